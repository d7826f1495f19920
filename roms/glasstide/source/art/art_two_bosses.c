/*
 * art_two_bosses.c - who runs the drowned glassworks: the Bellows, a ray that breathes; Cinder and Quench, eels of the
 * furnace; and the faces of these two, calm and angry. Bank 12, and Quench in the steel of bank 11.
 */
#include "art.h"

#include <math.h>

/* Bank 12: 2..8 iron, 9..11 brass, 12..13 fire. */
static const struct mat IRON = { MATTE, 2, 8, 0.02 }, SKIN = { VEIL, 2, 7, 0.04 }, LEATHER = { MATTE, 2, 5, 0.05 },
                        BRASS = { MATTE, 9, 11, 0.12 }, FIRE = { GLOW, 12, 15, 0 }, EMBER = { MATTE, 12, 13, 0.15 },
                        NIGHT = { FLAT, 1, 1, 0 }, LAMP = { FLAT, 15, 15, 0 };

/* -- the Bellows -- */

static void bellows_wings(struct paint *p, double k, double lift)
{
    double wing[] = { 3,      33,
                      17,     30,
                      31,     21 + lift * 0.3,
                      45,     12 + lift * 0.7,
                      54 - k, 2 + lift,
                      42,     -9 + lift * 0.6,
                      30,     -17 + lift * 0.2,
                      17,     -24,
                      4,      -27 };
    double back[] = { 10, -20, 19, -31 - k, 14, -36 - k, 4, -30 };
    paint_mirror(p, true);
    paint_fin(p, LEATHER, 4, -14, 4, back, 0.08);
    paint_fin(p, SKIN, 2, 0, 9, wing, 0.07);
    for (int i = 2; i < 7; i++)
        paint_ball(p, BRASS, wing[2 * i] - 1.2, wing[2 * i + 1], 2, 2, 0);
    for (int i = 0; i < 3; i++) {
        double x = 19 + 9 * i;
        paint_bow(p, LEATHER, x, -14 + 6 * i + lift * 0.3, x + 6, 2 + lift * 0.4, x - 3, 22 - 4 * i + lift * 0.3, 1.3,
                  1.0);
    }
    paint_mirror(p, false);
}

/* Folds of leather between hoops of brass: full is how wide they are blown up. */
static void bellows_body(struct paint *p, double full, double k)
{
    for (int i = 0; i < 8; i++) {
        double v = (i - 3.5) / 4.4, wide = full * (1 - v * v * 0.55), y = -19 + i * 5.6 * (1 + 0.03 * k);
        paint_ball(p, i % 2 ? LEATHER : IRON, 0, y, wide - (i % 2 ? 2 : 0), 4.8, 0);
    }
    for (int i = 0; i < 8; i += 2) {
        double v = (i - 3.5) / 4.4, wide = full * (1 - v * v * 0.55), y = -19 + i * 5.6 * (1 + 0.03 * k);
        paint_bow(p, BRASS, -wide + 1.6, y + 1, 0, y + 4, wide - 1.6, y + 1, 0.9, 0.9);
    }
    paint_limb(p, IRON, 0, -24, 4.6, 0, 20, 5.6);
    paint_ball(p, BRASS, 0, -8, 6.4, 8.6, 0);
    paint_ball(p, NIGHT, 0, -8, 5, 7.2, 0);
    paint_ball(p, FIRE, 0, -8, 4.4, 6.4 + k * 0.5, 0);
    paint_ball(p, BRASS, 0, 11, 4, 3.4, 0);
}

/* Where leather and skin tear: x, y, direction, length. */
static const double TEARS[][4] = { { -14, -8, 0.24, 18 }, { 30, -12, 0.22, 22 }, { -34, 2, 0.2, 18 },
                                   { 15, 2, 0.3, 16 },    { 44, -4, 0.33, 14 },  { -24, -16, 0.17, 24 } };

static void bellows(struct sheet *s, int x, int y, struct state now)
{
    struct paint *p = paint_new(116, 96);
    double frame = now.frame, k = art_sway(frame, 0), l = art_sway(frame, 0.25), lift = l * 6, roar = 0;
    if (now.attack) {
        lift = 5 + l * 2;
        roar = 2;
    }
    for (int i = 8; i >= 0; i--)
        paint_ball(p, i % 2 ? BRASS : IRON, art_sway(frame, 0.08 * i) * 0.5 * i, -27 - 2.3 * i, 3.4 - 0.3 * i, 2.2, 0);
    bellows_wings(p, k, lift);
    bellows_body(p, 18 + 3.4 * k + 2 * roar, k + roar);
    paint_cracks(p, now.wounds, FIRE, TEARS, 40);
    paint_mirror(p, true);
    paint_bow(p, IRON, 6, 22, 17, 30, 10, 41 + l, 3.6, 1.4);
    paint_ball(p, BRASS, 10.2, 40 + l, 1.8, 1.8, 0);
    paint_ball(p, IRON, 10.6, 20, 5, 5, 0);
    paint_ball(p, LAMP, 11, 21.4, 3.2, 3.2, 0);
    if (!now.attack)
        paint_ball(p, EMBER, 11.2, 22, 2.4, 2.4, 0);
    paint_ball(p, NIGHT, 11.2, 22.6, 1.2, 1.4, 0);
    paint_mirror(p, false);
    paint_limb(p, IRON, 0, 20, 7.6, 0, 30, 5);
    paint_ball(p, BRASS, 0, 31, 7.4, 3.8, 0);
    paint_ball(p, NIGHT, 0, 32.4 + roar, 5.2 + roar, 2.4 + 1.6 * roar, 0);
    paint_ball(p, FIRE, 0, 32.6 + roar, 3.6 + k * 0.6 + roar, 1.6 + 1.5 * roar, 0);
    paint_done(p, s, x, y, 1, 2);
}

struct sheet art_two_bellows(void)
{
    struct sheet s = sheet_new(116 * BOSS_FRAMES, 96 * BOSS_ROWS, 12);

    art_boss(&s, 116, 96, bellows);
    return s;
}

/* -- the eels -- */

/* Of what an eel is made: iron and fire, or steel and pale brass. */
struct eel {
    struct mat hide, plate, ring, glow, coal, fin;
    double side; /* where its coils begin: 1 or -1 */
};

static const struct eel CINDER = { { MATTE, 2, 6, 0.02 },
                                   { MATTE, 3, 8, 0.1 },
                                   { MATTE, 9, 11, 0.12 },
                                   { GLOW, 12, 15, 0 },
                                   { MATTE, 12, 13, 0.2 },
                                   { MATTE, 12, 14, 0.05 },
                                   1 };
static const struct eel QUENCH = { { MATTE, 2, 8, 0.02 },
                                   { MATTE, 4, 9, 0.16 },
                                   { MATTE, 10, 13, 0.08 },
                                   { GLOW, 11, 15, 0 },
                                   { MATTE, 10, 13, 0.12 },
                                   { VEIL, 3, 9, 0.08 },
                                   -1 };

/* Where its body is, t from the tail, 0, to the neck, 1; and how thick. */
static void spine(const struct eel *e, double frame, double t, double *x, double *y, double *r)
{
    double coil = 0.06 + 1.02 * t;
    *x = e->side * (27 - 12 * t) * art_sin(coil + 0.035 * art_sway(frame, -t)) + 1.6 * art_sway(frame, 0.3 - t);
    *y = -37 + 46 * t + 7 * art_sin(2 * coil + 0.2) * (1 - t);
    *r = 2.6 + 7.4 * t * (2 - t);
}

/* Fins that stand off the body on both sides: Cinder's are flames. */
static void eel_fins(struct paint *p, const struct eel *e, double frame, double bristle)
{
    for (int i = 1; i < 9; i++) {
        double t = i / 9.0, x, y, r, nx, ny, nr;
        spine(e, frame, t, &x, &y, &r);
        spine(e, frame, t + 0.05, &nx, &ny, &nr);
        double dx = nx - x, dy = ny - y, len = sqrt(dx * dx + dy * dy) + 0.01;
        double far = r + 4 + bristle + 3 * (i % 2) + 1.6 * art_sway(frame, 0.37 * i);
        dx /= len;
        dy /= len;
        for (int side = -1; side <= 1; side += 2) {
            double sx = side * -dy, sy = side * dx;
            double tip[] = { x + dx * 3, y + dy * 3, x + sx * far - dx * 4, y + sy * far - dy * 4,
                             x - dx * 3, y - dy * 3 };
            paint_fin(p, e->fin, x, y, 3, tip, 0.05);
        }
    }
}

static void eel_body(struct paint *p, const struct eel *e, double frame)
{
    enum { PIECES = 40 };
    double px, py, pr;
    spine(e, frame, 0, &px, &py, &pr);
    for (int i = 1; i <= PIECES; i++) {
        double t = (double)i / PIECES, x, y, r;
        spine(e, frame, t, &x, &y, &r);
        bool ring = i % 8 == 0, crack = i % 8 == 4;
        paint_limb(p,
                   ring        ? e->ring
                   : crack     ? e->coal
                   : i % 4 < 2 ? e->hide
                               : e->plate,
                   px, py, ring ? pr + 0.9 : pr, x, y, ring ? r + 0.9 : r);
        px = x;
        py = y;
        pr = r;
    }
}

/* Its head breaks, and what it is filled with shows. */
static void eel_cracks(struct paint *p, const struct eel *e, struct state now)
{
    static const double at[][4] = { { -12, -8, 0.11, 15 }, { 11, 7, 0.72, 13 },  { -5, 14, 0.68, 12 },
                                    { 4, -12, 0.2, 14 },   { -13, 3, 0.02, 12 }, { 8, 15, 0.7, 12 } };
    paint_cracks(p, now.wounds, e->glow, at, 61);
    if (now.wounds > 1) /* an eye is out */
        paint_ball(p, NIGHT, -7.6, 1.8, 3.6, 3, 0);
}

static void cinder_head(struct paint *p, struct state now)
{
    static const double jaw[] = { -8, 4, -9, 13, -4.6, 21, 4.6, 21, 9, 13, 8, 4 };
    static const double horn[] = { 7, -9, 15, -17, 20, -27, 12, -21, 3, -12 };
    static const double brow[] = { 2, -5, 12.6, -9, 16, -2, 10, -1.4, 3, 1 };
    double k = art_sway(now.frame, 0), gape = 1 + k, roar = now.attack ? 2.2 : 0;
    paint_mirror(p, true);
    paint_poly(p, CINDER.ring, 5, horn, 1.6);
    paint_bow(p, CINDER.fin, 9, 2, 18, 1 + k, 19 + k, 9, 3.4, 0.6);
    paint_bow(p, CINDER.fin, 8, 6, 15, 9, 15 + k, 16, 2.8, 0.5);
    paint_mirror(p, false);
    paint_ball(p, CINDER.hide, 0, -2, 13.6, 12, 0);
    paint_poly(p, CINDER.plate, 6, jaw, 3);
    paint_ball(p, NIGHT, 0, 12.6 + roar * 0.6, 5.6 + roar, 6.4 + gape * 0.5 + roar, 0);
    paint_ball(p, FIRE, 0, 13 + roar * 0.6, 4.6 + roar, 5.2 + gape * 0.5 + roar, 0);
    for (int i = -1; i <= 1 && !now.attack; i++)
        paint_limb(p, CINDER.ring, i * 3.4, 6.6, 0.8, i * 3, 18.6, 0.7);
    if (now.attack)
        paint_ball(p, LAMP, 0, 15, 3 + 0.6 * k, 4 + k, 0);
    paint_mirror(p, true);
    paint_ball(p, NIGHT, 8, 1, 3.6, 3, 0.05);
    paint_ball(p, LAMP, 7.8, 1.4, 2.3 + roar * 0.3, 1.8 + roar * 0.2, 0.05);
    paint_poly(p, CINDER.plate, 5, brow, 1.8);
    paint_mirror(p, false);
    paint_ball(p, CINDER.ring, 0, -7, 3.8, 4.6, 0);
    paint_ball(p, FIRE, 0, -7, 2.4, 3, 0);
    eel_cracks(p, &CINDER, now);
}

static void quench_head(struct paint *p, struct state now)
{
    static const double crest[] = { -3, -2, -6, -16, 0, -29, 6, -16, 3, -2 };
    static const double snout[] = { -9, 2, -7.4, 12, -3.2, 22, 3.2, 22, 7.4, 12, 9, 2 };
    double k = art_sway(now.frame, 0), l = art_sway(now.frame, 0.25), hiss = now.attack ? 3 : 0;
    double veil[] = { 9, -9, 19 + hiss, -13 - k * 2 - hiss, 22 + 2 * hiss, -3 - k * 2 - hiss, 17 + hiss, 7 - k, 9, 6 };
    double vent[] = { 8, 4, 14, 8 + l, 15, 16 + l * 2, 10, 13, 6, 9 };
    paint_mirror(p, true);
    paint_fin(p, QUENCH.fin, 5, -1, 5, veil, 0.14);
    paint_fin(p, QUENCH.fin, 4, 5, 5, vent, 0.1);
    paint_mirror(p, false);
    paint_poly(p, QUENCH.fin, 5, crest, 2.4);
    paint_ball(p, QUENCH.hide, 0, -1, 11.6, 11.6, 0);
    paint_poly(p, QUENCH.plate, 6, snout, 3.4);
    paint_limb(p, QUENCH.plate, 0, -9, 2.6, 0, 18, 1.6);
    paint_mirror(p, true);
    paint_ball(p, NIGHT, 6.6, 2.4, 3.4, 2.6, -0.09);
    paint_ball(p, LAMP, 6.8, 2.6, 2.2 + hiss * 0.3, 1.5 + hiss * 0.3, -0.09);
    paint_limb(p, NIGHT, 1.6, 18.4, 0.7, 4.6, 12.6, 0.7);
    paint_ball(p, QUENCH.ring, 9.6, -4.6, 1.8, 1.8, 0);
    paint_mirror(p, false);
    paint_ball(p, QUENCH.ring, 0, -8.4, 3, 3.6, 0);
    paint_ball(p, QUENCH.glow, 0, -8.4, 1.9 + hiss * 0.3, 2.3 + hiss * 0.3, 0);
    if (now.attack) { /* its snout opens */
        paint_ball(p, NIGHT, 0, 16.6, 4.2, 5, 0);
        paint_ball(p, QUENCH.glow, 0, 17, 3 + 0.4 * k, 3.8 + 0.4 * k, 0);
    }
    eel_cracks(p, &QUENCH, now);
}

static void eel(struct sheet *s, int x, int y, const struct eel *e, struct state now,
                void (*head)(struct paint *, struct state))
{
    struct paint *p = paint_new(84, 92), *h = paint_new(84, 56);
    eel_fins(p, e, now.frame, now.attack ? 3 : 0);
    eel_body(p, e, now.frame);
    double body[6][4];
    for (int i = 0; i < 6; i++) {
        double r;
        spine(e, now.frame, 0.2 + 0.11 * i, &body[i][0], &body[i][1], &r);
        body[i][0] -= r * 0.7;
        body[i][2] = 0.06;
        body[i][3] = r * 1.6;
    }
    paint_cracks(p, now.wounds, e->glow, body, 11);
    paint_done(p, s, x, y, 1, 2);
    head(h, now);
    paint_done(h, s, x, y + 36, 1, 2);
}

static void cinder(struct sheet *s, int x, int y, struct state now)
{
    eel(s, x, y, &CINDER, now, cinder_head);
}

static void quench(struct sheet *s, int x, int y, struct state now)
{
    eel(s, x, y, &QUENCH, now, quench_head);
}

struct sheet art_two_cinder(void)
{
    struct sheet s = sheet_new(84 * BOSS_FRAMES, 92 * BOSS_ROWS, 12);

    art_boss(&s, 84, 92, cinder);
    return s;
}

struct sheet art_two_quench(void)
{
    struct sheet s = sheet_new(84 * BOSS_FRAMES, 92 * BOSS_ROWS, 11);

    art_boss(&s, 84, 92, quench);
    return s;
}

/* -- their faces, looking right -- */

/* A neck that comes up from the lower left. */
static void neck(struct paint *p, const struct eel *e)
{
    for (int i = 0; i < 7; i++) {
        double t = i / 6.0, x = -26 + 18 * t * t, y = 50 - 38 * t;
        paint_limb(p, i % 2 ? e->plate : e->hide, x, y, 20 - 2 * t, x + 3, y - 5, 19 - 2 * t);
    }
    paint_bow(p, e->ring, -38, 36, -12, 46, 4, 30, 2.4, 2.4);
    paint_bow(p, e->coal, -36, 22, -12, 32, 6, 17, 1.4, 1.4);
}

static void cinder_mane(struct paint *p)
{
    static const double at[7][4] = { { -10, -26, -20, -44 }, { -16, -20, -32, -34 }, { -20, -12, -36, -20 },
                                     { -22, -2, -37, -4 },   { -23, 8, -37, 12 },    { -4, -28, -6, -47 },
                                     { 3, -28, 8, -44 } };
    for (int i = 0; i < 7; i++) {
        double wx = (at[i][0] + at[i][2]) * 0.5 + 3, wy = (at[i][1] + at[i][3]) * 0.5 + 3;
        paint_bow(p, CINDER.fin, at[i][0], at[i][1], wx, wy, at[i][2], at[i][3], 7, 0.8);
    }
}

static void cinder_face(struct sheet *s, int x, bool cross)
{
    static const double top[] = { -14, -18, 4, -22, 20, -14, 32, 0, 34, 8, 22, 9, 2, 8, -14, 6 };
    static const double low[] = { -12, 12, 6, 15, 20, 15, 27, 18, 22, 26, 8, 30, -8, 27, -15, 20 };
    static const double horn[] = { -4, -20, -2, -34, 8, -46, 8, -32, 7, -20 };
    struct paint *p = paint_new(72, 96);
    double open = cross ? 6 : 1;
    double jaw[16];
    for (int i = 0; i < 16; i++)
        jaw[i] = low[i] + (i % 2 ? open : 0);
    cinder_mane(p);
    neck(p, &CINDER);
    paint_ball(p, NIGHT, 8, 12 + open * 0.5, 20, 6 + open, 0);
    paint_ball(p, FIRE, 6, 12 + open * 0.5, 17, 4.6 + open, 0);
    paint_poly(p, CINDER.hide, 8, jaw, 4);
    paint_ball(p, CINDER.hide, -4, -4, 20, 19, 0);
    paint_poly(p, CINDER.plate, 8, top, 5);
    for (int i = 0; i < 4; i++) {
        double tx = 3 + 7 * i;
        double fang[] = { tx - 2.4, 7, tx + 2.4, 7, tx + 0.6, 14 + (i == 3 ? 2 : 0) };
        paint_poly(p, CINDER.ring, 3, fang, 1);
    }
    paint_poly(p, CINDER.ring, 5, horn, 2.4);
    paint_ball(p, NIGHT, 8, -5, 8, 6.4, 0.04);
    paint_ball(p, FIRE, 8.4, -4.6, 6.6, 5.2, 0.04);
    paint_ball(p, NIGHT, 10, -4.4, 1.6, 4.4, 0.04);
    paint_ball(p, LAMP, 6, -7, 1.6, 1.4, 0);
    double lid = cross ? 3.4 : 0;
    double brow[] = { -6, -12 + lid * 0.2, 8, -14 + lid, 20, -7 + lid * 1.1, 18, -3 + lid * 0.9, 7, -9 + lid, -5, -7 };
    paint_poly(p, CINDER.plate, 6, brow, 2);
    paint_ball(p, CINDER.ring, -12, -3, 5, 7, 0);
    paint_ball(p, FIRE, -12, -3, 3.2, 5, 0);
    paint_ball(p, NIGHT, 28.6, 1.6, 1.8, 1.2, 0.06);
    paint_done(p, s, x, 0, 1, 2);
}

static void quench_face(struct sheet *s, int x, bool cross)
{
    static const double top[] = { -14, -16, 2, -20, 16, -13, 28, -2, 35, 9, 26, 10, 4, 9, -14, 8 };
    static const double low[] = { -12, 11, 6, 12, 22, 12, 31, 12, 24, 19, 8, 24, -8, 23, -15, 18 };
    double crest[] = { -6, -16, -2, -34, -14, -47, -24, -40, -30, -28, -33, -14, -32, 2, -22, 8 };
    double vent[] = { -14, 18, -22, 30, -20, 40, -8, 36, 0, 26 };
    struct paint *p = paint_new(72, 96);
    paint_fin(p, QUENCH.fin, -8, -2, 8, crest, 0.12);
    neck(p, &QUENCH);
    paint_fin(p, QUENCH.fin, -8, 14, 5, vent, 0.1);
    paint_poly(p, QUENCH.hide, 8, low, 4);
    paint_ball(p, QUENCH.hide, -4, -3, 18, 17, 0);
    paint_poly(p, QUENCH.plate, 8, top, 6);
    paint_bow(p, NIGHT, -6, 11, 14, cross ? 14 : 8.6, 33, 10, 0.8, 0.6);
    paint_bow(p, QUENCH.plate, -10, -15, 8, -16, 30, 3, 1.6, 1.0);
    paint_ball(p, NIGHT, 9, -3.4, 7.6, cross ? 3.4 : 5, 0.06);
    paint_ball(p, QUENCH.glow, 9.4, -3.2, 6.2, cross ? 2.6 : 4, 0.06);
    paint_ball(p, NIGHT, 11, -3, 1.3, cross ? 2.4 : 3.4, 0.06);
    paint_ball(p, LAMP, 7, -5, 1.3, 1, 0);
    paint_limb(p, QUENCH.plate, -1, cross ? -7 : -9, 1.8, 17, cross ? -4.6 : -4, 1.4);
    for (int i = 0; i < 3; i++)
        paint_bow(p, NIGHT, -15 + 4 * i, -4, -12 + 4 * i, 3, -15 + 4 * i, 10, 0.6, 0.6);
    paint_ball(p, QUENCH.ring, -9, -13, 3, 3, 0);
    paint_ball(p, QUENCH.ring, -17, -10, 2.4, 2.4, 0);
    paint_ball(p, NIGHT, 29.6, 3.4, 1.4, 1, 0.08);
    paint_done(p, s, x, 0, 1, 2);
}

static void cinder_face_near(struct sheet *s)
{
    cinder_face(s, 0, true);
}

struct sheet art_two_cinder_face(void)
{
    struct sheet s = sheet_new(CUT_W, 96 + CUT_H, 12);

    cinder_face(&s, 0, false);
    cinder_face(&s, 72, true);
    art_cut_in(&s, 96, cinder_face_near, 4, 0, 2);
    return s;
}

static void quench_face_near(struct sheet *s)
{
    quench_face(s, 0, true);
}

struct sheet art_two_quench_face(void)
{
    struct sheet s = sheet_new(CUT_W, 96 + CUT_H, 11);

    quench_face(&s, 0, false);
    quench_face(&s, 72, true);
    art_cut_in(&s, 96, quench_face_near, 5, 0, 2);
    return s;
}
