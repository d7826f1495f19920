/*
 * bots.h - simple players: how many of them live says how hard a section is. They fire, and press no bomb.
 * floor: cab
 *
 *     stand   four of them fly to a place in the lower part of the field, and stay there
 *     wander  six of them go somewhere else every so often, and look at nothing
 *     dodge   six of them see bullets as they were 12 frames ago, think that these fly straight on, and every 4 frames
 *             take the way on which none comes near for longest
 */
#ifndef CAB_BOTS_H
#define CAB_BOTS_H

#include "trial.h"

enum bot_kind { BOT_STAND, BOT_WANDER, BOT_DODGE, BOT_KINDS };

struct bots {
    int n[BOT_KINDS], lived[BOT_KINDS];
    uint32_t frames; /* that they lived, all together */
};

/* Lets all play from there, to the section's end or the last frame. False: no memory. */
bool bots_play(struct trial *t, const struct trial_mark *start, uint32_t limit, struct bots *out);

/* All of them. */
int bots_all(const struct bots *b);
int bots_lived(const struct bots *b);

/* Frames that one lived, on average. */
uint32_t bots_mean(const struct bots *b);

#endif
