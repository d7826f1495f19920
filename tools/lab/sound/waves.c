/*
 * waves.c - the ear's section on waves: what of them folds back from above half the sampling rate.
 *
 * A note of an odd number of turns in a power of two of samples: its harmonics stand at multiples of that number, and
 * what folds back stands elsewhere.
 */
#include <math.h>
#include <stdlib.h>
#include "ear.h"

enum { LOW = 24, HIGH = 108, NOTES = HIGH - LOW + 1 };

struct foul {
    double db[NOTES], worst, worst_10k;
    int at;
};

/* The loudest line below `hertz` that is no harmonic, under the fundamental. */
static double loudest(const double *level, int turns, double hertz)
{
    double most = 1e-9;

    for (int k = 1; k < EAR_LONG * hertz / SND_RATE; k++)
        if (k % turns && level[k] > most)
            most = level[k];
    return 20 * log10(most / level[turns]);
}

static void naive_saw(double step, double *out)
{
    for (int i = 0; i < EAR_LONG; i++)
        out[i] = 2 * fmod(i * step, 1) - 1;
}

/* inst NULL: a saw without any care. */
static struct foul measure(const struct ear_inst *inst)
{
    static double x[EAR_LONG], level[EAR_LONG / 2 + 1];
    struct foul f = { .worst = -999, .worst_10k = -999 };

    for (int n = 0; n < NOTES; n++) {
        const int turns = ear_turns(LOW + n);
        if (inst)
            ear_wave(inst, ear_step(turns), x, EAR_LONG);
        else
            naive_saw((double)turns / EAR_LONG, x);
        ear_spectrum(x, level);
        const double low = loudest(level, turns, 10000);
        f.db[n] = loudest(level, turns, 20000);
        f.worst_10k = low > f.worst_10k ? low : f.worst_10k;
        if (f.db[n] > f.worst) {
            f.worst = f.db[n];
            f.at = LOW + n;
        }
    }
    return f;
}

static const struct kind {
    const char *name, *settings;
    double mark; /* of the prototype; 0: it has none */
} KINDS[] = {
    { "saw", "saw", -84.7 },
    { "pulse of 1/2", "pulse", -84.7 },
    { "pulse of 1/4", "pulse duty=25", -81.6 },
    { "triangle", "triangle", -92.2 },
    { "wave of 32 harmonics",
      "wave harmonics=100,50,33.3,25,20,16.7,14.3,12.5,11.1,10,9.1,8.3,7.7,7.1,6.7,6.2,5.9,5.6,5.3,5,4.8,4.5,4.3,4.2,4,"
      "3.8,3.7,3.6,3.4,3.3,3.2,3.1",
      0 },
};
enum { COUNT = sizeof KINDS / sizeof *KINDS };

static void plot(const struct foul *saw, const struct foul *wave, const struct foul *naive)
{
    double notes[NOTES];

    for (int n = 0; n < NOTES; n++)
        notes[n] = LOW + n;
    report_plot(&(struct report_plot){
        .file = "alias",
        .title = "The loudest alias below 20 kHz",
        .x_name = "note",
        .y_name = "dB relative to the fundamental",
        .x_linear = true,
        .y_linear = true,
        .described = "Aliases of a naive saw rise from -53 to -17 dB as the note gets "
                     "higher; those of the engine's saw and 32-harmonic wave stay below -84 dB." });
    report_plot_line("saw", true, notes, saw->db, NOTES);
    report_plot_line("wave", false, notes, wave->db, NOTES);
    report_plot_line("naive saw", false, notes, naive->db, NOTES);
    report_plot_end();
}

void section_waves(void)
{
    struct foul f[COUNT], naive = measure(NULL);

    report_section("Waves");
    report_text("The engine reads a wave from a band-limited table with harmonics up to 28 kHz. There are %d versions "
                "of the table, half\n"
                "an octave apart. Each version has 4,096 values, which are interpolated linearly. A pulse is the "
                "difference of two saws.\n"
                "When a note needs a different version, it crossfades to that version within a frame. A piece's custom "
                "waves have up to\n"
                "10 versions. The results below cover all notes from %d to %d:",
                (int)WAVE_MIPS, LOW, HIGH);
    report_table(NULL, "wave|worst alias, dB>|at note>|below 10 kHz, dB>|prototype, dB>");
    for (int k = 0; k < COUNT; k++) {
        struct ear_inst inst = ear_inst(KINDS[k].settings);
        f[k] = measure(&inst);
        free(inst.rom);
        report_row(1, KINDS[k].name, ear_db(f[k].worst), report_string("%d", f[k].at), ear_db(f[k].worst_10k),
                   KINDS[k].mark < 0 ? ear_db(KINDS[k].mark) : "", NULL);
        if (KINDS[k].mark < 0)
            ear_figure(report_string("alias of a %s", KINDS[k].name), report_string("%s dB", ear_db(f[k].worst)),
                       report_string("%s dB", ear_db(KINDS[k].mark)), f[k].worst <= KINDS[k].mark);
    }
    report_row(0, "naive saw", ear_db(naive.worst), report_string("%d", naive.at), ear_db(naive.worst_10k), "-16.6",
               NULL);
    report_table_end();
    plot(&f[0], &f[4], &naive);
}
