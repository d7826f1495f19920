/*
 * fuzz_ase.c - libFuzzer: any bytes as a file of Aseprite's. The first byte says how it is asked for; pixel data that
 * begins with the zlib header is inflated, as it is for a game. What is read becomes sprites: the whole canvas, each
 * tag, and a part of the canvas.
 */
#include <stdio.h>
#include "../../src/workbench/pack/sheet.h"
#include "fuzz.h"

/* Every pixel is looked at, and what came of the slices is in order. */
static void look(const struct ase_sprite *s)
{
    const size_t pixels = (size_t)s->picture.w * (size_t)s->picture.h;
    uint32_t sum = 0;

    need(s->sprite.frames >= 1 && s->sprite.frames <= CART_MAX_FRAMES && s->sprite.frame_ticks >= 1);
    need(s->picture.w == s->sprite.w * s->sprite.frames && s->picture.h == s->sprite.h && s->hit.rows <= 4);
    for (size_t i = 0; i < pixels; i++)
        sum += s->picture.rgba[4 * i] + (s->picture.index != NULL ? s->picture.index[i] : 0u);
    for (uint32_t i = 0; i < s->hit.rows; i++)
        need(s->hit.row[i].a >= 0 && s->hit.row[i].b >= 0);
    need(sum != 1 || pixels <= 1 << 24); /* uses the sum */
}

static void make(const struct sheet *sheet, const struct art_sheet *asked, struct art_sprite sprite)
{
    static uint8_t rgb[CART_PALETTE_SIZE];
    struct ase_sprite made;
    char err[256] = "";
    uint8_t *lump = NULL;
    size_t size;

    sprite.rotations = 1;
    if (!sheet_sprite(sheet, asked, &sprite, &made, err, sizeof err)) {
        need(err[0]);
        return;
    }
    look(&made);
    bool good = art_make_sprite(&made.picture, &made.sprite, 0, rgb, true, &lump, &size, NULL, err, sizeof err);
    need(good ? size >= CART_GFX_HEADER_SIZE : err[0] != '\0');
    free(lump);
    sheet_sprite_close(sheet, &made);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct art_sheet asked = { .file = "a.ase", .by_index = size > 0 && data[0] & 1 };
    struct art_sprite all = { .scale_percent = size > 0 && data[0] & 2 ? 150 : 100 };
    struct art_sprite part = { .x = 1, .y = 1, .w = 2, .h = 2, .scale_percent = 100, .frame_ticks = 3 };
    char err[256] = "";
    struct sheet sheet;

    if (size < 1)
        return 0;
    if (sheet_read(&sheet, &asked, data + 1, size - 1, err, sizeof err)) {
        make(&sheet, &asked, all);
        make(&sheet, &asked, part);
        for (int i = 0; i < sheet.ase.n_tags && i < 8; i++) {
            memcpy(all.tag, sheet.ase.tags[i].name, sizeof all.tag);
            make(&sheet, &asked, all);
        }
    } else {
        need(err[0]);
    }
    sheet_close(&sheet);
    return 0;
}
