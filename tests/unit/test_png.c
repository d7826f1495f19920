/* test_png.c - png.h: what is written is read back, the bytes never change, and nothing damaged is taken. */
#include "../test.h"
#include "../../src/base/hash.h"
#include "../../src/base/rng.h"
#include "../../src/player/picture/png.h"

static char err[256];

static void colours(uint32_t rgb[256])
{
    for (uint32_t i = 0; i < 256; i++)
        rgb[i] = (i * 0x010305u + 0x123456u) & 0xffffffu;
}

/* Writes a picture of palette indices and compares what is read with it. */
static void round_trip(int w, int h, int pitch, uint64_t most)
{
    struct rng r;
    uint32_t rgb[256];
    uint8_t *pix = malloc((size_t)pitch * (size_t)h), *file, *rgba;
    size_t size;
    int rw, rh;

    rng_seed(&r, (uint64_t)w);
    colours(rgb);
    for (int i = 0; i < pitch * h; i++)
        pix[i] = (uint8_t)rng_below(&r, most);
    assert_true(png_write(pix, pitch, w, h, rgb, &file, &size));
    assert_true(png_read(file, size, &rgba, &rw, &rh, err, sizeof err));
    assert_int_equal(rw, w);
    assert_int_equal(rh, h);
    for (int y = 0; y < h; y++) {
        for (int x = 0; x < w; x++) {
            const uint8_t *p = rgba + 4 * (y * w + x);
            uint32_t want = rgb[pix[y * pitch + x]];
            assert_int_equal((uint32_t)p[0] << 16 | (uint32_t)p[1] << 8 | p[2], want);
            assert_int_equal(p[3], 255);
        }
    }
    free(rgba);
    free(file);
    free(pix);
}

TEST(round_trip)
{
    round_trip(1, 1, 1, 256);
    round_trip(7, 5, 7, 256);
    round_trip(240, 320, 304, 4);   /* compresses */
    round_trip(240, 320, 304, 256); /* does not */
    round_trip(1024, 3, 1024, 2);
}

TEST(rgb)
{
    uint8_t rgb[5 * 3 * 3], *file, *rgba;
    size_t size;
    int w, h;

    for (size_t i = 0; i < sizeof rgb; i++)
        rgb[i] = (uint8_t)(i * 37);
    assert_true(png_write_rgb(rgb, 5, 3, &file, &size));
    assert_true(png_read(file, size, &rgba, &w, &h, err, sizeof err));
    assert_int_equal(w, 5);
    assert_int_equal(h, 3);
    for (size_t i = 0; i < 15; i++)
        assert_memory_equal(rgba + 4 * i, rgb + 3 * i, 3);
    free(rgba);
    free(file);
}

/* Golden pictures are compared as files too: the same picture is the same bytes with every compiler. */
TEST(same_bytes)
{
    uint32_t rgb[256];
    uint8_t pix[64 * 48], *file;
    size_t size;

    colours(rgb);
    for (int i = 0; i < 64 * 48; i++)
        pix[i] = (uint8_t)((i % 64) * (i / 64) / 16);
    assert_true(png_write(pix, 64, 64, 48, rgb, &file, &size));
    assert_int_equal(size, 2709);
    assert_int_equal(hash_crc32(file, size - 4), 0xd3531fa7);
    free(file);
}

TEST(sizes)
{
    uint32_t rgb[256] = { 0 };
    uint8_t pix[1] = { 0 }, *file;
    size_t size;

    assert_false(png_write(pix, 1, 0, 1, rgb, &file, &size));
    assert_null(file);
    assert_false(png_write(pix, 1, 1, PNG_MAX_SIDE + 1, rgb, &file, &size));
    assert_false(png_write_rgb(pix, -1, 1, &file, &size));
}

static uint8_t *small(size_t *size)
{
    uint32_t rgb[256];
    uint8_t pix[12] = { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 }, *file;

    colours(rgb);
    assert_true(png_write(pix, 4, 4, 3, rgb, &file, size));
    return file;
}

static void refused(const uint8_t *data, size_t n, const char *part)
{
    uint8_t *rgba;
    int w, h;

    err[0] = 0;
    assert_false(png_read(data, n, &rgba, &w, &h, err, sizeof err));
    assert_null(rgba);
    if (!strstr(err, part))
        fail_msg("\"%s\" does not say \"%s\"", err, part);
}

TEST(cut)
{
    size_t size;
    uint8_t *file = small(&size);

    for (size_t n = 0; n < size; n++)
        refused(file, n, n < 8 ? "not a PNG" : "truncated");
    free(file);
}

TEST(damage)
{
    size_t size;
    uint8_t *file = small(&size);

    for (size_t i = 0; i < size; i++) {
        file[i] ^= 1;
        refused(file, size, "PNG");
        file[i] ^= 1;
    }
    file[33 + 8 + 5] ^= 4; /* a colour */
    refused(file, size, "wrong CRC in the chunk at byte 33");
    free(file);
}

static void be32(uint8_t *p, uint32_t v)
{
    for (int i = 0; i < 4; i++)
        p[i] = (uint8_t)(v >> (24 - 8 * i));
}

TEST(huge)
{
    size_t size;
    uint8_t *file = small(&size);

    be32(file + 16, 8192);
    be32(file + 20, 8192);
    be32(file + 29, hash_crc32(file + 12, 17));
    refused(file, size, "the PNG is too large: 8192 x 8192 pixels");
    be32(file + 16, 0xffffffff);
    be32(file + 29, hash_crc32(file + 12, 17));
    refused(file, size, "too large");
    free(file);
}

/* ---- files made here: any kind, any amount of pixel data ---- */

/* zlib's format, not compressed: blocks of up to 65535 bytes as they are. */
static uint8_t *stored(const uint8_t *data, size_t size, size_t *out_size)
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
    be32(p, b << 16 | a);
    *out_size = (size_t)(p + 4 - out);
    return out;
}

struct kind {
    int w, h, bits, colour, interlaced;
};

static uint8_t *put_chunk(uint8_t *p, const char *type, const uint8_t *data, size_t n)
{
    be32(p, (uint32_t)n);
    memcpy(p + 4, type, 4);
    if (n)
        memcpy(p + 8, data, n);
    be32(p + 8 + n, hash_crc32(p + 4, n + 4));
    return p + 12 + n;
}

/* A file whose pixel data is `raw`; colours 0: no palette. */
static uint8_t *make(const struct kind *k, const uint8_t *raw, size_t raw_size, const uint8_t *palette,
                     size_t n_colours, size_t *size)
{
    size_t n;
    uint8_t *packed = stored(raw, raw_size, &n), head[13] = { 0 };
    uint8_t *file = malloc(n + 2048), *p = file;

    memcpy(p, "\x89PNG\r\n\x1a\n", 8);
    be32(head, (uint32_t)k->w);
    be32(head + 4, (uint32_t)k->h);
    head[8] = (uint8_t)k->bits;
    head[9] = (uint8_t)k->colour;
    head[12] = (uint8_t)k->interlaced;
    p = put_chunk(p + 8, "IHDR", head, 13);
    if (n_colours)
        p = put_chunk(p, "PLTE", palette, 3 * n_colours);
    p = put_chunk(p, "IDAT", packed, 0); /* in an empty piece and two more */
    p = put_chunk(p, "IDAT", packed, n / 2);
    p = put_chunk(p, "IDAT", packed + n / 2, n - n / 2);
    p = put_chunk(p, "IEND", NULL, 0);
    free(packed);
    *size = (size_t)(p - file);
    return file;
}

static int channels_of(int colour)
{
    return colour == 2 ? 3 : colour == 4 ? 2 : colour == 6 ? 4 : 1;
}

/* The pass of an interlaced picture that pixel (x, y) is in: the format's own 8 x 8 pattern. */
static int pass_of(int x, int y)
{
    static const char *const pattern[8] = { "16462646", "77777777", "56565656", "77777777",
                                            "36463646", "77777777", "56565656", "77777777" };

    return pattern[y & 7][x & 7] - '0';
}

/* Pixel data of the right size, every row unfiltered and the rest random, counted pixel by pixel. */
static size_t fill(const struct kind *k, struct rng *r, uint8_t *raw)
{
    size_t at = 0;

    for (int pass = 1; pass <= (k->interlaced ? 7 : 1); pass++)
        for (int y = 0; y < k->h; y++) {
            int n = 0;
            for (int x = 0; x < k->w; x++)
                n += !k->interlaced || pass_of(x, y) == pass;
            if (!n)
                continue;
            raw[at++] = 0;
            for (int i = 0; i < (n * k->bits * channels_of(k->colour) + 7) / 8; i++)
                raw[at++] = (uint8_t)rng_next(r);
        }
    return at;
}

TEST(kinds)
{
    static const struct kind kinds[] = {
        { 0, 0, 1, 0, 0 }, { 0, 0, 2, 0, 0 },  { 0, 0, 4, 0, 0 }, { 0, 0, 8, 0, 0 },  { 0, 0, 16, 0, 0 },
        { 0, 0, 8, 2, 0 }, { 0, 0, 16, 2, 0 }, { 0, 0, 1, 3, 0 }, { 0, 0, 2, 3, 0 },  { 0, 0, 4, 3, 0 },
        { 0, 0, 8, 3, 0 }, { 0, 0, 8, 4, 0 },  { 0, 0, 8, 6, 0 }, { 0, 0, 16, 4, 0 }, { 0, 0, 16, 6, 0 },
    };
    static uint8_t raw[64 * 64 * 8 + 4096], palette[768];
    struct rng r;

    rng_seed(&r, 5);
    for (int i = 0; i < 768; i++)
        palette[i] = (uint8_t)rng_next(&r);
    for (int n = 0; n < 15 * 60; n++) {
        struct kind k = kinds[n % 15];
        uint8_t *rgba;
        size_t size;
        int w, h;
        k.w = 1 + (int)rng_below(&r, 40);
        k.h = 1 + (int)rng_below(&r, 40);
        k.interlaced = n / 15 % 2;
        size_t need = fill(&k, &r, raw);
        uint8_t *file = make(&k, raw, need, palette, k.colour == 3 ? (size_t)1 << k.bits : 0, &size);
        if (!png_read(file, size, &rgba, &w, &h, err, sizeof err))
            fail_msg("%dx%d, %d bits, type %d%s: %s", k.w, k.h, k.bits, k.colour, k.interlaced ? ", interlaced" : "",
                     err);
        assert_int_equal(w * 1000 + h, k.w * 1000 + k.h);
        if (k.colour == 3 && k.bits == 8 && !k.interlaced)
            for (int i = 0; i < w * h; i++) {
                const uint8_t *colour = palette + 3 * raw[i / w * (w + 1) + 1 + i % w];
                assert_memory_equal(rgba + 4 * i, colour, 3);
                assert_int_equal(rgba[4 * i + 3], 255);
            }
        free(rgba);
        free(file);
        file = make(&k, raw, need - 1, palette, k.colour == 3 ? (size_t)1 << k.bits : 0, &size);
        refused(file, size, "fewer pixels");
        free(file);
        raw[need] = 0;
        file = make(&k, raw, need + 1, palette, k.colour == 3 ? (size_t)1 << k.bits : 0, &size);
        refused(file, size, "more pixels");
        free(file);
    }
}

/* A pixel whose index is beyond a short palette is named; the last one is no such pixel. */
TEST(short_palette)
{
    const struct kind k = { 3, 2, 8, 3, 0 };
    const uint8_t palette[] = { 9, 8, 7, 6, 5, 4 };
    uint8_t raw[] = { 0, 0, 1, 0, 0, 1, 1, 1 }, *rgba;
    size_t size;
    int w, h;

    uint8_t *file = make(&k, raw, sizeof raw, palette, 2, &size);
    assert_true(png_read(file, size, &rgba, &w, &h, err, sizeof err));
    free(rgba);
    free(file);
    raw[6] = 2;
    file = make(&k, raw, sizeof raw, palette, 2, &size);
    refused(file, size, "pixel 1,1 has palette index 2, but the PNG's palette ends at index 1");
    free(file);
    file = make(&k, raw, sizeof raw, palette, 0, &size);
    refused(file, size, "but no palette");
    free(file);
}

/* Data that inflates to 16 MiB, where the header asks for 68 bytes. */
TEST(bomb)
{
    enum { SIZE = 1 << 24 };
    const struct kind k = { 4, 4, 8, 6, 0 };
    uint8_t *raw = calloc(1, SIZE);
    size_t size;

    uint8_t *file = make(&k, raw, SIZE, NULL, 0, &size);
    free(raw);
    refused(file, size, "more pixels than its header says");
    free(file);
}

RUN_TESTS(NULL, NULL)
