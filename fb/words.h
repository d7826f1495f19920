/*
 * words.h - eight pixels at a time: what a 64-bit word of them can do without a step from one byte to the next, so that
 * the byte order of the host does not matter.
 * floor: fb    used by: fb/
 */
#ifndef FB_WORDS_H
#define FB_WORDS_H

#include <stdint.h>
#include <string.h>

#define BYTES(b) ((uint64_t)(b)*0x0101010101010101u)

static inline uint64_t load(const uint8_t *p)
{
    uint64_t v;

    memcpy(&v, p, sizeof v);
    return v;
}

static inline void store(uint8_t *p, uint64_t v)
{
    memcpy(p, &v, sizeof v);
}

/* 255 in every byte that is not 0 in s. */
static inline uint64_t opaque(uint64_t s)
{
    uint64_t top = (((s & BYTES(0x7f)) + BYTES(0x7f)) | s) & BYTES(0x80);

    return top | (top - (top >> 7));
}

/* s + add in each byte, modulo 256. */
static inline uint64_t add_bytes(uint64_t s, uint64_t add)
{
    return ((s & BYTES(0x7f)) + (add & BYTES(0x7f))) ^ ((s ^ add) & BYTES(0x80));
}

#endif
