/*
 * tally.h - counts what happens in a run by looking at the board between frames: for the bot's report and for tests.
 */
#ifndef TOOLS_TALLY_H
#define TOOLS_TALLY_H

#include <string.h>
#include "../src/machine/machine.h"

enum { TALLY_ENEMIES = 4096 };

struct tally {
    uint64_t fired, kills, deaths, grazes;
    uint32_t most; /* bullets at once */
    int32_t lives[MAX_PLAYERS];
    uint32_t grazed[MAX_PLAYERS], top;
    uint64_t used[TALLY_ENEMIES / 64];
};

/* Before a tick: what there is. */
static inline void tally_before(struct tally *t, const struct board *b)
{
    for (int p = 0; p < MAX_PLAYERS; p++) {
        t->lives[p] = b->player.in_game[p] ? b->player.lives[p] : -1;
        t->grazed[p] = b->player.grazes[p];
    }
    t->top = b->enemies.s.top;
    memcpy(t->used, b->enemies.s.live_bits, t->top / 8);
}

/* After it. An enemy that died keeps hp 0 in its free slot; one that left keeps what it had. */
static inline void tally_after(struct tally *t, const struct board *b)
{
    EACH_LIVE (i, &b->bullets.s)
        t->fired += b->bullets.born[i] + 1 == b->core.clock;
    for (uint32_t i = 0; i < t->top; i++) {
        bool was = t->used[i / 64] >> (i & 63) & 1, is = b->enemies.s.live_bits[i / 64] >> (i & 63) & 1;
        t->kills += was && !is && b->enemies.hp[i] == 0;
    }
    for (int p = 0; p < MAX_PLAYERS; p++) {
        if (t->lives[p] >= 0 && (!b->player.in_game[p] || b->player.lives[p] < t->lives[p]))
            t->deaths++;
        if (b->player.grazes[p] > t->grazed[p])
            t->grazes += b->player.grazes[p] - t->grazed[p];
    }
    if (b->bullets.s.live > t->most)
        t->most = b->bullets.s.live;
}

#endif
