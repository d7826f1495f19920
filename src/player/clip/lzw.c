/*
 * lzw.c - LZW compression (lzw.h). A hash table maps each known string, given as the code of all but its last byte and
 * that byte, to its code. When all 4096 codes are in use, the table is cleared.
 */
#include "lzw.h"

#include <string.h>

enum {
    BITS = 8, /* of a byte */
    CLEAR = 1 << BITS,
    STOP,
    FIRST, /* the first code of a string */
    MOST_BITS = 12,
    CODES = 1 << MOST_BITS,
    SLOTS = 1 << 14,
    BLOCK = 255
};

struct lzw {
    struct byte_buffer *out;
    uint32_t key[SLOTS]; /* (code << 8 | byte) + 1; 0: free */
    uint16_t code[SLOTS];
    int next, bits; /* the next code to assign; the present size of codes */
    uint32_t held;  /* bits that are not written yet */
    int n_held;
    uint8_t block[BLOCK + 1]; /* starts with its length */
};

static void flush(struct lzw *z)
{
    if (z->block[0])
        byte_buffer_put(z->out, z->block, 1u + z->block[0]);
    z->block[0] = 0;
}

static void put_byte(struct lzw *z, uint8_t byte)
{
    z->block[++z->block[0]] = byte;
    if (z->block[0] == BLOCK)
        flush(z);
}

static void put(struct lzw *z, int code)
{
    z->held |= (uint32_t)code << z->n_held;
    for (z->n_held += z->bits; z->n_held >= 8; z->n_held -= 8, z->held >>= 8)
        put_byte(z, (uint8_t)z->held);
}

static void forget(struct lzw *z)
{
    memset(z->key, 0, sizeof z->key);
    z->next = FIRST;
    z->bits = BITS + 1;
}

/* Returns the slot of a string, or the free slot for it. */
static uint32_t find(const struct lzw *z, uint32_t key)
{
    uint32_t at = key * 2654435761u >> (32 - 14);

    while (z->key[at] && z->key[at] != key)
        at = (at + 1) % SLOTS;
    return at;
}

/* Assigns the next code to a string. The decoder learns it one code later, so codes become one bit longer when the
 * first code of that length is assigned. */
static void learn(struct lzw *z, uint32_t at, uint32_t key)
{
    if (z->next == CODES) {
        put(z, CLEAR);
        forget(z);
        return;
    }
    z->key[at] = key;
    z->code[at] = (uint16_t)z->next;
    if (z->next == 1 << z->bits)
        z->bits++;
    z->next++;
}

void lzw_put(struct byte_buffer *out, const uint8_t *bytes, size_t n)
{
    struct lzw z;
    int code = n ? bytes[0] : STOP;

    z.out = out;
    z.held = 0;
    z.n_held = 0;
    z.block[0] = 0;
    forget(&z);
    byte_buffer_byte(out, BITS);
    put(&z, CLEAR);
    for (size_t i = 1; i < n; i++) {
        const uint32_t key = ((uint32_t)code << 8 | bytes[i]) + 1, at = find(&z, key);
        if (z.key[at]) {
            code = z.code[at];
            continue;
        }
        put(&z, code);
        learn(&z, at, key);
        code = bytes[i];
    }
    if (n) {
        put(&z, code);
        if (z.next < CODES && z.next == 1 << z.bits) /* the decoder has assigned one more code by now */
            z.bits++;
    }
    put(&z, STOP);
    if (z.n_held)
        put_byte(&z, (uint8_t)z.held);
    flush(&z);
    byte_buffer_byte(out, 0);
}
