/*
 * test_view.c - a view's colours against the matrices that were published, in floating point, and what must stay as it
 * is.
 */
#include <math.h>
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/board/board.h"

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

static void as_published(enum colour_blind_mode kind, uint32_t rgb)
{
    const uint32_t got = view_adjust_colour(kind, rgb);
    double light[3], lost[3];

    assert_true(got <= 0xffffff);
    for (int c = 0; c < 3; c++)
        light[c] = light_of((int)(rgb >> (16 - 8 * c) & 255));
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

RUN_TESTS(NULL, NULL)
