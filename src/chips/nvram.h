/*
 * nvram.h - memory that outlives the power: score tables and saves. Bytes, little-endian, the same on every host.
 * floor: chips
 *
 * Layout: magic "NV01"; SAVES records of 96 bytes { key[32], type, length, 2 spare, value[60] }; TABLES tables of
 * 32 + ROWS x 24 bytes { name[32], rows { name[16], score } }. An empty key or name is a free record.
 */
#ifndef CHIPS_NVRAM_H
#define CHIPS_NVRAM_H

#include "slots.h"

enum {
    NV_BYTES = 32768,
    NV_SAVES = 256,
    NV_KEY = 31,    /* bytes of a key */
    NV_STRING = 60, /* bytes of a string value */
    NV_TABLES = 16,
    NV_ROWS = 10,
    NV_NAME = 15, /* bytes of a name in a score table */
};

enum nv_type { NV_NONE, NV_INT, NV_FLOAT, NV_TEXT, NV_BOOL };

struct nv_value {
    enum nv_type type;
    uint64_t bits; /* integer, double's bits, or 0/1 */
    char text[NV_STRING];
    size_t length;
};

struct nvram {
    struct slots s; /* a list of NV_BYTES entries */
    uint8_t *bytes;
    uint32_t writes;
};

extern const struct chip nvram_chip;

/* Is it an image that nvram_load takes? */
bool nvram_valid(const uint8_t *image, size_t size);

/* Starts with the image if it is valid, else blank. */
void nvram_load(struct nvram *nv, const uint8_t *image, size_t size);

/* The value kept under a key; type NV_NONE when there is none. */
struct nv_value nvram_get(const struct nvram *nv, const char *key);

/* Keeps a value (NV_NONE forgets the key). False: all records are taken. */
bool nvram_set(struct nvram *nv, const char *key, const struct nv_value *v);

/* Row r of a score table, best first; false when there is none. name: NV_NAME + 1 bytes. */
bool nvram_row(const struct nvram *nv, const char *table, int r, char *name, int64_t *score);

/* Enters a score below those that are better or equal; returns its row, or -1 when it is not good enough. -2: no table
 * free. */
int nvram_enter(struct nvram *nv, const char *table, const char *name, int64_t score);

#endif
