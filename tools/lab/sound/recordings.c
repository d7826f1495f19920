/*
 * recordings.c - the ear's section on recordings at other pitches: what is between their samples, and what must go.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "ear.h"

enum { N = 8192, EDGE = 96, ROOM = 4 * N + 4 * EDGE };

static int16_t in[ROOM];

static void fill(double hertz)
{
    for (int i = 0; i < ROOM; i++)
        in[i] = (int16_t)lrint(30000 * sin(2 * M_PI * hertz * (i - EDGE) / SND_RATE));
}

/* n samples of `in` read at a step, as voices read them. */
static void read_at(uint64_t step, bool pass, double *out, int n)
{
    static int16_t passed[ROOM];

    if (pass)
        wave_filter_low_pass(&ear_tables, in + EDGE - 8, ROOM - 2 * EDGE + 8, step, step, passed);
    else
        memcpy(passed, in + EDGE - 8, (ROOM - 2 * EDGE) * sizeof *in);
    for (int k = 0; k < n; k += SND_BLOCK) {
        int16_t block[SND_BLOCK];
        const uint64_t at = (uint64_t)k * step;
        wave_resample_block(&ear_tables, passed + 8 + (at >> 32), (uint32_t)at, step, block);
        for (int i = 0; i < SND_BLOCK; i++)
            out[k + i] = block[i];
    }
}

/* What is heard of a sine, with its loudness corrected, against the right one. */
static double snr(double hertz, double ratio, double *gain)
{
    static double right[N], heard[N];
    double both = 0, all = 0;
    const uint64_t step = (uint64_t)(ratio * 0x1p32);

    fill(hertz);
    read_at(step, true, heard, N);
    for (int n = 0; n < N; n++) {
        right[n] = 30000 * sin(2 * M_PI * hertz * ((double)n * (double)step / 0x1p32) / SND_RATE);
        both += right[n] * heard[n];
        all += right[n] * right[n];
    }
    *gain = 20 * log10(both / all);
    for (int n = 0; n < N; n++)
        right[n] *= both / all;
    return ear_snr(right, heard, N);
}

static void between(void)
{
    static const struct {
        double hertz, mark;
    } TONES[] = { { 200, 91 }, { 1000, 80.0 }, { 3000, 74.2 }, { 6000, 69.1 }, { 10000, 66.8 }, { 14000, 39.6 } };
    bool reached = true;
    const char *here[6];

    report_table(NULL, "tone, Hz|SNR, dB>|gain, dB>|prototype, dB>");
    for (int k = 0; k < 6; k++) {
        double gain;
        const double db = snr(TONES[k].hertz, 1.0595, &gain);
        reached = reached && (k == 0 || k == 5 || db >= TONES[k].mark - 0.05);
        here[k] = ear_db(db);
        report_row(1, report_count((int64_t)TONES[k].hertz), here[k], report_string("%.2f", gain),
                   ear_db(TONES[k].mark), NULL);
    }
    report_table_end();
    ear_figure("SNR of a sample played a semitone higher, at 1 / 3 / 6 / 10 kHz",
               report_string("%s / %s / %s / %s dB", here[1], here[2], here[3], here[4]),
               "80.0 / 74.2 / 69.1 / 66.8 dB", reached);
}

/* What lies between two samples by a straight line, for comparison. */
static double snr_of_lines(double hertz, double ratio)
{
    static double right[N], heard[N];
    double both = 0, all = 0;

    fill(hertz);
    for (int n = 0; n < N; n++) {
        const double at = n * ratio, part = at - floor(at);
        const int16_t *x = in + EDGE + (int)at;
        heard[n] = x[0] + (x[1] - x[0]) * part;
        right[n] = 30000 * sin(2 * M_PI * hertz * at / SND_RATE);
        both += right[n] * heard[n];
        all += right[n] * right[n];
    }
    for (int n = 0; n < N; n++)
        right[n] *= both / all;
    return ear_snr(right, heard, N);
}

static void plot_between(void)
{
    enum { POINTS = 30 };
    double hertz[POINTS], ours[POINTS], lines[POINTS], gain;

    for (int k = 0; k < POINTS; k++) {
        hertz[k] = 500 * (k + 1);
        ours[k] = snr(hertz[k], 1.0595, &gain);
        lines[k] = snr_of_lines(hertz[k], 1.0595);
    }
    report_plot(&(struct report_plot){ .file = "between",
                                       .title = "A sine a semitone up",
                                       .x_name = "Hz",
                                       .y_name = "SNR, dB",
                                       .x_linear = true,
                                       .y_linear = true,
                                       .described = "The engine's filter stays above 66 dB up to 10 kHz; linear "
                                                    "interpolation falls from 76 dB at 500 Hz to 22 dB at 10 kHz." });
    report_plot_line("8 taps", true, hertz, ours, POINTS);
    report_plot_line("lines", false, hertz, lines, POINTS);
    report_plot_end();
}

/* The loudest of what folds back below 20 kHz, of tones all the way up; and what is lost of the loudest note below
 * `hertz` that stays. */
static double folded(double ratio, bool passed)
{
    static double out[N];
    const uint64_t step = (uint64_t)(ratio * 0x1p32);
    double most = 0;

    for (double hertz = (SND_RATE - 20000) / ratio; hertz < 23500; hertz += 250) {
        double all = 0;
        if (fmod(hertz * ratio, SND_RATE) > 20000 && fmod(hertz * ratio, SND_RATE) < SND_RATE - 20000)
            continue;
        fill(hertz);
        read_at(step, passed, out, N);
        for (int n = 0; n < N; n++)
            all += out[n] * out[n];
        all = sqrt(2 * all / N) / 30000;
        most = all > most ? all : most;
    }
    return most > 0 ? 20 * log10(most) : -999;
}

static double lost(double ratio, double hertz)
{
    double gain;

    snr(hertz / ratio, ratio, &gain);
    return gain;
}

static void faster(void)
{
    static const double RATIOS[] = { 1.5, 2, 2.5, 3, 4 };
    double worst = -999;

    report_text("A sample that is played faster first passes through a %d-tap low-pass filter. There is a filter for "
                "each sixth of an\n"
                "octave. The table shows the level of tones that alias below 20 kHz, with and without the filter, and "
                "the gain of tones\n"
                "that are heard at 10 and 15 kHz:",
                (int)LOW_PASS_TAPS);
    report_table(NULL, "speed|aliases, dB>|without filter, dB>|10 kHz, dB>|15 kHz, dB>");
    for (size_t k = 0; k < sizeof RATIOS / sizeof *RATIOS; k++) {
        const double db = folded(RATIOS[k], true);
        worst = db > worst ? db : worst;
        report_row(1, report_string("%g", RATIOS[k]), ear_db(db), ear_db(folded(RATIOS[k], false)),
                   report_string("%.2f", lost(RATIOS[k], 10000)), report_string("%.2f", lost(RATIOS[k], 15000)), NULL);
    }
    report_table_end();
    ear_figure("aliasing of a sample played up to two octaves higher", report_string("%s dB", ear_db(worst)),
               "0 dB: no filter", worst < -60);
}

void section_recordings(void)
{
    report_section("Samples at other pitches");
    report_text("The engine interpolates samples with an 8-tap Kaiser-windowed sinc filter, at %d positions between "
                "two values. The\n"
                "table is for a sine played a semitone higher (1.0595 times as fast):",
                (int)SINC_PHASES);
    between();
    plot_between();
    faster();
}
