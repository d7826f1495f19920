/*
 * console.c - the console's input, history and output (console.h).
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
    struct console_output *s = &c->output[c->output_count++ % CONSOLE_MAX_OUTPUT];
    s->colour = colour;
    snprintf(s->text, sizeof s->text, "%.*s", (int)n, text);
}

/* Prints text of any length and any number of lines. */
static void print(struct console *c, enum canvas_colour colour, const char *text)
{
    while (*text) {
        size_t n = strcspn(text, "\n"), part = n < CONSOLE_OUTPUT_SIZE - 1 ? n : CONSOLE_OUTPUT_SIZE - 1;
        print_bytes(c, colour, text, part);
        text += part;
        text += part == n && *text == '\n';
    }
}

/* ---- running a line ---- */

static bool save(struct console *c, const struct board *b)
{
    size_t size = board_snapshot_size(b);
    if (size > c->snapshot_capacity) {
        free(c->snapshot);
        c->snapshot = malloc(size);
        c->snapshot_capacity = c->snapshot ? size : 0;
    }
    if (c->snapshot)
        board_save(b, c->snapshot);
    return c->snapshot != 0;
}

static void run(struct console *c, struct board *b, bool can_keep)
{
    char out[EVAL_TEXT_SIZE], echo[CONSOLE_LINE_SIZE + 2];
    bool kept = strncmp(c->line, keep, sizeof keep - 1) == 0;
    snprintf(echo, sizeof echo, "> %s", c->line);
    print(c, CANVAS_YELLOW, echo);
    if (kept && !can_keep) {
        print(c, CANVAS_RED, "`keep` is unavailable while a demo plays");
        return;
    }
    if (!save(c, b)) {
        print(c, CANVAS_RED, "out of memory: changes could not be undone");
        return;
    }
    bool ok = board_eval(b, c->line + (kept ? sizeof keep - 1 : 0), out, sizeof out);
    if (!ok || !kept)
        board_restore(b, c->snapshot);
    print(c, ok ? CANVAS_WHITE : CANVAS_RED, out);
    if (ok && kept)
        print(c, CANVAS_GREY, "changes kept; the run is marked as \"touched\", and its scores are not saved");
    c->kept = c->kept || (ok && kept);
}

/* ---- the line ---- */

static void set_line(struct console *c, const char *text)
{
    snprintf(c->line, sizeof c->line, "%s", text);
    c->length = c->cursor = (int)strlen(c->line);
}

static void insert(struct console *c, char byte)
{
    if (byte < ' ' || byte > '~' || c->length == CONSOLE_LINE_SIZE - 1)
        return;
    memmove(c->line + c->cursor + 1, c->line + c->cursor, (size_t)(c->length - c->cursor + 1));
    c->line[c->cursor++] = byte;
    c->length++;
}

static void erase(struct console *c, int i)
{
    if (i < 0 || i >= c->length)
        return;
    memmove(c->line + i, c->line + i + 1, (size_t)(c->length - i));
    c->length--;
    c->cursor = i;
}

/* direction 1: to the previous line; -1: to the next one. */
static void recall(struct console *c, int direction)
{
    int most = c->history_count < CONSOLE_HISTORY ? c->history_count : CONSOLE_HISTORY,
        to = c->history_back + direction;
    if (to < 0 || to > most)
        return;
    c->history_back = to;
    set_line(c, to ? c->history[(c->history_count - to) % CONSOLE_HISTORY] : "");
}

static void submit_line(struct console *c, struct board *b, bool can_keep)
{
    if (!c->length)
        return;
    run(c, b, can_keep);
    if (!c->history_count || strcmp(c->history[(c->history_count - 1) % CONSOLE_HISTORY], c->line) != 0)
        memcpy(c->history[c->history_count++ % CONSOLE_HISTORY], c->line, sizeof c->line);
    c->history_back = 0;
    set_line(c, "");
}

static void handle_key(struct console *c, unsigned key, struct board *b, bool can_keep)
{
    switch (key) {
    case KEY_ENTER:
    case KEY_KEYPAD_ENTER:
        submit_line(c, b, can_keep);
        break;
    case KEY_ESCAPE:
        c->open = false;
        break;
    case KEY_BACKSPACE:
        erase(c, c->cursor - 1);
        break;
    case KEY_DELETE:
        erase(c, c->cursor);
        break;
    case KEY_HOME:
        c->cursor = 0;
        break;
    case KEY_END:
        c->cursor = c->length;
        break;
    case KEY_LEFT:
        c->cursor -= c->cursor > 0;
        break;
    case KEY_RIGHT:
        c->cursor += c->cursor < c->length;
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

/* Handles keys that were not held at the last poll, and repeats some that are held. */
static void read_keys(struct console *c, const struct plat_input *in, struct board *b, bool can_keep)
{
    static const uint8_t keys[] = { KEY_ENTER, KEY_ESCAPE, KEY_BACKSPACE, KEY_HOME, KEY_DELETE,      KEY_END,
                                    KEY_RIGHT, KEY_LEFT,   KEY_DOWN,      KEY_UP,   KEY_KEYPAD_ENTER };
    if (!plat_is_key_held(in, c->repeat_key))
        c->repeat_key = 0;
    for (size_t i = 0; i < sizeof keys && c->open; i++) {
        if (!plat_is_key_held(in, keys[i]))
            continue;
        if (!was_held(c, keys[i])) {
            handle_key(c, keys[i], b, can_keep);
            c->repeat_key = can_repeat(keys[i]) ? keys[i] : 0;
            c->repeat_polls = 0;
        } else if (c->repeat_key == keys[i] && ++c->repeat_polls >= REPEAT_AFTER && c->repeat_polls % REPEAT_EVERY == 0)
            handle_key(c, keys[i], b, can_keep);
    }
}

static void open_console(struct console *c)
{
    c->open = true;
    c->repeat_key = 0;
    if (!c->output_count)
        print(c, CANVAS_GREY,
              "Enter a line of Lua. Its changes are undone afterwards,\nexcept with `keep LINE`. Up: history. Escape: "
              "close.");
}

/* The console's hotkey is also a letter: text that arrives while it is held is ignored. */
void console_poll(struct console *c, const struct plat_input *in, struct keys_state *k, struct board *b, bool can_keep)
{
    const uint32_t key = (uint32_t)1 << HOTKEY_CONSOLE;
    bool was_open = c->open;
    if (!b || (k->pressed & key && was_open))
        c->open = false;
    else if (k->pressed & key)
        open_console(c);
    for (int i = 0; was_open && c->open && !(k->held & key) && in->text[i]; i++)
        insert(c, in->text[i]);
    if (was_open && c->open)
        read_keys(c, in, b, can_keep);
    memcpy(c->held, in->keys, sizeof c->held);
    if (was_open || c->open)
        memset(k, 0, sizeof *k);
}

bool console_take_kept(struct console *c)
{
    bool kept = c->kept;
    c->kept = false;
    return kept;
}

/* ---- picture ---- */

static int row_count(const char *text, int columns)
{
    int rows = 0;
    do {
        text += canvas_text_fit(text, columns);
        rows++;
    } while (*text);
    return rows;
}

/* Draws lines upwards from the newest, as many as fit. */
static void draw_output(const struct console *c, const struct canvas *canvas, int y0, int y1, int columns)
{
    int oldest = c->output_count > CONSOLE_MAX_OUTPUT ? c->output_count - CONSOLE_MAX_OUTPUT : 0, y = y1;
    for (int i = c->output_count - 1; i >= oldest && y > y0; i--) {
        const struct console_output *s = &c->output[i % CONSOLE_MAX_OUTPUT];
        const char *text = s->text;
        int row = y -= row_count(text, columns) * CANVAS_CELL_H;
        for (int n; *text; text += n, row += CANVAS_CELL_H) {
            n = canvas_text_fit(text, columns);
            if (row >= y0)
                canvas_text_n(canvas, 2, row, s->colour, text, n);
        }
    }
}

/* Scrolls a long line so that the cursor is visible. */
static void draw_line(const struct console *c, const struct canvas *canvas, int y, int columns)
{
    int first = c->cursor < columns - 2 ? 0 : c->cursor - columns + 3;
    int x = canvas_text(canvas, 2, y, CANVAS_YELLOW, "> ");
    canvas_text_n(canvas, x, y, CANVAS_WHITE, c->line + first, columns - 2);
    canvas_rect(canvas, x + (c->cursor - first) * CANVAS_CELL_W, y + CANVAS_CELL_H - 1, CANVAS_CELL_W - 1, 1,
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
