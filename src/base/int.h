/*
 * int.h - the smaller, the larger and the absolute value of whole numbers, and values clamped to a range.
 */
#ifndef BASE_INT_H
#define BASE_INT_H

#include <stdint.h>

/*
 * For a type: NAME_min(a, b), NAME_max(a, b); NAME_abs(v), v not the least there is; NAME_clamp(v, lo, hi), which is v
 * clamped to lo..hi, lo <= hi.
 */
#define INT_FUNCTIONS(name, type)                                                                                      \
    static inline type name##_min(type a, type b)                                                                      \
    {                                                                                                                  \
        return a < b ? a : b;                                                                                          \
    }                                                                                                                  \
    static inline type name##_max(type a, type b)                                                                      \
    {                                                                                                                  \
        return a > b ? a : b;                                                                                          \
    }                                                                                                                  \
    static inline type name##_abs(type v)                                                                              \
    {                                                                                                                  \
        return v < 0 ? -v : v;                                                                                         \
    }                                                                                                                  \
    static inline type name##_clamp(type v, type lo, type hi)                                                          \
    {                                                                                                                  \
        return v < lo ? lo : v > hi ? hi : v;                                                                          \
    }

INT_FUNCTIONS(int, int)
INT_FUNCTIONS(int64, int64_t)

#endif
