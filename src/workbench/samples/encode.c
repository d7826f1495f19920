/*
 * encode.c - see encode.h. A beam search finds the codes of each ADPCM block: from every step index, the WAYS sequences
 * with the least error are continued, and the best one at the block's end is written.
 */
#include "encode.h"

#include <string.h>
#include "../../base/bytes.h"

enum { WAYS = 4, TRIED = 3 /* codes tried for each */, CODES = ADPCM_BLOCK_SAMPLES - 1 };

struct way {
    struct adpcm_state at;
    int64_t wrong; /* sum of squares */
};

struct search {
    struct way way[ADPCM_STEPS], next[WAYS];
    int ways, nexts;
    uint8_t from[CODES][WAYS], code[CODES][WAYS];
};

/* Inserts a way, in order of error, if it is better than another one to the same state, or than the worst of WAYS. */
static void offer(struct search *s, const struct way *w, int i, int from, int code)
{
    int last = s->nexts;

    if (last == WAYS && w->wrong >= s->next[last - 1].wrong)
        return;
    for (int k = 0; k < s->nexts; k++)
        if (s->next[k].at.value == w->at.value && s->next[k].at.step_index == w->at.step_index) {
            if (s->next[k].wrong <= w->wrong)
                return;
            last = k;
            break;
        }
    if (last == s->nexts && s->nexts < WAYS)
        s->nexts++;
    else if (last == WAYS)
        last--;
    for (; last > 0 && s->next[last - 1].wrong > w->wrong; last--) {
        s->next[last] = s->next[last - 1];
        s->from[i][last] = s->from[i][last - 1];
        s->code[i][last] = s->code[i][last - 1];
    }
    s->next[last] = *w;
    s->from[i][last] = (uint8_t)from;
    s->code[i][last] = (uint8_t)code;
}

/* Continues a way with the codes nearest to the wanted value. */
static void continue_way(struct search *s, int i, int from, int32_t wanted)
{
    const struct way *w = &s->way[from];
    const int32_t far = wanted - w->at.value, size = far < 0 ? -far : far;
    const int sign = far < 0 ? 8 : 0, near = int_clamp(size * 4 / adpcm_steps[w->at.step_index], 0, 7);

    for (int k = 0; k < TRIED; k++) {
        const int n = near + k - TRIED / 2;
        if (n > 7)
            continue;
        const int code = n < 0 ? sign ^ 8 : n | sign;
        struct way next = { adpcm_next(w->at, code), w->wrong };
        const int64_t d = next.at.value - wanted;
        next.wrong += d * d;
        offer(s, &next, i, from, code);
    }
}

/* Finds the codes of a block of n samples; returns its first step index. */
static int find(struct search *s, const int16_t *in, uint32_t n, uint8_t codes[CODES])
{
    int first = 0;

    s->ways = ADPCM_STEPS;
    for (int k = 0; k < ADPCM_STEPS; k++)
        s->way[k] = (struct way){ { in[0], k }, 0 };
    for (int i = 0; i < CODES; i++) {
        s->nexts = 0;
        for (int k = 0; k < s->ways; k++)
            continue_way(s, i, k, (uint32_t)i + 1 < n ? in[i + 1] : 0);
        memcpy(s->way, s->next, sizeof s->next);
        s->ways = s->nexts;
    }
    for (int i = CODES - 1, k = 0; i >= 0; i--) {
        codes[i] = s->code[i][k];
        first = k = s->from[i][k];
    }
    return first;
}

static void write_block(struct search *s, uint8_t *out, const int16_t *in, uint32_t n)
{
    uint8_t codes[CODES];

    bytes_put16(out, (uint16_t)in[0]);
    out[2] = (uint8_t)find(s, in, n, codes);
    for (int i = 0; i < CODES; i++)
        out[4 + i / 2] |= (uint8_t)(i & 1 ? codes[i] << 4 : codes[i]);
}

void encode_sample(uint8_t *out, const int16_t *in, uint32_t n, uint32_t rate, uint32_t loop, enum sample_coding coding)
{
    struct search s;

    memset(out, 0, sample_size(n, coding));
    bytes_put32(out, rate);
    bytes_put32(out + 4, n);
    bytes_put32(out + 8, loop);
    out[12] = (uint8_t)coding;
    out += SAMPLE_HEADER_SIZE;
    if (coding == SAMPLE_PCM16)
        for (uint32_t i = 0; i < n; i++)
            bytes_put16(out + 2 * (size_t)i, (uint16_t)in[i]);
    else
        for (uint32_t i = 0; i < n; i += ADPCM_BLOCK_SAMPLES)
            write_block(&s, out + (size_t)(i / ADPCM_BLOCK_SAMPLES) * ADPCM_BLOCK_BYTES, in + i, n - i);
}
