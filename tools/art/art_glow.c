/*
 * art_glow.c - light for blended drawing: a lamp of 128 px and an ember of 24 px, in the ramp of bank 0. Half-tones
 * between two shades, and the fading out at the rim, are dithered: added to what lies under it, each shade is a step of
 * brightness, and a step along a circle would show.
 * floor: tools
 */
#include "art.h"

/* The threshold of a pixel, 1/32 to 31/32: the 4 x 4 ordered matrix of Bayer, 1973. */
static double threshold(int x, int y)
{
    static const int order[4][4] = { { 0, 8, 2, 10 }, { 12, 4, 14, 6 }, { 3, 11, 1, 9 }, { 15, 7, 13, 5 } };

    return (order[y & 3][x & 3] * 2 + 1) / 32.0;
}

/* Light that falls off from `core` in the middle to nothing at the rim, as the square of the depth (squared again for a
 * ball: its middle is broad). */
static void light(struct sheet *s, int x, int y, int size, double core, bool ball)
{
    double r = size / 2.0;

    for (int j = 0; j < size; j++)
        for (int i = 0; i < size; i++) {
            double dx = i + 0.5 - r, dy = j + 0.5 - r, d2 = (dx * dx + dy * dy) / (r * r), depth = 1 - d2;
            if (depth <= 0)
                continue;
            double v = core * depth * depth * (ball ? 1 : depth);
            int shade = (int)(v + threshold(i, j));
            sheet_set(s, x + i, y + j, shade > 15 ? 15 : shade);
        }
}

struct sheet art_glow(void)
{
    struct sheet s = sheet_new(160, 128, 0);

    light(&s, 0, 0, 128, 7.5, false);
    light(&s, 128, 0, 24, 17, true);
    return s;
}
