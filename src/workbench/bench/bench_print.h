/*
 * bench_print.h - the results of `curtain bench` as text.
 */
#ifndef WORKBENCH_BENCH_PRINT_H
#define WORKBENCH_BENCH_PRINT_H

#include "bench.h"
#include "measure.h"

enum { BENCH_LINES = 10 };

/* Prints the results after measure_end. */
void bench_print(const struct bench *b, const struct measure *m);

/* Stores the most expensive lines of Lua, at most n, the most expensive first; returns how many. */
int bench_top_lines(const struct measure *m, const struct profile_line *out[], int n);

/* Writes the source text of a line ("stages/one.lua:42"), trimmed and cut to fit; "" if the line is unknown. */
void bench_line_text(const struct measure *m, const char *place, char *text, size_t size);

#endif
