/*
 * pe.h - the resources of a Windows program: a game's icon and version in place of the program's own.
 * floor: cab
 */
#ifndef CAB_PE_H
#define CAB_PE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../board/rom/cart.h"

/* Does the file claim to be a Windows program? */
bool pe_is(const uint8_t *file, size_t size);

/* Replaces *file (malloc) by a copy with a section of resources for the game; the manifest, and the icon if the game
 * has none, remain. The copy ends with that section: symbols and a signature are cut off. Its bytes depend on nothing
 * but the file and the game. False and one sentence: the file is damaged, is not for x86-64, or has no room for a
 * section; *file is still to be freed. */
bool pe_dress(uint8_t **file, size_t *size, const struct cart *cart, char *err, size_t err_size);

#endif
