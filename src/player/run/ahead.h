/*
 * ahead.h - look-ahead: ticks the board once more with the same pads to draw the next frame, and restores it.
 *
 * This reduces input latency by a frame. If the player presses other buttons in the next frame, that frame differs from
 * the one shown. Only the picture is a frame ahead: sound, recording, scores, log and requests are those of the present
 * frame.
 */
#ifndef PLAYER_AHEAD_H
#define PLAYER_AHEAD_H

#include "guard.h"

struct ahead {
    void *snapshot, *output; /* malloc */
    size_t capacity;         /* bytes allocated for the snapshot */
    bool saved;              /* a state is saved, and not restored yet */
};

/* Saves the board's state and output, for ahead_end. Returns false when out of memory. Call it only between frames. */
bool ahead_save(struct ahead *a, const struct board *b);

/* Saves the board and ticks it once. Returns false when out of memory, or if the tick faults or takes too long; the
 * board is then unchanged. Call it only between frames, for a board without a fault. */
bool ahead_begin(struct ahead *a, struct guard *g, const uint16_t pads[MAX_PLAYERS]);

/* Restores the saved state, if any. Call it before changing the board. */
void ahead_end(struct ahead *a, struct guard *g);

/* Frees the memory. Does nothing if *a is zeroed. */
void ahead_close(struct ahead *a);

#endif
