/*
 * mix.c - the ear's section on the mix: the limiter, and noise.
 */
#include <math.h>
#include <stdlib.h>
#include "ear.h"

enum { TONE = 341 /* turns in EAR_LONG: 999 Hz */ };

/* Overtones of a sine of that peak, in dB of full scale, under it; *peak: what comes out at most. */
static double distortion(double db, double *peak)
{
    static double x[EAR_LONG], level[EAR_LONG / 2 + 1];
    double over = 0;

    *peak = 0;
    for (int i = 0; i < EAR_LONG; i++) {
        const double v = exp2(22) * pow(10, db / 20) * sin(2 * M_PI * (double)i * TONE / EAR_LONG);
        x[i] = wave_limit((int32_t)lrint(v));
        *peak = fabs(x[i]) > *peak ? fabs(x[i]) : *peak;
    }
    ear_spectrum(x, level);
    for (int k = 2 * TONE; k < EAR_LONG / 2; k += TONE)
        over += level[k] * level[k];
    return 10 * log10(over) - 20 * log10(level[TONE]);
}

static void limiter(void)
{
    static const struct {
        int db;
        double mark;
    } CASES[] = { { -9, -114.6 }, { -6, -115.6 }, { -3, -36.4 }, { 0, -25.3 }, { 3, -18.7 }, { 6, -14.1 } };
    double at[6];

    report_table(NULL, "peak, dB relative to full scale|THD, dB>|output, fraction of full scale>|prototype, dB>");
    for (int k = 0; k < 6; k++) {
        double peak;
        at[k] = distortion(CASES[k].db, &peak);
        report_row(1, report_string("%+d", CASES[k].db), ear_db(at[k]), report_string("%.3f", peak / 32767),
                   ear_db(CASES[k].mark), NULL);
    }
    report_table_end();
    ear_figure("limiter, THD at -9 / -3 / 0 dB",
               report_string("%s / %s / %s dB", ear_db(at[0]), ear_db(at[2]), ear_db(at[3])),
               "-114.6 / -36.4 / -25.3 dB", at[0] <= -110 && at[2] <= -36.35 && at[3] <= -25.25);
}

static void plot_limiter(void)
{
    enum { POINTS = 61 };
    double in[POINTS], thd[POINTS], peak;

    for (int k = 0; k < POINTS; k++) {
        in[k] = -9 + k * 0.25;
        thd[k] = distortion(in[k], &peak);
    }
    report_plot(&(struct report_plot){ .file = "limiter",
                                       .title = "The limiter: overtones of a sine",
                                       .x_name = "peak, dB relative to full scale",
                                       .y_name = "THD, dB",
                                       .x_linear = true,
                                       .y_linear = true,
                                       .described =
                                           "Up to -6 dB the limiter adds nothing above -115 dB; above -6 dB, "
                                           "overtones rise to -25 dB at full scale and -14 dB at twice full scale." });
    report_plot_line("THD", true, in, thd, POINTS);
    report_plot_end();
}

static void noise(void)
{
    enum { LAGS = 2000 };
    static double x[EAR_LONG * 64];
    const int n = EAR_LONG * 64;
    struct ear_inst inst = ear_inst("noise");
    double mean = 0, power = 0, most = 0;

    ear_wave(&inst, (uint64_t)1 << 40, x, n); /* a value a sample */
    free(inst.rom);
    for (int i = 0; i < n; i++) {
        mean += x[i] / n;
        power += x[i] * x[i] / n;
    }
    for (int lag = 1; lag < LAGS; lag++) {
        double sum = 0;
        for (int i = 0; i < n - LAGS; i++)
            sum += x[i] * x[i + lag];
        sum = fabs(sum / (n - LAGS) / power);
        most = sum > most ? sum : most;
    }
    report_text("Noise is a hash of the sample's index, so it needs no state. On a scale of 32,767, the mean of the "
                "noise is %.1f and the\n"
                "RMS level is %.0f; the RMS level of true noise is 18,918. The autocorrelation at lags up to %d is at "
                "most %.4f. The\n"
                "autocorrelation of true noise is at most about 0.0037; the prototype was below that value by chance.",
                mean, sqrt(power), LAGS - 1, most);
    ear_figure("largest autocorrelation of noise", report_string("%.4f", most), "0.0032; true noise 0.0037",
               most < 0.004);
}

void section_mix(void)
{
    report_section("The mix");
    report_text("There are sixteen voices for music and eight for sounds. A voice with a volume of 127 reaches a third "
                "of full scale. The\n"
                "mix is exact up to half of full scale. Above half of full scale, a limiter without memory follows a "
                "curve that reaches\n"
                "full scale when the input is at twice full scale, so loud passages saturate softly and never clip. "
                "The table is for a\n"
                "sine of 1 kHz:");
    limiter();
    plot_limiter();
    noise();
}
