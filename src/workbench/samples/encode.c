/*
 * encode.c - see encode.h. A beam search finds the codes of each ADPCM block. It starts with a path for every step
 * index, keeps the BEAM_WIDTH paths with the smallest error after each sample, and writes the best path.
 */
#include "encode.h"

#include <string.h>
#include "../../base/bytes.h"

enum { BEAM_WIDTH = 4, CODES_TRIED = 3 /* codes tried for each path */, CODES = ADPCM_BLOCK_SAMPLES - 1 };

struct path {
    struct adpcm_state state;
    int64_t error; /* sum of squared differences */
};

struct search {
    struct path path[ADPCM_STEPS], next[BEAM_WIDTH];
    int paths, nexts;
    uint8_t parent[CODES][BEAM_WIDTH], code[CODES][BEAM_WIDTH];
};

/* Inserts a path in order of error, if it is better than another path to the same state, or than the worst path. */
static void insert_path(struct search *s, const struct path *path, int i, int parent, int code)
{
    int last = s->nexts;

    if (last == BEAM_WIDTH && path->error >= s->next[last - 1].error)
        return;
    for (int k = 0; k < s->nexts; k++)
        if (s->next[k].state.value == path->state.value && s->next[k].state.step_index == path->state.step_index) {
            if (s->next[k].error <= path->error)
                return;
            last = k;
            break;
        }
    if (last == s->nexts && s->nexts < BEAM_WIDTH)
        s->nexts++;
    else if (last == BEAM_WIDTH)
        last--;
    for (; last > 0 && s->next[last - 1].error > path->error; last--) {
        s->next[last] = s->next[last - 1];
        s->parent[i][last] = s->parent[i][last - 1];
        s->code[i][last] = s->code[i][last - 1];
    }
    s->next[last] = *path;
    s->parent[i][last] = (uint8_t)parent;
    s->code[i][last] = (uint8_t)code;
}

/* Extends a path by the codes nearest to the wanted value. */
static void extend_path(struct search *s, int i, int parent, int32_t wanted)
{
    const struct path *w = &s->path[parent];
    const int32_t far = wanted - w->state.value, size = far < 0 ? -far : far;
    const int sign = far < 0 ? 8 : 0, near = int_clamp(size * 4 / adpcm_steps[w->state.step_index], 0, 7);

    for (int k = 0; k < CODES_TRIED; k++) {
        const int n = near + k - CODES_TRIED / 2;
        if (n > 7)
            continue;
        const int code = n < 0 ? sign ^ 8 : n | sign;
        struct path next = { adpcm_next(w->state, code), w->error };
        const int64_t d = next.state.value - wanted;
        next.error += d * d;
        insert_path(s, &next, i, parent, code);
    }
}

/* Finds the codes of a block of n samples; returns its first step index. */
static int find_codes(struct search *s, const int16_t *in, uint32_t n, uint8_t codes[CODES])
{
    int first = 0;

    s->paths = ADPCM_STEPS;
    for (int k = 0; k < ADPCM_STEPS; k++)
        s->path[k] = (struct path){ { in[0], k }, 0 };
    for (int i = 0; i < CODES; i++) {
        s->nexts = 0;
        for (int k = 0; k < s->paths; k++)
            extend_path(s, i, k, (uint32_t)i + 1 < n ? in[i + 1] : 0);
        memcpy(s->path, s->next, sizeof s->next);
        s->paths = s->nexts;
    }
    for (int i = CODES - 1, k = 0; i >= 0; i--) {
        codes[i] = s->code[i][k];
        first = k = s->parent[i][k];
    }
    return first;
}

static void write_block(struct search *s, uint8_t *out, const int16_t *in, uint32_t n)
{
    uint8_t codes[CODES];

    bytes_put16(out, (uint16_t)in[0]);
    out[2] = (uint8_t)find_codes(s, in, n, codes);
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
