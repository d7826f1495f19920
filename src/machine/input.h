/*
 * input.h - the pads as a game sees them: held, pressed, released, repeated; and presses that wait to be taken.
 *
 * A press is a frame in which a button went down. It can be taken once (input_take) while it is at most PRESS_KEPT
 * frames old. The game and the pause screen have presses of their own: a press during a pause is not the game's, and
 * the game's presses do not age during a pause.
 */
#ifndef MACHINE_INPUT_H
#define MACHINE_INPUT_H

#include "../base/pads.h"
#include "../base/slots.h"

enum { REPEAT_AFTER = 20, REPEAT_EVERY = 5, PRESS_KEPT = 60 }; /* frames */

enum press_side { PRESS_GAME, PRESS_PAUSE, PRESS_SIDES, PRESS_NOBODY = PRESS_SIDES };

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

/* Takes this frame's pads. Opposite directions held together count as neither. The frame belongs to `side`: it gets the
 * presses, and the other side's do not age. carry: what was pressed, released and repeated in the frame before counts
 * as of this one, too; so a row of frames that are nobody's leaves it to the one after them. */
void input_latch(struct input *in, const uint16_t pads[PADS], enum press_side side, bool carry);

/* Nothing of this frame is carried. */
void input_done(struct input *in);

/* Takes the oldest press of a button that is at most n frames old (0 to PRESS_KEPT; 0: of this very frame). */
bool input_take(struct input *in, uint32_t p, uint32_t button, uint32_t n, enum press_side side);

/* Drops all presses of those buttons (PAD_ bits) of player p. */
void input_forget(struct input *in, uint32_t p, enum press_side side, unsigned buttons);

#endif
