/*
 * bots.h - simple players: how many of them live says how hard a section is. They fire, and press no bomb.
 *
 *     stand   four of them fly to a place in the lower part of the field, and stay there
 *     wander  six of them go somewhere else every so often, and look at nothing
 *     dodge   six of them see bullets as they were 12 frames ago, think that these fly straight on, and every 4 frames
 *             take the way on which none comes near for longest
 *
 * Or more of them, in these parts, that fly on when they are hit: how often that is says how hard a section is.
 */
#ifndef WORKBENCH_BOTS_H
#define WORKBENCH_BOTS_H

#include "trial.h"

enum bot_kind { BOT_STAND, BOT_WANDER, BOT_DODGE, BOT_KINDS };

struct bots {
    int n[BOT_KINDS], lived[BOT_KINDS];
    uint32_t frames;           /* that they lived, all together */
    uint32_t hits[BOT_KINDS];  /* of bots that fly on */
    uint32_t flown[BOT_KINDS]; /* frames in which these could be hit, all together */
    bool fault;                /* one of these came to a script's fault, and no more flew: board_last_output has it */
};

/* Lets all play from there, to the section's end or the last frame: sixteen of them, each until it is hit; or so many
 * that fly on, and cannot be hit again for BOTS_MERCY frames. False: no memory. */
enum { BOTS = 16, BOTS_MERCY = 90 };
bool bots_play(struct trial *t, const struct trial_mark *start, uint32_t limit, struct bots *out);
bool bots_play_on(struct trial *t, const struct trial_mark *start, uint32_t limit, int bots, struct bots *out);

/* All of them. */
int bots_all(const struct bots *b);
int bots_lived(const struct bots *b);

/* Hits a minute of bots that fly on, in tenths; 0 where none flew. */
uint32_t bots_rate(const struct bots *b);
uint32_t bots_rate_of(const struct bots *b, enum bot_kind kind);
uint32_t bots_hits(const struct bots *b);
uint32_t bots_flown(const struct bots *b);

/* Are bots that fly on hit more often there, at an easier difficulty, than at the next one? Says so; "": no. */
void bots_compare(const struct bots *easier, const struct bots *harder, char *why, size_t size);

/* Frames that one lived, on average. */
uint32_t bots_mean(const struct bots *b);

#endif
