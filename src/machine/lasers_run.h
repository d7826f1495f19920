/*
 * lasers_run.h - lasers on the board: their moves, which follow things and run programs, and how they end.
 */
#ifndef MACHINE_LASERS_RUN_H
#define MACHINE_LASERS_RUN_H

#include "machine.h"

/* Starts one: the head's bullet, and the rest. NO_SLOT: there was no room, which was told. */
int32_t lasers_fire(struct board *b, const struct bullet_shape *head, struct laser_shape *shape);

/* It is gone, at once. */
void lasers_remove(struct board *b, uint32_t i);

/* Moves all, after everything that they may follow; those that follow after the others. Those whose time is over, or
 * whose owner is gone, go at once; those that have left are marked, and go at the end of the frame. */
void lasers_move(struct board *b);
void lasers_end_frame(struct board *b);

/* A script has moved, turned or resized laser i: its ends are where they are now, and it passes nothing on the way. */
void lasers_settle(struct board *b, uint32_t i);

/* A script moves it to (x, y); a curve with all of its body. */
void lasers_place(struct board *b, uint32_t i, fx x, fx y);

/* Frames of its age; of one that is drawn or inspected between frames: those of the frame before, which hits saw. */
uint32_t lasers_age(const struct board *b, uint32_t i);
uint32_t lasers_age_seen(const struct board *b, uint32_t i);

/* What it is at an age: a bolt or curve that is delayed warns. */
enum laser_state lasers_state_of(const struct board *b, uint32_t i, uint32_t age);

/* Its line's corners, from the head on: of a beam or bolt two. */
uint32_t lasers_corners(const struct board *b, uint32_t i);
void lasers_corner(const struct board *b, uint32_t i, uint32_t k, fx *x, fx *y);

/* Where corner k was before this frame's move. */
void lasers_corner_was(const struct board *b, uint32_t i, uint32_t k, fx *x, fx *y);

/* Calls `each` for places along its line, `every` px apart, the first half of that from the head, and returns how many
 * there were; of one too short for any, its head. every > 0. */
uint32_t lasers_places(struct board *b, uint32_t i, fx every, void (*each)(struct board *b, fx x, fx y, void *context),
                       void *context);

/* The place of its line that is nearest to (x, y), to a 256th of a px. */
void lasers_nearest(const struct board *b, uint32_t i, fx x, fx y, fx *to_x, fx *to_y);

/* Is what is within half its width of its line, as it is drawn now, anywhere in the circle, box or line? Line: from
 * (x, y) to (to_x, to_y), all within a. */
bool lasers_in_circle(const struct board *b, uint32_t i, fx x, fx y, fx a);
bool lasers_in_box(const struct board *b, uint32_t i, fx x, fx y, fx w, fx h);
bool lasers_in_line(const struct board *b, uint32_t i, fx x, fx y, fx to_x, fx to_y, fx a);

#endif
