/*
 * png.c - reads and writes PNG files (png.h). This file handles the chunks; stb compresses and converts pixels.
 *
 * stb does not validate files, so it only gets data that was checked here: chunks with correct CRCs, and pixel data
 * that inflates to exactly the size that the header implies. stb reads beyond the end of a short palette, so it gets
 * pictures of palette indices with a palette in which colour i is grey i; the colours are then looked up here.
 */
#include "png.h"

#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../base/hash.h"

enum { MAX_BLOCK = 512 << 20 /* bytes in one block of stb's memory */ };

/* stb's memory. When memory runs short, stb's reader forgets some blocks and its compressor cannot fail, so allocate
 * then jumps out of stb, and the blocks are freed together. One picture is read or written at a time. */
struct block {
    _Alignas(16) struct block *next;
};
static struct {
    struct block *first;
    jmp_buf out_of_memory;
} blocks;

static void *allocate(size_t n)
{
    struct block *b = n <= MAX_BLOCK ? malloc(sizeof *b + n) : NULL;

    if (!b)
        longjmp(blocks.out_of_memory, 1);
    b->next = blocks.first;
    blocks.first = b;
    return b + 1;
}

static void *reallocate(void *old, size_t old_size, size_t n)
{
    void *p = allocate(n);

    if (old)
        memcpy(p, old, old_size < n ? old_size : n);
    return p;
}

static void free_blocks(void)
{
    while (blocks.first) {
        struct block *b = blocks.first;
        blocks.first = b->next;
        free(b);
    }
}

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_MAX_DIMENSIONS                PNG_MAX_SIDE
#define STBI_MALLOC(n)                     allocate(n)
#define STBI_REALLOC_SIZED(p, old_size, n) reallocate(p, old_size, n)
#define STBI_FREE(p)                       ((void)(p))

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STBIW_MALLOC(n)                     allocate(n)
#define STBIW_REALLOC_SIZED(p, old_size, n) reallocate(p, old_size, n)
#define STBIW_FREE(p)                       ((void)(p))
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

static const uint8_t signature[8] = { 137, 'P', 'N', 'G', 13, 10, 26, 10 };

void png_be32(uint8_t *p, uint32_t v)
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

uint8_t *png_chunk(uint8_t *p, const char type[4], const uint8_t *data, uint32_t n)
{
    png_be32(p, n);
    memcpy(p + 4, type, 4);
    if (n)
        memcpy(p + 8, data, n);
    png_be32(p + 8 + n, hash_crc32(p + 4, n + 4));
    return p + 12 + n;
}

/* Returns the rows as the file stores them: each is a filter byte (0: none) and n bytes. NULL: out of memory. */
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
    int w, h, bytes;         /* bytes per pixel: 1, 3 or 4 */
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
    return png_chunk(p, "PLTE", colours, sizeof colours);
}

static const uint8_t author[] = "Software\0Curtain"; /* without the last byte: the data of a tEXt */

enum { AUTHOR = sizeof author - 1, AFTER_HEAD = 8 + 12 + 13 /* bytes of the signature and IHDR */ };

static size_t assemble(uint8_t *out, const struct pixels *pic, const uint8_t *packed, uint32_t n)
{
    uint8_t head[13] = { 0 }, *p = out;

    png_be32(head, (uint32_t)pic->w);
    png_be32(head + 4, (uint32_t)pic->h);
    head[8] = 8;                                          /* bits */
    head[9] = pic->palette ? 3 : pic->bytes == 4 ? 6 : 2; /* palette, RGBA or RGB */
    memcpy(p, signature, sizeof signature);
    p = png_chunk(p + sizeof signature, "IHDR", head, sizeof head);
    if (pic->bytes < 4)
        p = png_chunk(p, "tEXt", author, AUTHOR);
    if (pic->palette)
        p = palette_chunk(p, pic->palette);
    p = png_chunk(p, "IDAT", packed, n);
    p = png_chunk(p, "IEND", NULL, 0);
    return (size_t)(p - out);
}

bool png_deflate(uint8_t *raw, size_t n, uint8_t **out, size_t *size)
{
    int packed_size = 0;
    uint8_t *packed;

    *out = NULL;
    if (n > MAX_BLOCK)
        return false;
    if (setjmp(blocks.out_of_memory) == 0) {
        packed = stbi_zlib_compress(raw, (int)n, &packed_size, 8);
        *size = (size_t)packed_size;
        *out = malloc(*size);
        if (*out)
            memcpy(*out, packed, *size);
    }
    free_blocks();
    return *out != NULL;
}

/* Returns the complete file for the raw rows, or NULL when out of memory. */
static uint8_t *compressed_file(const struct pixels *pic, uint8_t *raw, size_t raw_size, size_t *size)
{
    size_t n;
    uint8_t *packed, *out = NULL;

    if (!png_deflate(raw, raw_size, &packed, &n))
        return NULL;
    out = malloc(sizeof signature + 5 * 12 + 13 + AUTHOR + 768 + n);
    if (out)
        *size = assemble(out, pic, packed, (uint32_t)n);
    free(packed);
    return out;
}

static bool write_picture(const struct pixels *pic, uint8_t **out, size_t *size)
{
    *out = NULL;
    if (pic->w < 1 || pic->h < 1 || pic->w > PNG_MAX_SIDE || pic->h > PNG_MAX_SIDE)
        return false;
    size_t stride = (size_t)pic->w * (size_t)pic->bytes;
    if ((stride + 1) * (size_t)pic->h > MAX_BLOCK)
        return false;
    uint8_t *raw = rows(pic->from, pic->pitch, stride, pic->h);
    if (raw)
        *out = compressed_file(pic, raw, (stride + 1) * (size_t)pic->h, size);
    free(raw);
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

bool png_write_rgba(const uint8_t *rgba, int w, int h, uint8_t **out, size_t *size)
{
    return write_picture(&(struct pixels){ rgba, (ptrdiff_t)w * 4, w, h, 4, NULL }, out, size);
}

bool png_is_signed(const uint8_t *head, size_t n)
{
    const size_t data = AFTER_HEAD + 8;

    return n >= data + AUTHOR && memcmp(head, signature, sizeof signature) == 0 &&
           memcmp(head + data - 4, "tEXt", 4) == 0 && memcmp(head + data, author, AUTHOR) == 0;
}

/* ---- reading ---- */

/* The contents of a file, filled in by read_header and walk_chunks. */
struct layout {
    uint32_t w, h, bits, colour, interlaced; /* colour: PNG's colour type, 0, 2, 3, 4 or 6 */
    const uint8_t *palette, *opacity;        /* of PLTE and tRNS; NULL: none */
    uint32_t colours, opacities;
    size_t pixels; /* bytes in all IDAT */
};

static void record_chunk(struct layout *l, const uint8_t *type, const uint8_t *data, uint32_t n)
{
    if (memcmp(type, "PLTE", 4) == 0) {
        l->palette = data;
        l->colours = n / 3;
    } else if (memcmp(type, "tRNS", 4) == 0) {
        l->opacity = data;
        l->opacities = n;
    } else if (memcmp(type, "IDAT", 4) == 0)
        l->pixels += n;
}

/* Checks that the chunks up to IEND are complete and undamaged. */
static bool walk_chunks(const uint8_t *data, size_t n, struct layout *l, char *err, size_t err_size)
{
    size_t at = sizeof signature;

    while (n - at >= 12) {
        const uint8_t *p = data + at;
        uint32_t len = get_be32(p);
        if (len > n - at - 12)
            break;
        if (get_be32(p + 8 + len) != hash_crc32(p + 4, (size_t)len + 4))
            return err_set(err, err_size, "damaged PNG: wrong CRC in the chunk at byte %zu", at);
        record_chunk(l, p + 4, p + 8, len);
        if (memcmp(p + 4, "IEND", 4) == 0)
            return true;
        at += 12 + (size_t)len;
    }
    return err_set(err, err_size, "truncated PNG");
}

static bool read_header(const uint8_t *data, size_t n, struct layout *l, char *err, size_t err_size)
{
    static const uint8_t depths[7] = { 1 | 2 | 4 | 8 | 16, 0, 8 | 16, 1 | 2 | 4 | 8, 8 | 16, 0, 8 | 16 };
    const uint8_t *p = data + sizeof signature;

    if (n < sizeof signature + 25)
        return err_set(err, err_size, "truncated PNG");
    if (get_be32(p) != 13 || memcmp(p + 4, "IHDR", 4) != 0)
        return err_set(err, err_size, "the PNG has no header");
    *l = (struct layout){ get_be32(p + 8), get_be32(p + 12), p[16], p[17], p[20], NULL, NULL, 0, 0, 0 };
    if (l->colour > 6 || l->bits > 16 || !(depths[l->colour] & l->bits) || (l->bits & (l->bits - 1)) || p[18] ||
        p[19] || l->interlaced > 1)
        return err_set(err, err_size, "the PNG has an unknown colour type or depth");
    if (l->w == 0 || l->h == 0)
        return err_set(err, err_size, "the PNG has no pixels");
    if (l->w > PNG_MAX_SIDE || l->h > PNG_MAX_SIDE || (uint64_t)l->w * l->h > PNG_MAX_PIXELS)
        return err_set(err, err_size, "the PNG is too large: %lu x %lu pixels", (unsigned long)l->w,
                       (unsigned long)l->h);
    return true;
}

static bool check_palette(const struct layout *l, char *err, size_t err_size)
{
    if (l->colour != 3)
        return true;
    if (!l->palette)
        return err_set(err, err_size, "the PNG has palette indices but no palette");
    if (l->colours < 1 || l->colours > 256 || get_be32(l->palette - 8) % 3 != 0)
        return err_set(err, err_size, "the PNG has a damaged palette");
    if (l->opacities > l->colours)
        return err_set(err, err_size, "the PNG has more alpha values than colours");
    return true;
}

/* Returns the bytes of h rows of w pixels, including the filter bytes. */
static size_t rows_size(const struct layout *l, uint32_t w, uint32_t h)
{
    static const uint8_t channels[7] = { 1, 0, 3, 1, 2, 0, 4 };

    return w && h ? (size_t)h * (1 + ((size_t)w * channels[l->colour] * l->bits + 7) / 8) : 0;
}

/* Returns the bytes that the pixel data inflates to. An interlaced picture consists of seven pictures, each with every
 * dx-th pixel of every dy-th row from (x, y). */
static size_t inflated_size(const struct layout *l)
{
    static const uint8_t x[7] = { 0, 4, 0, 2, 0, 1, 0 }, y[7] = { 0, 0, 4, 0, 2, 0, 1 };
    static const uint8_t dx[7] = { 8, 8, 4, 4, 2, 2, 1 }, dy[7] = { 8, 8, 8, 4, 4, 2, 2 };
    size_t size = 0;

    if (!l->interlaced)
        return rows_size(l, l->w, l->h);
    for (int i = 0; i < 7; i++)
        size += rows_size(l, (l->w + dx[i] - 1u - x[i]) / dx[i], (l->h + dy[i] - 1u - y[i]) / dy[i]);
    return size;
}

/* Returns the concatenated data of all IDAT chunks, or NULL when out of memory. Call walk_chunks first. */
static uint8_t *join_pixels(const uint8_t *data, const struct layout *l)
{
    uint8_t *all = malloc(l->pixels ? l->pixels : 1), *to = all;

    for (const uint8_t *p = data + sizeof signature; all && memcmp(p + 4, "IEND", 4) != 0; p += 12 + get_be32(p))
        if (memcmp(p + 4, "IDAT", 4) == 0) {
            memcpy(to, p + 8, get_be32(p));
            to += get_be32(p);
        }
    return all;
}

/* Checks that the pixel data inflates to the size that the header implies. */
static bool check_pixels(const struct layout *l, const uint8_t *packed, char *err, size_t err_size)
{
    size_t size = inflated_size(l);
    uint8_t *room = malloc(size + 1);

    if (!room)
        return result_set_host_error(err, err_size, "out of memory");
    /* one more byte, because stb reports an overflow when the buffer is exactly full */
    int n = stbi_zlib_decode_buffer((char *)room, (int)size + 1, (const char *)packed, (int)l->pixels);
    free(room);
    if (n >= 0 && (size_t)n == size)
        return true;
    if (n >= 0 && (size_t)n < size)
        return err_set(err, err_size, "the PNG has fewer pixels than its header says");
    if (n >= 0 || !strcmp(stbi_failure_reason(), "output buffer limit"))
        return err_set(err, err_size, "the PNG has more pixels than its header says");
    return err_set(err, err_size, "cannot read the PNG (%s)", stbi_failure_reason());
}

/* Returns a file for stb with the same picture: one IDAT chunk, because stb's reader fails on an empty first one, and
 * only the chunks that stb needs. Palette colour i is grey i. */
static uint8_t *plain_file(const uint8_t *data, const struct layout *l, const uint8_t *packed, size_t *size)
{
    uint32_t greys[256], opacities = l->colour == 3 ? 0 : l->opacities;
    uint8_t *file = malloc(sizeof signature + 5 * 12 + 13 + 768 + opacities + l->pixels), *p = file;

    if (!file)
        return NULL;
    for (uint32_t i = 0; i < 256; i++)
        greys[i] = i * 0x010101u;
    memcpy(p, signature, sizeof signature);
    p = png_chunk(p + sizeof signature, "IHDR", data + sizeof signature + 8, 13);
    if (l->colour == 3)
        p = palette_chunk(p, greys);
    else if (l->opacity)
        p = png_chunk(p, "tRNS", l->opacity, opacities);
    p = png_chunk(p, "IDAT", packed, (uint32_t)l->pixels);
    p = png_chunk(p, "IEND", NULL, 0);
    *size = (size_t)(p - file);
    return file;
}

/* Replaces greys with the palette's colours, and stores the indices in index_of unless it is NULL. */
static bool look_up(const struct layout *l, uint8_t *rgba, uint8_t *index_of, char *err, size_t err_size)
{
    for (size_t i = 0; i < (size_t)l->w * l->h; i++, rgba += 4) {
        uint32_t index = rgba[0];
        if (index >= l->colours)
            return err_set(err, err_size, "pixel %lu,%lu has palette index %u, but the PNG's palette ends at index %u",
                           (unsigned long)(i % l->w), (unsigned long)(i / l->w), index, l->colours - 1);
        if (index_of)
            index_of[i] = (uint8_t)index;
        memcpy(rgba, l->palette + 3 * index, 3);
        rgba[3] = index < l->opacities ? l->opacity[index] : 255;
    }
    return true;
}

static bool decode(const uint8_t *file, size_t n, uint8_t *rgba, size_t size, char *err, size_t err_size)
{
    int w, h, channels;

    if (setjmp(blocks.out_of_memory))
        return result_set_host_error(err, err_size, "out of memory");
    const uint8_t *decoded = stbi_load_from_memory(file, (int)n, &w, &h, &channels, 4);
    if (!decoded)
        return err_set(err, err_size, "cannot read the PNG (%s)", stbi_failure_reason());
    memcpy(rgba, decoded, size);
    return true;
}

static uint8_t *decode_plain(const uint8_t *data, const struct layout *l, const uint8_t *packed, uint8_t *index,
                             char *err, size_t err_size)
{
    const size_t rgba_size = (size_t)l->w * l->h * 4;
    size_t size;
    uint8_t *file = plain_file(data, l, packed, &size), *rgba = malloc(rgba_size);
    bool good = file && rgba ? decode(file, size, rgba, rgba_size, err, err_size)
                             : result_set_host_error(err, err_size, "out of memory");

    free_blocks();
    free(file);
    if (good && (l->colour != 3 || look_up(l, rgba, index, err, err_size)))
        return rgba;
    free(rgba);
    return NULL;
}

/* Decodes the pixels. Stores palette indices in *index unless index is NULL or the picture has none. */
static uint8_t *read_pixels(const uint8_t *data, const struct layout *l, const uint8_t *packed, uint8_t **index,
                            char *err, size_t err_size)
{
    uint8_t *rgba;

    if (!check_pixels(l, packed, err, err_size))
        return NULL;
    if (index && l->colour == 3 && !(*index = malloc((size_t)l->w * l->h))) {
        result_set_host_error(err, err_size, "out of memory");
        return NULL;
    }
    rgba = decode_plain(data, l, packed, index ? *index : NULL, err, err_size);
    if (!rgba && index) {
        free(*index);
        *index = NULL;
    }
    return rgba;
}

bool png_read_indexed(const uint8_t *data, size_t n, uint8_t **rgba, uint8_t **index, int *w, int *h, char *err,
                      size_t err_size)
{
    struct layout l;

    *rgba = NULL;
    if (index)
        *index = NULL;
    if (n < sizeof signature || memcmp(data, signature, sizeof signature) != 0)
        return err_set(err, err_size, "not a PNG");
    if (n > PNG_MAX_BYTES)
        return err_set(err, err_size, "the PNG is too large");
    if (!read_header(data, n, &l, err, err_size) || !walk_chunks(data, n, &l, err, err_size) ||
        !check_palette(&l, err, err_size))
        return false;
    uint8_t *packed = join_pixels(data, &l);
    if (!packed)
        return result_set_host_error(err, err_size, "out of memory");
    *rgba = read_pixels(data, &l, packed, index, err, err_size);
    free(packed);
    *w = (int)l.w;
    *h = (int)l.h;
    return *rgba != NULL;
}

bool png_read(const uint8_t *data, size_t n, uint8_t **rgba, int *w, int *h, char *err, size_t err_size)
{
    return png_read_indexed(data, n, rgba, NULL, w, h, err, err_size);
}

bool png_inflate(const uint8_t *packed, size_t n, uint8_t *out, size_t size)
{
    return n <= INT32_MAX && size < INT32_MAX &&
           stbi_zlib_decode_buffer((char *)out, (int)size + 1, (const char *)packed, (int)n) == (int)size;
}
