/*
 * adpcm.c - see adpcm.h. Differences are decoded as (2n + 1) * step >> 3, as ffmpeg does; the standard's three shifts
 * lose up to 3. Encoding tries all sixteen codes and takes the nearest.
 */
#include "adpcm.h"

#include <string.h>
#include "../base/bytes.h"
#include "pitch.h"

enum { STEPS = 89 };
static const int16_t step_of[STEPS] = {
    7,    8,     9,     10,    11,    12,    13,    14,    16,    17,    19,    21,    23,    25,   28,
    31,   34,    37,    41,    45,    50,    55,    60,    66,    73,    80,    88,    97,    107,  118,
    130,  143,   157,   173,   190,   209,   230,   253,   279,   307,   337,   371,   408,   449,  494,
    544,  598,   658,   724,   796,   876,   963,   1060,  1166,  1282,  1411,  1552,  1707,  1878, 2066,
    2272, 2499,  2749,  3024,  3327,  3660,  4026,  4428,  4871,  5358,  5894,  6484,  7132,  7845, 8630,
    9493, 10442, 11487, 12635, 13899, 15289, 16818, 18500, 20350, 22385, 24623, 27086, 29794, 32767
};

struct state {
    int32_t value, index;
};

static int32_t clamp(int32_t v, int32_t lo, int32_t hi)
{
    return v < lo ? lo : v > hi ? hi : v;
}

static struct state decoded(struct state s, int code)
{
    static const int8_t moves[8] = { -1, -1, -1, -1, 2, 4, 6, 8 };
    const int32_t d = ((code & 7) * 2 + 1) * step_of[s.index] >> 3;

    s.value = clamp(code & 8 ? s.value - d : s.value + d, -32768, 32767);
    s.index = clamp(s.index + moves[code & 7], 0, STEPS - 1);
    return s;
}

/* n samples of a block from its `from`-th on. */
static void read_block(const uint8_t *block, int from, int n, int16_t *out)
{
    struct state s = { (int16_t)bytes_get16(block), block[2] };

    for (int i = 0; i < from + n; i++) {
        if (i > 0)
            s = decoded(s, block[4 + (i - 1) / 2] >> ((i - 1) & 1 ? 4 : 0) & 15);
        if (i >= from)
            out[i - from] = (int16_t)s.value;
    }
}

static uint32_t blocks_of(uint32_t n)
{
    return (n + ADPCM_SAMPLES - 1) / ADPCM_SAMPLES;
}

size_t sample_size(uint32_t n)
{
    return SAMPLE_HEADER + (size_t)blocks_of(n) * ADPCM_BYTES;
}

struct sample sample_of(const uint8_t *data)
{
    return (struct sample){ bytes_get32(data), bytes_get32(data + 4), bytes_get32(data + 8), data + SAMPLE_HEADER };
}

bool sample_open(const uint8_t *data, size_t size, struct sample *s)
{
    if (size < SAMPLE_HEADER)
        return false;
    *s = sample_of(data);
    if (s->rate < SAMPLE_RATE || s->rate > SND_RATE || s->n < 1 || s->n > SAMPLE_MOST || bytes_get32(data + 12) != 0 ||
        (s->loop != SAMPLE_ENDS && s->loop >= s->n) || size != sample_size(s->n))
        return false;
    for (uint32_t i = 0; i < blocks_of(s->n); i++)
        if (s->blocks[i * ADPCM_BYTES + 2] >= STEPS || s->blocks[i * ADPCM_BYTES + 3] != 0)
            return false;
    return true;
}

/* n samples from `from` on, all of them there. */
static void read_run(const struct sample *s, uint32_t from, int n, int16_t *out)
{
    while (n > 0) {
        const int first = (int)(from % ADPCM_SAMPLES), here = n < ADPCM_SAMPLES - first ? n : ADPCM_SAMPLES - first;
        read_block(s->blocks + (size_t)(from / ADPCM_SAMPLES) * ADPCM_BYTES, first, here, out);
        from += (uint32_t)here;
        out += here;
        n -= here;
    }
}

void sample_read(const struct sample *s, int64_t from, int n, int16_t *out)
{
    const int64_t length = s->n, loop = s->loop;

    while (n > 0) {
        int64_t here = n;
        if (from >= length && s->loop != SAMPLE_ENDS)
            from = loop + (from - loop) % (length - loop);
        if (from < 0) {
            here = -from < n ? -from : n;
            memset(out, 0, (size_t)here * sizeof *out);
        } else if (from >= length) {
            memset(out, 0, (size_t)n * sizeof *out);
        } else {
            here = length - from < n ? length - from : n;
            read_run(s, (uint32_t)from, (int)here, out);
        }
        from += here;
        out += here;
        n -= (int)here;
    }
}

/* The code that comes nearest to what is wanted. */
static int nearest(struct state s, int32_t wanted)
{
    int best = 0;
    int32_t least = INT32_MAX;

    for (int code = 0; code < 16; code++) {
        const int32_t d = decoded(s, code).value - wanted, far = d < 0 ? -d : d;
        if (far < least) {
            least = far;
            best = code;
        }
    }
    return best;
}

static struct state write_block(uint8_t *out, const int16_t *in, uint32_t n, int32_t index)
{
    struct state s = { in[0], index };

    bytes_put16(out, (uint16_t)in[0]);
    out[2] = (uint8_t)index;
    for (uint32_t i = 1; i < ADPCM_SAMPLES; i++) {
        const int code = nearest(s, i < n ? in[i] : 0);
        s = decoded(s, code);
        out[4 + (i - 1) / 2] |= (uint8_t)((i - 1) & 1 ? code << 4 : code);
    }
    return s;
}

void sample_write(uint8_t *out, const int16_t *in, uint32_t n, uint32_t rate, uint32_t loop)
{
    int32_t index = 0;

    memset(out, 0, sample_size(n));
    bytes_put32(out, rate);
    bytes_put32(out + 4, n);
    bytes_put32(out + 8, loop);
    for (uint32_t i = 0; i < blocks_of(n); i++)
        index = write_block(out + SAMPLE_HEADER + (size_t)i * ADPCM_BYTES, in + (size_t)i * ADPCM_SAMPLES,
                            n - i * ADPCM_SAMPLES, index)
                    .index;
}
