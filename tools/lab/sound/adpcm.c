/*
 * adpcm.c - the ear's section on recordings in a ROM: what their packing loses, and their loops.
 */
#include <math.h>
#include <stdlib.h>
#include "../../../src/base/bytes.h"
#include "../../../src/base/hash.h"
#include "../../../src/base/rng.h"
#include "../../../src/workbench/samples/encode.h"
#include "ear.h"

enum { N = 48000 };

static double tone(int i, double hertz)
{
    return sin(2 * M_PI * hertz * i / SND_RATE);
}

/* A chord, and its SNR after packing. */
static double packed(const double *hertz, int n, enum sample_coding coding)
{
    static int16_t in[N], out[N];
    static double right[N], heard[N];
    uint8_t *bytes = malloc(sample_size(N, coding));

    if (!bytes)
        report_fail("out of memory");
    for (int i = 0; i < N; i++) {
        right[i] = 0;
        for (int k = 0; k < n; k++)
            right[i] += 24000.0 / n * tone(i, hertz[k]);
        in[i] = (int16_t)lrint(right[i]);
    }
    encode_sample(bytes, in, N, SND_RATE, SAMPLE_NO_LOOP, coding);
    const struct sample s = sample_of(bytes);
    sample_read(&s, 0, N, out);
    for (int i = 0; i < N; i++)
        heard[i] = out[i];
    free(bytes);
    return ear_snr(right, heard, N);
}

/* Samples of many turns of a loop that are not those of the first one. */
static int loop_apart(void)
{
    enum { LONG = 3000, LOOP = 700, READ = 20000 };
    static int16_t in[LONG], out[READ];
    uint8_t *bytes = malloc(sample_size(LONG, SAMPLE_ADPCM));
    int apart = 0;

    if (!bytes)
        report_fail("out of memory");
    for (int i = 0; i < LONG; i++)
        in[i] = (int16_t)lrint(20000 * tone(i, 500));
    encode_sample(bytes, in, LONG, SND_RATE, LOOP, SAMPLE_ADPCM);
    const struct sample s = sample_of(bytes);
    sample_read(&s, 0, READ, out);
    for (int i = LONG; i < READ; i++)
        apart += out[i] != out[LOOP + (i - LOOP) % (LONG - LOOP)];
    free(bytes);
    return apart;
}

enum { BLOCKS = 60, DECODED = BLOCKS * ADPCM_BLOCK_SAMPLES };

/* Blocks of any beginning, step and codes, the same that tests/unit/test_record.c gives to ffmpeg. Their digest. */
static uint64_t decoded(void)
{
    static uint8_t bytes[SAMPLE_HEADER_SIZE + BLOCKS * ADPCM_BLOCK_BYTES];
    static int16_t out[DECODED];
    uint8_t *blocks = bytes + SAMPLE_HEADER_SIZE;
    uint64_t h = HASH_START;
    struct rng r;

    rng_seed(&r, 31);
    for (int i = 0; i < BLOCKS * ADPCM_BLOCK_BYTES; i++)
        blocks[i] = (uint8_t)rng_next(&r);
    for (int b = 0; b < BLOCKS; b++) {
        blocks[b * ADPCM_BLOCK_BYTES + 2] %= ADPCM_STEPS;
        blocks[b * ADPCM_BLOCK_BYTES + 3] = 0;
    }
    bytes_put32(bytes, SND_RATE);
    bytes_put32(bytes + 4, DECODED);
    bytes_put32(bytes + 8, SAMPLE_NO_LOOP);
    const struct sample s = sample_of(bytes);
    sample_read(&s, 0, DECODED, out);
    for (int i = 0; i < DECODED; i++)
        h = hash_fold(h, (uint16_t)out[i]);
    return h;
}

static const uint64_t ffmpeg_5_1_9 = 0x66e0ea38f190ae26u;

void section_adpcm(void)
{
    static const struct {
        const char *what;
        double hertz[2];
        int n;
    } TONES[] = { { "a tone of 110 Hz", { 110 }, 1 },
                  { "two tones, 382 and 2,368 Hz", { 382, 2368 }, 2 },
                  { "a tone of 5 kHz", { 5000 }, 1 } };
    const bool equal = decoded() == ffmpeg_5_1_9;

    report_section("Samples in a ROM");
    report_text("A ROM stores sound as 16-bit values or as IMA ADPCM, which takes a quarter of the space. Blocks of %d "
                "ADPCM values are\n"
                "decoded independently. A difference is decoded as `(2n + 1) * step >> 3`. In a test with blocks of "
                "random data, %s of\n"
                "the %s values differ from ffmpeg's.",
                (int)ADPCM_BLOCK_SAMPLES, equal ? "none" : "some", report_count(DECODED));
    report_table(NULL, "sound|ADPCM, SNR, dB>|16 bits, SNR, dB>");
    for (size_t k = 0; k < sizeof TONES / sizeof *TONES; k++)
        report_row(1, TONES[k].what, ear_db(packed(TONES[k].hertz, TONES[k].n, SAMPLE_ADPCM)),
                   ear_db(packed(TONES[k].hertz, TONES[k].n, SAMPLE_PCM16)), NULL);
    report_table_end();
    const int apart = loop_apart();
    report_text("Loops are exact: in eight passes of a loop, %d of 17,000 values differ from the first pass.", apart);
    ear_figure("ADPCM values that ffmpeg decodes differently",
               report_string(equal ? "0 of %s" : "some of %s", report_count(DECODED)), "0 of 96,455", equal);
    ear_figure("values of later passes of a loop that differ from the first pass", report_string("%d", apart), "0",
               apart == 0);
}
