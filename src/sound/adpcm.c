/*
 * adpcm.c - see adpcm.h. Differences are decoded as (2n + 1) * step >> 3, as in ffmpeg; the standard's three separate
 * shifts round down by up to 3 in total.
 */
#include "adpcm.h"

#include <string.h>
#include "../base/bytes.h"
#include "pitch.h"

const int16_t adpcm_steps[ADPCM_STEPS] = {
    7,    8,     9,     10,    11,    12,    13,    14,    16,    17,    19,    21,    23,    25,   28,
    31,   34,    37,    41,    45,    50,    55,    60,    66,    73,    80,    88,    97,    107,  118,
    130,  143,   157,   173,   190,   209,   230,   253,   279,   307,   337,   371,   408,   449,  494,
    544,  598,   658,   724,   796,   876,   963,   1060,  1166,  1282,  1411,  1552,  1707,  1878, 2066,
    2272, 2499,  2749,  3024,  3327,  3660,  4026,  4428,  4871,  5358,  5894,  6484,  7132,  7845, 8630,
    9493, 10442, 11487, 12635, 13899, 15289, 16818, 18500, 20350, 22385, 24623, 27086, 29794, 32767
};

/* Decodes n samples of a block, starting at index `from`. */
static void decode_block(const uint8_t *block, int from, int n, int16_t *out)
{
    struct adpcm_state s = { (int16_t)bytes_get16(block), block[2] };
    int i = 0;

    for (; i < from; i++)
        s = adpcm_next(s, block[4 + i / 2] >> (i & 1 ? 4 : 0) & 15);
    for (*out = (int16_t)s.value; i < from + n - 1; i++) {
        s = adpcm_next(s, block[4 + i / 2] >> (i & 1 ? 4 : 0) & 15);
        *++out = (int16_t)s.value;
    }
}

static uint32_t count_blocks(uint32_t n)
{
    return (n + ADPCM_BLOCK_SAMPLES - 1) / ADPCM_BLOCK_SAMPLES;
}

size_t sample_size(uint32_t n, enum sample_coding coding)
{
    return SAMPLE_HEADER_SIZE + (coding == SAMPLE_PCM16 ? 2 * (size_t)n : (size_t)count_blocks(n) * ADPCM_BLOCK_BYTES);
}

struct sample sample_of(const uint8_t *data)
{
    return (struct sample){ bytes_get32(data), bytes_get32(data + 4), bytes_get32(data + 8),
                            (enum sample_coding)data[12], data + SAMPLE_HEADER_SIZE };
}

bool sample_open(const uint8_t *data, size_t size, struct sample *s)
{
    if (size < SAMPLE_HEADER_SIZE || data[12] >= SAMPLE_CODINGS || data[13] | data[14] | data[15])
        return false;
    *s = sample_of(data);
    if (s->rate < SAMPLE_MIN_RATE || s->rate > SND_RATE || s->n < 1 || s->n > SAMPLE_MAX_LENGTH ||
        (s->loop_start != SAMPLE_NO_LOOP && s->loop_start >= s->n) || size != sample_size(s->n, s->coding))
        return false;
    for (uint32_t i = 0; s->coding == SAMPLE_ADPCM && i < count_blocks(s->n); i++)
        if (s->data[i * ADPCM_BLOCK_BYTES + 2] >= ADPCM_STEPS || s->data[i * ADPCM_BLOCK_BYTES + 3] != 0)
            return false;
    return true;
}

bool samples_are_valid(const uint8_t *data, size_t size, int n)
{
    struct sample first = { 0 }, s;
    size_t at = 0;

    for (int i = 0; i < n; i++) {
        if (size - at < SAMPLE_HEADER_SIZE)
            return false;
        const size_t bytes = sample_size(bytes_get32(data + at + 4), (enum sample_coding)data[at + 12]);
        if (bytes > size - at || !sample_open(data + at, bytes, &s))
            return false;
        first = i == 0 ? s : first;
        if (s.n != first.n || s.rate != first.rate || s.loop_start != first.loop_start)
            return false;
        at += bytes;
    }
    return at == size;
}

/* Reads n samples, starting at index `from`; all n must be in the recording. */
static void read_samples(const struct sample *s, uint32_t from, int n, int16_t *out)
{
    if (s->coding == SAMPLE_PCM16 && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__) {
        memcpy(out, s->data + 2 * (size_t)from, (size_t)n * sizeof *out);
        return;
    }
    for (; n > 0 && s->coding == SAMPLE_PCM16; n--, from++)
        *out++ = (int16_t)bytes_get16(s->data + 2 * (size_t)from);
    while (n > 0) {
        const int first = (int)(from % ADPCM_BLOCK_SAMPLES),
                  count = n < ADPCM_BLOCK_SAMPLES - first ? n : ADPCM_BLOCK_SAMPLES - first;
        decode_block(s->data + (size_t)(from / ADPCM_BLOCK_SAMPLES) * ADPCM_BLOCK_BYTES, first, count, out);
        from += (uint32_t)count;
        out += count;
        n -= count;
    }
}

void sample_read(const struct sample *s, int64_t from, int n, int16_t *out)
{
    const int64_t length = s->n, loop = s->loop_start;

    while (n > 0) {
        int64_t count = n;
        if (from >= length && s->loop_start != SAMPLE_NO_LOOP)
            from = loop + (from - loop) % (length - loop);
        if (from < 0) {
            count = -from < n ? -from : n;
            memset(out, 0, (size_t)count * sizeof *out);
        } else if (from >= length) {
            memset(out, 0, (size_t)n * sizeof *out);
        } else {
            count = length - from < n ? length - from : n;
            read_samples(s, (uint32_t)from, (int)count, out);
        }
        from += count;
        out += count;
        n -= (int)count;
    }
}
