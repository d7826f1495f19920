/*
 * nvram.c - see nvram.h. Finding a record is a linear search; resizing or removing a record moves all records after it.
 */
#include "nvram.h"
#include <assert.h>
#include <stdio.h>
#include <string.h>
#include "../base/bytes.h"
#include "../rom/manifest.h"

static const struct column columns[] = {
    COLUMN(nvram, bytes),
    REGISTER(nvram, writes),
};

const struct chip nvram_chip = { .name = "nvram", CHIP_COLUMNS(columns), .is_list = true };

enum {
    MAGIC_SIZE = 4,
    HEADER_SIZE = 3,
    ROW_SIZE = 24,
    ROW_PROGRESS_OFFSET = NV_MAX_NAME, /* offset in a row of the progress byte */
    ROW_SCORE_OFFSET = 16,
    MAX_RECORD_NAME = 2 * NV_MAX_KEY + 1 /* most bytes of the name of a table record, which may include a ship */
};

static const char magic[] = "NV02", old_magic[] = "NV01";

/* ---- records ---- */

static size_t record_size(const uint8_t *r)
{
    return HEADER_SIZE + (size_t)r[1] + r[2];
}

static const uint8_t *value_of(const uint8_t *r)
{
    return r + HEADER_SIZE + r[1];
}

/* Returns the offset of the record with this name, a score table if `wants_table` is set, otherwise a save; the image's
 * size if there is none. */
static uint32_t find_offset(const struct nvram *nv, bool wants_table, const char *name)
{
    size_t n = strlen(name);
    uint32_t at = MAGIC_SIZE;

    while (at < nv->s.live) {
        const uint8_t *r = nv->bytes + at;
        if ((r[0] == NV_TABLE) == wants_table && r[1] == n && !memcmp(r + HEADER_SIZE, name, n))
            break;
        at += (uint32_t)record_size(r);
    }
    return at;
}

static const uint8_t *find_record(const struct nvram *nv, bool wants_table, const char *name)
{
    uint32_t at = find_offset(nv, wants_table, name);

    return at < nv->s.live ? nv->bytes + at : NULL;
}

static void remove_record(struct nvram *nv, uint32_t at)
{
    uint32_t size = (uint32_t)record_size(nv->bytes + at);

    memmove(nv->bytes + at, nv->bytes + at + size, nv->s.live - at - size);
    nv->s.live -= size;
}

/* Resizes the record at `at`, or adds one at the end, for a value of m bytes, and returns the address of the value. The
 * old value, cut to m bytes, is preserved. Returns NULL, and changes nothing, if the record does not fit. */
static uint8_t *resize_record(struct nvram *nv, uint32_t at, enum nv_type type, const char *name, size_t m)
{
    uint8_t *r = nv->bytes + at;
    size_t n = strlen(name), old_size = at < nv->s.live ? record_size(r) : 0, new_size = HEADER_SIZE + n + m;

    assert(n <= MAX_RECORD_NAME && m <= UINT8_MAX);
    if (nv->s.live - old_size + new_size > nv->s.cap)
        return NULL;
    memmove(r + new_size, r + old_size, nv->s.live - at - old_size);
    nv->s.live = (uint32_t)(nv->s.live - old_size + new_size);
    r[0] = (uint8_t)type;
    r[1] = (uint8_t)n;
    r[2] = (uint8_t)m;
    memcpy(r + HEADER_SIZE, name, n);
    return r + HEADER_SIZE + n;
}

/* ---- images ---- */

static bool record_is_valid(const uint8_t *r, size_t left)
{
    if (left < HEADER_SIZE || r[1] > (r[0] == NV_TABLE ? MAX_RECORD_NAME : NV_MAX_KEY) || record_size(r) > left)
        return false;
    switch (r[0]) {
    case NV_INT:
    case NV_FLOAT:
        return r[2] == 8;
    case NV_TEXT:
        return r[2] <= NV_MAX_STRING;
    case NV_BOOL:
        return r[2] == 1 && *value_of(r) <= 1;
    case NV_TABLE:
        return r[2] % ROW_SIZE == 0 && r[2] >= ROW_SIZE && r[2] <= NV_MAX_ROWS * ROW_SIZE;
    default:
        return false;
    }
}

static bool are_all_records_valid(const uint8_t *image, size_t size)
{
    for (size_t at = MAGIC_SIZE; at < size; at += record_size(image + at))
        if (!record_is_valid(image + at, size - at))
            return false;
    return true;
}

enum {
    OLD_SAVE_COUNT = 256,
    OLD_SAVE_SIZE = 96,
    OLD_TYPE_OFFSET = 32,
    OLD_LENGTH_OFFSET = 33,
    OLD_VALUE_OFFSET = 36,
    OLD_TABLE_COUNT = 16,
    OLD_ROWS_OFFSET = 32,
    OLD_TABLE_SIZE = OLD_ROWS_OFFSET + NV_MAX_ROWS * ROW_SIZE,
    OLD_TABLES_OFFSET = MAGIC_SIZE + OLD_SAVE_COUNT * OLD_SAVE_SIZE
};

static bool old_image_is_valid(const uint8_t *image)
{
    for (int i = 0; i < OLD_SAVE_COUNT; i++) {
        const uint8_t *r = image + MAGIC_SIZE + i * OLD_SAVE_SIZE;
        if (r[NV_MAX_KEY] || r[OLD_TYPE_OFFSET] > NV_BOOL || r[OLD_LENGTH_OFFSET] > NV_MAX_STRING ||
            (r[0] && r[OLD_TYPE_OFFSET] == NV_NONE))
            return false;
    }
    for (int t = 0; t < OLD_TABLE_COUNT; t++) {
        const uint8_t *p = image + OLD_TABLES_OFFSET + t * OLD_TABLE_SIZE;
        for (int row = 0; row < NV_MAX_ROWS; row++)
            if (p[NV_MAX_KEY] || p[OLD_ROWS_OFFSET + row * ROW_SIZE + NV_MAX_NAME])
                return false;
    }
    return true;
}

bool nvram_is_valid(const uint8_t *image, size_t size)
{
    if (size == NV_OLD_IMAGE_SIZE && !memcmp(image, old_magic, MAGIC_SIZE))
        return old_image_is_valid(image);
    return size >= MAGIC_SIZE && size <= NV_MAX_KIB * 1024 && !memcmp(image, magic, MAGIC_SIZE) &&
           are_all_records_valid(image, size);
}

static struct nv_value read_old_value(const uint8_t *r)
{
    struct nv_value v = { .type = (enum nv_type)r[OLD_TYPE_OFFSET], .bits = bytes_get64(r + OLD_VALUE_OFFSET) };

    v.length = r[OLD_LENGTH_OFFSET];
    memcpy(v.text, r + OLD_VALUE_OFFSET, NV_MAX_STRING);
    return v;
}

/* Loads an old image. Of several records with the same key, the first is loaded, as in the versions that wrote them. */
static void load_old_image(struct nvram *nv, const uint8_t *image)
{
    for (int i = 0; i < OLD_SAVE_COUNT; i++) {
        const uint8_t *r = image + MAGIC_SIZE + i * OLD_SAVE_SIZE;
        struct nv_value v = read_old_value(r);
        if (r[0] && !find_record(nv, false, (const char *)r))
            nvram_set(nv, (const char *)r, &v);
    }
    for (int t = 0; t < OLD_TABLE_COUNT; t++) {
        const uint8_t *p = image + OLD_TABLES_OFFSET + t * OLD_TABLE_SIZE, *rows = p + OLD_ROWS_OFFSET;
        size_t n = 0;
        while (n < NV_MAX_ROWS && rows[n * ROW_SIZE])
            n++;
        if (!p[0] || !n || find_record(nv, true, (const char *)p))
            continue;
        uint8_t *to = resize_record(nv, nv->s.live, NV_TABLE, (const char *)p, n * ROW_SIZE);
        if (to)
            memcpy(to, rows, n * ROW_SIZE);
    }
}

void nvram_load(struct nvram *nv, const uint8_t *image, size_t size)
{
    size_t n = MAGIC_SIZE;

    assert(nv->s.cap >= MAGIC_SIZE);
    memcpy(nv->bytes, magic, MAGIC_SIZE);
    nv->s.live = MAGIC_SIZE;
    if (image && nvram_is_valid(image, size)) {
        if (!memcmp(image, old_magic, MAGIC_SIZE)) {
            load_old_image(nv, image);
        } else {
            while (n < size && n + record_size(image + n) <= nv->s.cap)
                n += record_size(image + n);
            memcpy(nv->bytes, image, n);
            nv->s.live = (uint32_t)n;
        }
    }
    nv->writes = 0;
}

/* ---- saves ---- */

struct nv_value nvram_get(const struct nvram *nv, const char *key)
{
    const uint8_t *r = find_record(nv, false, key);
    struct nv_value v = { .type = NV_NONE };

    if (!r)
        return v;
    v.type = (enum nv_type)r[0];
    if (v.type == NV_TEXT) {
        v.length = r[2];
        memcpy(v.text, value_of(r), v.length);
    } else
        v.bits = v.type == NV_BOOL ? *value_of(r) : bytes_get64(value_of(r));
    return v;
}

bool nvram_set(struct nvram *nv, const char *key, const struct nv_value *v)
{
    uint32_t at = find_offset(nv, false, key);
    uint8_t *to;

    if (v->type == NV_NONE) {
        nv->writes += at < nv->s.live;
        if (at < nv->s.live)
            remove_record(nv, at);
        return true;
    }
    to = resize_record(nv, at, v->type, key, v->type == NV_TEXT ? v->length : v->type == NV_BOOL ? 1 : 8);
    if (!to)
        return false;
    nv->writes++;
    if (v->type == NV_TEXT)
        memcpy(to, v->text, v->length);
    else if (v->type == NV_BOOL)
        *to = v->bits != 0;
    else
        bytes_put64(to, v->bits);
    return true;
}

/* ---- score tables ---- */

static int64_t score_of(const uint8_t *row)
{
    return (int64_t)bytes_get64(row + ROW_SCORE_OFFSET);
}

/* Returns whether record r belongs to this score table, with or without a ship; stores the ship's name, or "". */
static bool match_table(const uint8_t *r, const char *table, char ship[NV_MAX_KEY + 1])
{
    size_t n = strlen(table), length = r[1];
    const uint8_t *name = r + HEADER_SIZE;

    if (r[0] != NV_TABLE || length < n || memcmp(name, table, n) != 0 || (length > n && name[n] != NV_SHIP_SEPARATOR))
        return false;
    size_t ship_length = length > n ? length - n - 1 : 0;
    if (ship_length > NV_MAX_KEY)
        return false;
    memcpy(ship, name + length - ship_length, ship_length);
    ship[ship_length] = 0;
    return true;
}

/* Inserts a row into n rows, below all rows with the same or a better score. Returns the new number of rows, at most
 * NV_MAX_ROWS: the worst row may be dropped. */
static int insert_row(struct nv_row rows[NV_MAX_ROWS], int n, const uint8_t *from, const char *ship)
{
    int at = n;

    while (at > 0 && rows[at - 1].score < score_of(from))
        at--;
    if (at == NV_MAX_ROWS)
        return n;
    n = n < NV_MAX_ROWS ? n + 1 : n;
    memmove(rows + at + 1, rows + at, (size_t)(n - 1 - at) * sizeof *rows);
    rows[at] = (struct nv_row){ .score = score_of(from),
                                .stage = from[ROW_PROGRESS_OFFSET] & 15,
                                .continues = from[ROW_PROGRESS_OFFSET] >> 4 };
    memcpy(rows[at].name, from, NV_MAX_NAME);
    memcpy(rows[at].ship, ship, sizeof rows[at].ship);
    return n;
}

int nvram_get_rows(const struct nvram *nv, const char *table, const char *ship, struct nv_row rows[NV_MAX_ROWS])
{
    char row_ship[NV_MAX_KEY + 1];
    int n = 0;

    for (uint32_t at = MAGIC_SIZE; at < nv->s.live; at += (uint32_t)record_size(nv->bytes + at)) {
        const uint8_t *r = nv->bytes + at;
        if (!match_table(r, table, row_ship) || (ship && strcmp(ship, row_ship) != 0))
            continue;
        for (int i = 0; i < r[2] / ROW_SIZE; i++)
            n = insert_row(rows, n, value_of(r) + i * ROW_SIZE, row_ship);
    }
    return n;
}

int nvram_enter_row(struct nvram *nv, const char *table, const struct nv_row *row)
{
    char key[MAX_RECORD_NAME + 1];

    snprintf(key, sizeof key, row->ship[0] ? "%s%c%s" : "%s", table, NV_SHIP_SEPARATOR, row->ship);
    uint32_t at = find_offset(nv, true, key);
    const uint8_t *old = nv->bytes + at;
    int n = at < nv->s.live ? old[2] / ROW_SIZE : 0, r = 0;
    while (r < n && score_of(value_of(old) + r * ROW_SIZE) >= row->score)
        r++;
    if (r == NV_MAX_ROWS)
        return -1;
    int rows = n < NV_MAX_ROWS ? n + 1 : NV_MAX_ROWS;
    uint8_t *to = resize_record(nv, at, NV_TABLE, key, (size_t)rows * ROW_SIZE);
    if (!to)
        return -2;
    nv->writes++;
    memmove(to + (r + 1) * ROW_SIZE, to + r * ROW_SIZE, (size_t)(rows - 1 - r) * ROW_SIZE);
    to += r * ROW_SIZE;
    memset(to, 0, ROW_SIZE);
    memcpy(to, row->name, strlen(row->name));
    to[ROW_PROGRESS_OFFSET] = (uint8_t)(row->stage | row->continues << 4);
    bytes_put64(to + ROW_SCORE_OFFSET, (uint64_t)row->score);
    return r;
}
