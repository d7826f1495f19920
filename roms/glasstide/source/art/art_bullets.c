/*
 * art_bullets.c - bullets, shots and sparks. All on bank 0, so that adding a bank recolours them.
 *
 * A bullet is a shape given by its signed distance: a dark rim that holds it apart from anything behind it, a saturated
 * band, a bright band, and a white core where the danger is. What is turned by the packer is drawn pointing right and
 * has no light of its own.
 */
#include "art.h"

#include <math.h>
#include <stddef.h>

/* Signed distance in pixels, negative inside. */
typedef double dist_fn(double x, double y, const double *k);

/* Bands from the edge inwards: shade bands[i].shade from depth bands[i].depth on. */
struct band {
    double depth;
    int shade;
};

static void draw(struct sheet *s, int x0, int y0, int w, int h, dist_fn *f, const double *k, int n,
                 const struct band *bands)
{
    enum { SUB = 8 };
    for (int y = 0; y < h; y++) {
        for (int x = 0; x < w; x++) {
            double sum = 0;
            int in = 0, c = 0;
            for (int i = 0; i < SUB * SUB; i++) {
                double d = f(x + (i % SUB + 0.5) / SUB - w * 0.5, y + (i / SUB + 0.5) / SUB - h * 0.5, k);
                sum += d;
                in += d < 0;
            }
            if (2 * in < SUB * SUB)
                continue;
            for (int i = 0; i < n; i++) {
                if (i == 0 || -sum / (SUB * SUB) >= bands[i].depth)
                    c = bands[i].shade;
            }
            sheet_set(s, x0 + x, y0 + y, c);
        }
    }
}

#define DRAW(s, x, y, w, h, f, bands, ...)                                                                             \
    draw(s, x, y, w, h, f, (const double[]){ __VA_ARGS__ }, (int)(sizeof(bands) / sizeof((bands)[0])), bands)

static double length(double x, double y)
{
    return sqrt(x * x + y * y);
}

static double d_circle(double x, double y, const double *k)
{
    return length(x, y) - k[0];
}

/* k: half length, radius at the tail, radius at the head: two circles and what lies between. */
static double d_capsule(double x, double y, const double *k)
{
    double t = art_clamp((x + k[0]) / (2 * k[0]), 0, 1);
    return length(x + k[0] - t * 2 * k[0], y) - (k[1] + t * (k[2] - k[1]));
}

/* k: half length, half width. An ellipse's distance, near enough for a few pixels. */
static double d_ellipse(double x, double y, const double *k)
{
    double u = x / k[0], v = y / k[1], q = length(u, v), g = length(u / k[0], v / k[1]);
    return g > 1e-9 ? q * (q - 1) / g : -k[1];
}

/* Largest of n half planes: points outward normal (nx, ny) and offset. k: n, then nx ny off for each. */
static double d_planes(double x, double y, const double *k)
{
    double best = -1e9;
    for (int i = 0; i < (int)k[0]; i++) {
        double d = x * k[1 + 3 * i] + y * k[2 + 3 * i] - k[3 + 3 * i];
        best = d > best ? d : best;
    }
    return best;
}

/* An arrowhead: a diamond with a notch cut from behind. k: half length, half width, notch. */
static double d_kunai(double x, double y, const double *k)
{
    double ay = y < 0 ? -y : y;
    double head = ((x - k[0]) * k[1] + ay * 2 * k[0]) / length(k[1], 2 * k[0]);
    double notch = ((k[2] - k[0] - x) * k[1] - ay * k[2]) / length(k[1], k[2]);
    return head > notch ? head : notch;
}

/* k: points, outer radius, inner radius, turn. */
static double d_star(double x, double y, const double *k)
{
    double best = 1e9;
    int n = (int)k[0];
    for (int i = 0; i < n; i++) {
        double a = k[3] + (double)i / n, c = art_cos(a), s = art_sin(a);
        double u = x * c + y * s, v = y * c - x * s, half = k[2];
        v = v < 0 ? -v : v;
        double d = ((u - k[1]) * half + v * k[1]) / length(half, k[1]);
        d = -u > d ? -u : d;
        best = d < best ? d : best;
    }
    double core = length(x, y) - k[2] * 1.02;
    return core < best ? core : best;
}

/* A petal: two circles' common part, blunt at the back. k: radius, offset. */
static double d_petal(double x, double y, const double *k)
{
    double a = length(x, y - k[1]) - k[0], b = length(x, y + k[1]) - k[0];
    return a > b ? a : b;
}

static double d_drop(double x, double y, const double *k)
{
    double head = length(x - k[0], y) - k[1], t = art_clamp((x + k[2]) / (k[0] + k[2]), 0, 1);
    double tail = length(x + k[2] - t * (k[0] + k[2]), y) - t * t * k[1];
    return head < tail ? head : tail;
}

static const struct band SOLID[] = { { 0, 4 }, { 0.8, 8 }, { 1.6, 10 }, { 2.2, 12 }, { 2.7, 15 } };
static const struct band TINY[] = { { 0, 5 }, { 0.8, 9 }, { 1.6, 13 }, { 2.2, 15 } };
static const struct band THIN[] = { { 0, 5 }, { 0.6, 8 }, { 1.1, 11 }, { 1.6, 15 } };
static const struct band BIG[] = { { 0, 2 },    { 1, 6 },    { 2, 8 },  { 3.2, 9 },
                                   { 4.2, 11 }, { 5.2, 12 }, { 6, 13 }, { 6.8, 15 } };

/* A bubble: a thin bright ring, clear inside, with the light caught at two places. */
static void bubble(struct sheet *s, int x0, int y0, int size)
{
    double r = size * 0.5;
    for (int y = 0; y < size; y++) {
        for (int x = 0; x < size; x++) {
            double dx = x + 0.5 - r, dy = y + 0.5 - r, d = r - length(dx, dy),
                   side = (dx + dy) / (r * 1.4142135623730951);
            int c = 0;
            if (d < 0.1)
                continue;
            if (d < 1)
                c = 4;
            else if (d < 2)
                c = side < -0.55 || side > 0.55 ? 15 : 11;
            else if (d < 3)
                c = side < -0.5 ? 13 : side > 0.5 ? 9 : 8;
            else if (d < 3.9)
                c = 5;
            else if (d > 4 && d < 5.4 && side < -0.22 && side > -0.75)
                c = 15;
            if (c)
                sheet_set(s, x0 + x, y0 + y, c);
        }
    }
}

/* A ball of glass: rings, then a highlight at the upper left and the light leaving at the lower right. */
static void marble(struct sheet *s, int x0, int y0, int size)
{
    double r = size * 0.5;
    for (int y = 0; y < size; y++) {
        for (int x = 0; x < size; x++) {
            double dx = x + 0.5 - r, dy = y + 0.5 - r, q = length(dx, dy), d = r - q,
                   side = (dx + dy) / (r * 1.4142135623730951);
            int c = 15;
            if (d < 0.05)
                continue;
            if (d < 1)
                c = 2;
            else if (d < 2)
                c = side > 0.5 ? 12 : side < -0.5 ? 8 : 10;
            else if (d < 3.2)
                c = side > 0.45 ? 9 : 8;
            else if (d < 4.4)
                c = side > 0.4 ? 8 : 6;
            else if (q > r * 0.42)
                c = side > 0.25 ? 9 : 7;
            else if (q > r * 0.33)
                c = 11;
            else if (q > r * 0.24)
                c = 13;
            double hx = dx + r * 0.42, hy = dy + r * 0.42;
            if (hx * hx + hy * hy < r * r * 0.022)
                c = 15;
            sheet_set(s, x0 + x, y0 + y, c);
        }
    }
}

/* A glass splinter has a light and a dark face along its spine. */
static void splinter(struct sheet *s, int x0, int y0, int size)
{
    static const double k[] = { 4, 0.44, 0.90, 3.0, 0.44, -0.90, 3.0, -0.66, 0.75, 3.6, -0.66, -0.75, 3.6 };
    static const struct band edge[] = { { 0, 5 }, { 0.7, 8 }, { 1.3, 12 }, { 1.9, 15 } };
    draw(s, x0, y0, size, size, d_planes, k, 4, edge);
}

/* What stands where a bullet will be, 24 x 24 in four frames: a broken ring that closes in over a thin mist. It has
 * neither rim nor core, which are for what hurts. */
static void cloud(struct sheet *s, int x0, int y0, int frame)
{
    static const double radius[4] = { 10.8, 8.8, 6.9, 5.2 };
    static const int shade[4] = { 7, 9, 11, 13 };
    double r = radius[frame];
    for (int y = 0; y < 24; y++) {
        for (int x = 0; x < 24; x++) {
            double dx = x - 11.5, dy = y - 11.5, q = length(dx, dy), a = frame / 24.0;
            double u = dx * art_cos(a) + dy * art_sin(a), v = dy * art_cos(a) - dx * art_sin(a);
            bool gap = u * u < v * v * 0.06 || v * v < u * u * 0.06;
            if (q < r && q > r - 1.2 && !gap)
                sheet_set(s, x0 + x, y0 + y, shade[frame]);
            else if (q < r - 1.8 && (x + y) % 2 == 0 && (frame > 1 || x % 2 == 0))
                sheet_set(s, x0 + x, y0 + y, q < r * 0.45 ? 5 + 2 * frame : 3 + frame);
        }
    }
}

/* A flame in a ball of glass, 24 x 24: it flickers over four frames. */
static void lamp(struct sheet *s, int x0, int y0, int frame)
{
    static const double tall[4] = { 5.4, 6.4, 7.0, 6.0 };
    static const struct band flame[] = { { 0, 8 }, { 1.0, 11 }, { 1.8, 13 }, { 2.6, 15 } };
    static const struct band cap[] = { { 0, 2 }, { 1, 9 }, { 1.8, 12 } };
    bubble(s, x0, y0, 24);
    DRAW(s, x0, y0 + (frame > 1 ? 0 : 1), 24, 24, d_ellipse, flame, 4.2, tall[frame]);
    DRAW(s, x0 + 8, y0, 8, 6, d_ellipse, cap, 3.9, 2.9);
    DRAW(s, x0 + 8, y0 + 19, 8, 5, d_ellipse, cap, 3.9, 2.4);
}

struct sheet art_bullets(void)
{
    struct sheet s = sheet_new(128, 116, 0);
    DRAW(&s, 0, 0, 8, 8, d_circle, TINY, 3.95);
    DRAW(&s, 16, 0, 12, 12, d_circle, SOLID, 5.95);
    bubble(&s, 32, 0, 16);
    DRAW(&s, 48, 0, 12, 12, d_ellipse, THIN, 5.9, 2.9);
    DRAW(&s, 64, 0, 14, 14, d_kunai, THIN, 6.8, 6.4, 3.2);
    DRAW(&s, 80, 0, 14, 14, d_drop, SOLID, 2.4, 4.3, 6.8);
    splinter(&s, 96, 0, 14);
    DRAW(&s, 112, 0, 14, 14, d_petal, SOLID, 8.1, 3.9);
    for (int i = 0; i < 4; i++)
        DRAW(&s, 16 * i, 16, 16, 16, d_star, THIN, 5, 8.2, 4.3, -0.25 + i / 20.0);
    DRAW(&s, 64, 16, 16, 16, d_capsule, THIN, 5.6, 1.0, 2.3);
    DRAW(&s, 0, 32, 24, 24, d_circle, BIG, 11.95);
    marble(&s, 32, 32, 32);
    DRAW(&s, 64, 32, 18, 18, d_circle, BIG, 8.95);
    bubble(&s, 96, 32, 24);
    for (int i = 0; i < 4; i++) {
        cloud(&s, 24 * i, 64, i);
        lamp(&s, 24 * i, 92, i);
    }
    DRAW(&s, 96, 64, 28, 28, d_ellipse, THIN, 13.6, 2.9);
    return s;
}

/* A bolt of light: a bright head, and a tail that thins out and darkens behind it. Shots are drawn under everything
 * that can hurt: bright bodies, but neither rim nor core. */
static void bolt(struct sheet *s, int x0, int y0, int size, double half, double wide)
{
    for (int y = 0; y < size; y++) {
        for (int x = 0; x < size; x++) {
            double dx = x + 0.5 - size * 0.5, dy = y + 0.5 - size * 0.5, t = (dx + half) / (2 * half);
            double head = half - dx, v = dy < 0 ? -dy : dy;
            if (t < 0 || head < 0)
                continue;
            double r = wide * (0.30 + 0.70 * t), q = 2 * wide;
            r = head < q ? r * sqrt(1 - (1 - head / q) * (1 - head / q)) : r;
            double light = (1 - v / (r > 0.5 ? r : 0.5)) * 1.5, heat = 0.34 + 0.72 * t;
            if (v > r || (t < 0.3 && t + 0.1 < art_dither(x, y) * 0.4))
                continue;
            sheet_set(s, x0 + x, y0 + y, 4 + (int)(10.4 * art_clamp(light, 0.15, 1) * art_clamp(heat, 0, 1)));
        }
    }
}

struct sheet art_shots(void)
{
    static const struct band beam[] = { { 0, 6 }, { 0.8, 9 }, { 1.6, 12 } };
    static const struct band soft[] = { { 0, 5 }, { 0.9, 8 }, { 1.7, 11 } };
    struct sheet s = sheet_new(64, 56, 0);
    DRAW(&s, 0, 0, 16, 16, d_capsule, beam, 5.6, 0.9, 2.2);
    DRAW(&s, 16, 0, 14, 14, d_kunai, soft, 6.4, 5.6, 3.6);
    DRAW(&s, 32, 0, 12, 12, d_capsule, soft, 3.8, 0.7, 1.6);
    bolt(&s, 0, 16, 40, 19.5, 4.0);
    bolt(&s, 40, 16, 22, 10.5, 2.6);
    return s;
}

/* A crescent that opens to the left: what comes back. */
static void crescent(struct sheet *s, int x0, int y0, int size)
{
    double c = size * 0.5;
    for (int y = 0; y < size; y++) {
        for (int x = 0; x < size; x++) {
            double dx = x + 0.5 - c, dy = y + 0.5 - c;
            double in = c - 0.6 - length(dx, dy), out = length(dx + c * 0.56, dy * 0.94) - c * 0.76;
            double d = in < out ? in : out;
            if (d > 0)
                sheet_set(s, x0 + x, y0 + y, d < 0.9 ? 6 : d < 1.7 ? 9 : d < 2.6 ? 12 : 14);
        }
    }
}

/* A profile of light across a ray, `tall` pixels: pale in its middle. */
static void profile(struct sheet *s, int x, int y, int tall, int least, int most)
{
    for (int i = 0; i < tall; i++) {
        double u = (i + 0.5 - tall * 0.5) / (tall * 0.5), v = 1 - u * u;
        sheet_set(s, x, y + i, least + (int)((most - least) * v * v + 0.5));
    }
}

/* What the crafts fire besides bolts: each of the six forms is known by its shape. Prisms of what was bullets; rays. */
struct sheet art_arms(void)
{
    static const struct band fang[] = { { 0, 5 }, { 0.9, 8 }, { 1.7, 11 }, { 2.5, 13 }, { 3.2, 14 } };
    static const struct band pike[] = { { 0, 5 }, { 0.8, 8 }, { 1.5, 11 }, { 2.2, 13 }, { 2.9, 14 } };
    static const struct band soft[] = { { 0, 6 }, { 0.9, 9 }, { 1.7, 12 }, { 2.4, 14 } };
    static const struct band gem[] = { { 0, 4 }, { 0.9, 9 }, { 1.9, 13 } };
    static const double wide[4] = { 3.9, 2.7, 1.5, 2.7 };
    struct sheet s = sheet_new(128, 112, 0);
    DRAW(&s, 0, 0, 24, 24, d_kunai, fang, 11.0, 9.6, 6.4);
    crescent(&s, 32, 0, 28);
    for (int i = 0; i < 4; i++)
        DRAW(&s, 64 + 12 * i, 0, 10, 10, d_ellipse, gem, wide[i], 4.6);
    profile(&s, 116, 0, 14, 5, 15);
    profile(&s, 120, 0, 52, 3, 13);
    DRAW(&s, 56, 56, 32, 32, d_drop, soft, 9.0, 5.2, 15.4);
    DRAW(&s, 0, 56, 56, 56, d_ellipse, pike, 27.4, 4.4);
    return s;
}

static void glint(struct sheet *s, int x0, int y0, int size, double arm)
{
    double c = size * 0.5;
    for (int y = 0; y < size; y++) {
        for (int x = 0; x < size; x++) {
            double dx = x + 0.5 - c, dy = y + 0.5 - c;
            dx = dx < 0 ? -dx : dx;
            dy = dy < 0 ? -dy : dy;
            double d = dx + dy + 2 * sqrt(dx * dy);
            if (d < arm)
                sheet_set(s, x0 + x, y0 + y, d < arm * 0.4 ? 15 : d < arm * 0.6 ? 13 : d < arm * 0.8 ? 10 : 7);
        }
    }
}

static void hoop(struct sheet *s, int x0, int y0, int size, double r, double wide, int shade)
{
    double c = size * 0.5;
    for (int y = 0; y < size; y++) {
        for (int x = 0; x < size; x++) {
            double d = length(x + 0.5 - c, y + 0.5 - c) - r;
            if (d < wide * 0.5 && d > -wide * 0.5)
                sheet_set(s, x0 + x, y0 + y, shade);
        }
    }
}

/* Four tumbling frames of a bit of glass: wide, narrow, edge on, narrow. */
static void crumb(struct sheet *s, int x0, int y0, double wide, bool flip)
{
    for (int y = 0; y < 8; y++) {
        for (int x = 0; x < 8; x++) {
            double dx = x - 3.5, dy = y - 3.5, u = flip ? dx - dy * 0.5 : dx + dy * 0.5;
            double d = (u < 0 ? -u : u) / wide + (dy < 0 ? -dy : dy) / 3.6;
            if (d < 1)
                sheet_set(s, x0 + x, y0 + y, u + dy * 0.4 < -0.4 ? 14 : u < wide * 0.4 ? 10 : 6);
        }
    }
}

/* The halo shown while focused: four arcs that turn a quarter in four frames. */
static void halo(struct sheet *s, int x0, int y0, int frame)
{
    for (int y = 0; y < 48; y++) {
        for (int x = 0; x < 48; x++) {
            double dx = x - 23.5, dy = y - 23.5, q = length(dx, dy), a = frame / 32.0;
            double u = dx * art_cos(a) + dy * art_sin(a), v = dy * art_cos(a) - dx * art_sin(a);
            double off = u * u < v * v ? u / (v == 0 ? 1 : v) : v / (u == 0 ? 1 : u);
            off = off < 0 ? -off : off;
            if (q > 20.4 && q < 21.6 && off > 0.22)
                sheet_set(s, x0 + x, y0 + y, off > 0.6 ? 9 : 6);
            if (q > 22 && q < 23.2 && off < 0.12)
                sheet_set(s, x0 + x, y0 + y, 11);
        }
    }
}

struct sheet art_sparks(void)
{
    static const double arms[4] = { 4.2, 8.4, 6.2, 3.2 }, crumbs[4] = { 3.0, 1.9, 0.9, 1.9 };
    static const struct band dot[] = { { 0, 1 }, { 0.9, 9 }, { 1.7, 15 } };
    struct sheet s = sheet_new(384, 112, 0);
    for (int i = 0; i < 4; i++) {
        glint(&s, 12 * i, 0, 12, arms[i]);
        crumb(&s, 48 + 8 * i, 0, crumbs[i], i == 3);
        hoop(&s, 80 + 12 * i, 0, 12, 1.6 + 1.25 * i, 1.5 - 0.15 * i, 14 - 2 * i);
        halo(&s, 48 * i, 16, i);
    }
    DRAW(&s, 128, 0, 8, 8, d_circle, dot, 3.6);
    bubble(&s, 136, 0, 12);
    bubble(&s, 148, 0, 8);
    hoop(&s, 160, 0, 7, 2.6, 1.1, 10);
    sheet_set(&s, 162, 2, 15);
    for (int i = 0; i < 8; i++)
        hoop(&s, 48 * i, 64, 48, 3 + 2.8 * i, i < 3 ? 3 : i < 5 ? 2 : 1.2, 15 - i);
    return s;
}
