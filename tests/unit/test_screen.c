/*
 * test_screen.c - the program's screens: the stack of them, what each switch and the mouse do, questions, and that any
 * list fits any picture, whatever becomes of its rows.
 */
#include "../test.h"
#include "../../src/base/int.h"
#include "../../src/base/rng.h"
#include "../../src/player/screens/screen.h"
#include "../../src/workbench/pack/lang.h"

enum { MOST = 64 };
enum { ENTER = 40, ESCAPE = 41, BACKSPACE = 42, PAGE_UP = 75, DELETE = 76, PAGE_DOWN = 78, RIGHT = 79, LEFT = 80 };
enum { DOWN = 81, UP = 82, SHIFT = 225 };

/* A screen of which everything can be another way from frame to frame; what was done to it is written down. */
struct list {
    int n;
    char kind[MOST + 1]; /* of each row: ' ' plain, # heading, = changes, - disabled, ~ help of a line and a word */
    int value[MOST];
    int accepted, removed, closed, listened; /* the row of the last, or how often; accepted, removed: -1 none */
    bool listens;
};

static int rows(void *context)
{
    return ((const struct list *)context)->n;
}

static const char nearly_a_line[] = "This is one word longer than a line is in here.";

static void row(void *context, int at, struct screen_row *row)
{
    const struct list *l = context;

    assert_in_range(at, 0, l->n - 1);
    snprintf(row->label, sizeof row->label, "row %d", at);
    snprintf(row->help, sizeof row->help, "A sentence about %d, which is longer than most of the pictures are wide.",
             at);
    if (l->kind[at] == '~')
        snprintf(row->help, sizeof row->help, "%s", nearly_a_line);
    row->heading = l->kind[at] == '#';
    row->changes = l->kind[at] == '=';
    row->disabled = l->kind[at] == '-';
    row->removable = true;
    if (row->changes)
        snprintf(row->value, sizeof row->value, "%d", l->value[at]);
}

static void change(void *context, int at, int by)
{
    ((struct list *)context)->value[at] += by;
}

static void accept(void *context, int at)
{
    ((struct list *)context)->accepted = at;
}

static void take_away(void *context, int at)
{
    struct list *l = context;

    l->removed = at;
    l->n--;
}

static void closed(void *context)
{
    ((struct list *)context)->closed++;
}

static bool listen(void *context, const struct plat_input *in)
{
    struct list *l = context;

    (void)in;
    l->listened += l->listens;
    return l->listens;
}

static const char *text(void *context)
{
    (void)context;
    return "Sentences above the list, of which there may be more than fit into one line.\nAnd a second one.";
}

static int height(void *context, int w, int h)
{
    (void)context;
    (void)w;
    return h / 3;
}

static void draw(void *context, int at, const struct canvas *canvas, struct screen_area to)
{
    assert_in_range(at, 0, ((const struct list *)context)->n - 1);
    canvas_rect(canvas, to.x, to.y, to.w, to.h, CANVAS_RED);
}

static const struct screen_def all = { .title = "all",
                                       .rows = rows,
                                       .row = row,
                                       .change = change,
                                       .accept = accept,
                                       .remove = take_away,
                                       .removal = "Take",
                                       .closed = closed,
                                       .listen = listen },
                               bare = { .title = "bare", .small = true, .rows = rows, .row = row },
                               full = { .title = "full",
                                        .rows = rows,
                                        .row = row,
                                        .text = text,
                                        .height = height,
                                        .draw = draw,
                                        .change = change,
                                        .accept = accept,
                                        .remove = take_away };

/* ---- a stack with one list, and a picture ---- */

static struct screens screens;
static struct list list;
static struct fb fb;
static uint8_t mem[1 << 20];
static uint32_t rgb[256];

static void lay(struct list *l, const char *kinds)
{
    *l = (struct list){ .n = (int)strlen(kinds), .accepted = -1, .removed = -1 };
    snprintf(l->kind, sizeof l->kind, "%s", kinds);
}

static void resize(int w, int h)
{
    assert_true(fb_size(w, h) <= sizeof mem);
    fb_init(&fb, mem, w, h);
}

static void show(void)
{
    struct canvas canvas;

    fb_fill(&fb, 0);
    canvas_open(&canvas, &fb, rgb);
    screens_draw(&screens, &canvas, fb.h);
}

static void poll(const struct plat_input *in, uint16_t pad)
{
    struct keys_state k = { .pads = { 0, pad } };

    screens_poll(&screens, in, &k);
    show();
}

static const struct plat_input idle = { .mouse_x = -1, .mouse_y = -1 };

static void rest(void)
{
    poll(&idle, 0);
}

static struct plat_input holding(int key)
{
    struct plat_input in = { .mouse_x = -1, .mouse_y = -1 };

    in.keys[key >> 3] = (uint8_t)(1u << (key & 7));
    return in;
}

static void hold(int key, int frames)
{
    const struct plat_input in = holding(key);

    for (int i = 0; i < frames; i++)
        poll(&in, 0);
}

static void tap(int key)
{
    hold(key, 1);
    rest();
}

static void tap_pad(uint16_t pad)
{
    poll(&idle, pad);
    rest();
}

static void tap_switch(int which, enum plat_button s)
{
    struct plat_input in = { .mouse_x = -1, .mouse_y = -1 };

    in.controllers[which] = 1u << s;
    poll(&in, 0);
    rest();
}

static int chosen(void)
{
    return screens.place[screens.depth - 1].row;
}

static void open_list(const char *kinds)
{
    screens_close_all(&screens);
    lay(&list, kinds);
    screens_open(&screens, &all, &list);
    show();
    rest();
}

static int setup(void **state)
{
    (void)state;
    screens = (struct screens){ 0 };
    resize(240, 320);
    return 0;
}

/* ---- the stack ---- */

TEST(screens_lie_on_one_another)
{
    struct list below, above;

    lay(&below, "   ");
    lay(&above, "  ");
    rest(); /* harmless without a screen */
    screens_open(&screens, &all, &below);
    rest();
    tap(DOWN);
    screens_open(&screens, &all, &above);
    rest();
    tap(ENTER);
    assert_int_equal(above.accepted, 0);
    assert_int_equal(below.accepted, -1);
    tap(ESCAPE);
    assert_int_equal(above.closed, 1);
    assert_int_equal(chosen(), 1); /* where it was */
    tap(BACKSPACE);
    assert_int_equal(below.closed, 1);
    assert_false(screens_are_open(&screens));
    for (int i = 0; i < SCREENS_MAX_DEPTH + 3; i++)
        screens_open(&screens, i % 2 ? &all : &bare, &below);
    assert_int_equal(screens.depth, SCREENS_MAX_DEPTH);
    screens_close_all(&screens);
    assert_int_equal(below.closed, 1 + SCREENS_MAX_DEPTH / 2);
    assert_false(screens_are_open(&screens));
}

/* What is held when a screen opens was pressed for something else. */
TEST(what_was_held_before_means_nothing)
{
    struct plat_input in = holding(ENTER);

    lay(&list, "  ");
    screens_open(&screens, &all, &list);
    show();
    in.mouse_buttons = 1;
    in.mouse_x = screens.list.x + 9;
    in.mouse_y = screens.list.y + screens.row_height + 2;
    for (int i = 0; i < 100; i++)
        poll(&in, PAD_FIRE | PAD_DOWN);
    assert_int_equal(list.accepted, -1);
    rest();
    tap(ENTER);
    assert_int_equal(list.accepted, 0);
}

/* ---- switches ---- */

TEST(headings_are_passed_over)
{
    open_list("# ## =#");
    assert_int_equal(chosen(), 1);
    tap(DOWN);
    assert_int_equal(chosen(), 4);
    tap(DOWN);
    tap(DOWN);
    assert_int_equal(chosen(), 1); /* round the end */
    tap(UP);
    assert_int_equal(chosen(), 5);
    screens_choose(&screens, 3);
    screens_choose(&screens, 7);
    assert_int_equal(chosen(), 5);
    screens_choose(&screens, 4);
    assert_int_equal(chosen(), 4);
    open_list("##");
    tap(DOWN);
    tap(ENTER);
    assert_int_equal(list.accepted, -1);
}

TEST(every_device_works)
{
    struct plat_input shift_right = holding(RIGHT);

    open_list("=    ");
    tap_pad(PAD_RIGHT);
    tap_switch(0, PLAT_DPAD_RIGHT);
    tap_switch(1, PLAT_LEFT_STICK_RIGHT);
    tap(RIGHT);
    assert_int_equal(list.value[0], 4);
    tap_pad(PAD_RIGHT | PAD_FOCUS);
    assert_int_equal(list.value[0], 14);
    shift_right.keys[SHIFT >> 3] |= 1u << (SHIFT & 7);
    poll(&shift_right, 0);
    assert_int_equal(list.value[0], 24);
    tap_pad(PAD_LEFT);
    tap_switch(1, PLAT_DPAD_LEFT);
    tap_switch(0, PLAT_LEFT_STICK_LEFT);
    tap(LEFT);
    assert_int_equal(list.value[0], 20);
    tap_pad(PAD_FIRE); /* accepting a value changes it */
    assert_int_equal(list.value[0], 21);
    tap_pad(PAD_DOWN);
    tap_switch(0, PLAT_DPAD_DOWN);
    tap_switch(0, PLAT_LEFT_STICK_DOWN);
    assert_int_equal(chosen(), 3);
    tap_switch(1, PLAT_LEFT_STICK_UP);
    tap_switch(1, PLAT_DPAD_UP);
    assert_int_equal(chosen(), 1);
    tap(DELETE);
    tap_pad(PAD_SPECIAL);
    tap_switch(1, PLAT_NORTH);
    assert_int_equal(list.n, 2);
}

TEST(every_device_accepts_and_closes)
{
    static const uint16_t yes[] = { PAD_FIRE, PAD_START }, no[] = { PAD_BOMB };
    static const enum plat_button accepts[] = { PLAT_SOUTH, PLAT_START }, closes[] = { PLAT_EAST, PLAT_GUIDE };

    for (int i = 0; i < 4; i++) {
        open_list(" ");
        if (i < 2)
            tap_pad(yes[i]);
        else
            tap_switch(i % 2, accepts[i - 2]);
        assert_int_equal(list.accepted, 0);
    }
    for (int i = 0; i < 3; i++) {
        open_list(" ");
        if (i < 1)
            tap_pad(no[i]);
        else
            tap_switch(i % 2, closes[i - 1]);
        assert_int_equal(list.closed, 1);
    }
}

TEST(what_is_faint_or_plain_stays)
{
    open_list("- ");
    tap(ENTER);
    assert_int_equal(list.accepted, -1);
    tap(DOWN);
    tap(RIGHT);
    assert_int_equal(list.value[1], 0);
    screens_close_all(&screens);
    screens_open(&screens, &bare, &list); /* without any function */
    rest();
    tap(DOWN);
    tap(ENTER);
    tap(DELETE);
    tap(LEFT);
    assert_int_equal(chosen(), 1);
    tap(ESCAPE);
    assert_false(screens_are_open(&screens));
}

TEST(yes_and_no_is_no)
{
    open_list(" ");
    tap_pad(PAD_FIRE | PAD_BOMB);
    assert_int_equal(list.accepted, -1);
    assert_int_equal(list.closed, 1);
}

TEST(arrows_repeat)
{
    open_list("=    ");
    hold(RIGHT, 20);
    assert_int_equal(list.value[0], 1);
    hold(RIGHT, 1);
    assert_int_equal(list.value[0], 2);
    hold(RIGHT, 6);
    assert_int_equal(list.value[0], 4);
    hold(DOWN, 20); /* another key starts again */
    assert_int_equal(chosen(), 1);
    rest();
    hold(ENTER, 1);
    list.accepted = -1;
    hold(ENTER, 100); /* nothing else repeats */
    assert_int_equal(list.accepted, -1);
}

TEST(pages)
{
    resize(240, 120);
    open_list("#                                                 ");
    const int far = screens.shown - 1;
    assert_in_range(far, 2, 12);
    tap(PAGE_DOWN);
    tap_switch(0, PLAT_SHOULDER_RIGHT);
    assert_int_equal(chosen(), 1 + 2 * far);
    tap(PAGE_UP);
    tap_switch(1, PLAT_SHOULDER_LEFT);
    assert_int_equal(chosen(), 1);
    hold(PAGE_DOWN, 200);
    assert_int_equal(chosen(), 49); /* not beyond the end */
    hold(PAGE_UP, 200);
    assert_int_equal(chosen(), 1);
}

/* The chosen row is always one of those that are shown. */
TEST(the_list_follows)
{
    resize(160, 90);
    open_list("#       #           #              ");
    for (int i = 0; i < 100; i++) {
        const struct screen_place *p = &screens.place[0];
        assert_in_range(p->row, p->top, p->top + screens.shown - 1);
        assert_true(p->top + screens.shown <= list.n);
        tap(i < 60 ? DOWN : UP);
    }
}

/* ---- sounds ---- */

/* The sound of the last input; -1: none. */
static int sounded(void)
{
    int which = -1;

    for (int i = 0; i < THEME_SOUNDS; i++) {
        assert_true(!screens.sounded[i] || which < 0);
        which = screens.sounded[i] ? i : which;
        screens.sounded[i] = false;
    }
    return which;
}

TEST(inputs_have_sounds)
{
    open_list("  =-");
    assert_int_equal(sounded(), THEME_OPEN);
    rest();
    assert_int_equal(sounded(), -1);
    tap(DOWN);
    assert_int_equal(sounded(), THEME_MOVE);
    tap(RIGHT); /* the row does not change */
    assert_int_equal(sounded(), -1);
    tap(ENTER);
    assert_int_equal(sounded(), THEME_ACCEPT);
    tap(DOWN);
    sounded();
    tap(RIGHT);
    assert_int_equal(sounded(), THEME_MOVE);
    tap(DOWN);
    sounded();
    tap(ENTER); /* a row that cannot be accepted */
    assert_int_equal(sounded(), -1);
    screens_open(&screens, &all, &list);
    assert_int_equal(sounded(), -1); /* it is above another, whose accepting has sounded */
    rest();
    tap(ESCAPE);
    assert_int_equal(sounded(), THEME_BACK);
}

/* ---- the mouse ---- */

static void point(int at, uint8_t buttons, int wheel)
{
    poll(&(struct plat_input){ .mouse_x = screens.list.x + 20,
                               .mouse_y = screens.list.y + at * screens.row_height + screens.row_height / 2,
                               .mouse_buttons = buttons,
                               .wheel = wheel },
         0);
}

TEST(a_mouse)
{
    open_list(" #  = ");
    point(0, 0, 0);
    point(3, 0, 0);
    assert_int_equal(chosen(), 3);
    point(1, 1, 0); /* a heading: neither chosen nor accepted */
    assert_int_equal(chosen(), 3);
    assert_int_equal(list.accepted, -1);
    point(2, 0, 0);
    point(2, 1, 0);
    assert_int_equal(list.accepted, 2);
    list.accepted = -1;
    point(2, 1, 0); /* held */
    point(5, 1, 0);
    assert_int_equal(chosen(), 5);
    point(6, 0, 0); /* below the last row */
    point(6, 1, 0);
    assert_int_equal(list.accepted, -1);
    point(4, 0, 0);
    tap(UP); /* a mouse at rest chooses nothing again */
    assert_int_equal(chosen(), 3);
    point(4, 0, 0);
    point(4, 1, 0);
    assert_int_equal(list.value[4], 1);
    point(4, 0, -1);
    assert_int_equal(chosen(), 5);
    point(4, 0, 1);
    assert_int_equal(chosen(), 4);
    point(4, 2, 0);
    assert_int_equal(list.closed, 1);
}

/* A mouse that lies on a row when the screen opens has not chosen it. */
TEST(a_mouse_that_lies_there)
{
    open_list("    ");
    for (int i = 0; i < 4; i++)
        point(3, 0, 0);
    assert_int_equal(chosen(), 0);
    point(1, 0, 0);
    assert_int_equal(chosen(), 1);
    poll(&idle, 0); /* the window goes, and comes back under the mouse */
    point(3, 0, 0);
    assert_int_equal(chosen(), 1);
    point(2, 0, 0);
    assert_int_equal(chosen(), 2);
}

/* A changed value may give the window another size: then the mouse is elsewhere, though nobody moved it. */
TEST(a_window_that_moves_under_the_mouse)
{
    open_list("= =  ");
    point(3, 0, 0);
    point(0, 0, 0);
    point(0, 1, 0);
    assert_int_equal(list.value[0], 1);
    for (int i = 0; i < 60; i++)
        point(3, 0, 0);
    assert_int_equal(chosen(), 0);
    point(1, 0, 0); /* a hand that moves it later does choose */
    assert_int_equal(chosen(), 1);
}

/* ---- questions, listening, sayings ---- */

static int asked;

static void then(void *context)
{
    assert_string_equal(context, "of");
    asked++;
}

static void ask(void)
{
    static char context[] = "of";

    screens_ask(&screens, "Lose it?", "lose it", then, context);
    rest();
}

TEST(a_question)
{
    asked = 0;
    open_list(" ");
    ask();
    tap(ENTER); /* no comes first */
    assert_int_equal(screens.depth, 1);
    ask();
    tap(DOWN);
    tap(ESCAPE);
    assert_int_equal(screens.depth, 1);
    assert_int_equal(asked, 0);
    ask();
    tap(DOWN);
    tap(ENTER);
    assert_int_equal(screens.depth, 1);
    assert_int_equal(asked, 1);
    assert_int_equal(list.accepted, -1);
}

TEST(who_listens_has_all_switches)
{
    open_list("  ");
    list.listens = true;
    tap(ESCAPE);
    tap_pad(PAD_DOWN);
    hold(ENTER, 1);
    assert_int_equal(list.listened, 5);
    assert_true(screens_are_open(&screens));
    list.listens = false;
    hold(ENTER, 1); /* it was pressed while it listened */
    assert_int_equal(list.accepted, -1);
    rest();
    tap(ENTER);
    assert_int_equal(list.accepted, 0);
}

static uint32_t ink(void)
{
    uint32_t n = 0;

    for (int y = 0; y < fb.h; y++)
        for (int x = 0; x < fb.w; x++)
            n = n * 31 + fb.pix[y * fb.pitch + x];
    return n;
}

/* A message is shown for four seconds, or until another row is chosen. */
TEST(messages)
{
    open_list("  ");
    tap(DOWN);
    const uint32_t second = ink();
    tap(UP);
    const uint32_t first = ink();
    screens_show_message(&screens, "%d settings are not kept", 3);
    for (int i = 0; i < 239; i++)
        rest();
    assert_int_not_equal(ink(), first);
    rest();
    assert_int_equal(ink(), first);
    screens_show_message(&screens, "%s", "of the first");
    tap(DOWN);
    assert_int_equal(ink(), second);
}

/* ---- any list in any picture ---- */

TEST(a_list_that_becomes_shorter)
{
    open_list("    ");
    tap(UP);
    assert_int_equal(chosen(), 3);
    for (int i = 0; i < 6; i++)
        tap(DELETE);
    assert_int_equal(list.n, 0);
    tap(ENTER);
    tap(DOWN);
    assert_int_equal(list.accepted, -1);
    open_list("   ");
    tap(UP);
    list.n = 1; /* by itself */
    show();
    rest();
    assert_int_equal(chosen(), 0);
    list.n = 2;
    list.kind[0] = '#';
    rest();
    assert_int_equal(chosen(), 1);
}

/* ---- how it looks ---- */

static void expect_buttons(const char *accept, const char *back, const char *removal)
{
    const char *const want[SCREEN_BUTTONS] = { accept, back, removal };
    char got[SCREEN_VALUE];

    for (enum screen_button b = 0; b < SCREEN_BUTTONS; b++) {
        screens_describe_button(&screens, b, got, sizeof got);
        assert_string_equal(got, want[b]);
    }
}

TEST(buttons_are_described)
{
    open_list("= -");
    expect_buttons("Change", "Back", "Take");
    tap(DOWN);
    expect_buttons("Select", "Back", "Take");
    tap(DOWN);
    expect_buttons("", "Back", "Take");
    list.listens = true;
    rest();
    expect_buttons("", "", "");
    screens_close_all(&screens);
    screens_open(&screens, &bare, &list);
    expect_buttons("", "Back", "");
    list.n = 0;
    expect_buttons("", "Back", "");
}

enum { HEIGHT = 300, FRAME_BOTTOM = HEIGHT - 8, HELP_BOTTOM = FRAME_BOTTOM - 8 }; /* of a large screen, px */

/* Draws the list in the first HEIGHT rows of an empty picture. */
static struct canvas draw_alone(void)
{
    struct canvas canvas;

    fb_fill(&fb, 0);
    canvas_open(&canvas, &fb, rgb);
    screens_draw(&screens, &canvas, HEIGHT);
    return canvas;
}

/* The game shows around the frame of a large screen. */
TEST(frames_have_a_margin)
{
    open_list("  ");
    draw_alone();
    for (int y = 0; y < fb.h; y++)
        for (int x = 0; x < fb.w; x++) {
            const bool inside = x >= 8 && x < fb.w - 8 && y >= 8 && y < FRAME_BOTTOM;
            if (!inside)
                assert_int_equal(fb.pix[y * fb.pitch + x], 0);
        }
    assert_int_not_equal(fb.pix[100 * fb.pitch + 8], 0);
    assert_int_not_equal(fb.pix[(FRAME_BOTTOM - 1) * fb.pitch + 100], 0);
}

/* Returns the rightmost pixel of white text in a line of help, from 0. */
static int line_end(const struct canvas *canvas, int line)
{
    const int h = canvas_line_height(canvas), top = HELP_BOTTOM - 3 * h + line * h;
    int end = 0;

    for (int y = top; y < top + h; y++)
        for (int x = 16; x < fb.w - 16; x++)
            end = fb.pix[y * fb.pitch + x] == canvas->colour[CANVAS_WHITE] ? int_max(end, x) : end;
    return end;
}

TEST(no_line_has_a_single_word)
{
    open_list("~");
    const struct canvas canvas = draw_alone();
    assert_in_range(canvas_large_text_width(&canvas, nearly_a_line), fb.w - 32, fb.w);
    assert_in_range(line_end(&canvas, 0), 110, 160);
    assert_in_range(line_end(&canvas, 1), 110, 160);
    assert_int_equal(line_end(&canvas, 2), 0);
}

/* The help of all lists is at the same place, so that nothing jumps from page to page. */
TEST(lists_end_at_the_same_place)
{
    open_list("~");
    draw_alone();
    const int rows = screens.list.h;
    open_list("   ");
    draw_alone();
    assert_int_equal(screens.list.h, rows);
}

/* A bar next to the rows shows which part of a list is visible. */
TEST(long_lists_have_a_track)
{
    int before[2] = { 0 };

    open_list("                                                            ");
    for (int end = 0; end < 2; end++) {
        const struct canvas canvas = draw_alone();
        const int x = screens.list.x + screens.list.w - 2, y = screens.list.y;
        before[end] = fb.pix[(y + 1) * fb.pitch + x] == canvas.colour[CANVAS_CYAN];
        assert_int_equal(fb.pix[(y + screens.shown * screens.row_height / 2) * fb.pitch + x],
                         canvas.colour[CANVAS_GREY]);
        tap(UP);
    }
    assert_int_equal(before[0], 1);
    assert_int_equal(before[1], 0);
}

TEST(whatever_happens)
{
    static const struct screen_def *const defs[] = { &all, &bare, &full };
    static const int sizes[][2] = { { 240, 320 }, { 320, 240 }, { 384, 448 }, { 160, 144 }, { 64, 64 }, { 16, 16 } };
    struct rng r;

    rng_seed(&r, 7);
    for (int round = 0; round < 300; round++) {
        const int *size = sizes[rng_below(&r, 6)];
        resize(size[0], size[1]);
        screens_close_all(&screens);
        lay(&list, "");
        for (list.n = 0; list.n < (int)rng_below(&r, MOST); list.n++)
            list.kind[list.n] = " ==#-"[rng_below(&r, 5)];
        screens_open(&screens, defs[rng_below(&r, 3)], &list);
        for (int frame = 0; frame < 60; frame++) {
            struct plat_input in = holding((int)(75 + rng_below(&r, 8)));
            in.controllers[0] = rng_below(&r, 4) == 0 ? 1u << rng_below(&r, PLAT_BUTTONS) : 0;
            in.mouse_x = (int)rng_below(&r, 400) - 8;
            in.mouse_y = (int)rng_below(&r, 460) - 8;
            in.mouse_buttons = rng_below(&r, 4) == 0;
            in.wheel = (int)rng_below(&r, 3) - 1;
            poll(&in, rng_below(&r, 8) == 0 ? (uint16_t)(1u << rng_below(&r, 16)) : 0);
            if (rng_below(&r, 6) == 0 && list.n > 0)
                list.kind[rng_below(&r, (uint64_t)list.n)] = " =#"[rng_below(&r, 3)];
            if (rng_below(&r, 9) == 0)
                list.n = (int)rng_below(&r, (uint64_t)list.n + 1);
            show();
        }
    }
}

/* ---- languages ---- */

static uint8_t *lump;

static void speak(const char *file)
{
    struct lang lang;
    char err[256];

    if (!lang_read(&lang, file, strlen(file), "lang/xx.txt", err, sizeof err))
        fail_msg("%s", err);
    free(lump);
    assert_true(lang_make(&lang, &lump) > 0);
    screens.words = words_of(lump);
    lang_free(&lang);
}

static void translated(const char *text, const char *want)
{
    char out[40];

    screen_translate(&screens.words, text, out, sizeof out);
    assert_string_equal(out, want);
}

TEST(screens_are_translated)
{
    struct screen_row row;
    char text[SCREEN_TEXT];

    open_list(" =");
    speak("row %d = Zeile %d\nall = alles\nfull = voll\n%d = Nr. %d\n"
          "Sentences above the list, of which there may be more than fit into one line. = Oben.\n"
          "A sentence about %d, which is longer than most of the pictures are wide. = Hilfe zu %d.\n");
    row = screen_place_row(&screens.place[0], 1);
    assert_string_equal(row.label, "Zeile 1");
    assert_string_equal(row.value, "Nr. 0");
    assert_string_equal(row.help, "Hilfe zu 1.");
    assert_true(row.changes);
    screen_place_title(&screens.place[0], text, sizeof text);
    assert_string_equal(text, "alles");
    screen_place_text(&screens.place[0], text, sizeof text);
    assert_string_equal(text, "");
    screens_open(&screens, &full, &list);
    screen_place_text(&screens.place[1], text, sizeof text); /* line by line: the second has no translation */
    assert_string_equal(text, "Oben.\nAnd a second one.");
    show();
    screens.words = (struct words){ 0 };
    screen_place_text(&screens.place[1], text, sizeof text);
    assert_true(strncmp(text, "Sentences", 9) == 0);
}

#define TIDES_13                                                                                                       \
    "\xe6\xbd\xae\xe6\xbd\xae\xe6\xbd\xae\xe6\xbd\xae\xe6\xbd\xae\xe6\xbd\xae\xe6\xbd\xae\xe6\xbd\xae\xe6\xbd\xae"     \
    "\xe6\xbd\xae\xe6\xbd\xae\xe6\xbd\xae\xe6\xbd\xae"

TEST(text_is_looked_up)
{
    speak("On = An\nPlayer %d = Spieler %d\n%d of %d = %d von %d\nNone %d = Keiner\nOne = %d %d\nTwo %d = %d %d\n"
          "Long = " TIDES_13 "\xe6\xbd\xae\n");
    translated("On", "An");
    translated("  On", "  An");
    translated("Off", "Off");
    translated("", "");
    translated("Player 12", "Spieler 12");
    translated("3 of 04", "3 von 04");
    translated("None 5", "Keiner");
    translated("One", "%d %d"); /* a translation is no format */
    translated("Two 2", "2 %d");
    translated("1 2 3 4 5 6 7 8 9", "1 2 3 4 5 6 7 8 9");
    translated("On\nOff\n  Player 2\n", "An\nOff\n  Spieler 2\n");
    translated("Long", TIDES_13); /* whole characters */
}

/* A ROM may come from anywhere: a translation never takes other arguments than the program passes. */
TEST(formats_are_translated)
{
    char out[64];

    speak("%s has %d%% = %s: %d%%\nGone: %s = Weg: %n\nMore: %s = Mehr: %s %s\nEnd: %s = Ende: %s %\n"
          "Less: %s = Weniger\nSwap: %s %d = %d %s\nWide: %s = %9s\nremoved %s = %s entfernt\n");
    screens_format(&screens, out, sizeof out, "%s has %d%%", "x", 5);
    assert_string_equal(out, "x: 5%");
    screens_format(&screens, out, sizeof out, "Gone: %s", "x");
    assert_string_equal(out, "Gone: x");
    screens_format(&screens, out, sizeof out, "More: %s", "x");
    assert_string_equal(out, "More: x");
    screens_format(&screens, out, sizeof out, "End: %s", "x");
    assert_string_equal(out, "End: x");
    screens_format(&screens, out, sizeof out, "Less: %s", "x");
    assert_string_equal(out, "Less: x");
    screens_format(&screens, out, sizeof out, "Swap: %s %d", "x", 5);
    assert_string_equal(out, "Swap: x 5");
    screens_format(&screens, out, sizeof out, "Wide: %s", "x");
    assert_string_equal(out, "Wide: x");
    screens_show_message(&screens, "removed %s", "z");
    assert_string_equal(screens.message, "z entfernt");
}

RUN_TESTS_EACH(setup, NULL)
