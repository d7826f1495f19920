/*
 * input.h - the pads as a game sees them: held, pressed, released, repeated; and presses that wait to be taken.
 * floor: chips    used by: board/
 *
 * A press is a frame in which a button went down. It waits for somebody to take it, once, and goes stale. The game and
 * the screen that freezes it have presses of their own: what was pressed while the game stood is none of the game's, and
 * what it had not taken by then is as old as it was when it goes on.
 */
#ifndef CHIPS_INPUT_H
#define CHIPS_INPUT_H

#include "../base/pads.h"
#include "slots.h"

enum { REPEAT_AFTER = 20, REPEAT_EVERY = 5, PRESS_KEPT = 60 }; /* frames */

enum press_side { PRESS_GAME, PRESS_PAUSE, PRESS_SIDES }; /* whose it is */

struct input {
    struct slots s; /* two entries */
    uint16_t *held;
    uint16_t *pressed; /* down now, up the frame before */
    uint16_t *released;
    uint16_t *repeated; /* pressed, and again every few frames while held */
    uint32_t *since;    /* PAD_BUTTONS a player: frames held */
    uint64_t *presses;  /* PRESS_SIDES times PAD_BUTTONS a player: bit k, pressed k frames ago and not taken yet */
};

extern const struct chip input_chip;

/* Takes this frame's pads. Opposite directions held together count as neither. Presses are those of `side`, whose frame
 * it is; the other's grow no older. */
void input_latch(struct input *in, const uint16_t pads[PADS], enum press_side side);

/* Takes the oldest press of a button that is at most n frames old (0 to PRESS_KEPT; 0: of this very frame). */
bool input_take(struct input *in, uint32_t p, uint32_t button, uint32_t n, enum press_side side);

/* No press of player p waits any more. */
void input_forget(struct input *in, uint32_t p, enum press_side side);

#endif
