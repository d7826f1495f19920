/*
 * pages.h - the head of a test of screens: a game on a rig, what its cells say, and who presses what.
 */
#ifndef TESTS_PAGES_H
#define TESTS_PAGES_H

#include "rig.h"

static struct rig_game g;
static struct rig r;

static inline void close_game(void)
{
    if (rig_fault(&r))
        fail_msg("%s", rig_fault(&r)->message);
    rig_close(&r);
}

/* Where in the cells the text stands: its first column plus 1000 a row; -1: nowhere. */
static inline int at(const char *text)
{
    const struct fix *f = &r.b->fix;
    char row[128];

    for (uint32_t y = 0; y < f->rows; y++) {
        for (uint32_t x = 0; x < f->cols; x++)
            row[x] = (char)(f->code[y * f->cols + x] > 32 ? f->code[y * f->cols + x] : ' ');
        row[f->cols] = 0;
        if (strstr(row, text))
            return (int)(1000 * y) + (int)(strstr(row, text) - row);
    }
    return -1;
}

/* So many, or until it faults. */
static inline void frames(int n)
{
    static const uint16_t none[MAX_PLAYERS];

    for (; n > 0 && !rig_fault(&r); n--)
        board_tick(r.b, none);
}

static inline void press(uint16_t first, uint16_t second)
{
    const uint16_t down[MAX_PLAYERS] = { first, second };

    if (rig_fault(&r))
        fail_msg("%s", rig_fault(&r)->message);
    rig_tick(&r, down);
    rig_tick(&r, down);
    frames(2);
}

/* Is shown within so many frames. */
static inline void soon(const char *text, int most)
{
    for (int i = 0; at(text) < 0; i++) {
        if (i == most || rig_fault(&r))
            fail_msg("frame %u: no \"%s\"%s%s", board_frame(r.b), text, rig_fault(&r) ? ": " : "",
                     rig_fault(&r) ? rig_fault(&r)->message : "");
        frames(1);
    }
}

#endif
