/*
 * test_text.c - text against a painter that sets one pixel after the other.
 */
#include <stdbool.h>
#include "../test.h"
#include "../../fb/text.h"
#include "../../src/base/rng.h"

enum { W = 64, H = 40, FIRST = 32, COUNT = 100, EMPTY = 40, SAFE = 1 << 20 };

struct bed {
    struct fb fb;
    uint8_t *mem;
    uint8_t glyphs[COUNT * 64];
    struct font font;
    uint8_t want[H][W];
    struct rng r;
};

static int bed_open(void **state)
{
    struct bed *b = calloc(1, sizeof *b);

    assert_non_null(b);
    rng_seed(&b->r, 11);
    b->mem = malloc(fb_size(W, H));
    assert_non_null(b->mem);
    fb_init(&b->fb, b->mem, W, H);
    for (size_t i = 0; i < sizeof b->glyphs; i++)
        b->glyphs[i] = rng_below(&b->r, 2) ? (uint8_t)rng_below(&b->r, 16) : 0;
    memset(b->glyphs + (EMPTY - FIRST) * 64, 0, 64);
    b->font = (struct font){ b->glyphs, FIRST, COUNT };
    *state = b;
    return 0;
}

static int bed_close(void **state)
{
    struct bed *b = *state;

    free(b->mem);
    free(b);
    return 0;
}

static void bed_reset(struct bed *b, uint8_t c)
{
    fb_fill(&b->fb, c);
    memset(b->want, c, sizeof b->want);
}

static void dot(struct bed *b, int64_t x, int64_t y, int c)
{
    if (x >= b->fb.x0 && x < b->fb.x1 && y >= b->fb.y0 && y < b->fb.y1)
        b->want[y][x] = (uint8_t)c;
}

/* The box of a character without a glyph: six pixels by seven, and its shadow beside it. */
static void paint_box(struct bed *b, int64_t x, int64_t y, int bank)
{
    for (int by = 0; by < 7; by++)
        for (int bx = 0; bx < 6; bx++)
            if (bx == 0 || by == 0 || bx == 5 || by == 6)
                dot(b, x + 1 + bx, y + 1 + by, bank * 16 + 1);
    for (int by = 0; by < 7; by++)
        for (int bx = 0; bx < 6; bx++)
            if (bx == 0 || by == 0 || bx == 5 || by == 6)
                dot(b, x + bx, y + by, bank * 16 + 15);
}

static void paint(struct bed *b, int64_t x, int64_t y, uint32_t c, uint8_t bank)
{
    if (c == 32 || c == 160 || c == 0x3000)
        return;
    if (c < FIRST || c >= FIRST + COUNT || c == EMPTY) {
        paint_box(b, x, y, bank);
        return;
    }
    for (int64_t k = 0; k < 64; k++) {
        int64_t px = x + k % 8, py = y + k / 8;
        uint8_t v = b->glyphs[(c - FIRST) * 64 + (uint32_t)k];
        if (v)
            dot(b, px, py, v + bank * 16);
    }
}

static void expect(struct bed *b)
{
    for (int y = 0; y < H; y++)
        assert_memory_equal(b->fb.pix + y * b->fb.pitch, b->want[y], W);
}

TEST(every_code)
{
    struct bed *b = *state;

    fb_reset_clip(&b->fb);
    static const uint32_t more[] = { 0x3000, 0x5f3e, 0x10ffff, UINT32_MAX };

    for (uint32_t i = 0; i < 260; i++) {
        uint32_t c = i < 256 ? i : more[i - 256];
        bed_reset(b, 3);
        paint(b, 11, 9, c, (uint8_t)(c % 16));
        text_draw_glyph(&b->fb, &b->font, 11, 9, c, (uint8_t)(c % 16));
        expect(b);
        assert_int_equal(text_has_glyph(&b->font, c), c >= FIRST && c < FIRST + COUNT && c != EMPTY);
    }
}

static int any_place(struct rng *r)
{
    static const int ends[] = { INT32_MIN, INT32_MIN + 7, INT32_MAX, INT32_MAX - 8 };

    return rng_below(r, 6) == 0 ? ends[rng_below(r, 4)] : (int)rng_below(r, 120) - 60;
}

TEST(any_string_anywhere)
{
    struct bed *b = *state;

    for (int k = 0; k < 3000; k++) {
        char s[40];
        int n = (int)rng_below(&b->r, sizeof s), x = any_place(&b->r), y = any_place(&b->r);
        uint8_t bank = (uint8_t)rng_below(&b->r, 16);
        int64_t at = x, row = y;
        for (int i = 0; i < n; i++)
            s[i] = (char)(rng_below(&b->r, 8) == 0 ? '\n' : (int)(1 + rng_below(&b->r, 255)));
        s[n] = '\0';
        if (k % 2)
            fb_set_clip(&b->fb, (int)rng_below(&b->r, W), (int)rng_below(&b->r, H), 1 + (int)rng_below(&b->r, W), 20);
        else
            fb_reset_clip(&b->fb);
        bed_reset(b, 200);
        for (int i = 0; i < n; i++) {
            if (s[i] != '\n')
                paint(b, at, row, (uint8_t)s[i], bank);
            at = s[i] == '\n' ? x : at + 8;
            row += s[i] == '\n' ? 8 : 0;
        }
        text_draw(&b->fb, &b->font, x, y, s, bank);
        expect(b);
    }
}

/* The start of a long text is far off; its end is seen. */
TEST(long_text_from_far_left)
{
    struct bed *b = *state;
    char *s = malloc(SAFE + 3);

    assert_non_null(s);
    memset(s, 'x', SAFE);
    strcpy(s + SAFE, "AB");
    fb_reset_clip(&b->fb);
    bed_reset(b, 1);
    for (int i = -1; i < 7; i++)
        paint(b, 5 + 8 * i, 4, i < 4 ? 'x' : i == 4 ? 'A' : i == 5 ? 'B' : ' ', 2);
    text_draw(&b->fb, &b->font, 5 + 8 * (4 - SAFE), 4, s, 2);
    expect(b);
    free(s);
}

/* Its pixels and the eight places next to each, by words where nothing is cut off, at every place near the edges. */
TEST(any_rim_anywhere)
{
    struct bed *b = *state;

    for (int round = 0; round < 4000; round++) {
        const uint32_t code = FIRST - 2 + (uint32_t)rng_below(&b->r, COUNT + 4);
        const int x = (int)rng_below(&b->r, W + 24) - 12, y = (int)rng_below(&b->r, H + 24) - 12;
        const uint8_t rim = (uint8_t)rng_below(&b->r, 256);
        const bool has = text_has_glyph(&b->font, code) && !text_is_blank(code);
        bed_reset(b, (uint8_t)rng_below(&b->r, 256));
        fb_set_clip(&b->fb, (int)rng_below(&b->r, 9), (int)rng_below(&b->r, 9), W - 12, H - 12);
        for (int at = 0; has && at < 64; at++)
            for (int k = 0; k < 9 && b->glyphs[(code - FIRST) * 64 + (uint32_t)at]; k++)
                dot(b, x + at % 8 + k % 3 - 1, y + at / 8 + k / 3 - 1, rim);
        text_draw_rim(&b->fb, &b->font, x, y, code, rim);
        for (int row = 0; row < H; row++)
            assert_memory_equal(b->fb.pix + row * b->fb.pitch, b->want[row], W);
        fb_reset_clip(&b->fb);
    }
}

RUN_TESTS(bed_open, bed_close)
