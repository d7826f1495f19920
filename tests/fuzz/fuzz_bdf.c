/*
 * fuzz_bdf.c - libFuzzer: any bytes as a BDF font, and as the lump of a font. What is read makes a lump that is taken,
 * in which each character is found; what is refused says why. Of a lump that is taken every pixel can be read.
 */
#include "../../src/rom/face.h"
#include "../../src/workbench/pack/bdf.h"
#include "fuzz.h"

static unsigned look(const struct face *face, uint32_t code)
{
    struct face_glyph g;
    unsigned sum = 0;

    if (!face_find(face, code, &g))
        return 0;
    need(g.w <= g.pitch && g.pitch % 8 == 0 && g.w <= FACE_MAX_SIDE && g.h <= FACE_MAX_SIDE &&
         g.advance <= FACE_MAX_HEIGHT);
    for (int i = 0; i < g.pitch * g.h; i++) {
        need(g.pix[i] <= 15);
        sum += g.pix[i];
    }
    return sum + 1;
}

static void as_lump(const uint8_t *data, size_t size)
{
    char err[256] = "";
    struct face face;

    if (!face_open(&face, data, size, err, sizeof err)) {
        need(err[0]);
        return;
    }
    for (uint32_t code = 0; code < 300; code++)
        look(&face, code);
}

static void as_font(const char *text, size_t n)
{
    static struct pack_font_chars all;
    struct pack_font f;
    struct face face;
    char err[256] = "";
    uint8_t *lump;

    memset(&all, 0xff, sizeof all);
    if (!bdf_read(&f, text, n, &all, err, sizeof err)) {
        need(strlen(err) > 9);
        pack_font_free(&f);
        return;
    }
    need(f.n < 2 || f.list[0].code < f.list[1].code);
    need(pack_font_add_shadow(&f));
    size_t size = pack_font_make(&f, &lump);
    need(size > 0 && face_open(&face, lump, size, err, sizeof err) && face.n == (uint32_t)f.n);
    for (int i = 0; i < f.n; i++)
        need(look(&face, f.list[i].code) > 0);
    free(lump);
    pack_font_free(&f);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    uint8_t *copy = fuzz_copy(data, size);

    as_font((const char *)copy, size);
    as_lump(copy, size);
    free(copy);
    return 0;
}
