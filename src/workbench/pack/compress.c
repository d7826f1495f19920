/*
 * compress.c - see compress.h.
 *
 * At each byte the longest match among those found, and those of the last four distances, is weighed by rules of thumb:
 * a near match is cheaper than a far one, a remembered distance cheaper still, and a match is put off by a byte if a
 * better one is there. Matches are found by chains of the places whose next four bytes have the same hash. Some 13 MB a
 * second; a writer that tries all ways makes a Glass Tide that is 13 % smaller, and takes four times as long.
 */
#include "compress.h"

#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../rom/compressed.h"
#include "../../rom/lzma.h"

enum { HASH_BITS = 17, DEPTH = 64 /* places that are looked at for a match */ };

struct match {
    uint32_t length, distance; /* distance less 1 */
};

struct writer {
    const uint8_t *in;
    size_t size, at; /* of the next byte */
    uint8_t *out;
    size_t n, room;
    uint64_t low;
    uint32_t range;
    uint8_t held; /* a byte that a carry may still change, and how many 0xff stand behind it, and itself */
    size_t pending;
    int state;
    uint32_t rep[LZMA_REPS];
    struct lzma_model m;
    size_t looked;                         /* places below it are in the chains */
    uint32_t *two, *three, *four, *before; /* the last place of a hash, and the place before a place; less 1, 0: none */
};

/* ---- bits ---- */

static void put_byte(struct writer *w, uint8_t byte)
{
    if (w->n < w->room)
        w->out[w->n] = byte;
    w->n++;
}

static void shift(struct writer *w)
{
    if (w->low < 0xff000000 || w->low > UINT32_MAX) {
        const uint8_t carry = (uint8_t)(w->low >> 32);
        put_byte(w, (uint8_t)(w->held + carry));
        for (; w->pending > 1; w->pending--)
            put_byte(w, (uint8_t)(0xff + carry));
        w->pending = 0;
        w->held = (uint8_t)(w->low >> 24);
    }
    w->pending++;
    w->low = (w->low & 0x00ffffff) << 8;
}

static void refill(struct writer *w)
{
    if (w->range < LZMA_TOP) {
        w->range <<= 8;
        shift(w);
    }
}

static void put_bit(struct writer *w, lzma_prob *prob, unsigned bit)
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
    refill(w);
}

static void put_tree(struct writer *w, lzma_prob *prob, int bits, uint32_t value)
{
    unsigned m = 1;

    for (int i = bits - 1; i >= 0; i--) {
        const unsigned bit = value >> i & 1;
        put_bit(w, prob + m, bit);
        m = m << 1 | bit;
    }
}

static void put_backwards(struct writer *w, lzma_prob *prob, int bits, uint32_t value)
{
    unsigned m = 1;

    for (int i = 0; i < bits; i++) {
        const unsigned bit = value >> i & 1;
        put_bit(w, prob + m, bit);
        m = m << 1 | bit;
    }
}

static void put_even(struct writer *w, int bits, uint32_t value)
{
    for (int i = bits - 1; i >= 0; i--) {
        w->range >>= 1;
        if (value >> i & 1)
            w->low += w->range;
        refill(w);
    }
}

/* ---- symbols ---- */

static void put_literal(struct writer *w)
{
    const unsigned byte = w->in[w->at] | 0x100;
    unsigned m = 1;
    int i = 7;

    put_bit(w, &w->m.match[w->state], 0);
    if (w->state >= LZMA_LITERAL_STATES) {
        const unsigned match = w->in[w->at - w->rep[0] - 1];
        for (; i >= 0; i--) {
            const unsigned would = match >> i & 1, bit = byte >> i & 1;
            put_bit(w, &w->m.literal[1 + would][m], bit);
            m = m << 1 | bit;
            if (bit != would) {
                i--;
                break;
            }
        }
    }
    for (; i >= 0; i--) {
        put_bit(w, &w->m.literal[0][m], byte >> i & 1);
        m = m << 1 | (byte >> i & 1);
    }
    w->state = lzma_state_after_literal(w->state);
    w->at++;
}

static void put_length(struct writer *w, struct lzma_length *l, uint32_t length)
{
    const uint32_t n = length - LZMA_MIN_MATCH;

    put_bit(w, &l->choice[0], n >= 8);
    if (n < 8) {
        put_tree(w, l->low, 3, n);
        return;
    }
    put_bit(w, &l->choice[1], n >= 16);
    if (n < 16)
        put_tree(w, l->middle, 3, n - 8);
    else
        put_tree(w, l->high, 8, n - 16);
}

static void put_distance(struct writer *w, uint32_t length, uint32_t distance)
{
    const uint32_t kind = length - LZMA_MIN_MATCH < LZMA_SLOT_MODELS ? length - LZMA_MIN_MATCH : LZMA_SLOT_MODELS - 1;
    int bits = 0;

    while (distance >> bits > 3)
        bits++;
    const uint32_t slot = distance < 4 ? distance : 2 * ((uint32_t)bits + 1) + (distance >> bits & 1);
    put_tree(w, w->m.slot[kind], 6, slot);
    if (slot < 4)
        return;
    const uint32_t from = (2 | (slot & 1)) << bits, rest = distance - from;
    if (slot < LZMA_MODELLED_SLOTS) {
        put_backwards(w, w->m.near + from - slot, bits, rest);
        return;
    }
    put_even(w, bits - LZMA_ALIGN_BITS, rest >> LZMA_ALIGN_BITS);
    put_backwards(w, w->m.align, LZMA_ALIGN_BITS, rest & ((1 << LZMA_ALIGN_BITS) - 1));
}

static void put_match(struct writer *w, struct match match)
{
    put_bit(w, &w->m.match[w->state], 1);
    put_bit(w, &w->m.rep[w->state], 0);
    put_length(w, &w->m.length, match.length);
    put_distance(w, match.length, match.distance);
    memmove(w->rep + 1, w->rep, (LZMA_REPS - 1) * sizeof *w->rep);
    w->rep[0] = match.distance;
    w->state = lzma_state_after_match(w->state, LZMA_MATCH);
    w->at += match.length;
}

/* A match of the i-th remembered distance. */
static void put_again(struct writer *w, int i, uint32_t length)
{
    const uint32_t distance = w->rep[i];

    put_bit(w, &w->m.match[w->state], 1);
    put_bit(w, &w->m.rep[w->state], 1);
    put_bit(w, &w->m.rep_0[w->state], i > 0);
    if (i == 0) {
        put_bit(w, &w->m.rep_0_long[w->state], length > 1);
    } else {
        put_bit(w, &w->m.rep_1[w->state], i > 1);
        if (i > 1)
            put_bit(w, &w->m.rep_2[w->state], i > 2);
    }
    memmove(w->rep + 1, w->rep, (size_t)i * sizeof *w->rep);
    w->rep[0] = distance;
    if (length > 1)
        put_length(w, &w->m.rep_length, length);
    w->state = lzma_state_after_match(w->state, length > 1 ? LZMA_REP : LZMA_SHORT_REP);
    w->at += length;
}

/* ---- matches ---- */

/* Bytes at a place that are those `distance` + 1 before it, at most LZMA_MAX_MATCH. */
static uint32_t same(const struct writer *w, size_t at, uint32_t distance)
{
    const size_t left = w->size - at, most = left < LZMA_MAX_MATCH ? left : LZMA_MAX_MATCH;
    uint32_t n = 0;

    if (distance >= at)
        return 0;
    for (const uint8_t *p = w->in + at, *q = p - distance - 1; n < most && p[n] == q[n];)
        n++;
    return n;
}

/* Takes the next place, which has four bytes or more, into the chains; first[]: those before it of its hashes. */
static void look_at_next(struct writer *w, uint32_t first[3])
{
    const size_t at = w->looked++;
    const uint32_t bytes = w->size - at >= 4 ? bytes_get32(w->in + at) : 0;
    uint32_t *const heads[3] = { w->four + (bytes * 0x9e3779b1u >> (32 - HASH_BITS)),
                                 w->three + ((bytes & 0xffffff) * 0x9e3779b1u >> (32 - HASH_BITS)),
                                 w->two + (bytes & 0xffff) };

    memset(first, 0, 3 * sizeof *first);
    if (w->size - at < 4)
        return;
    w->before[at] = *heads[0];
    for (int i = 0; i < 3; i++) {
        first[i] = *heads[i];
        *heads[i] = (uint32_t)at + 1;
    }
}

/* Is a match of that length and distance worth more than one that is shorter? It must not be much farther away. */
static bool better(struct match m, struct match than)
{
    return m.length > than.length + 1 || (m.length == than.length + 1 && m.distance >> 7 <= than.distance);
}

static struct match consider(const struct writer *w, size_t at, uint32_t place, struct match best)
{
    struct match found = { 0, (uint32_t)(at - place) };

    if (place == 0 || at + best.length >= w->size || w->in[place - 1 + best.length] != w->in[at + best.length])
        return best; /* it cannot be longer */
    found.length = same(w, at, found.distance);
    return found.length >= LZMA_MIN_MATCH && (best.length == 0 || better(found, best)) ? found : best;
}

/* The best match of a place, which is the next one that is looked at; length 0: none. */
static struct match find(struct writer *w, size_t at)
{
    struct match best = { 0, 0 };
    uint32_t first[3];

    look_at_next(w, first);
    best = consider(w, at, first[2], best);
    best = consider(w, at, first[1], best);
    uint32_t place = first[0];
    for (int i = 0; place > 0 && i < DEPTH && best.length < LZMA_MAX_MATCH; i++) {
        best = consider(w, at, place, best);
        place = w->before[place - 1];
    }
    return best.length == 2 && best.distance >= 0x80 ? (struct match){ 0, 0 } : best;
}

/* The longest match of a remembered distance: its length, and which in *i. */
static uint32_t again(const struct writer *w, size_t at, int *which)
{
    uint32_t best = 0;

    for (int i = 0; i < LZMA_REPS; i++) {
        const uint32_t n = same(w, at, w->rep[i]);
        if (n > best) {
            best = n;
            *which = i;
        }
    }
    return best;
}

/* Is a remembered distance as good as that match, which is longer by a little? */
static bool again_does(uint32_t length, struct match m)
{
    return length >= LZMA_MIN_MATCH && (length + 1 >= m.length || (length + 2 >= m.length && m.distance > 1 << 9) ||
                                        (length + 3 >= m.length && m.distance > 1 << 15));
}

/* Is it better to put a literal, and then what is found behind it? */
static bool waits(const struct writer *w, struct match m, struct match next)
{
    int which;

    if (next.length >= LZMA_MIN_MATCH &&
        ((next.length >= m.length && next.distance < m.distance) || better(next, m) ||
         (next.length + 1 >= m.length && m.length >= 3 && m.distance >> 7 > next.distance)))
        return true;
    return again(w, w->at + 1, &which) + 1 >= m.length;
}

/* ---- all of it ---- */

static void put_single(struct writer *w)
{
    if (w->at > w->rep[0] && w->state >= LZMA_LITERAL_STATES && w->in[w->at] == w->in[w->at - w->rep[0] - 1])
        put_again(w, 0, 1);
    else
        put_literal(w);
}

static void write_all(struct writer *w)
{
    struct match now = { 0, 0 };
    bool found = false; /* `now` is of this place: what was looked for a byte before */

    while (w->at < w->size && w->n < w->room) {
        uint32_t first[3];
        int which = 0;
        const size_t from = w->at;
        if (!found)
            now = find(w, from);
        found = false;
        const uint32_t length = again(w, from, &which);
        struct match next = { 0, 0 };
        if (again_does(length, now)) {
            put_again(w, which, length);
        } else if (now.length < LZMA_MIN_MATCH) {
            put_single(w);
        } else if (now.length < LZMA_MAX_MATCH && from + 1 < w->size &&
                   (next = find(w, from + 1), waits(w, now, next))) {
            put_single(w);
            now = next;
            found = true;
        } else {
            put_match(w, now);
        }
        while (w->looked < w->at)
            look_at_next(w, first);
    }
    for (int i = 0; i < 5; i++)
        shift(w);
}

bool compress_rom(const void *rom, size_t rom_size, uint8_t **out, size_t *size)
{
    struct writer *w = calloc(1, sizeof *w);
    bool good = false;

    *out = NULL;
    *size = 0;
    if (!w || rom_size <= COMPRESSED_HEADER_SIZE || rom_size > COMPRESSED_MAX_SIZE) {
        free(w);
        return w != NULL;
    }
    *w = (struct writer){ .in = rom, .size = rom_size, .range = UINT32_MAX, .pending = 1 };
    w->room = rom_size - COMPRESSED_HEADER_SIZE;
    w->out = malloc(rom_size);
    w->two = calloc((1 << 16) + 2 * ((size_t)1 << HASH_BITS) + rom_size, sizeof *w->two);
    if (w->out && w->two) {
        w->three = w->two + (1 << 16);
        w->four = w->three + (1 << HASH_BITS);
        w->before = w->four + (1 << HASH_BITS);
        lzma_model_reset(&w->m);
        write_all(w);
        good = true;
    }
    free(w->two);
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
