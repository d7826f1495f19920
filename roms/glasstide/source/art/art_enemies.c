/*
 * art_enemies.c - the glass creatures of the tide, the guard and the queen. Four frames each.
 */
#include "art.h"

/* Banks 10 and 11: 2..9 glass, 10..13 what lives inside, 14 and 15 light. */
static const struct mat GLAZE = { GLASS, 2, 9, 0 }, CLEAR = { VEIL, 2, 9, 0 }, SKIN = { VEIL, 3, 9, 0.05 },
                        HEART = { GLOW, 10, 15, 0 };
static const struct mat INNER = { MATTE, 10, 13, 0.1 }, BEAD = { GLASS, 10, 14, 0.1 }, EYE = { FLAT, 1, 1, 0 },
                        GLEAM = { FLAT, 15, 15, 0 };

/* The smallest: a drop with two long feelers that row. */
static void krill(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(20, 22);
    double k = art_sway(frame, 0);
    double a[2] = { 2.0, 5.0 }, c[2] = { 8.6, 6.5 - k * 2.0 }, b[2] = { 8.6 - k * 0.4, -2.6 - k * 2.2 };
    double fork[] = { 0.2, -10.2, 2.6, -9.6 + k * 0.5, 3.4, -8.0 };
    paint_mirror(p, true);
    paint_curve(p, SKIN, a, c, b, 0.9, 0.5);
    paint_fin(p, SKIN, 0, -4.2, 3, fork, 0.1);
    paint_mirror(p, false);
    paint_limb(p, GLAZE, 0, -6.0, 1.2, 0, 0, 3.0);
    paint_ball(p, GLAZE, 0, 3.4, 4.2, 5.2, 0);
    paint_ball(p, HEART, 0, 3.6, 2.0, 2.5, 0);
    paint_done(p, s, x, y, 1, 3);
}

/* A fish seen from above, swimming down; the tail beats. */
static void fish(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(28, 32);
    double k = art_sway(frame, 0), l = art_sway(frame, 0.25), tx = k * 3.0;
    double a[2] = { 0, 1 }, c[2] = { 0, -5 }, b[2] = { tx, -9 };
    double tail[] = { tx - 4.6 + l, -14.6, tx - 1.6, -13.2, tx + l * 1.2, -12.2, tx + 1.6, -13.2, tx + 4.6 + l, -14.6 };
    double fin[] = { 5.0, 6.2, 9.6, 3.4 - k * 0.4, 12.0, -3.0 + k * 0.8, 7.0, -2.2 };
    double hind[] = { 2.4, -2.0, 5.8, -6.0 - k * 0.5, 2.0, -7.0 };
    paint_fin(p, SKIN, tx, -7.6, 5, tail, 0.10);
    paint_mirror(p, true);
    paint_fin(p, SKIN, 2.0, 4.6, 4, fin, 0.04);
    paint_fin(p, SKIN, 1.0, -2.0, 3, hind, 0.04);
    paint_mirror(p, false);
    paint_curve(p, GLAZE, a, c, b, 4.8, 1.3);
    paint_ball(p, GLAZE, 0, 5.0, 5.6, 9.6, 0);
    double s0[2] = { 0, 6 }, sc[2] = { 0, -3 }, s1[2] = { k * 2.4, -7.6 };
    paint_curve(p, INNER, s0, sc, s1, 1.4, 0.5);
    paint_ball(p, HEART, 0, 4.6, 2.2, 3.0, 0);
    paint_mirror(p, true);
    paint_ball(p, GLEAM, 3.7, 9.4, 1.6, 1.6, 0);
    paint_ball(p, EYE, 4.0, 10.0, 1.0, 1.0, 0);
    paint_done(p, s, x, y, 1, 3);
}

static void jelly(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(36, 44);
    double k = art_sway(frame, 0), rx = 13.6 + k * 1.3, ry = 13.4 - k * 1.2, top = -7.0;
    for (int i = 0; i < 5; i++) {
        double tx = (i - 2) * 4.4, sway = art_sway(frame, 0.17 * i);
        double a[2] = { tx * 0.8, top + 3 }, c[2] = { tx + sway * 4.0, 7 },
               b[2] = { tx * 1.2 - sway * 3.4, 19.4 - (i % 2) * 3.5 - k };
        paint_curve(p, i % 2 ? SKIN : INNER, a, c, b, 1.5, 0.5);
    }
    paint_band(p, -1e9, top + 5.5);
    paint_ball(p, GLAZE, 0, top + 1, rx, ry, 0);
    paint_band(p, -1e9, 1e9);
    for (int i = 0; i < 7; i++) {
        double u = (i - 3) / 3.0;
        paint_ball(p, CLEAR, u * (rx - 2.0), top + 5.4 - u * u * 1.6, 2.5, 2.1 + k * 0.3, 0);
    }
    paint_ball(p, INNER, 0, top + 0.5, 6.2, 4.8, 0);
    paint_ball(p, HEART, 0, top + 0.3, 3.9, 3.3, 0);
    paint_mirror(p, true);
    double a[2] = { 3.4, top - 8.6 }, c[2] = { 8.2, top - 5 }, b[2] = { 9.4, top + 1.5 };
    paint_curve(p, (struct mat){ VEIL, 2, 9, 0.22 }, a, c, b, 0.55, 0.55);
    paint_mirror(p, false);
    paint_ball(p, GLEAM, -6.2, top - 5.4, 2.4, 1.0, -0.11);
    paint_done(p, s, x, y, 1, 3);
}

static void ray(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(52, 44);
    double k = art_sway(frame, 0), tip = 23.0 - 2.6 * (k < 0 ? -k : k), lift = k * 4.0;
    double wing[] = { 2, 13.5, 8, 12.0, 14, 7.0 + lift * 0.2, tip, 3.0 + lift, 16, -3.5 + lift * 0.4, 9, -7.2, 2, -9 };
    double a[2] = { 0, -5 }, c[2] = { art_sway(frame, 0.2) * 3.0, -13 }, b[2] = { art_sway(frame, 0.45) * 4.4, -20.5 };
    double spot[] = { 9.0, 5.2, 13.0, 3.4 + lift * 0.2, 12.6, 0.4 + lift * 0.2, 8.6, 0.6 };
    double horn0[2] = { 2.8, 11 }, hornc[2] = { 5.6, 14 }, horn1[2] = { 4.0, 18.4 };
    paint_curve(p, GLAZE, a, c, b, 2.0, 0.5);
    paint_mirror(p, true);
    paint_fin(p, SKIN, 0, 2, 7, wing, 0.05);
    paint_poly(p, INNER, 4, spot, 1.2);
    paint_curve(p, GLAZE, horn0, hornc, horn1, 1.5, 0.7);
    paint_mirror(p, false);
    paint_ball(p, GLAZE, 0, 3.2, 5.8, 11.6, 0);
    double s0[2] = { 0, 3 }, sc[2] = { 0, -3 }, s1[2] = { 0, -8.5 };
    paint_curve(p, INNER, s0, sc, s1, 1.5, 0.5);
    paint_ball(p, HEART, 0, 4.6, 2.6, 3.4, 0);
    paint_mirror(p, true);
    paint_ball(p, GLEAM, 3.8, 11.2, 1.2, 1.2, 0);
    paint_ball(p, EYE, 4.0, 11.6, 0.8, 0.8, 0);
    paint_done(p, s, x, y, 1, 3);
}

/* The spines turn by a quarter of their spacing a frame, so four frames make an endless turn. */
static void urchin(struct sheet *s, int x, int y, int frame)
{
    enum { SPINES = 12 };
    struct paint *p = paint_new(38, 38);
    for (int i = 0; i < 2 * SPINES; i++) {
        double a = (i * 0.5 + frame / 4.0) / SPINES, r = i % 2 ? 13.4 : 17.6, cx = art_cos(a), cy = art_sin(a);
        struct mat m = { GLASS, 2, 9, i % 2 ? 0.02 : 0.2 };
        paint_limb(p, m, cx * 8, cy * 8, i % 2 ? 1.4 : 1.9, cx * r, cy * r, 0.45);
    }
    paint_ball(p, GLAZE, 0, 0, 10.2, 10.2, 0);
    for (int i = 0; i < SPINES / 2; i++) {
        double a = (i * 2 + frame / 4.0 * 2) / SPINES;
        paint_ball(p, BEAD, art_cos(a) * 7.0, art_sin(a) * 7.0, 1.3, 1.3, 0);
    }
    paint_ball(p, INNER, 0, 0, 5.0, 5.0, 0);
    paint_ball(p, HEART, 0, 0, 3.6, 3.6, 0);
    paint_ball(p, GLEAM, -4.4, -5.2, 2.0, 1.1, -0.12);
    paint_done(p, s, x, y, 1, 3);
}

/* A shell seen from its side: a disc with flames towards the rim, a dark line that winds to the middle, a hood, arms.
 */
static void nautilus(struct sheet *s, int x, int y, int frame)
{
    enum { TURNS = 26 };
    struct paint *p = paint_new(44, 42);
    double cx = -4.0, cy = -2.6;
    for (int i = 0; i < 6; i++) {
        double sway = art_sway(frame, i * 0.19), bx = 17.6 - i * 2.6, by = 10.0 + i * 1.5;
        double a[2] = { 7.0 - i * 0.6, 7.0 + i * 0.3 }, c[2] = { 14.0 - i, 9.0 + i + sway },
               b[2] = { bx + sway * 1.4, by + 3.0 - sway };
        paint_curve(p, i % 2 ? SKIN : INNER, a, c, b, 1.9, 0.6);
    }
    paint_ball(p, GLAZE, cx, cy, 14.4, 13.8, 0);
    for (int i = 0; i < 6; i++) {
        double turn = 0.44 + i * 0.085, c1 = art_cos(turn), s1 = art_sin(turn), c2 = art_cos(turn + 0.05),
               s2 = art_sin(turn + 0.05);
        double a[2] = { cx + c1 * 13.6, cy + s1 * 13.0 }, c[2] = { cx + c2 * 11, cy + s2 * 11 },
               b[2] = { cx + c2 * 6.6, cy + s2 * 6.6 };
        paint_curve(p, INNER, a, c, b, 1.9, 0.5);
    }
    double px = cx + 9.6, py = cy + 9.0;
    for (int i = 1; i <= TURNS; i++) {
        double t = (double)i / TURNS, turn = 0.12 - t * 1.35, d = 12.6 * (1 - t) * (1 - 0.35 * t) + 2.6 * t;
        double nx = cx + 1.0 + art_cos(turn) * d, ny = cy + 1.0 + art_sin(turn) * d;
        if (t > 0.42)
            paint_limb(p, (struct mat){ FLAT, 2, 2, 0 }, px, py, 0.55, nx, ny, 0.55);
        px = nx;
        py = ny;
    }
    paint_ball(p, HEART, cx + 1.0, cy + 1.0, 2.4, 2.4, 0);
    paint_ball(p, (struct mat){ GLASS, 3, 9, 0.10 }, 5.4, 5.6, 7.0, 4.6, 0.09);
    paint_ball(p, GLEAM, 7.4, 5.6, 2.3, 2.3, 0);
    paint_ball(p, EYE, 8.0, 6.0, 1.3, 1.3, 0);
    paint_ball(p, GLEAM, cx - 6.0, cy - 8.2, 2.6, 1.1, -0.1);
    paint_done(p, s, x, y, 1, 3);
}

/* A fisherman's float: a ball of thick glass in a net, which rocks. */
static void buoy(struct sheet *s, int x, int y, int frame)
{
    static const struct mat rope = { MATTE, 10, 13, 0.2 };
    struct paint *p = paint_new(36, 40);
    double k = art_sway(frame, 0), cx = k * 0.8, r = 15.0;
    paint_ball(p, (struct mat){ GLASS, 2, 9, 0.05 }, cx, 2, r, r, 0);
    for (int i = -1; i <= 1; i++) {
        double a[2] = { cx, 2 - r }, c[2] = { cx + i * 19.0 + k * 1.5, 2 }, b[2] = { cx, 2 + r };
        paint_curve(p, rope, a, c, b, 0.75, 0.75);
        double d[2] = { cx - 13.6 + (i ? 2.4 : 0), 2 + i * 8.2 }, e[2] = { cx, 5.4 + i * 9.4 },
               f[2] = { cx + 13.6 - (i ? 2.4 : 0), 2 + i * 8.2 };
        paint_curve(p, rope, d, e, f, 0.7, 0.7);
    }
    paint_ball(p, rope, cx, 2 - r, 2.6, 1.9, 0);
    paint_limb(p, rope, cx, 2 - r, 0.9, cx - k * 2.4, -18.6, 0.7);
    paint_ball(p, GLEAM, cx - 6.4, -5.4, 2.6, 1.4, -0.12);
    paint_ball(p, (struct mat){ FLAT, 9, 9, 0 }, cx + 6.6, 9.0, 1.8, 1.2, -0.12);
    paint_done(p, s, x, y, 1, 3);
}

struct sheet art_enemies(void)
{
    struct sheet s = sheet_new(208, 240, 10);
    for (int i = 0; i < 4; i++) {
        krill(&s, 20 * i, 0, i);
        fish(&s, 80 + 28 * i, 0, i);
        jelly(&s, 36 * i, 32, i);
        ray(&s, 52 * i, 76, i);
        urchin(&s, 38 * i, 120, i);
        nautilus(&s, 44 * i, 158, i);
        buoy(&s, 36 * i, 200, i);
    }
    return s;
}

struct sheet art_enemies_poses(void)
{
    return art_poses(art_enemies);
}

/* Bank 12: 2..8 glass, 9..11 gold, 12..13 heart. */
static const struct mat PANE = { GLASS, 2, 8, 0 }, FILM = { VEIL, 2, 8, 0.02 }, GOLD = { MATTE, 9, 11, 0.12 },
                        SOUL = { GLOW, 12, 15, 0.0 };
static const struct mat FLESH = { MATTE, 12, 13, 0.1 }, NIGHT = { FLAT, 1, 1, 0 }, LAMP = { FLAT, 15, 15, 0 };

static void crab_legs(struct paint *p, int frame)
{
    for (int i = 0; i < 3; i++) {
        double k = art_sway(frame, i * 0.33) * 1.6, kx = 30 - i * 3.0, ky = -17.0 + i * 8.5 + k;
        double a[2] = { 14, -5.0 + i * 4.5 }, c[2] = { 24, ky - 3 }, b[2] = { kx, ky };
        paint_curve(p, PANE, a, c, b, 2.6, 2.0);
        paint_limb(p, PANE, kx, ky, 2.0, kx + 8.0 - i * 2.2, ky + 8.5 - k, 0.7);
        paint_ball(p, GOLD, kx, ky, 1.7, 1.7, 0);
    }
}

static void crab_claw(struct paint *p, int frame)
{
    static const double out[] = { -4.0, -4.5, 4.4, -5.5, 7.6, 1.5, 6.0, 9.5, 0.6, 16.0, 1.6, 8.4, 0.2, 3.6, -4.6, 2.6 };
    static const double in[] = { -5.4, -1.0, 0.6, 3.6, -0.4, 8.6, -3.4, 14.0, -6.2, 7.6 };
    double k = art_sway(frame, 0.1), open = 0.6 + 0.6 * art_sway(frame, 0.4), cx = 25.0 + k, cy = 12.0 + k, outer[16],
           inner[10];
    double a[2] = { 14, 4 }, c[2] = { 27, -1 }, b[2] = { cx, cy };
    for (int i = 0; i < 16; i++)
        outer[i] = out[i] + (i % 2 ? cy : cx) + (i == 8 ? open * 1.4 : 0);
    for (int i = 0; i < 10; i++)
        inner[i] = in[i] + (i % 2 ? cy : cx) - (i == 6 ? open * 1.6 : 0);
    paint_curve(p, PANE, a, c, b, 3.8, 3.0);
    paint_ball(p, GOLD, 22.4, 3.0, 2.4, 2.4, 0);
    paint_poly(p, (struct mat){ GLASS, 2, 8, 0.04 }, 5, inner, 3.0);
    paint_poly(p, (struct mat){ GLASS, 2, 8, 0.14 }, 8, outer, 4.2);
    paint_ball(p, GOLD, cx + 0.4, cy - 2.8, 3.0, 2.2, 0);
}

static void crab(struct sheet *s, int x, int frame)
{
    static const double crest[] = { 0, -15.5, 2.6, -12.0, 0, -8.0, -2.6, -12.0 };
    static const double horn[] = { 5.5, -12.4, 9.6, -16.6, 9.4, -11.0 };
    static const double spike[] = { 16, -9.0, 22.6, -11.6, 19.4, -5.4 };
    struct paint *p = paint_new(80, 60);
    double k = art_sway(frame, 0) * 0.6;
    paint_mirror(p, true);
    crab_legs(p, frame);
    crab_claw(p, frame);
    paint_poly(p, GOLD, 3, spike, 1.6);
    paint_poly(p, GOLD, 3, horn, 1.4);
    paint_mirror(p, false);
    paint_ball(p, PANE, 0, 0 + k * 0.3, 21.0, 13.2, 0);
    paint_mirror(p, true);
    double a[2] = { 2, -11.6 }, c[2] = { 12, -8 }, b[2] = { 14, 5.5 };
    paint_curve(p, (struct mat){ VEIL, 2, 8, 0.2 }, a, c, b, 0.6, 0.6);
    double a2[2] = { 6, -11.2 }, c2[2] = { 18.6, -7 }, b2[2] = { 19, 2 };
    paint_curve(p, (struct mat){ VEIL, 2, 8, 0.12 }, a2, c2, b2, 0.6, 0.5);
    paint_limb(p, PANE, 6.2, 9.5, 1.6, 8.0, 14.6 + k, 1.3);
    paint_ball(p, LAMP, 8.2, 16.0 + k, 2.5, 2.5, 0);
    paint_ball(p, NIGHT, 8.3, 16.8 + k, 1.3, 1.3, 0);
    paint_mirror(p, false);
    paint_poly(p, GOLD, 4, crest, 1.8);
    paint_ball(p, GOLD, 0, 0.6, 8.6, 6.8, 0);
    paint_ball(p, FLESH, 0, 0.6, 6.8, 5.2, 0);
    paint_ball(p, SOUL, 0, 0.6, 5.2 + k * 0.5, 4.0 + k * 0.5, 0);
    paint_ball(p, LAMP, -9.5, -7.6, 4.2, 1.2, -0.06);
    paint_done(p, s, x, 0, 1, 2);
}

static void queen_fins(struct paint *p, int frame)
{
    double k = art_sway(frame, 0) * 3.0, l = art_sway(frame, 0.3) * 3.0;
    double lower[] = { 20, 32 + l, 30, 28 + l, 37, 20 + l * 0.6, 38, 11, 30, 6 };
    double upper[] = { 34, 6,  43, -4 + k * 0.4, 47, -17 + k, 45.5, -30 + k, 37, -38 + k * 0.8, 27, -30 + k * 0.4,
                       17, -20 };
    paint_fin(p, FILM, 6, 0, 5, lower, 0.16);
    paint_fin(p, FILM, 5, -6, 7, upper, 0.12);
    for (int i = 1; i < 6; i++)
        paint_ball(p, GOLD, upper[2 * i], upper[2 * i + 1], 1.6, 1.6, 0);
}

static void queen_arms(struct paint *p, int frame)
{
    for (int i = 0; i < 4; i++) {
        double sway = art_sway(frame, 0.21 * i), tx = 3.5 + i * 5.2;
        double a[2] = { tx * 0.8, 8 }, c[2] = { tx + 5 + sway * 5, 26 },
               b[2] = { tx * 1.25 - sway * 5, 46.5 - i * 4.6 };
        paint_curve(p, i % 2 ? PANE : FLESH, a, c, b, 2.5, 0.6);
    }
}

static void queen_crown(struct paint *p)
{
    static const double side[] = { 4.0, -26, 9.6, -39, 12.6, -22.4 };
    static const double wide[] = { 12.0, -22, 19.6, -32.4, 17.6, -17 };
    static const double mid[] = { -4.6, -27, 0, -47, 4.6, -27 };
    paint_mirror(p, true);
    paint_poly(p, GOLD, 3, wide, 1.8);
    paint_poly(p, GOLD, 3, side, 2.0);
    paint_mirror(p, false);
    paint_poly(p, GOLD, 3, mid, 2.2);
    paint_ball(p, SOUL, 0, -31.5, 2.0, 2.8, 0);
}

static void queen(struct sheet *s, int x, int frame)
{
    static const double slit[] = { 0, -12.4, 2.3, -6.0, 0, 0.4, -2.3, -6.0 };
    struct paint *p = paint_new(96, 96);
    double k = art_sway(frame, 0), rx = 22.5 + k * 0.8;
    paint_mirror(p, true);
    queen_fins(p, frame);
    queen_arms(p, frame);
    paint_mirror(p, false);
    queen_crown(p);
    paint_band(p, -1e9, 8);
    paint_ball(p, PANE, 0, -3, rx, 25.5, 0);
    paint_band(p, -1e9, 1e9);
    paint_mirror(p, true);
    for (int i = 0; i < 2; i++) {
        double a[2] = { 4.0 + 6 * i, -27.2 + 2.4 * i }, c[2] = { 12.5 + 9.0 * i, -20 + 2 * i },
               b[2] = { 13.0 + 6.4 * i, 6 };
        paint_curve(p, (struct mat){ VEIL, 2, 8, 0.2 }, a, c, b, 0.7, 0.7);
    }
    paint_mirror(p, false);
    for (int row = 0; row < 2; row++) {
        for (int i = 0; i < 9 - row; i++) {
            double u = (i - 4 + row * 0.5) / 4.0, ry = 3.4 + art_sway(frame, i * 0.25 + row * 0.5) * 0.6;
            paint_ball(p, row ? GOLD : PANE, u * (rx - 1.0), 7.6 + row * -1.8 - u * u * 3.0, row ? 1.5 : 3.6,
                       row ? 1.5 : ry, 0);
        }
    }
    paint_ball(p, GOLD, 0, -6, 12.2, 9.6, 0);
    paint_ball(p, NIGHT, 0, -6, 10.6, 8.0, 0);
    paint_ball(p, (struct mat){ MATTE, 12, 14, 0.16 }, 0, -6, 9.4, 7.4, 0);
    paint_ball(p, (struct mat){ FLAT, 12, 12, 0 }, 0, -6, 6.2, 6.8, 0);
    paint_ball(p, (struct mat){ MATTE, 9, 11, 0.30 }, 0, -6, 5.4, 6.2, 0);
    paint_poly(p, NIGHT, 4, slit, 0);
    paint_ball(p, LAMP, -2.8, -9.0, 1.8, 1.6, 0);
    paint_ball(p, LAMP, -11.0, -20.0, 4.6, 1.5, -0.11);
    paint_done(p, s, x, 0, 1, 2);
}

struct sheet art_queen(void)
{
    struct sheet s = sheet_new(384, 96, 12);
    for (int i = 0; i < 4; i++)
        queen(&s, 96 * i, i);
    return s;
}
