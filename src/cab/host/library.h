/*
 * library.h - a shared library that is opened when it is needed: it is there to read some kinds of files, and a program
 * that reads none of them runs without it.
 * floor: cab
 */
#ifndef CAB_LIBRARY_H
#define CAB_LIBRARY_H

#include <stdbool.h>
#include <stddef.h>

/* A function, and where its address goes. */
struct library_function {
    const char *name;
    void *to; /* a pointer to a function pointer */
};

/* Opens a library, for good, and finds n functions in it. False: it is not there, or is another one. */
bool library_open(const char *name, const struct library_function *list, size_t n);

#endif
