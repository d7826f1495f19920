/*
 * iso.c - host.h in pure ISO C: names and files.
 *
 * ISO C has no folders, links or devices. Paths are used as typed.
 */
#pragma GCC diagnostic ignored "-Wunused-parameter" /* some functions do nothing */

#include "host.h"

#include <stdlib.h>
#include <string.h>

static bool folder_from_variable(char out[HOST_PATH_SIZE], const char *variable, const char *suffix)
{
    const char *value = getenv(variable);
    return value && value[0] && snprintf(out, HOST_PATH_SIZE, "%s%s", value, suffix) < HOST_PATH_SIZE;
}

bool host_data_folder(char out[HOST_PATH_SIZE])
{
    return folder_from_variable(out, "APPDATA", "");
}

bool host_pictures_folder(char out[HOST_PATH_SIZE])
{
    return folder_from_variable(out, "USERPROFILE", "/Pictures");
}

void host_base_folder(const char *path, char out[HOST_PATH_SIZE + 1])
{
    out[0] = 0;
}

void plat_normalize_slashes(char *path)
{
}

FILE *host_open(const char *path, enum host_mode mode)
{
    static const char *const modes[] = {
        [HOST_READ] = "rb", [HOST_STREAM] = "rb", [HOST_NEW] = "wbx", [HOST_WRITE] = "wb", [HOST_APPEND] = "ab"
    };
    return fopen(path, modes[mode]);
}

long host_file_size(const char *path)
{
    FILE *f = fopen(path, "rb");
    if (!f)
        return -1;
    long size = fseek(f, 0, SEEK_END) == 0 ? ftell(f) : -1;
    fclose(f);
    return size;
}

bool host_exists(const char *path)
{
    return host_file_size(path) >= 0;
}

bool host_is_special(const char *path)
{
    return false;
}

bool host_is_same_file(const char *a, const char *b)
{
    return strcmp(a, b) == 0;
}

bool host_resolve_links(char path[HOST_PATH_SIZE])
{
    return true;
}

bool host_make_folder(const char *path)
{
    return true;
}

bool host_sync_file(FILE *f)
{
    return true;
}

void host_sync_folder(const char *folder)
{
}

void host_copy_permissions(FILE *f, const char *path)
{
}

/* In ISO C, rename may fail if the new name exists. */
bool host_replace(const char *from, const char *to)
{
    if (rename(from, to) == 0)
        return true;
    remove(to);
    return rename(from, to) == 0;
}

bool host_remove(const char *path)
{
    return remove(path) == 0;
}

bool host_make_executable(const char *path)
{
    return true;
}

int host_list(const char *folder, void (*visit)(void *user, const struct plat_folder_entry *file), void *user)
{
    return -1;
}
