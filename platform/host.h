/*
 * host.h - the half of the platform's defaults that differs between hosts. stdio.c is the other half.
 *
 * Two files of a host define all of this, and the functions of platform.h under "the host": posix.c and
 * posix_process.c; win.c and win_process.c; iso.c for hosts with nothing but ISO C, and no_process.c for those without
 * processes. Paths are UTF-8, with / between folders. A function that fails sets errno where the host gives a reason.
 */
#ifndef PLATFORM_HOST_H
#define PLATFORM_HOST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include "platform.h"

/* A port overrides a default by defining the same function. PE has no weak symbols: there the build names the
 * overrides with -DPLAT_OWN_... */
#if (defined(__GNUC__) || defined(__clang__)) && !defined(_WIN32)
#define DEFAULT __attribute__((weak))
#else
#define DEFAULT
#endif

enum { HOST_PATH = 2048 }; /* bytes of a path, with its NUL */

/* ---- names ---- */

/* The user's folders for program data and for pictures. False: there is none. */
bool host_data_folder(char out[HOST_PATH]);
bool host_pictures_folder(char out[HOST_PATH]);

/* The current folder and a slash if the path is relative; "" if it is absolute or the folder is unknown. */
void host_folder_before(const char *path, char out[HOST_PATH + 1]);

/* The path of the running program's file, with links resolved. */
bool host_program_path(char out[HOST_PATH]);

/* ---- files ---- */

enum host_mode {
    HOST_READ,   /* a regular file; a pipe is not waited for */
    HOST_STREAM, /* reads whatever it is */
    HOST_NEW,    /* writes a file that must not exist */
    HOST_WRITE,  /* empties it first */
    HOST_APPEND
};

FILE *host_open(const char *path, enum host_mode mode);

/* Like plat_size. */
long host_size(const char *path);

/* True if it exists. */
bool host_exists(const char *path);

/* True if it exists and is not a regular file: a device, a pipe, a folder. */
bool host_special(const char *path);

/* True if both exist and are the same file or folder. */
bool host_same_file(const char *a, const char *b);

/* Replaces a path by the target of its symbolic links, which need not exist. False: a loop, or too long. */
bool host_follow(char path[HOST_PATH]);

/* True if the folder exists afterwards. */
bool host_make_folder(const char *path);

/* Writes a file, or the names in a folder, to the disk before returning. */
bool host_to_disk(FILE *f);
void host_folder_to_disk(const char *folder);

/* Copies the permissions of the file at path, if there is one. */
void host_keep_mode(FILE *f, const char *path);

bool host_replace(const char *from, const char *to);
bool host_remove(const char *path);
bool host_runnable(const char *path);
int host_list(const char *folder, void (*each)(void *user, const struct plat_file *file), void *user);

/* ---- the process ---- */

/* A number that differs between programs that run at the same time. */
long host_process(void);

/* Writes to standard error immediately. */
void host_log(const char *text, size_t size);

/* Calls `crashed` when the program is about to crash; then the crash takes its course. A second fault inside `crashed`
 * exits immediately. False: the host cannot do that. */
bool host_crash_arm(void (*crashed)(const char *what));
void host_crash_disarm(void);

/* plat_each without processes: runs the pieces one after another in this process. stdio.c defines it. */
bool host_each(int n, const struct plat_work *work);

/* Files for `crashed`: these and host_log are safe in a signal handler. host_crash_open creates a file that only the
 * user can read; -1: it cannot. */
int host_crash_open(const char *path);
void host_crash_write(int file, const void *bytes, size_t size);
void host_crash_close(int file);

#endif
