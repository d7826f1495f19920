/*
 * numbers.h - what the measuring and proving programs share: random numbers, and doubles in order.
 */
#ifndef TOOLS_NUMBERS_H
#define TOOLS_NUMBERS_H

#include <stdint.h>
#include <stdlib.h>

/* The next of a stream of pseudo-random numbers: splitmix64, Steele, Lea and Flood 2014. */
static inline uint64_t numbers_random(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15;

    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
}

static inline int numbers_compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Sorts n doubles, the least first: v[n / 2] is the median then. */
static inline void numbers_sort(double *v, size_t n)
{
    qsort(v, n, sizeof *v, numbers_compare);
}

#endif
