/*
 * compressed.h - a ROM's file made small. In it is the ROM, byte by byte: lumps and hashes are of the plain one.
 *
 * Little-endian:
 *
 *      0  "CURTAINZ"
 *      8  u32 format (1)                       16  u32 bytes of the plain ROM      24  u32 CRC32 of the plain ROM
 *     12  u32 CRC32 of all bytes from 16       20  u32 bytes of this file          28  u32 zero
 *     32  the ROM (base/rom.h) as an LZMA stream: lzma.h
 */
#ifndef ROM_COMPRESSED_H
#define ROM_COMPRESSED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    COMPRESSED_HEADER = 32,
    COMPRESSED_MOST =
        256 << 20,          /* bytes of the plain ROM, and how many times as many as the file has: what says more */
    COMPRESSED_TIMES = 1000 /* is there to fill a memory. The writer leaves such a ROM plain. */
};

/* Does it begin as one? Then it is no plain ROM. */
bool compressed_is(const void *data, size_t size);

/* Bytes of the ROM in it; 0 and one sentence, without the file's name, for one that is damaged or says too much. */
size_t compressed_size(const void *data, size_t size, char *err, size_t err_size);

/* Writes these bytes into out. False and one sentence. They are looked at by rom_open like any others. */
bool compressed_read(const void *data, size_t size, void *out, char *err, size_t err_size);

/* Puts the header before a stream of `size - COMPRESSED_HEADER` bytes that stands behind it. */
void compressed_seal(uint8_t *out, size_t size, const void *rom, size_t rom_size);

#endif
