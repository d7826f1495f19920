/*
 * stamp.c - see stamp.h.
 *
 * On the surface, pictures are painted over the existing pixels (paint.h). In a layer, a picture fills only the bytes
 * that are still 0, so a picture drawn later ends up underneath. A word may extend past the picture's edge by up to 7
 * pixels, which are 0: the band and slack of fb.h exist for that. Common sizes have specialised loops.
 */
#include "stamp.h"
#include <assert.h>
#include <string.h>
#include "paint.h"

static uint64_t bank_offsets(unsigned bank)
{
    return WORDS_EACH((uint8_t)(bank * 16));
}

bool stamp_make(struct stamp *stamp, const struct image *image, unsigned banks)
{
    stamp->w = image->w;
    stamp->h = image->h;
    stamp->pitch = (image->w + 7) / 8 * 8;
    if ((int64_t)stamp->pitch * image->h > STAMP_MAX_BYTES)
        return false;
    stamp->bytes = stamp->pitch * image->h;
    for (int at = 0, y = 0; y < image->h; y++)
        for (int x = 0; x < stamp->pitch; x += 8, at += 8) {
            uint64_t s = words_load(image->pix + (ptrdiff_t)y * image->pitch + x), mask = words_opaque_mask(s);
            for (unsigned bank = 0; bank < 16; bank++)
                if (banks >> bank & 1)
                    words_store(stamp->colour + (int)bank * stamp->bytes + at, words_add(s, bank_offsets(bank)) & mask);
        }
    return true;
}

static inline void fill_under(uint8_t *d, uint64_t colour)
{
    uint64_t s = words_load(d);

    words_store(d, s | (colour & ~words_opaque_mask(s)));
}

static inline void fill_under_sixteen(uint8_t *d, const uint8_t *colour)
{
    pixels16 s, c;

    memcpy(&s, d, sizeof s);
    memcpy(&c, colour, sizeof c);
    s |= c & (s == 0);
    memcpy(d, &s, sizeof s);
}

static inline void paint_under(uint8_t *d, ptrdiff_t pitch, const uint8_t *colour, int colour_pitch, int h)
{
    for (int y = 0; y < h; y++, d += pitch, colour += colour_pitch) {
        int k = 0;
        for (; k + 16 <= colour_pitch; k += 16)
            fill_under_sixteen(d + k, colour + k);
        if (k < colour_pitch)
            fill_under(d + k, words_load(colour + k));
    }
}

/* Returns the first byte of a surface's band. */
static uint8_t *band_start(const struct fb *fb)
{
    return fb->pix - (ptrdiff_t)FB_GUARD * fb->pitch - FB_GUARD;
}

/* The pictures that destinations show instead of the one image; both NULL: the image. */
struct pictures {
    const uint32_t *offsets;         /* offset of each destination's picture, or NULL */
    const struct stamp_turns *turns; /* or NULL */
};

/* Returns the address of a destination; first: the address of destination 0. */
static inline uint8_t *dest_address(uint8_t *first, uint32_t dest, uint32_t bias)
{
    return first + ((dest & (STAMP_CALLER_ENTRY - 1)) - bias);
}

/* Draws images with a pitch of 8, or of 16 if `wide`. mix, and the widths and heights of most bullets, are constants at
 * the call sites. Each destination shows the image, or the picture that `pictures` selects by at or turns. */
__attribute__((always_inline)) static inline size_t draw_specialised(const struct fb *fb, const struct image *image,
                                                                     const struct pictures pictures, enum blit_mix mix,
                                                                     const struct stamp_list *list, bool wide, int h)
{
    const uint32_t *dests = list->dests;
    uint8_t *first = fb->pix + (ptrdiff_t)fb->sy0 * fb->pitch + fb->sx0;
    const ptrdiff_t pitch = fb->pitch;
    const uint8_t *s = image->pix;
    const struct stamp_turns t = pictures.turns ? *pictures.turns : (struct stamp_turns){ 0 };

    for (size_t i = 0; i < list->n; i++) {
        const uint8_t add = (uint8_t)(dests[i] >> 28 << 4);
        if (dests[i] & STAMP_CALLER_ENTRY)
            return i;
        uint8_t *d = dest_address(first, dests[i], list->bias);
        if (pictures.offsets)
            s = image->pix + pictures.offsets[i];
        if (pictures.turns)
            s = image->pix + (size_t)stamp_turn_index(t.dir[t.dir_index[i]], t.n_copies) * t.size;
        if (wide)
            paint_wide(d, pitch, s, add, h, mix);
        else
            paint_narrow(d, pitch, s, add, h, mix);
    }
    return list->n;
}

__attribute__((always_inline)) static inline size_t
draw_specialised_sizes(const struct fb *fb, const struct image *image, const struct pictures pictures,
                       enum blit_mix mix, const struct stamp_list *list)
{
    const int h = image->h;

    if (image->pitch == 8)
        return h == 8 ? draw_specialised(fb, image, pictures, mix, list, false, 8)
                      : draw_specialised(fb, image, pictures, mix, list, false, h);
    if (h == 12)
        return draw_specialised(fb, image, pictures, mix, list, true, 12);
    return h == 16 ? draw_specialised(fb, image, pictures, mix, list, true, 16)
                   : draw_specialised(fb, image, pictures, mix, list, true, h);
}

static size_t picture_offset(const struct pictures *pictures, size_t i)
{
    if (pictures->turns)
        return (size_t)stamp_turn_index(pictures->turns->dir[pictures->turns->dir_index[i]],
                                        pictures->turns->n_copies) *
               pictures->turns->size;
    return pictures->offsets ? pictures->offsets[i] : 0;
}

/* Draws images of any size by any rule. */
static size_t draw_other_sizes(const struct fb *fb, const struct image *image, const struct pictures pictures,
                               enum blit_mix mix, const struct stamp_list *list)
{
    enum { BATCH = 64 };
    const uint32_t *dests = list->dests;
    const size_t n = list->n;
    uint8_t *first = fb->pix + (ptrdiff_t)fb->sy0 * fb->pitch + fb->sx0;
    struct blit_item items[BATCH];
    size_t i = 0, k = 0;

    while (i < n && !(dests[i] & STAMP_CALLER_ENTRY)) {
        for (k = 0; k < BATCH && i < n && !(dests[i] & STAMP_CALLER_ENTRY); k++, i++)
            items[k] = (struct blit_item){ image->pix + picture_offset(&pictures, i),
                                           dest_address(first, dests[i], list->bias), dests[i] >> 28 };
        blit_batch(items, k, fb->pitch, image->w, image->h, image->pitch, mix);
    }
    return i;
}

static bool has_specialised_size(const struct image *image)
{
    return image->pitch == 8 || (image->pitch == 16 && image->w > 8);
}

__attribute__((always_inline)) static inline size_t draw_any_size(const struct fb *fb, const struct image *image,
                                                                  const struct pictures pictures, enum blit_mix mix,
                                                                  const struct stamp_list *list)
{
    if (has_specialised_size(image) && mix == BLIT_OPAQUE)
        return draw_specialised_sizes(fb, image, pictures, BLIT_OPAQUE, list);
    if (has_specialised_size(image) && mix == BLIT_RAMP_ADD)
        return draw_specialised_sizes(fb, image, pictures, BLIT_RAMP_ADD, list);
    return draw_other_sizes(fb, image, pictures, mix, list);
}

/* Draws two rows of eight pixels: keeps the bytes of d where `keep_mask` is set, and adds the bits of `colour`. */
static inline void put_two_rows(uint8_t *d, ptrdiff_t pitch, pixels16 keep_mask, pixels16 colour)
{
    uint64_t rows[2] = { words_load(d), words_load(d + pitch) };
    pixels16 v;

    memcpy(&v, rows, sizeof v);
    v = (v & keep_mask) | colour;
    memcpy(rows, &v, sizeof v);
    words_store(d, rows[0]);
    words_store(d + pitch, rows[1]);
}

/* Masks and colours of an 8x8 image in one bank, two rows per vector. */
struct image8 {
    pixels16 keep_mask[4], colour[4];
};

static inline void make_image8(struct image8 *e, const struct image *image, uint32_t bank)
{
#pragma GCC unroll 4
    for (int k = 0; k < 4; k++) {
        pixels16 s;
        memcpy(&s, image->pix + 16 * k, sizeof s);
        e->keep_mask[k] = s == 0;
        e->colour[k] = paint_add_bank(s, (uint8_t)(bank << 4)) & (s != 0);
    }
}

/* Returns whether two pictures 8 px wide overlap and are in the same rows. */
static inline bool overlap_in_same_rows(uint32_t dest, uint32_t other)
{
    return dest - other + 7 < 15;
}

/* Returns whether there are many destinations and most of them overlap the one before, in any rows, judging by the
 * first few. */
static bool are_stacked(const uint32_t *dests, size_t n, uint32_t pitch)
{
    enum { MIN_DESTS = 512, PROBES = 8 };
    int overlaps = 0;

    for (size_t i = 1; n >= MIN_DESTS && i <= PROBES; i++) {
        const uint32_t offset =
            (dests[i] & (STAMP_CALLER_ENTRY - 1)) - (dests[i - 1] & (STAMP_CALLER_ENTRY - 1)) + 7 + 7 * pitch;
        overlaps += offset < 15 * pitch && offset % pitch < 15;
    }
    return overlaps > PROBES / 2;
}

/* Draws a row at a time, so that pixels that were just stored can be loaded again as soon as possible. */
static inline void put_rows(uint8_t *d, ptrdiff_t pitch, const struct image8 *e)
{
    const uint8_t *keep_mask = (const uint8_t *)e->keep_mask, *colour = (const uint8_t *)e->colour;

#pragma GCC unroll 8
    for (int k = 0; k < 64; k += 8, d += pitch)
        words_store(d, (words_load(d) & words_load(keep_mask + k)) | words_load(colour + k));
}

/* Draws an opaque 8x8 image at the destinations before the first whose bank is not that of dests[0]. Returns the number
 * drawn. The image's masks and colours stay in registers. A picture that overlaps the previous one, as in a ring that
 * was just fired, has to wait for the previous picture's stores, so it is drawn row by row. */
static size_t draw_one_bank(const struct fb *fb, const struct image *image, const struct stamp_list *list)
{
    const uint32_t *dests = list->dests;
    const uint32_t bank = dests[0] >> 27; /* includes the STAMP_CALLER_ENTRY bit, which is 0 */
    struct image8 e;
    const ptrdiff_t pitch = fb->pitch;
    uint8_t *first = fb->pix + (ptrdiff_t)fb->sy0 * pitch + fb->sx0;
    uint32_t previous = dests[0] - 8;
    size_t i = 0;

    make_image8(&e, image, bank >> 1);
    for (; i < list->n && dests[i] >> 27 == bank; previous = dests[i++]) {
        uint8_t *d = dest_address(first, dests[i], list->bias);
        if (overlap_in_same_rows(dests[i], previous)) {
            put_rows(d, pitch, &e);
            continue;
        }
        put_two_rows(d, pitch, e.keep_mask[0], e.colour[0]);
        put_two_rows(d + 2 * pitch, pitch, e.keep_mask[1], e.colour[1]);
        put_two_rows(d + 4 * pitch, pitch, e.keep_mask[2], e.colour[2]);
        put_two_rows(d + 6 * pitch, pitch, e.keep_mask[3], e.colour[3]);
    }
    return i;
}

/* Like draw_one_bank, but draws all banks, up to the first STAMP_CALLER_ENTRY, row by row. */
static size_t draw_stacked(const struct fb *fb, const struct image *image, const struct stamp_list *list)
{
    const uint32_t *dests = list->dests;
    uint8_t *first = fb->pix + (ptrdiff_t)fb->sy0 * fb->pitch + fb->sx0;
    struct image8 banks[16];
    unsigned made_mask = 0;
    size_t i = 0;

    for (; i < list->n && !(dests[i] & STAMP_CALLER_ENTRY); i++) {
        const uint32_t bank = dests[i] >> 28;
        if (!(made_mask >> bank & 1))
            make_image8(&banks[bank], image, bank);
        made_mask |= 1u << bank;
        put_rows(dest_address(first, dests[i], list->bias), fb->pitch, &banks[bank]);
    }
    return i;
}

/* Like draw_one_bank, but draws turned copies; masks are made on the fly. */
static size_t draw_one_bank_turned(const struct fb *fb, const struct image *image, const struct stamp_turns *turns,
                                   const struct stamp_list *list)
{
    const struct stamp_turns t = *turns;
    const uint32_t *dests = list->dests;
    const uint32_t bank = dests[0] >> 27;
    const ptrdiff_t pitch = fb->pitch;
    const uint8_t *pix = image->pix;
    uint8_t *first = fb->pix + (ptrdiff_t)fb->sy0 * pitch + fb->sx0;
    const uint8_t add = (uint8_t)(bank >> 1 << 4);
    size_t i = 0;

    for (; i < list->n && dests[i] >> 27 == bank; i++) {
        const uint8_t *from = pix + (size_t)stamp_turn_index(t.dir[t.dir_index[i]], t.n_copies) * t.size;
        uint8_t *d = dest_address(first, dests[i], list->bias);
#pragma GCC unroll 4
        for (int k = 0; k < 4; k++, d += 2 * pitch) {
            pixels16 s;
            memcpy(&s, from + 16 * k, sizeof s);
            put_two_rows(d, pitch, s == 0, paint_add_bank(s, add) & (s != 0));
        }
    }
    return i;
}

/* Draws 8x8 images in any banks, assuming that most images of a kind share one bank. When the bank changes, the next
 * MIXED images are painted without prepared masks, because the bank may soon change again. turns: the turned copies to
 * draw, or NULL. */
static size_t draw_8x8(const struct fb *fb, const struct image *image, const struct stamp_turns *turns,
                       const struct stamp_list *list)
{
    enum { MIXED_IMAGES = 64 };
    const uint32_t *dests = list->dests;
    const size_t n = list->n;
    struct stamp_turns remaining_turns = turns ? *turns : (struct stamp_turns){ 0 };
    const struct pictures pictures = { NULL, turns ? &remaining_turns : NULL };
    struct stamp_list remaining = { .bias = list->bias };
    size_t i = 0;

    if (!turns && are_stacked(dests, n, (uint32_t)fb->pitch))
        return draw_stacked(fb, image, list);
    while (i < n && !(dests[i] & STAMP_CALLER_ENTRY)) {
        remaining.dests = dests + i;
        remaining.n = n - i;
        if (turns) {
            remaining_turns.dir_index = turns->dir_index + i;
            i += draw_one_bank_turned(fb, image, &remaining_turns, &remaining);
            remaining_turns.dir_index = turns->dir_index + i;
        } else
            i += draw_one_bank(fb, image, &remaining);
        remaining.dests = dests + i;
        remaining.n = n - i < MIXED_IMAGES ? n - i : MIXED_IMAGES;
        i += draw_specialised(fb, image, pictures, BLIT_OPAQUE, &remaining, false, 8);
    }
    return i;
}

size_t stamp_draw(struct fb *fb, const struct image *image, enum blit_mix mix, const struct stamp_list *list)
{
    if (image->pitch == 8 && image->h == 8 && mix == BLIT_OPAQUE)
        return draw_8x8(fb, image, NULL, list);
    return draw_any_size(fb, image, (struct pictures){ NULL, NULL }, mix, list);
}

size_t stamp_draw_each(struct fb *fb, const struct image *image, const uint32_t *at, enum blit_mix mix,
                       const struct stamp_list *list)
{
    return draw_any_size(fb, image, (struct pictures){ at, NULL }, mix, list);
}

size_t stamp_draw_turned(struct fb *fb, const struct image *image, const struct stamp_turns *turns, enum blit_mix mix,
                         const struct stamp_list *list)
{
    if (image->pitch == 8 && image->h == 8 && mix == BLIT_OPAQUE)
        return draw_8x8(fb, image, turns, list);
    return draw_any_size(fb, image, (struct pictures){ NULL, turns }, mix, list);
}

/* ---- layers ---- */

/* Overdraw, in multiples of the layer's area, after which the map is worth updating: for the first update, and for each
 * later one. */
enum { FIRST_OVERDRAW = 4, NEXT_OVERDRAW = 3 };

static size_t map_size(const struct fb *fb)
{
    return (size_t)(fb->pitch / 8) * (size_t)(fb->h + 2 * FB_GUARD);
}

size_t stamp_layer_size(int w, int h)
{
    size_t size = fb_size(w, h);

    return size + size / 8 + 8;
}

void stamp_layer_init(struct stamp_layer *l, void *mem, int w, int h)
{
    fb_init(&l->fb, mem, w, h);
    l->map = (uint8_t *)mem + fb_size(w, h);
    l->budget = FIRST_OVERDRAW * (size_t)w * (size_t)h;
    l->next_budget = NEXT_OVERDRAW * (size_t)w * (size_t)h;
    l->covered = false;
    l->hidden_count = 0;
    memset(l->map, 0, map_size(&l->fb));
}

/* Returns a mask with 255 in those bytes of word `word` of a row that are outside the picture. */
static uint64_t band_mask(const struct fb *fb, int word)
{
    uint8_t b[8];

    for (int i = 0; i < 8; i++)
        b[i] = word * 8 + i < FB_GUARD || word * 8 + i >= FB_GUARD + fb->w ? 255 : 0;
    return words_load(b);
}

/* Returns whether no byte of s is 0. */
static inline bool is_full(uint64_t s)
{
    return !((s - WORDS_EACH(1)) & ~s & WORDS_EACH(0x80));
}

/* Updates the map of a row of words; `below` is the map of the next row down. Returns false if a pixel is still 0. */
static bool update_map_row(uint8_t *restrict map, const uint8_t *restrict below, const uint8_t *restrict row, int words,
                           const uint64_t *restrict band)
{
    unsigned all_full = 1;

    for (int i = 0; i < words; i++) {
        unsigned word_full = is_full(words_load(row + 8 * i) | band[i]);
        map[i] = (uint8_t)((below[i] + (unsigned)(below[i] < 255)) & (0u - word_full));
        all_full &= word_full;
    }
    return all_full;
}

/* Rebuilds the map. The guard band is not shown and counts as drawn. */
void stamp_layer_update_map(struct stamp_layer *l)
{
    const struct fb *fb = &l->fb;
    int words = fb->pitch / 8, y = fb->h + FB_GUARD;
    uint64_t band[(FB_MAX_SIDE + 2 * FB_GUARD) / 8];

    for (int i = 0; i < words; i++)
        band[i] = band_mask(fb, i);
    memset(l->map + (ptrdiff_t)y * words, 255, (size_t)(FB_GUARD * words));
    l->covered = true;
    while (y-- > FB_GUARD) {
        uint8_t *map = l->map + (ptrdiff_t)y * words;
        l->covered &=
            update_map_row(map, map + words, fb->pix + (ptrdiff_t)(y - FB_GUARD) * fb->pitch - FB_GUARD, words, band);
    }
    for (; y >= 0; y--)
        for (int i = 0; i < words; i++) {
            uint8_t below = l->map[(ptrdiff_t)(y + 1) * words + i];
            l->map[(ptrdiff_t)y * words + i] = (uint8_t)(below + (below < 255));
        }
    l->budget = l->next_budget;
}

static void spend_budget(struct stamp_layer *l, size_t pixels)
{
    if (l->budget > pixels)
        l->budget -= pixels;
    else
        stamp_layer_update_map(l);
}

void stamp_layer_draw(struct stamp_layer *l, const struct stamp *stamp, const struct stamp_list *list, size_t pixels)
{
    uint8_t *first = band_start(&l->fb);
    size_t n = list->n;

    while (n > 0 && !l->covered) {
        uint32_t dest = list->dests[--n], at = (dest & (STAMP_CALLER_ENTRY - 1)) - list->bias;
        const uint8_t *colour = stamp->colour + (dest >> 28) * (uint32_t)stamp->bytes;
        if (stamp_layer_hides(l, at, (uint32_t)stamp->w, (uint32_t)stamp->h)) {
            l->hidden_count++;
            continue;
        }
        paint_under(first + at, l->fb.pitch, colour, stamp->pitch, stamp->h);
        spend_budget(l, pixels);
    }
    l->hidden_count += n;
}

static void compute_cell_grid(int w, int h, uint32_t *columns, uint32_t *rows)
{
    *columns = (uint32_t)(w + 2 * FB_GUARD + 7) / 8;
    *rows = (uint32_t)(h + 2 * FB_GUARD + 7) / 8;
}

size_t stamp_cells_size(int w, int h)
{
    uint32_t columns, rows;

    compute_cell_grid(w, h, &columns, &rows);
    return (size_t)columns * rows + 1;
}

/* Returns whether all pixels in [x0, x1) x [y0, y1), relative to the band's first byte, are covered. Pixels outside the
 * band are not shown and count as covered. */
static bool are_all_covered(const struct stamp_layer *l, int x0, int y0, int x1, int y1)
{
    int words = l->fb.pitch / 8, rows = l->fb.h + 2 * FB_GUARD;

    x0 = x0 < 0 ? 0 : x0;
    y0 = y0 < 0 ? 0 : y0;
    x1 = x1 > l->fb.pitch ? l->fb.pitch : x1;
    y1 = y1 > rows ? rows : y1;
    if (x0 >= x1 || y0 >= y1)
        return true;
    for (int i = x0 / 8; i <= (x1 - 1) / 8; i++)
        if (l->map[(ptrdiff_t)y0 * words + i] < y1 - y0)
            return false;
    return true;
}

void stamp_cells_compute(const struct stamp_layer *l, struct stamp_cells *cells, uint8_t *visible, int x0, int y0,
                         int x1, int y1)
{
    compute_cell_grid(l->fb.w, l->fb.h, &cells->columns, &cells->rows);
    cells->visible = visible;
    for (int v = 0; v < (int)cells->rows; v++)
        for (int u = 0; u < (int)cells->columns; u++)
            *visible++ = !are_all_covered(l, 8 * u + x0, 8 * v + y0, 8 * u + 7 + x1, 8 * v + 7 + y1);
    *visible = 1;
}

void stamp_cells_index(const struct stamp_cells *cells, const fx *restrict x, const fx *restrict y,
                       uint32_t *restrict at)
{
    const uint32_t columns = cells->columns, no_cell = columns * cells->rows, w = 8 * columns, h = 8 * cells->rows;

    for (int i = 0; i < 64; i++) {
        uint32_t px = (uint32_t)(x[i] >> 16) + FB_GUARD, py = (uint32_t)(y[i] >> 16) + FB_GUARD;
        uint32_t in_mask = 0u - (uint32_t)((px < w) & (py < h));
        at[i] = (((py >> 3) * columns + (px >> 3)) & in_mask) | (no_cell & ~in_mask);
    }
}

void stamp_layer_draw_sprite(struct stamp_layer *l, const struct image *image, uint32_t dest, size_t pixels)
{
    uint64_t add = bank_offsets(dest >> 28);
    uint8_t *first = band_start(&l->fb) + (dest & (STAMP_CALLER_ENTRY - 1));

    if (l->covered || stamp_layer_hides(l, dest & (STAMP_CALLER_ENTRY - 1), (uint32_t)image->w, (uint32_t)image->h)) {
        l->hidden_count++;
        return;
    }
    for (int row = 0; row < image->h; row++) {
        const uint8_t *s = image->pix + (ptrdiff_t)row * image->pitch;
        uint8_t *d = first + (ptrdiff_t)row * l->fb.pitch;
        for (int k = 0; k < image->w; k += 8) {
            uint64_t v = words_load(s + k);
            fill_under(d + k, words_add(v, add) & words_opaque_mask(v));
        }
    }
    spend_budget(l, pixels);
}

void stamp_layer_show(const struct stamp_layer *l, struct fb *fb, int x, int y)
{
    for (int row = 0; row < l->fb.h; row++) {
        const uint8_t *s = l->fb.pix + (ptrdiff_t)row * l->fb.pitch;
        uint8_t *d = fb->pix + (ptrdiff_t)(y + row) * fb->pitch + x;
        int k = 0;
        for (; k + 8 <= l->fb.w; k += 8) {
            uint64_t v = words_load(s + k);
            words_store(d + k, (words_load(d + k) & ~words_opaque_mask(v)) | v);
        }
        for (; k < l->fb.w; k++)
            d[k] = s[k] ? s[k] : d[k];
    }
}
