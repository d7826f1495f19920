/*
 * art_whale.c - the bones of a whale on the floor of the shallows, seen from above: its tail is below, for that comes
 * first. Bank 13. Its ribs, and the flowers that grow on it, are creatures: banks 12 and 11.
 */
#include "art.h"

enum { WHALE_W = 224, WHALE_H = 640, RIBS = 6, RIB_FIRST = -120, RIB_STEP = 50 };

static const struct mat BONE = { MATTE, 6, 12, 0.14 }, OLD = { MATTE, 4, 10, 0.04 }, SHADE = { FLAT, 1, 1, 0 },
                        WEED = { MATTE, 13, 15, -0.05 };

/* A bone from a to b, with its shadow on the sand. */
static void bone(struct paint *p, struct mat m, double ax, double ay, double ra, double bx, double by, double rb)
{
    paint_limb(p, m, ax, ay, ra, bx, by, rb);
    paint_ball(p, m, bx, by, rb * 1.5, rb * 1.4, 0);
}

/* The sand is darker under the whale. */
static void shadow(struct sheet *s)
{
    for (int y = 0; y < WHALE_H; y++)
        for (int x = 0; x < WHALE_W; x++) {
            double u = (x - WHALE_W / 2) / 84.0, v = (y - 320) / 310.0, deep = 1 - u * u * (1 + v) - v * v * v * v;
            if (deep > 0 && art_dither(x, y) < deep * 0.7)
                sheet_set(s, x, y, 1);
        }
}

/* The two bows of the lower jaw, the snout between them, and the sockets of the eyes. */
static void skull(struct paint *p)
{
    double snout[] = { -4, -308, 4, -308, 17, -236, 22, -196, -22, -196, -17, -236 };
    double brow[] = { -22, -214, 22, -214, 46, -196, 40, -172, 16, -158, -16, -158, -40, -172, -46, -196 };

    for (int side = -1; side <= 1; side += 2) {
        paint_bow(p, SHADE, side * 44.0 + 5, -176, side * 70.0 + 5, -246, side * 8.0 + 5, -308, 6, 3);
        paint_bow(p, BONE, side * 44.0, -182, side * 70.0, -250, side * 8.0, -314, 6, 3);
    }
    paint_poly(p, BONE, 6, snout, 5);
    paint_poly(p, BONE, 8, brow, 7);
    paint_limb(p, OLD, 0, -300, 1, 0, -204, 2);
    for (int side = -1; side <= 1; side += 2) {
        paint_ball(p, OLD, side * 33.0, -190, 12, 10, 0);
        paint_ball(p, SHADE, side * 33.0, -190, 9, 7.5, 0);
    }
    paint_ball(p, SHADE, 0, -176, 4, 6, 0);
}

/* A shoulder blade, and the hand of a flipper. */
static void flipper(struct paint *p, double side)
{
    double blade[] = { side * 26, -150, side * 54, -158, side * 58, -140, side * 34, -132 };

    if (side < 0) { /* clockwise too */
        double t[] = { blade[6], blade[7], blade[4], blade[5], blade[2], blade[3], blade[0], blade[1] };
        paint_poly(p, BONE, 4, t, 3);
    } else {
        paint_poly(p, BONE, 4, blade, 3);
    }
    bone(p, BONE, side * 56, -150, 4, side * 74, -136, 3.4);
    for (int i = 0; i < 4; i++) {
        double dx = 0.35 + 0.22 * i, dy = 1 - 0.2 * i, x = side * 76, y = -132;
        for (int k = 0; k < 3; k++) {
            double nx = x + side * dx * (11 - 2 * k), ny = y + dy * (11 - 2 * k);
            bone(p, OLD, x + side * dx * 2, y + dy * 2, 2 - 0.3 * k, nx, ny, 1.6 - 0.3 * k);
            x = nx;
            y = ny;
        }
    }
}

static void spine(struct paint *p)
{
    for (int i = 0; i < 21; i++) {
        double y = -144 + 21.5 * i, size = i < 13 ? 1 : 1 - (i - 12) / 11.0, wide = (i < 13 ? 22 : 26) * size;
        for (int side = -1; side <= 1; side += 2) {
            paint_limb(p, SHADE, 4, y + 5, 3.4 * size, side * wide + 4, y + 9, 1.4);
            bone(p, BONE, 0, y, 3.2 * size, side * wide, y + 4, 1.6 * size);
        }
        paint_ball(p, BONE, 0, y, 8.6 * size, 8.2 * size, 0);
        paint_ball(p, OLD, 0, y - 3 * size, 4 * size, 3 * size, 0);
        paint_limb(p, BONE, 0, y + 2, 1.6 * size, 0, y + 11 * size, 1);
    }
}

/* Where the ribs are joined to the spine; they themselves are creatures. */
static void sockets(struct paint *p)
{
    for (int i = 0; i < RIBS; i++)
        for (int side = -1; side <= 1; side += 2)
            bone(p, OLD, side * 12.0, RIB_FIRST + RIB_STEP * i, 4, side * 32.0, RIB_FIRST + RIB_STEP * i - 6, 4);
}

static void tuft(struct paint *p, double x, double y, uint32_t seed)
{
    for (int i = 0; i < 6; i++) {
        double a = art_pick(&seed, 0, 1), far = art_pick(&seed, 5, 13), ex = art_cos(a) * far, ey = art_sin(a) * far;
        paint_bow(p, WEED, x, y, x + ex * 0.6 + 2, y + ey * 0.6 - 2, x + ex, y + ey, 1.5, 0.5);
    }
}

struct sheet art_whale(void)
{
    struct sheet s = sheet_new(WHALE_W, WHALE_H, 13);
    struct paint *p = paint_new(WHALE_W, WHALE_H);
    uint32_t seed = 21;

    shadow(&s);
    flipper(p, -1);
    flipper(p, 1);
    sockets(p);
    spine(p);
    skull(p);
    for (int i = 0; i < 22; i++) {
        double x = art_pick(&seed, 12, 92), y = art_pick(&seed, -280, 300);
        tuft(p, i % 2 ? x : -x, y, (uint32_t)(i * 53 + 5));
    }
    paint_done(p, &s, 0, 0, 1, 0);
    return s;
}

/* -- a rib, right of the spine, and a flower of glass: shut, ajar, open -- */

static void rib(struct sheet *s)
{
    const struct mat bone_of_glass = { MATTE, 2, 8, 0.02 };
    struct paint *p = paint_new(80, 48);

    paint_bow(p, bone_of_glass, -35, -4, 14, -24, 35, 17, 6.5, 3.4);
    paint_ball(p, bone_of_glass, -34, -4, 5.6, 7.4, 0);
    paint_ball(p, bone_of_glass, 35, 17, 4.2, 4.6, 0);
    paint_done(p, s, 0, 0, 1, 0);
}

static void flower(struct sheet *s, int x, double open)
{
    static const struct mat petal = { GLASS, 2, 9, 0.04 }, heart = { GLOW, 10, 13, 0 };
    struct paint *p = paint_new(40, 40);

    for (int i = 0; i < 9; i++) {
        double a = i / 9.0 + 0.03, far = 4 + 13 * open, cx = art_cos(a), cy = art_sin(a), bend = 0.06 + 0.05 * open;
        paint_bow(p, petal, cx * 3, cy * 3, art_cos(a + bend) * far * 0.7, art_sin(a + bend) * far * 0.7, cx * far,
                  cy * far, 4 - open, 1.4);
    }
    paint_ball(p, petal, 0, 0, 8 - 2 * open, 8 - 2 * open, 0);
    paint_ball(p, heart, 0, 0, 2 + 3 * open, 2 + 3 * open, 0);
    paint_done(p, s, x, 48, 1, 0);
}

struct sheet art_bones(void)
{
    struct sheet s = sheet_new(120, 88, 10);

    rib(&s);
    for (int i = 0; i < 3; i++)
        flower(&s, 40 * i, i / 2.0);
    return s;
}
