/*
 * video_lines.c - draws lines of text over everything else: broken into rows, aligned, revealed letter by letter,
 * boxed.
 *
 * Rows are broken for the whole text, so that no word jumps to the next row while it is being revealed. A row may end
 * at a space, or between characters of scripts without spaces (U+2E80 and above), but not before closing punctuation or
 * after opening punctuation.
 */
#include <string.h>
#include "../../../fb/blit.h"
#include "../../../fb/text.h"
#include "../../../fb/utf8.h"
#include "../../base/int.h"
#include "video.h"

enum { MARGIN = 6, CELL_GAP = 1, FIRST_UNSPACED_CODE = 0x2e80 };

struct page {
    const struct cart *cart;
    struct face face; /* data NULL: the cell font is used */
    struct font font;
    bool is_full_width; /* full-width letters are `screen.full_width` px wide */
    const uint32_t *code;
    uint32_t n;
    int row_width, row_height; /* width of a row, px, 0: unlimited; distance between rows, px */
};

struct row {
    uint32_t first, end, next; /* the row shows codes [first, end); the next row starts at code `next` */
    int width;
};

static bool find_glyph(const struct page *p, uint32_t code, struct face_glyph *g)
{
    return (p->is_full_width && utf8_is_full_width(code) ? cart_find_full_width_glyph : cart_find_glyph)(
        p->cart, p->face.data ? &p->face : NULL, code, g);
}

static int glyph_advance(const struct page *p, uint32_t code)
{
    struct face_glyph g;

    return find_glyph(p, code, &g) ? g.advance : (p->face.data ? p->face.height : TEXT_SIDE) / 2 + 1;
}

/* Returns the row that starts at code `first`. */
static struct row row_at(const struct page *p, uint32_t first)
{
    struct row row = { first, first, first, 0 }, last_break = row;
    bool may_break = false;

    for (uint32_t k = first; k < p->n; k++) {
        const uint32_t code = p->code[k];
        if (code == '\n') {
            row.next = k + 1;
            return row;
        }
        if (code == ' ') {
            last_break = (struct row){ first, row.end, k + 1, row.width };
            may_break = true;
        } else if (k > first && code >= FIRST_UNSPACED_CODE && !text_is_closing_punctuation(code) &&
                   !text_is_opening_punctuation(p->code[k - 1])) {
            last_break = (struct row){ first, k, k, row.width };
            may_break = true;
        }
        row.width += glyph_advance(p, code);
        if (p->row_width && row.width > p->row_width && k > first && code != ' ')
            return may_break ? last_break : (struct row){ first, k, k, row.width - glyph_advance(p, code) };
        row.end = row.next = k + 1;
    }
    return row;
}

/* Draws a code's glyph or, if g is NULL and the code is not blank, a box. */
static void draw_glyph(struct draw_target *c, const struct page *p, uint32_t code, const struct face_glyph *g, int x,
                       int y, uint8_t bank)
{
    if (g) {
        struct image image = { g->pix, g->w, g->h, g->pitch };
        blit_sprite(c->fb, &image, x + g->x, y + g->y, bank, 0);
    } else if (!text_is_blank(code)) {
        text_draw_box(c->fb, x, y, glyph_advance(p, code), p->face.data ? p->face.height : TEXT_SIDE, bank);
    }
}

/* Returns the number of rows of the whole text. Sets *widest to the width of the widest row, px. */
static int measure_text(const struct page *p, int *widest)
{
    int rows = 0;

    *widest = 0;
    for (uint32_t k = 0; k < p->n; rows++) {
        struct row row = row_at(p, k);
        *widest = row.width > *widest ? row.width : *widest;
        k = row.next;
    }
    return rows;
}

static int align_offset(int align, int px)
{
    return align == LINE_CENTER ? px / 2 : align == LINE_RIGHT ? px : 0;
}

static void draw_box(struct draw_target *c, const struct page *p, const struct lines *l, uint32_t i, int x, int y)
{
    int widest, rows = measure_text(p, &widest);

    if (p->row_width)
        widest = p->row_width;
    x -= align_offset(l->align[i], widest) + MARGIN;
    video_draw_plate(c, x, y - MARGIN, widest + 2 * MARGIN, rows * p->row_height + 2 * MARGIN, l->bank[i]);
}

static struct page page_of(const struct draw_target *c, int font, bool is_full_width)
{
    const struct cart *cart = &c->b->cart;
    struct page p = { .cart = cart,
                      .is_full_width = is_full_width,
                      .font = { cart->glyphs, CART_FIRST_CHAR, cart->n_glyphs },
                      .row_height = TEXT_SIDE + CELL_GAP };

    if (font > 0 && font <= cart->count[CART_FACES]) {
        p.face = cart_face(cart, font - 1);
        p.row_height = p.face.height + p.face.height / 8;
    }
    return p;
}

static void draw_line(struct draw_target *c, uint32_t i, int x, int y)
{
    const struct lines *l = &c->b->lines;
    const uint32_t visible_count = lines_visible_letters(l, i, c->b->core.clock);
    struct page p = page_of(c, l->font[i], l->flags[i] & LINE_FULL_WIDTH && c->b->cart.manifest.full_width > TEXT_SIDE);

    p.code = l->code + (size_t)i * LINE_MAX_TEXT;
    p.n = l->length[i];
    p.row_width = l->wrap_width[i];
    if (p.is_full_width)
        p.row_height = int_max(p.row_height, c->b->cart.manifest.full_width + CELL_GAP);
    if (l->flags[i] & LINE_BOX)
        draw_box(c, &p, l, i, x, y);
    for (uint32_t k = 0; k < visible_count; y += p.row_height) {
        struct row row = row_at(&p, k);
        int pen_x = x - align_offset(l->align[i], row.width);
        for (; k < row.end && k < visible_count; k++) {
            struct face_glyph g;
            draw_glyph(c, &p, p.code[k], find_glyph(&p, p.code[k], &g) ? &g : NULL, pen_x, y, l->bank[i]);
            pen_x += glyph_advance(&p, p.code[k]);
        }
        k = row.next;
    }
}

/* Draws a part (row by row) of a glyph at `size` times its size into out. Corners of pixels follow the scale2x rule, so
 * that slanted lines do not turn into stairs. */
static void enlarge(const uint8_t *from, int size, int part, uint8_t out[CART_GLYPH_SIZE])
{
    const int x0 = part % size * FIX_CELL_SIZE, y0 = part / size * FIX_CELL_SIZE;

    for (int i = 0; i < CART_GLYPH_SIZE; i++) {
        const int at_x = x0 + i % FIX_CELL_SIZE, at_y = y0 + i / FIX_CELL_SIZE;
        const int x = at_x / size, y = at_y / size, sub_x = at_x % size, sub_y = at_y % size;
        const uint8_t *p = from + y * FIX_CELL_SIZE + x;
        const int up = y > 0 ? p[-FIX_CELL_SIZE] : 0, down = y < 7 ? p[FIX_CELL_SIZE] : 0;
        const int left = x > 0 ? p[-1] : 0, right = x < 7 ? p[1] : 0;
        const int beside = sub_x ? right : left, over = sub_y ? down : up;
        const bool is_corner = (!sub_x || sub_x == size - 1) && (!sub_y || sub_y == size - 1);
        out[i] = (uint8_t)(is_corner && up != down && left != right && beside == over ? over : *p);
    }
}

/* Returns the glyph's pixels as 8 x 8 px, cropped to the cell. If they have to be copied, the copy is stored in
 * `buffer`. */
static const uint8_t *crop_to_cell(const struct face_glyph *g, uint8_t buffer[CART_GLYPH_SIZE])
{
    if (g->w == FIX_CELL_SIZE && g->h == FIX_CELL_SIZE && g->pitch == FIX_CELL_SIZE && g->x == 0 && g->y == 0)
        return g->pix;
    memset(buffer, 0, CART_GLYPH_SIZE);
    for (int y = 0; y < FIX_CELL_SIZE; y++)
        for (int x = 0; x < FIX_CELL_SIZE; x++) {
            const int u = x - g->x, v = y - g->y;
            if (u >= 0 && v >= 0 && u < g->w && v < g->h)
                buffer[y * FIX_CELL_SIZE + x] = g->pix[v * g->pitch + u];
        }
    return buffer;
}

/* Finds the glyph that cell i shows; for a large character, the cell's part of its glyph, stored in `buffer`.
 * Returns false if there is no glyph: the cell is blank, or shows a box. */
static bool find_cell_glyph(const struct page *p, const struct fix *f, uint32_t i, uint8_t buffer[CART_GLYPH_SIZE],
                            struct face_glyph *g)
{
    uint8_t whole[CART_GLYPH_SIZE];

    if (!find_glyph(p, fix_code(f, i), g) || g->w == 0)
        return false;
    if (!(f->style[i] & FIX_PART))
        return true;
    const int part = f->style[i] & FIX_PART, size = part < FIX_TRIPLE ? 2 : 3;
    enlarge(crop_to_cell(g, whole), size, (part - (size == 2 ? FIX_DOUBLE : FIX_TRIPLE)) >> 5, buffer);
    *g = (struct face_glyph){ buffer, FIX_CELL_SIZE, FIX_CELL_SIZE, FIX_CELL_SIZE, 0, 0, FIX_CELL_SIZE };
    return true;
}

void video_draw_cell(struct draw_target *c, uint32_t i)
{
    const struct fix *f = &c->b->fix;
    const struct page p = page_of(c, f->page ? f->font[i] : 0, f->style[i] & FIX_FULL_WIDTH);
    const int x = fix_x(f, i), y = fix_y(f, i);
    uint8_t buffer[CART_GLYPH_SIZE];
    struct face_glyph g;

    draw_glyph(c, &p, fix_code(f, i), find_cell_glyph(&p, f, i, buffer, &g) ? &g : NULL, x, y, f->style[i] & FIX_BANK);
}

void video_draw_cell_rim(struct draw_target *c, uint32_t i, uint8_t rim)
{
    const struct fix *f = &c->b->fix;
    const struct page p = page_of(c, f->page ? f->font[i] : 0, f->style[i] & FIX_FULL_WIDTH);
    const int x = fix_x(f, i), y = fix_y(f, i);
    uint8_t buffer[CART_GLYPH_SIZE];
    struct face_glyph g;

    if (!p.face.data && !(f->style[i] & (FIX_PART | FIX_FULL_WIDTH)) && text_has_glyph(&p.font, fix_code(f, i))) {
        text_draw_rim(c->fb, &p.font, x, y, fix_code(f, i), rim);
    } else if (!find_cell_glyph(&p, f, i, buffer, &g)) {
        return;
    } else if (g.pix == buffer) {
        const struct font cell_font = { buffer, (int)fix_code(f, i), 1 };
        text_draw_rim(c->fb, &cell_font, x, y, fix_code(f, i), rim);
    } else {
        struct image image = { g.pix, g.w, g.h, g.pitch };
        blit_rim(c->fb, &image, x + g.x, y + g.y, rim);
    }
}

void video_draw_lines(struct draw_target *c)
{
    const struct lines *l = &c->b->lines;

    EACH_LIVE (i, &l->s) {
        fx x = l->x[i], y = l->y[i];
        const bool on_screen = l->flags[i] & LINE_SCREEN;
        if (l->flags[i] & LINE_HIDDEN ||
            (l->follow_target[i] && !board_get_position(c->b, l->follow_target[i], &x, &y)))
            continue;
        if (on_screen)
            fb_reset_clip(c->fb);
        else
            video_clip_field(c);
        const int px = fx_floor(x) + fx_floor(l->dx[i]), py = fx_floor(y) + fx_floor(l->dy[i]);
        draw_line(c, i, on_screen ? px : video_screen_x(c, c->x + px), on_screen ? py : video_screen_y(c, c->y + py));
        c->drawn_count++;
    }
    fb_reset_clip(c->fb);
}
