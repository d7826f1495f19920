/* test_png.c - png.h: what is written is read back, the bytes never change, and nothing damaged is taken. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../src/base/hash.h"
#include "../../src/base/rng.h"
#include "../../src/cab/png.h"

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

static void test_round_trip(void **state)
{
    (void)state;
    round_trip(1, 1, 1, 256);
    round_trip(7, 5, 7, 256);
    round_trip(240, 320, 304, 4);   /* compresses */
    round_trip(240, 320, 304, 256); /* does not */
    round_trip(1024, 3, 1024, 2);
}

static void test_rgb(void **state)
{
    uint8_t rgb[5 * 3 * 3], *file, *rgba;
    size_t size;
    int w, h;

    (void)state;
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
static void test_same_bytes(void **state)
{
    uint32_t rgb[256];
    uint8_t pix[64 * 48], *file;
    size_t size;

    (void)state;
    colours(rgb);
    for (int i = 0; i < 64 * 48; i++)
        pix[i] = (uint8_t)((i % 64) * (i / 64) / 16);
    assert_true(png_write(pix, 64, 64, 48, rgb, &file, &size));
    assert_int_equal(size, 2681);
    assert_int_equal(crc32_of(file, size - 4), 0x90537568);
    free(file);
}

static void test_sizes(void **state)
{
    uint32_t rgb[256] = { 0 };
    uint8_t pix[1] = { 0 }, *file;
    size_t size;

    (void)state;
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

static void test_cut(void **state)
{
    size_t size;
    uint8_t *file = small(&size);

    (void)state;
    for (size_t n = 0; n < size; n++)
        refused(file, n, n < 8 ? "not a PNG" : "cut short");
    free(file);
}

static void test_damage(void **state)
{
    size_t size;
    uint8_t *file = small(&size);

    (void)state;
    for (size_t i = 0; i < size; i++) {
        file[i] ^= 1;
        refused(file, size, "PNG");
        file[i] ^= 1;
    }
    file[33 + 8 + 5] ^= 4; /* a colour */
    refused(file, size, "byte 33 has a wrong CRC");
    free(file);
}

static void be32(uint8_t *p, uint32_t v)
{
    for (int i = 0; i < 4; i++)
        p[i] = (uint8_t)(v >> (24 - 8 * i));
}

static void test_huge(void **state)
{
    size_t size;
    uint8_t *file = small(&size);

    (void)state;
    be32(file + 16, 8192);
    be32(file + 20, 8192);
    be32(file + 29, crc32_of(file + 12, 17));
    refused(file, size, "8192 x 8192 pixels is too large");
    be32(file + 16, 0xffffffff);
    be32(file + 29, crc32_of(file + 12, 17));
    refused(file, size, "cannot be read");
    free(file);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_trip), cmocka_unit_test(test_rgb), cmocka_unit_test(test_same_bytes),
        cmocka_unit_test(test_sizes),      cmocka_unit_test(test_cut), cmocka_unit_test(test_damage),
        cmocka_unit_test(test_huge),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
