/*
 * lzma.h - LZMA: matches, and a range coder with adaptive bit probabilities.
 *
 * A stream is what liblzma calls raw LZMA1 with lc = 0, lp = 0 and pb = 0; its dictionary is all preceding output.
 * Other programs can write and read it; tests/cli/compressed.sh does both with Python's lzma module.
 */
#ifndef ROM_LZMA_H
#define ROM_LZMA_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    LZMA_MIN_MATCH = 2, /* minimum bytes of a match */
    LZMA_MAX_MATCH = 273,
    LZMA_REPS = 4, /* number of remembered distances */
    LZMA_STATES = 12,
    LZMA_LITERAL_STATES = 7, /* in states below this one, the last symbol was a literal */
    LZMA_SLOT_MODELS = 4,    /* models of distance slots: for matches of 2, 3, 4, and 5 or more bytes */
    LZMA_MODELLED_SLOTS =
        14,              /* in distance slots below this one, all bits of a distance are coded with probabilities */
    LZMA_ALIGN_BITS = 4, /* in the other slots, only the lowest LZMA_ALIGN_BITS bits are; the rest are direct bits */
    LZMA_PROB_BITS = 11,
    LZMA_ADAPT_SHIFT =
        5, /* adaptation rate: each bit moves its probability 2^-LZMA_ADAPT_SHIFT of the way towards that bit */
    LZMA_TOP = 1 << 24 /* when the range is below this, another byte is read or written */
};

/* The probability that a bit is 0, of 2048. */
typedef uint16_t lzma_prob;

struct lzma_length {
    lzma_prob choice[2], low[8], middle[8], high[256];
};

/* The probability of each kind of bit, adapted to the bits so far. The writer and the reader have equal models at each
 * bit. */
struct lzma_model {
    lzma_prob match[LZMA_STATES], rep[LZMA_STATES], rep_0[LZMA_STATES], rep_0_long[LZMA_STATES], rep_1[LZMA_STATES],
        rep_2[LZMA_STATES];
    lzma_prob slot[LZMA_SLOT_MODELS][64], near[128], align[1 << LZMA_ALIGN_BITS];
    struct lzma_length length, rep_length;
    lzma_prob literal[3][256]; /* [0]: plain; [1 + b]: after a match whose next bit would have been b */
};

void lzma_model_reset(struct lzma_model *m);

/* lzma_state_after_literal returns the state that follows `state` after a literal; lzma_state_after_match, the one
 * after a match: with a new distance, with a remembered distance, or of one byte at the last distance. */
enum lzma_match { LZMA_MATCH, LZMA_REP, LZMA_SHORT_REP };
int lzma_state_after_literal(int state);
int lzma_state_after_match(int state, enum lzma_match match);

/* Decompresses a stream of exactly `size` plain bytes. Returns false if the stream is damaged or has another size; the
 * contents of out are then undefined. */
bool lzma_read(const uint8_t *in, size_t n, uint8_t *out, size_t size);

#endif
