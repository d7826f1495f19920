/* test_drift.c - the rate that holds two clocks together, by simulated clocks; and the resampler that plays at it. */
#include <math.h>
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/player/speaker/drift.h"
#include "../../src/player/speaker/resample.h"

enum { BLOCK = 800, SECOND = 60 };

/* A card whose clock is another by `differs`: what waits, sixtieth by sixtieth, frames above the target. */
struct card {
    struct drift drift;
    double off, differs;
    int jitter; /* frames, at most */
    struct rng rng;
};

/* Returns how far it is off at worst. The rate moves by a ten thousandth a frame at most. */
static double run(struct card *c, int frames)
{
    double worst = 0;

    for (int i = 0; i < frames; i++) {
        const double before = c->drift.rate,
                     jitter = c->jitter ? (double)rng_below(&c->rng, (uint32_t)(2 * c->jitter)) : 0;
        const double rate = drift_step(&c->drift, c->off + jitter - c->jitter);
        assert_true(fabs(rate) <= DRIFT_MAX && fabs(rate - before) <= 0.000101);
        c->off += BLOCK / (1 + rate) - BLOCK * (1 + c->differs);
        worst = fmax(worst, fabs(c->off));
    }
    return worst;
}

static struct card open_card(double differs, int jitter)
{
    struct card c = { .differs = differs, .jitter = jitter };

    rng_seed(&c.rng, 7);
    return c;
}

/* Whichever way the clocks differ, up to half a percent: never a third of a block off on the way, and in the end held
 * where it should be, at the rate that is theirs. */
TEST(clocks_are_held)
{
    static const double each[] = { 0, -0.0003, 0.002, 0.005, -0.005 };
    for (size_t i = 0; i < sizeof each / sizeof each[0]; i++)
        for (int jitter = 0; jitter <= 256; jitter += 256) {
            struct card c = open_card(each[i], jitter);
            assert_true(run(&c, 60 * SECOND) < 500);
            assert_true(run(&c, 60 * SECOND) < (jitter ? 60 : 4));
            assert_true(fabs(c.drift.rate + each[i]) < 0.0006);
            assert_true(fabs(c.drift.sum + each[i]) < 0.0002);
        }
}

/* Frames that are lost or thrown away at once are made up for, without swinging to the other side by more than a tenth,
 * and what is known of the clocks is not forgotten. */
TEST(jumps_are_made_up)
{
    static const double jumps[] = { 1500, -1500, 300 };
    for (int i = 0; i < 3; i++) {
        struct card c = open_card(0.001, 0);
        run(&c, 120 * SECOND);
        c.off += jumps[i];
        assert_true(run(&c, 20 * SECOND) <= fabs(jumps[i]) * 1.01 + 1);
        assert_true(run(&c, 60 * SECOND) < 150);
        assert_true(run(&c, 60 * SECOND) < 15);
    }
}

/* drift_reset_error: the rate does not follow a step of the queue; the difference of the clocks stays known. */
TEST(a_jump_that_is_told_moves_nothing)
{
    struct card c = open_card(0.003, 0);
    run(&c, 120 * SECOND);
    const double rate = c.drift.rate;
    for (int i = 0; i < 600; i++) {
        c.off = 0;
        drift_reset_error(&c.drift);
        drift_step(&c.drift, 0);
    }
    assert_true(fabs(c.drift.rate - rate) < 0.0002);
    drift_step(&c.drift, -1900);
    drift_reset_error(&c.drift);
    drift_step(&c.drift, 40);
    assert_true(c.drift.error == 40);
}

/* ---- the resampler ---- */

static struct resample r;
static int16_t in[2 * 48000], out[2 * 60000];

/* Rounds of blocks of a card's size at one step; returns how many frames came. */
static int pass(int frames, int at_once, uint64_t step)
{
    int n = 0;

    resample_clear(&r);
    for (int i = 0; i < frames; i += at_once) {
        resample_add(&r, in + 2 * i, at_once);
        n += resample_take(&r, step, RESAMPLE_CAPACITY, out + 2 * n, 60000 - n);
    }
    return n;
}

static void noise(void)
{
    struct rng rng;

    rng_seed(&rng, 3);
    for (int i = 0; i < 2 * 48000; i++)
        in[i] = (int16_t)(rng_below(&rng, 65536) - 32768);
}

/* At its own rate every bit passes, whatever it is and however it is cut. */
TEST(one_is_transparent)
{
    static const int cuts[] = { 800, 1, 37, 2400 };
    noise();
    for (int i = 0; i < 4; i++) {
        const int frames = cuts[i] * (24000 / cuts[i]), n = pass(frames, cuts[i], RESAMPLE_ONE);
        assert_int_equal(n, frames - RESAMPLE_AFTER);
        assert_memory_equal(in, out, (size_t)n * 4);
    }
}

/* A level stays what it is, the loudest one too; what is beyond full scale is cut and does not wrap. */
TEST(levels_stay)
{
    for (int level = -32768; level <= 32767; level += 13107) {
        for (int i = 0; i < 2 * 8000; i++)
            in[i] = (int16_t)level;
        const int n = pass(8000, 800, RESAMPLE_ONE + RESAMPLE_ONE / 211);
        for (int i = 50; i < 2 * n; i++)
            assert_true(abs(out[i] - level) <= 1);
    }
    for (int i = 0; i < 8000; i++)
        in[2 * i] = in[2 * i + 1] = i / 5 % 2 ? INT16_MAX : INT16_MIN;
    const int n = pass(8000, 800, RESAMPLE_ONE + RESAMPLE_ONE / 211);
    for (int i = 60; i < n; i++) {
        const int at = (int)(i * (1 + 1 / 211.0) + 0.5);
        assert_true(at % 5 == 0 || at % 5 == 4 || (at / 5 % 2 ? out[2 * i] > 9000 : out[2 * i] < -9000));
    }
}

/* Decibels of what a sine is not any more, after it passed at a rate of half a percent more or less. */
static double wrong(double hz, double rate)
{
    static const double turn = 6.28318530717958647692;
    double sum = 0, all = 0;
    const uint64_t step = (uint64_t)((double)RESAMPLE_ONE * rate);

    for (int i = 0; i < 24000; i++) {
        in[2 * i] = (int16_t)lrint(20000 * sin(turn * hz * i / 48000));
        in[2 * i + 1] = (int16_t)lrint(20000 * cos(turn * hz * i / 48000));
    }
    const int n = pass(24000, 800, step);
    for (int i = 100; i < n - 100; i++) {
        const double at = i * ((double)step / (double)RESAMPLE_ONE), want = 20000 * sin(turn * hz * at / 48000);
        sum += (out[2 * i] - want) * (out[2 * i] - want);
        all += want * want;
        assert_true(abs(out[2 * i + 1] - (int)lrint(20000 * cos(turn * hz * at / 48000))) < 40 || hz > 15000);
    }
    return 10 * log10(sum / all);
}

TEST(sines_stay_sines)
{
    for (int way = -1; way <= 1; way += 2) {
        const double rate = 1 + way * 0.005;
        assert_true(wrong(100, rate) < -88);
        assert_true(wrong(12000, rate) < -88);
        assert_true(wrong(16000, rate) < -85);
    }
}

/* As many frames come as the step says, and not one is lost or comes twice over an hour of blocks. */
TEST(nothing_is_lost)
{
    uint64_t came = 0;
    memset(in, 0, sizeof in);
    resample_clear(&r);
    const uint64_t step = RESAMPLE_ONE + RESAMPLE_ONE / 997;
    for (int i = 0; i < 216000; i++) {
        resample_add(&r, in, 800);
        came += (uint64_t)resample_take(&r, step, RESAMPLE_CAPACITY, out, 60000);
    }
    assert_true(llabs((int64_t)came - (int64_t)(216000.0 * 800 / (1 + 1 / 997.0))) < 40);
}

/* No more passes than is asked for, and what is asked for and not there waits. */
TEST(it_takes_what_it_may)
{
    noise();
    resample_clear(&r);
    resample_add(&r, in, 2000);
    assert_int_equal(resample_ready(&r), 2000 - RESAMPLE_AFTER);
    assert_int_equal(resample_take(&r, RESAMPLE_ONE, 300, out, 60000), 300);
    assert_int_equal(resample_take(&r, RESAMPLE_ONE / 2, 100, out, 60000), 200);
    assert_int_equal(resample_take(&r, RESAMPLE_ONE, 5000, out, 500), 500);
    assert_memory_equal(out, in + 2 * 400, 2000);
    assert_int_equal(resample_take(&r, RESAMPLE_ONE, 5000, out, 60000), 2000 - RESAMPLE_AFTER - 900);
}

static int make(void **state)
{
    (void)state;
    resample_open(&r);
    return 0;
}

RUN_TESTS(make, NULL)
