/*
 * reach.c - see reach.h.
 *
 * A ship has 17 ways to go on in a frame. For each, the starts from which something hits are a convex shape: for a
 * circle all within its radius and the ship's of the line along which it comes nearer. A row of cells lies in it where
 * both lines of the grid that bound the row do. What is left is moved by the way; where that is no whole number of
 * cells, into all cells it could be in. At the area's edge a ship stops: from there a way counts as hit only where it
 * ends.
 */
#include "reach.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/int.h"
#include "../../entities/player.h"

#define MARGIN (1.0 / 64) /* px: what is computed in doubles is far nearer to the truth */

/* ---- ways ---- */

uint16_t reach_pads(int way)
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

    return way < 9 ? compass[way] : (uint16_t)(compass[way - 8] | PAD_FOCUS);
}

static void move_of(const struct danger_ship *ship, int way, fx *mx, fx *my)
{
    const uint16_t pads = reach_pads(way);
    const int dx = !!(pads & PAD_RIGHT) - !!(pads & PAD_LEFT), dy = !!(pads & PAD_DOWN) - !!(pads & PAD_UP);
    fx speed = pads & PAD_FOCUS ? ship->focused_speed : ship->speed;

    if (dx && dy)
        speed = fx_mul(speed, PLAYER_DIAGONAL_FACTOR);
    *mx = dx * speed;
    *my = dy * speed;
}

void reach_step(const struct danger_ship *ship, int way, fx *x, fx *y)
{
    fx mx, my;

    move_of(ship, way, &mx, &my);
    *x = fx_clamp(fx_clamp(*x, ship->area.x0, ship->area.x1) + mx, ship->area.x0, ship->area.x1);
    *y = fx_clamp(fx_clamp(*y, ship->area.y0, ship->area.y1) + my, ship->area.y0, ship->area.y1);
}

/* ---- sets ---- */

static uint8_t *set_of(const struct reach *r, uint32_t t)
{
    return r->sets + (size_t)t * r->bytes;
}

static void pack(const struct reach *r, const uint8_t *cells, uint8_t *set)
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

static void unpack(const struct reach *r, const uint8_t *set, uint8_t *cells)
{
    const size_t n = (size_t)r->w * (size_t)r->h;

    for (size_t i = 0; i < n; i++)
        cells[i] = set[i / 8] >> i % 8 & 1;
}

/* Finds the box round what is in `from`. */
static void bound(struct reach *r)
{
    r->x0 = r->w;
    r->y0 = r->h;
    r->x1 = r->y1 = -1;
    for (int y = 0; y < r->h; y++) {
        const uint8_t *row = r->from + (size_t)y * (size_t)r->w;
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

/* ---- what hits ---- */

/* The starts from which a way of the ship ends in a hit, in px from the area's corner: all within r of the line from p
 * to q; or, with half_w >= 0, all within r of a box round p. */
struct killer {
    double px, py, qx, qy, r, half_w, half_h;
    double ox, oy; /* from the line to one of the two edges beside it; 0, 0: p is q */
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

/* Where the horizontal line at y crosses it: lo > hi: nowhere. */
static void cross(const struct killer *k, double y, double *lo, double *hi)
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

/* The cells of a way whose starts are not stopped by the area's edge. */
struct window {
    int x0, y0, x1, y1;
};

static void kill_row(struct reach *r, int row, double lo, double hi, const struct window *w)
{
    const double cell = r->cell / (double)FX_ONE;
    const double first = ceil((lo + MARGIN) / cell), last = floor((hi - MARGIN) / cell) - 1;

    if (first > w->x1 || last < w->x0) /* before the conversions: both are infinite where the line misses it */
        return;
    const int x0 = first > w->x0 ? (int)first : w->x0, x1 = last < w->x1 ? (int)last : w->x1;
    if (x1 >= x0)
        memset(r->dead + (size_t)row * (size_t)r->w + x0, 1, (size_t)(x1 - x0 + 1));
}

/* Marks the cells that lie in it whole. */
static void kill(struct reach *r, struct killer *k, const struct window *w)
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
    cross(k, y0 * cell, &lo, &hi);
    for (int y = y0; y <= y1; y++, lo = next_lo, hi = next_hi) {
        cross(k, (y + 1) * cell, &next_lo, &next_hi);
        kill_row(r, y, lo > next_lo ? lo : next_lo, hi < next_hi ? hi : next_hi, w);
    }
}

static double px(int64_t v)
{
    return (double)v / FX_ONE;
}

/* Marks the starts from which a danger hits on a way by (mx, my); that is, of what is awkward, a part of them. */
static void mark(struct reach *r, const struct danger *d, fx radius, fx mx, fx my, const struct window *w)
{
    const double x = px((int64_t)d->x - mx - r->area.x0), y = px((int64_t)d->y - my - r->area.y0);
    const double was_x = px((int64_t)d->x - d->mx - r->area.x0), was_y = px((int64_t)d->y - d->my - r->area.y0);
    struct killer k = { x, y, x, y, px((int64_t)d->a + radius), -1, -1, 0, 0 };

    if (d->shape == DANGER_BOX) {
        k.r = px(radius);
        k.half_w = px(d->a);
        k.half_h = px(d->b);
        kill(r, &k, w);
        k.px = k.qx = (x + was_x) / 2;
        k.py = k.qy = (y + was_y) / 2;
        if (d->swept)
            kill(r, &k, w);
        return;
    }
    if (d->shape == DANGER_LASER_SEGMENT) {
        k.qx = px((int64_t)d->b - mx - r->area.x0);
        k.qy = px((int64_t)d->c - my - r->area.y0);
        kill(r, &k, w);
        return;
    }
    if (d->swept) {
        k.qx = was_x;
        k.qy = was_y;
    }
    kill(r, &k, w);
    if (d->shape == DANGER_CAPSULE) {
        k = (struct killer){ x - px(d->b), y - px(d->c), x + px(d->b), y + px(d->c), k.r, -1, -1, 0, 0 };
        kill(r, &k, w);
    }
}

/* Of a way by (mx, my): the starts that are not stopped; of a stop, all. Within what `from` has. */
static struct window window_of(const struct reach *r, fx mx, fx my)
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

/* r->dead: the starts of a way in that frame of the forecast that are hit for certain. */
static void mark_all(struct reach *r, const struct forecast_frame *frame, fx mx, fx my)
{
    const struct window w = window_of(r, mx, my);

    for (int y = r->y0; y <= r->y1; y++)
        memset(r->dead + (size_t)y * (size_t)r->w, 0, (size_t)r->w);
    if (frame->safe || w.x1 < w.x0 || w.y1 < w.y0)
        return;
    for (uint32_t i = 0; i < frame->n; i++)
        mark(r, &r->f->list[frame->first + i], frame->ship.path.radius + r->grown, mx, my, &w);
}

/* ---- a frame on ---- */

/* How many whole cells v is, downwards. */
static int cells_in(const struct reach *r, fx v)
{
    return v >= 0 ? v / r->cell : -((-v + r->cell - 1) / r->cell);
}

/* to[i] |= from[i] & ~dead[i], n of them; each is 0 or 1. */
static void or_living(uint8_t *to, const uint8_t *from, const uint8_t *dead, int n)
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

/* A row's cells that live go on by k cells; those at the edge stop there. */
static void row_on(const struct reach *r, const uint8_t *from, const uint8_t *dead, uint8_t *to, int k)
{
    const int last = r->w - 1;
    const int first_free = r->x0 > -k ? r->x0 : -k, last_free = r->x1 < last - k ? r->x1 : last - k;

    for (int x = r->x0; x <= r->x1 && x < first_free; x++)
        to[0] |= (uint8_t)(from[x] & ~dead[x]);
    if (last_free >= first_free)
        or_living(to + first_free + k, from + first_free, dead + first_free, last_free - first_free + 1);
    for (int x = r->x1; x >= r->x0 && x > last_free; x--)
        to[last] |= (uint8_t)(from[x] & ~dead[x]);
}

static void way_on(struct reach *r, fx mx, fx my)
{
    const int kx = cells_in(r, mx), ky = cells_in(r, my);
    const int more_x = mx % r->cell != 0, more_y = my % r->cell != 0;

    for (int y = r->y0; y <= r->y1; y++) {
        const size_t at = (size_t)y * (size_t)r->w;
        for (int dy = 0; dy <= more_y; dy++) {
            uint8_t *to = r->to + (size_t)int_clamp(y + ky + dy, 0, r->h - 1) * (size_t)r->w;
            for (int dx = 0; dx <= more_x; dx++)
                row_on(r, r->from + at, r->dead + at, to, kx + dx);
        }
    }
}

/* A row's cells from which k cells on one is in `to`. */
static void row_back(const struct reach *r, uint8_t *seen, const uint8_t *to, int k)
{
    const int last = r->w - 1, first_free = k < 0 ? -k : 0, last_free = k > 0 ? last - k : last;

    for (int x = 0; x < first_free && x <= last; x++)
        seen[x] |= to[0];
    if (last_free >= first_free)
        or_living(seen + first_free, to + first_free + k, r->dead, last_free - first_free + 1);
    for (int x = last; x > last_free && x >= 0; x--)
        seen[x] |= to[last];
}

/* Adds to `seen` the cells from which a way leads into one of `to`. r->dead is all zero. */
static void way_back(struct reach *r, uint8_t *seen, fx mx, fx my)
{
    const int kx = cells_in(r, mx), ky = cells_in(r, my);
    const int more_x = mx % r->cell != 0, more_y = my % r->cell != 0;

    for (int y = r->y0; y <= r->y1; y++)
        for (int dy = 0; dy <= more_y; dy++) {
            const uint8_t *to = r->to + (size_t)int_clamp(y + ky + dy, 0, r->h - 1) * (size_t)r->w;
            for (int dx = 0; dx <= more_x; dx++)
                row_back(r, seen + (size_t)y * (size_t)r->w, to, kx + dx);
        }
}

/* Has the frame no ship that moves, and nothing that hits? */
static bool is_idle(const struct forecast_frame *frame)
{
    return !frame->moves && (frame->n == 0 || frame->safe);
}

static void frame_on(struct reach *r, const struct forecast_frame *frame)
{
    fx mx, my;

    memset(r->to, 0, (size_t)r->w * (size_t)r->h);
    for (int way = 0; way < (frame->moves ? REACH_WAYS : 1); way++) {
        move_of(&frame->ship, way, &mx, &my);
        mark_all(r, frame, mx, my);
        way_on(r, mx, my);
    }
    /* what stopped at the edge is hit where it is now */
    uint8_t *swap = r->from;
    r->from = r->to;
    r->to = swap;
    bound(r);
    if (r->x1 < r->x0 || frame->safe)
        return;
    const struct window all = { r->x0, r->y0, r->x1, r->y1 };
    for (int y = r->y0; y <= r->y1; y++)
        memset(r->dead + (size_t)y * (size_t)r->w, 0, (size_t)r->w);
    for (uint32_t i = 0; i < frame->n; i++) {
        struct danger d = r->f->list[frame->first + i];
        d.swept = false;
        mark(r, &d, frame->ship.path.radius + r->grown, 0, 0, &all);
    }
    for (size_t i = (size_t)r->y0 * (size_t)r->w; i < (size_t)(r->y1 + 1) * (size_t)r->w; i++)
        r->from[i] &= (uint8_t)~r->dead[i];
    bound(r);
}

/* ---- all frames ---- */

static bool take_room(struct reach *r, const struct forecast *f)
{
    const size_t n = (size_t)r->w * (size_t)r->h;

    r->bytes = (n + 7) / 8;
    r->room = f->frames + 1;
    r->sets = malloc(r->room * r->bytes);
    r->from = calloc(n, 1);
    r->to = calloc(n, 1);
    r->dead = calloc(n, 1);
    return r->sets && r->from && r->to && r->dead;
}

bool reach_open(struct reach *r, const struct forecast *f, fx cell, fx grown, fx x, fx y)
{
    *r = (struct reach){ .f = f, .cell = cell, .grown = grown };
    if (f->frames == 0)
        return false;
    r->area = f->frame[0].ship.area;
    r->w = (int)(((int64_t)r->area.x1 - r->area.x0) / cell) + 1;
    r->h = (int)(((int64_t)r->area.y1 - r->area.y0) / cell) + 1;
    if (!take_room(r, f))
        return false;
    const int cx = int_clamp((int)(((int64_t)x - r->area.x0) / cell), 0, r->w - 1);
    const int cy = int_clamp((int)(((int64_t)y - r->area.y0) / cell), 0, r->h - 1);
    r->from[(size_t)cy * (size_t)r->w + (size_t)cx] = 1;
    bound(r);
    pack(r, r->from, set_of(r, 0));
    while (r->frames < f->frames && r->x1 >= r->x0) {
        if (!is_idle(&f->frame[r->frames]))
            frame_on(r, &f->frame[r->frames]);
        pack(r, r->from, set_of(r, ++r->frames));
    }
    return true;
}

void reach_close(struct reach *r)
{
    free(r->sets);
    free(r->from);
    free(r->to);
    free(r->dead);
    *r = (struct reach){ 0 };
}

uint32_t reach_count(const struct reach *r, uint32_t t)
{
    const uint8_t *set = set_of(r, t);
    uint32_t n = 0;

    for (size_t i = 0; i < r->bytes; i++)
        for (uint8_t bits = set[i]; bits; bits &= (uint8_t)(bits - 1))
            n++;
    return n;
}

bool reach_ended(const struct reach *r)
{
    return reach_count(r, r->frames) == 0;
}

/* Whether something hits on the way is not asked again: who follows the sets looks exactly. */
static void frame_back(struct reach *r, uint32_t t, uint8_t *seen)
{
    const struct forecast_frame *frame = &r->f->frame[t];
    const size_t n = (size_t)r->w * (size_t)r->h;
    fx mx, my;

    unpack(r, set_of(r, t + 1), r->to);
    unpack(r, set_of(r, t), r->from);
    bound(r);
    memset(seen, 0, n);
    memset(r->dead, 0, (size_t)r->w);
    for (int way = 0; way < (frame->moves ? REACH_WAYS : 1); way++) {
        move_of(&frame->ship, way, &mx, &my);
        way_back(r, seen, mx, my);
    }
    for (size_t i = 0; i < n; i++)
        seen[i] &= r->from[i];
    pack(r, seen, set_of(r, t));
}

void reach_back(struct reach *r)
{
    uint32_t last = r->frames;
    uint8_t *seen = malloc((size_t)r->w * (size_t)r->h);

    while (last > 0 && reach_count(r, last) == 0)
        last--;
    for (uint32_t t = last; seen && t-- > 0;) {
        if (is_idle(&r->f->frame[t]))
            memcpy(set_of(r, t), set_of(r, t + 1), r->bytes);
        else
            frame_back(r, t, seen);
    }
    free(seen);
}

bool reach_has(const struct reach *r, uint32_t t, fx x, fx y)
{
    if (x < r->area.x0 || x > r->area.x1 || y < r->area.y0 || y > r->area.y1)
        return false;
    const int cx = (int)(((int64_t)x - r->area.x0) / r->cell), cy = (int)(((int64_t)y - r->area.y0) / r->cell);
    const size_t i = (size_t)cy * (size_t)r->w + (size_t)cx;
    return set_of(r, t)[i / 8] >> i % 8 & 1;
}
