/*
 * files.c - see files.h. The seam has no word for why a file cannot be written; where its functions are made of ISO C's,
 * errno has.
 */
#include "files.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include "../../platform/platform.h"

/* "NAME: cannot be VERB (why)" */
static void explain(const char *name, const char *verb, char *err, size_t err_size)
{
    if (errno)
        snprintf(err, err_size, "%s: cannot be %s (%s)", name, verb, strerror(errno));
    else
        snprintf(err, err_size, "%s: cannot be %s", name, verb);
}

static bool wrote(bool good, const char *path, char *err, size_t err_size)
{
    if (!good)
        explain(path, "written", err, err_size);
    return good;
}

bool files_save(const char *path, const void *data, size_t size, char *err, size_t err_size)
{
    errno = 0;
    return wrote(plat_save(path, data, size), path, err, err_size);
}

bool files_append(const char *path, const void *data, size_t size, char *err, size_t err_size)
{
    errno = 0;
    return wrote(plat_append(path, data, size), path, err, err_size);
}

bool files_load(const char *path, const char *name, void *to, size_t size, char *err, size_t err_size)
{
    errno = 0;
    if (plat_load(path, to, size) == (long)size)
        return true;
    explain(name, "read", err, err_size);
    return false;
}

long files_size(const char *path)
{
    errno = 0;
    return plat_size(path);
}

const char *files_absent(const char *name, const char *what, char *err, size_t err_size)
{
    if (errno && errno != ENOENT && errno != ENOTDIR)
        explain(name, "read", err, err_size);
    else
        snprintf(err, err_size, "%s: no such %s", name, what);
    return err;
}
