/*
 * progress.h - on a terminal: how far something is that takes longer than a second, and how long it will take yet, in
 * one line that is written over again and again.
 *
 * A program has one standard error, so there is one of these: a command begins it, and whoever does the work, however
 * deep, tells. Where none was begun, and where standard error is no terminal, nothing happens.
 */
#ifndef COMMON_PROGRESS_H
#define COMMON_PROGRESS_H

#include <stddef.h>
#include <stdint.h>

enum { PROGRESS_LINE = 80 /* bytes of the line, with its end */ };

/* A piece of work begins, and with it its clock; one that was going on ends. */
void progress_begin(void);

/* So much is done of all that is to be done; `format` says what is done just now ("frame %u of %u"). May be called as
 * often as one likes: it shows at most four a second, the first after a second. */
void progress_tell(uint64_t done, uint64_t of, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Takes the line off the terminal: before anything else is written there. The next one that is told comes below. */
void progress_wipe(void);

/* The work is done, or was given up. */
void progress_end(void);

/* The line that is shown when so many microseconds have brought `done` of `of`: `what`, cut where it is long, and the
 * time that the rest takes at that pace, if there is a pace yet and it is known how much that is (of is not 0). */
void progress_line(char line[PROGRESS_LINE], const char *what, uint64_t usec, uint64_t done, uint64_t of);

#endif
