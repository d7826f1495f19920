/*
 * nvram.c - see nvram.h.
 */
#include "nvram.h"
#include <string.h>
#include "../base/bytes.h"

static const struct column columns[] = {
    COLUMN(nvram, bytes),
    REGISTER(nvram, writes),
};

const struct chip nvram_chip = { "nvram", columns, sizeof columns / sizeof *columns, true, false };

enum { HEAD = 4, SAVE = 96, ROW = 24, TABLE = 32 + NV_ROWS * ROW, FIRST_TABLE = HEAD + NV_SAVES * SAVE };

static const char magic[] = "NV01";

static bool fields_valid(const uint8_t *image)
{
    for (int i = 0; i < NV_SAVES; i++) {
        const uint8_t *r = image + HEAD + i * SAVE;
        if (r[NV_KEY] || r[32] > NV_BOOL || r[33] > NV_STRING || (r[0] && r[32] == NV_NONE))
            return false;
    }
    for (int t = 0; t < NV_TABLES; t++) {
        const uint8_t *p = image + FIRST_TABLE + t * TABLE;
        if (p[31])
            return false;
        for (int r = 0; r < NV_ROWS; r++)
            if (p[32 + r * ROW + NV_NAME])
                return false;
    }
    return true;
}

bool nvram_valid(const uint8_t *image, size_t size)
{
    return size == NV_BYTES && !memcmp(image, magic, HEAD) && fields_valid(image);
}

void nvram_load(struct nvram *nv, const uint8_t *image, size_t size)
{
    memset(nv->bytes, 0, NV_BYTES);
    if (image && nvram_valid(image, size))
        memcpy(nv->bytes, image, NV_BYTES);
    memcpy(nv->bytes, magic, HEAD);
    nv->writes = 0;
}

/* The record of a key; with `make`, a free one when there is none. NULL: not found, or all taken. */
static uint8_t *record(const struct nvram *nv, const char *key, bool make)
{
    uint8_t *free = NULL;

    for (int i = 0; i < NV_SAVES; i++) {
        uint8_t *r = nv->bytes + HEAD + i * SAVE;
        if (r[0] && !strcmp((char *)r, key))
            return r;
        if (!r[0] && !free)
            free = r;
    }
    return make ? free : NULL;
}

struct nv_value nvram_get(const struct nvram *nv, const char *key)
{
    const uint8_t *r = record(nv, key, false);
    struct nv_value v = { .type = NV_NONE };

    if (!r)
        return v;
    v.type = (enum nv_type)r[32];
    v.bits = bytes_get64(r + 36);
    v.length = r[33];
    memcpy(v.text, r + 36, NV_STRING);
    return v;
}

bool nvram_set(struct nvram *nv, const char *key, const struct nv_value *v)
{
    uint8_t *r = record(nv, key, v->type != NV_NONE);

    nv->writes++;
    if (!r)
        return v->type == NV_NONE;
    memset(r, 0, SAVE);
    if (v->type == NV_NONE)
        return true;
    strcpy((char *)r, key);
    r[32] = (uint8_t)v->type;
    if (v->type == NV_TEXT) {
        r[33] = (uint8_t)v->length;
        memcpy(r + 36, v->text, v->length);
    } else
        bytes_put64(r + 36, v->bits);
    return true;
}

static uint8_t *table_at(const struct nvram *nv, const char *name, bool make)
{
    uint8_t *free = NULL;

    for (int t = 0; t < NV_TABLES; t++) {
        uint8_t *p = nv->bytes + FIRST_TABLE + t * TABLE;
        if (p[0] && !strcmp((char *)p, name))
            return p;
        if (!p[0] && !free)
            free = p;
    }
    return make ? free : NULL;
}

bool nvram_row(const struct nvram *nv, const char *table, int r, char *name, int64_t *score)
{
    const uint8_t *p = table_at(nv, table, false);

    if (!p || r < 0 || r >= NV_ROWS || !p[32 + r * ROW])
        return false;
    memcpy(name, p + 32 + r * ROW, NV_NAME + 1);
    *score = (int64_t)bytes_get64(p + 32 + r * ROW + 16);
    return true;
}

int nvram_enter(struct nvram *nv, const char *table, const char *name, int64_t score)
{
    uint8_t *p = table_at(nv, table, true);
    int r = 0;

    nv->writes++;
    if (!p)
        return -2;
    uint8_t *rows = p + 32;
    while (r < NV_ROWS && rows[r * ROW] && (int64_t)bytes_get64(rows + r * ROW + 16) >= score)
        r++;
    if (r == NV_ROWS)
        return -1;
    strcpy((char *)p, table);
    memmove(rows + (r + 1) * ROW, rows + r * ROW, (size_t)(NV_ROWS - 1 - r) * ROW);
    memset(rows + r * ROW, 0, ROW);
    strcpy((char *)rows + r * ROW, name);
    bytes_put64(rows + r * ROW + 16, (uint64_t)score);
    return r;
}
