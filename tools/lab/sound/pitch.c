/*
 * pitch.c - the ear's section on pitch and time.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../../src/base/rng.h"
#include "ear.h"

static double worst_cents(int *at)
{
    double worst = 0;

    for (int32_t p = 12 * PITCH_ONE; p <= 120 * PITCH_ONE; p += PITCH_ONE / 256) {
        const double right = 440 * exp2(((double)p / PITCH_ONE - 69) / 12) / SND_RATE * 0x1p56;
        const double cents = fabs(1200 * log2((double)pitch_step(p) / right));
        if (cents > worst) {
            worst = cents;
            *at = p / PITCH_ONE;
        }
    }
    return worst;
}

static double worst_ratio(void)
{
    double worst = 0;

    for (int32_t p = -48 * PITCH_ONE; p <= 24 * PITCH_ONE; p += PITCH_ONE / 256) {
        const double right = exp2((double)p / PITCH_ONE / 12) * 0x1p32;
        const double cents = fabs(1200 * log2((double)pitch_ratio(p) / right));
        worst = cents > worst ? cents : worst;
    }
    return worst;
}

enum { FRAMES = 100000 };

/* A frame of random steps, summed sample by sample, against what a tick makes of it. */
static int steps_apart(void)
{
    struct ear_inst inst = ear_inst("sine");
    struct ear_voices e;
    struct rng r;
    int apart = 0;

    ear_open(&e);
    rng_seed(&r, 17);
    for (int f = 0; f < FRAMES; f++) {
        voices_start_note(&e.v, inst.rom, 0, &(struct voice_note){ inst.at, 0, 60 * PITCH_ONE, 0, 64 }, 0);
        uint64_t sum = e.v.phase[0] = rng_next(&r);
        e.v.step0[0] = rng_next(&r) >> 12;
        e.v.step1[0] = rng_next(&r) >> 12;
        int64_t step = (int64_t)e.v.step0[0];
        const int64_t bend = ((int64_t)e.v.step1[0] - step) / SND_FRAME;
        for (int n = 0; n < SND_FRAME; n++, step += bend)
            sum += (uint64_t)step;
        voices_step(&e.v, inst.rom);
        apart += e.v.phase[0] != sum;
    }
    free(e.block);
    free(inst.rom);
    return apart;
}

void section_pitch(void)
{
    int at = 0;
    const double cents = worst_cents(&at), ratio = worst_ratio();
    const int apart = steps_apart();

    report_section("Pitch and time");
    report_text(
        "The step of a note is a 64-bit phase increment. The increment is the product of four powers of 2^(1/12): one "
        "for the\n"
        "whole semitones and three for fractions of a semitone. For notes 12 to 120, tested at every 1/256 of a "
        "semitone, the\n"
        "step is at most %.1e cents off (at note %d). The speed ratio of a sample, from four octaves down to two "
        "octaves up,\n"
        "is at most %.1e cents off. In a pitch slide, the engine computes the phase at the end of a frame directly. In "
        "%s\n"
        "frames of random slides, this phase is compared with the sum of the frame's 800 steps: %d frames differ.",
        cents, at, ratio, report_count(FRAMES), apart);
    report_text("A music tick is 600,000 units long. The tempo is stored as a number of hundredths of a quarter note "
                "per minute. Each\n"
                "audio sample advances the music by this number of units. Nothing is rounded, so the music never "
                "drifts. A note can start\n"
                "at any of the 800 samples of a frame.");
    ear_figure("tuning, notes 12 to 120", report_string("%.1e cents", cents), "1.8e-04 cents", cents <= 0.000176);
    ear_figure("tuning of samples", report_string("%.1e cents", ratio), "1.8e-04 cents", ratio <= 0.000176);
    ear_figure("frames of pitch slides that differ from the sum of their steps",
               report_string("%d of %s", apart, report_count(FRAMES)), "0 of 100,000", apart == 0);
}
