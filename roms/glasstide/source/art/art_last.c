/*
 * art_last.c - the Drowned Moon: a disc of silver with an eye in it, in a tarnished frame that weed hangs from. Six
 * pictures as it wanes, is new, is full, and goes dark; in the ramps of bank 12 of the moon's palette.
 * And who comes up with it in the caravan's water.
 */
#include "art.h"

#include <math.h>

enum { SIDE = 160, PHASES = 6, CRATERS = 15 };

static const double DISC = 62, FRAME = 71; /* radii */

/* Bank 12: 2..8 stone, 9..11 light, 12..13 what the eye is of. */
static const struct mat SILVER = { MATTE, 2, 8, 0.02 }, STUD = { MATTE, 9, 11, 0.1 }, WEED = { MATTE, 2, 4, 0 },
                        LEAF = { MATTE, 2, 5, 0.05 };

/* One of its pictures: where its light comes from (turns from the front, 0.5 is behind it), how far the eye is open. */
struct face {
    double sun, open, iris;
    bool eclipse;
};

static const struct face FACES[PHASES] = {
    { 0.11, 0.62, 1.0, false }, /* gibbous */
    { 0.24, 0.40, 0.9, false }, /* half */
    { 0.35, 0.22, 0.8, false }, /* crescent */
    { 0.47, 0.09, 0.7, false }, /* new */
    { 0.02, 1.00, 1.2, false }, /* full */
    { 0.50, 0.80, 1.3, true },  /* eclipse */
};

static const double craters[CRATERS][3] = {
    { -40, -26, 11 }, { 38, -34, 9 },  { -30, 40, 12 }, { 44, 22, 10 },  { -52, 8, 7 },
    { 8, -50, 8 },    { 12, 50, 9 },   { -14, -44, 5 }, { 54, -6, 6 },   { -46, 30, 5 },
    { 28, 42, 6 },    { -8, 56, 4.5 }, { 26, -48, 4 },  { -56, -12, 4 }, { 46, 38, 4.5 },
};

/* The ground's normal is bent by craters: *nx, *ny in, *nx, *ny out. What lies deeper is darker: returned. */
static double bend(double x, double y, double *nx, double *ny)
{
    double deep = 0;

    for (int i = 0; i < CRATERS; i++) {
        double dx = x - craters[i][0], dy = y - craters[i][1], r = craters[i][2];
        double d = sqrt(dx * dx + dy * dy);
        if (d >= r)
            continue;
        double slope = d > 0.6 * r ? -0.55 : 0.4 * d / r; /* the wall looks inwards, the floor is a bowl */
        if (d > 0.86 * r)
            slope = 0.5;
        *nx += slope * dx / r;
        *ny += slope * dy / r;
        deep += d < 0.8 * r ? 0.07 : 0;
    }
    double sea = art_sin(x / 76 + 0.4 * art_sin(y / 60)) + art_sin(y / 66 + 0.3 + 0.3 * art_sin(x / 48));
    return deep + (sea > 0.35 ? 0.12 : 0);
}

/* A pixel of the disc outside of the eye. */
static int ground(const struct face *f, int px, int py, double x, double y)
{
    double nx = x / DISC, ny = y / DISC, nz = sqrt(art_clamp(1 - nx * nx - ny * ny, 0, 1));
    double side = art_sin(f->sun), front = art_cos(f->sun), dark = bend(x, y, &nx, &ny);
    double light = -0.86 * side * nx - 0.4 * ny * (0.3 + side) + front * nz;
    double edge = sqrt(x * x + y * y) / DISC;

    if (f->eclipse)
        return edge > 0.955 ? 11 : 1 + (art_dither(px, py) < 0.6 * edge * edge - dark);
    if (light <= 0.04) /* where no light falls only the sea's glimmer shows it */
        return 1 + (art_dither(px, py) < 0.25 + 0.9 * (1 - edge) - 2 * dark + 0.4 * (nx + ny));
    return (int)art_clamp(2.4 + 4.6 * light - 9 * dark * light + art_dither(px, py), 2, 8);
}

/* The iris: rays about the slit, dark at both of its edges. 0..2. */
static double iris_light(double x, double y, double share)
{
    double ray = 0;

    for (int i = 0; i < 11; i++) {
        double across = fabs(x * art_sin(i / 22.0) - y * art_cos(i / 22.0));
        ray = across < 0.9 ? 0.9 : ray;
    }
    return 2.1 - 3.2 * (share - 0.62) * (share - 0.62) * 3.4 - ray;
}

/* The eye: lids of stone that open, a dark ball, an iris of rays and a slit. 0: not of the eye. */
static int eye(const struct face *f, double frame, int px, int py, double x, double y)
{
    double wide = 39, high = 26 * f->open * (1 + 0.06 * art_sway(frame, 0)), u = x / wide, lid = high * (1 - u * u),
           rim = 3.6 * (1 - u * u);
    double r = sqrt(x * x + y * y), ring = (15.9 + 0.5 * art_sway(frame, 0.25)) * f->iris;

    if (u * u >= 1 || fabs(y) > lid + rim)
        return 0;
    if (fabs(y) > lid) /* the rims of the lids, lit from above */
        return f->eclipse ? 11 : y < 0 ? 4 : 7;
    if (fabs(y) > lid - 1.6)
        return 1;
    double slit = (3.6 + 0.5 * art_sway(frame, 0.25)) * (1 - y * y / (1.1 * ring * ring));
    if (r < ring && fabs(x) < slit)
        return fabs(x) > slit - 1 ? 12 : 1;
    if (r < ring)
        return 9 + (int)art_clamp(iris_light(x, y, r / ring) + 0.8 * art_dither(px, py), 0, 2.99);
    if (r < ring + 1.6)
        return 1;
    double ball = 0.9 - r / wide - (y < 0 ? 0.25 : 0);
    return ball + 0.3 * art_dither(px, py) > 0.52 ? 13 : 12;
}

static double sway(double frame, int i)
{
    return 1.6 * art_sway(frame, 0.5 * (i % 2));
}

/* Behind the disc: weed that hangs from the frame, the frame itself with twelve studs. */
static void setting(struct sheet *s, int x, int y, double frame, bool eclipse)
{
    struct paint *p = paint_new(SIDE, SIDE);

    for (int i = 0; i < 36 && eclipse; i++) { /* the light that goes by it */
        double t = i / 36.0, far = 76.7 + 2.3 * art_sway(frame, 0.5 * (i % 2));
        paint_limb(p, (struct mat){ FLAT, 9, 10, i % 3 ? 0.2 : 0.7 }, art_cos(t) * 69, art_sin(t) * 69, 3.4,
                   art_cos(t) * far, art_sin(t) * far, 0.3);
    }
    for (int i = 0; i < 13 && !eclipse; i++) {
        double t = 0.25 + 0.026 * (i - 6), k = sway(frame, i);
        double a[2] = { art_cos(t) * (FRAME - 4), art_sin(t) * (FRAME - 4) - 2 }, c[2] = { a[0] + 4 * k, a[1] + 7 },
               b[2] = { a[0] - 2 * k, 78.6 - 1.6 * (i * 5 % 4) };
        paint_curve(p, i % 2 ? WEED : LEAF, a, c, b, 2.8, 0.8);
    }
    paint_ball(p, eclipse ? (struct mat){ GLOW, 9, 11, -0.1 } : SILVER, 0, 0, FRAME, FRAME, 0);
    for (int i = 0; i < 48; i++) { /* a milled edge */
        double t = i / 48.0, far = FRAME - 1.2;
        paint_limb(p, eclipse ? STUD : (struct mat){ FLAT, 3, 3, 0 }, art_cos(t) * (far - 3), art_sin(t) * (far - 3),
                   0.6, art_cos(t) * far, art_sin(t) * far, 0.6);
    }
    for (int i = 0; i < 12; i++) {
        double t = i / 12.0, far = 0.5 * (FRAME + DISC) + 0.2;
        paint_ball(p, STUD, art_cos(t) * far, art_sin(t) * far, i % 3 ? 2.2 : 3.4, i % 3 ? 2.2 : 3.4, 0);
    }
    paint_ball(p, (struct mat){ FLAT, 1, 1, 0 }, 0, 0, DISC + 1.4, DISC + 1.4, 0);
    paint_done(p, s, x, y, 1, 1);
}

static void face(struct sheet *s, int x0, int y0, const struct face *f, double frame)
{
    setting(s, x0, y0, frame, f->eclipse);
    for (int py = 0; py < SIDE; py++) {
        for (int px = 0; px < SIDE; px++) {
            double x = px + 0.5 - SIDE / 2.0, y = py + 0.5 - SIDE / 2.0;
            if (x * x + y * y > DISC * DISC)
                continue;
            int c = eye(f, frame, px, py, x, y - 2);
            sheet_set(s, x0 + px, y0 + py, c ? c : ground(f, px, py, x, y));
        }
    }
}

/* What it shows of its wounds whatever its phase: cracks from the rim to the eye, which the sea's light fills. */
static void cracks(struct sheet *s, int x0, int y0, double frame, int wounds)
{
    const struct mat glow = { FLAT, 9, 11, 0.6 + 0.3 * art_sway(frame, 0) };
    struct paint *p = paint_new(SIDE, SIDE);

    double at[6][4];

    for (int i = 0; i < 6; i++) {
        double t = (i * 2 % 6 + i / 3) / 6.0 + 0.05, far = DISC - 4;
        double crack[] = { far * art_cos(t), far * art_sin(t), t + 0.5, 18 + 3 * (i % 3) };
        for (int k = 0; k < 4; k++)
            at[i][k] = crack[k];
    }
    paint_cracks(p, wounds, glow, at, 130);
    paint_done(p, s, x0, y0, 0, 0);
}

/* Its eye wide open, over the one it has, as it attacks. */
static void glare(struct sheet *s, int x0, int y0, double frame)
{
    const struct face wide = { 0.02, 1.05, 1.3, false };

    for (int py = 0; py < SIDE; py++) {
        for (int px = 0; px < SIDE; px++)
            sheet_set(s, x0 + px, y0 + py, eye(&wide, frame, px, py, px + 0.5 - SIDE / 2.0, py + 0.5 - SIDE / 2.0 - 2));
    }
}

struct sheet art_last(void)
{
    struct sheet s = sheet_new(SIDE * BOSS_FRAMES, SIDE * (PHASES + 3), 12);

    for (int i = 0; i < BOSS_FRAMES; i++) {
        double frame = i * 4.0 / BOSS_FRAMES;
        for (int k = 0; k < PHASES; k++)
            face(&s, SIDE * i, SIDE * k, &FACES[k], frame);
        cracks(&s, SIDE * i, SIDE * PHASES, frame, 1);
        cracks(&s, SIDE * i, SIDE * (PHASES + 1), frame, 2);
        glare(&s, SIDE * i, SIDE * (PHASES + 2), frame);
    }
    return s;
}

/* Who talks: the eye from near, half asleep and wide awake, with water running down over it. */
static void portrait(struct sheet *s, int x0, const struct face *f)
{
    enum { W = 72, H = 96 };
    const double radius = 35, zoom = 1.14;
    struct paint *p = paint_new(W, H);

    paint_ball(p, SILVER, 0, 2, radius, radius, 0);
    paint_ball(p, (struct mat){ FLAT, 1, 1, 0 }, 0, 2, radius - 2.4, radius - 2.4, 0);
    for (int i = 0; i < 7; i++) {
        double t = 0.25 + 0.05 * (i - 3), a[2] = { art_cos(t) * 32, 2 + art_sin(t) * 32 };
        double c[2] = { a[0] + (i % 2 ? 3 : -3), a[1] + 6 }, b[2] = { a[0], 45 - 3 * (i % 3) };
        paint_curve(p, i % 2 ? WEED : LEAF, a, c, b, 2.2, 0.7);
    }
    paint_done(p, s, x0, 0, 1, 1);
    for (int py = 0; py < H; py++) {
        for (int px = 0; px < W; px++) {
            double x = px + 0.5 - W / 2.0, y = py + 0.5 - H / 2.0 - 2, k = DISC / (radius - 3);
            if (x * x + y * y > (radius - 3) * (radius - 3))
                continue;
            int c = eye(f, 0, px, py, x * zoom, y * zoom);
            sheet_set(s, x0 + px, py, c ? c : ground(f, px, py, x * k, y * k));
        }
    }
}

/* Its open eye fills the band of its cut-in. */
static void near_eye(struct sheet *s, int y0)
{
    const double zoom = 0.72;

    for (int py = 0; py < CUT_H; py++) {
        for (int px = 0; px < CUT_W; px++) {
            double x = (px + 0.5 - CUT_W / 2.0) * zoom, y = (py + 0.5 - CUT_H / 2.0) * zoom;
            int band = art_band(px + 0.5, py + 0.5), c = eye(&FACES[4], 0, px, py, x, y);
            if (!c && x * x < DISC * DISC)
                c = ground(&FACES[4], px, py, x, y);
            if (band)
                sheet_set(s, px, y0 + py, band == 1 ? 15 : c ? c : art_streak(px, py));
        }
    }
}

struct sheet art_last_face(void)
{
    struct sheet s = sheet_new(CUT_W, 96 + CUT_H, 12);

    portrait(&s, 0, &FACES[1]);
    portrait(&s, 72, &FACES[4]);
    near_eye(&s, 96);
    return s;
}
