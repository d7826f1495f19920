/*
 * lzw.c - LZW compression (lzw.h). A hash table maps each known string, given as the code of all but its last byte and
 * that byte, to its code. When all 4096 codes are in use, the table is cleared.
 */
#include "lzw.h"

#include <string.h>

enum {
    BYTE_BITS = 8,
    CLEAR = 1 << BYTE_BITS,
    END,
    FIRST, /* the first code of a string */
    MAX_BITS = 12,
    MAX_CODES = 1 << MAX_BITS,
    SLOTS = 1 << 14,
    BLOCK_SIZE = 255
};

struct lzw {
    struct byte_buffer *out;
    uint32_t key[SLOTS]; /* (code << 8 | byte) + 1; 0: free */
    uint16_t code[SLOTS];
    int next, bits;   /* the next code to assign; the present size of codes */
    uint32_t pending; /* bits that are not written yet */
    int pending_bits;
    uint8_t block[BLOCK_SIZE + 1]; /* starts with its length */
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
    if (z->block[0] == BLOCK_SIZE)
        flush(z);
}

static void put(struct lzw *z, int code)
{
    z->pending |= (uint32_t)code << z->pending_bits;
    for (z->pending_bits += z->bits; z->pending_bits >= 8; z->pending_bits -= 8, z->pending >>= 8)
        put_byte(z, (uint8_t)z->pending);
}

static void reset_table(struct lzw *z)
{
    memset(z->key, 0, sizeof z->key);
    z->next = FIRST;
    z->bits = BYTE_BITS + 1;
}

/* Returns the slot of a string, or the free slot for it. */
static uint32_t find_slot(const struct lzw *z, uint32_t key)
{
    uint32_t at = key * 2654435761u >> (32 - 14);

    while (z->key[at] && z->key[at] != key)
        at = (at + 1) % SLOTS;
    return at;
}

/* Assigns the next code to a string. The decoder learns it one code later, so codes become one bit longer when the
 * first code of that length is assigned. */
static void add_string(struct lzw *z, uint32_t at, uint32_t key)
{
    if (z->next == MAX_CODES) {
        put(z, CLEAR);
        reset_table(z);
        return;
    }
    z->key[at] = key;
    z->code[at] = (uint16_t)z->next;
    if (z->next == 1 << z->bits)
        z->bits++;
    z->next++;
}

void lzw_append(struct byte_buffer *out, const uint8_t *bytes, size_t n)
{
    struct lzw z;
    int code = n ? bytes[0] : END;

    z.out = out;
    z.pending = 0;
    z.pending_bits = 0;
    z.block[0] = 0;
    reset_table(&z);
    byte_buffer_byte(out, BYTE_BITS);
    put(&z, CLEAR);
    for (size_t i = 1; i < n; i++) {
        const uint32_t key = ((uint32_t)code << 8 | bytes[i]) + 1, at = find_slot(&z, key);
        if (z.key[at]) {
            code = z.code[at];
            continue;
        }
        put(&z, code);
        add_string(&z, at, key);
        code = bytes[i];
    }
    if (n) {
        put(&z, code);
        if (z.next < MAX_CODES && z.next == 1 << z.bits) /* the decoder has assigned one more code by now */
            z.bits++;
    }
    put(&z, END);
    if (z.pending_bits)
        put_byte(&z, (uint8_t)z.pending);
    flush(&z);
    byte_buffer_byte(out, 0);
}
