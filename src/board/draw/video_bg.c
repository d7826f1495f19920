/*
 * video_bg.c - draws the background (bg.h): from back to front layer 1, the plane, layers 2 to 4; those that are in
 * front, over all sprites.
 *
 * Pixel (x, y) of the field shows pixel (x - floor(layer.x + line y's offset), y - floor(layer.y)) of the layer's map,
 * which repeats if it wraps. Each row is put together from rows of tiles in a buffer and goes onto the surface in one
 * piece: copied where all of its tiles are solid. So line scroll costs nothing more, and no tile is clipped.
 *
 * The plane: with `height` h and the horizon k rows away (halves: the middle of a row), a pixel is s = h / k px of the
 * plane wide, and the row is f * s away, f the field's width. All is Q32, one column is s farther along the row than
 * the last, and only where a row begins is rounded.
 */
#include "../../../fb/row.h"
#include "../../base/bytes.h"
#include "../../base/int.h"
#include "../../base/trig.h"
#include "../video.h"
#include <string.h>

enum { ROW = 1024 + 64 /* the widest field, and a tile more on each side */ };

/* How the rows of a layer or of the plane go onto the surface. */
struct brush {
    uint8_t bank;
    const uint8_t *to;    /* what each colour is shown as, or NULL */
    const uint8_t *table; /* a blend's, or NULL */
};

static int64_t modulo(int64_t a, int64_t n)
{
    int64_t r = a % n;

    return r < 0 ? r + n : r;
}

/* n pixels from s into row y of the field, from column x on. */
static void lay(struct draw_target *c, const struct brush *b, const uint8_t *s, int x, int y, int n, bool solid)
{
    const struct manifest *m = &c->b->cart.m;
    uint8_t *d = c->fb->pix + (m->field_y + y) * c->fb->pitch + m->field_x + x;

    if (b->to || b->table)
        row_mix(d, s, n, b->bank, b->to, b->table);
    else if (solid)
        row_copy(d, s, n, b->bank);
    else
        row_cover(d, s, n, b->bank);
}

/* The tiles that a row of a layer shows: where each begins among the map's pixels. Rows of the same tiles share them. */
struct tiles {
    uint32_t at[ROW / 8];
    int n, col, row; /* how many, from which cell on */
    bool solid;      /* all are */
};

/* Finds n tiles from cell (col, row) on, starting over at the map's right edge. */
static void find_tiles(const struct map *m, int col, int row, int n, struct tiles *t)
{
    const uint8_t *cells = m->cells + 2 * (size_t)row * (size_t)m->cols;
    const uint32_t size = (uint32_t)(m->side * m->side);
    uint8_t solid = 1;

    t->n = n;
    t->col = col;
    t->row = row;
    for (int k = 0; k < n; k++) {
        size_t tile = bytes_get16(cells + 2 * col);
        t->at[k] = (uint32_t)tile * size;
        solid &= m->solid[tile];
        if (++col == m->cols)
            col = 0;
    }
    t->solid = solid;
}

/* Puts row `in` of each tile into `to`. The side is a constant where this is called, so that each copy is a few
 * instructions; forced, for gcc would call it, and each copy would be a call then. */
__attribute__((always_inline)) static inline void put_tiles(const struct map *m, const struct tiles *t, int in,
                                                            uint8_t *restrict to, const int side)
{
    const uint8_t *pix = m->pix + in * side;

    for (int k = 0; k < t->n; k++)
        memcpy(to + k * side, pix + t->at[k], (size_t)side);
}

/* n pixels of the map from (x, y) on, both inside. */
static const uint8_t *map_row(const struct map *m, int x, int y, int n, struct tiles *t, uint8_t row[ROW])
{
    const int shift = m->side == 8 ? 3 : m->side == 16 ? 4 : 5, mask = m->side - 1;
    const int skip = x & mask, tiles = (skip + n + mask) >> shift;

    if (t->n != tiles || t->col != x >> shift || t->row != y >> shift)
        find_tiles(m, x >> shift, y >> shift, tiles, t);
    if (m->side == 8)
        put_tiles(m, t, y & mask, row, 8);
    else if (m->side == 16)
        put_tiles(m, t, y & mask, row, 16);
    else
        put_tiles(m, t, y & mask, row, 32);
    return row + skip;
}

static struct brush brush_of(const struct board *b, uint32_t i)
{
    const unsigned blend = (b->bg.flags[i] & BG_BLEND) / BG_BLEND_ONE;
    struct brush brush = { (uint8_t)(b->bg.bank[i] * 16), NULL, blend ? b->cart.blend[blend - 1] : NULL };

    if (bg_dark(&b->bg))
        brush.to = b->bg_shades.to + BG_BLACK_TABLES + (bg_dark(&b->bg) - 1) * 256;
    return brush;
}

/* A shake moves the maps in the field, so that they go on to its edges. */
static int shaken_x(const struct draw_target *c)
{
    return c->x - c->b->cart.m.field_x;
}

static int shaken_y(const struct draw_target *c)
{
    return c->y - c->b->cart.m.field_y;
}

/* What row y of the field shows of a layer: columns [from, to) of the field, from (x, my) of the map on. */
struct shown_row {
    int64_t aside; /* the map's left edge, from the field's */
    int64_t from, to, x, my;
};

/* The next row of a map that wraps. One that is as far aside as the last needs no division. */
static void row_wraps(struct shown_row *r, int64_t aside, int64_t mw, int64_t mh)
{
    if (r->aside != aside)
        r->x = modulo(-aside, mw);
    r->aside = aside;
    r->my += 1;
    r->my -= r->my == mh ? mh : 0;
}

/* The next row of one that does not. False: nothing is there. */
static bool row_once(struct shown_row *r, int64_t aside, int64_t mw, int64_t mh, int w)
{
    r->my += 1;
    r->from = aside > 0 ? aside : 0;
    r->to = mw + aside < w ? mw + aside : w;
    r->x = r->from - aside;
    return r->my >= 0 && r->my < mh && r->from < r->to;
}

static void draw_layer(struct draw_target *c, uint32_t i)
{
    const struct bg *g = &c->b->bg;
    const struct brush brush = brush_of(c->b, i);
    const int w = c->b->cart.m.field_w, h = c->b->cart.m.field_h, dx = shaken_x(c), dy = shaken_y(c);
    const bool wraps = g->flags[i] & BG_WRAP;
    struct tiles tiles = { .n = -1 };
    uint8_t row[ROW];
    struct map m;

    cart_map(&c->b->cart, g->map[i] - 1, &m);
    const int64_t mw = m.cols * m.side, mh = m.rows * m.side, top = (g->y[i] >> 16) + dy;
    struct shown_row r = { .aside = INT64_MIN, .to = w, .my = (wraps ? modulo(-top, mh) : -top) - 1 };
    for (int y = 0; y < h; y++) {
        const int line = (int)int64_clamp(y - dy, 0, h - 1);
        const int64_t aside = ((g->x[i] + bg_line(g, &c->b->bg_lines, i, line)) >> 16) + dx;
        if (wraps)
            row_wraps(&r, aside, mw, mh);
        else if (!row_once(&r, aside, mw, mh, w))
            continue;
        const uint8_t *s = map_row(&m, (int)r.x, (int)r.my, (int)(r.to - r.from), &tiles, row);
        lay(c, &brush, s, (int)r.from, y, (int)(r.to - r.from), tiles.solid);
    }
    c->drawn++;
}

/* How a row of the plane is walked: place and step in Q32, both from 0 to the map's size. */
struct walk {
    int64_t u, v, du, dv;
};

/* n pixels of the map along the walk. */
static bool walk_row(const struct map *m, struct walk a, int n, uint8_t *row)
{
    const int64_t w = (int64_t)m->cols * m->side << 32, h = (int64_t)m->rows * m->side << 32;
    const int shift = m->side == 8 ? 3 : m->side == 16 ? 4 : 5, mask = m->side - 1;
    uint8_t solid = 1;

    for (int x = 0; x < n; x++) {
        int u = (int)(a.u >> 32), v = (int)(a.v >> 32);
        size_t tile = bytes_get16(m->cells + 2 * (size_t)((v >> shift) * m->cols + (u >> shift)));
        row[x] = m->pix[(tile << 2 * shift) + (size_t)((v & mask) << shift | (u & mask))];
        solid &= m->solid[tile];
        a.u += a.du;
        a.u -= a.u >= w ? w : 0;
        a.v += a.dv;
        a.v -= a.v >= h ? h : 0;
    }
    return solid;
}

/* Where row k halves from the horizon begins; s: its px of plane a pixel, Q16. */
static struct walk walk_of(const struct bg *g, const struct map *m, int field_w, int64_t s)
{
    const int64_t w = (int64_t)m->cols * m->side << 32, h = (int64_t)m->rows * m->side << 32;
    const int64_t ahead_x = s * trig_cos30(g->dir[BG_PLANE]) >> 14, ahead_y = s * trig_sin30(g->dir[BG_PLANE]) >> 14;
    const int64_t u = modulo(g->x[BG_PLANE], w >> 16) * 65536 + field_w * ahead_x - (1 - field_w) * ahead_y / 2;
    const int64_t v = modulo(g->y[BG_PLANE], h >> 16) * 65536 + field_w * ahead_y + (1 - field_w) * ahead_x / 2;

    return (struct walk){ modulo(u, w), modulo(v, h), modulo(-ahead_y, w), modulo(ahead_x, h) };
}

/* The walk from n columns farther on. */
static struct walk skipped(struct walk a, const struct map *m, int n)
{
    a.u = modulo(a.u + n * a.du, (int64_t)m->cols * m->side << 32);
    a.v = modulo(a.v + n * a.dv, (int64_t)m->rows * m->side << 32);
    return a;
}

/* Which table of fog a row is shown by: 0 none, or 1 to BG_SHADES. */
static int fog_at(const struct bg *g, int field_w, int64_t s)
{
    if (g->fog[BG_PLANE] == BG_NO_FOG)
        return 0;
    int64_t depth = s * field_w * BG_SHADES;
    return depth / g->far[BG_PLANE] < BG_SHADES ? (int)(depth / g->far[BG_PLANE]) : BG_SHADES;
}

/* The table that fogs, and then shades: one of the two, or both in one. */
static const uint8_t *plane_table(const struct board *b, int fog, uint8_t both[256])
{
    const uint8_t *first = fog ? b->bg_shades.to + BG_FOG_TABLES + (fog - 1) * 256 : NULL;
    const uint8_t *then = brush_of(b, BG_PLANE).to;

    if (!first || !then)
        return first ? first : then;
    for (int k = 0; k < 256; k++)
        both[k] = then[first[k]];
    return both;
}

static void draw_plane(struct draw_target *c)
{
    const struct bg *g = &c->b->bg;
    const int w = c->b->cart.m.field_w, h = c->b->cart.m.field_h, horizon = g->horizon[BG_PLANE] + shaken_y(c);
    const bool ceiling = g->flags[BG_PLANE] & BG_CEILING;
    struct brush brush = brush_of(c->b, BG_PLANE);
    uint8_t row[ROW], both[256];
    struct map m;
    int fogged = -1;

    cart_map(&c->b->cart, g->map[BG_PLANE] - 1, &m);
    for (int y = 0; y < h; y++) {
        int64_t away = ceiling ? 2 * (horizon - y) - 1 : 2 * (y - horizon) + 1;
        if (away <= 0)
            continue;
        int64_t s = (4 * (int64_t)g->height[BG_PLANE] + away) / (2 * away);
        int fog = fog_at(g, w, s);
        if (fog != fogged)
            brush.to = plane_table(c->b, fogged = fog, both);
        bool solid = walk_row(&m, skipped(walk_of(g, &m, w, s), &m, -shaken_x(c)), w, row);
        lay(c, &brush, row, 0, y, w, solid);
    }
    c->drawn++;
}

static bool shown(const struct bg *g, uint32_t i, bool front)
{
    return g->map[i] && !(g->flags[i] & BG_HIDDEN) && !(g->flags[i] & BG_FRONT) == !front;
}

/* Does layer i hide all that is under it? */
static bool covers(const struct board *b, uint32_t i)
{
    struct map m;

    if (!shown(&b->bg, i, false) || !(b->bg.flags[i] & BG_WRAP) || b->bg.flags[i] & BG_BLEND)
        return false;
    cart_map(&b->cart, b->bg.map[i] - 1, &m);
    return m.whole;
}

/* The frontmost layer that covers the field, or -1. */
static int covering(const struct board *b)
{
    int i = (int)b->bg.s.live - 2;

    while (i >= 0 && !covers(b, (uint32_t)i))
        i--;
    return i;
}

bool video_bg_covers(const struct board *b)
{
    return covering(b) >= 0;
}

void video_bg(struct draw_target *c, bool front)
{
    const struct bg *g = &c->b->bg;
    const int first = front ? 0 : covering(c->b);

    for (int i = first < 0 ? 0 : first; i + 1 < (int)g->s.live; i++) {
        if (shown(g, (uint32_t)i, front))
            draw_layer(c, (uint32_t)i);
        if (i == 0 && shown(g, BG_PLANE, front))
            draw_plane(c);
    }
}
