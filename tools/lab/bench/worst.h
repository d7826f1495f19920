/*
 * worst.h - the operations of Lua that take longest for what the guard counts, each in an endless loop.
 */
#ifndef BENCH_WORST_H
#define BENCH_WORST_H

#include <stdint.h>
#include "../../../src/machine/machine.h"
#include "../../../src/script/vm.h"

struct worst {
    const char *what;
    uint32_t cost;    /* what a round of the loop is charged at least */
    const char *text; /* a chunk that never ends; `...` is a table in whose `n` it counts rounds */
};

extern const struct worst WORST[];
extern const int WORST_COUNT;

enum {
    WORST_LUA_KIB = 16 << 10, /* of heap that the operations want; roms/bench has as many */
    WORST_LIMIT = 5000000     /* of work, after which they are stopped */
};

/* Runs one, counting, on a board that is of no use afterwards. How often it ran; *fault is what stopped it, NULL:
 * none. */
uint64_t worst_run(struct board *b, const struct worst *w, const char **fault);

#endif
