/*
 * last.h - the last seconds of a run as a GIF.
 */
#ifndef PLAYER_LAST_H
#define PLAYER_LAST_H

#include "../../board/board.h"
#include "../run/guard.h"
#include "gif.h"

/* Films the past from frame `first`, or the first one that can be brought back, to the present, in one go; ten seconds
 * take about one. The board is then as if nothing had been (lookback.h says when it may be). fb, rgb and scratch are to
 * draw in; no view changes the pictures. False: no memory, or a frame took too long. Close g either way. */
bool last_film(struct gif *g, struct guard *guard, uint32_t first, struct fb *fb, uint32_t rgb[256], void *scratch);

#endif
