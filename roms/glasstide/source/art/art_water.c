/*
 * art_water.c - black water at night, and the moon's light on it: two pictures of 240 x 320 px that join above and
 * below, in the ramp of bank 13 of the moon's palette.
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
            sheet_set(s, x, y, (int)art_clamp(3.3 + 1.25 * v - 1.6 * off + art_dither(x, y), 1, 6));
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

struct sheet art_water(void)
{
    struct sheet s = sheet_new(WIDE, 2 * HIGH, 13);

    swell(&s);
    light(&s);
    return s;
}
