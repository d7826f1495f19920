/* test_pack.c - pack.h: folders made in a temporary place, packed, looked at, and unpacked again. */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */
#include "../test.h"
#include <lua.h>
#include "../../platform/platform.h"
#include "../../src/base/bytes.h"
#include "../../src/rom/cart.h"
#include "../../src/script/api/eval.h"
#include "../../src/machine/video/video.h"
#include "../../src/script/std.h"
#include "../../src/workbench/pack/pack.h"
#include "../../src/workbench/pack/blend.h"
#include "../../src/player/picture/shade.h"
#include "../temp.h"
#include "png_file.h"

enum { PATH = 512 };

static char dir[PATH], err[512];

/* ---- a folder ---- */

static int new_folder(void **state)
{
    (void)state;
    err[0] = '\0';
    return temp_folder(dir, sizeof dir, "Pack") ? 0 : -1;
}

static int drop_folder(void **state)
{
    char command[PATH + 16];

    (void)state;
    snprintf(command, sizeof command, "rm -r '%s'", dir);
    return system(command);
}

static const char *in_dir(const char *name)
{
    static char path[PATH + 300];

    snprintf(path, sizeof path, "%s/%s", dir, name);
    return path;
}

static void put_bytes(const char *name, const void *data, size_t size)
{
    assert_true(plat_save(in_dir(name), data, size));
}

static void put_text(const char *name, const char *text)
{
    put_bytes(name, text, strlen(text));
}

static void put_game(const char *manifest)
{
    put_text("rom.lua", manifest);
    put_text("main.lua", "print('hello')\n");
}

/* ---- pictures ---- */

/* A PNG file of RGBA pixels. */
static void put_picture(const char *name, const uint32_t *argb, int w, int h)
{
    const struct png_kind rgba = { w, h, 8, 6, 0 };
    uint8_t *raw = malloc((size_t)h * (1 + 4 * (size_t)w)), *p = raw;
    size_t size;

    for (int y = 0; y < h; y++) {
        *p++ = 0;
        for (int x = 0; x < w; x++, p += 4, argb++)
            png_put32(p, *argb << 8 | *argb >> 24);
    }
    uint8_t *file = png_file(&rgba, raw, (size_t)(p - raw), NULL, 0, &size);
    put_bytes(name, file, size);
    free(file);
    free(raw);
}

/* Palette entry i is #0000ii with the bank in red, but for bank 3's shade 2, which equals its shade 1. */
static uint32_t colour(int i)
{
    return 0xff000000u | (uint32_t)(i / 16 * 16) << 16 | (uint32_t)(i == 0x32 ? 0x31 : i);
}

static void put_palette(const char *name)
{
    uint32_t argb[256];

    for (int i = 0; i < 256; i++)
        argb[i] = colour(i);
    put_picture(name, argb, 16, 16);
}

/* A sheet from a drawing: . is transparent, a letter a shade (a is 1) of bank 3, # a colour of no bank, ~ half
 * transparent. */
static void put_sheet(const char *name, const char *const *rows, int w, int h)
{
    static uint32_t argb[4096];

    for (int i = 0; i < w * h; i++) {
        char c = rows[i / w][i % w];
        argb[i] = c == '.' ? 0x00ff00aau : c == '~' ? 0x7fff00aau : c == '#' ? 0xffff00aau : colour(0x30 + c - 'a' + 1);
    }
    put_picture(name, argb, w, h);
}

/* ---- packing ---- */

/* The ROM that was packed last. */
static struct rom_image image;

static void pack(bool nearest)
{
    rom_image_free(&image);
    err[0] = '\0';
    if (!pack_load_game(dir, nearest, &image, err, sizeof err))
        fail_msg("%s", err);
}

static void refused(const char *line)
{
    uint8_t *bytes;
    size_t size;

    assert_false(pack_folder(dir, false, NULL, NULL, &bytes, &size, err, sizeof err));
    assert_string_equal(err, line);
}

static struct lump find(const char *name)
{
    int i = rom_find(&image.rom, name);
    struct lump l;

    if (i < 0)
        fail_msg("no lump %s", name);
    rom_lump(&image.rom, i, &l);
    return l;
}

static void assert_lump(const char *name, const char *text)
{
    struct lump l = find(name);

    assert_int_equal(l.size, strlen(text));
    assert_memory_equal(l.data, text, l.size);
}

static struct sprite sprite(const char *name)
{
    struct cart cart;
    struct sprite s;

    assert_true(cart_open(&cart, &image.rom, err, sizeof err));
    assert_true(cart_find(&cart, CART_SPRITES, name) >= 0);
    cart_sprite(&cart, cart_find(&cart, CART_SPRITES, name), &s);
    return s;
}

TEST(smallest)
{
    struct cart cart;

    put_game("return {}");
    pack(false);
    assert_true(cart_open(&cart, &image.rom, err, sizeof err));
    assert_lump("script/main.lua", "print('hello')\n");
    assert_int_equal(find("palette/main").size, 768);
    assert_int_equal(find("shades").size, CART_SHADES_SIZE);
    assert_int_equal(cart.n_glyphs, 0);
    assert_int_equal(image.rom.count, 4);
}

TEST(what_goes_in)
{
    put_game("\xef\xbb\xbfreturn { entry = 'boot/start' }");
    put_text("boot/start.lua", "\xef\xbb\xbfreturn 7");
    put_text("stages/deep/one.lua", "return 1");
    put_text("names.txt", "\xef\xbb\xbf"
                          "Ann\r\n");
    put_text("data/x.txt", "");
    put_bytes("demos/attract.demo", "\0\1\2", 3);
    put_text("demos/readme.txt", "hi");
    put_text("other/late.demo", "not packed");
    put_text("tests/broken.lua", "= = =");
    put_text("stages/tests/t.lua", "return 2");
    put_text("README.md", "no");
    put_text(".hidden.lua", "= = =");
    put_text(".git/x.lua", "= = =");
    pack(false);
    assert_lump("script/boot/start.lua", "return 7");
    assert_lump("script/stages/deep/one.lua", "return 1");
    assert_lump("script/stages/tests/t.lua", "return 2");
    assert_lump("data/names.txt", "Ann\r\n");
    assert_lump("data/data/x.txt", "");
    assert_lump("data/demos/readme.txt", "hi");
    assert_int_equal(find("demo/attract").size, 3);
    assert_int_equal(image.rom.count, 11);
}

/* The modules of the library, without their pieces, that a game of this main.lua gets, as lumps: "path prelude". */
static const char *modules_of(const char *text)
{
    static char got[128];
    const char *folder = "script/@std/";

    put_text("main.lua", text);
    pack(false);
    got[0] = '\0';
    for (int i = rom_find_first(&image.rom, folder); i < rom_find_first(&image.rom, "script/@std0"); i++) {
        struct lump l;
        rom_lump(&image.rom, i, &l);
        const char *name = l.name + strlen(folder);
        if (!strchr(name, '/'))
            snprintf(got + strlen(got), sizeof got - strlen(got), "%s%.*s", got[0] ? " " : "", (int)strlen(name) - 4,
                     name);
    }
    return got;
}

static const char every[] = "bg boot boss choose figure fx game hud menu mission path pattern prelude say scoring "
                            "stage sweep talk trail unlock";

/* A module is in the ROM when a script of the game names it, or a module that is. */
TEST(modules)
{
    put_game("return {}");
    assert_string_equal(modules_of("-- pattern, boss\nlocal s = 'path' print(s.stage, s:menu()) s.hud = 1"), "");
    assert_string_equal(modules_of("wait_until(print)"), "prelude");
    assert_string_equal(modules_of("return pattern"), "figure pattern prelude"); /* any field may be read of it */
    assert_string_equal(modules_of("pattern.ring {} local r = pattern . fan"), "pattern prelude");
    assert_string_equal(modules_of("pattern --[[ ! ]] . star {}"), "figure pattern prelude");
    assert_string_equal(modules_of("bullet.fire {} bg.layer(1) score.add(1, 1) spark.burst {}"), "");
    assert_string_equal(modules_of("bullet.sweep {}"), "prelude sweep");
    assert_string_equal(modules_of("local b = bullet"), "prelude sweep");
    assert_string_equal(modules_of("score.rule {}"), "prelude scoring");
    assert_string_equal(modules_of("say(nil, 'a')"), "boss hud path prelude say stage talk");
    assert_string_equal(modules_of("return _ENV['pat' .. 'tern']"), every);
    assert_string_equal(modules_of("return _G"), every);
    assert_string_equal(modules_of("return load('x')"), every);
    put_text("other.lua", "return pattern.ring");
    put_text("tests/not.lua", "return boss");
    put_text("words.txt", "boss");
    assert_string_equal(modules_of("return 1"), "pattern prelude");
}

/* A script in std replaces the library's module or section of that name, and is packed even if nothing uses it. */
TEST(std)
{
    put_game("return {}");
    put_text("std/menu.lua", "return 'mine', path");
    pack(false);
    assert_lump("script/@std/menu.lua", "return 'mine', path");
    assert_int_equal(rom_find(&image.rom, "script/@std/boot/list.lua"), -1);
    assert_string_equal(modules_of("return pattern.arc"), "menu path pattern prelude");
    put_text("std/boot/list.lua", "return 'mine'");
    put_text("main.lua", "return boot.run");
    pack(false);
    assert_lump("script/@std/boot/list.lua", "return 'mine'");
    put_text("std/boot/lists.lua", "return 1");
    refused("std/boot/lists.lua: the standard library has no script with this name");
}

/* A board of the game with this main.lua, until the next one. */
static struct board *power(const char *text)
{
    static void *ram;
    struct board_start start = { .difficulty = -1 };
    size_t size;

    put_text("main.lua", text);
    pack(false);
    assert_true(board_size(&image.rom, &size, err, sizeof err));
    free(ram);
    ram = aligned_alloc(64, (size + 63) / 64 * 64);
    struct board *b = board_power_on(ram, size, &image.rom, &start, err, sizeof err);
    assert_non_null(b);
    if (board_last_output(b)->fault != NULL)
        fail_msg("%s", board_last_output(b)->fault->message);
    return b;
}

/* A line that is typed while the game runs may name a module that the ROM does not have. */
TEST(not_here)
{
    const char *missing =
        "undeclared global \"pattern\" (not packed in this ROM; a library module is packed if a script names it)";
    char out[EVAL_TEXT_SIZE];

    put_palette("p.png");
    put_game("return { palette = 'p.png', sheets = { s = { file = 's.png', bank = 3 } },"
             "  sprites = { a = { sheet = 's', w = 2, h = 1 } } }");
    put_sheet("s.png", (const char *const[]){ "ab" }, 2, 1);
    const char *const lines[][2] = { { "pattern.ring { x = 1, y = 1 }", missing },
                                     { "bullet.sweep { x = 1, y = 1 }", "bullet.sweep: not packed in this ROM" },
                                     { "pattrn.ring { x = 1, y = 1 }", "undeclared global \"pattrn\"" },
                                     { "enemy.spawn { kind = 'fly', path = {} }",
                                       "enemy.spawn: path: expected a route (from path.def)" } };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        struct board *b = power("enemy.def('fly', { sprite = 'a', hp = 5, hit = { circle = 1 } })");
        assert_false(board_eval(b, lines[i][0], out, sizeof out));
        assert_non_null(strstr(out, lines[i][1]));
    }
    struct board *b = power("local t = pattern");
    assert_true(board_eval(b, "pattern ~= nil", out, sizeof out));
    assert_string_equal(out, "true\n");
}

/* A table is that of the game's palette. */
TEST(blends)
{
    struct lump l;

    put_game("return { palette = 'p.png', blends = { glow = 'add', ghost = { mix = 30 } } }");
    put_palette("p.png");
    pack(false);
    l = find("blend/glow");
    assert_int_equal(l.size, CART_BLEND_SIZE);
    assert_int_equal(l.data[0x11 * 256 + 0x21], 0x31); /* #300032: #300031 is as near as #300033 */
    assert_int_equal(l.data[0xf1 * 256 + 0xf1], 0xff); /* #ff00ff */
    l = find("blend/ghost");
    assert_int_equal(l.data[0x12 * 256 + 0x42], 0x21); /* #1e0020: #200020 is never drawn */
    assert_int_equal(l.data[0x42 * 256 + 0x12], 0x34); /* #320034 */
}

/* A palette with the colours of p.png from the other end. */
static void put_turned(const char *name)
{
    uint32_t argb[256];

    for (int i = 0; i < 256; i++)
        argb[i] = colour(255 - i);
    put_picture(name, argb, 16, 16);
}

/* A palette has tables of its own where they differ from those of the first; one of the same colours, and a blend of
 * ramps, have none. */
TEST(own_tables)
{
    uint8_t *table = malloc(CART_BLEND_SIZE), shades[CART_SHADES_SIZE];

    put_game("return { palette = 'p.png', palettes = { dusk = 'd.png', same = 'p.png' },"
             "  blends = { glow = 'add', ramp = { ramp = 'add' } } }");
    put_palette("p.png");
    put_turned("d.png");
    pack(false);
    const uint8_t *dusk = find("palette/dusk").data, *main = find("palette/main").data;
    for (int i = 0; i < 256; i++)
        assert_int_equal(main[i * 3] << 16 | main[i * 3 + 1] << 8 | main[i * 3 + 2], colour(i) & 0xffffff);
    assert_non_null(table);
    assert_true(blend_make(dusk, BLEND_ADD, table));
    assert_memory_equal(find("blends/dusk/glow").data, table, CART_BLEND_SIZE);
    assert_true(blend_make(main, BLEND_ADD, table));
    assert_memory_equal(find("blend/glow").data, table, CART_BLEND_SIZE);
    shade_make(dusk, shades);
    assert_memory_equal(find("shade/dusk").data, shades, CART_SHADES_SIZE);
    assert_int_equal(rom_find(&image.rom, "shade/same"), -1);
    assert_int_equal(rom_find(&image.rom, "blends/same/glow"), -1);
    assert_int_equal(rom_find(&image.rom, "blends/dusk/ramp"), -1);
    free(table);
}

/* Tables and fog after these lines are those of that palette. */
static void shown_as(const char *lines, const char *palette)
{
    static uint8_t fog[BG_SHADES * 256];
    struct board *b = power(lines);

    assert_string_equal(cart_name(&b->cart, CART_PALETTES, board_loaded_palette(b)), palette);
    const struct cart_colour_tables look = video_get_palette_tables(b);
    const bool main = !strcmp(palette, "main");
    assert_ptr_equal(look.shades, find(main ? "shades" : "shade/dusk").data);
    assert_ptr_equal(look.blend[0], find(main ? "blend/glow" : "blends/dusk/glow").data);
    bg_fill_shades(fog, cart_palette(&b->cart, palette), 0x123456);
    assert_memory_equal(b->bg_shades.table + BG_FOG_OFFSET, fog, sizeof fog);
}

TEST(loaded)
{
    put_game("return { palette = 'p.png', palettes = { dusk = 'd.png' }, blends = { glow = 'add' },"
             "  maps = { m = { tiles = 's.png', bank = 3, rows = { { 1 } } } } }");
    put_palette("p.png");
    put_turned("d.png");
    put_picture("s.png", (uint32_t[256]){ 0 }, 16, 16);
#define FOG "bg.plane().fog = { to = 0x123456, far = 100 } "
    shown_as(FOG, "main");
    shown_as("palette.load('dusk') " FOG, "dusk");
    shown_as(FOG "palette.load('dusk')", "dusk");
    shown_as("palette.load('dusk') " FOG "palette.load('main')", "main");
    shown_as(FOG "palette.fade { to = 'dusk', over = 20 }", "dusk");
    shown_as("palette.load('dusk') " FOG "palette.fade { to = 0xffffff, over = 20 }", "dusk");
    shown_as("palette.load('dusk') " FOG "palette.fade { to = 0, over = 20 } palette.set(33, 0)", "dusk");
}

static const char art_manifest[] =
    "return { palette = 'p.png', sheets = { s = { file = 'art/s.png', bank = 3 } }, sprites = {\n"
    "  two = { sheet = 's', x = 1, y = 1, w = 3, h = 2, frames = 2, every = 9, origin = { -1, 2 } } } }";

TEST(sprite)
{
    static const uint8_t want[4][8] = { { 0x31, 0, 0x33 }, { 0x3f }, { 0, 0x35 }, { 0, 0, 0x31 } };
    struct sprite s;

    put_game(art_manifest);
    put_palette("p.png");
    put_sheet("art/s.png", (const char *const[]){ "########", "#a~c.e.#", "#o....b#" }, 8, 3);
    pack(false);
    s = sprite("two");
    assert_true(s.w == 3 && s.h == 2 && s.pitch == 8 && s.ox == -1 && s.oy == 2);
    assert_true(s.frames == 2 && s.frame_ticks == 9 && s.rotations == 1 && s.bank == 3);
    assert_memory_equal(s.pix, want, sizeof want); /* b has the colour of a: the lowest shade is taken */
    put_sheet("art/s.png", (const char *const[]){ "........", ".aaaaaa.", ".aaaa#a." }, 8, 3);
    pack(true);
    assert_int_equal(sprite("two").pix[3 * 8 + 1], 0x3f); /* #30003f is nearest to #ff00aa */
}

/* The shade of the first pixel of cell i of a map with 8 px tiles. */
static int map_shade(const char *name, int i)
{
    const uint8_t *p = find(name).data, *cells = p + CART_MAP_HEADER_SIZE;
    const int n = bytes_get16(p) * bytes_get16(p + 2), tiles = bytes_get16(p + 6);

    return cells[2 * n + tiles + 64 * bytes_get16(cells + 2 * i)] % 16;
}

#define MAP_OF(tilesets, cells)                                                                                        \
    "\xef\xbb\xbf<map width='2' height='1' tilewidth='8' tileheight='8'>\n" tilesets                                   \
    "<layer width='2' height='1'><data encoding='csv'>" cells "</data></layer></map>"

/* A map's tilesets are in files of their own, and its tiles on several pictures. */
TEST(maps)
{
    static const char *const one[] = { "ccccccccccccccccccc", "cddddddddcaaaaaaaac", "cddddddddcaaaaaaaac",
                                       "cddddddddcaaaaaaaac", "cddddddddcaaaaaaaac", "cddddddddcaaaaaaaac",
                                       "cddddddddcaaaaaaaac", "cddddddddcaaaaaaaac", "cddddddddcaaaaaaaac",
                                       "ccccccccccccccccccc" },
                             *const two[] = { "eeeeeeee", "eeeeeeee", "eeeeeeee", "eeeeeeee",
                                              "eeeeeeee", "eeeeeeee", "eeeeeeee", "eeeeeeee" };

    put_palette("p.png");
    put_sheet("art/one.png", one, 19, 10);
    put_sheet("art/two.png", two, 8, 8);
    put_text("sets/one.tsx", "\xef\xbb\xbf<tileset tilewidth='8' tileheight='8' spacing='1' margin='1' columns='2'>"
                             "<image source='../art/one.png' width='19' height='10'/></tileset>");
    put_text("sets/two.tsx", "<tileset><image source='../art/two.png'/></tileset>");
    put_text("maps/m.tmx", MAP_OF("<tileset firstgid='1' source='../sets/one.tsx'/>", "1,2"));
    put_game("return { palette = 'p.png', maps = { m = { tiles = 'art/one.png', bank = 3, file = 'maps/m.tmx' } } }");
    pack(false);
    assert_int_equal(map_shade("map/m", 0), 4);
    assert_int_equal(map_shade("map/m", 1), 1);

    put_text("maps/m.tmx", MAP_OF("<tileset firstgid='1' source='../sets/two.tsx'/>"
                                  "<tileset firstgid='11' source='../sets/one.tsx'/>",
                                  "11,12"));
    pack(false); /* the unused tileset does not matter */
    assert_int_equal(map_shade("map/m", 1), 1);
    put_text("maps/m.tmx", MAP_OF("<tileset firstgid='1' source='../sets/two.tsx'/>"
                                  "<tileset firstgid='11' source='../sets/one.tsx'/>",
                                  "1,12"));
    refused("sets/two.tsx:1: the map uses tiles from art/two.png; add it to `tiles` of map \"m\" in rom.lua");
    put_game("return { palette = 'p.png', maps = { m = { tiles = { 'art/one.png', 'art/two.png' }, bank = 3,"
             "  file = 'maps/m.tmx' } } }");
    pack(false);
    assert_int_equal(map_shade("map/m", 0), 5);
    assert_int_equal(map_shade("map/m", 1), 1);

    put_text("sets/one.tsx", "<tileset columns='3'><image source='../art/one.png'/></tileset>");
    refused("sets/one.tsx:1: the tileset has 3 columns, but art/one.png has 2; open the map in Tiled with that picture "
            "and save it");
    put_text("maps/m.tmx", MAP_OF("<tileset firstgid='1' source='../sets/three.tsx'/>", "1,0"));
    refused("maps/m.tmx:2: sets/three.tsx does not exist");
    put_game("return { maps = { m = { tiles = { 'a.png', 'b.png' }, rows = { { 1 } } } } }");
    refused("rom.lua: maps.m: tiles: only a .tmx map can use tiles from several pictures");
}

/* Pixel (x, y) of picture i, counted from the anchor. */
static uint8_t at(const struct sprite *s, int i, int x, int y)
{
    x += s->ox;
    y += s->oy;
    return x < 0 || y < 0 || x >= s->w || y >= s->h ? 0 : s->pix[(i * s->h + y) * s->pitch + x];
}

/* Quarter turns keep every pixel; clockwise, about the origin's pixel. */
TEST(turned)
{
    static const uint8_t first[4] = { 0x31, 0x33, 0x34, 0x35 }, second[4] = { 0, 0x36, 0x37, 0 };
    struct sprite s;

    put_game("return { palette = 'p.png', sheets = { s = { file = 's.png', bank = 3 } }, sprites = {\n"
             "  pin = { sheet = 's', w = 4, h = 1, frames = 2, rotations = 4, origin = { 0, 0 } },\n"
             "  odd = { sheet = 's', x = 0, w = 3, h = 1, rotations = 4 } } }");
    put_palette("p.png");
    put_sheet("s.png", (const char *const[]){ "acde.fg." }, 8, 1);
    pack(false);
    s = sprite("pin");
    assert_true(s.w == 7 && s.h == 7 && s.rotations == 4 && s.frames == 2);
    for (int k = 0; k < 4; k++) {
        assert_int_equal(at(&s, 0, k, 0), first[k]);
        assert_int_equal(at(&s, 1, 0, k), first[k]);
        assert_int_equal(at(&s, 2, -k, 0), first[k]);
        assert_int_equal(at(&s, 3, 0, -k), first[k]);
        assert_int_equal(at(&s, 4, k, 0), second[k]);
        assert_int_equal(at(&s, 7, 0, -k), second[k]);
    }
    s = sprite("odd"); /* about its middle pixel */
    assert_true(s.w == 3 && s.h == 3);
    assert_int_equal(at(&s, 0, -1, 0), 0x31);
    assert_int_equal(at(&s, 1, 0, 1), 0x34);
}

/* Sizes: frames stay, the anchor's pixel too; what is turned is turned at its size. */
TEST(sized)
{
    struct sprite s;

    put_game("return { palette = 'p.png', sheets = { s = { file = 's.png', bank = 3 } }, sprites = {\n"
             "  two = { sheet = 's', w = 2, h = 2, frames = 2, every = 9, sizes = { 300, 50 } },\n"
             "  pin = { sheet = 's', w = 4, h = 2, rotations = 4, origin = { 0, -1 }, sizes = { 200, 300 } } } }");
    put_palette("p.png");
    put_sheet("s.png", (const char *const[]){ "aacc....", "aacc...." }, 8, 2);
    pack(false);
    s = sprite("two_300");
    assert_true(s.w == 6 && s.h == 6 && s.ox == 3 && s.oy == 3 && s.frames == 2 && s.frame_ticks == 9);
    for (int y = 0; y < 6; y++)
        for (int x = 0; x < 6; x++) {
            bool corner = (x < 2 || x > 3) && (y < 2 || y > 3);
            assert_true(at(&s, 0, x - 3, y - 3) == 0x31 || (corner && !at(&s, 0, x - 3, y - 3)));
            assert_true(at(&s, 1, x - 3, y - 3) == 0x33 || (corner && !at(&s, 1, x - 3, y - 3)));
        }
    s = sprite("two_50");
    assert_true(s.w == 1 && s.h == 1 && s.ox == 0 && s.oy == 0);
    assert_int_equal(at(&s, 1, 0, 0), 0x33);
    s = sprite("pin_200"); /* its anchor was the pixel above its corner, and is at 1, -1 of the larger one */
    assert_int_equal(s.rotations, 4);
    assert_int_equal(at(&s, 0, 1, 2), 0x31);
    assert_int_equal(at(&s, 1, -2, 1), 0x31);
    assert_int_equal(at(&s, 2, -1, -2), 0x31);
    s = sprite("pin_300"); /* at 1, -2: the lowest row is 7 below it */
    assert_int_equal(at(&s, 0, 3, 7), 0x31);
    assert_int_equal(at(&s, 0, 3, 8), 0);
}

TEST(art_errors)
{
    put_game("return {\n -- font = 'art/p.png'\n font = 'art/p.pngx', palette =\n\"art/p.png\" }");
    refused("rom.lua:4: art/p.png does not exist");
    put_game("return {\n palette = 'art/' .. 'p.png' }");
    refused("rom.lua: art/p.png does not exist");
    put_game("return { sheets = { s = { file = 's.png' } }, sprites = {"
             "  a = { sheet = 's', y = 1, w = 1, h = 1 } } }");
    put_sheet("s.png", (const char *const[]){ ".." }, 2, 1);
    refused("s.png: sprite \"a\": 1 frames of 1x1 at 0,1 do not fit in the sheet of 2x1 pixels");
}

TEST(too_large)
{
    static char row[4097];

    put_palette("p.png");
    memset(row, 'a', 4096);
    put_sheet("s.png", (const char *const[]){ row }, 4096, 1);
    put_game("return { palette = 'p.png', sheets = { s = { file = 's.png', bank = 3 } }, sprites = {"
             "  a = { sheet = 's', w = 16, h = 1, rotations = 256, frames = 256, origin = { 64, 64 } } } }");
    refused("s.png: sprite \"a\": its frames and rotations take more than 64 MiB");
    put_game("return { palette = 'p.png', sheets = { s = { file = 's.png', bank = 3 } }, sprites = {"
             "  a = { sheet = 's', w = 2, h = 1, rotations = 2, origin = { 1000, 0 } } } }");
    assert_false(pack_folder(dir, false, NULL, NULL, &(uint8_t *){ NULL }, &(size_t){ 0 }, err, sizeof err));
    assert_non_null(strstr(err, " pixels when rotated, expected at most 1024 in each direction"));
}

/* The id follows the folder's name, however it is spelled. */
TEST(id)
{
    static const char *const spelled[] = { "My-Game", "My-Game//", "x/../My-Game" };

    put_text("My-Game/rom.lua", "return {}");
    put_text("My-Game/main.lua", "");
    put_text("x/y", "");
    for (int i = 0; i < 3; i++) {
        struct rom_image made;
        struct cart cart;
        if (!pack_load_game(in_dir(spelled[i]), false, &made, err, sizeof err))
            fail_msg("%s", err);
        assert_true(cart_open(&cart, &made.rom, err, sizeof err));
        assert_string_equal(cart.manifest.id, "my_game");
        rom_image_free(&made);
    }
}

TEST(errors)
{
    static const char *const names[][2] = {
        { "stages/my stage.lua", "stages/my stage.lua: expected a name of letters, digits, _ - and . only" },
        { "stages/One.lua", "stages/One.lua and stages/one.lua differ only in case; on some systems they are the same "
                            "file" },
        { "stages/Nul.x.lua", "stages/Nul.x.lua: not a valid file name on Windows" },
        { "com4/x.txt", "com4/x.txt: not a valid file name on Windows" },
        { "a/b/c/d/e/f/g/h/i/x.lua", "a/b/c/d/e/f/g/h/i: folders nested deeper than 8" },
    };

    refused("rom.lua: no such file");
    put_text("rom.lua", "return {}");
    refused("rom.lua: entry: main.lua does not exist");
    put_text("main.lua", "return 1");
    put_text("stages/one.lua", "for");
    refused("stages/one.lua:1: <name> expected near <eof>");
    put_text("stages/one.lua", "");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        put_text(names[i][0], "");
        refused(names[i][1]);
        remove(in_dir(names[i][0]));
    }
}

TEST(long_text)
{
    static char text[MAX_TEXT + 2];

    put_game("return {}");
    memset(text, 'a', MAX_TEXT);
    put_text("lines.txt", text);
    pack(false);
    text[MAX_TEXT] = 'b';
    put_text("lines.txt", text);
    refused("lines.txt: expected text of at most 65536 bytes, got 65537");
}

/* A ROM of lumps that need not be a cart. */
static struct rom_image loose(const struct lump *lumps, int n)
{
    struct rom_image made = { malloc(rom_write_size(lumps, n)), rom_write_size(lumps, n), { 0 } };

    rom_write(made.bytes, lumps, n);
    assert_true(rom_open(&made.rom, made.bytes, made.size, err, sizeof err));
    return made;
}

TEST(unpack_refuses)
{
    static const char *const names[] = { "script/../evil.lua", "script//etc/evil", "data/.profile", "script/C:evil.lua",
                                         "data/a\\b.txt" };
    char out[PATH + 8];

    snprintf(out, sizeof out, "%s/out", dir);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        struct lump lumps[] = { { "aaa", (const uint8_t *)"x", 1 }, { names[i], (const uint8_t *)"x", 1 } };
        struct rom_image made = loose(lumps, 2);
        assert_false(pack_unpack(&made.rom, out, err, sizeof err));
        assert_non_null(strstr(err, "\" is not a valid file name"));
        assert_int_equal(plat_file_size(in_dir("out/lumps/aaa")), -1); /* nothing was written */
        rom_image_free(&made);
    }
    struct lump twice[] = { { "data/main.lua", (const uint8_t *)"x", 1 },
                            { "gfx/between", NULL, 0 },
                            { "script/main.lua", (const uint8_t *)"y", 1 } };
    struct rom_image made = loose(twice, 3);
    assert_false(pack_unpack(&made.rom, out, err, sizeof err));
    assert_string_equal(err, "two lumps would be written to main.lua");
    rom_image_free(&made);
}

RUN_TESTS_EACH(new_folder, drop_folder)
