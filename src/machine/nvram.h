/*
 * nvram.h - memory that outlives the power: score tables and saves. Bytes, little-endian, the same on every host.
 *
 * Image: magic "NV02", then records one behind the other, without gaps, in the order in which they were first kept:
 *
 *     u8 type (enum nv_type), u8 n, u8 m, n bytes of name, m bytes of value
 *
 * Of an integer and a double 8 bytes, of a text up to NV_STRING, of a boolean 1; of a score table NV_ROWS rows at most,
 * best first, of 24 bytes: name[15], NULs behind it, u8 how far, and i64 score. So memory, snapshots and hashes have
 * what is kept and no more; the manifest says how much there is room for (board.nvram).
 *
 * The name's last byte says how far that score went: its low four bits the stage that was reached (0: not said, 15: all
 * were cleared), its high four how often the run was continued (15: as often or more). The scores of one ship stand in
 * a table of their own, whose name is that of the table, NV_SHIP, and the ship's.
 *
 * Images of before, "NV01", are taken too: 32768 bytes; 256 records of 96 bytes { key[32], type, length, 2 spare,
 * value[60] }, 16 tables of 32 + 10 x 24 bytes { name[32], rows }, zeroes. An empty key or name is a free record.
 */
#ifndef MACHINE_NVRAM_H
#define MACHINE_NVRAM_H

#include "../base/slots.h"

enum {
    NV_KEY = 31,    /* bytes of a key, and of a table's name */
    NV_SHIP = '\n', /* between a table's name and a ship's */
    NV_STRING = 60, /* bytes of a string value */
    NV_ROWS = 10,
    NV_NAME = 15,      /* bytes of a name in a score table */
    NV_CLEARED = 15,   /* in place of a stage: all of them */
    NV_CONTINUES = 15, /* as many, or more */
    NV_OLD_BYTES = 32768
};

enum nv_type { NV_NONE, NV_INT, NV_FLOAT, NV_TEXT, NV_BOOL, NV_TABLE };

struct nv_value {
    enum nv_type type;
    uint64_t bits; /* integer, double's bits, or 0/1 */
    char text[NV_STRING];
    size_t length;
};

struct nv_row {
    char name[NV_NAME + 1], ship[NV_KEY + 1]; /* ship "": not said */
    int64_t score;
    uint8_t stage, continues; /* 0 to NV_CLEARED, NV_CONTINUES */
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

/* Rows of a score table, best first, and how many: those of a ship, or with NULL the best of all, those without a ship
 * among them. */
int nvram_rows(const struct nvram *nv, const char *table, const char *ship, struct nv_row rows[NV_ROWS]);

/* Enters a row below those that are better or equal, into the table of its ship; returns its place there, or -1 when it
 * is not good enough. -2: there is no room. */
int nvram_enter(struct nvram *nv, const char *table, const struct nv_row *row);

#endif
