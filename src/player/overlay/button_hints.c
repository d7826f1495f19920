/*
 * button_hints.c - see button_hints.h.
 */
#include <stdio.h>
#include <string.h>
#include "../../base/int.h"
#include "button_hints.h"

enum {
    CAP = 3, /* px on each side of a label */
    GAP = 3, /* between a button and its meaning */
    APART = 8,
};

/* The colours that the buttons of a controller have. Nintendo's have none. */
static enum canvas_colour colour_of(const char *label, int kind)
{
    static const struct {
        const char *label;
        enum canvas_colour colour;
    } table[] = { { "A", CANVAS_GREEN },        { "B", CANVAS_RED },       { "X", CANVAS_CYAN },
                  { "Y", CANVAS_YELLOW },       { "\u2715", CANVAS_CYAN }, { "\u25CB", CANVAS_RED },
                  { "\u25A1", CANVAS_MAGENTA }, { "\u25B3", CANVAS_GREEN } };

    for (size_t i = 0; kind >= 0 && kind != PLAT_NINTENDO && i < sizeof table / sizeof *table; i++)
        if (!strcmp(table[i].label, label))
            return table[i].colour;
    return CANVAS_WHITE;
}

static int width_of(const struct canvas *canvas, const struct button_hint *h)
{
    int w = canvas_large_text_width(canvas, h->meaning);

    for (int i = 0; i < BUTTON_HINT_CAPS; i++)
        w += h->cap[i].label[0] ? canvas_large_text_width(canvas, h->cap[i].label) + 2 * CAP + GAP : 0;
    return w;
}

static int total_width(const struct canvas *canvas, const struct button_hint *hint, int n)
{
    int w = n > 0 ? APART * (n - 1) : 0;

    for (int i = 0; i < n; i++)
        w += width_of(canvas, &hint[i]);
    return w;
}

/* Draws a key as a square cap, a controller's button as a round one. Returns the x after it. */
static int draw_button(const struct canvas *canvas, int x, int y, const struct button_cap *cap)
{
    const enum canvas_colour c = colour_of(cap->label, cap->kind);
    const int w = canvas_large_text_width(canvas, cap->label) + 2 * CAP, h = BUTTON_HINTS_HEIGHT - 2,
              round = cap->kind >= 0 ? 2 : 1;

    for (int i = 0; i < round; i++)
        canvas_rect(canvas, x + round - i, y + i, w - 2 * (round - i), h - 2 * i, c);
    canvas_rect(canvas, x, y + round, w, h - 2 * round, c);
    canvas_large_text(canvas, x + CAP, y + 2, CANVAS_DARK, cap->label);
    return x + w;
}

/* What is printed on keys, where that is not their name with a capital. */
static const struct {
    const char *name, *printed;
} key_prints[] = {
    { "lshift", "Shift" },
    { "rshift", "Shift" },
    { "lctrl", "Ctrl" },
    { "rctrl", "Ctrl" },
    { "lalt", "Alt" },
    { "ralt", "Alt" },
    { "minus", "-" },
    { "equals", "=" },
    { "lbracket", "[" },
    { "rbracket", "]" },
    { "backslash", "\\" },
    { "semicolon", ";" },
    { "quote", "'" },
    { "backquote", "`" },
    { "comma", "," },
    { "period", "." },
    { "slash", "/" },
    { "up", "\u2191" },
    { "down", "\u2193" },
    { "left", "\u2190" },
    { "right", "\u2192" },
    { "pageup", "Page Up" },
    { "pagedown", "Page Down" },
    { "kpenter", "Num Enter" },
};

static void print_key(const char *name, char *out, size_t size)
{
    snprintf(out, size, strncmp(name, "kp", 2) == 0 ? "Num %s" : "%s", strncmp(name, "kp", 2) == 0 ? name + 2 : name);
    for (size_t i = 0; i < sizeof key_prints / sizeof *key_prints; i++)
        if (strcmp(key_prints[i].name, name) == 0)
            snprintf(out, size, "%s", key_prints[i].printed);
    if (out[0] >= 'a' && out[0] <= 'z')
        out[0] = (char)(out[0] - 'a' + 'A');
}

void button_hints_print(const char *label, int kind, char out[INPUT_CODE_NAME_SIZE])
{
    const char *modifier = strncmp(label, "ctrl+", 5) == 0 ? "Ctrl+" : strncmp(label, "alt+", 4) == 0 ? "Alt+" : "";
    const size_t n = strlen(modifier);

    snprintf(out, INPUT_CODE_NAME_SIZE, "%s", kind < 0 ? modifier : label);
    if (kind < 0)
        print_key(label + n, out + n, INPUT_CODE_NAME_SIZE - n);
}

/* Draws the caps of a hint, and its meaning. Returns the x after it. */
static int draw_hint(const struct canvas *canvas, int x, int y, const struct button_hint *h)
{
    enum canvas_colour colour = CANVAS_YELLOW;

    for (int i = 0; i < BUTTON_HINT_CAPS; i++)
        if (h->cap[i].label[0]) {
            x = draw_button(canvas, x, y + 1, &h->cap[i]) + GAP;
            colour = CANVAS_WHITE;
        }
    canvas_large_text(canvas, x, y + 3, colour, h->meaning);
    return x + canvas_large_text_width(canvas, h->meaning);
}

void button_hints_draw(const struct canvas *picture, int y, int width, struct button_hint *hint, int n)
{
    const struct canvas plain = canvas_plain(picture), *canvas = &plain;
    char label[INPUT_CODE_NAME_SIZE];

    for (int i = 0; i < n * BUTTON_HINT_CAPS; i++) {
        struct button_cap *cap = &hint[i / BUTTON_HINT_CAPS].cap[i % BUTTON_HINT_CAPS];
        button_hints_print(cap->label, cap->kind, label);
        memcpy(cap->label, label, sizeof label);
    }
    while (n > 1 && total_width(canvas, hint, n) > canvas->fb->w)
        n--;
    int x = (canvas->fb->w - total_width(canvas, hint, n)) / 2;
    width = int_max(width, canvas->fb->w - 2 * (x - APART));
    canvas_rect(canvas, (canvas->fb->w - width) / 2, y, width, BUTTON_HINTS_HEIGHT, CANVAS_DARK);
    for (int i = 0; i < n; i++)
        x = draw_hint(canvas, x, y, &hint[i]) + APART;
}
