/*
 * test_text.c - text against a painter that sets one pixel after the other.
 */
#include <stdbool.h>
#include "../test.h"
#include "../../fb/text.h"
#include "../../src/base/rng.h"

enum { W = 64, H = 40, FIRST = 32, COUNT = 100, EMPTY = 40, SAFE = 1 << 20 };

static struct fb fb;
static uint8_t mem[1 << 14], glyphs[COUNT * 64], want[H][W];
static const struct font font = { glyphs, FIRST, COUNT };
static struct rng r;

static int setup(void **state)
{
    (void)state;
    assert_true(fb_size(W, H) <= sizeof mem);
    fb_init(&fb, mem, W, H);
    rng_seed(&r, 11);
    for (size_t i = 0; i < sizeof glyphs; i++)
        glyphs[i] = rng_below(&r, 2) ? (uint8_t)rng_below(&r, 16) : 0;
    memset(glyphs + (EMPTY - FIRST) * 64, 0, 64);
    return 0;
}

static void clear(uint8_t c)
{
    fb_fill(&fb, c);
    memset(want, c, sizeof want);
}

static void dot(int64_t x, int64_t y, int c)
{
    if (x >= fb.x0 && x < fb.x1 && y >= fb.y0 && y < fb.y1)
        want[y][x] = (uint8_t)c;
}

/* The box of a character without a glyph: six pixels by seven, and its shadow. */
static void paint_box(int64_t x, int64_t y, int bank)
{
    for (int shadow = 1; shadow >= 0; shadow--)
        for (int by = 0; by < 7; by++)
            for (int bx = 0; bx < 6; bx++)
                if (bx == 0 || by == 0 || bx == 5 || by == 6)
                    dot(x + shadow + bx, y + shadow + by, bank * 16 + (shadow ? 1 : 15));
}

static void paint(int64_t x, int64_t y, uint32_t c, uint8_t bank)
{
    if (c == 32 || c == 160 || c == 0x3000)
        return;
    if (c < FIRST || c >= FIRST + COUNT || c == EMPTY) {
        paint_box(x, y, bank);
        return;
    }
    for (int64_t k = 0; k < 64; k++) {
        int64_t px = x + k % 8, py = y + k / 8;
        uint8_t v = glyphs[(c - FIRST) * 64 + (uint32_t)k];
        if (v)
            dot(px, py, v + bank * 16);
    }
}

static void expect(void)
{
    for (int y = 0; y < H; y++)
        assert_memory_equal(fb.pix + y * fb.pitch, want[y], W);
}

TEST(every_code)
{
    static const uint32_t codes[] = { 0,   ' ',    FIRST + 1, EMPTY,    FIRST + COUNT - 1, FIRST + COUNT,
                                      160, 0x3000, 0x5f3e,    0x10ffff, UINT32_MAX };

    fb_reset_clip(&fb);
    for (size_t i = 0; i < sizeof codes / sizeof *codes; i++) {
        const uint32_t c = codes[i];
        clear(3);
        paint(11, 9, c, (uint8_t)(c % 16));
        text_draw_glyph(&fb, &font, 11, 9, c, (uint8_t)(c % 16));
        expect();
        assert_int_equal(text_has_glyph(&font, c), c >= FIRST && c < FIRST + COUNT && c != EMPTY);
    }
}

static int any_place(void)
{
    static const int ends[] = { INT32_MIN, INT32_MIN + 7, INT32_MAX, INT32_MAX - 8 };

    return rng_below(&r, 6) == 0 ? ends[rng_below(&r, 4)] : (int)rng_below(&r, 120) - 60;
}

TEST(any_string_anywhere)
{
    for (int k = 0; k < 3000; k++) {
        char s[40];
        int n = (int)rng_below(&r, sizeof s), x = any_place(), y = any_place();
        uint8_t bank = (uint8_t)rng_below(&r, 16);
        int64_t at = x, row = y;
        for (int i = 0; i < n; i++)
            s[i] = (char)(rng_below(&r, 8) == 0 ? '\n' : (int)(1 + rng_below(&r, 255)));
        s[n] = '\0';
        if (k % 2)
            fb_set_clip(&fb, (int)rng_below(&r, W), (int)rng_below(&r, H), 1 + (int)rng_below(&r, W), 20);
        else
            fb_reset_clip(&fb);
        clear(200);
        for (int i = 0; i < n; i++) {
            if (s[i] != '\n')
                paint(at, row, (uint8_t)s[i], bank);
            at = s[i] == '\n' ? x : at + 8;
            row += s[i] == '\n' ? 8 : 0;
        }
        text_draw(&fb, &font, x, y, s, bank);
        expect();
    }
}

/* The start of a long text is far off; its end is seen. */
TEST(long_text_from_far_left)
{
    char *s = malloc(SAFE + 3);

    assert_non_null(s);
    memset(s, 'x', SAFE);
    strcpy(s + SAFE, "AB");
    fb_reset_clip(&fb);
    clear(1);
    for (int i = -1; i < 7; i++)
        paint(5 + 8 * i, 4, i < 4 ? 'x' : i == 4 ? 'A' : i == 5 ? 'B' : ' ', 2);
    text_draw(&fb, &font, 5 + 8 * (4 - SAFE), 4, s, 2);
    expect();
    free(s);
}

/* Its pixels and the eight places next to each, by words where nothing is cut off, at every place near the edges. */
TEST(any_rim_anywhere)
{
    for (int round = 0; round < 4000; round++) {
        const uint32_t code = FIRST - 2 + (uint32_t)rng_below(&r, COUNT + 4);
        const int x = (int)rng_below(&r, W + 24) - 12, y = (int)rng_below(&r, H + 24) - 12;
        const uint8_t rim = (uint8_t)rng_below(&r, 256);
        const bool has = text_has_glyph(&font, code) && !text_is_blank(code);
        clear((uint8_t)rng_below(&r, 256));
        fb_set_clip(&fb, (int)rng_below(&r, 9), (int)rng_below(&r, 9), W - 12, H - 12);
        for (int at = 0; has && at < 64; at++)
            for (int k = 0; k < 9 && glyphs[(code - FIRST) * 64 + (uint32_t)at]; k++)
                dot(x + at % 8 + k % 3 - 1, y + at / 8 + k / 3 - 1, rim);
        text_draw_rim(&fb, &font, x, y, code, rim);
        expect();
        fb_reset_clip(&fb);
    }
}

RUN_TESTS(setup, NULL)
