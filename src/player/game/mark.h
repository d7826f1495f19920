/*
 * mark.h - constants in the program that describe the game at the end of its file.
 *
 * `export` overwrites these 64 bytes in the copy it makes; a libretro core has them too. As the running program itself
 * knows that it has a game, it can detect a truncated or unreadable file.
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
    uint32_t crc;  /* of the game's ROM, the plain one */
    uint64_t at;   /* bytes of the file before it, a multiple of ROM_ALIGN */
    uint64_t size; /* of the ROM as it stands there, compressed or plain; 0: there is no game */
    uint32_t core; /* of what has the mark; mark_put leaves it */
};

/* The mark of the program that runs. */
struct mark mark_own(void);

/* Where in a program's file its mark stands. False: it has none, or bytes that look the same. */
bool mark_find(const uint8_t *file, size_t size, size_t *at);

/* Writes a mark over one that was found. */
void mark_put(uint8_t at[MARK_BYTES], const struct mark *m);
void mark_read(const uint8_t at[MARK_BYTES], struct mark *m);

#endif
