/*
 * prose.h - text that grows in memory, for output to a file or the terminal.
 */
#ifndef COMMON_PROSE_H
#define COMMON_PROSE_H

#include <stdbool.h>
#include <stddef.h>

/* Starts as zeroes; free bytes at its end. */
struct prose {
    char *bytes; /* malloc, with a 0 behind it; NULL: nothing was added yet */
    size_t n, room;
    bool failed; /* out of memory: some of it is lost */
};

/* Adds text as printf would. */
void prose_add(struct prose *p, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
