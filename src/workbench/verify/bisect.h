/*
 * bisect.h - `verify --bisect A B`: the first frame in which two runs differ, out of what `hash` printed of each.
 *
 * A and B are tracks (hash, or hash --parts) or traces (hash --trace, see trace.h), of two builds, machines or ROMs;
 * either may be "-", standard input. They are read line by line, so their size does not matter.
 */
#ifndef WORKBENCH_BISECT_H
#define WORKBENCH_BISECT_H

#include <stdio.h>
#include "../../common/result.h"
#include "../../player/args/args.h"

/* RESULT_DONE: equal. RESULT_DIFFERS: the frame, and what differs in it, is on standard output. RESULT_REFUSED: not
 * such files, not of the same frames and parts, or equal but of different lengths; RESULT_HOST_FAILED: no memory; with
 * these one sentence in err. */
enum result bisect_paths(const char *a, const char *b, char *err, size_t err_size);

/* The same of two open files, by the names they have in what is printed. */
enum result bisect_files(FILE *a, const char *a_name, FILE *b, const char *b_name, char *err, size_t err_size);

/* The command verify --bisect. */
enum result bisect_command(const struct args *a);

#endif
