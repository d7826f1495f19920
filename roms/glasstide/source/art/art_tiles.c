/*
 * art_tiles.c - tiles of 16 px for backgrounds, eight a row, in the ramp of bank 13: the sea in four tiles that join on
 * all sides, four slabs; a cloud of three tiles and a puff, a tower's cap, wall and window, a bush.
 */
#include "art.h"

enum { SIDE = 16 };

/* Waves that repeat after 64 px across and 16 down; half-tones by the 2 x 2 matrix. */
static void sea(struct sheet *s)
{
    static const double order[2][2] = { { 0.125, 0.625 }, { 0.875, 0.375 } };

    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < 4 * SIDE; x++) {
            double v = art_sin(y / 16.0 + 0.6 * art_sin(x / 64.0)) + 0.6 * art_sin(2 * y / 16.0 - 3 * x / 64.0);
            sheet_set(s, x, y, (int)(art_clamp(5.2 + 1.7 * v, 2, 9) + order[y & 1][x & 1]));
            if (v > 1.42)
                sheet_set(s, x, y, 13);
        }
}

/* A slab whose edges catch the light. */
static void slab(struct sheet *s, int x, int y, int shade)
{
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) {
            bool lit = i == 0 || j == 0, dark = i == SIDE - 1 || j == SIDE - 1;
            sheet_set(s, x + i, y + j, shade + (dark ? -3 : lit ? 3 : (i * 7 + j * 5) % 11 == 0 ? 1 : 0));
        }
}

static void cloud(struct sheet *s, int x, int y)
{
    const struct mat m = { MATTE, 8, 12, 0.2 };
    struct paint *p = paint_new(3 * SIDE, SIDE);

    paint_ball(p, m, -13, 3, 9, 4.5, 0);
    paint_ball(p, m, 12, 3, 10, 4.5, 0);
    paint_ball(p, m, -5, 0, 9, 6.5, 0);
    paint_ball(p, m, 5, 1, 9, 6, 0);
    paint_done(p, s, x, y, 7, 15);
    p = paint_new(SIDE, SIDE);
    paint_ball(p, m, 0, 2, 6, 4, 0);
    paint_done(p, s, x + 3 * SIDE, y, 7, 15);
}

/* A wall of bricks; a window in it, or the cap. */
static void wall(struct sheet *s, int x, int y, bool window, bool cap)
{
    for (int j = cap ? 4 : 0; j < SIDE; j++)
        for (int i = 2; i < SIDE - 2; i++) {
            bool joint = j % 4 == 3 || (i + (j / 4 % 2) * 4) % 8 == 0;
            bool pane = window && i >= 6 && i <= 9 && j >= 4 && j <= 11;
            sheet_set(s, x + i, y + j, pane ? 14 : (i < 5 ? 9 : i > 10 ? 4 : 7) - joint);
        }
    for (int i = 0; i < SIDE && cap; i++)
        for (int j = i % 4 < 2 ? 0 : 3; j < 6; j++)
            sheet_set(s, x + i, y + j, j == 5 ? 4 : 10);
}

static void bush(struct sheet *s, int x, int y)
{
    struct paint *p = paint_new(SIDE, SIDE);

    paint_ball(p, (struct mat){ MATTE, 3, 8, 0 }, -3, 4, 5, 5, 0);
    paint_ball(p, (struct mat){ MATTE, 3, 8, 0 }, 3, 3, 5, 6, 0);
    paint_done(p, s, x, y, 1, 0);
}

struct sheet art_tiles(void)
{
    struct sheet s = sheet_new(8 * SIDE, 2 * SIDE, 13);

    sea(&s);
    for (int k = 0; k < 4; k++)
        slab(&s, (4 + k) * SIDE, 0, 5 + k);
    cloud(&s, 0, SIDE);
    wall(&s, 4 * SIDE, SIDE, false, true);
    wall(&s, 5 * SIDE, SIDE, false, false);
    wall(&s, 6 * SIDE, SIDE, true, false);
    bush(&s, 7 * SIDE, SIDE);
    return s;
}
