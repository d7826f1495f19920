/*
 * test_screen.c - the program's screens: the stack of them, what each switch and the mouse do, questions, and that any
 * list fits any picture, whatever becomes of its rows.
 */
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/player/screens/screen.h"

enum { MOST = 64 };
enum { ENTER = 40, ESCAPE = 41, BACKSPACE = 42, PAGE_UP = 75, DELETE = 76, PAGE_DOWN = 78, RIGHT = 79, LEFT = 80 };
enum { DOWN = 81, UP = 82, SHIFT = 225 };

/* A screen of which everything can be another way from frame to frame; what was done to it is written down. */
struct list {
    int n;
    char kind[MOST + 1]; /* of each row: ' ' plain, # heading, = changes, - faint */
    int value[MOST];
    int accepted, removed, closed, listened; /* the row of the last, or how often; accepted, removed: -1 none */
    bool listens;
    struct screens *s; /* accepting its last row closes all */
};

static int rows(void *context)
{
    return ((const struct list *)context)->n;
}

static void row(void *context, int at, struct screen_row *row)
{
    const struct list *l = context;

    assert_in_range(at, 0, l->n - 1);
    snprintf(row->label, sizeof row->label, "row %d", at);
    snprintf(row->help, sizeof row->help, "A sentence about %d, which is longer than most of the pictures are wide.",
             at);
    row->heading = l->kind[at] == '#';
    row->changes = l->kind[at] == '=';
    row->disabled = l->kind[at] == '-';
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
                                        .remove = take_away },
                               window = { .title = "a window",
                                          .small = true,
                                          .rows = rows,
                                          .row = row,
                                          .text = text,
                                          .change = change,
                                          .accept = accept,
                                          .remove = take_away };

/* ---- a bed: a stack with one list, and a picture ---- */

struct bed {
    struct screens s;
    struct list l;
    struct fb fb;
    void *mem;
    uint32_t rgb[256];
    int w, h;
};

static void lay(struct list *l, const char *kinds)
{
    *l = (struct list){ .n = (int)strlen(kinds), .accepted = -1, .removed = -1 };
    snprintf(l->kind, sizeof l->kind, "%s", kinds);
}

static void resize(struct bed *b, int w, int h)
{
    free(b->mem);
    b->mem = malloc(fb_size(w, h));
    assert_non_null(b->mem);
    fb_init(&b->fb, b->mem, w, h);
    b->w = w;
    b->h = h;
}

static void show(struct bed *b)
{
    struct canvas canvas;

    fb_fill(&b->fb, 0);
    canvas_open(&canvas, &b->fb, b->rgb);
    screens_draw(&b->s, &canvas, "z: choose  x: back");
}

static void poll(struct bed *b, const struct plat_input *in, uint16_t pad)
{
    struct keys_state k = { .pads = { 0, pad } };

    screens_poll(&b->s, in, &k);
    show(b);
}

static void rest(struct bed *b)
{
    poll(b, &(struct plat_input){ .mouse_x = -1, .mouse_y = -1 }, 0);
}

static struct plat_input holding(int key)
{
    struct plat_input in = { .mouse_x = -1, .mouse_y = -1 };

    in.keys[key >> 3] = (uint8_t)(1u << (key & 7));
    return in;
}

static void hold(struct bed *b, int key, int frames)
{
    const struct plat_input in = holding(key);

    for (int i = 0; i < frames; i++)
        poll(b, &in, 0);
}

static void tap(struct bed *b, int key)
{
    hold(b, key, 1);
    rest(b);
}

static void tap_pad(struct bed *b, uint16_t pad)
{
    poll(b, &(struct plat_input){ .mouse_x = -1, .mouse_y = -1 }, pad);
    rest(b);
}

static void tap_switch(struct bed *b, int which, enum plat_button s)
{
    struct plat_input in = { .mouse_x = -1, .mouse_y = -1 };

    in.controllers[which] = 1u << s;
    poll(b, &in, 0);
    rest(b);
}

static int chosen(const struct bed *b)
{
    return b->s.place[b->s.depth - 1].row;
}

static void open_list(struct bed *b, const char *kinds)
{
    screens_close_all(&b->s);
    lay(&b->l, kinds);
    screens_open(&b->s, &all, &b->l);
    show(b);
    rest(b);
}

static int bed_open(void **state)
{
    struct bed *b = calloc(1, sizeof *b);

    assert_non_null(b);
    resize(b, 240, 320);
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

/* ---- the stack ---- */

TEST(screens_lie_on_one_another)
{
    struct bed *b = *state;
    struct list below, above;

    lay(&below, "   ");
    lay(&above, "  ");
    assert_false(screens_are_open(&b->s));
    assert_null(screens_top(&b->s));
    screens_close(&b->s);
    rest(b); /* harmless without a screen */
    screens_open(&b->s, &all, &below);
    rest(b);
    tap(b, DOWN);
    screens_open(&b->s, &all, &above);
    rest(b);
    tap(b, ENTER);
    assert_int_equal(above.accepted, 0);
    assert_int_equal(below.accepted, -1);
    tap(b, ESCAPE);
    assert_int_equal(above.closed, 1);
    assert_int_equal(below.closed, 0);
    assert_int_equal(chosen(b), 1); /* where it was */
    tap(b, BACKSPACE);
    assert_int_equal(below.closed, 1);
    assert_false(screens_are_open(&b->s));
    for (int i = 0; i < SCREENS_MAX_DEPTH + 3; i++)
        screens_open(&b->s, i % 2 ? &all : &bare, &below);
    assert_int_equal(b->s.depth, SCREENS_MAX_DEPTH);
    screens_close_all(&b->s);
    assert_int_equal(below.closed, 1 + SCREENS_MAX_DEPTH / 2);
    assert_false(screens_are_open(&b->s));
}

/* What is held when a screen opens was pressed for something else. */
TEST(what_was_held_before_means_nothing)
{
    struct bed *b = *state;
    struct plat_input in = holding(ENTER);

    lay(&b->l, "  ");
    screens_open(&b->s, &all, &b->l);
    show(b);
    in.mouse_buttons = 1;
    in.mouse_x = b->s.list.x + 9;
    in.mouse_y = b->s.list.y + screen_row_height() + 2;
    for (int i = 0; i < 100; i++)
        poll(b, &in, PAD_FIRE | PAD_DOWN);
    assert_int_equal(b->l.accepted, -1);
    in = holding(ENTER);
    poll(b, &in, PAD_FIRE);
    assert_int_equal(b->l.accepted, -1);
    rest(b);
    tap(b, ENTER);
    assert_int_equal(b->l.accepted, 0);
}

/* ---- switches ---- */

TEST(headings_are_passed_over)
{
    struct bed *b = *state;

    open_list(b, "# ## =#");
    assert_int_equal(chosen(b), 1);
    tap(b, DOWN);
    assert_int_equal(chosen(b), 4);
    tap(b, DOWN);
    assert_int_equal(chosen(b), 5);
    tap(b, DOWN);
    assert_int_equal(chosen(b), 1); /* round the end */
    tap(b, UP);
    assert_int_equal(chosen(b), 5);
    screens_choose(&b->s, 3);
    screens_choose(&b->s, 7);
    screens_choose(&b->s, -1);
    assert_int_equal(chosen(b), 5);
    screens_choose(&b->s, 4);
    assert_int_equal(chosen(b), 4);
    open_list(b, "##");
    tap(b, DOWN);
    tap(b, ENTER);
    assert_int_equal(b->l.accepted, -1);
}

TEST(every_device_works)
{
    struct bed *b = *state;

    open_list(b, " =  ");
    tap_pad(b, PAD_DOWN);
    tap_pad(b, PAD_RIGHT);
    tap_switch(b, 0, PLAT_DPAD_RIGHT);
    tap_switch(b, 1, PLAT_LEFT_STICK_RIGHT);
    tap(b, RIGHT);
    assert_int_equal(b->l.value[1], 4);
    tap_pad(b, PAD_RIGHT | PAD_FOCUS);
    assert_int_equal(b->l.value[1], 14);
    tap_pad(b, PAD_LEFT);
    tap_switch(b, 1, PLAT_DPAD_LEFT);
    tap_switch(b, 0, PLAT_LEFT_STICK_LEFT);
    tap(b, LEFT);
    assert_int_equal(b->l.value[1], 10);
    tap_pad(b, PAD_FIRE); /* who accepts what changes changes it */
    assert_int_equal(b->l.value[1], 11);
    assert_int_equal(b->l.accepted, -1);
    tap_switch(b, 0, PLAT_LEFT_STICK_DOWN);
    tap_switch(b, 1, PLAT_START);
    assert_int_equal(b->l.accepted, 2);
    tap_switch(b, 0, PLAT_DPAD_DOWN);
    tap_pad(b, PAD_START);
    assert_int_equal(b->l.accepted, 3);
    tap_switch(b, 1, PLAT_LEFT_STICK_UP);
    tap_switch(b, 1, PLAT_DPAD_UP);
    tap_pad(b, PAD_UP);
    tap_switch(b, 0, PLAT_SOUTH);
    assert_int_equal(b->l.accepted, 0);
    tap(b, DELETE);
    assert_int_equal(b->l.removed, 0);
    tap_pad(b, PAD_SPECIAL);
    tap_switch(b, 1, PLAT_NORTH);
    assert_int_equal(b->l.n, 1);
    tap_switch(b, 0, PLAT_EAST);
    assert_int_equal(b->l.closed, 1);
    open_list(b, " ");
    tap_pad(b, PAD_BOMB);
    assert_int_equal(b->l.closed, 1);
    open_list(b, " ");
    tap_switch(b, 1, PLAT_GUIDE);
    assert_int_equal(b->l.closed, 1);
}

TEST(ten_steps_with_shift)
{
    struct bed *b = *state;
    struct plat_input in = holding(RIGHT);

    open_list(b, "=");
    in.keys[SHIFT >> 3] |= 1u << (SHIFT & 7);
    poll(b, &in, 0);
    assert_int_equal(b->l.value[0], 10);
}

TEST(what_is_faint_or_plain_stays)
{
    struct bed *b = *state;

    open_list(b, "- ");
    tap(b, ENTER);
    assert_int_equal(b->l.accepted, -1);
    tap(b, DOWN);
    tap(b, RIGHT);
    assert_int_equal(b->l.value[1], 0);
    screens_close_all(&b->s);
    screens_open(&b->s, &bare, &b->l); /* without any function */
    rest(b);
    tap(b, DOWN);
    tap(b, ENTER);
    tap(b, DELETE);
    tap(b, LEFT);
    assert_int_equal(chosen(b), 1);
    tap(b, ESCAPE);
    assert_false(screens_are_open(&b->s));
}

TEST(yes_and_no_is_no)
{
    struct bed *b = *state;

    open_list(b, " ");
    tap_pad(b, PAD_FIRE | PAD_BOMB);
    assert_int_equal(b->l.accepted, -1);
    assert_int_equal(b->l.closed, 1);
    open_list(b, " ");
    poll(b, &(struct plat_input){ .mouse_x = -1, .mouse_y = -1 }, PAD_FIRE);
    assert_int_equal(b->l.accepted, 0);
    b->l.accepted = -1;
    tap_pad(b, PAD_FIRE | PAD_BOMB);
    assert_int_equal(b->l.accepted, -1);
    assert_int_equal(b->l.closed, 1);
}

TEST(arrows_repeat)
{
    struct bed *b = *state;

    open_list(b, "=    ");
    hold(b, RIGHT, 20);
    assert_int_equal(b->l.value[0], 1);
    hold(b, RIGHT, 1);
    assert_int_equal(b->l.value[0], 2);
    hold(b, RIGHT, 6);
    assert_int_equal(b->l.value[0], 4);
    hold(b, DOWN, 1); /* another one begins anew */
    assert_int_equal(chosen(b), 1);
    hold(b, DOWN, 19);
    assert_int_equal(chosen(b), 1);
    hold(b, DOWN, 4);
    assert_int_equal(chosen(b), 3);
    rest(b);
    hold(b, ENTER, 100);
    assert_int_equal(b->l.accepted, 3);
    b->l.accepted = -1;
    hold(b, ENTER, 100); /* nothing else repeats */
    assert_int_equal(b->l.accepted, -1);
}

TEST(pages)
{
    struct bed *b = *state;

    resize(b, 240, 120);
    open_list(b, "#                                                 ");
    const int far = b->s.shown - 1;
    assert_in_range(far, 2, 12);
    tap(b, PAGE_DOWN);
    assert_int_equal(chosen(b), 1 + far);
    tap_switch(b, 0, PLAT_SHOULDER_RIGHT);
    assert_int_equal(chosen(b), 1 + 2 * far);
    tap(b, PAGE_UP);
    assert_int_equal(chosen(b), 1 + far);
    hold(b, PAGE_DOWN, 200);
    assert_int_equal(chosen(b), 49); /* not beyond the end */
    hold(b, PAGE_UP, 200);
    assert_int_equal(chosen(b), 1);
    tap_switch(b, 1, PLAT_SHOULDER_LEFT);
    assert_int_equal(chosen(b), 1);
}

/* The chosen row is always one of those that are shown. */
TEST(the_list_follows)
{
    struct bed *b = *state;

    resize(b, 160, 90);
    open_list(b, "#       #           #              ");
    for (int i = 0; i < 100; i++) {
        const struct screen_place *p = &b->s.place[0];
        assert_in_range(p->row, p->top, p->top + b->s.shown - 1);
        assert_true(p->top + b->s.shown <= b->l.n);
        tap(b, i < 60 ? DOWN : UP);
    }
}

/* ---- the mouse ---- */

static void point(struct bed *b, int at, uint8_t buttons, int wheel)
{
    poll(b,
         &(struct plat_input){ .mouse_x = b->s.list.x + 20,
                               .mouse_y = b->s.list.y + at * screen_row_height() + screen_row_height() / 2,
                               .mouse_buttons = buttons,
                               .wheel = wheel },
         0);
}

TEST(a_mouse)
{
    struct bed *b = *state;

    open_list(b, " #  = ");
    point(b, 0, 0, 0);
    point(b, 3, 0, 0);
    assert_int_equal(chosen(b), 3);
    point(b, 1, 1, 0); /* a heading: neither chosen nor accepted */
    assert_int_equal(chosen(b), 3);
    assert_int_equal(b->l.accepted, -1);
    point(b, 2, 0, 0);
    point(b, 2, 1, 0);
    assert_int_equal(b->l.accepted, 2);
    b->l.accepted = -1;
    point(b, 2, 1, 0);
    assert_int_equal(b->l.accepted, -1); /* held */
    point(b, 5, 1, 0);
    assert_int_equal(chosen(b), 5);
    assert_int_equal(b->l.accepted, -1);
    point(b, 6, 0, 0); /* below the last row */
    point(b, 6, 1, 0);
    assert_int_equal(chosen(b), 5);
    assert_int_equal(b->l.accepted, -1);
    point(b, 4, 0, 0);
    tap(b, UP); /* one that rests chooses nothing again */
    assert_int_equal(chosen(b), 3);
    point(b, 4, 0, 0);
    point(b, 4, 1, 0);
    assert_int_equal(b->l.value[4], 1);
    point(b, 4, 0, -1);
    assert_int_equal(chosen(b), 5);
    point(b, 4, 0, 1);
    assert_int_equal(chosen(b), 4);
    point(b, 4, 2, 0);
    assert_int_equal(b->l.closed, 1);
}

/* One that lies on a row when the screen opens has not chosen it, wherever it was when the last one closed. */
TEST(a_mouse_that_lies_there)
{
    struct bed *b = *state;

    open_list(b, "    ");
    point(b, 1, 0, 0);
    point(b, 2, 0, 0);
    assert_int_equal(chosen(b), 2);
    screens_close_all(&b->s);
    lay(&b->l, "    ");
    screens_open(&b->s, &all, &b->l);
    show(b);
    for (int i = 0; i < 4; i++)
        point(b, 3, 0, 0);
    assert_int_equal(chosen(b), 0);
    point(b, 1, 0, 0);
    assert_int_equal(chosen(b), 1);
    poll(b, &(struct plat_input){ .mouse_x = -1, .mouse_y = -1 }, 0); /* the window goes, and comes back under it */
    point(b, 3, 0, 0);
    assert_int_equal(chosen(b), 1);
    point(b, 2, 0, 0);
    assert_int_equal(chosen(b), 2);
}

/* A value that is changed may give the window another size: then the mouse lies elsewhere, and nobody moved it. */
TEST(a_window_that_moves_under_the_mouse)
{
    struct bed *b = *state;

    open_list(b, "= =  ");
    for (int way = 0; way < 2; way++) {
        point(b, 3, 0, 0);
        point(b, 0, 0, 0);
        assert_int_equal(chosen(b), 0);
        if (way == 0) {
            struct plat_input in = holding(RIGHT);
            in.mouse_x = b->s.list.x + 20;
            in.mouse_y = b->s.list.y + screen_row_height() / 2;
            poll(b, &in, 0);
        } else {
            point(b, 0, 1, 0);
        }
        assert_int_equal(b->l.value[0], way + 1);
        point(b, 3, 0, 0);
        assert_int_equal(chosen(b), 0);
        for (int i = 0; i < 60; i++)
            point(b, 3, 0, 0);
        assert_int_equal(chosen(b), 0);
        point(b, 1, 0, 0); /* a hand that moves it later does choose */
        assert_int_equal(chosen(b), 1);
    }
}

/* ---- questions, listening, sayings ---- */

static int asked;

static void then(void *context)
{
    assert_string_equal(context, "of");
    asked++;
}

TEST(a_question)
{
    struct bed *b = *state;
    char context[] = "of";

    asked = 0;
    open_list(b, " ");
    screens_ask(&b->s, "Lose it?", "lose it", then, context);
    rest(b);
    assert_int_equal(chosen(b), 0);
    tap(b, ENTER); /* no comes first */
    assert_int_equal(b->s.depth, 1);
    screens_ask(&b->s, "Lose it?", "lose it", then, context);
    rest(b);
    tap(b, DOWN);
    tap(b, ESCAPE);
    assert_int_equal(b->s.depth, 1);
    assert_int_equal(asked, 0);
    screens_ask(&b->s, "Lose it?", "lose it", then, context);
    rest(b);
    tap(b, DOWN);
    tap(b, ENTER);
    assert_int_equal(b->s.depth, 1);
    assert_int_equal(asked, 1);
    assert_int_equal(b->l.accepted, -1);
}

TEST(who_listens_has_all_switches)
{
    struct bed *b = *state;
    const struct plat_input enter = holding(ENTER), escape = holding(ESCAPE);
    const struct keys_state none = { 0 };

    open_list(b, "  ");
    b->l.listens = true;
    assert_true(screens_poll(&b->s, &escape, &none));
    assert_true(screens_poll(&b->s, &enter, &none));
    tap_pad(b, PAD_DOWN);
    assert_int_equal(b->l.listened, 4);
    assert_true(screens_are_open(&b->s));
    b->l.listens = false;
    assert_false(screens_poll(&b->s, &enter, &none)); /* it was pressed while it listened */
    assert_int_equal(b->l.accepted, -1);
    rest(b);
    tap(b, ENTER);
    assert_int_equal(b->l.accepted, 0);
}

static uint32_t ink(const struct bed *b)
{
    uint32_t n = 0;

    for (int y = 0; y < b->h; y++)
        for (int x = 0; x < b->w; x++)
            n = n * 31 + b->fb.pix[y * b->fb.pitch + x];
    return n;
}

TEST(what_is_said_goes_again)
{
    struct bed *b = *state;

    open_list(b, " ");
    const uint32_t before = ink(b);
    screens_show_message(&b->s, "%d settings are not kept", 3);
    show(b);
    assert_int_not_equal(ink(b), before);
    for (int i = 0; i < 239; i++)
        rest(b);
    assert_int_not_equal(ink(b), before);
    rest(b);
    assert_int_equal(ink(b), before);
}

/* What is said of a row is not read below another one. */
TEST(what_is_said_is_of_one_row)
{
    struct bed *b = *state;

    open_list(b, "  ");
    tap(b, DOWN);
    const uint32_t second = ink(b);
    tap(b, UP);
    screens_show_message(&b->s, "%s", "of the first");
    tap(b, DOWN);
    assert_int_equal(ink(b), second);
}

/* ---- any list in any picture ---- */

TEST(a_list_that_becomes_shorter)
{
    struct bed *b = *state;

    open_list(b, "    ");
    tap(b, UP);
    assert_int_equal(chosen(b), 3);
    for (int i = 0; i < 6; i++)
        tap(b, DELETE);
    assert_int_equal(b->l.n, 0);
    tap(b, ENTER);
    tap(b, DOWN);
    assert_int_equal(b->l.accepted, -1);
    tap(b, ESCAPE);
    assert_int_equal(b->l.closed, 1);
    open_list(b, "   ");
    tap(b, UP);
    b->l.n = 1; /* by itself */
    show(b);
    rest(b);
    assert_int_equal(chosen(b), 0);
    open_list(b, "  ");
    b->l.kind[0] = '#';
    rest(b);
    assert_int_equal(chosen(b), 1);
}

TEST(whatever_happens)
{
    static const struct screen_def *const defs[] = { &all, &bare, &full, &window };
    static const int sizes[][2] = { { 240, 320 }, { 320, 240 }, { 384, 448 }, { 160, 144 }, { 64, 64 }, { 16, 16 } };
    struct bed *b = *state;
    struct rng r;

    rng_seed(&r, 7);
    for (int round = 0; round < 300; round++) {
        const int *size = sizes[rng_below(&r, 6)];
        resize(b, size[0], size[1]);
        screens_close_all(&b->s);
        lay(&b->l, "");
        for (b->l.n = 0; b->l.n < (int)rng_below(&r, MOST); b->l.n++)
            b->l.kind[b->l.n] = " ==#-"[rng_below(&r, 5)];
        screens_open(&b->s, defs[rng_below(&r, 4)], &b->l);
        for (int frame = 0; frame < 60; frame++) {
            struct plat_input in = holding((int)(75 + rng_below(&r, 8)));
            in.controllers[0] = rng_below(&r, 4) == 0 ? 1u << rng_below(&r, PLAT_BUTTONS) : 0;
            in.mouse_x = (int)rng_below(&r, 400) - 8;
            in.mouse_y = (int)rng_below(&r, 460) - 8;
            in.mouse_buttons = rng_below(&r, 4) == 0;
            in.wheel = (int)rng_below(&r, 3) - 1;
            poll(b, &in, rng_below(&r, 8) == 0 ? (uint16_t)(1u << rng_below(&r, 16)) : 0);
            if (rng_below(&r, 6) == 0 && b->l.n > 0)
                b->l.kind[rng_below(&r, (uint64_t)b->l.n)] = " =#"[rng_below(&r, 3)];
            if (rng_below(&r, 9) == 0)
                b->l.n = (int)rng_below(&r, (uint64_t)b->l.n + 1);
            show(b);
        }
    }
}

RUN_TESTS_EACH(bed_open, bed_close)
