/*
 * test_pack_font.c - fonts on their way into a ROM: which characters a script shows, BDF files and each way in which
 * one is refused, pictures with a grid of cells, shadows, and the lump.
 */
#include "../test.h"
#include "../../src/base/bytes.h"
#include "../../src/rom/face.h"
#include "../../src/workbench/pack/bdf.h"

static struct pack_font_chars set;
static struct pack_font f;
static char err[512];

static int count(void)
{
    int n = 0;

    for (uint32_t c = 0; c <= UTF8_MAX_CODE; c++)
        n += pack_font_has(&set, c);
    return n;
}

TEST(set)
{
    static const char script[] =
        "local a = 'x\xc3\xa9' -- \xc3\xa4 is not shown\n--[[ nor\n\xc3\xb6 ]] local b = \"\\\"--\\u{5f3e}\\\\\"\n"
        "--[==[ ]] \xc3\xbc ]==] c = [[\xe5\xb9\x95]] d = '\\'\xc3\x9f";

    memset(&set, 0, sizeof set);
    pack_font_add_script(&set, script, sizeof script - 1);
    assert_true(pack_font_has(&set, 0xe9) && pack_font_has(&set, 0x5f3e) && pack_font_has(&set, 0x5e55) &&
                pack_font_has(&set, 0xdf));
    assert_false(pack_font_has(&set, 0xe4) || pack_font_has(&set, 0xf6) || pack_font_has(&set, 0xfc));
    assert_false(pack_font_has(&set, UTF8_MAX_CODE + 1) || pack_font_has(&set, UINT32_MAX));
    for (size_t n = 0; n < sizeof script; n++) { /* nothing is read beyond the end */
        char *cut = malloc(n + (n == 0));
        memcpy(cut, script, n);
        pack_font_add_script(&set, cut, n);
        free(cut);
    }
    memset(&set, 0, sizeof set);
    pack_font_add_text(&set, "a\xf4\x8f\xbf\xbf\xff", 6);
    assert_true(pack_font_has(&set, 'a') && pack_font_has(&set, UTF8_MAX_CODE) && pack_font_has(&set, 0xff) &&
                count() == 3);
    pack_font_add_script(&set, "'\\u{110000}\\u{ffffffffff}'", 26);
    assert_int_equal(count(), 3 + 5); /* {10f} */
}

#define HEAD                                                                                                           \
    "STARTFONT 2.1\nFONT -x\nFONTBOUNDINGBOX 8 9 0 -2\nSTARTPROPERTIES 2\nFONT_ASCENT 7\nFONT_DESCENT 2\n"             \
    "CHARSET_REGISTRY \"ISO10646\"\nENDPROPERTIES\nCHARS 3\n"
#define LETTER_A "STARTCHAR A\nENCODING 65\nSWIDTH 1 0\nDWIDTH 5 0\nBBX 4 3 -1 0\nBITMAP\n90\n60\nF0\nENDCHAR\n"

TEST(bdf)
{
    static const char text[] =
        HEAD "STARTCHAR dan\r\nENCODING 24382\r\nDWIDTH 9 0\r\nBBX 9 1 0 -2\r\nBITMAP\r\n8080\r\nENDCHAR\r\n" LETTER_A
             "STARTCHAR no\nENCODING -1 7\nDWIDTH 5 0\nBBX 1 1 0 0\nBITMAP\n80\nENDCHAR\n"
             "STARTCHAR B\nENCODING 66\nDWIDTH 5 0\nBBX 1 1 0 0\nBITMAP\n80\nENDCHAR\n"
             "STARTCHAR space\nENCODING 32\nDWIDTH 3 0\nBBX 0 0 0 0\nBITMAP\nENDCHAR\nENDFONT\n";

    memset(&set, 0, sizeof set);
    pack_font_add_text(&set, " A\xe5\xbc\xbe\xe5\xb9\x95", 8);
    if (!bdf_read(&f, text, sizeof text - 1, &set, err, sizeof err))
        fail_msg("%s", err);
    assert_int_equal(f.n, 3);
    assert_int_equal(f.height, 9);
    const struct pack_font_glyph *a = &f.list[1], *dan = &f.list[2];
    assert_true(a->code == 65 && a->w == 4 && a->h == 3 && a->x == -1 && a->y == 4 && a->advance == 5);
    assert_memory_equal(a->pix, "\17\0\0\17\0\17\17\0\17\17\17\17", 12);
    assert_true(dan->code == 0x5f3e && dan->w == 9 && dan->y == 8 && dan->pix[0] == 15 && dan->pix[8] == 15);
    assert_true(f.list[0].code == 32 && f.list[0].w == 0 && f.list[0].advance == 3);

    uint8_t *lump;
    struct face face;
    struct face_glyph g;
    size_t size = pack_font_make(&f, &lump);
    assert_int_equal(size, 8 + 3 * 16 + 3 * 8 + 16);
    assert_true(face_open(&face, lump, size, err, sizeof err) && face.height == 9 && face.n == 3);
    assert_true(face_find(&face, 65, &g) && g.w == 4 && g.h == 3 && g.pitch == 8 && g.x == -1 && g.y == 4);
    assert_true(g.advance == 5 && g.pix[8 + 1] == 15 && g.pix[8 + 4] == 0);
    assert_true(face_find(&face, 0x5f3e, &g) && g.pitch == 16 && face_find(&face, 32, &g) && g.advance == 3);
    assert_false(face_find(&face, 66, &g) || face_find(&face, 0, &g) || face_find(&face, UINT32_MAX, &g));
    free(lump);

    assert_true(pack_font_add_shadow(&f));
    assert_true(f.list[1].w == 5 && f.list[1].h == 4 && f.list[0].w == 0);
    assert_memory_equal(f.list[1].pix, "\17\1\0\17\1\1\17\17\1\1\17\17\17\17\1\1\1\1\1\1", 20);
    pack_font_darken(&f, 13);
    assert_memory_equal(f.list[1].pix, "\15\1\0\15\1\1\15\15\1\1\15\15\15\15\1\1\1\1\1\1", 20);
    pack_font_free(&f);
}

static void refused(const char *text, const char *want)
{
    char *copy = malloc(strlen(text) + 1); /* of exactly this size */

    memcpy(copy, text, strlen(text));
    assert_false(bdf_read(&f, copy, strlen(text), &set, err, sizeof err));
    assert_string_equal(err, want);
    pack_font_free(&f);
    free(copy);
}

TEST(bdf_refused)
{
    memset(&set, 0xff, sizeof set);
    refused("", "line 0: expected STARTFONT: not a BDF file");
    refused(HEAD "ENDFONT", "line 10: no characters");
    refused("STARTFONT 2.1\nFONT_ASCENT many\n",
            "line 2: expected 1 numbers from -32768 to 32767, got \"FONT_ASCENT many\"");
    refused("STARTFONT 2.1\nFONT_ASCENT 7\nSTARTCHAR A\n",
            "line 3: the header has no FONT_DESCENT and no FONTBOUNDINGBOX");
    refused("STARTFONT 2.1\nMETRICSSET 1\n", "line 2: vertical fonts are not supported");
    refused("STARTFONT 2.3\nSIZE 9 75 75 3\n", "line 2: 3 bits per pixel; expected 1, 2, 4 or 8");
    refused("STARTFONT 2.3\nSIZE 9 75 75 4\nBITS_PER_PIXEL 2\n", "line 3: 2 bits per pixel, but 4 in an earlier line");
    refused("STARTFONT 2.1\nFONT_ASCENT 0\nFONT_DESCENT 0\nSTARTCHAR A\n",
            "line 4: line height 0 px (ascent 0, descent 0); expected 1 to 128");
    refused(HEAD "STARTCHAR A\nENCODING 65", "line 11: the file ends inside a character");
    refused(HEAD "STARTCHAR A\nENCODING 65\nBITMAP\n", "line 12: BITMAP needs ENCODING and BBX before it");
    refused(HEAD "STARTCHAR A\nENCODING 65\nDWIDTH 9 0\nBBX 65 1 0 0\nBITMAP\n",
            "line 14: character of 65x1 px; expected at most 64 in each direction");
    refused(HEAD "STARTCHAR A\nENCODING 65\nDWIDTH 9\nBBX 8 1 0 500\nBITMAP\n00\n",
            "line 14: U+0041 is too far from the baseline");
    refused(HEAD "STARTCHAR A\nENCODING 65\nDWIDTH 9\nBBX 9 1 0 0\nBITMAP\n00\n",
            "line 15: expected a row of 4 hexadecimal digits, got \"00\"");
    refused(HEAD LETTER_A LETTER_A "ENDFONT", "duplicate character U+0041");
    refused(HEAD "STARTCHAR A\nENCODING 65\nBBX 1 1 0 0\nBITMAP\n80\n",
            "line 13: U+0041 has no DWIDTH, and the header has none");
    refused(HEAD "STARTCHAR A\nENCODING 65\nDWIDTH -4 0\nBBX 1 1 0 0\nBITMAP\n80\n",
            "line 14: U+0041: DWIDTH -4 0; expected a width of 0 to 128 and a height of 0");
    refused(HEAD "STARTCHAR A\nENCODING 65\nDWIDTH 4 0\nENDCHAR\n", "line 13: character without BITMAP");
}

#define BOX               "FONTBOUNDINGBOX 4 7 0 -2\n"
#define DOT(name, number) "STARTCHAR " name "\nENCODING " number "\nDWIDTH 5 0\nBBX 1 1 0 0\nBITMAP\n80\nENDCHAR\n"

/* The code that becomes of a font's one character; 0: of none, or it is refused. */
static uint32_t code_in(const char *head, const char *letter)
{
    char text[1024];

    snprintf(text, sizeof text, "STARTFONT 2.1\n" BOX "%s%sENDFONT\n", head, letter);
    const bool good = bdf_read(&f, text, strlen(text), &set, err, sizeof err);
    const uint32_t code = good && f.n == 1 ? f.list[0].code : 0;
    pack_font_free(&f);
    return code;
}

/* Registry and encoding together say what the numbers are. */
TEST(bdf_charset)
{
    static const struct {
        const char *registry, *encoding, *letter;
        uint32_t code;
    } rows[] = {
        { "ISO10646", "1", DOT("x", "261"), 261 },
        { "iso10646", "", DOT("x", "261"), 261 },
        { "ISO8859", "1", DOT("x", "177"), 177 },
        { "ISO8859", "1", DOT("x", "261"), 0 },
        { "ISO8859", "2", DOT("x", "177"), 0x105 },
        { "ISO8859", "3", DOT("x", "165"), 0 }, /* there is none */
        { "iso8859", "15", DOT("x", "164"), 0x20ac },
        { "ISO8859", "16", DOT("x", "254"), 0x21b },
        { "KOI8", "R", DOT("x", "128"), 0x2500 },
        { "US", "ASCII", DOT("x", "126"), 126 },
        { "Adobe", "FontSpecific", DOT("alpha", "97"), 97 },
        { "Adobe", "FontSpecific", DOT("uni03B1", "97"), 0x3b1 },
        { "Adobe", "FontSpecific", DOT("u1F600", "97"), 0x1f600 },
        { "ISO10646", "1", DOT("uni03B1", "97"), 97 },
    };

    memset(&set, 0xff, sizeof set);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char head[256];
        snprintf(head, sizeof head,
                 "STARTPROPERTIES 2\nCHARSET_ENCODING \"%s\"\nCHARSET_REGISTRY \"%s\"\nENDPROPERTIES\n",
                 rows[i].encoding, rows[i].registry);
        assert_int_equal(code_in(head, rows[i].letter), rows[i].code);
    }
    assert_int_equal(code_in("FONT -misc-fixed-medium-r-normal--8-80-75-75-c-50-iso8859-2\n", DOT("x", "177")), 0x105);
    assert_int_equal(code_in("FONT -misc-fixed-medium-r-normal--8-80-75-75-c-50-jisx0201.1976-0\n", DOT("x", "65")), 0);
    assert_non_null(strstr(err, "line 3: unsupported character set JISX0201.1976-0; expected ISO10646-1 (Unicode), "));
}

/* What the head says holds for all characters. */
TEST(bdf_head)
{
    static const char *const heads[] = {
        "FONT_DESCENT 2\nFONT_ASCENT 6\n" BOX "DWIDTH 6\nMETRICSSET 2\nDWIDTH1 0 9\n",
        "FONTBOUNDINGBOX 200 8 0 -2\nDWIDTH 6 0\nSWIDTH 1 2\n",
        "FONTBOUNDINGBOX 4 8 0 -2\nDWIDTH 6 0\nFONT_ASCENT 0\nFONT_DESCENT 0\n",
    };
    char text[1024];

    memset(&set, 0xff, sizeof set);
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
        snprintf(text, sizeof text,
                 "STARTFONT 2.1\n%sSTARTCHAR A\nENCODING 65\nBBX 4 1 0 0\nBITMAP\nCOMMENT a row\n 90\nENDCHAR\n"
                 "COMMENT STARTCHAR\nSTARTCHAR B\nDWIDTH 3 0\nDWIDTH1 1 2\nVVECTOR 1 2\nBBX 4 1 0 0\nENCODING 66\n"
                 "BITMAP\n60\nENDCHAR\nENDFONT\n",
                 heads[i]);
        if (!bdf_read(&f, text, strlen(text), &set, err, sizeof err))
            fail_msg("%s", err);
        assert_true(f.n == 2 && f.height == 8 && f.list[0].advance == 6 && f.list[1].advance == 3);
        assert_true(f.list[0].y == 5 && f.list[1].y == 5);
        assert_memory_equal(f.list[0].pix, "\17\0\0\17", 4);
        assert_memory_equal(f.list[1].pix, "\0\17\17\0", 4);
        pack_font_free(&f);
    }
}

/* Of greys, 0 is nothing and the greatest is ink. */
TEST(bdf_greys)
{
    static const struct {
        const char *head, *row, *shades;
    } greys[] = {
        { "SIZE 9 75 75 1", "90", "\17\0\0\17" },
        { "SIZE 9 75 75 2", "1B", "\0\5\12\17" },
        { "BITS_PER_PIXEL 4", "f017", "\17\0\1\7" },
        { "SIZE 9 75 75 8\nBITS_PER_PIXEL 8", "FF001880", "\17\0\1\10" },
    };
    char text[512];

    memset(&set, 0xff, sizeof set);
    for (size_t i = 0; i < sizeof greys / sizeof *greys; i++) {
        snprintf(text, sizeof text,
                 "STARTFONT 2.3\n%s\n" BOX
                 "STARTCHAR A\nENCODING 65\nDWIDTH 5 0\nBBX 4 1 0 0\nBITMAP\n%s\nENDCHAR\nENDFONT",
                 greys[i].head, greys[i].row);
        if (!bdf_read(&f, text, strlen(text), &set, err, sizeof err))
            fail_msg("%s", err);
        assert_memory_equal(f.list[0].pix, greys[i].shades, 4);
        pack_font_free(&f);
    }
}

/* A picture of two cells of 4 x 3 px, in bank 0 of the standard palette. */
TEST(cells)
{
    static const char *const dots[] = { ".#..#...", ".##.#...", "........" };
    static uint8_t rgb[CART_PALETTE_SIZE], rgba[8 * 3 * 4];
    static struct art_font font = { .w = 4, .h = 3, .chars = "\xc3\xa9i " };
    struct art_picture picture = { .rgba = rgba, .w = 8, .h = 3 };

    memset(&set, 0xff, sizeof set);
    art_default_palette(rgb);
    for (int i = 0; i < 24; i++)
        if (dots[i / 8][i % 8] == '#') {
            memcpy(rgba + 4 * i, rgb + 3 * 15, 3);
            rgba[4 * i + 3] = 255;
        }
    f = (struct pack_font){ 0 };
    assert_false(pack_font_cut(&f, &picture, &font, &set, rgb, false, err, sizeof err));
    assert_string_equal(err, "8x3 pixels hold 2 cells of 4x3, but `chars` has 3 characters");
    font.chars[3] = '\0';
    assert_true(pack_font_cut(&f, &picture, &font, &set, rgb, false, err, sizeof err));
    assert_true(f.n == 2 && f.height == 3 && f.list[0].code == 0xe9 && f.list[0].w == 2 && f.list[0].advance == 3);
    assert_memory_equal(f.list[0].pix, "\17\0\17\17\0\0", 6);
    assert_true(f.list[1].code == 'i' && f.list[1].w == 1 && f.list[1].advance == 2);
    pack_font_free(&f);
    font.fixed = true;
    set.bits[0xe9 / 8] = 0;
    assert_true(pack_font_cut(&f, &picture, &font, &set, rgb, false, err, sizeof err));
    assert_true(f.n == 1 && f.list[0].code == 'i' && f.list[0].w == 4 && f.list[0].advance == 4);
    pack_font_free(&f);
    rgba[16] ^= 0x55;
    assert_false(pack_font_cut(&f, &picture, &font, &set, rgb, false, err, sizeof err));
    assert_non_null(strstr(err, "pixel 4,0: colour #"));
    pack_font_free(&f);
}

static void spoilt(size_t at, uint8_t v, const char *want)
{
    static const char text[] = HEAD LETTER_A "STARTCHAR B\nENCODING 66\nDWIDTH 5 0\nBBX 1 1 0 0\nBITMAP\n80\nENDCHAR\n"
                                             "ENDFONT";
    struct face face;
    uint8_t *lump;

    memset(&set, 0xff, sizeof set);
    assert_true(bdf_read(&f, text, sizeof text - 1, &set, err, sizeof err));
    size_t size = pack_font_make(&f, &lump);
    assert_true(face_open(&face, lump, size, err, sizeof err));
    lump[at] = v;
    assert_false(face_open(&face, lump, size, err, sizeof err));
    assert_string_equal(err, want);
    pack_font_free(&f);
    free(lump);
}

TEST(lump)
{
    struct face face;

    assert_false(face_open(&face, (const uint8_t *)"1234567", 7, err, sizeof err));
    spoilt(0, 0, "its header is out of range");
    spoilt(2, 1, "its header is out of range");
    spoilt(7, 9, "its header is out of range");
    spoilt(8, 66, "glyph 1 is out of order (expected ascending codes)");
    spoilt(12, 39, "glyph 0 is out of range");
    spoilt(15, 1, "glyph 0 is out of range");
    spoilt(17, 65, "glyph 0 is out of range");
    spoilt(20, 129, "glyph 0 is out of range");
    spoilt(23, 1, "glyph 0 is out of range");
    spoilt(40, 16, "glyph 0 is out of range");
    spoilt(44, 1, "glyph 0 is out of range"); /* beyond its width */
    spoilt(64, 255, "glyph 1 is out of range");
}

RUN_TESTS(NULL, NULL)
