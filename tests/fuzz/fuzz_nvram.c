/*
 * fuzz_nvram.c - libFuzzer: any bytes as an image of saves and score tables. Odd inputs are the image; even ones are
 * edits of a blank one, so that most are taken:
 *
 *     u16 offset (of the image, modulo its size), u8 count 0..63, count bytes
 *
 * An image that is taken stays one whatever is kept in it; one that is not is as good as a blank one.
 */
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "../../src/base/bytes.h"
#include "../../src/chips/nvram.h"

static void need(bool good)
{
    if (!good)
        abort();
}

static void edit(uint8_t *image, const uint8_t *data, size_t size)
{
    memset(image, 0, NV_BYTES);
    memcpy(image, "NV01", 4);
    for (size_t at = 0; size - at >= 3;) {
        size_t to = bytes_get16(data + at) % NV_BYTES, n = data[at + 2] % 64u;
        at += 3;
        n = n < size - at ? n : size - at;
        n = n < NV_BYTES - to ? n : NV_BYTES - to;
        if (n)
            memcpy(image + to, data + at, n);
        at += n;
    }
}

/* A value that is read can be kept, and is then the same. */
static void keep_again(struct nvram *nv, const char *key)
{
    struct nv_value v = nvram_get(nv, key);

    need(v.type != NV_NONE && v.type <= NV_BOOL && v.length <= NV_STRING);
    need(nvram_set(nv, key, &v));
    struct nv_value back = nvram_get(nv, key);
    need(back.type == v.type);
    if (v.type == NV_TEXT)
        need(back.length == v.length && memcmp(back.text, v.text, v.length) == 0);
    else
        need(back.bits == v.bits);
}

static void use(struct nvram *nv, const uint8_t *image)
{
    const struct nv_value number = { .type = NV_INT, .bits = 7 };
    char key[NV_KEY + 1], name[NV_NAME + 1];
    int64_t score, above = INT64_MAX;

    for (int i = 0; i < NV_SAVES; i++) {
        memcpy(key, image + 4 + i * 96, sizeof key);
        if (key[0])
            keep_again(nv, key);
    }
    bool kept = nvram_set(nv, "one more", &number);
    need(nvram_get(nv, "one more").type == (kept ? NV_INT : NV_NONE));
    int row = nvram_enter(nv, "table", "me", 1000);
    need(row >= -2 && row < NV_ROWS);
    if (row >= 0)
        need(nvram_row(nv, "table", row, name, &score) && score == 1000 && !strcmp(name, "me"));
    for (int r = 0; r < row && nvram_row(nv, "table", r, name, &score); r++) {
        need(memchr(name, 0, sizeof name) && score >= 1000);
        above = score < above ? score : above;
    }
    need(above >= 1000);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static uint8_t image[NV_BYTES];
    struct nvram nv = { .bytes = malloc(NV_BYTES) };
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
    size_t n = whole ? size - 1 : NV_BYTES;
    bool good = nvram_valid(from, n);
    nvram_load(&nv, from, n);
    need(nvram_valid(nv.bytes, NV_BYTES) && (!good || memcmp(nv.bytes, from, NV_BYTES) == 0));
    if (good)
        use(&nv, from);
    need(nvram_valid(nv.bytes, NV_BYTES));
    free(nv.bytes);
    free(copy);
    return 0;
}
