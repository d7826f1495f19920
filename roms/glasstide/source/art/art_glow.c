/*
 * art_glow.c - light for blended drawing: a lamp of 128 px and an ember of 24 px, in the ramp of bank 0, and strips of
 * lasers: a ray one pixel wide, a glow, a scaled skin. Half-tones
 * between two shades, and the fading out at the rim, are dithered: added to what lies under it, each shade is a step of
 * brightness, and a step along a circle would show.
 */
#include "art.h"

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
            int shade = (int)(v + art_dither(i, j));
            sheet_set(s, x + i, y + j, shade > 15 ? 15 : shade);
        }
}

/* A ray, across: a rim, its colour, and a white core. */
static void ray(struct sheet *s, int x, int y)
{
    static const int shades[16] = { 3, 6, 8, 9, 11, 13, 15, 15, 15, 15, 13, 11, 9, 8, 6, 3 };

    for (int j = 0; j < 16; j++)
        sheet_set(s, x, y + j, shades[j]);
}

/* Light along a line, four pixels of it, for the dither repeats after so many. */
static void glow_strip(struct sheet *s, int x, int y, int h)
{
    for (int j = 0; j < h; j++)
        for (int i = 0; i < 4; i++) {
            double d = (j + 0.5) / h * 2 - 1, depth = 1 - d * d;
            sheet_set(s, x + i, y + j, (int)(art_clamp(15 * depth * depth, 0, 14.9) + art_dither(i, j)));
        }
}

/* A skin of arrows: 16 px that repeat, pointing along the line. */
static void skin(struct sheet *s, int x, int y)
{
    for (int j = 0; j < 12; j++)
        for (int i = 0; i < 16; i++) {
            int off = j < 6 ? 5 - j : j - 6, phase = (i + off) & 15;
            int shade = off == 5 ? 3 : phase < 4 ? 15 - off : phase < 7 ? 11 - off : 8 - off / 2;
            sheet_set(s, x + i, y + j, shade);
        }
}

struct sheet art_glow(void)
{
    struct sheet s = sheet_new(160, 128, 0);

    light(&s, 0, 0, 128, 7.5, false);
    light(&s, 128, 0, 24, 17, true);
    ray(&s, 128, 32);
    glow_strip(&s, 132, 32, 24);
    skin(&s, 136, 32);
    return s;
}
