/*
 * art_night.c - the pictures of the game that `curtain new` writes: a paper kite, lanterns and moths that glow, the
 * keeper of them all, and the river at night. Banks 0 to 7 are those of art_palette.c, so bullets, sparks and the font
 * are the same pictures in all games. Four frames each.
 */
#include "art.h"

#include <math.h>

/* Bank 8, the kite: 2..6 paper, 7..9 red dye, 10..12 wood and gold, 13..15 its lamp. */
static const struct mat SHEET = { MATTE, 2, 6, 0.22 }, DYE = { MATTE, 7, 9, 0.14 }, CANE = { MATTE, 10, 12, 0.1 },
                        LAMP = { GLOW, 12, 15, 0.15 };

/* Banks 10 and 11, lanterns and moths: 2..9 lit paper, 10..12 wood, 13..15 flame. */
static const struct mat GLOWING = { GLOW, 3, 9, 0.02 }, SHADED = { MATTE, 2, 7, 0.1 }, WOOD = { MATTE, 10, 12, 0.12 },
                        FLAME = { GLOW, 13, 15, 0.1 }, RIB = { FLAT, 3, 3, 0 }, DUST = { VEIL, 3, 9, 0.06 };

/* Bank 12, the keeper: 2..8 wings, 9..11 gold, 12..13 ember, 14..15 light. */
static const struct mat WING = { VEIL, 2, 8, 0.0 }, DOWN = { MATTE, 3, 8, 0.16 }, GOLD = { MATTE, 9, 11, 0.14 },
                        EMBER = { GLOW, 12, 15, 0.0 }, DARK = { FLAT, 1, 1, 0 }, SPARK = { FLAT, 15, 15, 0 };

/* ---- the kite ---- */

static void kite(struct sheet *s, int x, int y, int frame, double roll)
{
    static const double wing[] = { 1.5, -5.0, 7.0, -1.6, 13.0, 5.4, 12.2, 7.4, 7.0, 6.0, 1.5, 7.6 };
    static const double band[] = { 7.6, 0.2, 10.0, 3.0, 9.2, 6.0, 6.4, 5.2 };
    static const double body[] = { 0, -15.0, 3.4, -6.0, 2.6, 8.0, 0, 11.6, -2.6, 8.0, -3.4, -6.0 };
    static const double crest[] = { 0, -14.0, 1.7, -8.4, 0, -5.0, -1.7, -8.4 };
    struct paint *p = paint_new(28, 36);
    double k = art_sway(frame, 0), l = art_sway(frame, 0.3);
    double a[2] = { 2.0, 8.0 }, c[2] = { 5.6 + 1.6 * k, 11.0 }, b[2] = { 3.6 + 2.0 * l, 16.4 };

    paint_mirror(p, true);
    paint_curve(p, DYE, a, c, b, 1.1, 0.6);
    paint_poly(p, SHEET, 6, wing, 1.8);
    paint_poly(p, DYE, 4, band, 0.8);
    paint_limb(p, CANE, 1.0, -5.0, 0.7, 12.6, 5.6, 0.6);
    paint_mirror(p, false);
    paint_poly(p, SHEET, 6, body, 2.4);
    paint_poly(p, DYE, 4, crest, 0.8);
    paint_limb(p, CANE, 0, -3.6, 0.6, 0, 9.6, 0.6);
    paint_ball(p, LAMP, 0, 1.4, 2.6 + 0.3 * k, 3.2 + 0.3 * k, 0);
    paint_roll(p, roll);
    paint_done(p, s, x, y, 1, 1);
}

struct sheet art_kite(void)
{
    struct sheet s = sheet_new(112, 108, 8);

    for (int i = 0; i < 12; i++) /* level, banking to the left, to the right */
        kite(&s, 28 * (i % 4), i / 4 * 36, i % 4, (const double[]){ 0, -1, 1 }[i / 4]);
    return s;
}

/* ---- lanterns and moths ---- */

/* Hoops that hold the paper: short dark arcs across, lower in the middle. */
static void hoops(struct paint *p, double x, double y, double rx, double ry, int n)
{
    for (int i = 0; i < n; i++) {
        double u = (i + 0.5) / n * 1.7 - 0.85, half = rx * sqrt(1 - u * u) - 0.4;
        double a[2] = { x - half, y + u * ry }, c[2] = { x, y + u * ry + 2.0 }, b[2] = { x + half, y + u * ry };
        paint_curve(p, RIB, a, c, b, 0.34, 0.34);
    }
}

static void tassel(struct paint *p, double x, double y, double sway, double length)
{
    double a[2] = { x, y }, c[2] = { x + sway, y + length * 0.5 }, b[2] = { x - sway, y + length };

    paint_curve(p, WOOD, a, c, b, 0.6, 0.6);
    paint_limb(p, SHADED, x - sway, y + length, 0.8, x - 1.6 * sway, y + length + 3.4, 1.5);
}

/* A round lantern of the river feast. */
static void lantern(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(24, 34);
    double k = art_sway(frame, 0), sway = 0.9 * art_sway(frame, 0.2);

    tassel(p, sway * 0.4, 8.5, sway, 3.4);
    paint_ball(p, GLOWING, 0, -1.5, 10.2, 9.8, 0);
    hoops(p, 0, -1.5, 10.2, 9.8, 4);
    paint_ball(p, FLAME, 0, 0.4, 2.5 + 0.4 * k, 3.6 + 0.6 * k, 0);
    paint_limb(p, WOOD, -3.6, -11.4, 1.3, 3.6, -11.4, 1.3);
    paint_limb(p, WOOD, -3.0, 8.0, 1.1, 3.0, 8.0, 1.1);
    paint_limb(p, WOOD, 0, -12.0, 0.6, 0, -15.4, 0.6);
    paint_done(p, s, x, y, 1, 2);
}

/* Wings up, level, down, level. */
static void moth(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(40, 32);
    double k = art_sway(frame, 0.25), tip = 17.4 - 3.6 * (k < 0 ? -k : 0), lift = 3.4 * k;
    double upper[] = { 6, -10.4 - lift * 0.4, 14, -10.6 - lift, tip, -6.4 - lift, 15.0, 0.5, 6, 2 };
    double lower[] = { 8, 1.5, 13.4, 4.0 - lift * 0.3, 12.4, 9.8 - lift * 0.5, 7.0, 11.6, 3, 8 };
    double a[2] = { 0.8, -8 }, c[2] = { 2.4, -12 }, b[2] = { 5.2, -13.6 };

    paint_mirror(p, true);
    paint_fin(p, DUST, 0, 0, 5, lower, 0.10);
    paint_fin(p, DUST, 0, -3, 5, upper, 0.08);
    paint_ball(p, WOOD, 11.0, -5.4 - lift * 0.6, 2.3, 2.3, 0);
    paint_ball(p, FLAME, 11.0, -5.4 - lift * 0.6, 1.3, 1.3, 0);
    paint_curve(p, SHADED, a, c, b, 0.6, 0.4);
    paint_mirror(p, false);
    paint_limb(p, SHADED, 0, 0, 2.6, 0, 10.0, 1.2);
    paint_ball(p, (struct mat){ MATTE, 4, 9, 0.2 }, 0, -3.4, 3.8, 4.2, 0);
    paint_ball(p, SHADED, 0, -8.0, 2.5, 2.2, 0);
    paint_done(p, s, x, y, 1, 2);
}

/* A tall lantern of a temple: folds, caps, a sign in ink. */
static void drum(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(40, 56);
    double k = art_sway(frame, 0), sway = 1.1 * art_sway(frame, 0.2);

    tassel(p, -5, 17.5, sway, 3.6);
    tassel(p, 5, 17.5, sway, 3.6);
    tassel(p, 0, 18.0, sway * 1.2, 4.6);
    paint_limb(p, GLOWING, 0, -8.5, 14.6, 0, 7.0, 14.6);
    hoops(p, 0, -1.0, 15.0, 21.0, 7);
    paint_ball(p, FLAME, 0, 1.0, 4.0 + 0.5 * k, 6.6 + 0.9 * k, 0);
    paint_limb(p, WOOD, -8.4, -22.4, 2.0, 8.4, -22.4, 2.0);
    paint_limb(p, WOOD, -7.4, 17.4, 1.8, 7.4, 17.4, 1.8);
    paint_limb(p, WOOD, 0, -23, 0.9, 0, -26.6, 0.9);
    paint_done(p, s, x, y, 1, 2);
}

struct sheet art_lanterns(void)
{
    struct sheet s = sheet_new(160, 122, 10);

    for (int i = 0; i < 4; i++) {
        lantern(&s, 24 * i, 0, i);
        moth(&s, 40 * i, 34, i);
        drum(&s, 40 * i, 66, i);
    }
    return s;
}

/* ---- the keeper ---- */

/* An eye on a wing: gold, ember, and light that looks at whoever comes. */
static void wing_eye(struct paint *p, double x, double y, double r)
{
    paint_ball(p, GOLD, x, y, r, r * 0.92, 0);
    paint_ball(p, DARK, x, y, r * 0.74, r * 0.68, 0);
    paint_ball(p, EMBER, x, y, r * 0.56, r * 0.52, 0);
}

static void keeper_wings(struct paint *p, int frame)
{
    double k = art_sway(frame, 0.25), lift = 5.0 * k, in = k < 0 ? -2.4 * k : 0;
    double upper[] = { 10,      -34 - lift * 0.3, 28, -43 - lift, 45 - in, -42 - lift, 54 - in, -31 - lift,
                       52 - in, -16 - lift * 0.6, 42, -4,         24,      4,          8,       2 };
    double lower[] = {
        16, 2,  34, 4, 43 - in, 14 - lift * 0.3, 40 - in, 27 - lift * 0.5, 31, 36 - lift * 0.4, 24, 44, 20,
        34, 12, 27, 5, 18
    };

    paint_mirror(p, true);
    paint_fin(p, WING, 2, 2, 9, lower, 0.10);
    paint_fin(p, WING, 2, -8, 8, upper, 0.07);
    for (int i = 1; i < 6; i++)
        paint_ball(p, GOLD, upper[2 * i], upper[2 * i + 1], 1.5, 1.5, 0);
    wing_eye(p, 34, -24 - lift * 0.6, 8.2);
    wing_eye(p, 27, 17 - lift * 0.2, 5.4);
    paint_mirror(p, false);
}

/* Feelers like ferns, a ruff of down, a face with two lights, the lamp that all moths come to. */
static void keeper(struct sheet *s, int x, int frame)
{
    struct paint *p = paint_new(112, 96);
    double k = art_sway(frame, 0), l = art_sway(frame, 0.3);
    double a[2] = { 2.0, -26 }, c[2] = { 7.0, -37 }, b[2] = { 17.0 + l, -43 };

    keeper_wings(p, frame);
    paint_mirror(p, true);
    paint_curve(p, GOLD, a, c, b, 1.3, 0.6);
    for (int i = 0; i < 4; i++) {
        double t = 0.35 + 0.2 * i, px = 2 + t * t * 15 + t * 1.5, py = -26 - 17.5 * t + 1.5 * t * t;
        paint_limb(p, GOLD, px, py, 0.6, px + 3.6, py + 4.2 - i * 0.5, 0.4);
    }
    paint_mirror(p, false);
    for (int i = 0; i < 5; i++)
        paint_ball(p, i % 2 ? GOLD : DOWN, 0, 33.0 - 5.0 * i, 4.0 + 1.2 * i, 4.6, 0);
    paint_ball(p, DOWN, 0, -6, 13.0, 14.0, 0);
    for (int i = 0; i < 7; i++) {
        double u = (i - 3) / 3.0;
        paint_ball(p, DOWN, u * 12.5, -14.5 + 3.2 * u * u, 4.2, 4.6, 0);
    }
    paint_ball(p, DOWN, 0, -22.6, 7.6, 7.0, 0);
    paint_mirror(p, true);
    paint_ball(p, DARK, 3.9, -22.0, 2.7, 3.1, 0.06);
    paint_ball(p, EMBER, 3.9, -21.8, 1.9, 2.3, 0.06);
    paint_mirror(p, false);
    paint_ball(p, GOLD, 0, -0.5, 8.2, 8.8, 0);
    paint_ball(p, DARK, 0, -0.5, 6.8, 7.4, 0);
    paint_ball(p, EMBER, 0, -0.3, 5.6 + 0.5 * k, 6.2 + 0.5 * k, 0);
    paint_ball(p, SPARK, 0, 0.6, 1.6, 2.2 + 0.4 * k, 0);
    paint_done(p, s, x, 0, 1, 2);
}

struct sheet art_keeper(void)
{
    struct sheet s = sheet_new(448, 96, 12);

    for (int i = 0; i < 4; i++)
        keeper(&s, 112 * i, i);
    return s;
}

/* ---- the night ---- */

enum { SIDE = 16, SKY_W = 256, SKY_H = 96, RIVER = 64 };

/* The same bits for the same two numbers. */
static uint32_t noise(int x, int y)
{
    uint32_t h = (uint32_t)x * 0x9e3779b1u + (uint32_t)y * 0x85ebca77u;

    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return h ^ h >> 15;
}

/* A shade between two, by the 4 x 4 matrix. */
static int dither(double v, int x, int y)
{
    return (int)(v + art_dither(x, y));
}

/* The hills' height at x, which repeats after SKY_W. */
static double hills(int x, double height, double phase)
{
    double t = (double)x / SKY_W;

    return height *
           (0.55 + 0.25 * art_sin(2 * t + phase) + 0.14 * art_sin(5 * t + 2 * phase) + 0.06 * art_sin(11 * t + phase));
}

static void sky(struct sheet *s)
{
    for (int y = 0; y < SKY_H; y++)
        for (int x = 0; x < SKY_W; x++) {
            int up = SKY_H - y, shade = dither(1.2 + 4.6 * y * y / ((double)SKY_H * SKY_H), x, y);
            if (noise(x, y) % 389 == 0 && up > 34)
                shade = noise(y, x) % 4 == 0 ? 15 : 14;
            if (up < hills(x, 34, 0.1))
                shade = 8;
            if (up < hills(x, 24, 0.42))
                shade = 7;
            if (up < 4 + hills(x, 14, 0.7) && noise(x, y) % 61 == 0)
                shade = 13; /* a window in the valley */
            sheet_set(s, x, y, shade);
        }
}

/* Waves that repeat after RIVER px each way, and what glints on them. */
static void river(struct sheet *s, int x0, int y0)
{
    for (int y = 0; y < RIVER; y++)
        for (int x = 0; x < RIVER; x++) {
            double u = (double)x / RIVER, v = (double)y / RIVER;
            double h = art_sin(3 * v + 0.5 * art_sin(u)) + 0.7 * art_sin(5 * v - 2 * u) + 0.5 * art_sin(2 * u + v);
            int shade = dither(art_clamp(2.6 + 1.0 * h, 1, 5), x, y);
            sheet_set(s, x0 + x, y0 + y, h > 1.72 ? 14 : h > 1.5 ? 6 : shade);
        }
}

/* A field, with a lamp or without. */
static void land(struct sheet *s, int x0, int y0, bool lit)
{
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            sheet_set(s, x0 + x, y0 + y,
                      7 + (int)(noise(x + x0, y + y0) % 7 == 0) + (int)(noise(x / 2, y / 2 + x0) % 5 == 0));
    for (int i = 0; lit && i < 9; i++)
        sheet_set(s, x0 + 6 + i % 3, y0 + 7 + i / 3, i == 4 ? 15 : i % 2 ? 13 : 9);
}

/* The river's edge: land, and water from `from` on, to the right or to the left. */
static void shore(struct sheet *s, int x0, int y0, const struct sheet *from, bool left)
{
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            double edge = 8 + 2.5 * art_sin(y / 16.0) + 1.5 * art_sin(2 * y / 16.0 + 0.3), off = left ? x : 15 - x;
            if (off > edge)
                sheet_set(s, x0 + x, y0 + y, sheet_get(from, x, SKY_H + y));
            else if (off > edge - 1.5)
                sheet_set(s, x0 + x, y0 + y, 10);
        }
}

/* Tiles of 16 px, sixteen a row: 1 to 96 the sky; 97 to 100 and the rows below them the river, 4 x 4; 101 and 102 land,
 * without a lamp and with one, 103 and 104 the same at the left shore, 105 and 106 at the right one. */
struct sheet art_night(void)
{
    struct sheet s = sheet_new(SKY_W, SKY_H + RIVER, 13);

    sky(&s);
    river(&s, 0, SKY_H);
    for (int i = 0; i < 6; i++) {
        land(&s, RIVER + i * SIDE, SKY_H, i % 2);
        if (i > 1)
            shore(&s, RIVER + i * SIDE, SKY_H, &s, i < 4);
    }
    return s;
}

/* The moon, 56 x 56, in the colours of bank 15. */
struct sheet art_moon(void)
{
    static const double pits[][3] = { { -8, -6, 5 }, { 6, 4, 6.4 }, { 10, -10, 3.4 }, { -4, 11, 4 }, { -14, 5, 3 } };
    struct sheet s = sheet_new(56, 56, 15);
    struct paint *p = paint_new(56, 56);

    paint_ball(p, (struct mat){ MATTE, 6, 14, 0.34 }, 0, 0, 24, 24, 0);
    for (int i = 0; i < 5; i++)
        paint_ball(p, (struct mat){ MATTE, 6, 12, 0.16 }, pits[i][0], pits[i][1], pits[i][2], pits[i][2] * 0.85, 0);
    paint_done(p, &s, 0, 0, 0, 0);
    for (int y = 0; y < 56; y++) /* a halo of every other pixel, thinner outwards */
        for (int x = 0; x < 56; x++) {
            double dx = x - 27.5, dy = y - 27.5, r = sqrt(dx * dx + dy * dy);
            if (!sheet_get(&s, x, y) && r < 28 && dither((28 - r) / 5.0, x, y) > 0)
                sheet_set(&s, x, y, 2);
        }
    return s;
}
