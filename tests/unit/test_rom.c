/* test_rom.c - rom.h and cart.h: what is written is read back, and whatever is wrong with a ROM is refused in one
 * sentence. */
#include "../test.h"
#include "../../src/base/bytes.h"
#include "../../src/base/hash.h"
#include "../../src/rom/rom.h"
#include "../../src/rom/cart.h"

/* A ROM in memory of exactly its size, so that a sanitizer sees any read beyond it. */
struct block {
    uint8_t *p;
    size_t size;
};

static struct block make(const struct lump *lumps, int n)
{
    struct block b = { NULL, rom_write_size(lumps, n) };

    b.p = malloc(b.size);
    assert_non_null(b.p);
    rom_write(b.p, lumps, n);
    return b;
}

static const uint8_t *bytes(const char *s)
{
    return (const uint8_t *)s;
}

#define TEXT(name, s)                                                                                                  \
    {                                                                                                                  \
        name, bytes(s), sizeof(s) - 1                                                                                  \
    }

static struct block make_small(void)
{
    const struct lump lumps[] = { TEXT("data/a.txt", "alpha"), TEXT("gfx/b", ""), TEXT("script/main.lua", "return 1"),
                                  TEXT("z", "0123456789abcdef!") };

    return make(lumps, 4);
}

static uint8_t *entry(struct block b, uint32_t i)
{
    return b.p + ROM_HEADER_SIZE + (size_t)i * ROM_ENTRY_SIZE;
}

/* Makes the header's checksum good again. */
static void repair(struct block b)
{
    bytes_put32(b.p + 12, hash_crc32(b.p + 16, b.size - 16));
}

static void refused(struct block b, const char *sentence)
{
    char err[256] = "";
    struct rom rom;

    assert_false(rom_open(&rom, b.p, b.size, err, sizeof err));
    assert_string_equal(err, sentence);
    free(b.p);
}

static void opened(struct rom *rom, struct block b)
{
    char err[256] = "";
    bool good = rom_open(rom, b.p, b.size, err, sizeof err);

    assert_string_equal(err, "");
    assert_true(good);
}

TEST(round_trip)
{
    struct block b = make_small();
    struct rom rom;
    struct lump l;

    opened(&rom, b);
    assert_int_equal(rom.count, 4);
    assert_int_equal(rom.crc, bytes_get32(b.p + 12));
    assert_int_equal(rom_find(&rom, "script/main.lua"), 2);
    assert_int_equal(rom_find(&rom, "script/main"), -1);
    assert_int_equal(rom_find(&rom, "zz"), -1);
    assert_int_equal(rom_find_first(&rom, "gfx/"), 1);
    assert_int_equal(rom_find_first(&rom, "zz"), 4);
    rom_lump(&rom, 3, &l);
    assert_string_equal(l.name, "z");
    assert_int_equal(l.size, 17);
    assert_memory_equal(l.data, "0123456789abcdef!", 17);
    assert_int_equal((l.data - b.p) % ROM_ALIGN, 0);
    free(b.p);
    b = make(NULL, 0);
    opened(&rom, b);
    assert_int_equal(rom_find(&rom, "a"), -1);
    free(b.p);
}

TEST(too_large)
{
    struct lump lumps[2] = { { "a", NULL, UINT32_MAX - 100 }, { "b", NULL, 100 } };

    assert_int_equal(rom_write_size(lumps, 2), 0);
    assert_true(rom_write_size(lumps, 1) > 0);
}

/* A name of n letters. */
static const char *letters(char *out, size_t n)
{
    memset(out, 'n', n);
    out[n] = '\0';
    return out;
}

TEST(names)
{
    char name[200];

    assert_true(rom_name_ok(letters(name, ROM_MAX_NAME - 1)));
    assert_false(rom_name_ok(letters(name, ROM_MAX_NAME)));
    assert_false(rom_name_ok(""));
    assert_false(rom_name_ok("\xc3\xa4"));
}

/* Cut anywhere, also when the header's length and checksum are those of the rest. */
TEST(cut_anywhere)
{
    struct block whole = make_small();
    struct rom rom;

    for (size_t n = 0; n < whole.size; n++) {
        char err[256] = "";
        uint8_t *cut = malloc(n + (n == 0));
        memcpy(cut, whole.p, n);
        assert_false(rom_open(&rom, cut, n, err, sizeof err));
        assert_string_not_equal(err, "");
        if (n >= ROM_HEADER_SIZE) {
            bytes_put32(cut + 20, (uint32_t)n);
            repair((struct block){ cut, n });
            assert_false(rom_open(&rom, cut, n, err, sizeof err));
        }
        free(cut);
    }
    free(whole.p);
}

TEST(header)
{
    static const struct {
        int at;
        uint32_t value;
        const char *why;
    } spoilt[] = { { 0, 0, "not a Curtain ROM" },
                   { 4, 0, "not a Curtain ROM" },
                   { 8, 2, "unknown ROM format 2 (this program reads format 1)" },
                   { 24, 1, "reserved header bytes are not zero" },
                   { 28, 0x01000000, "reserved header bytes are not zero" },
                   { 16, 0xffffffff, "the directory of 4294967295 lumps runs past the end" } };
    struct block b = make_small();
    char want[80];

    snprintf(want, sizeof want, "%zu bytes long, but its header says %zu", b.size + 1, b.size);
    b.p = realloc(b.p, ++b.size);
    b.p[b.size - 1] = 0;
    refused(b, want);
    refused((struct block){ calloc(1, 31), 31 }, "too short for a ROM (31 bytes)");
    for (size_t i = 0; i < sizeof spoilt / sizeof *spoilt; i++) {
        b = make_small();
        bytes_put32(b.p + spoilt[i].at, spoilt[i].value);
        repair(b);
        refused(b, spoilt[i].why);
    }
    b = make_small();
    b.p[b.size - 1] ^= 1;
    refused(b, "damaged: the checksum does not match");
}

/* Field 0 to 3 (name, data, size, CRC) of lump i becomes v; only the header's checksum is made good. */
static struct block with(uint32_t i, int field, uint32_t v)
{
    struct block b = make_small();

    bytes_put32(entry(b, i) + field * 4, v);
    repair(b);
    return b;
}

TEST(directory)
{
    struct block b = make_small();
    uint32_t size = (uint32_t)b.size, name2 = bytes_get32(entry(b, 2)), data0 = bytes_get32(entry(b, 0) + 4);

    free(b.p);
    refused(with(1, 0, ROM_HEADER_SIZE), "lump 1: its name is outside the file");
    refused(with(1, 0, size), "lump 1: its name is outside the file");
    refused(with(1, 0, 0xffffffff), "lump 1: its name is outside the file");
    refused(with(3, 0, size - 1), "lump 3: its name is outside the file"); /* no NUL from there on */
    refused(with(1, 0, name2 - 1), "lump 1: its name is empty, too long or not plain ASCII");
    refused(with(3, 0, name2), "lump 3 \"script/main.lua\" is out of order (lumps are sorted by name)");
    refused(with(0, 0, name2), "lump 1 \"gfx/b\" is out of order (lumps are sorted by name)");
    refused(with(2, 1, data0 + 1), "lump 2 \"script/main.lua\" is not aligned to 16 bytes");
    refused(with(2, 1, 0xfffffff0), "lump 2 \"script/main.lua\" runs past the end");
    refused(with(2, 2, 0xffffffff), "lump 2 \"script/main.lua\" runs past the end");
    refused(with(2, 1, data0), "lump 2 \"script/main.lua\" overlaps the lump before it");
    refused(with(0, 1, 0), "lump 0 \"data/a.txt\" overlaps the lump before it");
    refused(with(2, 3, 0), "lump 2 \"script/main.lua\" is damaged: its checksum does not match");
}

TEST(hashes)
{
    struct lump lumps[] = { TEXT("data/a.txt", "alpha"), TEXT("demo/d", "demo"),
                            TEXT("font", "font"),        TEXT("gfx/b", "pix"),
                            TEXT("hit/b", "shape"),      TEXT("manifest", "m"),
                            TEXT("palette/main", "p"),   TEXT("script/main.lua", "return 1"),
                            TEXT("shades", "s") };
    const bool in_game[] = { true, false, false, false, true, true, false, true, false };
    struct block b = make(lumps, 9);
    struct rom rom;
    uint64_t all, game;

    opened(&rom, b);
    all = rom_hash(&rom);
    game = rom_game_hash(&rom);
    free(b.p);
    for (int i = 0; i < 9; i++) {
        struct lump was = lumps[i];
        lumps[i].data = bytes("x");
        lumps[i].size = 1;
        b = make(lumps, 9);
        opened(&rom, b);
        assert_true(rom_hash(&rom) != all);
        assert_int_equal(rom_game_hash(&rom) != game, in_game[i]);
        free(b.p);
        lumps[i] = was;
    }
}

/* ---- carts ---- */

enum { FULL = 7, GFX = 4 * 8 + CART_GFX_HEADER_SIZE };

/* The lumps of a ROM that runs; a test spoils one. */
struct full {
    struct manifest m;
    uint32_t manifest_size;
    uint8_t manifest[MANIFEST_BYTES], palette[CART_PALETTE_SIZE], font[2 * CART_GLYPH_SIZE], gfx[GFX];
    struct lump lumps[FULL];
};

static void full_init(struct full *f)
{
    uint8_t *g = f->gfx;

    memset(f, 0, sizeof *f);
    manifest_set_defaults(&f->m);
    f->manifest_size = manifest_pack(&f->m, f->manifest);
    f->palette[3] = 0xaa;
    f->font[64] = 15;
    bytes_put16(g, 5); /* w h pitch ox oy frames every rotations bank */
    bytes_put16(g + 2, 2);
    bytes_put16(g + 4, 8);
    bytes_put16(g + 6, 2);
    bytes_put16(g + 8, (uint16_t)-1);
    bytes_put16(g + 10, 2);
    bytes_put16(g + 12, 6);
    bytes_put16(g + 14, 1);
    bytes_put16(g + 16, 3);
    g[24] = 0x31;
    g[24 + 4] = 0x3f;
    const struct lump lumps[FULL] = {
        TEXT("data/names.txt", "Ann"),
        { "font", f->font, sizeof f->font },
        { "gfx/a", f->gfx, sizeof f->gfx },
        { "gfx/orb", f->gfx, sizeof f->gfx },
        { "manifest", f->manifest, f->manifest_size },
        { "palette/main", f->palette, sizeof f->palette },
        TEXT("script/main.lua", "return 1"),
    };
    memcpy(f->lumps, lumps, sizeof lumps);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const struct lump *)a)->name, ((const struct lump *)b)->name);
}

/* The ROM and cart that were opened last. */
static struct {
    struct block b;
    struct rom rom;
    struct cart cart;
    char err[256];
} last;

/* Opens f's lumps and n more, but not the one at `skip`. */
static bool open_with(const struct full *f, int skip, const struct lump *more, int n)
{
    struct lump lumps[FULL + 4];
    int count = 0;

    for (int i = 0; i < FULL; i++)
        if (i != skip)
            lumps[count++] = f->lumps[i];
    for (int i = 0; i < n; i++)
        lumps[count++] = more[i];
    qsort(lumps, (size_t)count, sizeof *lumps, by_name);
    free(last.b.p);
    last.b = make(lumps, count);
    opened(&last.rom, last.b);
    last.err[0] = '\0';
    return cart_open(&last.cart, &last.rom, last.err, sizeof last.err);
}

static void full_refused(const struct full *f, int skip, const char *sentence)
{
    assert_false(open_with(f, skip, NULL, 0));
    assert_string_equal(last.err, sentence);
}

TEST(cart)
{
    const struct cart *cart = &last.cart;
    struct full f;
    struct sprite s;
    char name[200];
    const char *text;
    size_t size;

    full_init(&f);
    assert_true(open_with(&f, -1, NULL, 0));
    assert_string_equal(cart->manifest.title, "Untitled");
    assert_int_equal(cart->count[CART_SPRITES], 2);
    assert_int_equal(cart->n_glyphs, 2);
    assert_int_equal(cart->glyphs[64], 15);
    assert_int_equal(cart_find(cart, CART_SPRITES, "orb"), 1);
    assert_int_equal(cart_find(cart, CART_SPRITES, "or"), -1);
    assert_int_equal(cart_find(cart, CART_SPRITES, letters(name, 150)), -1);
    assert_string_equal(cart_name(cart, CART_SPRITES, 1), "orb");
    cart_sprite(cart, 1, &s);
    assert_true(s.w == 5 && s.h == 2 && s.pitch == 8 && s.ox == 2 && s.oy == -1);
    assert_true(s.frames == 2 && s.frame_ticks == 6 && s.rotations == 1 && s.bank == 3);
    assert_int_equal(s.pix[4], 0x3f);
    assert_int_equal(cart_palette(cart, "main")[3], 0xaa);
    assert_null(cart_palette(cart, "dusk"));
    assert_true(cart_find_script(cart, "main", &text, &size));
    assert_int_equal(size, 8);
    assert_memory_equal(text, "return 1", 8);
    assert_false(cart_find_script(cart, letters(name, 150), &text, &size));
    assert_true(cart_find_text(cart, "names.txt", &text, &size));
    assert_memory_equal(text, "Ann", 3);
    assert_false(cart_find_text(cart, "main", &text, &size));
}

TEST(cart_blends)
{
    static uint8_t tables[4][CART_BLEND_SIZE];
    struct lump more[] = { { "blend/a", tables[0], CART_BLEND_SIZE },
                           { "blend/b", tables[1], CART_BLEND_SIZE },
                           { "blend/c/d", tables[2], CART_BLEND_SIZE },
                           { "blend/e", tables[3], CART_BLEND_SIZE } };
    struct full f;

    full_init(&f);
    for (int i = 0; i < 4; i++)
        tables[i][65535] = (uint8_t)(i + 1);
    assert_true(open_with(&f, -1, more, 3));
    assert_int_equal(last.cart.count[CART_BLENDS], 3);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(last.cart.main_tables.blend[i][65535], i + 1);
        assert_int_equal(cart_find(&last.cart, CART_BLENDS, cart_name(&last.cart, CART_BLENDS, i)), i);
    }
    assert_string_equal(cart_name(&last.cart, CART_BLENDS, 2), "c/d");
    assert_false(open_with(&f, -1, more, 4));
    assert_string_equal(last.err, "4 lumps named \"blend/...\", expected at most 3");
    more[1].size--;
    assert_false(open_with(&f, -1, more, 2));
    assert_string_equal(last.err, "lump \"blend/b\": 65535 bytes long, expected 65536");
}

/* Older ROMs have no tables of shades. */
TEST(cart_shades)
{
    static uint8_t tables[CART_SHADES_SIZE + 1];
    struct lump shades = { "shades", tables, CART_SHADES_SIZE };
    struct full f;

    full_init(&f);
    tables[CART_SHADES_SIZE - 1] = 77;
    assert_true(open_with(&f, -1, NULL, 0));
    assert_null(last.cart.main_tables.shades);
    assert_true(open_with(&f, -1, &shades, 1));
    assert_int_equal(last.cart.main_tables.shades[CART_SHADES_SIZE - 1], 77);
    shades.size++;
    assert_false(open_with(&f, -1, &shades, 1));
    assert_string_equal(last.err, "lump \"shades\": 769 bytes long, expected 768");
}

/* Opens a cart with a hitbox for the sprite of that name, in `size` bytes. */
static bool open_hit(const struct cart_hitbox *hit, const char *name, uint32_t size)
{
    uint8_t bytes_of[CART_HITBOX_SIZE + 1] = { 0 };
    const struct lump lump = { name, bytes_of, size };
    struct full f;

    full_init(&f);
    cart_pack_hitbox(hit, bytes_of);
    return open_with(&f, -1, &lump, 1);
}

static void hit_refused(const struct cart_hitbox *hit, const char *name, uint32_t size, const char *sentence)
{
    assert_false(open_hit(hit, name, size));
    assert_string_equal(last.err, sentence);
}

/* The lengths of a hitbox are at least 0 and within reach, and unused fields are 0. */
TEST(cart_hits)
{
    enum { PX = 65536, FAR = 8191 * PX };
    static const char bad[] = "lump \"hit/orb\": not a hitbox";
    const struct cart_hitbox good[] = {
        { 1, 1, { { FAR, 0, 0, 0 } } },
        { 2, 1, { { 3 * PX, FAR, 0, 0 } } },
        { 4, 1, { { 3 * PX, 0, 7 * PX, 0 } } },
        { 8, 2, { { PX, 0, -5 * PX, 2 }, { 2 * PX, 0, FAR - 4 * PX, -2 * PX } } },
    };
    const struct cart_hitbox wrong[] = {
        { 0, 1, { { PX, 0, 0, 0 } } },
        { 3, 1, { { PX, 0, 0, 0 } } },
        { 1, 0, { { 0, 0, 0, 0 } } },
        { 1, 2, { { PX, 0, 0, 0 }, { PX, 0, 0, 0 } } },
        { 8, 5, { { PX, 0, 0, 0 } } },
        { 1, 1, { { -1, 0, 0, 0 } } },
        { 1, 1, { { FAR + 1, 0, 0, 0 } } },
        { 1, 1, { { PX, 1, 0, 0 } } },
        { 2, 1, { { PX, -1, 0, 0 } } },
        { 2, 1, { { PX, FAR + 1, 0, 0 } } },
        { 4, 1, { { PX, 0, FAR, 0 } } },
        { 8, 1, { { PX, 0, 0, 0 }, { 0, 0, 1, 0 } } },
        { 8, 2, { { PX, 0, 0, 0 }, { PX, 0, INT32_MIN, 0 } } },
    };
    struct cart_hitbox found = { 0 };

    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        assert_true(open_hit(&good[i], "hit/orb", CART_HITBOX_SIZE));
        assert_true(cart_find_hitbox(&last.cart, "orb", &found));
        assert_memory_equal(&found, &good[i], sizeof found);
        assert_false(cart_find_hitbox(&last.cart, "a", &found));
    }
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        hit_refused(&wrong[i], "hit/orb", CART_HITBOX_SIZE, bad);
    hit_refused(&good[0], "hit/orb", CART_HITBOX_SIZE - 1, bad);
    hit_refused(&good[0], "hit/other", CART_HITBOX_SIZE, "lump \"hit/other\": no sprite has this name");
}

TEST(cart_lumps)
{
    struct full f;

    full_init(&f);
    assert_true(open_with(&f, 1, NULL, 0)); /* without a font */
    full_refused(&f, 4, "no lump \"manifest\"");
    full_refused(&f, 5, "no lump \"palette/main\"");
    full_refused(&f, 6, "no lump \"script/main.lua\", the entry script");
    f.m.bullets = 5000000;
    manifest_pack(&f.m, f.manifest);
    full_refused(&f, -1, "lump \"manifest\": board.bullets: expected a whole number from 0 to 4194304, got 5000000");
    full_init(&f);
    f.lumps[5].size--;
    full_refused(&f, -1, "lump \"palette/main\": 767 bytes long, expected 768");
    full_init(&f);
    f.lumps[1].size--;
    full_refused(&f, -1, "lump \"font\": 127 bytes long, expected 64 bytes for each of 1 to 224 characters");
    f.lumps[1].size = 0;
    full_refused(&f, -1, "lump \"font\": 0 bytes long, expected 64 bytes for each of 1 to 224 characters");
    full_init(&f);
    f.font[100] = 16;
    full_refused(&f, -1, "lump \"font\": shade 16 in character 33, expected 0 to 15");
}

TEST(sprite_size)
{
    struct full f;

    full_init(&f);
    f.lumps[2].size = 23;
    full_refused(&f, -1, "lump \"gfx/a\": too short for a sprite (23 bytes)");
    f.lumps[2].size = sizeof f.gfx - 1;
    full_refused(&f, -1, "lump \"gfx/a\": 55 bytes long, its header says 56");
    full_init(&f);
    bytes_put16(f.gfx + 2, 1024); /* the largest header there is needs 64 bits */
    bytes_put16(f.gfx + 4, 1024);
    bytes_put16(f.gfx + 10, 256);
    bytes_put16(f.gfx + 14, 256);
    full_refused(&f, -1, "lump \"gfx/a\": 56 bytes long, its header says 68719476760");
}

TEST(sprite_header)
{
    static const int wrong[][2] = { { 0, 0 },     { 0, 9 },    { 0, 1025 },  { 2, 0 },    { 2, 1025 }, { 4, 12 },
                                    { 6, -1025 }, { 6, 2049 }, { 8, -1025 }, { 8, 2049 }, { 10, 0 },   { 10, 257 },
                                    { 12, 0 },    { 14, 0 },   { 14, 257 },  { 16, 16 },  { 18, 99 },  { 22, 1 } };
    struct full f;

    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        full_init(&f);
        bytes_put16(f.gfx + wrong[i][0], (uint16_t)wrong[i][1]);
        full_refused(&f, -1, "lump \"gfx/a\": its header is out of range");
    }
}

TEST(sprite_pixels)
{
    static const uint8_t wrong[][2] = { { 24, 0x41 }, { 24, 0x30 }, { 24, 1 }, { 29, 0x31 }, { 31, 0x31 } };
    struct full f;

    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        full_init(&f);
        f.gfx[wrong[i][0]] = wrong[i][1];
        full_refused(&f, -1, "lump \"gfx/a\": row 0 has a pixel beyond its width or with a colour outside bank 3");
    }
    full_init(&f);
    f.gfx[GFX - 1] = 0x31;
    full_refused(&f, -1, "lump \"gfx/a\": row 3 has a pixel beyond its width or with a colour outside bank 3");
}

RUN_TESTS(NULL, NULL)
