/*
 * err.h - error messages of loaders and parsers.
 */
#ifndef BASE_ERR_H
#define BASE_ERR_H

#include <stdbool.h>
#include <stddef.h>

/* Writes the message to err, truncated to `size` bytes including the NUL. Always returns false, so that a parser can
 * fail with `return err_set(...)`. */
bool err_set(char *err, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));

#endif
