/*
 * art_abyss.c - the ground of the deep, which is seen at an angle: plates of stone with light in their cracks,
 * 128 x 128 px that join on all sides, in the ramp of bank 13. And what sinks from broken creatures, on bank 0.
 */
#include "art.h"

#include <math.h>

enum { SIDE = 128, ACROSS = 5, PLATES = ACROSS * ACROSS };

struct plate {
    double x, y, shade, lean_x, lean_y;
    bool lit; /* what its cracks hold glimmers */
};

static void lay_plates(struct plate *plates)
{
    uint32_t seed = 77;

    for (int i = 0; i < PLATES; i++) {
        double side = (double)SIDE / ACROSS;
        plates[i].x = (i % ACROSS + 0.12 + 0.76 * art_random(&seed)) * side;
        plates[i].y = (i / ACROSS + 0.12 + 0.76 * art_random(&seed)) * side;
        plates[i].shade = 4.2 + 2.4 * art_random(&seed);
        plates[i].lean_x = 0.16 * (art_random(&seed) - 0.5);
        plates[i].lean_y = 0.16 * (art_random(&seed) - 0.5);
        plates[i].lit = i % 7 == 3;
    }
}

/* The shorter way round the picture. */
static double wrapped(double d)
{
    return d > SIDE / 2.0 ? d - SIDE : d < -SIDE / 2.0 ? d + SIDE : d;
}

static int shade_at(const struct plate *plates, int x, int y)
{
    static const double order[2][2] = { { 0.125, 0.625 }, { 0.875, 0.375 } };
    double turn_x = (double)x / SIDE, turn_y = (double)y / SIDE, nearest = 1e9, second = 1e9, px = 0, py = 0;
    double u = x + 3.5 * art_sin(2 * turn_y + turn_x) + 1.3 * art_sin(7 * turn_x - 3 * turn_y);
    double v = y + 3.5 * art_sin(2 * turn_x - turn_y) + 1.3 * art_sin(6 * turn_y + 4 * turn_x);
    const struct plate *on = plates;

    for (int i = 0; i < PLATES; i++) {
        double dx = wrapped(u - plates[i].x), dy = wrapped(v - plates[i].y), d = sqrt(dx * dx + dy * dy);
        if (d < nearest) {
            second = nearest, nearest = d;
            on = &plates[i], px = dx, py = dy;
        } else if (d < second) {
            second = d;
        }
    }
    double edge = second - nearest;
    if (edge < 1.5)
        return on->lit && edge < 1.1 ? 13 + (x / 4 + y / 4) % 3 : 1;
    double grain = 0.5 * art_sin(9 * turn_x + 5 * turn_y + 0.4 * art_sin(8 * turn_y)) + 0.4 * art_sin(13 * turn_y);
    double bevel = edge < 4 && px + py < 0 ? 2 : edge < 4 ? -1.4 : 0;
    return (int)art_clamp(on->shade + on->lean_x * px + on->lean_y * py + grain + bevel + order[y & 1][x & 1], 2, 10);
}

struct sheet art_seabed(void)
{
    struct sheet s = sheet_new(SIDE, SIDE, 13);
    struct plate plates[PLATES];

    lay_plates(plates);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            sheet_set(&s, x, y, shade_at(plates, x, y));
    return s;
}

/* -- what sinks: a pearl, a conch, a heart, foam; and the ray of a lamp -- */

static const struct mat NACRE = { GLASS, 6, 15, 0.25 }, SHELL = { MATTE, 4, 13, 0.1 }, LIP = { FLAT, 15, 15, 0 };

static void pearl(struct sheet *s, int x)
{
    struct paint *p = paint_new(14, 14);

    paint_ball(p, NACRE, 0, 0, 5.2, 5.2, 0);
    paint_ball(p, LIP, -1.8, -1.8, 1.3, 1.3, 0);
    paint_done(p, s, x, 0, 2, 0);
}

/* Three whorls, each larger than the one before, and the mouth. */
static void conch(struct sheet *s, int x)
{
    struct paint *p = paint_new(16, 16);

    paint_limb(p, SHELL, 4.6, -5.2, 0.6, 1, -1, 3);
    paint_ball(p, SHELL, 2.4, -2.8, 2.6, 1.5, 0.1);
    paint_ball(p, SHELL, 0.6, -0.4, 4.2, 2.4, 0.1);
    paint_ball(p, SHELL, -1.4, 2.6, 5.4, 3.8, 0.1);
    paint_ball(p, LIP, -2.6, 3.6, 2.8, 1.3, 0.1);
    paint_done(p, s, x, 0, 2, 0);
}

static void heart(struct sheet *s, int x)
{
    static const double tip[] = { -5.8, -0.6, 0, -3, 5.8, -0.6, 0, 6.4 };
    struct paint *p = paint_new(16, 16);

    paint_poly(p, NACRE, 4, tip, 2);
    paint_ball(p, NACRE, -2.9, -2, 3.4, 3.2, 0);
    paint_ball(p, NACRE, 2.9, -2, 3.4, 3.2, 0);
    paint_ball(p, LIP, -3.4, -3, 1.2, 1, 0);
    paint_done(p, s, x, 0, 2, 0);
}

static void foam(struct sheet *s, int x)
{
    struct paint *p = paint_new(8, 8);

    paint_ball(p, NACRE, 0, 0, 2.6, 2.6, 0);
    paint_done(p, s, x, 0, 3, 0);
}

/* A lamp's ray, across: a dark rim, its colour, and a white core. */
static void ray(struct sheet *s, int x)
{
    static const int shades[16] = { 1, 3, 6, 8, 9, 11, 13, 15, 15, 13, 11, 9, 8, 6, 3, 1 };

    for (int y = 0; y < 16; y++)
        sheet_set(s, x, y, shades[y]);
}

struct sheet art_finds(void)
{
    struct sheet s = sheet_new(64, 16, 0);

    pearl(&s, 0);
    conch(&s, 16);
    heart(&s, 32);
    foam(&s, 48);
    ray(&s, 60);
    return s;
}
