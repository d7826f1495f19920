/* test_pack.c - pack.h: folders made in a temporary place, packed, looked at, and unpacked again. */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */
#include "../test.h"
#include <lua.h>
#include "../../platform/platform.h"
#include "../../src/base/bytes.h"
#include "../../src/base/hash.h"
#include "../../src/rom/cart.h"
#include "../../src/script/api/eval.h"
#include "../../src/machine/video/video.h"
#include "../../src/script/std.h"
#include "../../src/workbench/pack/pack.h"
#include "../../src/workbench/pack/blend.h"
#include "../../src/player/picture/shade.h"
#include "../temp.h"

enum { PATH = 512 };

static char dir[PATH], err[512];

/* ---- a folder ---- */

static int new_folder(void **state)
{
    (void)state;
    err[0] = '\0';
    return temp_folder(dir, sizeof dir, "Pack") ? 0 : -1;
}

struct names {
    char name[64][64];
    bool folder[64];
    int n;
};

static void note_name(void *user, const struct plat_folder_entry *file)
{
    struct names *l = user;

    if (l->n == 64)
        return;
    snprintf(l->name[l->n], sizeof l->name[0], "%s", file->name);
    l->folder[l->n++] = file->is_folder;
}

static void remove_folder(const char *path)
{
    struct names l = { .n = 0 };

    plat_list(path, note_name, &l);
    for (int i = 0; i < l.n; i++) {
        char below[PATH + 80];
        snprintf(below, sizeof below, "%s/%s", path, l.name[i]);
        if (l.folder[i])
            remove_folder(below);
        else
            remove(below);
    }
    remove(path);
}

static int drop_folder(void **state)
{
    (void)state;
    remove_folder(dir);
    return 0;
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

static uint32_t big32(uint8_t *p, uint32_t v)
{
    for (int i = 0; i < 4; i++)
        p[i] = (uint8_t)(v >> (24 - 8 * i));
    return v;
}

static size_t png_chunk(uint8_t *p, const char *kind, const uint8_t *data, size_t n)
{
    big32(p, (uint32_t)n);
    memcpy(p + 4, kind, 4);
    if (n > 0)
        memcpy(p + 8, data, n);
    big32(p + 8 + n, hash_crc32(p + 4, n + 4));
    return n + 12;
}

/* An RGBA picture as a PNG file whose data is stored, not compressed; rows are filtered by none. At most 65535 bytes.
 */
static void put_picture(const char *name, const uint32_t *argb, int w, int h)
{
    static uint8_t raw[65535 + 11], file[65535 + 100];
    uint8_t header[13] = { 0 }, *p = raw + 7;
    uint32_t a = 1, b = 0;
    size_t n = (size_t)h * (1 + 4 * (size_t)w), size = 8;

    assert_true(n <= 65535);
    for (int y = 0; y < h; y++) {
        *p++ = 0;
        for (int x = 0; x < w; x++, p += 4, argb++)
            big32(p, *argb << 8 | *argb >> 24);
    }
    memcpy(raw, "\x78\x01\x01", 3);
    bytes_put16(raw + 3, (uint16_t)n);
    bytes_put16(raw + 5, (uint16_t)~n);
    for (size_t i = 0; i < n; i++) {
        a = (a + raw[7 + i]) % 65521;
        b = (b + a) % 65521;
    }
    big32(p, b << 16 | a);
    big32(header, (uint32_t)w);
    big32(header + 4, (uint32_t)h);
    header[8] = 8;
    header[9] = 6;
    memcpy(file, "\x89PNG\r\n\x1a\n", 8);
    size += png_chunk(file + size, "IHDR", header, 13);
    size += png_chunk(file + size, "IDAT", raw, n + 11);
    size += png_chunk(file + size, "IEND", NULL, 0);
    put_bytes(name, file, size);
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

static struct rom_image packed(bool nearest)
{
    struct rom_image image;
    err[0] = '\0';
    bool good = pack_load_game(dir, nearest, &image, err, sizeof err);

    assert_string_equal(err, "");
    assert_true(good);
    return image;
}

static void refused(const char *line)
{
    uint8_t *bytes;
    size_t size;

    assert_false(pack_folder(dir, false, NULL, NULL, &bytes, &size, err, sizeof err));
    assert_string_equal(err, line);
}

static struct lump find(const struct rom *rom, const char *name)
{
    int i = rom_find(rom, name);
    struct lump l;

    if (i < 0)
        fail_msg("no lump %s", name);
    rom_lump(rom, i, &l);
    return l;
}

static void assert_lump(const struct rom *rom, const char *name, const char *text)
{
    struct lump l = find(rom, name);

    assert_int_equal(l.size, strlen(text));
    assert_memory_equal(l.data, text, l.size);
}

static struct sprite sprite(const struct rom *rom, const char *name)
{
    struct cart cart;
    struct sprite s;

    assert_true(cart_open(&cart, rom, err, sizeof err));
    assert_true(cart_find(&cart, CART_SPRITES, name) >= 0);
    cart_sprite(&cart, cart_find(&cart, CART_SPRITES, name), &s);
    return s;
}

TEST(smallest)
{
    struct rom_image image;
    struct cart cart;
    char want[32] = "pack_";

    put_game("return {}");
    image = packed(false);
    assert_true(cart_open(&cart, &image.rom, err, sizeof err));
    snprintf(want, sizeof want, "pack_%s", strrchr(dir, '-') + 1);
    for (char *c = want; *c != '\0'; c++)
        *c = *c >= 'A' && *c <= 'Z' ? (char)(*c + 32) : *c;
    assert_string_equal(cart.manifest.id, want);
    assert_lump(&image.rom, "script/main.lua", "print('hello')\n");
    assert_int_equal(find(&image.rom, "palette/main").size, 768);
    assert_int_equal(find(&image.rom, "shades").size, CART_SHADES_SIZE);
    assert_int_equal(cart.n_glyphs, 0);
    assert_int_equal(image.rom.count, 4);
    rom_image_free(&image);
    assert_null(image.bytes);
}

TEST(what_goes_in)
{
    struct rom_image image;

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
    image = packed(false);
    assert_lump(&image.rom, "script/boot/start.lua", "return 7");
    assert_lump(&image.rom, "script/stages/deep/one.lua", "return 1");
    assert_lump(&image.rom, "script/stages/tests/t.lua", "return 2");
    assert_lump(&image.rom, "data/names.txt", "Ann\r\n");
    assert_lump(&image.rom, "data/data/x.txt", "");
    assert_lump(&image.rom, "data/demos/readme.txt", "hi");
    assert_int_equal(find(&image.rom, "demo/attract").size, 3);
    assert_int_equal(image.rom.count, 11);
    rom_image_free(&image);
}

TEST(same_bytes)
{
    struct rom_image a, b;

    put_game("return { sheets = { s = { file = 's.png', bank = 3 } },"
             "  sprites = { a = { sheet = 's', w = 2, h = 1, rotations = 7 }, b = { sheet = 's', w = 1, h = 1 } } }");
    put_sheet("s.png", (const char *const[]){ "ab" }, 2, 1);
    put_text("b.lua", "return 1");
    a = packed(true);
    remove(in_dir("b.lua")); /* another order of entries in the folder, other times */
    put_text("c.txt", "1");
    put_text("b.lua", "return 1");
    remove(in_dir("c.txt"));
    b = packed(true);
    assert_int_equal(a.size, b.size);
    assert_memory_equal(a.bytes, b.bytes, a.size);
    rom_image_free(&a);
    rom_image_free(&b);
}

/* The modules of the library, without their pieces, that a game of this main.lua gets, as lumps: "path prelude". */
static const char *modules_of(const char *text)
{
    static char got[128];
    const char *folder = "script/@std/";
    struct rom_image image;

    put_text("main.lua", text);
    image = packed(false);
    got[0] = '\0';
    for (int i = rom_find_first(&image.rom, folder); i < rom_find_first(&image.rom, "script/@std0"); i++) {
        struct lump l;
        rom_lump(&image.rom, i, &l);
        const char *name = l.name + strlen(folder);
        if (!strchr(name, '/'))
            snprintf(got + strlen(got), sizeof got - strlen(got), "%s%.*s", got[0] ? " " : "", (int)strlen(name) - 4,
                     name);
    }
    rom_image_free(&image);
    return got;
}

static const char every[] =
    "bg boot boss choose figure game hud menu mission path pattern prelude say scoring stage sweep talk trail unlock";

/* A module is in the ROM when a script of the game names it, or a module that is. */
TEST(modules)
{
    put_game("return {}");
    assert_string_equal(modules_of("-- pattern, boss\nlocal s = 'path' print(s.stage, s:menu()) s.hud = 1"), "");
    assert_string_equal(modules_of("wait_until(print)"), "prelude");
    assert_string_equal(modules_of("return pattern"), "figure pattern prelude"); /* any field may be read of it */
    assert_string_equal(modules_of("pattern.ring {} local r = pattern . fan"), "pattern prelude");
    assert_string_equal(modules_of("pattern --[[ ! ]] . star {}"), "figure pattern prelude");
    assert_string_equal(modules_of("pattern['ring'] {}"), "figure pattern prelude");
    assert_string_equal(modules_of("bullet.fire {} star.polygon()"), "");
    assert_string_equal(modules_of("bullet.sweep {}"), "prelude sweep");
    assert_string_equal(modules_of("local b = bullet"), "prelude sweep");
    assert_string_equal(modules_of("local l = bg.layer(1), bg.plane()"), "");
    assert_string_equal(modules_of("bg.show(nil)"), "bg prelude");
    assert_string_equal(modules_of("spark.burst {} spark.trail {}"), "prelude trail");
    assert_string_equal(modules_of("score.add(1, 1) score.rows('t')"), "");
    assert_string_equal(modules_of("score.rule {}"), "prelude scoring");
    assert_string_equal(modules_of("unlock.has('x')"), "prelude unlock");
    assert_string_equal(modules_of("path.def {}"), "path prelude");
    assert_string_equal(modules_of("stage.def('one', print)"), "boss hud path prelude stage");
    assert_string_equal(modules_of("say(nil, 'a')"), "boss hud path prelude say stage talk");
    assert_string_equal(modules_of("return _ENV['pat' .. 'tern']"), every);
    assert_string_equal(modules_of("return _G"), every);
    assert_string_equal(modules_of("return load('x')"), every);
    put_text("other.lua", "return pattern.ring");
    put_text("tests/not.lua", "return boss");
    put_text("words.txt", "boss");
    assert_string_equal(modules_of("return 1"), "pattern prelude");
}

/* A module of the game's own is in the ROM unasked, and what it names too; it is the library's name it has. */
TEST(std)
{
    struct rom_image image;

    put_game("return {}");
    put_text("std/menu.lua", "return 'mine', path");
    image = packed(false);
    assert_lump(&image.rom, "script/@std/menu.lua", "return 'mine', path");
    rom_image_free(&image);
    assert_string_equal(modules_of("return 1"), "menu path prelude");
    assert_string_equal(modules_of("return pattern.arc"), "menu path pattern prelude");
    put_text("std/nonesuch.lua", "return 1");
    refused("std/nonesuch.lua: the standard library has no script with this name");
}

/* A piece is in the ROM with its module, and the game's own in its stead; a game without the module has none. */
TEST(pieces)
{
    struct rom_image image;

    put_game("return {}");
    put_text("main.lua", "return wait_until");
    image = packed(false);
    assert_int_equal(rom_find(&image.rom, "script/@std/boot/list.lua"), -1);
    rom_image_free(&image);
    put_text("main.lua", "return boot.run");
    image = packed(false);
    assert_true(rom_find(&image.rom, "script/@std/boot/list.lua") >= 0);
    rom_image_free(&image);
    put_text("std/boot/list.lua", "return 'mine'");
    image = packed(false);
    assert_lump(&image.rom, "script/@std/boot/list.lua", "return 'mine'");
    rom_image_free(&image);
    put_text("std/boot/lists.lua", "return 1");
    refused("std/boot/lists.lua: the standard library has no script with this name");
}

/* The library's files are the modules that the board knows and their pieces. */
TEST(library)
{
    int pieces = 0;

    for (int k = 0; k < std_script_count; k++)
        pieces += std_module_of_file(std_scripts[k].name) >= 0;
    assert_int_equal(std_script_count, STD_MODULE_COUNT + pieces);
    assert_true(pieces > 0);
    for (int i = 0; i < STD_MODULE_COUNT; i++) {
        int found = 0;
        for (int k = 0; k < std_script_count; k++)
            found += strcmp(std_scripts[k].name, std_modules[i].name) == 0;
        assert_int_equal(found, 1);
    }
}

/* A board of a game with this main.lua. */
struct bed {
    struct rom_image image;
    void *ram;
    struct board *b;
};

static struct bed bed_open(const char *text)
{
    struct board_start start = { .difficulty = -1 };
    struct bed t;
    size_t size;

    put_text("main.lua", text);
    t.image = packed(false);
    assert_true(board_size(&t.image.rom, &size, err, sizeof err));
    t.ram = aligned_alloc(64, (size + 63) / 64 * 64);
    t.b = board_power_on(t.ram, size, &t.image.rom, &start, err, sizeof err);
    assert_non_null(t.b);
    if (board_last_output(t.b)->fault != NULL)
        fail_msg("%s", board_last_output(t.b)->fault->message);
    return t;
}

static void bed_close(struct bed *t)
{
    free(t->ram);
    rom_image_free(&t->image);
}

/* What it takes: bytes of Lua's heap in use and ever allocated while it loads, bytes of the ROM. */
struct price {
    size_t heap, work, rom;
};

static struct price price_of(const char *text)
{
    struct bed t = bed_open(text);
    struct price p = { heap_used(t.b->vm.heap), (size_t)heap_work(t.b->vm.heap), t.image.size };

    bed_close(&t);
    print_message("# bytes: %6zu of Lua's, %6zu allocated, %5zu of ROM: %s\n", p.heap, p.work, p.rom, text);
    return p;
}

/* A game that names no module pays for none: neither in the ROM, nor in Lua's memory, nor at load. */
TEST(price)
{
    put_game("return {}");
    struct price none = price_of("local t = 'pattern path stage boss hud menu boot'");
    struct price one = price_of("local t = pattern");
    struct price all = price_of("local t = { pattern, path, stage, boss, hud, menu, boot }");
    assert_true(none.heap + 8000 < one.heap && none.heap + 60000 < all.heap);
    assert_true(none.work + 10000 < one.work && none.work + 200000 < all.work);
    assert_true(none.rom + 5000 < one.rom && none.rom + 30000 < all.rom);
    struct price functions =
        price_of("for _, of in pairs { enemy, player, query, board } do for _ in pairs(of) do end end");
    assert_true(none.heap + 2000 < functions.heap); /* of the API, too, it pays for what it reads */
}

static void fails(struct bed *t, const char *line, const char *want)
{
    char out[EVAL_TEXT_SIZE];

    assert_false(board_eval(t->b, line, out, sizeof out));
    assert_non_null(strstr(out, want));
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
        struct bed t = bed_open("enemy.def('fly', { sprite = 'a', hp = 5, hit = { circle = 1 } })");
        fails(&t, lines[i][0], lines[i][1]);
        bed_close(&t);
    }
    struct bed t = bed_open("local t = pattern");
    assert_true(board_eval(t.b, "pattern ~= nil", out, sizeof out));
    assert_string_equal(out, "true\n");
    bed_close(&t);
}

/* The globals that modules bind are those that std_module_of_global knows, and no others. */
TEST(globals)
{
    int bound = 0;

    put_game("return {}");
    struct bed none = bed_open("local t = 1"), all = bed_open("local t = _G");
    lua_State *L = all.b->vm.L, *M = none.b->vm.L;
    lua_pushglobaltable(L);
    lua_pushglobaltable(M);
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) {
        lua_pushstring(M, lua_tostring(L, -2));
        bool everywhere = lua_rawget(M, -2) != LUA_TNIL;
        lua_pop(M, 1);
        assert_int_equal(everywhere, std_module_of_global(lua_tostring(L, -2)) < 0);
        bound += !everywhere;
    }
    assert_int_equal(bound,
                     STD_MODULE_COUNT - 6 + 3); /* but prelude, which binds 3, figure, sweep, bg, trail, scoring */
    bed_close(&none);
    bed_close(&all);
}

TEST(palette)
{
    struct rom_image image;
    struct lump l;

    put_game("return { palette = 'art/p.png', palettes = { dusk = 'art/p.png' } }");
    put_palette("art/p.png");
    image = packed(false);
    l = find(&image.rom, "palette/main");
    for (int i = 0; i < 256; i++)
        assert_int_equal(l.data[i * 3] << 16 | l.data[i * 3 + 1] << 8 | l.data[i * 3 + 2], colour(i) & 0xffffff);
    assert_memory_equal(find(&image.rom, "palette/dusk").data, l.data, 768);
    rom_image_free(&image);
}

/* Same palette, same tables; and the table is that of the game's palette. */
TEST(blends)
{
    struct rom_image image, again;
    struct lump l;

    put_game("return { palette = 'p.png', blends = { glow = 'add', ghost = { mix = 30 } } }");
    put_palette("p.png");
    image = packed(false);
    again = packed(false);
    assert_int_equal(image.size, again.size);
    assert_memory_equal(image.bytes, again.bytes, image.size);
    l = find(&image.rom, "blend/glow");
    assert_int_equal(l.size, CART_BLEND_SIZE);
    assert_int_equal(l.data[0x11 * 256 + 0x21], 0x31); /* #300032: #300031 is as near as #300033 */
    assert_int_equal(l.data[0xf1 * 256 + 0xf1], 0xff); /* #ff00ff */
    l = find(&image.rom, "blend/ghost");
    assert_int_equal(l.data[0x12 * 256 + 0x42], 0x21); /* #1e0020: #200020 is never drawn */
    assert_int_equal(l.data[0x42 * 256 + 0x12], 0x34); /* #320034 */
    rom_image_free(&image);
    rom_image_free(&again);
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
    struct rom_image image;
    uint8_t *table = malloc(CART_BLEND_SIZE), shades[CART_SHADES_SIZE];

    put_game("return { palette = 'p.png', palettes = { dusk = 'd.png', same = 'p.png' },"
             "  blends = { glow = 'add', ramp = { ramp = 'add' } } }");
    put_palette("p.png");
    put_turned("d.png");
    image = packed(false);
    const uint8_t *dusk = find(&image.rom, "palette/dusk").data, *main = find(&image.rom, "palette/main").data;
    assert_non_null(table);
    assert_true(blend_make(dusk, BLEND_ADD, table));
    assert_memory_equal(find(&image.rom, "blends/dusk/glow").data, table, CART_BLEND_SIZE);
    assert_true(blend_make(main, BLEND_ADD, table));
    assert_memory_equal(find(&image.rom, "blend/glow").data, table, CART_BLEND_SIZE);
    shade_make(dusk, shades);
    assert_memory_equal(find(&image.rom, "shade/dusk").data, shades, CART_SHADES_SIZE);
    assert_int_equal(rom_find(&image.rom, "shade/same"), -1);
    assert_int_equal(rom_find(&image.rom, "blends/same/glow"), -1);
    assert_int_equal(rom_find(&image.rom, "blends/dusk/ramp"), -1);
    rom_image_free(&image);
    free(table);
}

/* Tables and fog after these lines are those of that palette. */
static void shown_as(const char *lines, const char *palette)
{
    static uint8_t fog[BG_SHADES * 256];
    struct bed t = bed_open(lines);

    t.b->cart.rom = &t.image.rom; /* it has moved */
    assert_string_equal(cart_name(&t.b->cart, CART_PALETTES, board_loaded_palette(t.b)), palette);
    const struct cart_colour_tables look = video_get_palette_tables(t.b);
    const bool main = !strcmp(palette, "main");
    assert_ptr_equal(look.shades, find(&t.image.rom, main ? "shades" : "shade/dusk").data);
    assert_ptr_equal(look.blend[0], find(&t.image.rom, main ? "blend/glow" : "blends/dusk/glow").data);
    bg_fill_shades(fog, cart_palette(&t.b->cart, palette), 0x123456);
    assert_memory_equal(t.b->bg_shades.table + BG_FOG_OFFSET, fog, sizeof fog);
    bed_close(&t);
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
    struct rom_image image;
    struct sprite s;

    put_game(art_manifest);
    put_palette("p.png");
    put_sheet("art/s.png", (const char *const[]){ "########", "#a.c.e.#", "#o....b#" }, 8, 3);
    image = packed(false);
    s = sprite(&image.rom, "two");
    assert_int_equal(s.w, 3);
    assert_int_equal(s.h, 2);
    assert_int_equal(s.pitch, 8);
    assert_int_equal(s.ox, -1);
    assert_int_equal(s.oy, 2);
    assert_int_equal(s.frames, 2);
    assert_int_equal(s.frame_ticks, 9);
    assert_int_equal(s.rotations, 1);
    assert_int_equal(s.bank, 3);
    assert_memory_equal(s.pix, want, sizeof want); /* b has the colour of a: the lowest shade is taken */
    rom_image_free(&image);
}

TEST(half_transparent)
{
    struct rom_image image;

    put_game(art_manifest);
    put_palette("p.png");
    put_sheet("art/s.png", (const char *const[]){ "........", ".~~~~~~.", ".~~~~~d." }, 8, 3);
    image = packed(false);
    assert_int_equal(sprite(&image.rom, "two").pix[0], 0);
    assert_int_equal(sprite(&image.rom, "two").pix[3 * 8 + 2], 0x34);
    rom_image_free(&image);
}

TEST(foreign_colour)
{
    struct rom_image image;

    put_game(art_manifest);
    put_palette("p.png");
    put_sheet("art/s.png", (const char *const[]){ "........", ".aaaaaa.", ".aaaa#a." }, 8, 3);
    refused("art/s.png: pixel 5,2: colour #ff00aa is not in bank 3 (use --nearest for the nearest colour, or match = "
            "\"index\" in rom.lua to use the indices of an indexed picture)");
    image = packed(true);
    assert_int_equal(sprite(&image.rom, "two").pix[3 * 8 + 1], 0x3f); /* #30003f is nearest to #ff00aa */
    rom_image_free(&image);
}

/* Pixel (x, y) of picture i, counted from the anchor. */
/* The shade of the first pixel of cell i of a map with 8 px tiles. */
static int map_shade(const struct rom *rom, const char *name, int i)
{
    const uint8_t *p = find(rom, name).data, *cells = p + CART_MAP_HEADER_SIZE;
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
                                              "eeeeeeee", "eeeeeeee", "eeeeeeee", "eeeeee#e" };
    struct rom_image image;

    put_palette("p.png");
    put_sheet("art/one.png", one, 19, 10);
    put_sheet("art/two.png", two, 8, 8);
    put_text("sets/one.tsx", "\xef\xbb\xbf<tileset tilewidth='8' tileheight='8' spacing='1' margin='1' columns='2'>"
                             "<image source='../art/one.png' width='19' height='10'/></tileset>");
    put_text("sets/two.tsx", "<tileset><image source='../art/two.png'/></tileset>");
    put_text("maps/m.tmx", MAP_OF("<tileset firstgid='1' source='../sets/one.tsx'/>", "1,2"));
    put_game("return { palette = 'p.png', maps = { m = { tiles = 'art/one.png', bank = 3, file = 'maps/m.tmx' } } }");
    image = packed(false);
    assert_int_equal(map_shade(&image.rom, "map/m", 0), 4);
    assert_int_equal(map_shade(&image.rom, "map/m", 1), 1);
    rom_image_free(&image);

    put_text("maps/m.tmx", MAP_OF("<tileset firstgid='1' source='../sets/two.tsx'/>"
                                  "<tileset firstgid='11' source='../sets/one.tsx'/>",
                                  "11,12"));
    image = packed(false); /* the unused tileset does not matter */
    assert_int_equal(map_shade(&image.rom, "map/m", 1), 1);
    rom_image_free(&image);
    put_text("maps/m.tmx", MAP_OF("<tileset firstgid='1' source='../sets/two.tsx'/>"
                                  "<tileset firstgid='11' source='../sets/one.tsx'/>",
                                  "1,12"));
    refused("sets/two.tsx:1: the map uses tiles from art/two.png; add it to `tiles` of map \"m\" in rom.lua");
    put_game("return { palette = 'p.png', maps = { m = { tiles = { 'art/one.png', 'art/two.png' }, bank = 3,"
             "  file = 'maps/m.tmx' } } }");
    refused("art/two.png: pixel 6,7: colour #ff00aa is not in bank 3 (use --nearest for the nearest colour, or match = "
            "\"index\" in rom.lua to use the indices of an indexed picture)");
    put_sheet("art/two.png", two, 8, 7);
    refused("maps/m.tmx: map \"m\": column 1, row 1: tile 1, but the sheet has 0 tiles of 8x8 px");
    put_sheet("art/two.png", (const char *const[]){ two[0], two[0], two[0], two[0], two[0], two[0], two[0], two[0] }, 8,
              8);
    image = packed(false);
    assert_int_equal(map_shade(&image.rom, "map/m", 0), 5);
    assert_int_equal(map_shade(&image.rom, "map/m", 1), 1);
    rom_image_free(&image);

    put_text("sets/one.tsx", "<tileset columns='3'><image source='../art/one.png'/></tileset>");
    refused("sets/one.tsx:1: the tileset has 3 columns, but art/one.png has 2; open the map in Tiled with that picture "
            "and save it");
    put_text("maps/m.tmx", MAP_OF("<tileset firstgid='1' source='../sets/three.tsx'/>", "1,0"));
    refused("maps/m.tmx:2: sets/three.tsx does not exist");
    put_game("return { maps = { m = { tiles = { 'a.png', 'b.png' }, rows = { { 1 } } } } }");
    refused("rom.lua: maps.m: tiles: only a .tmx map can use tiles from several pictures");
}

static uint8_t at(const struct sprite *s, int i, int x, int y)
{
    x += s->ox;
    y += s->oy;
    return x < 0 || y < 0 || x >= s->w || y >= s->h ? 0 : s->pix[(i * s->h + y) * s->pitch + x];
}

/* Quarter turns keep every pixel; about the anchor's pixel when it is named, and clockwise. */
TEST(turned)
{
    struct rom_image image;
    struct sprite s;

    put_game("return { palette = 'p.png', sheets = { s = { file = 's.png', bank = 3 } }, sprites = {\n"
             "  pin = { sheet = 's', w = 4, h = 1, frames = 2, rotations = 4, origin = { 0, 0 } },\n"
             "  odd = { sheet = 's', x = 0, w = 3, h = 1, rotations = 4 } } }");
    put_palette("p.png");
    put_sheet("s.png", (const char *const[]){ "acde.fg." }, 8, 1);
    image = packed(false);
    s = sprite(&image.rom, "pin");
    assert_int_equal(s.rotations, 4);
    assert_int_equal(s.frames, 2);
    for (int k = 0; k < 4; k++) {
        static const uint8_t first[4] = { 0x31, 0x33, 0x34, 0x35 }, second[4] = { 0, 0x36, 0x37, 0 };
        assert_int_equal(at(&s, 0, k, 0), first[k]);
        assert_int_equal(at(&s, 1, 0, k), first[k]);
        assert_int_equal(at(&s, 2, -k, 0), first[k]);
        assert_int_equal(at(&s, 3, 0, -k), first[k]);
        assert_int_equal(at(&s, 4, k, 0), second[k]);
        assert_int_equal(at(&s, 7, 0, -k), second[k]);
    }
    assert_int_equal(s.w, 7);
    assert_int_equal(s.h, 7);
    s = sprite(&image.rom, "odd"); /* about its middle pixel */
    assert_int_equal(s.w, 3);
    assert_int_equal(s.h, 3);
    assert_int_equal(at(&s, 0, -1, 0), 0x31);
    assert_int_equal(at(&s, 0, 0, 0), 0x33);
    assert_int_equal(at(&s, 1, 0, 1), 0x34);
    rom_image_free(&image);
}

/* Sizes: frames stay, the anchor's pixel too; what is turned is turned at its size. */
TEST(sized)
{
    struct rom_image image;
    struct sprite s;

    put_game("return { palette = 'p.png', sheets = { s = { file = 's.png', bank = 3 } }, sprites = {\n"
             "  two = { sheet = 's', w = 2, h = 2, frames = 2, every = 9, sizes = { 300, 50 } },\n"
             "  pin = { sheet = 's', w = 4, h = 2, rotations = 4, origin = { 0, -1 }, sizes = { 200, 300 } } } }");
    put_palette("p.png");
    put_sheet("s.png", (const char *const[]){ "aacc....", "aacc...." }, 8, 2);
    image = packed(false);
    s = sprite(&image.rom, "two_300");
    assert_true(s.w == 6 && s.h == 6 && s.ox == 3 && s.oy == 3 && s.frames == 2 && s.frame_ticks == 9);
    for (int y = 0; y < 6; y++)
        for (int x = 0; x < 6; x++) {
            bool corner = (x < 2 || x > 3) && (y < 2 || y > 3);
            assert_true(at(&s, 0, x - 3, y - 3) == 0x31 || (corner && !at(&s, 0, x - 3, y - 3)));
            assert_true(at(&s, 1, x - 3, y - 3) == 0x33 || (corner && !at(&s, 1, x - 3, y - 3)));
        }
    s = sprite(&image.rom, "two_50");
    assert_true(s.w == 1 && s.h == 1 && s.ox == 0 && s.oy == 0);
    assert_int_equal(at(&s, 1, 0, 0), 0x33);
    s = sprite(&image.rom,
               "pin_200"); /* its anchor was the pixel above its corner, and is at 1, -1 of the larger one */
    assert_int_equal(s.rotations, 4);
    assert_int_equal(at(&s, 0, 1, 2), 0x31);
    assert_int_equal(at(&s, 1, -2, 1), 0x31);
    assert_int_equal(at(&s, 2, -1, -2), 0x31);
    s = sprite(&image.rom, "pin_300"); /* at 1, -2: the lowest row is 7 below it */
    assert_int_equal(at(&s, 0, 3, 7), 0x31);
    assert_int_equal(at(&s, 0, 3, 8), 0);
    rom_image_free(&image);
}

/* Two sheets with a sprite each, one of nothing at all, turned: a picture of one empty pixel. */
TEST(two_sheets)
{
    struct rom_image image;

    put_game(
        "return { palette = 'p.png', sheets = { s = { file = 's.png', bank = 3 }, t = { file = 't.png', bank = 3 } },"
        "  sprites = { a = { sheet = 't', w = 1, h = 1 }, b = { sheet = 's', w = 2, h = 1, rotations = 3 } } }");
    put_palette("p.png");
    put_sheet("s.png", (const char *const[]){ ".." }, 2, 1);
    put_sheet("t.png", (const char *const[]){ "d" }, 1, 1);
    image = packed(false);
    assert_int_equal(sprite(&image.rom, "a").pix[0], 0x34);
    assert_int_equal(sprite(&image.rom, "b").w, 1);
    assert_int_equal(sprite(&image.rom, "b").pix[0], 0);
    rom_image_free(&image);
}

/* All turns lie inside the picture: as many pixels as the sprite has, about. */
TEST(many_turns)
{
    struct rom_image image;
    struct sprite s;

    put_game("return { palette = 'p.png', sheets = { s = { file = 's.png', bank = 3 } }, sprites = {\n"
             "  bar = { sheet = 's', w = 16, h = 4, rotations = 64 } } }");
    put_palette("p.png");
    put_sheet("s.png",
              (const char *const[]){ "aaaaaaaaaaaaaaaa", "aaaaaaaaaaaaaaaa", "aaaaaaaaaaaaaaaa", "aaaaaaaaaaaaaaaa" },
              16, 4);
    image = packed(false);
    s = sprite(&image.rom, "bar");
    assert_true(s.w >= 16 && s.w <= 18 && s.h >= 16 && s.h <= 18);
    for (int i = 0; i < 64; i++) {
        int n = 0;
        for (int k = 0; k < s.pitch * s.h; k++)
            n += s.pix[i * s.pitch * s.h + k] != 0;
        assert_in_range(n, 50, 80);
    }
    rom_image_free(&image);
}

TEST(font)
{
    static uint32_t argb[128 * 16];
    struct rom_image image;
    struct lump l;

    argb[8 * 128 + 9] = 0xff000005; /* cell 17, that is character 49, pixel 1,0 */
    put_game("return { palette = 'p.png', font = 'font.png' }");
    put_palette("p.png");
    put_picture("font.png", argb, 128, 16);
    image = packed(false);
    l = find(&image.rom, "font");
    assert_int_equal(l.size, 32 * 64);
    for (uint32_t i = 0; i < l.size; i++)
        assert_int_equal(l.data[i], i == 17 * 64 + 1 ? 5 : 0);
    rom_image_free(&image);
    argb[3] = 0xff123456;
    put_picture("font.png", argb, 128, 16);
    refused("font.png: pixel 3,0: colour #123456 is not in bank 0 (use --nearest for the nearest colour, or match = "
            "\"index\" in rom.lua to use the indices of an indexed picture)");
    put_picture("font.png", argb, 120, 16);
    refused("font.png: 120x16 pixels, expected 128 wide and 8 to 112 high: cells of 8x8, 16 per row");
    put_picture("font.png", argb, 128, 12);
    refused("font.png: 128x12 pixels, expected 128 wide and 8 to 112 high: cells of 8x8, 16 per row");
}

TEST(art_errors)
{
    put_game("return { palette = 'art/p.png' }");
    refused("rom.lua:1: art/p.png does not exist");
    put_game("return {\n -- font = 'art/p.png'\n font = 'art/p.pngx', palette =\n\"art/p.png\" }");
    refused("rom.lua:4: art/p.png does not exist");
    put_game("return {\n palette = 'art/' .. 'p.png' }");
    refused("rom.lua: art/p.png does not exist");
    put_game("return { palette = 'art/p.png' }");
    put_text("art/p.png", "not a picture");
    assert_false(pack_folder(dir, false, NULL, NULL, &(uint8_t *){ NULL }, &(size_t){ 0 }, err, sizeof err));
    assert_int_equal(strncmp(err, "art/p.png: ", 11), 0);
    put_sheet("art/p.png", (const char *const[]){ "ab" }, 2, 1);
    refused("art/p.png: 2x1 pixels, expected 16x16: one row per bank, one column per shade");
    put_game("return { sheets = { s = { file = 's.png' } }, sprites = {"
             "  a = { sheet = 's', x = 1, w = 1, h = 1, frames = 2 } } }");
    put_sheet("s.png", (const char *const[]){ ".." }, 2, 1);
    refused("s.png: sprite \"a\": 2 frames of 1x1 at 1,0 do not fit in the sheet of 2x1 pixels");
    put_game("return { sheets = { s = { file = 's.png' } }, sprites = {"
             "  a = { sheet = 's', y = 1, w = 1, h = 1 } } }");
    refused("s.png: sprite \"a\": 1 frames of 1x1 at 0,1 do not fit in the sheet of 2x1 pixels");
}

TEST(too_large_turned)
{
    put_game("return { palette = 'p.png', sheets = { s = { file = 's.png', bank = 3 } }, sprites = {"
             "  a = { sheet = 's', w = 2, h = 1, rotations = 2, origin = { 1000, 0 } } } }");
    put_palette("p.png");
    put_sheet("s.png", (const char *const[]){ "aa" }, 2, 1);
    assert_false(pack_folder(dir, false, NULL, NULL, &(uint8_t *){ NULL }, &(size_t){ 0 }, err, sizeof err));
    assert_non_null(strstr(err, "s.png: sprite \"a\": 200"));
    assert_non_null(strstr(err, " pixels when rotated, expected at most 1024 in each direction"));
}

TEST(too_large)
{
    put_game("return { palette = 'p.png', sheets = { s = { file = 's.png', bank = 3 } }, sprites = {"
             "  a = { sheet = 's', w = 16, h = 1, rotations = 256, frames = 256, origin = { 64, 64 } } } }");
    put_palette("p.png");
    static char row[4097];
    memset(row, 'a', 4096);
    put_sheet("s.png", (const char *const[]){ row }, 4096, 1);
    refused("s.png: sprite \"a\": its frames and rotations take more than 64 MiB");
}

/* The id follows the folder's name, however it is spelled. */
TEST(id)
{
    static const char *const spelled[] = { "My-Game", "My-Game/", "My-Game//", "x/../My-Game", "My-Game/." };

    put_text("My-Game/rom.lua", "return {}");
    put_text("My-Game/main.lua", "");
    put_text("x/y", "");
    for (size_t i = 0; i < sizeof spelled / sizeof spelled[0]; i++) {
        struct rom_image image;
        struct cart cart;
        bool good = pack_load_game(in_dir(spelled[i]), false, &image, err, sizeof err);
        assert_string_equal(err, "");
        assert_true(good);
        assert_true(cart_open(&cart, &image.rom, err, sizeof err));
        assert_string_equal(cart.manifest.id, i == 4 ? "game" : "my_game");
        rom_image_free(&image);
    }
}

TEST(errors)
{
    char want[PATH + 64];

    refused("rom.lua: no such file");
    put_text("rom.lua", "return { bord = {} }");
    refused("rom.lua: bord: unknown key (did you mean \"board\"?)");
    put_text("rom.lua", "return {}");
    refused("rom.lua: entry: main.lua does not exist");
    put_text("main.lua", "x = = 1");
    refused("main.lua:1: unexpected symbol near '='");
    put_text("main.lua", "\n\nx = 2^3");
    refused("main.lua:3: operator ^ is not available (results differ between machines); use x*x or math.sqrt");
    put_text("main.lua", "return 1");
    put_text("stages/one.lua", "for");
    refused("stages/one.lua:1: <name> expected near <eof>");
    put_text("stages/one.lua", "");
    put_text("stages/my stage.lua", "");
    refused("stages/my stage.lua: expected a name of letters, digits, _ - and . only");
    remove(in_dir("stages/my stage.lua"));
    put_text("stages/One.lua", "");
    refused("stages/One.lua and stages/one.lua differ only in case; on some systems they are the same file");
    remove(in_dir("stages/One.lua"));
    put_text("stages/Nul.x.lua", "");
    refused("stages/Nul.x.lua: not a valid file name on Windows");
    remove(in_dir("stages/Nul.x.lua"));
    put_text("com4/x.txt", "");
    refused("com4/x.txt: not a valid file name on Windows");
    remove(in_dir("com4/x.txt"));
    put_text("a/b/c/d/e/f/g/h/i/x.lua", "");
    refused("a/b/c/d/e/f/g/h/i: folders nested deeper than 8");
    snprintf(want, sizeof want, "%s/none: no such folder", dir);
    strcat(dir, "/none");
    refused(want);
    *strrchr(dir, '/') = '\0';
}

TEST(long_name)
{
    char name[160] = "stages/", want[300];

    put_game("return {}");
    memset(name + 7, 'n', 120);
    strcpy(name + 127, ".lua");
    put_text(name, "return 1");
    snprintf(want, sizeof want, "%s: name too long", name);
    refused(want);
}

TEST(long_text)
{
    static char text[MAX_TEXT + 2];

    put_game("return {}");
    memset(text, 'a', MAX_TEXT);
    put_text("lines.txt", text);
    struct rom_image image = packed(false);
    rom_image_free(&image);
    text[MAX_TEXT] = 'b';
    put_text("lines.txt", text);
    refused("lines.txt: expected text of at most 65536 bytes, got 65537");
}

TEST(load)
{
    struct rom_image folder, file;
    char path[PATH + 16], want[PATH + 128];

    put_game("return { title = 'T' }");
    folder = packed(false);
    snprintf(path, sizeof path, "%s/game.rom", dir);
    assert_true(plat_save(path, folder.bytes, folder.size));
    assert_true(pack_load_game(path, false, &file, err, sizeof err));
    assert_int_equal(file.size, folder.size);
    assert_memory_equal(file.bytes, folder.bytes, file.size);
    assert_int_equal(rom_find(&file.rom, "manifest"), rom_find(&folder.rom, "manifest"));
    rom_image_free(&file);
    folder.bytes[folder.size - 1] ^= 1;
    assert_true(plat_save(path, folder.bytes, folder.size));
    assert_false(pack_load_game(path, false, &file, err, sizeof err));
    snprintf(want, sizeof want, "%s: damaged: the checksum does not match", path);
    assert_string_equal(err, want);
    assert_null(file.bytes);
    rom_image_free(&folder);
    snprintf(path, sizeof path, "%s/none.rom", dir);
    assert_false(pack_load_game(path, false, &file, err, sizeof err));
    snprintf(want, sizeof want, "%s: no such file or folder", path);
    assert_string_equal(err, want);
    put_text("rom.lua", "return 1");
    assert_false(pack_load_game(dir, false, &file, err, sizeof err));
    assert_null(file.bytes);
}

/* A ROM of lumps that need not be a cart. */
static struct rom_image loose(const struct lump *lumps, int n)
{
    struct rom_image image = { malloc(rom_write_size(lumps, n)), rom_write_size(lumps, n), { 0 } };

    rom_write(image.bytes, lumps, n);
    assert_true(rom_open(&image.rom, image.bytes, image.size, err, sizeof err));
    return image;
}

static void add_line(void *user, const char *line)
{
    strcat(user, line);
    strcat(user, "\n");
}

TEST(list)
{
    const struct lump lumps[] = { { "data/a.txt", (const uint8_t *)"123456789", 9 }, { "gfx/b", NULL, 0 } };
    struct rom_image image = loose(lumps, 2);
    char text[200] = "";

    pack_list(&image.rom, add_line, text);
    assert_string_equal(text, "data/a.txt 9 cbf43926\ngfx/b 0 00000000\n");
    rom_image_free(&image);
}

static void assert_file(const char *name, const struct lump *l)
{
    uint8_t *data = malloc(l->size + 1);

    assert_int_equal(plat_file_size(in_dir(name)), l->size);
    assert_int_equal(plat_load(in_dir(name), data, l->size + 1), l->size);
    assert_memory_equal(data, l->data, l->size);
    free(data);
}

/* Every lump is a file again, byte for byte, under the name this says. */
TEST(unpack)
{
    struct rom_image image;
    char out[PATH + 8];

    put_game(
        "return { sheets = { s = { file = 's.png', bank = 3 } }, sprites = { orb = { sheet = 's', w = 2, h = 1 } } }");
    put_sheet("s.png", (const char *const[]){ ".." }, 2, 1);
    put_text("stages/one.lua", "return 1");
    put_text("names.txt", "Ann");
    put_bytes("demos/attract.demo", "\0\1\2", 3);
    image = packed(false);
    snprintf(out, sizeof out, "%s/out", dir);
    assert_true(pack_unpack(&image.rom, out, err, sizeof err));
    for (uint32_t i = 0; i < image.rom.count; i++) {
        struct lump l;
        char name[256];
        rom_lump(&image.rom, (int)i, &l);
        if (strncmp(l.name, "script/@std/", 12) == 0)
            snprintf(name, sizeof name, "out/std/%s", l.name + 12);
        else if (strncmp(l.name, "script/", 7) == 0)
            snprintf(name, sizeof name, "out/%s", l.name + 7);
        else if (strcmp(l.name, "data/names.txt") == 0)
            snprintf(name, sizeof name, "out/names.txt");
        else if (strcmp(l.name, "demo/attract") == 0)
            snprintf(name, sizeof name, "out/demos/attract.demo");
        else
            snprintf(name, sizeof name, "out/lumps/%s", l.name);
        assert_file(name, &l);
    }
    assert_false(pack_unpack(&image.rom, out, err, sizeof err));
    assert_non_null(strstr(err, ": already exists"));
    rom_image_free(&image);
}

TEST(unpack_refuses)
{
    static const char *const names[] = { "script/../evil.lua",
                                         "data/a/../../evil.txt",
                                         "script//etc/evil",
                                         "data/.profile",
                                         "gfx/..",
                                         "script/C:evil.lua",
                                         "script/",
                                         "data/a\\b.txt",
                                         "demo/x/" };
    char want[256], out[PATH + 8];

    snprintf(out, sizeof out, "%s/out", dir);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        struct lump lumps[] = { { "aaa", (const uint8_t *)"x", 1 }, { names[i], (const uint8_t *)"x", 1 } };
        struct rom_image image = loose(lumps, 2);
        assert_false(pack_unpack(&image.rom, out, err, sizeof err));
        assert_non_null(strstr(err, "\" is not a valid file name"));
        assert_int_equal(plat_file_size(in_dir("out/lumps/aaa")), -1); /* nothing was written */
        rom_image_free(&image);
    }
    struct lump twice[] = { { "data/main.lua", (const uint8_t *)"x", 1 },
                            { "gfx/between", NULL, 0 },
                            { "script/main.lua", (const uint8_t *)"y", 1 } };
    struct rom_image image = loose(twice, 3);
    snprintf(want, sizeof want, "two lumps would be written to main.lua");
    assert_false(pack_unpack(&image.rom, out, err, sizeof err));
    assert_string_equal(err, want);
    rom_image_free(&image);
    image = loose(NULL, 0);
    assert_true(pack_unpack(&image.rom, out, err, sizeof err));
    rom_image_free(&image);
}

RUN_TESTS_EACH(new_folder, drop_folder)
