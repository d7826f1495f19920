/*
 * stamp.c - see stamp.h.
 *
 * A word that is drawn over is (what was there & keep) | colour. In a layer it is what was there | (colour where that
 * is 0): a picture drawn later is the one below. Eight rows of one word each, which most bullets are, have a loop of
 * their own.
 */
#include "stamp.h"
#include <assert.h>
#include <string.h>
#include "words.h"

static uint64_t bank_bytes(unsigned bank)
{
    return BYTES((uint8_t)(bank * 16));
}

/* The word of a picture's row that begins at pixel x. */
static uint64_t word_at(const struct image *image, int x, int y)
{
    const uint8_t *p = image->pix + (ptrdiff_t)y * image->pitch + x;
    uint8_t b[8] = { 0 };

    if (x + 8 <= image->pitch)
        return load(p);
    memcpy(b, p, (size_t)(image->pitch - x));
    return load(b);
}

static bool add_word(struct stamp *stamp, ptrdiff_t at, uint64_t s)
{
    if (stamp->n == STAMP_WORDS)
        return false;
    stamp->at[stamp->n] = (int32_t)at;
    stamp->keep[stamp->n] = ~opaque(s);
    stamp->colour[stamp->n++] = s; /* for the moment */
    return true;
}

static bool find_words(struct stamp *stamp, const struct fb *fb, const struct image *image)
{
    for (int y = 0; y < image->h; y++) {
        ptrdiff_t at = (ptrdiff_t)y * fb->pitch;
        if (image->w <= 8) {
            if (!add_word(stamp, at, word_at(image, 0, y)))
                return false;
            continue;
        }
        for (int x = 0; x < image->w; x++)
            if (image->pix[(ptrdiff_t)y * image->pitch + x]) {
                if (!add_word(stamp, at + x, word_at(image, x, y)))
                    return false;
                x += 7;
            }
    }
    return true;
}

bool stamp_make(struct stamp *stamp, const struct fb *fb, const struct image *image, unsigned banks)
{
    uint64_t words[STAMP_WORDS];

    stamp->n = 0;
    stamp->w = image->w;
    stamp->h = image->h;
    stamp->rows = image->w <= 8;
    if (!find_words(stamp, fb, image))
        return false;
    memcpy(words, stamp->colour, (size_t)stamp->n * sizeof *words);
    for (unsigned bank = 0; bank < 16; bank++)
        for (int k = 0; k < stamp->n && banks >> bank & 1; k++)
            stamp->colour[(int)bank * stamp->n + k] = add_bytes(words[k], bank_bytes(bank)) & ~stamp->keep[k];
    return true;
}

static inline void over(uint8_t *d, uint64_t keep, uint64_t colour)
{
    store(d, (load(d) & keep) | colour);
}

static inline void under(uint8_t *d, uint64_t keep, uint64_t colour)
{
    uint64_t s = load(d);

    (void)keep;
    store(d, s | (colour & ~opaque(s)));
}

/* The first byte of a surface's band. */
static uint8_t *origin(const struct fb *fb)
{
    return fb->pix - (ptrdiff_t)FB_GUARD * fb->pitch - FB_GUARD;
}

struct stamp_corners stamp_corners(const struct fb *fb, int w, int h)
{
    int wide = fb->sx1 - fb->sx0 - w + 1, high = fb->sy1 - fb->sy0 - h + 1;
    bool some = wide > 0 && high > 0;

    return (struct stamp_corners){ fb->sx0, fb->sy0, some ? (uint32_t)wide : 0, some ? (uint32_t)high : 0 };
}

/* The two ways through a stamp's words: eight rows of one word each, which most bullets are, and any words. */
#define EIGHT_ROWS(way, d, pitch, keep, colour)                                                                        \
    do {                                                                                                               \
        way(d, keep[0], colour[0]), d += pitch;                                                                        \
        way(d, keep[1], colour[1]), d += pitch;                                                                        \
        way(d, keep[2], colour[2]), d += pitch;                                                                        \
        way(d, keep[3], colour[3]), d += pitch;                                                                        \
        way(d, keep[4], colour[4]), d += pitch;                                                                        \
        way(d, keep[5], colour[5]), d += pitch;                                                                        \
        way(d, keep[6], colour[6]), d += pitch;                                                                        \
        way(d, keep[7], colour[7]);                                                                                    \
    } while (0)

#define ANY_WORDS(way, d, stamp, c)                                                                                    \
    do {                                                                                                               \
        int w_ = 0;                                                                                                    \
        for (; w_ + 4 <= (stamp)->n; w_ += 4) {                                                                        \
            way(d + (stamp)->at[w_], (stamp)->keep[w_], c[w_]);                                                        \
            way(d + (stamp)->at[w_ + 1], (stamp)->keep[w_ + 1], c[w_ + 1]);                                            \
            way(d + (stamp)->at[w_ + 2], (stamp)->keep[w_ + 2], c[w_ + 2]);                                            \
            way(d + (stamp)->at[w_ + 3], (stamp)->keep[w_ + 3], c[w_ + 3]);                                            \
        }                                                                                                              \
        for (; w_ < (stamp)->n; w_++)                                                                                  \
            way(d + (stamp)->at[w_], (stamp)->keep[w_], c[w_]);                                                        \
    } while (0)

/* `eight` is a constant in its calls. */
static inline size_t draw_over(const struct fb *fb, const struct stamp *stamp, const uint32_t *places, size_t n,
                               bool eight)
{
    const ptrdiff_t pitch = fb->pitch;
    uint8_t *first = fb->pix + fb->sy0 * pitch + fb->sx0;

    for (size_t i = 0; i < n; i++) {
        uint32_t place = places[i];
        if (place & STAMP_OTHER)
            return i;
        uint8_t *d = first + (place & (STAMP_OTHER - 1));
        const uint64_t *colour = stamp->colour + (size_t)(place >> 28) * (size_t)(eight ? 8 : stamp->n);
        if (eight)
            EIGHT_ROWS(over, d, pitch, stamp->keep, colour);
        else
            ANY_WORDS(over, d, stamp, colour);
    }
    return n;
}

size_t stamp_over(struct fb *fb, const struct stamp *stamp, const uint32_t *places, size_t n)
{
    if (stamp->rows && stamp->n == 8)
        return draw_over(fb, stamp, places, n, true);
    return draw_over(fb, stamp, places, n, false);
}

/* ---- layers ---- */

/* Pixels of a layer that are drawn, on the average, before the map is worth drawing up: so many, then so many more. */
enum { FIRST_COATS = 4, MORE_COATS = 3 };

static size_t words_of(const struct fb *fb)
{
    return (size_t)(fb->pitch / 8) * (size_t)(fb->h + 2 * FB_GUARD);
}

size_t layer_size(int w, int h)
{
    size_t size = fb_size(w, h);

    return size + size / 8 + 8;
}

void layer_init(struct layer *l, void *mem, int w, int h)
{
    fb_init(&l->fb, mem, w, h);
    l->full = (uint8_t *)mem + fb_size(w, h);
    l->room = FIRST_COATS * (size_t)w * (size_t)h;
    l->step = MORE_COATS * (size_t)w * (size_t)h;
    l->covered = false;
    l->hidden = 0;
    memset(l->full, 0, words_of(&l->fb));
}

/* 255 in the bytes of a row's word `at` that are not in the picture. */
static uint64_t band_bytes(const struct fb *fb, int at)
{
    uint8_t b[8];

    for (int i = 0; i < 8; i++)
        b[i] = at * 8 + i < FB_GUARD || at * 8 + i >= FB_GUARD + fb->w ? 255 : 0;
    return load(b);
}

/* Is no byte of it 0? */
static inline bool is_full(uint64_t s)
{
    return !((s - BYTES(1)) & ~s & BYTES(0x80));
}

/* The map of a row of words, of which `below` is the map of the row under it. False: something is 0 still. */
static bool map_row(uint8_t *restrict full, const uint8_t *restrict below, const uint8_t *restrict row, int words,
                    const uint64_t *restrict band)
{
    unsigned all = 1;

    for (int i = 0; i < words; i++) {
        unsigned is = is_full(load(row + 8 * i) | band[i]);
        full[i] = (uint8_t)((below[i] + (unsigned)(below[i] < 255)) & (0u - is));
        all &= is;
    }
    return all;
}

/* Nobody sees the band: it counts as drawn. */
void layer_map(struct layer *l)
{
    const struct fb *fb = &l->fb;
    int words = fb->pitch / 8, y = fb->h + FB_GUARD;
    uint64_t band[(FB_MAX + 2 * FB_GUARD) / 8];

    for (int i = 0; i < words; i++)
        band[i] = band_bytes(fb, i);
    memset(l->full + (ptrdiff_t)y * words, 255, (size_t)(FB_GUARD * words));
    l->covered = true;
    while (y-- > FB_GUARD) {
        uint8_t *full = l->full + (ptrdiff_t)y * words;
        l->covered &=
            map_row(full, full + words, fb->pix + (ptrdiff_t)(y - FB_GUARD) * fb->pitch - FB_GUARD, words, band);
    }
    for (; y >= 0; y--)
        for (int i = 0; i < words; i++) {
            uint8_t below = l->full[(ptrdiff_t)(y + 1) * words + i];
            l->full[(ptrdiff_t)y * words + i] = (uint8_t)(below + (below < 255));
        }
    l->room = l->step;
}

static void used(struct layer *l, size_t pixels)
{
    if (l->room > pixels)
        l->room -= pixels;
    else
        layer_map(l);
}

static inline void draw_under(struct layer *l, const struct stamp *stamp, const uint32_t *places, size_t n,
                              size_t pixels, bool eight)
{
    const ptrdiff_t pitch = l->fb.pitch;
    uint8_t *first = origin(&l->fb);

    while (n > 0 && !l->covered) {
        uint32_t place = places[--n], at = place & (STAMP_OTHER - 1);
        if (layer_hides(l, at, (uint32_t)stamp->w, (uint32_t)stamp->h)) {
            l->hidden++;
            continue;
        }
        uint8_t *d = first + at;
        const uint64_t *colour = stamp->colour + (size_t)(place >> 28) * (size_t)(eight ? 8 : stamp->n);
        if (eight)
            EIGHT_ROWS(under, d, pitch, stamp->keep, colour);
        else
            ANY_WORDS(under, d, stamp, colour);
        used(l, pixels);
    }
    l->hidden += n;
}

void layer_stamp(struct layer *l, const struct stamp *stamp, const uint32_t *places, size_t n, size_t pixels)
{
    if (stamp->rows && stamp->n == 8)
        draw_under(l, stamp, places, n, pixels, true);
    else
        draw_under(l, stamp, places, n, pixels, false);
}

static void cells_across(int w, int h, uint32_t *across, uint32_t *down)
{
    *across = (uint32_t)(w + 2 * FB_GUARD + 7) / 8;
    *down = (uint32_t)(h + 2 * FB_GUARD + 7) / 8;
}

size_t layer_cells_size(int w, int h)
{
    uint32_t across, down;

    cells_across(w, h, &across, &down);
    return (size_t)across * down + 1;
}

/* Is all covered in [x0, x1) x [y0, y1), counted from the band's first byte? What lies outside nobody sees. */
static bool all_covered(const struct layer *l, int x0, int y0, int x1, int y1)
{
    int words = l->fb.pitch / 8, rows = l->fb.h + 2 * FB_GUARD;

    x0 = x0 < 0 ? 0 : x0;
    y0 = y0 < 0 ? 0 : y0;
    x1 = x1 > l->fb.pitch ? l->fb.pitch : x1;
    y1 = y1 > rows ? rows : y1;
    if (x0 >= x1 || y0 >= y1)
        return true;
    for (int i = x0 / 8; i <= (x1 - 1) / 8; i++)
        if (l->full[(ptrdiff_t)y0 * words + i] < y1 - y0)
            return false;
    return true;
}

void layer_find_cells(const struct layer *l, struct layer_cells *cells, uint8_t *seen, int x0, int y0, int x1, int y1)
{
    cells_across(l->fb.w, l->fb.h, &cells->across, &cells->down);
    cells->seen = seen;
    for (int v = 0; v < (int)cells->down; v++)
        for (int u = 0; u < (int)cells->across; u++)
            *seen++ = !all_covered(l, 8 * u + x0, 8 * v + y0, 8 * u + 7 + x1, 8 * v + 7 + y1);
    *seen = 1;
}

void layer_cells_at(const struct layer_cells *cells, const fx *restrict x, const fx *restrict y, uint32_t *restrict at)
{
    const uint32_t across = cells->across, none = across * cells->down, w = 8 * across, h = 8 * cells->down;

    for (int i = 0; i < 64; i++) {
        uint32_t px = (uint32_t)(x[i] >> 16) + FB_GUARD, py = (uint32_t)(y[i] >> 16) + FB_GUARD;
        uint32_t in = 0u - (uint32_t)((px < w) & (py < h));
        at[i] = (((py >> 3) * across + (px >> 3)) & in) | (none & ~in);
    }
}

void layer_sprite(struct layer *l, const struct image *image, uint32_t place, size_t pixels)
{
    uint64_t add = bank_bytes(place >> 28);
    uint8_t *first = origin(&l->fb) + (place & (STAMP_OTHER - 1));

    if (l->covered || layer_hides(l, place & (STAMP_OTHER - 1), (uint32_t)image->w, (uint32_t)image->h)) {
        l->hidden++;
        return;
    }
    for (int row = 0; row < image->h; row++) {
        const uint8_t *s = image->pix + (ptrdiff_t)row * image->pitch;
        uint8_t *d = first + (ptrdiff_t)row * l->fb.pitch;
        for (int k = 0; k < image->w; k += 8) {
            uint64_t v = load(s + k);
            under(d + k, 0, add_bytes(v, add) & opaque(v));
        }
    }
    used(l, pixels);
}

void layer_show(const struct layer *l, struct fb *fb, int x, int y)
{
    for (int row = 0; row < l->fb.h; row++) {
        const uint8_t *s = l->fb.pix + (ptrdiff_t)row * l->fb.pitch;
        uint8_t *d = fb->pix + (ptrdiff_t)(y + row) * fb->pitch + x;
        int k = 0;
        for (; k + 8 <= l->fb.w; k += 8) {
            uint64_t v = load(s + k);
            store(d + k, (load(d + k) & ~opaque(v)) | v);
        }
        for (; k < l->fb.w; k++)
            d[k] = s[k] ? s[k] : d[k];
    }
}
