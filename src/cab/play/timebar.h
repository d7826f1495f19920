/*
 * timebar.h - the run as a bar at the picture's bottom: where we are in it, and its markers.
 * floor: cab    used by: cab
 *
 * Stages are white, points of a stage cyan, waves grey, bosses red, their phases yellow, deaths magenta. Over the bar
 * stands the frame, its time, and the last markers before it: "1234/14016 0:20 one queen/bloom". What was gone through
 * is green, and red from where a playback is not as it was recorded.
 */
#ifndef CAB_TIMEBAR_H
#define CAB_TIMEBAR_H

#include "../overlay/ink.h"
#include "session.h"

enum { TIMEBAR_H = 16 /* px */ };

/* Draws it over the last rows of the picture. */
void timebar_draw(const struct ink *ink, const struct session *s);

/* The frame under a point of the picture; false: the point is not on the bar. */
bool timebar_at(const struct session *s, int w, int h, int x, int y, uint32_t *frame);

/* The frame of the last marker half a second or more before `frame` (so that asking again leads farther), or of the
 * first one after it; where there is none, the end that way. Waves are passed over: there are too many. */
uint32_t timebar_before(const struct session *s, uint32_t frame);
uint32_t timebar_after(const struct session *s, uint32_t frame);

#endif
