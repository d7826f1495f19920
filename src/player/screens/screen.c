/*
 * screen.c - the stack of screens, and the effect of each input (screen.h). screen_draw.c draws the screens.
 */
#include "screen.h"

#include <stdio.h>
#include <string.h>

enum {
    UP = 1 << 0,
    DOWN = 1 << 1,
    LEFT = 1 << 2,
    RIGHT = 1 << 3,
    PAGE_UP = 1 << 4,
    PAGE_DOWN = 1 << 5,
    ACCEPT = 1 << 6,
    BACK = 1 << 7,
    REMOVE = 1 << 8,
    TEN_STEPS = 1 << 9,
    REPEATS = UP | DOWN | LEFT | RIGHT | PAGE_UP | PAGE_DOWN
};

enum {
    REPEAT_DELAY = 20, /* frames until a held arrow repeats, and between repeats */
    REPEAT_EVERY = 3,
    MESSAGE_FRAMES = 240,
    SETTLE_FRAMES = 30, /* after a change, because the window may move under the mouse */
    NO_MOUSE = 255      /* instead of mouse buttons: position and buttons were meant for another screen */
};

/* ---- the stack ---- */

static struct screen_place *top_place(struct screens *s)
{
    return &s->place[s->depth - 1];
}

static int row_count(const struct screen_place *p)
{
    return p->screen->rows(p->context);
}

static bool is_heading(const struct screen_place *p, int at)
{
    return screen_place_row(p, at).heading;
}

/* Returns the next row that can be chosen, with wrap-around, or `at` if there is no other. */
static int step(const struct screen_place *p, int at, int by)
{
    const int n = row_count(p);
    int to = at;

    for (int i = 0; i < n; i++) {
        to = (to + by + n) % n;
        if (!is_heading(p, to))
            return to;
    }
    return at;
}

/* Chooses another row if the chosen one was removed or became a heading. */
static void settle(struct screen_place *p)
{
    const int n = row_count(p);

    if (p->row >= n)
        p->row = n - 1;
    if (p->row < 0)
        p->row = 0;
    if (n > 0 && is_heading(p, p->row))
        p->row = step(p, p->row, 1);
}

const struct screen_def *screens_top(const struct screens *s)
{
    return s->depth > 0 ? s->place[s->depth - 1].screen : NULL;
}

bool screens_contain(const struct screens *s, const struct screen_def *screen)
{
    for (int i = 0; i < s->depth; i++)
        if (s->place[i].screen == screen)
            return true;
    return false;
}

void screens_open(struct screens *s, const struct screen_def *screen, void *context)
{
    if (s->depth == SCREENS_MAX_DEPTH)
        return;
    s->place[s->depth++] = (struct screen_place){ .screen = screen, .context = context, .words = &s->words };
    settle(top_place(s));
    s->sounded[THEME_OPEN] = s->sounded[THEME_OPEN] || s->depth == 1;
    s->held = UINT32_MAX; /* keys held now were pressed for something else */
    s->held_for = 0;
    s->mouse = NO_MOUSE;
    s->listened = false;
    s->message_frames = 0;
}

void screens_close(struct screens *s)
{
    if (s->depth == 0)
        return;
    const struct screen_place p = *top_place(s);
    s->depth--;
    s->message_frames = 0;
    if (p.screen->closed)
        p.screen->closed(p.context);
}

void screens_close_all(struct screens *s)
{
    while (s->depth > 0)
        screens_close(s);
}

void screens_settle(struct screens *s)
{
    if (s->depth > 0)
        settle(top_place(s));
}

void screens_choose(struct screens *s, int row)
{
    if (s->depth == 0)
        return;
    struct screen_place *p = top_place(s);
    if (row >= 0 && row < row_count(p) && !is_heading(p, row))
        p->row = row;
}

void screens_show_message(struct screens *s, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    screens_format_list(s, s->message, sizeof s->message, format, args);
    va_end(args);
    s->message_frames = MESSAGE_FRAMES;
}

void screen_sentence(char *out, size_t size, const char *phrase)
{
    snprintf(out, size, "%s.", phrase);
    if (out[0] >= 'a' && out[0] <= 'z')
        out[0] = (char)(out[0] - 'a' + 'A');
}

/* ---- questions ---- */

enum { CONFIRM_CANCEL, CONFIRM_ACCEPT, CONFIRM_ROWS };

static const char *confirm_text(void *context)
{
    return ((const struct screens *)context)->confirm.question;
}

static int confirm_rows(void *context)
{
    (void)context;
    return CONFIRM_ROWS;
}

static void confirm_row(void *context, int at, struct screen_row *row)
{
    const struct screens *s = context;

    snprintf(row->label, sizeof row->label, "%s", at == CONFIRM_CANCEL ? "Cancel" : s->confirm.yes);
}

static void confirm_accept(void *context, int at)
{
    struct screens *s = context;

    screens_close(s);
    if (at == CONFIRM_ACCEPT)
        s->confirm.then(s->confirm.context);
}

static const struct screen_def confirm_screen = { .title = "Confirm",
                                                  .small = true,
                                                  .text = confirm_text,
                                                  .rows = confirm_rows,
                                                  .row = confirm_row,
                                                  .accept = confirm_accept };

void screens_ask(struct screens *s, const char *question, const char *yes, void (*then)(void *context), void *context)
{
    snprintf(s->confirm.question, sizeof s->confirm.question, "%s", question);
    snprintf(s->confirm.yes, sizeof s->confirm.yes, "%s", yes);
    s->confirm.then = then;
    s->confirm.context = context;
    screens_open(s, &confirm_screen, s);
}

/* ---- input ---- */

static uint32_t keyboard_input(const struct plat_input *in)
{
    static const struct {
        uint8_t usage;
        uint16_t input;
    } keys[] = {
        { 82, UP },        { 81, DOWN },       { 80, LEFT },       { 79, RIGHT }, { 75, PAGE_UP },
        { 78, PAGE_DOWN }, { 40, ACCEPT },     { 88, ACCEPT },     { 41, BACK },  { 42, BACK },
        { 76, REMOVE },    { 225, TEN_STEPS }, { 229, TEN_STEPS },
    };
    uint32_t held = 0;

    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        held |= plat_is_key_held(in, keys[i].usage) ? keys[i].input : 0;
    return held;
}

static uint32_t controller_input(const struct plat_input *in)
{
    static const uint16_t input[PLAT_BUTTONS] = {
        [PLAT_DPAD_UP] = UP,
        [PLAT_DPAD_DOWN] = DOWN,
        [PLAT_DPAD_LEFT] = LEFT,
        [PLAT_DPAD_RIGHT] = RIGHT,
        [PLAT_LEFT_STICK_UP] = UP,
        [PLAT_LEFT_STICK_DOWN] = DOWN,
        [PLAT_LEFT_STICK_LEFT] = LEFT,
        [PLAT_LEFT_STICK_RIGHT] = RIGHT,
        [PLAT_SOUTH] = ACCEPT,
        [PLAT_EAST] = BACK,
        [PLAT_START] = ACCEPT,
        [PLAT_GUIDE] = BACK,
        [PLAT_NORTH] = REMOVE,
        [PLAT_SHOULDER_LEFT] = PAGE_UP,
        [PLAT_SHOULDER_RIGHT] = PAGE_DOWN,
    };
    uint32_t held = 0;

    for (int c = 0; c < PLAT_MAX_CONTROLLERS; c++)
        for (int i = 0; i < PLAT_BUTTONS; i++)
            held |= in->controllers[c] >> i & 1 ? input[i] : 0;
    return held;
}

static uint32_t pad_input(const struct keys_state *k)
{
    static const struct {
        uint16_t button, input;
    } buttons[] = {
        { PAD_UP, UP },       { PAD_DOWN, DOWN },      { PAD_LEFT, LEFT },
        { PAD_RIGHT, RIGHT }, { PAD_FIRE, ACCEPT },    { PAD_START, ACCEPT },
        { PAD_BOMB, BACK },   { PAD_SPECIAL, REMOVE }, { PAD_FOCUS, TEN_STEPS },
    };
    uint32_t held = 0;

    for (int p = 0; p < MAX_PLAYERS; p++)
        for (size_t i = 0; i < sizeof buttons / sizeof *buttons; i++)
            held |= k->pads[p] & buttons[i].button ? buttons[i].input : 0;
    return held;
}

/* If players have bound accept or back to other buttons of a controller, south and east have their bound meaning. */
static uint32_t button_input(const struct plat_input *in, const struct keys_state *k)
{
    const uint32_t pads = pad_input(k), controllers = controller_input(in);

    return pads | (pads & (ACCEPT | BACK) ? controllers & ~(uint32_t)(ACCEPT | BACK) : controllers);
}

/* Returns inputs that were just pressed, and repeats of held arrows that were pressed on this screen. */
static uint32_t find_presses(struct screens *s, uint32_t held)
{
    uint32_t newly_pressed = held & ~s->held;

    if (newly_pressed & REPEATS)
        s->held_for = 1;
    else
        s->held_for = held & REPEATS && s->held_for > 0 ? s->held_for + 1 : 0;
    s->held = held;
    if (s->held_for > REPEAT_DELAY && (s->held_for - REPEAT_DELAY - 1) % REPEAT_EVERY == 0)
        newly_pressed |= held & REPEATS;
    return newly_pressed;
}

/* ---- the mouse ---- */

static int row_under(const struct screens *s, const struct screen_place *p, int x, int y)
{
    const struct screen_area *l = &s->list;
    const int at = s->row_height ? p->top + (y - l->y) / s->row_height : -1;

    if (at < 0 || x < l->x || x >= l->x + l->w || y < l->y || at >= p->top + s->shown || at >= row_count(p))
        return -1;
    return at;
}

/* Moving the mouse chooses the row under it, but a window that moves or appears under a resting mouse doesn't. The left
 * button accepts the row, the right one closes the screen. */
static uint32_t use_mouse(struct screens *s, struct screen_place *p, const struct plat_input *in)
{
    const uint8_t newly_pressed = (uint8_t)(in->mouse_buttons & ~s->mouse);
    const bool moved = s->mouse != NO_MOUSE && s->mouse_settle == 0 && s->mouse_x >= 0 &&
                       (in->mouse_x != s->mouse_x || in->mouse_y != s->mouse_y);
    const int at = in->mouse_x >= 0 ? row_under(s, p, in->mouse_x, in->mouse_y) : -1;

    s->mouse = in->mouse_buttons;
    s->mouse_x = in->mouse_x;
    s->mouse_y = in->mouse_y;
    if (at >= 0 && (moved || newly_pressed))
        screens_choose(s, at);
    if (newly_pressed & 2)
        return BACK;
    if (in->wheel)
        return in->wheel > 0 ? UP : DOWN;
    return newly_pressed & 1 && at == p->row ? ACCEPT : 0;
}

/* ---- the frame ---- */

static void change(struct screens *s, const struct screen_place *p, int by)
{
    s->mouse_settle = SETTLE_FRAMES;
    s->sounded[THEME_MOVE] = true;
    p->screen->change(p->context, p->row, by);
}

static bool changes(const struct screen_place *p)
{
    return p->screen->change && screen_place_row(p, p->row).changes;
}

static void accept(struct screens *s, const struct screen_place *p)
{
    const struct screen_row row = screen_place_row(p, p->row);

    if (row.disabled || row.heading)
        return;
    if (changes(p) && !row.action) {
        change(s, p, 1);
    } else if (p->screen->accept) {
        s->sounded[THEME_ACCEPT] = true;
        p->screen->accept(p->context, p->row);
    }
}

/* Moves by a page of rows, but not beyond the end of the list. */
static void move_page(struct screens *s, struct screen_place *p, int by)
{
    const int n = row_count(p), count = s->shown > 1 ? s->shown - 1 : 1;

    for (int i = 0; i < count; i++) {
        const int to = step(p, p->row, by);
        if (by > 0 ? to < p->row : to > p->row)
            return;
        p->row = to < n ? to : p->row;
    }
}

void screens_describe_button(const struct screens *s, enum screen_button button, char *out, size_t size)
{
    const struct screen_place *p = s->depth > 0 ? &s->place[s->depth - 1] : NULL;
    struct screen_row row = { .disabled = true };
    const char *meaning = "";

    if (p && row_count(p) > 0)
        row = screen_place_row(p, p->row);
    if (!p || s->listened)
        meaning = "";
    else if (button == SCREEN_BACK)
        meaning = "Back";
    else if (button == SCREEN_REMOVE && p->screen->remove && row.removable)
        meaning = p->screen->removal;
    else if (button == SCREEN_ACCEPT && !row.disabled && !row.heading)
        meaning = row.action ? row.action : changes(p) ? "Change" : p->screen->accept ? "Select" : "";
    screen_translate(&s->words, meaning, out, size);
}

bool screens_poll(struct screens *s, const struct plat_input *in, const struct keys_state *k)
{
    if (s->depth == 0)
        return false;
    struct screen_place *p = top_place(s);
    const uint32_t held = keyboard_input(in) | button_input(in, k);

    s->message_frames -= s->message_frames > 0;
    s->mouse_settle -= s->mouse_settle > 0;
    s->listened = p->screen->listen && p->screen->listen(p->context, in);
    if (s->listened) {
        s->held = UINT32_MAX;
        s->mouse = NO_MOUSE;
        return true;
    }
    settle(p);
    const int chosen = p->row;
    const uint32_t newly_pressed = find_presses(s, held) | use_mouse(s, p, in);
    if (row_count(p) > 0) {
        if (newly_pressed & UP)
            p->row = step(p, p->row, -1);
        if (newly_pressed & DOWN)
            p->row = step(p, p->row, 1);
        if (newly_pressed & (PAGE_UP | PAGE_DOWN))
            move_page(s, p, newly_pressed & PAGE_UP ? -1 : 1);
        if (newly_pressed & (LEFT | RIGHT) && changes(p))
            change(s, p, (newly_pressed & LEFT ? -1 : 1) * (held & TEN_STEPS ? 10 : 1));
    }
    if (p->row != chosen) { /* the message was about the other row, or has been read */
        s->message_frames = 0;
        s->sounded[THEME_MOVE] = true;
    }
    if (newly_pressed & BACK) { /* also if accept is pressed too */
        s->sounded[THEME_BACK] = true;
        if (p->screen->back)
            p->screen->back(p->context);
        else
            screens_close(s);
    } else if (newly_pressed & REMOVE && p->screen->remove && row_count(p) > 0 &&
               screen_place_row(p, p->row).removable) {
        p->screen->remove(p->context, p->row);
    } else if (newly_pressed & ACCEPT && row_count(p) > 0) {
        accept(s, p);
    }
    return false;
}
