/*
 * blit.c - see blit.h. Processes eight or sixteen pixels at a time: loads part of a row of the picture into a 64-bit
 * word, makes the mask from the bytes that are zero, recolours the whole word, and writes the result back. No step
 * moves bits from one byte to another, so the byte order of the host does not matter. Bytes written back outside the
 * sprite are unchanged.
 *
 * A word may extend past the sprite's edge by up to 7 pixels: the band and slack of fb.h exist for that.
 */
#include "blit.h"
#include "paint.h"
#include <string.h>

static inline uint64_t reverse_bytes(uint64_t v)
{
    v = (v & 0x00ff00ff00ff00ffu) << 8 | (v >> 8 & 0x00ff00ff00ff00ffu);
    v = (v & 0x0000ffff0000ffffu) << 16 | (v >> 16 & 0x0000ffff0000ffffu);
    return v << 32 | v >> 32;
}

enum { REVERSED_BYTES = 1024 }; /* bytes of the buffer for reversed rows */

/* A drawing job: words of source rows, and their destination. In a flipped job, words are written from right to
 * left. */
struct job {
    uint8_t *d;
    const uint8_t *s;
    ptrdiff_t d_stride, s_stride; /* bytes from one row to the next */
    int words, rows;
    uint64_t first_mask, last_mask; /* masks for a row's first and last word: 255 for drawn bytes, otherwise 0 */
    uint64_t add;
};

/* Paints whole words of one row. */
static inline void paint_row(uint8_t *d, const uint8_t *s, int words, uint64_t add)
{
    for (; words > 1; words -= 2, s += 16, d += 16)
        paint_sixteen_opaque(d, s, (uint8_t)add);
    if (words > 0)
        paint_word(d, words_load(s), add);
}

/* Paints whole words of every row; `words` is a constant in the calls that matter. Here and in similar functions the
 * job is first copied into locals: the pixels might alias the job, so the compiler would have to reload it after each
 * store. */
static inline void paint_rows(const struct job *j, int words)
{
    const uint8_t *s = j->s;
    uint8_t *d = j->d;
    ptrdiff_t s_stride = j->s_stride, d_stride = j->d_stride;
    uint64_t add = j->add;

    for (int y = j->rows; y > 0; y--, s += s_stride, d += d_stride)
        paint_row(d, s, words, add);
}

static inline void paint(const struct job *j)
{
    if (j->words == 1)
        paint_rows(j, 1);
    else if (j->words == 2)
        paint_rows(j, 2);
    else
        paint_rows(j, j->words);
}

static inline void paint_flipped_words(const struct job *j)
{
    const uint8_t *s = j->s;
    uint8_t *d = j->d;
    ptrdiff_t s_stride = j->s_stride, d_stride = j->d_stride;
    uint64_t add = j->add;
    int words = j->words;

    for (int y = j->rows; y > 0; y--, s += s_stride, d += d_stride) {
        const uint8_t *from = s;
        uint8_t *to = d;
        for (int k = words; k > 0; k--, from += 8, to -= 8)
            paint_word(to, reverse_bytes(words_load(from)), add);
    }
}

/* Paints long flipped rows. Reverses several rows before painting the first of them, because processors are slow to
 * load sixteen bytes that have just been stored as two words. */
static void paint_reversed(const struct job *j)
{
    uint8_t reversed[REVERSED_BYTES];
    int row_bytes = 8 * j->words, max_rows = REVERSED_BYTES / row_bytes;
    const uint8_t *s = j->s;
    struct job t = *j;

    t.s = reversed;
    t.s_stride = row_bytes;
    t.d -= row_bytes - 8;
    for (int rows_left = j->rows; rows_left > 0; rows_left -= t.rows, t.d += t.rows * t.d_stride) {
        t.rows = rows_left < max_rows ? rows_left : max_rows;
        for (int y = 0; y < t.rows; y++, s += j->s_stride)
            for (int k = 0; k < row_bytes; k += 8)
                words_store(reversed + y * row_bytes + row_bytes - 8 - k, reverse_bytes(words_load(s + k)));
        paint(&t);
    }
}

static void paint_flipped(const struct job *j)
{
    if (j->words > 4 && j->words <= REVERSED_BYTES / 8)
        paint_reversed(j);
    else
        paint_flipped_words(j);
}

/* In every row, paints the pixels of word k that `mask` selects. */
static void paint_column(const struct job *j, int k, uint64_t mask, bool flip)
{
    const uint8_t *s = j->s + 8 * k;
    uint8_t *d = flip ? j->d - 8 * k : j->d + 8 * k;
    ptrdiff_t s_stride = j->s_stride, d_stride = j->d_stride;
    uint64_t add = j->add;

    for (int y = j->rows; y > 0; y--, s += s_stride, d += d_stride)
        paint_word(d, flip ? reverse_bytes(words_load(s) & mask) : words_load(s) & mask, add);
}

/* Paints every row with its first and last word masked. */
static void paint_masked(struct job *j, bool flip)
{
    if (j->words == 1) {
        paint_column(j, 0, j->first_mask & j->last_mask, flip);
        return;
    }
    paint_column(j, 0, j->first_mask, flip);
    paint_column(j, j->words - 1, j->last_mask, flip);
    j->words -= 2;
    j->s += 8;
    j->d += flip ? -8 : 8;
    if (flip)
        paint_flipped(j);
    else
        paint(j);
}

/* Source of masks that have 255 in bytes [from, 8) of a word, in memory order, or in bytes [0, to). */
static const uint8_t edge_masks[24] = { 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255 };

static uint64_t mask_from(int from)
{
    return words_load(edge_masks + 8 - from);
}

static uint64_t mask_to(int to)
{
    return words_load(edge_masks + 16 - to);
}

/* The part of an image inside the clip. */
struct visible_area {
    int first_column, end_column; /* columns of the image */
    int rows;
    const uint8_t *s; /* column 0 of the first visible row */
    ptrdiff_t s_stride;
    int64_t row_offset; /* offset from fb->pix at which the unclipped row would start */
};

/* Computes the visible part of an image. Returns false if nothing is inside the clip. */
static bool find_visible_area(struct visible_area *p, const struct fb *fb, const struct image *image, int64_t x,
                              int64_t y, unsigned flags)
{
    int64_t left = fb->x0 > x ? fb->x0 - x : 0, top = fb->y0 > y ? fb->y0 - y : 0; /* columns and rows of the sprite */
    int64_t right = fb->x1 - x < image->w ? fb->x1 - x : image->w;
    int64_t bottom = fb->y1 - y < image->h ? fb->y1 - y : image->h;
    bool flip_x = flags & BLIT_FLIP_X, flip_y = flags & BLIT_FLIP_Y;

    if (left >= right || top >= bottom)
        return false;
    p->first_column = (int)(flip_x ? image->w - right : left);
    p->end_column = (int)(flip_x ? image->w - left : right);
    p->rows = (int)(bottom - top);
    p->s = image->pix + (flip_y ? image->h - 1 - top : top) * image->pitch;
    p->s_stride = flip_y ? -image->pitch : image->pitch;
    p->row_offset = (y + top) * fb->pitch + x;
    return true;
}

static void blit_clipped(struct fb *fb, const struct image *image, int64_t x, int64_t y, uint8_t bank, unsigned flags)
{
    bool flip = flags & BLIT_FLIP_X;
    struct visible_area p;

    if (!find_visible_area(&p, fb, image, x, y, flags))
        return;
    int first_word = p.first_column / 8, last_word = (p.end_column - 1) / 8;
    struct job j = {
        .d = fb->pix + p.row_offset + (flip ? image->w - 8 - 8 * first_word : 8 * first_word),
        .s = p.s + 8 * first_word,
        .d_stride = fb->pitch,
        .s_stride = p.s_stride,
        .words = last_word - first_word + 1,
        .rows = p.rows,
        .first_mask = mask_from(p.first_column - 8 * first_word),
        .last_mask = mask_to(p.end_column - 8 * last_word),
        .add = WORDS_EACH((uint8_t)(bank * 16)),
    };
    paint_masked(&j, flip);
}

static bool is_in_safe_area(const struct fb *fb, const struct image *image, int x, int y)
{
    return x >= fb->sx0 && x <= fb->sx1 - image->w && y >= fb->sy0 && y <= fb->sy1 - image->h;
}

/* Draws one opaque pixel through a blend table. */
static inline void mix_pixel(uint8_t *d, uint8_t colour, const uint8_t *table)
{
    *d = table[(size_t)*d << 8 | colour];
}

/* Draws the opaque pixels among eight. Unrolled by hand, because gcc does not unroll the loop. */
static inline void mix_word(uint8_t *d, const uint8_t *s, uint8_t add, const uint8_t *table)
{
    if (words_opaque_mask(words_load(s)) == ~(uint64_t)0) {
        mix_pixel(d, (uint8_t)(s[0] + add), table);
        mix_pixel(d + 1, (uint8_t)(s[1] + add), table);
        mix_pixel(d + 2, (uint8_t)(s[2] + add), table);
        mix_pixel(d + 3, (uint8_t)(s[3] + add), table);
        mix_pixel(d + 4, (uint8_t)(s[4] + add), table);
        mix_pixel(d + 5, (uint8_t)(s[5] + add), table);
        mix_pixel(d + 6, (uint8_t)(s[6] + add), table);
        mix_pixel(d + 7, (uint8_t)(s[7] + add), table);
        return;
    }
    if (s[0])
        mix_pixel(d, (uint8_t)(s[0] + add), table);
    if (s[1])
        mix_pixel(d + 1, (uint8_t)(s[1] + add), table);
    if (s[2])
        mix_pixel(d + 2, (uint8_t)(s[2] + add), table);
    if (s[3])
        mix_pixel(d + 3, (uint8_t)(s[3] + add), table);
    if (s[4])
        mix_pixel(d + 4, (uint8_t)(s[4] + add), table);
    if (s[5])
        mix_pixel(d + 5, (uint8_t)(s[5] + add), table);
    if (s[6])
        mix_pixel(d + 6, (uint8_t)(s[6] + add), table);
    if (s[7])
        mix_pixel(d + 7, (uint8_t)(s[7] + add), table);
}

/* Draws n pixels of a row. */
static inline void mix_row(uint8_t *d, const uint8_t *s, int n, uint8_t add, const uint8_t *table)
{
    for (; n >= 8; n -= 8, s += 8, d += 8)
        if (words_load(s) != 0)
            mix_word(d, s, add, table);
    for (; n > 0; n--, s++, d++)
        if (*s)
            mix_pixel(d, (uint8_t)(*s + add), table);
}

/* Draws n pixels of a row from right to left: d is the destination of the first. */
static inline void mix_row_flipped(uint8_t *d, const uint8_t *s, int n, uint8_t add, const uint8_t *table)
{
    for (; n >= 8; n -= 8, s += 8, d -= 8) {
        if (words_load(s) == 0)
            continue;
        for (int k = 0; k < 8; k++)
            if (s[k])
                mix_pixel(d - k, (uint8_t)(s[k] + add), table);
    }
    for (; n > 0; n--, s++, d--)
        if (*s)
            mix_pixel(d, (uint8_t)(*s + add), table);
}

void blit_blended(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags,
                  const uint8_t table[65536])
{
    bool flip = flags & BLIT_FLIP_X;
    uint8_t add = (uint8_t)(bank * 16);
    struct visible_area p;

    if (!find_visible_area(&p, fb, image, x, y, flags))
        return;
    uint8_t *d = fb->pix + p.row_offset + (flip ? image->w - 1 - p.first_column : p.first_column);
    const uint8_t *s = p.s + p.first_column;
    ptrdiff_t d_stride = fb->pitch;
    int n = p.end_column - p.first_column;
    for (int row = p.rows; row > 0; row--, d += d_stride, s += p.s_stride)
        if (flip)
            mix_row_flipped(d, s, n, add, table);
        else
            mix_row(d, s, n, add, table);
}

void blit_solid(struct fb *fb, const struct image *image, int x, int y, uint8_t c, unsigned flags)
{
    const bool flip = flags & BLIT_FLIP_X, is_dotted = flags & BLIT_DOTS;
    struct visible_area p;

    if (!find_visible_area(&p, fb, image, x, y, flags))
        return;
    uint8_t *d = fb->pix + p.row_offset + (flip ? image->w - 1 - p.first_column : p.first_column);
    const uint8_t *s = p.s + p.first_column;
    const int64_t parity =
        (fb->y0 > y ? (int64_t)fb->y0 - y : 0) + p.first_column; /* parity within the image, so that the dots
                                                                            move with the image */
    for (int row = 0; row < p.rows; row++, d += fb->pitch, s += p.s_stride)
        for (int k = 0; k < p.end_column - p.first_column; k++)
            if (s[k] && !(is_dotted && (parity + row + k) & 1))
                d[flip ? -k : k] = c;
}

void blit_rim(struct fb *fb, const struct image *image, int x, int y, uint8_t c)
{
    for (int k = 0; k < 9; k++)
        blit_solid(fb, image, x + k % 3 - 1, y + k / 3 - 1, c, 0);
}

/* Returns the job that draws a whole image without clipping. */
static inline struct job make_unclipped_job(const struct fb *fb, const struct image *image, int x, int y, uint8_t bank,
                                            unsigned flags)
{
    ptrdiff_t first_row = flags & BLIT_FLIP_Y ? (ptrdiff_t)(image->h - 1) * image->pitch : 0;

    return (struct job){
        .d = fb->pix + y * fb->pitch + x,
        .s = image->pix + first_row,
        .d_stride = fb->pitch,
        .s_stride = flags & BLIT_FLIP_Y ? -image->pitch : image->pitch,
        .words = (image->w + 7) / 8,
        .rows = image->h,
        .add = WORDS_EACH((uint8_t)(bank * 16)),
    };
}

static inline uint8_t bank_offset(const struct blit_item *item)
{
    return (uint8_t)(item->bank * 16);
}

__attribute__((always_inline)) static inline void draw_narrow_items(const struct blit_item *items, size_t n,
                                                                    ptrdiff_t d_stride, int h, enum blit_mix mix)
{
    for (size_t i = 0; i < n; i++)
        paint_narrow(items[i].d, d_stride, items[i].s, bank_offset(&items[i]), h, mix);
}

__attribute__((always_inline)) static inline void draw_wide_items(const struct blit_item *items, size_t n,
                                                                  ptrdiff_t d_stride, int h, enum blit_mix mix)
{
    for (size_t i = 0; i < n; i++)
        paint_wide(items[i].d, d_stride, items[i].s, bank_offset(&items[i]), h, mix);
}

/* Draws one image of any width by a rule. */
__attribute__((always_inline)) static inline void mix_rows(const struct job *j, enum blit_mix rule)
{
    const uint8_t *s = j->s;
    uint8_t *d = j->d;

    for (int y = j->rows; y > 0; y--, s += j->s_stride, d += j->d_stride) {
        int k = 0;
        for (; k + 1 < j->words; k += 2)
            paint_sixteen(d + 8 * k, s + 8 * k, (uint8_t)j->add, rule);
        if (k < j->words)
            paint_eight(d + 8 * k, s + 8 * k, (uint8_t)j->add, rule);
    }
}

static void mix_job(const struct job *j, enum blit_mix rule)
{
    if (rule == BLIT_RAMP_ADD)
        mix_rows(j, BLIT_RAMP_ADD);
    else if (rule == BLIT_RAMP_HALF)
        mix_rows(j, BLIT_RAMP_HALF);
    else
        mix_rows(j, BLIT_RAMP_MAX);
}

/* Draws items of any size, one by one. */
static void draw_other_items(const struct blit_item *items, size_t n, struct job j, enum blit_mix mix)
{
    for (size_t i = 0; i < n; i++) {
        j.s = items[i].s;
        j.d = items[i].d;
        j.add = WORDS_EACH((uint8_t)(items[i].bank * 16));
        if (mix == BLIT_OPAQUE)
            paint(&j);
        else
            mix_job(&j, mix);
    }
}

/* Draws items of at most 16 px width. The usual heights are passed as constants, as mix is by the callers, so that the
 * compiler specializes the loops. */
__attribute__((always_inline)) static inline void
draw_specialised_items(const struct blit_item *items, size_t n, ptrdiff_t d_stride, int h, bool wide, enum blit_mix mix)
{
    if (!wide && h == 8)
        draw_narrow_items(items, n, d_stride, 8, mix);
    else if (!wide)
        draw_narrow_items(items, n, d_stride, h, mix);
    else if (h == 16)
        draw_wide_items(items, n, d_stride, 16, mix);
    else if (h == 12)
        draw_wide_items(items, n, d_stride, 12, mix);
    else
        draw_wide_items(items, n, d_stride, h, mix);
}

void blit_batch(const struct blit_item *items, size_t n, int d_pitch, int w, int h, int s_pitch, enum blit_mix mix)
{
    const bool wide = s_pitch == 16 && w > 8, is_specialised = s_pitch == 8 || wide;

    if (is_specialised && mix == BLIT_OPAQUE)
        draw_specialised_items(items, n, d_pitch, h, wide, BLIT_OPAQUE);
    else if (is_specialised && mix == BLIT_RAMP_ADD)
        draw_specialised_items(items, n, d_pitch, h, wide, BLIT_RAMP_ADD);
    else
        draw_other_items(
            items, n, (struct job){ .d_stride = d_pitch, .s_stride = s_pitch, .words = (w + 7) / 8, .rows = h }, mix);
}

bool blit_ramped(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags,
                 enum blit_mix rule)
{
    if (!is_in_safe_area(fb, image, x, y) || flags & BLIT_FLIP_X)
        return false;
    const struct job j = make_unclipped_job(fb, image, x, y, bank, flags);
    mix_job(&j, rule);
    return true;
}

static void blit_flipped(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags)
{
    struct job j = make_unclipped_job(fb, image, x + image->w - 8, y, bank, flags);

    paint_flipped(&j);
}

void blit_sprite(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags)
{
    if (!is_in_safe_area(fb, image, x, y))
        blit_clipped(fb, image, x, y, bank, flags);
    else if (flags & BLIT_FLIP_X)
        blit_flipped(fb, image, x, y, bank, flags);
    else {
        struct job j = make_unclipped_job(fb, image, x, y, bank, flags);
        paint(&j);
    }
}
