/*
 * reach.h - for each frame of a forecast, a set of cells that contains every position that the ship could have reached
 * without a hit, and more.
 *
 * The sets are never too small. A cell is left out only if the ship is certainly hit at every position in it: shapes
 * are taken smaller than they are (by MARGIN, or as inner shapes), and a ship in a cell may be anywhere in it. An empty
 * set therefore proves that these bullets leave no path. A set that is not empty proves nothing.
 */
#ifndef WORKBENCH_REACH_H
#define WORKBENCH_REACH_H

#include "simulation.h"

enum { REACH_WAYS = 17 /* moves: none, eight directions, and these with focus */ };

struct reach {
    const struct forecast *f;
    fx cell;  /* side of a cell, px */
    fx grown; /* added to the ship's radius, px */
    struct box area;
    int w, h;        /* cells */
    size_t bytes;    /* of a set; a bit for each cell */
    uint32_t frames; /* the sets are 0 to frames; set 0: before frame[0] of the forecast */
    uint32_t room;   /* allocated sets */
    uint8_t *sets;
    uint8_t *from, *to, *dead; /* a byte for each cell; temporary */
    int x0, y0, x1, y1;        /* bounds of the cells in `from`; x1 < x0: none */
};

/* Return the buttons of a move, 0 to REACH_WAYS - 1, and move (x, y). */
uint16_t reach_pads(int way);
void reach_step(const struct danger_ship *ship, int way, fx *x, fx *y);

/* Computes the sets for a ship at (x, y) before the first frame, until a set is empty or the forecast ends. False: out
 * of memory, or no frames. */
bool reach_open(struct reach *r, const struct forecast *f, fx cell, fx grown, fx x, fx y);
void reach_close(struct reach *r);

/* Returns whether set `frames` is empty. */
bool reach_ended(const struct reach *r);

/* Removes the cells that do not lead to the last set that is not empty. */
void reach_back(struct reach *r);

/* Returns whether (x, y) is in set t. */
bool reach_has(const struct reach *r, uint32_t t, fx x, fx y);

/* Returns the number of cells in set t. */
uint32_t reach_count(const struct reach *r, uint32_t t);

#endif
