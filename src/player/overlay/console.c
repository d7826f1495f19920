/*
 * console.c - see console.h.
 */
#include "console.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../script/api/eval.h"

enum { REPEAT_AFTER = 24, REPEAT_EVERY = 3 /* polls */ };

static const char keep[] = "keep ";

/* ---- output ---- */

static void print_bytes(struct console *c, enum canvas_colour colour, const char *text, size_t n)
{
    struct console_output *s = &c->output[c->outputs++ % CONSOLE_OUTPUT];
    s->colour = colour;
    snprintf(s->text, sizeof s->text, "%.*s", (int)n, text);
}

/* Text of any length, with \n in it or not. */
static void print(struct console *c, enum canvas_colour colour, const char *text)
{
    while (*text) {
        size_t n = strcspn(text, "\n"), part = n < CONSOLE_TEXT - 1 ? n : CONSOLE_TEXT - 1;
        print_bytes(c, colour, text, part);
        text += part;
        text += part == n && *text == '\n';
    }
}

static void print_format(struct console *c, enum canvas_colour colour, const char *format, const char *what)
{
    char text[EVAL_TEXT_SIZE + 64];
    snprintf(text, sizeof text, format, what);
    print(c, colour, text);
}

/* ---- running a line ---- */

static bool save(struct console *c, const struct board *b)
{
    size_t size = board_snapshot_size(b);
    if (size > c->room) {
        free(c->snapshot);
        c->snapshot = malloc(size);
        c->room = c->snapshot ? size : 0;
    }
    if (c->snapshot)
        board_save(b, c->snapshot);
    return c->snapshot != 0;
}

static void run(struct console *c, struct board *b, bool keeps)
{
    char out[EVAL_TEXT_SIZE];
    bool kept = strncmp(c->line, keep, sizeof keep - 1) == 0;
    print_format(c, CANVAS_YELLOW, "> %s", c->line);
    if (kept && !keeps) {
        print(c, CANVAS_RED, "`keep` is unavailable while a demo plays");
        return;
    }
    if (!save(c, b)) {
        print(c, CANVAS_RED, "out of memory: changes could not be undone");
        return;
    }
    bool good = board_eval(b, c->line + (kept ? sizeof keep - 1 : 0), out, sizeof out);
    if (!good || !kept)
        board_restore(b, c->snapshot);
    print(c, good ? CANVAS_WHITE : CANVAS_RED, out);
    if (good && kept)
        print(c, CANVAS_GREY, "changes kept; the run is marked as \"touched\", and its scores are not saved");
    c->kept = c->kept || (good && kept);
}

/* ---- the line ---- */

static void set_line(struct console *c, const char *text)
{
    snprintf(c->line, sizeof c->line, "%s", text);
    c->length = c->at = (int)strlen(c->line);
}

static void insert(struct console *c, char byte)
{
    if (byte < ' ' || byte > '~' || c->length == CONSOLE_LINE - 1)
        return;
    memmove(c->line + c->at + 1, c->line + c->at, (size_t)(c->length - c->at + 1));
    c->line[c->at++] = byte;
    c->length++;
}

static void erase(struct console *c, int at)
{
    if (at < 0 || at >= c->length)
        return;
    memmove(c->line + at, c->line + at + 1, (size_t)(c->length - at));
    c->length--;
    c->at = at;
}

/* by 1: one line further back; -1: forward. */
static void recall(struct console *c, int by)
{
    int most = c->lines < CONSOLE_HISTORY ? c->lines : CONSOLE_HISTORY, to = c->back + by;
    if (to < 0 || to > most)
        return;
    c->back = to;
    set_line(c, to ? c->history[(c->lines - to) % CONSOLE_HISTORY] : "");
}

static void enter(struct console *c, struct board *b, bool keeps)
{
    if (!c->length)
        return;
    run(c, b, keeps);
    if (!c->lines || strcmp(c->history[(c->lines - 1) % CONSOLE_HISTORY], c->line) != 0)
        memcpy(c->history[c->lines++ % CONSOLE_HISTORY], c->line, sizeof c->line);
    c->back = 0;
    set_line(c, "");
}

static void press(struct console *c, unsigned key, struct board *b, bool keeps)
{
    switch (key) {
    case KEY_ENTER:
    case KEY_KEYPAD_ENTER:
        enter(c, b, keeps);
        break;
    case KEY_ESCAPE:
        c->open = false;
        break;
    case KEY_BACKSPACE:
        erase(c, c->at - 1);
        break;
    case KEY_DELETE:
        erase(c, c->at);
        break;
    case KEY_HOME:
        c->at = 0;
        break;
    case KEY_END:
        c->at = c->length;
        break;
    case KEY_LEFT:
        c->at -= c->at > 0;
        break;
    case KEY_RIGHT:
        c->at += c->at < c->length;
        break;
    case KEY_UP:
        recall(c, 1);
        break;
    case KEY_DOWN:
        recall(c, -1);
        break;
    }
}

/* ---- polls ---- */

static bool was_held(const struct console *c, unsigned key)
{
    return c->held[key >> 3] >> (key & 7) & 1;
}

static bool can_repeat(unsigned key)
{
    return key == KEY_BACKSPACE || key == KEY_DELETE || (key >= KEY_RIGHT && key <= KEY_UP);
}

/* A key that was not held at the last poll is pressed; some are again and again. */
static void read_keys(struct console *c, const struct plat_input *in, struct board *b, bool keeps)
{
    static const uint8_t keys[] = { KEY_ENTER, KEY_ESCAPE, KEY_BACKSPACE, KEY_HOME, KEY_DELETE,      KEY_END,
                                    KEY_RIGHT, KEY_LEFT,   KEY_DOWN,      KEY_UP,   KEY_KEYPAD_ENTER };
    if (!plat_is_key_held(in, c->repeats))
        c->repeats = 0;
    for (size_t i = 0; i < sizeof keys && c->open; i++) {
        if (!plat_is_key_held(in, keys[i]))
            continue;
        if (!was_held(c, keys[i])) {
            press(c, keys[i], b, keeps);
            c->repeats = can_repeat(keys[i]) ? keys[i] : 0;
            c->polls = 0;
        } else if (c->repeats == keys[i] && ++c->polls >= REPEAT_AFTER && c->polls % REPEAT_EVERY == 0)
            press(c, keys[i], b, keeps);
    }
}

static void open_console(struct console *c)
{
    c->open = true;
    c->repeats = 0;
    if (!c->outputs)
        print(c, CANVAS_GREY,
              "Enter a line of Lua. Its changes are undone afterwards,\nexcept with `keep LINE`. Up: history. Escape: "
              "close.");
}

/* The key that opens and closes it has a letter too: what comes while it is held is not typed. */
void console_poll(struct console *c, const struct plat_input *in, struct keys_read *k, struct board *b, bool keeps)
{
    const uint32_t key = (uint32_t)1 << HOTKEY_CONSOLE;
    bool was = c->open;
    if (!b || (k->pressed & key && was))
        c->open = false;
    else if (k->pressed & key)
        open_console(c);
    for (int i = 0; was && c->open && !(k->held & key) && in->text[i]; i++)
        insert(c, in->text[i]);
    if (was && c->open)
        read_keys(c, in, b, keeps);
    memcpy(c->held, in->keys, sizeof c->held);
    if (was || c->open)
        memset(k, 0, sizeof *k);
}

bool console_kept(struct console *c)
{
    bool kept = c->kept;
    c->kept = false;
    return kept;
}

/* ---- picture ---- */

static int rows_of(const char *text, int columns)
{
    int rows = 0;
    do {
        text += canvas_fit(text, columns);
        rows++;
    } while (*text);
    return rows;
}

/* From the newest upwards, as far as there is room. */
static void draw_output(const struct console *c, const struct canvas *canvas, int y0, int y1, int columns)
{
    int oldest = c->outputs > CONSOLE_OUTPUT ? c->outputs - CONSOLE_OUTPUT : 0, y = y1;
    for (int i = c->outputs - 1; i >= oldest && y > y0; i--) {
        const struct console_output *s = &c->output[i % CONSOLE_OUTPUT];
        const char *text = s->text;
        int row = y -= rows_of(text, columns) * CANVAS_CELL_H;
        for (int n; *text; text += n, row += CANVAS_CELL_H) {
            n = canvas_fit(text, columns);
            if (row >= y0)
                canvas_bytes(canvas, 2, row, s->colour, text, n);
        }
    }
}

/* A line longer than the picture is wide is shown round the cursor. */
static void draw_line(const struct console *c, const struct canvas *canvas, int y, int columns)
{
    int first = c->at < columns - 2 ? 0 : c->at - columns + 3;
    int x = canvas_text(canvas, 2, y, CANVAS_YELLOW, "> ");
    canvas_bytes(canvas, x, y, CANVAS_WHITE, c->line + first, columns - 2);
    canvas_rect(canvas, x + (c->at - first) * CANVAS_CELL_W, y + CANVAS_CELL_H - 1, CANVAS_CELL_W - 1, 1,
                CANVAS_YELLOW);
}

int console_draw(const struct console *c, const struct canvas *canvas)
{
    int w = canvas->fb->w, h = canvas->fb->h, columns = (w - 3) / CANVAS_CELL_W;
    int rows = h / 2 / CANVAS_CELL_H, y0 = h - rows * CANVAS_CELL_H - 3, line = h - CANVAS_CELL_H - 1;
    if (!c->open)
        return h;
    canvas_rect(canvas, 0, y0, w, h - y0, CANVAS_DARK);
    canvas_rect(canvas, 0, y0, w, 1, CANVAS_GREY);
    draw_output(c, canvas, y0 + 2, line, columns);
    draw_line(c, canvas, line, columns);
    return y0;
}

void console_close(struct console *c)
{
    free(c->snapshot);
    *c = (struct console){ 0 };
}
