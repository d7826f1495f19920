/*
 * err.h - error messages of loaders and parsers.
 */
#ifndef BASE_ERR_H
#define BASE_ERR_H

#include <stdbool.h>
#include <stddef.h>

/* Writes the message, cut to size bytes including its NUL. Returns false, so that `return err_set(...)` ends a
 * reader. */
bool err_set(char *err, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));

#endif
