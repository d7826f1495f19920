/* test_map.c - map.h: CSV and Tiled's maps, good and bad, and the lump with its turned tiles. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../src/base/bytes.h"
#include "../../src/cab/pack/map.h"

static char err[256];

static bool csv(const char *text, int first, struct map_cells *c)
{
    err[0] = '\0';
    return map_read_csv(text, strlen(text), "m.csv", first, c, err, sizeof err);
}

static bool tmx(const char *text, const char *layer, struct map_cells *c)
{
    err[0] = '\0';
    return map_read_tmx(text, strlen(text), "m.tmx", layer, c, err, sizeof err);
}

static void cells_are(const struct map_cells *c, int cols, int rows, const uint32_t *cell)
{
    assert_int_equal(c->cols, cols);
    assert_int_equal(c->rows, rows);
    assert_memory_equal(c->cell, cell, (size_t)(cols * rows) * sizeof *cell);
    free(c->cell);
}

/* ---- CSV ---- */

static void test_csv(void **state)
{
    static const uint32_t cells[] = { 1, 0, 3, 40, 5, 6 };
    struct map_cells c;

    (void)state;
    assert_true(csv("1,0,3\n40,5,6\n", 1, &c));
    cells_are(&c, 3, 2, cells);
    assert_true(csv(" 1 ,0,\t3,\r\n40,5,6\r\n\n \n", 1, &c));
    cells_are(&c, 3, 2, cells);
    assert_true(csv("0,-1,2\n39,4,5", 0, &c));
    cells_are(&c, 3, 2, cells);
}

static void test_csv_bad(void **state)
{
    static const struct {
        const char *text;
        int first;
        const char *said;
    } bad[] = {
        { "", 1, "m.csv: expected lines of numbers, got none" },
        { "\n\n", 1, "m.csv: expected lines of numbers, got none" },
        { "1,2\n3\n", 1, "m.csv:2: 1 tiles, expected 2 as in the first line" },
        { "1,2\n\n3,4\n", 1, "m.csv:2: an empty line amid the others" },
        { "1;2\n", 1, "m.csv:1: expected a comma, got the byte 59" },
        { "1,x\n", 1, "m.csv:1: expected a whole number, got the byte 120" },
        { "1,,2\n", 1, "m.csv:1: expected a whole number, got the byte 44" },
        { "1\n-", 1, "m.csv:2: expected a whole number, got the file's end" },
        { "1,-1\n", 1,
          "m.csv:1: expected 0 for empty or a tile from 1 on, got -1 (Tiled's CSV counts from 0: write first = 0)" },
        { "0,-2\n", 0, "m.csv:1: expected -1 for empty or a tile from 0 on, got -2" },
        { "9999999999\n", 1, "m.csv:1: expected 0 for empty or a tile from 1 on, got 9999999999" },
    };
    struct map_cells c;

    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(csv(bad[i].text, bad[i].first, &c));
        assert_string_equal(err, bad[i].said);
        assert_null(c.cell);
    }
}

/* ---- Tiled's ---- */

#define HEAD                                                                                                           \
    "<?xml version=\"1.0\"?>\n<map orientation=\"orthogonal\" width=\"3\" height=\"2\" tilewidth=\"16\" "              \
    "tileheight=\"16\" infinite=\"0\">\n<tileset firstgid=\"1\" source='a.tsx'/>\n"
#define LAYER(name, data) "<layer name=\"" name "\" width=\"3\" height=\"2\">" data "</layer>\n"
#define CSV(text)         "<data encoding=\"csv\">" text "</data>"

static void test_tmx(void **state)
{
    static const uint32_t cells[] = {
        1, 0, 3, 7 | MAP_FLIP_X, 8 | MAP_FLIP_Y, 9 | MAP_DIAGONAL | MAP_FLIP_X | MAP_FLIP_Y
    };
    struct map_cells c;

    (void)state;
    assert_true(tmx(HEAD LAYER("a", CSV("\n1,0,3,\n2147483655,1073741832,3758096393\n")) "</map>", "", &c));
    assert_int_equal(c.side, 16);
    cells_are(&c, 3, 2, cells);
    assert_true(tmx(HEAD "<!-- <layer> -->" LAYER("b", CSV("0,0,0,0,0,0"))
                        LAYER("a", "<data><tile gid=\"1\"/><tile/><tile gid='3'></tile>"
                                   "<tile gid=\"2147483655\"/><tile gid=\"1073741832\"/><tile "
                                   "gid=\"3758096393\"/></data>") "<objectgroup><object/></objectgroup></map>",
                    "a", &c));
    cells_are(&c, 3, 2, cells);
    assert_true(tmx("<map width=\"1\" height=\"1\" tilewidth=\"8\" tileheight=\"8\"><tileset firstgid=\"5\"/>"
                    "<layer width=\"1\" height=\"1\" opacity=\"1\"><data encoding=\"csv\">6</data></layer></map>",
                    "", &c));
    assert_int_equal(c.side, 8);
    cells_are(&c, 1, 1, (const uint32_t[]){ 2 });
}

static void test_tmx_bad(void **state)
{
    static const struct {
        const char *text, *layer, *said;
    } bad[] = {
        { "", "", "m.tmx: there is no <map>: not a map of Tiled's" },
        { "words", "", "m.tmx: there is no <map>: not a map of Tiled's" },
        { HEAD "</map>", "", "m.tmx: there is no layer of tiles" },
        { HEAD LAYER("b", CSV("0,0,0,0,0,0")) "</map>", "a", "m.tmx: there is no layer of tiles \"a\" (there is b)" },
        { HEAD LAYER("a", CSV("0,0,0,0,0,0")) LAYER("b", "") "</map>", "",
          "m.tmx:5: a second layer of tiles: say in rom.lua which, layer = \"NAME\"" },
        { "<map orientation=\"isometric\">", "", "m.tmx:1: the map is isometric; only orthogonal maps are read" },
        { "<map infinite=\"1\">", "", "m.tmx:1: the map is infinite (Tiled: Map Properties, Infinite off)" },
        { "\n<map width=\"0\">", "", "m.tmx:2: <map> width: expected a whole number from 1 to 2048, got 0" },
        { "<map width=\"3\" height=\"x\">", "",
          "m.tmx:1: <map> height: expected a whole number from 1 to 2048, got x" },
        { "<map width=\"3\" height=\"3\" tilewidth=\"16\" tileheight=\"8\">", "",
          "m.tmx:1: tiles of 16x8 px, expected 8x8, 16x16 or 32x32" },
        { HEAD "<tileset firstgid=\"9\"/>", "", "m.tmx:4: a second tileset: all tiles of a map stand on one sheet" },
        { "<map width=\"3\" height=\"3\" tilewidth=\"8\" tileheight=\"8\"><tileset firstgid=\"1\" margin=\"1\">", "",
          "m.tmx:1: a tileset with margin is not read: tiles stand side by side" },
        { HEAD "<group>", "", "m.tmx:4: layers in groups are not read" },
        { HEAD LAYER("a", "<data encoding=\"base64\" compression=\"zlib\">eJw=</data>"), "",
          "m.tmx:4: data in base64 is not read (Tiled: Map Properties, Tile Layer Format: CSV)" },
        { HEAD "<layer width=\"3\" height=\"2\" offsetx=\"4\">", "", "m.tmx:4: offsetx of a layer is not read" },
        { HEAD "<layer width=\"2\" height=\"2\">", "",
          "m.tmx:4: <layer> width: expected a whole number from 3 to 3, got 2" },
        { HEAD "<layer width=\"3\" height=\"2\">", "", "m.tmx:4: a layer without <data>" },
        { HEAD LAYER("a", CSV("1,2")), "", "m.tmx:4: 2 tiles, expected 6 (3x2)" },
        { HEAD LAYER("a", CSV("1,2,3,4,5,6,7")), "", "m.tmx:4: more tiles than 3x2" },
        { HEAD LAYER("a", CSV("1,2\n,,3")), "", "m.tmx:5: expected a tile's number" },
        { HEAD LAYER("a", CSV("1 2")), "", "m.tmx:4: expected a comma between tiles" },
        { HEAD LAYER("a", CSV("4294967296")), "", "m.tmx:4: expected a tile's number, got 4294967296" },
        { HEAD LAYER("a", CSV("268435457")), "", "m.tmx:4: expected a tile's number, got 268435457" },
        { HEAD LAYER("a", "<data><chunk/></data>"), "", "m.tmx:4: chunks of an infinite map are not read" },
        { HEAD LAYER("a", "<data><tile gid=\"1\"/>"), "", "m.tmx:4: expected <tile gid=\"...\"/>" },
        { HEAD "<layer width=\"3\" height=\"2\"><data>", "", "m.tmx:4: <data> has no end" },
        { "<map", "", "m.tmx:1: a tag without its >" },
        { "<map width>", "", "m.tmx:1: expected an attribute, name=\"value\"" },
        { "<map width=3>", "", "m.tmx:1: expected a value in quotes" },
        { "<map\nwidth=\"3>", "", "m.tmx:2: a value in quotes has no end" },
        { "<!-- ", "", "m.tmx:1: a comment has no end" },
        { "<!DOCTYPE x>", "", "m.tmx:1: a <!...> is not read: this does not look like a map of Tiled's" },
        { "< >", "", "m.tmx:1: expected a tag's name behind <" },
        { "<layer>", "", "m.tmx:1: a layer outside of <map>" },
        { "<map width=\"1\" height=\"1\" tilewidth=\"8\" tileheight=\"8\"><layer width=\"1\" height=\"1\"><data>", "",
          "m.tmx:1: a layer without a tileset before it" },
    };
    struct map_cells c;

    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(tmx(bad[i].text, bad[i].layer, &c));
        assert_string_equal(err, bad[i].said);
        assert_null(c.cell);
    }
}

/* ---- the lump ---- */

/* A sheet of two tiles of 8 px: pixel (x, y) of the first has shade 1 + (x + 2 y) % 15; the second is empty but for a
 * corner. */
static struct art_picture sheet_of(const uint8_t *rgb)
{
    struct art_picture p = { .rgba = calloc(16 * 8, 4), .w = 16, .h = 8 };

    for (int y = 0; y < 8; y++)
        for (int x = 0; x < 8; x++) {
            uint8_t *at = p.rgba + 4 * (y * 16 + x);
            memcpy(at, rgb + 3 * (5 * 16 + 1 + (x + 2 * y) % 15), 3);
            at[3] = 255;
        }
    memcpy(p.rgba + 4 * 8, rgb + 3 * (5 * 16 + 4), 3);
    p.rgba[4 * 8 + 3] = 255;
    return p;
}

/* The shade at (x, y) of the first tile as Tiled shows it: mirrored across the diagonal, then across, then down. */
static int turned(uint32_t flips, int x, int y)
{
    x = flips & MAP_FLIP_X ? 7 - x : x;
    y = flips & MAP_FLIP_Y ? 7 - y : y;
    return 1 + (flips & MAP_DIAGONAL ? y + 2 * x : x + 2 * y) % 15;
}

static void test_lump(void **state)
{
    uint32_t cell[] = { 1, 1, 0, 2, 2 | MAP_FLIP_X, 0, 0, 0, 0, 0 };
    struct map_cells c = { 5, 2, 0, cell };
    uint8_t rgb[CART_PALETTE], *lump;
    size_t size;

    (void)state;
    art_default_palette(rgb);
    struct art_picture sheet = sheet_of(rgb);
    for (uint32_t k = 1; k < 5; k++)
        cell[5 + k] = 1 | (k & 1 ? MAP_FLIP_X : 0) | (k & 2 ? MAP_FLIP_Y : 0) | (k & 4 ? MAP_DIAGONAL : 0);
    assert_true(map_make(&c, 8, &sheet, 5, rgb, false, &lump, &size, NULL, err, sizeof err));
    assert_int_equal(bytes_get16(lump), 5);
    assert_int_equal(bytes_get16(lump + 2), 2);
    assert_int_equal(bytes_get16(lump + 4), 8);
    const int tiles = bytes_get16(lump + 6);
    assert_int_equal(tiles, 1 + 1 + 2 + 4);
    assert_int_equal(bytes_get16(lump + 8), 5);
    assert_int_equal(bytes_get16(lump + 10), 0);
    assert_int_equal(size, CART_MAP_HEADER + 20 + tiles * 65);
    const uint8_t *cells = lump + CART_MAP_HEADER, *solid = cells + 20, *pix = solid + tiles;
    assert_int_equal(bytes_get16(cells), bytes_get16(cells + 2));
    assert_int_equal(bytes_get16(cells + 4), 0);
    for (int i = 0; i < 10; i++) {
        const int t = bytes_get16(cells + 2 * i);
        const bool first = (cell[i] & MAP_NUMBER) == 1;
        assert_int_equal(solid[t], first);
        for (int k = 0; k < 64; k++) {
            int want = first ? 5 * 16 + turned(cell[i], k % 8, k / 8) : 0;
            if ((cell[i] & MAP_NUMBER) == 2 && k == (cell[i] & MAP_FLIP_X ? 7 : 0))
                want = 5 * 16 + 4;
            assert_int_equal(pix[64 * t + k], want);
        }
    }
    free(lump);
    cell[3] = 3;
    assert_false(map_make(&c, 8, &sheet, 5, rgb, false, &lump, &size, NULL, err, sizeof err));
    assert_string_equal(err, "column 4 of row 1: tile 3, the sheet has 2 of 8x8 px");
    cell[3] = 1;
    assert_false(map_make(&c, 8, &sheet, 6, rgb, false, &lump, &size, NULL, err, sizeof err));
    assert_non_null(strstr(err, "is not in bank 6"));
    free(sheet.rgba);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_csv),     cmocka_unit_test(test_csv_bad), cmocka_unit_test(test_tmx),
        cmocka_unit_test(test_tmx_bad), cmocka_unit_test(test_lump),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
