/*
 * crt.c - the CRT filter (crt.h).
 *
 * Darkness grows with the square of the distance from the middle of a scanline. A row of the window gets the mean
 * darkness of the area that it covers, so scanlines with fractional spacing don't cause moire.
 */
#include "crt.h"

#include "../../base/int.h"

enum {
    LINE_DISTANCE = 4096, /* units between two scanlines */
    DARK = 208,           /* of 256: what a dark colour loses between two scanlines */
    BRIGHT = 112,         /* the same for a bright colour */
    BRIGHTENING = 96,     /* of 256: applied to colours of medium brightness */
    DIM = 0xDC,           /* factor for the other two colours of a mask stripe */
    DIM_NARROW = 0xE8     /* the same for narrow stripes */
};

void crt_colours(uint32_t out[256], const uint32_t rgb[256])
{
    for (int i = 0; i < 256; i++) {
        uint32_t to = 0;
        for (int shift = 0; shift < 24; shift += 8) {
            const uint32_t c = rgb[i] >> shift & 255;
            to |= (c + c * (255 - c) * BRIGHTENING / 255 / 256 * 2) << shift;
        }
        out[i] = to;
    }
}

/* Returns the integral of the darkness from the middle of scanline 0 to u. The darkness at distance d from the middle
 * of the nearest scanline is (2 d / LINE_DISTANCE)^2, so its integral over a whole line is LINE_DISTANCE / 3. */
static int64_t darkness_integral(int64_t u)
{
    const int64_t line = (u + LINE_DISTANCE / 2) >> 12, rest = u - line * LINE_DISTANCE;

    return line * (LINE_DISTANCE / 3) + rest * rest * rest * 4 / LINE_DISTANCE / LINE_DISTANCE / 3;
}

struct crt_line crt_line(int y, int small, int large)
{
    if (large < 2 * small)
        return (struct crt_line){ 256, 0 };
    const int64_t middle = large < 3 * small ? LINE_DISTANCE / 4 : LINE_DISTANCE / 2;
    const int64_t from = (int64_t)y * small * LINE_DISTANCE / large - middle,
                  to = (int64_t)(y + 1) * small * LINE_DISTANCE / large - middle;
    const int64_t sum = darkness_integral(to) - darkness_integral(from);
    const int64_t darkness = int64_clamp(sum * 256 / int64_max(to - from, 1), 0, 256);
    const int dark = 256 - (int)(darkness * DARK / 256), bright = 256 - (int)(darkness * BRIGHT / 256);

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

/* Compilers vectorise this form: a constant number of bytes, and 16-bit products. */
static inline void filter_bytes(uint8_t *restrict row, const uint8_t *restrict mask, uint16_t dark, uint16_t bright,
                                int n)
{
    for (int i = 0; i < n; i++) {
        const uint16_t c = row[i], part = (uint16_t)(dark + (uint16_t)((uint16_t)(c * bright) >> 8));
        const uint16_t lit = (uint16_t)((uint16_t)(c * part) >> 8), mask_factor = (uint16_t)(mask[i] + 1);
        row[i] = (uint8_t)((uint16_t)(lit * mask_factor) >> 8);
    }
}

void crt_row(uint32_t *row, const uint32_t *mask, struct crt_line line, int n)
{
    uint8_t *to = (uint8_t *)row;
    const uint8_t *factors = (const uint8_t *)mask;
    int i = 0;

    for (; i + BLOCK <= 4 * n; i += BLOCK)
        filter_bytes(to + i, factors + i, line.dark, line.bright, BLOCK);
    filter_bytes(to + i, factors + i, line.dark, line.bright, 4 * n - i);
}
