/*
 * oracle.h - sines and cosines to 124 bits and more, made by MPFR; MPFR itself where that does not decide. Nothing of
 * the engine is included here.
 *
 * Angles are in half angs, 2^-33 of a turn, so that what is halfway between two angs is a whole number too. Fractions
 * of 128 bits are in units of 2^-128; one is 2^128 - 1.
 */
#ifndef PROVE_ORACLE_H
#define PROVE_ORACLE_H

#include <math.h>
#include "prove.h"

enum {
    ORACLE_LOW = 16,                            /* bits of an angle for the second table */
    ORACLE_HIGH = (1 << (31 - ORACLE_LOW)) + 1, /* entries of the first: a quarter turn, its end included */
};
static const uint32_t ORACLE_QUARTER = 0x80000000; /* a quarter turn */

struct oracle_high {
    u128 sine, cosine;
};
struct oracle_low {
    u128 sine, versine; /* 1 - cosine: angles below 2^-17 turns */
};
extern struct oracle_high oracle_high[ORACLE_HIGH];
extern struct oracle_low oracle_low[1 << ORACLE_LOW];

/* Fills the tables. */
void oracle_open(void);

/* Gives back what MPFR keeps for a thread, at its end. */
void oracle_thread_ends(void);

/* The high half of the product, less at most 2. */
static inline u128 oracle_product(u128 a, u128 b)
{
    uint64_t ah = (uint64_t)(a >> 64), al = (uint64_t)a, bh = (uint64_t)(b >> 64), bl = (uint64_t)b;

    return (u128)ah * bh + ((u128)ah * bl >> 64) + ((u128)al * bh >> 64);
}

/*
 * Sine and cosine of h <= a quarter turn, by sin(a+b) = sin a - sin a (1 - cos b) + cos a sin b and its like. Off by
 * less than 2^-124: four table entries off by 1/2, products by 2, one by 1.
 */
static inline void oracle_circle(uint32_t h, u128 *sine, u128 *cosine)
{
    const struct oracle_high *a = &oracle_high[h >> ORACLE_LOW];
    const struct oracle_low *b = &oracle_low[h & ((1 << ORACLE_LOW) - 1)];

    *sine = a->sine - oracle_product(a->sine, b->versine) + oracle_product(a->cosine, b->sine);
    *cosine = a->cosine - oracle_product(a->cosine, b->versine) - oracle_product(a->sine, b->sine);
}

/* v, of which 2^-128 is a unit, as a double. */
static inline double oracle_double(u128 v)
{
    return (double)(uint64_t)(v >> 64) * 0x1p-64 + (double)(uint64_t)v * 0x1p-128;
}

/* The sign of m * sin(h) - n/2, or with the cosine, by MPFR with 512 bits. */
int oracle_sine_side(uint32_t h, bool cosine, uint64_t m, uint64_t n);

/* The sign of y cos(h) - x sin(h), h of 33 bits: > 0 where (x, y) lies clockwise of the ray. */
int oracle_ray_side(uint64_t h, int64_t x, int64_t y);

/* What MPFR makes of a function, rounded once to a whole number, ties to even: for a sample of each function. */
int64_t oracle_sqrt(int64_t n);  /* sqrt(n * 2^16) */
int64_t oracle_rsqrt(int64_t n); /* 2^24 / sqrt(n) */
int64_t oracle_hypot(int64_t x, int64_t y);
int64_t oracle_sine(uint32_t ang, bool cosine, int64_t scale);    /* scale * sin */
int64_t oracle_atan2(int64_t y, int64_t x);                       /* in 2^-32 turns, -2^31..2^31 */
int64_t oracle_unit(int64_t x, int64_t y);                        /* 2^16 x / hypot(x, y) */
int64_t oracle_ratio(int64_t a, int64_t b, int64_t c, int64_t d); /* (a * b + c) / d */

/* floor(sqrt(2^34 - odd^2) * 2^77), odd < 2^17 */
u128 oracle_other_side(uint32_t odd);

/*
 * A continued fraction, walked: the convergents n/d of b/a, 0 <= b <= a <= 2^94. They are the fractions nearest to b/a
 * for their size: whenever |d * b/a - n| < 1/(2d), n/d in lowest terms is one of them (Legendre).
 */
struct walk {
    u128 before, rest; /* |d * b - n * a| of the last convergent but one, and the last */
    uint64_t n0, d0, n, d;
};

static inline struct walk walk_from(u128 b, u128 a)
{
    return (struct walk){ a, b, 1, 0, 0, 1 };
}

/* The quotient, rounded down; by doubles where they come within one of it. */
static inline uint64_t walk_divide(u128 a, u128 b, u128 *rest)
{
    int64_t ah = (int64_t)(a >> 32), bh = (int64_t)(b >> 32);
    uint64_t q;

    if (bh > 1 << 28 && ah >> 20 < bh) {
        q = (uint64_t)(int64_t)((double)ah / (double)bh);
        *rest = a - q * b;
        if ((i128)*rest < 0)
            q--, *rest += b;
        else if (*rest >= b)
            q++, *rest -= b;
        return q;
    }
    *rest = a % b;
    return a / b > UINT64_MAX ? UINT64_MAX : (uint64_t)(a / b);
}

/* To the next convergent; false when there is none with d <= limit < 2^33. */
static inline bool walk_next(struct walk *w, uint64_t limit)
{
    u128 rest;
    uint64_t q, d, n;

    if (w->rest == 0)
        return false;
    q = walk_divide(w->before, w->rest, &rest);
    if (q > limit)
        return false;
    d = q * w->d + w->d0;
    n = q * w->n + w->n0;
    if (d > limit)
        return false;
    *w = (struct walk){ w->rest, rest, w->n, w->d, n, d };
    return true;
}

#endif
