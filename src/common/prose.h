/*
 * prose.h - text that grows in memory, for output to a file or the terminal.
 */
#ifndef COMMON_PROSE_H
#define COMMON_PROSE_H

#include <stdbool.h>
#include <stddef.h>

/* Zero it before use; free .bytes afterwards. */
struct prose {
    char *bytes; /* malloc, with a final 0; NULL: empty */
    size_t n, room;
    bool failed; /* out of memory: text is missing */
};

/* Appends text like printf. */
void prose_add(struct prose *p, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
