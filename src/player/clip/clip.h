/*
 * clip.h - records the last seconds of a run as a GIF.
 */
#ifndef PLAYER_CLIP_H
#define PLAYER_CLIP_H

#include "../../board/board.h"
#include "../run/guard.h"
#include "gif.h"

/* Adds the frames from `first`, or the oldest one in the past, to the present; ten seconds take about one second. Then
 * restores the board. Call it only between frames, for a board without a fault. fb, rgb and scratch are used for
 * drawing, without a view. Returns false when out of memory, or if a frame took too long. Close g either way. */
bool clip_record(struct gif *g, struct guard *guard, uint32_t first, struct fb *fb, uint32_t rgb[256], void *scratch);

#endif
