/*
 * err.h - the sentence with which a loader or parser says no.
 */
#ifndef BASE_ERR_H
#define BASE_ERR_H

#include <stdbool.h>
#include <stddef.h>

/* Writes the sentence, cut to size bytes with its 0. Returns false, so that `return err_set(...)` ends a reader. */
bool err_set(char *err, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));

#endif
