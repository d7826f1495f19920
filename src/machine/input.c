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
    COLUMNS(input, presses, PRESS_SIDES *PAD_BUTTONS),
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

static uint64_t *presses(struct input *in, uint32_t p, uint32_t button, enum press_side side)
{
    return &in->presses[(p * PRESS_SIDES + (uint32_t)side) * PAD_BUTTONS + button];
}

/* Returns the mask of presses that are at most n frames old. */
static uint64_t younger(uint32_t n)
{
    return ((uint64_t)2 << n) - 1;
}

/* Counts the frames for which each button has been held, and sets `repeated`. now, was: buttons down in this and in the
 * previous frame; the count of any other button is 0 already. */
static void count_frames(struct input *in, uint32_t p, unsigned now, unsigned was)
{
    for (unsigned m = now | was; m; m &= m - 1) {
        const uint32_t i = bits_lowest(m);
        uint32_t *since = &in->since[p * PAD_BUTTONS + i];
        const bool down = now >> i & 1;
        if (down && (*since == 0 || (*since >= REPEAT_AFTER && (*since - REPEAT_AFTER) % REPEAT_EVERY == 0)))
            in->repeated[p] |= (uint16_t)(1u << i);
        *since = down ? *since + 1 : 0;
    }
}

static void keep_presses(struct input *in, uint32_t p, enum press_side side)
{
    uint64_t *kept = presses(in, p, 0, side);

    for (uint32_t i = 0; i < PAD_BUTTONS; i++)
        kept[i] = kept[i] << 1 & younger(PRESS_KEPT);
    for (unsigned m = in->pressed[p]; m; m &= m - 1)
        kept[bits_lowest(m)] |= 1;
}

void input_done(struct input *in)
{
    for (int p = 0; p < PADS; p++)
        in->pressed[p] = in->released[p] = in->repeated[p] = 0;
}

void input_latch(struct input *in, const uint16_t pads[PADS], enum press_side side, bool carry)
{
    if (!carry)
        input_done(in);
    for (int p = 0; p < PADS; p++) {
        unsigned now = without_opposites(pads[p]), was = in->held[p];
        in->held[p] = (uint16_t)now;
        in->pressed[p] |= (uint16_t)(now & ~was);
        in->released[p] |= (uint16_t)(was & ~now);
        count_frames(in, (uint32_t)p, now, was);
        if (side != PRESS_NOBODY)
            keep_presses(in, (uint32_t)p, side);
    }
}

bool input_take(struct input *in, uint32_t p, uint32_t button, uint32_t n, enum press_side side)
{
    uint64_t *kept = presses(in, p, button, side), oldest = (uint64_t)1 << n;

    if (!(*kept & younger(n)))
        return false;
    while (!(*kept & oldest))
        oldest >>= 1;
    *kept &= ~oldest;
    return true;
}

void input_forget(struct input *in, uint32_t p, enum press_side side, unsigned buttons)
{
    for (uint32_t i = 0; i < PAD_BUTTONS; i++)
        if (buttons >> i & 1u)
            *presses(in, p, i, side) = 0;
}
