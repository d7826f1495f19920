/* test_map.c - map.h: CSV and Tiled's maps, good and bad, and the lump with its turned tiles. */
#include "../test.h"
#include "../../src/base/bytes.h"
#include "../../src/workbench/pack/map.h"

static char err[256];

static bool csv(const char *text, int first, struct map_cells *c)
{
    err[0] = '\0';
    return map_read_csv(text, strlen(text), "m.csv", first, c, err, sizeof err);
}

/* The game's other files. */
static const char *const files[][2] = {
    { "maps/plain.tsx", "<?xml version=\"1.0\"?>\n<tileset name=\"p\" tilewidth=\"16\" tileheight=\"16\" spacing=\"1\" "
                        "margin=\"2\" tilecount=\"8\" columns=\"4\"><image source=\"../art/p.png\" width=\"71\" "
                        "height=\"37\"/></tileset>" },
    { "t.tsx", "<tileset><image source=\"up/../t.png\"/></tileset>" },
    { "shifted.tsx", "<tileset>\n<tileoffset x=\"0\" y=\"-6\"/></tileset>" },
    { "map.tsx", "<map/>" },
};

static bool load(void *context, const char *file, uint8_t **text, size_t *n, char *why, size_t why_size)
{
    (void)context;
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        if (strcmp(files[i][0], file) == 0) {
            *n = strlen(files[i][1]);
            *text = malloc(*n + 1);
            memcpy(*text, files[i][1], *n + 1);
            return true;
        }
    snprintf(why, why_size, "%s does not exist", file);
    return false;
}

static bool tmx_at(const char *file, const char *text, const char *layer, struct map_cells *c)
{
    const struct map_files all = { load, NULL };

    err[0] = '\0';
    return map_read_tmx(text, strlen(text), file, layer, &all, c, err, sizeof err);
}

static bool tmx(const char *text, const char *layer, struct map_cells *c)
{
    return tmx_at("m.tmx", text, layer, c);
}

static void cells_are(const struct map_cells *c, int cols, int rows, const uint32_t *cell)
{
    assert_int_equal(c->cols, cols);
    assert_int_equal(c->rows, rows);
    assert_memory_equal(c->cell, cell, (size_t)(cols * rows) * sizeof *cell);
    free(c->cell);
}

/* ---- CSV ---- */

TEST(csv)
{
    static const uint32_t cells[] = { 1, 0, 3, 40, 5, 6 };
    struct map_cells c;

    assert_true(csv(" 1 ,0,\t3,\r\n40,5,6\r\n\n \n", 1, &c));
    cells_are(&c, 3, 2, cells);
    assert_true(csv("0,-1,2\n39,4,5", 0, &c));
    cells_are(&c, 3, 2, cells);
}

/* Tiled's export has the flags of turned tiles in the number, which may be written as a negative one. */
TEST(csv_turns)
{
    static const uint32_t cells[] = { 1 | MAP_FLIP_X, 2 | MAP_FLIP_Y, 3 | MAP_DIAGONAL,
                                      4 | MAP_FLIP_X | MAP_FLIP_Y | MAP_DIAGONAL };
    struct map_cells c;

    assert_true(csv("-2147483648,1073741825,536870914,3758096387\n", 0, &c));
    cells_are(&c, 4, 1, cells);
    assert_true(csv("2147483649,1073741826,536870915,-536870908\n", 1, &c));
    cells_are(&c, 4, 1, cells);
    assert_false(csv("2147483648\n", 1, &c)); /* a turned nothing */
    assert_false(csv("268435456\n", 0, &c));  /* the flag of hexagonal maps */
}

TEST(csv_bad)
{
    static const struct {
        const char *text;
        int first;
        const char *said;
    } bad[] = {
        { "", 1, "m.csv: expected lines of numbers, got an empty file" },
        { "1,2\n3\n", 1, "m.csv:2: 1 tiles, expected 2, as in the first line" },
        { "1,2\n\n3,4\n", 1, "m.csv:2: blank line between rows" },
        { "1;2\n", 1, "m.csv:1: expected a comma, got byte 59" },
        { "1,,2\n", 1, "m.csv:1: expected an integer, got byte 44" },
        { "1\n-", 1, "m.csv:2: expected an integer, got the end of the file" },
        { "1,-1\n", 1,
          "m.csv:1: expected 0 (empty) or a tile number of at least 1, got -1 (Tiled's CSV counts from 0: add first = "
          "0)" },
        { "0,-2\n", 0, "m.csv:1: expected -1 (empty) or a tile number of at least 0, got -2" },
    };
    struct map_cells c;

    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(csv(bad[i].text, bad[i].first, &c));
        assert_string_equal(err, bad[i].said);
        assert_null(c.cell);
    }
}

/* ---- Tiled's ---- */

#define HEAD                                                                                                           \
    "<?xml version=\"1.0\"?>\n<map orientation=\"orthogonal\" width=\"3\" height=\"2\" tilewidth=\"16\" "              \
    "tileheight=\"16\" infinite=\"0\">\n<tileset firstgid=\"1\" source='t.tsx'/>\n"
#define LAYER(name, data) "<layer name=\"" name "\" width=\"3\" height=\"2\">" data "</layer>\n"
#define CSV(text)         "<data encoding=\"csv\">" text "</data>"

TEST(tmx)
{
    static const uint32_t cells[] = {
        1, 0, 3, 7 | MAP_FLIP_X, 8 | MAP_FLIP_Y, 9 | MAP_DIAGONAL | MAP_FLIP_X | MAP_FLIP_Y
    };
    struct map_cells c;

    assert_true(tmx(HEAD LAYER("a", CSV("\n1,0,3,\n2147483655,1073741832,3758096393\n")) "</map>", "", &c));
    assert_int_equal(c.side, 16);
    cells_are(&c, 3, 2, cells);
    assert_true(tmx(HEAD "<!-- <layer> -->" LAYER("b", CSV("0,0,0,0,0,0"))
                        LAYER("a", "<data><tile gid=\"1\"/><tile/><tile gid='3'></tile>"
                                   "<tile gid=\"2147483655\"/><tile gid=\"1073741832\"/><tile "
                                   "gid=\"3758096393\"/></data>") "<objectgroup><object/></objectgroup></map>",
                    "a", &c));
    cells_are(&c, 3, 2, cells);
}

#define PACKED(kind, text) "<data encoding=\"base64\"" kind ">\n" text "\n</data>"

/* The same cells, packed in each way. */
TEST(tmx_packed)
{
    static const char *const maps[] = {
        HEAD LAYER("a", PACKED("", "AQAAAAAAAAADAAAABwAAgAgAAEAJAADg")) "</map>",
        HEAD LAYER("a", PACKED(" compression=\"zlib\"", "eJxjZIAAZiBmZ2Bo4GBgcOBkYHgAAAe4Ab0=")) "</map>",
        HEAD LAYER(
            "a", PACKED(" compression=\"gzip\"", "H4sICAAAAAAC/24AY2SAAGYgZmdgaOBgYHDgZGB4AAA7HPVPGAAAAA==")) "</map>",
    };
    static const uint32_t cells[] = {
        1, 0, 3, 7 | MAP_FLIP_X, 8 | MAP_FLIP_Y, 9 | MAP_DIAGONAL | MAP_FLIP_X | MAP_FLIP_Y
    };
    struct map_cells c;

    for (size_t i = 0; i < sizeof maps / sizeof *maps; i++) {
        const bool read = tmx(maps[i], "", &c);
        assert_string_equal(err, "");
        assert_true(read);
        cells_are(&c, 3, 2, cells);
    }
}

#define ENDLESS                                                                                                        \
    "<map width=\"30\" height=\"20\" tilewidth=\"8\" tileheight=\"8\" infinite=\"1\"><tileset firstgid=\"1\"/>"
#define CHUNK(x, y, data) "<chunk x=\"" x "\" y=\"" y "\" width=\"2\" height=\"2\">" data "</chunk>"

/* An infinite map is as large as its tiles need. */
TEST(tmx_infinite)
{
    struct map_cells c;

    assert_true(tmx(ENDLESS LAYER("a", "<data encoding=\"csv\">" CHUNK("-2", "-4", "0,0,0,1")
                                           CHUNK("0", "-4", "0,0,0,0") CHUNK("0", "-2", "0,2,3,0") "</data>") "</map>",
                    "", &c));
    cells_are(&c, 3, 3, (const uint32_t[]){ 1, 0, 0, 0, 0, 2, 0, 3, 0 });
    assert_true(
        tmx(ENDLESS LAYER("a", "<data>" CHUNK("7", "8", "<tile/><tile gid=\"2\"/><tile/><tile/>") "</data>") "</map>",
            "", &c));
    cells_are(&c, 1, 1, (const uint32_t[]){ 2 });
    assert_false(
        tmx(ENDLESS LAYER("a", "<data encoding=\"csv\">" CHUNK("0", "0", "0,0,0,0") "</data>") "</map>", "", &c));
    assert_string_equal(err, "m.tmx:1: the layer has no tiles");
    assert_false(tmx(ENDLESS LAYER("a", "<data encoding=\"csv\">" CHUNK("0", "0", "1,0,0,0")
                                            CHUNK("9000", "0", "1,0,0,0") "</data>") "</map>",
                     "", &c));
    assert_string_equal(err, "m.tmx:1: the layer covers 9001x1 tiles, expected at most 2048 in each direction");
}

/* What stands in a .tsx counts as if it were in the map. */
TEST(tmx_external)
{
    static const char map[] =
        "<map width=\"2\" height=\"1\" tilewidth=\"16\" tileheight=\"16\">"
        "<tileset firstgid=\"1\" source=\"plain.tsx\"/>\n<tileset firstgid=\"9\" source=\"../t.tsx\"/>"
        "\n<layer width=\"2\" height=\"1\"><data encoding=\"csv\">%s</data></layer></map>";
    struct map_cells c;
    char text[1024];

    snprintf(text, sizeof text, map, "3,0");
    assert_true(tmx_at("maps/m.tmx", text, "", &c));
    assert_true(c.tilesets == 1 && c.match_pictures && c.tileset[0].spacing == 1 && c.tileset[0].margin == 2);
    assert_true(c.tileset[0].columns == 4 && c.tileset[0].width == 71);
    assert_string_equal(c.tileset[0].picture, "art/p.png");
    assert_string_equal(c.tileset[0].place, "maps/plain.tsx:2");
    cells_are(&c, 2, 1, (const uint32_t[]){ 3, 0 });
    snprintf(text, sizeof text, map, "3,11");
    assert_true(tmx_at("maps/m.tmx", text, "", &c));
    assert_true(c.tilesets == 2 && c.tileset[0].base == 0 && c.tileset[1].base == 3 && c.tileset[1].spacing == 0);
    assert_string_equal(c.tileset[1].picture, "t.png");
    cells_are(&c, 2, 1, (const uint32_t[]){ 3, 6 });
    snprintf(text, sizeof text, map, "0,10");
    assert_true(tmx_at("maps/m.tmx", text, "", &c));
    assert_true(c.tilesets == 1 && c.tileset[0].base == 0);
    assert_string_equal(c.tileset[0].picture, "t.png");
    cells_are(&c, 2, 1, (const uint32_t[]){ 0, 2 });
}

/* What is written in other words, and what is wrong where it does not show. */
TEST(tmx_harmless)
{
    static const uint32_t cells[] = { 1, 2, 3, 4, 5, 6 };
    static const char *const maps[] = {
        "<!DOCTYPE map SYSTEM \"http://mapeditor.org/dtd/1.0/map.dtd\">" HEAD LAYER("a", CSV("1,2,3,4,5,6")) "</map>",
        HEAD
        "<layer name=\"&lt;&#x61;&#226;&amp;&gt;\" width=\"3\" height=\"2\" opacity=\"1.0\" offsetx=\"0\" "
        "tintcolor=\"#ffffff\" mode=\"normal\" locked=\"1\" class='c' id='4'><properties><property name='n'>any text"
        "</property></properties>" CSV("1,2,3,4,5,6") "</layer></map>",
        HEAD
        "<editorsettings><export target='x'/></editorsettings><properties/>"
        "<objectgroup name='o'><properties/><object id='1' x='3' y='4'><point/></object><object gid='2' visible='0'/>"
        "</objectgroup><imagelayer visible='0'><image source='x.png'/></imagelayer>" LAYER("a",
                                                                                           CSV("1,2,3,4,5,6")) "</map>",
        HEAD
        "<tileset firstgid=\"100\" tilewidth=\"32\" tileheight=\"9\" columns=\"0\"><tileoffset x=\"3\" y=\"0\"/>"
        "<tile id=\"0\"><image source=\"0.png\"/></tile><future/></tileset>" LAYER("a", CSV("1,2,3,4,5,6")) "</map>",
        "<map width=\"3\" height=\"2\" tilewidth=\"8\" tileheight=\"8\" backgroundcolor=\"#00ff8000\"><tileset "
        "firstgid=\"1\"><wangsets/><tile id=\"6\" type=\"t\"><animation><frame/></animation></tile><tile id='2'>"
        "<objectgroup/></tile></tileset><group name='g'><group opacity='1'>" LAYER("a",
                                                                                   CSV("1,2,3,4,5,6")) "</group>"
                                                                                                       "</group></map>",
    };
    struct map_cells c;

    for (size_t i = 0; i < sizeof maps / sizeof *maps; i++) {
        const bool read = tmx(maps[i], i == 1 ? "<a\xc3\xa2&>" : "", &c);
        assert_string_equal(err, "");
        assert_true(read);
        cells_are(&c, 3, 2, cells);
    }
    assert_true(tmx(HEAD LAYER("a", CSV("1,2,3,4,5,6")) "<imagelayer/><objectgroup><object gid='2'/></objectgroup>"
                                                        "<layer name='b' opacity='0.5'/></map>",
                    "a", &c));
    cells_are(&c, 3, 2, cells);
}

#define TILESET(attributes, inside)                                                                                    \
    "<map width=\"3\" height=\"2\" tilewidth=\"16\" tileheight=\"16\"><tileset firstgid=\"1\"" attributes ">" inside   \
    "</tileset>" LAYER("a", CSV("0,0,1,0,0,0")) "</map>"

TEST(tmx_bad)
{
    static const struct {
        const char *text, *layer, *said;
    } bad[] = {
        { "", "", "m.tmx: no <map>: not a Tiled map" },
        { HEAD "</map>", "", "m.tmx: no tile layer" },
        { HEAD LAYER("b", CSV("0,0,0,0,0,0")) "</map>", "a", "m.tmx: no tile layer \"a\" (the map has b)" },
        { HEAD LAYER("a", CSV("0,0,0,0,0,0")) LAYER("b", "") "</map>", "",
          "m.tmx:5: more than one tile layer; choose one in rom.lua with layer = \"NAME\"" },
        { HEAD LAYER("a", CSV("0,0,0,0,0,0")) LAYER("a", "") "</map>", "a",
          "m.tmx:5: more than one layer with this name" },
        { "<map orientation=\"isometric\">", "",
          "m.tmx:1: <map> orientation=\"isometric\" is not supported, expected \"orthogonal\"" },
        { "<map infinite=\"2\">", "", "m.tmx:1: <map> infinite: expected a whole number from 0 to 1, got 2" },
        { "<map backgroundcolor=\"#ff8000\">", "",
          "m.tmx:1: <map> backgroundcolor=\"#ff8000\" is not supported; clear it in Tiled's Map Properties" },
        { "<map future=\"1\">", "", "m.tmx:1: <map> future=\"1\" is not supported" },
        { "\n<map width=\"0\">", "", "m.tmx:2: <map> width: expected a whole number from 1 to 2048, got 0" },
        { "<map width=\"3\">", "", "m.tmx:1: <map> height: expected a whole number from 1 to 2048, got nothing" },
        { "<map width=\"3\" height=\"3\" tilewidth=\"16\" tileheight=\"8\">", "",
          "m.tmx:1: tiles of 16x8 px, expected 8x8, 16x16 or 32x32" },
        { HEAD "<future/>", "", "m.tmx:4: <future> is not supported" },
        { HEAD "<imagelayer/>", "",
          "m.tmx:4: image layers are not supported; hide the layer, or choose another in rom.lua with layer = "
          "\"NAME\"" },
        { HEAD "<objectgroup>\n<object gid=\"3\"/>", "",
          "m.tmx:5: tile objects are not supported; put the tile on the layer" },
        { HEAD "<objectgroup><object template=\"a.tx\"/>", "",
          "m.tmx:4: template objects are not supported; detach the template in Tiled" },
        { HEAD "<objectgroup><object><text>hi</text>", "", "m.tmx:4: text objects are not supported" },
        { HEAD "<layer width=\"3\" height=\"2\" opacity=\"0.5\">", "",
          "m.tmx:4: <layer> opacity=\"0.5\" is not supported, expected \"1\"" },
        { HEAD "<layer width=\"2\" height=\"2\">", "",
          "m.tmx:4: <layer> width: expected a whole number from 3 to 3, got 2" },
        { HEAD LAYER("a", "<future/>"), "", "m.tmx:4: <future> in a layer is not supported" },
        { HEAD "<layer width=\"3\" height=\"2\"/>", "", "m.tmx:4: layer without <data>" },
        { HEAD LAYER("a", CSV("0,0,0,0,0,0") "<data/>"), "", "m.tmx:4: more than one <data>" },
        /* tilesets, once the layer has a tile of them */
        { TILESET(" tilewidth=\"32\" tileheight=\"32\"", ""), "",
          "m.tmx:1: tiles of 32x32 px, expected 16x16, as in the map" },
        { TILESET("", "<future/>"), "", "m.tmx:1: <future> in a tileset is not supported" },
        { TILESET("", "<image format=\"png\"><data/></image>"), "",
          "m.tmx:1: <image> without a source: embedded pictures are not supported" },
        { TILESET("", "<tile id=\"0\">\n<animation/></tile>"), "",
          "m.tmx:2: animated tiles are not supported; remove the animation" },
        { TILESET("", "<tile id=\"0\"><image source=\"0.png\"/></tile>"), "",
          "m.tmx:1: image collections are not supported; put the tiles in one picture" },
        { HEAD "<tileset firstgid=\"4\" tilecount=\"2\"/>" LAYER("a", CSV("1,4,5,6,0,0")), "",
          "m.tmx:4: tile 6 does not belong to a tileset: m.tmx:4 has only 2 tiles" },
        { HEAD "<tileset source=\"t.tsx\"/>", "",
          "m.tmx:4: <tileset> firstgid: expected a whole number from 1 to 268435456, got nothing" },
        { HEAD "<tileset firstgid=\"4\" source=\"no.tsx\"/>", "", "m.tmx:4: no.tsx does not exist" },
        { HEAD "<tileset firstgid=\"4\" source=\"map.tsx\"/>", "",
          "map.tsx:1: expected <tileset>; save the tileset in Tiled as .tsx" },
        { HEAD "<tileset firstgid=\"4\" source=\"../t.tsx\"/>", "",
          "m.tmx:4: tileset \"../t.tsx\" is outside the game's folder; move it there, or embed it in the map" },
        { HEAD "<tileset firstgid=\"4\" source=\"C:\\t.tsx\"/>", "",
          "m.tmx:4: tileset \"C:\\t.tsx\" is outside the game's folder; move it there, or embed it in the map" },
        { HEAD "<tileset firstgid=\"4\" source=\"shifted.tsx\"/>" LAYER("a", CSV("0,4,0,0,0,0")), "",
          "shifted.tsx:2: <tileoffset> y=\"-6\" is not supported, expected \"0\"" },
        { "<map width=\"1\" height=\"1\" tilewidth=\"8\" tileheight=\"8\"><layer width=\"1\" height=\"1\"><data "
          "encoding=\"csv\">1"
          "</data>",
          "", "m.tmx:1: tile 1 does not belong to a tileset" },
        /* data */
        { HEAD LAYER("a", "<data encoding=\"base64\" compression=\"zstd\">KLUv</data>"), "",
          "m.tmx:4: zstd compression is not supported; in Tiled's Map Properties, set Tile Layer Format to CSV" },
        { HEAD LAYER("a", "<data encoding=\"csv\" compression=\"zlib\">"), "",
          "m.tmx:4: compressed data must be base64" },
        { HEAD LAYER("a", "<data encoding=\"hex\">"), "",
          "m.tmx:4: <data> encoding=\"hex\" is not supported, expected \"csv\"" },
        { HEAD LAYER("a", PACKED("", "AQ=A")), "", "m.tmx:4: invalid base64" },
        { HEAD LAYER("a", PACKED("", "AQAAAA==")), "", "m.tmx:4: 4 bytes of tiles, expected 24" },
        { HEAD LAYER("a", PACKED(" compression=\"zlib\"", "eJxjZIAAZiBmZ2Bo4GBgcOBkYHjAiEMcADkQA3k=")), "",
          "m.tmx:4: the data does not decompress to 6 tiles" },
        { HEAD LAYER(
              "a",
              PACKED(" compression=\"zlib\"",
                     "eJztwTEBAAAAwqD1T20ND6AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
                     "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAACAVwOGrwAB")),
          "", "m.tmx:4: the data does not decompress to 6 tiles" },
        { HEAD LAYER("a", PACKED(" compression=\"gzip\"", "H4sICAAAAAAC/24AY2SAAGYgZmdgaOBgYHDgZGB4AAA6HPVPGAAAAA==")),
          "", "m.tmx:4: the data does not decompress to 6 tiles" },
        { HEAD LAYER("a", CSV("1,2")), "", "m.tmx:4: 2 tiles, expected 6 (3x2)" },
        { HEAD LAYER("a", CSV("1,2,3,4,5,6,7")), "", "m.tmx:4: more than 6 tiles" },
        { HEAD LAYER("a", CSV("1,2\n,,3")), "", "m.tmx:5: expected a tile number" },
        { HEAD LAYER("a", CSV("1 2")), "", "m.tmx:4: expected a comma between tiles" },
        { HEAD LAYER("a", CSV("268435457")), "", "m.tmx:4: expected a tile number, got 268435457" },
        { HEAD LAYER("a", "<data><chunk/></data>"), "", "m.tmx:4: expected <tile gid=\"...\"/>, got <chunk>" },
    };
    struct map_cells c;

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

TEST(lump)
{
    uint32_t cell[] = { 1, 1, 0, 2, 2 | MAP_FLIP_X, 0, 0, 0, 0, 0 };
    struct map_cells c = { .cols = 5, .rows = 2, .cell = cell, .tilesets = 1 };
    uint8_t rgb[CART_PALETTE_SIZE], *lump;
    size_t size;

    art_default_palette(rgb);
    struct art_picture sheet = sheet_of(rgb);
    const struct map_picture picture[MAP_MAX_TILESETS] = { { &sheet, "t.png" } };
    for (uint32_t k = 1; k < 5; k++)
        cell[5 + k] = 1 | (k & 1 ? MAP_FLIP_X : 0) | (k & 2 ? MAP_FLIP_Y : 0) | (k & 4 ? MAP_DIAGONAL : 0);
    assert_true(map_make(&c, "m.tmx", 8, picture, 5, rgb, false, &lump, &size, err, sizeof err));
    const int tiles = bytes_get16(lump + 6);
    assert_true(bytes_get16(lump) == 5 && bytes_get16(lump + 2) == 2 && bytes_get16(lump + 4) == 8);
    assert_true(tiles == 1 + 1 + 2 + 4 && bytes_get16(lump + 8) == 5 && bytes_get16(lump + 10) == 0);
    assert_int_equal(size, CART_MAP_HEADER_SIZE + 20 + tiles * 65);
    const uint8_t *cells = lump + CART_MAP_HEADER_SIZE, *solid = cells + 20, *pix = solid + tiles;
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
    assert_false(map_make(&c, "m.tmx", 8, picture, 6, rgb, false, &lump, &size, err, sizeof err));
    assert_non_null(strstr(err, "is not in bank 6"));
    free(sheet.rgba);
}

/* Two pictures of tiles: in the first they are 3 px apart and 2 px from its border; tile k is all of shade k + 1. */
TEST(lump_sheets)
{
    uint32_t cell[] = { 1, 4, 5, 6 };
    struct map_cells c = { .cols = 4, .rows = 1, .side = 8, .cell = cell, .tilesets = 2 };
    struct art_picture a = { .rgba = calloc(25 * 24, 4), .w = 25, .h = 24 },
                       b = { .rgba = calloc(16 * 8, 4), .w = 16, .h = 8 };
    const struct map_picture picture[MAP_MAX_TILESETS] = { { &a, "a.png" }, { &b, "b.png" } };
    uint8_t rgb[CART_PALETTE_SIZE], *lump;
    size_t size;

    art_default_palette(rgb);
    c.tileset[0].spacing = 3;
    c.tileset[0].margin = 2;
    c.tileset[1].base = 4;
    for (int k = 0; k < 6; k++)
        for (int i = 0; i < 64; i++) {
            const struct art_picture *p = k < 4 ? &a : &b;
            const int x = k < 4 ? 2 + k % 2 * 11 : (k - 4) * 8, y = k < 4 ? 2 + k / 2 * 11 : 0;
            uint8_t *at = p->rgba + 4 * ((y + i / 8) * p->w + x + i % 8);
            memcpy(at, rgb + 3 * (k + 1), 3);
            at[3] = 255;
        }
    assert_true(map_make(&c, "m.tmx", 8, picture, 0, rgb, false, &lump, &size, err, sizeof err));
    const uint8_t *cells = lump + CART_MAP_HEADER_SIZE, *pix = cells + 8 + 5;
    assert_int_equal(bytes_get16(lump + 6), 5);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 64; k++)
            assert_int_equal(pix[64 * bytes_get16(cells + 2 * i) + k], cell[i]);
    free(lump);
    cell[3] = 7;
    assert_false(map_make(&c, "m.tmx", 8, picture, 0, rgb, false, &lump, &size, err, sizeof err));
    assert_string_equal(err, "m.tmx: column 4, row 1: tile 3, but the sheet has 2 tiles of 8x8 px");
    snprintf(c.tileset[0].place, sizeof c.tileset[0].place, "t.tsx:2");
    c.tileset[0].columns = 2;
    c.tileset[0].width = 24; /* a px less at the right is no column less */
    assert_true(map_check_columns(&c, 0, &picture[0], err, sizeof err));
    assert_true(map_check_columns(&c, 1, &picture[1], err, sizeof err));
    c.tileset[0].width = 20;
    assert_false(map_check_columns(&c, 0, &picture[0], err, sizeof err));
    assert_string_equal(err, "t.tsx:2: the tileset's picture is 20 px wide, but a.png is 25 px; open the map in Tiled "
                             "with that picture and save it");
    free(a.rgba);
    free(b.rgba);
}

RUN_TESTS(NULL, NULL)
