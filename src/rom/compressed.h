/*
 * compressed.h - compressed ROM files. Decompression restores the plain ROM exactly, so lumps and hashes do not
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

/* A file whose header exceeds these maximums is rejected, because decompressing it could exhaust memory. The packer
 * leaves a ROM that would exceed them uncompressed. */
enum {
    COMPRESSED_HEADER_SIZE = 32,
    COMPRESSED_MAX_SIZE = 256 << 20, /* maximum bytes of the plain ROM */
    COMPRESSED_MAX_RATIO = 1000      /* maximum ratio of the plain ROM's size to the file's size */
};

/* Returns whether data starts like a compressed ROM, which a plain ROM never does. */
bool compressed_has_magic(const void *data, size_t size);

/* Returns the bytes of the plain ROM; 0, with one sentence in err (without the file's name), if the file is damaged or
 * its header exceeds the maximums. */
size_t compressed_plain_size(const void *data, size_t size, char *err, size_t err_size);

/* Decompresses the plain ROM into out, which has compressed_plain_size bytes. Returns false, with one sentence in err,
 * if the file is damaged. The caller must still check the result with rom_open. */
bool compressed_unpack(const void *data, size_t size, void *out, char *err, size_t err_size);

/* Writes the header of a compressed file of `size` bytes at out. The LZMA stream must already be at out +
 * COMPRESSED_HEADER_SIZE. rom is the plain ROM. */
void compressed_write_header(uint8_t *out, size_t size, const void *rom, size_t rom_size);

#endif
