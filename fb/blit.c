/*
 * blit.c - see blit.h. Eight pixels at a time, or two times eight: a row of the picture is copied into 64-bit words,
 * the mask is made from the bytes that are zero, the whole word is recoloured, and the result is written back. No step
 * moves bits from one byte to another, so the byte order of the host does not matter. Bytes written back outside the
 * sprite are those that were read.
 *
 * A word may hang over the sprite's edge by up to 7 pixels: fb.h's band and slack are there for it.
 */
#include "blit.h"
#include "../src/base/trig.h"
#include "words.h"
#include <assert.h>
#include <stdbool.h>
#include <string.h>

static inline uint64_t reverse(uint64_t v)
{
    v = (v & 0x00ff00ff00ff00ffu) << 8 | (v >> 8 & 0x00ff00ff00ff00ffu);
    v = (v & 0x0000ffff0000ffffu) << 16 | (v >> 16 & 0x0000ffff0000ffffu);
    return v << 32 | v >> 32;
}

static inline void cover(uint8_t *d, uint64_t s, uint64_t add)
{
    uint64_t mask = opaque(s);

    store(d, (load(d) & ~mask) | (add_bytes(s, add) & mask));
}

/* Sixteen pixels at once, in a form that compilers turn into vector instructions of the plainest kind: a select by
 * mask, no branch, a constant count. */
static inline void cover_pair(uint8_t *restrict d, const uint8_t *restrict s, uint8_t add)
{
    for (int k = 0; k < 16; k++) {
        uint8_t mask = (uint8_t)(0 - (s[k] != 0)), colour = (uint8_t)(s[k] + add);
        d[k] = (uint8_t)(d[k] ^ ((d[k] ^ colour) & mask));
    }
}

enum { TURNED = 1024 }; /* bytes */

/* What is to be drawn: words of source rows, and where they go. Flipped, words go from right to left. */
struct job {
    uint8_t *d;
    const uint8_t *s;
    ptrdiff_t d_row, s_row; /* bytes from a row to the next */
    int words, rows;
    uint64_t first, last; /* the bytes of a row's first and last word that are drawn: 255, else 0 */
    uint64_t add;
};

/* Whole words of one row. */
static inline void paint_row(uint8_t *d, const uint8_t *s, int words, uint64_t add)
{
    for (; words > 1; words -= 2, s += 16, d += 16)
        cover_pair(d, s, (uint8_t)add);
    if (words > 0)
        cover(d, load(s), add);
}

/* Whole words; words a row is a constant in the calls that matter. Here and below all of a job is copied first: for all
 * a compiler knows, what is drawn lies over it. */
static inline void paint_rows(const struct job *j, int words)
{
    const uint8_t *s = j->s;
    uint8_t *d = j->d;
    ptrdiff_t s_row = j->s_row, d_row = j->d_row;
    uint64_t add = j->add;

    for (int y = j->rows; y > 0; y--, s += s_row, d += d_row)
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
    ptrdiff_t s_row = j->s_row, d_row = j->d_row;
    uint64_t add = j->add;
    int words = j->words;

    for (int y = j->rows; y > 0; y--, s += s_row, d += d_row) {
        const uint8_t *from = s;
        uint8_t *to = d;
        for (int k = words; k > 0; k--, from += 8, to -= 8)
            cover(to, reverse(load(from)), add);
    }
}

/* Long rows are turned round first, several before the first is painted: processors are slow at loading sixteen bytes
 * that have just been stored as two words. */
static void paint_turned(const struct job *j)
{
    uint8_t turned[TURNED];
    int row = 8 * j->words, most = TURNED / row;
    const uint8_t *s = j->s;
    struct job t = *j;

    t.s = turned;
    t.s_row = row;
    t.d -= row - 8;
    for (int left = j->rows; left > 0; left -= t.rows, t.d += t.rows * t.d_row) {
        t.rows = left < most ? left : most;
        for (int y = 0; y < t.rows; y++, s += j->s_row)
            for (int k = 0; k < row; k += 8)
                store(turned + y * row + row - 8 - k, reverse(load(s + k)));
        paint(&t);
    }
}

static void paint_flipped(const struct job *j)
{
    if (j->words > 4 && j->words <= TURNED / 8)
        paint_turned(j);
    else
        paint_flipped_words(j);
}

/* Word k of every row, of which `mask` is drawn. */
static void paint_column(const struct job *j, int k, uint64_t mask, bool flip)
{
    const uint8_t *s = j->s + 8 * k;
    uint8_t *d = flip ? j->d - 8 * k : j->d + 8 * k;
    ptrdiff_t s_row = j->s_row, d_row = j->d_row;
    uint64_t add = j->add;

    for (int y = j->rows; y > 0; y--, s += s_row, d += d_row)
        cover(d, flip ? reverse(load(s) & mask) : load(s) & mask, add);
}

/* As above with the first and last word of a row cut. */
static void paint_cut(struct job *j, bool flip)
{
    if (j->words == 1) {
        paint_column(j, 0, j->first & j->last, flip);
        return;
    }
    paint_column(j, 0, j->first, flip);
    paint_column(j, j->words - 1, j->last, flip);
    j->words -= 2;
    j->s += 8;
    j->d += flip ? -8 : 8;
    if (flip)
        paint_flipped(j);
    else
        paint(j);
}

/* 255 in bytes [from, 8) of a word, in the order of memory; and in [0, to). */
static const uint8_t edge[24] = { 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255 };

static uint64_t bytes_from(int from)
{
    return load(edge + 8 - from);
}

static uint64_t bytes_to(int to)
{
    return load(edge + 16 - to);
}

/* The part of an image inside the clip. */
struct part {
    int from, to; /* columns of the image */
    int rows;
    const uint8_t *s; /* the first of these rows, from its column 0 */
    ptrdiff_t s_row;
    int64_t at; /* where the whole row would begin, from fb->pix */
};

/* False: nothing is inside. */
static bool visible_part(struct part *p, const struct fb *fb, const struct image *image, int64_t x, int64_t y,
                         unsigned flags)
{
    int64_t left = fb->x0 > x ? fb->x0 - x : 0, top = fb->y0 > y ? fb->y0 - y : 0; /* columns, rows of the sprite */
    int64_t right = fb->x1 - x < image->w ? fb->x1 - x : image->w;
    int64_t bottom = fb->y1 - y < image->h ? fb->y1 - y : image->h;
    bool flip_x = flags & BLIT_FLIP_X, flip_y = flags & BLIT_FLIP_Y;

    if (left >= right || top >= bottom)
        return false;
    p->from = (int)(flip_x ? image->w - right : left);
    p->to = (int)(flip_x ? image->w - left : right);
    p->rows = (int)(bottom - top);
    p->s = image->pix + (flip_y ? image->h - 1 - top : top) * image->pitch;
    p->s_row = flip_y ? -image->pitch : image->pitch;
    p->at = (y + top) * fb->pitch + x;
    return true;
}

static void blit_clipped(struct fb *fb, const struct image *image, int64_t x, int64_t y, uint8_t bank, unsigned flags)
{
    bool flip = flags & BLIT_FLIP_X;
    struct part p;

    if (!visible_part(&p, fb, image, x, y, flags))
        return;
    int word = p.from / 8, last = (p.to - 1) / 8;
    struct job j = {
        .d = fb->pix + p.at + (flip ? image->w - 8 - 8 * word : 8 * word),
        .s = p.s + 8 * word,
        .d_row = fb->pitch,
        .s_row = p.s_row,
        .words = last - word + 1,
        .rows = p.rows,
        .first = bytes_from(p.from - 8 * word),
        .last = bytes_to(p.to - 8 * last),
        .add = BYTES((uint8_t)(bank * 16)),
    };
    paint_cut(&j, flip);
}

static bool is_safe(const struct fb *fb, const struct image *image, int x, int y)
{
    return x >= fb->sx0 && x <= fb->sx1 - image->w && y >= fb->sy0 && y <= fb->sy1 - image->h;
}

/* One opaque pixel through a blend's table. */
static inline void mix(uint8_t *d, uint8_t colour, const uint8_t *table)
{
    *d = table[(size_t)*d << 8 | colour];
}

/* The opaque ones of eight. Written out: gcc leaves a loop as it is. */
static inline void mix_word(uint8_t *d, const uint8_t *s, uint8_t add, const uint8_t *table)
{
    if (opaque(load(s)) == ~(uint64_t)0) {
        mix(d, (uint8_t)(s[0] + add), table);
        mix(d + 1, (uint8_t)(s[1] + add), table);
        mix(d + 2, (uint8_t)(s[2] + add), table);
        mix(d + 3, (uint8_t)(s[3] + add), table);
        mix(d + 4, (uint8_t)(s[4] + add), table);
        mix(d + 5, (uint8_t)(s[5] + add), table);
        mix(d + 6, (uint8_t)(s[6] + add), table);
        mix(d + 7, (uint8_t)(s[7] + add), table);
        return;
    }
    if (s[0])
        mix(d, (uint8_t)(s[0] + add), table);
    if (s[1])
        mix(d + 1, (uint8_t)(s[1] + add), table);
    if (s[2])
        mix(d + 2, (uint8_t)(s[2] + add), table);
    if (s[3])
        mix(d + 3, (uint8_t)(s[3] + add), table);
    if (s[4])
        mix(d + 4, (uint8_t)(s[4] + add), table);
    if (s[5])
        mix(d + 5, (uint8_t)(s[5] + add), table);
    if (s[6])
        mix(d + 6, (uint8_t)(s[6] + add), table);
    if (s[7])
        mix(d + 7, (uint8_t)(s[7] + add), table);
}

/* n pixels of a row. */
static inline void mix_row(uint8_t *d, const uint8_t *s, int n, uint8_t add, const uint8_t *table)
{
    for (; n >= 8; n -= 8, s += 8, d += 8)
        if (load(s) != 0)
            mix_word(d, s, add, table);
    for (; n > 0; n--, s++, d++)
        if (*s)
            mix(d, (uint8_t)(*s + add), table);
}

/* The same from right to left: d is where the first goes. */
static inline void mix_row_flipped(uint8_t *d, const uint8_t *s, int n, uint8_t add, const uint8_t *table)
{
    for (; n >= 8; n -= 8, s += 8, d -= 8) {
        if (load(s) == 0)
            continue;
        for (int k = 0; k < 8; k++)
            if (s[k])
                mix(d - k, (uint8_t)(s[k] + add), table);
    }
    for (; n > 0; n--, s++, d--)
        if (*s)
            mix(d, (uint8_t)(*s + add), table);
}

void blit_blended(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags,
                  const uint8_t table[65536])
{
    bool flip = flags & BLIT_FLIP_X;
    uint8_t add = (uint8_t)(bank * 16);
    struct part p;

    if (!visible_part(&p, fb, image, x, y, flags))
        return;
    uint8_t *d = fb->pix + p.at + (flip ? image->w - 1 - p.from : p.from);
    const uint8_t *s = p.s + p.from;
    ptrdiff_t d_row = fb->pitch;
    int n = p.to - p.from;
    for (int row = p.rows; row > 0; row--, d += d_row, s += p.s_row)
        if (flip)
            mix_row_flipped(d, s, n, add, table);
        else
            mix_row(d, s, n, add, table);
}

/* All of an image. */
static inline struct job whole_job(const struct fb *fb, const struct image *image, int x, int y, uint8_t bank,
                                   unsigned flags)
{
    ptrdiff_t last = flags & BLIT_FLIP_Y ? (ptrdiff_t)(image->h - 1) * image->pitch : 0;

    return (struct job){
        .d = fb->pix + y * fb->pitch + x,
        .s = image->pix + last,
        .d_row = fb->pitch,
        .s_row = flags & BLIT_FLIP_Y ? -image->pitch : image->pitch,
        .words = (image->w + 7) / 8,
        .rows = image->h,
        .add = BYTES((uint8_t)(bank * 16)),
    };
}

static void blit_flipped(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags)
{
    struct job j = whole_job(fb, image, x + image->w - 8, y, bank, flags);

    paint_flipped(&j);
}

void blit_sprite(struct fb *fb, const struct image *image, int x, int y, uint8_t bank, unsigned flags)
{
    if (!is_safe(fb, image, x, y))
        blit_clipped(fb, image, x, y, bank, flags);
    else if (flags & BLIT_FLIP_X)
        blit_flipped(fb, image, x, y, bank, flags);
    else {
        struct job j = whole_job(fb, image, x, y, bank, flags);
        paint(&j);
    }
}

/* From the point to the farthest corner of pixel (x, y), squared, in half pixels. */
static int64_t reach_of(int64_t x, int64_t y, int64_t ox, int64_t oy)
{
    int64_t dx = 2 * x + 1 - ox, dy = 2 * y + 1 - oy; /* to the pixel's middle; its far corner is one more each way */

    dx = (dx < 0 ? -dx : dx) + 1;
    dy = (dy < 0 ? -dy : dy) + 1;
    return dx * dx + dy * dy;
}

void blit_rotated_size(const uint8_t *in, int w, int h, int pitch, int ox, int oy, int *out_w, int *out_h)
{
    int64_t far = 1, side = 1;

    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            if (in[(ptrdiff_t)y * pitch + x] != 0 && reach_of(x, y, ox, oy) > far)
                far = reach_of(x, y, ox, oy);
    while (side * side < far)
        side++;
    *out_w = (int)(side + ((side ^ ox) & 1));
    *out_h = (int)(side + ((side ^ oy) & 1));
}

/*
 * Turning. Each pixel of the result asks SAMPLES x SAMPLES points of its square what colour they have in the image,
 * made smoother by Scale2x (Andrea Mazzoleni, 2001) applied twice, and the majority decides: first whether it is
 * opaque, then the colour. A pixel at the rim of the result then votes again among points at the rim of the image, so
 * that a bullet's outline stays closed. Chosen by eye among seven ways, on 12 px rice, arrow and knife bullets in 32
 * directions.
 */
enum { SAMPLES = 8, ALL = SAMPLES * SAMPLES };

struct turned {
    const uint8_t *in;
    int w, h, pitch;
    int64_t cos30, sin30;
    int ox, oy;
    int out_w, out_h;
};

static int pixel(const struct turned *t, int x, int y)
{
    return x < 0 || y < 0 || x >= t->w || y >= t->h ? 0 : t->in[(ptrdiff_t)y * t->pitch + x];
}

/* Scale2x: a corner of pixel e takes the colour of the two neighbours it touches, if these agree and their opposites do
 * not join them. dx, dy: which corner, -1 or 1. */
static int corner(int e, int beside, int above, int opposite, int below)
{
    return beside == above && above != opposite && beside != below ? beside : e;
}

static int pixel2(const struct turned *t, int x, int y)
{
    int px = x >> 1, py = y >> 1, dx = x & 1 ? 1 : -1, dy = y & 1 ? 1 : -1;

    return corner(pixel(t, px, py), pixel(t, px + dx, py), pixel(t, px, py + dy), pixel(t, px - dx, py),
                  pixel(t, px, py - dy));
}

static int pixel4(const struct turned *t, int x, int y)
{
    int px = x >> 1, py = y >> 1, dx = x & 1 ? 1 : -1, dy = y & 1 ? 1 : -1;

    return corner(pixel2(t, px, py), pixel2(t, px + dx, py), pixel2(t, px, py + dy), pixel2(t, px - dx, py),
                  pixel2(t, px, py - dy));
}

/* Opaque, with a transparent neighbour. */
static bool is_rim(const struct turned *t, int x, int y)
{
    return pixel(t, x, y) != 0 &&
           (pixel(t, x - 1, y) == 0 || pixel(t, x + 1, y) == 0 || pixel(t, x, y - 1) == 0 || pixel(t, x, y + 1) == 0);
}

/* Where point (i, j) of pixel (x, y) lies in the image, in quarter pixels. Points are 1/8 px apart, counted in 1/16. */
static void locate(const struct turned *t, int x, int y, int i, int j, int *qx, int *qy)
{
    int64_t u = 16 * x + 2 * i + 1 - 8 * t->out_w, v = 16 * y + 2 * j + 1 - 8 * t->out_h;

    *qx = (int)((t->cos30 * u + t->sin30 * v) >> 32) + 2 * t->ox;
    *qy = (int)((t->cos30 * v - t->sin30 * u) >> 32) + 2 * t->oy;
}

/* True: the image has one colour as far round the middle of pixel (x, y) as its points can see. */
static bool is_flat(const struct turned *t, int x, int y, int *colour)
{
    int qx, qy;

    locate(t, x, y, SAMPLES / 2, SAMPLES / 2, &qx, &qy);
    *colour = pixel(t, qx >> 2, qy >> 2);
    for (int dy = -2; dy <= 2; dy++)
        for (int dx = -2; dx <= 2; dx++)
            if (pixel(t, (qx >> 2) + dx, (qy >> 2) + dy) != *colour)
                return false;
    return true;
}

/* The opaque colour with the most votes, the lowest of equals; 0 without votes. */
static uint8_t winner(const uint8_t votes[256])
{
    int best = 0;

    for (int c = 1; c < 256; c++)
        if (votes[c] > (best ? votes[best] : 0))
            best = c;
    return (uint8_t)best;
}

static uint8_t vote(const struct turned *t, int x, int y, bool rim)
{
    uint8_t votes[256] = { 0 };
    int qx, qy;

    for (int j = 0; j < SAMPLES; j++)
        for (int i = 0; i < SAMPLES; i++) {
            locate(t, x, y, i, j, &qx, &qy);
            if (!rim || pixel(t, qx >> 2, qy >> 2) == 0 || is_rim(t, qx >> 2, qy >> 2))
                votes[pixel4(t, qx, qy)]++;
        }
    return !rim && votes[0] > ALL / 2 ? 0 : winner(votes);
}

static uint8_t turned_pixel(const struct turned *t, int x, int y)
{
    int colour;

    return is_flat(t, x, y, &colour) ? (uint8_t)colour : vote(t, x, y, false);
}

/* Quarter turns map middles of pixels to middles, or all of them to edges, of which the lower pixel is then taken. */
static uint8_t quarter_pixel(const struct turned *t, int x, int y)
{
    int64_t u = 2 * x + 1 - t->out_w, v = 2 * y + 1 - t->out_h;
    int hx = (int)((t->cos30 * u + t->sin30 * v) >> 30) + t->ox,
        hy = (int)((t->cos30 * v - t->sin30 * u) >> 30) + t->oy;

    return (uint8_t)pixel(t, hx >> 1, hy >> 1);
}

void blit_rotate(uint8_t *out, int out_w, int out_h, int out_pitch, const uint8_t *in, int w, int h, int pitch,
                 ang turn, int ox, int oy)
{
    struct turned t = { in, w, h, pitch, trig_cos30(turn), trig_sin30(turn), ox, oy, out_w, out_h };
    struct turned result = { .in = out, .w = out_w, .h = out_h, .pitch = out_pitch };
    bool quarter = (turn & 0x3fffffff) == 0;

    assert(out_w <= FB_MAX && out_h <= FB_MAX && w <= FB_MAX && h <= FB_MAX); /* so that locate fits 64 bits */
    for (int y = 0; y < out_h; y++)
        for (int x = 0; x < out_w; x++)
            out[(ptrdiff_t)y * out_pitch + x] = quarter ? quarter_pixel(&t, x, y) : turned_pixel(&t, x, y);
    for (int y = 0; y < out_h && !quarter; y++)
        for (int x = 0; x < out_w; x++) {
            uint8_t colour = is_rim(&result, x, y) ? vote(&t, x, y, true) : 0; /* no pixel becomes transparent here */
            if (colour != 0)
                out[(ptrdiff_t)y * out_pitch + x] = colour;
        }
}
