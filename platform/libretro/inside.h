/*
 * inside.h - the game that an exported core carries behind itself in its file (`curtain export --libretro`).
 */
#ifndef PORTS_LIBRETRO_INSIDE_H
#define PORTS_LIBRETRO_INSIDE_H

#include <stdbool.h>
#include <stddef.h>

/* Does this core say that it has one? */
bool inside_is(void);

/* Reads the packed game, *rom (malloc). False and one sentence: the core's file cannot be read, or was cut short. */
bool inside_read(void **rom, size_t *size, char *err, size_t err_size);

#endif
