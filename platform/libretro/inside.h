/*
 * inside.h - the game that `curtain export --libretro` appends to a core's file.
 */
#ifndef PORTS_LIBRETRO_INSIDE_H
#define PORTS_LIBRETRO_INSIDE_H

#include <stdbool.h>
#include <stddef.h>

/* Returns whether this core has an embedded game. */
bool inside_has_game(void);

/* Reads the packed game into *rom, from malloc. Returns false, sets err and sets *rom to NULL if the core's file cannot
 * be read or is truncated, or when out of memory. */
bool inside_read_game(void **rom, size_t *size, char *err, size_t err_size);

#endif
