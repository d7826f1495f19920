/*
 * desktop.h - a menu entry for desktops that starts a program at its present path: PROGRAM.desktop and PROGRAM.png.
 */
#ifndef WORKBENCH_DESKTOP_H
#define WORKBENCH_DESKTOP_H

#include <stdbool.h>
#include <stddef.h>
#include "../../rom/cart.h"

/* True if an entry can contain the path: it has no line breaks or control characters. */
bool desktop_may_name(const char *path);

/* Writes a path as it is between double quotes in the line Exec of an entry. */
void desktop_quote(const char *path, char *out, size_t size);

/* Checks that an entry can contain the path and that both files can be written. rom: the game that is read. */
bool desktop_may_write(const char *rom, const char *program, char *err, size_t err_size);

/* Writes both files, or only the entry if the game has no icon. */
bool desktop_write(const char *program, const struct cart *cart, char *err, size_t err_size);

#endif
