/*
 * lzma.h - bytes made small as LZMA does it: matches, and a range coder over bits that are expected.
 *
 * A stream is what liblzma calls raw LZMA1 with lc = 0, lp = 0 and pb = 0, whose dictionary is all that came before.
 * Other programs can write and read it; tests/cli/compressed.sh has Python's do both.
 */
#ifndef ROM_LZMA_H
#define ROM_LZMA_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    LZMA_SHORTEST = 2, /* bytes of a match */
    LZMA_LONGEST = 273,
    LZMA_REPS = 4, /* distances that are remembered */
    LZMA_STATES = 12,
    LZMA_LITERALS = 7, /* states below it are those after a literal */
    LZMA_LENGTHS = 4,  /* how slots of distances are told apart: by matches of 2, 3, 4 and more bytes */
    LZMA_NEAR = 14,    /* slots below it have all their bits expected */
    LZMA_ALIGN = 4,    /* bits at a distance's end that are expected where the others are not */
    LZMA_SCALE = 11,
    LZMA_PACE = 5,     /* odds move by 1/32 of what they were off */
    LZMA_TOP = 1 << 24 /* a range below it takes another byte */
};

/* How likely a bit is 0, of 2048. */
typedef uint16_t lzma_odds;

struct lzma_length {
    lzma_odds choice[2], low[8], middle[8], high[256];
};

/* What has been seen of each kind of bit so far; the writer's and the reader's are the same at each byte. */
struct lzma_model {
    lzma_odds match[LZMA_STATES], rep[LZMA_STATES], rep_0[LZMA_STATES], rep_0_long[LZMA_STATES], rep_1[LZMA_STATES],
        rep_2[LZMA_STATES];
    lzma_odds slot[LZMA_LENGTHS][64], near[128], align[1 << LZMA_ALIGN];
    struct lzma_length length, rep_length;
    lzma_odds literal[3][256]; /* plain; after a match, by the bit that would have gone on with it */
};

void lzma_model_reset(struct lzma_model *m);

/* The state after a literal, and after a match: plain, of a remembered distance, of one byte of the last distance. */
enum lzma_match { LZMA_MATCH, LZMA_REP, LZMA_SHORT_REP };
int lzma_after_literal(int state);
int lzma_after(int state, enum lzma_match match);

/* Reads a stream that is just `size` bytes plain. False: it is not; what out has then is of no use. */
bool lzma_read(const uint8_t *in, size_t n, uint8_t *out, size_t size);

#endif
