/*
 * adpcm.c - the ear's section on recordings in a ROM: what their packing loses, and their loops.
 * floor: tools
 */
#include <math.h>
#include <stdlib.h>
#include "../../src/snd/adpcm.h"
#include "ear.h"

enum { N = 48000 };

static double tone(int i, double hertz)
{
    return sin(2 * M_PI * hertz * i / SND_RATE);
}

/* A chord, and its SNR after packing. */
static double packed(const double *hertz, int n)
{
    static int16_t in[N], out[N];
    static double right[N], heard[N];
    uint8_t *bytes = malloc(sample_size(N));

    if (!bytes)
        report_fail("out of memory");
    for (int i = 0; i < N; i++) {
        right[i] = 0;
        for (int k = 0; k < n; k++)
            right[i] += 24000.0 / n * tone(i, hertz[k]);
        in[i] = (int16_t)lrint(right[i]);
    }
    sample_write(bytes, in, N, SND_RATE, SAMPLE_ENDS);
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
    uint8_t *bytes = malloc(sample_size(LONG));
    int apart = 0;

    if (!bytes)
        report_fail("out of memory");
    for (int i = 0; i < LONG; i++)
        in[i] = (int16_t)lrint(20000 * tone(i, 500));
    sample_write(bytes, in, LONG, SND_RATE, LOOP);
    const struct sample s = sample_of(bytes);
    sample_read(&s, 0, READ, out);
    for (int i = LONG; i < READ; i++)
        apart += out[i] != out[LOOP + (i - LOOP) % (LONG - LOOP)];
    free(bytes);
    return apart;
}

void section_adpcm(void)
{
    static const double CHORD[] = { 382, 2368 }, LOW[] = { 110 }, HIGH[] = { 5000 };

    report_section("Recordings in a ROM");
    report_text(
        "IMA ADPCM in blocks of %d samples, each of which can be entered without those before. A difference is\n"
        "decoded as `(2n + 1) * step >> 3`.",
        (int)ADPCM_SAMPLES);
    report_table(NULL, "what is packed|SNR, dB>");
    report_row(1, "a tone of 110 Hz", ear_db(packed(LOW, 1)), NULL);
    report_row(1, "two tones, 382 and 2,368 Hz", ear_db(packed(CHORD, 2)), NULL);
    report_row(1, "a tone of 5 kHz", ear_db(packed(HIGH, 1)), NULL);
    report_table_end();
    const int apart = loop_apart();
    report_text("A loop is exact to the sample: of 17,000 samples of eight turns %d are others than in the first.",
                apart);
    ear_figure("samples of a loop that are others than in its first turn", report_string("%d", apart), "0", apart == 0);
}
