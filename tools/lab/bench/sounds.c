/*
 * sounds.c - section "sound": what 24 voices cost a frame, and the tick of voices and of a piece of music. A loop over
 * an array of 16 bits, which is what plain C can do, runs in turns with them.
 */
#include <stdlib.h>
#include <string.h>
#include "../../../src/workbench/samples/encode.h"
#include "../../../src/workbench/mml/mml.h"
#include "../../../src/sound/seq.h"
#include "../../../src/sound/voices.h"
#include "bench.h"

enum { LONG = 48000, ROUNDS = 40, FRAMES = 10, RECORDED = 16, NOTES = 8 };

static struct snd_tables tables;

/* One ROM's bytes: the tune of all instruments, and a recording behind it. */
static struct {
    uint8_t *bytes;
    uint32_t insts, exact, packed;
} rom;

enum inst_number { SAMPLE, PULSE, SAW, TRIANGLE, NOISE, FM2, FM4, FM4_BACK, WAVE };

static const char PIECE[] =
    "@s sample x\n@p pulse vibrato=10,5,0\n@f fm\n"
    "@g fm4 algorithm=4 op1=2,1,0,500,20 op2=1,80,0,900,50 op3=3,1.5,5,300,10 op4=1,100,0,900,50\n"
    "@h fm4 feedback=1 algorithm=4 op1=2,1,0,500,20 op2=1,80,0,900,50 op3=3,1.5,5,300,10 op4=1,100,0,900,50\n"
    "@w wave harmonics=100,50,33,25,20,16\n"
    "A @s c @p c @saw c @triangle c @noise c @f c @g c @h c @w c\n";

static void write_recording(uint8_t *out, enum sample_coding coding)
{
    static int16_t in[LONG];

    for (int i = 0; i < LONG; i++)
        in[i] = (int16_t)(((uint32_t)i * 40503u >> 4 & 0x3fff) - 0x2000);
    encode_sample(out, in, LONG, 44100, 0, coding);
}

static void make_rom(void)
{
    const struct mml_settings settings = { .volume = 255, .limit = 1, .title = "" };
    char err[256];
    uint8_t *tune;
    size_t n;

    if (!mml_compile(PIECE, strlen(PIECE), "bench", &settings, &tune, &n, err, sizeof err))
        report_fail(err);
    const size_t exact = sample_size(LONG, SAMPLE_PCM16), packed = sample_size(LONG, SAMPLE_ADPCM);
    rom.bytes = realloc(tune, n + exact + packed);
    if (!rom.bytes)
        report_fail("out of memory");
    const struct tune t = tune_of(rom.bytes);
    rom.insts = (uint32_t)(tune_inst(&t, 0) - rom.bytes);
    rom.exact = (uint32_t)n;
    rom.packed = (uint32_t)(n + exact);
    write_recording(rom.bytes + rom.exact, SAMPLE_PCM16);
    write_recording(rom.bytes + rom.packed, SAMPLE_ADPCM);
}

/* ---- voices ---- */

struct band {
    const char *what;
    int recorded; /* voices of recordings */
    uint32_t *recording;
    int32_t higher; /* semitones */
    int notes;      /* others, of these in turn */
    enum inst_number of[4];
    int kinds;
    struct voices v;
    uint8_t *block;
    struct samples mix, step;
};

static void open_band(struct band *b)
{
    uint8_t *next = b->block = calloc(1, (size_t)slots_size(&voices_chip, VOICE_SLOTS, 0) + 64);

    if (!b->block)
        report_fail("out of memory");
    slots_layout(&voices_chip, &b->v.s, VOICE_SLOTS, 0, &next);
    b->v.s.live = b->v.s.cap;
    b->v.gain0 = b->v.gain1 = VOICE_FULL_GAIN;
    for (int i = 0; i < b->recorded + b->notes; i++) {
        const bool recorded = i < b->recorded;
        const enum inst_number k = recorded ? SAMPLE : b->of[(i - b->recorded) % b->kinds];
        const struct voice_note n = { rom.insts + INST_BYTES * (uint32_t)k, recorded ? *b->recording : 0,
                                      (60 + b->higher + i % 7) * PITCH_ONE, 1200, (uint8_t)(5 * i) };
        voices_start_note(&b->v, rom.bytes, i, &n, 33 * i);
    }
}

static void run_band(struct band *b, bool counted)
{
    int16_t out[2 * SND_FRAME];

    for (int f = 0; f < FRAMES; f++) {
        double from = bench_now();
        voices_mix(&b->v, rom.bytes, &tables, out);
        const double mixed = bench_since(from);
        from = bench_now();
        voices_step(&b->v, rom.bytes);
        const double stepped = bench_since(from);
        b->v.gain1 = VOICE_FULL_GAIN;
        if (!counted)
            continue;
        samples_add(&b->mix, mixed);
        samples_add(&b->step, stepped);
    }
}

/* What plain C can do: 24 times 800 stereo samples of 16 bits, times a gain, added up. */
static void plain_mix(const int16_t *in, int32_t *left, int32_t *right)
{
    for (int v = 0; v < VOICES; v++)
        for (int i = 0; i < SND_FRAME; i++) {
            left[i] += in[v * 64 + i] * (v + 3);
            right[i] += in[v * 64 + i] * (27 - v);
        }
}

static void run_plain(struct samples *s, bool counted)
{
    static int16_t in[VOICES * 64 + SND_FRAME];
    static int32_t left[SND_FRAME], right[SND_FRAME];

    for (int f = 0; f < FRAMES; f++) {
        const double from = bench_now();
        plain_mix(in, left, right);
        const double ns = bench_since(from);
        in[f] = (int16_t)(left[f] + right[f]);
        if (counted)
            samples_add(s, ns);
    }
}

/* ---- a piece ---- */

static double mean(const struct samples *s)
{
    double sum = 0;

    for (int i = 0; i < s->n; i++)
        sum += s->ns[i];
    return sum / s->n;
}

/* What its events do to voices. */
static void play(struct voices *v, int voice, const struct tune_played_event *p)
{
    const struct voice_note n = { rom.insts + INST_BYTES * (uint32_t)(1 + voice % 8), 0, p->value * (PITCH_ONE / 256),
                                  900, 64 };

    if (p->event == TUNE_NOTE)
        voices_start_note(v, rom.bytes, voice, &n, p->sample);
    else if (p->event == TUNE_OFF)
        voices_release(v, voice, p->sample);
    else if (p->event == TUNE_VOLUME)
        voices_set_volume_and_pan(v, voice, 900, 64);
}

/* The tick of a piece of 16 tracks: its sequencer, and the voices that it plays. */
static void measure_seq(struct samples *s)
{
    static const char text[] = "ABCDEFGHIJKLMNOP t150 L l16 [c d8 e32 f32 g4 v9 a]8\n";
    const struct mml_settings settings = { .volume = 255, .limit = 1, .title = "" };
    struct band band = { .notes = 0 };
    struct seq q = { 0 };
    char err[256];
    uint8_t *tune, *block, *next;
    size_t n;

    if (!mml_compile(text, strlen(text), "bench", &settings, &tune, &n, err, sizeof err))
        report_fail(err);
    next = block = calloc(1, (size_t)slots_size(&seq_chip, SEQ_SLOTS, 0) + 64);
    if (!block)
        report_fail("out of memory");
    slots_layout(&seq_chip, &q.s, SEQ_SLOTS, 0, &next);
    q.s.live = q.s.cap;
    const struct tune t = tune_of(tune);
    seq_start(&q, 1, &t);
    open_band(&band);
    for (int f = 0; f < ROUNDS * FRAMES; f++) {
        const double from = bench_now();
        voices_step(&band.v, rom.bytes);
        struct seq_run run = { .s = &q, .t = &t };
        struct tune_played_event e;
        while (seq_next_event(&run, &e))
            play(&band.v, run.slot - 1, &e);
        samples_add(s, bench_since(from));
    }
    free(band.block);
    free(block);
    free(tune);
}

static void table(struct band *bands, int n, struct samples *plain)
{
    report_table(NULL, "voices | µs per frame> | ratio to plain loop> | tick, µs>");
    for (int i = 0; i < n; i++)
        report_row(i == 0, bands[i].what, samples_figure(&bands[i].mix, 1e3),
                   report_figure(samples_median(&bands[i].mix) / samples_median(plain)),
                   samples_figure(&bands[i].step, 1e3), NULL);
    report_row(0, "the plain loop", samples_figure(plain, 1e3), "1", "", NULL);
    report_table_end();
}

static struct band bands[] = {
    { .what = "16 samples, 8 voices of pulse, saw, triangle and noise",
      .recorded = 16,
      .recording = &rom.exact,
      .notes = 8,
      .of = { PULSE, SAW, TRIANGLE, NOISE },
      .kinds = 4 },
    { .what = "16 samples, 8 voices of 4-operator FM with feedback",
      .recorded = 16,
      .recording = &rom.exact,
      .notes = 8,
      .of = { FM4_BACK },
      .kinds = 1 },
    { .what = "16 ADPCM samples, 8 voices of pulse, saw, triangle and noise",
      .recorded = 16,
      .recording = &rom.packed,
      .notes = 8,
      .of = { PULSE, SAW, TRIANGLE, NOISE },
      .kinds = 4 },
    { .what = "24 voices of 4-operator FM with feedback", .notes = 24, .of = { FM4_BACK }, .kinds = 1 },
    { .what = "24 voices of 4-operator FM", .notes = 24, .of = { FM4 }, .kinds = 1 },
    { .what = "24 voices of 2-operator FM, waves and pulses", .notes = 24, .of = { FM2, WAVE, PULSE }, .kinds = 3 },
    { .what = "16 samples an octave up, 8 FM voices",
      .recorded = 16,
      .recording = &rom.exact,
      .higher = 12,
      .notes = 8,
      .of = { FM4 },
      .kinds = 1 },
    { .what = "none" },
};
enum { N = sizeof bands / sizeof *bands };

void section_sound(void)
{
    struct samples plain = { 0 }, seq = { 0 };

    snd_tables_make(&tables);
    make_rom();
    for (int i = 0; i < N; i++)
        open_band(&bands[i]);
    for (int round = -1; round < ROUNDS; round++) {
        run_plain(&plain, round >= 0);
        for (int i = 0; i < N; i++)
            run_band(&bands[i], round >= 0);
    }
    measure_seq(&seq);
    report_section("Sound");
    report_text("The table shows the microseconds to compute the sound of one frame (800 values for each of the two "
                "channels), and the microseconds of the tick that advances all voices by a frame. For a music piece "
                "with 16 tracks of 12 notes a second each, the tick takes %s µs, including the sequencer. The target "
                "of 100 µs applies to the second row. Samples that play far above their original pitch take longer, "
                "because they pass through a 64-tap filter. The *plain loop* only multiplies 24 voices of 16-bit "
                "samples by a gain and adds them up for each channel.",
                samples_figure(&seq, 1e3));
    table(bands, N, &plain);
    report_text("A game without sound has no voices and no sequencer, and no sound code runs in its frames. The commit "
                "that added sound was compared with its predecessor for a game without sound (`make compare "
                "BASE=ed089444 GAME=examples/first START= FRAMES=600`):\n"
                "\n"
                "* A frame takes 1.01 times as long as before and 1.000 times as many instructions.\n"
                "* Loading takes 1.00 times as long as before and 1.002 times as many instructions.\n"
                "* RAM grew by 448 bytes to 6,075,008 bytes, and a snapshot by 512 bytes to 315,904 bytes. The Lua "
                "heap did not grow.");
    const double most = samples_median(&bands[1].mix) / 1e3, tick = mean(&seq) / 1e3;
    bench_target("the sound of a frame with 24 voices: 16 samples, and 8 voices of 4-operator FM with feedback",
                 "100 µs", report_string("%s µs", report_figure(most)), most <= 100);
    bench_target("the sound tick of a music piece with 16 tracks, on average", "0.5 µs",
                 report_string("%s µs", report_figure(tick)), tick <= 0.5);
    for (int i = 0; i < N; i++) {
        free(bands[i].block);
        samples_free(&bands[i].mix);
        samples_free(&bands[i].step);
    }
    samples_free(&plain);
    samples_free(&seq);
    free(rom.bytes);
}
