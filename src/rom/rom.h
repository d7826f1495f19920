/*
 * rom.h - the archive a game travels in: named lumps in one flat read-only block.
 *
 * Little-endian, no pointers, so that it can be mapped or linked into a program:
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
    ROM_HEADER = 32, /* bytes before the directory */
    ROM_ENTRY = 16,  /* bytes a lump has in the directory */
    ROM_ALIGN = 16,
    ROM_NAME = 128 /* longest name with its NUL */
};

struct rom {
    const uint8_t *data;
    size_t size;
    uint32_t count; /* lumps */
    uint32_t crc;   /* of everything but the first 16 bytes: names this very file */
};

struct lump {
    const char *name;
    const uint8_t *data;
    uint32_t size;
};

/* Checks every byte the reader will rely on, once. False and one sentence in err (without the file's name) for a block
 * that is not a whole, undamaged ROM. The block must outlive rom. */
bool rom_open(struct rom *rom, const void *data, size_t size, char *err, size_t err_size);

/* The lump's index, or -1. */
int rom_find(const struct rom *rom, const char *name);

/* Lump i, 0 <= i < count. */
void rom_lump(const struct rom *rom, int i, struct lump *out);

/* The index of the first lump whose name is not before prefix; lumps that share a prefix stand together from there. */
int rom_first(const struct rom *rom, const char *prefix);

/* All lumps: names and bytes. */
uint64_t rom_hash(const struct rom *rom);

/* The lumps that tick can read: manifest, script/, data/, lang/, tune/ and hit/. Art, sounds and demos are left out. */
uint64_t rom_game_hash(const struct rom *rom);

/* May this be a lump's name? 1 to ROM_NAME - 1 printable ASCII characters. */
bool rom_name_ok(const char *name);

/* Bytes of the ROM that rom_write makes of n lumps; 0: more than 4 GiB. */
size_t rom_write_size(const struct lump *lumps, int n);

/* Writes a ROM of n lumps with good, ascending, different names into out (rom_write_size bytes). */
void rom_write(void *out, const struct lump *lumps, int n);

#endif
