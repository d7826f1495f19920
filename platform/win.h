/*
 * win.h - functions that win.c, win_process.c and win_register.c share.
 */
#ifndef PLATFORM_WIN_H
#define PLATFORM_WIN_H

#define WIN32_LEAN_AND_MEAN
#define _WIN32_WINNT 0x0601 /* Windows 7 */

#include <windows.h>
#include "host.h"

enum { WIN_PATH_SIZE = 2 * HOST_PATH_SIZE }; /* maximum length of a full path in UTF-16 units, including the NUL */

/* Sets errno from GetLastError. Always returns false. */
bool win_set_errno(void);

/* Converts a Windows path to UTF-8 with /. Returns false if it does not fit or is not valid UTF-16. */
bool win_to_utf8(char *out, size_t size, const wchar_t *wide);

/* Converts a path to a full path of any length, for the wide-character functions. On failure, returns false and sets
 * errno. */
bool win_to_full_path(wchar_t out[WIN_PATH_SIZE], const char *path);

/* Returns a binary stream that owns the handle. On failure, closes the handle and returns NULL. */
FILE *win_open_stream(HANDLE h, int flags, const char *mode);

#endif
