/*
 * compressed.c - see compressed.h.
 */
#include "compressed.h"

#include <inttypes.h>
#include <string.h>
#include "../base/bytes.h"
#include "../base/err.h"
#include "../base/hash.h"
#include "lzma.h"

enum { FORMAT = 1, CRC_START = 16 };
static const uint8_t magic[8] = { 'C', 'U', 'R', 'T', 'A', 'I', 'N', 'Z' };

bool compressed_has_magic(const void *data, size_t size)
{
    return size >= sizeof magic && memcmp(data, magic, sizeof magic) == 0;
}

size_t compressed_plain_size(const void *data, size_t size, char *err, size_t err_size)
{
    const uint8_t *p = data;

    if (size < COMPRESSED_HEADER_SIZE || !compressed_has_magic(data, size)) {
        err_set(err, err_size, "too short for a compressed ROM (%zu bytes)", size);
        return 0;
    }
    const uint32_t plain_size = bytes_get32(p + 16);
    if (bytes_get32(p + 8) != FORMAT)
        err_set(err, err_size, "unknown compression format %" PRIu32 " (this program reads format %d)",
                bytes_get32(p + 8), FORMAT);
    else if (bytes_get32(p + 20) != size)
        err_set(err, err_size, "%zu bytes long, but its header says %" PRIu32, size, bytes_get32(p + 20));
    else if (bytes_get32(p + 12) != hash_crc32(p + CRC_START, size - CRC_START))
        err_set(err, err_size, "damaged: the checksum does not match");
    else if (bytes_get32(p + 28) != 0)
        err_set(err, err_size, "reserved header bytes are not zero");
    else if (plain_size == 0 || plain_size > COMPRESSED_MAX_SIZE || plain_size / COMPRESSED_MAX_RATIO > size)
        err_set(err, err_size,
                "%zu bytes long, but its header says %" PRIu32
                " bytes when decompressed: expected 1 to %d, and at most %d times the file's size",
                size, plain_size, COMPRESSED_MAX_SIZE, COMPRESSED_MAX_RATIO);
    else
        return plain_size;
    return 0;
}

bool compressed_unpack(const void *data, size_t size, void *out, char *err, size_t err_size)
{
    const uint8_t *p = data;
    const size_t plain_size = compressed_plain_size(data, size, err, err_size);

    if (plain_size == 0)
        return false;
    if (lzma_read(p + COMPRESSED_HEADER_SIZE, size - COMPRESSED_HEADER_SIZE, out, plain_size) &&
        hash_crc32(out, plain_size) == bytes_get32(p + 24))
        return true;
    return err_set(err, err_size, "damaged: decompressed data has the wrong checksum");
}

void compressed_write_header(uint8_t *out, size_t size, const void *rom, size_t rom_size)
{
    memset(out, 0, COMPRESSED_HEADER_SIZE);
    memcpy(out, magic, sizeof magic);
    bytes_put32(out + 8, FORMAT);
    bytes_put32(out + 16, (uint32_t)rom_size);
    bytes_put32(out + 20, (uint32_t)size);
    bytes_put32(out + 24, hash_crc32(rom, rom_size));
    bytes_put32(out + 12, hash_crc32(out + CRC_START, size - CRC_START));
}
