/*
 * test_button_hints.c - the picture of hints on buttons: what is printed on keys, the colours of controllers' buttons,
 * and hints that don't fit.
 */
#include "../test.h"
#include "../../src/player/overlay/button_hints.h"

enum { WIDTH = 240 };

static uint8_t pixels[WIDTH * BUTTON_HINTS_HEIGHT];
static uint32_t rgb[256];
static struct fb fb;
static struct canvas canvas;

static struct button_hint hints[3];

/* Draws Start, Fire and Bomb. */
static void draw(const char *start, const char *fire, const char *bomb, int width, int kind)
{
    const char *const labels[] = { start, fire, bomb };

    fb = (struct fb){ .pix = pixels, .w = width, .h = BUTTON_HINTS_HEIGHT, .pitch = WIDTH };
    fb_reset_clip(&fb);
    fb_fill(&fb, 0);
    canvas_open(&canvas, &fb, rgb);
    for (int i = 0; i < 3; i++) {
        struct button_cap *cap = &hints[i].cap[0];
        snprintf(cap->label, sizeof cap->label, "%s", labels[i]);
        cap->kind = kind;
        hints[i].meaning = i == 0 ? "Start" : i == 1 ? "Fire" : "Bomb";
    }
    button_hints_draw(&canvas, 0, fb.w, hints, 3);
}

static int count(enum canvas_colour colour)
{
    int n = 0;

    for (int y = 0; y < BUTTON_HINTS_HEIGHT; y++)
        for (int x = 0; x < fb.w; x++)
            n += pixels[y * WIDTH + x] == canvas.colour[colour];
    return n;
}

TEST(keys_are_printed_as_on_the_keyboard)
{
    draw("enter", "z", "lshift", WIDTH, -1);
    assert_string_equal(hints[0].cap[0].label, "Enter");
    assert_string_equal(hints[1].cap[0].label, "Z");
    assert_string_equal(hints[2].cap[0].label, "Shift");
    assert_true(count(CANVAS_WHITE) > 300);
    assert_int_equal(count(CANVAS_RED) + count(CANVAS_GREEN) + count(CANVAS_CYAN), 0);
}

TEST(names_of_keys_are_printed)
{
    static const char *const rows[][2] = { { "lbracket", "[" },          { "kp.", "Num ." },
                                           { "kpenter", "Num Enter" },   { "ctrl+q", "Ctrl+Q" },
                                           { "alt+enter", "Alt+Enter" }, { "f5", "F5" },
                                           { "left", "\u2190" } };
    char out[INPUT_CODE_NAME_SIZE];

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        button_hints_print(rows[i][0], -1, out);
        assert_string_equal(out, rows[i][1]);
    }
    button_hints_print("stick left", PLAT_XBOX, out);
    assert_string_equal(out, "stick left");
}

TEST(both_players_have_a_cap)
{
    draw("enter", "z", "x", WIDTH, -1);
    const int caps = count(CANVAS_WHITE);
    hints[1].cap[1] = (struct button_cap){ "A", PLAT_XBOX };
    button_hints_draw(&canvas, 0, fb.w, hints, 3);
    assert_true(count(CANVAS_GREEN) > 30);
    assert_true(count(CANVAS_WHITE) >= caps);
    hints[1].cap[1].label[0] = '\0';
}

TEST(controllers_have_their_colours)
{
    draw("Menu", "A", "B", WIDTH, PLAT_XBOX);
    assert_string_equal(hints[1].cap[0].label, "A");
    assert_true(count(CANVAS_GREEN) > 30 && count(CANVAS_RED) > 30);
    draw("Options", "\u2715", "\u25CB", WIDTH, PLAT_PS5);
    assert_true(count(CANVAS_CYAN) > 30 && count(CANVAS_RED) > 30);
    draw("+", "B", "A", WIDTH, PLAT_NINTENDO);
    assert_int_equal(count(CANVAS_GREEN) + count(CANVAS_RED), 0);
}

TEST(what_does_not_fit_is_left_out)
{
    draw("enter", "A", "B", 112, PLAT_XBOX);
    assert_true(count(CANVAS_GREEN) > 30);
    assert_int_equal(count(CANVAS_RED), 0);
}

RUN_TESTS(NULL, NULL)
