/*
 * ahead.h - a look at the frame after the present one: the board ticks once more with the same pads, is drawn, and goes
 * back to where it was, as if nothing had been.
 *
 * What is shown is a frame younger then, so a switch is seen a frame earlier. Where the player presses something else
 * in the next frame, that frame differs from the one that was shown. Nothing but the picture is of it: sound,
 * recording, scores, log and requests are the present's.
 */
#ifndef PLAYER_AHEAD_H
#define PLAYER_AHEAD_H

#include "guard.h"

struct ahead {
    void *snapshot, *output; /* malloc */
    size_t room;             /* bytes of snapshot */
    bool on;                 /* the board stands a frame ahead */
};

/* Goes ahead. False: it cannot (no memory, or the next tick would fault or take too long), and the board is as it
 * was. Only between frames, of a board without a fault. */
bool ahead_begin(struct ahead *a, struct guard *g, const uint16_t pads[MAX_PLAYERS]);

/* Goes back, if it went ahead. To be called before anything else is done with the board but looking at it. */
void ahead_end(struct ahead *a, struct guard *g);

/* Harmless on zeroes. */
void ahead_close(struct ahead *a);

#endif
