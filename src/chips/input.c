/*
 * input.c - see input.h.
 */
#include "input.h"

static const struct column columns[] = {
    COLUMN(input, held),
    COLUMN(input, pressed),
    COLUMN(input, released),
    COLUMN(input, repeated),
    COLUMNS(input, since, PAD_BUTTONS),
};

const struct chip input_chip = { "input", columns, sizeof columns / sizeof *columns, true, false };

static uint16_t without_opposites(uint16_t pads)
{
    const unsigned across = PAD_LEFT | PAD_RIGHT, along = PAD_UP | PAD_DOWN;
    unsigned v = pads & PAD_ALL;

    if ((v & across) == across)
        v &= ~across;
    if ((v & along) == along)
        v &= ~along;
    return (uint16_t)v;
}

void input_latch(struct input *in, const uint16_t pads[PADS])
{
    for (int p = 0; p < PADS; p++) {
        unsigned now = without_opposites(pads[p]), was = in->held[p];
        in->held[p] = (uint16_t)now;
        in->pressed[p] = (uint16_t)(now & ~was);
        in->released[p] = (uint16_t)(was & ~now);
        in->repeated[p] = 0;
        for (int i = 0; i < PAD_BUTTONS; i++) {
            uint32_t *since = &in->since[p * PAD_BUTTONS + i];
            bool down = now >> i & 1;
            if (down && (*since == 0 || (*since >= REPEAT_AFTER && (*since - REPEAT_AFTER) % REPEAT_EVERY == 0)))
                in->repeated[p] |= (uint16_t)(1u << i);
            *since = down ? *since + 1 : 0;
        }
    }
}
