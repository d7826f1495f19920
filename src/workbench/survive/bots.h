/*
 * bots.h - simple bots, whose survival measures how hard a section is. They fire and don't bomb.
 *
 *     stand   four bots fly to a position in the lower part of the field, and stay there
 *     wander  six bots fly to random positions, and ignore bullets
 *  dodge   six bots see the bullets of 12 frames ago, assume that these fly straight, and every 4 frames choose the
 *  move
 *          that keeps bullets away for the longest time
 *
 * With --bots, any number of bots, in these proportions, continue after hits; hits per minute measure the difficulty.
 */
#ifndef WORKBENCH_BOTS_H
#define WORKBENCH_BOTS_H

#include "simulation.h"

enum bot_kind { BOT_STAND, BOT_WANDER, BOT_DODGE, BOT_KINDS };

struct bots {
    int n[BOT_KINDS], survived[BOT_KINDS];
    uint32_t frames;           /* survived, sum of all bots */
    uint32_t hits[BOT_KINDS];  /* of bots that continue after hits */
    uint32_t flown[BOT_KINDS]; /* frames in which such bots could be hit, sum of all bots */
    bool fault;                /* a script faulted, which ended the test; board_last_output has the fault */
};

/* Bots play from `start` to the section's end or the frame `limit`. bots_play: BOTS bots, each until it is hit.
 * bots_play_invincible: `bots` bots that continue after hits, safe for BOTS_MERCY frames. False: out of memory. */
enum { BOTS = 16, BOTS_MERCY = 90 };
bool bots_play(struct simulation *t, const struct simulation_state *start, uint32_t limit, struct bots *out);
bool bots_play_invincible(struct simulation *t, const struct simulation_state *start, uint32_t limit, int bots,
                          struct bots *out);

/* Return the sums of all kinds. */
int bots_count(const struct bots *b);
int bots_survived(const struct bots *b);

/* Return the hits per minute, in tenths, of bots that continue after hits; 0 without such bots. */
uint32_t bots_rate(const struct bots *b);
uint32_t bots_rate_of(const struct bots *b, enum bot_kind kind);
uint32_t bots_hits(const struct bots *b);
uint32_t bots_flown(const struct bots *b);

/* Writes why the easier difficulty is harder for bots that continue after hits; "": it is not. */
void bots_compare(const struct bots *easier, const struct bots *harder, char *why, size_t size);

/* Returns the average lifetime in frames. */
uint32_t bots_mean(const struct bots *b);

#endif
