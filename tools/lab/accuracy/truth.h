/*
 * truth.h - true results of the engine's functions, to about 100 bits, from doubles with + - * / and sqrt alone.
 */
#ifndef LAB_TRUTH_H
#define LAB_TRUTH_H

#include <stdint.h>

/* A true result in the last bits of the function's own result: near + rest, near the nearest whole number. */
struct truth {
    int64_t near; /* a tie: the even one */
    double rest;
};

struct truth truth_mul(int32_t a, int32_t b);
struct truth truth_div(int32_t a, int32_t b); /* b != 0 */
struct truth truth_sqrt(int32_t x);           /* x >= 0 */
struct truth truth_rsqrt(int32_t x);          /* x > 0 */
struct truth truth_hypot(int32_t x, int32_t y);
struct truth truth_lerp(int32_t a, int32_t b, int32_t t);

/* size * sin a / 2^16, so the sine itself for size = 2^32; the cosine a quarter of a turn on. */
struct truth truth_sin(int64_t size, uint32_t a);

/* In 2^-32 turns, from 0 to 2^32; (x, y) != (0, 0). */
struct truth truth_atan2(int32_t y, int32_t x);

/* x / length of (x, y), which is not 0. */
struct truth truth_unit(int32_t x, int32_t y);

/* deg in 2^-32 turns, |deg| < 2^20. */
struct truth truth_degrees(double deg);

#endif
