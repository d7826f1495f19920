/*
 * scale.c - see scale.h.
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

/* Of the small picture every pixel is `whole` times itself; the middle of a large pixel is then between two of these,
 * in 256ths. */
static void place_pixel(struct scale_axis *a, int i, int small, int large, int whole)
{
    const int64_t middle = ((int64_t)(2 * i + 1) * small * whole * 128) / large - 128;
    const int most = small * whole - 1, at = (int)int64_clamp(middle >> 8, 0, most), next = int_min(at + 1, most);

    a->from[i] = (uint16_t)(at / whole);
    a->share[i] = middle < 0 || at / whole == next / whole ? 0 : (uint16_t)(middle & 255);
}

bool scale_open(struct scale_axis *a, int small, int large)
{
    const int whole = int_max(1, large / small);

    *a = (struct scale_axis){ .n = large };
    a->from = malloc((size_t)large * sizeof *a->from);
    a->share = malloc((size_t)large * sizeof *a->share);
    if (!a->from || !a->share) {
        scale_close(a);
        return false;
    }
    for (int i = 0; i < large; i++)
        place_pixel(a, i, small, large, whole);
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

void scale_mix(uint32_t *out, const uint32_t *first, const uint32_t *second, int share, int n)
{
    for (int i = 0; i < n; i++)
        out[i] = mix(first[i], second[i], (uint32_t)share);
}
