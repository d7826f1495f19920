/*
 * blend.c - see blend.h. 65536 colours are looked for among 241. The colour cube is cut into cells, and each cell in
 * which a colour is looked for gets a list of the entries that can be nearest to one there: an entry whose distance
 * from the cell's nearest point is above another's from its farthest is none of them. So a search looks at some thirty
 * entries and finds what a look at all would find.
 */
#include "blend.h"

#include <stdlib.h>

enum { CELL = 32, SIDE = 256 / CELL, CELLS = SIDE * SIDE * SIDE };

struct grid {
    const uint8_t *rgb;
    int count[CELLS]; /* 0: nothing was looked for there yet */
    uint8_t list[CELLS][256];
};

static int square(int v)
{
    return v * v;
}

/* Of the distances of colour c from the points of a cell whose lowest corner is `low`: the least and the greatest,
 * squared. */
static void reach(const uint8_t *c, const int low[3], int *least, int *most)
{
    *least = *most = 0;
    for (int i = 0; i < 3; i++) {
        int below = low[i] - c[i], above = c[i] - (low[i] + CELL - 1); /* outside it on that side, when positive */
        *least += square(below > 0 ? below : above > 0 ? above : 0);
        *most += square(below > above ? below + CELL - 1 : above + CELL - 1);
    }
}

/* Column 0 of a bank is not drawn, but entry 0 is the background. */
static bool is_shown(int entry)
{
    return entry == 0 || entry % 16 != 0;
}

static void fill_cell(struct grid *g, int cell)
{
    const int low[3] = { cell / SIDE / SIDE * CELL, cell / SIDE % SIDE * CELL, cell % SIDE * CELL };
    int least[256], most, bound = 3 * 256 * 256;

    for (int i = 0; i < 256; i++) {
        reach(g->rgb + 3 * i, low, &least[i], &most);
        if (is_shown(i) && most < bound)
            bound = most;
    }
    for (int i = 0; i < 256; i++)
        if (is_shown(i) && least[i] <= bound)
            g->list[cell][g->count[cell]++] = (uint8_t)i;
}

static uint8_t nearest(struct grid *g, const int c[3])
{
    int cell = (c[0] / CELL * SIDE + c[1] / CELL) * SIDE + c[2] / CELL, best = 0, off = 3 * 256 * 256;

    if (g->count[cell] == 0)
        fill_cell(g, cell);
    for (int k = 0; k < g->count[cell]; k++) {
        int entry = g->list[cell][k];
        const uint8_t *p = g->rgb + 3 * entry;
        int d = square(c[0] - p[0]) + square(c[1] - p[1]) + square(c[2] - p[2]);
        if (d < off) {
            off = d;
            best = entry;
        }
    }
    return (uint8_t)best;
}

static int blended(int under, int over, int mix)
{
    if (mix == BLEND_ADD)
        return under + over < 255 ? under + over : 255;
    return (under * (100 - mix) + over * mix + 50) / 100;
}

bool blend_make(const uint8_t *rgb, int mix, uint8_t table[CART_BLEND_SIZE])
{
    if (mix <= BLEND_RULE) {
        for (int i = 0; i < CART_BLEND_SIZE; i++)
            table[i] =
                blit_ramp_entry((enum blit_mix)(BLEND_RULE + BLIT_RAMP_ADD - mix), (uint8_t)(i >> 8), (uint8_t)i);
        return true;
    }
    struct grid *g = calloc(1, sizeof *g);

    if (g == NULL)
        return false;
    g->rgb = rgb;
    for (int under = 0; under < 256; under++)
        for (int over = 0; over < 256; over++) {
            int c[3];
            for (int i = 0; i < 3; i++)
                c[i] = blended(g->rgb[3 * under + i], g->rgb[3 * over + i], mix);
            table[under * 256 + over] = nearest(g, c);
        }
    free(g);
    return true;
}
