/*
 * input.c - see input.h.
 */
#include "input.h"

static const struct column columns[] = {
    COLUMN(input, held),
    COLUMN(input, played),
    COLUMN(input, pressed),
    COLUMN(input, released),
    COLUMN(input, repeated),
    COLUMNS(input, held_frames, PAD_BUTTON_COUNT),
    COLUMNS(input, presses, PRESS_SIDES *PAD_BUTTON_COUNT),
};

const struct chip input_chip = { .name = "input", CHIP_COLUMNS(columns), .is_list = true };

static uint16_t cancel_opposites(uint16_t pads)
{
    const unsigned horizontal = PAD_LEFT | PAD_RIGHT, vertical = PAD_UP | PAD_DOWN;
    unsigned v = pads & PAD_ALL;

    if ((v & horizontal) == horizontal)
        v &= ~horizontal;
    if ((v & vertical) == vertical)
        v &= ~vertical;
    return (uint16_t)v;
}

enum { IS_PLAYED = 1 << 15 }; /* of `played` */

static uint64_t *presses_of(struct input *in, uint32_t p, uint32_t button, enum press_side side)
{
    return &in->presses[(p * PRESS_SIDES + (uint32_t)side) * PAD_BUTTON_COUNT + button];
}

/* Returns the mask of presses that are at most n frames old. */
static uint64_t age_mask(uint32_t n)
{
    return ((uint64_t)2 << n) - 1;
}

/* Counts the frames for which each button has been held, and sets `repeated`. now, was: buttons down in this and in the
 * previous frame; the count of any other button is 0 already. */
static void count_frames(struct input *in, uint32_t p, unsigned now, unsigned was)
{
    for (unsigned m = now | was; m; m &= m - 1) {
        const uint32_t i = bits_lowest(m);
        uint32_t *held_frames = &in->held_frames[p * PAD_BUTTON_COUNT + i];
        const bool down = now >> i & 1;
        if (down &&
            (*held_frames == 0 || (*held_frames >= REPEAT_AFTER && (*held_frames - REPEAT_AFTER) % REPEAT_EVERY == 0)))
            in->repeated[p] |= (uint16_t)(1u << i);
        *held_frames = down ? *held_frames + 1 : 0;
    }
}

static void record_presses(struct input *in, uint32_t p, enum press_side side)
{
    uint64_t *buffer = presses_of(in, p, 0, side);

    for (uint32_t i = 0; i < PAD_BUTTON_COUNT; i++)
        buffer[i] = buffer[i] << 1 & age_mask(MAX_PRESS_AGE);
    for (unsigned m = in->pressed[p]; m; m &= m - 1)
        buffer[bits_lowest(m)] |= 1;
}

void input_play(struct input *in, uint32_t p, unsigned pads)
{
    in->played[p] = (uint16_t)(IS_PLAYED | cancel_opposites((uint16_t)pads));
    for (unsigned m = pads & (PAD_BOMB | PAD_SPECIAL); m; m &= m - 1)
        *presses_of(in, p, bits_lowest(m), PRESS_GAME) |= 1;
}

bool input_end_play(struct input *in, uint32_t p)
{
    const bool was_played = in->played[p];

    in->played[p] = 0;
    return was_played;
}

unsigned input_held(const struct input *in, uint32_t p)
{
    return in->played[p] ? in->played[p] & PAD_ALL : in->held[p];
}

void input_clear_edges(struct input *in)
{
    for (int p = 0; p < MAX_PLAYERS; p++)
        in->pressed[p] = in->released[p] = in->repeated[p] = 0;
}

void input_latch(struct input *in, const uint16_t pads[MAX_PLAYERS], enum press_side side, bool carry)
{
    if (!carry)
        input_clear_edges(in);
    for (int p = 0; p < MAX_PLAYERS; p++) {
        unsigned now = cancel_opposites(pads[p]), was = in->held[p];
        in->held[p] = (uint16_t)now;
        in->played[p] = 0;
        in->pressed[p] |= (uint16_t)(now & ~was);
        in->released[p] |= (uint16_t)(was & ~now);
        count_frames(in, (uint32_t)p, now, was);
        if (side != PRESS_NOBODY)
            record_presses(in, (uint32_t)p, side);
    }
}

bool input_take(struct input *in, uint32_t p, uint32_t button, uint32_t n, enum press_side side)
{
    uint64_t *buffer = presses_of(in, p, button, side), oldest = (uint64_t)1 << n;

    if (!(*buffer & age_mask(n)))
        return false;
    while (!(*buffer & oldest))
        oldest >>= 1;
    *buffer &= ~oldest;
    return true;
}

void input_drop_presses(struct input *in, uint32_t p, enum press_side side, unsigned buttons)
{
    for (uint32_t i = 0; i < PAD_BUTTON_COUNT; i++)
        if (buttons >> i & 1u)
            *presses_of(in, p, i, side) = 0;
}
