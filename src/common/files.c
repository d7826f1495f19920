/*
 * files.c - reads and writes files (files.h). The platform API does not report why a write failed; where the API is
 * implemented with ISO C functions, errno has the reason.
 */
#include "files.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"
#include "../base/err.h"
#include "result.h"

const char *files_display_name(const char *name, char path[FILES_PATH_SIZE])
{
    bool in_user_folder = strncmp(name, "user:", 5) == 0 || strncmp(name, "pictures:", 9) == 0;

    if (!in_user_folder || !plat_path(name, path, FILES_PATH_SIZE))
        snprintf(path, FILES_PATH_SIZE, "%s", name);
    return path;
}

/* Sets err to "NAME: cannot be VERB (REASON)", without the reason when errno is 0. */
static void set_access_error(const char *name, const char *verb, char *err, size_t err_size)
{
    char shown[FILES_PATH_SIZE];
    int error = errno;

    files_display_name(name, shown);
    if (error)
        snprintf(err, err_size, "%s: cannot be %s (%s)", shown, verb, strerror(error));
    else
        snprintf(err, err_size, "%s: cannot be %s", shown, verb);
}

static bool check_written(bool good, const char *path, char *err, size_t err_size)
{
    if (good)
        return true;
    set_access_error(path, "written", err, err_size);
    result_set_host_failed();
    return false;
}

bool files_save(const char *path, const void *data, size_t size, char *err, size_t err_size)
{
    errno = 0;
    return check_written(plat_save(path, data, size), path, err, err_size);
}

bool files_append(const char *path, const void *data, size_t size, char *err, size_t err_size)
{
    errno = 0;
    return check_written(plat_append(path, data, size), path, err, err_size);
}

bool files_load(const char *path, const char *name, void *data, size_t size, char *err, size_t err_size)
{
    errno = 0;
    if (plat_load(path, data, size) == (long)size)
        return true;
    set_access_error(name, "read", err, err_size);
    return false;
}

long files_size(const char *path)
{
    errno = 0;
    return plat_file_size(path);
}

static void ignore_entry(void *user, const struct plat_folder_entry *file)
{
    (void)user;
    (void)file;
}

int files_count_entries(const char *folder)
{
    return plat_list(folder, ignore_entry, NULL);
}

const char *files_set_missing_error(const char *name, const char *type, char *err, size_t err_size)
{
    if (errno && errno != ENOENT && errno != ENOTDIR)
        set_access_error(name, "read", err, err_size);
    else
        snprintf(err, err_size, "%s: no such %s", name, type);
    return err;
}

bool files_read(const char *path, const char *name, size_t max, uint8_t **data, size_t *size, char *err,
                size_t err_size)
{
    long n = files_size(path);

    *data = NULL;
    *size = 0;
    if (n < 0) {
        files_set_missing_error(name, "file", err, err_size);
        return false;
    }
    if ((unsigned long)n > max)
        return err_set(err, err_size, "%s: larger than %zu KiB", name, max >> 10);
    uint8_t *bytes = malloc((size_t)n + 1);
    if (bytes == NULL)
        return result_set_host_error(err, err_size, "%s: out of memory", name);
    if (!files_load(path, name, bytes, (size_t)n, err, err_size)) {
        free(bytes);
        return false;
    }
    bytes[n] = 0;
    *data = bytes;
    *size = (size_t)n;
    return true;
}

void files_strip_bom(void *text, size_t *size)
{
    uint8_t *bytes = text;

    if (*size < 3 || memcmp(bytes, "\xef\xbb\xbf", 3) != 0)
        return;
    *size -= 3;
    memmove(bytes, bytes + 3, *size + 1);
}

bool files_read_text(const char *path, const char *name, size_t max, uint8_t **text, size_t *size, char *err,
                     size_t err_size)
{
    if (!files_read(path, name, max, text, size, err, err_size))
        return false;
    files_strip_bom(*text, size);
    return true;
}

bool files_has_suffix(const char *name, const char *suffix)
{
    const size_t n = strlen(name), m = strlen(suffix);

    return n > m && strcmp(name + n - m, suffix) == 0;
}
