/*
 * lzma.c - see lzma.h.
 *
 * The range coder splits a range of numbers in proportion to the probabilities of each bit, until only the number that
 * the stream encodes is left in the range. Any sequence of bytes decodes to some symbols, so the reader checks that no
 * distance points before the start of the output, that no match runs past the end of the output, and that stream and
 * output end together.
 */
#include "lzma.h"

#include <string.h>

enum { PROB_HALF = 1 << (LZMA_PROB_BITS - 1) };

void lzma_model_reset(struct lzma_model *m)
{
    const lzma_prob half = PROB_HALF;

    for (size_t i = 0; i < sizeof *m; i += sizeof half) /* every member is an lzma_prob */
        memcpy((uint8_t *)m + i, &half, sizeof half);
}

int lzma_state_after_literal(int state)
{
    return state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
}

int lzma_state_after_match(int state, enum lzma_match match)
{
    static const uint8_t next[] = { [LZMA_MATCH] = 7, [LZMA_REP] = 8, [LZMA_SHORT_REP] = 9 };

    if (state < LZMA_LITERAL_STATES)
        return next[match];
    return match == LZMA_MATCH ? 10 : 11;
}

/* ---- range decoder ---- */

struct reader {
    const uint8_t *in, *end;
    uint32_t range, code;
    bool overrun; /* the decoder needed bytes beyond the end of the stream */
    uint8_t *out;
    size_t at, size;
    uint32_t rep[LZMA_REPS]; /* match distances - 1, most recent first */
    int state;
    struct lzma_model m;
};

static void refill(struct reader *r)
{
    if (r->range >= LZMA_TOP)
        return;
    if (r->in == r->end)
        r->overrun = true;
    r->range <<= 8;
    r->code = r->code << 8 | (r->overrun ? 0 : *r->in++);
}

static unsigned read_bit(struct reader *r, lzma_prob *prob)
{
    const uint32_t bound = (r->range >> LZMA_PROB_BITS) * *prob;
    const unsigned bit = r->code >= bound;

    if (bit) {
        r->range -= bound;
        r->code -= bound;
        *prob = (lzma_prob)(*prob - (*prob >> LZMA_ADAPT_SHIFT));
    } else {
        r->range = bound;
        *prob = (lzma_prob)(*prob + (((1 << LZMA_PROB_BITS) - *prob) >> LZMA_ADAPT_SHIFT));
    }
    refill(r);
    return bit;
}

/* Reads a number of `bits` bits, most significant first. The probability of each bit depends on the bits before it. */
static unsigned read_tree(struct reader *r, lzma_prob *prob, int bits)
{
    unsigned m = 1;

    for (int i = 0; i < bits; i++)
        m = m << 1 | read_bit(r, prob + m);
    return m - (1u << bits);
}

/* Like read_tree, but least significant bit first. */
static uint32_t read_reverse_tree(struct reader *r, lzma_prob *prob, int bits)
{
    unsigned m = 1;
    uint32_t out = 0;

    for (int i = 0; i < bits; i++) {
        const unsigned bit = read_bit(r, prob + m);
        m = m << 1 | bit;
        out |= (uint32_t)bit << i;
    }
    return out;
}

/* Reads direct bits (fixed probability 1/2), most significant first. */
static uint32_t read_direct_bits(struct reader *r, int bits)
{
    uint32_t out = 0;

    for (int i = 0; i < bits; i++) {
        r->range >>= 1;
        const unsigned bit = r->code >= r->range;
        r->code -= bit ? r->range : 0;
        out = out << 1 | bit;
        refill(r);
    }
    return out;
}

/* ---- symbols ---- */

static void read_literal(struct reader *r)
{
    unsigned m = 1;

    if (r->state >= LZMA_LITERAL_STATES) {
        /* The byte that would continue the match. The literal usually differs, or the match would be longer. */
        const unsigned match = r->out[r->at - r->rep[0] - 1];
        for (int i = 7; i >= 0 && m < 0x100; i--) {
            const unsigned match_bit = match >> i & 1, bit = read_bit(r, &r->m.literal[1 + match_bit][m]);
            m = m << 1 | bit;
            if (bit != match_bit)
                break;
        }
    }
    while (m < 0x100)
        m = m << 1 | read_bit(r, &r->m.literal[0][m]);
    r->out[r->at++] = (uint8_t)m;
    r->state = lzma_state_after_literal(r->state);
}

static uint32_t read_length(struct reader *r, struct lzma_length *l)
{
    if (!read_bit(r, &l->choice[0]))
        return LZMA_MIN_MATCH + read_tree(r, l->low, 3);
    if (!read_bit(r, &l->choice[1]))
        return LZMA_MIN_MATCH + 8 + read_tree(r, l->middle, 3);
    return LZMA_MIN_MATCH + 16 + read_tree(r, l->high, 8);
}

static uint32_t read_distance(struct reader *r, uint32_t length)
{
    const uint32_t kind = length - LZMA_MIN_MATCH < LZMA_SLOT_MODELS ? length - LZMA_MIN_MATCH : LZMA_SLOT_MODELS - 1;
    const uint32_t slot = read_tree(r, r->m.slot[kind], 6);

    if (slot < 4)
        return slot;
    const int bits = (int)(slot >> 1) - 1;
    const uint32_t base = (2 | (slot & 1)) << bits;
    if (slot < LZMA_MODELLED_SLOTS)
        return base + read_reverse_tree(r, r->m.near + base - slot, bits);
    const uint32_t high = read_direct_bits(r, bits - LZMA_ALIGN_BITS) << LZMA_ALIGN_BITS;
    return base + high + read_reverse_tree(r, r->m.align, LZMA_ALIGN_BITS);
}

/* Moves remembered distance i to the front. */
static void move_rep_to_front(struct reader *r, int i)
{
    const uint32_t distance = r->rep[i];

    memmove(r->rep + 1, r->rep, (size_t)i * sizeof *r->rep);
    r->rep[0] = distance;
}

/* Reads a match with a remembered distance. Returns its length. */
static uint32_t read_rep_match(struct reader *r)
{
    struct lzma_model *m = &r->m;

    if (!read_bit(r, &m->rep_0[r->state])) {
        if (!read_bit(r, &m->rep_0_long[r->state])) {
            r->state = lzma_state_after_match(r->state, LZMA_SHORT_REP);
            return 1;
        }
    } else if (!read_bit(r, &m->rep_1[r->state])) {
        move_rep_to_front(r, 1);
    } else {
        move_rep_to_front(r, 2 + (int)read_bit(r, &m->rep_2[r->state]));
    }
    const uint32_t length = read_length(r, &m->rep_length);
    r->state = lzma_state_after_match(r->state, LZMA_REP);
    return length;
}

/* Reads a match with a new distance. Returns its length. */
static uint32_t read_match(struct reader *r)
{
    const uint32_t length = read_length(r, &r->m.length);

    memmove(r->rep + 1, r->rep, (LZMA_REPS - 1) * sizeof *r->rep);
    r->rep[0] = read_distance(r, length);
    r->state = lzma_state_after_match(r->state, LZMA_MATCH);
    return length;
}

/* Copies a match of `length` bytes at distance rep[0]. Returns false if it starts before the output or runs past its
 * end. */
static bool copy_match(struct reader *r, uint32_t length)
{
    if (r->rep[0] >= r->at || length > r->size - r->at)
        return false;
    const uint8_t *from = r->out + r->at - r->rep[0] - 1;
    for (uint8_t *to = r->out + r->at; length > 0; length--, r->at++)
        *to++ = *from++; /* byte by byte, because source and destination can overlap */
    return true;
}

/* Returns whether the whole stream has been read: the encoded number is the start of the range, and no byte is left. */
static bool is_finished(const struct reader *r)
{
    return r->code == 0 && r->in == r->end && !r->overrun;
}

bool lzma_read(const uint8_t *in, size_t n, uint8_t *out, size_t size)
{
    struct reader r = { .in = in, .end = in + n, .range = UINT32_MAX, .out = out, .size = size };

    lzma_model_reset(&r.m);
    if (n < 5 || *r.in++ != 0)
        return false;
    for (int i = 0; i < 4; i++)
        r.code = r.code << 8 | *r.in++;
    while (!r.overrun) {
        if (r.at == size && is_finished(&r))
            return true;
        if (!read_bit(&r, &r.m.match[r.state])) {
            if (r.at == size)
                return false;
            read_literal(&r);
            continue;
        }
        const bool is_rep = read_bit(&r, &r.m.rep[r.state]);
        if (is_rep && r.at == 0)
            return false;
        const uint32_t length = is_rep ? read_rep_match(&r) : read_match(&r);
        if (!is_rep && r.rep[0] == UINT32_MAX) /* an end marker, which some encoders write */
            return r.at == size && is_finished(&r);
        if (!copy_match(&r, length))
            return false;
    }
    return false;
}
