/*
 * art_water.c - black water at night, the moon's light on it, and the town that the tide took, seen through it: three
 * pictures of 240 x 320 px in the ramp of bank 13 of the moon's palette. The first two join above and below.
 */
#include "art.h"

#include <math.h>

enum { WIDE = 240, HIGH = 320, STROKES = 430, SPARKS = 120 };

/* Swells that lie across: long, low, and bent by each other. */
static void swell(struct sheet *s)
{
    for (int y = 0; y < HIGH; y++) {
        for (int x = 0; x < WIDE; x++) {
            double a = (double)y / HIGH, b = (double)x / WIDE;
            double warp = 0.5 * art_sin(b + 2 * a) + 0.3 * art_sin(2 * b - 3 * a + 0.2);
            double v = art_sin(9 * a + warp) + 0.6 * art_sin(21 * a + 1.4 * warp + b) + 0.3 * art_sin(34 * a - 3 * b);
            double off = (b - 0.5) * (b - 0.5) * 4;
            sheet_set(s, x, y, (int)art_clamp(4.4 + 1.5 * v - 1.5 * off + art_dither(x, y), 1, 7));
        }
    }
}

/* One stroke of light: pointed at both ends, brightest in its middle. */
static void stroke(struct sheet *s, int x, int y, int half, int shade)
{
    for (int i = -half; i <= half; i++) {
        int far = i < 0 ? -i : i, c = shade - 4 * far / (half + 1);
        sheet_set(s, x + i, HIGH + (y + HIGH) % HIGH, c < 5 ? 5 : c);
        if (half > 4 && far < half / 2)
            sheet_set(s, x + i, HIGH + (y + 1 + HIGH) % HIGH, c > 7 ? c - 2 : 5);
    }
}

/* The way of light: strokes lie closer and longer in its middle. */
static void light(struct sheet *s)
{
    uint32_t seed = 41;

    for (int i = 0; i < STROKES; i++) {
        double y = art_random(&seed) * HIGH, turn = y / HIGH;
        double off = art_random(&seed) + art_random(&seed) + art_random(&seed) - 1.5;
        double wide = 34 + 12 * art_sin(3 * turn) + 7 * art_sin(7 * turn + 0.3);
        double near = 1 - fabs(off) / 1.5;
        int half = 2 + (int)(7 * near * art_random(&seed));
        stroke(s, 120 + (int)(off * wide), (int)y, half, 6 + (int)(6.4 * near * near));
    }
    for (int i = 0; i < SPARKS; i++) { /* what glimmers: the palette goes round in these */
        double off = art_random(&seed) + art_random(&seed) + art_random(&seed) - 1.5;
        int x = 120 + (int)(off * 36), y = (int)(art_random(&seed) * HIGH);
        sheet_set(s, x, HIGH + y, 13 + i % 3);
        sheet_set(s, x + 1, HIGH + y, 13 + i % 3);
    }
}

/* -- the drowned town -- */

static const struct mat WALL = { MATTE, 3, 10, 0.04 }, ROOF = { MATTE, 2, 7, 0 }, DARK = { FLAT, 1, 1, 0 },
                        LIT = { FLAT, 14, 14, 0 };

/* A house whose foot is at y: its roof, and windows, of which some are lit. */
static void house(struct paint *p, double x, double y, double wide, double tall, uint32_t *seed)
{
    double wall[] = { x - wide, y - tall, x + wide, y - tall, x + wide, y, x - wide, y };
    double roof[] = { x - wide - 2.5, y - tall + 1, x, y - tall - wide * 0.9, x + wide + 2.5, y - tall + 1 };

    paint_poly(p, WALL, 4, wall, 3);
    paint_poly(p, ROOF, 3, roof, 2.6);
    for (double v = y - tall + 8; v < y - 4; v += 13)
        for (double u = x - wide + 6; u < x + wide - 3; u += 9)
            paint_ball(p, art_random(seed) < 0.2 ? LIT : DARK, u, v, 1.9, 2.9, 0);
}

/* The tower of its bell, which leans, with the bell still in it. */
static void tower(struct paint *p, double x, double y)
{
    double wall[] = { x - 15, y - 150, x + 13, y - 152, x + 22, y, x - 18, y };
    double belfry[] = { x - 19, y - 190, x + 13, y - 192, x + 15, y - 148, x - 18, y - 146 };
    double spire[] = { x - 21, y - 188, x - 7, y - 246, x + 15, y - 191 };

    paint_poly(p, WALL, 4, wall, 8);
    paint_poly(p, WALL, 4, belfry, 4);
    paint_poly(p, ROOF, 3, spire, 6);
    paint_limb(p, WALL, x - 7, y - 244, 0.9, x - 8, y - 258, 0.7);
    paint_ball(p, DARK, x - 2, y - 168, 9.5, 13, 0);
    paint_ball(p, ROOF, x - 2, y - 170, 5.4, 6.6, 0);
    paint_limb(p, ROOF, x - 9, y - 162, 1.7, x + 5, y - 162.6, 1.7);
    paint_ball(p, LIT, x - 2, y - 158, 1.8, 1.8, 0);
    for (int i = 0; i < 4; i++)
        paint_ball(p, i == 2 ? LIT : DARK, x + 1.0 + i, y - 126 + 30 * i, 2.8, 5, 0);
    paint_ball(p, WALL, x - 1, y - 134, 8, 8, 0);
    paint_ball(p, DARK, x - 1, y - 134, 6.4, 6.4, 0);
    paint_limb(p, LIT, x - 1, y - 134, 0.8, x - 1, y - 139, 0.7);
    paint_limb(p, LIT, x - 1, y - 134, 0.8, x + 3, y - 132, 0.7);
}

static void town(struct sheet *s)
{
    struct paint *p = paint_new(WIDE, HIGH);
    const double foot = HIGH / 2.0 + 2;
    uint32_t seed = 9;

    house(p, -64, foot - 28, 13, 44, &seed);
    house(p, 62, foot - 24, 15, 58, &seed);
    house(p, 104, foot - 18, 14, 86, &seed);
    tower(p, -92, foot - 14);
    for (int i = 0; i < 9; i++)
        house(p, -116 + 29 * i, foot, art_pick(&seed, 10, 16), art_pick(&seed, 16, 40), &seed);
    paint_done(p, s, 0, 2 * HIGH, 1, 1);
}

struct sheet art_water(void)
{
    struct sheet s = sheet_new(WIDE, 3 * HIGH, 13);

    swell(&s);
    light(&s);
    town(&s);
    return s;
}
