/*
 * no_files.c - stubs for the file functions that recording to a file uses. The library records in memory only, so they
 * are never called and no file is opened.
 */
#pragma GCC diagnostic ignored "-Wunused-parameter" /* the functions do nothing */

#include "../../platform/platform.h"
#include "../base/err.h"
#include "../common/files.h"

bool files_save(const char *path, const void *data, size_t size, char *err, size_t err_size)
{
    return err_set(err, err_size, "no file system");
}

bool files_append(const char *path, const void *data, size_t size, char *err, size_t err_size)
{
    return files_save(path, data, size, err, err_size);
}

const char *files_display_name(const char *name, char path[FILES_PATH_SIZE])
{
    return name;
}

long plat_file_size(const char *name)
{
    return -1;
}

bool plat_remove(const char *name)
{
    return false;
}
