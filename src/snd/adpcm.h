/*
 * adpcm.h - recordings, kept as IMA ADPCM in blocks that can be entered anywhere.
 * floor: snd
 *
 * A sample in a ROM is a header of SAMPLE_HEADER bytes (u32 frames a second, u32 samples, u32 the first sample of its
 * loop, or SAMPLE_ENDS; four zero bytes) and its blocks, ADPCM_BYTES each: i16 the first sample, u8 the step's index,
 * a zero byte, then two samples a byte, low half first, as in WAV files. A loop reaches to the last sample.
 */
#ifndef SND_ADPCM_H
#define SND_ADPCM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    SAMPLE_HEADER = 16,
    SAMPLE_RATE = 4000,    /* the least; SND_RATE is the most */
    SAMPLE_MOST = 1 << 24, /* samples */
    ADPCM_BYTES = 256,
    ADPCM_SAMPLES = 505
};
#define SAMPLE_ENDS UINT32_MAX

struct sample {
    uint32_t rate, n, loop;
    const uint8_t *blocks;
};

/* The header, and that all blocks are there and good. False: no sample. */
bool sample_open(const uint8_t *data, size_t size, struct sample *s);

/* The same of what was checked. */
struct sample sample_of(const uint8_t *data);

/* Samples from place `from` on, which may be before the first and beyond the last one: silence there, or the loop. */
void sample_read(const struct sample *s, int64_t from, int n, int16_t *out);

/* Bytes of n samples with their header; writes them. in: the samples. */
size_t sample_size(uint32_t n);
void sample_write(uint8_t *out, const int16_t *in, uint32_t n, uint32_t rate, uint32_t loop);

#endif
