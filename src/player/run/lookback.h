/*
 * lookback.h - the frames that were, one after another, as they are looked at again: the board goes back into its past,
 * comes to the present by the same pads, and is then as if nothing had been.
 */
#ifndef PLAYER_LOOKBACK_H
#define PLAYER_LOOKBACK_H

#include "guard.h"

/* Calls `each` for the board at every frame from `first`, or the first one that can be brought back, to the present.
 * Only between frames, of a board without a fault. False: no memory, `each` said no, or a frame took too long. */
bool lookback(struct guard *g, uint32_t first, bool (*each)(void *user, const struct board *b), void *user);

#endif
