/*
 * art_ships.c - the three craft, level and banking, and their options. Four frames: the flame breathes.
 */
#include "art.h"

static const struct mat HULL = { MATTE, 2, 6, 0.18 }, DARK = { MATTE, 2, 5, 0.06 }, CANOPY = { MATTE, 7, 9, 0.12 };
static const struct mat TRIM = { MATTE, 10, 12, 0.10 }, FLAME = { GLOW, 12, 15, 0.1 }, GLASSY = { GLASS, 7, 9, 0.1 };

static const double FLICKER[4] = { 0, 1.6, 0.6, 2.4 };

static void heron(struct sheet *s, int x, int y, int frame, double roll)
{
    static const double wing[] = { 2.5, -1, 6, 2.0, 11.6, 8.0, 11.6, 11.0, 9.0, 10.4, 4.5, 8.2, 2.5, 8 };
    static const double stripe[] = { 7.8, 4.3, 9.8, 6.2, 8.4, 9.6, 6.6, 8.8 };
    static const double canard[] = { 1.8, -8.4, 5.8, -4.6, 6.0, -3.0, 2, -4.2 };
    struct paint *p = paint_new(28, 36);
    double f = FLICKER[frame];
    paint_mirror(p, true);
    paint_limb(p, FLAME, 5.2, 11, 1.7, 5.2, 13.4 + f * 0.8, 0.6);
    paint_mirror(p, false);
    paint_limb(p, FLAME, 0, 11, 2.4, 0, 14.4 + f, 0.8);
    paint_mirror(p, true);
    paint_poly(p, HULL, 7, wing, 2.2);
    paint_poly(p, TRIM, 4, stripe, 1.0);
    paint_poly(p, TRIM, 4, canard, 1.2);
    paint_limb(p, DARK, 5.2, 4.0, 1.4, 5.2, 10.6, 2.0);
    paint_limb(p, HULL, 11.6, 4.0, 0.6, 11.6, 11.0, 1.0);
    paint_mirror(p, false);
    paint_limb(p, HULL, 0, -15.2, 0.7, 0, -4, 3.7);
    paint_limb(p, HULL, 0, -4, 3.7, 0, 10.5, 2.6);
    paint_ball(p, CANOPY, 0, -4.6, 2.2, 4.6, 0);
    paint_limb(p, TRIM, 0, 3.6, 0.9, 0, 8.6, 0.7);
    paint_roll(p, roll);
    paint_done(p, s, x, y, 1, 1);
}

static void petrel(struct sheet *s, int x, int y, int frame, double roll)
{
    static const double wing[] = { 1.5,  -3,   6.0, -2.6, 10.0, -5.4, 12.4, -11.0, 13.6,
                                   -5.0, 13.0, 1.6, 10.4, 6.8,  6.0,  9.6,  1.5,   10 };
    static const double edge[] = { 11.6, -6.4, 12.5, -8.2, 13.0, -4.2, 12.4, 1.0, 9.8, 5.8, 8.6, 4.4, 11.0, 0.0 };
    static const double tail[] = { -2.6, 8, 2.6, 8, 1.6, 13.0, 0, 11.4, -1.6, 13.0 };
    struct paint *p = paint_new(30, 34);
    double f = FLICKER[frame];
    paint_mirror(p, true);
    paint_limb(p, FLAME, 5.6, 9.4, 2.2, 5.6, 12.4 + f, 0.7);
    paint_poly(p, HULL, 9, wing, 2.6);
    paint_poly(p, TRIM, 7, edge, 0.8);
    paint_limb(p, DARK, 5.6, 3.4, 1.7, 5.6, 9.2, 2.2);
    paint_mirror(p, false);
    paint_poly(p, HULL, 5, tail, 1.0);
    paint_limb(p, HULL, 0, -12.6, 0.9, 0, -3, 3.9);
    paint_limb(p, HULL, 0, -3, 3.9, 0, 8.4, 2.4);
    paint_ball(p, CANOPY, 0, -3.4, 2.3, 4.6, 0);
    paint_limb(p, TRIM, 0, 4.2, 0.9, 0, 8.0, 0.7);
    paint_roll(p, roll);
    paint_done(p, s, x, y, 1, 1);
}

/* Long swept wings, a forked tail, and a lamp in the bow. */
static void tern(struct sheet *s, int x, int y, int frame, double roll)
{
    static const double wing[] = { 2, -6.5, 6.5, -4.6, 11.0, -0.6, 15.0, 6.8, 15.4, 10.4, 11.4, 6.4, 6.8, 3.6, 2, 3.4 };
    static const double edge[] = { 6.6, -3.4, 10.6, 0.4, 14.4, 7.4, 14.6, 9.0, 10.4, 3.4, 6.4, -0.6 };
    static const double tail[] = { 0.6, 5.4, 3.2, 6.2, 6.6, 14.6, 5.8, 15.4, 2.0, 10.6, 0.6, 9.4 };
    static const struct mat slate = { MATTE, 2, 5, 0.06 }, brass = { MATTE, 13, 15, 0.02 };
    struct paint *p = paint_new(32, 36);
    double f = FLICKER[frame];
    paint_limb(p, FLAME, 0, 9.4, 1.8, 0, 12.4 + f, 0.6);
    paint_mirror(p, true);
    paint_poly(p, slate, 6, tail, 1.0);
    paint_poly(p, slate, 8, wing, 2.2);
    paint_poly(p, brass, 6, edge, 0.8);
    paint_limb(p, TRIM, 3.4, -1.6, 0.8, 5.6, 3.0, 1.0);
    paint_mirror(p, false);
    paint_limb(p, HULL, 0, -13.2, 1.8, 0, -3, 3.6);
    paint_limb(p, HULL, 0, -3, 3.6, 0, 8.8, 1.8);
    paint_ball(p, CANOPY, 0, -3.0, 2.1, 4.2, 0);
    paint_ball(p, (struct mat){ GLOW, 13, 15, 0.2 }, 0, -12.6, 2.2, 2.6, 0);
    paint_limb(p, TRIM, 0, 3.8, 0.8, 0, 7.4, 0.6);
    paint_roll(p, roll);
    paint_done(p, s, x, y, 1, 1);
}

/* An option is a bead of glass with two fins. */
static void option(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(14, 14);
    double tilt = frame % 2 ? 0.8 : 0;
    double fin[] = { 1.5, -2, 6, -1 + tilt, 6.2, 2.5 + tilt, 2, 2.4 };
    paint_mirror(p, true);
    paint_poly(p, TRIM, 4, fin, 1.2);
    paint_mirror(p, false);
    paint_ball(p, GLASSY, 0, 0, 3.4, 4.6, 0);
    paint_ball(p, FLAME, 0, 1.2, 1.3, 1.6, 0);
    paint_done(p, s, x, y, 1, 1);
}

/* Below the options, the craft as it banks to the left and to the right, first a little, then hard. */
static struct sheet craft(int bank, int wide, void (*draw)(struct sheet *, int, int, int, double))
{
    static const double rolls[] = { -0.6, 0.6, -1, 1 };
    struct sheet s = sheet_new(4 * wide, 198, bank);
    for (int i = 0; i < 4; i++) {
        draw(&s, wide * i, 0, i, 0);
        for (int k = 0; k < 4; k++)
            draw(&s, wide * i, 54 + 36 * k, i, rolls[k]);
        if (i < 2)
            option(&s, 14 * i, 38, i);
    }
    return s;
}

struct sheet art_heron(void)
{
    return craft(8, 28, heron);
}

struct sheet art_petrel(void)
{
    return craft(9, 30, petrel);
}

struct sheet art_tern(void)
{
    return craft(8, 32, tern);
}

void art_level_heron(struct sheet *s)
{
    heron(s, 0, 0, 1, 0);
}

void art_level_petrel(struct sheet *s)
{
    petrel(s, 0, 0, 1, 0);
}
