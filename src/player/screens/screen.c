/*
 * screen.c - see screen.h: the stack, and the effect of each input. screen_draw.c draws the screens.
 */
#include "screen.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum {
    UP = 1 << 0,
    DOWN = 1 << 1,
    LEFT = 1 << 2,
    RIGHT = 1 << 3,
    PAGE_UP = 1 << 4,
    PAGE_DOWN = 1 << 5,
    YES = 1 << 6,
    NO = 1 << 7,
    REMOVE = 1 << 8,
    TEN = 1 << 9,
    REPEATS = UP | DOWN | LEFT | RIGHT | PAGE_UP | PAGE_DOWN
};

enum {
    REPEAT_DELAY = 20, /* frames until a held arrow repeats, and between repeats */
    REPEAT_EVERY = 3,
    SAID = 240,    /* frames for which a line is shown */
    SETTLE = 30,   /* frames after a change in which the window may move under the mouse */
    NO_MOUSE = 255 /* instead of its buttons: its position and buttons were meant for another screen */
};

/* ---- the stack ---- */

static struct screen_place *top_of(struct screens *s)
{
    return &s->place[s->deep - 1];
}

static int rows_of(const struct screen_place *p)
{
    return p->screen->rows(p->of);
}

static bool is_heading(const struct screen_place *p, int at)
{
    return screen_place_row(p, at).heading;
}

/* The next row that can be chosen, with wrap-around; `at` if there is no other. */
static int step(const struct screen_place *p, int at, int by)
{
    const int n = rows_of(p);
    int to = at;

    for (int i = 0; i < n; i++) {
        to = (to + by + n) % n;
        if (!is_heading(p, to))
            return to;
    }
    return at;
}

/* Rows may have been removed, or the chosen one may have become a heading. */
static void settle(struct screen_place *p)
{
    const int n = rows_of(p);

    if (p->row >= n)
        p->row = n - 1;
    if (p->row < 0)
        p->row = 0;
    if (n > 0 && is_heading(p, p->row))
        p->row = step(p, p->row, 1);
}

const struct screen_def *screens_top(const struct screens *s)
{
    return s->deep > 0 ? s->place[s->deep - 1].screen : NULL;
}

bool screens_have(const struct screens *s, const struct screen_def *screen)
{
    for (int i = 0; i < s->deep; i++)
        if (s->place[i].screen == screen)
            return true;
    return false;
}

void screens_open(struct screens *s, const struct screen_def *screen, void *of)
{
    if (s->deep == SCREENS_DEEP)
        return;
    s->place[s->deep++] = (struct screen_place){ .screen = screen, .of = of };
    settle(top_of(s));
    s->held = UINT32_MAX; /* keys held now were pressed for something else */
    s->held_for = 0;
    s->mouse = NO_MOUSE;
    s->said_for = 0;
}

void screens_close(struct screens *s)
{
    if (s->deep == 0)
        return;
    const struct screen_place p = *top_of(s);
    s->deep--;
    s->said_for = 0;
    if (p.screen->closed)
        p.screen->closed(p.of);
}

void screens_close_all(struct screens *s)
{
    while (s->deep > 0)
        screens_close(s);
}

void screens_settle(struct screens *s)
{
    if (s->deep > 0)
        settle(top_of(s));
}

void screens_choose(struct screens *s, int row)
{
    if (s->deep == 0)
        return;
    struct screen_place *p = top_of(s);
    if (row >= 0 && row < rows_of(p) && !is_heading(p, row))
        p->row = row;
}

void screens_say(struct screens *s, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    vsnprintf(s->said, sizeof s->said, format, args);
    va_end(args);
    s->said_for = SAID;
}

void screen_sentence(char *out, size_t size, const char *phrase)
{
    snprintf(out, size, "%s.", phrase);
    if (out[0] >= 'a' && out[0] <= 'z')
        out[0] = (char)(out[0] - 'a' + 'A');
}

/* ---- questions ---- */

enum { ASK_NO, ASK_YES, ASK_ROWS };

static const char *ask_text(void *of)
{
    return ((const struct screens *)of)->asked.question;
}

static int ask_rows(void *of)
{
    (void)of;
    return ASK_ROWS;
}

static void ask_row(void *of, int at, struct screen_row *row)
{
    const struct screens *s = of;

    snprintf(row->label, sizeof row->label, "%s", at == ASK_NO ? "Cancel" : s->asked.yes);
}

static void ask_accept(void *of, int at)
{
    struct screens *s = of;

    screens_close(s);
    if (at == ASK_YES)
        s->asked.then(s->asked.of);
}

static const struct screen_def ask = {
    .title = "Confirm", .small = true, .text = ask_text, .rows = ask_rows, .row = ask_row, .accept = ask_accept
};

void screens_ask(struct screens *s, const char *question, const char *yes, void (*then)(void *of), void *of)
{
    snprintf(s->asked.question, sizeof s->asked.question, "%s", question);
    snprintf(s->asked.yes, sizeof s->asked.yes, "%s", yes);
    s->asked.then = then;
    s->asked.of = of;
    screens_open(s, &ask, s);
}

/* ---- input ---- */

static uint32_t keyboard_input(const struct plat_input *in)
{
    static const struct {
        uint8_t usage;
        uint16_t does;
    } keys[] = {
        { 82, UP },  { 81, DOWN }, { 80, LEFT }, { 79, RIGHT },  { 75, PAGE_UP }, { 78, PAGE_DOWN }, { 40, YES },
        { 88, YES }, { 41, NO },   { 42, NO },   { 76, REMOVE }, { 225, TEN },    { 229, TEN },
    };
    uint32_t held = 0;

    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        held |= plat_is_key_held(in, keys[i].usage) ? keys[i].does : 0;
    return held;
}

static uint32_t controller_input(const struct plat_input *in)
{
    static const uint16_t does[PLAT_BUTTONS] = {
        [PLAT_DPAD_UP] = UP,
        [PLAT_DPAD_DOWN] = DOWN,
        [PLAT_DPAD_LEFT] = LEFT,
        [PLAT_DPAD_RIGHT] = RIGHT,
        [PLAT_LEFT_STICK_UP] = UP,
        [PLAT_LEFT_STICK_DOWN] = DOWN,
        [PLAT_LEFT_STICK_LEFT] = LEFT,
        [PLAT_LEFT_STICK_RIGHT] = RIGHT,
        [PLAT_SOUTH] = YES,
        [PLAT_EAST] = NO,
        [PLAT_START] = YES,
        [PLAT_GUIDE] = NO,
        [PLAT_NORTH] = REMOVE,
        [PLAT_SHOULDER_LEFT] = PAGE_UP,
        [PLAT_SHOULDER_RIGHT] = PAGE_DOWN,
    };
    uint32_t held = 0;

    for (int c = 0; c < PLAT_MAX_CONTROLLERS; c++)
        for (int i = 0; i < PLAT_BUTTONS; i++)
            held |= in->controllers[c] >> i & 1 ? does[i] : 0;
    return held;
}

static uint32_t pad_input(const struct keys_state *k)
{
    static const struct {
        uint16_t button, does;
    } buttons[] = {
        { PAD_UP, UP },     { PAD_DOWN, DOWN }, { PAD_LEFT, LEFT },      { PAD_RIGHT, RIGHT }, { PAD_FIRE, YES },
        { PAD_START, YES }, { PAD_BOMB, NO },   { PAD_SPECIAL, REMOVE }, { PAD_FOCUS, TEN },
    };
    uint32_t held = 0;

    for (int p = 0; p < MAX_PLAYERS; p++)
        for (size_t i = 0; i < sizeof buttons / sizeof *buttons; i++)
            held |= k->pads[p] & buttons[i].button ? buttons[i].does : 0;
    return held;
}

/* If a player has assigned yes or no to other buttons of a controller, south and east have the assigned meaning. */
static uint32_t button_input(const struct plat_input *in, const struct keys_state *k)
{
    const uint32_t pads = pad_input(k), controllers = controller_input(in);

    return pads | (pads & (YES | NO) ? controllers & ~(uint32_t)(YES | NO) : controllers);
}

/* Inputs that were just pressed, and repeats of held arrows that were pressed here. */
static uint32_t pressed(struct screens *s, uint32_t held)
{
    uint32_t fresh = held & ~s->held;

    if (fresh & REPEATS)
        s->held_for = 1;
    else
        s->held_for = held & REPEATS && s->held_for > 0 ? s->held_for + 1 : 0;
    s->held = held;
    if (s->held_for > REPEAT_DELAY && (s->held_for - REPEAT_DELAY - 1) % REPEAT_EVERY == 0)
        fresh |= held & REPEATS;
    return fresh;
}

/* ---- the mouse ---- */

static int row_under(const struct screens *s, const struct screen_place *p, int x, int y)
{
    const struct screen_area *l = &s->list;
    const int at = p->top + (y - l->y) / screen_row_height();

    if (x < l->x || x >= l->x + l->w || y < l->y || at >= p->top + s->shown || at >= rows_of(p))
        return -1;
    return at;
}

/* Moving the mouse chooses the row under it, but a window that moves or appears under a resting mouse doesn't. The left
 * button accepts the row, the right one closes the screen. */
static uint32_t use_mouse(struct screens *s, struct screen_place *p, const struct plat_input *in)
{
    const uint8_t fresh = (uint8_t)(in->mouse_buttons & ~s->mouse);
    const bool moved = s->mouse != NO_MOUSE && s->settle == 0 && s->mouse_x >= 0 &&
                       (in->mouse_x != s->mouse_x || in->mouse_y != s->mouse_y);
    const int at = in->mouse_x >= 0 ? row_under(s, p, in->mouse_x, in->mouse_y) : -1;

    s->mouse = in->mouse_buttons;
    s->mouse_x = in->mouse_x;
    s->mouse_y = in->mouse_y;
    if (at >= 0 && (moved || fresh))
        screens_choose(s, at);
    if (fresh & 2)
        return NO;
    if (in->wheel)
        return in->wheel > 0 ? UP : DOWN;
    return fresh & 1 && at == p->row ? YES : 0;
}

/* ---- the frame ---- */

static void change(struct screens *s, const struct screen_place *p, int by)
{
    s->settle = SETTLE;
    p->screen->change(p->of, p->row, by);
}

static bool changes(const struct screen_place *p)
{
    return p->screen->change && screen_place_row(p, p->row).changes;
}

static void accept(struct screens *s, const struct screen_place *p)
{
    const struct screen_row row = screen_place_row(p, p->row);

    if (row.faint || row.heading)
        return;
    if (changes(p))
        change(s, p, 1);
    else if (p->screen->accept)
        p->screen->accept(p->of, p->row);
}

/* Moves by a page of rows, at most to the end of the list. */
static void move_page(struct screens *s, struct screen_place *p, int by)
{
    const int n = rows_of(p), far = s->shown > 1 ? s->shown - 1 : 1;

    for (int i = 0; i < far; i++) {
        const int to = step(p, p->row, by);
        if (by > 0 ? to < p->row : to > p->row)
            return;
        p->row = to < n ? to : p->row;
    }
}

bool screens_poll(struct screens *s, const struct plat_input *in, const struct keys_state *k)
{
    if (s->deep == 0)
        return false;
    struct screen_place *p = top_of(s);
    const uint32_t held = keyboard_input(in) | button_input(in, k);

    s->said_for -= s->said_for > 0;
    s->settle -= s->settle > 0;
    if (p->screen->listen && p->screen->listen(p->of, in)) {
        s->held = UINT32_MAX;
        s->mouse = NO_MOUSE;
        return true;
    }
    settle(p);
    const int chosen = p->row;
    const uint32_t fresh = pressed(s, held) | use_mouse(s, p, in);
    if (rows_of(p) > 0) {
        if (fresh & UP)
            p->row = step(p, p->row, -1);
        if (fresh & DOWN)
            p->row = step(p, p->row, 1);
        if (fresh & (PAGE_UP | PAGE_DOWN))
            move_page(s, p, fresh & PAGE_UP ? -1 : 1);
        if (fresh & (LEFT | RIGHT) && changes(p))
            change(s, p, (fresh & LEFT ? -1 : 1) * (held & TEN ? 10 : 1));
    }
    if (p->row != chosen) /* it was about the other row, or has been read */
        s->said_for = 0;
    if (fresh & NO) /* yes and no together mean no */
        screens_close(s);
    else if (fresh & REMOVE && p->screen->remove && rows_of(p) > 0)
        p->screen->remove(p->of, p->row);
    else if (fresh & YES && rows_of(p) > 0)
        accept(s, p);
    return false;
}
