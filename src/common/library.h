/*
 * library.h - opens shared libraries when they are needed to read some kinds of files. The program runs without them.
 * The file that calls a library declares its functions, so a build's features don't depend on installed headers.
 */
#ifndef COMMON_LIBRARY_H
#define COMMON_LIBRARY_H

#include <stdbool.h>
#include <stddef.h>

enum library { LIBRARY_SNDFILE, LIBRARY_OPENMPT, LIBRARIES };

/* A function, and where to store its address. */
struct library_function {
    const char *name;
    void *to; /* a pointer to a function pointer */
};

/* Opens a library, which stays open, and finds n functions in it. Returns false if the library or a function is
 * missing. */
bool library_open(enum library library, const struct library_function *list, size_t n);

/* Sets err to which library is missing and what it is for. Returns false. */
bool library_missing(enum library library, char *err, size_t err_size);

/* Writes a line about a library: its version, or that it is missing, and what it reads. */
void library_about(enum library library, char *text, size_t size);

#endif
