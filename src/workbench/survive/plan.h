/*
 * plan.h - a path for the ship through a forecast, with exact positions and exact hit tests.
 */
#ifndef WORKBENCH_PLAN_H
#define WORKBENCH_PLAN_H

#include "reach.h"

struct plan {
    uint16_t *pads;  /* of player 1 in each frame, without fire */
    uint32_t frames; /* of the path: those of the forecast, or fewer if no path is longer */
    uint64_t tried;  /* moves */
};

/* Searches for a path from (x, y) inside the sets of r, after reach_back. Tries at most `most` moves, and one position
 * per cell and frame. `taste` varies the choice between good paths. `aims`: 1: the ship prefers to be below enemies; 2:
 * it prefers that strongly to free space. False: out of memory. */
bool plan_make(struct plan *p, const struct reach *r, fx x, fx y, uint64_t most, uint32_t taste, int aims);
void plan_free(struct plan *p);

/* Returns whether something hits the ship on this move in a frame. grown: added to the ship's radius. */
bool plan_hits(const struct forecast *f, uint32_t frame, const struct danger_path *way, fx grown);

#endif
