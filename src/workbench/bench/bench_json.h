/*
 * bench_json.h - `curtain bench --json`.
 */
#ifndef WORKBENCH_BENCH_JSON_H
#define WORKBENCH_BENCH_JSON_H

#include "bench.h"
#include "measure.h"

/* One object on one line of standard output. Times are nanoseconds, of a frame; work as profile_work has it. */
void bench_json(const struct bench *b, const struct measure *m);

#endif
