/*
 * blit.c - see blit.h. Eight pixels at a time: a row of the picture is copied into 64-bit words, the mask is made from
 * the bytes that are zero, the whole word is recoloured, and the result is written back. No step moves bits from one
 * byte to another, so the byte order of the host does not matter. Bytes written back outside the sprite are those that
 * were read.
 *
 * A word may hang over the sprite's edge by up to 7 pixels: fb.h's band and slack are there for it.
 */
#include "blit.h"
#include <stdbool.h>
#include <string.h>

#define BYTES(b) ((uint64_t)(b)*0x0101010101010101u)

static inline uint64_t load(const uint8_t *p)
{
    uint64_t v;

    memcpy(&v, p, sizeof v);
    return v;
}

static inline void store(uint8_t *p, uint64_t v)
{
    memcpy(p, &v, sizeof v);
}

/* 255 in every byte that is not 0 in s. */
static inline uint64_t opaque(uint64_t s)
{
    uint64_t top = (((s & BYTES(0x7f)) + BYTES(0x7f)) | s) & BYTES(0x80);

    return top | (top - (top >> 7));
}

/* s + add in each byte, modulo 256. */
static inline uint64_t add_bytes(uint64_t s, uint64_t add)
{
    return ((s & BYTES(0x7f)) + (add & BYTES(0x7f))) ^ ((s ^ add) & BYTES(0x80));
}

static inline uint64_t reverse(uint64_t v)
{
    v = (v & 0x00ff00ff00ff00ffu) << 8 | (v >> 8 & 0x00ff00ff00ff00ffu);
    v = (v & 0x0000ffff0000ffffu) << 16 | (v >> 16 & 0x0000ffff0000ffffu);
    return v << 32 | v >> 32;
}

static inline void blend(uint8_t *d, uint64_t s, uint64_t add)
{
    uint64_t mask = opaque(s);

    store(d, (load(d) & ~mask) | (add_bytes(s, add) & mask));
}

/* What is to be drawn: words of source rows, and where they go. Flipped, words go from right to left. */
struct job {
    uint8_t *d;
    const uint8_t *s;
    ptrdiff_t d_row, s_row; /* bytes from a row to the next */
    int words, rows;
    uint64_t first, last; /* the bytes of a row's first and last word that are drawn: 255, else 0 */
    uint64_t add;
};

/* Whole words; words a row is a constant in the calls that matter. */
static inline void paint(const struct job *j, int words)
{
    const uint8_t *s = j->s;
    uint8_t *d = j->d;
    uint64_t add = j->add;

    for (int y = j->rows; y > 0; y--, s += j->s_row, d += j->d_row)
        for (int k = 0; k < words; k++)
            blend(d + 8 * k, load(s + 8 * k), add);
}

static void paint_flipped(const struct job *j)
{
    const uint8_t *s = j->s;
    uint8_t *d = j->d;

    for (int y = j->rows; y > 0; y--, s += j->s_row, d += j->d_row)
        for (int k = 0; k < j->words; k++)
            blend(d - 8 * k, reverse(load(s + 8 * k)), j->add);
}

/* As above with the first and last word of a row cut. */
static void paint_cut(const struct job *j, bool flip)
{
    for (int y = 0; y < j->rows; y++) {
        const uint8_t *s = j->s + y * j->s_row;
        uint8_t *d = j->d + y * j->d_row;
        for (int k = 0; k < j->words; k++) {
            uint64_t v = load(s + 8 * k);
            v &= k == 0 ? j->first : ~(uint64_t)0;
            v &= k == j->words - 1 ? j->last : ~(uint64_t)0;
            blend(flip ? d - 8 * k : d + 8 * k, flip ? reverse(v) : v, j->add);
        }
    }
}

/* 255 in bytes [from, to) of a word, in the order of memory. */
static uint64_t byte_range(int from, int to)
{
    uint8_t b[8];

    for (int i = 0; i < 8; i++)
        b[i] = i >= from && i < to ? 255 : 0;
    return load(b);
}

/* The part of an image inside the clip. */
static void blit_clipped(struct fb *fb, const struct image *image, int64_t x, int64_t y, uint8_t bank, unsigned flags)
{
    int64_t left = fb->x0 > x ? fb->x0 - x : 0, top = fb->y0 > y ? fb->y0 - y : 0; /* columns, rows of the sprite */
    int64_t right = fb->x1 - x < image->w ? fb->x1 - x : image->w;
    int64_t bottom = fb->y1 - y < image->h ? fb->y1 - y : image->h;
    bool flip_x = flags & BLIT_FLIP_X, flip_y = flags & BLIT_FLIP_Y;

    if (left >= right || top >= bottom)
        return;
    int from = (int)(flip_x ? image->w - right : left),
        to = (int)(flip_x ? image->w - left : right); /* of the source */
    int word = from / 8, last = (to - 1) / 8;
    int64_t row = flip_y ? image->h - 1 - top : top;
    int64_t column = flip_x ? image->w - 8 - 8 * word : 8 * word; /* of the sprite, where that word goes */
    struct job j = {
        .d = fb->pix + (y + top) * fb->pitch + (x + column),
        .s = image->pix + row * image->pitch + 8 * word,
        .d_row = fb->pitch,
        .s_row = flip_y ? -image->pitch : image->pitch,
        .words = last - word + 1,
        .rows = (int)(bottom - top),
        .first = byte_range(from - 8 * word, 8),
        .last = byte_range(0, to - 8 * last),
        .add = BYTES((uint8_t)(bank * 16)),
    };
    paint_cut(&j, flip_x);
}

static bool is_safe(const struct fb *fb, const struct image *image, int x, int y)
{
    return x >= fb->sx0 && x <= fb->sx1 - image->w && y >= fb->sy0 && y <= fb->sy1 - image->h;
}

void blit_sprite(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags)
{
    if (!is_safe(fb, image, x, y)) {
        blit_clipped(fb, image, x, y, bank, flags);
        return;
    }
    struct job j = {
        .d = fb->pix + y * fb->pitch + x,
        .s = image->pix,
        .d_row = fb->pitch,
        .s_row = image->pitch,
        .words = (image->w + 7) / 8,
        .rows = image->h,
        .add = BYTES((uint8_t)(bank * 16)),
    };
    if (flags & BLIT_FLIP_Y) {
        j.s += (ptrdiff_t)(image->h - 1) * image->pitch;
        j.s_row = -image->pitch;
    }
    if (flags & BLIT_FLIP_X) {
        j.d += image->w - 8;
        paint_flipped(&j);
    } else if (j.words == 1)
        paint(&j, 1);
    else if (j.words == 2)
        paint(&j, 2);
    else
        paint(&j, j.words);
}

/* An image made ready for many copies: its opaque pixels in as few words as cover them, wherever those begin. */
enum { BATCH_WORDS = 192, BATCH_MIN = 8 };
struct stamp {
    ptrdiff_t at[BATCH_WORDS]; /* from the sprite's top left corner, in the surface */
    uint64_t keep[BATCH_WORDS], colour[BATCH_WORDS];
    int n;
};

/* False: too many words. */
static bool stamp_make(struct stamp *stamp, const struct image *image, int fb_pitch, uint64_t add)
{
    stamp->n = 0;
    for (int y = 0; y < image->h; y++) {
        const uint8_t *row = image->pix + (ptrdiff_t)y * image->pitch;
        for (int x = 0; x < image->w; x++) {
            if (row[x] == 0)
                continue;
            if (stamp->n == BATCH_WORDS)
                return false;
            uint8_t b[8] = { 0 };
            memcpy(b, row + x, (size_t)(image->w - x < 8 ? image->w - x : 8));
            uint64_t s = load(b), mask = opaque(s);
            stamp->at[stamp->n] = (ptrdiff_t)y * fb_pitch + x;
            stamp->keep[stamp->n] = ~mask;
            stamp->colour[stamp->n++] = add_bytes(s, add) & mask;
            x += 7;
        }
    }
    return true;
}

void blit_batch(struct fb *fb, const struct image *image, const int32_t *xy, size_t n, uint8_t bank)
{
    struct stamp stamp;

    if (n < BATCH_MIN || !stamp_make(&stamp, image, fb->pitch, BYTES((uint8_t)(bank * 16)))) {
        for (size_t i = 0; i < n; i++)
            blit_sprite(fb, image, xy[2 * i], xy[2 * i + 1], bank, 0);
        return;
    }
    int words = stamp.n;
    for (size_t i = 0; i < n; i++) {
        int32_t x = xy[2 * i], y = xy[2 * i + 1];
        if (!is_safe(fb, image, x, y)) {
            blit_clipped(fb, image, x, y, bank, 0);
            continue;
        }
        uint8_t *d = fb->pix + y * fb->pitch + x;
        for (int k = 0; k < words; k++)
            store(d + stamp.at[k], (load(d + stamp.at[k]) & stamp.keep[k]) | stamp.colour[k]);
    }
}
