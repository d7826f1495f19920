/*
 * test_snd.c - what sounds are made of: pitches, levels, recordings, filters, and time. Oracles are doubles.
 */
#include "../test.h"
#include <math.h>
#include "../../src/base/bytes.h"
#include "../../src/base/rng.h"
#include "../../src/workbench/samples/encode.h"
#include "../../src/workbench/mml/mml.h"
#include "../../src/sound/voices.h"
#include "../../src/sound/adpcm.h"
#include "../../src/sound/fm.h"
#include "../../src/sound/wave.h"

static struct snd_tables tables;

static int make_tables(void **state)
{
    (void)state;
    snd_tables_make(&tables);
    return 0;
}

TEST(pitch)
{
    for (int32_t p = 0; p <= PITCH_MAX; p += 997) {
        const long double hz = 440 * exp2l(((long double)p / PITCH_ONE - 69) / 12), step = hz / SND_RATE * 0x1p56l;
        assert_true(fabsl(1200 * log2l((long double)pitch_step(p) / step)) < 0.0001l);
    }
    for (int32_t p = -96 * PITCH_ONE; p <= 48 * PITCH_ONE; p += 1009) {
        const long double ratio = exp2l((long double)p / PITCH_ONE / 12) * 0x1p32l;
        assert_true(fabsl(1200 * log2l((long double)pitch_ratio(p) / ratio)) < 0.0002l);
    }
    assert_true(pitch_step(-5) == pitch_step(0) && pitch_step(INT32_MAX) == pitch_step(PITCH_MAX));
    assert_true(pitch_ratio(0) == (uint64_t)1 << 32 && pitch_ratio(12 * PITCH_ONE) == (uint64_t)2 << 32);
}

TEST(halved)
{
    for (uint64_t x = 0; x < (uint64_t)31 << 32; x += 12345678) {
        const double right = 0x1p30 * exp2(-(double)x / 0x1p32);
        assert_true(fabs(pitch_exp2_neg(x) - right) <= 0x1p30 * 4e-6 * exp2(-(double)x / 0x1p32) + 1);
    }
    assert_int_equal(pitch_exp2_neg(0), 1 << 30);
    assert_int_equal(pitch_exp2_neg((uint64_t)3 << 32), 1 << 27);
}

/* Weights add up to one; one that stands on a sample gives it back; each phase is the mirror of its opposite. */
TEST(sinc)
{
    for (int p = 0; p < SINC_PHASES; p++) {
        int sum = 0;
        for (int j = 0; j < SINC_TAPS; j++)
            sum += tables.sinc[p][j];
        assert_int_equal(sum, 1 << 15);
    }
    for (int j = 0; j < SINC_TAPS; j++)
        assert_true(abs(tables.sinc[0][j] - (j == 3 ? 1 << 15 : 0)) < 1200);
}

TEST(limit)
{
    int16_t last = 0;

    for (int32_t v = 0; v < 1 << 25; v += 997) {
        const int16_t out = wave_limit(v);
        assert_true(out >= last && wave_limit(-v) == -out);
        if (v <= 1 << 21)
            assert_int_equal(out, (v + 64) >> 7);
        last = out;
    }
    assert_int_equal(last, 32767);
}

/* The level rises in its attack, halves as it says, and has no jump. */
TEST(level)
{
    const struct env i = { .sustain = 8000, .attack = 480, .decay = 1000, .fade = 48000, .release = 2000 };
    int32_t last = 0;

    for (int32_t age = -10; age < 60000; age++) {
        const int32_t level = wave_level(&i, age, 20000);
        assert_true(level >= 0 && level <= 32767 && abs(level - last) <= 32767 / 480 + 2);
        last = level;
    }
    assert_int_equal(wave_level(&i, 480, AGE_NEVER), 32767);
    assert_true(abs(wave_level(&i, 1480, AGE_NEVER) - (int)(lrint((8000 + 24767 / 2) * exp2(-1000.0 / 48000)))) <= 3);
    assert_true(abs(wave_level(&i, 22000, 20000) * 2 - wave_level(&i, 20000, 20000)) <= 2);
    assert_true(wave_is_silent(&i, 20000 + 16 * 2000, 20000) && !wave_is_silent(&i, 20000, AGE_NEVER));
}

/* What is read depends neither on where reading starts nor on how often the loop is passed. */
TEST(adpcm)
{
    enum { N = 3000 };
    static int16_t in[N], all[4 * N], part[200];
    uint8_t *bytes = malloc(sample_size(N, SAMPLE_ADPCM));
    struct sample s;
    struct rng r;

    rng_seed(&r, 4);
    for (int i = 0; i < N; i++)
        in[i] = (int16_t)(12000 * sin(i * 0.05) + 4000 * sin(i * 0.31));
    for (int looped = 0; looped < 2; looped++) {
        encode_sample(bytes, in, N, 44100, looped ? 700 : SAMPLE_NO_LOOP, SAMPLE_ADPCM);
        assert_true(sample_open(bytes, sample_size(N, SAMPLE_ADPCM), &s));
        sample_read(&s, 0, 4 * N, all);
        for (int i = N; i < 4 * N; i++)
            assert_int_equal(all[i], looped ? all[700 + (i - 700) % (N - 700)] : 0);
        for (int k = 0; k < 2000; k++) {
            const int from = (int)(rng_next(&r) % (4 * N - 200 + 50)) - 50, n = (int)(rng_next(&r) % 200);
            sample_read(&s, from, n, part);
            for (int i = 0; i < n; i++)
                assert_int_equal(part[i], from + i < 0 ? 0 : all[from + i]);
        }
    }
    bytes[SAMPLE_HEADER_SIZE + 2] = 89;
    assert_false(sample_open(bytes, sample_size(N, SAMPLE_ADPCM), &s));
    assert_false(sample_open(bytes, sample_size(N, SAMPLE_ADPCM) - 1, &s));
    free(bytes);
}

/* ---- fast and plain ---- */

static struct rng chance;

/* Any 16 bits, extremes often. */
static int16_t any16(void)
{
    static const int16_t extremes[] = { 0, 1, -1, 32767, -32767, -32768, 16384, -16384 };
    const uint64_t v = rng_next(&chance);

    return v % 3 == 0 ? extremes[v >> 8 & 7] : (int16_t)(v >> 16);
}

/* All sines there are. */
TEST(sines)
{
    uint32_t phase[FM_BLOCK];
    int16_t fast[FM_BLOCK], plain[FM_BLOCK];

    for (uint32_t p = 0; p < 65536; p += FM_BLOCK) {
        for (uint32_t n = 0; n < FM_BLOCK; n++)
            phase[n] = (p + n) << 16 | (n * 2114 & 0xffff);
        fm_sines(phase, fast);
        fm_sines_portable(phase, plain);
        assert_memory_equal(fast, plain, sizeof fast);
        for (uint32_t n = 0; n < FM_BLOCK; n++)
            assert_true(fabs(plain[n] - 32767 * sin(2 * M_PI * (p + n + 0.5) / 65536)) < 2);
    }
}

static int16_t x[4 * SND_BLOCK + 2 * LOW_PASS_TAPS];

static int64_t in16(int64_t v)
{
    return v > 32767 ? 32767 : v < -32768 ? -32768 : v;
}

static void same_sample(int round)
{
    const uint64_t step = rng_next(&chance) >> (30 + round % 3);
    const uint32_t phase = (uint32_t)rng_next(&chance) | (round % 4 ? 0 : 0xfff00000u);
    int16_t out[SND_BLOCK];

    wave_resample_block(&tables, x + LOW_PASS_TAPS, phase, step, out);
    for (int n = 0; n < SND_BLOCK; n++) {
        const uint64_t at = phase + (uint64_t)n * step, place = ((at & 0xffffffff) + (1 << 21)) >> 22;
        int64_t sum = 1 << 14;
        for (int j = 0; j < SINC_TAPS; j++)
            sum += (int64_t)x[LOW_PASS_TAPS + (int)(at >> 32) + j - 3] * tables.sinc[place][j];
        assert_int_equal(out[n], in16(sum >> 15));
    }
}

static int64_t passed(int row, int n)
{
    int64_t sum = 1 << 13;

    for (int j = 0; row >= 0 && j < LOW_PASS_TAPS; j++)
        sum += (int64_t)x[LOW_PASS_TAPS / 2 + n + j] * tables.low_pass[row][j];
    return row < 0 ? x[LOW_PASS_TAPS + n] : in16(sum >> 14);
}

static void same_low(int round)
{
    const uint64_t step0 = (uint64_t)(4 + 3 * (round % 4)) << 30, step1 = (uint64_t)(4 + 2 * (round % 5)) << 30;
    const int many = SND_BLOCK - round % 7, row0 = snd_low_pass_row(step0), row1 = snd_low_pass_row(step1);
    int16_t out[SND_BLOCK + 1];

    out[many] = 12345;
    wave_filter_low_pass(&tables, x + LOW_PASS_TAPS, many, step0, step1, out);
    for (int n = 0; n < many; n++) {
        const int64_t a = passed(row0, n), b = passed(row1, n);
        assert_int_equal(out[n], row0 == row1 ? a : a + (b - a) * n / many);
    }
    assert_int_equal(out[many], 12345);
}

static int32_t between(int32_t from, int32_t to, int n)
{
    return (from * SND_BLOCK + (to - from) * n) >> 5;
}

static void same_mix(void)
{
    const struct wave_gains from = { any16() & 32767, any16() & 32767 }, to = { any16() & 32767, any16() & 32767 };
    int16_t wave[SND_BLOCK], level[SND_BLOCK];
    int32_t left[SND_BLOCK], right[SND_BLOCK], was[SND_BLOCK];

    for (int n = 0; n < SND_BLOCK; n++) {
        wave[n] = any16();
        level[n] = any16() & 32767;
        was[n] = left[n] = right[n] = (int32_t)rng_next(&chance) >> 6;
    }
    wave_add_to_mix(wave, level, &from, &to, left, right);
    for (int n = 0; n < SND_BLOCK; n++) {
        const int32_t heard = (wave[n] * level[n] + (1 << 14)) >> 15;
        assert_int_equal(left[n], was[n] + (heard * between(from.left, to.left, n) >> 8));
        assert_int_equal(right[n], was[n] + (heard * between(from.right, to.right, n) >> 8));
    }
}

/* Filters and the mix are what is written here one by one, whatever comes. */
TEST(plain)
{
    rng_seed(&chance, 8);
    for (int round = 0; round < 3000; round++) {
        for (size_t i = 0; i < sizeof x / sizeof *x; i++)
            x[i] = any16();
        same_sample(round);
        same_low(round);
        same_mix();
    }
}

/* Operators at their extremes: the sum of the audible ones stays within their gains, and silence is silent. */
TEST(operators)
{
    struct fm_op op[FM_OPS];
    int16_t out[FM_BLOCK];

    rng_seed(&chance, 9);
    for (int round = 0; round < 4000; round++) {
        const int algorithm = round % FM_ALGORITHMS, ops = round % 5 ? 4 : 2, gain = round % 7 ? 32767 / ops : 0;
        const unsigned audible = inst_audible_ops(ops, algorithm);
        const int32_t top = (FEEDBACK_ROWS - 1) * FEEDBACK_ROW_UNITS,
                      rows[2] = { round % 3 ? top : 0, round % 2 ? top : 0 };
        int most = 0; /* each operator alone can be no louder than its gain */
        for (int k = 0; k < ops; k++) {
            const bool is_audible = audible >> k & 1;
            most += is_audible ? gain + 1 : 0;
            op[k].phase = (uint32_t)rng_next(&chance);
            op[k].step = (uint32_t)rng_next(&chance);
            op[k].scale = is_audible ? 0 : (int)(rng_next(&chance) % 5);
            for (int n = 0; n < FM_BLOCK; n++)
                op[k].gain[n] = (int16_t)(is_audible ? gain : any16() & 32767);
        }
        fm_compute_block(&tables, ops, algorithm, op, rows, out);
        for (int n = 0; n < FM_BLOCK; n++)
            assert_true(abs(out[n]) <= most);
    }
}

/* ---- time ---- */

struct played {
    int n;
    struct {
        int64_t at;
        int event, value;
    } e[4000];
};

static void run_in(const struct tune *t, int piece, int64_t samples, struct played *d)
{
    struct track_cursor c = tune_track_start(t, 0);

    d->n = 0;
    for (int64_t base = 0; base < samples; base += piece) {
        struct tune_run run = { t, 0, c, t->tempo, 0, (int)(samples - base < piece ? samples - base : piece), 0 };
        struct tune_played_event e;
        while (tune_next_event(&run, &e)) {
            d->e[d->n].at = base + e.sample;
            d->e[d->n].event = (int)e.event;
            d->e[d->n++].value = e.value;
        }
        c = run.cursor;
    }
}

/* A track read in frames, or in pieces of any length, is the same one, to the sample. */
TEST(time)
{
    static struct played whole, parts;
    const struct mml_settings settings = { .volume = 255, .priority = 4, .limit = 2, .title = "" };
    const char *text = "t137.31 l16 c d e4. r32 L f&g {ab}4 v3 p9 [c32]5 {{cdefgab}}2 r";
    const int pieces[] = { 1, 799, 800, 12345 };
    uint8_t *bytes;
    char err[128];
    size_t size;

    assert_true(mml_compile(text, strlen(text), "t", &settings, &bytes, &size, err, sizeof err));
    const struct tune t = tune_of(bytes);
    assert_int_equal(t.tempo, 13731);
    run_in(&t, 100000, 800000, &whole);
    assert_true(whole.n > 250);
    for (size_t k = 0; k < sizeof pieces / sizeof *pieces; k++) {
        run_in(&t, pieces[k], 800000, &parts);
        assert_int_equal(whole.n, parts.n);
        assert_memory_equal(whole.e, parts.e, (size_t)whole.n * sizeof *whole.e);
    }
    /* the third note, e, begins after two 16ths: 240 ticks */
    for (int i = 0, notes = 0; i < whole.n; i++)
        if (whole.e[i].event == TUNE_NOTE && ++notes == 3)
            assert_int_equal(whole.e[i].at, (int64_t)ceil(240.0 * TUNE_TICK / 13731));
    free(bytes);
}

/* ---- voices ---- */

static struct voices *make_voices(uint8_t **block)
{
    static struct voices v;
    uint8_t *next = *block = calloc(1, (size_t)slots_size(&voices_chip, VOICE_CAPACITY, 0) + 64);

    memset(&v, 0, sizeof v);
    slots_layout(&voices_chip, &v, VOICE_CAPACITY, 0, &next);
    v.s.live = v.s.cap;
    v.gain0 = v.gain1 = VOICE_FULL_GAIN;
    return &v;
}

/* A note of an instrument of MML on voice 0, which began with the first of so many frames; the last one's samples. */
static struct voices *played(const char *settings, int frames, int16_t out[2 * SND_FRAME], uint8_t **rom,
                             uint8_t **block)
{
    const struct mml_settings music = { .volume = 255, .limit = 2, .title = "" };
    char text[256], err[128];
    struct voices *v = make_voices(block);
    size_t size;

    snprintf(text, sizeof text, "@x %s\nA @x c", settings);
    if (!mml_compile(text, strlen(text), "t", &music, rom, &size, err, sizeof err))
        fail_msg("%s", err);
    const struct tune t = tune_of(*rom);
    const uint32_t inst = (uint32_t)(tune_inst(&t, 0) - *rom);
    for (int f = 0; f < frames; f++) {
        voices_step(v, *rom);
        v->gain1 = VOICE_FULL_GAIN;
        if (f == 0)
            voices_start_note(v, *rom, 0, &(struct voice_note){ inst, 0, 60 * PITCH_ONE, 16000, 64 }, 0);
    }
    voices_mix(v, *rom, &tables, out);
    return v;
}

/* Its step at the frame's beginning (0) or end (1), in semitones above the note. */
static double semitones(const char *settings, int frames, int end)
{
    int16_t out[2 * SND_FRAME];
    uint8_t *rom, *block;
    const struct voices *v = played(settings, frames, out, &rom, &block);
    const double step = (double)(end ? v->step1[0] : v->step0[0]);

    free(rom);
    free(block);
    return 12 * log2(step / (double)pitch_step(60 * PITCH_ONE));
}

/* How loud its side is, of the loudest sample of a note that is nothing but a sine. */
static double loudness(const char *settings, int frames, int side)
{
    int16_t out[2 * SND_FRAME];
    uint8_t *rom, *block;
    int most = 0;

    played(settings, frames, out, &rom, &block);
    for (int i = side; i < 2 * SND_FRAME; i += 2)
        most = abs(out[i]) > most ? abs(out[i]) : most;
    free(rom);
    free(block);
    return most / (16000 * 0.7071);
}

/* A gliding note has no larger jumps at the borders of frames than within them. */
TEST(borders)
{
    enum { FRAMES = 12 };
    static int16_t out[FRAMES * 2 * SND_FRAME];
    uint8_t *block, rom[INST_BYTES + 16] = { 0 };
    const struct inst inst = { .kind = INST_TRIANGLE, .env = { .sustain = 20000, .attack = 300, .decay = 3000 } };
    struct voices *v = make_voices(&block);
    int most[2] = { 0 };

    inst_write(rom + 16, &inst, NULL, "");
    for (int f = 0; f < FRAMES; f++) {
        voices_step(v, rom);
        v->gain1 = VOICE_FULL_GAIN;
        if (f == 0)
            voices_start_note(v, rom, 3, &(struct voice_note){ 16, 0, 57 * PITCH_ONE, 20000, 40 }, 123);
        if (f == 2)
            voices_glide(v, 3, 69 * PITCH_ONE, 9);
        voices_mix(v, rom, &tables, out + 2 * SND_FRAME * f);
    }
    for (int i = 1; i < FRAMES * SND_FRAME - 1; i++) {
        const int bend = abs(out[2 * i + 2] - 2 * out[2 * i] + out[2 * i - 2]);
        const bool at_border = i % SND_FRAME == 0 || (i + 1) % SND_FRAME == 0;
        most[at_border] = bend > most[at_border] ? bend : most[at_border];
    }
    assert_true(most[0] < 800 && most[1] <= most[0]);
    free(block);
}

#define NEAR(a, b, by) assert_true(fabs((a) - (b)) < (by))

/* Arpeggios jump where a frame begins, curves go straight from value to value, tremolo starts at the full level. */
TEST(shapes)
{
    static const double arpeggio[] = { 0, 0, 4, 4, 7, 7, 0, 0 };

    for (int f = 0; f < 8; f++) {
        NEAR(semitones("sine arpeggio=2:0,4,7", f + 1, 0), arpeggio[f], 0.001);
        NEAR(semitones("sine arpeggio=2:0,4,7", f + 1, 1), arpeggio[f], 0.001);
    }
    NEAR(semitones("sine pitch=2:0,1200,-600", 2, 1), 12, 0.001);
    NEAR(semitones("sine pitch=2:0,1200,-600", 3, 1), 3, 0.001);
    NEAR(semitones("sine pitch=2:0,1200,-600", 9, 1), -6, 0.001);
    NEAR(semitones("sine pitch=1:0,1200|500,300", 8, 1), 5, 0.001);
    NEAR(semitones("sine vibrato=100,15,0", 2, 1), 0, 0.02); /* half a turn in two frames */
    NEAR(semitones("sine vibrato=100,7.5,0", 2, 1), 1, 0.02);
    NEAR(loudness("sine attack=0 decay=0", 3, 0), 1, 0.01);
    NEAR(loudness("sine attack=0 decay=0 volume=2:100,50", 4, 0), 0.5, 0.01);
    NEAR(loudness("sine attack=0 decay=0 volume=2:0,100|20,60", 5, 0), 0.4, 0.01);
    NEAR(loudness("sine attack=0 decay=0 pan=1:-64", 3, 0), 1.414, 0.02);
    NEAR(loudness("sine attack=0 decay=0 pan=1:-64", 3, 1), 0, 0.001);
    NEAR(loudness("sine attack=0 decay=0 tremolo=100,20,0", 1, 0), 1, 0.05);
    NEAR(loudness("fm4 attack=0 decay=0 op2=1,0 op3=1,0 op4=1,0", 3, 0), 1, 0.01);
    NEAR(loudness("fm4 attack=0 decay=0 op1=1,50,0,16.667 op2=1,0 op3=1,0 op4=1,0", 3, 0), 0.125, 0.02);
    NEAR(loudness("wave harmonics=0,100 attack=0 decay=0", 3, 0), 27600 / 32767.0, 0.01);
}

RUN_TESTS(make_tables, NULL)
