/*
 * bisect.h - `verify --bisect A B`: finds the first frame in which two outputs of `hash` differ.
 *
 * A and B are tracks (hash, or hash --parts) or traces (hash --trace, see trace.h) of two builds, machines or ROMs. One
 * may be "-", standard input. They are read line by line, so they may have any size.
 */
#ifndef WORKBENCH_BISECT_H
#define WORKBENCH_BISECT_H

#include <stdio.h>
#include "../../common/result.h"
#include "../../player/args/args.h"

/* RESULT_DONE: equal. RESULT_DIFFERS: the frame and its differences have been printed. Otherwise err is set.
 * RESULT_REFUSED: invalid files, different frames or parts, or equal files of different lengths. RESULT_HOST_FAILED:
 * out of memory. */
enum result bisect_paths(const char *a, const char *b, char *err, size_t err_size);

/* The same for two open files. */
enum result bisect_files(FILE *a, const char *a_name, FILE *b, const char *b_name, char *err, size_t err_size);

/* The command verify --bisect. */
enum result bisect_command(const struct args *a);

#endif
