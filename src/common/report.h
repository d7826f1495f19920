/*
 * report.h - prints errors, faults and script output with plat_log, after cleaning each line with clean_line.
 */
#ifndef COMMON_REPORT_H
#define COMMON_REPORT_H

#include <stdbool.h>
#include "../board/board.h"
#include "result.h"

/* Prints one line, "curtain: ...". Returns result. */
enum result report_line(enum result result, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Prints an error like report_line. Returns result_take_cause(). */
enum result report_error(const char *err);

/* Returns the last error or fault, without the program's name; "" if there was none. */
const char *report_last(void);

/* Prints text to standard output like printf, after cleaning it with clean_lines. */
void report_print(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Prints a fault, "FILE:LINE: ...", and the traceback if `trace` is set. Returns RESULT_REFUSED. */
enum result report_fault(const struct board_fault *fault, bool trace);

/* Prints the script output of a tick, with `prefix` before each line. */
void report_log(const struct board_out *out, const char *prefix);

/* Saves a PNG picture of png_write in a file and frees it; NULL: there was no memory for it. Prints an error. */
enum result report_save_png(const char *path, uint8_t *png, size_t size);

/* Flushes standard output. Returns result, or if that failed, prints an error and returns RESULT_HOST_FAILED. */
enum result report_stdout(enum result result);

#endif
