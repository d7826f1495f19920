/*
 * art_two_train.c - the yard of the glassworks, seen from above: two tracks over slag in which glass still glows. Bank
 * 13. Its trains are creatures: an engine and its trucks, banks 10 and 11, which run downwards.
 */
#include "art.h"

enum { WIDE = 240, TALL = 320, LEFT = 64, RIGHT = 176, GAUGE = 13 };

/* -- the yard -- */

static double grain(int x, int y)
{
    uint32_t seed = (uint32_t)x * 374761393u + (uint32_t)(y % TALL) * 668265263u + 29u;
    seed = (seed ^ seed >> 13) * 1274126177u;
    seed ^= seed >> 16;
    return art_pick(&seed, 0, 1);
}

/* A gutter of glass that winds between the tracks, repeating every TALL lines. */
static double gutter(int x, int y)
{
    double turn = (double)y / TALL, off = x - 120 - 9 * art_sin(turn) - 4 * art_sin(3 * turn + 0.2);
    return off < 0 ? -off : off;
}

/* Plates, slag between them, and here and there embers in the slag. */
static int ground(int x, int y)
{
    int row = y / 32, col = (x + (row % 2 ? 20 : 0)) / 40, px = (x + (row % 2 ? 20 : 0)) % 40, py = y % 32;
    double tone = 3.1 + 1.4 * (grain(col, row + 7) - 0.5) + 0.7 * (grain(x / 2, y / 2) - 0.5);
    double off = gutter(x, y);

    if (off < 7)
        return off > 5.2 ? 13 : grain(x / 2, y / 7) < 0.3 ? 15 : grain(x / 3, y / 9) < 0.6 ? 14 : 13;
    if (off < 12)
        return off < 8.4 ? 1 : (int)(7.4 - (off - 8) * 0.7 + art_dither(x, y));
    if (px < 2 || py < 2)
        return grain(x / 3, y / 3) < 0.06 ? 13 : 1;
    if ((px == 4 || px == 37) && (py == 4 || py == 29))
        return 7;
    tone += px == 2 || py == 2 ? 1.4 : px == 39 || py == 31 ? -1.2 : 0;
    return (int)art_clamp(tone + art_dither(x, y), 1, 7);
}

/* Sleepers, two rails with their shine, bolts. */
static void track(struct sheet *s, int middle)
{
    for (int y = 0; y < TALL; y++)
        for (int x = middle - GAUGE - 9; x <= middle + GAUGE + 9; x++) {
            int off = x < middle ? middle - x : x - middle, sleeper = y % 16;
            int shade = 1 + (grain(x / 2, y / 2) < 0.3);
            if (sleeper < 8)
                shade = sleeper == 0 ? 9 : sleeper == 7 ? 3 : 6 + (grain(x / 5, y / 16) < 0.4);
            if (sleeper < 8 && (off == GAUGE + 5 || off == GAUGE - 4) && (sleeper == 3 || sleeper == 4))
                shade = 9;
            if (off >= GAUGE - 1 && off <= GAUGE + 2)
                shade = off == GAUGE ? 15 : off == GAUGE + 1 ? 12 : off == GAUGE - 1 ? 8 : 1;
            sheet_set(s, x, y, shade);
        }
}

struct sheet art_two_yard(void)
{
    struct sheet s = sheet_new(WIDE, TALL, 13);

    for (int y = 0; y < TALL; y++)
        for (int x = 0; x < WIDE; x++)
            sheet_set(&s, x, y, ground(x, y));
    track(&s, LEFT);
    track(&s, RIGHT);
    return s;
}

/* -- the trains -- */

static const struct mat IRON = { MATTE, 2, 9, 0.04 }, PLATE = { MATTE, 3, 9, 0.1 }, RED = { MATTE, 10, 13, 0 },
                        DARK = { FLAT, 1, 1, 0 };

static void box(struct paint *p, struct mat m, double x0, double y0, double x1, double y1, double bevel)
{
    double xy[] = { x0, y0, x1, y0, x1, y1, x0, y1 };
    paint_poly(p, m, 4, xy, bevel);
}

static void buffers(struct paint *p, double y, double way)
{
    for (int side = -1; side <= 1; side += 2) {
        paint_limb(p, IRON, side * 10.0, y - way * 3, 1.6, side * 10.0, y, 1.6);
        paint_limb(p, PLATE, side * 10.0 - 2.6, y, 1.3, side * 10.0 + 2.6, y, 1.3);
    }
}

static void rivets(struct paint *p, double x, double y0, double y1)
{
    for (double y = y0; y <= y1; y += 5)
        paint_ball(p, PLATE, x, y, 0.9, 0.9, 0);
}

static void chassis(struct paint *p, double half)
{
    for (int side = -1; side <= 1; side += 2)
        for (double y = -half + 7; y <= half - 7; y += half - 7)
            paint_limb(p, DARK, side * 15.0, y - 4, 2.2, side * 15.0, y + 4, 2.2);
    buffers(p, -half + 1, -1);
    buffers(p, half - 1, 1);
}

/* The engine: a boiler, its chimney in front, its cab at the back. It runs down, or up with way -1; frame makes its
 * fire flicker. */
static void engine(struct sheet *s, int x, int y, int frame, double way)
{
    struct paint *p = paint_new(44, 68);
    double glow = art_sway(frame, 0) * 0.8;

    chassis(p, 33);
    paint_limb(p, IRON, 0, -12 * way, 13, 0, 18 * way, 13);
    for (int i = 0; i < 3; i++)
        paint_limb(p, PLATE, -12, (-6.0 + 11 * i) * way, 1.5, 12, (-6.0 + 11 * i) * way, 1.5);
    box(p, RED, -16, -20.5 * way - 8.5, 16, -20.5 * way + 8.5, 4);
    box(p, PLATE, -12, -20.5 * way - 5.5, 12, -20.5 * way + 5.5, 3);
    paint_ball(p, DARK, 0, -20 * way, 6, 4.2, 0);
    paint_ball(p, (struct mat){ GLOW, 11, 15, 0.1 }, 0, -20 * way, 4.2 + glow, 2.8 + glow / 2, 0);
    paint_ball(p, PLATE, 0, 5 * way, 4.6, 4.6, 0);
    paint_ball(p, IRON, 0, 19 * way, 8, 8, 0);
    paint_ball(p, DARK, 0, 19 * way, 5.6, 5.6, 0);
    paint_ball(p, (struct mat){ GLOW, 11, 15, 0.2 }, 0, 19 * way, 3 + glow, 3 + glow, 0);
    paint_ball(p, (struct mat){ GLASS, 12, 15, 0.3 }, -11, 28 * way, 2.8, 2.8, 0);
    paint_ball(p, (struct mat){ GLASS, 12, 15, 0.3 }, 11, 28 * way, 2.8, 2.8, 0);
    paint_done(p, s, x, y, 1, 9);
}

/* A truck with a gun on a turntable. */
static void gun(struct sheet *s, int x, int frame)
{
    struct paint *p = paint_new(44, 56);

    chassis(p, 27);
    box(p, IRON, -16, -23, 16, 23, 4);
    rivets(p, -13, -18, 18);
    rivets(p, 13, -18, 18);
    paint_ball(p, DARK, 0, 0, 13, 13, 0);
    paint_ball(p, PLATE, 0, 0, 11, 11, 0);
    paint_limb(p, IRON, -4, 3, 3.2, -4, 16, 2.6);
    paint_limb(p, IRON, 4, 3, 3.2, 4, 16, 2.6);
    paint_ball(p, DARK, -4, 17, 1.8, 1.6, 0);
    paint_ball(p, DARK, 4, 17, 1.8, 1.6, 0);
    paint_ball(p, RED, 0, -2, 5.4, 5.4, 0);
    paint_ball(p, (struct mat){ GLOW, 11, 15, 0 }, 0, -2, 2 + art_sway(frame, 0), 2 + art_sway(frame, 0), 0);
    paint_done(p, s, x, 68, 1, 9);
}

/* A truck with a ladle of molten glass. */
static void ladle(struct sheet *s, int x, int frame)
{
    struct paint *p = paint_new(44, 56);
    double sway = art_sway(frame, 0);

    chassis(p, 27);
    box(p, IRON, -16, -23, 16, 23, 4);
    paint_limb(p, PLATE, -18, 0, 3, 18, 0, 3);
    paint_ball(p, PLATE, 0, 0, 16, 17, 0);
    paint_ball(p, DARK, 0, 0, 13, 14, 0);
    paint_ball(p, (struct mat){ GLOW, 11, 15, 0.05 }, 0, 0, 12, 13, 0);
    paint_ball(p, (struct mat){ FLAT, 15, 15, 0 }, 4 * sway, -3, 3, 2, 0);
    paint_ball(p, (struct mat){ FLAT, 14, 14, 0 }, -4, 4 - 2 * sway, 2.4, 1.6, 0);
    paint_done(p, s, x, 124, 1, 9);
}

struct sheet art_two_train(void)
{
    struct sheet s = sheet_new(4 * 44, 248, 10);

    for (int frame = 0; frame < 4; frame++) {
        engine(&s, 44 * frame, 0, frame, 1);
        engine(&s, 44 * frame, 180, frame, -1);
        gun(&s, 44 * frame, frame);
        ladle(&s, 44 * frame, frame);
    }
    return s;
}
