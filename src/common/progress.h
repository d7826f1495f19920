/*
 * progress.h - shows the progress of long work on a terminal, in one line that is rewritten.
 *
 * There is one progress line, as a program has one standard error. A command starts it with progress_begin, and the
 * code that does the work calls progress_update. Without progress_begin, or without a terminal, nothing is shown.
 */
#ifndef COMMON_PROGRESS_H
#define COMMON_PROGRESS_H

#include <stddef.h>
#include <stdint.h>

enum { PROGRESS_LINE = 80 /* bytes of the line, including the NUL */ };

/* Starts the progress of some work, and ends that of earlier work. */
void progress_begin(void);

/* Reports that `done` of `of` steps are done; `format` describes the current step ("frame %u of %u"). Can be called
 * often: the line appears after a second and changes at most four times a second. */
void progress_update(uint64_t done, uint64_t of, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Removes the line from the terminal. Call it before printing anything else. */
void progress_clear(void);

/* Ends the progress of the work. */
void progress_end(void);

/* Makes the line for `done` of `of` steps after `usec` microseconds: `what`, truncated if necessary, and the estimated
 * time left, unless done or of is 0. */
void progress_line(char line[PROGRESS_LINE], const char *what, uint64_t usec, uint64_t done, uint64_t of);

#endif
