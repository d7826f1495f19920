/*
 * art_scene.c - what is not alive: the sea floor, the reef at its sides, the title.
 */
#include "art.h"

#include <math.h>

/* -- the sea floor: bank 13; it repeats every 320 lines -- */

static double dunes(double x, double y)
{
    double a = y / 320,
           warp = 20 * art_sin(a + x / 600) + 11 * art_sin(2 * a + 0.3 + x / 330) + 5 * art_sin(3 * a + 0.7 - x / 210);
    double broad = art_sin((x + warp * 1.5) / 118) * 5.2 + art_sin(a * 2 + (x + warp) / 170 + 0.2) * 4.6 +
                   art_sin(a * 3 - x / 125 + 0.6) * 2.6;
    double fine = art_sin(a * 15 + (x + warp * 2.2) / 74 + 0.16 * art_sin(a * 2 + x / 90)) *
                  (0.75 + 0.55 * art_sin(a + x / 160 + 0.1));
    return broad + fine;
}

static void sand(struct sheet *s)
{
    static const int level[] = { 1, 3, 4, 5, 7, 8 };
    for (int y = 0; y < 320; y++) {
        for (int x = 0; x < 240; x++) {
            double slope = dunes(x + 1.2, y + 1.2) - dunes(x - 1.2, y - 1.2), off = (x - 119.5) / 120;
            double v = 1.75 + slope * 0.85 + off * off * 0.8 + dunes(x, y) * 0.05;
            sheet_set(s, x, y, level[(int)art_clamp(v + 0.5, 0, 5)]);
        }
    }
}

/* Pebbles and starfish half sunk in the sand, drawn three times so that they cross the seam. */
static void debris(struct sheet *s)
{
    static const struct mat pebble = { MATTE, 1, 8, -0.05 }, star = { MATTE, 3, 9, 0 };
    struct paint *p = paint_new(240, 320);
    for (int copy = -1; copy <= 1; copy++) {
        uint32_t seed = 19;
        for (int i = 0; i < 26; i++) {
            double x = art_pick(&seed, -118, 118), y = art_pick(&seed, -160, 160), r = art_pick(&seed, 1.6, 4.6),
                   turn = art_pick(&seed, 0, 1);
            x = x < 0 ? x * 0.5 - 60 : x * 0.5 + 60;
            paint_ball(p, pebble, x, y + copy * 320, r * 1.3, r * 0.9, turn);
            paint_ball(p, pebble, x + r * 1.9, y + r * 0.7 + copy * 320, r * 0.55, r * 0.45, 0);
        }
        for (int i = 0; i < 5; i++) {
            double x = art_pick(&seed, -90, 90), y = art_pick(&seed, -160, 160) + copy * 320,
                   turn = art_pick(&seed, 0, 1);
            for (int k = 0; k < 5; k++)
                paint_limb(p, star, x, y, 1.8, x + art_cos(turn + k / 5.0) * 5.4, y + art_sin(turn + k / 5.0) * 5.4,
                           0.5);
        }
    }
    paint_done(p, s, 0, 0, 1, 0);
}

/* Splinters of glass that the tide has left, in heaps; they glimmer, for their shades go round. */
static void splinters_in_sand(struct sheet *s)
{
    struct paint *p = paint_new(240, 320);
    for (int copy = -1; copy <= 1; copy++) {
        uint32_t seed = 51;
        for (int i = 0; i < 11; i++) {
            double x = art_pick(&seed, -104, 104), y = art_pick(&seed, -160, 160) + copy * 320;
            for (int k = 0; k < 5; k++) {
                double turn = art_pick(&seed, 0, 1), far = art_pick(&seed, 2, 13), long_by = art_pick(&seed, 2.4, 6.5);
                double cx = x + art_cos(turn) * far, cy = y + art_sin(turn) * far * 0.7, lean = art_pick(&seed, 0, 1);
                double ux = art_cos(lean) * long_by, uy = art_sin(lean) * long_by;
                double shard[] = { cx - ux, cy - uy, cx + uy * 0.35, cy - ux * 0.35,
                                   cx + ux, cy + uy, cx - uy * 0.25, cy + ux * 0.25 };
                paint_poly(p, (struct mat){ GLASS, 13, 15, k % 2 ? -0.1 : 0.05 }, 4, shard, 1.2);
            }
        }
    }
    paint_done(p, s, 0, 0, 1, 0);
}

/* Moonlight bent by the waves far above: the borders between cells of scattered points, on a bent grid. */
static void caustics(struct sheet *s, int y0)
{
    enum { CELLS = 54 };
    double px[CELLS], py[CELLS];
    uint32_t seed = 2;
    for (int i = 0; i < CELLS; i++) {
        px[i] = (i % 6 + art_pick(&seed, 0.1, 0.9)) * 40;
        py[i] = (i / 6 + art_pick(&seed, 0.1, 0.9)) * (320.0 / 9);
    }
    for (int y = 0; y < 320; y++) {
        for (int x = 0; x < 240; x++) {
            double u = x + 7 * art_sin(y / 64.0 + x / 240.0) + 3 * art_sin(x / 60.0 + y / 32.0);
            double v = y + 7 * art_sin(x / 60.0 + 0.2 - y / 160.0) + 3 * art_sin(y / 40.0 + x / 30.0), d1 = 1e9,
                   d2 = 1e9;
            for (int i = 0; i < CELLS; i++) {
                double dx = u - px[i], dy = v - py[i];
                dx = dx > 120 ? dx - 240 : dx < -120 ? dx + 240 : dx;
                dy = dy > 160 ? dy - 320 : dy < -160 ? dy + 320 : dy;
                double d = sqrt(dx * dx + dy * dy);
                d2 = d < d1 ? d1 : d < d2 ? d : d2;
                d1 = d < d1 ? d : d1;
            }
            double fade = art_sin(x / 120.0 + y / 320.0 + 0.1) + art_sin(x / 240.0 - y / 160.0) + 0.15;
            if (fade > 0 && d2 - d1 < 0.7 + 0.8 * art_clamp(fade, 0, 1))
                sheet_set(s, x, y0 + y, d2 - d1 < 0.5 && fade > 0.7 ? 7 : 6);
        }
    }
}

struct sheet art_floor(void)
{
    struct sheet s = sheet_new(240, 640, 13);
    sand(&s);
    debris(&s);
    splinters_in_sand(&s);
    caustics(&s, 320);
    return s;
}

/* -- the reef: columns for the left edge, nearer and so brighter and faster; flipped they are the right edge -- */

static const struct mat STONE = { MATTE, 2, 9, 0.02 }, CORAL = { MATTE, 4, 11, 0.08 }, TUBE = { MATTE, 4, 12, 0.04 },
                        HOLE = { FLAT, 1, 1, 0 };
static const struct mat BUD = { FLAT, 13, 15, 0.5 };

static void branch(struct paint *p, struct mat m, double x, double y, double turn, double len, double r, int depth,
                   uint32_t *seed)
{
    double nx = x + art_cos(turn) * len, ny = y + art_sin(turn) * len;
    paint_limb(p, m, x, y, r, nx, ny, r * 0.74);
    if (depth == 0) {
        paint_ball(p, BUD, nx, ny, 0.9, 0.9, 0);
        return;
    }
    branch(p, m, nx, ny, turn - art_pick(seed, 0.05, 0.12), len * 0.8, r * 0.74, depth - 1, seed);
    branch(p, m, nx, ny, turn + art_pick(seed, 0.05, 0.12), len * 0.8, r * 0.74, depth - 1, seed);
}

static void boulders(struct paint *p, double y, uint32_t seed)
{
    for (int i = 0; i < 5; i++) {
        double r = art_pick(&seed, 6, 13), x = art_pick(&seed, -36, -16), turn = art_pick(&seed, 0, 0.5);
        paint_ball(p, STONE, x - r * 0.4, y + (i - 2) * 9.0, r, r * 0.85, turn);
    }
}

static void tubes(struct paint *p, double y, uint32_t seed)
{
    for (int i = 0; i < 5; i++) {
        double x = -33 + i * 5.5 + art_pick(&seed, -1, 1), top = y - art_pick(&seed, 4, 14), r = 3.4 - i * 0.25;
        paint_limb(p, TUBE, x - 5, y + 16, r * 0.8, x, top, r);
        paint_ball(p, TUBE, x, top - 0.6, r * 1.12, r * 0.75, 0);
        paint_ball(p, HOLE, x + 0.2, top - 0.5, r * 0.7, r * 0.42, 0);
    }
}

static void fan(struct paint *p, double x, double y, double size)
{
    double tips[14];
    for (int i = 0; i < 7; i++) {
        double a = -0.30 + i * 0.062, r = size * (i == 0 || i == 6 ? 0.8 : 1);
        tips[2 * i] = x + art_cos(a) * r;
        tips[2 * i + 1] = y + art_sin(a) * r;
    }
    paint_fin(p, (struct mat){ VEIL, 3, 9, -0.05 }, x, y, 7, tips, 0.08);
}

struct sheet art_reef(void)
{
    struct sheet s = sheet_new(72, 320, 13);
    struct paint *p = paint_new(72, 320);
    for (int copy = -1; copy <= 1; copy++) {
        double y = copy * 320;
        uint32_t seed = 5;
        fan(p, -37, y - 116, 26);
        fan(p, -37, y + 78, 30);
        boulders(p, y - 92, 3);
        boulders(p, y + 112, 12);
        boulders(p, y + 20, 77);
        branch(p, CORAL, -38, y - 128, -0.06, 12, 3.2, 3, &seed);
        branch(p, CORAL, -38, y - 40, -0.03, 14, 3.6, 3, &seed);
        branch(p, CORAL, -38, y + 58, 0.01, 11, 3.0, 3, &seed);
        tubes(p, y - 66, 9);
        tubes(p, y + 136, 31);
    }
    paint_done(p, &s, 0, 0, 1, 2);
    return s;
}

/* -- the border: the sea floor around the game's picture, with the reef along its sides and a frame -- */

/* Returns the shade of the frame `d` px outside the picture; 0: there is none. */
static int frame_shade(int d)
{
    static const int shades[] = { 1, 12, 7, 1 };

    return d <= 4 ? shades[d - 1] : 0;
}

struct sheet art_border(void)
{
    enum { HOLE_W = 240, HOLE_H = 320, SIDE = 240, ABOVE = 40, W = HOLE_W + 2 * SIDE, H = HOLE_H + 2 * ABOVE };
    struct sheet s = sheet_new(W, H, 13), ground = art_floor(), reef = art_reef();

    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            const int right = x - SIDE - HOLE_W + 1, left = SIDE - x, side = right > left ? right : left;
            const int above = y < ABOVE ? ABOVE - y : y - ABOVE - HOLE_H + 1, d = side > above ? side : above;
            const int rock = side > 0 ? sheet_get(&reef, side - 1, (y + (right > 0 ? 170 : 0)) % 320) : 0;
            const int sand = sheet_get(&ground, x / 240 == 1 ? 239 - x % 240 : x % 240, (y + 320 - ABOVE) % 320);
            if (d > 0)
                sheet_set(&s, x, y,
                          frame_shade(d)     ? frame_shade(d)
                          : rock             ? rock
                          : sand * 2 / 3 > 1 ? sand * 2 / 3
                                             : 1);
        }
    sheet_free(&ground);
    sheet_free(&reef);
    return s;
}

/* -- the title: letters cut from glass, bank 15 -- */

struct pen {
    int n;
    double seg[256];
};

static void to(struct pen *k, double ax, double ay, double bx, double by)
{
    double *s = &k->seg[4 * k->n++];
    s[0] = ax;
    s[1] = ay;
    s[2] = bx;
    s[3] = by;
}

static void arc(struct pen *k, double x, double y, double rx, double ry, double from, double sweep)
{
    for (int i = 0; i < 8; i++) {
        double a = from + sweep * i / 8, b = from + sweep * (i + 1) / 8;
        to(k, x + rx * art_cos(a), y + ry * art_sin(a), x + rx * art_cos(b), y + ry * art_sin(b));
    }
}

/* A letter 26 wide and 34 high about (x, y). */
static struct pen letter(char c, double x, double y)
{
    struct pen k = { 0 };
    switch (c) {
    case 'G':
        arc(&k, x, y, 11.5, 15, -0.12, -0.76);
        to(&k, x + 10.4, y + 8, x + 10.4, y + 2);
        to(&k, x + 10.4, y + 2, x + 2.5, y + 2);
        break;
    case 'L':
        to(&k, x - 8, y - 15, x - 8, y + 15);
        to(&k, x - 8, y + 15, x + 9, y + 15);
        break;
    case 'A':
        to(&k, x - 11.5, y + 15, x, y - 15);
        to(&k, x, y - 15, x + 11.5, y + 15);
        to(&k, x - 7, y + 5.5, x + 7, y + 5.5);
        break;
    case 'S':
        arc(&k, x, y - 7.5, 9.5, 7.5, -0.08, -0.67);
        arc(&k, x, y + 7.5, 9.5, 7.5, -0.25, 0.67);
        break;
    case 'T':
        to(&k, x - 11.5, y - 15, x + 11.5, y - 15);
        to(&k, x, y - 15, x, y + 15);
        break;
    case 'I':
        to(&k, x, y - 15, x, y + 15);
        break;
    case 'D':
        to(&k, x - 9, y - 15, x - 9, y + 15);
        arc(&k, x - 4, y, 13.5, 15, -0.25, 0.5);
        to(&k, x - 9, y - 15, x - 4, y - 15);
        to(&k, x - 9, y + 15, x - 4, y + 15);
        break;
    default:
        to(&k, x + 8.5, y - 15, x - 8.5, y - 15);
        to(&k, x - 8.5, y - 15, x - 8.5, y + 15);
        to(&k, x - 8.5, y + 15, x + 8.5, y + 15);
        to(&k, x - 8.5, y, x + 5.5, y);
        break;
    }
    return k;
}

/* The water stands to the middle of each letter: above it the glass is pale and darkens downwards, below it is deep and
 * clears downwards. */
static void word(struct paint *p, const char *text, double x, double y, double step)
{
    enum { BANDS = 14, WATER = 7 };
    for (; *text; text++, x += step) {
        struct pen k = letter(*text, x, y);
        for (int i = 0; i < BANDS; i++) {
            double top = y - 21 + i * 3, level = i < WATER ? 0.56 - i * 0.075 : -0.10 + (i - WATER) * 0.075;
            paint_band(p, top, top + 3);
            paint_stroke(p, (struct mat){ GLASS, 2, 9, level }, k.n, k.seg, 4.8, 2.6);
        }
    }
    paint_band(p, -1e9, 1e9);
}

struct sheet art_logo(void)
{
    static const struct mat gold = { MATTE, 10, 14, 0.12 };
    static const double a[] = { 7, -3.5 }, ac[] = { 22, -9.5 }, b[] = { 38, -3.5 }, bc[] = { 54, 2 },
                        c[] = { 70, -3.5 }, cc[] = { 80, -7 }, d[] = { 88, -4.5 };
    struct sheet s = sheet_new(208, 112, 15);
    struct paint *p = paint_new(208, 112);
    word(p, "GLASS", -72, -31, 36);
    word(p, "TIDE", -51, 24, 34);
    paint_mirror(p, true);
    paint_curve(p, gold, a, ac, b, 1.3, 1.6);
    paint_curve(p, gold, b, bc, c, 1.6, 1.2);
    paint_curve(p, gold, c, cc, d, 1.2, 0.5);
    paint_mirror(p, false);
    paint_ball(p, gold, 0, -3.5, 4.2, 4.2, 0);
    paint_ball(p, (struct mat){ GLASS, 4, 9, 0.15 }, 0, -3.5, 2.9, 2.9, 0);
    paint_done(p, &s, 0, 0, 1, 2);
    return s;
}
