/*
 * scale.c - see scale.h.
 *
 * An enlarged pixel is looked up in the doubled image, where Scale2x's rule is applied a second time to the corner of
 * the pixel that the centre of the enlarged pixel falls into. So enlarging four times equals Scale2x twice, and lower
 * factors sample that picture. The centre of a pixel of the image keeps its colour, so a factor of 1 is a copy.
 *
 * If either side shrinks, each pixel covers an area of the image and, as in resize.c, the majority of that area
 * decides: first whether the pixel is opaque (half suffices), then its colour (the first in reading order if areas are
 * equal).
 */
#include "scale.h"
#include <assert.h>
#include <stdbool.h>
#include <string.h>

static int get_pixel(const uint8_t *pix, int w, int h, ptrdiff_t pitch, int x, int y)
{
    return x < 0 || y < 0 || x >= w || y >= h ? 0 : pix[y * pitch + x];
}

/* Scale2x: a corner of pixel e takes the colour of the two neighbours next to the corner, if they agree and differ from
 * the neighbours opposite them. */
static inline uint8_t corner(int e, int side, int above, int opposite, int below)
{
    return (uint8_t)(side == above && above != opposite && side != below ? side : e);
}

void scale_double(uint8_t *out, int out_pitch, const uint8_t *pix, int w, int h, int pitch)
{
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++) {
            int e = pix[(ptrdiff_t)y * pitch + x];
            int left = get_pixel(pix, w, h, pitch, x - 1, y), right = get_pixel(pix, w, h, pitch, x + 1, y);
            int above = get_pixel(pix, w, h, pitch, x, y - 1), below = get_pixel(pix, w, h, pitch, x, y + 1);
            uint8_t *d = out + 2 * (ptrdiff_t)y * out_pitch + 2 * x;
            d[0] = corner(e, left, above, right, below);
            d[1] = corner(e, right, above, left, below);
            d[out_pitch] = corner(e, left, below, right, above);
            d[out_pitch + 1] = corner(e, right, below, left, above);
        }
}

/* The doubled image has a border of one transparent pixel. */
size_t scale_scratch_size(int w, int h)
{
    return (2 * (size_t)w + 2) * (2 * (size_t)h + 2);
}

/* The centre of pixel i of n along one axis, at (2 i + 1) / 2 n of `length` doubled pixels: in the doubled pixel `at`,
 * rest / 2 n of a pixel from its start. It is the centre of a pixel of the image if rest is 0 and `at` is odd. */
struct place {
    int at, rest;
};

static inline bool is_centre(struct place p)
{
    return p.rest == 0 && p.at % 2;
}

/* Returns to which side of the doubled pixel's centre a place is: -1, 0 or 1. */
static inline int side_of(struct place p, int n)
{
    return p.rest < n ? -1 : p.rest > n;
}

/* Moves a place to that of the next pixel. */
static inline void step(struct place *p, int n, int length)
{
    for (p->rest += 2 * length; p->rest >= 2 * n; p->rest -= 2 * n)
        p->at++;
}

static inline struct place first_place(int n, int length)
{
    return (struct place){ length / (2 * n), length % (2 * n) };
}

/* Paints a row of w pixels. doubled: the row of the doubled image, of `length` pixels; vertical: the offset of the row
 * on the other side of which the enlarged row is; 0: none. */
static void enlarge_row(uint8_t *out, int w, const uint8_t *pix, const uint8_t *doubled, int length, ptrdiff_t vertical)
{
    struct place p = first_place(w, length);

    for (int x = 0; x < w; x++, step(&p, w, length)) {
        const uint8_t *at = doubled + p.at;
        const int side = side_of(p, w);
        out[x] = is_centre(p)       ? pix[p.at / 2]
                 : side && vertical ? corner(at[0], at[side], at[vertical], at[-side], at[-vertical])
                                    : at[0];
    }
}

/* Paints a row whose pixels' centres are those of pixels of the image on the vertical axis. */
static void copy_row(uint8_t *out, int w, const uint8_t *pix, int length)
{
    struct place p = first_place(w, length);

    for (int x = 0; x < w; x++, step(&p, w, length))
        out[x] = pix[p.at / 2];
}

static void enlarge(const struct image *in, uint8_t *out, int w, int h, int pitch, uint8_t *scratch)
{
    const int double_pitch = 2 * in->w + 2;

    memset(scratch, 0, scale_scratch_size(in->w, in->h));
    scale_double(scratch + double_pitch + 1, double_pitch, in->pix, in->w, in->h, in->pitch);
    struct place p = first_place(h, 2 * in->h);
    for (int y = 0; y < h; y++, step(&p, h, 2 * in->h)) {
        const uint8_t *pix = in->pix + (ptrdiff_t)(p.at / 2) * in->pitch,
                      *doubled = scratch + (ptrdiff_t)(p.at + 1) * double_pitch + 1;
        if (is_centre(p))
            copy_row(out + (ptrdiff_t)y * pitch, w, pix, 2 * in->w);
        else
            enlarge_row(out + (ptrdiff_t)y * pitch, w, pix, doubled, 2 * in->w,
                        side_of(p, h) * (ptrdiff_t)double_pitch);
    }
}

/* Returns the length that the k-th of n equal parts and the i-th of m equal parts of a length n * m have in common. */
static int64_t overlap(int k, int n, int i, int m)
{
    int64_t from = (int64_t)k * m, to = from + m, a = (int64_t)i * n, z = a + n;

    from = from > a ? from : a;
    to = to < z ? to : z;
    return to > from ? to - from : 0;
}

enum { MAX_SPAN = 7 /* most pixels of the image that a reduced pixel touches along an axis */ };

/* The areas of the colours in a reduced pixel, in the order in which they were found. */
struct votes {
    int n;
    uint8_t colour[MAX_SPAN * MAX_SPAN];
    int64_t area[MAX_SPAN * MAX_SPAN];
};

static void add_vote(struct votes *v, uint8_t colour, int64_t area)
{
    int i = 0;

    while (i < v->n && v->colour[i] != colour)
        i++;
    if (i == v->n) {
        v->colour[v->n] = colour;
        v->area[v->n++] = 0;
    }
    v->area[i] += area;
}

static uint8_t elect(const struct votes *v)
{
    int64_t opaque = 0, clear = 0, most = 0;
    uint8_t best = 0;

    for (int i = 0; i < v->n; i++) {
        if (!v->colour[i]) {
            clear = v->area[i];
            continue;
        }
        opaque += v->area[i];
        best = v->area[i] > most ? v->colour[i] : best;
        most = v->area[i] > most ? v->area[i] : most;
    }
    return opaque >= clear ? best : 0;
}

static uint8_t reduced_pixel(const struct image *in, int x, int y, int w, int h)
{
    const int x0 = (int)((int64_t)x * in->w / w), y0 = (int)((int64_t)y * in->h / h);
    struct votes votes;

    votes.n = 0;
    for (int v = y0; v < in->h; v++) {
        const int64_t rows = overlap(v, in->h, y, h);
        if (!rows)
            break;
        for (int u = x0; u < in->w; u++) {
            const int64_t columns = overlap(u, in->w, x, w);
            if (!columns)
                break;
            add_vote(&votes, in->pix[(ptrdiff_t)v * in->pitch + u], rows * columns);
        }
    }
    return elect(&votes);
}

void scale_paint(const struct image *in, uint8_t *out, int w, int h, int pitch, void *scratch)
{
    assert(w >= 1 && h >= 1 && 5 * (int64_t)w >= in->w && 5 * (int64_t)h >= in->h);
    for (int y = 0; y < h; y++)
        memset(out + (ptrdiff_t)y * pitch + w, 0, (size_t)(pitch - w));
    if (w >= in->w && h >= in->h) {
        enlarge(in, out, w, h, pitch, scratch);
        return;
    }
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            out[(ptrdiff_t)y * pitch + x] = reduced_pixel(in, x, y, w, h);
}
