/*
 * files.c - see files.h. The seam has no word for why a file cannot be written; where its functions are made of ISO C's,
 * errno has.
 */
#include "files.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include "../../platform/platform.h"

static bool explain(bool good, const char *path, char *err, size_t err_size)
{
    if (!good && errno)
        snprintf(err, err_size, "%s: cannot be written (%s)", path, strerror(errno));
    else if (!good)
        snprintf(err, err_size, "%s: cannot be written", path);
    return good;
}

bool files_save(const char *path, const void *data, size_t size, char *err, size_t err_size)
{
    errno = 0;
    return explain(plat_save(path, data, size), path, err, err_size);
}

bool files_append(const char *path, const void *data, size_t size, char *err, size_t err_size)
{
    errno = 0;
    return explain(plat_append(path, data, size), path, err, err_size);
}
