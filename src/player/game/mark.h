/*
 * mark.h - 64 bytes in the program that describe the game at the end of its file.
 *
 * `export` overwrites these bytes in the copy that it makes; a libretro core has them too. A running program knows from
 * its mark that it has a game, so it can detect that its file is truncated or unreadable.
 */
#ifndef PLAYER_MARK_H
#define PLAYER_MARK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { MARK_BYTES = 64 };

enum { MARK_KEYS = 1 /* includes the keys and commands for authors */ };

struct mark {
    uint32_t flags;
    uint32_t crc;  /* of the game's ROM, uncompressed */
    uint64_t at;   /* offset of the ROM in the file, a multiple of ROM_ALIGN */
    uint64_t size; /* of the ROM in the file, compressed or not; 0: there is no game */
    uint32_t core; /* core version of the program or library; mark_put doesn't change it */
};

/* Returns the mark of the running program. */
struct mark mark_own(void);

/* Finds the mark in a program's file. Returns false if there is none, or more than one candidate. */
bool mark_find(const uint8_t *file, size_t size, size_t *at);

/* mark_put overwrites a mark that was found; mark_read reads it. */
void mark_put(uint8_t at[MARK_BYTES], const struct mark *m);
void mark_read(const uint8_t at[MARK_BYTES], struct mark *m);

#endif
