/*
 * art.c - see art.h. A sprite is made in two steps: its frames and their rotated copies are drawn into a stack of cells
 * of equal size; then the rectangle that all of them need is copied from each cell into the lump. A sprite without
 * rotations keeps its size.
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

enum { MAX_STACK = 64 << 20 /* bytes of a sprite's cells */ };

/* Returns a channel (0 to 2) of a saturated colour; hues are 0 to 1535, 256 for each sixth of the colour wheel. */
static int hue_channel(int hue, int channel)
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
            int full = bank == 0 ? 255 : hue_channel((bank - 1) * 1536 / 15, c);
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

/* Returns the squared distance of two colours. */
static int squared_distance(const uint8_t *a, const uint8_t *b)
{
    int sum = 0;

    for (int c = 0; c < 3; c++)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

/* Returns the shade, 1 to 15, that is nearest to the colour, the lowest of equals. colours: the bank's 48 bytes. *off:
 * the squared distance. */
static int nearest_shade(const uint8_t *colours, const uint8_t *colour, int *off)
{
    int best = 1;

    *off = squared_distance(colours + 3, colour);
    for (int shade = 2; shade < 16 && *off > 0; shade++) {
        int d = squared_distance(colours + shade * 3, colour);
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

static bool index_in_bank(int index, int bank)
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

static int find_shade(const struct art_picture *p, int x, int y, int bank, const uint8_t *rgb, bool nearest, char *err,
                      size_t err_size)
{
    const size_t at = (size_t)y * (size_t)p->w + (size_t)x;
    const uint8_t *colour = p->rgba + at * 4;
    int off, shade;

    if (colour[3] < 128)
        return 0;
    if (p->by_index)
        return index_in_bank(p->index[at], bank) ? p->index[at] % 16
                                                 : refuse_index(p, x, y, p->index[at], bank, err, err_size);
    shade = nearest_shade(rgb + bank * 48, colour, &off);
    return off == 0 || nearest ? shade : refuse_colour(p, x, y, colour, bank, err, err_size);
}

int art_shade(const struct art_picture *p, int x, int y, int bank, const uint8_t *rgb, bool nearest, char *err,
              size_t err_size)
{
    return find_shade(p, x, y, bank, rgb, nearest, err, err_size);
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
            int shade = find_shade(p, x, y, 0, rgb, nearest, err, err_size);
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

static int find_bank(const uint8_t *rgb, const uint8_t *colour)
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
    struct art_strays s = { .bank = -1, .index = -1, .indices_fit = picture->index != NULL };

    for (size_t i = 0; i < (size_t)picture->w * (size_t)picture->h; i++) {
        const uint8_t *colour = picture->rgba + i * 4;
        int off = 0;
        if ((marked != NULL && !marked[i]) || colour[3] < 128)
            continue;
        s.indices_fit = s.indices_fit && index_in_bank(picture->index[i], bank);
        if (picture->by_index)
            off = !index_in_bank(picture->index[i], bank);
        else
            nearest_shade(rgb + bank * 48, colour, &off);
        if (off == 0 || s.n++ > 0)
            continue;
        s.index = picture->by_index ? picture->index[i] : -1;
        s.x = (int)(i % (size_t)picture->w);
        s.y = (int)(i / (size_t)picture->w);
        memcpy(s.c, colour, 3);
    }
    s.bank = s.n > 0 ? find_bank(rgb, s.c) : -1;
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

void art_faint_describe(const struct art_picture *picture, const struct art_faint *f, char *out, size_t size)
{
    char place[ART_PLACE], count[48] = "";

    art_place(picture, f->x, f->y, place);
    if (f->n > 1)
        snprintf(count, sizeof count, "; %ld such pixels in total", f->n);
    snprintf(out, size, "%s: %d %% opaque; pixels below 50 %% become transparent%s", place, f->percent, count);
}

/* Cells of w x h pixels, without padding: cell = frame * rotations + rotation. */
struct stack {
    uint8_t *pix;
    int w, h, n;
    int px, py; /* centre of rotation, half pixels */
};

static size_t stack_bytes(const struct stack *s)
{
    return (size_t)s->w * (size_t)s->h * (size_t)s->n;
}

static uint8_t *stack_cell(const struct stack *s, int i)
{
    return s->pix + (size_t)s->w * (size_t)s->h * (size_t)i;
}

/* Copies the sprite's frames from the sheet as palette indices. */
static bool cut_frames(struct stack *s, const struct art_picture *sheet, const struct art_sprite *sprite, int bank,
                       const uint8_t *rgb, bool nearest, char *err, size_t err_size)
{
    for (int y = 0; y < s->h; y++) {
        for (int x = 0; x < s->w * s->n; x++) {
            int shade = find_shade(sheet, sprite->x + x, sprite->y + y, bank, rgb, nearest, err, err_size);
            if (shade < 0)
                return false;
            stack_cell(s, x / s->w)[y * s->w + x % s->w] = shade == 0 ? 0 : (uint8_t)(bank * 16 + shade);
        }
    }
    return true;
}

/* Returns the centre of rotation in half pixels: the exact centre if the origin is the middle pixel, otherwise the
 * middle of the origin's pixel. */
static int pivot(int origin, int side)
{
    return origin == side / 2 ? side : 2 * origin + 1;
}

static bool make_stack(struct stack *s, int w, int h, int n, char *err, size_t err_size)
{
    *s = (struct stack){ .w = w, .h = h, .n = n };
    if ((uint64_t)w * (uint64_t)h * (uint64_t)n > MAX_STACK)
        return err_set(err, err_size, "its frames and rotations take more than %d MiB", MAX_STACK >> 20);
    s->pix = calloc(1, stack_bytes(s));
    return s->pix != NULL ? true : result_set_host_error(err, err_size, "out of memory");
}

/* Computes the size that fits every rotation of every frame. */
static void rotated_size(const struct stack *s, int *w, int *h)
{
    *w = *h = 0;
    for (int i = 0; i < s->n; i++) {
        int one_w, one_h;
        turn_size(stack_cell(s, i), s->w, s->h, s->w, s->px, s->py, &one_w, &one_h);
        *w = one_w > *w ? one_w : *w;
        *h = one_h > *h ? one_h : *h;
    }
}

/* Draws every rotation of every frame of s. */
static void rotate_stack(struct stack *to, const struct stack *s, int rotations, void *scratch)
{
    struct turn t;

    for (int i = 0; i < to->n; i++) {
        ang turn = (ang)(((uint64_t)(i % rotations) << 32) / (uint64_t)rotations);
        if (i % rotations == 0)
            turn_init(&t, stack_cell(s, i / rotations), s->w, s->h, s->w, s->px, s->py, scratch);
        turn_paint(&t, turn, stack_cell(to, i), to->w, to->h, to->w);
    }
}

/* Replaces each frame by all its rotations. */
static bool rotate_frames(struct stack *s, int rotations, char *err, size_t err_size)
{
    struct stack t;
    int w, h;

    rotated_size(s, &w, &h);
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
    rotate_stack(&t, s, rotations, scratch);
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

/* Returns the pixel that contains the middle of pixel v after scaling. */
static int resized_position(int v, int percent)
{
    int64_t to = (2 * (int64_t)v + 1) * percent;

    return (int)(to / 200 - (to % 200 < 0));
}

/* Replaces the frames by scaled copies with the origin (ox, oy). */
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
        turn_init(&t, stack_cell(s, i), s->w, s->h, s->w, s->px, s->py, scratch);
        resize_paint(&t, stack_cell(&to, i), w, h);
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

/* Returns the bounding box of the opaque pixels of all cells; one pixel if there are none. */
static struct box bounding_box(const struct stack *s)
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

/* Writes the header, then the box of each cell, with rows padded to a multiple of 8. */
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
            memcpy(row, stack_cell(s, i) + y * s->w + b.x0, (size_t)w);
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
        ox = resized_position(ox, sprite->scale_percent);
        oy = resized_position(oy, sprite->scale_percent);
        if (!sprite->has_origin) {
            ox = art_resized(sprite->w, sprite->scale_percent) / 2;
            oy = art_resized(sprite->h, sprite->scale_percent) / 2;
        }
        good = resize_frames(&s, sprite->scale_percent, ox, oy, err, err_size);
    }
    struct box box = { 0, 0, s.w, s.h };
    if (good && sprite->rotations > 1) {
        good = rotate_frames(&s, sprite->rotations, err, err_size);
        box = bounding_box(&s);
        ox = s.px / 2;
        oy = s.py / 2;
    }
    if (good && !write_lump(&s, sprite, box, ox, oy, bank, out, size))
        good = result_set_host_error(err, err_size, "out of memory");
    free(s.pix);
    return good;
}
