/*
 * art_story.c - the pictures of the opening and the endings, 240 x 160 px each, in fifteen colours of their own: 1..7
 * what is far, 8..11 what is near, 12..15 what shines.
 */
#include "art.h"

#include <math.h>

enum { WIDE = 240, HIGH = 160 };

static const struct mat NEAR = { MATTE, 8, 11, 0 }, SHADE = { FLAT, 8, 8, 0 }, EDGE = { FLAT, 9, 9, 0 },
                        LIT = { GLOW, 12, 15, 0.05 }, PANE = { FLAT, 13, 13, 0 }, FAR = { FLAT, 2, 2, 0 },
                        HULL = { MATTE, 8, 11, 0.14 };

static uint32_t hashed(int x, int y)
{
    uint32_t h = (uint32_t)x * 374761393u + (uint32_t)y * 668265263u;

    h = (h ^ h >> 13) * 1274126177u;
    return h ^ h >> 16;
}

static double random_at(int x, int y)
{
    return (hashed(x, y) & 0xffff) / 65536.0;
}

/* ---- what is behind ---- */

/* From `top` at the upper edge to `low` at the horizon, with long clouds; stars where it is dark. */
static void sky(struct sheet *s, int horizon, double top, double low, double clouds, int stars)
{
    for (int y = 0; y < horizon; y++) {
        for (int x = 0; x < WIDE; x++) {
            double t = (double)y / horizon, v = top + (low - top) * t * t;
            double c = art_sin(y / 21.0 + 0.5 * art_sin(x / 210.0) + 0.2 * art_sin(x / 67.0 + y / 50.0)) +
                       0.5 * art_sin(x / 150.0 - y / 9.0);
            v += c > 0.55 ? clouds * (c - 0.3) : 0;
            sheet_set(s, x, y, (int)art_clamp(v + art_dither(x, y), 1, 7));
        }
    }
    for (int i = 0; i < stars; i++) {
        int x = (int)(random_at(i, 5) * WIDE), y = (int)(random_at(i, 9) * random_at(i, 3) * (horizon - 10));
        sheet_set(s, x, y, i % 5 ? 7 : 15);
    }
}

/* A disc in the sky, and the light about it. */
static void moon(struct sheet *s, double cx, double cy, double r)
{
    struct paint *p = paint_new(WIDE, HIGH);

    for (int y = 0; y < HIGH; y++) {
        for (int x = 0; x < WIDE; x++) {
            double d = sqrt((x - cx) * (x - cx) + (y - cy) * (y - cy)), near = 1 - (d - r) / (0.9 * r);
            int c = sheet_get(s, x, y);
            if (near > 0 && d > r && c && c < 7 && art_dither(x, y) < 0.7 * near * near)
                sheet_set(s, x, y, c + 1);
        }
    }
    cx -= WIDE / 2.0;
    cy -= HIGH / 2.0;
    paint_ball(p, (struct mat){ GLOW, 13, 15, 0.1 }, cx, cy, r, r, 0);
    paint_ball(p, (struct mat){ FLAT, 13, 13, 0 }, cx - 0.3 * r, cy - 0.2 * r, 0.3 * r, 0.24 * r, 0.1);
    paint_ball(p, (struct mat){ FLAT, 13, 13, 0 }, cx + 0.35 * r, cy + 0.3 * r, 0.24 * r, 0.2 * r, 0);
    paint_ball(p, (struct mat){ FLAT, 13, 13, 0 }, cx + 0.1 * r, cy - 0.5 * r, 0.14 * r, 0.12 * r, 0);
    paint_done(p, s, 0, 0, 0, 0);
}

/* Mud that has dried into plates, out to the horizon. */
static void mud(struct sheet *s, int horizon)
{
    for (int y = horizon; y < HIGH; y++) {
        for (int x = 0; x < WIDE; x++) {
            double far = 460.0 / (y - horizon + 5), u = (x - 120) * far / 460, v = far * 0.95, d1 = 9, d2 = 9;
            u *= 5.5;
            for (int j = -1; j <= 1; j++) {
                for (int i = -1; i <= 1; i++) {
                    int cx = (int)floor(u) + i, cy = (int)floor(v) + j;
                    double dx = cx + random_at(cx, cy) - u, dy = cy + random_at(cy, cx + 40) - v;
                    double d = dx * dx + dy * dy;
                    d2 = d < d1 ? d1 : d < d2 ? d : d2;
                    d1 = d < d1 ? d : d1;
                }
            }
            double edge = sqrt(d2) - sqrt(d1), near = (double)(y - horizon) / (HIGH - horizon);
            double light = 9.9 - 1.1 * near + (edge < 0.25 ? 0.5 : 0) - 0.9 * sqrt(d1);
            sheet_set(s, x, y, edge < 0.13 * near ? 8 : (int)art_clamp(light + art_dither(x, y), 8, 10));
        }
    }
}

/* Water: what is above the horizon, upside down and broken by waves; a way of light below `shine`, or 0. */
static void water(struct sheet *s, int horizon, int shine)
{
    for (int y = horizon; y < HIGH; y++) {
        double far = 30.0 / (y - horizon + 1.5);
        for (int x = 0; x < WIDE; x++) {
            double wave = art_sin(9 * far + 0.2 * art_sin(x / 90.0 * far)) + 0.7 * art_sin(x * far / 130 + 23 * far);
            int from = horizon - 1 - (int)((y - horizon) * 0.9) + (int)(wave * 2.2);
            int c = sheet_get(s, x + (int)(wave * 2), from < 0 ? 0 : from);
            double off = fabs(x - shine) / (10.0 + 0.45 * (y - horizon));
            c = c > 11 ? c - 1 : c > 7 ? c : c > 1 && (wave < 0.2 || (x + y) & 1) ? c - 1 : c;
            if (shine && off < 1 && wave > 0.3 + off * 0.8)
                c = off < 0.5 ? 14 : 13;
            sheet_set(s, x, y, c ? c : 1);
        }
    }
}

/* ---- what stands there ---- */

/* A house: its front, a gable, a window or two. */
static void house(struct paint *p, double x, double y, double w, double h, bool light)
{
    double front[] = { x, y, x, y - h, x + w / 2, y - h - 0.5 * w, x + w, y - h, x + w, y };

    paint_poly(p, NEAR, 5, front, 1.2);
    for (int i = 0; i < 2; i++)
        paint_ball(p, light ? PANE : SHADE, x + w * (0.3 + 0.4 * i), y - 0.55 * h, 1.1, 1.5, 0);
    paint_limb(p, SHADE, x + 0.8 * w, y - h - 0.2 * w, 1, x + 0.8 * w, y - h - 0.5 * w, 1);
}

/* The harbour: a wall of stone, houses on it, a tower with a light, and a bell on a frame. */
static void harbour(struct sheet *s, double y, bool awake)
{
    static const double size[][2] = { { 15, 13 }, { 12, 19 }, { 18, 12 }, { 11, 15 }, { 15, 21 }, { 13, 11 } };
    struct paint *p = paint_new(WIDE, HIGH);
    double x = -121;

    for (int i = 0; i < 6; x += size[i++][0])
        house(p, x, y - 8, size[i][0], size[i][1], awake || i == 4);
    double wall[] = { -122, y + 6, -122, y - 8, -34, y - 8, -22, y + 6 };
    paint_poly(p, (struct mat){ MATTE, 8, 10, 0 }, 4, wall, 1.5);
    for (int i = 0; i < 9; i++)
        paint_limb(p, SHADE, -116 + 9.6 * i, y - 3 + 4 * (i % 2), 0.5, -110 + 9.6 * i, y - 3 + 4 * (i % 2), 0.5);
    double tower[] = { 92, y + 4, 95, y - 38, 103, y - 38, 106, y + 4 };
    paint_ball(p, SHADE, 99, y + 4, 22, 5, 0);
    paint_poly(p, NEAR, 4, tower, 2);
    paint_limb(p, SHADE, 94, y - 39, 1.2, 104, y - 39, 1.2);
    paint_ball(p, awake ? LIT : SHADE, 99, y - 43, 3.2, 3.6, 0);
    paint_limb(p, EDGE, 95, y - 47.4, 1, 103, y - 47.4, 1);
    paint_limb(p, SHADE, -30, y - 8, 0.9, -30, y - 24, 0.9);
    paint_limb(p, SHADE, -30, y - 24, 0.9, -22, y - 24, 0.9);
    paint_ball(p, awake ? PANE : EDGE, -23, y - 20.5, 2.4, 2.8, 0);
    paint_limb(p, awake ? PANE : EDGE, -26, y - 18.2, 0.7, -20, y - 18.2, 0.7);
    paint_done(p, s, 0, 0, 0, 0);
}

/* A lamp-boat from the side, `k` times its size, leaning by `turn`. */
static void boat(struct paint *p, double x, double y, double k, double turn, bool lit)
{
    static const double hull[] = { -15, -3, -8, -4, 9, -4, 16, -6, 12, 3, 4, 6, -9, 5 };
    double c = art_cos(turn) * k, q = art_sin(turn) * k, at[14];

    for (int i = 0; i < 7; i++) {
        at[2 * i] = x + hull[2 * i] * c - hull[2 * i + 1] * q;
        at[2 * i + 1] = y + hull[2 * i] * q + hull[2 * i + 1] * c;
    }
    paint_limb(p, EDGE, x, y, 0.9 * k, x + 22 * q, y - 22 * c, 0.7 * k);
    paint_limb(p, EDGE, x + 20 * q, y - 20 * c, 0.5 * k, x + 7 * c + 19 * q, y + 7 * q - 19 * c, 0.5 * k);
    paint_poly(p, HULL, 7, at, 2.2 * k);
    paint_limb(p, SHADE, x - 8 * c, y - 8 * q, 0.6 * k, x + 9 * c, y + 9 * q, 0.6 * k);
    paint_ball(p, lit ? LIT : EDGE, x + 7 * c + 15 * q, y + 7 * q - 15 * c, (lit ? 3.4 : 2.2) * k,
               (lit ? 3.8 : 2.8) * k, 0);
}

/* A craft of the game at (x, y), its nose turned from straight up; shades: the picture's for each of the craft's. */
static void craft(struct sheet *s, void (*draw)(struct sheet *), double x, double y, double turn, double zoom,
                  const uint8_t shades[16])
{
    enum { SIDE = 72 };
    struct sheet own = art_turned(SIDE, draw, turn, zoom);

    for (int i = 0; i < SIDE * SIDE; i++)
        if (own.px[i])
            sheet_set(s, (int)x - SIDE / 2 + i % SIDE, (int)y - SIDE / 2 + i / SIDE, shades[own.px[i]]);
    sheet_free(&own);
}

/* The parts of a craft (art_palette.c: outline, 2..6 hull, 7..9 glass, 10..12 accent, 13..15 flame) by day and at
 * night. */
static const uint8_t BY_DAY[16] = { 0, 8, 9, 9, 10, 10, 11, 5, 6, 7, 12, 12, 13, 13, 14, 15 };
static const uint8_t AT_NIGHT[16] = { 0, 8, 9, 10, 11, 5, 6, 13, 14, 15, 12, 12, 12, 13, 14, 15 };

/* ---- the pictures ---- */

static struct sheet begin(int bank)
{
    return sheet_new(WIDE, HIGH, bank);
}

/* The harbour, and no sea in it. */
struct sheet art_dry(void)
{
    struct sheet s = begin(8);
    struct paint *p;

    sky(&s, 86, 1.2, 7.2, -1.2, 0);
    moon(&s, 168, 52, 24);
    mud(&s, 86);
    harbour(&s, 8, false);
    p = paint_new(WIDE, HIGH);
    paint_ball(p, SHADE, 60, 22, 13, 3, 0); /* their shadows */
    paint_ball(p, SHADE, 19, 37, 19, 4, 0);
    paint_ball(p, SHADE, -58, 61, 33, 6, 0);
    paint_ball(p, SHADE, 80, 70, 29, 6, 0);
    boat(p, 62, 18, 0.7, 0.05, false);
    boat(p, 22, 30, 1.0, -0.07, false);
    boat(p, -52, 50, 1.7, 0.06, false);
    boat(p, 84, 60, 1.5, -0.09, false);
    paint_done(p, &s, 0, 0, 8, 0);
    return s;
}

/* Lamp-boats at the brink, where the sea bed falls away. */
struct sheet art_brink(void)
{
    static const double cliff[] = { -121, 81, -121, 4, -84, 0, -60, 4, -20, -4, 14, 4, 30, 16, 34, 44, 46, 60, 44, 81 };
    static const double ledge[] = { 30, 81, 40, 52, 58, 46, 70, 54, 74, 81 };
    struct sheet s = begin(9);
    struct paint *p = paint_new(WIDE, HIGH);

    sky(&s, HIGH, 1.4, 5.5, 0.8, 70);
    for (int y = 70; y < HIGH; y++) /* the mist that comes up */
        for (int x = 130; x < WIDE; x++) {
            double v = 2 + 3.2 * (y - 70) / 90.0 + art_sin(x / 80.0 + y / 40.0);
            sheet_set(&s, x, y, (int)art_clamp(v + art_dither(x, y), 1, 7));
        }
    paint_poly(p, (struct mat){ MATTE, 8, 10, -0.1 }, 5, ledge, 4);
    paint_poly(p, NEAR, 10, cliff, 5);
    for (int i = 0; i < 26; i++) {
        double x = -112 + 6 * i + 4 * random_at(i, 1), y = 16 + 60 * random_at(i, 2);
        paint_limb(p, SHADE, x, y, 0.8, x + 7, y + 3 - 7 * random_at(i, 7), 0.5);
    }
    boat(p, -96, -9, 1.0, 0.01, true);
    boat(p, -58, -6, 1.1, 0.015, true);
    boat(p, -18, -12, 1.15, -0.02, true);
    boat(p, 20, -2, 1.2, 0.08, true);
    boat(p, 70, 30, 0.9, 0.14, true);
    boat(p, 92, 62, 0.7, 0.16, true);
    paint_done(p, &s, 0, 0, 8, 0);
    return s;
}

/* Height of the glass wave's back at x. */
static double crest(double x)
{
    double a = (x - 34) / 46, b = (x + 90) / 60;

    return 56 - 118 / (1 + a * a) - 16 / (1 + b * b);
}

static void facets(struct paint *p)
{
    enum { COLS = 15, ROWS = 6 };
    double at[COLS + 1][ROWS + 1][2];

    for (int i = 0; i <= COLS; i++) {
        for (int j = 0; j <= ROWS; j++) {
            bool inside = j > 0 && j < ROWS;
            double x = -124 + i * 248.0 / COLS + (random_at(i, j) - 0.5) * 13, top = crest(x), t = (double)j / ROWS;
            double lean = (56 - top) / 118 * (1 - t) * (1 - t); /* the crest falls over */
            at[i][j][0] = x - 74 * lean * lean;
            at[i][j][1] = top + (84 - top) * t + (inside ? (random_at(j, i + 9) - 0.5) * 12 : 0);
        }
    }
    for (int i = 0; i < COLS; i++) {
        for (int j = 0; j < ROWS; j++) {
            double *a = at[i][j], *b = at[i + 1][j], *c = at[i + 1][j + 1], *d = at[i][j + 1];
            double up[] = { a[0], a[1], b[0], b[1], c[0], c[1] }, down[] = { a[0], a[1], c[0], c[1], d[0], d[1] };
            double deep = 0.62 - 0.12 * j;
            paint_poly(p, (struct mat){ GLASS, 2, 7, deep * random_at(i, j + 50) }, 3, up, 1.6);
            paint_poly(p, (struct mat){ GLASS, 2, 7, deep * random_at(i + 50, j) - 0.06 }, 3, down, 1.6);
        }
    }
}

/* What swims in the glass. */
static void swimmers(struct paint *p)
{
    static const struct mat skin = { VEIL, 8, 11, 0.1 }, heart = { GLOW, 12, 15, 0 };
    double wing[] = { 34, 8, 50, 2, 66, 16, 48, 20 }, other[] = { 20, 8, 6, 0, -10, 12, 8, 20 };

    paint_fin(p, skin, 28, 10, 4, wing, 0.06);
    paint_fin(p, skin, 27, 10, 4, other, 0.06);
    paint_ball(p, skin, 27.5, 13, 6, 11, 0);
    paint_ball(p, heart, 27.5, 12, 3, 4, 0);
    for (int i = 0; i < 3; i++) {
        double x = -76 + 32 * i, y = 50 - 9 * (i % 2), r = 9 - 1.5 * i;
        for (int k = -1; k <= 1; k++)
            paint_limb(p, skin, x + 4 * k, y, 1.4, x + 6 * k + 2, y + 17, 0.5);
        paint_ball(p, skin, x, y, r, r * 0.9, 0);
        paint_ball(p, heart, x, y, r * 0.35, r * 0.35, 0);
    }
    paint_ball(p, heart, 80, 42, 2, 2, 0);
    paint_ball(p, heart, 92, 58, 1.6, 1.6, 0);
}

/* The tide of glass, and how small one is before it. */
struct sheet art_wave(void)
{
    struct sheet s = begin(10);
    struct paint *p = paint_new(WIDE, HIGH);

    sky(&s, HIGH, 1, 3, 0.7, 40);
    facets(p);
    swimmers(p);
    paint_done(p, &s, 0, 0, 1, 0);
    craft(&s, art_level_heron, 22, 98, 0.14, 0.8, BY_DAY);
    return s;
}

/* A cone of light from (x, y) along `turn`. */
static void cone(struct sheet *s, double x, double y, double turn, double wide, int far)
{
    double c = art_cos(turn), q = art_sin(turn);

    for (int py = 0; py < HIGH; py++) {
        for (int px = 0; px < WIDE; px++) {
            double dx = px - x, dy = py - y, along = dx * c + dy * q, off = fabs(dy * c - dx * q);
            int was = sheet_get(s, px, py);
            if (along < 0 || along > far || off > wide * along || was > 7)
                continue;
            double light = 3.6 * (1 - along / far) * (1 - off / (wide * along + 0.01)) + 1;
            sheet_set(s, px, py, (int)art_clamp(was + light + art_dither(px, py) - 0.5, 1, 7));
        }
    }
}

/* Two lamps, and the deep below them. */
struct sheet art_dive(void)
{
    struct sheet s = begin(11);
    struct paint *p = paint_new(WIDE, HIGH);

    for (int y = 0; y < HIGH; y++) {
        for (int x = 0; x < WIDE; x++) {
            double t = (double)y / HIGH,
                   rays = art_sin((x - 0.5 * y) / 46.0) + 0.6 * art_sin((x - 0.5 * y) / 19.0 + 0.3);
            double v = 6.4 * (1 - t) * (1 - t) + rays * (1 - t) * 0.9 + 0.4;
            sheet_set(&s, x, y, (int)art_clamp(v + art_dither(x, y), 1, 7));
        }
    }
    cone(&s, 160, 82, 0.17, 0.3, 110);
    cone(&s, 86, 66, 0.19, 0.3, 120);
    for (int i = 0; i < 46; i++) { /* bubbles, behind them */
        double t = random_at(i, 2), x = (i % 2 ? -66 : 8) - 40 * t + 14 * (random_at(i, 4) - 0.5), y = -40 - 36 * t;
        paint_ball(p, (struct mat){ GLASS, 5, 7, 0.3 }, x, y + (i % 2 ? 0 : 16), 0.6 + 1.2 * random_at(i, 6),
                   0.6 + 1.2 * random_at(i, 6), 0);
    }
    for (int i = 0; i < 9; i++) /* what waits down there */
        paint_ball(p, (struct mat){ FLAT, 3 + i % 2, 3 + i % 2, 0 }, -104 + 25 * i + 8 * random_at(i, 8),
                   62 + 14 * random_at(i, 1), 0.9, 0.9, 0);
    paint_done(p, &s, 0, 0, 1, 0);
    craft(&s, art_level_heron, 142, 58, 0.42, 1.6, BY_DAY);
    craft(&s, art_level_petrel, 70, 44, 0.44, 1.35, BY_DAY);
    return s;
}

/* The harbour, and the sea in it. */
struct sheet art_flood(void)
{
    struct sheet s = begin(12);
    struct paint *p;

    sky(&s, 86, 1.4, 7.4, 1.1, 0);
    harbour(&s, 4, true);
    water(&s, 86, 168);
    p = paint_new(WIDE, HIGH);
    boat(p, 62, 16, 0.7, 0.01, true);
    boat(p, 18, 26, 1.0, -0.01, true);
    boat(p, -56, 44, 1.6, 0.015, true);
    boat(p, 84, 54, 1.5, -0.02, true);
    paint_done(p, &s, 0, 0, 8, 0);
    return s;
}

/* The moon where it belongs, and two lamps on their way home. */
struct sheet art_home(void)
{
    struct sheet s = begin(14);
    struct paint *p;

    sky(&s, 96, 1, 6.2, 0.9, 90);
    moon(&s, 120, 46, 30);
    water(&s, 96, 120);
    p = paint_new(WIDE, HIGH);
    for (int i = 0; i < 7; i++)
        paint_limb(p, FAR, -122 + 14 * i, 16, 3.2 + 3 * random_at(i, 3), -108 + 14 * i, 16, 2.2 + 3 * random_at(i, 4));
    paint_done(p, &s, 0, 0, 8, 0);
    craft(&s, art_level_petrel, 78, 108, 0.05, 1.2, AT_NIGHT);
    craft(&s, art_level_heron, 160, 126, -0.04, 1.6, AT_NIGHT);
    return s;
}
