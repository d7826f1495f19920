/*
 * test_record.c - recordings: what of WAV, OGG, FLAC and modules is read, ADPCM and other rates, the tunes they become,
 * what is refused and in which words, and that no damage is more than a sentence.
 */
#include "../test.h"
#include <math.h>
#include "../../src/base/bytes.h"
#include "../../src/base/hash.h"
#include "../../src/base/rng.h"
#include "../../src/common/files.h"
#include "../../src/common/library.h"
#include "../../src/workbench/samples/encode.h"
#include "../../src/workbench/samples/flaws.h"
#include "../../src/workbench/samples/recording.h"
#include "../../src/sound/tune.h"
#include "../temp.h"

static const char *const seeds[] = { "stereo.wav", "loop.wav", "loop.ogg", "mono.opus", "loop.flac",
                                     "mono.flac",  "tiny.mod", "tiny.xm",  "tiny.s3m",  "tiny.it" };
enum { SEED_FILES = sizeof seeds / sizeof *seeds };

static uint8_t *load(const char *name, size_t *n)
{
    char path[256], err[256];
    uint8_t *data;

    snprintf(path, sizeof path, "tests/fuzz/seeds/fuzz_recording/%s", name);
    if (!files_read(path, name, 1 << 20, &data, n, err, sizeof err))
        fail_msg("%s", err);
    return data;
}

static const struct art_loop own_loop = { .kind = LOOP_FROM_FILE }, no_loop = { .kind = LOOP_NONE };

static struct pcm read_seed(const char *name, const struct art_loop *loop)
{
    struct pcm p;
    char err[256];
    size_t n;
    uint8_t *data = load(name, &n);

    if (!recording_read(name, data, n, loop, &p, err, sizeof err))
        fail_msg("%s: %s", name, err);
    free(data);
    return p;
}

/* ---- files ---- */

static size_t make_wav(uint8_t *p, int channels, int bits, uint32_t rate, uint32_t frames)
{
    const uint32_t bytes = frames * (uint32_t)(channels * bits / 8);

    memset(p, 0, 44 + bytes);
    memcpy(p, "RIFF....WAVEfmt ", 16);
    bytes_put32(p + 4, 36 + bytes);
    bytes_put32(p + 16, 16);
    bytes_put16(p + 20, 1);
    bytes_put16(p + 22, (uint16_t)channels);
    bytes_put32(p + 24, rate);
    bytes_put16(p + 34, (uint16_t)bits);
    memcpy(p + 36, "data", 4);
    bytes_put32(p + 40, bytes);
    for (uint32_t i = 0; i < bytes; i++)
        p[44 + i] = (uint8_t)(i * 7);
    return 44 + bytes;
}

static void wav_refuses(const uint8_t *p, size_t n, const char *message)
{
    struct pcm out;
    char err[256];

    assert_false(pcm_read_wav(p, n, &out, err, sizeof err));
    assert_string_equal(err, message);
}

/* The length in front is ignored, as players do; programs that write into a pipe leave both lengths open. */
TEST(wav_lengths)
{
    static const uint32_t lengths[][2] = {
        { 0, 1200 }, { 0x7ffff024, 1200 }, { 0, 0 }, { 0x7ffff000, 0x7ffff000 }, { UINT32_MAX, UINT32_MAX }
    };
    static uint8_t p[2048];
    const size_t n = make_wav(p, 1, 16, 44100, 600);
    struct pcm out;
    char err[256];

    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        bytes_put32(p + 4, lengths[i][0]);
        bytes_put32(p + 40, lengths[i][1]);
        assert_true(pcm_read_wav(p, n, &out, err, sizeof err) && out.n == 600);
        pcm_free(&out);
    }
    make_wav(p, 1, 16, 44100, 600);
    memcpy(p + n, "an end of another program", 25);
    assert_true(pcm_read_wav(p, n + 25, &out, err, sizeof err) && out.n == 600);
    pcm_free(&out);
    wav_refuses(p, n - 1, "chunk \"data\" of 1200 bytes is longer than the file");
}

TEST(wav)
{
    static uint8_t p[8192];
    struct pcm out;
    char err[256];

    for (int bits = 8; bits <= 32; bits += 8)
        for (int channels = 1; channels <= 2; channels++) {
            size_t n = make_wav(p, channels, bits, 22050, 600);
            for (int c = 0; c < channels; c++) /* -2048 left, -1024 right */
                for (int b = 0; b < 4 && b < bits / 8; b++)
                    p[44 + c * bits / 8 + b] =
                        (uint8_t)(bits == 8 ? (c ? 124 : 120) : (c ? -1024 : -2048) * 65536 >> (32 - bits + 8 * b));
            assert_true(pcm_read_wav(p, n, &out, err, sizeof err));
            assert_true(out.n == 600 && out.rate == 22050 && out.channels == channels && out.loop == -1);
            assert_int_equal(out.frames[0], -2048);
            assert_true(channels == 1 || out.frames[1] == -1024);
            pcm_free(&out);
        }
    size_t n = make_wav(p, 1, 32, 44100, 3);
    const float values[] = { 0.5f, 1.5f, -0.25f };
    p[20] = 3;
    memcpy(p + 44, values, sizeof values);
    assert_true(pcm_read_wav(p, n, &out, err, sizeof err));
    assert_true(out.frames[0] == 16384 && out.frames[1] == 32767 && out.frames[2] == -8192 && out.clipped == 1);
    pcm_free(&out);
    n = make_wav(p, 1, 16, 44100, 600);
    wav_refuses(p, 8, "expected a WAV file (RIFF, WAVE)");
    wav_refuses(p, 36, "no chunk \"data\"");
    p[20] = 2;
    wav_refuses(p, n, "expected PCM samples (format 1: integers, or format 3: floats), got format 2");
    n = make_wav(p, 3, 16, 44100, 600);
    wav_refuses(p, n, "expected one or two channels, got 3");
    make_wav(p, 1, 12, 44100, 600);
    bytes_put32(p + 4, UINT32_MAX);
    wav_refuses(p, n, "expected samples of 8, 16, 24 or 32 bits, got 12");
    n = make_wav(p, 1, 16, 400000, 600);
    wav_refuses(p, n, "expected a sample rate of 4000 to 384000 Hz, got 400000");
}

/* How far below the one is what differs from the other, in dB. */
static double below(const int16_t *a, const int16_t *b, size_t n)
{
    double loud = 0, wrong = 1e-9;

    for (size_t i = 0; i < n; i++) {
        loud += a[i] * (double)a[i];
        wrong += (a[i] - b[i]) * (double)(a[i] - b[i]);
    }
    return 10 * log10(loud / wrong);
}

static void needs_libraries(void)
{
    if (sizeof(void *) == 4 && !library_open(LIBRARY_SNDFILE, NULL, 0))
        skip(); /* libsndfile is rarely there in 32 bits: WAV and ADPCM alone */
}

TEST(library)
{
    struct pcm flac = read_seed("loop.flac", &own_loop), ogg = read_seed("loop.ogg", &own_loop);
    struct pcm opus = read_seed("mono.opus", &own_loop), wav = read_seed("loop.wav", &own_loop);

    needs_libraries();
    assert_true(flac.n == 2400 && flac.rate == 12000 && flac.channels == 2 && flac.loop == 600 &&
                flac.loop_end == 2400);
    assert_true(ogg.n == 2400 && ogg.rate == 12000 && ogg.channels == 2 && ogg.loop == 600 && ogg.loop_end == 2400);
    for (int i = 0; i < 2400; i++) {
        const double left = sin(i * 0.05) * 0.5 + sin(i * 0.31) * 0.2;
        assert_true(fabs(flac.frames[2 * i] - left * 32767) < 0.51);
    }
    assert_true(below(flac.frames, ogg.frames, 4800) > 15);
    /* the first 52 frames of 48 kHz are the codec's; it counts loops at 48 kHz */
    assert_true(opus.channels == 1 && opus.loop * 48000 == 2400 * (int64_t)opus.rate &&
                (opus.loop_end - opus.loop) * 48000 == 4800 * (int64_t)opus.rate);
    assert_true(wav.loop == 100 && wav.loop_end == 400 && wav.n == 400);
    assert_memory_equal(wav.frames, flac.frames, 400 * 4);
    pcm_free(&flac), pcm_free(&ogg), pcm_free(&opus), pcm_free(&wav);
}

/* A module as the library plays it on and on: n frames. */
static float *played_on(const char *name, size_t n)
{
    void *(*open)(const void *data, size_t size, void *log, void *log_user, void *fail, void *fail_user, int *error,
                  const char **message, const void *ctls);
    int (*repeat)(void *module, int32_t times);
    size_t (*read)(void *module, int32_t rate, size_t frames, float *to);
    void (*close)(void *module);
    const struct library_function list[] = { { "openmpt_module_create_from_memory2", &open },
                                             { "openmpt_module_set_repeat_count", &repeat },
                                             { "openmpt_module_read_interleaved_float_stereo", &read },
                                             { "openmpt_module_destroy", &close } };
    float *out = calloc(2 * n, sizeof *out);
    size_t size;
    uint8_t *data = load(name, &size);

    assert_true(library_open(LIBRARY_OPENMPT, list, 4));
    void *module = open(data, size, NULL, NULL, NULL, NULL, NULL, NULL, NULL);
    assert_true(out && module && repeat(module, -1) == 1);
    assert_int_equal(read(module, 48000, n, out), n);
    close(module);
    free(data);
    return out;
}

/* A program that writes into a pipe does not state the length in STREAMINFO: 36 bits from byte 21 on. */
TEST(open_flac)
{
    struct pcm p, stated = read_seed("loop.flac", &own_loop);
    char err[256];
    size_t n;
    uint8_t *data = load("loop.flac", &n);

    needs_libraries();
    data[21] &= 0xf0;
    memset(data + 22, 0, 4);
    assert_true(recording_read("a.flac", data, n, &own_loop, &p, err, sizeof err));
    assert_true(p.n == stated.n && p.loop == stated.loop);
    assert_memory_equal(p.frames, stated.frames, p.n * (size_t)p.channels * sizeof *p.frames);
    pcm_free(&p);
    pcm_free(&stated);
    for (size_t cut = 0; cut < n; cut++) /* it may end behind any whole frame; all but the last have 1152 samples */
        if (recording_read("a.flac", data, cut, &own_loop, &p, err, sizeof err)) {
            assert_true(p.n == 1152 || p.n == 2304);
            pcm_free(&p);
        }
    free(data);
}

/* One ID3 tag or two in front, without and with a footer, and one at the end. */
TEST(id3)
{
    char err[256];

    needs_libraries();
    for (int kind = 0; kind < 4; kind++) {
        const size_t tag = 10 + 300 + (kind & 1 ? 10 : 0), front = kind & 2 ? 2 * tag : tag;
        struct pcm p, bare = read_seed("loop.flac", &own_loop);
        size_t n;
        uint8_t *data = load("loop.flac", &n), *tagged = calloc(front + n + 128, 1);
        for (size_t at = 0; at < front; at += tag) {
            memcpy(tagged + at, "ID3\x04\x00\x00\x00\x00\x02\x2c", 10); /* 2 * 128 + 44 */
            tagged[at + 5] = kind & 1 ? 16 : 0;
        }
        memcpy(tagged + front, data, n);
        memcpy(tagged + front + n, "TAG", 3);
        assert_true(recording_read("a.flac", tagged, front + n + 128, &own_loop, &p, err, sizeof err));
        assert_true(p.n == bare.n && p.loop == bare.loop);
        pcm_free(&p);
        pcm_free(&bare);
        free(data);
        free(tagged);
    }
}

/* Each loops exactly: for ten passes and more it is, to the last bit, what the library plays on and on. */
TEST(modules)
{
    static const struct {
        const char *name;
        uint32_t n, once;
        int loop, tempo;
    } list[] = { { "tiny.mod", 15360, 7680, 7680, 125 },
                 { "tiny.xm", 15360, 15360, 7680, 375 },
                 { "tiny.s3m", 15360, 7680, 7680, 375 },
                 { "tiny.it", 7680, 7680, 0, 375 } };

    needs_libraries();
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        struct pcm p = read_seed(list[k].name, &own_loop);
        assert_true(p.n == list[k].n && p.loop == list[k].loop);
        assert_true(fabs(p.tempo - list[k].tempo) < 1e-6);
        float *all = played_on(list[k].name, 100000);
        for (int64_t i = 0; i < 100000; i++) {
            const int64_t at = i < p.n ? i : p.loop + (i - p.loop) % (p.n - p.loop);
            for (int c = 0; c < 2; c++)
                assert_int_equal(p.frames[2 * at + c], lrint((double)all[2 * i + c] * 32768));
        }
        free(all);
        pcm_free(&p);
        p = read_seed(list[k].name, &no_loop);
        assert_true(p.n == list[k].once && p.loop == -1);
        pcm_free(&p);
    }
}

/* ---- ADPCM ---- */

/* Random blocks become the samples that ffmpeg 5.1.9 gave for them as a WAV file of IMA ADPCM. */
TEST(decoder)
{
    enum { BLOCKS = 60, N = BLOCKS * ADPCM_BLOCK_SAMPLES };
    static uint8_t bytes[SAMPLE_HEADER_SIZE + BLOCKS * ADPCM_BLOCK_BYTES];
    static int16_t out[N];
    uint8_t *p = bytes + SAMPLE_HEADER_SIZE;
    struct sample s;
    struct rng r;
    uint64_t h = HASH_START;

    rng_seed(&r, 31);
    for (int i = 0; i < BLOCKS * ADPCM_BLOCK_BYTES; i++)
        p[i] = (uint8_t)rng_next(&r);
    for (int b = 0; b < BLOCKS; b++) {
        p[b * ADPCM_BLOCK_BYTES + 2] %= ADPCM_STEPS;
        p[b * ADPCM_BLOCK_BYTES + 3] = 0;
    }
    bytes_put32(bytes, 48000);
    bytes_put32(bytes + 4, N);
    bytes_put32(bytes + 8, SAMPLE_NO_LOOP);
    assert_true(sample_open(bytes, sizeof bytes, &s));
    sample_read(&s, 0, N, out);
    for (int i = 0; i < N; i++)
        h = hash_fold(h, (uint16_t)out[i]);
    assert_true(h == 0x66e0ea38f190ae26u);
}

/* 16 bits lose nothing; ADPCM loses little. */
TEST(encoder)
{
    enum { N = 5050 };
    static int16_t in[N], out[N];
    static uint8_t bytes[SAMPLE_HEADER_SIZE + 2 * N];
    struct sample s;

    for (int i = 0; i < N; i++)
        in[i] = (int16_t)(9000 * sin(i * 0.11) * exp(-(i % 1700) / 600.0) + 3000 * sin(i * 0.47 + sin(i * 0.013)));
    assert_int_equal(sample_size(N, SAMPLE_PCM16), sizeof bytes);
    encode_sample(bytes, in, N, 44100, 50, SAMPLE_PCM16);
    assert_true(sample_open(bytes, sizeof bytes, &s) && s.loop_start == 50 && s.coding == SAMPLE_PCM16);
    sample_read(&s, 0, N, out);
    assert_memory_equal(in, out, sizeof in);
    sample_read(&s, N + 49, 100, out);
    assert_memory_equal(in + 50 + 49, out, 200);
    encode_sample(bytes, in, N, 44100, SAMPLE_NO_LOOP, SAMPLE_ADPCM);
    assert_true(sample_open(bytes, sample_size(N, SAMPLE_ADPCM), &s));
    sample_read(&s, 0, N, out);
    assert_true(below(in, out, N) > 29.45);
    bytes[12] = SAMPLE_CODINGS;
    assert_false(sample_open(bytes, sizeof bytes, &s));
}

/* ---- other rates ---- */

static struct pcm sine(uint32_t rate, uint32_t n, double hertz, int64_t loop)
{
    struct pcm p = { .rate = rate, .channels = 1, .loop = loop, .loop_end = -1 };

    for (uint32_t i = 0; i < n; i++) {
        const float v = (float)(0.5 * sin(2 * 3.14159265358979 * hertz * i / rate));
        assert_true(pcm_add(&p, &v, 1));
    }
    return p;
}

/* The sample at this rate, prepared: from 48,000 on at 48,000. */
static struct pcm prepared(uint32_t rate, uint32_t n, double hertz, int64_t loop)
{
    const struct art_loop own = { 0 };
    struct pcm p = sine(rate, n, hertz, loop);
    char err[256];

    assert_true(recording_prepare(&p, &own, err, sizeof err));
    return p;
}

/* A rate above 48,000 comes down to it: what can be heard stays, what would fold is gone, a loop is whole. */
TEST(rates)
{
    int16_t expected[4800];

    struct pcm p = prepared(44100, 4410, 1000, -1);
    assert_true(p.rate == 44100 && p.n == 4410);
    pcm_free(&p);
    p = prepared(88200, 8820, 5000, -1);
    assert_true(p.rate == 48000 && p.n == 4800);
    for (int i = 0; i < 4800; i++)
        expected[i] = (int16_t)lrint(16384 * sin(2 * 3.14159265358979 * 5000 * i / 48000));
    assert_true(below(expected + 100, p.frames + 100, 4600) > 80);
    pcm_free(&p);
    p = prepared(96000, 9600, 30000, -1);
    for (int i = 100; i < 4700; i++)
        assert_true(abs(p.frames[i]) <= 2);
    pcm_free(&p);
    p = prepared(96000, 9600, 300, 960); /* 27 turns in 8640 frames: so it goes on over the loop's end */
    assert_true(p.n == 4800 && p.loop == 480);
    for (int at = 4000; at < 7000; at++) {
        const int there = at < 4800 ? at : 480 + (at - 480) % 4320;
        assert_true(abs(p.frames[there] - (int)lrint(16384 * sin(2 * 3.14159265358979 * 300 * at / 48000))) <= 4);
    }
    pcm_free(&p);
}

/* Prepared with this loop, frames 300 to 1000 of a sample become this range. */
static void loops_at(const struct art_loop *loop, int64_t from, int64_t n)
{
    struct pcm p = sine(10000, 1000, 500, 300);
    char err[256];

    assert_true(recording_prepare(&p, loop, err, sizeof err));
    assert_int_equal(p.loop, from);
    assert_int_equal(p.n, n);
    pcm_free(&p);
}

TEST(loops)
{
    loops_at(&own_loop, 300, 1000);
    loops_at(&(struct art_loop){ LOOP_RANGE, true, 0.02, 0.05 }, 200, 700);
    loops_at(&(struct art_loop){ .kind = LOOP_WHOLE }, 0, 1000);
    loops_at(&no_loop, -1, 1000);
}

TEST(flaws)
{
    struct pcm p = sine(10000, 10000, 500, 4000);
    struct flaws f;

    flaws_measure_frames(&p, &f);
    flaws_measure_loop(&p, &f);
    assert_true(f.clipped == 0 && fabs(f.dc_offset) < 0.0001 && !f.clicks);
    p.loop = 4003; /* of 20 frames: not where it goes on */
    flaws_measure_loop(&p, &f);
    assert_true(f.clicks && f.jump > 0.2 && f.nearby > 0.04 && f.nearby < 0.06);
    for (int i = 0; i < 10000; i++)
        p.frames[i] = (int16_t)(p.frames[i] + 1638);
    p.frames[300] = p.frames[301] = 32767; /* twice is no clipping */
    p.frames[77] = p.frames[78] = p.frames[79] = p.frames[80] = -32768;
    flaws_measure_frames(&p, &f);
    assert_true(f.clipped == 4 && f.first_clipped == 77 && fabs(f.dc_offset - 0.05) < 0.001);
    p.clipped = 5;
    p.clipped_at = 9;
    flaws_measure_frames(&p, &f);
    assert_true(f.clipped == 5 && f.first_clipped == 9);
    pcm_free(&p);
}

/* ---- the tunes they become ---- */

/* The events of a track in n samples. */
static const char *events(const uint8_t *tune, int track, int64_t samples)
{
    static const char names[] = ".nso/ivptm";
    static char list[2048];
    const struct tune t = tune_of(tune);
    struct track_cursor c = tune_track_start(&t, track);
    struct tune_played_event e;
    size_t n = 0;

    list[0] = '\0';
    for (long long at = 0; at < samples && c.cursor; at += 800) {
        struct tune_run run = { &t, track, c, t.tempo, 0, 800, 0 };
        while (tune_next_event(&run, &e) && n < sizeof list)
            n += (size_t)snprintf(list + n, sizeof list - n, "%lld%c%d ", at + e.sample, names[e.event], e.value);
        c = run.cursor;
    }
    return list;
}

TEST(sound)
{
    struct art_sound about = { .title = "Drum", .volume = 200, .priority = 3, .limit = 5 };
    struct pcm p = sine(24000, 2400, 500, -1);
    struct recording_bytes b;
    char err[256];

    assert_true(recording_sound(&p, &about, &b, err, sizeof err) && tune_validate(b.data, b.n, err, sizeof err));
    const struct tune t = tune_of(b.data);
    assert_true(t.n_tracks == 1 && t.channels == 1 && t.volume == 200 && t.priority == 3 && t.limit == 5);
    assert_true(tune_is_recording(&t) && !tune_is_stream(&t) && !tune_is_endless(&t));
    assert_string_equal(tune_title(&t), "Drum");
    assert_string_equal(events(b.data, 0, 48000), "0i0 0p64 0v127 0n15360 4800.0 ");
    free(b.data);
    pcm_free(&p);
}

static struct pcm silence(int64_t tenths, int64_t loop)
{
    static float quiet[2 * 4410];
    struct pcm p = { .rate = 44100, .channels = 2, .loop = loop, .loop_end = -1 };

    for (int64_t i = 0; i < tenths; i++)
        assert_true(pcm_add(&p, quiet, 4410));
    return p;
}

TEST(stereo_sound)
{
    struct art_sound about = { .volume = 200, .limit = 5 };
    struct pcm p = silence(1, 0);
    struct recording_bytes b;
    char err[256];

    for (int sides = 1; sides <= 2; sides++) {
        about.stereo = sides == 2;
        assert_true(recording_sound(&p, &about, &b, err, sizeof err) && tune_validate(b.data, b.n, err, sizeof err));
        const struct tune t = tune_of(b.data);
        assert_true(t.n_tracks == sides && t.channels == sides && tune_is_endless(&t));
        free(b.data);
    }
    pcm_free(&p);
}

/* The tune of p and its samples, both valid; the latter are freed. */
static struct recording_bytes music_of(const struct pcm *p, const struct art_sound *about,
                                       const struct art_marker *markers)
{
    struct recording_bytes tune, wave;
    char err[256];

    assert_true(recording_music(p, about, markers, &tune, &wave, err, sizeof err));
    assert_true(tune_validate(tune.data, tune.n, err, sizeof err));
    assert_true(samples_are_valid(wave.data, wave.n, p->channels));
    free(wave.data);
    return tune;
}

static const struct art_marker markers[] = { { "", 0 }, { "drop", 5 }, { "lead", 0 }, { "off", 12.5 } };
static const struct art_sound at_120_beats = {
    .volume = 255, .limit = 1, .beats_per_bar = 4, .tempo = 12000, .stereo = true
};

/* At 120 beats a minute a beat is 24,000 samples. The loop is 12 beats, its first marker in beat 5. */
TEST(music)
{
    struct art_sound about = at_120_beats;
    struct pcm p = silence(81, 4410 + 88200); /* 0.1 s and 16 beats */

    about.offset = 0.1;
    about.first_marker = 1;
    about.n_markers = 3;
    struct recording_bytes tune = music_of(&p, &about, markers);
    const struct tune t = tune_of(tune.data);
    assert_true(t.n_tracks == 2 && t.channels == 2 && tune_is_stream(&t) && t.tempo == 12000 && t.lead == 4800 &&
                t.loop_units == 0);
    assert_string_equal(events(tune.data, 1, 48000 * 9), "0i1 0p128 0v127 0n15360 100800v127 100800v127 388800v127 ");
    assert_string_equal(events(tune.data, -1, 48000 * 15),
                        "4800m1 124800t12000 124800m0 304800m2 412800m0 592800m2 700800m0 ");
    free(tune.data);
    pcm_free(&p);
}

/* The loop is not a whole number of ticks: marker 0 of pass i is where i whole loops put it, rounded up once. */
TEST(markers_do_not_drift)
{
    struct art_sound about = at_120_beats;
    struct pcm p = silence(81, 4410 + 88200);

    about.tempo = 9999;
    about.first_marker = 1;
    about.n_markers = 1;
    struct recording_bytes tune = music_of(&p, &about, markers);
    const char *all_events = events(tune.data, -1, 48000 * 200);
    for (int i = 0; i < 30; i++) {
        char expected[64];
        const int64_t loop = (p.n - p.loop) * 480 / 441 * 9999, units = 5 * 480 * (int64_t)TUNE_TICK + i * loop;
        snprintf(expected, sizeof expected, "%lldm0 ", (long long)((units + 9998) / 9999));
        if (!strstr(all_events, expected))
            fail_msg("%s in %s", expected, all_events);
    }
    free(tune.data);
    pcm_free(&p);
}

TEST(music_without_loop)
{
    struct art_sound about = at_120_beats;
    struct pcm p = silence(10, -1);
    struct recording_bytes tune = music_of(&p, &about, markers);

    assert_string_equal(events(tune.data, -1, 96000), "0.0 ");
    assert_string_equal(events(tune.data, 0, 96000), "0i0 0p0 0v127 0n15360 48000.0 ");
    free(tune.data);
    p.loop = p.n - 7; /* shorter than a tick */
    p.tempo = 97.25;  /* the file's, as rom.lua sets none */
    about.tempo = 0;
    tune = music_of(&p, &about, markers);
    assert_int_equal(tune_of(tune.data).tempo, 9725);
    free(tune.data);
    pcm_free(&p);
}

/* ---- damage ---- */

/* Takes it, and then it becomes a sound, or says in one line why not. */
static bool takes(const char *name, const uint8_t *data, size_t n)
{
    const struct art_sound about = { .volume = 255, .limit = 1, .stereo = true, .exact = true };
    struct recording_bytes b;
    struct pcm p;
    char err[256] = "";

    bool good = recording_read(name, data, n, &own_loop, &p, err, sizeof err);
    if (good) {
        good = recording_prepare(&p, &(struct art_loop){ 0 }, err, sizeof err);
        if (good && p.n < 1 << 16) {
            assert_true(recording_sound(&p, &about, &b, err, sizeof err));
            if (!tune_validate(b.data, b.n, err, sizeof err))
                fail_msg("%s: %s", name, err);
            free(b.data);
        }
        pcm_free(&p);
    }
    if (!good && (strlen(err) < 9 || strchr(err, '\n')))
        fail_msg("%s: \"%s\"", name, err);
    return good;
}

/* No WAV, OGG or FLAC is taken that was cut off, but for a WAV that ends between two chunks. Modules may be: what is
 * missing is silence. */
TEST(truncated)
{
    needs_libraries();
    for (int i = 0; i < SEED_FILES; i++) {
        size_t n;
        uint8_t *data = load(seeds[i], &n);
        const size_t before_smpl = strcmp(seeds[i], "loop.wav") == 0 ? 1644 : SIZE_MAX;
        assert_true(takes(seeds[i], data, n));
        for (size_t cut = 0; cut < n; cut++) {
            uint8_t *part = malloc(cut + (cut == 0)); /* of exactly this size */
            memcpy(part, data, cut);
            if (takes(seeds[i], part, cut) && strncmp(seeds[i], "tiny", 4) != 0 && cut != before_smpl)
                fail_msg("%s: taken with %zu bytes of %zu", seeds[i], cut, n);
            free(part);
        }
        free(data);
    }
}

/* An OGG file of many pages that was cut off behind one of them. */
TEST(cut_pages)
{
    uint8_t *data;
    size_t n, last;
    struct pcm p;
    char err[256];

    needs_libraries();
    assert_true(files_read("examples/tape/music/reel.ogg", "reel.ogg", 1 << 20, &data, &n, err, sizeof err));
    assert_true(takes("reel.ogg", data, n));
    for (last = n - 4; memcmp(data + last, "OggS", 4) != 0;)
        last--;
    assert_false(recording_read("reel.ogg", data, last, &own_loop, &p, err, sizeof err));
    assert_string_equal(err, "truncated before its last page");
    data[last - 1] ^= 1;
    assert_false(recording_read("reel.ogg", data, n, &own_loop, &p, err, sizeof err));
    assert_non_null(strstr(err, ": wrong checksum"));
    free(data);
}

/* Some bytes of a page are changed and its checksum is made good, so that what is behind that sees them. */
static void repair_page(uint8_t *p, size_t n)
{
    for (size_t at = 0; at + 27 <= n && memcmp(p + at, "OggS", 4) == 0;) {
        size_t size = 27u + p[at + 26];
        for (size_t i = 0; i < p[at + 26] && at + 27 + i < n; i++)
            size += p[at + 27 + i];
        if (size > n - at)
            return;
        uint32_t crc = 0;
        bytes_put32(p + at + 22, 0);
        for (size_t i = 0; i < size; i++) {
            crc ^= (uint32_t)p[at + i] << 24;
            for (int k = 0; k < 8; k++)
                crc = crc << 1 ^ (crc >> 31 ? 0x04c11db7u : 0);
        }
        bytes_put32(p + at + 22, crc);
        at += size;
    }
}

/* Ten thousand recordings with some bits changed. */
TEST(damage)
{
    int taken = 0;
    struct rng r;

    needs_libraries();
    rng_seed(&r, 17);
    for (int i = 0; i < 10000; i++) {
        const int k = i % 16 == 0 ? 6 + i / 16 % 4 : i % 6; /* modules more seldom, for they take long */
        size_t n;
        uint8_t *data = load(seeds[k], &n);
        for (int b = 0; b < 1 + i % 3; b++)
            data[rng_next(&r) % (i % 2 && n > 256 ? 256 : n)] ^= (uint8_t)(1 << rng_next(&r) % 8);
        if (strstr(seeds[k], ".o") && i % 4)
            repair_page(data, n);
        taken += takes(seeds[k], data, n);
        free(data);
    }
    assert_in_range(taken, 1000, 9000);
}

RUN_TESTS(NULL, NULL)
