/*
 * rng.h - random streams. A stream is a struct in its owner's state; there is no global stream.
 *
 * xoshiro256** 1.0 (Blackman and Vigna, 2018) seeded by splitmix64, integers only: the same numbers on every host.
 */
#ifndef BASE_RNG_H
#define BASE_RNG_H

#include <stdint.h>

struct rng {
    uint64_t s[4];
};

static inline uint64_t rng_rotate(uint64_t v, int count)
{
    return v << count | v >> (64 - count);
}

/* Seeds the stream; any seed is good, 0 included. */
static inline void rng_seed(struct rng *r, uint64_t seed)
{
    for (int i = 0; i < 4; i++) {
        uint64_t z = seed += 0x9e3779b97f4a7c15u;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        r->s[i] = z ^ z >> 31;
    }
}

/* Returns the next 64 random bits. */
static inline uint64_t rng_next(struct rng *r)
{
    uint64_t *s = r->s, out = rng_rotate(s[1] * 5, 7) * 9, t = s[1] << 17;

    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = rng_rotate(s[3], 45);
    return out;
}

/* Returns a uniform number in [0, n), n >= 1. Draws again (rarely) so that small numbers are not favoured. */
static inline uint64_t rng_below(struct rng *r, uint64_t n)
{
    uint64_t limit = 0 - n, v;

    limit %= n; /* 2^64 mod n: the number of values that would be drawn too often */
    do
        v = rng_next(r);
    while (v < limit);
    return v % n;
}

#endif
