/*
 * png.c - see png.h. Chunks are ours, compression and the pixel formats are stb's.
 *
 * stb trusts a file more than we do, so it sees only what has been looked at: the chunks with their CRCs, and pixel
 * data that inflates to just what the header asks for, into memory of that size. It reads colours beyond the end of a
 * short palette, so a picture of palette indices is given to it with a palette of grey i for index i, and looked up
 * here.
 */
#include "png.h"

#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../base/hash.h"

enum { STB_MOST = 512 << 20 }; /* bytes in one piece */

/* What stb's reader holds. It forgets some of it when memory is short, so what is left after a failure is freed here.
 * One picture is read at a time. */
static struct {
    void *piece[8];
    bool shortage; /* a piece was refused */
} reading;

static void *hold(void *old, size_t n)
{
    enum { SLOTS = sizeof reading.piece / sizeof reading.piece[0] };
    int i = 0;

    while (i < SLOTS && reading.piece[i] != old)
        i++;
    void *p = i < SLOTS && n <= STB_MOST ? realloc(old, n ? n : 1) : NULL;
    if (p)
        reading.piece[i] = p;
    else
        reading.shortage = true;
    return p;
}

static void let_go(const void *p)
{
    for (size_t i = 0; p && i < sizeof reading.piece / sizeof reading.piece[0]; i++)
        if (reading.piece[i] == p)
            reading.piece[i] = NULL;
}

static void release(void *p)
{
    let_go(p);
    free(p);
}

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_MALLOC(n)      hold(NULL, n)
#define STBI_REALLOC(p, n)  hold(p, n)
#define STBI_FREE(p)        release(p)
#define STBI_MAX_DIMENSIONS PNG_MAX_SIDE

/* What stb's compressor takes, which cannot say that memory is short: then it is left by a jump. A piece is given back
 * when all are. One picture is written at a time. */
struct piece {
    _Alignas(16) struct piece *next;
};
static struct {
    struct piece *first;
    jmp_buf full;
} compressing;

static void *piece_take(size_t n)
{
    struct piece *p = n <= STB_MOST ? malloc(sizeof *p + n) : NULL;

    if (!p)
        longjmp(compressing.full, 1);
    p->next = compressing.first;
    compressing.first = p;
    return p + 1;
}

static void *piece_grow(void *old, size_t had, size_t n)
{
    void *p = piece_take(n);

    if (old)
        memcpy(p, old, had < n ? had : n);
    return p;
}

static void pieces_free(void)
{
    while (compressing.first) {
        struct piece *p = compressing.first;
        compressing.first = p->next;
        free(p);
    }
}

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STBIW_MALLOC(n)                piece_take(n)
#define STBIW_REALLOC_SIZED(p, had, n) piece_grow(p, had, n)
#define STBIW_FREE(p)                  ((void)(p))
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
    return png_chunk(p, "PLTE", colours, sizeof colours);
}

static const uint8_t author[] = "Software\0Curtain"; /* without the last byte: the data of a tEXt */

enum { AUTHOR = sizeof author - 1, AFTER_HEAD = 8 + 12 + 13 /* bytes of the signature and IHDR */ };

static size_t assemble(uint8_t *out, const struct pixels *pic, const uint8_t *packed, uint32_t n)
{
    uint8_t head[13] = { 0 }, *p = out;

    png_be32(head, (uint32_t)pic->w);
    png_be32(head + 4, (uint32_t)pic->h);
    head[8] = 8;                    /* bits */
    head[9] = pic->palette ? 3 : 2; /* palette or RGB */
    memcpy(p, signature, sizeof signature);
    p = png_chunk(p + sizeof signature, "IHDR", head, sizeof head);
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
    if (n > STB_MOST)
        return false;
    if (setjmp(compressing.full) == 0) {
        packed = stbi_zlib_compress(raw, (int)n, &packed_size, 8);
        *size = (size_t)packed_size;
        *out = malloc(*size);
        if (*out)
            memcpy(*out, packed, *size);
    }
    pieces_free();
    return *out != NULL;
}

/* The whole file of rows of raw bytes; NULL: out of memory. */
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
    if ((stride + 1) * (size_t)pic->h > STB_MOST)
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

bool png_is_signed(const uint8_t *head, size_t n)
{
    const size_t data = AFTER_HEAD + 8;

    return n >= data + AUTHOR && memcmp(head, signature, sizeof signature) == 0 &&
           memcmp(head + data - 4, "tEXt", 4) == 0 && memcmp(head + data, author, AUTHOR) == 0;
}

/* ---- reading ---- */

/* What a file says, once its chunks have been walked. */
struct layout {
    uint32_t w, h, bits, colour, interlaced; /* colour: PNG's type, 0 2 3 4 6 */
    const uint8_t *palette, *opacity;        /* of PLTE and tRNS; NULL: none */
    uint32_t colours, opacities;
    size_t pixels; /* bytes in all IDAT */
};

static void note(struct layout *l, const uint8_t *type, const uint8_t *data, uint32_t n)
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

/* Are the chunks whole and undamaged up to IEND? */
static bool walk_chunks(const uint8_t *data, size_t n, struct layout *l, char *err, size_t err_size)
{
    size_t at = sizeof signature;

    while (n - at >= 12) {
        const uint8_t *p = data + at;
        uint32_t len = get_be32(p);
        if (len > n - at - 12)
            break;
        if (get_be32(p + 8 + len) != hash_crc32(p + 4, (size_t)len + 4)) {
            snprintf(err, err_size, "damaged PNG: wrong CRC in the chunk at byte %zu", at);
            return false;
        }
        note(l, p + 4, p + 8, len);
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
    if (l->w > PNG_MAX_SIDE || l->h > PNG_MAX_SIDE || (uint64_t)l->w * l->h > PNG_MAX_PIXELS) {
        snprintf(err, err_size, "the PNG is too large: %lu x %lu pixels", (unsigned long)l->w, (unsigned long)l->h);
        return false;
    }
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

/* Bytes of rows of w x h pixels, each with the byte of its filter. */
static size_t rows_size(const struct layout *l, uint32_t w, uint32_t h)
{
    static const uint8_t channels[7] = { 1, 0, 3, 1, 2, 0, 4 };

    return w && h ? (size_t)h * (1 + ((size_t)w * channels[l->colour] * l->bits + 7) / 8) : 0;
}

/* Bytes the pixel data inflates to. An interlaced picture is seven, each of every dx-th pixel in every dy-th row
 * from (x, y). */
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

/* The data of all IDAT on end. The chunks have been walked. */
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

/* Does the pixel data inflate to what the header asks for? */
static bool check_pixels(const struct layout *l, const uint8_t *packed, char *err, size_t err_size)
{
    size_t size = inflated_size(l);
    uint8_t *room = malloc(size + 1);

    if (!room)
        return result_set_host_error(err, err_size, "out of memory");
    /* a byte more, so that data of just the size does not look like too much */
    int n = stbi_zlib_decode_buffer((char *)room, (int)size + 1, (const char *)packed, (int)l->pixels);
    free(room);
    if (n >= 0 && (size_t)n == size)
        return true;
    if (n >= 0 && (size_t)n < size)
        return err_set(err, err_size, "the PNG has fewer pixels than its header says");
    if (n >= 0 || !strcmp(stbi_failure_reason(), "output buffer limit"))
        return err_set(err, err_size, "the PNG has more pixels than its header says");
    snprintf(err, err_size, "cannot read the PNG (%s)", stbi_failure_reason());
    return false;
}

/* The same picture with all its data in one chunk, and nothing that stb need not know: of indices with grey i for index
 * i. (stb's reader cannot take an empty chunk of data before the others.) */
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

/* Greys to the palette's colours; the indices go to `index`, if it is not NULL. */
static bool look_up(const struct layout *l, uint8_t *rgba, uint8_t *index_of, char *err, size_t err_size)
{
    for (size_t i = 0; i < (size_t)l->w * l->h; i++, rgba += 4) {
        uint32_t index = rgba[0];
        if (index >= l->colours) {
            snprintf(err, err_size, "pixel %lu,%lu has palette index %u, but the PNG's palette ends at index %u",
                     (unsigned long)(i % l->w), (unsigned long)(i / l->w), index, l->colours - 1);
            return false;
        }
        if (index_of)
            index_of[i] = (uint8_t)index;
        memcpy(rgba, l->palette + 3 * index, 3);
        rgba[3] = index < l->opacities ? l->opacity[index] : 255;
    }
    return true;
}

static uint8_t *decode(const uint8_t *data, size_t n, char *err, size_t err_size)
{
    int w, h, channels;

    reading.shortage = false;
    uint8_t *rgba = stbi_load_from_memory(data, (int)n, &w, &h, &channels, 4);
    let_go(rgba);
    for (size_t i = 0; i < sizeof reading.piece / sizeof reading.piece[0]; i++)
        release(reading.piece[i]);
    if (rgba)
        return rgba;
    if (reading.shortage)
        result_set_host_error(err, err_size, "out of memory");
    else
        snprintf(err, err_size, "cannot read the PNG (%s)", stbi_failure_reason());
    return NULL;
}

static uint8_t *decode_plain(const uint8_t *data, const struct layout *l, const uint8_t *packed, uint8_t *index,
                             char *err, size_t err_size)
{
    size_t size;
    uint8_t *file = plain_file(data, l, packed, &size), *rgba;

    if (!file) {
        result_set_host_error(err, err_size, "out of memory");
        return NULL;
    }
    rgba = decode(file, size, err, err_size);
    free(file);
    if (rgba && l->colour == 3 && !look_up(l, rgba, index, err, err_size)) {
        free(rgba);
        return NULL;
    }
    return rgba;
}

/* Reads what `packed` inflates to; the indices, if there are any and they are asked for, into *index. */
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
