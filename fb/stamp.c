/*
 * stamp.c - see stamp.h.
 *
 * Pictures are painted over the existing pixels (paint.h). A word may extend past the picture's edge by up to 7 pixels,
 * which are 0: the band and slack of fb.h exist for that. Common sizes have specialised loops.
 */
#include "stamp.h"
#include <assert.h>
#include <string.h>
#include "paint.h"

/* Returns the address of a destination; first: the address of destination 0. */
static inline uint8_t *dest_address(uint8_t *first, uint32_t dest, uint32_t bias)
{
    return first + ((dest & (STAMP_CALLER_ENTRY - 1)) - bias);
}

/* Draws images with a pitch of 8, or of 16 if `wide`. mix, and the widths and heights of most bullets, are constants at
 * the call sites. offsets: as in stamp_draw_each; NULL: every destination shows the image. */
__attribute__((always_inline)) static inline size_t draw_specialised(const struct fb *fb, const struct image *image,
                                                                     const uint32_t *offsets, enum blit_mix mix,
                                                                     const struct stamp_list *list, bool wide, int h)
{
    const uint32_t *dests = list->dests;
    uint8_t *first = fb->pix + (ptrdiff_t)fb->sy0 * fb->pitch + fb->sx0;
    const ptrdiff_t pitch = fb->pitch;
    const uint8_t *s = image->pix;

    for (size_t i = 0; i < list->n; i++) {
        const uint8_t add = (uint8_t)(dests[i] >> 28 << 4);
        if (dests[i] & STAMP_CALLER_ENTRY)
            return i;
        uint8_t *d = dest_address(first, dests[i], list->bias);
        if (offsets)
            s = image->pix + offsets[i];
        if (wide)
            paint_wide(d, pitch, s, add, h, mix);
        else
            paint_narrow(d, pitch, s, add, h, mix);
    }
    return list->n;
}

__attribute__((always_inline)) static inline size_t draw_specialised_sizes(const struct fb *fb,
                                                                           const struct image *image,
                                                                           const uint32_t *offsets, enum blit_mix mix,
                                                                           const struct stamp_list *list)
{
    const int h = image->h;

    if (image->pitch == 8)
        return h == 8 ? draw_specialised(fb, image, offsets, mix, list, false, 8)
                      : draw_specialised(fb, image, offsets, mix, list, false, h);
    if (h == 12)
        return draw_specialised(fb, image, offsets, mix, list, true, 12);
    return h == 16 ? draw_specialised(fb, image, offsets, mix, list, true, 16)
                   : draw_specialised(fb, image, offsets, mix, list, true, h);
}

/* Draws images of any size by any rule. */
static size_t draw_other_sizes(const struct fb *fb, const struct image *image, const uint32_t *offsets,
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
            items[k] = (struct blit_item){ image->pix + (offsets ? offsets[i] : 0),
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
                                                                  const uint32_t *offsets, enum blit_mix mix,
                                                                  const struct stamp_list *list)
{
    if (has_specialised_size(image) && mix == BLIT_OPAQUE)
        return draw_specialised_sizes(fb, image, offsets, BLIT_OPAQUE, list);
    if (has_specialised_size(image) && mix == BLIT_RAMP_ADD)
        return draw_specialised_sizes(fb, image, offsets, BLIT_RAMP_ADD, list);
    return draw_other_sizes(fb, image, offsets, mix, list);
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
 * drawn. The image's masks and colours stay in registers. Kept because drawing a crowd takes 0.83 of the time (rows
 * "crowd" of `make compare`). */
static size_t draw_one_bank(const struct fb *fb, const struct image *image, const struct stamp_list *list)
{
    const uint32_t *dests = list->dests;
    const uint32_t bank = dests[0] >> 27; /* includes the STAMP_CALLER_ENTRY bit, which is 0 */
    struct image8 e;
    const ptrdiff_t pitch = fb->pitch;
    uint8_t *first = fb->pix + (ptrdiff_t)fb->sy0 * pitch + fb->sx0;
    size_t i = 0;

    make_image8(&e, image, bank >> 1);
    for (; i < list->n && dests[i] >> 27 == bank; i++) {
        uint8_t *d = dest_address(first, dests[i], list->bias);
        put_two_rows(d, pitch, e.keep_mask[0], e.colour[0]);
        put_two_rows(d + 2 * pitch, pitch, e.keep_mask[1], e.colour[1]);
        put_two_rows(d + 4 * pitch, pitch, e.keep_mask[2], e.colour[2]);
        put_two_rows(d + 6 * pitch, pitch, e.keep_mask[3], e.colour[3]);
    }
    return i;
}

/* Like draw_one_bank, but draws all banks, up to the first STAMP_CALLER_ENTRY, row by row. Kept because drawing rings
 * that were just fired takes 0.8 to 0.9 of the time (rows "price fan", "price mixed" of `make compare`). */
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

/* Draws an 8x8 image in any banks, assuming that most bullets of a kind share one bank. When the bank changes, the next
 * MIXED_IMAGES are painted without prepared masks, because the bank may soon change again. */
static size_t draw_8x8(const struct fb *fb, const struct image *image, const struct stamp_list *list)
{
    enum { MIXED_IMAGES = 64 };
    const uint32_t *dests = list->dests;
    const size_t n = list->n;
    struct stamp_list remaining = { .bias = list->bias };
    size_t i = 0;

    if (are_stacked(dests, n, (uint32_t)fb->pitch))
        return draw_stacked(fb, image, list);
    while (i < n && !(dests[i] & STAMP_CALLER_ENTRY)) {
        remaining.dests = dests + i;
        remaining.n = n - i;
        i += draw_one_bank(fb, image, &remaining);
        remaining.dests = dests + i;
        remaining.n = n - i < MIXED_IMAGES ? n - i : MIXED_IMAGES;
        i += draw_specialised(fb, image, NULL, BLIT_OPAQUE, &remaining, false, 8);
    }
    return i;
}

size_t stamp_draw(struct fb *fb, const struct image *image, enum blit_mix mix, const struct stamp_list *list)
{
    if (image->pitch == 8 && image->h == 8 && mix == BLIT_OPAQUE)
        return draw_8x8(fb, image, list);
    return draw_any_size(fb, image, NULL, mix, list);
}

size_t stamp_draw_each(struct fb *fb, const struct image *image, const uint32_t *at, enum blit_mix mix,
                       const struct stamp_list *list)
{
    return draw_any_size(fb, image, at, mix, list);
}
