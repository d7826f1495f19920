/*
 * roms.h - stores ROMs of a game that recordings need: user:roms/ID-HASH.rom.
 */
#ifndef PLAYER_ROMS_H
#define PLAYER_ROMS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../rom/rom.h"
#include "unsaved.h"

enum { ROMS_PATH = 96 };

/* Writes the path of a game's ROM. */
void roms_path(char path[ROMS_PATH], const char *id, uint64_t hash);

/* Returns whether the ROM is stored. */
bool roms_has(const char *id, uint64_t hash);

/* Stores a ROM unless it is stored. If it cannot be written, adds it to *unsaved, sets err and returns false. */
bool roms_store(struct unsaved **unsaved, const char *id, const struct rom *rom, char *err, size_t err_size);

/* Removes all stored ROMs of a game that are not needed. */
void roms_collect(const char *id, bool (*needed)(void *context, uint64_t hash), void *context);

#endif
