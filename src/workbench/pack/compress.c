/*
 * compress.c - see compress.h.
 *
 * The encoder is greedy with lazy matching, as LZMA's fast mode: heuristics choose between the longest match of the
 * match finder and the repeats of the last four distances. A near match is cheaper than a far one, and a repeated
 * distance is cheaper still. If the next byte has a better match, a literal is written first. The match finder uses
 * hash chains of the next four bytes. The speed is about 13 MB/s. An optimal parser makes Glass Tide 13 % smaller, and
 * takes four times as long.
 */
#include "compress.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../rom/compressed.h"
#include "../../rom/lzma.h"

enum { HASH_BITS = 17, MAX_CHAIN = 64 /* positions that are tried for a match */ };

struct match {
    uint32_t length, distance; /* distance: minus 1 */
};

struct encoder {
    const uint8_t *in;
    size_t size, at; /* at: the next byte to encode */
    uint8_t *out;
    size_t n, room;
    uint64_t low;
    uint32_t range;
    uint8_t cache;  /* the byte that a carry may still change */
    size_t pending; /* the cached byte and the 0xff bytes after it */
    int state;
    uint32_t rep[LZMA_REPS];
    struct lzma_model m;
    size_t hashed; /* positions below this are in the hash chains */
    /* the last position + 1 for each hash of 2, 3 and 4 bytes; the previous position + 1 of the chain; 0: none */
    uint32_t *hash2, *hash3, *hash4, *previous;
};

/* ---- range coder ---- */

static void write_byte(struct encoder *w, uint8_t byte)
{
    if (w->n < w->room)
        w->out[w->n] = byte;
    w->n++;
}

static void shift_low(struct encoder *w)
{
    if (w->low < 0xff000000 || w->low > UINT32_MAX) {
        const uint8_t carry = (uint8_t)(w->low >> 32);
        write_byte(w, (uint8_t)(w->cache + carry));
        for (; w->pending > 1; w->pending--)
            write_byte(w, (uint8_t)(0xff + carry));
        w->pending = 0;
        w->cache = (uint8_t)(w->low >> 24);
    }
    w->pending++;
    w->low = (w->low & 0x00ffffff) << 8;
}

static void normalize(struct encoder *w)
{
    if (w->range < LZMA_TOP) {
        w->range <<= 8;
        shift_low(w);
    }
}

static void encode_bit(struct encoder *w, lzma_prob *prob, unsigned bit)
{
    const uint32_t half = (w->range >> LZMA_PROB_BITS) * *prob;

    if (bit) {
        w->low += half;
        w->range -= half;
        *prob = (lzma_prob)(*prob - (*prob >> LZMA_ADAPT_SHIFT));
    } else {
        w->range = half;
        *prob = (lzma_prob)(*prob + (((1 << LZMA_PROB_BITS) - *prob) >> LZMA_ADAPT_SHIFT));
    }
    normalize(w);
}

static void encode_bit_tree(struct encoder *w, lzma_prob *prob, int bits, uint32_t value)
{
    unsigned m = 1;

    for (int i = bits - 1; i >= 0; i--) {
        const unsigned bit = value >> i & 1;
        encode_bit(w, prob + m, bit);
        m = m << 1 | bit;
    }
}

static void encode_reverse_bit_tree(struct encoder *w, lzma_prob *prob, int bits, uint32_t value)
{
    unsigned m = 1;

    for (int i = 0; i < bits; i++) {
        const unsigned bit = value >> i & 1;
        encode_bit(w, prob + m, bit);
        m = m << 1 | bit;
    }
}

static void encode_direct_bits(struct encoder *w, int bits, uint32_t value)
{
    for (int i = bits - 1; i >= 0; i--) {
        w->range >>= 1;
        if (value >> i & 1)
            w->low += w->range;
        normalize(w);
    }
}

/* ---- symbols ---- */

static void encode_literal(struct encoder *w)
{
    const unsigned byte = w->in[w->at] | 0x100;
    unsigned m = 1;
    int i = 7;

    encode_bit(w, &w->m.match[w->state], 0);
    if (w->state >= LZMA_LITERAL_STATES) {
        const unsigned match = w->in[w->at - w->rep[0] - 1];
        for (; i >= 0; i--) {
            const unsigned would = match >> i & 1, bit = byte >> i & 1;
            encode_bit(w, &w->m.literal[1 + would][m], bit);
            m = m << 1 | bit;
            if (bit != would) {
                i--;
                break;
            }
        }
    }
    for (; i >= 0; i--) {
        encode_bit(w, &w->m.literal[0][m], byte >> i & 1);
        m = m << 1 | (byte >> i & 1);
    }
    w->state = lzma_state_after_literal(w->state);
    w->at++;
}

static void encode_length(struct encoder *w, struct lzma_length *l, uint32_t length)
{
    const uint32_t n = length - LZMA_MIN_MATCH;

    encode_bit(w, &l->choice[0], n >= 8);
    if (n < 8) {
        encode_bit_tree(w, l->low, 3, n);
        return;
    }
    encode_bit(w, &l->choice[1], n >= 16);
    if (n < 16)
        encode_bit_tree(w, l->middle, 3, n - 8);
    else
        encode_bit_tree(w, l->high, 8, n - 16);
}

static void encode_distance(struct encoder *w, uint32_t length, uint32_t distance)
{
    const uint32_t kind = length - LZMA_MIN_MATCH < LZMA_SLOT_MODELS ? length - LZMA_MIN_MATCH : LZMA_SLOT_MODELS - 1;
    int bits = 0;

    while (distance >> bits > 3)
        bits++;
    const uint32_t slot = distance < 4 ? distance : 2 * ((uint32_t)bits + 1) + (distance >> bits & 1);
    encode_bit_tree(w, w->m.slot[kind], 6, slot);
    if (slot < 4)
        return;
    const uint32_t from = (2 | (slot & 1)) << bits, rest = distance - from;
    if (slot < LZMA_MODELLED_SLOTS) {
        encode_reverse_bit_tree(w, w->m.near + from - slot, bits, rest);
        return;
    }
    encode_direct_bits(w, bits - LZMA_ALIGN_BITS, rest >> LZMA_ALIGN_BITS);
    encode_reverse_bit_tree(w, w->m.align, LZMA_ALIGN_BITS, rest & ((1 << LZMA_ALIGN_BITS) - 1));
}

static void encode_match(struct encoder *w, struct match match)
{
    encode_bit(w, &w->m.match[w->state], 1);
    encode_bit(w, &w->m.rep[w->state], 0);
    encode_length(w, &w->m.length, match.length);
    encode_distance(w, match.length, match.distance);
    memmove(w->rep + 1, w->rep, (LZMA_REPS - 1) * sizeof *w->rep);
    w->rep[0] = match.distance;
    w->state = lzma_state_after_match(w->state, LZMA_MATCH);
    w->at += match.length;
}

/* Encodes a match of the i-th repeated distance. */
static void encode_repeat(struct encoder *w, int i, uint32_t length)
{
    const uint32_t distance = w->rep[i];

    encode_bit(w, &w->m.match[w->state], 1);
    encode_bit(w, &w->m.rep[w->state], 1);
    encode_bit(w, &w->m.rep_0[w->state], i > 0);
    if (i == 0) {
        encode_bit(w, &w->m.rep_0_long[w->state], length > 1);
    } else {
        encode_bit(w, &w->m.rep_1[w->state], i > 1);
        if (i > 1)
            encode_bit(w, &w->m.rep_2[w->state], i > 2);
    }
    memmove(w->rep + 1, w->rep, (size_t)i * sizeof *w->rep);
    w->rep[0] = distance;
    if (length > 1)
        encode_length(w, &w->m.rep_length, length);
    w->state = lzma_state_after_match(w->state, length > 1 ? LZMA_REP : LZMA_SHORT_REP);
    w->at += length;
}

/* ---- match finder ---- */

/* Returns the length of the match at a position with a distance, at most LZMA_MAX_MATCH. */
static uint32_t match_length(const struct encoder *w, size_t at, uint32_t distance)
{
    const size_t left = w->size - at, most = left < LZMA_MAX_MATCH ? left : LZMA_MAX_MATCH;
    uint32_t n = 0;

    if (distance >= at)
        return 0;
    for (const uint8_t *p = w->in + at, *q = p - distance - 1; n < most && p[n] == q[n];)
        n++;
    return n;
}

/* Inserts the next position into the hash tables, if four bytes follow. first: the previous positions of its hashes. */
static void insert_next(struct encoder *w, uint32_t first[3])
{
    const size_t at = w->hashed++;
    const uint32_t bytes = w->size - at >= 4 ? bytes_get32(w->in + at) : 0;
    uint32_t *const heads[3] = { w->hash4 + (bytes * 0x9e3779b1u >> (32 - HASH_BITS)),
                                 w->hash3 + ((bytes & 0xffffff) * 0x9e3779b1u >> (32 - HASH_BITS)),
                                 w->hash2 + (bytes & 0xffff) };

    memset(first, 0, 3 * sizeof *first);
    if (w->size - at < 4)
        return;
    w->previous[at] = *heads[0];
    for (int i = 0; i < 3; i++) {
        first[i] = *heads[i];
        *heads[i] = (uint32_t)at + 1;
    }
}

/* Returns whether the longer match m is worth its distance: it must not be much farther away. */
static bool is_better_match(struct match m, struct match than)
{
    return m.length > than.length + 1 || (m.length == than.length + 1 && m.distance >> 7 <= than.distance);
}

static struct match try_position(const struct encoder *w, size_t at, uint32_t position, struct match best)
{
    struct match found = { 0, (uint32_t)(at - position) };

    if (position == 0 || at + best.length >= w->size || w->in[position - 1 + best.length] != w->in[at + best.length])
        return best; /* cannot be longer */
    found.length = match_length(w, at, found.distance);
    return found.length >= LZMA_MIN_MATCH && (best.length == 0 || is_better_match(found, best)) ? found : best;
}

/* Returns the best match at the position, which is the next one to be hashed; length 0: none. */
static struct match find_match(struct encoder *w, size_t at)
{
    struct match best = { 0, 0 };
    uint32_t first[3];

    insert_next(w, first);
    best = try_position(w, at, first[2], best);
    best = try_position(w, at, first[1], best);
    uint32_t position = first[0];
    for (int i = 0; position > 0 && i < MAX_CHAIN && best.length < LZMA_MAX_MATCH; i++) {
        best = try_position(w, at, position, best);
        position = w->previous[position - 1];
    }
    return best.length == 2 && best.distance >= 0x80 ? (struct match){ 0, 0 } : best;
}

/* Returns the length of the longest match of a repeated distance, and its index in *which. */
static uint32_t find_repeat(const struct encoder *w, size_t at, int *which)
{
    uint32_t best = 0;

    for (int i = 0; i < LZMA_REPS; i++) {
        const uint32_t n = match_length(w, at, w->rep[i]);
        if (n > best) {
            best = n;
            *which = i;
        }
    }
    return best;
}

/* Returns whether a match of a repeated distance is cheaper than match m, which may be slightly longer. */
static bool prefer_repeat(uint32_t length, struct match m)
{
    return length >= LZMA_MIN_MATCH && (length + 1 >= m.length || (length + 2 >= m.length && m.distance > 1 << 9) ||
                                        (length + 3 >= m.length && m.distance > 1 << 15));
}

/* Returns whether to encode a literal first, because the next position has a better match. */
static bool prefer_literal(const struct encoder *w, struct match m, struct match next)
{
    int which;

    if (next.length >= LZMA_MIN_MATCH &&
        ((next.length >= m.length && next.distance < m.distance) || is_better_match(next, m) ||
         (next.length + 1 >= m.length && m.length >= 3 && m.distance >> 7 > next.distance)))
        return true;
    return find_repeat(w, w->at + 1, &which) + 1 >= m.length;
}

/* ---- encoder ---- */

static void encode_literal_or_short_repeat(struct encoder *w)
{
    if (w->at > w->rep[0] && w->state >= LZMA_LITERAL_STATES && w->in[w->at] == w->in[w->at - w->rep[0] - 1])
        encode_repeat(w, 0, 1);
    else
        encode_literal(w);
}

static void encode_all(struct encoder *w)
{
    struct match now = { 0, 0 };
    bool found = false; /* `now` was found while encoding the byte before */

    while (w->at < w->size && w->n < w->room) {
        uint32_t first[3];
        int which = 0;
        const size_t from = w->at;
        if (!found)
            now = find_match(w, from);
        found = false;
        const uint32_t length = find_repeat(w, from, &which);
        struct match next = { 0, 0 };
        if (prefer_repeat(length, now)) {
            encode_repeat(w, which, length);
        } else if (now.length < LZMA_MIN_MATCH) {
            encode_literal_or_short_repeat(w);
        } else if (now.length < LZMA_MAX_MATCH && from + 1 < w->size &&
                   (next = find_match(w, from + 1), prefer_literal(w, now, next))) {
            encode_literal_or_short_repeat(w);
            now = next;
            found = true;
        } else {
            encode_match(w, now);
        }
        while (w->hashed < w->at)
            insert_next(w, first);
    }
    for (int i = 0; i < 5; i++)
        shift_low(w);
}

bool compress_rom(const void *rom, size_t rom_size, uint8_t **out, size_t *size)
{
    struct encoder *w = calloc(1, sizeof *w);
    bool good = false;

    *out = NULL;
    *size = 0;
    if (!w || rom_size <= COMPRESSED_HEADER_SIZE || rom_size > COMPRESSED_MAX_SIZE) {
        free(w);
        return w != NULL;
    }
    *w = (struct encoder){ .in = rom, .size = rom_size, .range = UINT32_MAX, .pending = 1 };
    w->room = rom_size - COMPRESSED_HEADER_SIZE;
    w->out = malloc(rom_size);
    w->hash2 = calloc((1 << 16) + 2 * ((size_t)1 << HASH_BITS) + rom_size, sizeof *w->hash2);
    if (w->out && w->hash2) {
        w->hash3 = w->hash2 + (1 << 16);
        w->hash4 = w->hash3 + (1 << HASH_BITS);
        w->previous = w->hash4 + (1 << HASH_BITS);
        lzma_model_reset(&w->m);
        encode_all(w);
        good = true;
    }
    free(w->hash2);
    if (good && w->n < w->room && rom_size / COMPRESSED_MAX_RATIO <= w->n) {
        memmove(w->out + COMPRESSED_HEADER_SIZE, w->out, w->n);
        *size = COMPRESSED_HEADER_SIZE + w->n;
        compressed_write_header(w->out, *size, rom, rom_size);
        *out = w->out;
        w->out = NULL;
    }
    free(w->out);
    free(w);
    return good;
}
