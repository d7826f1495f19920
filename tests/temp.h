/*
 * temp.h - a folder for a test's files, in $TMPDIR or /tmp. A program that includes this has _POSIX_C_SOURCE 200809L,
 * or more, defined before all includes.
 */
#ifndef TESTS_TEMP_H
#define TESTS_TEMP_H

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

/* Makes one whose name begins with `name` and writes its path to dir; false: it cannot be made. */
static inline bool temp_folder(char *dir, size_t size, const char *name)
{
    const char *tmp = getenv("TMPDIR");

    snprintf(dir, size, "%s/%s-XXXXXX", tmp ? tmp : "/tmp", name);
    return mkdtemp(dir) != NULL;
}

#endif
