/*
 * strip.c - see strip.h.
 *
 * Each piece of the line is the part of the plane between four edges: two along it, half the width away, and a cut at
 * either end. Where two pieces meet they share the cut, which halves the angle between them, and every pixel's middle is
 * on one side of it: so they leave no gap and do not overlap. A row of a piece is what its edges leave of the clip; an
 * edge is followed from row to row by one addition. In a piece the picture is found by two steps a pixel, one along the
 * line and one across.
 */
#include "strip.h"
#include <string.h>
#include "../src/base/fx.h"

enum { HALF = 32768, PROFILE = 256 };

/* A direction of length one, Q16. */
struct unit {
    int32_t x, y;
};

/* A straight edge, as the rows see it. */
struct edge {
    int64_t x, step; /* where it is on this row's middle, and how far on the next; Q16 px */
    bool level;      /* it lies along the rows: all of a row is on one side */
    bool right;      /* what is kept is to its right; level: below it */
    int32_t y;       /* of a level one, Q16 px */
};

/* What the pixels need. */
struct brush {
    struct fb *fb;
    const struct strip *s;
    const struct image *image;
    int32_t half;             /* of the width */
    int64_t scale;            /* from px across to rows of the picture, Q16 */
    uint8_t profile[PROFILE]; /* of a picture one pixel wide: its colours, the bank added; 0: none */
    bool plain;               /* it is one, opaque and not dashed */
};

/* The edge through (x, y) that keeps what lies in the direction n, from the row `row` on. */
static struct edge edge_at(int32_t x, int32_t y, struct unit n, int row)
{
    struct edge e = { .level = n.x == 0, .right = n.x == 0 ? n.y > 0 : n.x > 0, .y = y };
    int64_t down = (int64_t)row * FX_ONE + HALF - y;

    if (e.level)
        return e;
    e.step = -(int64_t)n.y * FX_ONE / n.x;
    e.x = x + (e.step * down >> 16);
    return e;
}

/* Cuts the row's span [*lo, *hi) at the edge, which goes on to the next row. */
static inline void cut(struct edge *e, int row, int64_t *lo, int64_t *hi)
{
    if (e->level) {
        if (((int64_t)row * FX_ONE + HALF >= e->y) != e->right)
            *hi = *lo;
        return;
    }
    int64_t first = (e->x + HALF - 1) >> 16; /* the first pixel whose middle is not left of it */
    e->x += e->step;
    if (e->right)
        *lo = first > *lo ? first : *lo;
    else
        *hi = first < *hi ? first : *hi;
}

static struct edge other_side(struct edge e)
{
    e.right = !e.right;
    return e;
}

static inline void put(const struct brush *b, uint8_t *d, uint8_t texel)
{
    uint8_t c = (uint8_t)(texel + b->s->bank * 16);

    if (texel)
        *d = b->s->blend ? b->s->blend[(size_t)*d << 8 | c] : c;
}

/* The picture's row that lies `across` Q16 px from its first. */
static inline int row_of(const struct brush *b, int64_t row)
{
    const int most = b->image->h - 1;

    row >>= 16;
    return row < 0 ? 0 : row > most ? most : (int)row;
}

/* The picture's pixel, `along` Q16 px from the line's beginning. */
static inline void paint(const struct brush *b, uint8_t *d, int64_t along, int row)
{
    int64_t px = along >> 16;

    if (b->s->dashed && (px & 4))
        return;
    if (b->image->w > 1 && !b->s->dashed)
        px = (px % b->image->w + b->image->w) % b->image->w;
    else
        px = 0;
    put(b, d, b->image->pix[row * b->image->pitch + px]);
}

/* A span of a piece whose picture is one pixel wide and opaque. */
static inline void plain_span(const struct brush *b, uint8_t *d, int n, int64_t row, int64_t row_step)
{
    const int64_t most = (int64_t)b->image->h * FX_ONE - 1;

    for (; n > 0; n--, d++, row += row_step) {
        int64_t at = row < 0 ? 0 : row > most ? most : row;
        uint8_t c = b->profile[at >> 16];
        *d = c ? c : *d;
    }
}

struct piece {
    struct strip_corner from;
    struct unit dir;
    int64_t along; /* Q16 px of the line before it */
};

static void paint_span(const struct brush *b, const struct piece *p, int y, int lo, int hi)
{
    const int64_t dx = (int64_t)lo * FX_ONE + HALF - p->from.x, dy = (int64_t)y * FX_ONE + HALF - p->from.y;
    int64_t along = p->along + ((dx * p->dir.x + dy * p->dir.y) >> 16);
    int64_t row = ((dy * p->dir.x - dx * p->dir.y) / FX_ONE + b->half) * b->scale >> 16;
    const int64_t row_step = -(int64_t)p->dir.y * b->scale >> 16;
    uint8_t *d = b->fb->pix + (ptrdiff_t)y * b->fb->pitch + lo;

    if (b->plain) {
        plain_span(b, d, hi - lo, row, row_step);
        return;
    }
    for (int x = lo; x < hi; x++, d++, along += p->dir.x, row += row_step)
        paint(b, d, along, row_of(b, row));
}

/* Rows that may be within `reach` of what lies from y0 to y1, all in Q16 px. */
static void rows_near(const struct fb *fb, int32_t y0, int32_t y1, int64_t reach, int *first, int *last)
{
    int64_t top = ((y0 < y1 ? y0 : y1) - reach) >> 16, end = ((y0 < y1 ? y1 : y0) + reach) >> 16;

    *first = top > fb->y0 ? (int)top : fb->y0;
    *last = end < fb->y1 - 1 ? (int)end : fb->y1 - 1;
}

/* A straight piece to `to`, between its two cuts, each through a corner and keeping what lies in its direction. */
static void draw_piece(const struct brush *b, const struct piece *p, struct strip_corner to, struct unit begin,
                       struct unit end)
{
    const int32_t ox = (int32_t)((int64_t)p->dir.y * b->half >> 16), oy = (int32_t)((int64_t)p->dir.x * b->half >> 16);
    const struct unit left = { p->dir.y, -p->dir.x }, right = { -p->dir.y, p->dir.x };
    int first, last;

    rows_near(b->fb, p->from.y, to.y, (int64_t)b->half * 3 / 2 + FX_ONE, &first, &last);
    if (first > last)
        return;
    struct edge edges[4] = { edge_at(p->from.x, p->from.y, begin, first), other_side(edge_at(to.x, to.y, end, first)),
                             edge_at(p->from.x + ox, p->from.y - oy, right, first),
                             edge_at(p->from.x - ox, p->from.y + oy, left, first) };
    for (int y = first; y <= last; y++) {
        int64_t lo = b->fb->x0, hi = b->fb->x1;
        for (int k = 0; k < 4; k++)
            cut(&edges[k], y, &lo, &hi);
        if (lo < hi)
            paint_span(b, p, y, (int)lo, (int)hi);
    }
}

enum half { BEHIND, AHEAD, WHOLE };

/* The half of a circle that lies behind corner c of a piece along dir, or ahead, or all of it. */
static void draw_end(const struct brush *b, struct strip_corner c, struct unit dir, int64_t along, enum half half)
{
    int first, last;

    rows_near(b->fb, c.y, c.y, b->half, &first, &last);
    if (first > last)
        return;
    struct edge edge = edge_at(c.x, c.y, dir, first);
    if (half == BEHIND)
        edge = other_side(edge);
    for (int y = first; y <= last; y++) {
        const int64_t dy = (int64_t)y * FX_ONE + HALF - c.y, rest = (int64_t)b->half * b->half - dy * dy;
        int64_t lo = b->fb->x0, hi = b->fb->x1;
        if (half != WHOLE)
            cut(&edge, y, &lo, &hi);
        if (rest < 0)
            continue;
        const int64_t reach = (int64_t)fx_root((uint64_t)rest);
        const int64_t x0 = (c.x - reach + HALF - 1) >> 16, x1 = ((c.x + reach - HALF) >> 16) + 1;
        lo = x0 > lo ? x0 : lo;
        hi = x1 < hi ? x1 : hi;
        for (int64_t x = lo; x < hi; x++) {
            const int64_t dx = x * FX_ONE + HALF - c.x, far = (int64_t)fx_root((uint64_t)(dx * dx + dy * dy));
            const bool left = dy * dir.x < dx * dir.y;
            paint(b, b->fb->pix + (ptrdiff_t)y * b->fb->pitch + x, along,
                  row_of(b, (b->half + (left ? -far : far)) * b->scale >> 16));
        }
    }
}

/* The direction from a to b, and how far it is; false: it is nearly nothing. */
static bool direction(struct strip_corner a, struct strip_corner b, struct unit *dir, int64_t *far)
{
    const int64_t dx = (int64_t)b.x - a.x, dy = (int64_t)b.y - a.y;

    *far = (int64_t)fx_root((uint64_t)(dx * dx) + (uint64_t)(dy * dy));
    if (*far < FX_ONE / 4)
        return false;
    *dir = (struct unit){ (int32_t)(dx * FX_ONE / *far), (int32_t)(dy * FX_ONE / *far) };
    return true;
}

static bool brush_of(struct brush *b, struct fb *fb, const struct strip *s)
{
    b->fb = fb;
    b->s = s;
    b->image = s->image;
    b->half = s->width / 2;
    if (b->half < 1 || fb->x0 >= fb->x1 || fb->y0 >= fb->y1)
        return false;
    b->scale = (int64_t)s->image->h * FX_ONE * FX_ONE / (2 * (int64_t)b->half);
    b->plain = s->image->w == 1 && s->image->h <= PROFILE && !s->blend && !s->dashed;
    for (int y = 0; b->plain && y < s->image->h; y++) {
        uint8_t texel = s->image->pix[y * s->image->pitch];
        b->profile[y] = texel ? (uint8_t)(texel + s->bank * 16) : 0;
    }
    return true;
}

/* The corners that are far enough apart, and the ways between them: of n corners n - 1. */
struct line {
    struct strip_corner corner[STRIP_CORNERS];
    struct unit dir[STRIP_CORNERS];
    int64_t far[STRIP_CORNERS];
    int n;
};

static void take_line(struct line *l, const struct strip_corner *corner, int n)
{
    l->corner[0] = corner[0];
    l->n = 1;
    for (int k = 1; k < n; k++)
        if (direction(l->corner[l->n - 1], corner[k], &l->dir[l->n - 1], &l->far[l->n - 1]))
            l->corner[l->n++] = corner[k];
}

/* Do two ways meet at half a right angle or less? Then the cut between them halves it, and the corner outside is at most
 * a twelfth further from the line than half the width. */
static bool halved(struct unit a, struct unit b, struct unit *cut_at)
{
    *cut_at = (struct unit){ a.x + b.x, a.y + b.y };
    return (int64_t)a.x * b.x + (int64_t)a.y * b.y >= 3037000500; /* 2^32 cos 45 */
}

void strip_draw(struct fb *fb, const struct strip *s, const struct strip_corner *corner, int n)
{
    struct brush b;
    struct line l;
    struct piece p = { .along = (int64_t)s->along * FX_ONE };

    if (!brush_of(&b, fb, s))
        return;
    take_line(&l, corner, n);
    if (l.n == 1) {
        draw_end(&b, l.corner[0], (struct unit){ FX_ONE, 0 }, p.along, WHOLE);
        return;
    }
    struct unit begin = l.dir[0], end;
    draw_end(&b, l.corner[0], begin, p.along, BEHIND);
    for (int k = 0; k + 1 < l.n; k++) {
        const bool last = k + 2 == l.n, smooth = !last && halved(l.dir[k], l.dir[k + 1], &end);
        p.from = l.corner[k];
        p.dir = l.dir[k];
        draw_piece(&b, &p, l.corner[k + 1], begin, smooth ? end : p.dir);
        p.along += l.far[k];
        begin = smooth ? end : last ? p.dir : l.dir[k + 1];
        if (!smooth)
            draw_end(&b, l.corner[k + 1], p.dir, p.along, AHEAD);
    }
}
