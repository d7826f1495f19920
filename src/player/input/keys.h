/*
 * keys.h - from raw switches to pads: the key map, and the program's own keys.
 *
 * An action is a button of a player (p1.fire) or a key of the program (pause). It has up to KEYS_EACH switches, written
 * by name, with blanks between them:
 *
 *     z  enter  kp0  lshift  f12     a key, by its place on a US keyboard
 *     key100                         the key of USB HID usage 100
 *     alt+enter  ctrl+q              a key while that modifier is held; a plain binding of the key is then not seen
 *     pad.south  pad.r1              a switch of the player's controller (seats.h says which that is); to the program
 *                                    of any
 *     pad1.south  pad4.south         a switch of a certain controller, as the host counts them
 *
 * A player with one hand has a layout beside the map, on one half of the keyboard and of the controller. A switch of it
 * means to that player what the layout says and nothing else; a key of it means nothing to the other player.
 */
#ifndef PLAYER_KEYS_H
#define PLAYER_KEYS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../../platform/platform.h"
#include "../../base/pads.h"
#include "seats.h"
#include "switch.h"

/* The program's actions, after the players' MAX_PLAYERS * PAD_BUTTON_COUNT. */
enum hotkey {
    HOTKEY_PAUSE,
    HOTKEY_STEP,
    HOTKEY_SLOW,
    HOTKEY_TURBO,
    HOTKEY_REWIND,
    HOTKEY_BACK,
    HOTKEY_BEFORE,
    HOTKEY_AFTER,
    HOTKEY_GOTO,
    HOTKEY_TAKE_OVER,
    HOTKEY_RELOAD,
    HOTKEY_PRACTICE,
    HOTKEY_RETRY,
    HOTKEY_MUTE,
    HOTKEY_QUIETER,
    HOTKEY_LOUDER,
    HOTKEY_SCREENSHOT,
    HOTKEY_CAPTURE,
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

/* Of 1 << enum hotkey, the keys of those who make games: to move in time, which a replay has for everybody, and to
 * look into the board. */
#define KEYS_IN_TIME                                                                                                   \
    (1u << HOTKEY_STEP | 1u << HOTKEY_SLOW | 1u << HOTKEY_TURBO | 1u << HOTKEY_REWIND | 1u << HOTKEY_BACK |            \
     1u << HOTKEY_BEFORE | 1u << HOTKEY_AFTER | 1u << HOTKEY_GOTO)
#define KEYS_INSIDE                                                                                                    \
    (1u << HOTKEY_RELOAD | 1u << HOTKEY_HITBOXES | 1u << HOTKEY_GAUGES | 1u << HOTKEY_FRAME_TIMES | 1u << HOTKEY_TASKS |       \
     1u << HOTKEY_MIXER | 1u << HOTKEY_CONSOLE)

enum { KEYS_EACH = 6, KEYS_HAND = 3, KEYS_ACTIONS = MAX_PLAYERS * PAD_BUTTON_COUNT + HOTKEYS };

enum keys_hand { HAND_BOTH, HAND_LEFT, HAND_RIGHT };

/* What somebody pressed last: a key, or a switch of a controller of that kind. */
struct keys_device {
    bool controller;
    enum plat_controller_kind kind;
};

struct keys {
    uint16_t code[KEYS_ACTIONS][KEYS_EACH];                  /* as in switch.h; 0: none */
    uint16_t hand[MAX_PLAYERS][PAD_BUTTON_COUNT][KEYS_HAND]; /* the layout of a player with one hand; 0: none */
    uint8_t eaten[PLAT_KEYS / 8];                            /* keys a chord has used, until they are released */
    bool alt, ctrl, had_alt, had_ctrl;                       /* held at this poll or the last one; at the last one */
    uint16_t by_key[MAX_PLAYERS], by_switch[MAX_PLAYERS];    /* of the last read: held by keys, by a controller */
    struct keys_device player[MAX_PLAYERS], latest;          /* latest: of whichever player pressed last */
    uint32_t held;
};

/* What one poll means. */
struct keys_read {
    uint16_t pads[MAX_PLAYERS];
    uint16_t pads_fresh[MAX_PLAYERS]; /* those that were not held at the last read */
    bool fresh;                       /* there is one of those */
    uint32_t held, pressed;           /* hotkeys, 1 << HOTKEY_PAUSE ...; pressed: held now, not at the last read */
};

/* The map of the table in keys.c; nothing held. */
void keys_defaults(struct keys *k);

/* Gives an action the switches of a list like "z pad.south", or none with "none", in place of those it had. False and
 * one sentence for an unknown action or switch, or too many; the map is then unchanged. */
bool keys_bind(struct keys *k, const char *action, const char *list, char *err, size_t err_size);

/* Gives a player (from 0) the layout of a hand; HAND_BOTH: none. */
void keys_hand(struct keys *k, int player, enum keys_hand hand);

/* Writes what an action's player is to press, for hints: the first switch of what they used last, named as it is
 * printed on their controller ("cross") or on a key ("w", "enter"); or the first there is, a controller's spelled; or
 * "none". For an action of the program, of what was used last by anybody. */
void keys_first(const struct keys *k, const char *action, char *out, size_t size);

/* True when there is such an action. The functions above and below take one that is known. */
bool keys_known(const char *action);

/* Action i of KEYS_ACTIONS: its name in the file, "p1.fire"; its label on the screen, "Fire"; its help, "fire; confirm
 * in menus" or "". */
const char *keys_action(int i);
const char *keys_label(int i);
const char *keys_meaning(int i);

/* Writes the label of an action, with its player: "Player 1 Fire", "Take Over". */
enum { KEYS_TITLE = 32 };
void keys_title(const char *action, char *out, size_t size);

/* Writes the list of an action's switches, as keys_bind reads it. */
void keys_text(const struct keys *k, const char *action, char *out, size_t size);

/* Waits for a switch that is pressed anew. */
struct keys_capture {
    uint8_t keys[PLAT_KEYS / 8];
    uint32_t controllers[PLAT_MAX_CONTROLLERS];
    unsigned modifier; /* usage of Alt or Ctrl that is held, and may become a chord */
};

/* What is held now does not count. Then, each poll: the code of a switch, a key, a chord, or Alt or Ctrl when it is let
 * go alone; of whichever controller, as the player's own (pad.south). 0: none yet. */
void keys_capture_begin(struct keys_capture *c, const struct plat_input *in);
uint16_t keys_capture(struct keys_capture *c, const struct plat_input *in);

/* Gives an action one switch more, as its last, or takes one away. keys_add: false and one sentence when it has
 * KEYS_EACH; true also when it has this one. */
bool keys_add(struct keys *k, const char *action, uint16_t code, char *err, size_t err_size);
void keys_drop(struct keys *k, const char *action, uint16_t code);

/* The first other action that one press of this switch would mean too, were it given to this one; NULL: none. What is
 * pad.south to both players is no conflict, for each has a controller. */
const char *keys_conflict(const struct keys *k, const char *action, uint16_t code);

/* Escape and a controller's guide button open the program's menu: a screen gives them to no other action, or there
 * would be no way back. */
bool keys_reserved(uint16_t code);

/* seats: this poll's. */
void keys_read(struct keys *k, const struct plat_input *in, const struct seats *seats, struct keys_read *out);

/* Hands out the default map, a line an action, for `curtain help play`, but for these of the program's. */
void keys_help(uint32_t without, void (*line)(const char *));

#endif
