/*
 * bench_json.h - `curtain bench --json`.
 */
#ifndef WORKBENCH_BENCH_JSON_H
#define WORKBENCH_BENCH_JSON_H

#include "bench.h"
#include "measure.h"

/* Prints one object on one line of standard output. Times are nanoseconds per frame; work is that of profile_work. */
void bench_json(const struct bench *b, const struct measure *m);

#endif
