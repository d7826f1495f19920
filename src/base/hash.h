/*
 * hash.h - the 64-bit state hash and the CRC32 of files.
 *
 * The state hash folds 64-bit values, never raw memory, so it is the same on every host, whatever its byte order. It
 * distinguishes states; it does not resist an adversary.
 */
#ifndef BASE_HASH_H
#define BASE_HASH_H

#include <stddef.h>
#include <stdint.h>

enum { HASH_START = 0x43555254 }; /* any constant; "CURT" */

/* Folds v into h. Order matters: fold(fold(h,a),b) differs from fold(fold(h,b),a). The final mixing steps are
 * murmur3's. */
static inline uint64_t hash_fold(uint64_t h, uint64_t v)
{
    h = (h ^ v) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
    h *= 0xff51afd7ed558ccdu;
    return h ^ h >> 29;
}

/* Folds n bytes, and then n itself, into h. */
uint64_t hash_bytes(uint64_t h, const void *bytes, size_t n);

/* Return the CRC-32 used by PNG and zlib (ISO 3309, polynomial 0xEDB88320). hash_crc32_add continues the CRC of the
 * preceding bytes; start with crc 0. */
uint32_t hash_crc32_add(uint32_t crc, const void *bytes, size_t n);
uint32_t hash_crc32(const void *bytes, size_t n);

#endif
