/*
 * library.h - shared libraries that are opened when they are needed: they read some kinds of files, and a program that
 * reads none of them runs without. Their few declarations are ours, in the file that calls them, so that what a build
 * can do depends on no header that happens to be installed.
 */
#ifndef COMMON_LIBRARY_H
#define COMMON_LIBRARY_H

#include <stdbool.h>
#include <stddef.h>

enum library { LIBRARY_SNDFILE, LIBRARY_OPENMPT, LIBRARIES };

/* A function, and where its address goes. */
struct library_function {
    const char *name;
    void *to; /* a pointer to a function pointer */
};

/* Opens a library, for good, and finds n functions in it. False: it is missing, or lacks one of them. */
bool library_open(enum library library, const struct library_function *list, size_t n);

/* Writes a sentence that says which library is missing, and what for. Always false. */
bool library_missing(enum library library, char *err, size_t err_size);

/* Writes one line about a library: its version, or that it is missing, and what it is for. */
void library_about(enum library library, char *text, size_t size);

#endif
