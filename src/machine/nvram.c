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

const struct chip nvram_chip = { "nvram", columns, sizeof columns / sizeof *columns, true, false };

enum {
    MAGIC = 4,
    HEAD = 3,
    ROW = 24,
    ROW_FAR = NV_NAME, /* offset in a row of the progress byte */
    ROW_SCORE = 16,
    KEY_MOST = 2 * NV_KEY + 1 /* most bytes of the name of a table record, which may include a ship */
};

static const char magic[] = "NV02", old_magic[] = "NV01";

/* ---- records ---- */

static size_t record_size(const uint8_t *r)
{
    return HEAD + (size_t)r[1] + r[2];
}

static const uint8_t *value_of(const uint8_t *r)
{
    return r + HEAD + r[1];
}

/* Returns the offset of the record with this name, a score table if `table` is set, otherwise a save; the image's size
 * if there is none. */
static uint32_t find(const struct nvram *nv, bool table, const char *name)
{
    size_t n = strlen(name);
    uint32_t at = MAGIC;

    while (at < nv->s.live) {
        const uint8_t *r = nv->bytes + at;
        if ((r[0] == NV_TABLE) == table && r[1] == n && !memcmp(r + HEAD, name, n))
            break;
        at += (uint32_t)record_size(r);
    }
    return at;
}

static const uint8_t *record(const struct nvram *nv, bool table, const char *name)
{
    uint32_t at = find(nv, table, name);

    return at < nv->s.live ? nv->bytes + at : NULL;
}

static void drop(struct nvram *nv, uint32_t at)
{
    uint32_t size = (uint32_t)record_size(nv->bytes + at);

    memmove(nv->bytes + at, nv->bytes + at + size, nv->s.live - at - size);
    nv->s.live -= size;
}

/* Resizes the record at `at`, or adds one at the end, for a value of m bytes, and returns the address of the value. The
 * old value, cut to m bytes, is preserved. Returns NULL, and changes nothing, if the record does not fit. */
static uint8_t *put(struct nvram *nv, uint32_t at, enum nv_type type, const char *name, size_t m)
{
    uint8_t *r = nv->bytes + at;
    size_t n = strlen(name), was = at < nv->s.live ? record_size(r) : 0, is = HEAD + n + m;

    assert(n <= KEY_MOST && m <= UINT8_MAX);
    if (nv->s.live - was + is > nv->s.cap)
        return NULL;
    memmove(r + is, r + was, nv->s.live - at - was);
    nv->s.live = (uint32_t)(nv->s.live - was + is);
    r[0] = (uint8_t)type;
    r[1] = (uint8_t)n;
    r[2] = (uint8_t)m;
    memcpy(r + HEAD, name, n);
    return r + HEAD + n;
}

/* ---- images ---- */

static bool record_valid(const uint8_t *r, size_t left)
{
    if (left < HEAD || r[1] > (r[0] == NV_TABLE ? KEY_MOST : NV_KEY) || record_size(r) > left)
        return false;
    switch (r[0]) {
    case NV_INT:
    case NV_FLOAT:
        return r[2] == 8;
    case NV_TEXT:
        return r[2] <= NV_STRING;
    case NV_BOOL:
        return r[2] == 1 && *value_of(r) <= 1;
    case NV_TABLE:
        return r[2] % ROW == 0 && r[2] >= ROW && r[2] <= NV_ROWS * ROW;
    default:
        return false;
    }
}

static bool records_valid(const uint8_t *image, size_t size)
{
    for (size_t at = MAGIC; at < size; at += record_size(image + at))
        if (!record_valid(image + at, size - at))
            return false;
    return true;
}

enum {
    OLD_SAVES = 256,
    OLD_SAVE = 96,
    OLD_TYPE = 32,
    OLD_LENGTH = 33,
    OLD_VALUE = 36,
    OLD_TABLES = 16,
    OLD_ROWS = 32,
    OLD_TABLE = OLD_ROWS + NV_ROWS * ROW,
    OLD_FIRST_TABLE = MAGIC + OLD_SAVES * OLD_SAVE
};

static bool old_valid(const uint8_t *image)
{
    for (int i = 0; i < OLD_SAVES; i++) {
        const uint8_t *r = image + MAGIC + i * OLD_SAVE;
        if (r[NV_KEY] || r[OLD_TYPE] > NV_BOOL || r[OLD_LENGTH] > NV_STRING || (r[0] && r[OLD_TYPE] == NV_NONE))
            return false;
    }
    for (int t = 0; t < OLD_TABLES; t++) {
        const uint8_t *p = image + OLD_FIRST_TABLE + t * OLD_TABLE;
        for (int row = 0; row < NV_ROWS; row++)
            if (p[NV_KEY] || p[OLD_ROWS + row * ROW + NV_NAME])
                return false;
    }
    return true;
}

bool nvram_valid(const uint8_t *image, size_t size)
{
    if (size == NV_OLD_BYTES && !memcmp(image, old_magic, MAGIC))
        return old_valid(image);
    return size >= MAGIC && size <= NV_MOST_KIB * 1024 && !memcmp(image, magic, MAGIC) && records_valid(image, size);
}

static struct nv_value old_value(const uint8_t *r)
{
    struct nv_value v = { .type = (enum nv_type)r[OLD_TYPE], .bits = bytes_get64(r + OLD_VALUE) };

    v.length = r[OLD_LENGTH];
    memcpy(v.text, r + OLD_VALUE, NV_STRING);
    return v;
}

/* Loads an old image. Of several records with the same key, the first is loaded, as in the versions that wrote them. */
static void load_old(struct nvram *nv, const uint8_t *image)
{
    for (int i = 0; i < OLD_SAVES; i++) {
        const uint8_t *r = image + MAGIC + i * OLD_SAVE;
        struct nv_value v = old_value(r);
        if (r[0] && !record(nv, false, (const char *)r))
            nvram_set(nv, (const char *)r, &v);
    }
    for (int t = 0; t < OLD_TABLES; t++) {
        const uint8_t *p = image + OLD_FIRST_TABLE + t * OLD_TABLE, *rows = p + OLD_ROWS;
        size_t n = 0;
        while (n < NV_ROWS && rows[n * ROW])
            n++;
        if (!p[0] || !n || record(nv, true, (const char *)p))
            continue;
        uint8_t *to = put(nv, nv->s.live, NV_TABLE, (const char *)p, n * ROW);
        if (to)
            memcpy(to, rows, n * ROW);
    }
}

void nvram_load(struct nvram *nv, const uint8_t *image, size_t size)
{
    size_t n = MAGIC;

    assert(nv->s.cap >= MAGIC);
    memcpy(nv->bytes, magic, MAGIC);
    nv->s.live = MAGIC;
    if (image && nvram_valid(image, size)) {
        if (!memcmp(image, old_magic, MAGIC)) {
            load_old(nv, image);
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
    const uint8_t *r = record(nv, false, key);
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
    uint32_t at = find(nv, false, key);
    uint8_t *to;

    if (v->type == NV_NONE) {
        nv->writes += at < nv->s.live;
        if (at < nv->s.live)
            drop(nv, at);
        return true;
    }
    to = put(nv, at, v->type, key, v->type == NV_TEXT ? v->length : v->type == NV_BOOL ? 1 : 8);
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
    return (int64_t)bytes_get64(row + ROW_SCORE);
}

/* Returns whether record r belongs to this score table, with or without a ship; stores the ship's name, or "". */
static bool is_table(const uint8_t *r, const char *table, char ship[NV_KEY + 1])
{
    size_t n = strlen(table), all = r[1];
    const uint8_t *name = r + HEAD;

    if (r[0] != NV_TABLE || all < n || memcmp(name, table, n) != 0 || (all > n && name[n] != NV_SHIP))
        return false;
    size_t rest = all > n ? all - n - 1 : 0;
    if (rest > NV_KEY)
        return false;
    memcpy(ship, name + all - rest, rest);
    ship[rest] = 0;
    return true;
}

/* Inserts a row into n rows, below all rows with the same or a better score. Returns the new number of rows, at most
 * NV_ROWS: the worst row may be dropped. */
static int sort_in(struct nv_row rows[NV_ROWS], int n, const uint8_t *from, const char *ship)
{
    int at = n;

    while (at > 0 && rows[at - 1].score < score_of(from))
        at--;
    if (at == NV_ROWS)
        return n;
    n = n < NV_ROWS ? n + 1 : n;
    memmove(rows + at + 1, rows + at, (size_t)(n - 1 - at) * sizeof *rows);
    rows[at] = (struct nv_row){ .score = score_of(from), .stage = from[ROW_FAR] & 15, .continues = from[ROW_FAR] >> 4 };
    memcpy(rows[at].name, from, NV_NAME);
    memcpy(rows[at].ship, ship, sizeof rows[at].ship);
    return n;
}

int nvram_rows(const struct nvram *nv, const char *table, const char *ship, struct nv_row rows[NV_ROWS])
{
    char of[NV_KEY + 1];
    int n = 0;

    for (uint32_t at = MAGIC; at < nv->s.live; at += (uint32_t)record_size(nv->bytes + at)) {
        const uint8_t *r = nv->bytes + at;
        if (!is_table(r, table, of) || (ship && strcmp(ship, of) != 0))
            continue;
        for (int i = 0; i < r[2] / ROW; i++)
            n = sort_in(rows, n, value_of(r) + i * ROW, of);
    }
    return n;
}

int nvram_enter(struct nvram *nv, const char *table, const struct nv_row *row)
{
    char key[KEY_MOST + 1];

    snprintf(key, sizeof key, row->ship[0] ? "%s%c%s" : "%s", table, NV_SHIP, row->ship);
    uint32_t at = find(nv, true, key);
    const uint8_t *had = nv->bytes + at;
    int n = at < nv->s.live ? had[2] / ROW : 0, r = 0;
    while (r < n && score_of(value_of(had) + r * ROW) >= row->score)
        r++;
    if (r == NV_ROWS)
        return -1;
    int rows = n < NV_ROWS ? n + 1 : NV_ROWS;
    uint8_t *to = put(nv, at, NV_TABLE, key, (size_t)rows * ROW);
    if (!to)
        return -2;
    nv->writes++;
    memmove(to + (r + 1) * ROW, to + r * ROW, (size_t)(rows - 1 - r) * ROW);
    to += r * ROW;
    memset(to, 0, ROW);
    memcpy(to, row->name, strlen(row->name));
    to[ROW_FAR] = (uint8_t)(row->stage | row->continues << 4);
    bytes_put64(to + ROW_SCORE, (uint64_t)row->score);
    return r;
}
