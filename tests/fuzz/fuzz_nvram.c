/*
 * fuzz_nvram.c - libFuzzer: any bytes as an image of saves and score tables. The first byte says how much room there
 * is; if it is odd the others are the image, else they are edits of a blank one of NV01, so that most are taken:
 *
 *     u16 offset (of the image, modulo its size), u8 count 0..63, count bytes
 *
 * An image that is taken stays one whatever is kept in it; one that is not is as good as a blank one.
 */
#include "../../src/base/bytes.h"
#include "../../src/machine/nvram.h"
#include "fuzz.h"

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

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static uint8_t image[NV_OLD_IMAGE_SIZE];

    if (!size)
        return 0;
    const uint32_t room = 1024u * (1 + data[0] / 2 % 32);
    const bool whole = data[0] % 2;
    struct nvram nv = { .bytes = malloc(room + 1), .s = { .cap = room } };
    uint8_t *copy = fuzz_copy(data + 1, size - 1);
    if (!whole)
        edit(image, copy, size - 1);
    const uint8_t *from = whole ? copy : image;
    const size_t n = whole ? size - 1 : NV_OLD_IMAGE_SIZE;
    const bool good = nvram_is_valid(from, n), old = n == NV_OLD_IMAGE_SIZE && !memcmp(from, "NV01", 4);
    nvram_load(&nv, from, n);
    need(nvram_is_valid(nv.bytes, nv.s.live) && nv.s.live <= room && nv.s.live >= 4 && (good || nv.s.live == 4));
    if (good && !old)
        need(memcmp(nv.bytes, from, nv.s.live) == 0 && (n > room || nv.s.live == n));
    if (good)
        use(&nv);
    need(nvram_is_valid(nv.bytes, nv.s.live) && nv.s.live <= room);
    free(nv.bytes);
    free(copy);
    return 0;
}
