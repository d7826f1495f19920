/*
 * art_two_scene.c - the drowned glassworks themselves: a wall of arches, pipes before it, stacks at the sides; the
 * street of the works, which is seen at an angle, with the chimneys at its end; and the bullets that are made there.
 */
#include "art.h"

#include <math.h>

enum { WIDE = 240, TALL = 320, STREET = 128, BAY = 160 };

/* 0 to 1, the same for the same place. */
static double grain(int x, int y)
{
    uint32_t seed = (uint32_t)x * 374761393u + (uint32_t)y * 668265263u + 17u;
    seed = (seed ^ seed >> 13) * 1274126177u;
    seed ^= seed >> 16;
    return art_pick(&seed, 0, 1);
}

static int dithered(double v, int x, int y)
{
    static const double order[2][2] = { { 0.125, 0.625 }, { 0.875, 0.375 } };
    return (int)art_clamp(v + order[y & 1][x & 1], 1, 12);
}

/* -- the wall: two rows of arches, which repeat every 160 lines -- */

static int brick(int x, int y, double tone)
{
    int row = y / 8, col = (x + (row % 2 ? 8 : 0)) / 16;
    if (y % 8 == 7 || (x + (row % 2 ? 8 : 0)) % 16 == 15)
        return dithered(tone - 2, x, y);
    bool edge = y % 8 == 0;
    return dithered(tone + 1.1 * (grain(col, row % (TALL / 8)) - 0.5) + (edge ? 0.6 : 0), x, y);
}

/* What is seen through an arch: the dark, and far below in it a fire. */
static int niche(double dx, double v, int x, int y)
{
    double glow = (v - 96) / 52 - dx * dx / 900;
    if (glow > 0.25 && grain(x / 2, y) < (glow - 0.25) * 0.8)
        return glow > 0.86 && grain(x, y / 2) < 0.3 ? 14 : 13;
    return dithered(1.2 + (glow > 0 ? glow * 1.4 : 0), x, y);
}

static int wall_at(int x, int y)
{
    int v = (y + (x < WIDE / 2 ? 0 : BAY / 2)) % BAY;
    double cx = x < WIDE / 2 ? 64 : 176, dx = x + 0.5 - cx, dy = v - 78.0, d = sqrt(dx * dx + dy * dy);
    double side = dx < 0 ? -dx : dx, out = v < 78 ? d : side;
    if (v < 12 && x > 14 && x < 226)
        return dithered(v < 2 ? 8 : v < 9 ? 6 : 1.6, x, y);
    if (v > 38 && v < 150 && out < 36)
        return niche(dx, v, x, y);
    if (v > 32 && v < 152 && out < 45) {
        double lean = v < 78 ? (dx / (side + 78.0 - v) + 1) * 7 : v / 9.0;
        bool joint = lean - (int)lean < 0.14;
        return dithered((joint ? 2.6 : 6) + (out > 43 ? 1.2 : 0) - (out < 38 ? 1.4 : 0), x, y);
    }
    if (x < 12 || x >= 228 || (x > 110 && x < 130)) {
        int in = x < 12 ? x : x >= 228 ? 239 - x : x - 110;
        return dithered((y % 32 == 31 || in == 0 ? 2 : 6 - 0.08 * in) + (y % 32 == 0 ? 1.6 : 0), x, y);
    }
    return brick(x, y, 4.4);
}

/* -- pipes -- */

static const struct mat PIPE = { MATTE, 2, 9, 0.06 }, PIPE_FAR = { MATTE, 2, 7, 0 }, JOINT = { MATTE, 4, 11, 0.08 },
                        HOT = { FLAT, 13, 15, 0.4 }, SOOT = { FLAT, 1, 1, 0 };

static void upright(struct paint *p, struct mat m, double x, double r, double y, double off)
{
    paint_limb(p, m, x, y - 170, r, x, y + 170, r);
    for (int i = 0; i < 4; i++) {
        double at = y - 160 + off + 80 * i;
        paint_limb(p, JOINT, x - r - 1, at, 2, x + r + 1, at, 2);
        paint_limb(p, JOINT, x - r - 1, at + 5, 1.6, x + r + 1, at + 5, 1.6);
    }
}

static void valve(struct paint *p, double x, double y, double r)
{
    for (int i = 0; i < 8; i++) {
        double a = i / 8.0, b = (i + 1) / 8.0;
        paint_limb(p, JOINT, x + r * art_cos(a), y + r * art_sin(a), 1.3, x + r * art_cos(b), y + r * art_sin(b), 1.3);
        if (i % 2)
            paint_limb(p, PIPE, x, y, 0.9, x + r * art_cos(a), y + r * art_sin(a), 0.9);
    }
    paint_ball(p, JOINT, x, y, 2.4, 2.4, 0);
}

/* From the wall at one side to a place, and down from there. */
static void elbow(struct paint *p, double from, double x, double y, double r, double down)
{
    paint_limb(p, PIPE, from, y, r, x, y, r);
    paint_limb(p, PIPE, x, y, r, x, y + down, r);
    paint_ball(p, JOINT, x, y, r + 1.6, r + 1.6, 0);
    paint_limb(p, JOINT, x - r - 1, y + down, 2, x + r + 1, y + down, 2);
    paint_ball(p, SOOT, x, y + down + 2, r - 1, 1.6, 0);
    paint_ball(p, HOT, x, y + down + 2.4, r - 2, 0.9, 0);
}

static void pipes(struct sheet *s, int y0)
{
    struct paint *p = paint_new(WIDE, TALL);
    for (int copy = -1; copy <= 1; copy++) {
        double y = copy * TALL;
        upright(p, PIPE_FAR, -84, 4, y, 30);
        upright(p, PIPE_FAR, 98, 4, y, 8);
        upright(p, PIPE, -104, 8, y, 0);
        upright(p, PIPE, 110, 6, y, 44);
        elbow(p, -130, -62, y - 96, 5.4, 34);
        elbow(p, 130, 70, y + 30, 5, 46);
        elbow(p, 130, 46, y - 130, 4, 26);
        elbow(p, -130, -40, y + 96, 4.4, 22);
        valve(p, -104, y - 22, 9);
        valve(p, 110, y + 108, 8);
        valve(p, 84, y - 56, 6);
    }
    paint_done(p, s, 0, y0, 1, 0);
}

struct sheet art_two_works(void)
{
    struct sheet s = sheet_new(WIDE, 2 * TALL, 13);

    for (int y = 0; y < TALL; y++)
        for (int x = 0; x < WIDE; x++)
            sheet_set(&s, x, y, wall_at(x, y));
    pipes(&s, TALL);
    return s;
}

/* -- the stacks: columns for the left edge; flipped they are the right one -- */

/* A chimney of bricks that stands in the picture's lower part. */
static void chimney(struct paint *p, double x, double top, double foot, double r)
{
    double trunk[] = { x - r, foot, x - r * 0.72, top, x + r * 0.72, top, x + r, foot };
    static const struct mat clay = { MATTE, 3, 9, 0.02 };
    paint_poly(p, clay, 4, trunk, r * 0.7);
    for (double y = top + 9; y < foot; y += 9)
        paint_limb(p, PIPE_FAR, x - r * 0.8, y, 0.7, x + r * 0.8, y, 0.7);
    paint_limb(p, JOINT, x - r * 0.8, top, 3, x + r * 0.8, top, 3);
    paint_ball(p, SOOT, x, top - 0.8, r * 0.56, 1.7, 0);
    paint_ball(p, HOT, x, top - 0.4, r * 0.4, 0.9, 0);
}

static void boiler(struct paint *p, double y)
{
    static const struct mat drum = { MATTE, 2, 10, 0.02 };
    paint_limb(p, drum, -44, y, 19, -24, y, 19);
    for (int i = 0; i < 9; i++) {
        double a = i / 8.0 * 0.5 - 0.25;
        paint_ball(p, JOINT, -24 + 15.6 * art_cos(a), y + 15.6 * art_sin(a), 1.2, 1.2, 0);
    }
    paint_ball(p, JOINT, -22, y, 8, 8, 0);
    paint_ball(p, SOOT, -22, y, 6, 6, 0);
    for (int i = -2; i <= 2; i++)
        paint_limb(p, HOT, -22 + 2.4 * i, y - 4.6 + (i * i) * 0.5, 0.6, -22 + 2.4 * i, y + 4.6 - (i * i) * 0.5, 0.6);
}

struct sheet art_two_stacks(void)
{
    struct sheet s = sheet_new(72, TALL, 13);
    struct paint *p = paint_new(72, TALL);
    for (int copy = -1; copy <= 1; copy++) {
        double y = copy * TALL;
        chimney(p, -14, y - 122, y - 20, 9);
        chimney(p, -30, y - 150, y - 20, 12);
        boiler(p, y - 12);
        paint_limb(p, PIPE, -22, y + 8, 4, -22, y + 70, 4);
        paint_limb(p, JOINT, -28, y + 34, 2, -16, y + 34, 2);
        paint_limb(p, PIPE, -40, y + 70, 4.6, -22, y + 70, 4.6);
        valve(p, -22, y + 52, 8);
        chimney(p, -22, y + 92, y + 168, 11);
        chimney(p, -33, y + 76, y + 168, 9);
    }
    paint_done(p, &s, 0, 0, 1, 2);
    return s;
}

/* -- the street: stones, two rails, and a gutter in which the glass runs -- */

static int street_at(int x, int y)
{
    double turn = (double)y / STREET, mid = 14 + 2.2 * art_sin(turn) + 1.2 * art_sin(3 * turn + 0.3), off = x - mid;
    off = off < 0 ? -off : off;
    if (off < 7)
        return off > 5.4 ? 13 : grain(x / 2, y / 6) < 0.26 ? 15 : grain(x / 3, y / 9) < 0.6 ? 14 : 13;
    if (off < 11)
        return dithered(off < 8.4 ? 1.2 : 7 - (off - 8) * 0.6, x, y);
    if (x == 62 || x == 63 || x == 92 || x == 93)
        return x % 2 ? 5 : 10;
    if (y % 16 < 4 && x > 55 && x < 101)
        return dithered(y % 16 == 0 ? 4.4 : 2.4, x, y);
    int row = y / 8, shift = row % 2 ? 6 : 0, col = (x + shift) / 12;
    if (y % 8 == 7 || (x + shift) % 12 == 11)
        return 1;
    return dithered(3.6 + 2.2 * (grain(col % 11, row) - 0.5) + (y % 8 == 0 ? 1 : 0), x, y);
}

struct sheet art_two_street(void)
{
    struct sheet s = sheet_new(STREET, STREET, 13);

    for (int y = 0; y < STREET; y++)
        for (int x = 0; x < STREET; x++)
            sheet_set(&s, x, y, street_at(x, y));
    return s;
}

enum { SKY = 80 };

/* Sheds and chimneys where the street ends; the windows are lit. */
struct sheet art_two_skyline(void)
{
    static const struct mat shed = { MATTE, 2, 6, 0 }, smoke = { MATTE, 1, 4, -0.05 };
    struct sheet s = sheet_new(WIDE, SKY, 13);
    struct paint *p = paint_new(WIDE, SKY);
    uint32_t seed = 41;
    for (int i = 0; i < 9; i++) {
        double x = -108 + 27 * i + art_pick(&seed, -4, 4), top = art_pick(&seed, -22, 4), r = art_pick(&seed, 4, 6.5);
        for (int k = 0; k < 4; k++)
            paint_ball(p, smoke, x + 3 * k + k * k, top - 5 - 4.6 * k, 3.4 + 1.5 * k, 2.6 + k, 0);
        chimney(p, x, top, 44, r);
    }
    for (int i = 0; i < 10; i++) {
        double x = -112 + 25 * i, top = 14 + art_pick(&seed, -4, 6);
        double roof[] = { x - 13, 44, x - 13, top + 6, x - 4, top - 3, x - 4, top + 6, x + 13, top - 1, x + 13, 44 };
        paint_poly(p, shed, 6, roof, 2);
        for (int k = 0; k < 3; k++)
            paint_limb(p, HOT, x - 8 + 7 * k, top + 14, 1.2, x - 8 + 7 * k, top + 18, 1.2);
    }
    paint_done(p, &s, 0, 0, 1, 0);
    return s;
}

/* -- bullets, on bank 0: a dark rim, the colour, a bright core -- */

static int ring_of(double d, double r)
{
    static const struct {
        double from;
        int shade;
    } bands[] = { { 0, 2 }, { 1, 6 }, { 1.9, 8 }, { 3, 10 }, { 4.2, 12 }, { 5.2, 13 }, { 6.2, 15 } };
    int shade = 0;
    double scale = r < 8 ? r / 8 : 1;
    for (unsigned i = 0; i < sizeof bands / sizeof *bands; i++) {
        if (d >= bands[i].from * scale)
            shade = bands[i].shade;
    }
    return shade;
}

/* A toothed wheel with a bright hub; frame turns it by a quarter of a tooth. */
static void wheel(struct sheet *s, int x0, int frame)
{
    enum { TEETH = 8, SIDE = 22 };
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            double dx = x + 0.5 - SIDE / 2.0, dy = y + 0.5 - SIDE / 2.0, q = sqrt(dx * dx + dy * dy), r = 8;
            for (int i = 0; i < TEETH; i++) {
                double a = (i + frame / 4.0) / TEETH, u = dx * art_cos(a) + dy * art_sin(a),
                       v = dy * art_cos(a) - dx * art_sin(a);
                if (u > 0 && v < 1.9 && v > -1.9)
                    r = 10.9;
            }
            double d = r - q;
            if (d > 0)
                sheet_set(s, x0 + x, y, q < 2.6 ? 15 : q < 3.6 ? 8 : q < 4.4 ? 2 : d < 1 ? 2 : d < 2.2 ? 8 : 11);
        }
}

/* A bar of glass with a lit and a dark face, pointing right. */
static void ingot(struct sheet *s, int x0, int y0)
{
    for (int y = 0; y < 20; y++)
        for (int x = 0; x < 20; x++) {
            double u = x + 0.5 - 10, v = y + 0.5 - 10, side = v < 0 ? -v : v, along = u < 0 ? -u : u;
            double dx = 9.6 - along, dy = 4.8 - side - (along > 6 ? (along - 6) * 0.5 : 0), d = dx < dy ? dx : dy;
            if (d > 0)
                sheet_set(s, x0 + x, y0 + y,
                          d < 0.9   ? 2
                          : d < 1.9 ? 8
                          : d < 2.8 ? (v < 0 ? 11 : 9)
                          : d < 3.6 ? 13
                                    : 15);
        }
}

/* A pane lies across; where it is thinnest it lets the light through. */
static void pane(struct sheet *s, int x0, int y0)
{
    for (int y = 0; y < 12; y++)
        for (int x = 0; x < 34; x++) {
            int in = x < 33 - x ? x : 33 - x, up = y < 11 - y ? y : 11 - y, d = in < up ? in : up;
            bool streak = (x + y) % 14 == 4 || (x + y) % 14 == 5;
            if (d > 0 || (in > 0 && up > 0) || in + up > 1)
                sheet_set(s, x0 + x, y0 + y, d == 0 ? 3 : d == 1 ? 15 : d == 2 ? 11 : streak ? 14 : 8);
        }
}

/* A gob of molten glass that wobbles: its middle is clear, its light at the upper left. */
static void gob(struct sheet *s, int x0, int y0, int frame)
{
    double k = art_sin(frame / 4.0) * 0.9, rx = 14 + k, ry = 14 - k;
    for (int y = 0; y < 30; y++)
        for (int x = 0; x < 30; x++) {
            double u = (x + 0.5 - 15) / rx, v = (y + 0.5 - 15) / ry, q = sqrt(u * u + v * v), d = (1 - q) * 14;
            double hx = u + 0.36, hy = v + 0.38;
            if (d <= 0)
                continue;
            int c = d < 1      ? 2
                    : d < 2.2  ? 11
                    : d < 3.4  ? 9
                    : d < 5    ? 8
                    : q > 0.4  ? (u + v > 0.3 ? 8 : 7)
                    : q > 0.26 ? 11
                               : 15;
            sheet_set(s, x0 + x, y0 + y, hx * hx + hy * hy < 0.022 ? 15 : c);
        }
}

/* Steam: three puffs that turn about a core. */
static void steam(struct sheet *s, int x0, int y0, int frame)
{
    enum { SIDE = 22 };
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            double dx = x + 0.5 - SIDE / 2.0, dy = y + 0.5 - SIDE / 2.0, best = 8 - sqrt(dx * dx + dy * dy);
            double core = best;
            for (int i = 0; i < 5; i++) {
                double a = (i + frame / 4.0) / 5, u = dx - 5 * art_cos(a), v = dy - 5 * art_sin(a);
                double d = 5.4 - sqrt(u * u + v * v);
                best = d > best ? d : best;
            }
            if (best > 0)
                sheet_set(s, x0 + x, y0 + y, core > 3 ? ring_of(core - 1, 8) : best < 1 ? 2 : best < 2 ? 7 : 6);
        }
}

/* An ember, on its way out: 5 px. It is drawn in the ramp of what glimmers, 13 to 15. */
static void ember(struct sheet *s, int x0, int y0, int frame)
{
    double r = frame == 0 ? 1.6 : frame == 1 ? 1.9 : frame == 2 ? 1.3 : 0.8;
    for (int y = 0; y < 5; y++)
        for (int x = 0; x < 5; x++) {
            double dx = x - 2.0, dy = y - 2.0, q = sqrt(dx * dx + dy * dy);
            if (q < r)
                sheet_set(s, x0 + x, y0 + y, q < 0.6 && frame < 2 ? 15 : frame == 3 ? 13 : 14);
        }
}

struct sheet art_two_bullets(void)
{
    struct sheet s = sheet_new(124, 80, 0);

    for (int i = 0; i < 4; i++) {
        wheel(&s, 22 * i, i);
        gob(&s, 30 * i, 24, i);
        steam(&s, 22 * i, 56, i);
        ember(&s, 92 + 6 * i, 0, i);
    }
    ingot(&s, 90, 56);
    pane(&s, 90, 8);
    return s;
}
