/*
 * reach.h - for each frame of a forecast, a set of cells that covers every position that the ship can reach without a
 * hit.
 *
 * The sets are conservative. A cell is removed only if the ship is certainly hit at every position in it: shapes are
 * made smaller (by MARGIN, or by using inner shapes), and a ship in a cell may be anywhere in it. An empty set
 * therefore proves that these bullets leave no path. A set that is not empty proves nothing.
 */
#ifndef WORKBENCH_REACH_H
#define WORKBENCH_REACH_H

#include "simulation.h"

enum { REACH_MOVES = 17 /* no move, eight directions, and eight directions with focus */ };

struct reach {
    const struct forecast *f;
    fx cell;         /* side of a cell, px */
    fx extra_radius; /* added to the ship's radius, px */
    struct box area;
    int w, h;          /* cells */
    size_t bytes;      /* of a set: a bit per cell */
    uint32_t frames;   /* the sets are 0 to frames; set 0: before frame[0] of the forecast */
    uint32_t capacity; /* allocated sets */
    uint8_t *sets;
    uint8_t *current, *next, *hit; /* temporary, a byte per cell: current set, next set, cells whose move is hit */
    int x0, y0, x1, y1;            /* bounds of the current set; x1 < x0: empty */
};

/* Return the buttons of a move, 0 to REACH_MOVES - 1, and apply it to (x, y). */
uint16_t reach_move_pads(int move);
void reach_apply_move(const struct danger_ship *ship, int move, fx *x, fx *y);

/* Computes the sets for a ship at (x, y) before the first frame, until a set is empty or the forecast ends. False: out
 * of memory, or no frames. */
bool reach_compute(struct reach *r, const struct forecast *f, fx cell, fx extra_radius, fx x, fx y);
void reach_free(struct reach *r);

/* Returns whether set `frames` is empty. */
bool reach_is_empty(const struct reach *r);

/* Removes the cells that don't lead to the last set that is not empty. */
void reach_prune(struct reach *r);

/* Returns whether (x, y) is in set t. */
bool reach_has(const struct reach *r, uint32_t t, fx x, fx y);

/* Returns the number of cells in set t. */
uint32_t reach_count(const struct reach *r, uint32_t t);

#endif
