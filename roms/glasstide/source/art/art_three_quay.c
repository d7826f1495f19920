/*
 * art_three_quay.c - the quay of a harbour that sank into the abyss, seen from above: its stones, its boats, the edge
 * where it broke off. Bank 13. The lamps that stand on it are creatures, out and lit: bank 10.
 */
#include "art.h"

enum { WIDE = 256, TALL = 320, LAMP_W = 32, LAMP_H = 40 };

static const struct mat PLANK = { MATTE, 2, 9, 0 }, RAIL = { MATTE, 4, 11, 0.06 }, DARK = { FLAT, 1, 1, 0 },
                        ROPE = { FLAT, 7, 7, 0 }, STONE = { MATTE, 2, 9, 0.02 };

/* 0 to 1, the same for the same place; repeats every TALL lines. */
static double grain(int x, int y)
{
    uint32_t seed = (uint32_t)x * 374761393u + (uint32_t)y * 668265263u + 43u;
    seed = (seed ^ seed >> 13) * 1274126177u;
    seed ^= seed >> 16;
    return art_pick(&seed, 0, 1);
}

/* How far inside the edge of the quay a place is, px. */
static double inside(int x, int y)
{
    double turn = (double)y / TALL, off = x < WIDE / 2 ? WIDE / 2 - x : x - WIDE / 2,
           bite = 5 * art_sin(3 * turn + (x < WIDE / 2 ? 0 : 0.4)) + 4 * art_sin(7 * turn + (x < WIDE / 2 ? 0.2 : 0));
    return 86 + bite + 3 * (grain(x < WIDE / 2, y / 10) - 0.5) - off;
}

/* Cobbles in rows; each stone is rounded: light at its top left, dark in its joints. Some are missing. */
static int cobble(int x, int y)
{
    int row = y / 10, shift = row % 2 ? 7 : 0, col = (x + shift) / 14, px = (x + shift) % 14, py = y % 10;
    double tone = 3.3 + 1.8 * (grain(col, row) - 0.5);

    if (px == 13 || py == 9 || grain(col + 31, row) < 0.05)
        return 1;
    tone += py == 0 || px == 0 ? 1.8 : py == 8 || px == 12 ? -1.6 : 0;
    if ((px == 0 || px == 12) && (py == 0 || py == 8))
        return 2;
    return (int)art_clamp(tone + art_dither(x, y), 1, 9);
}

static void stones(struct sheet *s)
{
    for (int y = 0; y < TALL; y++)
        for (int x = 0; x < WIDE; x++) {
            double in = inside(x, y);
            if (in > 9)
                sheet_set(s, x, y, cobble(x, y));
            else if (in > 0) /* the kerb: long stones */
                sheet_set(s, x, y, y % 40 == 39 ? 1 : in < 1.5 ? 2 : in > 7.5 ? 8 : y % 40 == 0 ? 7 : 5);
            else if (in > -16) /* the wall below the edge */
                sheet_set(s, x, y, (int)art_clamp(3.4 + in / 6 + art_dither(x, y) - (y % 12 == 11), 1, 4));
        }
}

/* A boat from above, its bow upwards; some of its planks are gone. */
static void boat(struct paint *p, double x, double y, double half, double lean)
{
    double l = half * 2.4;

    for (int i = 0; i < 3; i++) { /* shadow, hull, hold */
        struct mat m = i == 0 ? DARK : i == 1 ? RAIL : (struct mat){ FLAT, 2, 2, 0 };
        double w = half - (i == 2 ? 3 : 0), h = l - (i == 2 ? 5 : 0), dx = i == 0 ? 5 : 0, dy = i == 0 ? 6 : 0;
        double hull[] = { x + dx + lean,     y + dy - h,       x + dx + w * 0.8,  y + dy - h * 0.45, x + dx + w, y + dy,
                          x + dx + w * 0.75, y + dy + h * 0.8, x + dx - w * 0.75, y + dy + h * 0.8,  x + dx - w, y + dy,
                          x + dx - w * 0.8,  y + dy - h * 0.45 };
        paint_poly(p, m, 7, hull, i == 1 ? 3 : 0);
    }
    for (int i = 0; i < 4; i++)
        if (i != 2)
            paint_limb(p, PLANK, x - half * 0.7, y - l * 0.4 + i * l * 0.3, 2, x + half * 0.7,
                       y - l * 0.4 + i * l * 0.3, 2);
    paint_limb(p, PLANK, x + lean * 0.4, y - l * 0.8, 1.4, x, y + l * 0.7, 1.4);
}

static void bollard(struct paint *p, double x, double y, double side)
{
    paint_bow(p, ROPE, x, y, x + side * 12, y + 14, x + side * 26, y + 4, 0.7, 0.7);
    paint_ball(p, DARK, x + 3, y + 4, 6, 6, 0);
    paint_ball(p, STONE, x, y, 6, 6, 0);
    paint_ball(p, RAIL, x, y - 1, 3.4, 3.4, 0);
}

static void anchor(struct paint *p, double x, double y)
{
    paint_limb(p, RAIL, x, y - 12, 1.8, x, y + 12, 1.8);
    paint_limb(p, RAIL, x - 7, y - 7, 1.4, x + 7, y - 7, 1.4);
    paint_bow(p, RAIL, x - 11, y + 4, x - 8, y + 16, x, y + 13, 1, 2.2);
    paint_bow(p, RAIL, x + 11, y + 4, x + 8, y + 16, x, y + 13, 1, 2.2);
    paint_ball(p, RAIL, x, y - 15, 3.6, 3.6, 0);
    paint_ball(p, DARK, x, y - 15, 1.8, 1.8, 0);
}

struct sheet art_quay(void)
{
    struct sheet s = sheet_new(WIDE, TALL, 13);
    struct paint *p = paint_new(WIDE, TALL);

    stones(&s);
    for (int copy = -1; copy <= 1; copy++) {
        double y = copy * (double)TALL;
        boat(p, -108, y - 70, 14, 3);
        boat(p, 110, y + 40, 15, -2);
        boat(p, 106, y - 126, 11, 4);
        boat(p, -112, y + 96, 11, -3);
        bollard(p, -76, y - 40, -1);
        bollard(p, -78, y + 120, -1);
        bollard(p, 77, y + 60, 1);
        bollard(p, 75, y - 104, 1);
        anchor(p, 30, y - 60);
        anchor(p, -44, y + 66);
    }
    paint_done(p, &s, 0, 0, 1, 0);
    return s;
}

/* -- lamps: out, and four frames of a flame -- */

static void lamp(struct sheet *s, int x, int frame)
{
    static const struct mat iron = { MATTE, 2, 9, 0.1 }, pane = { GLASS, 1, 6, -0.06 };
    struct paint *p = paint_new(LAMP_W, LAMP_H);
    double sway = frame < 0 ? 0 : art_sway(frame, 0);
    double hood[] = { -10, -7, -5, -15, 5, -15, 10, -7 }, foot[] = { -7, 11, 7, 11, 5, 16, -5, 16 };

    paint_ball(p, (struct mat){ FLAT, 1, 1, 0 }, 2, 15, 9, 3, 0);
    if (frame < 0)
        paint_ball(p, pane, 0, 2, 8.6, 10, 0);
    else {
        paint_ball(p, (struct mat){ GLASS, 11, 15, 0.1 }, 0, 2, 9, 10.4, 0);
        paint_ball(p, (struct mat){ GLOW, 12, 15, 0.2 }, sway, 3 - sway, 5 + sway / 2, 7 + sway, 0);
    }
    for (int side = -1; side <= 1; side++)
        paint_bow(p, iron, side * 5, -8, side * 14, 2, side * 5, 12, 0.9, 0.9);
    paint_poly(p, iron, 4, hood, 2.4);
    paint_poly(p, iron, 4, foot, 2);
    paint_ball(p, iron, 0, -16, 2.6, 2.6, 0);
    paint_done(p, s, x, 0, 1, 9);
}

struct sheet art_quay_lamps(void)
{
    struct sheet s = sheet_new(5 * LAMP_W, LAMP_H, 10);

    for (int i = 0; i < 5; i++)
        lamp(&s, i * LAMP_W, i - 1);
    return s;
}
