/*
 * prove.h - what the proof programs share: inputs in chunks, two threads, counts, and a line for each function.
 *
 *     PROGRAM [--sample] [--seed N] [--threads N] [--only NAME] [--hard FILE]
 *
 * Without --sample every input named in the lines is tried. --sample tries the known hard cases (hard.inc) and a few
 * chunks of everything else, chosen by the seed. Inputs depend on the seed alone, not on the threads. --hard appends
 * the inputs found nearest to a tie to FILE, in the form of hard.inc. Exit 1 if anything was misrounded.
 */
#ifndef PROVE_H
#define PROVE_H

#include <stdbool.h>
#include <stdint.h>
#include "../numbers.h"

__extension__ typedef unsigned __int128 u128;
__extension__ typedef __int128 i128;

enum {
    PROVE_TALLIES = 4, /* functions proved in one pass over their inputs */
    PROVE_HARD = 32,
    PROVE_WRONG = 3
};

/* Two integers stand for an input; what they mean is the function's affair. */
struct prove_case {
    int64_t a, b;
};

struct tally {
    uint64_t tried, wrong, ties, near, by_mpfr;
    double worst;   /* error of a wrong result, ulp */
    double nearest; /* the least distance of an exact value from a tie that is no tie itself, ulp */
    double keep;    /* what is farther from a tie needs no more attention */
    int hards, wrongs;
    double off[PROVE_HARD];             /* nearest first, */
    struct prove_case hard[PROVE_HARD]; /* and the inputs */
    struct {
        struct prove_case input;
        int64_t got, want;
    } first[PROVE_WRONG];
};

/* Nearer than this to a tie is "near". */
#define PROVE_NEAR 0x1p-16

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

/* A right result; `off` is the distance of the exact value from the nearest tie, 0.5 where that means nothing. */
void tally_near(struct tally *t, double off, int64_t a, int64_t b);
static inline void tally_right(struct tally *t, double off, int64_t a, int64_t b)
{
    t->tried++;
    if (off < t->keep)
        tally_near(t, off, a, b);
}

/* A wrong one, its error in ulp. */
void tally_wrong(struct tally *t, double error, int64_t a, int64_t b, int64_t got, int64_t want);

/* Of any magnitude: all 32 bits, or fewer. */
static inline int32_t prove_scaled(uint64_t *state)
{
    uint64_t z = numbers_random(state);

    return (int32_t)((int64_t)z >> 32 >> (z & 31));
}

/* Tries the chunk-th part of some inputs; t[0..PROVE_TALLIES) are its counts. */
typedef void prove_chunk(uint64_t chunk, struct tally *t, uint64_t *random);

/* All of the chunks, or with --sample so many: the first, the last, and others by chance. */
void prove_phase(prove_chunk *f, uint64_t chunks, uint64_t sample);

/* Is only a sample wanted? */
bool prove_sampled(void);

/* Tries one input. */
typedef void prove_try(struct tally *t, int64_t a, int64_t b);

/* Tries the inputs that hard.inc has for a function; counted by tally `id`. */
void prove_hard(int id, const char *name, prove_try *f);

/* Ends a proof: the line of tally `id`, with how its inputs were found. */
void prove_line(int id, const char *name, const char *how);

/* A proof prints the lines of one or more functions; its name is what --only asks for. */
struct proof {
    const char *name;
    void (*prove)(void);
};

int prove_main(int argc, char **argv, const struct proof *proofs, int n);

#endif
