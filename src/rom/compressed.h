/*
 * compressed.h - compressed ROM files. Decompression restores the plain ROM byte by byte, so lumps and hashes do not
 * change.
 *
 * Little-endian:
 *
 *      0  "CURTAINZ"
 *      8  u32 format (1)                       16  u32 bytes of the plain ROM      24  u32 CRC32 of the plain ROM
 *     12  u32 CRC32 of all bytes from 16       20  u32 bytes of this file          28  u32 zero
 *     32  the ROM (rom.h) as an LZMA stream (lzma.h)
 */
#ifndef ROM_COMPRESSED_H
#define ROM_COMPRESSED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A file whose header claims more is rejected, since it could exhaust memory; the writer leaves such a ROM plain. */
enum {
    COMPRESSED_HEADER = 32,
    COMPRESSED_MOST = 256 << 20, /* maximum bytes of the plain ROM */
    COMPRESSED_TIMES = 1000      /* maximum ratio of its size to the file's */
};

/* Returns whether data starts like a compressed ROM, which a plain ROM never does. */
bool compressed_is(const void *data, size_t size);

/* Returns the bytes of the plain ROM; 0, with one sentence in err (without the file's name), if the file is damaged or
 * claims too much. */
size_t compressed_size(const void *data, size_t size, char *err, size_t err_size);

/* Decompresses the plain ROM into out, which has compressed_size bytes. Returns false, with one sentence in err, if the
 * file is damaged. rom_open still has to check the result. */
bool compressed_read(const void *data, size_t size, void *out, char *err, size_t err_size);

/* Writes the header at out, in front of a stream of `size - COMPRESSED_HEADER` bytes that is already there. */
void compressed_seal(uint8_t *out, size_t size, const void *rom, size_t rom_size);

#endif
