/*
 * nvram.h - memory that outlives the power: score tables and saves. Bytes, little-endian, the same on every host.
 * floor: chips
 *
 * Image: magic "NV02", then records one behind the other, without gaps, in the order in which they were first kept:
 *
 *     u8 type (enum nv_type), u8 n, u8 m, n bytes of name, m bytes of value
 *
 * Of an integer and a double 8 bytes, of a text up to NV_STRING, of a boolean 1; of a score table NV_ROWS rows at most,
 * best first, of 24 bytes: name[16], with a NUL, and i64 score. So memory, snapshots and hashes have what is kept and
 * no more; the manifest says how much there is room for (board.nvram).
 *
 * Images of before, "NV01", are taken too: 32768 bytes; 256 records of 96 bytes { key[32], type, length, 2 spare,
 * value[60] }, 16 tables of 32 + 10 x 24 bytes { name[32], rows }, zeroes. An empty key or name is a free record.
 */
#ifndef CHIPS_NVRAM_H
#define CHIPS_NVRAM_H

#include "slots.h"

enum {
    NV_KEY = 31,    /* bytes of a key, and of a table's name */
    NV_STRING = 60, /* bytes of a string value */
    NV_ROWS = 10,
    NV_NAME = 15,       /* bytes of a name in a score table */
    NV_KIB = 32,        /* room when the manifest says nothing; all of an image of before fits */
    NV_MOST_KIB = 1024, /* the most */
    NV_OLD_BYTES = 32768
};

enum nv_type { NV_NONE, NV_INT, NV_FLOAT, NV_TEXT, NV_BOOL, NV_TABLE };

struct nv_value {
    enum nv_type type;
    uint64_t bits; /* integer, double's bits, or 0/1 */
    char text[NV_STRING];
    size_t length;
};

struct nvram {
    struct slots s; /* a list: the image's bytes are live, those behind it may be anything */
    uint8_t *bytes;
    uint32_t writes;
};

extern const struct chip nvram_chip;

/* Is it an image that nvram_load takes? */
bool nvram_valid(const uint8_t *image, size_t size);

/* Starts with the image if it is valid, else blank. Of an image that is too large come the first records. */
void nvram_load(struct nvram *nv, const uint8_t *image, size_t size);

/* The value kept under a key; type NV_NONE when there is none. */
struct nv_value nvram_get(const struct nvram *nv, const char *key);

/* Keeps a value (NV_NONE forgets the key). False: there is no room, and what was kept stays. */
bool nvram_set(struct nvram *nv, const char *key, const struct nv_value *v);

/* Row r of a score table, best first; false when there is none. name: NV_NAME + 1 bytes. */
bool nvram_row(const struct nvram *nv, const char *table, int r, char *name, int64_t *score);

/* Enters a score below those that are better or equal; returns its row, or -1 when it is not good enough. -2: there is
 * no room. */
int nvram_enter(struct nvram *nv, const char *table, const char *name, int64_t score);

#endif
