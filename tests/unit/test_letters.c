/* test_letters.c - the canvas's larger face: each character is itself, texts are as wide as they say and stay there. */
#include <stdbool.h>
#include "../test.h"
#include "../../fb/utf8.h"
#include "../../src/base/rng.h"
#include "../../src/player/overlay/canvas.h"
#include "../../src/player/overlay/letters.h"

enum { W = 200, H = 100, MIDDLE = 40 };

static struct fb fb;
static uint32_t rgb[256];
static struct canvas canvas;

/* Where there is ink of a colour; x0 > x1: nowhere. */
struct ink {
    int x0, y0, x1, y1, n;
};

static int clear(void **state)
{
    static void *memory;

    (void)state;
    if (!memory) {
        memory = malloc(fb_size(W, H));
        assert_non_null(memory);
        fb_init(&fb, memory, W, H);
    }
    fb_fill(&fb, 0);
    canvas_open(&canvas, &fb, rgb);
    return 0;
}

static bool inked(int x, int y, enum canvas_colour c)
{
    return fb.pix[y * fb.pitch + x] == canvas.colour[c];
}

static struct ink look(enum canvas_colour c)
{
    struct ink ink = { W, H, -1, -1, 0 };

    for (int i = 0; i < W * H; i++) {
        int x = i % W, y = i / W;
        if (!inked(x, y, c))
            continue;
        ink.x0 = x < ink.x0 ? x : ink.x0;
        ink.x1 = x > ink.x1 ? x : ink.x1;
        ink.y0 = y < ink.y0 ? y : ink.y0;
        ink.y1 = y > ink.y1 ? y : ink.y1;
        ink.n++;
    }
    return ink;
}

static bool same(const struct letter *a, const struct letter *b)
{
    return a->w == b->w && !memcmp(a->rows, b->rows, sizeof a->rows);
}

/* No two of all there are look alike, but for a comma and the quotation mark that is one. */
TEST(every_character_is_itself)
{
    static struct letter all[400];
    int n = 0;

    for (uint32_t code = '!'; code < 0x3000; code++) {
        if (!letter_exists(code) || code == 0xA0 || code == 0x2610 || code == 0x201A)
            continue;
        assert_true(n < 400);
        letter_load(&all[n], code);
        assert_true(all[n].w >= 1 && all[n].w <= 8);
        for (int i = 0; i < n; i++)
            assert_false(same(&all[i], &all[n]));
        n++;
    }
    assert_true(n > 280);
}

TEST(what_is_promised_is_there)
{
    static const char text[] = "\u2190\u2192\u2191\u2193"  /* arrows */
                               "\u25CB\u2715\u25A1\u25B3"  /* circle, cross, square, triangle */
                               "\u25A0\u2610\u2611\u2713"  /* boxes and a tick */
                               "\u2026\u00A9\u00D7\u2013"; /* ellipsis, copyright, times, dash */
    const char *s = text;
    struct letter unknown, box;

    for (uint32_t code = ' '; code <= '~'; code++)
        assert_true(letter_exists(code));
    for (uint32_t code = 0xC0; code <= 0xFF; code++)
        assert_true(letter_exists(code));
    while (*s)
        assert_true(letter_exists(utf8_next(&s, text + sizeof text - 1)));
    assert_false(letter_exists(0x65E5) || letter_exists(7));
    letter_load(&unknown, 0x65E5);
    letter_load(&box, 0xFFFD);
    assert_true(same(&unknown, &box));
    assert_int_equal(box.rows[LETTER_ACCENT_HEIGHT], 0x1F);
    assert_int_equal(box.rows[LETTER_ACCENT_HEIGHT + 3], 0x11);
}

/* A capital fills rows 0 to 6; no accent changes the letter under it; one row is free between the two. */
TEST(marks_leave_the_letter)
{
    static const struct {
        uint32_t code, letter;
        int free; /* the row with nothing in it */
    } v[] = { { 0xC9, 'E', 2 },  { 0xE9, 'e', 4 },  { 0xD1, 'N', 2 },  { 0xE5, 'a', 4 },
              { 0x17D, 'Z', 2 }, { 0xE7, 'c', -1 }, { 0x119, 'e', -1 } };

    for (size_t i = 0; i < sizeof v / sizeof *v; i++) {
        struct letter with, bare;
        int ink = 0;
        letter_load(&with, v[i].code);
        letter_load(&bare, v[i].letter);
        for (int row = 0; row < LETTER_ROWS; row++) {
            assert_int_equal(with.rows[row] & bare.rows[row], bare.rows[row]);
            ink += with.rows[row] != bare.rows[row];
        }
        assert_true(ink > 0);
        if (v[i].free >= 0)
            assert_int_equal(with.rows[v[i].free], 0);
    }
    for (uint32_t c = '0'; c <= '9'; c++) { /* digits are in columns */
        struct letter l;
        letter_load(&l, c);
        assert_int_equal(l.w, 5);
    }
    for (uint32_t c = 'A'; c <= 'Z'; c++) {
        struct letter l;
        letter_load(&l, c);
        assert_true(l.rows[LETTER_ACCENT_HEIGHT] && l.rows[LETTER_ACCENT_HEIGHT + 6] &&
                    !l.rows[LETTER_ACCENT_HEIGHT - 1] && !l.rows[LETTER_ACCENT_HEIGHT + 7]);
    }
}

/* An i with dots is wider than its stem: it starts where the dots do, and the stem is in their middle. */
TEST(a_mark_wider_than_its_letter)
{
    struct letter l;

    letter_load(&l, 0xEF);
    assert_int_equal(l.w, 3);
    assert_int_equal(l.rows[LETTER_ACCENT_HEIGHT], 5);
    assert_int_equal(l.rows[LETTER_ACCENT_HEIGHT + 2], 2);
}

/* Ink goes from x to x + width, and from the accents' row to the descenders'; what is returned is behind a gap. */
TEST(texts_are_as_wide_as_they_say)
{
    static const char *const texts[] = { "H", "\u00C9p\u00E5j|", "main.lua:12", "\u2190\u25A0" };

    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct ink ink;
        clear(NULL);
        assert_int_equal(canvas_large_text(&canvas, 9, MIDDLE, CANVAS_CYAN, texts[i]),
                         9 + canvas_large_text_width(&canvas, texts[i]) + CANVAS_LARGE_LETTER_SPACING);
        ink = look(CANVAS_CYAN);
        assert_int_equal(ink.x0, 9);
        assert_int_equal(ink.x1, 9 + canvas_large_text_width(&canvas, texts[i]) - 1);
        assert_true(ink.y0 >= MIDDLE - CANVAS_LARGE_ACCENT_HEIGHT && ink.y1 < MIDDLE + CANVAS_LARGE_HEIGHT);
    }
    assert_int_equal(canvas_large_text_width(&canvas, ""), 0);
    assert_int_equal(canvas_large_text(&canvas, 5, 5, CANVAS_RED, ""), 5);
    assert_int_equal(canvas_large_text_width(&canvas, "H\tH"), canvas_large_text_width(&canvas, "H  H"));
    assert_int_equal(canvas_large_text_width(&canvas, "H\xC2\xA0H"), canvas_large_text_width(&canvas, "H H"));
    assert_true(CANVAS_LARGE_LINE_HEIGHT >= CANVAS_LARGE_ACCENT_HEIGHT + CANVAS_LARGE_HEIGHT);
}

TEST(what_does_not_fit_is_cut)
{
    static const char text[] = "a replay with quite a long name";
    int whole = canvas_large_text_width(&canvas, text);

    for (int width = 8; width < whole; width++) {
        clear(NULL);
        canvas_large_text_truncated(&canvas, 3, MIDDLE, CANVAS_RED, text, width);
        assert_true(look(CANVAS_RED).x1 < 3 + width);
        assert_true(look(CANVAS_RED).x1 >= 3 + width - 16 || width < 20);
    }
    clear(NULL);
    assert_int_equal(canvas_large_text_truncated(&canvas, 3, MIDDLE, CANVAS_RED, text, whole),
                     3 + whole + CANVAS_LARGE_LETTER_SPACING);
}

TEST(lines_break_after_blanks)
{
    static const char text[] = "one two three\nfour";
    int w = canvas_large_text_width(&canvas, "one two t");

    assert_int_equal(canvas_large_text_fit(&canvas, text, w), 8);
    assert_int_equal(canvas_large_text_fit(&canvas, text, 1000), 13);
    assert_int_equal(canvas_large_text_fit(&canvas, "one two", canvas_large_text_width(&canvas, "one")), 4);
    assert_int_equal(canvas_large_text_fit(&canvas, "a verylongword", canvas_large_text_width(&canvas, "a verylo")), 8);
    assert_int_equal(canvas_large_text_fit(&canvas, "\xC3\x84\xC3\x84", 1), 2);
    assert_int_equal(canvas_large_text_fit(&canvas, "あああ。あ", canvas_large_text_width(&canvas, "あああ")), 6);
    assert_int_equal(canvas_large_text_fit(&canvas, "あああっあ", canvas_large_text_width(&canvas, "あああ")), 6);
    assert_int_equal(canvas_large_text_fit(&canvas, "あああEscape", canvas_large_text_width(&canvas, "あああEs")), 9);
    assert_int_equal(canvas_large_text_fit(&canvas, "", 50), 0);
    assert_int_equal(canvas_large_text_lines(&canvas, text, w), 3);
    assert_int_equal(canvas_large_text_lines(&canvas, "one\n\ntwo", w), 3);
}

TEST(lines_stand_below_each_other)
{
    canvas_large_text_wrapped(&canvas, 4, 10, 30, CANVAS_GREEN, "HHH HHH\nHH");
    const struct ink ink = look(CANVAS_GREEN);
    assert_true(ink.x0 == 4 && ink.x1 < 4 + 30);
    assert_int_equal(ink.y0, 10);
    assert_int_equal(ink.y1, 10 + 2 * CANVAS_LARGE_LINE_HEIGHT + 6);
}

/* Any bytes at any place end and stay inside; lines are never wider than they may be, and take every byte. */
TEST(any_bytes)
{
    struct rng r;

    rng_seed(&r, 5);
    for (int n = 0; n < 300; n++) {
        int width = (int)rng_below(&r, 150), x = (int)rng_below(&r, 400) - 200, y = (int)rng_below(&r, 200) - 100;
        char text[300] = "";
        for (size_t i = rng_below(&r, sizeof text); i > 0; i--)
            text[i - 1] = (char)(n % 2 ? 32 + rng_below(&r, 95) : 1 + rng_below(&r, 255));
        canvas_large_text_truncated(&canvas, x, y, CANVAS_RED, text, width);
        canvas_large_text_wrapped(&canvas, x, y, width, CANVAS_RED, text);
        for (const char *s = text; *s;) {
            char line[sizeof text] = "";
            int fit = canvas_large_text_fit(&canvas, s, 60 + width), ink = fit;
            assert_true((fit > 0 || *s == '\n') && fit <= (int)strlen(s));
            while (ink > 0 && s[ink - 1] == ' ')
                ink--;
            memcpy(line, s, (size_t)ink);
            assert_true(canvas_large_text_width(&canvas, line) <= 60 + width);
            s += fit + (s[fit] == '\n');
        }
    }
}

RUN_TESTS_EACH(clear, NULL)
