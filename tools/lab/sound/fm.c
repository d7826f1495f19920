/*
 * fm.c - the ear's section on FM: operators against doubles, feedback against the recursion that chips compute.
 */
#include <math.h>
#include <stdlib.h>
#include "ear.h"

/* ---- operators ---- */

enum { SAMPLES = 48000 };

static double sine(double turns)
{
    return sin(2 * M_PI * turns);
}

/* The phase of sample n in turns, as exact as the engine's. */
static double turns_at(uint64_t step, int n)
{
    return (double)(step * (uint64_t)n & (((uint64_t)1 << 56) - 1)) / 0x1p56;
}

static double two_ops(double index, uint64_t step)
{
    static double right[SAMPLES], heard[SAMPLES];
    struct ear_inst inst = ear_inst(report_string("fm ratio=1 depth=%g", index));
    const double depth = inst_read_op(inst.rom + inst.at, 0).level / 4096.0;

    ear_wave(&inst, step, heard, SAMPLES);
    for (int n = 0; n < SAMPLES; n++)
        right[n] = 32767 * sine(turns_at(step, n) + depth * sine(turns_at(step, n)));
    free(inst.rom);
    return ear_snr(right, heard, SAMPLES);
}

static double four_ops(uint64_t step)
{
    static double right[SAMPLES], heard[SAMPLES];
    struct ear_inst inst = ear_inst("fm4 algorithm=0 op1=1,2 op2=2,1 op3=1,2 op4=1,100");
    double depth[3];

    for (int k = 0; k < 3; k++)
        depth[k] = inst_read_op(inst.rom + inst.at, k).level / 4096.0;
    ear_wave(&inst, step, heard, SAMPLES);
    for (int n = 0; n < SAMPLES; n++) {
        const double p = turns_at(step, n);
        right[n] = 32767 * sine(p + depth[2] * sine(p + depth[1] * sine(2 * p + depth[0] * sine(p))));
    }
    free(inst.rom);
    return ear_snr(right, heard, SAMPLES);
}

static void operators(void)
{
    static const struct {
        double index;
        int note;
        double mark;
    } CASES[] = {
        { 1, 60, 85.3 }, { 2, 60, 78.8 }, { 4, 60, 76.8 }, { 8, 60, 70.0 }, { 4, 36, 76.8 }, { 4, 96, 76.8 }
    };
    double least = 999, first = 0;

    report_table(NULL, "operators|depth, radians>|note>|SNR, dB>|prototype, dB>");
    for (size_t k = 0; k < sizeof CASES / sizeof *CASES; k++) {
        const double snr = two_ops(CASES[k].index, pitch_step(CASES[k].note * PITCH_ONE));
        least = snr < least ? snr : least;
        first = k == 0 ? snr : first;
        report_row(1, "2", report_string("%g", CASES[k].index), report_string("%d", CASES[k].note), ear_db(snr),
                   ear_db(CASES[k].mark), NULL);
    }
    const double four = four_ops(pitch_step(60 * PITCH_ONE));
    report_row(1, "4, each modulates the next", "2, 1, 2", "60", ear_db(four), "75.2", NULL);
    report_table_end();
    report_text("At a depth of one radian, the SNR is %s dB lower than the prototype's. At greater depths, the SNR is "
                "higher than the\n"
                "prototype's.",
                ear_db(CASES[0].mark - first));
    ear_figure("2-operator FM, SNR", report_string("at least %s dB", ear_db(least)), "at least 70.0 dB", least >= 70);
    ear_figure("4-operator FM, SNR", report_string("%s dB", ear_db(four)), "75.2 dB", four >= 75.2);
}

/* ---- feedback ---- */

/* The last two samples, as chips take them; EAR_LONG samples after a second. */
static void recursion(double b, int turns, double *out)
{
    double y = 0, before = 0;

    for (int n = -3 * EAR_LONG; n < EAR_LONG; n++) {
        const double now =
            sin(2 * M_PI * fmod((double)(n + 4 * EAR_LONG) * turns / EAR_LONG, 1) + b * (y + before) / 2);
        before = y;
        y = now;
        if (n >= 0)
            out[n] = now;
    }
}

/* The largest difference of the first eight harmonics that are above -40 dB. */
static double harmonics_apart(const double *a, const double *b, int turns)
{
    double most = 0;

    for (int h = 1; h <= 8 && h * turns < EAR_LONG / 2; h++) {
        const double x = 20 * log10(a[h * turns] / a[turns]), y = 20 * log10(b[h * turns] / b[turns]);
        if (x > -40 && fabs(x - y) > most)
            most = fabs(x - y);
    }
    return most;
}

static double apart(double b, int note)
{
    static double x[EAR_LONG], ours[EAR_LONG / 2 + 1], theirs[EAR_LONG / 2 + 1];
    struct ear_inst inst = ear_inst(report_string("fm4 feedback=%g op1=1,100 op2=1,0 op3=1,0 op4=1,0", b));
    const int turns = ear_turns(note);

    ear_wave(&inst, ear_step(turns), x, EAR_LONG);
    ear_spectrum(x, ours);
    recursion(b, turns, x);
    ear_spectrum(x, theirs);
    free(inst.rom);
    return harmonics_apart(theirs, ours, turns);
}

static void feedback(void)
{
    static const double STRENGTHS[] = { 0.196, 0.393, 0.785, 1, 1.25, 1.5 };
    double most = 0, above = 0;

    report_text("Feedback, `y = sin(p + b y)`, is read from a table that has a row for each b and is indexed by the "
                "phase p. FM chips\n"
                "take y from the last two samples instead, which acts like a smaller b on higher notes. To sound like "
                "the chips, the\n"
                "engine therefore picks the row by b and pitch. The table below compares the first eight harmonics "
                "with those of the\n"
                "chips. Each value is the largest difference in dB, for harmonics above -40 dB:");
    report_table(NULL, "b, radians|note 36>|48>|60>|72>|84>|96>");
    for (size_t k = 0; k < sizeof STRENGTHS / sizeof *STRENGTHS; k++) {
        const char *cells[7] = { report_string("%.3f", STRENGTHS[k]) };
        for (int i = 0; i < 6; i++) {
            const double db = apart(STRENGTHS[k], 36 + 12 * i);
            most = i < 5 && db > most ? db : most;
            above = i == 5 && db > above ? db : above;
            cells[i + 1] = report_string("%.2f", db);
        }
        report_cells(1, cells, 7);
    }
    report_table_end();
    report_text("Up to note 84, the table has a row that is close to the chips for every b. Above note 84, no row is "
                "close enough: at\n"
                "note 96 with b of 1 or more, harmonics are up to %.2f dB off, so a high note with strong feedback "
                "does not sound like\n"
                "the chips.",
                above);
    ear_figure("feedback compared with FM chips, up to note 84 and with b up to 1.5",
               report_string("%.2f dB off", most), "1 dB off", most <= 1);
}

void section_fm(void)
{
    report_section("FM");
    report_text("FM has two or four operators and eight algorithms. Each operator has a separate envelope, ratio and "
                "detune. A sine is\n"
                "computed as a polynomial in 16-bit lanes, which compilers vectorise. The table compares the engine's "
                "FM with the same\n"
                "computation in doubles:");
    operators();
    feedback();
}
