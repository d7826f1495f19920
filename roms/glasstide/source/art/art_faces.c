/*
 * art_faces.c - who talks: the pilots of the three craft and the queen, each with two faces side by side. They look
 * right; a talk turns those round that stand on the right side.
 */
#include "art.h"

enum { FACE_W = 72, FACE_H = 96 };

/* What bank 8, the same in all stages, has of skin, hair and cloth. */
struct palette {
    int skin, shade, blush; /* of a face */
    int ink, white;         /* outlines, and what shines */
    struct mat hair, cloth, iris, scarf, metal;
};

static struct mat flat(int shade)
{
    return (struct mat){ FLAT, shade, shade, 0 };
}

/* A pen stroke from one place to another. */
static void line(struct paint *p, struct mat m, double ax, double ay, double bx, double by, double r)
{
    const double seg[] = { ax, ay, bx, by };
    paint_stroke(p, m, 1, seg, r, 0);
}

/* An eye r wide at (x, y); lid: how far it is shut, 0 to 1. */
static void eye(struct paint *p, const struct palette *c, double x, double y, double r, double lid)
{
    double tall = r * 1.45, top = y - tall + lid * 2 * r;
    double a[2] = { x - r - 0.8, top + 2.2 - lid }, m[2] = { x, top - 1.6 + lid }, b[2] = { x + r + 0.8, top + 1.6 };
    paint_band(p, top, 1e9);
    paint_ball(p, flat(c->ink), x, y, r + 0.3, tall + 0.3, 0);
    paint_ball(p, flat(c->white), x, y + 0.4, r - 0.3, tall - 0.4, 0);
    paint_ball(p, c->iris, x + 0.9, y + 0.5, r * 0.8, tall * 0.92, 0);
    paint_ball(p, flat(c->ink), x + 1.1, y + 0.2, r * 0.4, tall * 0.5, 0);
    paint_ball(p, flat(c->white), x - 0.4, y - 1.8, 1.2, 1.5, 0);
    paint_band(p, -1e9, 1e9);
    paint_curve(p, flat(c->ink), a, m, b, 0.9, 0.7);
}

static void mouth(struct paint *p, const struct palette *c, double x, double y, bool open)
{
    if (open) {
        paint_ball(p, flat(c->ink), x, y + 0.8, 3.4, 2.6, 0);
        paint_ball(p, flat(c->blush), x, y + 1.6, 2.3, 1.5, 0);
        return;
    }
    double a[2] = { x - 2.8, y - 0.2 }, m[2] = { x, y + 1.8 }, b[2] = { x + 2.8, y - 0.6 };
    paint_curve(p, flat(c->ink), a, m, b, 0.5, 0.5);
}

/* Head and neck, before what covers them. */
static void head(struct paint *p, const struct palette *c)
{
    paint_limb(p, flat(c->shade), 1, 12, 6.4, 0, 30, 7);
    paint_ball(p, flat(c->skin), -2.2, 24.5, 4.2, 5.5, 0);
    paint_ball(p, flat(c->shade), 3, 0, 17.5, 19, 0);
    paint_ball(p, flat(c->shade), 4.4, 12.5, 10.5, 9.4, 0);
    paint_ball(p, flat(c->skin), 1.6, -0.6, 16.8, 18.6, 0);
    paint_ball(p, flat(c->skin), 3.2, 11.4, 9.6, 8.8, 0);
}

static void features(struct paint *p, const struct palette *c, bool cross)
{
    double lid = cross ? 0.3 : 0;
    eye(p, c, -4.2, 4, 4.6, lid);
    eye(p, c, 11.6, 4, 3.9, lid);
    line(p, c->hair, -8.8, cross ? -5.6 : -5.4, 0.6, cross ? -2.4 : -6.4, 0.8);
    line(p, c->hair, 8.4, cross ? -2.6 : -6.4, 15.4, cross ? -5.6 : -5.2, 0.8);
    line(p, flat(c->shade), 5.4, 8.4, 6.2, 10.4, 0.6);
    paint_ball(p, flat(c->shade), -7.4, 11.6, 2.6, 1.1, 0);
    mouth(p, c, 4.4, 15.4, cross);
}

/* A white flight suit with a scarf. */
static void suit(struct paint *p, const struct palette *c)
{
    static const double body[] = { 0, 25, 9, 26, 20, 30, 29, 36, 33, 44, 34, 52, 0, 52 };
    static const double flap[] = { 3, 34, 13, 30, 17, 52, 6, 52 };
    paint_mirror(p, true);
    paint_poly(p, c->cloth, 7, body, 5);
    paint_poly(p, c->metal, 4, flap, 1.6);
    paint_mirror(p, false);
    paint_limb(p, c->scarf, -12, 29, 4.6, 1, 34.5, 5.4);
    paint_limb(p, c->scarf, 13, 28, 4.2, 1, 34.5, 5.4);
    paint_limb(p, c->scarf, 1, 35, 4.4, -6, 50, 5.6);
}

/* ---- the Heron's: a helmet, goggles pushed up ---- */

static const struct palette IRI = { 14,
                                    12,
                                    11,
                                    1,
                                    15,
                                    { MATTE, 10, 11, 0.05 },
                                    { MATTE, 3, 6, 0.22 },
                                    { GLASS, 7, 9, 0.15 },
                                    { MATTE, 10, 12, 0.12 },
                                    { MATTE, 2, 5, 0.1 } };

static void helmet(struct paint *p, const struct palette *c)
{
    static const double tuft[5][6] = { { -15, -12, -8, -12, -12.5, 0 },
                                       { -10, -12, -1, -12, -6.4, -3.6 },
                                       { -3, -12, 6, -12, 2.4, -4.2 },
                                       { 4, -12, 13, -12, 11.6, -4.4 },
                                       { 11, -12, 19, -12, 18.4, -0.6 } };
    for (int i = 0; i < 5; i++)
        paint_poly(p, c->hair, 3, tuft[i], 1.6);
    paint_band(p, -1e9, -9);
    paint_ball(p, c->cloth, 0, -9, 24, 27, 0);
    paint_band(p, -1e9, 1e9);
    double a[2] = { -22.4, -8.6 }, m[2] = { 1, -12 }, b[2] = { 23, -8.6 };
    paint_curve(p, c->metal, a, m, b, 2.0, 2.0);
    double s0[2] = { -3.4, -33.2 }, s1[2] = { -8, -26 }, s2[2] = { -8.6, -13 };
    paint_curve(p, c->scarf, s0, s1, s2, 1.6, 3.0);
    paint_ball(p, c->metal, -5.4, -17.4, 10.4, 7.6, -0.02);
    paint_ball(p, c->metal, 13.2, -17.0, 8.4, 7.2, 0.03);
    paint_ball(p, (struct mat){ GLASS, 7, 9, 0.1 }, -5.2, -17.4, 8.4, 5.7, -0.02);
    paint_ball(p, (struct mat){ GLASS, 7, 9, 0.1 }, 13.2, -17.0, 6.6, 5.4, 0.03);
    paint_ball(p, flat(15), -9, -19.6, 2.4, 1.0, -0.09);
    paint_ball(p, flat(15), 10.4, -19.2, 1.8, 0.9, -0.09);
}

static void ears(struct paint *p, const struct palette *c)
{
    paint_ball(p, c->cloth, -20, 2, 6.4, 13, 0.02);
    paint_ball(p, c->metal, -20.4, 2, 4.6, 7.6, 0.02);
    paint_ball(p, c->scarf, -20.6, 2, 2.6, 4.6, 0.02);
    double a[2] = { -19, 9 }, m[2] = { -14, 20 }, b[2] = { -3, 19.4 };
    paint_curve(p, c->metal, a, m, b, 1.1, 1.0);
    paint_ball(p, c->metal, -1.6, 19.4, 2.2, 1.7, 0);
}

static void iri(struct sheet *s, int x, bool cross)
{
    struct paint *p = paint_new(FACE_W, FACE_H);
    paint_ball(p, IRI.metal, 0, -4, 22, 24, 0);
    suit(p, &IRI);
    head(p, &IRI);
    features(p, &IRI, cross);
    helmet(p, &IRI);
    ears(p, &IRI);
    paint_done(p, s, x, 0, 1, 1);
}

struct sheet art_iri(void)
{
    struct sheet s = sheet_new(2 * FACE_W, FACE_H, 8);
    iri(&s, 0, false);
    iri(&s, FACE_W, true);
    return s;
}

/* ---- the Petrel's: an old navigator in a storm coat, a braid over her shoulder, a patch on one eye ---- */

static const struct palette SEN = { 14,
                                    12,
                                    11,
                                    1,
                                    15,
                                    { MATTE, 2, 6, 0.02 },
                                    { MATTE, 7, 9, 0.1 },
                                    { GLASS, 7, 9, 0.15 },
                                    { MATTE, 10, 12, 0.1 },
                                    { MATTE, 2, 5, 0.1 } };

/* A lock from a to b, pulled towards m. */
static void lock(struct paint *p, struct mat hair, double ax, double ay, double mx, double my, double bx, double by,
                 double r)
{
    double a[2] = { ax, ay }, m[2] = { mx, my }, b[2] = { bx, by };
    paint_curve(p, hair, a, m, b, r, 0.5);
}

/* The coat's wide shoulders, its flaps with buttons, and a collar that stands up round her jaw. */
static void storm_coat(struct paint *p, const struct palette *c)
{
    static const double body[] = { 0, 30, 10, 30, 24, 33, 34, 40, 36, 52, 0, 52 };
    static const double cape[] = { 9, 29, 22, 30, 35, 38, 36, 47, 22, 42, 10, 38 };
    static const double collar[] = { 5, 40, 8, 24, 17, 11, 24, 12, 22, 27, 12, 42 };
    const struct mat felt = { MATTE, 2, 4, 0.06 };

    paint_limb(p, flat(c->shade), 1, 12, 6, 0, 32, 6.4);
    paint_mirror(p, true);
    paint_poly(p, felt, 6, body, 4);
    paint_poly(p, c->cloth, 6, cape, 3);
    paint_poly(p, felt, 6, collar, 2.4);
    paint_limb(p, c->metal, 8, 39, 0.8, 21, 14, 0.8);
    paint_mirror(p, false);
    for (int i = 0; i < 2; i++) {
        paint_ball(p, flat(13), -5, 43.0 + 6 * i, 1.5, 1.5, 0);
        paint_ball(p, flat(13), 5, 43.0 + 6 * i, 1.5, 1.5, 0);
    }
    paint_poly(p, c->scarf, 4, (double[]){ -6, 33, 0, 41, 6, 33, 0, 36 }, 1);
}

/* Narrower than the others', with a long chin. */
static void old_face(struct paint *p, const struct palette *c, bool cross)
{
    paint_ball(p, flat(c->shade), 2.6, 0, 15.4, 18.6, 0);
    paint_ball(p, flat(c->shade), 4.6, 13.4, 8.8, 9.6, 0);
    paint_ball(p, flat(c->skin), 1.4, -0.4, 14.8, 18.2, 0);
    paint_ball(p, flat(c->skin), 3.6, 12.4, 8.2, 9.2, 0);
    eye(p, c, -3.4, 4.4, 3.8, cross ? 0.5 : 0.3);
    line(p, c->metal, -8.4, cross ? -2.2 : -3, 0.8, cross ? 0.4 : -3, 0.9);
    line(p, flat(c->shade), -9.6, 4, -7.6, 5.4, 0.5);
    line(p, flat(c->shade), -9.8, 7, -7.4, 7.2, 0.5);
    line(p, flat(c->ink), -13, -8, 19, 3, 0.8); /* the patch and its string */
    paint_ball(p, flat(c->ink), 11, 4.2, 4.8, 4.6, 0);
    paint_ball(p, c->metal, 10.4, 3.2, 3.2, 2.8, 0);
    line(p, flat(c->shade), 5, 6.4, 6.2, 10.6, 0.7);
    line(p, flat(c->shade), -2.6, 12.6, -0.8, 16.4, 0.5);
    line(p, flat(c->shade), 10.4, 12.4, 9.6, 16, 0.5);
    mouth(p, c, 4.4, 16.4, cross);
}

/* Combed back into a knot, and down in a braid over the shoulder. */
static void knot(struct paint *p, const struct palette *c)
{
    paint_ball(p, c->hair, -15, -22, 8.6, 8, 0.08);
    paint_ball(p, c->scarf, -11, -18.6, 3.6, 2.2, 0.1);
    paint_ball(p, c->hair, -3, -5, 19.4, 21, 0);
}

static void combed(struct paint *p, const struct palette *c)
{
    paint_band(p, -1e9, -9);
    paint_ball(p, c->hair, 0, -8, 18.6, 19, 0);
    paint_band(p, -1e9, 1e9);
    lock(p, c->hair, 12, -20, -6, -22, -16, -4, 5);
    lock(p, c->hair, 12, -20, 0, -16, -12, -9, 4);
    lock(p, c->hair, 10, -21, 18, -14, 17.6, -3, 4.6);
    lock(p, c->hair, -13, -9, -17, 2, -15, 12, 4.4);
    for (int i = 0; i < 6; i++)
        paint_ball(p, c->hair, -17 + (i % 2 ? 1.5 : -1.5) + 0.6 * i, 11 + 6.2 * i, 4.6 - 0.2 * i, 4.2,
                   i % 2 ? 0.1 : -0.1);
    paint_ball(p, c->scarf, -14, 46, 3.2, 2, 0);
    paint_ball(p, flat(13), -14.6, 9.4, 1.7, 2.2, 0); /* an earring */
}

static void sen(struct sheet *s, int x, bool cross)
{
    struct paint *p = paint_new(FACE_W, FACE_H);
    knot(p, &SEN);
    storm_coat(p, &SEN);
    old_face(p, &SEN, cross);
    combed(p, &SEN);
    paint_done(p, s, x, 0, 1, 1);
}

struct sheet art_sen(void)
{
    struct sheet s = sheet_new(2 * FACE_W, FACE_H, 8);
    sen(&s, 0, false);
    sen(&s, FACE_W, true);
    return s;
}

/* ---- the Tern's: a cap, curls, a bell at the collar ---- */

static const struct palette ONO = { 14,
                                    12,
                                    11,
                                    1,
                                    15,
                                    { MATTE, 1, 3, 0.12 },
                                    { MATTE, 2, 4, 0.12 },
                                    { GLASS, 7, 9, 0.15 },
                                    { MATTE, 13, 15, 0.02 },
                                    { MATTE, 10, 12, 0.02 } };

static void curls(struct paint *p, const struct palette *c)
{
    static const double at[9][3] = { { -18, -4, 6 },  { -19, 5, 5 },   { -15, -12, 7 }, { -7, -12, 6 }, { 1, -11.4, 6 },
                                     { 9, -11.6, 6 }, { 16, -9, 5.4 }, { 19, -1, 4.4 }, { -17, 12, 4 } };
    for (int i = 0; i < 9; i++)
        paint_ball(p, c->hair, at[i][0], at[i][1], at[i][2], at[i][2] * 0.92, 0);
}

/* A flat cap of felt with a brim that shades the brow. */
static void cap(struct paint *p, const struct palette *c)
{
    static const struct mat felt = { MATTE, 7, 9, -0.06 };
    double a[2] = { -12, -14.6 }, m[2] = { 8, -19.4 }, b[2] = { 25, -11.6 };
    paint_band(p, -1e9, -13);
    paint_ball(p, felt, -2, -16, 24.6, 17.4, -0.02);
    paint_band(p, -1e9, 1e9);
    paint_limb(p, felt, -22, -14, 3.2, 18, -15.2, 3.4);
    paint_curve(p, c->cloth, a, m, b, 2.4, 2.0);
    paint_ball(p, c->metal, -2, -33, 2.4, 1.8, 0);
    paint_ball(p, c->scarf, -15, -20, 3.4, 3.6, 0);
    paint_ball(p, flat(c->white), -16, -21.2, 1.0, 1.1, 0);
}

static void little_bell(struct paint *p, const struct palette *c)
{
    static const double skirt[] = { 2.6, 36, 5.4, 38.4, 7.4, 44, -2.2, 44, -0.2, 38.4 };
    paint_poly(p, c->scarf, 5, skirt, 1.6);
    paint_ball(p, flat(c->ink), 2.6, 45, 1.6, 1.4, 0);
}

static void ono(struct sheet *s, int x, bool cross)
{
    struct paint *p = paint_new(FACE_W, FACE_H);
    paint_ball(p, ONO.hair, -2, -4, 21, 21, 0);
    suit(p, &ONO);
    head(p, &ONO);
    features(p, &ONO, cross);
    curls(p, &ONO);
    cap(p, &ONO);
    little_bell(p, &ONO);
    paint_done(p, s, x, 0, 1, 1);
}

struct sheet art_ono(void)
{
    struct sheet s = sheet_new(2 * FACE_W, FACE_H, 8);
    ono(&s, 0, false);
    ono(&s, FACE_W, true);
    return s;
}

/* ---- the queen: so near that her bell fills the picture ---- */

static const struct mat PANE = { GLASS, 2, 8, 0 }, FILM = { VEIL, 2, 7, 0.05 }, GOLD = { MATTE, 9, 11, 0.12 },
                        NIGHT = { FLAT, 1, 1, 0 }, LAMP = { FLAT, 15, 15, 0 }, SOUL = { GLOW, 12, 15, 0.1 };

static void veils(struct paint *p)
{
    static const double low[] = { 22, 46, 31, 40, 34.5, 28, 33, 16 };
    static const double high[] = { 32, 14, 34.5, 0, 34, -16, 29, -27, 22, -22 };
    paint_mirror(p, true);
    paint_fin(p, FILM, 8, 14, 4, low, 0.14);
    paint_fin(p, FILM, 8, 4, 5, high, 0.12);
    for (int i = 1; i < 4; i++)
        paint_ball(p, GOLD, high[2 * i] - 1.5, high[2 * i + 1], 1.8, 1.8, 0);
    paint_mirror(p, false);
}

static void crown(struct paint *p)
{
    static const double side[] = { 5, -22, 14, -40, 18, -17 }, wide[] = { 16, -18, 27, -31, 24, -9 };
    static const double mid[] = { -7, -23, 0, -47, 7, -23 };
    paint_mirror(p, true);
    paint_poly(p, GOLD, 3, wide, 2.4);
    paint_poly(p, GOLD, 3, side, 2.6);
    paint_mirror(p, false);
    paint_poly(p, GOLD, 3, mid, 3);
    paint_ball(p, SOUL, 0, -30, 2.6, 3.8, 0);
}

static void bell(struct paint *p)
{
    static const double ribs[3][4] = { { 5, -26, 9, 30 }, { 14, -22, 20, 29 }, { 22, -14, 28, 26 } };
    paint_band(p, -1e9, 34);
    paint_ball(p, PANE, 0, 12, 30, 39, 0);
    paint_mirror(p, true);
    for (int i = 0; i < 3; i++) {
        double a[2] = { ribs[i][0], ribs[i][1] }, m[2] = { ribs[i][2] + 4, -4 }, b[2] = { ribs[i][2], ribs[i][3] };
        paint_curve(p, (struct mat){ VEIL, 2, 8, 0.2 - 0.04 * i }, a, m, b, 0.8, 0.8);
    }
    paint_mirror(p, false);
    paint_band(p, -1e9, 1e9);
    for (int i = -5; i <= 5; i++) {
        paint_ball(p, PANE, i * 5.6, 36 - i * i * 0.32, 4.4, 6.2, 0);
        paint_ball(p, GOLD, i * 5.6, 31.4 - i * i * 0.32, 2.1, 2.1, 0);
    }
    for (int i = 0; i < 4; i++)
        paint_limb(p, i % 2 ? PANE : (struct mat){ MATTE, 12, 13, 0.1 }, -16 + 10.6 * i, 40, 3.4, -18 + 12 * i, 56,
                   2.2);
}

static void gaze(struct paint *p, bool cross)
{
    static const double slit[] = { 5, -3.2, 8.4, 5.5, 5, 14.2, 1.6, 5.5 };
    paint_ball(p, GOLD, 2, 6, 20, 15.4, 0);
    paint_ball(p, NIGHT, 2, 6, 17.6, 13, 0);
    paint_ball(p, (struct mat){ MATTE, 12, 14, 0.16 }, 2, 6, 16, 12, 0);
    paint_ball(p, flat(12), 4, 5.6, 10.6, 10.8, 0);
    paint_ball(p, (struct mat){ MATTE, 9, 11, 0.3 }, 4.4, 5.6, 9.2, 9.8, 0);
    paint_poly(p, NIGHT, 4, slit, 0);
    paint_ball(p, LAMP, 0, 0.4, 2.8, 2.6, 0);
    if (cross) {
        static const double lid[] = { -19, -6, -8, -12, 10, -12, 23, -1, 21, 3, 6, -1, -10, -2, -18, 2 };
        paint_poly(p, GOLD, 8, lid, 2.4);
    }
    paint_ball(p, LAMP, -15, -14, 6, 2.2, -0.11);
}

static void queen(struct sheet *s, int x, bool cross)
{
    struct paint *p = paint_new(FACE_W, FACE_H);
    veils(p);
    crown(p);
    bell(p);
    gaze(p, cross);
    paint_done(p, s, x, 0, 1, 2);
}

static void queen_near(struct sheet *s)
{
    queen(s, 0, true);
}

struct sheet art_queen_face(void)
{
    struct sheet s = sheet_new(CUT_W, 96 + CUT_H, 12);
    queen(&s, 0, false);
    queen(&s, FACE_W, true);
    art_cut_in(&s, 96, queen_near, 0, 3, 2);
    return s;
}
