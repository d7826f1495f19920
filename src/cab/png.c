/*
 * png.c - see png.h. Chunks are ours, compression and the pixel formats are stb's.
 *
 * stb trusts lengths enough to inflate a small file into gigabytes and does not look at CRCs, so the chunks are walked
 * first and its memory is capped.
 */
#include "png.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../base/hash.h"

enum { STB_MOST = 512 << 20 }; /* bytes in one piece */

static void *capped_malloc(size_t n)
{
    return n <= STB_MOST ? malloc(n) : NULL;
}

static void *capped_realloc(void *p, size_t n)
{
    return n <= STB_MOST ? realloc(p, n) : NULL;
}

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_MALLOC(n)      capped_malloc(n)
#define STBI_REALLOC(p, n)  capped_realloc(p, n)
#define STBI_FREE(p)        free(p)
#define STBI_MAX_DIMENSIONS PNG_MAX_SIDE
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

static const uint8_t signature[8] = { 137, 'P', 'N', 'G', 13, 10, 26, 10 };

/* PNG numbers are big-endian. */
static void put_be32(uint8_t *p, uint32_t v)
{
    p[0] = (uint8_t)(v >> 24);
    p[1] = (uint8_t)(v >> 16);
    p[2] = (uint8_t)(v >> 8);
    p[3] = (uint8_t)v;
}

static uint32_t get_be32(const uint8_t *p)
{
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3];
}

/* ---- writing ---- */

static uint8_t *chunk(uint8_t *p, const char type[4], const uint8_t *data, uint32_t n)
{
    put_be32(p, n);
    memcpy(p + 4, type, 4);
    if (n)
        memcpy(p + 8, data, n);
    put_be32(p + 8 + n, crc32_of(p + 4, n + 4));
    return p + 12 + n;
}

/* Rows as the file has them: each a filter byte (0: none) and its n bytes. */
static uint8_t *rows(const uint8_t *from, ptrdiff_t pitch, size_t n, int h)
{
    size_t stride = n + 1;
    uint8_t *out = malloc(stride * (size_t)h);

    for (int y = 0; out && y < h; y++) {
        out[stride * (size_t)y] = 0;
        memcpy(out + stride * (size_t)y + 1, from + y * pitch, n);
    }
    return out;
}

struct pixels {
    const uint8_t *from;
    ptrdiff_t pitch;         /* bytes */
    int w, h, bytes;         /* bytes a pixel: 1 or 3 */
    const uint32_t *palette; /* NULL: none */
};

static uint8_t *palette_chunk(uint8_t *p, const uint32_t rgb[256])
{
    uint8_t colours[768];

    for (int i = 0; i < 256; i++) {
        colours[3 * i] = (uint8_t)(rgb[i] >> 16);
        colours[3 * i + 1] = (uint8_t)(rgb[i] >> 8);
        colours[3 * i + 2] = (uint8_t)rgb[i];
    }
    return chunk(p, "PLTE", colours, sizeof colours);
}

static size_t assemble(uint8_t *out, const struct pixels *pic, const uint8_t *packed, uint32_t n)
{
    uint8_t head[13] = { 0 }, *p = out;

    put_be32(head, (uint32_t)pic->w);
    put_be32(head + 4, (uint32_t)pic->h);
    head[8] = 8;                    /* bits */
    head[9] = pic->palette ? 3 : 2; /* palette or RGB */
    memcpy(p, signature, sizeof signature);
    p = chunk(p + sizeof signature, "IHDR", head, sizeof head);
    if (pic->palette)
        p = palette_chunk(p, pic->palette);
    p = chunk(p, "IDAT", packed, n);
    p = chunk(p, "IEND", NULL, 0);
    return (size_t)(p - out);
}

static bool write_picture(const struct pixels *pic, uint8_t **out, size_t *size)
{
    int n = 0;

    *out = NULL;
    if (pic->w < 1 || pic->h < 1 || pic->w > PNG_MAX_SIDE || pic->h > PNG_MAX_SIDE)
        return false;
    size_t stride = (size_t)pic->w * (size_t)pic->bytes;
    if ((stride + 1) * (size_t)pic->h > STB_MOST)
        return false;
    uint8_t *raw = rows(pic->from, pic->pitch, stride, pic->h);
    uint8_t *packed = raw ? stbi_zlib_compress(raw, (int)(stride + 1) * pic->h, &n, 8) : NULL;
    free(raw);
    if (packed)
        *out = malloc(sizeof signature + 4 * 12 + 13 + 768 + (size_t)n);
    if (*out)
        *size = assemble(*out, pic, packed, (uint32_t)n);
    free(packed);
    return *out != NULL;
}

bool png_write(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256], uint8_t **out, size_t *size)
{
    return write_picture(&(struct pixels){ pix, pitch, w, h, 1, rgb }, out, size);
}

bool png_write_rgb(const uint8_t *rgb, int w, int h, uint8_t **out, size_t *size)
{
    return write_picture(&(struct pixels){ rgb, (ptrdiff_t)w * 3, w, h, 3, NULL }, out, size);
}

/* ---- reading ---- */

static bool fail(char *err, size_t err_size, const char *what)
{
    snprintf(err, err_size, "%s", what);
    return false;
}

/* Are the chunks whole and undamaged up to IEND? */
static bool check_chunks(const uint8_t *data, size_t n, char *err, size_t err_size)
{
    size_t at = sizeof signature;

    while (n - at >= 12) {
        const uint8_t *p = data + at;
        uint32_t len = get_be32(p);
        if (len > n - at - 12)
            break;
        if (get_be32(p + 8 + len) != crc32_of(p + 4, (size_t)len + 4)) {
            snprintf(err, err_size, "a damaged PNG: the chunk at byte %zu has a wrong CRC", at);
            return false;
        }
        if (memcmp(p + 4, "IEND", 4) == 0)
            return true;
        at += 12 + (size_t)len;
    }
    return fail(err, err_size, "a PNG that is cut short");
}

bool png_read(const uint8_t *data, size_t n, uint8_t **rgba, int *w, int *h, char *err, size_t err_size)
{
    int channels;

    *rgba = NULL;
    if (n < sizeof signature || memcmp(data, signature, sizeof signature) != 0)
        return fail(err, err_size, "not a PNG");
    if (n > INT_MAX)
        return fail(err, err_size, "a PNG that is too large");
    if (!check_chunks(data, n, err, err_size))
        return false;
    if (!stbi_info_from_memory(data, (int)n, w, h, &channels)) {
        snprintf(err, err_size, "a PNG that cannot be read (%s)", stbi_failure_reason());
        return false;
    }
    if (*w > PNG_MAX_SIDE || *h > PNG_MAX_SIDE || (int64_t)*w * *h > PNG_MAX_PIXELS) {
        snprintf(err, err_size, "a PNG of %d x %d pixels is too large", *w, *h);
        return false;
    }
    *rgba = stbi_load_from_memory(data, (int)n, w, h, &channels, 4);
    if (!*rgba)
        snprintf(err, err_size, "a PNG that cannot be read (%s)", stbi_failure_reason());
    return *rgba != NULL;
}
