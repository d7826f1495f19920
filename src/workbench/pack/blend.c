/*
 * blend.c - see blend.h. Finds the nearest of 241 palette entries for each of 65536 colours. The colour cube is divided
 * into cells. Each cell in which a colour is searched gets a list of candidates: the entries that can be nearest to a
 * colour in the cell. An entry is no candidate if even its nearest point of the cell is farther away than another
 * entry's farthest point. A search then compares about thirty entries, with the same result as comparing all.
 */
#include "blend.h"

#include <stdlib.h>

enum { CELL = 32, SIDE = 256 / CELL, CELLS = SIDE * SIDE * SIDE };

struct grid {
    const uint8_t *rgb;
    int count[CELLS]; /* of candidates; 0: not listed yet */
    uint8_t candidates[CELLS][256];
};

static int squared(int v)
{
    return v * v;
}

/* Computes the smallest and the largest squared distance of colour c from the points of a cell with the lowest corner
 * `low`. */
static void distance_range(const uint8_t *c, const int low[3], int *min, int *max)
{
    *min = *max = 0;
    for (int i = 0; i < 3; i++) {
        int below = low[i] - c[i], above = c[i] - (low[i] + CELL - 1); /* positive: outside on that side */
        *min += squared(below > 0 ? below : above > 0 ? above : 0);
        *max += squared(below > above ? below + CELL - 1 : above + CELL - 1);
    }
}

/* Column 0 of a bank is transparent, but entry 0 is the background. */
static bool is_shown(int entry)
{
    return entry == 0 || entry % 16 != 0;
}

static void list_candidates(struct grid *g, int cell)
{
    const int low[3] = { cell / SIDE / SIDE * CELL, cell / SIDE % SIDE * CELL, cell % SIDE * CELL };
    int min[256], max, bound = 3 * 256 * 256;

    for (int i = 0; i < 256; i++) {
        distance_range(g->rgb + 3 * i, low, &min[i], &max);
        if (is_shown(i) && max < bound)
            bound = max;
    }
    for (int i = 0; i < 256; i++)
        if (is_shown(i) && min[i] <= bound)
            g->candidates[cell][g->count[cell]++] = (uint8_t)i;
}

static uint8_t nearest_entry(struct grid *g, const int c[3])
{
    int cell = (c[0] / CELL * SIDE + c[1] / CELL) * SIDE + c[2] / CELL, best = 0, best_distance = 3 * 256 * 256;

    if (g->count[cell] == 0)
        list_candidates(g, cell);
    for (int k = 0; k < g->count[cell]; k++) {
        int entry = g->candidates[cell][k];
        const uint8_t *p = g->rgb + 3 * entry;
        int d = squared(c[0] - p[0]) + squared(c[1] - p[1]) + squared(c[2] - p[2]);
        if (d < best_distance) {
            best_distance = d;
            best = entry;
        }
    }
    return (uint8_t)best;
}

static int blend_channel(int under, int over, int mix)
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
                c[i] = blend_channel(g->rgb[3 * under + i], g->rgb[3 * over + i], mix);
            table[under * 256 + over] = nearest_entry(g, c);
        }
    free(g);
    return true;
}
