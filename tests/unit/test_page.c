/* test_page.c - messages to be read: all of a text can be got to, on any picture, and nothing is drawn twice. */
#include <stdbool.h>
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/player/overlay/page.h"

enum { W = 400, H = 448 };

struct bed {
    struct fb fb;
    void *mem;
    uint32_t rgb[256];
    struct canvas canvas;
};

static int bed_open(void **state)
{
    struct bed *b = calloc(1, sizeof *b);

    assert_non_null(b);
    b->mem = malloc(fb_size(W, H));
    assert_non_null(b->mem);
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

/* A grey picture of that size. */
static void clear(struct bed *b, int w, int h)
{
    fb_init(&b->fb, b->mem, w, h);
    fb_fill(&b->fb, 77);
    canvas_open(&b->canvas, &b->fb, b->rgb);
}

static bool is(const struct bed *b, int x, int y, enum canvas_colour c)
{
    return b->fb.pix[y * b->fb.pitch + x] == b->canvas.colour[c];
}

/* Pixels of a colour in rows y0 to y1. */
static int ink(const struct bed *b, enum canvas_colour c, int y0, int y1)
{
    int n = 0;

    for (int y = y0; y < y1; y++)
        for (int x = 0; x < b->fb.w; x++)
            n += is(b, x, y, c);
    return n;
}

/* So many lines "l", each a stem of 8 pixels. */
static void lines(char *text, int n)
{
    for (int i = 0; i < n; i++)
        memcpy(text + 2 * i, "l\n", 2);
    text[2 * n] = 0;
}

/* A short message covers what it needs, and the picture is seen below. */
TEST(short_ones_leave_the_picture)
{
    struct bed *b = *state;
    struct page p = { "title", "what happened", "", "what to do", 0, -1 };

    clear(b, 240, 320);
    int y = page_draw(&b->canvas, &p);
    assert_int_equal(p.max_top, 0);
    assert_true(y > 3 * CANVAS_LARGE_LINE_HEIGHT && y < 80);
    assert_true(ink(b, CANVAS_YELLOW, 0, y) > 20 && ink(b, CANVAS_WHITE, 0, y) > 50 && ink(b, CANVAS_CYAN, 0, y) > 40);
    for (int x = 0; x < 240; x++) {
        assert_int_not_equal(b->fb.pix[(y - 1) * b->fb.pitch + x], 77);
        assert_int_equal(b->fb.pix[y * b->fb.pitch + x], 77);
    }
}

/* Title and foot stay, and from the top to the end each line is seen. */
TEST(long_ones_scroll)
{
    static const int sizes[][2] = { { 240, 320 }, { 320, 240 }, { 384, 448 }, { 64, 64 } };
    struct bed *b = *state;
    char text[300];

    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct page p = { "t", text, "", "f", 0, 0 };
        int h = sizes[i][1], shown = 0;
        lines(text, 100);
        clear(b, sizes[i][0], h);
        assert_true(page_draw(&b->canvas, &p) <= h);
        for (int y = 0; y < h; y++)
            shown += is(b, 6, y, CANVAS_WHITE);
        assert_int_equal(shown % 6, 0); /* a stem's first column is 6 px high */
        assert_int_equal(p.max_top, 100 - shown / 6);
        int before = ink(b, CANVAS_WHITE, 0, h);
        p.top = 1000;
        clear(b, sizes[i][0], h);
        page_draw(&b->canvas, &p);
        assert_int_equal(ink(b, CANVAS_WHITE, 0, h), before);
        assert_true(ink(b, CANVAS_YELLOW, 0, 20) > 0 && ink(b, CANVAS_CYAN, h - 30, h) > 0);
    }
}

/* The last line is seen where it is scrolled to, and not before. */
TEST(the_end_is_reached)
{
    struct bed *b = *state;
    char text[400];
    struct page p = { "", text, "", "", 0, 0 };

    lines(text, 60);
    strcat(text, "MMMMMMMMMM");
    clear(b, 240, 120);
    page_draw(&b->canvas, &p);
    int most = p.max_top, none = 0;
    for (p.top = 0; p.top <= most; p.top++) {
        clear(b, 240, 120);
        page_draw(&b->canvas, &p);
        none = 0;
        for (int y = 0; y < 120; y++)
            for (int x = 20; x < 70; x++)
                none += is(b, x, y, CANVAS_WHITE);
        assert_true(p.top == most ? none > 50 : none == 0);
    }
}

TEST(the_second_part_is_fainter)
{
    struct bed *b = *state;
    struct page p = { "", "", "stack", "", 0, 0 };

    clear(b, 240, 120);
    page_draw(&b->canvas, &p);
    assert_int_equal(ink(b, CANVAS_WHITE, 0, 120), 0);
    assert_true(ink(b, CANVAS_GREY, 0, 15) > 20);
}

TEST(anything_ends)
{
    struct bed *b = *state;
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
        clear(b, (int)(1 + rng_below(&r, 50)) * 8, (int)(1 + rng_below(&r, 56)) * 8);
        assert_true(page_draw(&b->canvas, &p) > 0);
        assert_true(p.max_top >= 0);
    }
}

RUN_TESTS_EACH(bed_open, bed_close)
