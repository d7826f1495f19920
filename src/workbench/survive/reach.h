/*
 * reach.h - where a ship could be: for each frame of a forecast a set of cells that holds every place to which any
 * buttons could have brought it without a hit, and more.
 *
 * The sets are never too small. A cell is left out only where every place in it is hit for certain: what hits is taken
 * smaller than it is (MARGIN, and inner shapes where the exact one is awkward), and a ship that ends anywhere in a cell
 * is held to be anywhere in it. So an empty set proves that these bullets leave no way. A set that is not empty proves
 * nothing.
 */
#ifndef WORKBENCH_REACH_H
#define WORKBENCH_REACH_H

#include "trial.h"

enum { REACH_WAYS = 17 /* standing, eight directions, and those with focus */ };

struct reach {
    const struct forecast *f;
    fx cell;  /* px a cell has on each side */
    fx grown; /* px, added to the ship's radius */
    struct box area;
    int w, h;        /* cells */
    size_t bytes;    /* of a set, a bit a cell */
    uint32_t frames; /* sets 0 to frames are there; set 0: before frame[0] of the forecast */
    uint32_t room;   /* sets there is memory for */
    uint8_t *sets;
    uint8_t *from, *to, *dead; /* a byte a cell, while it works */
    int x0, y0, x1, y1;        /* the cells of `from` that are not empty lie within; x1 < x0: none */
};

/* The buttons of a way, 0 to REACH_WAYS - 1, and where it leads from (x, y). */
uint16_t reach_pads(int way);
void reach_step(const struct danger_ship *ship, int way, fx *x, fx *y);

/* Sets of cells of that size, for a forecast in whose first frame the ship is in the game, having been at (x, y).
 * Goes on until a set is empty, or the forecast ends: r->frames. False: no memory, or there is no frame. */
bool reach_open(struct reach *r, const struct forecast *f, fx cell, fx grown, fx x, fx y);
void reach_close(struct reach *r);

/* Is set `frames` empty? */
bool reach_ended(const struct reach *r);

/* Leaves in each set only what leads to the last one that is not empty. */
void reach_back(struct reach *r);

/* Is (x, y) in set t? Outside of the area: no. */
bool reach_has(const struct reach *r, uint32_t t, fx x, fx y);

/* Cells in set t. */
uint32_t reach_count(const struct reach *r, uint32_t t);

#endif
