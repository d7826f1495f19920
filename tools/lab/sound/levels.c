/*
 * levels.c - the ear's section on envelopes: levels as they are heard against the exact curves.
 */
#include <math.h>
#include <stdlib.h>
#include "ear.h"

enum { FRAMES = 24, N = FRAMES * SND_FRAME, AT = 400, VOL = 16000 };

static double exact(const struct env *e, double age)
{
    if (age < 0)
        return 0;
    if (age < e->attack)
        return age / e->attack;
    const double sustain = e->decay ? e->sustain / 32767.0 : 1;
    return sustain + (1 - sustain) * (e->decay ? exp2(-(age - e->attack) / e->decay) : 1);
}

/* The largest error of the level itself, of full scale. */
static double worst_level(const char *settings)
{
    struct ear_inst inst = ear_inst(settings);
    double most = 0;

    for (int32_t age = 0; age < N; age++) {
        const double apart = fabs(wave_level(&inst.inst.env, age, AGE_NEVER) / 32767.0 - exact(&inst.inst.env, age));
        most = apart > most ? apart : most;
    }
    free(inst.rom);
    return 20 * log10(most);
}

/* A sine from sample AT of the first frame on; the largest error, of the note's full level. */
static double worst(const char *settings)
{
    struct ear_inst inst = ear_inst(settings);
    struct ear_voices e;
    int16_t out[2 * SND_FRAME];
    double most = 0;
    const int32_t pitch = 69 * PITCH_ONE;
    const double full = VOL / 32768.0 * ear_tables.pan[128] * (32767.0 / 32768);

    ear_open(&e);
    for (int f = 0; f < FRAMES; f++) {
        voices_step(&e.v, inst.rom);
        e.v.gain1 = VOICE_FULL_GAIN;
        if (f == 0)
            voices_start_note(&e.v, inst.rom, 0, &(struct voice_note){ inst.at, 0, pitch, VOL, 64 }, AT);
        voices_mix(&e.v, inst.rom, &ear_tables, out);
        for (int n = 0; n < SND_FRAME; n++) {
            const int age = f * SND_FRAME + n - AT;
            const double turns = (double)age * (double)pitch_step(pitch) / 0x1p56;
            const double right = full * exact(&inst.inst.env, age) * sin(2 * M_PI * turns);
            most = fabs(out[2 * n] - right) > most ? fabs(out[2 * n] - right) : most;
        }
    }
    free(e.block);
    free(inst.rom);
    return 20 * log10(most / full);
}

void section_levels(void)
{
    static const struct {
        const char *what, *settings, *prototype;
    } CASES[] = { { "attack 1 ms, half-life 5 ms", "sine attack=1 decay=5 sustain=0", "-84.4" },
                  { "attack 1 ms, half-life 50 ms", "sine attack=1 decay=50 sustain=0", "-84.4" },
                  { "attack 5 ms, half-life 100 ms", "sine attack=5 decay=100 sustain=0", "-84.3" },
                  { "attack 50 ms, half-life 200 ms", "sine attack=50 decay=200 sustain=30", "-84.2" } };
    double most = -999, most_level = -999;

    report_section("Envelopes");
    report_text("The level of an envelope is a function of the note's age. The engine evaluates the level every %d "
                "samples and\n"
                "interpolates linearly in between. In a block that contains a corner of the envelope, the engine "
                "evaluates the level at\n"
                "every sample. In the table, *level* is the largest level error at any age. *Heard* is the "
                "largest error of a sine\n"
                "over %d frames. The sine starts at sample %d of a frame, and the error includes its quantisation:",
                (int)SND_BLOCK, (int)FRAMES, (int)AT);
    report_table(
        NULL, "envelope|level, dB relative to full scale>|prototype, dB>|heard, dB relative to the sine's full level>");
    for (int k = 0; k < 4; k++) {
        const double db = worst(CASES[k].settings);
        const double level = worst_level(CASES[k].settings);
        most = db > most ? db : most;
        most_level = level > most_level ? level : most_level;
        report_row(1, CASES[k].what, ear_db(level), CASES[k].prototype, ear_db(db), NULL);
    }
    report_table_end();
    ear_figure("largest error of an envelope's level", report_string("%s dB", ear_db(most_level)), "-84.2 dB",
               most_level <= -84.2);
    ear_figure("largest error of a sine with an envelope", report_string("%s dB", ear_db(most)), "-60.3 dB",
               most <= -60.3);
}
