/* test_loudness.c - levels as ITU-R BS.1770 and EBU Tech 3341 have them; and how long tunes are. */
#include <math.h>
#include "../test.h"
#include "../../src/workbench/sound/loudness.h"
#include "../../src/workbench/mml/mml.h"
#include "../../src/workbench/samples/tune_time.h"

enum { RATE = 48000 };

/* A sine of 1 kHz, both channels, so many seconds each of levels in decibels; returns LUFS. */
static double of_levels(const double *level, const int *seconds, int n, bool right)
{
    int16_t *lr = malloc((size_t)RATE * 120 * 4);
    size_t at = 0;

    for (int k = 0; k < n; k++)
        for (int i = 0; i < seconds[k] * RATE; i++, at++) {
            const double v = 32768 * pow(10, level[k] / 20) * sin(6.283185307179586 * 1000 * (double)at / RATE);
            lr[2 * at] = (int16_t)lrint(v);
            lr[2 * at + 1] = right ? lr[2 * at] : 0;
        }
    const double lufs = loudness(lr, at);
    free(lr);
    return lufs;
}

/* Of Tech 3341, cases 1, 4 and 5: 0.1 LU. */
TEST(tech_3341)
{
    static const struct {
        double level[5];
        int seconds[5], n;
        double lufs;
    } cases[] = {
        { { -23 }, { 20 }, 1, -23 },
        { { -72, -36, -23, -36, -72 }, { 10, 10, 60, 10, 10 }, 5, -23 },
        { { -26, -20, -26 }, { 20, 20, 20 }, 3, -23 },
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        assert_true(fabs(of_levels(cases[i].level, cases[i].seconds, cases[i].n, true) - cases[i].lufs) < 0.1);
    assert_true(fabs(of_levels(cases[0].level, cases[0].seconds, 1, false) + 26.01) < 0.1);
}

TEST(little_and_nothing)
{
    int16_t lr[2 * 4800] = { 0 };
    assert_true(loudness(lr, 4800) == -70 && loudness(lr, 0) == -70);
    assert_true(loudness_peak(lr, 4800) == -120 && loudness_mean(lr, 0) == -120);
    for (int i = 0; i < 4800; i++)
        lr[2 * i] = lr[2 * i + 1] = (int16_t)(i % 48 < 24 ? 16384 : -16384);
    lr[777] = INT16_MIN;
    assert_true(fabs(loudness_peak(lr, 4800)) < 0.001);
    assert_true(fabs(loudness_mean(lr, 4800) + 6.02) < 0.01);
    assert_true(loudness(lr, 4800) > -8 && loudness(lr, 4800) < -2);
}

/* A tune lasts so many seconds, its loop so many of them. */
static void lasts(const char *mml, double all, double loop)
{
    const struct mml_settings settings = { .volume = 255, .priority = 4, .limit = 2, .title = "" };
    uint8_t *made;
    size_t size;
    char err[256];

    if (!mml_compile(mml, strlen(mml), "x", &settings, &made, &size, err, sizeof err))
        fail_msg("%s", err);
    const struct tune t = tune_of(made);
    const struct tune_time time = tune_time(&t);
    free(made);
    if (fabs(time.all - all) > 0.001 || fabs(time.loop - loop) > 0.001)
        fail_msg("%s: %.4f s and %.4f, expected %.4f and %.4f", mml, time.all, time.loop, all, loop);
}

TEST(how_long_tunes_are)
{
    lasts("A t120 @pulse c4 d4 e2", 2, 0);
    lasts("A t120 @pulse c1 L c4", 2.5, 0.5);
    lasts("A t120 @pulse c1 L c4d4\nB @saw e1 f1", 4, 1);
    lasts("A t60 @pulse c4 t120 c4 t240 c4 L t60 d4 t120 d4", 1 + 0.5 + 0.25 + 1.5, 1.5);
    lasts("A t150 @pulse [c8d8]4\nB @saw L c4", 1.6, 0.4);
    lasts("A t90 @pulse r1 r1", 5.3333, 0);
}

RUN_TESTS(NULL, NULL)
