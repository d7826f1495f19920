/*
 * rom.h - the archive format of a game: named lumps in one flat read-only block.
 *
 * Little-endian and without pointers, so that it can be mapped or linked into a program:
 *
 *      0  "CURTAIN\x1a"
 *      8  u32 version (ROM_VERSION)        16  u32 lumps        24  u32 zero
 *     12  u32 CRC32 of all bytes from 16   20  u32 bytes        28  u32 zero
 *     32  the directory, ascending by name: u32 name offset, u32 data offset, u32 size, u32 CRC32 of the data
 *         the names, each ended by a NUL; then the data, in the directory's order, each lump 16-byte aligned
 */
#ifndef ROM_H
#define ROM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    ROM_VERSION = 1,
    ROM_HEADER_SIZE = 32, /* bytes before the directory */
    ROM_ENTRY_SIZE = 16,  /* bytes per lump in the directory */
    ROM_ALIGN = 16,
    ROM_MAX_NAME = 128 /* maximum bytes of a name, with its NUL */
};

struct rom {
    const uint8_t *data;
    size_t size;
    uint32_t count; /* lumps */
    uint32_t crc;   /* of everything but the first 16 bytes; identifies this file */
};

struct lump {
    const char *name;
    const uint8_t *data;
    uint32_t size;
};

/* Opens a ROM and checks it, so that the other functions need no checks. Returns false, with one sentence in err
 * (without the file's name), if data is not a complete, undamaged ROM. data must outlive rom. */
bool rom_open(struct rom *rom, const void *data, size_t size, char *err, size_t err_size);

/* Returns the index of the lump with that name, or -1. */
int rom_find(const struct rom *rom, const char *name);

/* Reads lump i, 0 <= i < count. */
void rom_lump(const struct rom *rom, int i, struct lump *out);

/* Returns the index of the first lump whose name does not sort before prefix; lumps with that prefix start there. */
int rom_find_first(const struct rom *rom, const char *prefix);

/* Returns a hash of the names and bytes of all lumps. */
uint64_t rom_hash(const struct rom *rom);

/* Returns a hash of the names and bytes of these lumps, which ticks can read: manifest, script/, data/, lang/, tune/
 * and hit/. bulletml/, art, sounds and demos are not included. */
uint64_t rom_game_hash(const struct rom *rom);

/* Returns whether name is valid for a lump: 1 to ROM_MAX_NAME - 1 printable ASCII characters. */
bool rom_name_ok(const char *name);

/* Returns the size in bytes of a ROM of n lumps; 0: 4 GiB or more. */
size_t rom_write_size(const struct lump *lumps, int n);

/* Writes a ROM of n lumps into out (rom_write_size bytes). The names must be valid, distinct and ascending. */
void rom_write(void *out, const struct lump *lumps, int n);

#endif
