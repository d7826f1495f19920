/*
 * result.c - records whether the host caused a failure (result.h).
 */
#include "result.h"

#include <stdarg.h>
#include <stdio.h>

static bool host_failed;

void result_set_host_failed(void)
{
    host_failed = true;
}

bool result_set_host_error(char *err, size_t size, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    vsnprintf(err, size, format, args);
    va_end(args);
    result_set_host_failed();
    return false;
}

enum result result_take_cause(void)
{
    const bool is_host_failure = host_failed;

    host_failed = false;
    return is_host_failure ? RESULT_HOST_FAILED : RESULT_REFUSED;
}
