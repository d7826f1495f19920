/*
 * progress.h - on a terminal, a line of how far a command is and how long it will take, once it takes longer than a
 * second. Elsewhere nothing.
 * floor: cab
 */
#ifndef CAB_PROGRESS_H
#define CAB_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

struct progress {
    uint64_t begun, told; /* usec */
    bool terminal;
};

/* Begins now. */
void progress_open(struct progress *p);

/* So much of `all` is done, in any unit; all 0: not known. The format's text stands before the time that is left. May
 * be called often: it writes four times a second at most. */
void progress_tell(struct progress *p, uint64_t done, uint64_t all, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Takes the line away, before anything else is written, and at the end. */
void progress_clear(struct progress *p);

#endif
