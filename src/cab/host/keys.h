/*
 * keys.h - from raw switches to pads: the key map, and the cabinet's own keys.
 * floor: cab
 *
 * An action is a button of a player (p1.fire) or a key of the cabinet (pause). It has up to KEYS_EACH switches, written
 * by name, with blanks between them:
 *
 *     z  enter  kp0  lshift  f12     a key, by its place on a US keyboard
 *     key100                         the key of USB HID usage 100
 *     alt+enter  ctrl+q              a key while that modifier is held; a plain binding of the key is then not seen
 *     pad.south  pad.r1              a controller's switch: p1 has the first controller, p2 the second, the
 *                                    cabinet both
 *     pad1.south  pad2.south         a switch of a certain controller
 */
#ifndef CAB_KEYS_H
#define CAB_KEYS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../../platform/platform.h"
#include "../../base/pads.h"

/* The cabinet's actions, after the players' PADS * PAD_BUTTONS. */
enum cab_key {
    CAB_PAUSE,
    CAB_STEP,
    CAB_SLOW,
    CAB_TURBO,
    CAB_REWIND,
    CAB_BACK,
    CAB_BEFORE,
    CAB_AFTER,
    CAB_GOTO,
    CAB_TAKE_OVER,
    CAB_RELOAD,
    CAB_PRACTICE,
    CAB_RETRY,
    CAB_MUTE,
    CAB_QUIETER,
    CAB_LOUDER,
    CAB_SCREENSHOT,
    CAB_FULLSCREEN,
    CAB_QUIT,
    CAB_MENU,
    CAB_HELP,
    CAB_SHAPES, /* the overlay's panels, in their order */
    CAB_GAUGES,
    CAB_SPLIT,
    CAB_TASKS,
    CAB_MIXER,
    CAB_CONSOLE,
    CAB_KEYS
};

enum { KEYS_EACH = 6, KEYS_ACTIONS = PADS * PAD_BUTTONS + CAB_KEYS };

struct keys {
    uint16_t code[KEYS_ACTIONS][KEYS_EACH]; /* 0: none */
    uint8_t eaten[PLAT_KEYS / 8];           /* keys a chord has used, until they are released */
    uint16_t pads[PADS];                    /* of the last read */
    uint32_t held;
};

/* What one poll means. */
struct keys_read {
    uint16_t pads[PADS];
    uint32_t held, pressed; /* cabinet keys, 1 << CAB_PAUSE ...; pressed: held now, not at the last read */
    bool fresh;             /* a pad button is down that was not at the last read */
};

/* The map of the table in keys.c; nothing held. */
void keys_defaults(struct keys *k);

/* Gives an action the switches of a list like "z pad.south", or none with "none", in place of those it had. False and
 * one sentence for an unknown action or switch, or too many; the map is then unchanged. */
bool keys_bind(struct keys *k, const char *action, const char *list, char *err, size_t err_size);

/* Writes the name of an action's first switch, "enter", or "none". */
void keys_first(const struct keys *k, const char *action, char *out, size_t size);

/* Writes all switches of an action as keys_bind takes them: "z pad.south", or "none". */
void keys_list(const struct keys *k, int action, char *out, size_t size);

/* The name of an action, and what it does in a few words ("": as the one of player 1). */
const char *keys_action(int action);
const char *keys_does(int action);

/* True when there is such an action. */
bool keys_known(const char *action);

void keys_read(struct keys *k, const struct plat_input *in, struct keys_read *out);

/* Hands out the default map, a line an action, for `curtain help play`. */
void keys_help(void (*line)(const char *));

#endif
