/*
 * clicks.c - the ear's section on clicks: second differences where one thing ends and the next begins.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "ear.h"

enum {
    FRAMES = 60,
    N = FRAMES * SND_FRAME,
    LOUD = 23000 /* about full scale on one side with the place of one side */
};

static int second(const int16_t *x, int i)
{
    return abs(x[2 * i + 2] - 2 * x[2 * i] + x[2 * i - 2]);
}

/* A sine that sways, slides, and changes its volume and place all the time. */
static void sway(int *border, int *elsewhere)
{
    static int16_t out[2 * N];
    struct ear_inst inst = ear_inst("sine decay=0 vibrato=50,6,0");
    struct ear_voices e;

    *border = *elsewhere = 0;
    ear_open(&e);
    for (int f = 0; f < FRAMES; f++) {
        voices_step(&e.v, inst.rom);
        e.v.gain1 = VOICE_FULL_GAIN;
        if (f == 0)
            voices_start_note(&e.v, inst.rom, 0, &(struct voice_note){ inst.at, 0, 57 * PITCH_ONE, LOUD, 64 }, 0);
        if (f % 20 == 5)
            voices_glide(&e.v, 0, (f % 40 < 20 ? 64 : 57) * PITCH_ONE, 10);
        if (f % 7 == 3)
            voices_set_volume_and_pan(&e.v, 0, (uint16_t)(f % 14 == 3 ? LOUD / 2 : LOUD),
                                      (uint8_t)(f % 21 == 3 ? 20 : 64));
        voices_mix(&e.v, inst.rom, &ear_tables, out + 2 * SND_FRAME * f);
    }
    for (int i = 300; i < N - 1; i++) {
        int *most = i % SND_FRAME == 0 || i % SND_FRAME == SND_FRAME - 1 ? border : elsewhere;
        *most = second(out, i) > *most ? second(out, i) : *most;
    }
    free(e.block);
    free(inst.rom);
}

/* A loud note is taken by a silent one in the third frame; its tail is kept, or not. */
static int taken(bool tail)
{
    static int16_t out[2 * 5 * SND_FRAME];
    struct ear_inst inst = ear_inst("sine decay=0");
    struct ear_voices e;
    int most = 0;

    ear_open(&e);
    for (int f = 0; f < 5; f++) {
        voices_step(&e.v, inst.rom);
        e.v.gain1 = VOICE_FULL_GAIN;
        if (f == 0)
            voices_start_note(&e.v, inst.rom, 0, &(struct voice_note){ inst.at, 0, 57 * PITCH_ONE, LOUD, 64 }, 0);
        if (f == 2) {
            voices_start_note(&e.v, inst.rom, 0, &(struct voice_note){ inst.at, 0, 57 * PITCH_ONE, 0, 64 }, 0);
            e.v.inst[VOICES] = tail ? e.v.inst[VOICES] : 0;
        }
        voices_mix(&e.v, inst.rom, &ear_tables, out + 2 * SND_FRAME * f);
    }
    for (int i = 300; i < 5 * SND_FRAME - 1; i++)
        most = second(out, i) > most ? second(out, i) : most;
    free(e.block);
    free(inst.rom);
    return most;
}

enum { HEARD = 6 * SND_FRAME };

/* A note of FM that begins at a sample of the first frame. */
static void begun_at(const struct ear_inst *inst, int at, int16_t *out)
{
    struct ear_voices e;

    ear_open(&e);
    for (int f = 0; f < 6; f++) {
        voices_step(&e.v, inst->rom);
        e.v.gain1 = VOICE_FULL_GAIN;
        if (f == 0)
            voices_start_note(&e.v, inst->rom, 0, &(struct voice_note){ inst->at, 0, 60 * PITCH_ONE, LOUD, 64 }, at);
        voices_mix(&e.v, inst->rom, &ear_tables, out + 2 * SND_FRAME * f);
    }
    free(e.block);
}

/* The largest difference between the note begun at any sample and the one begun at the first, moved. */
static int moved_apart(int *at)
{
    static int16_t first[2 * HEARD], other[2 * HEARD];
    struct ear_inst inst = ear_inst("fm attack=1 decay=100 dull=80");
    int most = 0;

    begun_at(&inst, 0, first);
    for (int k = 1; k < SND_FRAME; k++) {
        begun_at(&inst, k, other);
        for (int i = 0; i < HEARD - SND_FRAME; i++) {
            const int apart = abs(other[2 * (i + k)] - first[2 * i]);
            *at = apart > most ? k : *at;
            most = apart > most ? apart : most;
        }
    }
    free(inst.rom);
    return most;
}

void section_clicks(void)
{
    int border, elsewhere, at = 0;
    const int kept = taken(true), cut = taken(false), moved = moved_apart(&at);

    sway(&border, &elsewhere);
    report_section("Clicks");
    report_text("Every voice has two slots: one for a note and one for the tail of the previous note. When another "
                "note steals the voice,\n"
                "the old note fades out within %d samples. In a click, the second difference (the change in slope from "
                "sample to sample)\n"
                "is larger than in the samples around it. The table is for a loud sine at note 57:",
                (int)VOICE_FADE);
    report_table(NULL, "transition|largest second difference>|prototype>");
    report_row(1, "vibrato, slides, volume and pan, at frame boundaries", report_string("%d", border), "104", NULL);
    report_row(0, "the same, elsewhere", report_string("%d", elsewhere), "123", NULL);
    report_row(1, "a voice stolen by another note", report_string("%d", kept), "185", NULL);
    report_row(0, "the same, without a tail", report_count(cut), "15,671", NULL);
    report_table_end();
    report_text("An FM note with an attack of 1 ms was started at each of the 800 samples of a frame. With their "
                "starts aligned, the 800\n"
                "notes differ by at most %d of 32,767; the note started at sample %d differs most.",
                moved, at);
    ear_figure("largest second difference at frame boundaries (and elsewhere)",
               report_string("%d (%d)", border, elsewhere), "104 (123)", border <= elsewhere && border <= 104);
    ear_figure("largest second difference when a voice is stolen", report_string("%d", kept), "185", kept <= 185);
    ear_figure("largest difference between aligned notes that started at different samples of a frame",
               report_string("%d of 32,767", moved), "7 of 32,767", moved <= 7);
}
