/* test_canvas.c - what the program draws over a picture: borrowed colours, words, shapes. */
#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/player/overlay/message.h"

enum { W = 64, H = 48 };

static struct fb fb;
static uint32_t colours[256];
static struct canvas canvas;
static struct rng rng;
static void *memory;

/* A picture of one colour, and a canvas on it. */
static void clear(void)
{
    fb_fill(&fb, 0);
    canvas_open(&canvas, &fb, colours);
}

static int setup(void **state)
{
    (void)state;
    if (!memory)
        memory = malloc(fb_size(W, H));
    assert_non_null(memory);
    fb_init(&fb, memory, W, H);
    memset(colours, 0, sizeof colours);
    rng_seed(&rng, 3);
    return 0;
}

static uint8_t *at(int x, int y)
{
    return &fb.pix[y * fb.pitch + x];
}

/* Which of the canvas's colours is there; -1: the picture. */
static int canvas_at(int x, int y)
{
    for (int i = 0; i < CANVAS_COLOURS; i++)
        if (*at(x, y) == canvas.colour[i])
            return i;
    return -1;
}

static bool is_free(int colour)
{
    return colour >= 77 && colour < 77 + CANVAS_COLOURS;
}

/* Every colour but CANVAS_COLOURS of them is on the picture: those are taken, and not a pixel changes. */
TEST(unused_colours_are_taken)
{
    bool seen[256] = { false };

    for (int i = 0; i < W * H; i++)
        *at(i % W, i / W) = (uint8_t)(is_free(i % 256) ? 3 : i);
    canvas_open(&canvas, &fb, colours);
    for (int i = 0; i < W * H; i++)
        assert_int_equal(*at(i % W, i / W), is_free(i % 256) ? 3 : i % 256);
    for (int i = 0; i < CANVAS_COLOURS; i++) {
        assert_true(is_free(canvas.colour[i]) && !seen[canvas.colour[i]]);
        seen[canvas.colour[i]] = true;
        for (int k = 0; k < i; k++)
            assert_true(colours[canvas.colour[i]] != colours[canvas.colour[k]]);
    }
    assert_int_equal(colours[canvas.colour[CANVAS_WHITE]], 0xFFFFFF);
}

/* All 256 are on it: a pixel of a colour that was taken gets the nearest of those that were not. */
TEST(a_full_palette_gives_up_a_few)
{
    uint32_t was[256];

    for (int i = 0; i < 256; i++)
        colours[i] = (uint32_t)i * 0x010101;
    for (int i = 0; i < W * H; i++)
        *at(i % W, i / W) = (uint8_t)i;
    memcpy(was, colours, sizeof was);
    canvas_open(&canvas, &fb, colours);
    for (int i = 0; i < W * H; i++) {
        int got = (int)(was[*at(i % W, i / W)] & 255), want = i % 256;
        assert_int_equal(canvas_at(i % W, i / W), -1);
        assert_true(abs(got - want) <= CANVAS_COLOURS);
        assert_true(got == want || colours[want] != was[want]);
    }
}

/* Words on a band, from the top or ending above a row; what is higher than that begins at the top. */
TEST(words_stand_on_a_band)
{
    static const char text[] = "hello there, this is it, it is longer\nthan a line \xC3\xA9";
    const int height = 1 + 4 * CANVAS_CELL_H, bottom = H - 3;

    clear();
    assert_int_equal(message_draw(&canvas, 0, text), height);
    clear();
    assert_int_equal(message_draw_above(&canvas, bottom, text), bottom - height);
    int white = 0;
    for (int i = 0; i < W * H; i++) {
        const int y = i / W, colour = canvas_at(i % W, y);
        assert_true((y >= bottom - height && y < bottom) == (colour == CANVAS_DARK || colour == CANVAS_WHITE));
        white += colour == CANVAS_WHITE;
    }
    assert_true(white > 100);
    assert_int_equal(message_draw_above(&canvas, 5, text), 0);
}

/* Each printable character differs from every other, and stays in its cell. */
TEST(letters_can_be_told_apart)
{
    uint32_t shape[127] = { 0 };

    for (int c = ' '; c <= '~'; c++) {
        const char text[2] = { (char)c, 0 };
        clear();
        assert_int_equal(canvas_text(&canvas, 8, 8, CANVAS_CYAN, text), 8 + CANVAS_CELL_W);
        for (int i = 0; i < W * H; i++) {
            bool cell = i % W >= 8 && i % W < 8 + CANVAS_CELL_W - 1 && i / W >= 8 && i / W < 8 + CANVAS_CELL_H - 1;
            assert_true(cell || canvas_at(i % W, i / W) < 0);
            if (cell)
                shape[c] = shape[c] << 1 | (canvas_at(i % W, i / W) == CANVAS_CYAN);
        }
        for (int d = ' '; d < c; d++)
            assert_true(shape[c] != shape[d]);
    }
}

TEST(widths)
{
    canvas_open(&canvas, &fb, colours);
    assert_int_equal(canvas_text_width(""), 0);
    assert_int_equal(canvas_text_width("a\t\xC3\xA9"), 4 * CANVAS_CELL_W);
    assert_int_equal(canvas_text(&canvas, -5, -3, CANVAS_RED, "a\t\xC3\xA9"), -5 + 4 * CANVAS_CELL_W);
    assert_int_equal(canvas_text_n(&canvas, 2, 3, CANVAS_RED, "abcdef", 2), 2 + 2 * CANVAS_CELL_W);
}

/* ---- shapes: x, y, and three sizes, in Q15.16 px ---- */

enum { X, Y, SIZE_1, SIZE_2, SIZE_3, SIZES };

typedef bool inside_fn(int64_t px, int64_t py, const int64_t s[SIZES]);

/* Is the middle of pixel (px, py) inside? */
static bool in_circle(int64_t px, int64_t py, const int64_t s[SIZES])
{
    const int64_t dx = px * 65536 + 32768 - s[X], dy = py * 65536 + 32768 - s[Y];

    return dx * dx + dy * dy <= s[SIZE_1] * s[SIZE_1];
}

static bool in_box(int64_t px, int64_t py, const int64_t s[SIZES])
{
    return llabs(px * 65536 + 32768 - s[X]) <= s[SIZE_1] && llabs(py * 65536 + 32768 - s[Y]) <= s[SIZE_2];
}

/* By the nearest point of the line from (x - size 1, y - size 2) to (x + size 1, y + size 2). */
static bool in_capsule(int64_t px, int64_t py, const int64_t s[SIZES])
{
    double x = (double)(px * 65536 + 32768 - s[X]), y = (double)(py * 65536 + 32768 - s[Y]);
    double hx = (double)s[SIZE_1], hy = (double)s[SIZE_2], r = (double)s[SIZE_3], hh = hx * hx + hy * hy;
    double along = hh > 0 ? (x * hx + y * hy) / hh : 0;

    along = along < -1 ? -1 : along > 1 ? 1 : along;
    return (x - along * hx) * (x - along * hx) + (y - along * hy) * (y - along * hy) <= r * r;
}

/* Each pixel inside is drawn, of a rim only those with a neighbour that is not; dot: and the one in the middle. */
static void expect_shape(inside_fn *inside, const int64_t s[SIZES], bool rim, bool dot)
{
    for (int i = 0; i < W * H; i++) {
        const int64_t px = i % W, py = i / W;
        const bool inner =
            rim && inside(px - 1, py, s) && inside(px + 1, py, s) && inside(px, py - 1, s) && inside(px, py + 1, s);
        const bool want = (inside(px, py, s) && !inner) || (dot && s[X] >> 16 == px && s[Y] >> 16 == py);
        assert_int_equal(canvas_at((int)px, (int)py) == CANVAS_GREEN, want && px >= fb.x0 && px < fb.x1);
    }
}

/* An odd multiple of 1/512 px (so that doubles decide right), within `span` from `low`, in px. */
static int64_t any(int low, int span)
{
    return low * 65536 + (2 * (int64_t)rng_below(&rng, (uint64_t)span * 256) + 1) * 128;
}

/* A circle is drawn in multiples of 1/256 px. Below a pixel's size there is one pixel at least. */
TEST(rings_and_discs)
{
    fb_set_clip(&fb, 5, 0, W - 9, H);
    for (int n = 0; n < 1200; n++) {
        const int64_t s[SIZES] = { any(-20, 100) & ~255, any(-20, 90) & ~255, any(0, n % 2 ? 3 : 60) & ~255 };
        const bool rim = n % 4 < 2;
        clear();
        (rim ? canvas_circle : canvas_disc)(&canvas, (int32_t)s[X], (int32_t)s[Y], (int32_t)s[SIZE_1], CANVAS_GREEN);
        expect_shape(in_circle, s, rim, s[SIZE_1] < 65536);
    }
}

TEST(boxes)
{
    for (int n = 0; n < 600; n++) {
        const int64_t s[SIZES] = { any(-20, 100), any(-20, 90), any(0, n % 2 ? 4 : 50), any(0, 20) };
        clear();
        canvas_box(&canvas, (int32_t)s[X], (int32_t)s[Y], (int32_t)s[SIZE_1], (int32_t)s[SIZE_2], CANVAS_GREEN);
        expect_shape(in_box, s, true, !in_box(s[X] >> 16, s[Y] >> 16, s));
    }
}

TEST(capsules)
{
    for (int n = 0; n < 300; n++) {
        const int64_t s[SIZES] = { any(-20, 100), any(-20, 90), n % 5 ? any(-40, 80) : 0, n % 7 ? any(-40, 80) : 0,
                                   any(0, 30) };
        clear();
        canvas_capsule(&canvas, (int32_t)s[X], (int32_t)s[Y], (int32_t)s[SIZE_1], (int32_t)s[SIZE_2],
                       (int32_t)s[SIZE_3], CANVAS_GREEN);
        expect_shape(in_capsule, s, true, s[SIZE_3] < 65536);
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
    for (int view = 0; view < COLOUR_BLIND_MODES; view++) {
        uint32_t was[256];
        canvas_open(&canvas, &fb, colours);
        memcpy(was, colours, sizeof was);
        canvas_set_colour_blind_mode(&canvas, (enum colour_blind_mode)view);
        for (int i = 0; i < 256; i++) {
            bool own = false;
            for (int c = 0; c < CANVAS_COLOURS; c++)
                own = own || canvas.colour[c] == i;
            assert_int_equal(colours[i], own ? view_adjust_colour((enum colour_blind_mode)view, was[i]) : was[i]);
        }
        const double dark = light_of(colours[canvas.colour[CANVAS_DARK]]);
        for (int c = CANVAS_DARK + 1; c < CANVAS_COLOURS; c++)
            assert_true((light_of(colours[canvas.colour[c]]) + 0.05) / (dark + 0.05) >= 4.5);
    }
}

/* Whatever the numbers and the text, drawing ends and stays inside. */
TEST(extremes_are_clipped)
{
    static const int v[] = { INT_MIN, INT_MIN / 2, -70000, 5, INT_MAX / 2, INT_MAX };
    enum { N = sizeof v / sizeof *v };
    char text[600];

    clear();
    for (int i = 0; i < N * N * N; i++) {
        int x = v[i % N], y = v[i / N % N], r = v[i / N / N];
        canvas_circle(&canvas, x, y, r, CANVAS_RED);
        canvas_disc(&canvas, x, y, r, CANVAS_RED);
        canvas_box(&canvas, x, y, r, x, CANVAS_RED);
        canvas_capsule(&canvas, x, y, r, y, x, CANVAS_RED);
        canvas_line(&canvas, x, y, r, x, CANVAS_RED);
        canvas_rect(&canvas, x, y, r, y, CANVAS_RED);
        canvas_outline(&canvas, x, y, r, y, CANVAS_RED);
    }
    clear();
    canvas_text(&canvas, W, 0, CANVAS_RED, "MMM");
    canvas_text(&canvas, 0, H, CANVAS_RED, "MMM");
    for (int i = 0; i < W * H; i++)
        assert_int_equal(canvas_at(i % W, i / W), -1);
    for (int w = 8; w <= W; w += 8) {
        fb_init(&fb, memory, w, H);
        canvas_open(&canvas, &fb, colours);
        for (size_t i = 0; i < sizeof text - 1; i++)
            text[i] = (char)(1 + rng_below(&rng, 255));
        text[sizeof text - 1] = 0;
        assert_true(message_draw(&canvas, 0, text) > 0);
        assert_true(message_draw(&canvas, H - 4, text) > 0);
    }
}

RUN_TESTS_EACH(setup, NULL)
