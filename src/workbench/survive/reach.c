/*
 * reach.c - see reach.h.
 *
 * In a frame, a ship has 17 moves. For each move and danger, the start positions from which the ship is hit form a
 * convex shape: for a circle, all positions within the sum of the radii of the line along which the two approach each
 * other. A run of cells in a row is inside the shape if its upper and its lower edge are. The other cells are shifted
 * by the move, into every cell that they could overlap. At the area's edge a ship stops, so moves that are clamped
 * there are only checked at their end.
 */
#include "reach.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/int.h"
#include "../../entities/player.h"

#define MARGIN (1.0 / 64) /* px; far above the rounding errors of doubles */

/* ---- moves ---- */

uint16_t reach_move_pads(int move)
{
    static const uint16_t compass[9] = { 0,
                                         PAD_LEFT,
                                         PAD_RIGHT,
                                         PAD_UP,
                                         PAD_DOWN,
                                         PAD_LEFT | PAD_UP,
                                         PAD_RIGHT | PAD_UP,
                                         PAD_LEFT | PAD_DOWN,
                                         PAD_RIGHT | PAD_DOWN };

    return move < 9 ? compass[move] : (uint16_t)(compass[move - 8] | PAD_FOCUS);
}

static void move_vector(const struct danger_ship *ship, int move, fx *mx, fx *my)
{
    const uint16_t pads = reach_move_pads(move);
    const int dx = !!(pads & PAD_RIGHT) - !!(pads & PAD_LEFT), dy = !!(pads & PAD_DOWN) - !!(pads & PAD_UP);
    fx speed = pads & PAD_FOCUS ? ship->focused_speed : ship->speed;

    if (dx && dy)
        speed = fx_mul(speed, PLAYER_DIAGONAL_FACTOR);
    *mx = dx * speed;
    *my = dy * speed;
}

void reach_apply_move(const struct danger_ship *ship, int move, fx *x, fx *y)
{
    fx mx, my;

    move_vector(ship, move, &mx, &my);
    *x = fx_clamp(fx_clamp(*x, ship->area.x0, ship->area.x1) + mx, ship->area.x0, ship->area.x1);
    *y = fx_clamp(fx_clamp(*y, ship->area.y0, ship->area.y1) + my, ship->area.y0, ship->area.y1);
}

/* ---- sets ---- */

static uint8_t *get_set(const struct reach *r, uint32_t t)
{
    return r->sets + (size_t)t * r->bytes;
}

static void pack_set(const struct reach *r, const uint8_t *cells, uint8_t *set)
{
    const size_t n = (size_t)r->w * (size_t)r->h;

    for (size_t i = 0; i + 8 <= n; i += 8) {
        uint8_t bits = 0;
        for (int k = 0; k < 8; k++)
            bits |= (uint8_t)(cells[i + (size_t)k] << k);
        set[i / 8] = bits;
    }
    if (n % 8)
        set[n / 8] = 0;
    for (size_t i = n / 8 * 8; i < n; i++)
        set[i / 8] |= (uint8_t)(cells[i] << i % 8);
}

static void unpack_set(const struct reach *r, const uint8_t *set, uint8_t *cells)
{
    const size_t n = (size_t)r->w * (size_t)r->h;

    for (size_t i = 0; i < n; i++)
        cells[i] = set[i / 8] >> i % 8 & 1;
}

/* Computes the bounds of the current set. */
static void update_bounds(struct reach *r)
{
    r->x0 = r->w;
    r->y0 = r->h;
    r->x1 = r->y1 = -1;
    for (int y = 0; y < r->h; y++) {
        const uint8_t *row = r->current + (size_t)y * (size_t)r->w;
        const uint8_t *first = memchr(row, 1, (size_t)r->w);
        if (!first)
            continue;
        int last = r->w - 1;
        while (!row[last])
            last--;
        r->y0 = r->y0 < y ? r->y0 : y;
        r->y1 = y;
        r->x0 = first - row < r->x0 ? (int)(first - row) : r->x0;
        r->x1 = last > r->x1 ? last : r->x1;
    }
}

/* ---- dangers ---- */

/* The start positions from which a move is hit, in px from the area's corner: all within r of the line from p to q; or,
 * if half_w >= 0, all within r of a box around p. */
struct hit_shape {
    double px, py, qx, qy, r, half_w, half_h;
    double ox, oy; /* offset from the line to one of its parallel edges; 0, 0: p is q */
};

static void widen(double *lo, double *hi, double a, double b)
{
    *lo = a < *lo ? a : *lo;
    *hi = b > *hi ? b : *hi;
}

static void widen_circle(double *lo, double *hi, double x, double y, double r, double at)
{
    const double rest = r * r - (at - y) * (at - y);

    if (rest >= 0)
        widen(lo, hi, x - sqrt(rest), x + sqrt(rest));
}

/* Computes the interval in which the horizontal line at y crosses the shape; lo > hi: none. */
static void row_interval(const struct hit_shape *k, double y, double *lo, double *hi)
{
    *lo = INFINITY;
    *hi = -INFINITY;
    if (k->half_w >= 0) {
        const double above = fabs(y - k->py) - k->half_h;
        if (above <= 0)
            widen(lo, hi, k->px - k->half_w - k->r, k->px + k->half_w + k->r);
        else if (above <= k->r)
            widen(lo, hi, k->px - k->half_w - sqrt(k->r * k->r - above * above),
                  k->px + k->half_w + sqrt(k->r * k->r - above * above));
        return;
    }
    widen_circle(lo, hi, k->px, k->py, k->r, y);
    if (k->ox == 0 && k->oy == 0)
        return;
    widen_circle(lo, hi, k->qx, k->qy, k->r, y);
    const double dy = k->qy - k->py;
    for (int side = -1; dy != 0 && side <= 1; side += 2) {
        const double at = (y - k->py - side * k->oy) / dy;
        if (at >= 0 && at <= 1)
            widen(lo, hi, k->px + side * k->ox + at * (k->qx - k->px), k->px + side * k->ox + at * (k->qx - k->px));
    }
}

/* The cells from which a move is not clamped at the area's edge. */
struct window {
    int x0, y0, x1, y1;
};

static void mark_row(struct reach *r, int row, double lo, double hi, const struct window *w)
{
    const double cell = r->cell / (double)FX_ONE;
    const double first = ceil((lo + MARGIN) / cell), last = floor((hi - MARGIN) / cell) - 1;

    if (first > w->x1 ||
        last < w->x0) /* before the conversions to int: both are infinite if the line misses the shape */
        return;
    const int x0 = first > w->x0 ? (int)first : w->x0, x1 = last < w->x1 ? (int)last : w->x1;
    if (x1 >= x0)
        memset(r->hit + (size_t)row * (size_t)r->w + x0, 1, (size_t)(x1 - x0 + 1));
}

/* Marks the cells that are completely inside the shape. */
static void mark_shape(struct reach *r, struct hit_shape *k, const struct window *w)
{
    const double cell = r->cell / (double)FX_ONE, far = k->r + (k->half_w >= 0 ? k->half_h : 0);
    const double top = (k->py < k->qy ? k->py : k->qy) - far, bottom = (k->py > k->qy ? k->py : k->qy) + far;
    const double side = k->r + (k->half_w >= 0 ? k->half_w : 0);
    const double left = (k->px < k->qx ? k->px : k->qx) - side, right = (k->px > k->qx ? k->px : k->qx) + side;
    double lo, hi, next_lo, next_hi;

    if (bottom < w->y0 * cell || top > (w->y1 + 1) * cell || right < w->x0 * cell || left > (w->x1 + 1) * cell)
        return;
    const int y0 = top / cell > w->y0 ? (int)(top / cell) : w->y0;
    const int y1 = bottom / cell < w->y1 ? (int)(bottom / cell) : w->y1;
    const double dx = k->qx - k->px, dy = k->qy - k->py, length = sqrt(dx * dx + dy * dy);
    k->ox = length > 0 ? -dy / length * k->r : 0;
    k->oy = length > 0 ? dx / length * k->r : 0;
    row_interval(k, y0 * cell, &lo, &hi);
    for (int y = y0; y <= y1; y++, lo = next_lo, hi = next_hi) {
        row_interval(k, (y + 1) * cell, &next_lo, &next_hi);
        mark_row(r, y, lo > next_lo ? lo : next_lo, hi < next_hi ? hi : next_hi, w);
    }
}

static double px(int64_t v)
{
    return (double)v / FX_ONE;
}

/* Marks the cells from which a danger certainly hits the ship on a move by (mx, my). For complex shapes, it marks only
 * a part of them. */
static void mark_danger(struct reach *r, const struct danger *d, fx radius, fx mx, fx my, const struct window *w)
{
    const double x = px((int64_t)d->x - mx - r->area.x0), y = px((int64_t)d->y - my - r->area.y0);
    const double was_x = px((int64_t)d->x - d->mx - r->area.x0), was_y = px((int64_t)d->y - d->my - r->area.y0);
    struct hit_shape k = { x, y, x, y, px((int64_t)d->a + radius), -1, -1, 0, 0 };

    if (d->shape == DANGER_BOX) {
        k.r = px(radius);
        k.half_w = px(d->a);
        k.half_h = px(d->b);
        mark_shape(r, &k, w);
        k.px = k.qx = (x + was_x) / 2;
        k.py = k.qy = (y + was_y) / 2;
        if (d->swept)
            mark_shape(r, &k, w);
        return;
    }
    if (d->shape == DANGER_LASER_SEGMENT) {
        k.qx = px((int64_t)d->b - mx - r->area.x0);
        k.qy = px((int64_t)d->c - my - r->area.y0);
        mark_shape(r, &k, w);
        return;
    }
    if (d->swept) {
        k.qx = was_x;
        k.qy = was_y;
    }
    mark_shape(r, &k, w);
    if (d->shape == DANGER_CAPSULE) {
        k = (struct hit_shape){ x - px(d->b), y - px(d->c), x + px(d->b), y + px(d->c), k.r, -1, -1, 0, 0 };
        mark_shape(r, &k, w);
    }
}

/* Returns the window of a move by (mx, my), within the bounds of the current set. */
static struct window move_window(const struct reach *r, fx mx, fx my)
{
    const int left = mx < 0 ? (-mx + r->cell - 1) / r->cell : 0, right = mx > 0 ? mx / r->cell + 2 : 0;
    const int top = my < 0 ? (-my + r->cell - 1) / r->cell : 0, bottom = my > 0 ? my / r->cell + 2 : 0;
    struct window w = { left, top, r->w - 1 - right, r->h - 1 - bottom };

    w.x0 = w.x0 > r->x0 ? w.x0 : r->x0;
    w.y0 = w.y0 > r->y0 ? w.y0 : r->y0;
    w.x1 = w.x1 < r->x1 ? w.x1 : r->x1;
    w.y1 = w.y1 < r->y1 ? w.y1 : r->y1;
    return w;
}

/* Sets r->hit: the cells from which a move in this frame is certainly hit. */
static void mark_hits(struct reach *r, const struct forecast_frame *frame, fx mx, fx my)
{
    const struct window w = move_window(r, mx, my);

    for (int y = r->y0; y <= r->y1; y++)
        memset(r->hit + (size_t)y * (size_t)r->w, 0, (size_t)r->w);
    if (frame->safe || w.x1 < w.x0 || w.y1 < w.y0)
        return;
    for (uint32_t i = 0; i < frame->n; i++)
        mark_danger(r, &r->f->list[frame->first + i], frame->ship.path.radius + r->extra_radius, mx, my, &w);
}

/* ---- moving a set ---- */

/* Returns v in whole cells, rounded down. */
static int floor_cells(const struct reach *r, fx v)
{
    return v >= 0 ? v / r->cell : -((-v + r->cell - 1) / r->cell);
}

/* Computes to[i] |= from[i] & ~dead[i] for n bytes of 0 or 1. */
static void or_and_not(uint8_t *to, const uint8_t *from, const uint8_t *dead, int n)
{
    int i = 0;

    for (; i + 8 <= n; i += 8) {
        uint64_t a, b, c;
        memcpy(&a, to + i, sizeof a);
        memcpy(&b, from + i, sizeof b);
        memcpy(&c, dead + i, sizeof c);
        a |= b & ~c;
        memcpy(to + i, &a, sizeof a);
    }
    for (; i < n; i++)
        to[i] |= (uint8_t)(from[i] & ~dead[i]);
}

/* Shifts the surviving cells of a row by k cells; cells at the edge stop there. */
static void shift_row(const struct reach *r, const uint8_t *from, const uint8_t *dead, uint8_t *to, int k)
{
    const int last = r->w - 1;
    const int first_free = r->x0 > -k ? r->x0 : -k, last_free = r->x1 < last - k ? r->x1 : last - k;

    for (int x = r->x0; x <= r->x1 && x < first_free; x++)
        to[0] |= (uint8_t)(from[x] & ~dead[x]);
    if (last_free >= first_free)
        or_and_not(to + first_free + k, from + first_free, dead + first_free, last_free - first_free + 1);
    for (int x = r->x1; x >= r->x0 && x > last_free; x--)
        to[last] |= (uint8_t)(from[x] & ~dead[x]);
}

static void shift_set(struct reach *r, fx mx, fx my)
{
    const int kx = floor_cells(r, mx), ky = floor_cells(r, my);
    const int partial_x = mx % r->cell != 0, partial_y = my % r->cell != 0;

    for (int y = r->y0; y <= r->y1; y++) {
        const size_t at = (size_t)y * (size_t)r->w;
        for (int dy = 0; dy <= partial_y; dy++) {
            uint8_t *to = r->next + (size_t)int_clamp(y + ky + dy, 0, r->h - 1) * (size_t)r->w;
            for (int dx = 0; dx <= partial_x; dx++)
                shift_row(r, r->current + at, r->hit + at, to, kx + dx);
        }
    }
}

/* Adds the cells of a row from which a shift by k leads to a cell of `to`. */
static void shift_row_back(const struct reach *r, uint8_t *result, const uint8_t *to, int k)
{
    const int last = r->w - 1, first_free = k < 0 ? -k : 0, last_free = k > 0 ? last - k : last;

    for (int x = 0; x < first_free && x <= last; x++)
        result[x] |= to[0];
    if (last_free >= first_free)
        or_and_not(result + first_free, to + first_free + k, r->hit, last_free - first_free + 1);
    for (int x = last; x > last_free && x >= 0; x--)
        result[x] |= to[last];
}

/* Adds to `result` the cells from which a move leads to a cell of r->next. r->hit is all zero. */
static void shift_set_back(struct reach *r, uint8_t *result, fx mx, fx my)
{
    const int kx = floor_cells(r, mx), ky = floor_cells(r, my);
    const int partial_x = mx % r->cell != 0, partial_y = my % r->cell != 0;

    for (int y = r->y0; y <= r->y1; y++)
        for (int dy = 0; dy <= partial_y; dy++) {
            const uint8_t *to = r->next + (size_t)int_clamp(y + ky + dy, 0, r->h - 1) * (size_t)r->w;
            for (int dx = 0; dx <= partial_x; dx++)
                shift_row_back(r, result + (size_t)y * (size_t)r->w, to, kx + dx);
        }
}

/* Returns whether the ship cannot move and nothing can hit it. */
static bool is_idle(const struct forecast_frame *frame)
{
    return !frame->moves && (frame->n == 0 || frame->safe);
}

static void advance_frame(struct reach *r, const struct forecast_frame *frame)
{
    fx mx, my;

    memset(r->next, 0, (size_t)r->w * (size_t)r->h);
    for (int move = 0; move < (frame->moves ? REACH_MOVES : 1); move++) {
        move_vector(&frame->ship, move, &mx, &my);
        mark_hits(r, frame, mx, my);
        shift_set(r, mx, my);
    }
    /* clamped moves have not been checked: check the new positions */
    uint8_t *swap = r->current;
    r->current = r->next;
    r->next = swap;
    update_bounds(r);
    if (r->x1 < r->x0 || frame->safe)
        return;
    const struct window all = { r->x0, r->y0, r->x1, r->y1 };
    for (int y = r->y0; y <= r->y1; y++)
        memset(r->hit + (size_t)y * (size_t)r->w, 0, (size_t)r->w);
    for (uint32_t i = 0; i < frame->n; i++) {
        struct danger d = r->f->list[frame->first + i];
        d.swept = false;
        mark_danger(r, &d, frame->ship.path.radius + r->extra_radius, 0, 0, &all);
    }
    for (size_t i = (size_t)r->y0 * (size_t)r->w; i < (size_t)(r->y1 + 1) * (size_t)r->w; i++)
        r->current[i] &= (uint8_t)~r->hit[i];
    update_bounds(r);
}

/* ---- all frames ---- */

static bool allocate(struct reach *r, const struct forecast *f)
{
    const size_t n = (size_t)r->w * (size_t)r->h;

    r->bytes = (n + 7) / 8;
    r->capacity = f->frames + 1;
    r->sets = malloc(r->capacity * r->bytes);
    r->current = calloc(n, 1);
    r->next = calloc(n, 1);
    r->hit = calloc(n, 1);
    return r->sets && r->current && r->next && r->hit;
}

bool reach_compute(struct reach *r, const struct forecast *f, fx cell, fx extra_radius, fx x, fx y)
{
    *r = (struct reach){ .f = f, .cell = cell, .extra_radius = extra_radius };
    if (f->frames == 0)
        return false;
    r->area = f->frame[0].ship.area;
    r->w = (int)(((int64_t)r->area.x1 - r->area.x0) / cell) + 1;
    r->h = (int)(((int64_t)r->area.y1 - r->area.y0) / cell) + 1;
    if (!allocate(r, f))
        return false;
    const int cx = int_clamp((int)(((int64_t)x - r->area.x0) / cell), 0, r->w - 1);
    const int cy = int_clamp((int)(((int64_t)y - r->area.y0) / cell), 0, r->h - 1);
    r->current[(size_t)cy * (size_t)r->w + (size_t)cx] = 1;
    update_bounds(r);
    pack_set(r, r->current, get_set(r, 0));
    while (r->frames < f->frames && r->x1 >= r->x0) {
        if (!is_idle(&f->frame[r->frames]))
            advance_frame(r, &f->frame[r->frames]);
        pack_set(r, r->current, get_set(r, ++r->frames));
    }
    return true;
}

void reach_free(struct reach *r)
{
    free(r->sets);
    free(r->current);
    free(r->next);
    free(r->hit);
    *r = (struct reach){ 0 };
}

uint32_t reach_count(const struct reach *r, uint32_t t)
{
    const uint8_t *set = get_set(r, t);
    uint32_t n = 0;

    for (size_t i = 0; i < r->bytes; i++)
        for (uint8_t bits = set[i]; bits; bits &= (uint8_t)(bits - 1))
            n++;
    return n;
}

bool reach_is_empty(const struct reach *r)
{
    return reach_count(r, r->frames) == 0;
}

/* Hits are not checked again, because plan.c makes exact checks. */
static void prune_frame(struct reach *r, uint32_t t, uint8_t *result)
{
    const struct forecast_frame *frame = &r->f->frame[t];
    const size_t n = (size_t)r->w * (size_t)r->h;
    fx mx, my;

    unpack_set(r, get_set(r, t + 1), r->next);
    unpack_set(r, get_set(r, t), r->current);
    update_bounds(r);
    memset(result, 0, n);
    memset(r->hit, 0, (size_t)r->w);
    for (int move = 0; move < (frame->moves ? REACH_MOVES : 1); move++) {
        move_vector(&frame->ship, move, &mx, &my);
        shift_set_back(r, result, mx, my);
    }
    for (size_t i = 0; i < n; i++)
        result[i] &= r->current[i];
    pack_set(r, result, get_set(r, t));
}

void reach_prune(struct reach *r)
{
    uint32_t last = r->frames;
    uint8_t *buffer = malloc((size_t)r->w * (size_t)r->h);

    while (last > 0 && reach_count(r, last) == 0)
        last--;
    for (uint32_t t = last; buffer && t-- > 0;) {
        if (is_idle(&r->f->frame[t]))
            memcpy(get_set(r, t), get_set(r, t + 1), r->bytes);
        else
            prune_frame(r, t, buffer);
    }
    free(buffer);
}

bool reach_has(const struct reach *r, uint32_t t, fx x, fx y)
{
    if (x < r->area.x0 || x > r->area.x1 || y < r->area.y0 || y > r->area.y1)
        return false;
    const int cx = (int)(((int64_t)x - r->area.x0) / r->cell), cy = (int)(((int64_t)y - r->area.y0) / r->cell);
    const size_t i = (size_t)cy * (size_t)r->w + (size_t)cx;
    return get_set(r, t)[i / 8] >> i % 8 & 1;
}
