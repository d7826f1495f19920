/*
 * desktop.h - an entry for the menu of a desktop, which starts a program where it is now: PROGRAM.desktop, PROGRAM.png.
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

/* Can the path be in an entry, and may both files be written? rom: the game that is read. False and one sentence. */
bool desktop_may_write(const char *rom, const char *program, char *err, size_t err_size);

/* Writes both; without an icon in the game, the first only. False and one sentence. */
bool desktop_write(const char *program, const struct cart *cart, char *err, size_t err_size);

#endif
