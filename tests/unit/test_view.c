/*
 * test_view.c - a view's colours against the matrices that were published, in floating point; what must stay as it is;
 * and that what was alike to such eyes no longer is.
 */
#include <math.h>
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/board/board.h"
#include "../../src/workbench/pack/art.h"

/* Machado, Oliveira, Fernandes 2009, severity 1.0. */
static const double seen[COLOUR_BLIND_MODES][3][3] = {
    [COLOUR_BLIND_PROTAN] = { { 0.152286, 1.052583, -0.204868 },
                              { 0.114503, 0.786281, 0.099216 },
                              { -0.003882, -0.048116, 1.051998 } },
    [COLOUR_BLIND_DEUTAN] = { { 0.367322, 0.860646, -0.227968 },
                              { 0.280085, 0.672501, 0.047413 },
                              { -0.011820, 0.042940, 0.968881 } },
    [COLOUR_BLIND_TRITAN] = { { 1.255528, -0.076749, -0.178779 },
                              { -0.078411, 0.930809, 0.147602 },
                              { 0.004733, 0.691367, 0.303900 } },
};

/* What share of the red, green and blue that are lost goes to each channel. */
static const double moved[COLOUR_BLIND_MODES][3][3] = {
    [COLOUR_BLIND_PROTAN] = { [2] = { 0.5, 0, 0.5 } },
    [COLOUR_BLIND_DEUTAN] = { [2] = { 0.5, 0, 0.5 } },
    [COLOUR_BLIND_TRITAN] = { { 0.5, 0, 0.5 }, { 0, 0, -0.5 } },
};

static double light_of(int level)
{
    const double v = level / 255.0;

    return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

static double level_of(double light)
{
    light = light < 0 ? 0 : light > 1 ? 1 : light;
    return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1 / 2.4) - 0.055);
}

static void lights(uint32_t rgb, double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = light_of((int)(rgb >> (16 - 8 * c) & 255));
}

static void see(enum colour_blind_mode kind, const double light[3], double out[3])
{
    for (int c = 0; c < 3; c++) {
        out[c] = seen[kind][c][0] * light[0] + seen[kind][c][1] * light[1] + seen[kind][c][2] * light[2];
        out[c] = out[c] < 0 ? 0 : out[c] > 1 ? 1 : out[c];
    }
}

static void as_published(enum colour_blind_mode kind, uint32_t rgb)
{
    const uint32_t got = view_adjust_colour(kind, rgb);
    double light[3], lost[3];

    assert_true(got <= 0xffffff);
    lights(rgb, light);
    for (int c = 0; c < 3; c++)
        lost[c] = light[c] - seen[kind][c][0] * light[0] - seen[kind][c][1] * light[1] - seen[kind][c][2] * light[2];
    for (int c = 0; c < 3; c++) {
        const double *share = moved[kind][c];
        const double want = level_of(light[c] + share[0] * lost[0] + share[1] * lost[1] + share[2] * lost[2]);
        /* nearest in light, not in level, and constants of 16 bits: near black a level is 20 of 65536 */
        if (fabs((double)(got >> (16 - 8 * c) & 255) - want) > 0.62)
            fail_msg("view %d of %06x is %06x: channel %d should be %f", kind, rgb, got, c, want);
    }
}

TEST(published)
{
    struct rng r;

    rng_seed(&r, 3);
    for (int kind = COLOUR_BLIND_PROTAN; kind < COLOUR_BLIND_MODES; kind++) {
        for (uint32_t i = 0; i < 4096; i++) /* each of the cube's 16 x 16 x 16 corners */
            as_published((enum colour_blind_mode)kind, (i >> 8) * 0x110000 | (i >> 4 & 15) * 0x1100 | (i & 15) * 0x11);
        for (int i = 0; i < 20000; i++)
            as_published((enum colour_blind_mode)kind, (uint32_t)rng_next(&r) & 0xffffff);
    }
}

TEST(stays)
{
    struct rng r;

    for (int kind = 0; kind < COLOUR_BLIND_MODES; kind++)
        for (uint32_t grey = 0; grey < 256; grey++)
            assert_int_equal(view_adjust_colour((enum colour_blind_mode)kind, grey * 0x10101), grey * 0x10101);
    rng_seed(&r, 5);
    for (int i = 0; i < 1000; i++) {
        const uint32_t rgb = (uint32_t)rng_next(&r) & 0xffffff;
        assert_int_equal(view_adjust_colour(COLOUR_BLIND_OFF, rgb), rgb);
        assert_int_equal(view_adjust_colour(COLOUR_BLIND_PROTAN, rgb) >> 8, rgb >> 8); /* blue alone is another */
        assert_int_equal(view_adjust_colour(COLOUR_BLIND_DEUTAN, rgb) >> 8, rgb >> 8);
        assert_int_equal(view_adjust_colour(COLOUR_BLIND_TRITAN, rgb) & 255, rgb & 255);
    }
}

/* How far apart two colours look, roughly: the cube root of light is near to how light it looks. */
static double apart(const double a[3], const double b[3])
{
    double sum = 0;

    for (int c = 0; c < 3; c++)
        sum += (cbrt(a[c]) - cbrt(b[c])) * (cbrt(a[c]) - cbrt(b[c]));
    return sqrt(sum);
}

/* How far apart two colours look to such eyes. */
static double apart_seen(enum colour_blind_mode kind, uint32_t a, uint32_t b)
{
    double light[3], sa[3], sb[3];

    lights(a, light);
    see(kind, light, sa);
    lights(b, light);
    see(kind, light, sb);
    return apart(sa, sb);
}

/* Of all pairs of a palette that look apart, and alike to such eyes: they are parted to twice as far on the whole. */
TEST(parts)
{
    uint8_t rgb[CART_PALETTE_SIZE];
    uint32_t colour[256];

    art_default_palette(rgb);
    for (int i = 0; i < 256; i++)
        colour[i] = (uint32_t)(rgb[3 * i] << 16 | rgb[3 * i + 1] << 8 | rgb[3 * i + 2]);
    for (int k = COLOUR_BLIND_PROTAN; k < COLOUR_BLIND_MODES; k++) {
        const enum colour_blind_mode kind = (enum colour_blind_mode)k;
        double was = 0, is = 0;
        int n = 0;
        for (int i = 0; i < 256; i++)
            for (int j = 0; j < i; j++) {
                double a[3], b[3], before = apart_seen(kind, colour[i], colour[j]);
                lights(colour[i], a);
                lights(colour[j], b);
                if (apart(a, b) < 0.35 || before > 0.12)
                    continue;
                n++;
                was += before;
                is += apart_seen(kind, view_adjust_colour(kind, colour[i]), view_adjust_colour(kind, colour[j]));
            }
        print_message("# view %d: %d pairs, %.3f apart, then %.3f\n", k, n, was / n, is / n);
        assert_true(n > 100 && is > 2 * was);
    }
}

/* What was light stays light: so bullets stand out from backgrounds as they did. */
TEST(light)
{
    struct rng r;

    rng_seed(&r, 6);
    for (int kind = COLOUR_BLIND_PROTAN; kind < COLOUR_BLIND_MODES; kind++) {
        double off = 0;
        for (int i = 0; i < 10000; i++) {
            const uint32_t rgb = (uint32_t)rng_next(&r) & 0xffffff;
            double a[3], b[3];
            lights(rgb, a);
            lights(view_adjust_colour((enum colour_blind_mode)kind, rgb), b);
            off += fabs(0.2126 * (b[0] - a[0]) + 0.7152 * (b[1] - a[1]) + 0.0722 * (b[2] - a[2]));
        }
        assert_true(off / 10000 < 0.05);
    }
}

RUN_TESTS(NULL, NULL)
