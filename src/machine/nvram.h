/*
 * nvram.h - non-volatile memory: score tables and saves. A little-endian byte image, identical on every host.
 *
 * Image: magic "NV02", then records without gaps, in the order in which they were first stored:
 *
 *     u8 type (enum nv_type), u8 n, u8 m, n bytes of name, m bytes of value
 *
 * An integer or a double has 8 bytes of value, a string up to NV_MAX_STRING, a boolean 1. A score table has at most
 * NV_MAX_ROWS rows, best first, of 24 bytes: name[15] padded with NULs, u8 progress, i64 score. Memory, snapshots and
 * hashes hold only what is stored; the manifest sets the capacity (board.nvram).
 *
 * The low four bits of the progress byte are the stage reached (0: unknown, 15: all cleared), the high four bits the
 * number of continues (15: 15 or more). Each ship's scores are in a separate table, whose name is the score table's
 * name, NV_SHIP_SEPARATOR and the ship's name.
 *
 * Old images, with the magic "NV01", are accepted too: 32768 bytes; 256 records of 96 bytes { key[32], type, length, 2
 * spare, value[60] }, 16 tables of 32 + 10 x 24 bytes { name[32], rows }, then zeroes. An empty key or name is a free
 * record.
 */
#ifndef MACHINE_NVRAM_H
#define MACHINE_NVRAM_H

#include "../base/slots.h"

enum {
    NV_MAX_KEY = 31,          /* most bytes of a key or a table name */
    NV_SHIP_SEPARATOR = '\n', /* separates the table's name from the ship's */
    NV_MAX_STRING = 60,       /* most bytes of a string value */
    NV_MAX_ROWS = 10,
    NV_MAX_NAME = 15,      /* most bytes of a name in a score table */
    NV_STAGE_CLEARED = 15, /* stage value: all stages cleared */
    NV_MAX_CONTINUES = 15, /* this many continues or more */
    NV_OLD_IMAGE_SIZE = 32768
};

enum nv_type { NV_NONE, NV_INT, NV_FLOAT, NV_TEXT, NV_BOOL, NV_TABLE };

struct nv_value {
    enum nv_type type;
    uint64_t bits; /* integer, double's bits, or 0/1 */
    char text[NV_MAX_STRING];
    size_t length;
};

struct nv_row {
    char name[NV_MAX_NAME + 1], ship[NV_MAX_KEY + 1]; /* ship "": unknown */
    int64_t score;
    uint8_t stage, continues; /* stage: 0 to NV_STAGE_CLEARED; continues: 0 to NV_MAX_CONTINUES */
};

struct nvram {
    struct slots s; /* a list: the bytes of the image are live; bytes after them are undefined */
    uint8_t *bytes;
    uint32_t writes; /* number of writes since the image was loaded */
};

extern const struct chip nvram_chip;

/* Returns whether nvram_load accepts this image. */
bool nvram_is_valid(const uint8_t *image, size_t size);

/* Loads the image if it is valid, otherwise starts blank. If the image exceeds the capacity, only its first records are
 * loaded. */
void nvram_load(struct nvram *nv, const uint8_t *image, size_t size);

/* Returns the value stored under a key, or a value of type NV_NONE if there is none. */
struct nv_value nvram_get(const struct nvram *nv, const char *key);

/* Stores a value under a key; NV_NONE deletes the key. Returns false, and leaves the old value, if it does not fit. */
bool nvram_set(struct nvram *nv, const char *key, const struct nv_value *v);

/* Stores rows of a score table in `rows`, best first, and returns their number, at most NV_MAX_ROWS. ship: only this
 * ship's rows ("": only rows without a ship); NULL: the best of all rows, with or without a ship. */
int nvram_get_rows(const struct nvram *nv, const char *table, const char *ship, struct nv_row rows[NV_MAX_ROWS]);

/* Enters a row into the table of the row's ship, below all rows with the same or a better score. Returns the row's
 * index in that table, -1 if the score is not good enough, or -2 if the NVRAM is full. */
int nvram_enter_row(struct nvram *nv, const char *table, const struct nv_row *row);

#endif
