/*
 * input.h - the pads as a game sees them: held, pressed, released, repeated.
 * floor: chips    used by: board/
 */
#ifndef CHIPS_INPUT_H
#define CHIPS_INPUT_H

#include "../base/pads.h"
#include "slots.h"

enum { REPEAT_AFTER = 20, REPEAT_EVERY = 5 }; /* frames */

struct input {
    struct slots s; /* two entries */
    uint16_t *held;
    uint16_t *pressed; /* down now, up the frame before */
    uint16_t *released;
    uint16_t *repeated; /* pressed, and again every few frames while held */
    uint32_t *since;    /* PAD_BUTTONS a player: frames held */
};

extern const struct chip input_chip;

/* Takes this frame's pads. Opposite directions held together count as neither. */
void input_latch(struct input *in, const uint16_t pads[PADS]);

#endif
