/*
 * crt.c - see crt.h.
 *
 * How dark it is beside a line's middle grows with the square of the distance. A row of the window is given the mean of
 * that over what it covers, so lines that are no whole number of rows apart do not beat.
 */
#include "crt.h"

#include "../../base/int.h"

enum {
    ONE = 4096,   /* the distance of two lines */
    DARK = 208,   /* of 256, that a dark colour loses between two lines */
    BRIGHT = 112, /* and a bright one */
    LIFT = 96,    /* of 256: how much the colours of middle brightness are lifted */
    DIM = 0xDC,   /* of a stripe's other colours */
    DIM_NARROW = 0xE8
};

void crt_colours(uint32_t out[256], const uint32_t rgb[256])
{
    for (int i = 0; i < 256; i++) {
        uint32_t to = 0;
        for (int shift = 0; shift < 24; shift += 8) {
            const uint32_t c = rgb[i] >> shift & 255;
            to |= (c + c * (255 - c) * LIFT / 255 / 256 * 2) << shift;
        }
        out[i] = to;
    }
}

/* From the middle of line 0 on, in parts of ONE: (2 u)^2 from -1/2 to 1/2, and again for each line; summed up to u, of
 * ONE for a whole line a third. */
static int64_t summed(int64_t u)
{
    const int64_t line = (u + ONE / 2) >> 12, rest = u - line * ONE; /* -ONE / 2 to ONE / 2 */

    return line * (ONE / 3) + rest * rest * rest * 4 / ONE / ONE / 3;
}

struct crt_line crt_line(int y, int small, int large)
{
    if (large < 2 * small)
        return (struct crt_line){ 256, 0 };
    const int64_t middle = large < 3 * small ? ONE / 4 : ONE / 2;
    const int64_t from = (int64_t)y * small * ONE / large - middle,
                  to = (int64_t)(y + 1) * small * ONE / large - middle;
    const int64_t away = int64_clamp((summed(to) - summed(from)) * 256 / int64_max(to - from, 1), 0, 256);
    const int dark = 256 - (int)(away * DARK / 256), bright = 256 - (int)(away * BRIGHT / 256);

    return (struct crt_line){ (uint16_t)dark, (uint16_t)(bright - dark) };
}

void crt_mask(uint32_t *mask, int small, int large)
{
    static const uint32_t three[] = { 0xFF0000 | DIM << 8 | DIM, 0x00FF00 | DIM << 16 | DIM,
                                      0x0000FF | DIM << 16 | DIM << 8 };
    static const uint32_t two[] = { 0xFF00FF | DIM_NARROW << 8, 0x00FF00 | DIM_NARROW << 16 | DIM_NARROW };

    for (int x = 0; x < large; x++)
        mask[x] = large >= 3 * small ? three[x % 3] : large >= 2 * small ? two[x % 2] : 0xFFFFFF;
}

enum { BLOCK = 32 };

/* In this form compilers make vectors of it: a constant number of bytes, products of 16 bits. */
static inline void bytes(uint8_t *restrict row, const uint8_t *restrict mask, uint16_t dark, uint16_t bright, int n)
{
    for (int i = 0; i < n; i++) {
        const uint16_t c = row[i], part = (uint16_t)(dark + (uint16_t)((uint16_t)(c * bright) >> 8));
        const uint16_t lit = (uint16_t)((uint16_t)(c * part) >> 8), left = (uint16_t)(mask[i] + 1);
        row[i] = (uint8_t)((uint16_t)(lit * left) >> 8);
    }
}

void crt_row(uint32_t *row, const uint32_t *mask, struct crt_line line, int n)
{
    uint8_t *to = (uint8_t *)row;
    const uint8_t *left = (const uint8_t *)mask;
    int i = 0;

    for (; i + BLOCK <= 4 * n; i += BLOCK)
        bytes(to + i, left + i, line.dark, line.bright, BLOCK);
    bytes(to + i, left + i, line.dark, line.bright, 4 * n - i);
}
