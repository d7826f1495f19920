/* test_canvas.c - what the program draws over a picture: borrowed colours, words, shapes. */
#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/player/overlay/message.h"

enum { W = 64, H = 48 };

struct bed {
    struct fb fb;
    void *mem;
    uint32_t rgb[256];
    struct canvas canvas;
    struct rng r;
};

static int bed_open(void **state)
{
    struct bed *b = calloc(1, sizeof *b);

    assert_non_null(b);
    b->mem = malloc(fb_size(W, H));
    assert_non_null(b->mem);
    fb_init(&b->fb, b->mem, W, H);
    rng_seed(&b->r, 3);
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

static uint8_t *at(const struct bed *b, int x, int y)
{
    return &b->fb.pix[y * b->fb.pitch + x];
}

/* Which canvas stands there; -1: the picture. */
static int canvas_at(const struct bed *b, int x, int y)
{
    for (int i = 0; i < CANVAS_COLOURS; i++)
        if (*at(b, x, y) == b->canvas.colour[i])
            return i;
    return -1;
}

static int inked(const struct bed *b)
{
    int n = 0;

    for (int i = 0; i < W * H; i++)
        n += canvas_at(b, i % W, i / W) >= 0;
    return n;
}

static bool is_free(int colour)
{
    return colour >= 77 && colour < 77 + CANVAS_COLOURS;
}

/* Every colour but CANVAS_COLOURS of them is on the picture: those are taken, and not a pixel changes. */
TEST(unused_colours_are_taken)
{
    struct bed *b = *state;
    bool seen[256] = { false };

    for (int i = 0; i < W * H; i++)
        *at(b, i % W, i / W) = (uint8_t)(is_free(i % 256) ? 3 : i);
    canvas_open(&b->canvas, &b->fb, b->rgb);
    for (int i = 0; i < W * H; i++)
        assert_int_equal(*at(b, i % W, i / W), is_free(i % 256) ? 3 : i % 256);
    for (int i = 0; i < CANVAS_COLOURS; i++) {
        assert_true(is_free(b->canvas.colour[i]) && !seen[b->canvas.colour[i]]);
        seen[b->canvas.colour[i]] = true;
        for (int k = 0; k < i; k++)
            assert_true(b->rgb[b->canvas.colour[i]] != b->rgb[b->canvas.colour[k]]);
    }
    assert_int_equal(b->rgb[b->canvas.colour[CANVAS_WHITE]], 0xFFFFFF);
}

/* All 256 are on it: a pixel of a colour that was taken gets the nearest of those that were not. */
TEST(a_full_palette_gives_up_a_few)
{
    struct bed *b = *state;
    uint32_t was[256];

    for (int i = 0; i < 256; i++)
        b->rgb[i] = (uint32_t)i * 0x010101;
    for (int i = 0; i < W * H; i++)
        *at(b, i % W, i / W) = (uint8_t)i;
    memcpy(was, b->rgb, sizeof was);
    canvas_open(&b->canvas, &b->fb, b->rgb);
    for (int i = 0; i < W * H; i++) {
        int got = (int)(was[*at(b, i % W, i / W)] & 255), want = i % 256;
        assert_int_equal(canvas_at(b, i % W, i / W), -1);
        assert_true(abs(got - want) <= CANVAS_COLOURS);
        assert_true(got == want || b->rgb[want] != was[want]);
    }
}

TEST(words_stand_on_a_band)
{
    struct bed *b = *state;
    int white = 0;

    for (int i = 0; i < W * H; i++)
        *at(b, i % W, i / W) = 9;
    canvas_open(&b->canvas, &b->fb, b->rgb);
    int end = message_draw(&b->canvas, 0, "hello there, this is it, it is longer\nthan a line \xC3\xA9");
    assert_int_equal(end, 1 + 4 * CANVAS_CELL_H);
    for (int i = 0; i < W * end; i++) {
        int canvas = canvas_at(b, i % W, i / W);
        assert_true(canvas == CANVAS_DARK || canvas == CANVAS_WHITE);
        white += canvas == CANVAS_WHITE;
    }
    assert_true(white > 100);
    assert_int_equal(*at(b, 0, end), 9);
}

/* The same words, ending above a row; what is higher than that begins at the top. */
TEST(words_stand_above_a_row)
{
    struct bed *b = *state;
    const char *text = "hello there, this is it, it is longer\nthan a line \xC3\xA9";

    for (int i = 0; i < W * H; i++)
        *at(b, i % W, i / W) = 9;
    canvas_open(&b->canvas, &b->fb, b->rgb);
    const int from = message_draw_above(&b->canvas, H - 3, text);
    assert_int_equal(from, H - 3 - (1 + 4 * CANVAS_CELL_H));
    for (int y = 0; y < H; y++) {
        const int canvas = canvas_at(b, 0, y);
        assert_true((y >= from && y < H - 3) == (canvas == CANVAS_DARK || canvas == CANVAS_WHITE));
    }
    assert_int_equal(message_draw_above(&b->canvas, 5, text), 0);
}

/* Each printable character differs from every other, and stays in its cell. */
TEST(letters_can_be_told_apart)
{
    struct bed *b = *state;
    uint32_t shape[127] = { 0 };

    for (int c = ' '; c <= '~'; c++) {
        const char text[2] = { (char)c, 0 };
        fb_fill(&b->fb, 0);
        canvas_open(&b->canvas, &b->fb, b->rgb);
        assert_int_equal(canvas_text(&b->canvas, 8, 8, CANVAS_CYAN, text), 8 + CANVAS_CELL_W);
        for (int i = 0; i < W * H; i++) {
            bool cell = i % W >= 8 && i % W < 8 + CANVAS_CELL_W - 1 && i / W >= 8 && i / W < 8 + CANVAS_CELL_H - 1;
            assert_true(cell || canvas_at(b, i % W, i / W) < 0);
            if (cell)
                shape[c] = shape[c] << 1 | (canvas_at(b, i % W, i / W) == CANVAS_CYAN);
        }
        for (int d = ' '; d < c; d++)
            assert_true(shape[c] != shape[d]);
    }
}

TEST(widths)
{
    struct bed *b = *state;

    canvas_open(&b->canvas, &b->fb, b->rgb);
    assert_int_equal(canvas_text_width(""), 0);
    assert_int_equal(canvas_text_width("abc"), 3 * CANVAS_CELL_W);
    assert_int_equal(canvas_text_width("a\t\xC3\xA9"), 4 * CANVAS_CELL_W);
    assert_int_equal(canvas_text(&b->canvas, -5, -3, CANVAS_RED, "a\t\xC3\xA9"), -5 + 4 * CANVAS_CELL_W);
    assert_int_equal(canvas_text_n(&b->canvas, 2, 3, CANVAS_RED, "abcdef", 2), 2 + 2 * CANVAS_CELL_W);
}

/* Is the middle of pixel (px, py) in a circle? In units of half a Q15.16 pixel unit. */
static bool in_ring(int64_t px, int64_t py, int64_t x, int64_t y, int64_t r)
{
    int64_t dx = (2 * px + 1) * 32768 - x, dy = (2 * py + 1) * 32768 - y;

    return dx * dx + dy * dy <= r * r;
}

/* In multiples of 1/256 px, which is as exact as it draws. */
TEST(rings_are_rims_of_what_is_inside)
{
    struct bed *b = *state;

    for (int n = 0; n < 600; n++) {
        int64_t x = ((int64_t)rng_below(&b->r, 100) - 20) * 65536 + (int64_t)rng_below(&b->r, 256) * 256;
        int64_t y = ((int64_t)rng_below(&b->r, 90) - 20) * 65536 + (int64_t)rng_below(&b->r, 256) * 256;
        int64_t r = (int64_t)rng_below(&b->r, n % 2 ? 65536 * 3 : 65536 * 60) / 256 * 256;
        fb_fill(&b->fb, 0);
        canvas_open(&b->canvas, &b->fb, b->rgb);
        canvas_circle(&b->canvas, (int32_t)x, (int32_t)y, (int32_t)r, CANVAS_GREEN);
        for (int i = 0; i < W * H; i++) {
            int64_t px = i % W, py = i / W, sx = px * 65536 + 32768 < x ? -1 : 1, sy = py * 65536 + 32768 < y ? -1 : 1;
            bool want = in_ring(px, py, x, y, r) && (!in_ring(px + sx, py, x, y, r) || !in_ring(px, py + sy, x, y, r));
            want |= r < 65536 && x >> 16 == px && y >> 16 == py;
            assert_int_equal(canvas_at(b, (int)px, (int)py) == CANVAS_GREEN, want);
        }
    }
}

/* Of a disc each pixel that is inside; below a pixel's size one at least. */
TEST(discs_are_what_is_inside)
{
    struct bed *b = *state;

    for (int n = 0; n < 600; n++) {
        int64_t x = ((int64_t)rng_below(&b->r, 100) - 20) * 65536 + (int64_t)rng_below(&b->r, 256) * 256;
        int64_t y = ((int64_t)rng_below(&b->r, 90) - 20) * 65536 + (int64_t)rng_below(&b->r, 256) * 256;
        int64_t r = (int64_t)rng_below(&b->r, n % 2 ? 65536 * 3 : 65536 * 60) / 256 * 256;
        fb_fill(&b->fb, 0);
        canvas_open(&b->canvas, &b->fb, b->rgb);
        fb_set_clip(&b->fb, 5, 0, W - 9, H);
        canvas_disc(&b->canvas, (int32_t)x, (int32_t)y, (int32_t)r, CANVAS_GREEN);
        for (int i = 0; i < W * H; i++) {
            int64_t px = i % W, py = i / W;
            bool want = in_ring(px, py, x, y, r) || (r < 65536 && x >> 16 == px && y >> 16 == py);
            assert_int_equal(canvas_at(b, (int)px, (int)py) == CANVAS_GREEN, want && px >= 5 && px < W - 4);
        }
    }
}

static double light_of(uint32_t rgb)
{
    const double weight[3] = { 0.2126, 0.7152, 0.0722 };
    double sum = 0;

    for (int c = 0; c < 3; c++) {
        const double v = (rgb >> (16 - 8 * c) & 255) / 255.0;
        sum += weight[c] * (v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4));
    }
    return sum;
}

/* By each view, words in every colour stand out from the band they are written on: 4.5 to 1 is what WCAG 2 asks of
 * text. */
TEST(words_are_readable_by_each_view)
{
    struct bed *b = *state;

    for (int view = 0; view < COLOUR_BLIND_MODES; view++) {
        uint32_t was[256];
        canvas_open(&b->canvas, &b->fb, b->rgb);
        memcpy(was, b->rgb, sizeof was);
        canvas_set_colour_blind_mode(&b->canvas, (enum colour_blind_mode)view);
        for (int i = 0; i < 256; i++) {
            bool own = false;
            for (int c = 0; c < CANVAS_COLOURS; c++)
                own = own || b->canvas.colour[c] == i;
            assert_int_equal(b->rgb[i], own ? view_adjust_colour((enum colour_blind_mode)view, was[i]) : was[i]);
        }
        const double dark = light_of(b->rgb[b->canvas.colour[CANVAS_DARK]]);
        for (int c = CANVAS_DARK + 1; c < CANVAS_COLOURS; c++)
            assert_true((light_of(b->rgb[b->canvas.colour[c]]) + 0.05) / (dark + 0.05) >= 4.5);
    }
}

TEST(boxes_frame_what_is_inside)
{
    struct bed *b = *state;

    for (int n = 0; n < 600; n++) {
        int64_t x = (int64_t)rng_below(&b->r, 100 << 16) - (20 << 16),
                y = (int64_t)rng_below(&b->r, 90 << 16) - (20 << 16);
        int64_t w = (int64_t)rng_below(&b->r, n % 2 ? 4 << 16 : 50 << 16), h = (int64_t)rng_below(&b->r, 20 << 16);
        bool any = false;
        fb_fill(&b->fb, 0);
        canvas_open(&b->canvas, &b->fb, b->rgb);
        canvas_box(&b->canvas, (int32_t)x, (int32_t)y, (int32_t)w, (int32_t)h, CANVAS_GREEN);
#define IN(px, py) (llabs((px)*65536 + 32768 - x) <= w && llabs((py)*65536 + 32768 - y) <= h)
        for (int64_t i = -50 * 200; i < 200 * 200; i++)
            any |= IN(i % 200 - 50, i / 200);
        for (int i = 0; i < W * H; i++) {
            int64_t px = i % W, py = i / W;
            bool inner = IN(px - 1, py) && IN(px + 1, py) && IN(px, py - 1) && IN(px, py + 1);
            bool want = any ? IN(px, py) && !inner : x >> 16 == px && y >> 16 == py;
            assert_int_equal(canvas_at(b, (int)px, (int)py) == CANVAS_GREEN, want);
        }
    }
}

/* Is it near the bar? By the nearest point of many. */
static bool in_capsule(int64_t px, int64_t py, const int64_t at[5])
{
    double x = (double)(px * 65536 + 32768 - at[0]), y = (double)(py * 65536 + 32768 - at[1]);
    double hx = (double)at[2], hy = (double)at[3], r = (double)at[4], hh = hx * hx + hy * hy;
    double along = hh > 0 ? (x * hx + y * hy) / hh : 0;

    along = along < -1 ? -1 : along > 1 ? 1 : along;
    return (x - along * hx) * (x - along * hx) + (y - along * hy) * (y - along * hy) <= r * r;
}

/* Numbers are odd multiples of 1/16 px, so that doubles decide right. */
TEST(capsules_are_rims_of_what_is_inside)
{
    struct bed *b = *state;
    long drawn = 0;

    for (int n = 0; n < 300; n++) {
        static const int64_t low[5] = { -20, -20, -40, -40, 0 }, span[5] = { 100, 90, 80, 80, 30 };
        int64_t at[5];
        for (int i = 0; i < 5; i++)
            at[i] = low[i] * 65536 + (2 * (int64_t)rng_below(&b->r, (uint64_t)span[i] * 8) + 1) * 4096;
        if (n % 5 == 0)
            at[2] = 0;
        if (n % 7 == 0)
            at[3] = 0;
        fb_fill(&b->fb, 0);
        canvas_open(&b->canvas, &b->fb, b->rgb);
        canvas_capsule(&b->canvas, (int32_t)at[0], (int32_t)at[1], (int32_t)at[2], (int32_t)at[3], (int32_t)at[4],
                       CANVAS_GREEN);
        for (int i = 0; i < W * H; i++) {
            int64_t px = i % W, py = i / W;
            bool inner = in_capsule(px - 1, py, at) && in_capsule(px + 1, py, at) && in_capsule(px, py - 1, at) &&
                         in_capsule(px, py + 1, at);
            bool want = (in_capsule(px, py, at) && !inner) || (at[4] < 65536 && at[0] >> 16 == px && at[1] >> 16 == py);
            assert_int_equal(canvas_at(b, (int)px, (int)py) == CANVAS_GREEN, want);
            drawn += want;
        }
    }
    assert_true(drawn > 3000);
}

/* Whatever the numbers, drawing ends and stays inside. */
TEST(extremes_are_clipped)
{
    static const int v[] = { INT_MIN, INT_MIN / 2, -70000, -1, 0, 5, 70000, INT_MAX / 2, INT_MAX };
    enum { N = sizeof v / sizeof *v };
    struct bed *b = *state;

    canvas_open(&b->canvas, &b->fb, b->rgb);
    for (int i = 0; i < N * N * N; i++) {
        int x = v[i % N], y = v[i / N % N], r = v[i / N / N];
        canvas_circle(&b->canvas, x, y, r, CANVAS_RED);
        canvas_disc(&b->canvas, x, y, r, CANVAS_RED);
        canvas_box(&b->canvas, x, y, r, x, CANVAS_RED);
        canvas_capsule(&b->canvas, x, y, r, y, x, CANVAS_RED);
        canvas_line(&b->canvas, x, y, r, x, CANVAS_RED);
        canvas_rect(&b->canvas, x, y, r, y, CANVAS_RED);
        canvas_outline(&b->canvas, x, y, r, y, CANVAS_RED);
    }
    fb_fill(&b->fb, 0);
    canvas_open(&b->canvas, &b->fb, b->rgb);
    canvas_text(&b->canvas, -2, -2, CANVAS_RED, "MMM");
    assert_true(inked(b) > 0);
    fb_fill(&b->fb, 0);
    canvas_text(&b->canvas, W, 0, CANVAS_RED, "MMM");
    canvas_text(&b->canvas, 0, H, CANVAS_RED, "MMM");
    assert_int_equal(inked(b), 0);
}

/* Any text on any picture ends and stays inside. */
TEST(any_words)
{
    struct bed *b = *state;
    char text[600];

    for (int w = 8; w <= W; w += 8) {
        fb_init(&b->fb, b->mem, w, H);
        canvas_open(&b->canvas, &b->fb, b->rgb);
        for (size_t i = 0; i < sizeof text - 1; i++)
            text[i] = (char)(1 + rng_below(&b->r, 255));
        text[sizeof text - 1] = 0;
        assert_true(message_draw(&b->canvas, 0, text) > 0);
        assert_true(message_draw(&b->canvas, H - 4, text) > 0);
        assert_true(message_draw(&b->canvas, 0, "") == 1);
    }
}

RUN_TESTS_EACH(bed_open, bed_close)
