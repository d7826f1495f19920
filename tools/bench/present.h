/*
 * present.h - palette indices to 32-bit pixels, as a port shows them.
 * floor: tools
 *
 * A stand-in with plat_rgb's signature: when the platform has that function, this file goes and its callers call it.
 */
#ifndef BENCH_PRESENT_H
#define BENCH_PRESENT_H

#include <stdint.h>
#include "../../src/base/bytes.h"

/* out_pitch in pixels, pitch in bytes; w is a multiple of 8. */
static inline void present(uint32_t *out, int out_pitch, const uint8_t *pix, int pitch, int w, int h,
                           const uint32_t rgb[256])
{
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x += 8) {
            uint64_t p = get64(pix + y * pitch + x);
            uint32_t *to = out + y * out_pitch + x;
            to[0] = rgb[p & 255];
            to[1] = rgb[p >> 8 & 255];
            to[2] = rgb[p >> 16 & 255];
            to[3] = rgb[p >> 24 & 255];
            to[4] = rgb[p >> 32 & 255];
            to[5] = rgb[p >> 40 & 255];
            to[6] = rgb[p >> 48 & 255];
            to[7] = rgb[p >> 56];
        }
}

#endif
