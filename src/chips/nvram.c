/*
 * nvram.c - see nvram.h. A record is found by walking from the first; one that grows or goes moves those behind it.
 */
#include "nvram.h"
#include <assert.h>
#include <string.h>
#include "../base/bytes.h"

static const struct column columns[] = {
    COLUMN(nvram, bytes),
    REGISTER(nvram, writes),
};

const struct chip nvram_chip = { "nvram", columns, sizeof columns / sizeof *columns, true, false };

enum { MAGIC = 4, HEAD = 3, ROW = 24 };

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

/* Where the record of a name is: a save's or a table's. The image's size: there is none. */
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

/* Makes the record at `at`, or a new one at the end, one of a value of m bytes, and returns where these go. What was
 * there of it stays in the first of them. NULL: there is no room, and nothing changed. */
static uint8_t *put(struct nvram *nv, uint32_t at, enum nv_type type, const char *name, size_t m)
{
    uint8_t *r = nv->bytes + at;
    size_t n = strlen(name), was = at < nv->s.live ? record_size(r) : 0, is = HEAD + n + m;

    assert(n <= NV_KEY && m <= UINT8_MAX);
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

static bool rows_valid(const uint8_t *rows, size_t size)
{
    for (size_t at = 0; at < size; at += ROW)
        if (rows[at + NV_NAME])
            return false;
    return size % ROW == 0 && size >= ROW && size <= NV_ROWS * ROW;
}

static bool record_valid(const uint8_t *r, size_t left)
{
    if (left < HEAD || r[1] > NV_KEY || record_size(r) > left)
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
        return r[2] % ROW == 0 && rows_valid(value_of(r), r[2]);
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
        if (p[NV_KEY] || !rows_valid(p + OLD_ROWS, NV_ROWS * ROW))
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

/* The first of two records of one key is the one that was found. */
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

    nv->writes++;
    if (v->type == NV_NONE) {
        if (at < nv->s.live)
            drop(nv, at);
        return true;
    }
    to = put(nv, at, v->type, key, v->type == NV_TEXT ? v->length : v->type == NV_BOOL ? 1 : 8);
    if (!to)
        return false;
    if (v->type == NV_TEXT)
        memcpy(to, v->text, v->length);
    else if (v->type == NV_BOOL)
        *to = v->bits != 0;
    else
        bytes_put64(to, v->bits);
    return true;
}

/* ---- score tables ---- */

bool nvram_row(const struct nvram *nv, const char *table, int r, char *name, int64_t *score)
{
    const uint8_t *p = record(nv, true, table);

    if (!p || r < 0 || r >= p[2] / ROW)
        return false;
    memcpy(name, value_of(p) + r * ROW, NV_NAME + 1);
    *score = (int64_t)bytes_get64(value_of(p) + r * ROW + 16);
    return true;
}

int nvram_enter(struct nvram *nv, const char *table, const char *name, int64_t score)
{
    uint32_t at = find(nv, true, table);
    const uint8_t *had = nv->bytes + at;
    int n = at < nv->s.live ? had[2] / ROW : 0, r = 0;

    nv->writes++;
    while (r < n && (int64_t)bytes_get64(value_of(had) + r * ROW + 16) >= score)
        r++;
    if (r == NV_ROWS)
        return -1;
    int rows = n < NV_ROWS ? n + 1 : NV_ROWS;
    uint8_t *to = put(nv, at, NV_TABLE, table, (size_t)rows * ROW);
    if (!to)
        return -2;
    memmove(to + (r + 1) * ROW, to + r * ROW, (size_t)(rows - 1 - r) * ROW);
    memset(to + r * ROW, 0, ROW);
    memcpy(to + r * ROW, name, strlen(name));
    bytes_put64(to + r * ROW + 16, (uint64_t)score);
    return r;
}
