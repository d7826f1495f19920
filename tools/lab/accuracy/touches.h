/*
 * touches.h - does a point touch a circle on its way? Exact, and shares nothing with the engine.
 */
#ifndef LAB_TOUCHES_H
#define LAB_TOUCHES_H

#include <stdbool.h>
#include <stdint.h>

/* Does the way from d to d + w come within r of the origin? |d|, |w| < 2^29. */
bool touches_truly(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r);

#endif
