/*
 * report.h - what went wrong, and what a script printed, on plat_log: lines of which clean_line has blanked what is no
 * text.
 */
#ifndef COMMON_REPORT_H
#define COMMON_REPORT_H

#include <stdbool.h>
#include "../board/board.h"
#include "result.h"

/* One line, "curtain: ..."; returns result. */
enum result report_line(enum result result, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A sentence on plat_log; returns result_take_cause(). */
enum result report_error(const char *err);

/* The last sentence that said why something failed, without the program's name; "": there was none. */
const char *report_last(void);

/* Text on standard output, as printf has it; what may not be shown is blanked. */
void report_print(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* A fault: "FILE:LINE: what", and the traceback if asked. Returns RESULT_REFUSED. */
enum result report_fault(const struct board_fault *fault, bool trace);

/* What scripts printed in a tick, a line each, with `prefix` before it. */
void report_log(const struct board_out *out, const char *prefix);

/* Standard output is flushed; returns result, or when it could not be written RESULT_HOST_FAILED, with a line. */
enum result report_stdout(enum result result);

#endif
