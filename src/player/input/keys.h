/*
 * keys.h - key bindings: maps keys and controller buttons to players' buttons and to the program's hotkeys.
 *
 * An action is a button of a player (p1.fire) or a hotkey (pause). It is bound to up to KEYS_PER_ACTION inputs, which
 * are written by name, separated by spaces:
 *
 *     z  enter  kp0  lshift  f12     a key, by its position on a US keyboard
 *     key100                         the key with USB HID usage 100
 *     alt+enter  ctrl+q              a key while the modifier is held; bindings of the key alone are then ignored
 *     pad.south  pad.r1              a button of the player's controller (controllers.h); for hotkeys, of any one
 *     pad1.south  pad4.south         a button of a specific controller, in the host's order
 *
 * A one-handed player also has a fixed layout on one half of the keyboard and of the controller. The inputs of this
 * layout have no other meaning for that player, and its keys have no meaning for the other player.
 */
#ifndef PLAYER_KEYS_H
#define PLAYER_KEYS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../../platform/platform.h"
#include "../../base/pads.h"
#include "controllers.h"
#include "input_code.h"

/* The program's actions, which follow the players' MAX_PLAYERS * PAD_BUTTON_COUNT. */
enum hotkey {
    HOTKEY_PAUSE,
    HOTKEY_FRAME_ADVANCE,
    HOTKEY_SLOW,
    HOTKEY_TURBO,
    HOTKEY_REWIND,
    HOTKEY_FRAME_BACK,
    HOTKEY_PREVIOUS_EVENT,
    HOTKEY_NEXT_EVENT,
    HOTKEY_GOTO,
    HOTKEY_TAKE_OVER,
    HOTKEY_RELOAD,
    HOTKEY_PRACTICE,
    HOTKEY_RETRY,
    HOTKEY_MUTE,
    HOTKEY_QUIETER,
    HOTKEY_LOUDER,
    HOTKEY_SCREENSHOT,
    HOTKEY_SAVE_CLIP,
    HOTKEY_FULLSCREEN,
    HOTKEY_QUIT,
    HOTKEY_MENU,
    HOTKEY_HELP,
    HOTKEY_LOG,
    HOTKEY_HITBOXES, /* the overlay's panels, in their order */
    HOTKEY_GAUGES,
    HOTKEY_FRAME_TIMES,
    HOTKEY_TASKS,
    HOTKEY_MIXER,
    HOTKEY_CONSOLE,
    HOTKEYS
};

/* Sets of 1 << enum hotkey: keys that move in time, which exported games have only in replays, and keys for authors,
 * which work while a game's folder is played. */
#define KEYS_FOR_SEEKING                                                                                               \
    (1u << HOTKEY_FRAME_ADVANCE | 1u << HOTKEY_SLOW | 1u << HOTKEY_TURBO | 1u << HOTKEY_REWIND |                       \
     1u << HOTKEY_FRAME_BACK | 1u << HOTKEY_PREVIOUS_EVENT | 1u << HOTKEY_NEXT_EVENT | 1u << HOTKEY_GOTO)
#define KEYS_FOR_AUTHORS                                                                                               \
    (1u << HOTKEY_RELOAD | 1u << HOTKEY_LOG | 1u << HOTKEY_HITBOXES | 1u << HOTKEY_GAUGES | 1u << HOTKEY_FRAME_TIMES | \
     1u << HOTKEY_TASKS | 1u << HOTKEY_MIXER | 1u << HOTKEY_CONSOLE)

enum { KEYS_PER_ACTION = 6, KEYS_PER_HAND = 3, KEYS_ACTIONS = MAX_PLAYERS * PAD_BUTTON_COUNT + HOTKEYS };

enum keys_hand { HAND_BOTH, HAND_LEFT, HAND_RIGHT };

/* The device that was used last: the keyboard, or a controller of this kind. */
struct keys_device {
    bool is_controller;
    enum plat_controller_kind kind;
};

struct keys {
    uint16_t code[KEYS_ACTIONS][KEYS_PER_ACTION];                /* input codes (input_code.h); 0: none */
    uint16_t hand[MAX_PLAYERS][PAD_BUTTON_COUNT][KEYS_PER_HAND]; /* layouts of one-handed players; 0: none */

    /* The state between polls. */
    uint8_t consumed[PLAT_KEYS / 8];                                    /* keys of chords, until they are released */
    bool had_alt, had_ctrl;                                             /* held at the last poll */
    bool alt, ctrl;                                                     /* held at this poll or the last one */
    uint16_t held_by_key[MAX_PLAYERS], held_by_controller[MAX_PLAYERS]; /* pads at the last poll */
    uint32_t held;                                                      /* hotkeys at the last poll */
    struct keys_device device[MAX_PLAYERS], latest;                     /* latest: of the player who pressed last */
};

/* The result of a poll. "Pressed" means held now but not at the last poll. */
struct keys_state {
    uint16_t pads[MAX_PLAYERS];
    uint16_t pads_pressed[MAX_PLAYERS];
    bool any_pad_pressed;
    uint32_t held, pressed; /* hotkeys, 1 << enum hotkey */
};

static inline bool keys_pressed(const struct keys_state *k, enum hotkey key)
{
    return k->pressed >> key & 1;
}

/* Sets the default bindings, with nothing held. */
void keys_set_defaults(struct keys *k);

/* Replaces an action's inputs with those of a list such as "z pad.south", or "none". For an unknown action or input, or
 * too many inputs, returns false, sets err, and changes nothing. */
bool keys_bind(struct keys *k, const char *action, const char *list, char *err, size_t err_size);

/* Sets the one-handed layout of a player (from 0); HAND_BOTH: none. */
void keys_set_hand(struct keys *k, int player, enum keys_hand hand);

/* Writes the label of an action's first input for hints: on the device that its player used last (any player, for a
 * hotkey), "cross" or "enter"; otherwise on the other device, with a button's name in the settings, "pad.south"; or
 * "none". */
void keys_hint(const struct keys *k, const char *action, char *out, size_t size);

/* Returns whether there is an action with this name. Other functions require an existing one. */
bool keys_is_action(const char *name);

/* Return the name of action i of KEYS_ACTIONS in the settings file, "p1.fire"; its label on the screen, "Fire"; and its
 * help, "fire; confirm in menus" or "". */
const char *keys_action_name(int i);
const char *keys_action_label(int i);
const char *keys_action_help(int i);

/* Writes the list of an action's inputs, as keys_bind reads it. */
void keys_write_list(const struct keys *k, const char *action, char *out, size_t size);

/* Waits for an input to bind. */
struct keys_capture {
    uint8_t keys[PLAT_KEYS / 8];                /* held at the last poll */
    uint32_t controllers[PLAT_MAX_CONTROLLERS]; /* the same */
    unsigned modifier;                          /* usage of the held Alt or Ctrl key, which may be part of a chord */
};

/* keys_capture_begin ignores inputs that are held now. keys_capture_poll, called at each poll, then returns the code of
 * a newly pressed key, chord or button, or of an Alt or Ctrl key that is released alone; 0: none yet. A button of any
 * controller is returned as that of the player's own (pad.south). */
void keys_capture_begin(struct keys_capture *c, const struct plat_input *in);
uint16_t keys_capture_poll(struct keys_capture *c, const struct plat_input *in);

/* Add and remove an input of an action. Adding returns false if the action already has KEYS_PER_ACTION inputs; adding
 * an input twice has no effect. */
bool keys_add(struct keys *k, const char *action, uint16_t code);
void keys_remove(struct keys *k, const char *action, uint16_t code);

/* Returns the first other action that the same press would trigger if this input were bound to the action; NULL: none.
 * pad.south of both players is no conflict, because each player has a controller. */
const char *keys_conflict(const struct keys *k, const char *action, uint16_t code);

/* Returns whether an input is reserved for the menu: Escape and the guide button. The settings don't bind these to
 * other actions, because the menu could then become unreachable. */
bool keys_reserved(uint16_t code);

/* Computes the result of a poll. Call controllers_poll first. */
void keys_read(struct keys *k, const struct plat_input *in, const struct controllers *controllers,
               struct keys_state *out);

/* Prints the default bindings for `curtain help play`, one action per line. without: hotkeys to leave out. */
void keys_print_help(uint32_t without, void (*line)(const char *));

#endif
