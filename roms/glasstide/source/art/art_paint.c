/*
 * art_paint.c - the modeller: shapes with normals, sampled SS x SS a pixel, lit, and voted down to clean pixels.
 *
 * Each sample remembers the last shape (part) that covered it and how bright it was there. A pixel belongs to the part
 * with the most samples and is drawn when half of it is covered: so silhouettes are smooth and there are no in-between
 * colours. Afterwards an upper part casts a short shadow to its lower right, lone pixels are healed, and the outline is
 * laid around the outside.
 */
#include "art.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SS = 6, MAX_PARTS = 1024, MAX_POINTS = 64 };

static const double LIGHT[3] = { -0.55, -0.62, 0.5596 };
static const double HALF[3] = { -0.3114, -0.3511, 0.8831 }; /* between the light and the eye */

struct sample {
    float shade;
    uint16_t part; /* 0: nothing */
};

struct paint {
    int w, h;
    bool mirror;
    double y0, y1;
    int parts;
    struct mat mat[MAX_PARTS];
    struct sample *grid;
};

struct sheet sheet_new(int w, int h, int bank)
{
    struct sheet s = { w, h, bank, calloc((size_t)w * (size_t)h, 1) };
    assert(s.px);
    return s;
}

void sheet_free(struct sheet *s)
{
    free(s->px);
    s->px = NULL;
}

void sheet_set(struct sheet *s, int x, int y, int shade)
{
    if (x >= 0 && y >= 0 && x < s->w && y < s->h)
        s->px[y * s->w + x] = (uint8_t)shade;
}

int sheet_get(const struct sheet *s, int x, int y)
{
    return x >= 0 && y >= 0 && x < s->w && y < s->h ? s->px[y * s->w + x] : 0;
}

double art_clamp(double v, double lo, double hi)
{
    return v < lo ? lo : v > hi ? hi : v;
}

double art_sway(double frame, double phase)
{
    return art_sin(frame / 4.0 + phase);
}

double art_random(uint32_t *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 8 & 0xffff) / 65536.0;
}

double art_pick(uint32_t *seed, double lo, double hi)
{
    return lo + (hi - lo) * art_random(seed);
}

double art_dither(int x, int y)
{
    static const int order[4][4] = { { 0, 8, 2, 10 }, { 12, 4, 14, 6 }, { 3, 11, 1, 9 }, { 15, 7, 13, 5 } };

    return (order[y & 3][x & 3] + 0.5) / 16;
}

/* Taylor's series on [-1/4, 1/4] turn; the error is below 1e-9, far under a shade. */
double art_sin(double turns)
{
    double t = turns - (double)(int)turns;
    if (t > 0.5)
        t -= 1;
    if (t < -0.5)
        t += 1;
    if (t > 0.25)
        t = 0.5 - t;
    if (t < -0.25)
        t = -0.5 - t;
    double x = t * 6.28318530717958648, q = x * x;
    return x * (1 + q * (-1.0 / 6 +
                         q * (1.0 / 120 + q * (-1.0 / 5040 +
                                               q * (1.0 / 362880 + q * (-1.0 / 39916800 + q * (1.0 / 6227020800)))))));
}

double art_cos(double turns)
{
    return art_sin(turns + 0.25);
}

struct paint *paint_new(int w, int h)
{
    struct paint *p = calloc(1, sizeof *p);
    assert(p);
    p->w = w;
    p->h = h;
    p->y0 = -1e9;
    p->y1 = 1e9;
    p->grid = calloc((size_t)(w * h * SS * SS), sizeof *p->grid);
    assert(p->grid);
    return p;
}

void paint_mirror(struct paint *p, bool on)
{
    p->mirror = on;
}

void paint_band(struct paint *p, double y0, double y1)
{
    p->y0 = y0;
    p->y1 = y1;
}

static int new_part(struct paint *p, struct mat m)
{
    assert(p->parts + 1 < MAX_PARTS);
    p->mat[++p->parts] = m;
    return p->parts;
}

static double highlight(double nx, double ny, double nz)
{
    return nx * HALF[0] + ny * HALF[1] + nz * HALF[2];
}

/* Brightness 0..1 of a surface with the unit normal n. */
static double lit(struct mat m, double nx, double ny, double nz)
{
    double towards = nx * LIGHT[0] + ny * LIGHT[1] + nz * LIGHT[2];
    double through = -(nx * LIGHT[0] + ny * LIGHT[1]);
    double rim = 1 - nz, s = m.level;
    switch (m.style) {
    case MATTE:
        s += 0.10 + 0.78 * (towards > 0 ? towards : 0);
        return highlight(nx, ny, nz) > 0.975 ? s + 0.25 : s;
    case GLASS:
    case VEIL:
        s += 0.20 + 0.62 * (through > 0 ? through : 0) + 0.24 * rim * rim + 0.16 * (towards > 0 ? towards : 0);
        return highlight(nx, ny, nz) > 0.968 ? 1 : s;
    case GLOW:
        return s + 0.05 + 0.95 * nz * nz;
    case FLAT:
        break;
    }
    return s;
}

static void put(struct paint *p, int part, int sx, int sy, double shade)
{
    struct sample *g = &p->grid[sy * p->w * SS + sx];
    if (p->mat[part].style == VEIL && g->part && p->mat[g->part].lo == p->mat[part].lo)
        shade = 0.55 * shade + 0.55 * (double)g->shade;
    g->shade = (float)art_clamp(shade, 0, 0.9999);
    g->part = (uint16_t)part;
}

/* A shape answers for a point: is it inside, and how bright is it there? */
typedef bool shape_fn(const void *shape, struct mat m, double x, double y, double *shade);

static void scan(struct paint *p, int part, const void *shape, shape_fn *f, double x0, double y0, double x1, double y1)
{
    double cx = p->w * 0.5, cy = p->h * 0.5;
    int sx0 = (int)art_clamp((x0 + cx) * SS - 1, 0, p->w * SS), sx1 = (int)art_clamp((x1 + cx) * SS + 2, 0, p->w * SS);
    int sy0 = (int)art_clamp((y0 + cy) * SS - 1, 0, p->h * SS), sy1 = (int)art_clamp((y1 + cy) * SS + 2, 0, p->h * SS);
    for (int sy = sy0; sy < sy1; sy++) {
        double y = (sy + 0.5) / SS - cy, shade;
        if (y < p->y0 || y > p->y1)
            continue;
        for (int sx = sx0; sx < sx1; sx++) {
            if (f(shape, p->mat[part], (sx + 0.5) / SS - cx, y, &shade))
                put(p, part, sx, sy, shade);
        }
    }
}

struct ball {
    double x, y, rx, ry, c, s;
};

static bool in_ball(const void *shape, struct mat m, double x, double y, double *shade)
{
    const struct ball *b = shape;
    double dx = x - b->x, dy = y - b->y;
    double u = (dx * b->c + dy * b->s) / b->rx, v = (dy * b->c - dx * b->s) / b->ry;
    double q = u * u + v * v;
    if (q > 1)
        return false;
    *shade = lit(m, u * b->c - v * b->s, u * b->s + v * b->c, sqrt(1 - q));
    return true;
}

static void ball_once(struct paint *p, struct mat m, double x, double y, double rx, double ry, double turn)
{
    struct ball b = { x, y, rx, ry, art_cos(turn), art_sin(turn) };
    double r = rx > ry ? rx : ry;
    scan(p, new_part(p, m), &b, in_ball, x - r, y - r, x + r, y + r);
}

void paint_ball(struct paint *p, struct mat m, double x, double y, double rx, double ry, double turn)
{
    ball_once(p, m, x, y, rx, ry, turn);
    if (p->mirror)
        ball_once(p, m, -x, y, rx, ry, -turn);
}

struct limb {
    double ax, ay, ra, bx, by, rb;
};

static bool in_limb(const void *shape, struct mat m, double x, double y, double *shade)
{
    const struct limb *l = shape;
    double wx = l->bx - l->ax, wy = l->by - l->ay, len = wx * wx + wy * wy;
    double t = len > 0 ? art_clamp(((x - l->ax) * wx + (y - l->ay) * wy) / len, 0, 1) : 0;
    double dx = x - l->ax - t * wx, dy = y - l->ay - t * wy, r = l->ra + t * (l->rb - l->ra);
    double q = dx * dx + dy * dy;
    if (q > r * r || r <= 0)
        return false;
    *shade = lit(m, dx / r, dy / r, sqrt(1 - q / (r * r)));
    return true;
}

static void limb_scan(struct paint *p, int part, const struct limb *l)
{
    double r = l->ra > l->rb ? l->ra : l->rb;
    double x0 = l->ax < l->bx ? l->ax : l->bx, x1 = l->ax < l->bx ? l->bx : l->ax;
    double y0 = l->ay < l->by ? l->ay : l->by, y1 = l->ay < l->by ? l->by : l->ay;
    scan(p, part, l, in_limb, x0 - r, y0 - r, x1 + r, y1 + r);
}

void paint_limb(struct paint *p, struct mat m, double ax, double ay, double ra, double bx, double by, double rb)
{
    struct limb l = { ax, ay, ra, bx, by, rb }, r = { -ax, ay, ra, -bx, by, rb };
    limb_scan(p, new_part(p, m), &l);
    if (p->mirror)
        limb_scan(p, new_part(p, m), &r);
}

static void curve_once(struct paint *p, struct mat m, const double a[2], const double c[2], const double b[2],
                       double ra, double rb, double side)
{
    enum { STEPS = 24 };
    int part = new_part(p, m);
    double x = side * a[0], y = a[1], r = ra;
    for (int i = 1; i <= STEPS; i++) {
        double t = (double)i / STEPS, u = 1 - t;
        double nx = side * (u * u * a[0] + 2 * u * t * c[0] + t * t * b[0]);
        double ny = u * u * a[1] + 2 * u * t * c[1] + t * t * b[1], nr = ra + t * (rb - ra);
        struct limb l = { x, y, r, nx, ny, nr };
        limb_scan(p, part, &l);
        x = nx;
        y = ny;
        r = nr;
    }
}

void paint_curve(struct paint *p, struct mat m, const double a[2], const double c[2], const double b[2], double ra,
                 double rb)
{
    curve_once(p, m, a, c, b, ra, rb, 1);
    if (p->mirror)
        curve_once(p, m, a, c, b, ra, rb, -1);
}

void paint_bow(struct paint *p, struct mat m, double ax, double ay, double cx, double cy, double bx, double by,
               double ra, double rb)
{
    paint_curve(p, m, (double[]){ ax, ay }, (double[]){ cx, cy }, (double[]){ bx, by }, ra, rb);
}

struct poly {
    int n;
    double xy[2 * MAX_POINTS], bevel;
};

static bool in_poly(const void *shape, struct mat m, double x, double y, double *shade)
{
    const struct poly *q = shape;
    double best = 1e9, bx = 0, by = 0;
    bool inside = false;
    for (int i = 0, j = q->n - 1; i < q->n; j = i++) {
        double xi = q->xy[2 * i], yi = q->xy[2 * i + 1], xj = q->xy[2 * j], yj = q->xy[2 * j + 1];
        if ((yi > y) != (yj > y) && x < (xj - xi) * (y - yi) / (yj - yi) + xi)
            inside = !inside;
        double ex = xj - xi, ey = yj - yi, len = ex * ex + ey * ey;
        double t = len > 0 ? art_clamp(((x - xi) * ex + (y - yi) * ey) / len, 0, 1) : 0;
        double dx = xi + t * ex - x, dy = yi + t * ey - y, d = dx * dx + dy * dy;
        if (d < best) {
            best = d;
            bx = dx;
            by = dy;
        }
    }
    if (!inside)
        return false;
    double d = sqrt(best), tilt = d < q->bevel && d > 0 ? 0.8 * (1 - d / q->bevel) : 0;
    *shade = tilt > 0 ? lit(m, bx / d * tilt, by / d * tilt, sqrt(1 - tilt * tilt)) : lit(m, 0, 0, 1);
    return true;
}

static void poly_once(struct paint *p, struct mat m, int n, const double *xy, double bevel, double side)
{
    struct poly q = { .n = n, .bevel = bevel };
    double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
    assert(n <= MAX_POINTS);
    for (int i = 0; i < n; i++) {
        double x = side * xy[2 * i], y = xy[2 * i + 1];
        q.xy[2 * i] = x;
        q.xy[2 * i + 1] = y;
        x0 = x < x0 ? x : x0;
        x1 = x > x1 ? x : x1;
        y0 = y < y0 ? y : y0;
        y1 = y > y1 ? y : y1;
    }
    scan(p, new_part(p, m), &q, in_poly, x0, y0, x1, y1);
}

void paint_poly(struct paint *p, struct mat m, int n, const double *xy, double bevel)
{
    poly_once(p, m, n, xy, bevel, 1);
    if (p->mirror)
        poly_once(p, m, n, xy, bevel, -1);
}

struct fin {
    int n;
    double x, y, sag, tips[2 * MAX_POINTS];
};

/* In the sector of two ribs a point is root + a * rib + b * next; a + b runs from 0 at the root to 1 at the chord. */
static bool in_fin(const void *shape, struct mat m, double x, double y, double *shade)
{
    const struct fin *f = shape;
    for (int i = 0; i + 1 < f->n; i++) {
        double ux = f->tips[2 * i] - f->x, uy = f->tips[2 * i + 1] - f->y;
        double vx = f->tips[2 * i + 2] - f->x, vy = f->tips[2 * i + 3] - f->y;
        double det = ux * vy - uy * vx, px = x - f->x, py = y - f->y;
        if (det < 1e-6 && det > -1e-6)
            continue;
        double a = (px * vy - py * vx) / det, b = (ux * py - uy * px) / det, far = a + b;
        if (a < 0 || b < 0 || far <= 0)
            continue;
        double across = b / far, edge = 1 - f->sag * 4 * across * (1 - across);
        if (far > edge)
            continue;
        double rib = across < 0.5 ? 1 - 2 * across : 2 * across - 1;
        *shade = m.level + 0.12 + 0.40 * rib * rib * rib + 0.34 * far * far + (far > edge - 0.1 ? 0.22 : 0);
        return true;
    }
    return false;
}

static void fin_once(struct paint *p, struct mat m, double x, double y, int n, const double *tips, double sag,
                     double side)
{
    struct fin f = { .n = n, .x = side * x, .y = y, .sag = sag };
    double x0 = f.x, y0 = y, x1 = f.x, y1 = y;
    assert(n <= MAX_POINTS);
    for (int i = 0; i < n; i++) {
        double tx = side * tips[2 * i], ty = tips[2 * i + 1];
        f.tips[2 * i] = tx;
        f.tips[2 * i + 1] = ty;
        x0 = tx < x0 ? tx : x0;
        x1 = tx > x1 ? tx : x1;
        y0 = ty < y0 ? ty : y0;
        y1 = ty > y1 ? ty : y1;
    }
    scan(p, new_part(p, m), &f, in_fin, x0, y0, x1, y1);
}

void paint_fin(struct paint *p, struct mat m, double x, double y, int n, const double *tips, double sag)
{
    fin_once(p, m, x, y, n, tips, sag, 1);
    if (p->mirror)
        fin_once(p, m, x, y, n, tips, sag, -1);
}

struct stroke {
    int n;
    double seg[4 * MAX_POINTS], r, bevel;
};

static bool in_stroke(const void *shape, struct mat m, double x, double y, double *shade)
{
    const struct stroke *k = shape;
    double best = 1e9, bx = 0, by = 0;
    for (int i = 0; i < k->n; i++) {
        const double *s = &k->seg[4 * i];
        double wx = s[2] - s[0], wy = s[3] - s[1], len = wx * wx + wy * wy;
        double t = len > 0 ? art_clamp(((x - s[0]) * wx + (y - s[1]) * wy) / len, 0, 1) : 0;
        double dx = x - s[0] - t * wx, dy = y - s[1] - t * wy, d = dx * dx + dy * dy;
        if (d < best) {
            best = d;
            bx = dx;
            by = dy;
        }
    }
    double d = sqrt(best), depth = k->r - d;
    if (depth < 0)
        return false;
    double tilt = depth < k->bevel && d > 0 ? 0.85 * (1 - depth / k->bevel) : 0;
    *shade = tilt > 0 ? lit(m, bx / d * tilt, by / d * tilt, sqrt(1 - tilt * tilt)) : lit(m, 0, 0, 1);
    return true;
}

void paint_stroke(struct paint *p, struct mat m, int n, const double *segs, double r, double bevel)
{
    struct stroke k = { .n = n, .r = r, .bevel = bevel };
    double half_w = p->w * 0.5, half_h = p->h * 0.5;
    assert(n <= MAX_POINTS);
    for (int i = 0; i < 4 * n; i++)
        k.seg[i] = segs[i];
    scan(p, new_part(p, m), &k, in_stroke, -half_w, -half_h, half_w, half_h);
}

/* The part that owns most of a pixel, 0 when less than half of it is covered; *shade is its mean there. */
static int vote(const struct paint *p, int x, int y, double *shade)
{
    int parts[SS * SS], counts[SS * SS], kinds = 0, covered = 0, best = 0;
    double sums[SS * SS];
    for (int i = 0; i < SS * SS; i++) {
        const struct sample *g = &p->grid[(y * SS + i / SS) * p->w * SS + x * SS + i % SS];
        int k = 0;
        if (!g->part)
            continue;
        covered++;
        while (k < kinds && parts[k] != g->part)
            k++;
        if (k == kinds) {
            parts[kinds] = g->part;
            counts[kinds] = 0;
            sums[kinds++] = 0;
        }
        counts[k]++;
        sums[k] += (double)g->shade;
    }
    if (2 * covered < SS * SS)
        return 0;
    for (int k = 1; k < kinds; k++) {
        if (counts[k] > counts[best])
            best = k;
    }
    *shade = sums[best] / counts[best];
    return parts[best];
}

static int shade_of(struct mat m, double s)
{
    int n = m.hi - m.lo + 1, i = (int)(s * n);
    return m.lo + (i < 0 ? 0 : i >= n ? n - 1 : i);
}

/* A pixel all of whose neighbours agree on another shade of its own ramp takes theirs. */
static void heal(struct sheet *s, const struct sheet *part)
{
    for (int y = 1; y + 1 < s->h; y++) {
        for (int x = 1; x + 1 < s->w; x++) {
            int c = sheet_get(s, x, y - 1), me = sheet_get(s, x, y);
            if (c && me && c != me && me < 14 && c == sheet_get(s, x - 1, y) && c == sheet_get(s, x + 1, y) &&
                c == sheet_get(s, x, y + 1) && sheet_get(part, x, y) == sheet_get(part, x, y - 1))
                sheet_set(s, x, y, c);
        }
    }
}

static void outline(const struct sheet *from, struct sheet *to, int x0, int y0, int rim, int bright)
{
    for (int y = 0; y < from->h; y++) {
        for (int x = 0; x < from->w; x++) {
            int c = sheet_get(from, x, y);
            bool up = sheet_get(from, x, y - 1), left = sheet_get(from, x - 1, y);
            bool down = sheet_get(from, x, y + 1), right = sheet_get(from, x + 1, y);
            if (!c && (up || left))
                c = rim;
            else if (!c && (down || right))
                c = bright;
            if (c)
                sheet_set(to, x0 + x, y0 + y, c);
        }
    }
}

static void crack_line(struct paint *p, struct mat m, double x, double y, double turn, double length, double r,
                       uint32_t seed)
{
    enum { STEPS = 5 };

    for (int i = 0; i < STEPS; i++) {
        double t = turn + art_pick(&seed, -0.11, 0.11), far = length / STEPS, thin = r * (1 - 0.14 * i);
        double nx = x + far * art_cos(t), ny = y + far * art_sin(t);
        paint_limb(p, m, x, y, thin, nx, ny, thin * 0.86);
        x = nx;
        y = ny;
        if (i == 1 && length > 11)
            crack_line(p, m, x, y, turn + (seed & 256 ? 0.14 : -0.14), length * 0.5, r * 0.8, seed);
    }
}

void paint_cracks(struct paint *p, int wounds, struct mat glow, const double at[6][4], uint32_t seed)
{
    const double r = wounds > 1 ? 1.25 : 1;

    glow = wounds > 1 ? glow : (struct mat){ FLAT, glow.lo, glow.lo + 1, 0.6 };
    for (int i = 0; i < 3 * wounds; i++) {
        const double *c = at[i];
        crack_line(p, (struct mat){ FLAT, 1, 1, 0 }, c[0], c[1], c[2], c[3], 1.35 * r, seed + (uint32_t)i);
        crack_line(p, glow, c[0], c[1], c[2], c[3] * 0.85, 0.75 * r, seed + (uint32_t)i);
    }
}

void art_boss(struct sheet *s, int w, int h, void (*draw)(struct sheet *, int, int, struct state))
{
    for (int i = 0; i < BOSS_FRAMES; i++) {
        struct state now = { i * 4.0 / BOSS_FRAMES, false, 0 };
        draw(s, w * i, 0, now);
        draw(s, w * i, h, (struct state){ now.frame, true, 0 });
        for (now.wounds = 1; now.wounds < 3; now.wounds++) {
            struct sheet own = sheet_new(w, h, 0);
            draw(&own, 0, 0, now);
            for (int k = 0; k < w * h; k++) {
                int c = own.px[k], whole = sheet_get(s, w * i + k % w, k / w);
                if (c && whole && c != whole)
                    sheet_set(s, w * i + k % w, h * (1 + now.wounds) + k / w, c);
            }
            sheet_free(&own);
        }
    }
}

void paint_roll(struct paint *p, double roll)
{
    const int w = p->w * SS, h = p->h * SS;
    struct sample *row = calloc((size_t)w, sizeof *row);
    assert(row);
    for (int y = 0; y < h; y++) {
        memcpy(row, p->grid + y * w, (size_t)w * sizeof *row);
        for (int x = 0; x < w; x++) {
            double dx = x + 0.5 - w * 0.5, dip = dx * roll > 0 ? roll * roll : 0, side = dx * roll / (w * 0.5);
            int from = (int)(w * 0.5 + dx / (1 - 0.38 * dip - 0.10 * (roll * roll - dip)));
            struct sample *s = p->grid + y * w + x;
            *s = from >= 0 && from < w ? row[from] : (struct sample){ 0 };
            s->shade -= (float)(0.34 * side);
        }
    }
    free(row);
}

/* How a scene is turned, stretched and lit before it becomes pixels. */
struct pose {
    double turn, wide, tall, light;
};

enum { POSES = 4 };
static const struct pose AT_REST = { 0, 1, 1, 0 };
static const struct pose LIST[POSES] = {
    { 0.05, 0.97, 1, 0 }, { -0.05, 0.97, 1, 0 }, { 0, 1.03, 0.86, 0.1 }, { 0, 0.97, 1.05, 0.17 }
};
static const struct pose *pose = &AT_REST;

static void strike_pose(struct paint *p)
{
    const int w = p->w * SS, h = p->h * SS;
    const double c = art_cos(pose->turn), s = art_sin(pose->turn);
    struct sample *from = p->grid;

    p->grid = calloc((size_t)(w * h), sizeof *p->grid);
    assert(p->grid);
    for (int y = 0; y < h; y++) {
        for (int x = 0; x < w; x++) {
            double dx = x + 0.5 - w * 0.5, dy = y + 0.5 - h * 0.5;
            int u = (int)(w * 0.5 + (dx * c + dy * s) / pose->wide),
                v = (int)(h * 0.5 + (dy * c - dx * s) / pose->tall);
            if (u < 0 || v < 0 || u >= w || v >= h || !from[v * w + u].part)
                continue;
            p->grid[y * w + x] = from[v * w + u];
            p->grid[y * w + x].shade = (float)art_clamp((double)from[v * w + u].shade + pose->light, 0, 0.9999);
        }
    }
    free(from);
}

struct sheet art_poses(struct sheet (*draw)(void))
{
    struct sheet all = { 0 };

    for (int k = 0; k < POSES; k++) {
        pose = &LIST[k];
        struct sheet s = draw();
        if (k == 0)
            all = sheet_new(s.w, POSES * s.h, s.bank);
        memcpy(all.px + k * s.w * s.h, s.px, (size_t)(s.w * s.h));
        sheet_free(&s);
    }
    pose = &AT_REST;
    return all;
}

/* How scenes are drawn into a picture of another size: the surroundings of (cx, cy), turned and magnified, in the band
 * of a cut-in or on nothing. NULL: as they are. */
static const struct cut {
    int w, h;
    double cx, cy, turn, zoom;
    bool band;
} * cut;

int art_band(double x, double y)
{
    double dx = x - CUT_W / 2.0 + 0.5 * (y - CUT_H / 2.0), dy = y - CUT_H / 2.0;
    double in_x = CUT_W / 2.0 - CUT_H / 4.0 - 1 - (dx < 0 ? -dx : dx), in_y = CUT_H / 2.0 - 1 - (dy < 0 ? -dy : dy);

    return in_x < 0 || in_y < 0 ? 0 : in_x < 2 || in_y < 1.5 ? 1 : 2;
}

int art_streak(int x, int y)
{
    uint32_t seed = 97u * (uint32_t)y + 5;
    double from = art_pick(&seed, -60, CUT_W), far = art_pick(&seed, 30, 110), r = art_random(&seed);

    return x < from || x > from + far ? 1 : r < 0.4 ? 2 : r < 0.7 ? 3 : 1;
}

static void cut_out(struct paint *p)
{
    const int w = cut->w * SS, h = cut->h * SS;
    const double c = art_cos(cut->turn), q = art_sin(cut->turn);
    struct sample *from = p->grid;
    int ground[4];

    for (int i = 0; i < 4; i++)
        ground[i] = new_part(p, (struct mat){ FLAT, i ? i : 15, i ? i : 15, 0 });
    p->grid = calloc((size_t)(w * h), sizeof *p->grid);
    assert(p->grid);
    for (int y = 0; y < h; y++) {
        for (int x = 0; x < w; x++) {
            double px = (x + 0.5) / SS, py = (y + 0.5) / SS;
            double dx = (px - cut->w / 2.0) / cut->zoom, dy = (py - cut->h / 2.0) / cut->zoom;
            int band = cut->band ? art_band(px, py) : 2;
            int u = (int)((p->w / 2.0 + cut->cx + dx * c + dy * q) * SS);
            int v = (int)((p->h / 2.0 + cut->cy + dy * c - dx * q) * SS);
            struct sample *s = &p->grid[y * w + x];
            if (band == 2 && u >= 0 && v >= 0 && u < p->w * SS && v < p->h * SS && from[v * p->w * SS + u].part)
                *s = from[v * p->w * SS + u];
            else if (cut->band && band)
                s->part = (uint16_t)ground[band == 1 ? 0 : art_streak((int)px, (int)py)];
        }
    }
    p->w = cut->w;
    p->h = cut->h;
    free(from);
}

void art_cut_in(struct sheet *s, int y, void (*draw)(struct sheet *), double cx, double cy, double zoom)
{
    struct sheet own = sheet_new(CUT_W, CUT_H, 0);
    struct cut here = { CUT_W, CUT_H, cx, cy, 0, zoom, true };

    cut = &here;
    draw(&own);
    cut = NULL;
    for (int i = 0; i < CUT_W * CUT_H; i++)
        sheet_set(s, i % CUT_W, y + i / CUT_W, own.px[i]);
    sheet_free(&own);
}

struct sheet art_turned(int side, void (*draw)(struct sheet *), double turn, double zoom)
{
    struct sheet own = sheet_new(side, side, 0);
    struct cut here = { side, side, 0, 0, turn, zoom, false };

    cut = &here;
    draw(&own);
    cut = NULL;
    return own;
}

void paint_done(struct paint *p, struct sheet *s, int x0, int y0, int rim, int bright)
{
    if (cut)
        cut_out(p);
    struct sheet own = sheet_new(p->w, p->h, 0), part = sheet_new(p->w, p->h, 0);
    if (pose != &AT_REST)
        strike_pose(p);
    for (int y = 0; y < p->h; y++) {
        for (int x = 0; x < p->w; x++) {
            double shade = 0, other;
            int id = vote(p, x, y, &shade);
            if (!id)
                continue;
            struct mat m = p->mat[id];
            int above = y > 0 ? vote(p, x, y - 1, &other) : 0, beside = x > 0 ? vote(p, x - 1, y, &other) : 0;
            int c = shade_of(m, shade);
            if ((above > id + 1 || beside > id + 1) && m.style != GLOW && c > m.lo)
                c -= c > m.lo + 1 ? 2 : 1;
            sheet_set(&own, x, y, c);
            sheet_set(&part, x, y, id);
        }
    }
    heal(&own, &part);
    outline(&own, s, x0, y0, rim, bright);
    sheet_free(&own);
    sheet_free(&part);
    free(p->grid);
    free(p);
}
