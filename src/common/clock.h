/*
 * clock.h - how long something took, by the port's clock.
 */
#ifndef COMMON_CLOCK_H
#define COMMON_CLOCK_H

#include <stdint.h>
#include "../../platform/platform.h"

/* Microseconds since plat_usec() was *last, 0 if the port's clock went back all the same; *last is now. */
static inline uint64_t clock_lap(uint64_t *last)
{
    const uint64_t now = plat_usec(), took = now > *last ? now - *last : 0;

    *last = now;
    return took;
}

/* Microseconds since plat_usec() was `then`. */
static inline uint64_t clock_since(uint64_t then)
{
    return clock_lap(&then);
}

#endif
