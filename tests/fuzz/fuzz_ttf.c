/*
 * fuzz_ttf.c - libFuzzer: any bytes as a TrueType font, in a size that the first byte says. What is read makes a lump
 * that is taken; what is refused says why.
 */
#include "../../src/rom/face.h"
#include "../../src/workbench/pack/ttf.h"
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct pack_font_chars latin;
    struct pack_font f;
    struct face face;
    char err[256] = "";
    uint8_t *lump, *copy = fuzz_copy(data, size);
    const int px = 1 + (size > 0 ? copy[0] : 0) % TTF_MAX_SIZE;

    memset(latin.bits, 0xff, 32);
    if (size > 0)
        copy[0] = 0; /* of every TrueType font */
    if (ttf_read(&f, copy, size, px, &latin, err, sizeof err)) {
        const size_t n = pack_font_make(&f, &lump);
        need(n > 0 && face_open(&face, lump, n, err, sizeof err) && face.n == (uint32_t)f.n);
        free(lump);
    } else {
        need(strlen(err) > 9);
    }
    pack_font_free(&f);
    free(copy);
    return 0;
}
