/*
 * lasers_run.h - lasers on the board: how they spawn, move (following entities, running programs) and end.
 */
#ifndef MACHINE_LASERS_RUN_H
#define MACHINE_LASERS_RUN_H

#include "machine.h"

/* Fires a laser: adds the laser and its head, a bullet, in the same slot. Returns the slot, or NO_SLOT if a pool is
 * full, which is logged. */
int32_t lasers_fire(struct board *b, const struct bullet_spec *head, struct laser_spec *shape);

/* Removes laser i at once. */
void lasers_remove(struct board *b, uint32_t i);

/* Moves all lasers, after every entity they may follow; lasers that follow an entity move after the others. A laser
 * whose lifetime is over, or whose followed entity is dead, is removed at once; a laser that has left the field is
 * marked, and lasers_end_frame removes it. */
void lasers_move(struct board *b);
void lasers_end_frame(struct board *b);

/* Updates the tail of laser i after a script moved, turned or resized it (a curve has none to update). The area that
 * the laser passes over in this change is not tested for hits. */
void lasers_update_tail(struct board *b, uint32_t i);

/* Moves laser i to (x, y) for a script; a curve moves with its whole body. */
void lasers_move_to(struct board *b, uint32_t i, fx x, fx y);

/* Returns the age of laser i, in frames. lasers_shown_age is for drawing and inspecting between frames: it returns the
 * age that hit detection used in the last frame. */
uint32_t lasers_age(const struct board *b, uint32_t i);
uint32_t lasers_shown_age(const struct board *b, uint32_t i);

/* Returns the state of laser i at an age. A delayed bolt or curve is in LASER_WARN. */
enum laser_state lasers_state_of(const struct board *b, uint32_t i, uint32_t age);

/* lasers_corner_count returns the number of corners of laser i's line, 2 for a beam or bolt; lasers_get_corner stores
 * corner k, where 0 is the head. */
uint32_t lasers_corner_count(const struct board *b, uint32_t i);
void lasers_get_corner(const struct board *b, uint32_t i, uint32_t k, fx *x, fx *y);

/* Stores the position of corner k before this frame's move. */
void lasers_get_old_corner(const struct board *b, uint32_t i, uint32_t k, fx *x, fx *y);

/* The ends of a segment of a laser's line. lasers_segment_count returns the number of segments, at least 1: the line of
 * a curve with a single point is one segment of length 0. lasers_get_old_segment returns segment k before this frame's
 * move. */
struct lasers_segment {
    fx x, y, to_x, to_y;
};
uint32_t lasers_segment_count(const struct board *b, uint32_t i);
struct lasers_segment lasers_get_segment(const struct board *b, uint32_t i, uint32_t k);
struct lasers_segment lasers_get_old_segment(const struct board *b, uint32_t i, uint32_t k);

/* Calls `each` for positions along the line of laser i, `spacing` px apart, starting half that distance from the head.
 * Returns the number of calls. If the line is too short, calls `each` once, for the head. spacing > 0. */
uint32_t lasers_visit_positions(struct board *b, uint32_t i, fx spacing,
                                void (*each)(struct board *b, fx x, fx y, void *context), void *context);

/* Stores the point of laser i's line that is nearest to (x, y), to within 1/256 px. */
void lasers_get_nearest_point(const struct board *b, uint32_t i, fx x, fx y, fx *to_x, fx *to_y);

/* Returns whether laser i, as it is drawn now (all points within half its width of the line), overlaps the box around
 * (x, y) with half extents (w, h), or the set of all points within a of the line from (x, y) to (to_x, to_y). */
bool lasers_overlap_box(const struct board *b, uint32_t i, fx x, fx y, fx w, fx h);
bool lasers_overlap_line(const struct board *b, uint32_t i, fx x, fx y, fx to_x, fx to_y, fx a);

#endif
