/*
 * adpcm.h - sampled sounds: 16 bits per sample, or IMA ADPCM in blocks that can be decoded independently.
 *
 * A recording in a ROM is a header of SAMPLE_HEADER_SIZE bytes (u32 sample rate in Hz, u32 number of samples, u32 index
 * of the first sample of the loop or SAMPLE_NO_LOOP, u8 coding, three zero bytes), followed by the samples.
 * SAMPLE_PCM16: an i16 per sample. SAMPLE_ADPCM: blocks of ADPCM_BLOCK_BYTES: i16 first sample, u8 step index, a zero
 * byte, then two samples per byte, low half first, as in WAV files. A loop always ends at the last sample.
 */
#ifndef SOUND_ADPCM_H
#define SOUND_ADPCM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../base/int.h"

enum {
    SAMPLE_HEADER_SIZE = 16,
    SAMPLE_MIN_RATE = 4000,      /* minimum, Hz; the maximum is SND_RATE */
    SAMPLE_MAX_LENGTH = 1 << 25, /* maximum number of samples */
    ADPCM_BLOCK_BYTES = 256,
    ADPCM_BLOCK_SAMPLES = 505,
    ADPCM_STEPS = 89
};
#define SAMPLE_NO_LOOP UINT32_MAX

enum sample_coding { SAMPLE_ADPCM, SAMPLE_PCM16, SAMPLE_CODINGS };

struct sample {
    uint32_t rate, n, loop_start;
    enum sample_coding coding;
    const uint8_t *data;
};

/* Checks a sample of `size` bytes and stores its header in *s. Returns false if it is not valid. */
bool sample_open(const uint8_t *data, size_t size, struct sample *s);

/* Returns whether data is exactly n valid samples, one after another, all with the same length, rate and loop. */
bool samples_are_valid(const uint8_t *data, size_t size, int n);

/* Returns the header of a recording that sample_open has accepted. */
struct sample sample_of(const uint8_t *data);

/* Reads n samples, starting at index `from`. Negative indices read silence. Indices after the last sample repeat the
 * loop, or read silence if the recording has none. */
void sample_read(const struct sample *s, int64_t from, int n, int16_t *out);

/* Returns the size in bytes of a recording of n samples, including its header. */
size_t sample_size(uint32_t n, enum sample_coding coding);

/* ---- decoding ADPCM ---- */

struct adpcm_state {
    int32_t value, step_index;
};
extern const int16_t adpcm_steps[ADPCM_STEPS];

/* Returns the decoder state that follows s after a 4-bit code. */
static inline struct adpcm_state adpcm_next(struct adpcm_state s, int code)
{
    static const int8_t index_steps[8] = { -1, -1, -1, -1, 2, 4, 6, 8 };
    const int32_t d = ((code & 7) * 2 + 1) * adpcm_steps[s.step_index] >> 3;

    s.value = int_clamp(code & 8 ? s.value - d : s.value + d, -32768, 32767);
    s.step_index = int_clamp(s.step_index + index_steps[code & 7], 0, ADPCM_STEPS - 1);
    return s;
}

#endif
