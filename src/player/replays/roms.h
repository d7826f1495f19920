/*
 * roms.h - older ROMs of a game, kept by their hash for as long as a recording needs them: user:roms/ID-HASH.rom.
 */
#ifndef PLAYER_ROMS_H
#define PLAYER_ROMS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../rom/rom.h"
#include "unsaved.h"

enum { ROMS_PATH = 96 };

/* The file of a game's ROM. */
void roms_path(char path[ROMS_PATH], const char *id, uint64_t hash);

/* Is it there? */
bool roms_has(const char *id, uint64_t hash);

/* Keeps a ROM, if it is not kept yet. False and one sentence: it waits in the list. */
bool roms_keep(struct unsaved **unsaved, const char *id, const struct rom *rom, char *err, size_t err_size);

/* Removes all kept ROMs of a game but those that are needed. */
void roms_collect(const char *id, bool (*needed)(void *of, uint64_t hash), void *of);

#endif
