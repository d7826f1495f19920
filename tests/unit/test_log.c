/* test_log.c - the lines that the window's log keeps, and the screen that shows them. */
#include "../test.h"
#include "../../src/player/screens/log.h"

enum { KEY_PAGE_UP = 75, W = 240, H = 160 };

static struct log l;
static struct screens s;

static int begin(void **state)
{
    (void)state;
    memset(&l, 0, sizeof l);
    memset(&s, 0, sizeof s);
    return 0;
}

static const char *kept(int i)
{
    return log_line(&l, i)->text;
}

TEST(lines)
{
    assert_int_equal(log_count(&l), 0);
    log_add(&l, LOG_SCRIPT, 7, "one");
    log_add(&l, LOG_FAULT, 8, "two\n\n\tthree\n");
    log_add(&l, LOG_SCRIPT, 9, "");
    assert_int_equal(log_count(&l), 3);
    assert_string_equal(kept(0), "one");
    assert_int_equal(log_line(&l, 0)->frame, 7);
    assert_string_equal(kept(1), "two");
    assert_string_equal(kept(2), "\tthree");
    assert_int_equal(log_line(&l, 2)->kind, LOG_FAULT);
}

/* What is printed in every frame takes one line, as long as nothing else comes between. */
TEST(again)
{
    for (uint32_t i = 0; i < 60; i++)
        log_add(&l, LOG_SCRIPT, 100 + i, "hp 12");
    log_add(&l, LOG_FAULT, 160, "hp 12");
    log_add(&l, LOG_SCRIPT, 161, "hp 12");
    assert_int_equal(log_count(&l), 3);
    assert_int_equal(log_line(&l, 0)->times, 60);
    assert_int_equal(log_line(&l, 0)->frame, 100);
    assert_int_equal(log_line(&l, 1)->times, 1);
}

/* Adds n lines, NAME 0 and so on. */
static void fill_with(const char *name, int n)
{
    char text[32];

    for (int i = 0; i < n; i++) {
        snprintf(text, sizeof text, "%s %d", name, i);
        log_add(&l, LOG_SCRIPT, (uint32_t)i, text);
    }
}

/* The oldest lines go. */
TEST(many)
{
    fill_with("line", 3 * LOG_LINES + 5);
    assert_int_equal(log_count(&l), LOG_LINES);
    for (int i = 0; i < LOG_LINES; i++)
        assert_int_equal(log_line(&l, i)->frame, 2 * LOG_LINES + 5 + i);
    assert_string_equal(kept(0), "line 805");
}

/* A long line is cut behind a whole character; what a terminal would obey is blanked. */
TEST(long_lines)
{
    char text[2 * LOG_LINE] = "xx";

    for (size_t i = 2; i + 3 < sizeof text; i += 3)
        memcpy(text + i, "\u20ac", 4);
    for (int skip = 0; skip < 3; skip++) {
        log_add(&l, LOG_SCRIPT, 0, text + skip);
        const char *line = kept(log_count(&l) - 1);
        const size_t n = strlen(line);
        assert_in_range(n, LOG_LINE - 6, LOG_LINE - 1);
        assert_string_equal(line + n - 3, "...");
        assert_null(strchr(line, '?'));
    }
    log_add(&l, LOG_SCRIPT, 0, "a\033[31mb");
    assert_string_equal(kept(log_count(&l) - 1), "a [31mb");
}

/* ---- the screen ---- */

static const struct plat_input no_input = { .has_focus = true, .mouse_x = -1, .mouse_y = -1 };

static void poll_with(struct plat_input in)
{
    const struct keys_state none = { 0 };

    screens_poll(&s, &no_input, &none);
    screens_poll(&s, &in, &none);
}

static void press(unsigned usage)
{
    struct plat_input in = no_input;

    in.keys[usage / 8] = (uint8_t)(1 << usage % 8);
    poll_with(in);
}

static int chosen(void)
{
    return s.place[0].row;
}

static struct screen_row row_at(int at)
{
    struct screen_row row = { 0 };

    screens_top(&s)->row(s.place[0].context, at, &row);
    return row;
}

static void draw(void)
{
    static uint32_t rgb[256];
    void *memory = malloc(fb_size(W, H));
    struct canvas canvas;
    struct fb fb;

    assert_non_null(memory);
    fb_init(&fb, memory, W, H);
    fb_fill(&fb, 0);
    canvas_open(&canvas, &fb, rgb);
    screens_draw(&s, &canvas, fb.h);
    free(memory);
}

TEST(opens_at_the_end)
{
    log_open(&l, &s);
    draw();
    assert_string_equal(screens_top(&s)->text(&l), "No messages yet.");
    screens_close(&s);
    fill_with("line", 99);
    log_add(&l, LOG_FAULT, 99, "fault");
    log_open(&l, &s);
    draw();
    assert_int_equal(chosen(), 99);
    assert_int_equal(row_at(99).colour, CANVAS_RED);
    assert_string_equal(row_at(98).label, "line 98");
    assert_string_equal(row_at(98).value, "98");
    assert_string_equal(row_at(98).help, "line 98");
}

/* By keys, a controller and the wheel; and out. */
TEST(scrolls)
{
    struct plat_input in = no_input;

    test_opens_at_the_end(state);
    press(KEY_UP);
    assert_int_equal(chosen(), 98);
    in.controllers[2] = 1u << PLAT_DPAD_UP;
    poll_with(in);
    assert_int_equal(chosen(), 97);
    in.controllers[2] = 0;
    in.wheel = 1;
    poll_with(in);
    assert_int_equal(chosen(), 96);
    press(KEY_PAGE_UP);
    assert_in_range(chosen(), 80, 94);
    press(KEY_ESCAPE);
    assert_null(screens_top(&s));
}

/* Lines that come while it is open, of a reload, push the oldest out. */
TEST(stays_in_range)
{
    test_opens_at_the_end(state);
    fill_with("more", 2 * LOG_LINES);
    draw();
    assert_int_equal(chosen(), 99);
    assert_string_equal(row_at(99).label, "more 499");
    log_add(&l, LOG_PROGRAM, 5, "same");
    log_add(&l, LOG_PROGRAM, 6, "same");
    assert_string_equal(row_at(LOG_LINES - 1).value, "2 x  5");
}

RUN_TESTS_EACH(begin, NULL)
