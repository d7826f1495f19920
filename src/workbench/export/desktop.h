/*
 * desktop.h - writes a desktop entry that starts a program at its current path: PROGRAM.desktop and PROGRAM.png.
 */
#ifndef WORKBENCH_DESKTOP_H
#define WORKBENCH_DESKTOP_H

#include <stdbool.h>
#include <stddef.h>
#include "../../rom/cart.h"

/* Returns whether an entry can contain the path: it must have no line breaks or control characters. */
bool desktop_can_name(const char *path);

/* Escapes a path for the Exec line of an entry, in which it is inside double quotes. */
void desktop_quote(const char *path, char *out, size_t size);

/* Checks that an entry can contain the path and that both files can be written. rom: the input file. */
bool desktop_check_writable(const char *rom, const char *program, char *err, size_t err_size);

/* Writes both files, or only the .desktop file if the game has no icon. */
bool desktop_write(const char *program, const struct cart *cart, char *err, size_t err_size);

#endif
