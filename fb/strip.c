/*
 * strip.c - see strip.h.
 *
 * Each segment of the line is the part of the plane between four edges: two parallel to the line, half the width away,
 * and a cut at either end. Two segments that meet share a cut, which bisects the angle between them. The centre of
 * every pixel is on one side of the cut, so the segments leave no gap and do not overlap. A row of a segment is the
 * part of the clip between the segment's edges; an edge is advanced from row to row by one addition. Within a segment,
 * picture coordinates advance by two steps per pixel, one along the line and one across it.
 */
#include "strip.h"
#include <string.h>
#include "../src/base/fx.h"
#include "../src/base/int.h"

enum { HALF_PIXEL = 32768, MAX_PROFILE = 256 };

/* A unit vector, Q16. */
struct unit_vector {
    int32_t x, y;
};

/* A straight edge, evaluated row by row. */
struct edge {
    int64_t x, step;    /* x at the current row's centre, and its change per row; Q16 px */
    bool is_horizontal; /* parallel to the rows, so that a whole row is on one side */
    bool keeps_right;   /* keeps the pixels to its right; if horizontal, those below it */
    int32_t y;          /* of a horizontal edge, Q16 px */
};

/* The state needed to draw pixels. */
struct brush {
    struct fb *fb;
    const struct strip *s;
    const struct image *image;
    int32_t half_width;           /* half of the width, Q16 px */
    int64_t scale;                /* rows of the picture per px across the line, Q16 */
    uint8_t profile[MAX_PROFILE]; /* for a picture one pixel wide: its colours with the bank added; 0: transparent */
    bool uses_profile;            /* the picture is one pixel wide, opaque and not dashed */
};

/* The slope of an edge perpendicular to n; the side that n points to is kept. */
struct slope {
    struct unit_vector n;
    int64_t step;
};

static struct slope slope_of(struct unit_vector n)
{
    return (struct slope){ n, n.x ? -(int64_t)n.y * FX_ONE / n.x : 0 };
}

/* Returns the edge through (x, y), starting at `row`. */
static struct edge edge_at(int32_t x, int32_t y, const struct slope *s, int row)
{
    const int64_t dy = (int64_t)row * FX_ONE + HALF_PIXEL - y;

    return (struct edge){ .x = x + (s->step * dy >> 16),
                          .step = s->step,
                          .is_horizontal = s->n.x == 0,
                          .keeps_right = s->n.x == 0 ? s->n.y > 0 : s->n.x > 0,
                          .y = y };
}

/* The area that a segment or an end covers: rows first to last, and in each row a span between edges. */
struct coverage {
    int first, last;
    int64_t lo, hi; /* the clip */
    struct edge edge[4];
    int n;
};

static void add_edge(struct coverage *s, struct edge e)
{
    const int row = (int)(((int64_t)e.y + HALF_PIXEL - 1) >> 16); /* the first row whose centre is not above e */

    if (!e.is_horizontal)
        s->edge[s->n++] = e;
    else if (e.keeps_right)
        s->first = row > s->first ? row : s->first;
    else
        s->last = row - 1 < s->last ? row - 1 : s->last;
}

/* Stores the span [*lo, *hi) of a row and advances the edges to the next row. */
static inline void next_span(struct coverage *s, int64_t *lo, int64_t *hi)
{
    *lo = s->lo;
    *hi = s->hi;
    for (int k = 0; k < s->n; k++) {
        struct edge *e = &s->edge[k];
        const int64_t at = (e->x + HALF_PIXEL - 1) >> 16; /* the first pixel whose centre is not left of e */
        e->x += e->step;
        if (e->keeps_right)
            *lo = at > *lo ? at : *lo;
        else
            *hi = at < *hi ? at : *hi;
    }
}

static struct edge flip_edge(struct edge e)
{
    e.keeps_right = !e.keeps_right;
    return e;
}

static inline void put_texel(const struct brush *b, uint8_t *d, uint8_t texel)
{
    uint8_t c = (uint8_t)(texel + b->s->bank * 16);

    if (texel)
        *d = b->s->blend_table ? b->s->blend_table[(size_t)*d << 8 | c] : c;
}

/* Returns the picture's row at position `row`, in Q32, clamped to the picture. */
static inline int clamp_row(const struct brush *b, int64_t row)
{
    const int last_row = b->image->h - 1;

    row >>= 32;
    return row < 0 ? 0 : row > last_row ? last_row : (int)row;
}

/* Draws the picture's pixel that is `along` Q16 px from the start of the line. */
static inline void paint_pixel(const struct brush *b, uint8_t *d, int64_t line_pos, int row)
{
    if (b->s->dashed && (line_pos >> 16 & 4))
        return;
    const int64_t px = b->s->dashed ? 0 : int64_modulo(line_pos >> 16, b->image->w);
    put_texel(b, d, b->image->pix[row * b->image->pitch + px]);
}

/* Draws a span of a segment that is not dashed. */
static void paint_picture_span(const struct brush *b, uint8_t *d, int n, int64_t line_pos, int64_t step, int64_t row,
                               int64_t row_step)
{
    const int64_t period = (int64_t)b->image->w << 32;
    const uint8_t *pix = b->image->pix;
    const ptrdiff_t pitch = b->image->pitch;

    line_pos = int64_modulo(line_pos, period);
    for (; n > 0; n--, d++, row += row_step) {
        put_texel(b, d, pix[clamp_row(b, row) * pitch + (line_pos >> 32)]);
        line_pos += step; /* by at most one pixel */
        line_pos -= line_pos >= period ? period : 0;
        line_pos += line_pos < 0 ? period : 0;
    }
}

/* Draws a span of a segment whose picture is one pixel wide and opaque. Clamps the row of each pixel only if rounding
 * moved the first or the last one outside the picture. */
static void paint_profile_span(const struct brush *b, uint8_t *d, int n, int64_t row, int64_t row_step)
{
    const int64_t max_row = ((int64_t)b->image->h << 32) - 1, last = row + (n - 1) * row_step;

    if ((row | last | (max_row - row) | (max_row - last)) >= 0) {
        for (; n > 0; n--, d++, row += row_step) {
            uint8_t c = b->profile[row >> 32];
            *d = c ? c : *d;
        }
        return;
    }
    for (; n > 0; n--, d++, row += row_step) {
        uint8_t c = b->profile[clamp_row(b, row)];
        *d = c ? c : *d;
    }
}

struct segment {
    struct strip_corner from;
    struct unit_vector dir;
    int64_t line_pos; /* length of the line up to this segment, Q16 px, plus the strip's `offset_along` */
};

/* The picture coordinates of the first pixel of the clip in a row, Q32, and their change per pixel and per row. */
struct picture_pos {
    int64_t row, row_x, row_y; /* across the line */
    int64_t line_pos, line_pos_x, line_pos_y;
};

static struct picture_pos picture_pos_at(const struct brush *b, const struct segment *p, int y)
{
    const int64_t dx = (int64_t)b->fb->x0 * FX_ONE + HALF_PIXEL - p->from.x,
                  dy = (int64_t)y * FX_ONE + HALF_PIXEL - p->from.y;

    return (struct picture_pos){ .row = ((dy * p->dir.x - dx * p->dir.y) / FX_ONE + b->half_width) * b->scale,
                                 .row_x = -p->dir.y * b->scale,
                                 .row_y = p->dir.x * b->scale,
                                 .line_pos = p->line_pos * FX_ONE + dx * p->dir.x + dy * p->dir.y,
                                 .line_pos_x = (int64_t)p->dir.x * FX_ONE,
                                 .line_pos_y = (int64_t)p->dir.y * FX_ONE };
}

static void paint_span(const struct brush *b, const struct picture_pos *pos, int y, int lo, int hi)
{
    const int skipped = lo - b->fb->x0;
    int64_t line_pos = pos->line_pos + skipped * pos->line_pos_x, row = pos->row + skipped * pos->row_x;
    uint8_t *d = b->fb->pix + (ptrdiff_t)y * b->fb->pitch + lo;

    if (b->uses_profile)
        paint_profile_span(b, d, hi - lo, row, pos->row_x);
    else if (!b->s->dashed)
        paint_picture_span(b, d, hi - lo, line_pos, pos->line_pos_x, row, pos->row_x);
    else
        for (int x = lo; x < hi; x++, d++, line_pos += pos->line_pos_x, row += pos->row_x)
            paint_pixel(b, d, line_pos >> 16, clamp_row(b, row));
}

/* Computes the rows that may be within `reach` of y0 to y1, all in Q16 px. */
static void find_rows_near(const struct fb *fb, int32_t y0, int32_t y1, int64_t reach, int *first, int *last)
{
    int64_t top = ((y0 < y1 ? y0 : y1) - reach) >> 16, end = ((y0 < y1 ? y1 : y0) + reach) >> 16;

    *first = top > fb->y0 ? (int)top : fb->y0;
    *last = end < fb->y1 - 1 ? (int)end : fb->y1 - 1;
}

/* Draws the straight segment from p->from to `to`, between the cuts `begin` and `end` through these two corners. A cut
 * leans by at most a quarter of a right angle, so a segment extends less than 5/12 of half the width beyond its
 * ends. */
static void draw_segment(const struct brush *b, const struct segment *p, struct strip_corner to,
                         const struct slope *begin, const struct slope *end)
{
    const int32_t ox = (int32_t)((int64_t)p->dir.y * b->half_width >> 16),
                  oy = (int32_t)((int64_t)p->dir.x * b->half_width >> 16);
    const struct slope right = slope_of((struct unit_vector){ -p->dir.y, p->dir.x }),
                       left = { { p->dir.y, -p->dir.x }, right.step };
    int first, last;

    find_rows_near(b->fb, p->from.y, to.y,
                   (oy < 0 ? -(int64_t)oy : oy) + (ox < 0 ? -(int64_t)ox : ox) * 5 / 12 + FX_ONE, &first, &last);
    if (first > last)
        return;
    struct coverage s = { .first = first, .last = last, .lo = b->fb->x0, .hi = b->fb->x1 };
    add_edge(&s, edge_at(p->from.x, p->from.y, begin, first));
    add_edge(&s, flip_edge(edge_at(to.x, to.y, end, first)));
    add_edge(&s, edge_at(p->from.x + ox, p->from.y - oy, &right, first));
    add_edge(&s, edge_at(p->from.x - ox, p->from.y + oy, &left, first));
    for (int k = 0; k < s.n; k++)
        s.edge[k].x += s.edge[k].step * (s.first - first);
    struct picture_pos pos = picture_pos_at(b, p, s.first);
    for (int y = s.first; y <= s.last; y++, pos.row += pos.row_y, pos.line_pos += pos.line_pos_y) {
        int64_t lo, hi;
        next_span(&s, &lo, &hi);
        if (lo < hi)
            paint_span(b, &pos, y, (int)lo, (int)hi);
    }
}

enum cap_part { CAP_BEHIND, CAP_AHEAD, CAP_WHOLE };

/* Draws the circle around corner c, or only the half that is behind c, or ahead of c, in direction dir. */
static void draw_cap(const struct brush *b, struct strip_corner c, struct unit_vector dir, int64_t line_pos,
                     enum cap_part cap_part)
{
    int first, last;

    find_rows_near(b->fb, c.y, c.y, b->half_width, &first, &last);
    if (first > last)
        return;
    const struct slope slope = slope_of(dir);
    const struct edge edge = edge_at(c.x, c.y, &slope, first);
    struct coverage s = { .first = first, .last = last, .lo = b->fb->x0, .hi = b->fb->x1 };
    if (cap_part != CAP_WHOLE)
        add_edge(&s, cap_part == CAP_BEHIND ? flip_edge(edge) : edge);
    for (int k = 0; k < s.n; k++)
        s.edge[k].x += s.edge[k].step * (s.first - first);
    for (int y = s.first; y <= s.last; y++) {
        const int64_t dy = (int64_t)y * FX_ONE + HALF_PIXEL - c.y,
                      reach_squared = (int64_t)b->half_width * b->half_width - dy * dy;
        int64_t lo, hi;
        next_span(&s, &lo, &hi);
        if (reach_squared < 0)
            continue;
        const int64_t reach = (int64_t)fx_root((uint64_t)reach_squared);
        const int64_t x0 = (c.x - reach + HALF_PIXEL - 1) >> 16, x1 = ((c.x + reach - HALF_PIXEL) >> 16) + 1;
        lo = x0 > lo ? x0 : lo;
        hi = x1 < hi ? x1 : hi;
        for (int64_t x = lo; x < hi; x++) {
            const int64_t dx = x * FX_ONE + HALF_PIXEL - c.x,
                          distance = (int64_t)fx_root((uint64_t)(dx * dx + dy * dy));
            const bool left = dy * dir.x < dx * dir.y;
            paint_pixel(b, b->fb->pix + (ptrdiff_t)y * b->fb->pitch + x, line_pos,
                        clamp_row(b, (b->half_width + (left ? -distance : distance)) * b->scale));
        }
    }
}

/* Computes the direction from a to b, and their distance. Returns false if the distance is below 1/4 px. Coordinates
 * are reduced to Q12 before squaring, so that the squares fit in 64 bits for all corners. */
static bool find_direction(struct strip_corner a, struct strip_corner b, struct unit_vector *dir, int64_t *distance)
{
    const int64_t dx = ((int64_t)b.x - a.x) / 16, dy = ((int64_t)b.y - a.y) / 16;
    const int64_t d = (int64_t)fx_root((uint64_t)(dx * dx) + (uint64_t)(dy * dy));

    *distance = d * 16;
    if (d < FX_ONE / 16 / 4)
        return false;
    *dir = (struct unit_vector){ (int32_t)(dx * FX_ONE / d), (int32_t)(dy * FX_ONE / d) };
    return true;
}

static bool init_brush(struct brush *b, struct fb *fb, const struct strip *s)
{
    b->fb = fb;
    b->s = s;
    b->image = s->image;
    b->half_width = s->width / 2;
    if (b->half_width < FX_ONE / 16 || fb->x0 >= fb->x1 || fb->y0 >= fb->y1)
        return false;
    b->scale = (int64_t)s->image->h * FX_ONE * FX_ONE / (2 * (int64_t)b->half_width);
    b->uses_profile = s->image->w == 1 && s->image->h <= MAX_PROFILE && !s->blend_table && !s->dashed;
    for (int y = 0; b->uses_profile && y < s->image->h; y++) {
        uint8_t texel = s->image->pix[y * s->image->pitch];
        b->profile[y] = texel ? (uint8_t)(texel + s->bank * 16) : 0;
    }
    return true;
}

/* The corners that are far enough apart, and the directions and distances between them: n - 1 for n corners. */
struct line {
    struct strip_corner corner[STRIP_MAX_CORNERS];
    struct unit_vector dir[STRIP_MAX_CORNERS];
    int64_t distance[STRIP_MAX_CORNERS];
    int n;
};

static void init_line(struct line *l, const struct strip_corner *corner, int n)
{
    l->corner[0] = corner[0];
    l->n = 1;
    for (int k = 1; k < n; k++)
        if (find_direction(l->corner[l->n - 1], corner[k], &l->dir[l->n - 1], &l->distance[l->n - 1]))
            l->corner[l->n++] = corner[k];
}

/* Stores the direction of the cut, which bisects the angle between a and b. Returns whether that angle is at most half
 * a right angle; then the outer corner is at most 13/12 of half the width from the line. */
static bool bisect(struct unit_vector a, struct unit_vector b, struct unit_vector *bisector)
{
    *bisector = (struct unit_vector){ a.x + b.x, a.y + b.y };
    return (int64_t)a.x * b.x + (int64_t)a.y * b.y >= 3037000500; /* 2^32 cos 45 */
}

void strip_draw(struct fb *fb, const struct strip *s, const struct strip_corner *corner, int n)
{
    struct brush b;
    struct line l;
    struct segment p = { .line_pos = (int64_t)s->offset_along * FX_ONE };

    if (!init_brush(&b, fb, s))
        return;
    init_line(&l, corner, n);
    if (l.n == 1) {
        draw_cap(&b, l.corner[0], (struct unit_vector){ FX_ONE, 0 }, p.line_pos, CAP_WHOLE);
        return;
    }
    struct slope begin = slope_of(l.dir[0]), end;
    draw_cap(&b, l.corner[0], l.dir[0], p.line_pos, CAP_BEHIND);
    for (int k = 0; k + 1 < l.n; k++) {
        const bool is_last = k + 2 == l.n;
        struct unit_vector bisector;
        const bool smooth = !is_last && bisect(l.dir[k], l.dir[k + 1], &bisector);
        p.from = l.corner[k];
        p.dir = l.dir[k];
        end = slope_of(smooth ? bisector : p.dir);
        draw_segment(&b, &p, l.corner[k + 1], &begin, &end);
        p.line_pos += l.distance[k];
        begin = smooth || is_last ? end : slope_of(l.dir[k + 1]);
        if (!smooth)
            draw_cap(&b, l.corner[k + 1], p.dir, p.line_pos, CAP_AHEAD);
        if (!smooth && !is_last)
            draw_cap(&b, l.corner[k + 1], l.dir[k + 1], p.line_pos, CAP_BEHIND);
    }
}
