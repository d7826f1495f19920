/* test_page.c - messages to be read: all of a text can be got to, on any picture, and nothing is drawn twice. */
#include <stdbool.h>
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/player/overlay/page.h"

static struct fb fb;
static uint8_t mem[1 << 18];
static uint32_t rgb[256];
static struct canvas canvas;

/* A grey picture of that size. */
static void clear(int w, int h)
{
    assert_true(fb_size(w, h) <= sizeof mem);
    fb_init(&fb, mem, w, h);
    fb_fill(&fb, 77);
    canvas_open(&canvas, &fb, rgb);
}

static bool is(int x, int y, enum canvas_colour c)
{
    return fb.pix[y * fb.pitch + x] == canvas.colour[c];
}

/* Pixels of a colour in rows y0 to y1. */
static int ink(enum canvas_colour c, int y0, int y1)
{
    int n = 0;

    for (int y = y0; y < y1; y++)
        for (int x = 0; x < fb.w; x++)
            n += is(x, y, c);
    return n;
}

/* So many lines "l", each a stem of 8 pixels. */
static void lines(char *text, int n)
{
    for (int i = 0; i < n; i++)
        memcpy(text + 2 * i, "l\n", 2);
    text[2 * n] = 0;
}

/* A short message covers what it needs, and the picture is seen below. The second part is fainter. */
TEST(short_ones_leave_the_picture)
{
    struct page p = { "title", "what happened", "stack", "what to do", 0, -1 };

    clear(240, 320);
    int y = page_draw(&canvas, &p);
    assert_int_equal(p.max_top, 0);
    assert_true(y > 3 * CANVAS_LARGE_LINE_HEIGHT && y < 100);
    assert_true(ink(CANVAS_YELLOW, 0, y) > 20 && ink(CANVAS_WHITE, 0, y) > 50);
    assert_true(ink(CANVAS_CYAN, 0, y) > 40 && ink(CANVAS_GREY, 0, y) > 20);
    for (int x = 0; x < 240; x++) {
        assert_int_not_equal(fb.pix[(y - 1) * fb.pitch + x], 77);
        assert_int_equal(fb.pix[y * fb.pitch + x], 77);
    }
}

/* Title and foot stay, and from the top to the end each line is seen. */
TEST(long_ones_scroll)
{
    static const int sizes[][2] = { { 240, 320 }, { 320, 240 }, { 384, 448 }, { 64, 64 } };
    char text[300];

    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct page p = { "t", text, "", "f", 0, 0 };
        int h = sizes[i][1], shown = 0;
        lines(text, 100);
        clear(sizes[i][0], h);
        assert_true(page_draw(&canvas, &p) <= h);
        for (int y = 0; y < h; y++)
            shown += is(6, y, CANVAS_WHITE);
        assert_int_equal(shown % 6, 0); /* a stem's first column is 6 px high */
        assert_int_equal(p.max_top, 100 - shown / 6);
        int before = ink(CANVAS_WHITE, 0, h);
        p.top = 1000;
        clear(sizes[i][0], h);
        page_draw(&canvas, &p);
        assert_int_equal(ink(CANVAS_WHITE, 0, h), before);
        assert_true(ink(CANVAS_YELLOW, 0, 20) > 0 && ink(CANVAS_CYAN, h - 30, h) > 0);
    }
}

/* The last line is seen where it is scrolled to, and not before. */
TEST(the_end_is_reached)
{
    char text[400];
    struct page p = { "", text, "", "", 0, 0 };

    lines(text, 60);
    strcat(text, "MMMMMMMMMM");
    clear(240, 120);
    page_draw(&canvas, &p);
    const int most = p.max_top;
    for (p.top = 0; p.top <= most; p.top++) {
        int drawn = 0; /* right of the stems */
        clear(240, 120);
        page_draw(&canvas, &p);
        for (int i = 0; i < 120 * 50; i++)
            drawn += is(20 + i % 50, i / 50, CANVAS_WHITE);
        assert_true(p.top == most ? drawn > 50 : drawn == 0);
    }
}

TEST(anything_ends)
{
    struct rng r;
    char text[4][500];

    rng_seed(&r, 1);
    for (int n = 0; n < 300; n++) {
        for (int k = 0; k < 4; k++) {
            for (int i = 0; i < 499; i++)
                text[k][i] = (char)(rng_below(&r, 6) == 0 ? '\n' : 1 + rng_below(&r, 255));
            text[k][rng_below(&r, 500)] = 0;
            text[k][499] = 0;
        }
        struct page p = { text[0], text[1], text[2], text[3], (int)rng_below(&r, 200) - 50, 0 };
        clear((int)(1 + rng_below(&r, 50)) * 8, (int)(1 + rng_below(&r, 56)) * 8);
        assert_true(page_draw(&canvas, &p) > 0);
        assert_true(p.max_top >= 0);
    }
}

RUN_TESTS(NULL, NULL)
