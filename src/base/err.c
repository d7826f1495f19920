/*
 * err.c - see err.h.
 */
#include "err.h"

#include <stdarg.h>
#include <stdio.h>

bool err_set(char *err, size_t size, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    vsnprintf(err, size, format, args);
    va_end(args);
    return false;
}
