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
#include "video.h"

enum { MARGIN = 6, CELL_GAP = 1, UNSPACED = 0x2e80 };

struct page {
    const struct cart *cart;
    struct face face; /* data NULL: the cell font is used */
    struct font font;
    const uint32_t *code;
    uint32_t n;
    int width, height; /* width of a row, px, 0: unlimited; distance between rows, px */
};

struct row {
    uint32_t first, end, next; /* the row shows codes [first, end); the next row starts at code `next` */
    int px;
};

/* Converts a glyph of the cell font to a glyph of a face. Always returns true. */
static bool cell_picture(const struct font *font, uint32_t code, struct face_glyph *g, int y)
{
    *g = (struct face_glyph){ font->glyphs + (size_t)(code - (uint32_t)font->first) * CART_GLYPH,
                              TEXT_SIDE,
                              TEXT_SIDE,
                              TEXT_SIDE,
                              0,
                              y,
                              TEXT_SIDE };
    return true;
}

/* Finds the glyph of a code in the page's font. If that font has no glyph and the code is not blank, falls back to the
 * first of `fonts` that has one, then to the cell font; such a glyph is aligned with the bottom of the row. Returns
 * false if no font has a glyph. */
static bool find(const struct page *p, uint32_t code, struct face_glyph *g)
{
    const int side = p->face.data ? p->face.height : TEXT_SIDE;

    if (p->face.data && face_find(&p->face, code, g))
        return true;
    if (text_blank(code))
        return false;
    if (!p->face.data && text_has(&p->font, code))
        return cell_picture(&p->font, code, g, 0);
    for (int i = 0; i < p->cart->faces; i++) {
        struct face face = cart_face(p->cart, i);
        if (!face_find(&face, code, g))
            continue;
        g->y += side - face.height;
        return true;
    }
    return text_has(&p->font, code) && cell_picture(&p->font, code, g, side - TEXT_SIDE);
}

static int advance(const struct page *p, uint32_t code)
{
    const int side = p->face.data ? p->face.height : TEXT_SIDE;
    struct face_glyph g;

    if (!p->face.data && text_blank(code))
        return TEXT_SIDE;
    if (find(p, code, &g))
        return g.advance;
    return text_blank(code) ? side / (code == 0x3000 ? 1 : 3) : side / 2 + 1;
}

/* Returns whether a code is opening punctuation, which never ends a row. */
static bool opens(uint32_t code)
{
    return code == 0x300c || code == 0x300e || code == 0x3010 || code == 0xff08 || code == '(';
}

/* Returns the row that starts at code `first`. */
static struct row row_at(const struct page *p, uint32_t first)
{
    struct row row = { first, first, first, 0 }, fit = row;
    bool may_break = false;

    for (uint32_t k = first; k < p->n; k++) {
        const uint32_t code = p->code[k];
        if (code == '\n') {
            row.next = k + 1;
            return row;
        }
        if (code == ' ') {
            fit = (struct row){ first, row.end, k + 1, row.px };
            may_break = true;
        } else if (k > first && code >= UNSPACED && !text_closes(code) && !opens(p->code[k - 1])) {
            fit = (struct row){ first, k, k, row.px };
            may_break = true;
        }
        row.px += advance(p, code);
        if (p->width && row.px > p->width && k > first && code != ' ')
            return may_break ? fit : (struct row){ first, k, k, row.px - advance(p, code) };
        row.end = row.next = k + 1;
    }
    return row;
}

static void draw_code(struct draw_target *c, const struct page *p, uint32_t code, int x, int y, uint8_t bank)
{
    const int side = p->face.data ? p->face.height : TEXT_SIDE;
    struct face_glyph g;

    if (find(p, code, &g)) {
        struct image image = { g.pix, g.w, g.h, g.pitch };
        blit_sprite(c->fb, &image, x + g.x, y + g.y, bank, 0);
    } else if (!text_blank(code)) {
        text_box(c->fb, x, y, advance(p, code), side, bank);
    }
}

/* Returns the number of rows of the whole text. Sets *widest to the width of the widest row, px. */
static int measure(const struct page *p, int *widest)
{
    int rows = 0;

    *widest = 0;
    for (uint32_t k = 0; k < p->n; rows++) {
        struct row row = row_at(p, k);
        *widest = row.px > *widest ? row.px : *widest;
        k = row.next;
    }
    return rows;
}

static int aligned(int align, int px)
{
    return align == LINE_CENTER ? px / 2 : align == LINE_RIGHT ? px : 0;
}

static void draw_box(struct draw_target *c, const struct page *p, const struct lines *l, uint32_t i, int x, int y)
{
    int widest, rows = measure(p, &widest);

    if (p->width)
        widest = p->width;
    x -= aligned(l->align[i], widest) + MARGIN;
    video_plate(c, x, y - MARGIN, widest + 2 * MARGIN, rows * p->height + 2 * MARGIN, l->bank[i]);
}

static struct page page_of(const struct draw_target *c, int font)
{
    const struct cart *cart = &c->b->cart;
    struct page p = { .cart = cart,
                      .font = { cart->glyphs, CART_FIRST_CHAR, cart->n_glyphs },
                      .height = TEXT_SIDE + CELL_GAP };

    if (font > 0 && font <= cart->faces) {
        p.face = cart_face(cart, font - 1);
        p.height = p.face.height + p.face.height / 8;
    }
    return p;
}

static void draw_line(struct draw_target *c, uint32_t i, int x, int y)
{
    const struct lines *l = &c->b->lines;
    const uint32_t seen = lines_seen(l, i, c->b->core.clock);
    struct page p = page_of(c, l->font[i]);

    p.code = l->code + (size_t)i * LINE_TEXT;
    p.n = l->length[i];
    p.width = l->width[i];
    if (l->flags[i] & LINE_BOX)
        draw_box(c, &p, l, i, x, y);
    for (uint32_t k = 0; k < seen; y += p.height) {
        struct row row = row_at(&p, k);
        int at = x - aligned(l->align[i], row.px);
        for (; k < row.end && k < seen; k++) {
            draw_code(c, &p, p.code[k], at, y, l->bank[i]);
            at += advance(&p, p.code[k]);
        }
        k = row.next;
    }
}

/* Draws a quarter (0 to 3, row by row) of a glyph at double size into out. Corners follow the scale2x rule, so that
 * slanted lines do not turn into stairs. */
static void enlarge(const uint8_t *from, int quarter, uint8_t out[CART_GLYPH])
{
    const int x0 = quarter % 2 * 4, y0 = quarter / 2 * 4;

    for (int y = y0; y < y0 + 4; y++)
        for (int x = x0; x < x0 + 4; x++) {
            const uint8_t *p = from + y * FIX_CELL + x;
            uint8_t *to = out + (y - y0) * 2 * FIX_CELL + (x - x0) * 2;
            const int on = *p, up = y > 0 ? p[-FIX_CELL] : 0, down = y < 7 ? p[FIX_CELL] : 0;
            const int left = x > 0 ? p[-1] : 0, right = x < 7 ? p[1] : 0;
            const bool slant = up != down && left != right;
            to[0] = (uint8_t)(slant && left == up ? up : on);
            to[1] = (uint8_t)(slant && right == up ? up : on);
            to[FIX_CELL] = (uint8_t)(slant && left == down ? down : on);
            to[FIX_CELL + 1] = (uint8_t)(slant && right == down ? down : on);
        }
}

/* Returns the glyph's pixels as 8 x 8 px, cropped to the cell. If they have to be copied, the copy is stored in
 * `room`. */
static const uint8_t *fitted(const struct face_glyph *g, uint8_t room[CART_GLYPH])
{
    if (g->w == FIX_CELL && g->h == FIX_CELL && g->pitch == FIX_CELL && g->x == 0 && g->y == 0)
        return g->pix;
    memset(room, 0, CART_GLYPH);
    for (int y = 0; y < FIX_CELL; y++)
        for (int x = 0; x < FIX_CELL; x++) {
            const int u = x - g->x, v = y - g->y;
            if (u >= 0 && v >= 0 && u < g->w && v < g->h)
                room[y * FIX_CELL + x] = g->pix[v * g->pitch + u];
        }
    return room;
}

/* Finds the glyph that cell i shows; for a large character, the cell's quarter of its glyph, stored in `room`. Returns
 * false if there is no glyph: the cell is blank, or shows a box. */
static bool cell_glyph(const struct page *p, const struct fix *f, uint32_t i, uint8_t room[CART_GLYPH],
                       struct face_glyph *g)
{
    uint8_t whole[CART_GLYPH];

    if (!find(p, fix_code(f, i), g))
        return false;
    if (!(f->bank[i] & FIX_QUARTERS))
        return true;
    enlarge(fitted(g, whole), f->bank[i] / FIX_BIG - 1, room);
    *g = (struct face_glyph){ room, FIX_CELL, FIX_CELL, FIX_CELL, 0, 0, FIX_CELL };
    return true;
}

void video_cell(struct draw_target *c, uint32_t i)
{
    const struct fix *f = &c->b->fix;
    const struct page p = page_of(c, f->page ? f->font[i] : 0);
    const int x = (int)(i % f->cols) * FIX_CELL, y = (int)(i / f->cols) * FIX_CELL, bank = f->bank[i] & FIX_BANK;
    uint8_t room[CART_GLYPH];
    struct face_glyph g;

    if (cell_glyph(&p, f, i, room, &g)) {
        struct image image = { g.pix, g.w, g.h, g.pitch };
        blit_sprite(c->fb, &image, x + g.x, y + g.y, (uint8_t)bank, 0);
    } else if (!text_blank(fix_code(f, i))) {
        text_box(c->fb, x, y, advance(&p, fix_code(f, i)), p.face.data ? p.face.height : TEXT_SIDE, (uint8_t)bank);
    }
}

void video_cell_rim(struct draw_target *c, uint32_t i, uint8_t rim)
{
    const struct fix *f = &c->b->fix;
    const struct page p = page_of(c, f->page ? f->font[i] : 0);
    const int x = (int)(i % f->cols) * FIX_CELL, y = (int)(i / f->cols) * FIX_CELL;
    uint8_t room[CART_GLYPH];
    struct face_glyph g;

    if (!p.face.data && !(f->bank[i] & FIX_QUARTERS) && text_has(&p.font, fix_code(f, i))) {
        text_rim(c->fb, &p.font, x, y, fix_code(f, i), rim);
    } else if (!cell_glyph(&p, f, i, room, &g)) {
        return;
    } else if (g.pix == room) {
        const struct font one = { room, (int)fix_code(f, i), 1 };
        text_rim(c->fb, &one, x, y, fix_code(f, i), rim);
    } else {
        struct image image = { g.pix, g.w, g.h, g.pitch };
        blit_rim(c->fb, &image, x + g.x, y + g.y, rim);
    }
}

void video_lines(struct draw_target *c)
{
    const struct lines *l = &c->b->lines;

    EACH_LIVE (i, &l->s) {
        fx x = l->x[i], y = l->y[i];
        const bool screen = l->flags[i] & LINE_SCREEN;
        if (l->flags[i] & LINE_HIDDEN || (l->follow[i] && !board_where(c->b, l->follow[i], &x, &y)))
            continue;
        if (screen)
            fb_clip_all(c->fb);
        else
            video_clip_field(c);
        draw_line(c, i, (screen ? 0 : c->x) + fx_floor(x) + fx_floor(l->dx[i]),
                  (screen ? 0 : c->y) + fx_floor(y) + fx_floor(l->dy[i]));
        c->drawn++;
    }
    fb_clip_all(c->fb);
}
