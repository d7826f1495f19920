/*
 * words.h - operations on eight pixels at a time in a 64-bit word. No operation except words_shift_up moves bits
 * between bytes, so only words_shift_up depends on the host's byte order.
 */
#ifndef FB_WORDS_H
#define FB_WORDS_H

#include <stdint.h>
#include <string.h>

#define WORDS_EACH(b) ((uint64_t)(b)*0x0101010101010101u)

static inline uint64_t words_load(const uint8_t *p)
{
    uint64_t v;

    memcpy(&v, p, sizeof v);
    return v;
}

static inline void words_store(uint8_t *p, uint64_t v)
{
    memcpy(p, &v, sizeof v);
}

/* Returns 255 in every byte where s is not 0. */
static inline uint64_t words_opaque_mask(uint64_t s)
{
    uint64_t top = (((s & WORDS_EACH(0x7f)) + WORDS_EACH(0x7f)) | s) & WORDS_EACH(0x80);

    return top | (top - (top >> 7));
}

/* Moves each byte one place up in memory; the first byte becomes 0 and the last is lost. */
static inline uint64_t words_shift_up(uint64_t v)
{
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    return v >> 8;
#else
    return v << 8;
#endif
}

/* Returns s + add in each byte, modulo 256. */
static inline uint64_t words_add(uint64_t s, uint64_t add)
{
    return ((s & WORDS_EACH(0x7f)) + (add & WORDS_EACH(0x7f))) ^ ((s ^ add) & WORDS_EACH(0x80));
}

#endif
