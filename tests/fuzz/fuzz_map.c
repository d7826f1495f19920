/*
 * fuzz_map.c - libFuzzer: any bytes as a map. The first byte chooses the reader: a .tmx, one with a layer's name, or
 * CSV whose tiles count from 0 or 1. External tilesets are what stands behind the first 0 of a .tmx, or itself. What is
 * read is made into a lump with a small sheet.
 */
#include "../../src/workbench/pack/map.h"
#include "fuzz.h"

static void make(const struct map_cells *c)
{
    static uint8_t rgba[64 * 64 * 4], rgb[CART_PALETTE_SIZE];
    const struct art_picture sheet = { .rgba = rgba, .w = 64, .h = 64 };
    struct map_picture picture[MAP_MAX_TILESETS];
    char err[256] = "";
    uint8_t *lump = NULL;
    size_t size = 0;

    for (int i = 0; i < (int)sizeof rgba; i++)
        rgba[i] = (uint8_t)(i % 4 == 3 ? i * 7 : 0);
    for (int i = 0; i < c->tilesets; i++) {
        picture[i] = (struct map_picture){ &sheet, "t.png" };
        need(map_check_columns(c, i, &picture[i], err, sizeof err) || err[0]);
    }
    bool good = map_make(c, "m.tmx", c->side ? c->side : 8, picture, 3, rgb, true, &lump, &size, err, sizeof err);
    need(good ? size >= CART_MAP_HEADER_SIZE : err[0] != '\0');
    if (good)
        free(lump);
}

/* Each tileset that is not in the map: what stands behind its first 0. */
struct rest {
    const char *text;
    size_t n;
};

static bool load(void *context, const char *file, uint8_t **text, size_t *n, char *err, size_t err_size)
{
    const struct rest *rest = context;

    (void)err, (void)err_size, (void)file;
    *n = rest->n;
    *text = (uint8_t *)fuzz_text((const uint8_t *)rest->text, rest->n);
    return true;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    size_t n = size > 0 ? size - 1 : 0;
    char *text = fuzz_copy(data + 1, n), err[256] = "";
    const int how = size > 0 ? data[0] % 4 : 0;
    struct map_cells c;

    const char *zero = memchr(text, 0, n);
    const size_t first = zero != NULL ? (size_t)(zero - text) : n;
    struct rest rest = { zero != NULL ? zero + 1 : text, zero != NULL ? n - first - 1 : n };
    const struct map_files files = { load, &rest };
    bool good = how < 2 ? map_read_tmx(text, first, "maps/m.tmx", how ? "a" : "", &files, &c, err, sizeof err)
                        : map_read_csv(text, n, "m.csv", how - 2, &c, err, sizeof err);
    free(text);
    if (good) {
        need(c.tilesets >= 1 && c.tilesets <= MAP_MAX_TILESETS && c.cols >= 1 && c.rows >= 1);
        need((int64_t)c.cols * c.rows <= CART_MAX_MAP_CELLS && c.cell != NULL);
        make(&c);
        free(c.cell);
    } else {
        need(err[0] != '\0' && c.cell == NULL);
    }
    return 0;
}
