/*
 * timebar.h - the time bar at the bottom of the picture: the run, its current frame and its markers.
 *
 * Stages are white, marks of a stage cyan, waves grey, bosses red, their phases yellow, deaths magenta. Above the bar
 * are the frame, its time and the last markers before it: "1234/14016 0:20 one queen/bloom". The played part is green,
 * and red from the first frame in which a playback differs from its recording.
 */
#ifndef PLAYER_TIMEBAR_H
#define PLAYER_TIMEBAR_H

#include "../overlay/canvas.h"
#include "session.h"

enum { TIMEBAR_H = 16 /* px */ };

/* Draws the time bar over the last rows of the picture. */
void timebar_draw(const struct canvas *canvas, const struct session *s);

/* Finds the frame at a point of a picture of w x h. Returns false if the point is not on the bar. */
bool timebar_frame_at(const struct session *s, int w, int h, int x, int y, uint32_t *frame);

/* timebar_previous returns the frame of the last marker at least half a second before `frame` (so that a second press
 * goes further back), or session_first. timebar_next returns the frame of the first marker after it, or session_last.
 * Waves don't count, because there are too many. */
uint32_t timebar_previous(const struct session *s, uint32_t frame);
uint32_t timebar_next(const struct session *s, uint32_t frame);

#endif
