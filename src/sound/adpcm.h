/*
 * adpcm.h - recordings: 16 bits a sample, or IMA ADPCM in blocks that can be entered anywhere.
 *
 * A sample in a ROM is a header of SAMPLE_HEADER bytes (u32 frames a second, u32 samples, u32 the first sample of its
 * loop, or SAMPLE_ENDS; u8 its coding, three zero bytes) and what it is made of. SAMPLE_EXACT: i16 each. SAMPLE_PACKED:
 * blocks of ADPCM_BYTES: i16 the first sample, u8 the step's index, a zero byte, then two samples a byte, low half
 * first, as in WAV files. A loop reaches to the last sample.
 */
#ifndef SOUND_ADPCM_H
#define SOUND_ADPCM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    SAMPLE_HEADER = 16,
    SAMPLE_RATE = 4000,    /* the least; SND_RATE is the most */
    SAMPLE_MOST = 1 << 25, /* samples */
    ADPCM_BYTES = 256,
    ADPCM_SAMPLES = 505,
    ADPCM_STEPS = 89
};
#define SAMPLE_ENDS UINT32_MAX

enum sample_coding { SAMPLE_PACKED, SAMPLE_EXACT, SAMPLE_CODINGS };

struct sample {
    uint32_t rate, n, loop;
    enum sample_coding coding;
    const uint8_t *data;
};

/* The header, and that all of it is there and good. False: no sample. */
bool sample_open(const uint8_t *data, size_t size, struct sample *s);

/* Are n samples one behind the other, and no more: all good, equally long, of one rate and one loop? */
bool samples_open(const uint8_t *data, size_t size, int n);

/* The header of what was checked. */
struct sample sample_of(const uint8_t *data);

/* Samples from place `from` on, which may be before the first and beyond the last one: silence there, or the loop. */
void sample_read(const struct sample *s, int64_t from, int n, int16_t *out);

/* Bytes of n samples with their header. */
size_t sample_size(uint32_t n, enum sample_coding coding);

/* ---- a step of ADPCM ---- */

struct adpcm {
    int32_t value, index;
};
extern const int16_t adpcm_steps[ADPCM_STEPS];

static inline int32_t adpcm_clamp(int32_t v, int32_t lo, int32_t hi)
{
    return v < lo ? lo : v > hi ? hi : v;
}

/* What code of four bits makes of s. */
static inline struct adpcm adpcm_next(struct adpcm s, int code)
{
    static const int8_t moves[8] = { -1, -1, -1, -1, 2, 4, 6, 8 };
    const int32_t d = ((code & 7) * 2 + 1) * adpcm_steps[s.index] >> 3;

    s.value = adpcm_clamp(code & 8 ? s.value - d : s.value + d, -32768, 32767);
    s.index = adpcm_clamp(s.index + moves[code & 7], 0, ADPCM_STEPS - 1);
    return s;
}

#endif
