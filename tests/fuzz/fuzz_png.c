/*
 * fuzz_png.c - libFuzzer: any bytes as a PNG. Odd inputs go in as they are; for even ones the chunks' CRCs are made
 * good first. A picture that is read must be there to its last pixel.
 */
#include "../../src/base/hash.h"
#include "../../src/player/picture/png.h"
#include "fuzz.h"

static uint32_t be32(const uint8_t *p)
{
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3];
}

static void repair(uint8_t *p, size_t n)
{
    memcpy(p, "\x89PNG\r\n\x1a\n", 8);
    for (size_t at = 8; n - at >= 12; at += 12 + (size_t)be32(p + at)) {
        size_t size = be32(p + at);
        if (size > n - at - 12)
            return;
        uint32_t crc = hash_crc32(p + at + 4, size + 4);
        for (int i = 0; i < 4; i++)
            p[at + 8 + size + (size_t)i] = (uint8_t)(crc >> (24 - 8 * i));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    size_t n = size > 0 ? size - 1 : 0;
    uint8_t *copy = fuzz_copy(data + 1, n), *rgba;
    char err[256] = "";
    int w, h;

    if (n >= 8 && data[0] % 2 == 0)
        repair(copy, n);
    if (png_read(copy, n, &rgba, &w, &h, err, sizeof err)) {
        need(w >= 1 && h >= 1 && (int64_t)w * h <= PNG_MAX_PIXELS);
        need(hash_bytes(0, rgba, (size_t)w * (size_t)h * 4) != 1); /* reads all */
    } else {
        need(err[0] && rgba == NULL);
    }
    free(rgba);
    free(copy);
    return 0;
}
