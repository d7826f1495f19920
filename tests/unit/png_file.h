/* png_file.h - PNG files of any kind from raw rows, stored without compression. */
#ifndef TESTS_PNG_FILE_H
#define TESTS_PNG_FILE_H

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "../../src/base/hash.h"

struct png_kind {
    int w, h, bits, colour, interlaced;
};

static inline void png_put32(uint8_t *p, uint32_t v)
{
    for (int i = 0; i < 4; i++)
        p[i] = (uint8_t)(v >> (24 - 8 * i));
}

/* Data in zlib's format: stored blocks of up to 65535 bytes. */
static inline uint8_t *png_stored(const uint8_t *data, size_t size, size_t *out_size)
{
    uint8_t *out = malloc(size + size / 65535 * 5 + 16), *p = out;
    uint32_t a = 1, b = 0;

    *p++ = 0x78;
    *p++ = 0x01;
    for (size_t at = 0; at < size || at == 0; at += 65535) {
        size_t n = size - at < 65535 ? size - at : 65535;
        *p++ = at + n == size;
        *p++ = (uint8_t)n;
        *p++ = (uint8_t)(n >> 8);
        *p++ = (uint8_t)~n;
        *p++ = (uint8_t)(~n >> 8);
        memcpy(p, data + at, n);
        p += n;
    }
    for (size_t i = 0; i < size; i++) {
        a = (a + data[i]) % 65521;
        b = (b + a) % 65521;
    }
    png_put32(p, b << 16 | a);
    *out_size = (size_t)(p + 4 - out);
    return out;
}

static inline uint8_t *png_put_chunk(uint8_t *p, const char *type, const uint8_t *data, size_t n)
{
    png_put32(p, (uint32_t)n);
    memcpy(p + 4, type, 4);
    if (n)
        memcpy(p + 8, data, n);
    png_put32(p + 8 + n, hash_crc32(p + 4, n + 4));
    return p + 12 + n;
}

/* raw: the rows with their filter bytes. n_colours 0: no palette. */
static inline uint8_t *png_file(const struct png_kind *k, const uint8_t *raw, size_t raw_size, const uint8_t *palette,
                                size_t n_colours, size_t *size)
{
    size_t n;
    uint8_t *packed = png_stored(raw, raw_size, &n), head[13] = { 0 };
    uint8_t *file = malloc(n + 2048), *p = file;

    memcpy(p, "\x89PNG\r\n\x1a\n", 8);
    png_put32(head, (uint32_t)k->w);
    png_put32(head + 4, (uint32_t)k->h);
    head[8] = (uint8_t)k->bits;
    head[9] = (uint8_t)k->colour;
    head[12] = (uint8_t)k->interlaced;
    p = png_put_chunk(p + 8, "IHDR", head, 13);
    if (n_colours)
        p = png_put_chunk(p, "PLTE", palette, 3 * n_colours);
    p = png_put_chunk(p, "IDAT", packed, 0); /* an empty chunk and two more */
    p = png_put_chunk(p, "IDAT", packed, n / 2);
    p = png_put_chunk(p, "IDAT", packed + n / 2, n - n / 2);
    p = png_put_chunk(p, "IEND", NULL, 0);
    free(packed);
    *size = (size_t)(p - file);
    return file;
}

#endif
