/*
 * video_transform.c - pictures that are scaled or translucent.
 *
 * Both are drawn from copies of the picture: scaled, and with some of the pixels made transparent. A copy is made when
 * the frame first needs it and then kept in scratch until the frame ends or the space is used up, so a thousand bullets
 * of one kind share their copies. The copies are drawn like any other picture.
 *
 * A translucent picture is drawn in two parts. An ordered pattern of 8 levels selects the pixels of each. With the
 * blend "alpha", an even mix, the pixels of one part are opaque or left out and those of the other are mixed, so the
 * pattern only has to cover the quarters between nothing, the mix and the whole picture.
 */
#include <string.h>
#include "../../../fb/scale.h"
#include "../../base/int.h"
#include "video.h"

enum { LEVELS = ALPHA_OPAQUE, COPY_BITS = 8, MAX_COPIES = 1 << COPY_BITS, MIN_SIZE = 1 << 18 /* bytes */ };

/* A copy: `source` with the pixels of the levels from `first` to `end` - 1, scaled. */
struct copy {
    const uint8_t *source; /* NULL: unused */
    uint8_t scale, first, end;
    struct image image;
};

struct video_copies {
    uint64_t size, used; /* bytes of `pixels` */
    uint8_t *pixels;
    struct copy copy[MAX_COPIES];
};

static uint64_t pitch_of(uint64_t w)
{
    return (w + 7) & ~(uint64_t)7;
}

/* Returns the bytes of `pixels`: room for the largest copy of a sprite's picture, and for making it. */
static uint64_t pixels_size(const struct cart *cart)
{
    const uint64_t factor = SCALE_MAX / SCALE_ONE, w = (uint64_t)cart->max_sprite_w, h = (uint64_t)cart->max_sprite_h;
    const uint64_t largest = pitch_of(factor * w) * factor * h + scale_scratch_size((int)w, (int)h);

    return largest > MIN_SIZE ? largest : MIN_SIZE;
}

static size_t align(size_t n)
{
    return (size_t)int_align_cache_line(n);
}

size_t video_scratch_size(const struct cart *cart)
{
    const size_t bullets = video_bullets_scratch_size(&cart->manifest);

    if (!cart->manifest.has_transforms)
        return bullets;
    return align(bullets) + align(sizeof(struct video_copies)) + (size_t)pixels_size(cart) + 64;
}

struct video_copies *video_begin_copies(const struct board *b, void *scratch)
{
    uint8_t *at = (uint8_t *)scratch + video_bullets_scratch_size(&b->cart.manifest);
    struct video_copies *copies = (struct video_copies *)align((uintptr_t)at);

    if (!b->cart.manifest.has_transforms)
        return NULL;
    memset(copies, 0, sizeof *copies);
    copies->size = pixels_size(&b->cart);
    copies->pixels = (uint8_t *)copies + align(sizeof *copies);
    return copies;
}

/* Returns the pattern's level of a pixel, 0 to LEVELS - 1: a Bayer matrix of 4 x 4 that uses each level twice. */
static inline unsigned level_of(int x, int y)
{
    static const uint8_t levels[4][4] = { { 0, 4, 1, 5 }, { 6, 2, 7, 3 }, { 1, 5, 0, 4 }, { 7, 3, 6, 2 } };

    return levels[y & 3][x & 3];
}

static void clear_levels(const struct copy *copy, uint8_t *pixels)
{
    for (int y = 0; y < copy->image.h; y++, pixels += copy->image.pitch)
        for (int x = 0; x < copy->image.w; x++) {
            const unsigned level = level_of(x, y);
            pixels[x] = level >= copy->first && level < copy->end ? pixels[x] : 0;
        }
}

static void make_copy(struct video_copies *copies, struct copy *copy, const struct image *in)
{
    const int w = video_scale(in->w, copy->scale), h = video_scale(in->h, copy->scale);
    const int pitch = (int)pitch_of((uint64_t)w);
    const uint64_t bytes = (uint64_t)pitch * (uint64_t)h, scratch = scale_scratch_size(in->w, in->h);

    if (copies->used + bytes + scratch > copies->size) {
        const struct copy saved = *copy;
        memset(copies->copy, 0, sizeof copies->copy);
        copies->used = 0;
        *copy = saved;
    }
    uint8_t *pixels = copies->pixels + copies->used;
    copies->used += bytes;
    copy->image = (struct image){ pixels, w, h, pitch };
    scale_paint(in, pixels, w, h, pitch, pixels + bytes);
    if (copy->first > 0 || copy->end < LEVELS)
        clear_levels(copy, pixels);
}

/* Returns the entry for a copy: Fibonacci hashing, because addresses of pictures differ by multiples of their size. */
static struct copy *find_entry(struct video_copies *copies, const uint8_t *pix, unsigned scale, unsigned levels)
{
    const uint32_t key = (uint32_t)((uintptr_t)pix >> 3) + (scale << 20) + (levels << 26);

    return &copies->copy[(key * 2654435769u) >> (32 - COPY_BITS)];
}

/* Returns the copy of an image. It is valid until the next call. */
static struct image get_copy(const struct draw_target *c, const struct image *in, unsigned scale, unsigned first,
                             unsigned end)
{
    struct video_copies *copies = c->copies;
    struct copy *copy = find_entry(copies, in->pix, scale, LEVELS * first + end);

    if (scale == SCALE_ONE && first == 0 && end == LEVELS)
        return *in;
    if (copy->source != in->pix || copy->scale != scale || copy->first != first || copy->end != end) {
        *copy = (struct copy){ in->pix, (uint8_t)scale, (uint8_t)first, (uint8_t)end, { 0 } };
        make_copy(copies, copy, in);
    }
    return copy->image;
}

struct image video_scaled_image(const struct draw_target *c, const struct image *image, unsigned scale)
{
    return get_copy(c, image, scale, 0, LEVELS);
}

struct image video_dotted_image(const struct draw_target *c, const struct image *image, const struct pose *pose)
{
    return pose->alpha ? get_copy(c, image, pose->scale, 0, pose->alpha) : (struct image){ .pitch = 8 };
}

void video_paint_posed(struct draw_target *c, const struct image *image, const struct pose *pose, int x, int y,
                       uint8_t bank, unsigned flip, unsigned blend)
{
    const bool is_mixed = !blend && c->alpha_blend;
    const unsigned alpha = pose->alpha, half = LEVELS / 2;
    const unsigned whole = !is_mixed ? alpha : alpha > half ? 2 * (alpha - half) : 0;
    const unsigned mixed = !is_mixed ? 0 : alpha < half ? 2 * alpha : LEVELS;

    if (whole) {
        const struct image part = get_copy(c, image, pose->scale, 0, whole);
        video_paint(c, &part, x, y, bank, flip, blend);
    }
    if (mixed > whole) {
        const struct image part = get_copy(c, image, pose->scale, whole, mixed);
        video_paint(c, &part, x, y, bank, flip, c->alpha_blend);
    }
}
