/*
 * scale.c - enlarges pictures (scale.h).
 */
#include "scale.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/int.h"

static uint32_t mix(uint32_t a, uint32_t b, uint32_t share)
{
    const uint32_t red_blue = ((a & 0xFF00FF) * (256 - share) + (b & 0xFF00FF) * share) >> 8 & 0xFF00FF;
    const uint32_t green = ((a & 0x00FF00) * (256 - share) + (b & 0x00FF00) * share) >> 8 & 0x00FF00;

    return red_blue | green;
}

/* In units of 1 / large small pixels, a large pixel has length `small` and a small pixel `large`. The part of the large
 * pixel beyond the small pixel in which it begins is the share of the next one. */
static void set_pixel(struct scale_axis *a, int i, int small, int large)
{
    const int64_t begin = (int64_t)i * small, border = (begin / large + 1) * large, end = begin + small;

    a->from[i] = (uint16_t)(begin / large);
    a->share[i] =
        end > border && begin / large + 1 < small ? (uint16_t)int64_min((end - border) * 256 / small, 255) : 0;
}

bool scale_open(struct scale_axis *a, int small, int large)
{
    *a = (struct scale_axis){ .n = large };
    a->from = malloc((size_t)large * sizeof *a->from);
    a->share = malloc((size_t)large * sizeof *a->share);
    if (!a->from || !a->share) {
        scale_close(a);
        return false;
    }
    for (int i = 0; i < large; i++)
        set_pixel(a, i, small, large);
    return true;
}

void scale_close(struct scale_axis *a)
{
    free(a->from);
    free(a->share);
    *a = (struct scale_axis){ 0 };
}

void scale_row(const struct scale_axis *a, const uint32_t *small, uint32_t *large, int x0, int x1)
{
    for (int x = x0; x < x1; x++) {
        const uint32_t *from = small + a->from[x];
        large[x] = a->share[x] ? mix(from[0], from[1], a->share[x]) : from[0];
    }
}

enum { BLOCK = 32 };

/* Compilers vectorise this form: a constant number of bytes, and 16-bit products. */
static inline void mix_bytes(uint8_t *restrict out, const uint8_t *restrict first, const uint8_t *restrict second,
                             uint16_t share, int n)
{
    for (int i = 0; i < n; i++)
        out[i] = (uint8_t)((uint16_t)(first[i] * (uint16_t)(256 - share) + second[i] * share) >> 8);
}

void scale_mix(uint32_t *out, const uint32_t *first, const uint32_t *second, int share, int n)
{
    uint8_t *to = (uint8_t *)out;
    const uint8_t *a = (const uint8_t *)first, *b = (const uint8_t *)second;
    int i = 0;

    for (; i + BLOCK <= 4 * n; i += BLOCK)
        mix_bytes(to + i, a + i, b + i, (uint16_t)share, BLOCK);
    mix_bytes(to + i, a + i, b + i, (uint16_t)share, 4 * n - i);
}
