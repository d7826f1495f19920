/*
 * fuzz_nvram.c - libFuzzer: any bytes as an image of saves and score tables. The first byte says how much room there
 * is; if it is odd the others are the image, else they are edits of a blank one of NV01, so that most are taken:
 *
 *     u16 offset (of the image, modulo its size), u8 count 0..63, count bytes
 *
 * An image that is taken stays one whatever is kept in it; one that is not is as good as a blank one. Of one of NV01
 * nothing is lost where there is as much room as there was.
 */
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "../../src/base/bytes.h"
#include "../../src/machine/nvram.h"

static void need(bool good)
{
    if (!good)
        abort();
}

static void edit(uint8_t *image, const uint8_t *data, size_t size)
{
    memset(image, 0, NV_OLD_IMAGE_SIZE);
    memcpy(image, "NV01", 4);
    for (size_t at = 0; size - at >= 3;) {
        size_t to = bytes_get16(data + at) % NV_OLD_IMAGE_SIZE, n = data[at + 2] % 64u;
        at += 3;
        n = n < size - at ? n : size - at;
        n = n < NV_OLD_IMAGE_SIZE - to ? n : NV_OLD_IMAGE_SIZE - to;
        if (n)
            memcpy(image + to, data + at, n);
        at += n;
    }
}

/* A value that is read can be kept, and is then the same. */
static void keep_again(struct nvram *nv, const char *key)
{
    struct nv_value v = nvram_get(nv, key);

    need(v.type != NV_NONE && v.type <= NV_BOOL && v.length <= NV_MAX_STRING);
    need(nvram_set(nv, key, &v));
    struct nv_value back = nvram_get(nv, key);
    need(back.type == v.type && back.length == v.length && back.bits == v.bits);
    need(memcmp(back.text, v.text, v.length) == 0);
}

static void use(struct nvram *nv)
{
    const struct nv_value number = { .type = NV_INT, .bits = 7 };
    struct nv_row mine = { .name = "me", .ship = "crow", .score = 1000, .stage = 3 }, rows[NV_MAX_ROWS];
    char key[NV_MAX_KEY + 1];
    uint32_t size;

    for (uint32_t at = 4; at < nv->s.live; at += size) {
        const uint8_t *r = nv->bytes + at;
        size = 3u + r[1] + r[2];
        if (r[0] == NV_TABLE) /* its key, of a name and a ship, may be longer */
            continue;
        memset(key, 0, sizeof key);
        memcpy(key, r + 3, r[1]);
        if (strlen(key) == r[1])
            keep_again(nv, key);
    }
    bool kept = nvram_set(nv, "one more", &number);
    need(kept || nvram_get(nv, "one more").type != NV_INT || nvram_get(nv, "one more").bits != 7);
    need(!kept || nvram_get(nv, "one more").bits == 7);
    for (int i = 0; i < 2; i++, mine.ship[0] = 0) {
        int row = nvram_enter_row(nv, "table", &mine), n = nvram_get_rows(nv, "table", mine.ship, rows);
        need(row >= -2 && row < NV_MAX_ROWS && row < (n ? n : 1) && n <= NV_MAX_ROWS);
        for (int r = 1; r < n; r++)
            need(rows[r - 1].score >= rows[r].score);
    }
}

/* All of an image of NV01 is there: the first record of each key, the rows of the first table of each name. */
static void compare_old(const struct nvram *nv, const uint8_t *image)
{
    for (int i = 0; i < 256; i++) {
        const uint8_t *r = image + 4 + i * 96;
        bool first = r[0];
        for (int k = 0; k < i; k++)
            first = first && strcmp((const char *)image + 4 + k * 96, (const char *)r);
        if (!first)
            continue;
        struct nv_value v = nvram_get(nv, (const char *)r);
        need(v.type == (enum nv_type)r[32]);
        need(v.type != NV_TEXT || (v.length == r[33] && !memcmp(v.text, r + 36, v.length)));
        need(v.type == NV_TEXT || v.bits == (v.type == NV_BOOL ? bytes_get64(r + 36) != 0 : bytes_get64(r + 36)));
    }
    for (int t = 0; t < 16; t++) {
        const uint8_t *p = image + 4 + 256 * 96 + t * (32 + 240);
        struct nv_row rows[NV_MAX_ROWS];
        bool first = p[0] && p[32];
        for (int k = 0; k < t; k++) {
            const uint8_t *q = image + 4 + 256 * 96 + k * (32 + 240);
            first = first && (!q[32] || strcmp((const char *)q, (const char *)p));
        }
        int n = first ? nvram_get_rows(nv, (const char *)p, "", rows) : 0;
        for (int r = 0; first && r < NV_MAX_ROWS && p[32 + r * 24]; r++) {
            const uint8_t *row = p + 32 + r * 24;
            int k = 0;
            while (k < n &&
                   (rows[k].score != (int64_t)bytes_get64(row + 16) || strcmp(rows[k].name, (const char *)row)))
                k++;
            need(k < n);
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static uint8_t image[NV_OLD_IMAGE_SIZE];
    uint32_t room = size ? 1024u * (1 + data[0] / 2 % 32) : 0;
    struct nvram nv = { .bytes = malloc(room + 1), .s = { .cap = room } };
    bool whole = size && data[0] % 2;
    uint8_t *copy = malloc(size + 1); /* of exactly the size it has */

    if (!nv.bytes || !copy || !size) {
        free(nv.bytes);
        free(copy);
        return 0;
    }
    memcpy(copy, data + 1, size - 1);
    if (!whole)
        edit(image, copy, size - 1);
    const uint8_t *from = whole ? copy : image;
    size_t n = whole ? size - 1 : NV_OLD_IMAGE_SIZE;
    bool good = nvram_is_valid(from, n), old = n == NV_OLD_IMAGE_SIZE && !memcmp(from, "NV01", 4);
    nvram_load(&nv, from, n);
    need(nvram_is_valid(nv.bytes, nv.s.live) && nv.s.live <= room && nv.s.live >= 4 && (good || nv.s.live == 4));
    if (good && !old)
        need(memcmp(nv.bytes, from, nv.s.live) == 0 && (n > room || nv.s.live == n));
    if (good && old && room == NV_OLD_IMAGE_SIZE)
        compare_old(&nv, from);
    if (good)
        use(&nv);
    need(nvram_is_valid(nv.bytes, nv.s.live) && nv.s.live <= room);
    free(nv.bytes);
    free(copy);
    return 0;
}
