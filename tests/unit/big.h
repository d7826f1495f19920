/*
 * big.h - 384-bit signed integers for the oracles of the arithmetic tests: slow, plain, and nothing of the engine in
 * it. Two's complement, modulo 2^384.
 */
#ifndef TEST_BIG_H
#define TEST_BIG_H

#include <stdbool.h>
#include <stdint.h>

enum { BIG_LIMBS = 12 };

struct big {
    uint32_t limb[BIG_LIMBS]; /* the least significant first */
};

static inline struct big big_int(int64_t v)
{
    struct big b = { { (uint32_t)v, (uint32_t)((uint64_t)v >> 32) } };

    for (int i = 2; i < BIG_LIMBS; i++)
        b.limb[i] = v < 0 ? 0xffffffffu : 0;
    return b;
}

static inline struct big big_add(struct big a, struct big b)
{
    uint64_t carry = 0;

    for (int i = 0; i < BIG_LIMBS; i++) {
        carry += (uint64_t)a.limb[i] + b.limb[i];
        a.limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    return a;
}

static inline struct big big_neg(struct big a)
{
    for (int i = 0; i < BIG_LIMBS; i++)
        a.limb[i] = ~a.limb[i];
    return big_add(a, big_int(1));
}

static inline struct big big_sub(struct big a, struct big b)
{
    return big_add(a, big_neg(b));
}

static inline struct big big_mul(struct big a, struct big b)
{
    struct big p = { { 0 } };

    for (int i = 0; i < BIG_LIMBS; i++) {
        uint64_t carry = 0;

        for (int j = 0; i + j < BIG_LIMBS; j++) {
            carry += (uint64_t)a.limb[i] * b.limb[j] + p.limb[i + j];
            p.limb[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
    }
    return p;
}

static inline bool big_negative(struct big a)
{
    return a.limb[BIG_LIMBS - 1] >> 31;
}

/* -1, 0 or 1 */
static inline int big_sign(struct big a)
{
    for (int i = 0; i < BIG_LIMBS; i++)
        if (a.limb[i])
            return big_negative(a) ? -1 : 1;
    return 0;
}

/* The sign of a - b. */
static inline int big_compare(struct big a, struct big b)
{
    return big_sign(big_sub(a, b));
}

static inline struct big big_shift_left(struct big a, int by)
{
    for (; by >= 32; by -= 32) {
        for (int i = BIG_LIMBS - 1; i > 0; i--)
            a.limb[i] = a.limb[i - 1];
        a.limb[0] = 0;
    }
    return big_mul(a, big_int((int64_t)1 << by));
}

/* Towards minus infinity. */
static inline struct big big_shift_right(struct big a, int by)
{
    uint32_t fill = big_negative(a) ? 0xffffffffu : 0;

    for (; by >= 32; by -= 32) {
        for (int i = 0; i < BIG_LIMBS - 1; i++)
            a.limb[i] = a.limb[i + 1];
        a.limb[BIG_LIMBS - 1] = fill;
    }
    for (int i = 0; by && i < BIG_LIMBS; i++)
        a.limb[i] = a.limb[i] >> by | (i < BIG_LIMBS - 1 ? a.limb[i + 1] : fill) << (32 - by);
    return a;
}

/* The quotient, rounded down, of a >= 0 by b > 0, and the rest in *rest; bit by bit. */
static inline struct big big_divide(struct big a, struct big b, struct big *rest)
{
    struct big q = { { 0 } }, r = { { 0 } };

    for (int i = 32 * BIG_LIMBS - 1; i >= 0; i--) {
        r = big_add(r, r);
        r.limb[0] |= a.limb[i / 32] >> (i % 32) & 1;
        if (big_compare(r, b) >= 0) {
            r = big_sub(r, b);
            q.limb[i / 32] |= 1u << (i % 32);
        }
    }
    *rest = r;
    return q;
}

/* a >= 0 by a small divisor. */
static inline struct big big_divide_small(struct big a, uint32_t b)
{
    uint64_t rest = 0;

    for (int i = BIG_LIMBS - 1; i >= 0; i--) {
        rest = rest << 32 | a.limb[i];
        a.limb[i] = (uint32_t)(rest / b);
        rest %= b;
    }
    return a;
}

static inline int64_t big_low(struct big a)
{
    return (int64_t)((uint64_t)a.limb[1] << 32 | a.limb[0]);
}

/*
 * Is r the whole number nearest to n / d, ties to even, d > 0? If not clamped, that is 2|n - rd| < d, or equal and r
 * even; a clamped r stands for all that lies beyond it.
 */
static inline bool big_rounds_to(struct big n, struct big d, int64_t r, int64_t low, int64_t high)
{
    struct big off = big_sub(n, big_mul(d, big_int(r)));
    bool up = !big_negative(off);
    struct big twice = big_add(off, off);
    int c = big_compare(up ? twice : big_neg(twice), d);

    if (r < low || r > high)
        return false;
    if ((r == high && up) || (r == low && !up))
        return true;
    return c < 0 || (c == 0 && r % 2 == 0);
}

#endif
