/*
 * art_fx.c - what a creature of glass leaves: fire in three sizes, light, rings, sherds and bubbles. Fire and rings are
 * added to what lies under them, so they fade out through their darkest shades, dithered; a field of noise is what
 * burns.
 */
#include "art.h"

#include <math.h>

/* -- noise -- */

/* A number from 0 to 1 for a corner of the lattice. */
static double corner(int x, int y, uint32_t seed)
{
    uint32_t h = (uint32_t)x * 374761393u + (uint32_t)y * 668265263u + seed * 2246822519u;
    h = (h ^ h >> 13) * 1274126177u;
    return ((h ^ h >> 16) & 0xffff) / 65535.0;
}

static double smooth(double t)
{
    return t * t * (3 - 2 * t);
}

static double noise(double x, double y, uint32_t seed)
{
    double fx = floor(x), fy = floor(y), u = smooth(x - fx), v = smooth(y - fy);
    int i = (int)fx, j = (int)fy;
    double top = corner(i, j, seed) * (1 - u) + corner(i + 1, j, seed) * u;
    double low = corner(i, j + 1, seed) * (1 - u) + corner(i + 1, j + 1, seed) * u;

    return top * (1 - v) + low * v;
}

static double cloud(double x, double y, uint32_t seed)
{
    return 0.55 * noise(x, y, seed) + 0.29 * noise(2.1 * x, 2.1 * y, seed + 1) +
           0.16 * noise(4.3 * x, 4.3 * y, seed + 2);
}

/* Puts light of 0 to 1; under the darkest shade nothing is left. */
static void put(struct sheet *s, int x, int y, double v)
{
    int shade = (int)(art_clamp(v, 0, 1) * 14.9 + art_dither(x, y));

    if (shade > sheet_get(s, x, y))
        sheet_set(s, x, y, shade > 15 ? 15 : shade);
}

/* -- fire: bank 14 -- */

/* A ball of fire at the time t, 0 to 1. It swells fast, then slowly, is eaten hollow from its middle, and breaks up
 * into tongues as it cools. */
static void fire(struct sheet *s, int x, int y, int size, double t, double grain, uint32_t seed)
{
    double r = size / 2.0, ease = 1 - (1 - t) * (1 - t) * (1 - t), front = 0.34 + 0.6 * ease;
    double hollow = t < 0.25 ? -0.3 : 0.86 * smooth((t - 0.25) / 0.75) * front, heat = 1.02 - 0.72 * t;

    for (int j = 0; j < size; j++)
        for (int i = 0; i < size; i++) {
            double dx = (i + 0.5 - r) / r, dy = (j + 0.5 - r) / r, d = sqrt(dx * dx + dy * dy);
            double c = cloud(grain * dx / (0.5 + ease) + 7, grain * dy / (0.5 + ease) + 7, seed);
            double tongue = art_clamp((c - 0.22) * 2.0, 0, 1);
            double ragged = front * (0.74 + 0.42 * c), body = (ragged - d) / 0.30;
            double inner = (d - hollow + 0.36 * (c - 0.35)) / 0.34;
            double core = t < 0.34 ? (1 - d / (0.40 + 1.1 * t)) * (1 - t / 0.34) * 1.6 : 0;
            double v = art_clamp(body, 0, 1) * art_clamp(inner, 0, 1) * heat * (0.3 + 0.74 * tongue);
            if (d > 0.98)
                continue;
            v = v - 0.42 * t * (1 - tongue);
            put(s, x + i, y + j, v > core ? v : core);
        }
}

/* Sparks that fly ahead of it: short lines along their way. */
static void sparks(struct sheet *s, int x, int y, int size, double t, int n, uint32_t seed)
{
    double r = size / 2.0, ease = 1 - (1 - t) * (1 - t);

    for (int k = 0; k < n; k++) {
        double a = (k + 0.8 * corner(k, 1, seed)) / n, v = 0.6 + 0.4 * corner(k, 2, seed), tail = 0.34 * (1 - t) * v;
        for (int step = 0; step < size; step++) {
            double at = v * ease - tail * step / size;
            if (at > 0.05)
                put(s, x + (int)(r + at * r * art_cos(a)), y + (int)(r + at * r * art_sin(a)),
                    (1 - t) * (1.1 - 0.9 * step / size) * v);
        }
    }
}

/* -- light -- */

/* A star of light: a ball, and rays that are long across, short between. */
static void flare(struct sheet *s, int x, int y, int size, double t)
{
    double r = size / 2.0, power = (1 - t) * (1 - t);

    for (int j = 0; j < size; j++)
        for (int i = 0; i < size; i++) {
            double dx = fabs(i + 0.5 - r) / r, dy = fabs(j + 0.5 - r) / r, d = sqrt(dx * dx + dy * dy);
            double ball = (1 - d / (0.5 - 0.2 * t)) * power * 1.2;
            double wide = power * (1 - dx) * (1 - dy * (9 + 16 * t)), high = power * (1 - dy) * (1 - dx * (9 + 16 * t));
            double v = wide > high ? wide : high;
            put(s, x + i, y + j, d < 1 ? (v > ball ? v : ball) : 0);
        }
}

/* A ring that runs out and thins; behind it a second, fainter one. */
static void ring(struct sheet *s, int x, int y, int size, double t)
{
    double r = size / 2.0, ease = 1 - (1 - t) * (1 - t), wide = 0.16 * (1 - t) + 0.03,
           at = (1 - wide) * (0.12 + 0.88 * ease);

    for (int j = 0; j < size; j++)
        for (int i = 0; i < size; i++) {
            double dx = (i + 0.5 - r) / r, dy = (j + 0.5 - r) / r, d = sqrt(dx * dx + dy * dy);
            double edge = d > at ? 1 - (d - at) / (wide * 0.45) : 1 - (at - d) / (wide * 2.2);
            double second = 1 - fabs(d - at * 0.66) / (wide * 0.7);
            double v = edge > 0.45 * second ? edge : 0.45 * second;
            put(s, x + i, y + j, v * (1.15 - t));
        }
}

/* -- sherds: the creatures' bank, of every stage; 2..9 glass, 15 the light on it -- */

/* A flat piece of glass that turns about an axis of its own while it spins; it is dark, so that it is no bullet, and
 * glows a little where it meets the light. */
static void sherd(struct sheet *s, int x, int y, int size, double turn, int n, const double *xy)
{
    double flat = art_cos(turn), c = art_cos(turn * 1.0 + 0.1), q = art_sin(turn * 1.0 + 0.1), points[12];
    double lit = flat < 0 ? -flat : flat;
    struct paint *p = paint_new(size, size);

    for (int i = 0; i < n; i++) {
        double px = xy[2 * i] * size / 2, py = xy[2 * i + 1] * size / 2 * (lit < 0.22 ? 0.22 : lit);
        points[2 * i] = px * c - py * q;
        points[2 * i + 1] = px * q + py * c;
    }
    int hi = lit > 0.9 ? 6 : 4 + (int)(2 * lit), lo = hi - 2;
    paint_poly(p, (struct mat){ GLASS, lo, hi, 0.1 }, n, points, size * 0.16);
    paint_done(p, s, x, y, 0, 0);
    for (int i = 0; lit > 0.9 && i < size * size; i++) {
        if (sheet_get(s, x + i % size, y + i / size) >= hi - (flat > 0))
            sheet_set(s, x + i % size, y + i / size, 7);
    }
}

static void bubble(struct sheet *s, int x, int y, int size, double t)
{
    double r = size / 2.0, radius = r * (0.5 + 0.45 * t);

    for (int j = 0; j < size; j++)
        for (int i = 0; i < size; i++) {
            double dx = i + 0.5 - r, dy = j + 0.5 - r, d = sqrt(dx * dx + dy * dy);
            double rim = 1 - fabs(d - radius + 0.8) / 1.1;
            bool light = dx < -0.1 * r && dy < -0.1 * r && d < radius * 0.72 && d > radius * 0.36;
            if (rim > 0.25 && !(t > 0.8 && (i + j) % 2))
                sheet_set(s, x + i, y + j, 3 + (int)(6.9 * art_clamp(0.5 - (dx + dy) / (3 * r), 0, 1)));
            else if (light && t < 0.9)
                sheet_set(s, x + i, y + j, 14);
        }
}

/* -- the sheets -- */

enum { SMALL = 32, LARGE = 64, HUGE = 112, FRAMES = 10, HUGE_FRAMES = 14 };

struct sheet art_fires(void)
{
    struct sheet s = sheet_new(HUGE * HUGE_FRAMES, 2 * SMALL + 2 * LARGE + HUGE, 14);

    for (int i = 0; i < FRAMES; i++) {
        double t = (i + 0.3) / FRAMES;
        for (int k = 0; k < 2; k++) {
            fire(&s, SMALL * i, SMALL * k, SMALL, t, 3.6, 11 + 5 * (uint32_t)k);
            sparks(&s, SMALL * i, SMALL * k, SMALL, t, 7, 3 + (uint32_t)k);
            fire(&s, LARGE * i, 2 * SMALL + LARGE * k, LARGE, t, 4.8, 41 + 7 * (uint32_t)k);
            sparks(&s, LARGE * i, 2 * SMALL + LARGE * k, LARGE, t, 13, 8 + (uint32_t)k);
        }
    }
    for (int i = 0; i < HUGE_FRAMES; i++) {
        double t = (i + 0.3) / HUGE_FRAMES;
        fire(&s, HUGE * i, 2 * SMALL + 2 * LARGE, HUGE, t, 6.4, 97);
        sparks(&s, HUGE * i, 2 * SMALL + 2 * LARGE, HUGE, t, 22, 19);
    }
    return s;
}

/* A disc of light that spreads and fades: soft, or brightest along its edge. */
static void disc(struct sheet *s, int x, int y, int size, double t, bool soft)
{
    double r = size / 2.0, at = 0.30 + 0.68 * (1 - (1 - t) * (1 - t));

    for (int j = 0; j < size; j++)
        for (int i = 0; i < size; i++) {
            double dx = (i + 0.5 - r) / r, dy = (j + 0.5 - r) / r, d = sqrt(dx * dx + dy * dy) / at;
            double body = soft ? 1.1 * (1 - d * d) : 0.3 + 0.7 * d * d * d, edge = art_clamp((1 - d) / 0.14, 0, 1);
            put(s, x + i, y + j, d < 1 ? 0.92 * body * edge * (1 - t) : 0);
        }
}

/* A puff of light: where a shot hits, a ball and `n` short rays that fly off; without rays, the flame of a muzzle. */
static void puff(struct sheet *s, int x, int y, int size, double t, int n)
{
    double r = size / 2.0;

    for (int j = 0; j < size; j++)
        for (int i = 0; i < size; i++) {
            double dx = (i + 0.5 - r) / r * (n ? 1 : 1.7), dy = (j + 0.5 - r) / r, d = sqrt(dx * dx + dy * dy);
            double depth = art_clamp(1 - d / (1 - 0.4 * t), 0, 1);
            put(s, x + i, y + j, 1.5 * depth * depth * (1 - 0.6 * t));
        }
    sparks(s, x, y, size, t, n, 5);
}

enum { FLARE = 64, FLARES = 6, RING = 64, WAVE = 144, RINGS = 8, SHINE = 48, PUFF = 20, PUFFS = 3, SWELL = 192 };

struct sheet art_lights(void)
{
    struct sheet s = sheet_new(WAVE * RINGS, FLARE + RING + WAVE + SHINE + SWELL, 0);

    for (int i = 0; i < FLARES; i++)
        flare(&s, FLARE * i, 0, FLARE, (i + 0.2) / FLARES);
    for (int i = 0; i < RINGS; i++) {
        ring(&s, RING * i, FLARE, RING, (i + 0.4) / RINGS);
        ring(&s, WAVE * i, FLARE + RING, WAVE, (i + 0.4) / RINGS);
    }
    for (int i = 0; i < FLARES; i++) {
        disc(&s, SHINE * i, FLARE + RING + WAVE, SHINE, (i + 0.2) / FLARES, true);
        disc(&s, SWELL * i, FLARE + RING + WAVE + SHINE, SWELL, (i + 0.2) / FLARES, false);
    }
    for (int i = 0; i < PUFFS; i++) {
        puff(&s, SHINE * FLARES + PUFF * i, FLARE + RING + WAVE, PUFF, (i + 0.1) / PUFFS, 0);
        puff(&s, SHINE * FLARES + PUFF * (PUFFS + i), FLARE + RING + WAVE, PUFF, (i + 0.1) / PUFFS, 6);
    }
    return s;
}

/* Light that runs over the logo: what a slanting band covers of it, white in its middle. */
struct sheet art_logo_light(void)
{
    struct sheet logo = art_logo(), s = sheet_new(logo.w * RINGS, logo.h, 15);

    for (int k = 0; k < RINGS; k++)
        for (int i = 0; i < logo.w * logo.h; i++) {
            int x = i % logo.w, y = i / logo.w, shade = sheet_get(&logo, x, y);
            double at = (k + 0.5) / RINGS * (logo.w + 80) - 20, off = fabs(x + y * 0.5 - at) / 15;
            if (shade > 1 && off + 0.6 * art_dither(x, y) < 1)
                sheet_set(&s, logo.w * k + x, y, off < 0.4 ? 15 : shade < 10 ? 9 : 14);
        }
    sheet_free(&logo);
    return s;
}

/* A bomb, as the HUD shows it: a ball of glass with a burning fuse. */
static void glass_bomb(struct sheet *s, int x0, int y0)
{
    static const char *const rows[] = { ".......1.F1.", "......1AFDF1", "......1A1F1.", "..111111A1..",
                                        ".198876111..", "19FF87651...", "18FD87651...", "188887651...",
                                        "178777551...", "167765541...", ".1655541....", "..11111....." };

    for (int y = 0; y < (int)(sizeof rows / sizeof *rows); y++)
        for (int x = 0; rows[y][x]; x++) {
            const char c = rows[y][x];
            if (c != '.')
                sheet_set(s, x0 + x, y0 + y, c >= 'A' ? c - 'A' + 10 : c - '0');
        }
}

/* Copies a square of n px to (x1, y1) at twice its size, with smooth corners. */
static void enlarge(struct sheet *s, int x0, int y0, int n, int x1, int y1)
{
    for (int y = 0; y < 2 * n; y++)
        for (int x = 0; x < 2 * n; x++) {
            const int u = x0 + x / 2, v = y0 + y / 2, dx = x % 2 ? 1 : -1, dy = y % 2 ? 1 : -1;
            const int side = x / 2 + dx < 0 ? 0 : sheet_get(s, u + dx, v), over = sheet_get(s, u, v + dy);
            const bool corner = side == over && side != sheet_get(s, u, v - dy) && over != sheet_get(s, u - dx, v);
            sheet_set(s, x1 + x, y1 + y, corner ? side : sheet_get(s, u, v));
        }
}

/* What is found, a row each: pearl, conch and heart, over which a light runs in the first half of their frames; and
 * below them a bomb, small and large. */
struct sheet art_gems(void)
{
    enum { GEM = 16, GEMS = 3, GEM_FRAMES = 10, BOMB = 12 };
    struct sheet finds = art_finds(), s = sheet_new(GEM * GEM_FRAMES, GEM * GEMS + 2 * BOMB, 0);

    for (int k = 0; k < GEM_FRAMES * GEMS; k++)
        for (int i = 0; i < GEM * GEM; i++) {
            int frame = k % GEM_FRAMES, x = i % GEM, y = i / GEM;
            int shade = sheet_get(&finds, k / GEM_FRAMES * GEM + x, y);
            double off = fabs(x + y * 0.7 - (frame * 7 - 4));
            bool lit = shade > 2 && frame < 5 && off < 2.6;
            sheet_set(&s, frame * GEM + x, k / GEM_FRAMES * GEM + y, lit ? off < 1.4 ? 15 : 13 : shade);
        }
    glass_bomb(&s, 0, GEM * GEMS);
    enlarge(&s, 0, GEM * GEMS, BOMB, GEM, GEM * GEMS);
    sheet_free(&finds);
    return s;
}

/* Where a boss is, at the lower edge: an arrow that points up at it. */
struct sheet art_marker(void)
{
    struct sheet s = sheet_new(2 * 24, 10, 1);

    for (int k = 0; k < 2; k++)
        for (int y = 0; y < 10; y++)
            for (int x = 0; x < 24; x++) {
                double d = fabs(x - 11.5), rim = d - y * 1.2;
                if (rim < 0.8)
                    sheet_set(&s, 24 * k + x, y, rim > -0.6 || y == 9 ? 1 : y > 6 ? 4 : (k ? 13 : 9) - (int)(d / 4));
            }
    return s;
}

enum { TINY = 8, MIDDLE = 12, LONG = 18, TURNS = 8, BUBBLES = 4 };

struct sheet art_sherds(void)
{
    static const double three[] = { -0.9, 0.7, 0.1, -0.9, 0.8, 0.6 },
                        four[] = { -0.8, -0.5, 0.3, -0.9, 0.9, 0.2, -0.3, 0.8 },
                        five[] = { -0.9, -0.2, -0.1, -0.7, 0.9, -0.3, 0.6, 0.5, -0.4, 0.7 };
    struct sheet s = sheet_new(LONG * TURNS, TINY + MIDDLE + LONG + MIDDLE, 10);

    for (int i = 0; i < TURNS; i++) {
        double turn = (i + 0.5) / TURNS;
        sherd(&s, TINY * i, 0, TINY, turn, 3, three);
        sherd(&s, MIDDLE * i, TINY, MIDDLE, turn, 4, four);
        sherd(&s, LONG * i, TINY + MIDDLE, LONG, turn, 5, five);
    }
    for (int i = 0; i < BUBBLES; i++)
        bubble(&s, MIDDLE * i, TINY + MIDDLE + LONG, MIDDLE, i / 3.0);
    return s;
}
