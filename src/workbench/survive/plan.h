/*
 * plan.h - a way for the ship through a forecast, by exact places and exact hits.
 */
#ifndef WORKBENCH_PLAN_H
#define WORKBENCH_PLAN_H

#include "reach.h"

struct plan {
    uint16_t *pads;  /* of player 1, without fire, a frame each */
    uint32_t frames; /* so many: those of the forecast, or fewer if no way goes on from there */
    uint64_t tried;  /* ways that were looked at */
};

/* Looks from (x, y) on for a way that stays in the sets of r, which reach_back has seen. At most `most` ways are looked
 * at; of every cell one place is tried in a frame. `taste` varies which of the good ways is taken. `aims`: 1: it
 * would rather be under what can be shot; 2: much rather than where there is room. False: no memory. */
bool plan_make(struct plan *p, const struct reach *r, fx x, fx y, uint64_t most, uint32_t taste, int aims);
void plan_free(struct plan *p);

/* Is that way hit in a frame of the forecast? grown: added to the ship's radius. */
bool plan_hits(const struct forecast *f, uint32_t frame, const struct danger_path *way, fx grown);

#endif
