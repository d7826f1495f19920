/*
 * video_bg.c - draws the background (bg.h), back to front: layer 1, the plane, layers 2 to 4. A layer or plane marked
 * as front is drawn over all sprites.
 *
 * Pixel (x, y) of the field shows pixel (x - floor(layer.x + line y's offset), y - floor(layer.y)) of the layer's map;
 * the map repeats if the layer wraps. Consecutive rows with the same x offset and in the same row of tiles are drawn
 * together, tile by tile: empty tiles are skipped, solid ones are copied. With line scroll each row may have its own
 * offset and is then drawn alone. Rows that are blended with the picture under them are first assembled in a buffer,
 * one at a time.
 *
 * The plane: if `height` is h and the middle of a row is k rows from the horizon (k counts in halves), then a pixel of
 * the row is s = h / k px of the plane wide, and the row is f * s px away, where f is the field's width. Positions are
 * Q32. Each column is s px further along the row than the previous one, and rounding happens only at the start of a
 * row.
 */
#include "../../../fb/row.h"
#include "../../../fb/tiles.h"
#include "../../base/bytes.h"
#include "../../base/int.h"
#include "../../base/trig.h"
#include "video.h"
#include <string.h>

enum { MAX_ROW_WIDTH = 1024 + 64 /* px: the widest field plus one of the largest tiles on each side */ };

/* How rows of a layer or of the plane are drawn onto the surface. */
struct brush {
    uint8_t bank;
    const uint8_t *remap;       /* palette entry shown for each of 256; NULL: unchanged */
    const uint8_t *blend_table; /* table of a blend; NULL: opaque */
};

/* Draws n pixels from s into row y of the field, starting at column x. solid: no pixel is 0. */
static void draw_pixels(struct draw_target *c, const struct brush *b, const uint8_t *s, int x, int y, int n, bool solid)
{
    uint8_t *d = c->fb->pix + (c->area.y + y) * c->fb->pitch + c->area.x + x;

    if (b->remap || b->blend_table)
        row_mix(d, s, n, b->bank, b->remap, b->blend_table);
    else if (solid)
        row_copy(d, s, n, b->bank);
    else
        row_cover(d, s, n, b->bank);
}

/* The tiles shown by one or more rows of a layer. offset: offset of each tile in the map's pixels. */
struct tiles {
    uint32_t offset[MAX_ROW_WIDTH / 8];
    uint8_t kind[MAX_ROW_WIDTH / 8]; /* enum tile */
    int n, col, row;                 /* number of tiles; map cell of the first */
};

/* Finds n tiles from map cell (col, row), wrapping at the map's right edge. */
static void find_tiles(const struct map *m, int col, int row, int n, struct tiles *t)
{
    const uint8_t *cells = m->cells + 2 * (size_t)row * (size_t)m->cols;
    const uint32_t size = (uint32_t)(m->tile_side * m->tile_side);

    t->n = n;
    t->col = col;
    t->row = row;
    for (int k = 0; k < n; k++) {
        size_t tile = bytes_get16(cells + 2 * col);
        t->offset[k] = (uint32_t)tile * size;
        t->kind[k] = m->solid[tile] ? TILE_SOLID : tile ? TILE_MASKED : TILE_EMPTY;
        if (++col == m->cols)
            col = 0;
    }
}

/* Copies pixel row `tile_row` of each tile to `to`, side by side. */
static void copy_tiles(const struct map *m, const struct tiles *t, int tile_row, uint8_t *to)
{
    for (int k = 0; k < t->n; k++)
        memcpy(to + k * m->tile_side, m->pix + t->offset[k] + tile_row * m->tile_side, (size_t)m->tile_side);
}

/* Returns a table that applies `first`, then `second`; a NULL table changes nothing. May store the result in
 * `composed`. */
static const uint8_t *compose_tables(const uint8_t *first, const uint8_t *second, uint8_t composed[256])
{
    if (!first || !second)
        return first ? first : second;
    for (int k = 0; k < 256; k++)
        composed[k] = second[first[k]];
    return composed;
}

static struct brush brush_of(const struct draw_target *c, uint32_t i)
{
    const struct board *b = c->b;
    const unsigned blend = (b->bg.flags[i] & BG_BLEND) / BG_BLEND_ONE;
    struct brush brush = { (uint8_t)(b->bg.bank[i] * 16), NULL, blend ? c->palette_tables.blend[blend - 1] : NULL };

    if (bg_darkness(&b->bg))
        brush.remap = b->bg_shades.table + BG_BLACK_OFFSET + (bg_darkness(&b->bg) - 1) * 256;
    return brush;
}

/* Return by how many px a layer is moved by the camera and a shake, which moves the maps within the area, so that the
 * maps still reach its edges. */
static int layer_dx(const struct draw_target *c, uint32_t i)
{
    const fx *follow = c->b->bg.follow;

    return c->shake_x - (follow ? fx_floor(fx_mul(c->b->camera.x[0], follow[i])) : 0);
}

static int layer_dy(const struct draw_target *c, uint32_t i)
{
    const fx *follow = c->b->bg.follow;

    return c->shake_y - (follow ? fx_floor(fx_mul(c->b->camera.y[0], follow[i])) : 0);
}

/* The part of a layer's map that rows of the field show. Columns [from, to) of the field show the map's pixels from
 * column map_x, row map_y on. */
struct shown_rows {
    int64_t map_left; /* the map's left edge, px to the right of the field's left edge */
    int64_t from, to, map_x, map_y;
    int y, n; /* first row, and number of rows: all have the same `map_left` and the same row of tiles */
};

/* Finds the columns to show of a map that wraps; skips the division if `map_left` has not changed since the previous
 * rows. Always returns true. */
static bool find_wrapped_columns(struct shown_rows *r, int64_t map_left, int64_t mw, int64_t mh)
{
    if (r->map_left != map_left)
        r->map_x = int64_modulo(-map_left, mw);
    r->map_left = map_left;
    r->map_y -= r->map_y == mh ? mh : 0;
    return true;
}

/* Finds the columns to show of a map that does not wrap. Returns false if the rows show no pixel of the map. */
static bool find_single_columns(struct shown_rows *r, int64_t map_left, int64_t mw, int64_t mh, int w)
{
    r->from = map_left > 0 ? map_left : 0;
    r->to = mw + map_left < w ? mw + map_left : w;
    r->map_x = r->from - map_left;
    return r->map_y >= 0 && r->map_y < mh && r->from < r->to;
}

/* Returns the layer's x offset in row y of the area, px. dx, dy: by how much the layer is moved. */
static int64_t map_left_at(const struct draw_target *c, uint32_t i, int y, int dx, int dy)
{
    const struct bg *g = &c->b->bg;
    const int line = (int)int64_clamp(y - dy, 0, c->b->cart.manifest.field_h - 1);

    return ((g->x[i] + bg_line_offset(g, &c->b->bg_lines, i, line)) >> 16) + dx;
}

/* Draws columns [from, to) of tile k, which is not wholly inside the safe area (fb.h). */
static void draw_cut_tile(const struct draw_target *c, const struct tiles *t, const struct map *m, int k, uint8_t *d,
                          int tile_row, int rows, int from, int to, uint8_t bank)
{
    const uint8_t *s = m->pix + t->offset[k] + tile_row * m->tile_side;

    for (int y = 0; y < rows && t->kind[k] != TILE_EMPTY; y++, d += c->fb->pitch, s += m->tile_side)
        row_cover(d + from, s + from, to - from, bank);
}

/* Draws rows tile by tile. A tile at an edge of the field may extend into the surface's band, if the edge is next to
 * the band. */
static void draw_tiles(const struct draw_target *c, uint8_t bank, const struct map *m, const struct tiles *t,
                       const struct shown_rows *r)
{
    const int side = m->tile_side, skip = (int)r->map_x & (side - 1), tile_row = (int)r->map_y & (side - 1);
    const int left = c->area.x + (int)r->from - skip, end = skip + (int)(r->to - r->from);
    uint8_t *d = c->fb->pix + (c->area.y + r->y) * c->fb->pitch + left;
    const bool cut_left = left < c->fb->sx0;
    const bool cut_right = left + t->n * side > c->fb->sx1;
    const int first = cut_left ? 1 : 0, last = t->n - (cut_right && t->n > first ? 1 : 0);

    if (cut_left)
        draw_cut_tile(c, t, m, 0, d, tile_row, r->n, skip, end < side ? end : side, bank);
    tiles_draw(d + first * side, c->fb->pitch, m->pix + tile_row * side, t->offset + first, t->kind + first,
               last - first, side, r->n, bank);
    if (last < t->n)
        draw_cut_tile(c, t, m, last, d + last * side, tile_row, r->n, 0, end - last * side, bank);
}

/* Draws rows one at a time, through a blend or a colour table. */
static void draw_mixed_rows(struct draw_target *c, const struct brush *b, const struct map *m, const struct tiles *t,
                            const struct shown_rows *r)
{
    const int skip = (int)r->map_x & (m->tile_side - 1), tile_row = (int)r->map_y & (m->tile_side - 1);
    uint8_t row[MAX_ROW_WIDTH];

    for (int k = 0; k < r->n; k++) {
        copy_tiles(m, t, tile_row + k, row);
        draw_pixels(c, b, row + skip, (int)r->from, r->y + k, (int)(r->to - r->from), false);
    }
}

static void draw_rows(struct draw_target *c, const struct brush *b, const struct map *m, struct tiles *t,
                      const struct shown_rows *r)
{
    const int shift = m->tile_side == 8 ? 3 : m->tile_side == 16 ? 4 : 5, mask = m->tile_side - 1;
    const int col = (int)r->map_x >> shift, row = (int)r->map_y >> shift;
    const int n = (((int)r->map_x & mask) + (int)(r->to - r->from) + mask) >> shift;

    if (t->n != n || t->col != col || t->row != row)
        find_tiles(m, col, row, n, t);
    if (b->remap || b->blend_table)
        draw_mixed_rows(c, b, m, t, r);
    else
        draw_tiles(c, b->bank, m, t, r);
}

static void draw_layer(struct draw_target *c, uint32_t i, const uint8_t *shade)
{
    const struct bg *g = &c->b->bg;
    struct brush brush = brush_of(c, i);
    const int w = c->area.w, h = c->area.h, dx = layer_dx(c, i), dy = layer_dy(c, i);
    const bool wraps = g->flags[i] & BG_WRAP;
    struct tiles tiles = { .n = -1 };
    uint8_t composed[256];
    struct map m;

    brush.remap = compose_tables(brush.remap, shade, composed);
    cart_map(&c->b->cart, g->map[i] - 1, &m);
    const int64_t mw = m.cols * m.tile_side, mh = m.rows * m.tile_side, top = (g->y[i] >> 16) + dy;
    struct shown_rows r = { .map_left = INT64_MIN, .to = w, .map_y = wraps ? int64_modulo(-top, mh) : -top };
    for (int64_t map_left = map_left_at(c, i, 0, dx, dy), next = map_left; r.y < h;
         r.y += r.n, r.map_y += r.n, map_left = next) {
        const bool has_pixels =
            wraps ? find_wrapped_columns(&r, map_left, mw, mh) : find_single_columns(&r, map_left, mw, mh, w);
        const int max_rows = has_pixels ? m.tile_side - ((int)r.map_y & (m.tile_side - 1)) : 1;
        r.n = 0;
        do
            next = ++r.n + r.y < h ? map_left_at(c, i, r.y + r.n, dx, dy) : map_left;
        while (r.n < max_rows && r.y + r.n < h && next == map_left);
        if (has_pixels)
            draw_rows(c, &brush, &m, &tiles, &r);
    }
    c->drawn_count++;
}

/* A walk over the map along a row of the plane: position and step per column, Q32 px, each in [0, map size). */
struct walk {
    int64_t u, v, du, dv;
};

/* Copies n pixels of the map along the walk to row. Returns whether all of them come from solid tiles. */
static bool walk_row(const struct map *m, struct walk a, int n, uint8_t *row)
{
    const int64_t w = (int64_t)m->cols * m->tile_side << 32, h = (int64_t)m->rows * m->tile_side << 32;
    const int shift = m->tile_side == 8 ? 3 : m->tile_side == 16 ? 4 : 5, mask = m->tile_side - 1;
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

/* Returns the walk of a row of the plane. s: plane px per pixel of that row, Q16. */
static struct walk walk_of(const struct bg *g, const struct map *m, int field_w, int64_t s)
{
    const int64_t w = (int64_t)m->cols * m->tile_side << 32, h = (int64_t)m->rows * m->tile_side << 32;
    const int64_t ahead_x = s * trig_cos30(g->dir[BG_PLANE]) >> 14, ahead_y = s * trig_sin30(g->dir[BG_PLANE]) >> 14;
    const int64_t u = int64_modulo(g->x[BG_PLANE], w >> 16) * 65536 + field_w * ahead_x - (1 - field_w) * ahead_y / 2;
    const int64_t v = int64_modulo(g->y[BG_PLANE], h >> 16) * 65536 + field_w * ahead_y + (1 - field_w) * ahead_x / 2;

    return (struct walk){ int64_modulo(u, w), int64_modulo(v, h), int64_modulo(-ahead_y, w), int64_modulo(ahead_x, h) };
}

/* Returns the walk that starts n columns later. */
static struct walk advance_walk(struct walk a, const struct map *m, int n)
{
    a.u = int64_modulo(a.u + n * a.du, (int64_t)m->cols * m->tile_side << 32);
    a.v = int64_modulo(a.v + n * a.dv, (int64_t)m->rows * m->tile_side << 32);
    return a;
}

/* Returns which fog table applies to a row, 1 to BG_SHADES; 0: no fog. s: as in walk_of. */
static int fog_at(const struct bg *g, int field_w, int64_t s)
{
    if (g->fog[BG_PLANE] == BG_NO_FOG)
        return 0;
    int64_t depth = s * field_w * BG_SHADES;
    return depth / g->fog_end[BG_PLANE] < BG_SHADES ? (int)(depth / g->fog_end[BG_PLANE]) : BG_SHADES;
}

/* Returns a table that applies fog, then the fade to black, then the shade; NULL: none of them applies. May store the
 * result in `composed2` or `composed3`. */
static const uint8_t *plane_table(const struct draw_target *c, int fog, const uint8_t *shade, uint8_t composed2[256],
                                  uint8_t composed3[256])
{
    const uint8_t *first = fog ? c->b->bg_shades.table + BG_FOG_OFFSET + (fog - 1) * 256 : NULL;

    return compose_tables(compose_tables(first, brush_of(c, BG_PLANE).remap, composed2), shade, composed3);
}

static void draw_plane(struct draw_target *c, const uint8_t *shade)
{
    const struct bg *g = &c->b->bg;
    const int w = c->area.w, h = c->area.h, horizon = g->horizon[BG_PLANE] + c->shake_y;
    const bool is_ceiling = g->flags[BG_PLANE] & BG_CEILING;
    struct brush brush = brush_of(c, BG_PLANE);
    uint8_t row[MAX_ROW_WIDTH], composed2[256], composed3[256];
    struct map m;
    int current_fog = -1;

    cart_map(&c->b->cart, g->map[BG_PLANE] - 1, &m);
    for (int y = 0; y < h; y++) {
        int64_t half_rows = is_ceiling ? 2 * (horizon - y) - 1 : 2 * (y - horizon) + 1;
        if (half_rows <= 0)
            continue;
        int64_t s = (4 * (int64_t)g->height[BG_PLANE] + half_rows) / (2 * half_rows);
        int fog = fog_at(g, w, s);
        if (fog != current_fog)
            brush.remap = plane_table(c, current_fog = fog, shade, composed2, composed3);
        bool solid = walk_row(&m, advance_walk(walk_of(g, &m, w, s), &m, -c->shake_x), w, row);
        draw_pixels(c, &brush, row, 0, y, w, solid);
    }
    c->drawn_count++;
}

static bool is_shown(const struct bg *g, uint32_t i, bool front)
{
    return g->map[i] && !(g->flags[i] & BG_HIDDEN) && !(g->flags[i] & BG_FRONT) == !front;
}

/* Returns whether layer i hides everything under it. */
static bool layer_covers(const struct board *b, uint32_t i)
{
    struct map m;

    if (!is_shown(&b->bg, i, false) || !(b->bg.flags[i] & BG_WRAP) || b->bg.flags[i] & BG_BLEND)
        return false;
    cart_map(&b->cart, b->bg.map[i] - 1, &m);
    return m.all_solid;
}

/* Returns the frontmost layer that covers the field, or -1. */
static int find_covering_layer(const struct board *b)
{
    int i = (int)b->bg.s.live - 2;

    while (i >= 0 && !layer_covers(b, (uint32_t)i))
        i--;
    return i;
}

bool video_bg_covers(const struct board *b)
{
    return find_covering_layer(b) >= 0;
}

void video_draw_bg(struct draw_target *c, bool front)
{
    const struct bg *g = &c->b->bg;
    const uint8_t *shade = front ? c->shade : NULL; /* the other layers are shaded later, with the back sprites */
    const int first = front ? 0 : find_covering_layer(c->b);

    for (int i = first < 0 ? 0 : first; i + 1 < (int)g->s.live; i++) {
        if (is_shown(g, (uint32_t)i, front))
            draw_layer(c, (uint32_t)i, shade);
        if (i == 0 && is_shown(g, BG_PLANE, front))
            draw_plane(c, shade);
    }
}
