/*
 * y4m.c - see y4m.h.
 */
#include "y4m.h"

#include <stddef.h>

enum { HALF = 1 << 15 };

void y4m_write_header(FILE *f, int w, int h)
{
    fprintf(f, "YUV4MPEG2 W%d H%d F60:1 Ip A1:1 C444 XCOLORRANGE=LIMITED\n", w, h);
}

/* Converts a colour to Y, Cb and Cr. */
static void convert_colour(uint32_t rgb, uint8_t out[3])
{
    const int32_t r = rgb >> 16 & 255, g = rgb >> 8 & 255, b = rgb & 255;

    out[0] = (uint8_t)((16 * 65536 + 16829 * r + 33039 * g + 6416 * b + HALF) >> 16);
    out[1] = (uint8_t)((128 * 65536 - 9714 * r - 19070 * g + 28784 * b + HALF) >> 16);
    out[2] = (uint8_t)((128 * 65536 + 28784 * r - 24103 * g - 4681 * b + HALF) >> 16);
}

void y4m_write_picture(FILE *f, const uint8_t *pix, const uint32_t rgb[256], int w, int h)
{
    const size_t n = (size_t)w * (size_t)h;
    uint8_t code[256][3], part[4096];

    for (int i = 0; i < 256; i++)
        convert_colour(rgb[i], code[i]);
    fputs("FRAME\n", f);
    for (int plane = 0; plane < 3; plane++)
        for (size_t at = 0, k; at < n; at += k) {
            for (k = 0; k < sizeof part && at + k < n; k++)
                part[k] = code[pix[at + k]][plane];
            fwrite(part, 1, k, f);
        }
}
