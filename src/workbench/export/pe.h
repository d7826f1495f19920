/*
 * pe.h - the resources of a Windows program: a game's icon and version in place of the program's own.
 */
#ifndef WORKBENCH_PE_H
#define WORKBENCH_PE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../rom/cart.h"

/* Returns whether the file has the signature of a Windows program. */
bool pe_is(const uint8_t *file, size_t size);

/* Replaces *file (malloc) by a copy that ends with a resource section for the game: its version, and its icon if it has
 * one; other resources are copied. Symbols and a signature are removed. The result depends only on the file and the
 * game. False: the file is damaged, is not for x86-64, or has no space for another section header. The caller frees
 * *file in either case. */
bool pe_set_resources(uint8_t **file, size_t *size, const struct cart *cart, char *err, size_t err_size);

#endif
