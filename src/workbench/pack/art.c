/*
 * art.c - see art.h. A sprite is made in two steps: its pictures, frames and turns, into one loose stack of equal
 * cells; then the rectangle that all of them need, out of the stack into the lump. A sprite that is not turned keeps
 * the size it was given.
 */
#include "art.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../fb/resize.h"
#include "../../base/bytes.h"
#include "../../base/err.h"
#include "../../common/result.h"

enum { MAX_STACK = 64 << 20 /* bytes of one sprite's pictures */ };

/* The colour of hue sixth * 256 + part (6 sixths round the wheel) at full strength, channel 0 to 2. */
static int wheel(int hue, int channel)
{
    int at = (hue + 512 * (3 - channel)) % 1536; /* red is at 0, green at 512, blue at 1024 */
    int away = at < 768 ? at : 1536 - at;

    return away <= 256 ? 255 : away >= 512 ? 0 : (512 - away) * 255 / 256;
}

void art_default_palette(uint8_t rgb[CART_PALETTE_SIZE])
{
    for (int i = 0; i < 256; i++) {
        int bank = i / 16, shade = i % 16;
        for (int c = 0; c < 3; c++) {
            int full = bank == 0 ? 255 : wheel((bank - 1) * 1536 / 15, c);
            int light = bank == 0 || shade <= 8 ? 0 : (255 - full) * (shade - 8) / 7;
            int dark = bank == 0 ? shade * 17 : shade < 8 ? full * shade / 8 : full;
            rgb[i * 3 + c] = (uint8_t)(dark + light);
        }
    }
}

bool art_make_palette(const struct art_picture *picture, uint8_t rgb[CART_PALETTE_SIZE], char *err, size_t err_size)
{
    if (picture->w != 16 || picture->h != 16)
        return err_set(err, err_size, "%dx%d pixels, expected 16x16: one row per bank, one column per shade",
                       picture->w, picture->h);
    for (int i = 0; i < 256; i++)
        memcpy(rgb + i * 3, picture->rgba + i * 4, 3);
    return true;
}

/* Squares of the differences between two colours. */
static int difference(const uint8_t *a, const uint8_t *b)
{
    int sum = 0;

    for (int c = 0; c < 3; c++)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

/* The shade 1 to 15 of the bank (its 48 bytes) that is nearest to the colour, the lowest of equals; *off is how far it
 * is. */
static int nearest_shade(const uint8_t *colours, const uint8_t *colour, int *off)
{
    int best = 1;

    *off = difference(colours + 3, colour);
    for (int shade = 2; shade < 16 && *off > 0; shade++) {
        int d = difference(colours + shade * 3, colour);
        if (d < *off) {
            *off = d;
            best = shade;
        }
    }
    return best;
}

void art_picture_free(struct art_picture *picture)
{
    free(picture->rgba);
    free(picture->index);
    *picture = (struct art_picture){ 0 };
}

void art_place(const struct art_picture *p, int x, int y, char out[ART_PLACE])
{
    int frame = p->cell ? x / p->cell : 0;

    if (p->cell)
        snprintf(out, ART_PLACE, "frame %d, pixel %d,%d", p->frames ? p->frames[frame] : frame + 1, x % p->cell, y);
    else
        snprintf(out, ART_PLACE, "pixel %d,%d", x, y);
}

/* Is the index one of the bank, or of a palette of 16? */
static bool index_fits(int index, int bank)
{
    return index < 16 || index / 16 == bank;
}

static int refuse_index(const struct art_picture *p, int x, int y, int index, int bank, char *err, size_t err_size)
{
    char place[ART_PLACE];

    art_place(p, x, y, place);
    err_set(err, err_size, "%s: index %d is in bank %d, expected bank %d (%d to %d) or 0 to 15", place, index,
            index / 16, bank, bank * 16, bank * 16 + 15);
    return -1;
}

static int refuse_colour(const struct art_picture *p, int x, int y, const uint8_t *colour, int bank, char *err,
                         size_t err_size)
{
    char place[ART_PLACE];

    art_place(p, x, y, place);
    err_set(err, err_size,
            "%s: colour #%02x%02x%02x is not in bank %d (use --nearest for the nearest colour, or match = \"index\" in "
            "rom.lua to use the indices of an indexed picture)",
            place, colour[0], colour[1], colour[2], bank);
    return -1;
}

/* art_shade, which every pixel of every sprite goes through. */
static int shade_of(const struct art_picture *p, int x, int y, int bank, const uint8_t *rgb, bool nearest, char *err,
                    size_t err_size)
{
    const size_t at = (size_t)y * (size_t)p->w + (size_t)x;
    const uint8_t *colour = p->rgba + at * 4;
    int off, shade;

    if (colour[3] < 128)
        return 0;
    if (p->by_index)
        return index_fits(p->index[at], bank) ? p->index[at] % 16
                                              : refuse_index(p, x, y, p->index[at], bank, err, err_size);
    shade = nearest_shade(rgb + bank * 48, colour, &off);
    return off == 0 || nearest ? shade : refuse_colour(p, x, y, colour, bank, err, err_size);
}

int art_shade(const struct art_picture *p, int x, int y, int bank, const uint8_t *rgb, bool nearest, char *err,
              size_t err_size)
{
    return shade_of(p, x, y, bank, rgb, nearest, err, err_size);
}

bool art_make_font(const struct art_picture *p, const uint8_t rgb[CART_PALETTE_SIZE], bool nearest, uint8_t **out,
                   size_t *size, char *err, size_t err_size)
{
    if (p->w != 128 || p->h % 8 != 0 || p->h < 8 || p->h / 8 * 16 > CART_MAX_GLYPHS)
        return err_set(err, err_size, "%dx%d pixels, expected 128 wide and 8 to %d high: cells of 8x8, 16 per row",
                       p->w, p->h, CART_MAX_GLYPHS / 16 * 8);
    *size = (size_t)p->w * (size_t)p->h;
    *out = malloc(*size);
    if (*out == NULL)
        return result_set_host_error(err, err_size, "out of memory");
    for (int y = 0; y < p->h; y++) {
        for (int x = 0; x < p->w; x++) {
            int shade = shade_of(p, x, y, 0, rgb, nearest, err, err_size);
            if (shade < 0) {
                free(*out);
                *out = NULL;
                return false;
            }
            (*out)[(y / 8 * 16 + x / 8) * CART_GLYPH_SIZE + y % 8 * 8 + x % 8] = (uint8_t)shade;
        }
    }
    return true;
}

static int bank_with(const uint8_t *rgb, const uint8_t *colour)
{
    for (int bank = 0, off; bank < 16; bank++) {
        nearest_shade(rgb + bank * 48, colour, &off);
        if (off == 0)
            return bank;
    }
    return -1;
}

struct art_strays art_find_strays(const struct art_picture *picture, const uint8_t *marked, int bank,
                                  const uint8_t rgb[CART_PALETTE_SIZE])
{
    struct art_strays s = { .bank = -1, .index = -1, .fits = picture->index != NULL };

    for (size_t i = 0; i < (size_t)picture->w * (size_t)picture->h; i++) {
        const uint8_t *colour = picture->rgba + i * 4;
        int off = 0;
        if ((marked != NULL && !marked[i]) || colour[3] < 128)
            continue;
        s.fits = s.fits && index_fits(picture->index[i], bank);
        if (picture->by_index)
            off = !index_fits(picture->index[i], bank);
        else
            nearest_shade(rgb + bank * 48, colour, &off);
        if (off == 0 || s.n++ > 0)
            continue;
        s.index = picture->by_index ? picture->index[i] : -1;
        s.x = (int)(i % (size_t)picture->w);
        s.y = (int)(i / (size_t)picture->w);
        memcpy(s.c, colour, 3);
    }
    s.bank = s.n > 0 ? bank_with(rgb, s.c) : -1;
    return s;
}

struct art_faint art_find_faint(const struct art_picture *picture, const uint8_t *marked)
{
    struct art_faint f = { 0 };

    for (size_t i = 0; i < (size_t)picture->w * (size_t)picture->h; i++) {
        const uint8_t opacity = picture->rgba[i * 4 + 3];
        if ((marked != NULL && !marked[i]) || opacity == 0 || opacity >= 128 || f.n++ > 0)
            continue;
        f.x = (int)(i % (size_t)picture->w);
        f.y = (int)(i / (size_t)picture->w);
        f.percent = opacity * 100 / 255;
    }
    return f;
}

void art_faint_say(const struct art_picture *picture, const struct art_faint *f, char *out, size_t size)
{
    char place[ART_PLACE], count[48] = "";

    art_place(picture, f->x, f->y, place);
    if (f->n > 1)
        snprintf(count, sizeof count, "; %ld such pixels in total", f->n);
    snprintf(out, size, "%s: %d %% opaque; pixels below 50 %% become transparent%s", place, f->percent, count);
}

/* Pictures of w x h on end, without padding: picture = frame * rotations + rotation. */
struct stack {
    uint8_t *pix;
    int w, h, n;
    int px, py; /* the point turned about, half pixels: the anchor's */
};

static size_t stack_bytes(const struct stack *s)
{
    return (size_t)s->w * (size_t)s->h * (size_t)s->n;
}

static uint8_t *stack_picture(const struct stack *s, int i)
{
    return s->pix + (size_t)s->w * (size_t)s->h * (size_t)i;
}

/* The sprite's frames, as indices. */
static bool cut_frames(struct stack *s, const struct art_picture *sheet, const struct art_sprite *sprite, int bank,
                       const uint8_t *rgb, bool nearest, char *err, size_t err_size)
{
    for (int y = 0; y < s->h; y++) {
        for (int x = 0; x < s->w * s->n; x++) {
            int shade = shade_of(sheet, sprite->x + x, sprite->y + y, bank, rgb, nearest, err, err_size);
            if (shade < 0)
                return false;
            stack_picture(s, x / s->w)[y * s->w + x % s->w] = shade == 0 ? 0 : (uint8_t)(bank * 16 + shade);
        }
    }
    return true;
}

/* The point a sprite is turned about, in half pixels, for its anchor: the exact middle for the middle one, else the
 * pixel's. */
static int pivot(int anchor, int side)
{
    return anchor == side / 2 ? side : 2 * anchor + 1;
}

static bool make_stack(struct stack *s, int w, int h, int n, char *err, size_t err_size)
{
    *s = (struct stack){ .w = w, .h = h, .n = n };
    if ((uint64_t)w * (uint64_t)h * (uint64_t)n > MAX_STACK)
        return err_set(err, err_size, "its frames and rotations take more than %d MiB", MAX_STACK >> 20);
    s->pix = calloc(1, stack_bytes(s));
    return s->pix != NULL ? true : result_set_host_error(err, err_size, "out of memory");
}

/* The size that holds all turns of all frames. */
static void turned_size(const struct stack *s, int *w, int *h)
{
    *w = *h = 0;
    for (int i = 0; i < s->n; i++) {
        int one_w, one_h;
        turn_size(stack_picture(s, i), s->w, s->h, s->w, s->px, s->py, &one_w, &one_h);
        *w = one_w > *w ? one_w : *w;
        *h = one_h > *h ? one_h : *h;
    }
}

/* All turns of all frames of s. */
static void turn_stack(struct stack *turned, const struct stack *s, int rotations, void *scratch)
{
    struct turn t;

    for (int i = 0; i < turned->n; i++) {
        ang turn = (ang)(((uint64_t)(i % rotations) << 32) / (uint64_t)rotations);
        if (i % rotations == 0)
            turn_init(&t, stack_picture(s, i / rotations), s->w, s->h, s->w, s->px, s->py, scratch);
        turn_paint(&t, turn, stack_picture(turned, i), turned->w, turned->h, turned->w);
    }
}

/* Replaces the frames by all turns of each. */
static bool turn_frames(struct stack *s, int rotations, char *err, size_t err_size)
{
    struct stack t;
    int w, h;

    turned_size(s, &w, &h);
    if (w > CART_MAX_SIDE || h > CART_MAX_SIDE)
        return err_set(err, err_size, "%dx%d pixels when rotated, expected at most %d in each direction", w, h,
                       CART_MAX_SIDE);
    void *scratch = malloc(turn_scratch_size(s->w, s->h));
    if (scratch == NULL)
        return result_set_host_error(err, err_size, "out of memory");
    if (!make_stack(&t, w, h, s->n * rotations, err, err_size)) {
        free(scratch);
        return false;
    }
    turn_stack(&t, s, rotations, scratch);
    free(scratch);
    t.px = w;
    t.py = h;
    free(s->pix);
    *s = t;
    return true;
}

int art_resized(int side, int percent)
{
    int to = (side * percent + 50) / 100;

    return to < 1 ? 1 : to;
}

/* The pixel in which a point of the sheet's picture, the middle of pixel v, comes to lie. */
static int resized_at(int v, int percent)
{
    int64_t to = (2 * (int64_t)v + 1) * percent;

    return (int)(to / 200 - (to % 200 < 0));
}

/* Replaces the frames by copies of another size, turned about (ox, oy). */
static bool resize_frames(struct stack *s, int percent, int ox, int oy, char *err, size_t err_size)
{
    const int w = art_resized(s->w, percent), h = art_resized(s->h, percent);
    struct stack to;
    struct turn t;

    if (w > CART_MAX_SIDE || h > CART_MAX_SIDE)
        return err_set(err, err_size, "%dx%d pixels at %d percent, expected at most %d in each direction", w, h,
                       percent, CART_MAX_SIDE);
    void *scratch = malloc(turn_scratch_size(s->w, s->h));
    if (scratch == NULL)
        return result_set_host_error(err, err_size, "out of memory");
    if (!make_stack(&to, w, h, s->n, err, err_size)) {
        free(scratch);
        return false;
    }
    for (int i = 0; i < s->n; i++) {
        turn_init(&t, stack_picture(s, i), s->w, s->h, s->w, s->px, s->py, scratch);
        resize_paint(&t, stack_picture(&to, i), w, h);
    }
    free(scratch);
    to.px = pivot(ox, w);
    to.py = pivot(oy, h);
    free(s->pix);
    *s = to;
    return true;
}

struct box {
    int x0, y0, x1, y1; /* half open */
};

/* The pixels that are drawn in any picture; one pixel when there is none. */
static struct box used_box(const struct stack *s)
{
    struct box b = { s->w, s->h, 0, 0 };

    for (size_t i = 0; i < stack_bytes(s); i++) {
        int x = (int)(i % (size_t)s->w), y = (int)(i / (size_t)s->w % (size_t)s->h);
        if (s->pix[i] == 0)
            continue;
        b.x0 = x < b.x0 ? x : b.x0;
        b.y0 = y < b.y0 ? y : b.y0;
        b.x1 = x >= b.x1 ? x + 1 : b.x1;
        b.y1 = y >= b.y1 ? y + 1 : b.y1;
    }
    return b.x0 < b.x1 ? b : (struct box){ 0, 0, 1, 1 };
}

static void write_header(uint8_t *p, const struct art_sprite *sprite, struct box b, int pitch, int ox, int oy, int bank)
{
    memset(p, 0, CART_GFX_HEADER_SIZE);
    bytes_put16(p, (uint16_t)(b.x1 - b.x0));
    bytes_put16(p + 2, (uint16_t)(b.y1 - b.y0));
    bytes_put16(p + 4, (uint16_t)pitch);
    bytes_put16(p + 6, (uint16_t)(ox - b.x0));
    bytes_put16(p + 8, (uint16_t)(oy - b.y0));
    bytes_put16(p + 10, (uint16_t)sprite->frames);
    bytes_put16(p + 12, (uint16_t)sprite->frame_ticks);
    bytes_put16(p + 14, (uint16_t)sprite->rotations);
    bytes_put16(p + 16, (uint16_t)bank);
}

/* The lump: the header, then the box of each picture, its rows padded to a multiple of 8. */
static bool write_lump(const struct stack *s, const struct art_sprite *sprite, struct box b, int ox, int oy, int bank,
                       uint8_t **out, size_t *size)
{
    int w = b.x1 - b.x0, h = b.y1 - b.y0, pitch = (w + 7) / 8 * 8;

    *size = CART_GFX_HEADER_SIZE + (size_t)pitch * (size_t)h * (size_t)s->n;
    *out = calloc(1, *size);
    if (*out == NULL)
        return false;
    write_header(*out, sprite, b, pitch, ox, oy, bank);
    uint8_t *row = *out + CART_GFX_HEADER_SIZE;
    for (int i = 0; i < s->n; i++)
        for (int y = b.y0; y < b.y1; y++, row += pitch)
            memcpy(row, stack_picture(s, i) + y * s->w + b.x0, (size_t)w);
    return true;
}

bool art_make_sprite(const struct art_picture *sheet, const struct art_sprite *sprite, int bank,
                     const uint8_t rgb[CART_PALETTE_SIZE], bool nearest, uint8_t **out, size_t *size, bool *pixel,
                     char *err, size_t err_size)
{
    if (pixel)
        *pixel = false;
    int ox = sprite->ox, oy = sprite->oy;
    struct stack s;

    if (sprite->x + (int64_t)sprite->w * sprite->frames > sheet->w || sprite->y + sprite->h > sheet->h)
        return err_set(err, err_size, "%d frames of %dx%d at %d,%d do not fit in the sheet of %dx%d pixels",
                       (int)sprite->frames, (int)sprite->w, (int)sprite->h, (int)sprite->x, (int)sprite->y, sheet->w,
                       sheet->h);
    if (!make_stack(&s, sprite->w, sprite->h, sprite->frames, err, err_size))
        return false;
    s.px = pivot(sprite->ox, sprite->w);
    s.py = pivot(sprite->oy, sprite->h);
    bool good = cut_frames(&s, sheet, sprite, bank, rgb, nearest, err, err_size);
    if (pixel)
        *pixel = !good;
    if (good && sprite->scale_percent != 100) {
        ox = resized_at(ox, sprite->scale_percent);
        oy = resized_at(oy, sprite->scale_percent);
        if (!sprite->has_origin) {
            ox = art_resized(sprite->w, sprite->scale_percent) / 2;
            oy = art_resized(sprite->h, sprite->scale_percent) / 2;
        }
        good = resize_frames(&s, sprite->scale_percent, ox, oy, err, err_size);
    }
    struct box box = { 0, 0, s.w, s.h };
    if (good && sprite->rotations > 1) {
        good = turn_frames(&s, sprite->rotations, err, err_size);
        box = used_box(&s);
        ox = s.px / 2;
        oy = s.py / 2;
    }
    if (good && !write_lump(&s, sprite, box, ox, oy, bank, out, size))
        good = result_set_host_error(err, err_size, "out of memory");
    free(s.pix);
    return good;
}
