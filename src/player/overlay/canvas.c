/*
 * canvas.c - colours, the small font and shapes (canvas.h). canvas_large.c draws the large font.
 */
#include "canvas.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include "../../../fb/blit.h"
#include "../../base/fx.h"
#include "../../base/geom.h"
#include "../../base/int.h"
#include "../../machine/video/pal.h"
#include "letters.h"

enum { GLYPH_H = 6, GLYPH_W = 3 };

/* The glyphs of ' ' to '~'. Each octal digit is a row of three pixels; the last row is below the baseline. */
static const uint32_t glyphs[95] = {
    0000000, 0222020, 0550000, 0575750, 0362360, 0512450, 0252530, 0220000, /*  !"#$%&' */
    0122210, 0422240, 0052500, 0027200, 0000240, 0007000, 0000020, 0112440, /* ()*+,-./ */
    0755570, 0262270, 0717470, 0717170, 0557110, 0747170, 0747570, 0711220, /* 01234567 */
    0757570, 0757170, 0020200, 0020240, 0124210, 0070700, 0421240, 0713020, /* 89:;<=>? */
    0757430, 0257550, 0656560, 0344430, 0655560, 0746470, 0746440, 0345530, /* @ABCDEFG */
    0557550, 0722270, 0111520, 0556550, 0444470, 0577550, 0655550, 0255520, /* HIJKLMNO */
    0656440, 0255630, 0656550, 0342160, 0722220, 0555570, 0555520, 0557750, /* PQRSTUVW */
    0552550, 0552220, 0712470, 0644460, 0442110, 0311130, 0250000, 0000070, /* XYZ[\]^_ */
    0420000, 0035530, 0465560, 0034430, 0135530, 0027430, 0127220, 0035316, /* `abcdefg */
    0465550, 0202220, 0101116, 0456550, 0622230, 0077550, 0065550, 0025520, /* hijklmno */
    0065564, 0035531, 0056440, 0036360, 0272210, 0055530, 0055520, 0055770, /* pqrstuvw */
    0052250, 0055316, 0073670, 0326230, 0222220, 0623260, 0036000,          /* xyz{|}~ */
};

static const uint32_t colours[CANVAS_COLOURS] = {
    [CANVAS_DARK] = 0x101828,  [CANVAS_WHITE] = 0xFFFFFF,  [CANVAS_GREY] = 0x8C98A8, [CANVAS_RED] = 0xFF5858,
    [CANVAS_GREEN] = 0x58E070, [CANVAS_YELLOW] = 0xFFE050, [CANVAS_CYAN] = 0x50D8FF, [CANVAS_MAGENTA] = 0xFF70E8,
};

/* ---- colours ---- */

static void count_pixels(const struct fb *fb, uint32_t count[256])
{
    for (int y = 0; y < fb->h; y++)
        for (int x = 0; x < fb->w; x++)
            count[fb->pix[y * fb->pitch + x]]++;
}

/* Returns the least used entry that is not taken, the last of equal ones. */
static int least_used(const uint32_t count[256], const bool taken[256])
{
    int best = -1;
    for (int i = 255; i >= 0; i--)
        if (!taken[i] && (best < 0 || count[i] < count[best]))
            best = i;
    return best;
}

static uint32_t distance(uint32_t a, uint32_t b)
{
    uint32_t sum = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        int d = (int)(a >> shift & 255) - (int)(b >> shift & 255);
        sum += (uint32_t)(d * d);
    }
    return sum;
}

static uint8_t nearest(const uint32_t rgb[256], const bool taken[256], int entry)
{
    int best = -1;
    for (int i = 0; i < 256; i++)
        if (!taken[i] && (best < 0 || distance(rgb[i], rgb[entry]) < distance(rgb[best], rgb[entry])))
            best = i;
    return (uint8_t)(best < 0 ? entry : best);
}

/* Gives pixels that use a taken entry the nearest other one. */
static void free_entries(const struct fb *fb, const uint32_t rgb[256], const uint32_t count[256], const bool taken[256])
{
    uint8_t to[256];
    bool seen = false;

    for (int i = 0; i < 256; i++) {
        const bool moves = taken[i] && count[i];
        to[i] = moves ? nearest(rgb, taken, i) : (uint8_t)i;
        seen = seen || moves;
    }
    for (int y = 0; y < fb->h && seen; y++)
        for (int x = 0; x < fb->w; x++)
            fb->pix[y * fb->pitch + x] = to[fb->pix[y * fb->pitch + x]];
}

static struct canvas plain_canvas(struct fb *fb, uint32_t rgb[256])
{
    fb_reset_clip(fb);
    return (struct canvas){ .fb = fb,
                            .rgb = rgb,
                            .ascent = CANVAS_LARGE_ACCENT_HEIGHT,
                            .capital_height = LETTER_CAPITAL_HEIGHT,
                            .descent = CANVAS_LARGE_HEIGHT - LETTER_CAPITAL_HEIGHT };
}

/* Takes the entry that the picture uses least. */
static uint8_t take_entry(struct canvas *canvas, const uint32_t count[256])
{
    const int entry = least_used(count, canvas->own);

    canvas->own[entry] = true;
    return (uint8_t)entry;
}

void canvas_open(struct canvas *canvas, struct fb *fb, uint32_t rgb[256])
{
    uint32_t count[256] = { 0 };

    *canvas = plain_canvas(fb, rgb);
    count_pixels(fb, count);
    for (int i = 0; i < CANVAS_COLOURS; i++)
        canvas->colour[i] = take_entry(canvas, count);
    free_entries(fb, rgb, count, canvas->own);
    for (int i = 0; i < CANVAS_COLOURS; i++)
        rgb[canvas->colour[i]] = colours[i];
}

void canvas_set_colour_blind_mode(const struct canvas *canvas, enum colour_blind_mode mode)
{
    for (int i = 0; i < 256; i++)
        if (canvas->own[i])
            canvas->rgb[i] = view_adjust_colour(mode, canvas->rgb[i]);
}

void canvas_add_colours(const struct canvas *canvas, const uint32_t *added, int n, uint8_t *entries)
{
    uint32_t count[256] = { 0 };
    bool taken[256];
    int fitting = 0;

    memcpy(taken, canvas->own, sizeof taken);
    count_pixels(canvas->fb, count);
    for (int at; fitting < n && (at = least_used(count, taken)) >= 0; taken[at] = true)
        entries[fitting++] = (uint8_t)at;
    for (int i = 0; i < 256; i++)
        count[i] = canvas->own[i] ? 0 : count[i]; /* the canvas's own pixels stay */
    free_entries(canvas->fb, canvas->rgb, count, taken);
    for (int i = 0; i < fitting; i++)
        canvas->rgb[entries[i]] = added[i];
    for (int i = fitting; i < n; i++) {
        entries[i] = entries[0];
        for (int k = 1; k < fitting; k++)
            if (distance(added[k], added[i]) < distance(canvas->rgb[entries[i]], added[i]))
                entries[i] = entries[k];
    }
}

/* ---- themes ---- */

enum { BANK = 16 };

/* Takes the bank that the picture uses least. Returns its number. */
static int take_bank(struct canvas *canvas, const uint32_t count[256])
{
    uint64_t least = UINT64_MAX;
    int best = 0;

    for (int bank = 0; bank < 256 / BANK; bank++) {
        uint64_t used = 0;
        for (int i = 0; i < BANK; i++)
            used += count[bank * BANK + i];
        if (canvas->own[bank * BANK] || used >= least)
            continue;
        least = used;
        best = bank;
    }
    memset(canvas->own + best * BANK, true, BANK);
    return best;
}

/* Stores a game's bank in one of the canvas's, mixed with the paper by `share` of 256. */
static void copy_bank(const struct canvas *canvas, int to, int from, int share)
{
    const uint32_t paper = theme_colour(canvas->theme, canvas->theme->paper);

    for (int i = 1; i < BANK; i++)
        canvas->rgb[to * BANK + i] = pal_mix(theme_colour(canvas->theme, from * BANK + i), paper, share, 256);
}

/* Makes lines high enough for a theme's font and, with a gap of a pixel, for full-width letters. */
static void make_room(struct canvas *canvas, const struct theme *theme)
{
    const int above = (theme->full_width - theme->capital_height) / 2;

    canvas->ascent = int_max(canvas->ascent, above);
    canvas->descent = int_max(canvas->descent, theme->full_width - theme->capital_height - above + 1);
    canvas->ascent = int_max(canvas->ascent, theme->capital_top);
    canvas->descent = int_max(canvas->descent, theme->height - theme->capital_top - theme->capital_height);
}

void canvas_add_font(struct canvas *canvas, const struct theme *theme)
{
    if (!theme->has_font)
        return;
    canvas->spare = theme;
    make_room(canvas, theme);
}

void canvas_open_theme(struct canvas *canvas, struct fb *fb, uint32_t rgb[256], const struct theme *theme)
{
    enum { PAPER_SHARE = 112, /* of 256, in faint ink */ DIM = 115 /* of 256, as page.begin */ };
    const uint32_t paper = theme_colour(theme, theme->paper), ink = theme_text_colour(theme, theme->ink);
    uint32_t count[256] = { 0 };
    uint8_t bank[5];

    *canvas = plain_canvas(fb, rgb);
    canvas->theme = theme;
    if (theme->has_font) {
        make_room(canvas, theme);
        canvas->capital_height = theme->capital_height;
    }
    count_pixels(fb, count);
    for (int i = 0; i < 5; i++)
        bank[i] = (uint8_t)take_bank(canvas, count);
    for (int i = 0; i < CANVAS_COLOURS; i++)
        canvas->plain[i] = take_entry(canvas, count);
    free_entries(fb, rgb, count, canvas->own);
    for (int i = 0; i < 256; i++)
        rgb[i] = canvas->own[i] ? paper : pal_mix(rgb[i], 0, DIM, 256);
    copy_bank(canvas, bank[0], theme->ink, 0);
    copy_bank(canvas, bank[1], theme->accent, 0);
    copy_bank(canvas, bank[2], theme->ink, PAPER_SHARE);
    copy_bank(canvas, bank[3], theme->has_frame ? theme->frame.bank : theme->ink, 0);
    copy_bank(canvas, bank[4], theme->rule, 0);
    rgb[bank[0] * BANK] = ink;
    rgb[bank[1] * BANK] = theme_text_colour(theme, theme->accent);
    rgb[bank[2] * BANK] = pal_mix(ink, paper, PAPER_SHARE, 256);
    rgb[bank[4] * BANK] = theme_text_colour(theme, theme->rule);
    canvas->frame_bank = bank[3];
    for (int i = 0; i < CANVAS_COLOURS; i++) {
        canvas->bank[i] = bank[i == CANVAS_WHITE ? 0 : i == CANVAS_GREY ? 2 : i == CANVAS_CYAN ? 4 : 1];
        rgb[canvas->plain[i]] = colours[i];
        canvas->colour[i] = (uint8_t)((i == CANVAS_DARK ? bank[3] : canvas->bank[i]) * BANK);
    }
}

struct canvas canvas_plain(const struct canvas *canvas)
{
    const struct theme *font = canvas->theme ? canvas->theme : canvas->spare;
    struct canvas plain = plain_canvas(canvas->fb, canvas->rgb);

    memcpy(plain.own, canvas->own, sizeof plain.own);
    memcpy(plain.colour, canvas->theme ? canvas->plain : canvas->colour, sizeof plain.colour);
    if (font)
        canvas_add_font(&plain, font);
    return plain;
}

/* ---- text ---- */

static uint32_t glyph(unsigned char c)
{
    return c >= ' ' && c <= '~' ? glyphs[c - ' '] : glyphs['?' - ' '];
}

static void draw_glyph(struct fb *fb, int x, int y, uint32_t rows, uint8_t colour)
{
    for (int i = 0; i < GLYPH_H * GLYPH_W; i++)
        if (rows >> (GLYPH_H * GLYPH_W - 1 - i) & 1)
            fb_fill_rect(fb, x + i % GLYPH_W, y + i / GLYPH_W, 1, 1, colour);
}

/* Returns the columns that a byte occupies; 0 if it continues a UTF-8 character. */
static int columns_of(unsigned char c)
{
    return (c & 0xC0) == 0x80 ? 0 : c == '\t' ? 2 : 1;
}

int canvas_text_n(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text, int n)
{
    for (int i = 0; i < n && text[i]; i++) {
        unsigned char byte = (unsigned char)text[i];
        if (columns_of(byte) == 1 && byte != ' ')
            draw_glyph(canvas->fb, x, y, glyph(byte), canvas->colour[c]);
        x += columns_of(byte) * CANVAS_CELL_W;
    }
    return x;
}

int canvas_text(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text)
{
    return canvas_text_n(canvas, x, y, c, text, INT32_MAX);
}

int canvas_text_width(const char *text)
{
    int w = 0;
    for (; *text; text++)
        w += columns_of((unsigned char)*text) * CANVAS_CELL_W;
    return w;
}

int canvas_text_fit(const char *text, int width)
{
    int n = 0, used = 0, blank = 0;
    for (; text[n] && text[n] != '\n'; n++) {
        used += columns_of((unsigned char)text[n]);
        if (used > width)
            return blank > width / 2 ? blank : n ? n : 1;
        if (text[n] == ' ')
            blank = n + 1;
    }
    return n;
}

/* ---- shapes ---- */

void canvas_rect(const struct canvas *canvas, int x, int y, int w, int h, enum canvas_colour c)
{
    fb_fill_rect(canvas->fb, x, y, w, h, canvas->colour[c]);
}

void canvas_outline(const struct canvas *canvas, int x, int y, int w, int h, enum canvas_colour c)
{
    fb_outline(canvas->fb, x, y, w, h, canvas->colour[c]);
}

void canvas_line(const struct canvas *canvas, int x0, int y0, int x1, int y1, enum canvas_colour c)
{
    fb_line(canvas->fb, x0, y0, x1, y1, canvas->colour[c]);
}

static uint8_t rim_of(const struct canvas *canvas, enum canvas_colour c)
{
    return canvas->theme ? (uint8_t)(canvas->bank[c] * BANK + THEME_RIM) : canvas->colour[c];
}

void canvas_plate(const struct canvas *canvas, int x, int y, int w, int h, enum canvas_colour c)
{
    const uint32_t *bank = canvas->rgb + canvas->bank[c] * BANK;
    const bool readable = canvas->theme && theme_contrast(bank[0], bank[1]) >= THEME_MIN_CONTRAST;

    fb_plate(canvas->fb, x, y, w, h, readable ? (uint8_t)(canvas->bank[c] * BANK + 1) : canvas->colour[CANVAS_DARK],
             rim_of(canvas, c));
}

/* A rectangle, px. */
struct area {
    int x, y, w, h;
};

/* Fills an area with the part of the frame's picture at (u, v), part_w x part_h px. */
static void tile_frame_part(const struct canvas *canvas, struct area to, int u, int v, int part_w, int part_h)
{
    const struct sprite *s = &canvas->theme->frame;
    const struct image image = { s->pix, s->w, s->h, s->pitch };
    const uint8_t bank = (uint8_t)((canvas->frame_bank - s->bank) & 15);

    for (int y = 0; y < to.h && part_h > 0; y += part_h)
        for (int x = 0; x < to.w && part_w > 0; x += part_w) {
            fb_set_clip(canvas->fb, to.x + x, to.y + y, int_min(part_w, to.w - x), int_min(part_h, to.h - y));
            blit_sprite(canvas->fb, &image, to.x + x - u, to.y + y - v, bank, 0);
        }
    fb_reset_clip(canvas->fb);
}

int canvas_frame_width(const struct canvas *canvas)
{
    const struct theme *t = canvas->theme;

    return t && t->has_frame ? int_max(t->frame.w, t->frame.h) / 3 : 3;
}

void canvas_frame(const struct canvas *canvas, int x, int y, int w, int h)
{
    if (!canvas->theme || !canvas->theme->has_frame) {
        fb_plate(canvas->fb, x, y, w, h, canvas->colour[CANVAS_DARK], rim_of(canvas, CANVAS_WHITE));
        return;
    }
    const struct sprite *s = &canvas->theme->frame;
    const int cw = s->w / 3, ch = s->h / 3;
    const int u[4] = { 0, cw, s->w - cw, s->w }, v[4] = { 0, ch, s->h - ch, s->h };
    const int xs[4] = { x, x + cw, x + w - cw, x + w }, ys[4] = { y, y + ch, y + h - ch, y + h };
    canvas_rect(canvas, x + cw / 2, y + ch / 2, w - cw / 2 * 2, h - ch / 2 * 2, CANVAS_DARK);
    for (int i = 0; i < 9; i++) {
        const int c = i % 3, r = i / 3;
        const struct area to = { xs[c], ys[r], xs[c + 1] - xs[c], ys[r + 1] - ys[r] };
        tile_frame_part(canvas, to, u[c], v[r], u[c + 1] - u[c], v[r + 1] - v[r]);
    }
}

enum { SUBPIXELS = 256 };

/* The pixels whose centres are inside a circle, in subpixels. */
struct disc {
    int64_t x, y, r_squared;
};

static int64_t floor_pixel(int64_t v)
{
    return v >= 0 ? v / SUBPIXELS : -((SUBPIXELS - 1 - v) / SUBPIXELS);
}

/* Computes a row's pixels x0 to x1. An empty row has x0 > x1, both outside any picture. */
static void row_span(const struct disc *d, int64_t row, int64_t *x0, int64_t *x1)
{
    int64_t dy = row * SUBPIXELS + SUBPIXELS / 2 - d->y, left = d->r_squared - dy * dy,
            half = left < 0 ? 0 : (int64_t)fx_root_bits((uint64_t)left);
    *x0 = left < 0 ? INT32_MAX : -floor_pixel(half + SUBPIXELS / 2 - d->x);
    *x1 = left < 0 ? INT32_MIN : floor_pixel(d->x + half - SUBPIXELS / 2);
}

static void draw_span(const struct canvas *canvas, int64_t row, int64_t x0, int64_t x1, enum canvas_colour c)
{
    const struct fb *fb = canvas->fb;
    x0 = x0 < fb->x0 ? fb->x0 : x0;
    x1 = x1 >= fb->x1 ? fb->x1 - 1 : x1;
    if (x0 <= x1)
        fb_fill_rect(canvas->fb, (int)x0, (int)row, (int)(x1 - x0 + 1), 1, canvas->colour[c]);
}

/* Draws the outline in a row: its two ends, and the pixels that the next row outwards does not have. */
static void draw_rim_row(const struct canvas *canvas, const struct disc *d, int64_t row, enum canvas_colour c)
{
    int64_t x0, x1, next0, next1;
    row_span(d, row, &x0, &x1);
    if (x0 > x1)
        return;
    row_span(d, row * SUBPIXELS + SUBPIXELS / 2 < d->y ? row - 1 : row + 1, &next0, &next1);
    draw_span(canvas, row, x0, next0 > next1 || next0 <= x0 ? x0 : next0 - 1, c);
    draw_span(canvas, row, next0 > next1 || next1 >= x1 ? x1 : next1 + 1, x1, c);
    if (next0 > next1)
        draw_span(canvas, row, x0, x1, c);
}

/* reach: the greatest distance of a row from the centre, in pixels. */
static void draw_rim(const struct canvas *canvas, const struct disc *d, int64_t reach, enum canvas_colour c)
{
    const struct fb *fb = canvas->fb;
    int64_t from = floor_pixel(d->y) - reach, to = floor_pixel(d->y) + reach;
    from = from < fb->y0 ? fb->y0 : from;
    to = to >= fb->y1 ? fb->y1 - 1 : to;
    for (int64_t row = from; row <= to; row++)
        draw_rim_row(canvas, d, row, c);
}

/* ---- hitboxes ---- */

enum { FX = 65536, FX_PER_SUBPIXEL = FX / SUBPIXELS };

/* Draws the pixel of (x, y), for a shape that may contain no pixel centre. */
static void draw_pixel(const struct canvas *canvas, int64_t x, int64_t y, enum canvas_colour c)
{
    draw_span(canvas, y >> 16, x >> 16, x >> 16, c);
}

void canvas_circle(const struct canvas *canvas, int32_t x, int32_t y, int32_t r, enum canvas_colour c)
{
    int64_t units = r / FX_PER_SUBPIXEL;
    struct disc d = { x / FX_PER_SUBPIXEL, y / FX_PER_SUBPIXEL, units * units };
    if (r < FX)
        draw_pixel(canvas, x, y, c);
    if (r > 0)
        draw_rim(canvas, &d, units / SUBPIXELS + 1, c);
}

void canvas_disc(const struct canvas *canvas, int32_t x, int32_t y, int32_t r, enum canvas_colour c)
{
    int64_t units = r / FX_PER_SUBPIXEL, reach = units / SUBPIXELS + 1, x0, x1;
    struct disc d = { x / FX_PER_SUBPIXEL, y / FX_PER_SUBPIXEL, units * units };
    const int64_t from = int64_clamp(floor_pixel(d.y) - reach, canvas->fb->y0, canvas->fb->y1);
    const int64_t to = int64_clamp(floor_pixel(d.y) + reach + 1, canvas->fb->y0, canvas->fb->y1);

    if (r < FX)
        draw_pixel(canvas, x, y, c);
    for (int64_t row = from; row < to; row++) {
        row_span(&d, row, &x0, &x1);
        draw_span(canvas, row, x0, x1, c);
    }
}

/* Returns the first pixel whose centre is at or after v. */
static int64_t first_pixel_at(int64_t v)
{
    return (v - FX / 2 + FX - 1) >> 16;
}

void canvas_box(const struct canvas *canvas, int32_t x, int32_t y, int32_t a, int32_t b, enum canvas_colour c)
{
    int64_t x0 = first_pixel_at((int64_t)x - a), x1 = first_pixel_at((int64_t)x + a + 1);
    int64_t y0 = first_pixel_at((int64_t)y - b), y1 = first_pixel_at((int64_t)y + b + 1);
    if (x0 < x1 && y0 < y1)
        canvas_outline(canvas, (int)x0, (int)y0, (int)(x1 - x0), (int)(y1 - y0), c);
    else
        draw_pixel(canvas, x, y, c);
}

struct capsule {
    int64_t x, y, hx, hy, r;
};

/* Returns whether the centre of a pixel is in the capsule. */
static bool is_in_capsule(const struct capsule *b, int px, int py)
{
    int64_t dx = b->x - b->hx - ((int64_t)px * FX + FX / 2), dy = b->y - b->hy - ((int64_t)py * FX + FX / 2);
    return geom_swept_circles(dx, dy, 2 * b->hx, 2 * b->hy, b->r);
}

/* Returns whether a pixel is inside, and one of its four neighbours is not. */
static bool is_on_rim(const struct capsule *b, int px, int py)
{
    return is_in_capsule(b, px, py) && !(is_in_capsule(b, px - 1, py) && is_in_capsule(b, px + 1, py) &&
                                         is_in_capsule(b, px, py - 1) && is_in_capsule(b, px, py + 1));
}

static bool is_too_large(int64_t v)
{
    const int64_t limit = (int64_t)1 << 30;
    return v > limit || v < -limit;
}

void canvas_capsule(const struct canvas *canvas, int32_t x, int32_t y, int32_t hx, int32_t hy, int32_t r,
                    enum canvas_colour c)
{
    const struct fb *fb = canvas->fb;
    const struct capsule b = { x, y, hx, hy, r };
    int64_t w = (hx < 0 ? -b.hx : b.hx) + r, h = (hy < 0 ? -b.hy : b.hy) + r;
    if (is_too_large(x) || is_too_large(y) || is_too_large(hx) || is_too_large(hy) || is_too_large(r))
        return;
    if (r < FX)
        draw_pixel(canvas, x, y, c);
    const int x0 = (int)int64_clamp((x - w) >> 16, fb->x0, fb->x1);
    const int x1 = (int)int64_clamp(((x + w) >> 16) + 1, fb->x0, fb->x1);
    const int y0 = (int)int64_clamp((y - h) >> 16, fb->y0, fb->y1);
    const int y1 = (int)int64_clamp(((y + h) >> 16) + 1, fb->y0, fb->y1);
    for (int py = y0; py < y1; py++)
        for (int px = x0; px < x1; px++)
            if (is_on_rim(&b, px, py))
                draw_span(canvas, py, px, px, c);
}
