/*
 * bench_print.h - what `curtain bench` measured, as text to be read.
 */
#ifndef WORKBENCH_BENCH_PRINT_H
#define WORKBENCH_BENCH_PRINT_H

#include "bench.h"
#include "measure.h"

enum { BENCH_LINES = 10 /* the dearest ones */ };

/* After measure_end, on standard output. */
void bench_print(const struct bench *b, const struct measure *m);

/* The dearest lines of Lua, at most n, dearest first; returns how many there are. */
int bench_lines(const struct measure *m, const struct profile_line *out[], int n);

/* The text of that line ("stages/one.lua:42"), without what it begins and ends with in blanks, cut to fit; "": it is
 * not known. */
void bench_text(const struct measure *m, const char *place, char *text, size_t size);

#endif
