/*
 * art_one.c - who lives in the shallows of Glass Tide beside the creatures of art_enemies.c: a squid, a seahorse, the
 * hatches of the wreck, the Lantern Nautilus, and the Chandelier Crab in its parts, with its face.
 */
#include "art.h"

/* Bank 10: 2..9 glass, 10..13 what is inside. */
static const struct mat GLAZE = { GLASS, 2, 9, 0 }, SKIN = { VEIL, 3, 9, 0.05 }, HEART = { GLOW, 10, 15, 0 },
                        INNER = { MATTE, 10, 13, 0.1 }, EYE = { FLAT, 1, 1, 0 }, GLEAM = { FLAT, 15, 15, 0 };

/* It swims with its mantle ahead, so it is an arrow that points at whom it is after; its arms trail. */
static void squid(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(30, 44);
    double k = art_sway(frame, 0), fat = 6.4 - k * 0.9;
    double fin[] = { 1.0, 21.6, 11.8 - k, 12.5, 8.6 - k * 0.6, 9.0, 2.0, 7.0 };

    for (int i = 0; i < 5; i++) {
        double tx = (i - 2) * 2.6, sway = art_sway(frame, 0.2 * i) * 2.4, reach = i == 0 || i == 4 ? -20.0 : -17.0;
        double a[2] = { tx * 0.7, -5 }, c[2] = { tx * 1.6 + sway, -11 }, b[2] = { tx * 1.3 - sway, reach - k };
        paint_curve(p, i % 2 ? INNER : SKIN, a, c, b, 1.5, 0.6);
    }
    paint_mirror(p, true);
    paint_fin(p, SKIN, 0, 13.5, 4, fin, 0.04);
    paint_mirror(p, false);
    paint_limb(p, GLAZE, 0, -1, fat * 0.8, 0, 6, fat);
    paint_limb(p, GLAZE, 0, 6, fat, 0, 19.6, 1.4);
    paint_ball(p, HEART, 0, 6.4, 2.6, 4.4, 0);
    paint_ball(p, GLAZE, 0, -4.4, 5.4, 4.4, 0);
    paint_mirror(p, true);
    paint_ball(p, GLEAM, 4.6, -3.6, 1.7, 1.7, 0);
    paint_ball(p, EYE, 4.9, -3.2, 1.0, 1.0, 0);
    paint_mirror(p, false);
    paint_ball(p, GLEAM, -2.8, 9.6, 1.0, 3.0, -0.02);
    paint_done(p, s, x, y, 1, 3);
}

/* Seen from its side, with its snout to the left; the tail curls and the fin on its back beats. */
static void seahorse(struct sheet *s, int x, int y, int frame)
{
    struct paint *p = paint_new(32, 48);
    double k = art_sway(frame, 0);
    double neck[3][2] = { { 0, -12 }, { 6.5, -8 }, { 4, 0 } }, belly[3][2] = { { 3, -3 }, { 0, 8 }, { 4, 13 } };
    double tail[3][2] = { { 3.6, 11 }, { 7, 21 }, { -1, 20.5 } }, curl[3][2] = { { -1, 20.5 }, { -7, 18 }, { -2, 15 } };
    double fin[] = { 8.0, -6.0, 13.0 + k, -3.0, 14.0 - k, 2.0, 11.0 + k, 6.0, 6.0, 7.0 };
    static const double crest[] = { -1, -15, 2, -22, 4, -17, 7.6, -19, 6, -13 };

    paint_fin(p, SKIN, 3.5, 1, 5, fin, 0.1);
    paint_curve(p, GLAZE, curl[0], curl[1], curl[2], 1.7, 0.9);
    paint_curve(p, GLAZE, tail[0], tail[1], tail[2], 3.0, 1.6);
    paint_curve(p, GLAZE, belly[0], belly[1], belly[2], 5.6, 3.0);
    paint_curve(p, GLAZE, neck[0], neck[1], neck[2], 4.2, 5.2);
    paint_poly(p, (struct mat){ GLASS, 3, 9, 0.12 }, 5, crest, 1.6);
    paint_ball(p, GLAZE, 0.6, -13, 5.2, 4.8, 0);
    paint_limb(p, GLAZE, -2, -11.6, 2.6, -11, -8.4, 1.6);
    paint_ball(p, EYE, -11.6, -8.2, 0.9, 1.1, 0);
    for (int i = 0; i < 4; i++)
        paint_ball(p, INNER, 1.0 + 0.5 * i, -1.5 + 4.0 * i, 1.9 - 0.2 * i, 1.2, 0);
    paint_ball(p, HEART, 2.2, 3.4, 2.6, 3.0, 0);
    paint_ball(p, GLEAM, -0.6, -14, 2.0, 2.0, 0);
    paint_ball(p, EYE, -1.0, -13.8, 1.1, 1.1, 0);
    paint_done(p, s, x, y, 1, 3);
}

/* A round hatch of the wreck whose two lids slide apart; `open` is 0 to 1. What is behind them glows. */
static void hatch(struct sheet *s, int x, int y, double open)
{
    struct paint *p = paint_new(40, 40);
    double gap = open * 9.5;

    paint_ball(p, (struct mat){ MATTE, 2, 7, 0.05 }, 0, 0, 17, 17, 0);
    for (int i = 0; i < 8; i++)
        paint_ball(p, (struct mat){ MATTE, 4, 9, 0.2 }, art_cos((i + 0.5) / 8) * 14.6, art_sin((i + 0.5) / 8) * 14.6,
                   1.3, 1.3, 0);
    paint_ball(p, EYE, 0, 0, 12.6, 12.6, 0);
    if (open > 0)
        paint_ball(p, HEART, 0, 0, 4 + 7 * open, 4 + 7 * open, 0);
    for (int side = -1; side <= 1; side += 2) {
        double lid[28];
        for (int i = 0; i < 14; i++) {
            double a = (side < 0 ? 0.25 : 0.75) + 0.5 * i / 13, px = art_cos(a) * 12, py = art_sin(a) * 12;
            lid[2 * i] = side < 0 ? art_clamp(px - gap, -12.4, 0) : art_clamp(px + gap, 0, 12.4);
            lid[2 * i + 1] = py * (1 - 0.35 * open);
        }
        if (open < 1)
            paint_poly(p, (struct mat){ GLASS, 2, 8, 0.04 }, 14, lid, 3);
        paint_limb(p, (struct mat){ MATTE, 4, 9, 0.1 }, side * (1.6 + gap), -8 + 3 * open, 1, side * (1.6 + gap),
                   8 - 3 * open, 1);
    }
    paint_done(p, s, x, y, 1, 3);
}

struct sheet art_shoal(void)
{
    struct sheet s = sheet_new(160, 136, 10);

    for (int i = 0; i < 4; i++) {
        squid(&s, 30 * i, 0, i);
        seahorse(&s, 32 * i, 46, i);
        hatch(&s, 40 * i, 96, i / 3.0);
    }
    return s;
}

struct sheet art_shoal_poses(void)
{
    return art_poses(art_shoal);
}

/* Bank 12: 2..8 glass, 9..11 silver, 12..13 cold light. */
static const struct mat PANE = { GLASS, 2, 8, 0 }, SILVER = { MATTE, 9, 11, 0.12 }, SOUL = { GLOW, 12, 15, 0.05 },
                        FLESH = { MATTE, 12, 13, 0.1 }, NIGHT = { FLAT, 1, 1, 0 }, LAMP = { FLAT, 15, 15, 0 };

/* A ship's lamp: a cap, a light between bars, and a foot. */
static void lamp(struct paint *p, double x, double y, double r, double glow)
{
    double cap[] = { x - r, y - r * 0.9, x - r * 0.4, y - r * 1.7, x + r * 0.4, y - r * 1.7, x + r, y - r * 0.9 };

    paint_ball(p, (struct mat){ GLOW, 12, 15, 0.05 + glow * 0.12 }, x, y, r, r * 1.15, 0);
    for (int i = -1; i <= 1; i++) {
        double a[2] = { x + i * r * 0.5, y - r }, c[2] = { x + i * r * 1.3, y }, b[2] = { x + i * r * 0.5, y + r };
        paint_curve(p, (struct mat){ FLAT, 9, 9, 0 }, a, c, b, 0.55, 0.55);
    }
    paint_poly(p, SILVER, 4, cap, 1.4);
    paint_limb(p, SILVER, x - r * 0.6, y + r * 1.2, 1.3, x + r * 0.6, y + r * 1.2, 1.3);
    paint_ball(p, SILVER, x, y - r * 1.9, 1.5, 1.5, 0);
}

/* The flames of its shell, and the dark line that winds to the middle. */
static void shell(struct paint *p, double cx, double cy, double r)
{
    enum { FLAMES = 9, TURNS = 40 };
    double px = 0, py = 0;

    paint_ball(p, PANE, cx, cy, r, r * 0.96, 0);
    for (int i = 0; i < FLAMES; i++) {
        double turn = 0.40 + i * 0.066, c1 = art_cos(turn), s1 = art_sin(turn), c2 = art_cos(turn + 0.04),
               s2 = art_sin(turn + 0.04);
        double a[2] = { cx + c1 * r * 0.95, cy + s1 * r * 0.91 }, c[2] = { cx + c2 * r * 0.8, cy + s2 * r * 0.8 },
               b[2] = { cx + c2 * r * 0.5, cy + s2 * r * 0.5 };
        paint_curve(p, i % 2 ? SILVER : FLESH, a, c, b, 2.3, 0.6);
    }
    for (int i = 0; i <= TURNS; i++) {
        double t = (double)i / TURNS, turn = 0.14 - t * 1.5, d = r * (0.9 * (1 - t) * (1 - 0.3 * t) + 0.16 * t);
        double nx = cx + 1 + art_cos(turn) * d, ny = cy + 1 + art_sin(turn) * d;
        if (t > 0.38)
            paint_limb(p, NIGHT, px, py, 0.8, nx, ny, 0.8);
        px = nx;
        py = ny;
    }
    paint_ball(p, SOUL, cx + 1, cy + 1, r * 0.16, r * 0.16, 0);
    paint_ball(p, LAMP, cx - r * 0.42, cy - r * 0.6, r * 0.18, r * 0.07, -0.1);
}

/* Where its shell breaks: x, y, direction, length. */
static const double SHELL[][4] = { { -22, -29, 0.20, 22 }, { 8, -26, 0.32, 18 },  { -33, -2, 0.95, 16 },
                                   { -14, -8, 0.10, 20 },  { -26, 10, 0.86, 17 }, { 6, -12, 0.55, 18 } };

static void lantern(struct sheet *s, int x, int y, struct state now)
{
    struct paint *p = paint_new(84, 80);
    double frame = now.frame, k = art_sway(frame, 0), swing = art_sway(frame, 0.2) * 1.6;
    double wild = now.attack ? 5 : 0;

    for (int i = 0; i < 9; i++) {
        double sway = art_sway(frame, i * 0.13), bx = 33.0 - i * 5.0, by = 20.0 + i * 2.0 + (i % 3) * 3;
        double a[2] = { 15.0 - i * 1.4, 12.0 + i * 0.6 }, c[2] = { 27.0 - i * 2.4, 17.0 + i + 2 * sway },
               b[2] = { bx + sway * (2.2 + wild * 0.3) + wild * (0.8 - 0.2 * i), by + 6.0 - sway * 1.6 - wild };
        paint_curve(p, i % 2 ? PANE : FLESH, a, c, b, 2.9, 0.8);
    }
    shell(p, -8, -8, 28 + 0.4 * k);
    paint_cracks(p, now.wounds, SOUL, SHELL, 5);
    if (now.attack)
        paint_ball(p, SOUL, -7, -7, 7.5 + k, 7.5 + k, 0);
    paint_ball(p, (struct mat){ GLASS, 3, 8, 0.1 }, 11.5, 9.0, 13.5, 8.6, 0.09);
    for (int i = 0; i < 4; i++)
        paint_ball(p, SILVER, 4.0 + 6.0 * i, 3.0 + 1.6 * i, 1.4, 1.4, 0);
    paint_ball(p, LAMP, 15.6, 9.4, 4.6, 4.6, 0);
    if (now.attack)
        paint_ball(p, FLESH, 16, 9.8, 3.9, 3.9, 0);
    paint_ball(p, NIGHT, 16.6, 10.2, now.attack ? 1.2 : 2.7, 2.7, 0);
    paint_ball(p, LAMP, 15.4, 8.8, 1.0, 1.0, 0);
    double a[2] = { 8, 16 }, c[2] = { -2 + swing, 17 }, b[2] = { -3 + swing, 20 };
    paint_curve(p, FLESH, a, c, b, 2.2, 1.4);
    lamp(p, -3 + swing, 29, now.attack ? 7.4 : 6.2, now.attack ? 3 + k : k - 2.5 * now.wounds);
    paint_done(p, s, x, y, 1, 2);
}

struct sheet art_lantern_nautilus(void)
{
    struct sheet s = sheet_new(84 * BOSS_FRAMES, 80 * BOSS_ROWS, 12);

    art_boss(&s, 84, 80, lantern);
    return s;
}

/* -- the Chandelier Crab: its shell with the chandelier on it, and a claw, which is a part of its own -- */

static void legs(struct paint *p, double frame, bool up)
{
    for (int i = 0; i < 3; i++) {
        double k = art_sway(frame, i * 0.33) * 2.0, kx = 47 - i * 4.0, ky = -20.0 + i * 12.0 + k - (up ? 5 : 0);
        double a[2] = { 24, -6.0 + i * 5.5 }, c[2] = { 38, ky - 5 }, b[2] = { kx, ky };
        paint_curve(p, PANE, a, c, b, 3.6, 2.6);
        paint_limb(p, PANE, kx, ky, 2.6, kx + 7.4 - i * 2.0, ky + 13.0 - k, 0.8);
        paint_ball(p, SILVER, kx, ky, 2.2, 2.2, 0);
    }
}

/* A lamp of the chandelier; one that is out is a wick. */
static void flame(struct paint *p, double x, double y, double r, double tall, struct state now, bool out)
{
    if (now.attack)
        tall += 2.4;
    if (out) {
        paint_ball(p, (struct mat){ MATTE, 2, 4, 0 }, x, y, r, tall, 0);
        return;
    }
    paint_ball(p, SOUL, x, y - (now.attack ? 1.6 : 0), now.attack ? r + 0.6 : r, tall, 0);
    paint_ball(p, LAMP, x, y + 1, r * 0.4, tall * 0.45, 0);
}

/* Six arms of silver, a lamp on each, and a seventh on the stem. */
static void candelabra(struct paint *p, struct state now)
{
    static const double tips[3][2] = { { 12.5, -29 }, { 25.5, -24.5 }, { 36, -15 } };

    paint_limb(p, SILVER, 0, -10, 2.2, 0, -30, 1.5);
    for (int i = 2; i >= 0; i--) {
        double tx = tips[i][0], ty = tips[i][1], tall = 4.2 + 0.5 * art_sway(now.frame, 0.3 * i);
        double a[2] = { 1, -12 }, c[2] = { tx * 0.95, -6 - 1.5 * i }, b[2] = { tx, ty + 5 };
        paint_mirror(p, true);
        paint_curve(p, SILVER, a, c, b, 1.7, 1.3);
        paint_limb(p, SILVER, tx - 2.6, ty + 4.6, 1.2, tx + 2.6, ty + 4.6, 1.2);
        paint_mirror(p, false);
        flame(p, tx, ty - 0.4, 2.7, tall, now, now.wounds > 2 - i);
        flame(p, -tx, ty - 0.4, 2.7, tall, now, now.wounds && i == 1 + now.wounds % 2);
    }
    paint_limb(p, SILVER, -3, -30, 1.3, 3, -30, 1.3);
    flame(p, 0, -35, 3.0, 4.6 + 0.5 * art_sway(now.frame, 0.5), now, false);
}

/* Drops of cut glass that hang from the rim of its shell. */
static void pendants(struct paint *p, double frame)
{
    for (int i = 0; i < 4; i++) {
        double x = 4.5 + 8.4 * i, y = 20.5 - i * i * 1.1, sway = art_sway(frame, 0.12 * i) * 1.1,
               long_one = i % 2 ? 9 : 12;
        double drop[] = { x,
                          y,
                          x + 2.7 + sway * 0.5,
                          y + long_one * 0.62,
                          x + sway,
                          y + long_one,
                          x - 2.7 + sway * 0.5,
                          y + long_one * 0.62 };
        paint_poly(p, (struct mat){ GLASS, 3, 8, 0.16 }, 4, drop, 1.7);
        paint_ball(p, SILVER, x, y, 1.5, 1.5, 0);
    }
}

static const double CARAPACE[][4] = { { -26, -6, 0.06, 20 }, { 27, 12, 0.56, 16 }, { 14, -10, 0.22, 18 },
                                      { -12, 20, 0.72, 15 }, { 30, 0, 0.48, 16 },  { -31, 8, 0.98, 18 } };

static void crab(struct sheet *s, int x, int y, struct state now)
{
    static const double spike[] = { 29, -7, 40, -8.5, 33.5, 1.5 };
    struct paint *p = paint_new(112, 88);
    double frame = now.frame, k = art_sway(frame, 0) * 0.7, glare = now.attack ? 2 : 0,
           arm[3][2] = { { 24, 9 }, { 38, 6 }, { 43, 17 } };

    paint_mirror(p, true);
    legs(p, frame, now.attack);
    paint_curve(p, PANE, arm[0], arm[1], arm[2], 4.6, 4.0);
    paint_ball(p, SILVER, arm[2][0], arm[2][1], 3.4, 3.4, 0);
    paint_poly(p, SILVER, 3, spike, 2);
    pendants(p, frame);
    paint_mirror(p, false);
    paint_ball(p, PANE, 0, 4 + k * 0.3, 33, 19.5, 0);
    paint_mirror(p, true);
    for (int i = 0; i < 3; i++) {
        double a[2] = { 3.0 + 7 * i, -14.0 + 2 * i }, c[2] = { 14.0 + 8 * i, -8.0 + i },
               b[2] = { 12.0 + 8.5 * i, 19 - 4.5 * i };
        paint_curve(p, (struct mat){ VEIL, 2, 8, 0.22 - 0.05 * i }, a, c, b, 0.8, 0.6);
    }
    paint_limb(p, PANE, 8.6, 17, 2.2, 10.6, 24.6 + k, 1.8);
    paint_ball(p, LAMP, 10.8, 27 + k, 3.6, 3.6, 0);
    paint_ball(p, NIGHT, 10.9, 28.2 + k, 1.9, 1.9, 0);
    if (now.attack) /* its lids come down */
        paint_limb(p, PANE, 5.6, 26.4 + k, 1.9, 15, 22.4 + k, 1.9);
    paint_mirror(p, false);
    paint_cracks(p, now.wounds, SOUL, CARAPACE, 21);
    candelabra(p, now);
    paint_ball(p, SILVER, 0, 4.6, 12, 9.4, 0);
    paint_ball(p, NIGHT, 0, 4.6, 10, 7.6, 0);
    paint_ball(p, FLESH, 0, 4.6, 9, 6.8, 0);
    paint_ball(p, SOUL, 0, 4.6, 7.0 + glare + k * 0.6, 5.2 + glare * 0.8 + k * 0.6, 0);
    if (now.attack)
        paint_ball(p, LAMP, 0, 4.6, 4.4 + k, 3.4 + k, 0);
    paint_ball(p, LAMP, -15, -6, 6, 1.6, -0.06);
    paint_done(p, s, x, y, 1, 2);
}

/* The right one; the left one is this, turned over. Its joint is at the top left. */
static void claw(struct sheet *s, int x, int y, double frame)
{
    static const double out[] = { -8, -15, 6, -18, 14, -6, 12, 11, 3, 26, 2.6, 13, -1, 4, -9, 2 };
    static const double in[] = { -11, -6, -1, 2, -2, 13, -8, 24, -14, 11 };
    struct paint *p = paint_new(48, 64);
    double open = 1.5 + 1.5 * art_sway(frame, 0.4), outer[16], inner[10];

    for (int i = 0; i < 16; i++)
        outer[i] = out[i] + (i == 8 ? open * 1.6 : i == 10 ? open : 0);
    for (int i = 0; i < 10; i++)
        inner[i] = in[i] - (i == 6 || i == 8 ? open * 1.6 : i == 4 ? open : 0);
    paint_limb(p, PANE, -9, -24, 4.4, -4, -14, 5.4);
    paint_ball(p, SILVER, -9, -25, 3.6, 3.6, 0);
    paint_poly(p, (struct mat){ GLASS, 2, 8, 0.02 }, 5, inner, 4.6);
    paint_poly(p, (struct mat){ GLASS, 2, 8, 0.12 }, 8, outer, 6.5);
    paint_ball(p, SILVER, -1, -9, 6.4, 4.6, 0);
    paint_ball(p, NIGHT, -1, -9, 4.6, 3.2, 0);
    paint_ball(p, SOUL, -1, -9, 3.8, 2.6, 0);
    for (int i = 0; i < 3; i++)
        paint_ball(p, (struct mat){ MATTE, 9, 11, 0.2 }, 3.8 + 0.6 * i, 10.0 - 4 * i + 0.5 * open, 1.5, 1.5, 0);
    paint_ball(p, LAMP, 6, -12, 2.2, 1.0, 0.1);
    paint_done(p, s, x, y, 1, 2);
}

struct sheet art_crab(void)
{
    struct sheet s = sheet_new(112 * BOSS_FRAMES, 88 * BOSS_ROWS + 64, 12);

    art_boss(&s, 112, 88, crab);
    for (int i = 0; i < BOSS_FRAMES; i++)
        claw(&s, 48 * i, 88 * BOSS_ROWS, i * 4.0 / BOSS_FRAMES);
    return s;
}

/* -- its face, so near that the shell fills the picture -- */

static void stalk(struct paint *p, double x, double lean, double lid)
{
    double a[2] = { x * 0.7, 12 }, c[2] = { x * 0.9, 2 }, b[2] = { x + lean, -6 };
    paint_curve(p, PANE, a, c, b, 4.4, 3.4);
    paint_ball(p, SILVER, x + lean, -9, 9.4, 9.4, 0);
    paint_ball(p, NIGHT, x + lean, -9, 7.8, 7.8, 0);
    paint_ball(p, (struct mat){ GLOW, 12, 15, 0.2 }, x + lean, -9, 7, 7, 0);
    paint_ball(p, NIGHT, x + lean + 1.4, -8, 3.2, 4.2, 0);
    paint_ball(p, LAMP, x + lean - 1.6, -11, 1.8, 1.8, 0);
    if (lid > 0) {
        paint_band(p, -1e9, -9 - 5 + 6 * lid);
        paint_ball(p, PANE, x + lean, -9, 10, 10, 0);
        paint_band(p, -1e9, 1e9);
    }
}

static void jaws(struct paint *p, bool cross)
{
    double gape = cross ? 3.5 : 0;
    double jaw[] = { 1.2 + gape, 22, 8 + gape, 20, 11 + gape, 27, 7 + gape, 36, 1.8 + gape, 40 + gape };

    paint_ball(p, NIGHT, 0, 29, 9, 9, 0);
    if (cross)
        paint_ball(p, SOUL, 0, 30, 4, 6, 0);
    paint_mirror(p, true);
    paint_poly(p, (struct mat){ GLASS, 3, 8, 0.1 }, 5, jaw, 3);
    for (int i = 0; i < 3; i++)
        paint_ball(p, SILVER, 14.5 + 5.6 * i, 33 - 2.4 * i, 1.9, 1.9, 0);
    paint_mirror(p, false);
}

static void crab_face(struct sheet *s, int x, bool cross)
{
    static const double brow[] = { -4, 7, -30, 1, -34, 12, -24, 11, -4, 15 };
    struct paint *p = paint_new(72, 96);

    paint_mirror(p, true);
    for (int i = 2; i >= 0; i--) {
        double tx = 11.0 + 10.0 * i, ty = -35 + 5.0 * i + i * i;
        double a[2] = { 2, -10 }, c[2] = { tx, -6 }, b[2] = { tx, ty + 6 };
        paint_curve(p, SILVER, a, c, b, 2.4, 1.8);
        paint_limb(p, SILVER, tx - 3.4, ty + 6, 1.6, tx + 3.4, ty + 6, 1.6);
        paint_ball(p, SOUL, tx, ty - 1, 3.6, 6, 0);
        paint_ball(p, LAMP, tx, ty + 1, 1.5, 2.6, 0);
    }
    paint_mirror(p, false);
    paint_limb(p, SILVER, 0, -8, 3, 0, -36, 2);
    paint_ball(p, SOUL, 0, -41, 3.8, 6, 0);
    paint_ball(p, LAMP, 0, -39.5, 1.6, 2.6, 0);
    paint_ball(p, PANE, 0, 28, 35, 30, 0);
    paint_mirror(p, true);
    for (int i = 0; i < 3; i++) {
        double a[2] = { 6.0 + 8 * i, 1.0 + 3 * i }, c[2] = { 18.0 + 7 * i, 10 }, b[2] = { 17.0 + 7 * i, 46 };
        paint_curve(p, (struct mat){ VEIL, 2, 8, 0.2 - 0.05 * i }, a, c, b, 1, 0.7);
    }
    paint_poly(p, SILVER, 5, brow, 3);
    paint_mirror(p, false);
    stalk(p, -15, cross ? 2 : -1, cross ? 0.9 : 0);
    stalk(p, 15, cross ? -2 : 1, cross ? 0.9 : 0);
    jaws(p, cross);
    paint_ball(p, LAMP, -20, 18, 4, 1.6, -0.1);
    paint_done(p, s, x, 0, 1, 2);
}

static void crab_face_near(struct sheet *s)
{
    crab_face(s, 0, true);
}

struct sheet art_crab_face(void)
{
    struct sheet s = sheet_new(CUT_W, 96 + CUT_H, 12);

    crab_face(&s, 0, false);
    crab_face(&s, 72, true);
    art_cut_in(&s, 96, crab_face_near, 0, -8, 2);
    return s;
}
