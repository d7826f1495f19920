/*
 * art_three_deep.c - the two great ones of the abyss: the Anglerlamp with its lamp and stalk, and the Queen in all her
 * size. Bank 12: 2..8 glass, 9..11 silver, 12..13 heart, 14 and 15 light.
 */
#include "art.h"

#include <math.h>

enum { LIGHT = 168 }; /* px that the lamp's light measures */

static const struct mat PANE = { GLASS, 2, 8, 0 }, DEEP = { GLASS, 2, 5, -0.05 }, FILM = { VEIL, 2, 8, 0.02 },
                        SILVER = { MATTE, 9, 11, 0.12 }, SOUL = { GLOW, 12, 15, 0.0 };
static const struct mat FLESH = { MATTE, 12, 13, 0.1 }, NIGHT = { FLAT, 1, 1, 0 }, LAMP = { FLAT, 15, 15, 0 },
                        TOOTH = { FLAT, 11, 11, 0 };

/* -- the Anglerlamp, from the front: a mouth with a fish behind it -- */

static void angler_fins(struct paint *p, double frame)
{
    double k = art_sway(frame, 0) * 3.0, l = art_sway(frame, 0.25) * 2.0;
    double side[] = { 44, -14, 56, -16 + k, 59, -4 + k * 1.3, 57, 9 + k, 48, 16 + k * 0.5, 38, 14 };
    double back[] = { 8, -42, 15, -47 + l, 22, -44 + l, 29, -41 + l, 37, -32 };
    double low[] = { 26, 30, 35, 40 + l, 27, 44 + l, 18, 40 };
    paint_fin(p, FILM, 32, 0, 6, side, 0.16);
    paint_fin(p, FILM, 8, -20, 5, back, 0.2);
    paint_fin(p, FILM, 20, 24, 4, low, 0.16);
}

static void angler_jaws(struct paint *p, struct state now)
{
    double open = now.attack ? 5.5 + 0.5 * art_sway(now.frame, 0) : 1.5 + 1.5 * art_sway(now.frame, 0),
           floor = 24.0 + open;
    paint_ball(p, PANE, 0, floor - 2, 38, 17.0 + open * 0.5, 0);
    paint_ball(p, NIGHT, 0, 15.0 + open * 0.5, 33.5, 14.0 + open, 0);
    paint_ball(p, (struct mat){ FLAT, 2, 2, 0 }, 0, 20.0 + open * 0.5, 26, 8.0 + open * 0.7, 0);
    paint_ball(p, FLESH, 0, 24.0 + open * 0.7, 17.0, 4.2 + open * 0.4, 0);
    for (int i = -4; i <= 4; i++) { /* the lower teeth stand */
        if (now.wounds && (i == 2 || (now.wounds > 1 && (i == -3 || i == 0))))
            continue; /* it has lost some */
        double u = i / 4.6, x = 33 * u, y = floor + 9.0 - u * u * 11.0, len = 11.0 - (i & 1) * 4.0;
        paint_limb(p, TOOTH, x, y, 2.1, x * 0.92, y - len, 0.4);
    }
    for (int i = -5; i <= 5; i++) { /* the upper ones hang, longer */
        if (now.wounds && (i == -2 || (now.wounds > 1 && (i == 3 || i == 0))))
            continue;
        double u = i / 5.5, x = 34 * u, y = 5.0 + u * u * 7.0, len = 13.0 - (i & 1) * 5.0 - u * u * 3.0;
        paint_limb(p, TOOTH, x, y, 2.3, x * 0.95, y + len, 0.4);
    }
}

static const double BROW[][4] = { { -30, -20, 0.02, 17 }, { 6, -35, 0.22, 20 },  { 36, -14, 0.6, 14 },
                                  { -10, -34, 0.2, 18 },  { -38, -4, 0.98, 18 }, { 22, -30, 0.28, 20 } };

static void angler_brow(struct paint *p, struct state now)
{
    double k = art_sway(now.frame, 0.25) * 0.5, glare = now.attack ? 1.6 : 0;
    double lip0[2] = { -37, 13 }, lipc[2] = { 0, -11 }, lip1[2] = { 37, 13 };
    paint_band(p, -1e9, 5.0);
    paint_ball(p, PANE, 0, -10 + k, 41, 29, 0);
    paint_band(p, -1e9, 1e9);
    paint_curve(p, (struct mat){ GLASS, 3, 8, 0.1 }, lip0, lipc, lip1, 4.4, 4.4);
    paint_mirror(p, true);
    for (int i = 0; i < 3; i++) {
        double a[2] = { 7.0 + 9 * i, -37.0 + 4.4 * i * i * 0.7 }, c[2] = { 12.0 + 10 * i, -24 },
               b[2] = { 11.0 + 9 * i, -11.5 };
        paint_curve(p, (struct mat){ VEIL, 2, 8, 0.14 }, a, c, b, 0.8, 0.6);
    }
    paint_ball(p, DEEP, 24, -15, 9.4, 8.0, -0.04);
    paint_ball(p, NIGHT, 24, -14.4, 7.6, 6.2, -0.04);
    paint_ball(p, SOUL, 24, -14.0, 5.0 + k * 0.6 + glare, 4.6 + glare, 0);
    paint_ball(p, NIGHT, 24.4, -13.6, now.attack ? 0.8 : 1.1, 3.4 + glare, 0.02);
    paint_limb(p, PANE, 14, -19.6, 2.4, 33, -22.4, 1.4);
    for (int i = 0; i < 5; i++) { /* small lights on its brow */
        double x = 5.0 + 6.4 * i, y = -30.0 + 0.9 * i * i;
        paint_ball(p, now.attack || (i + (int)now.frame) % 4 == 0 ? LAMP : FLESH, x, y, 1.1, 1.1, 0);
    }
    paint_mirror(p, false);
    paint_cracks(p, now.wounds, SOUL, BROW, 80);
    if (now.wounds > 1) /* an eye is out */
        paint_ball(p, NIGHT, -24, -14, 7, 6, 0);
    paint_limb(p, PANE, 0, -30, 5.4, 0, -41, 2.6);
    paint_ball(p, LAMP, -17, -29, 5.2, 1.7, -0.09);
}

static void angler(struct sheet *s, int x, int y, struct state now)
{
    struct paint *p = paint_new(120, 96);
    paint_mirror(p, true);
    angler_fins(p, now.frame);
    paint_mirror(p, false);
    paint_ball(p, DEEP, 0, 2, 42, 38, 0);
    angler_jaws(p, now);
    angler_brow(p, now);
    paint_done(p, s, x, y, 1, 2);
}

/* The lamp it holds out, in four brightnesses of one breath. */
static void lantern(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(28, 32);
    double k = art_sway(frame, 0);
    paint_mirror(p, true);
    for (int i = 0; i < 2; i++) {
        double a[2] = { 3.0 + 3 * i, 6 }, c[2] = { 6.0 + 4 * i + k, 10 },
               b[2] = { 5.0 + 3 * i - k * 1.4, 14.6 - 3 * i };
        paint_curve(p, FILM, a, c, b, 1.0, 0.4);
    }
    paint_mirror(p, false);
    paint_ball(p, SILVER, 0, -10.6, 3.4, 2.6, 0);
    paint_ball(p, PANE, 0, -0.4, 10.2, 10.2, 0);
    paint_ball(p, SOUL, 0, 0.2, 7.6 + k * 0.5, 7.6 + k * 0.5, 0);
    paint_ball(p, LAMP, 0, 0.2, 4.4 + k * 0.5, 4.4 + k * 0.5, 0);
    paint_ball(p, LAMP, -4.4, -5.6, 2.0, 1.0, -0.12);
    paint_done(p, s, x, y, 1, 2);
}

/* The light about the lamp: the first shades of a ramp, which the blend adds to those of what lies under them. */
static void glow(struct sheet *s)
{
    static const double order[4][4] = {
        { 0.03, 0.53, 0.16, 0.66 }, { 0.78, 0.28, 0.91, 0.41 }, { 0.22, 0.72, 0.09, 0.59 }, { 0.97, 0.47, 0.84, 0.34 }
    };
    double half = LIGHT / 2.0;
    for (int v = 0; v < LIGHT; v++) {
        for (int u = 0; u < LIGHT; u++) {
            double dx = u + 0.5 - half, dy = v + 0.5 - half, d = sqrt(dx * dx + dy * dy) / half;
            double shade = d < 1 ? 1.9 * (1 - d) * (1 - 0.35 * d) : 0;
            sheet_set(s, u, v, (int)(shade + order[v & 3][u & 3]));
        }
    }
}

struct sheet art_angler(void)
{
    struct sheet s = sheet_new(120 * BOSS_FRAMES, 96 * BOSS_ROWS + 32, 12);
    art_boss(&s, 120, 96, angler);
    for (int i = 0; i < 4; i++)
        lantern(&s, 28 * i, 96 * BOSS_ROWS, i);
    struct paint *p = paint_new(8, 8);
    paint_ball(p, PANE, 0, 0, 3.0, 3.0, 0);
    paint_done(p, &s, 112, 96 * BOSS_ROWS, 1, 2);
    return s;
}

struct sheet art_lamplight(void)
{
    struct sheet s = sheet_new(LIGHT, LIGHT, 0);
    glow(&s);
    return s;
}

/* -- the Queen -- */

static void queen_fins(struct paint *p, double frame, double up)
{
    double k = art_sway(frame, 0) * 3.4 - up, l = art_sway(frame, 0.3) * 3.2, m = art_sway(frame, 0.15) * 3.0 - up;
    double low[] = { 26, 47 + l, 36, 44 + l, 44, 36 + l * 0.7, 47, 26, 40, 14 };
    double mid[] = { 42, 18, 53, 18 + m * 0.4, 60, 9 + m, 60, -3 + m, 52, -8 };
    double top[] = { 40, 0,       52, -10 + k * 0.4, 59, -24 + k,       61.5, -40 + k,
                     57, -53 + k, 45, -46 + k * 0.6, 33, -38 + k * 0.3, 20,   -26 };
    paint_fin(p, FILM, 8, 4, 5, low, 0.18);
    paint_fin(p, FILM, 8, 0, 5, mid, 0.16);
    paint_fin(p, FILM, 6, -8, 8, top, 0.13);
    for (int i = 1; i < 7; i++) /* silver on the tips, with a drop under each */
        paint_ball(p, i == 4 ? SOUL : SILVER, top[2 * i], top[2 * i + 1], i == 4 ? 2.6 : 1.8, i == 4 ? 2.6 : 1.8, 0);
    for (int i = 1; i < 4; i++) {
        double x = mid[2 * i], y = mid[2 * i + 1];
        paint_limb(p, SILVER, x, y, 0.6, x - m * 0.3, y + 6, 0.6);
        paint_ball(p, SOUL, x - m * 0.3, y + 7.4, 1.5, 2.1, 0);
    }
}

static void queen_arms(struct paint *p, double frame)
{
    for (int i = 0; i < 5; i++) {
        double sway = art_sway(frame, 0.19 * i), tx = 3.5 + i * 5.6;
        double a[2] = { tx * 0.8, 14 }, c[2] = { tx + 6 + sway * 6, 36 },
               b[2] = { tx * 1.2 - sway * 6, 62.0 - i * 5.4 };
        paint_curve(p, i % 2 ? PANE : FLESH, a, c, b, 3.0, 0.7);
        if (i % 2)
            paint_ball(p, SILVER, b[0], b[1], 1.3, 1.3, 0);
    }
}

/* A ring behind her head, as on old pictures, with rays. */
static void queen_halo(struct paint *p)
{
    for (int i = 0; i < 36; i++) {
        double a = i / 36.0, b = (i + 1) / 36.0, r = 38;
        paint_limb(p, SILVER, r * art_cos(a), -24 + r * art_sin(a), 0.9, r * art_cos(b), -24 + r * art_sin(b), 0.9);
    }
    for (int i = 0; i < 13; i++) {
        double a = 0.5 + i / 24.0, r = i % 2 ? 41.5 : 45.5;
        if (-24 + r * art_sin(a) > -63)
            paint_limb(p, SILVER, 38 * art_cos(a), -24 + 38 * art_sin(a), 1.1, r * art_cos(a), -24 + r * art_sin(a),
                       0.4);
    }
}

static void queen_crown(struct paint *p, struct state now)
{
    const struct mat gem = now.wounds > 1 ? NIGHT : SOUL, side_gem = now.wounds ? NIGHT : SOUL;
    const double shine = now.attack ? 1.2 : 0;
    static const double mid[] = { -5.4, -36, 0, -62, 5.4, -36 };
    static const double side[] = { 5.0, -36, 11.0, -54, 15.6, -31.6 };
    static const double wide[] = { 14.0, -32, 22.6, -45.4, 22.0, -24.6 };
    static const double last[] = { 20.4, -25, 30.4, -33.4, 26.4, -17 };
    paint_mirror(p, true);
    paint_poly(p, SILVER, 3, last, 1.8);
    paint_poly(p, SILVER, 3, wide, 2.0);
    paint_poly(p, SILVER, 3, side, 2.2);
    paint_mirror(p, false);
    paint_poly(p, SILVER, 3, mid, 2.6);
    paint_ball(p, gem, 0, -42, 2.6 + shine, 4.0 + shine, 0);
    paint_mirror(p, true);
    paint_ball(p, SOUL, 10.6, -38.6, 1.8 + shine, 2.6 + shine, 0);
    paint_ball(p, side_gem, 20.4, -31.6, 1.5 + shine, 2.1 + shine, 0);
    paint_mirror(p, false);
}

static void queen_bell(struct paint *p, double frame)
{
    double k = art_sway(frame, 0), rx = 28.5 + k;
    paint_band(p, -1e9, 13);
    paint_ball(p, PANE, 0, -4, rx, 33.5, 0);
    paint_band(p, -1e9, 1e9);
    paint_mirror(p, true);
    for (int i = 0; i < 3; i++) {
        double a[2] = { 3.6 + 6.4 * i, -36.0 + 2.2 * i * i }, c[2] = { 11.5 + 8.4 * i, -26 + 3.0 * i },
               b[2] = { 11.0 + 7.2 * i, 11 };
        paint_curve(p, (struct mat){ VEIL, 2, 8, 0.2 }, a, c, b, 0.8, 0.8);
    }
    paint_mirror(p, false);
    for (int row = 0; row < 3; row++) { /* two frills, and the pearls above them */
        for (int i = 0; i < 12 - row; i++) {
            double u = (i - 5.5 + row * 0.5) / 5.5, ry = 4.6 + art_sway(frame, i * 0.25 + row * 0.5) * 0.8;
            double y = 16.0 - row * 3.6 - u * u * 4.6;
            paint_ball(p,
                       row == 2 ? SILVER
                       : row    ? PANE
                                : FILM,
                       u * (rx + 1.6 - row * 1.4), y, row == 2 ? 1.7 : 3.7, row == 2 ? 1.7 : ry, 0);
        }
    }
}

static void queen_gaze(struct paint *p, struct state now)
{
    static const double slit[] = { 0, -16.4, 3.0, -8.0, 0, 0.4, -3.0, -8.0 };
    static const double lash[] = { 12.6, -15.0, 24.0, -21.4, 16.0, -10.4 };
    static const double tear[] = { -2.6, 4.0, 2.6, 4.0, 0, 10.6 };
    paint_mirror(p, true);
    paint_poly(p, SILVER, 3, lash, 1.6);
    paint_mirror(p, false);
    paint_poly(p, SILVER, 3, tear, 1.4);
    paint_ball(p, SILVER, 0, -8, 16.2, 12.2, 0);
    paint_ball(p, NIGHT, 0, -8, 14.2, 10.4, 0);
    paint_ball(p, (struct mat){ MATTE, 13, 14, 0.2 }, 0, -8, 12.8, 9.6, 0);
    paint_ball(p, (struct mat){ FLAT, 12, 12, 0 }, 0, -8, 8.6, 9.0, 0);
    paint_ball(p, (struct mat){ MATTE, 12, 13, 0.36 }, 0, -8, 7.4, 8.2, 0);
    if (now.attack) {
        paint_ball(p, SOUL, 0, -8, 11.6, 9.2, 0);
        paint_limb(p, NIGHT, 0, -16, 0.5, 0, 0, 0.5);
        paint_ball(p, NIGHT, 0, -8, 1.5, 5.6, 0);
    } else {
        paint_ball(p, (struct mat){ FLAT, 11, 11, 0 }, 0, -8, 4.6, 6.8, 0);
        paint_poly(p, NIGHT, 4, slit, 0);
    }
    paint_ball(p, LAMP, -4.0, -12.0, 2.4, 2.0, 0);
    paint_ball(p, SOUL, 0, 6.4, 1.5, 1.9, 0);
    paint_ball(p, LAMP, -14.5, -25.0, 5.6, 1.8, -0.11);
}

static const double BELL[][4] = { { -24, -18, 0.2, 24 }, { 14, -30, 0.12, 22 }, { 20, 10, 0.7, 15 },
                                  { -8, -34, 0.3, 18 },  { 26, -8, 0.4, 20 },   { -27, 6, 0.93, 20 } };

static void queen(struct sheet *s, int x, int y, struct state now)
{
    struct paint *p = paint_new(128, 128);
    queen_halo(p);
    paint_mirror(p, true);
    queen_fins(p, now.frame, now.attack ? 4 : 0);
    queen_arms(p, now.frame);
    paint_mirror(p, false);
    queen_crown(p, now);
    queen_bell(p, now.frame);
    queen_gaze(p, now);
    paint_cracks(p, now.wounds, SOUL, BELL, 101);
    paint_done(p, s, x, y, 1, 2);
}

struct sheet art_queen_abyss(void)
{
    struct sheet s = sheet_new(128 * BOSS_FRAMES, 128 * BOSS_ROWS, 12);
    art_boss(&s, 128, 128, queen);
    return s;
}
