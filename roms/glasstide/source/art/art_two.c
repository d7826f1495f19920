/*
 * art_two.c - who works in the drowned glassworks: creatures of copper, brass and steel. Four frames each.
 */
#include "art.h"

/* Banks 10 and 11: 2..9 metal, 10..13 what burns inside, 14 and 15 light. */
static const struct mat METAL = { MATTE, 2, 9, 0.04 }, SHINE = { MATTE, 4, 9, 0.2 }, DULL = { MATTE, 2, 6, 0 },
                        JAR = { GLASS, 2, 9, 0 }, FIRE = { GLOW, 10, 15, 0 }, COAL = { MATTE, 10, 13, 0.1 },
                        EYE = { FLAT, 1, 1, 0 }, DARK = { FLAT, 2, 2, 0 }, GLEAM = { FLAT, 15, 15, 0 };

/* A lantern with a flame in it, on two small fins. */
static void drone(struct sheet *s, int x, int y, int frame)
{
    static const double cap[] = { -4.5, -7.5, -3, -10.5, 3, -10.5, 4.5, -7.5 };
    static const double foot[] = { -5, 8.4, -3.4, 11.8, 3.4, 11.8, 5, 8.4 };
    struct paint *p = paint_new(24, 28);
    double k = art_sway(frame, 0), l = art_sway(frame, 0.3);
    double fin[] = { 7.5, -3.5 - k * 2.2, 11.4, -6.4 - k * 3.4, 10.4, -0.5 - k * 1.4, 6, 2 };
    paint_mirror(p, true);
    paint_fin(p, METAL, 4.5, 0, 4, fin, 0.08);
    paint_mirror(p, false);
    paint_bow(p, METAL, -2.6, -10, 0, -15.4, 2.6, -10, 0.8, 0.8);
    paint_ball(p, JAR, 0, 0.6, 7, 8.6, 0);
    paint_ball(p, FIRE, 0, 1.6 - l * 0.5, 4.2 + k * 0.4, 5.6 + l * 0.6, 0);
    paint_mirror(p, true);
    paint_bow(p, METAL, 2.6, -7.6, 7.8, 0.6, 2.8, 8.6, 0.75, 0.75);
    paint_mirror(p, false);
    paint_poly(p, SHINE, 4, cap, 1.4);
    paint_poly(p, METAL, 4, foot, 1.4);
    paint_ball(p, GLEAM, -3.6, -3.2, 1.1, 1.8, 0.1);
    paint_done(p, s, x, y, 1, 2);
}

/* A bottle that sinks with its neck ahead; what is in it washes to and fro. */
static void bottle(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(22, 34);
    double k = art_sway(frame, 0), nx = k * 0.9, slop = art_sway(frame, 0.2) * 1.2;
    static const double cork[] = { -2.2, 11.4, -2.8, 16, 2.8, 16, 2.2, 11.4 };
    double plug[8];
    for (int i = 0; i < 8; i++)
        plug[i] = cork[i] + (i % 2 ? 0 : nx);
    paint_limb(p, JAR, -nx * 0.6, -9, 6.6, 0, -1, 7.2);
    paint_limb(p, JAR, 0, -1, 7.2, nx * 0.6, 7.6, 3.2);
    paint_limb(p, JAR, nx * 0.6, 7, 3.0, nx, 12, 2.8);
    paint_limb(p, COAL, -1 + slop, -3.4, 4.6, slop * 0.4, 1.6, 5);
    paint_limb(p, COAL, 0, 1.6, 4.6, nx * 0.5, 7.4, 1.7);
    paint_ball(p, FIRE, 0, 2.4, 2.4, 2.4, 0);
    paint_ball(p, METAL, nx, 10.6, 3.8, 1.5, 0);
    paint_poly(p, SHINE, 4, plug, 1.2);
    paint_ball(p, (struct mat){ FLAT, 9, 9, 0 }, -4, -7.6, 1.0, 3.4, 0.02);
    paint_ball(p, GLEAM, -3.8, -9.2, 1.0, 1.5, 0);
    paint_ball(p, DULL, 0, -13.6, 4.2, 1.8, 0);
    paint_done(p, s, x, y, 1, 2);
}

/* The glassblower's tongs: they hold a gather of glass, and nip. */
static void tongs(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(36, 38);
    double open = 1.6 + 1.6 * art_sway(frame, 0), k = art_sway(frame, 0.25);
    paint_mirror(p, true);
    for (int i = 0; i < 3; i++) {
        double step = art_sway(frame, i * 0.34) * 1.5, kx = 13.6 - i * 1.4, ky = -14 + i * 5.2 + step;
        paint_bow(p, METAL, 4, -8 + i * 1.6, 10, ky - 4, kx, ky, 1.3, 1.0);
        paint_limb(p, METAL, kx, ky, 1.1, kx + 2.6, ky + 5.2, 0.5);
    }
    paint_bow(p, METAL, 2, -7, 15 + open, -3, 11 + open * 0.9, 7, 2.2, 2.4);
    paint_bow(p, SHINE, 11 + open * 0.9, 6, 10 + open, 14, 4.2 + open * 0.9, 16.6, 2.3, 0.8);
    paint_ball(p, SHINE, 11.4 + open, 6, 2.2, 2.2, 0);
    paint_mirror(p, false);
    paint_ball(p, METAL, 0, -9, 7.6, 6.2, 0);
    paint_ball(p, SHINE, 0, -8.2, 4.4, 3.6, 0);
    paint_ball(p, DARK, 0, -8.2, 2.4, 2, 0);
    paint_ball(p, FIRE, 0, -8.2, 1.7, 1.4, 0);
    paint_ball(p, COAL, 0, 8.6, 6.4, 7 + k * 0.4, 0);
    paint_ball(p, FIRE, 0, 9, 5 + k * 0.3, 5.6, 0);
    paint_ball(p, GLEAM, -2.4, 5.4, 1.3, 1.1, 0);
    paint_mirror(p, true);
    paint_limb(p, METAL, 3.4, -13, 0.8, 4.8, -16.4 + k * 0.4, 0.6);
    paint_ball(p, GLEAM, 4.9, -16.6 + k * 0.4, 1.3, 1.3, 0);
    paint_done(p, s, x, y, 1, 2);
}

/* A fish that is a bellows: folds of leather between two boards, and a nozzle to blow through. */
static void puffer(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(36, 40);
    double k = art_sway(frame, 0), full = 10.4 + 2.6 * k, tall = 1 + 0.05 * k;
    double tail[] = { -6 + k, -18.4, -2, -17, 0, -15.6, 2, -17, 6 + k, -18.4 };
    double fin[] = { full + 1, -2, full + 4.6, 0.4 + k * 1.4, full + 4, 5.4 + k, full - 1.4, 5 };
    paint_fin(p, METAL, 0, -10, 5, tail, 0.12);
    paint_mirror(p, true);
    paint_fin(p, METAL, full - 4, 2, 4, fin, 0.06);
    paint_mirror(p, false);
    for (int i = 0; i < 6; i++) {
        double v = (i - 2.5) / 3.1, wide = full * (1 - v * v * 0.62), cy = (-2 + (i - 2.5) * 4) * tall;
        paint_ball(p, i % 2 ? DULL : METAL, 0, cy, wide - (i % 2 ? 1.4 : 0), 3.4, 0);
    }
    paint_limb(p, SHINE, 0, -12, 3.4, 0, 6, 2.2);
    paint_ball(p, COAL, 0, -2, 2.6, 4.6, 0);
    paint_ball(p, FIRE, 0, -1.6, 1.9, 3.4 + k * 0.5, 0);
    paint_limb(p, METAL, 0, 9, 4.6, 0, 16, 2.6);
    paint_ball(p, SHINE, 0, 16.2, 3.6, 1.8, 0);
    paint_ball(p, EYE, 0, 17, 2, 0.9, 0);
    paint_mirror(p, true);
    paint_ball(p, SHINE, 6.2, 8.2, 2.6, 2.6, 0);
    paint_ball(p, GLEAM, 6.3, 8.6, 1.7, 1.7, 0);
    paint_ball(p, EYE, 6.4, 9.2, 1, 1, 0);
    paint_done(p, s, x, y, 1, 2);
}

/* A pot of molten glass on its chain; it runs over. */
static void crucible(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(44, 46);
    double k = art_sway(frame, 0), lean = k * 0.8;
    paint_mirror(p, true);
    paint_bow(p, DULL, 0.6, -21.6, 9, -19, 14.6 + lean * 0.4, -6.4, 1.0, 1.0);
    paint_ball(p, SHINE, 15.4, -4.6, 2.4, 2.6, 0);
    paint_mirror(p, false);
    paint_band(p, -4.6, 1e9);
    paint_ball(p, METAL, 0, 0, 16, 20, 0);
    paint_band(p, -1e9, 1e9);
    paint_ball(p, SHINE, 0, -4.8, 17, 5.4, 0);
    paint_ball(p, DARK, 0, -5, 14.6, 4, 0);
    paint_ball(p, FIRE, 0, -4.6, 13.8, 3.6, 0);
    for (int i = 0; i < 4; i++) {
        static const double at[4] = { -11, -4.6, 3.6, 10.4 };
        double run = 4.2 + 3.2 * art_sway(frame, 0.29 * i) + (i % 2 ? 4 : 0);
        paint_limb(p, COAL, at[i], -2.6, 2, at[i] * 0.96, -1 + run, 1.7);
        paint_ball(p, FIRE, at[i] * 0.96, -0.6 + run, 1.6, 2, 0);
    }
    for (int i = -1; i <= 1; i++)
        paint_ball(p, SHINE, i * 8.6, 12.6 - i * i * 2.2, 1.3, 1.3, 0);
    paint_bow(p, SHINE, -13.6, 10, 0, 15.6, 13.6, 10, 0.8, 0.8);
    paint_ball(p, FIRE, 0, 19.4, 2.4, 1.6 + k * 0.4, 0);
    paint_done(p, s, x, y, 1, 2);
}

/* A worm of pipes: a joint between each two, a valve for a crown, and a mouth to blow off steam. */
static void worm(struct sheet *s, int x, int y, int frame)
{
    enum { JOINTS = 6 };
    struct paint *p = paint_new(32, 56);
    double px = 0, py = 0;
    for (int i = 0; i <= JOINTS; i++) {
        double t = (double)i / JOINTS, nx = art_sway(frame, 0.21 * i) * (7 - 5 * t), ny = -25 + 38 * t;
        if (i)
            paint_limb(p, i % 2 ? METAL : DULL, px, py, 2.2 + 2.4 * (t - 0.15), nx, ny, 2.2 + 2.6 * t);
        px = nx;
        py = ny;
    }
    for (int i = 0; i < JOINTS; i++) {
        double t = (double)i / JOINTS;
        paint_ball(p, SHINE, art_sway(frame, 0.21 * i) * (7 - 5 * t), -25 + 38 * t, 3.4 + 2.9 * t, 1.7, 0);
    }
    paint_limb(p, METAL, px, 11, 6, px * 0.7, 19, 6.4);
    paint_mirror(p, true);
    paint_limb(p, SHINE, 6, 13.4, 1.2, 11.6, 11, 1.1);
    paint_mirror(p, false);
    for (int i = 0; i < 4; i++) {
        double a = (i + frame / 4.0) / 4;
        paint_limb(p, SHINE, 0, 13.4, 1.0, 5.4 * art_cos(a), 13.4 + 3.4 * art_sin(a), 0.9);
    }
    paint_ball(p, SHINE, 0, 13.4, 2.6, 2.2, 0);
    paint_ball(p, COAL, 0, 13.4, 1.4, 1.2, 0);
    paint_ball(p, SHINE, 0, 23, 7.4, 3.2, 0);
    paint_ball(p, EYE, 0, 24, 5.6, 2.2, 0);
    paint_ball(p, FIRE, 0, 24, 4.2, 1.4 + 0.4 * art_sway(frame, 0), 0);
    paint_mirror(p, true);
    paint_ball(p, GLEAM, 4.6, 18.6, 1.5, 1.5, 0);
    paint_ball(p, EYE, 4.8, 19.2, 0.8, 0.8, 0);
    paint_done(p, s, x, y, 1, 2);
}

/* A wheel with n teeth; turn: of one tooth's width, 0 to 1. */
static void cog(struct paint *p, double x, double y, double r, int n, double turn)
{
    for (int i = 0; i < n; i++) {
        double a = (i + turn) / n, c = art_cos(a), q = art_sin(a);
        paint_limb(p, SHINE, x + c * r * 0.7, y + q * r * 0.7, r * 0.2, x + c * r * 1.14, y + q * r * 1.14, r * 0.16);
    }
    paint_ball(p, METAL, x, y, r, r, 0);
    paint_ball(p, DARK, x, y, r * 0.62, r * 0.62, 0);
    for (int i = 0; i < 3; i++) {
        double a = (double)i / 3 + turn / n;
        paint_limb(p, METAL, x, y, r * 0.14, x + r * 0.66 * art_cos(a), y + r * 0.66 * art_sin(a), r * 0.14);
    }
    paint_ball(p, SHINE, x, y, r * 0.28, r * 0.28, 0);
}

/* A ray that carries two wheels which mesh with a third. */
static void gear_ray(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(60, 50);
    double k = art_sway(frame, 0), tip = 27 - 2.4 * (k < 0 ? -k : k), lift = k * 3.6, turn = frame / 4.0;
    double wing[] = { 2, 15.5, 10, 13.6, 17, 8 + lift * 0.3, tip, 2 + lift, 19, -5 + lift * 0.4, 10, -8.6, 2, -11 };
    paint_mirror(p, true);
    paint_fin(p, DULL, 0, 2, 7, wing, 0.06);
    paint_bow(p, METAL, 3, 12, 6.6, 16, 5, 21, 1.6, 0.8);
    paint_mirror(p, false);
    for (int i = 5; i >= 0; i--)
        paint_ball(p, i % 2 ? SHINE : DULL, art_sway(frame, 0.1 * i) * 0.7 * i, -10 - 2.7 * i, 2.6 - 0.26 * i, 2, 0);
    paint_ball(p, METAL, 0, 2.6, 7, 13.4, 0);
    cog(p, -13, 2.2 + lift * 0.14, 7, 8, turn);
    cog(p, 13, 2.2 + lift * 0.14, 7, 8, 1 - turn);
    cog(p, 0, 0, 5.4, 8, 0.5 - turn);
    paint_ball(p, FIRE, 0, 0, 2.4, 2.4, 0);
    paint_mirror(p, true);
    paint_ball(p, GLEAM, 4.2, 12.6, 1.5, 1.5, 0);
    paint_ball(p, EYE, 4.4, 13.2, 0.9, 0.9, 0);
    paint_done(p, s, x, y, 1, 2);
}

static void kiln_shell(struct paint *p)
{
    paint_ball(p, METAL, 0, -3, 23, 20, 0);
    for (int row = 0; row < 4; row++) {
        double y = -17 + row * 7.4, half = row == 0 ? 15 : row == 1 ? 20 : row == 2 ? 21.6 : 18;
        paint_bow(p, DARK, -half, y + 1, 0, y + 6.4, half, y + 1, 0.5, 0.5);
        for (int i = -2; i <= 2; i++) {
            double bx = (i + (row % 2 ? 0.5 : 0)) * 9.4;
            if (bx * bx < half * half * 0.8)
                paint_limb(p, DARK, bx, y + 4 - bx * bx * 0.012, 0.45, bx, y - 2.6 - bx * bx * 0.01, 0.45);
        }
    }
}

/* A tortoise with a kiln for a shell, its door towards whoever comes. */
static void kiln(struct sheet *s, int x, int y, int frame)
{
    static const double door[] = { -8, 15, -8, 4, -4.6, -1, 4.6, -1, 8, 4, 8, 15 };
    static const double hole[] = { -5.6, 13.4, -5.6, 5, -3, 1.6, 3, 1.6, 5.6, 5, 5.6, 13.4 };
    static const double stack[] = { -5, -14, -4, -27, 4, -27, 5, -14 };
    struct paint *p = paint_new(68, 62);
    double k = art_sway(frame, 0), l = art_sway(frame, 0.25);
    double front[] = { 24, 9 + k * 3, 32, 16 + k * 4, 30, 21 + k * 3, 20, 15 + k };
    double hind[] = { 22, -13 - k, 29, -19 - k * 3, 24, -22 - k * 2, 16, -17 };
    paint_mirror(p, true);
    paint_fin(p, METAL, 15, 6, 4, front, 0.04);
    paint_fin(p, METAL, 13, -12, 4, hind, 0.04);
    paint_mirror(p, false);
    paint_limb(p, METAL, 0, 14, 6.4, 0, 22 + l * 0.8, 6);
    paint_ball(p, METAL, 0, 23 + l * 0.8, 6.6, 6, 0);
    paint_mirror(p, true);
    paint_ball(p, GLEAM, 4.4, 25 + l * 0.8, 1.6, 1.6, 0);
    paint_ball(p, EYE, 4.6, 25.6 + l * 0.8, 0.9, 0.9, 0);
    paint_mirror(p, false);
    kiln_shell(p);
    paint_poly(p, DULL, 4, stack, 1.6);
    paint_ball(p, SHINE, 0, -27, 5.6, 2.2, 0);
    paint_ball(p, FIRE, 0, -27, 3.8, 1.2, 0);
    paint_poly(p, SHINE, 6, door, 1.8);
    paint_poly(p, EYE, 6, hole, 0);
    paint_ball(p, FIRE, 0, 9, 5 + k * 0.4, 5.6 + l * 0.6, 0);
    for (int i = -1; i <= 1; i++)
        paint_limb(p, DARK, i * 2.8, 2.6, 0.5, i * 2.8, 13.2, 0.5);
    paint_done(p, s, x, y, 1, 2);
}

struct sheet art_two_creatures(void)
{
    struct sheet s = sheet_new(272, 306, 10);

    for (int i = 0; i < 4; i++) {
        drone(&s, 24 * i, 0, i);
        bottle(&s, 96 + 22 * i, 0, i);
        tongs(&s, 36 * i, 36, i);
        worm(&s, 144 + 32 * i, 36, i);
        puffer(&s, 36 * i, 92, i);
        gear_ray(&s, 60 * i, 134, i);
        crucible(&s, 44 * i, 186, i);
        kiln(&s, 68 * i, 234, i);
    }
    return s;
}

struct sheet art_two_creatures_poses(void)
{
    return art_poses(art_two_creatures);
}
