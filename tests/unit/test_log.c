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

/* The oldest lines go. */
TEST(many)
{
    char text[16];

    for (int i = 0; i < 3 * LOG_LINES + 5; i++) {
        snprintf(text, sizeof text, "line %d", i);
        log_add(&l, LOG_SCRIPT, (uint32_t)i, text);
    }
    assert_int_equal(log_count(&l), LOG_LINES);
    for (int i = 0; i < LOG_LINES; i++) {
        snprintf(text, sizeof text, "line %d", 2 * LOG_LINES + 5 + i);
        assert_string_equal(kept(i), text);
    }
}

/* A long line is cut behind a whole character; what a terminal would obey is blanked. */
TEST(long_lines)
{
    char text[2 * LOG_LINE];

    for (size_t first = 0; first < 3; first++) {
        memset(text, 'x', first);
        for (size_t i = first; i + 3 < sizeof text; i += 3)
            memcpy(text + i, "\xe2\x82\xac", 4);
        log_add(&l, LOG_SCRIPT, 0, text);
        const char *line = kept(log_count(&l) - 1);
        assert_true(strlen(line) < LOG_LINE && strlen(line) >= LOG_LINE - 3 - 3);
        assert_int_equal((strlen(line) - first) % 3, 0);
        assert_string_equal(line + strlen(line) - 3, "...");
        assert_null(strchr(line, '?'));
    }
    log_add(&l, LOG_SCRIPT, 0, "a\033[31mb");
    assert_string_equal(kept(log_count(&l) - 1), "a [31mb");
}

/* ---- the screen ---- */

static void poll_with(const struct plat_input *in)
{
    const struct plat_input nothing = { .has_focus = true, .mouse_x = -1, .mouse_y = -1 };
    const struct keys_state none = { 0 };

    screens_poll(&s, &nothing, &none);
    screens_poll(&s, in, &none);
}

static struct plat_input with_key(unsigned usage)
{
    struct plat_input in = { .has_focus = true, .mouse_x = -1, .mouse_y = -1 };

    in.keys[usage / 8] = (uint8_t)(1 << usage % 8);
    return in;
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
    screens_draw(&s, &canvas, "");
    free(memory);
}

TEST(opens_at_the_end)
{
    char text[16];

    log_open(&l, &s);
    draw();
    assert_string_equal(screens_top(&s)->text(&l), "No messages yet.");
    poll_with(&(struct plat_input){ .has_focus = true, .mouse_x = -1, .mouse_y = -1, .wheel = 1 });
    screens_close(&s);
    for (int i = 0; i < 100; i++) {
        snprintf(text, sizeof text, "line %d", i);
        log_add(&l, i == 99 ? LOG_FAULT : LOG_SCRIPT, (uint32_t)i, text);
    }
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
    struct plat_input in = { .has_focus = true, .mouse_x = -1, .mouse_y = -1 };

    test_opens_at_the_end(state);
    in = with_key(KEY_UP);
    poll_with(&in);
    assert_int_equal(chosen(), 98);
    in = (struct plat_input){ .has_focus = true, .mouse_x = -1, .mouse_y = -1 };
    in.controllers[2] = 1u << PLAT_DPAD_UP;
    poll_with(&in);
    assert_int_equal(chosen(), 97);
    in.controllers[2] = 0;
    in.wheel = 1;
    poll_with(&in);
    assert_int_equal(chosen(), 96);
    in = with_key(KEY_PAGE_UP);
    poll_with(&in);
    assert_in_range(chosen(), 80, 94);
    in = with_key(KEY_ESCAPE);
    poll_with(&in);
    assert_null(screens_top(&s));
}

/* Lines that come while it is open, of a reload, push the oldest out. */
TEST(stays_in_range)
{
    char text[16];

    test_opens_at_the_end(state);
    for (int i = 0; i < 2 * LOG_LINES; i++) {
        snprintf(text, sizeof text, "more %d", i);
        log_add(&l, LOG_PROGRAM, 0, text);
    }
    draw();
    assert_int_equal(chosen(), 99);
    assert_string_equal(row_at(99).label, "more 499");
    log_add(&l, LOG_PROGRAM, 5, "same");
    log_add(&l, LOG_PROGRAM, 6, "same");
    assert_string_equal(row_at(LOG_LINES - 1).value, "2 x  5");
}

RUN_TESTS_EACH(begin, NULL)
