/*
 * art_three_scene.c - what the abyss looks like, all of it in the ramp of bank 13: the ground with its vents and bones,
 * chains of glass that hang into the picture, walls of rock, and what sinks. Maps repeat without a seam.
 */
#include "art.h"

#include <math.h>

enum { GROUND = 256, PLATES = 128, WIDE = 256, TALL = 320, DEEP = 2 * TALL };

static const struct mat STONE = { MATTE, 1, 7, -0.02 }, BONE = { MATTE, 3, 11, 0.02 }, LINK = { GLASS, 2, 11, -0.02 };
static const struct mat EMBER = { FLAT, 14, 14, 0 }, SPARK = { FLAT, 15, 15, 0 }, FAINT = { FLAT, 13, 13, 0 };

/* -- the ground -- */

/* A vent: a ring of stone about a hole in which something burns. */
static void vent(struct paint *p, double x, double y, double r, uint32_t *seed)
{
    for (int i = 0; i < 9; i++) {
        double a = i / 9.0, size = r * art_pick(seed, 0.34, 0.52);
        paint_ball(p, STONE, x + art_cos(a) * r, y + art_sin(a) * r, size, size, 0);
    }
    paint_ball(p, (struct mat){ FLAT, 1, 1, 0 }, x, y, r * 0.82, r * 0.82, 0);
    paint_ball(p, FAINT, x, y, r * 0.6, r * 0.6, 0);
    paint_ball(p, EMBER, x, y, r * 0.4, r * 0.4, 0);
    paint_ball(p, SPARK, x, y, r * 0.18, r * 0.18, 0);
}

/* Ribs of something that sank here: a spine, and bows to both sides. */
static void ribs(struct paint *p, double x, double y)
{
    for (int i = 0; i < 6; i++) {
        double v = y + i * 11.0, wide = 22.0 - (i - 2) * (i - 2) * 1.6;
        for (int side = -1; side <= 1; side += 2) {
            double a[2] = { x, v }, c[2] = { x + side * wide, v - 6 }, b[2] = { x + side * wide * 0.9, v + 9 };
            paint_curve(p, BONE, a, c, b, 2.0, 0.8);
        }
        paint_ball(p, BONE, x, v, 3.0, 2.6, 0);
    }
    paint_ball(p, BONE, x, y - 14, 8.0, 11.0, 0);
    paint_ball(p, (struct mat){ FLAT, 1, 1, 0 }, x - 3.4, y - 15, 2.0, 2.8, 0);
    paint_ball(p, (struct mat){ FLAT, 1, 1, 0 }, x + 3.4, y - 15, 2.0, 2.8, 0);
}

/* Splinters of glass that fell from above and stuck. */
static void splinters(struct paint *p, double x, double y, uint32_t *seed)
{
    for (int i = 0; i < 5; i++) {
        double dx = art_pick(seed, -9, 9), dy = art_pick(seed, -8, 8), h = art_pick(seed, 7, 14),
               lean = art_pick(seed, -5, 5);
        double shard[] = { x + dx - 2.2, y + dy, x + dx + lean, y + dy - h, x + dx + 2.2, y + dy };
        paint_poly(p, LINK, 3, shard, 1.2);
    }
}

struct sheet art_trench(void)
{
    struct sheet s = sheet_new(GROUND, GROUND, 13), plates = art_seabed();
    struct paint *p = paint_new(GROUND, GROUND);
    uint32_t seed = 11;

    for (int y = 0; y < GROUND; y++)
        for (int x = 0; x < GROUND; x++)
            sheet_set(&s, x, y, sheet_get(&plates, x % PLATES, y % PLATES));
    sheet_free(&plates);
    vent(p, -70, -76, 15, &seed);
    vent(p, -44, -58, 8, &seed);
    vent(p, 84, 64, 13, &seed);
    vent(p, 60, 82, 7, &seed);
    vent(p, -100, 40, 9, &seed);
    ribs(p, 52, -84);
    ribs(p, -34, 40);
    splinters(p, 6, -26, &seed);
    splinters(p, 104, -10, &seed);
    splinters(p, -98, -14, &seed);
    splinters(p, 14, 108, &seed);
    splinters(p, 100, -108, &seed);
    paint_done(p, &s, 0, 0, 1, 0);
    for (int i = 0; i < GROUND * GROUND; i++) /* the fog knows slate alone */
        s.px[i] = s.px[i] > 12 ? 2 * s.px[i] - 18 : s.px[i];
    return s;
}

/* -- chains, walls, snow: three pictures below one another, TALL lines each -- */

/* A chain from the top of the picture to its foot: links and, here and there, a lamp that is out. */
static void chain(struct paint *p, double x, double size, double phase)
{
    for (double y = -TALL / 2.0 - 12; y < TALL / 2.0 + 12; y += 16) {
        double at = y + phase;
        double lean = 2.2 * art_sin(at / TALL);
        paint_ball(p, LINK, x + lean, at, size * 0.62, size, 0);
        paint_ball(p, (struct mat){ FLAT, 1, 1, 0 }, x + lean, at, size * 0.30, size * 0.62, 0);
        paint_limb(p, LINK, x + lean, at + size * 0.7, size * 0.24, x + lean, at + 16 - size * 0.7, size * 0.24);
    }
}

static void lamp(struct paint *p, double x, double y)
{
    double hood[] = { x - 9, y - 4, x - 4, y - 12, x + 4, y - 12, x + 9, y - 4 };
    paint_poly(p, LINK, 4, hood, 2);
    paint_ball(p, (struct mat){ GLASS, 1, 8, 0 }, x, y + 2, 6.6, 8.0, 0);
    paint_ball(p, FAINT, x, y + 3, 2.4, 3.4, 0);
    paint_limb(p, LINK, x, y + 9, 1.6, x, y + 16, 0.6);
}

static void chains(struct sheet *s, int y0)
{
    struct paint *p = paint_new(WIDE, TALL);
    for (int copy = -1; copy <= 1; copy++) {
        double y = copy * (double)TALL;
        lamp(p, -104, y + 60);
        lamp(p, 102, y - 92);
        lamp(p, 88, y + 104);
    }
    chain(p, -112, 6.4, 0);
    chain(p, -92, 4.4, 7);
    chain(p, 112, 6.4, 4);
    chain(p, 84, 4.0, 11);
    paint_done(p, s, 0, y0, 1, 0);
}

/* Columns of basalt to both sides, the near ones in front of the far, and what clings to them. */
static void walls(struct sheet *s, int y0)
{
    struct paint *p = paint_new(WIDE, TALL);
    for (int depth = 0; depth < 3; depth++) {
        struct mat rock = { MATTE, 1, 4 + 2 * depth, -0.06 + 0.03 * depth };
        uint32_t seed = 40 + (uint32_t)depth;
        for (int i = 0; i < 16; i++) {
            double side = i % 2 ? 1 : -1, y = -TALL / 2.0 + i * (TALL / 16.0) + art_pick(&seed, -10, 10);
            double half = art_pick(&seed, 8, 13), tall = art_pick(&seed, 26, 54),
                   x = side * (WIDE / 2.0 - 8 - 11 * (2 - depth));
            x -= side * art_pick(&seed, -5, 5);
            for (int copy = -1; copy <= 1; copy++) {
                double top = y - tall + copy * TALL, foot = y + tall + copy * TALL;
                double column[] = { x - half, top + 6,  x - half * 0.4, top, x + half * 0.5, top + 2,  x + half,
                                    top + 8,  x + half, foot - 5,       x,   foot,           x - half, foot - 8 };
                paint_poly(p, rock, 7, column, 3.4);
                if (depth == 2 && i % 5 == 1) {
                    paint_limb(p, BONE, x - side * half, y + copy * TALL, 1.3, x - side * (half + 9),
                               y - 10 + copy * TALL, 0.6);
                    paint_ball(p, EMBER, x - side * (half + 9), y - 11 + copy * TALL, 1.5, 1.5, 0);
                }
            }
        }
    }
    paint_done(p, s, 0, y0, 1, 0);
}

/* Snow of the sea: what the light waters let fall. */
static void snow(struct sheet *s, int y0)
{
    uint32_t seed = 5;
    for (int i = 0; i < 92; i++) {
        int x = (int)art_pick(&seed, 0, WIDE), y = (int)art_pick(&seed, 0, TALL),
            shade = i % 9 == 0 ? 14
                    : i % 3    ? 9
                               : 12;
        sheet_set(s, x, y0 + y, shade);
        if (i % 4 == 0)
            sheet_set(s, (x + 1) % WIDE, y0 + y, shade - (shade > 12 ? 1 : 2));
    }
}

/* The lighthouse that sank: it leans on its rock, and its lamp still burns. */
enum { LAMP_X = 168, LAMP_Y = 236 };

static void lighthouse(struct paint *p)
{
    static const struct mat wall = { MATTE, 4, 12, 0.04 }, band = { MATTE, 3, 8, 0 }, rock = { MATTE, 2, 8, 0 };
    const double top[2] = { LAMP_X - WIDE / 2.0, LAMP_Y - DEEP / 2.0 }, foot[2] = { top[0] - 26, top[1] + 250 };
    uint32_t seed = 77;

    for (int i = 0; i < 7; i++) { /* seven bands, light and dark in turn, wider towards the bottom */
        double a = (i + 0.55) / 7.6, b = (i + 1.55) / 7.6, wide = 13 + 13 * a, low = 13 + 13 * b;
        double ax = top[0] + (foot[0] - top[0]) * a, ay = top[1] + (foot[1] - top[1]) * a;
        double bx = top[0] + (foot[0] - top[0]) * b, by = top[1] + (foot[1] - top[1]) * b;
        double course[] = { ax - wide, ay, ax + wide, ay + 3, bx + low, by + 3, bx - low, by };
        paint_poly(p, i % 2 ? band : wall, 4, course, 11);
        if (i % 2 == 0)
            paint_ball(p, (struct mat){ FLAT, 1, 1, 0 }, (ax + bx) / 2, (ay + by) / 2, 2.6, 4.6, 0.01);
    }
    double gallery[] = { top[0] - 21, top[1] + 14, top[0] + 21, top[1] + 17,
                         top[0] + 17, top[1] + 23, top[0] - 18, top[1] + 20 };
    paint_poly(p, wall, 4, gallery, 2.4);
    for (int i = -3; i <= 3; i++)
        paint_limb(p, band, top[0] + 6 * i, top[1] + 8 + 0.4 * i, 0.8, top[0] + 6 * i, top[1] + 15 + 0.4 * i, 0.8);
    paint_limb(p, band, top[0] - 20, top[1] + 7, 0.9, top[0] + 20, top[1] + 10, 0.9);
    paint_ball(p, (struct mat){ GLASS, 4, 9, 0 }, top[0], top[1], 11, 13, 0);
    paint_ball(p, FAINT, top[0], top[1] + 1, 7, 8, 0);
    paint_ball(p, EMBER, top[0], top[1] + 1, 4.4, 5.4, 0);
    paint_ball(p, SPARK, top[0], top[1] + 1, 2, 2.8, 0);
    double roof[] = { top[0] - 14, top[1] - 8, top[0] + 1, top[1] - 26, top[0] + 14, top[1] - 6 };
    paint_poly(p, band, 3, roof, 4);
    for (int i = 0; i < 26; i++) {
        double x = foot[0] + art_pick(&seed, -62, 66), size = art_pick(&seed, 9, 24);
        paint_ball(p, rock, x, foot[1] + art_pick(&seed, -6, 34), size, size * 0.7, art_pick(&seed, -0.1, 0.1));
    }
}

/* How much of the lamp's two beams there is at a pixel. */
static double beam(int x, int y)
{
    double dx = x - LAMP_X, dy = y - LAMP_Y - 0.22 * dx, far = fabs(dx);
    double across = fabs(dy) / (5 + 0.2 * far);
    return across < 1 && far > 9 ? (1 - across) * art_clamp(1.3 - far / 150, 0, 1) : 0;
}

/* Far below: folds of dark water, so that nothing is black for want of a picture, and a landmark. */
static void water(struct sheet *s, int y0)
{
    static const double order[2][2] = { { 0.125, 0.625 }, { 0.875, 0.375 } };
    struct paint *p = paint_new(WIDE, DEEP);

    for (int y = 0; y < DEEP; y++) {
        for (int x = 0; x < WIDE; x++) {
            double u = (double)x / WIDE, v = (double)y / TALL,
                   bend = 0.16 * art_sin(2 * v + u) + 0.1 * art_sin(u * 3 - v);
            double fold = art_sin(3 * v + bend * 2 + u) + 0.8 * art_sin(2 * u + 2 * v + bend * 3) +
                          0.5 * art_sin(5 * v - u + bend);
            double shade = 3.2 + fold * 1.15 + 4.2 * beam(x, y);
            sheet_set(s, x, y0 + y, (int)art_clamp(shade + order[y & 1][x & 1], 1, 8));
        }
    }
    lighthouse(p);
    paint_done(p, s, 0, y0, 1, 1);
}

struct sheet art_abyss_tiles(void)
{
    struct sheet s = sheet_new(WIDE, 3 * TALL + DEEP, 13);
    chains(&s, 0);
    walls(&s, TALL);
    snow(&s, 2 * TALL);
    water(&s, 3 * TALL);
    return s;
}
