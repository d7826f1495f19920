/*
 * plan.h - a path for the ship through a forecast, with exact positions and exact hit tests.
 */
#ifndef WORKBENCH_PLAN_H
#define WORKBENCH_PLAN_H

#include "reach.h"

struct plan {
    uint16_t *pads;  /* of player 1 in each frame, without fire */
    uint32_t frames; /* of the path: all of the forecast, or as many as the longest path has */
    uint64_t tried;  /* number of moves tried */
};

/* Searches for a path from (x, y) inside the sets of r, after reach_prune. Tries at most `max_moves` moves, and one
 * position per cell and frame. `seed` varies the choice between good paths. `aims`: 1: prefer positions below
 * enemies; 2: prefer them strongly to free space. False: out of memory. */
bool plan_make(struct plan *p, const struct reach *r, fx x, fx y, uint64_t max_moves, uint32_t seed, int aims);
void plan_free(struct plan *p);

/* Returns whether something hits the ship on this move in a frame. extra_radius: added to the ship's radius. */
bool plan_hits(const struct forecast *f, uint32_t frame, const struct danger_path *move, fx extra_radius);

#endif
