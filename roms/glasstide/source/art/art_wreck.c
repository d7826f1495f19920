/*
 * art_wreck.c - what lies and grows in the shallows: the wreck of a lamp ship, seen from above, kelp that is so near
 * that it is nearly black, and shafts of light. Bank 13.
 */
#include "art.h"

#include <math.h>

enum { WRECK_W = 160, WRECK_H = 640, TALL = 320, WIDE = 240 };

/* -- the wreck: its bow is below, for that comes first -- */

/* How wide half of the hull is at line y of the picture. */
static double half_width(double y)
{
    double from_bow = (WRECK_H - 8 - y) / 190, from_stern = (y - 8) / 70;
    double bow = art_clamp(from_bow, 0, 1), stern = art_clamp(from_stern, 0, 1);
    return 66 * sqrt(bow * (2 - bow)) * (0.72 + 0.28 * sqrt(stern * (2 - stern))) * (stern > 0 ? 1 : 0);
}

struct hole {
    double x, y, rx, ry;
};

/* Where the deck has fallen in. */
static const struct hole HOLES[] = {
    { 34, 70, 26, 20 }, { -40, 190, 24, 40 }, { 30, 322, 30, 34 }, { -34, 444, 22, 26 }, { 22, 556, 16, 22 },
};

/* 0 outside of all holes, up to 1 deep inside; their edges are torn. */
static double hole_at(double x, double y)
{
    double deepest = 0;
    for (unsigned i = 0; i < sizeof HOLES / sizeof *HOLES; i++) {
        double u = (x - HOLES[i].x) / HOLES[i].rx, v = (y - HOLES[i].y) / HOLES[i].ry;
        double tear = 0.14 * art_sin(x / 9 + y / 23) + 0.1 * art_sin(y / 7 - x / 17);
        double d = 1 - sqrt(u * u + v * v) + tear;
        deepest = d > deepest ? d : deepest;
    }
    return deepest;
}

/* Planks run along the ship, each a little lighter or darker, with joints. */
static int plank(int x, int y, double edge)
{
    int board = (x + 400) / 9;
    uint32_t seed = (uint32_t)(board * 977 + ((y + board * 37) / 74) * 131);
    double v = 6.6 + art_pick(&seed, -0.9, 0.9) + 0.35 * art_sin(y / 41.0 + board * 0.3) - x * 0.012;
    bool seam = (x + 400) % 9 == 0, joint = (y + board * 37) % 74 == 0;
    if (edge < 9)
        v -= 1.4;
    if (seam)
        v -= 2.2;
    if (joint)
        v -= 1.6;
    return (int)(art_clamp(v, 2, 9) + art_dither(x + 400, y) * 0.9);
}

/* The dark below the deck, with the ribs and the keel of the ship. */
static int below(int x, int y, double deep)
{
    bool rib = y % 22 < 5, keel = x > -4 && x < 4;
    if (deep < 0.12)
        return 9;
    return rib || keel ? (y % 22 == 0 ? 5 : 3) : 1 + (deep < 0.4 && art_dither(x + 400, y) > 0.6);
}

static void hull(struct sheet *s)
{
    for (int y = 0; y < WRECK_H; y++) {
        double half = half_width(y);
        for (int i = 0; i < WRECK_W; i++) {
            int x = i - WRECK_W / 2;
            double edge = half - (x < 0 ? -x : x), shadow = half_width(y - 10) - (x - 9 < 0 ? 9 - x : x - 9);
            if (half < 2 || edge < 0) {
                if (shadow > 0 && (shadow > 5 || art_dither(i, y) < shadow / 5))
                    sheet_set(s, i, y, 1);
                continue;
            }
            double deep = hole_at(x, y);
            int post = y % 24 < 2 ? 3 : 0, rail = edge < 1.2 ? 2 : (x < 0 ? 11 : 8) - post;
            sheet_set(s, i, y, edge < 5 ? rail : deep > 0 ? below(x, y, deep) : plank(x, y, edge));
        }
    }
}

static const struct mat WOOD = { MATTE, 3, 10, 0.02 }, IRON = { MATTE, 2, 11, 0.05 }, ROPE = { FLAT, 4, 4, 0 },
                        WEED = { MATTE, 13, 15, -0.05 }, DARK = { FLAT, 1, 1, 0 };

/* A lamp on its mast, which has fallen across the deck. */
static void mast(struct paint *p, double ax, double ay, double bx, double by)
{
    paint_limb(p, (struct mat){ FLAT, 1, 1, 0 }, ax + 4, ay + 6, 3.4, bx + 4, by + 6, 2.6);
    paint_limb(p, WOOD, ax, ay, 4.2, bx, by, 3);
    for (int i = 1; i < 4; i++) {
        double t = i / 4.0, x = ax + (bx - ax) * t, y = ay + (by - ay) * t;
        paint_ball(p, IRON, x, y, 4.4 - t, 4.4 - t, 0);
    }
    paint_ball(p, IRON, bx, by, 9.5, 9.5, 0);
    paint_ball(p, DARK, bx, by, 7, 7, 0);
    paint_ball(p, (struct mat){ GLASS, 13, 15, -0.1 }, bx, by, 6, 6, 0);
}

static void cabin(struct paint *p, double x, double y)
{
    double wall[] = { x - 30, y - 34, x + 30, y - 34, x + 34, y + 30, x - 34, y + 30 };
    double roof[] = { x - 24, y - 29, x + 24, y - 29, x + 26, y + 20, x - 26, y + 20 };
    double shade[] = { x - 24, y - 26, x + 42, y - 26, x + 44, y + 38, x - 26, y + 38 };

    paint_poly(p, DARK, 4, shade, 0);
    paint_poly(p, WOOD, 4, wall, 4);
    paint_poly(p, (struct mat){ MATTE, 4, 11, 0.04 }, 4, roof, 5);
    for (int i = -1; i <= 1; i++) {
        paint_ball(p, DARK, x + i * 17, y + 25, 4.6, 3.2, 0);
        paint_limb(p, (struct mat){ FLAT, 4, 4, 0 }, x + i * 13, y - 26, 0.5, x + i * 13, y + 17, 0.5);
    }
    paint_ball(p, IRON, x, y - 6, 12, 12, 0);
    paint_ball(p, DARK, x, y - 6, 9, 9, 0);
    paint_ball(p, (struct mat){ GLASS, 13, 15, -0.05 }, x, y - 6, 8, 8, 0);
}

static void tuft(struct paint *p, double x, double y, uint32_t seed)
{
    for (int i = 0; i < 6; i++) {
        double a = art_pick(&seed, 0, 1), far = art_pick(&seed, 5, 12);
        double from[2] = { x, y }, c[2] = { x + art_cos(a) * far * 0.6 + 2, y + art_sin(a) * far * 0.6 - 2 },
               to[2] = { x + art_cos(a) * far, y + art_sin(a) * far };
        paint_curve(p, WEED, from, c, to, 1.5, 0.5);
    }
}

struct sheet art_wreck(void)
{
    struct sheet s = sheet_new(WRECK_W, WRECK_H, 13);
    struct paint *p = paint_new(WRECK_W, WRECK_H);
    uint32_t seed = 8;

    hull(&s);
    cabin(p, 0, -176);
    mast(p, 20, -100, -46, -60);
    mast(p, -20, 60, 42, 108);
    paint_limb(p, IRON, 0, 236, 6, 0, 236, 6);
    paint_ball(p, DARK, 0, 236, 3.4, 3.4, 0);
    for (int side = -1; side <= 1; side += 2) {
        double a[2] = { side * 8.0, 236 }, c[2] = { side * 20.0, 200 }, b[2] = { side * 58.0, 180 };
        paint_curve(p, ROPE, a, c, b, 0.7, 0.7);
    }
    for (int i = 0; i < 18; i++) {
        double y = art_pick(&seed, -290, 290), half = half_width(y + WRECK_H / 2.0);
        tuft(p, (i % 2 ? 1 : -1) * art_pick(&seed, half * 0.6, half), y, (uint32_t)(i * 71 + 3));
    }
    paint_done(p, &s, 0, 0, 1, 0);
    return s;
}

/* -- kelp, at both edges of the picture, over the seam too -- */

static void frond(struct paint *p, double side, double y, double reach, uint32_t seed)
{
    const struct mat leaf = { MATTE, 1, 3, 0.1 }, stem = { FLAT, 2, 2, 0 };
    double x0 = side * 126, x1 = side * (126 - reach), px = x0, py = y + 60;

    for (int i = 1; i <= 8; i++) {
        double t = i / 8.0, x = x0 + (x1 - x0) * t + side * 5 * art_sin(t * 1.2), ny = y + 60 - 130 * t;
        double far = art_pick(&seed, 9, 17) * (1.15 - 0.5 * t), up = art_pick(&seed, -9, -3);
        double a[2] = { x, ny }, c[2] = { x - side * far * 0.6, ny + up * 0.2 - 4 }, b[2] = { x - side * far, ny + up };
        double c2[2] = { x + side * far * 0.6, ny - 5 }, b2[2] = { x + side * far, ny + up };
        paint_limb(p, stem, px, py, 1.4, x, ny, 1.2);
        paint_curve(p, leaf, a, c, b, 3.2, 0.6);
        paint_curve(p, leaf, a, c2, b2, 3.0, 0.6);
        px = x;
        py = ny;
    }
}

struct sheet art_kelp(void)
{
    struct sheet s = sheet_new(WIDE, TALL, 13);
    struct paint *p = paint_new(WIDE, TALL);

    for (int copy = -1; copy <= 1; copy++) {
        double y = copy * TALL;
        frond(p, -1, y - 110, 20, 4);
        frond(p, -1, y - 60, 8, 15);
        frond(p, -1, y + 96, 14, 26);
        frond(p, 1, y - 20, 22, 37);
        frond(p, 1, y + 20, 9, 48);
        frond(p, 1, y + 140, 12, 59);
    }
    paint_done(p, &s, 0, 0, 0, 1);
    return s;
}

/* -- light that falls in from above, slanting: two shafts beside each other, each 112 px wide with its slant -- */

static void shaft(struct sheet *s, int x0, double wide, double slant, double strength)
{
    for (int y = 0; y < TALL; y++) {
        double middle = x0 + 96 - slant * y, fade = strength * (1 - (double)y / TALL);
        for (int x = x0; x < x0 + 112; x++) {
            double off = (x - middle) / (wide * (0.7 + 0.5 * y / TALL)), soft = 1 - off * off;
            if (soft > 0 && art_dither(x, y) < soft * fade)
                sheet_set(s, x, y, 12);
        }
    }
}

struct sheet art_shafts(void)
{
    struct sheet s = sheet_new(224, TALL, 13);

    shaft(&s, 0, 15, 0.22, 0.62);
    shaft(&s, 112, 9, 0.26, 0.5);
    return s;
}
