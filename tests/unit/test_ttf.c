/*
 * test_ttf.c - TrueType fonts on their way into a ROM: the pixels of simple glyphs and of glyphs made of others, both
 * kinds of character maps, each way in which a font is refused, and fonts that are damaged anywhere.
 */
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/workbench/pack/ttf.h"

enum { TABLES = 7, GLYPHS = 5, UNITS = 8, MOST = 2048 };
enum { CMAP, GLYF, HEAD, HHEA, HMTX, LOCA, MAXP };

/* A font of 8 units per em: A is an L of 1 unit wide strokes, B is A moved by (2, 1), C is B moved by (1, 0), the space
 * is empty. */
struct font {
    uint8_t bytes[MOST];
    size_t n, table[TABLES];
};

static struct font font;
static struct pack_font f;
static struct pack_font_chars set;
static char err[256];

static void put16(int v)
{
    font.bytes[font.n++] = (uint8_t)(v >> 8);
    font.bytes[font.n++] = (uint8_t)v;
}

static void put_words(const int *v, size_t n)
{
    for (size_t i = 0; i < n; i++)
        put16(v[i]);
}
#define PUT(...) put_words((const int[]){ __VA_ARGS__ }, sizeof((const int[]){ __VA_ARGS__ }) / sizeof(int))

static void set16(size_t at, int v)
{
    font.bytes[at] = (uint8_t)(v >> 8);
    font.bytes[at + 1] = (uint8_t)v;
}

/* Starts a table. */
static void start(int table)
{
    font.table[table] = font.n;
    set16(12 + 16 * (size_t)table + 10, (int)font.n);
}

static void end(int table)
{
    set16(12 + 16 * (size_t)table + 14, (int)(font.n - font.table[table]));
}

static void put_map(bool groups)
{
    start(CMAP);
    PUT(0, 1, 3, groups ? 10 : 1, 0, 12);
    if (groups) /* space: 1; A to C: 2 to 4 */
        PUT(12, 0, 0, 40, 0, 0, 0, 2, 0, ' ', 0, ' ', 0, 1, 0, 'A', 0, 'C', 0, 2);
    else
        PUT(4, 40, 0, 6, 0, 0, 0, ' ', 'C', 0xffff, 0, ' ', 'A', 0xffff, 1 - ' ', 2 - 'A', 1, 0, 0, 0);
    end(CMAP);
}

static void put_glyphs(void)
{
    size_t at[GLYPHS + 1] = { 0 };

    start(GLYF);
    at[2] = font.n - font.table[GLYF];
    PUT(1, 0, 0, 3, 5, 5, 0);
    for (int i = 0; i < 3; i++) /* flags, two a word: on the curve */
        PUT(0x0101);
    PUT(0, 3, 0, -2, 0, -1); /* x */
    PUT(0, 0, 1, 0, 4, 0);   /* y */
    at[3] = font.n - font.table[GLYF];
    PUT(-1, 0, 0, 0, 0, 2 /* distances, bytes */, 2, 0x0201);
    at[4] = font.n - font.table[GLYF];
    PUT(-1, 0, 0, 0, 0, 3 /* distances, words */, 3, 1, 0);
    at[5] = font.n - font.table[GLYF];
    end(GLYF);
    start(LOCA);
    for (int i = 0; i <= GLYPHS; i++)
        put16((int)at[i] / 2);
    end(LOCA);
}

static void make_font(bool groups)
{
    static const char tags[] = "cmapglyfheadhheahmtxlocamaxp";

    memset(&font, 0, sizeof font);
    PUT(1, 0, TABLES, 0, 0, 0);
    for (int i = 0; i < TABLES; i++, font.n += 16)
        memcpy(font.bytes + font.n, tags + 4 * i, 4);
    put_map(groups);
    put_glyphs();
    start(HEAD);
    font.n += 54;
    set16(font.table[HEAD] + 18, UNITS);
    end(HEAD);
    start(HHEA);
    font.n += 36;
    set16(font.table[HHEA] + 4, 6);
    set16(font.table[HHEA] + 6, -2);
    set16(font.table[HHEA] + 34, 2);
    end(HHEA);
    start(HMTX); /* that of the space is that of all after it */
    PUT(0, 0, 4, 0, 0, 0, 0);
    end(HMTX);
    start(MAXP);
    PUT(0, 0, GLYPHS);
    end(MAXP);
    memset(&set, 0, sizeof set);
    pack_font_add_text(&set, " ABCD", 5);
}

/* Reads the font from a block of exactly its size. */
static bool read_font(const uint8_t *bytes, size_t n, int size)
{
    uint8_t *copy = malloc(n + (n == 0));

    memcpy(copy, bytes, n);
    err[0] = '\0';
    const bool good = ttf_read(&f, copy, n, size, &set, err, sizeof err);
    assert_true(good == (err[0] == '\0'));
    free(copy);
    return good;
}

static void glyph_is(int i, uint32_t code, int x, int y, const char *rows)
{
    const struct pack_font_glyph *g = &f.list[i];

    assert_int_equal(g->code, code);
    assert_int_equal(g->w * g->h, strlen(rows));
    assert_true(g->x == x && g->y == y);
    for (int k = 0; rows[k]; k++)
        assert_int_equal(g->pix[k], rows[k] == '#' ? 15 : 0);
}

TEST(pixels)
{
    for (int groups = 0; groups < 2; groups++) {
        make_font(groups);
        if (!read_font(font.bytes, font.n, 8))
            fail_msg("%s", err);
        assert_true(f.n == 4 && f.height == 8);
        assert_int_equal(f.list[0].advance, 4);
        glyph_is(0, ' ', 0, 6, "");
        glyph_is(1, 'A', 0, 1, "#..#..#..#..###");
        glyph_is(2, 'B', 2, 0, "#..#..#..#..###");
        glyph_is(3, 'C', 3, 0, "#..#..#..#..###");
        pack_font_free(&f);
    }
    assert_true(read_font(font.bytes, font.n, 16));
    glyph_is(1, 'A', 0, 2, "##....##....##....##....##....##....##....##....############");
    assert_true(f.height == 16 && f.list[1].advance == 8);
    pack_font_free(&f);
}

static void refused(const char *want, int size)
{
    assert_false(read_font(font.bytes, font.n, size));
    assert_string_equal(err, want);
    pack_font_free(&f);
    make_font(false);
}

TEST(refused)
{
    make_font(false);
    font.n = 3;
    refused("table directory: missing or damaged", 8);
    memcpy(font.bytes, "wOFF", 4);
    refused("not a TrueType font", 8);
    memcpy(font.bytes, "OTTO", 4);
    refused("an OpenType font with PostScript outlines; convert it to a TrueType font (.ttf)", 8);
    memcpy(font.bytes, "ttcf", 4);
    refused("a collection of fonts; convert it to a TrueType font (.ttf)", 8);
    set16(4, 200);
    refused("table directory: missing or damaged", 8);
    font.bytes[12 + 16 * LOCA] = 'L';
    refused("loca: missing or damaged", 8);
    set16(12 + 16 * GLYF + 8, 9);
    refused("glyf: missing or damaged", 8);
    set16(font.table[MAXP] + 4, GLYPHS + 1);
    refused("loca: missing or damaged", 8);
    set16(font.table[HEAD] + 18, 0);
    refused("head: missing or damaged", 8);
    set16(font.table[HHEA] + 34, 9);
    refused("hmtx: missing or damaged", 8);
    set16(font.table[CMAP] + 2, 900);
    refused("cmap: missing or damaged", 8);
    set16(font.table[CMAP] + 6, 0);
    refused("no Unicode character map (cmap of format 4 or 12)", 8);
    set16(font.table[HHEA] + 4, 2000);
    refused("line height 2002 px; expected 1 to 128", 8);
    set16(font.table[GLYF] + 10, 900);
    refused("U+0041: the outline is damaged or not supported", 8);
    set16(font.table[LOCA] + 6, 900);
    refused("U+0041: the outline is damaged or not supported", 8);
    set16(font.table[GLYF] + 22, 900); /* x of the second point */
    refused("U+0041: 900x5 px; expected at most 64 in each direction", 8);
    set16(font.table[LOCA] - 6, 4); /* C is made of C */
    refused("U+0043: the outline is damaged or not supported", 8);
    memset(&set, 0, sizeof set);
    refused("the font has no character that the game's text uses", 8);
}

/* Any byte may be wrong, and any rest may be missing. */
TEST(damaged)
{
    struct rng rng;

    rng_seed(&rng, 1);
    for (int groups = 0; groups < 2; groups++) {
        make_font(groups);
        for (size_t n = 0; n < font.n; n++) {
            read_font(font.bytes, n, 8);
            pack_font_free(&f);
        }
        for (int i = 0; i < 20000; i++) {
            struct font damaged = font;
            for (int k = 0; k < 1 + i % 3; k++)
                damaged.bytes[rng_below(&rng, font.n)] = (uint8_t)rng_below(&rng, 256);
            read_font(damaged.bytes, font.n, 1 + i % TTF_MAX_SIZE);
            pack_font_free(&f);
        }
    }
}

RUN_TESTS(NULL, NULL)
