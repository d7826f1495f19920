/*
 * main.c - the ear's command line: ear [--out FOLDER] [SECTION...]
 *
 * Writes FOLDER/sound.md and FOLDER/sound/NAME.svg; FOLDER is docs unless named. Exit 1: a figure is not reached.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../src/workbench/mml/mml.h"
#include "ear.h"

struct snd_tables ear_tables;
static bool wrong;

void ear_figure(const char *what, const char *here, const char *prototype, bool reached)
{
    const char *cells[] = { what, here, prototype };

    if (!reached)
        fprintf(stderr, "ear: does not hold: %s: %s, and the prototype has %s\n", what, here, prototype);
    wrong = wrong || !reached;
    report_conclude(cells, 3);
}

const char *ear_db(double v)
{
    return report_string("%.1f", v);
}

int ear_turns(int note)
{
    return (int)(440 * exp2((note - 69) / 12.0) * EAR_LONG / SND_RATE) | 1;
}

uint64_t ear_step(int turns)
{
    return (uint64_t)turns * (((uint64_t)1 << 56) / EAR_LONG);
}

/* By halves: even samples, odd samples. */
static void transform(double (*x)[2], double (*work)[2], int n, int stride)
{
    if (n == 1)
        return;
    transform(work, x, n / 2, 2 * stride);
    transform(work + stride, x + stride, n / 2, 2 * stride);
    for (int k = 0; k < n / 2; k++) {
        const double c = cos(2 * M_PI * k / n), s = -sin(2 * M_PI * k / n);
        const double *even = work[2 * k * stride], *odd = work[(2 * k + 1) * stride];
        const double re = odd[0] * c - odd[1] * s, im = odd[0] * s + odd[1] * c;
        x[k * stride][0] = even[0] + re;
        x[k * stride][1] = even[1] + im;
        x[(k + n / 2) * stride][0] = even[0] - re;
        x[(k + n / 2) * stride][1] = even[1] - im;
    }
}

void ear_spectrum(const double x[EAR_LONG], double level[EAR_LONG / 2 + 1])
{
    static double a[EAR_LONG][2], b[EAR_LONG][2];

    for (int i = 0; i < EAR_LONG; i++) {
        a[i][0] = b[i][0] = x[i];
        a[i][1] = b[i][1] = 0;
    }
    transform(a, b, EAR_LONG, 1);
    for (int k = 0; k <= EAR_LONG / 2; k++)
        level[k] = 2 * hypot(a[k][0], a[k][1]) / EAR_LONG;
}

double ear_snr(const double *right, const double *heard, int n)
{
    double all = 0, bad = 0;

    for (int i = 0; i < n; i++) {
        all += right[i] * right[i];
        bad += (heard[i] - right[i]) * (heard[i] - right[i]);
    }
    return 10 * log10(all / bad);
}

struct ear_inst ear_inst(const char *settings)
{
    const struct mml_settings music = { .volume = 255, .limit = 1, .title = "" };
    char err[256];
    const char *text = report_string("@x %s\nA @x c", settings);
    struct ear_inst i;
    size_t size;

    if (!mml_compile(text, strlen(text), "ear", &music, &i.rom, &size, err, sizeof err))
        report_fail(err);
    const struct tune t = tune_of(i.rom);
    i.at = (uint32_t)(tune_inst(&t, 0) - i.rom);
    i.inst = inst_read(i.rom + i.at);
    return i;
}

void ear_wave(const struct ear_inst *i, uint64_t step, double *out, int n)
{
    const uint8_t *bytes = i->rom + i->at;
    const int mip = snd_mip((uint32_t)(step >> 24));
    struct wave_params at = { 0, step, mip, mip, 0, 0, bytes + i->inst.wave };
    struct fm_note fm;
    int16_t block[SND_BLOCK];

    fm_begin(&fm, &i->inst, bytes);
    for (int from = 0; from < n; from += SND_BLOCK, at.phase += SND_BLOCK * step) {
        if (inst_op_count(i->inst.kind))
            fm_compute_note_block(&fm, &ear_tables, from, AGE_NEVER, at.phase, step, block);
        else
            wave_compute_block(&ear_tables, &i->inst, &at, block);
        for (int k = 0; k < SND_BLOCK && from + k < n; k++)
            out[from + k] = block[k];
    }
}

void ear_open(struct ear_voices *e)
{
    uint8_t *next = e->block = calloc(1, (size_t)slots_size(&voices_chip, VOICE_SLOTS, 0) + 64);

    if (!e->block)
        report_fail("out of memory");
    memset(&e->v, 0, sizeof e->v);
    slots_layout(&voices_chip, &e->v.s, VOICE_SLOTS, 0, &next);
    e->v.s.live = e->v.s.cap;
    e->v.gain0 = e->v.gain1 = VOICE_FULL_GAIN;
}

/* ---- the page ---- */

static const struct report_part SECTIONS[] = {
    { "waves", section_waves },           { "fm", section_fm },       { "pitch", section_pitch },
    { "recordings", section_recordings }, { "adpcm", section_adpcm }, { "levels", section_levels },
    { "clicks", section_clicks },         { "mix", section_mix },     { "formats", section_formats },
};
enum { COUNT = sizeof SECTIONS / sizeof *SECTIONS };

static const char ABOUT[] =
    "# Sound: synthesis and quality\n"
    "\n"
    "`make sound` takes the measurements and writes this page and its plots; do not edit them. `make test` repeats "
    "the\n"
    "measurements and compares the results. See [the guide](../guide/25-sound.md) for sound and music in scripts, [the "
    "MML\n"
    "reference](../reference/mml.md) for the language, and [speed.md](speed.md) for the cost.\n"
    "\n"
    "Each frame has 800 stereo samples at 48 kHz, which depend only on RAM and ROM. A note has a phase, a step (the "
    "phase\n"
    "increment per sample), an age and an instrument. Each tick advances the phase, the step and the age by a whole "
    "frame at\n"
    "once. The samples are computed from these values and the instrument. All arithmetic uses integers. This page "
    "compares\n"
    "the engine's code with the same computation in doubles.\n"
    "\n"
    "How to read the tables:\n"
    "\n"
    "* dB compares amplitudes: 20 dB is a factor of ten, 60 dB is a factor of a thousand, and full scale is 96 dB "
    "above the\n"
    "  lowest bit of a 16-bit sample.\n"
    "* *SNR* is the level of the signal relative to the errors. *THD* is the level of the overtones added to a pure "
    "sine,\n"
    "  relative to the sine. *Alias* is the level of frequencies that are not overtones.\n"
    "* A *note* is a MIDI number: 60 is `o4c`, 69 is the A of 440 Hz, 24 is 33 Hz, and 108 is 4,186 Hz.\n"
    "* *Prototype* is the result of an earlier, similar program, which set the target. Two results miss this target: "
    "FM with\n"
    "  a depth of one radian, and noise.\n"
    "\n"
    "[music.md](music.md) covers the music of *Glass Tide*: keys, forms, levels, and the program that checks them.\n"
    "\n";

int main(int argc, char **argv)
{
    struct report_options o = { .usage = "ear [--out FOLDER]", .folder = "docs/measured" };

    if (!report_options(&o, argc, argv, SECTIONS, COUNT))
        return 2;
    snd_tables_make(&ear_tables);
    report_begin(&(struct report){ .program = "ear", .folder = o.folder, .page = "sound", .exact = true });
    report_run(&o, SECTIONS, COUNT);
    report_finish(ABOUT, "## Results\n"
                         "\n"
                         "| | engine | prototype |\n"
                         "|---|---|---|\n");
    return wrong;
}
