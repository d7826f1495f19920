/*
 * art_three.c - who lives in the abyss: creatures of violet glass with lights of their own. Four frames each.
 */
#include "art.h"

/* Banks 10 and 11 of the abyss: 2..9 glass, 10..13 what lives inside, 14 and 15 light. */
static const struct mat GLAZE = { GLASS, 2, 9, 0 }, DEEP = { GLASS, 2, 7, -0.05 }, CLEAR = { VEIL, 2, 9, 0 },
                        SKIN = { VEIL, 3, 9, 0.05 }, HEART = { GLOW, 10, 15, 0 };
static const struct mat INNER = { MATTE, 10, 13, 0.1 }, TOOTH = { FLAT, 9, 9, 0 }, EYE = { FLAT, 1, 1, 0 },
                        GLEAM = { FLAT, 15, 15, 0 }, LIT = { FLAT, 13, 13, 0 }, DIM = { FLAT, 11, 11, 0 };

/* One of a row of lights that run along: the brightest of four is at another place in each frame. */
static struct mat running(int place, int frame)
{
    int at = (place + 4 - frame) & 3;
    return at == 0 ? GLEAM : at == 1 ? LIT : DIM;
}

/* The smallest: a drop with two feelers spread wide, which it beats down to hop. */
static void mite(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(24, 22);
    double k = art_sway(frame, 0);
    double a[2] = { 1.4, 3.4 }, c[2] = { 7.0, 7.6 - k }, b[2] = { 10.8 - k * 0.6, 1.4 - k * 3.4 };
    double fan[] = { 0.2, -10.0, 2.4, -9.8, 4.2 + k * 0.5, -8.2 };
    paint_mirror(p, true);
    paint_curve(p, GLAZE, a, c, b, 1.0, 0.5);
    paint_fin(p, SKIN, 0, -4.6, 3, fan, 0.12);
    paint_limb(p, SKIN, 2.4, 1.0, 0.9, 6.0, -2.4 + k * 1.2, 0.5);
    paint_mirror(p, false);
    paint_limb(p, GLAZE, 0, -6.4, 1.1, 0, 0.6, 3.4);
    paint_ball(p, GLAZE, 0, 2.6, 4.6, 4.6, 0);
    paint_ball(p, HEART, 0, 2.6, 2.2, 2.2, 0);
    paint_done(p, s, x, y, 1, 3);
}

/* A bell of a chain: it swims by itself, and the others with it. */
static void bell(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(20, 22);
    double k = art_sway(frame, 0);
    for (int i = -1; i <= 1; i++) {
        double a[2] = { i * 2.6, 2 }, c[2] = { i * 3.6 + k * 1.4, 6 }, b[2] = { i * 4.0 - k * 1.2, 9.6 - i * i };
        paint_curve(p, i ? SKIN : INNER, a, c, b, 1.0, 0.4);
    }
    paint_band(p, -1e9, 3.2);
    paint_ball(p, GLAZE, 0, -1.4, 7.0 + k * 0.6, 7.2 - k * 0.5, 0);
    paint_band(p, -1e9, 1e9);
    for (int i = -2; i <= 2; i++)
        paint_ball(p, CLEAR, i * 2.9, 3.0 - i * i * 0.25, 1.8, 1.5, 0);
    paint_ball(p, HEART, 0, -1.2, 2.8, 2.8, 0);
    paint_ball(p, GLEAM, -3.4, -4.6, 1.3, 0.8, -0.12);
    paint_done(p, s, x, y, 1, 3);
}

/* The head of a chain: a float that holds all of it up, with a ring of bells and three long threads. */
static void chain_head(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(40, 44);
    double k = art_sway(frame, 0);
    for (int i = -2; i <= 2; i++) {
        double sway = art_sway(frame, i * 0.17);
        double a[2] = { i * 3.0, 4 }, c[2] = { i * 4.4 + sway * 4, 12 },
               b[2] = { i * 3.4 - sway * 3, 20.6 - (i & 1) * 4.0 };
        paint_curve(p, i & 1 ? SKIN : INNER, a, c, b, 1.5, 0.5);
    }
    for (int i = -3; i <= 3; i++)
        paint_ball(p, DEEP, i * 4.6, 3.4 - i * i * 0.5 + k * 0.6, 3.6, 4.6, i * -0.02);
    paint_ball(p, GLAZE, 0, -7.6, 9.4 + k * 0.4, 12.2, 0);
    double a[2] = { -7.6, -12.6 }, c[2] = { 0, -17.4 }, b[2] = { 7.6, -12.6 };
    paint_curve(p, (struct mat){ VEIL, 3, 9, 0.2 }, a, c, b, 0.7, 0.7);
    for (int i = -3; i <= 3; i++)
        paint_ball(p, running(i + 3, frame), i * 3.0, 1.4 - i * i * 0.4, 1.1, 1.1, 0);
    paint_ball(p, INNER, 0, -6.6, 5.0, 6.4, 0);
    paint_ball(p, HEART, 0, -6.2, 3.4, 4.2, 0);
    paint_ball(p, GLEAM, -4.6, -13.6, 2.2, 1.2, -0.12);
    paint_done(p, s, x, y, 1, 3);
}

/* A viperfish seen from above, head down: jaws wider than its body, teeth that stand out of them. */
static void viper(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(32, 52);
    double k = art_sway(frame, 0), l = art_sway(frame, 0.22), tx = k * 4.2, open = 1.2 + 0.8 * art_sway(frame, 0.5);
    double a[2] = { 0, 8 }, c[2] = { -k * 4.6, -6 }, b[2] = { tx, -19 };
    double tail[] = { tx - 5.4, -25 + l, tx - 1.2, -23, tx + 1.2, -23, tx + 5.4, -25 - l };
    double fin[] = { 8.6, 5.0, 13.6, 0.6 - k * 1.2, 10.4, -1.8 };
    double jaw[] = { 1.0, 12, 7.6, 9.4, 9.4 + open * 0.4, 16.4, 6.2 + open, 23.4, 4.2 + open * 0.6, 18.2, 2.0, 16.6 };
    paint_fin(p, SKIN, tx, -17.4, 4, tail, 0.12);
    paint_mirror(p, true);
    paint_fin(p, SKIN, 3.0, 5.2, 3, fin, 0.08);
    paint_mirror(p, false);
    paint_curve(p, GLAZE, a, c, b, 5.4, 1.2);
    double back0[2] = { 0, 5 }, back1[2] = { tx * 0.9, -17.4 };
    paint_curve(p, INNER, back0, c, back1, 1.5, 0.4);
    paint_mirror(p, true);
    for (int i = 0; i < 3; i++) {
        double bx = 7.8 + open * 0.5 - i * 2.0, by = 18.2 - i * 0.8;
        paint_limb(p, TOOTH, bx, by, 1.0, bx - 1.2, by + 5.6 - i * 1.6, 0.4);
    }
    paint_poly(p, GLAZE, 6, jaw, 2.2);
    paint_mirror(p, false);
    paint_ball(p, GLAZE, 0, 9.6, 7.0, 7.4, 0);
    paint_ball(p, HEART, 0, 7.6, 2.4, 3.2, 0);
    paint_mirror(p, true);
    paint_ball(p, GLEAM, 4.9, 12.2, 2.0, 2.0, 0);
    paint_ball(p, EYE, 5.2, 12.8, 1.1, 1.1, 0);
    paint_mirror(p, false);
    for (int i = 0; i < 5; i++) {
        double t = i / 5.0, u = 1 - t, cx = u * u * a[0] + 2 * u * t * c[0] + t * t * b[0],
               cy = u * u * a[1] + 2 * u * t * c[1] + t * t * b[1], r = 4.4 - t * 3.2;
        paint_ball(p, running(i, frame), cx - r, cy, 0.9, 0.9, 0);
        paint_ball(p, running(i, frame), cx + r, cy, 0.9, 0.9, 0);
    }
    paint_done(p, s, x, y, 1, 3);
}

/* A squid of clear glass: mantle and fins above, its heart seen through, eight arms and two with clubs below. */
static void squid(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(40, 56);
    double k = art_sway(frame, 0), rx = 8.0 + k * 0.9;
    double fin[] = { 3.0, -26.4, 13.8, -23.0 + k * 1.4, 16.0, -16.4 + k * 2.0, 6.0, -12.0 };
    for (int i = 0; i < 4; i++) {
        double sway = art_sway(frame, 0.19 * i), tx = 1.4 + i * 2.0;
        double a[2] = { tx, 8 }, c[2] = { tx + 3 + sway * 2.6, 15 }, b[2] = { tx * 1.7 - sway * 2.4, 22.4 - i * 1.8 };
        paint_mirror(p, true);
        paint_curve(p, i % 2 ? GLAZE : INNER, a, c, b, 1.7, 0.5);
    }
    double arm[2] = { 3, 8 }, pull[2] = { 13.6 + k * 2, 12 }, club[2] = { 11.0 - k * 2.2, 24 };
    paint_curve(p, SKIN, arm, pull, club, 1.0, 0.7);
    paint_ball(p, DEEP, club[0], club[1], 1.9, 3.0, 0.04);
    paint_fin(p, SKIN, 2, -18, 4, fin, 0.06);
    paint_mirror(p, false);
    paint_limb(p, GLAZE, 0, -24.6, 2.4, 0, -12, rx);
    paint_ball(p, GLAZE, 0, -6.6, rx, 11.6 - k * 0.6, 0);
    paint_limb(p, INNER, 0, -19.4, 1.2, 0, -6, 4.2);
    paint_ball(p, HEART, 0, -6.2, 3.0, 4.2, 0);
    paint_ball(p, GLAZE, 0, 6.4, 6.6, 4.8, 0);
    paint_mirror(p, true);
    paint_ball(p, GLEAM, 5.0, 5.6, 2.6, 2.6, 0);
    paint_ball(p, EYE, 5.4, 6.0, 1.5, 1.5, 0);
    for (int i = 0; i < 4; i++)
        paint_ball(p, running(i, frame), 5.6 + (i == 1 || i == 2) * 0.8, -13.0 + i * 4.2, 0.9, 0.9, 0);
    paint_mirror(p, false);
    paint_ball(p, GLEAM, -3.6, -15.0, 1.2, 2.6, 0.06);
    paint_done(p, s, x, y, 1, 3);
}

/* A comb jelly: lights run down its six combs all the time. */
static void comb(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(36, 48);
    double k = art_sway(frame, 0), rx = 14.6 + k * 0.7, ry = 18.0 - k * 0.6;
    for (int i = -1; i <= 1; i += 2) {
        double a[2] = { i * 5.0, 10 }, c[2] = { i * (10.0 + k * 2.0), 16 }, b[2] = { i * (5.0 - k * 3.0), 22.6 };
        paint_curve(p, SKIN, a, c, b, 1.2, 0.4);
    }
    paint_ball(p, GLAZE, 0, -3, rx, ry, 0);
    paint_ball(p, (struct mat){ FLAT, 3, 3, 0 }, 0, 12.0, 7.2, 2.6, 0);
    paint_ball(p, INNER, 0, -1.0, 4.2, 9.0, 0);
    paint_ball(p, HEART, 0, -2.4, 2.8, 5.4, 0);
    for (int row = -2; row <= 2; row++) {
        if (row == 0)
            continue;
        for (int i = 0; i < 9; i++) {
            double v = (i - 4) / 5.2, across = row * (row * row > 1 ? 0.41 : 0.46);
            double px = across * rx * (1 - v * v * 0.62) * 0.98, py = -3 + v * ry;
            paint_ball(p, running(i, frame), px, py, 1.15, 0.95, 0);
        }
    }
    paint_ball(p, GLEAM, -5.6, -15.4, 2.8, 1.2, -0.1);
    paint_done(p, s, x, y, 1, 3);
}

/* A sea spider: almost nothing but legs, which it lifts in pairs. */
static void spider(struct sheet *s, int x, int y, int frame)
{
    static const double knee[4][2] = { { 16, -15 }, { 21, -7 }, { 21, 3.5 }, { 15, 10 } };
    static const double foot[4][2] = { { 21, -25 }, { 28.4, -14 }, { 28, 13.4 }, { 19, 24 } };
    struct paint *p = paint_new(60, 56);
    for (int i = 0; i < 8; i++) {
        int leg = i / 2, side = i % 2 ? 1 : -1;
        double k = art_sway(frame, leg * 0.25 + (side > 0 ? 0.5 : 0)) * 1.7;
        double kx = side * knee[leg][0], ky = knee[leg][1] + k, fx = side * (foot[leg][0] - k * 0.5),
               fy = foot[leg][1] + k * 1.2;
        paint_limb(p, GLAZE, side * 3.0, -5.0 + leg * 4.0, 1.7, kx, ky, 1.3);
        paint_limb(p, GLAZE, kx, ky, 1.3, fx, fy, 0.5);
        paint_ball(p, INNER, kx, ky, 1.8, 1.8, 0);
        paint_ball(p, running(leg, frame), kx, ky, 0.9, 0.9, 0);
    }
    paint_limb(p, GLAZE, 0, -12.6, 1.2, 0, -4, 3.2);
    paint_ball(p, GLAZE, 0, 1.0, 4.6, 8.6, 0);
    paint_ball(p, DEEP, 0, 10.6, 2.8, 4.2, 0);
    paint_ball(p, HEART, 0, 1.4, 2.6, 4.6, 0);
    paint_mirror(p, true);
    paint_ball(p, GLEAM, 1.9, 11.6, 1.0, 1.0, 0);
    paint_mirror(p, false);
    paint_done(p, s, x, y, 1, 3);
}

/* A lantern shark from above: slender, with a lamp in its nose and a row of lights down each flank. */
static void shark(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(52, 72);
    double k = art_sway(frame, 0), l = art_sway(frame, 0.22), tx = k * 5.0;
    double a[2] = { 0, 8 }, c[2] = { -k * 3.4, -12 }, b[2] = { tx, -28 };
    double tail[] = { tx - 2.4 + l * 2, -35.2, tx + 0.4, -33, tx + 4.0 + l * 3, -34.4 };
    double fin[] = { 9.0, 11.0, 18.0, 6.4 - k * 0.8, 23.6, -1.6 - k * 1.8, 17.0, -1.0 - k, 7.0, -1.0 };
    double hind[] = { 4.0, -12.0, 10.4, -18.6 + k, 4.0, -19.0 };
    paint_fin(p, SKIN, tx, -27, 3, tail, 0.1);
    paint_mirror(p, true);
    paint_fin(p, GLAZE, 4.0, 9.0, 5, fin, 0.05);
    paint_fin(p, SKIN, 1.5, -12.0, 3, hind, 0.05);
    paint_mirror(p, false);
    paint_curve(p, GLAZE, a, c, b, 8.0, 1.3);
    paint_ball(p, GLAZE, 0, 12, 9.4, 15.0, 0);
    paint_limb(p, GLAZE, 0, 18, 7.4, 0, 31, 3.0);
    double dorsal0[2] = { 0, 4 }, dorsalc[2] = { -k * 2, -8 }, dorsal1[2] = { tx * 0.6, -20 };
    paint_curve(p, INNER, dorsal0, dorsalc, dorsal1, 2.0, 0.6);
    paint_limb(p, (struct mat){ GLASS, 4, 9, 0.15 }, 0, 8, 2.2, -k * 1.6, -3.0, 0.8);
    paint_ball(p, HEART, 0, 27.6, 2.8, 3.8, 0);
    paint_mirror(p, true);
    paint_ball(p, GLEAM, 6.6, 19.4, 1.7, 2.2, 0.05);
    paint_ball(p, EYE, 6.9, 20.2, 1.0, 1.3, 0);
    for (int i = 0; i < 3; i++)
        paint_limb(p, (struct mat){ FLAT, 2, 2, 0 }, 5.6, 8.4 - i * 3.0, 0.5, 8.2, 7.4 - i * 3.0, 0.5);
    paint_mirror(p, false);
    for (int i = 0; i < 7; i++) {
        double t = i / 7.5, u = 1 - t, cx = u * u * a[0] + 2 * u * t * c[0] + t * t * b[0],
               cy = u * u * a[1] + 2 * u * t * c[1] + t * t * b[1], r = 6.4 - t * 5.2;
        paint_ball(p, running(i, frame), cx - r, cy, 1.0, 1.0, 0);
        paint_ball(p, running(i, frame), cx + r, cy, 1.0, 1.0, 0);
    }
    paint_done(p, s, x, y, 1, 3);
}

/* A gulper: a sack with a mouth, and a whip of a tail behind it. */
static void gulper(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(64, 64);
    double k = art_sway(frame, 0), wide = 20.0 + k * 2.0, drop = 6.0 + k * 1.6;
    double a[2] = { 0, 0 }, c[2] = { 14 + k * 4, -20 }, b[2] = { -6 + art_sway(frame, 0.3) * 5, -29 };
    double frill[] = { 12, -10, 22, -14 + k, 27, -4 + k * 1.6, 24, 6, 16, 8 };
    paint_curve(p, GLAZE, a, c, b, 7.0, 0.9);
    paint_ball(p, LIT, b[0], b[1], 1.8, 1.8, 0);
    paint_mirror(p, true);
    paint_fin(p, SKIN, 6, -2, 5, frill, 0.14);
    paint_mirror(p, false);
    paint_ball(p, GLAZE, 0, 0, 15.6, 14.6, 0);
    paint_ball(p, CLEAR, 0, 13, wide, 10.0 + drop * 0.8, 0);
    paint_ball(p, (struct mat){ FLAT, 2, 2, 0 }, 0, 14.5, wide - 3.4, 6.2 + drop * 0.8, 0);
    paint_ball(p, (struct mat){ MATTE, 10, 11, 0 }, 0, 16, wide - 7.0, 3.8 + drop * 0.7, 0);
    paint_ball(p, (struct mat){ FLAT, 1, 1, 0 }, 0, 17, wide - 11.0, 1.6 + drop * 0.7, 0);
    for (int i = -4; i <= 4; i++) {
        double tx = i * (wide - 4.0) / 4.6, ty = 8.6 + i * i * 0.22;
        paint_limb(p, TOOTH, tx, ty, 1.1, tx * 0.94, ty + 4.4 - (i & 1), 0.4);
    }
    paint_ball(p, HEART, 0, -3.4, 4.4, 4.4, 0);
    paint_mirror(p, true);
    paint_ball(p, GLEAM, 9.2, -2.8, 2.2, 2.2, 0);
    paint_ball(p, EYE, 9.6, -2.2, 1.2, 1.2, 0);
    paint_mirror(p, false);
    paint_ball(p, GLEAM, -7.0, -9.4, 2.8, 1.3, -0.1);
    paint_done(p, s, x, y, 1, 3);
}

struct sheet art_abyss_life(void)
{
    struct sheet s = sheet_new(304, 280, 10);
    for (int i = 0; i < 4; i++) {
        mite(&s, 24 * i, 0, i);
        bell(&s, 96 + 20 * i, 0, i);
        viper(&s, 176 + 32 * i, 0, i);
        chain_head(&s, 40 * i, 52, i);
        comb(&s, 160 + 36 * i, 52, i);
        squid(&s, 40 * i, 100, i);
        shark(&s, 52 * i, 156, i);
    }
    for (int i = 0; i < 4; i++)
        spider(&s, 60 * i, 228, i);
    return s;
}

struct sheet art_abyss_life_poses(void)
{
    return art_poses(art_abyss_life);
}

struct sheet art_gulper(void)
{
    struct sheet s = sheet_new(256, 64, 10);
    for (int i = 0; i < 4; i++)
        gulper(&s, 64 * i, 0, i);
    return s;
}

struct sheet art_gulper_poses(void)
{
    return art_poses(art_gulper);
}
