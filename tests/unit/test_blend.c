/* test_blend.c - blend.h: every entry of a table against a look at all colours. */
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/workbench/pack/art.h"
#include "../../src/workbench/pack/blend.h"

static uint8_t table[CART_BLEND_SIZE];

/* What blend.h promises, word by word. */
static int wanted(const uint8_t *rgb, int under, int over, int mix)
{
    int best = -1, least = 0, c[3];

    for (int i = 0; i < 3; i++) {
        int u = rgb[3 * under + i], o = rgb[3 * over + i];
        c[i] = mix ? (u * (100 - mix) + o * mix + 50) / 100 : u + o > 255 ? 255 : u + o;
    }
    for (int k = 0; k < 256; k++) {
        int d = 0;
        if (k > 0 && k % 16 == 0)
            continue;
        for (int i = 0; i < 3; i++)
            d += (c[i] - rgb[3 * k + i]) * (c[i] - rgb[3 * k + i]);
        if (best < 0 || d < least) {
            best = k;
            least = d;
        }
    }
    return best;
}

static void check(const uint8_t *rgb, int mix)
{
    memset(table, 0xaa, sizeof table);
    assert_true(blend_make(rgb, mix, table));
    for (int under = 0; under < 256; under++)
        for (int over = 0; over < 256; over++)
            assert_int_equal(table[under * 256 + over], wanted(rgb, under, over, mix));
}

TEST(default_palette)
{
    uint8_t rgb[CART_PALETTE_SIZE];

    art_default_palette(rgb);
    check(rgb, BLEND_ADD);
    check(rgb, 99);
}

TEST(random_palettes)
{
    static const int mixes[] = { BLEND_ADD, 1, 37, 50 };
    uint8_t rgb[CART_PALETTE_SIZE];
    struct rng r;

    rng_seed(&r, 8);
    for (size_t k = 0; k < sizeof mixes / sizeof *mixes; k++) {
        for (int i = 0; i < CART_PALETTE_SIZE; i++)
            rgb[i] = (uint8_t)(rng_next(&r) >> (k == 3 ? 59 : 56)); /* at last all in one corner */
        check(rgb, mixes[k]);
    }
}

/* Of ramps: what the rule says, whatever the colours. */
TEST(of_ramps)
{
    static const uint8_t black[CART_PALETTE_SIZE];

    for (int rule = BLIT_RAMP_ADD; rule < BLIT_MIXES; rule++) {
        assert_true(blend_make(black, BLEND_RULE + BLIT_RAMP_ADD - rule, table));
        for (int i = 0; i < CART_BLEND_SIZE; i++)
            assert_int_equal(table[i], blit_ramp_entry((enum blit_mix)rule, (uint8_t)(i >> 8), (uint8_t)i));
    }
}

/* Few colours, many times each: ties everywhere, and at the corners of the cube. */
TEST(equal_colours)
{
    uint8_t rgb[CART_PALETTE_SIZE];

    for (int i = 0; i < 256; i++)
        for (int c = 0; c < 3; c++)
            rgb[3 * i + c] = i >> c & 1 ? 255 : 0;
    check(rgb, BLEND_ADD);
    check(rgb, 50);
}

RUN_TESTS(NULL, NULL)
