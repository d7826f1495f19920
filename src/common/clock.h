/*
 * clock.h - measures time with the port's clock.
 */
#ifndef COMMON_CLOCK_H
#define COMMON_CLOCK_H

#include <stdint.h>
#include "../../platform/platform.h"

/* Returns the microseconds since *last, or 0 if the clock went back, and sets *last to the present time. */
static inline uint64_t clock_lap(uint64_t *last)
{
    const uint64_t now = plat_usec(), took = now > *last ? now - *last : 0;

    *last = now;
    return took;
}

/* Returns the microseconds since `then`. */
static inline uint64_t clock_since(uint64_t then)
{
    return clock_lap(&then);
}

#endif
