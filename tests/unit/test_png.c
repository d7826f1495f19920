/* test_png.c - png.h: what is written is read back, the bytes never change, and nothing damaged is taken. */
#include "../test.h"
#include "../../src/base/hash.h"
#include "../../src/base/rng.h"
#include "../../src/player/picture/png.h"
#include "png_file.h"

static char err[256];

static void colours(uint32_t rgb[256])
{
    for (uint32_t i = 0; i < 256; i++)
        rgb[i] = (i * 0x010305u + 0x123456u) & 0xffffffu;
}

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
    for (int i = 0; i < w * h; i++) {
        const uint8_t *p = rgba + 4 * i;
        assert_int_equal(p[0] << 16 | p[1] << 8 | p[2], rgb[pix[i / w * pitch + i % w]]);
        assert_int_equal(p[3], 255);
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

TEST(huge)
{
    uint32_t rgb[256] = { 0 };
    uint8_t pix[1] = { 0 }, *written;
    size_t size;
    uint8_t *file = small(&size);

    png_put32(file + 16, 8192);
    png_put32(file + 20, 8192);
    png_put32(file + 29, hash_crc32(file + 12, 17));
    refused(file, size, "the PNG is too large: 8192 x 8192 pixels");
    png_put32(file + 16, 0xffffffff);
    png_put32(file + 29, hash_crc32(file + 12, 17));
    refused(file, size, "too large");
    free(file);
    assert_false(png_write(pix, 1, 1, PNG_MAX_SIDE + 1, rgb, &written, &size));
    assert_null(written);
}

/* ---- files of any kind, with any amount of pixel data ---- */

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
static size_t fill(const struct png_kind *k, struct rng *r, uint8_t *raw)
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
    static const struct png_kind kinds[] = {
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
        struct png_kind k = kinds[n % 15];
        uint8_t *rgba;
        size_t size;
        int w, h;
        k.w = 1 + (int)rng_below(&r, 40);
        k.h = 1 + (int)rng_below(&r, 40);
        k.interlaced = n / 15 % 2;
        size_t need = fill(&k, &r, raw);
        uint8_t *file = png_file(&k, raw, need, palette, k.colour == 3 ? (size_t)1 << k.bits : 0, &size);
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
        file = png_file(&k, raw, need - 1, palette, k.colour == 3 ? (size_t)1 << k.bits : 0, &size);
        refused(file, size, "fewer pixels");
        free(file);
        raw[need] = 0;
        file = png_file(&k, raw, need + 1, palette, k.colour == 3 ? (size_t)1 << k.bits : 0, &size);
        refused(file, size, "more pixels");
        free(file);
    }
}

/* A pixel whose index is beyond a short palette is named; the last one is no such pixel. */
TEST(short_palette)
{
    const struct png_kind k = { 3, 2, 8, 3, 0 };
    const uint8_t palette[] = { 9, 8, 7, 6, 5, 4 };
    uint8_t raw[] = { 0, 0, 1, 0, 0, 1, 1, 1 }, *rgba;
    size_t size;
    int w, h;

    uint8_t *file = png_file(&k, raw, sizeof raw, palette, 2, &size);
    assert_true(png_read(file, size, &rgba, &w, &h, err, sizeof err));
    free(rgba);
    free(file);
    raw[6] = 2;
    file = png_file(&k, raw, sizeof raw, palette, 2, &size);
    refused(file, size, "pixel 1,1 has palette index 2, but the PNG's palette ends at index 1");
    free(file);
    file = png_file(&k, raw, sizeof raw, palette, 0, &size);
    refused(file, size, "but no palette");
    free(file);
}

RUN_TESTS(NULL, NULL)
