/*
 * host.h - the part of the platform API's defaults that depends on the host. stdio.c has the other part.
 *
 * Each host has its own files that define these functions, and those of platform.h under "the host": posix.c and
 * posix_process.c; win.c, win_process.c and win_register.c; iso.c for hosts that have only ISO C, and no_process.c for
 * hosts without processes; plat_run_jobs has a default in stdio.c. Paths are UTF-8, with / between folders. A function
 * that fails sets errno if the host gives a reason.
 */
#ifndef PLATFORM_HOST_H
#define PLATFORM_HOST_H

#include <errno.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include "platform.h"

/* A port overrides a default by defining the same function. PE has no weak symbols, so builds for PE name each
 * overridden function with -DPLAT_OWN_... */
#if (defined(__GNUC__) || defined(__clang__)) && !defined(_WIN32)
#define PLAT_DEFAULT __attribute__((weak))
#else
#define PLAT_DEFAULT
#endif

enum { HOST_PATH_SIZE = 2048 }; /* maximum size of a path in bytes, including the NUL */

/* Returns whether a path of n bytes fits, without the NUL; if not, sets errno. */
static inline bool host_fits(int n)
{
#ifdef ENAMETOOLONG
    if (n >= HOST_PATH_SIZE)
        errno = ENAMETOOLONG;
#endif
    return n < HOST_PATH_SIZE;
}

/* ---- names ---- */

/* Write the path of the user's folder for program data or for pictures. Return false if there is none or its path is
 * too long. */
bool host_data_folder(char out[HOST_PATH_SIZE]);
bool host_pictures_folder(char out[HOST_PATH_SIZE]);

/* Writes the prefix that makes `path` absolute: the current folder and a slash, or "" if `path` is absolute or the
 * folder is unknown. */
void host_base_folder(const char *path, char out[HOST_PATH_SIZE + 1]);

/* Writes the path of the running program's file, on POSIX with links resolved. Returns false if the host does not know
 * the path. */
bool host_program_path(char out[HOST_PATH_SIZE]);

/* ---- files ---- */

enum host_mode {
    HOST_READ,   /* reads a regular file; fails for a pipe without waiting for it */
    HOST_STREAM, /* reads a file of any kind */
    HOST_NEW,    /* creates a file that must not exist yet */
    HOST_WRITE,  /* creates a file, or empties an existing one */
    HOST_APPEND
};

FILE *host_open(const char *path, enum host_mode mode);

/* Returns what plat_file_size returns. */
long host_file_size(const char *path);

/* Returns whether the file or folder exists. */
bool host_exists(const char *path);

/* Returns whether the path exists and is not a regular file: a device, a pipe, a folder. */
bool host_is_special(const char *path);

/* Returns whether both paths exist and are the same file or folder. */
bool host_is_same_file(const char *a, const char *b);

/* Replaces a path by the target of its symbolic links, which need not exist. Returns false if the links form a loop or
 * the target's path is too long. */
bool host_resolve_links(char path[HOST_PATH_SIZE]);

/* Creates a folder. Returns whether it exists afterwards. */
bool host_make_folder(const char *path);

/* Flush a file, or a folder's entries, to the disk. */
bool host_sync_file(FILE *f);
void host_sync_folder(const char *folder);

/* Copies the permissions of the file at `path`, if it exists, to f. */
void host_copy_permissions(FILE *f, const char *path);

bool host_replace(const char *from, const char *to);
bool host_remove(const char *path);
bool host_make_executable(const char *path);
int host_list(const char *folder, void (*visit)(void *user, const struct plat_folder_entry *file), void *user);

/* ---- the process ---- */

/* Returns the process ID, which no other running program has; 0 on hosts without processes. */
long host_process_id(void);

/* Writes to standard error immediately. */
void host_log(const char *text, size_t size);

/* Opens a private temporary file, which fclose deletes. Returns NULL on failure, or if the host has none. */
FILE *host_open_temp_file(void);

#endif
