/*
 * crowd.h - the crowd of roms/bench on a board, as the references want to be told of it, and what must be equal.
 */
#ifndef BENCH_CROWD_H
#define BENCH_CROWD_H

#include "reference.h"
#include "scene.h"

/* The crowd as it stands after the scene's last frame; false: out of memory, or it is no crowd. bullets are
 * malloc'ed. */
bool crowd_take(struct crowd *c, const struct scene *s);

/* The player in the scene's last frame. */
struct crowd_player crowd_player(const struct scene *s);

/* Adds what the scene's last tick and, if `drawn`, its last picture counted. */
void crowd_count(struct crowd_counts *sum, const struct scene *s, bool drawn);

/* NULL when the reference stands as the board does, each bullet in its place, and their last pictures are equal; or
 * what differs. */
const char *crowd_differs(const struct crowd *c, const struct scene *s, const struct reference *r, const void *data);

/* NULL when the scene's picture is the painter's, or what is wrong. */
const char *crowd_misdrawn(const struct crowd *c, const struct scene *s);

#endif
