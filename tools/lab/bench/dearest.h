/*
 * dearest.h - a game for each feature whose work has no other bound than the guard: the dearest frame that a manifest
 * allows, or one that the guard ends.
 */
#ifndef BENCH_DEAREST_H
#define BENCH_DEAREST_H

#include "scene.h"

struct dearest {
    const char *what;
    const char *says; /* part of the fault that ends it; NULL: it stays below the limit */
    int frames;       /* that it runs at most */
    uint64_t least;   /* work that its dearest frame counts at least */
    struct scene_want want;
};

extern const struct dearest DEAREST[];
extern const int DEAREST_COUNT;

#endif
