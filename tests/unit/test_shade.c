/* test_shade.c - shade.h: every entry of the tables against a look at all colours, and which ROM they are made for. */
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/workbench/pack/art.h"
#include "../../src/player/picture/shade.h"

static int brightness(const uint8_t *rgb, int i)
{
    return 2 * rgb[3 * i] + 3 * rgb[3 * i + 1] + rgb[3 * i + 2];
}

/* What shade.h promises, word by word. */
static int wanted(const uint8_t *rgb, int entry, int dim, int before)
{
    double least = 1e9;
    int best = before;

    for (int k = 255; k >= 0; k--) {
        double d = 0;
        if ((k > 0 && k % 16 == 0) || brightness(rgb, k) > brightness(rgb, before))
            continue;
        for (int c = 0; c < 3; c++) {
            const double off = rgb[3 * k + c] - rgb[3 * entry + c] * (4 - dim) / 4.0;
            d += off * off;
        }
        if (d <= least) {
            least = d;
            best = k;
        }
    }
    return best;
}

static void check(const uint8_t *rgb)
{
    uint8_t tables[CART_SHADES_SIZE];

    memset(tables, 0xaa, sizeof tables);
    shade_make(rgb, tables);
    for (int i = 0; i < 256; i++) {
        int before = i;
        for (int dim = VIEW_DIM_QUARTER; dim <= VIEW_DIM_MOST; dim++) {
            const int got = tables[(dim - 1) * 256 + i];
            assert_int_equal(got, wanted(rgb, i, dim, before));
            assert_true(brightness(rgb, got) <= brightness(rgb, before));
            before = got;
        }
    }
}

TEST(tables)
{
    uint8_t rgb[CART_PALETTE_SIZE];
    struct rng r;

    art_default_palette(rgb);
    check(rgb);
    rng_seed(&r, 8);
    for (int round = 0; round < 12; round++) {
        for (int i = 0; i < CART_PALETTE_SIZE; i++)
            rgb[i] = (uint8_t)(rng_next(&r) >> (round % 3 ? 56 : 59)); /* or all in one corner */
        if (round > 8)
            memset(rgb, round == 9 ? 0 : 255, CART_PALETTE_SIZE / 2);
        check(rgb);
    }
}

/* A ROM without the lump gets tables, made once a palette; one that has it none. */
TEST(kept)
{
    static uint8_t manifest[MANIFEST_BYTES], bytes[8192], want[CART_SHADES_SIZE];
    uint8_t rgb[CART_PALETTE_SIZE];
    struct shade_cache kept = { 0 };
    struct cart cart;
    struct manifest m;
    struct rom rom;
    char err[256];

    art_default_palette(rgb);
    manifest_set_defaults(&m);
    const uint32_t manifest_size = manifest_pack(&m, manifest);
    for (int with = 0; with < 3; with++) {
        struct lump lumps[] = { { "manifest", manifest, manifest_size },
                                { "palette/main", rgb, sizeof rgb },
                                { "script/main.lua", (const uint8_t *)"", 0 },
                                { "shades", want, CART_SHADES_SIZE } };
        rgb[33] ^= (uint8_t)(with == 1);
        const int n = with == 2 ? 4 : 3;
        assert_true(rom_write_size(lumps, n) <= sizeof bytes);
        rom_write(bytes, lumps, n);
        assert_true(rom_open(&rom, bytes, rom_write_size(lumps, n), err, sizeof err));
        assert_true(cart_open(&cart, &rom, err, sizeof err));
        assert_int_equal(cart.main_tables.shades != NULL, with == 2);
        const uint8_t *got = shade_get_tables(&kept, &cart);
        assert_ptr_equal(got, with == 2 ? NULL : kept.tables);
        shade_make(rgb, want);
        assert_true(with == 2 || memcmp(got, want, CART_SHADES_SIZE) == 0);
        kept.tables[5] ^= (uint8_t)(with == 0);
        assert_true(with > 0 || shade_get_tables(&kept, &cart)[5] == (want[5] ^ 1)); /* not made again */
    }
}

RUN_TESTS(NULL, NULL)
