/*
 * repair.h - makes the checksums of spoilt files good, so that what reads them gets past these.
 */
#ifndef TESTS_REPAIR_H
#define TESTS_REPAIR_H

#include <string.h>
#include "../src/base/bytes.h"
#include "../src/base/hash.h"
#include "../src/rom/rom.h"
#include "../src/rom/compressed.h"

/* The header and all checksums of a ROM, as far as its directory makes sense. */
static inline void repair_rom(uint8_t *p, size_t size)
{
    if (size < ROM_HEADER_SIZE)
        return;
    memcpy(p, "CURTAIN\x1a\x01\0\0\0", 12);
    bytes_put32(p + 20, (uint32_t)size);
    for (size_t i = 0; i < bytes_get32(p + 16) && i < (size - ROM_HEADER_SIZE) / ROM_ENTRY_SIZE; i++) {
        uint8_t *e = p + ROM_HEADER_SIZE + i * ROM_ENTRY_SIZE;
        size_t at = bytes_get32(e + 4), n = bytes_get32(e + 8);
        if (at <= size && n <= size - at)
            bytes_put32(e + 12, hash_crc32(p + at, n));
    }
    bytes_put32(p + 12, hash_crc32(p + 16, size - 16));
}

/* The header of a compressed ROM; what it holds stays as it is, and so does how much that says it is. */
static inline void repair_compressed(uint8_t *p, size_t size)
{
    if (size < COMPRESSED_HEADER_SIZE)
        return;
    memcpy(p, "CURTAINZ\x01\0\0\0", 12);
    bytes_put32(p + 20, (uint32_t)size);
    bytes_put32(p + 28, 0);
    bytes_put32(p + 12, hash_crc32(p + 16, size - 16));
}

/* The CRCs of a demo's records, as far as their sizes make sense. */
static inline void repair_demo(uint8_t *p, size_t size)
{
    uint32_t crc = 0;

    for (size_t at = 8; at <= size && size - at >= 12; at += 12 + bytes_get32(p + at + 4)) {
        size_t n = bytes_get32(p + at + 4);
        if (n > size - at - 12)
            return;
        crc = hash_crc32_add(crc, p + at, 8 + n);
        bytes_put32(p + at + 8 + n, crc);
    }
}

#endif
