/*
 * art_bench.c - the bench's bullets: four discs of 8, 12, 16 and 24 px, in the ramp of bank 0.
 */
#include "art.h"

static void disc(struct sheet *s, int x, int size)
{
    double r = size / 2.0;

    for (int j = 0; j < size; j++)
        for (int i = 0; i < size; i++) {
            double dx = i + 0.5 - r, dy = j + 0.5 - r, d2 = (dx * dx + dy * dy) / (r * r);
            if (d2 <= 1)
                sheet_set(s, x + i, j, 15 - (int)(d2 * 13));
        }
}

struct sheet art_bench(void)
{
    struct sheet s = sheet_new(64, 24, 0);

    disc(&s, 0, 8);
    disc(&s, 8, 12);
    disc(&s, 20, 16);
    disc(&s, 36, 24);
    return s;
}
