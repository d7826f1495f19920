/*
 * screen_draw.c - draws a screen (screen.h). From the top: title, text, list, help of the chosen row, footer. The list
 * scrolls and text wraps, so every screen fits every picture. A label is truncated before it reaches its value.
 */
#include <stdio.h>
#include <string.h>
#include "screen.h"
#include "../../base/int.h"

enum {
    LINE = CANVAS_LARGE_LINE_HEIGHT,
    TEXT_TOP = 3, /* px from a line's top to the top of a capital */
    PADDING = 5,  /* px between a frame and its contents */
    TITLE = LINE + 2,
    HELP_LINES = 3,
    MIN_HELP_HEIGHT = 100,  /* px: the least height with a line of help; twice as many for more lines */
    MIN_FOOTER_HEIGHT = 120 /* px: the least height with a foot */
};

int screen_row_height(void)
{
    return LINE;
}

static int line_count(const char *text, int w)
{
    return canvas_large_text_wrapped(NULL, 0, 0, w, CANVAS_WHITE, text);
}

/* Draws at most max_lines lines from y down. Returns the y below them. */
static int draw_lines(const struct canvas *canvas, int x, int y, int w, int max_lines, enum canvas_colour c,
                      const char *text)
{
    for (int i = 0; i < max_lines && *text; i++, y += LINE) {
        const int n = canvas_large_text_fit(text, w);
        canvas_large_text_n(canvas, x, y + TEXT_TOP, c, text, (size_t)n);
        text += n;
        text += *text == '\n';
    }
    return y;
}

static enum canvas_colour label_colour(const struct screen_row *row)
{
    if (row->colour)
        return row->colour;
    return row->heading ? CANVAS_CYAN : row->disabled ? CANVAS_GREY : CANVAS_WHITE;
}

static enum canvas_colour value_colour(const struct screen_row *row)
{
    if (row->value_colour)
        return row->value_colour;
    return row->disabled ? CANVAS_GREY : CANVAS_YELLOW;
}

static void draw_row(const struct screen_place *p, int at, const struct canvas *canvas, struct screen_area to)
{
    const struct screen_row row = screen_place_row(p, at);
    char value[SCREEN_VALUE + 4];
    const bool chosen = at == p->row;

    if (chosen)
        canvas_rect(canvas, to.x, to.y, to.w, LINE, CANVAS_WHITE);
    snprintf(value, sizeof value, chosen && row.changes ? "< %s >" : "%s", row.value);
    const int space = to.w - 2 * PADDING, space_beside = space - canvas_large_text_width(row.label) - 2 * PADDING;
    const int max_width = space_beside > space / 2 ? space_beside : space / 2, width = canvas_large_text_width(value);
    const int value_w = width < max_width ? width : max_width;
    const int x = to.x + to.w - PADDING - value_w;
    canvas_large_text_truncated(canvas, to.x + PADDING, to.y + TEXT_TOP, chosen ? CANVAS_DARK : label_colour(&row),
                                row.label, x - to.x - 2 * PADDING);
    canvas_large_text_truncated(canvas, x, to.y + TEXT_TOP, chosen ? CANVAS_DARK : value_colour(&row), value, value_w);
}

/* Returns the first visible row, such that the chosen row and its neighbours are visible; the one above may be a
 * heading. */
static int first_visible_row(const struct screen_place *p, int n, int shown)
{
    int top = p->top;

    if (p->row < top + 1)
        top = p->row - 1;
    if (p->row > top + shown - 2)
        top = p->row - shown + 2;
    if (top > n - shown)
        top = n - shown;
    return top < 0 ? 0 : top;
}

static void draw_list(struct screens *s, struct screen_place *p, const struct canvas *canvas, struct screen_area to)
{
    const int n = p->screen->rows(p->context);

    s->list = to;
    s->shown = to.h / LINE;
    p->top = first_visible_row(p, n, s->shown);
    for (int i = 0; i < s->shown && p->top + i < n; i++)
        draw_row(p, p->top + i, canvas, (struct screen_area){ to.x, to.y + i * LINE, to.w, LINE });
    if (n > s->shown && n > 0) {
        const int h = s->shown * LINE;
        canvas_rect(canvas, to.x + to.w - 1, to.y + h * p->top / n, 1, h * s->shown / n, CANVAS_GREY);
    }
}

/* Returns the width of the title or the widest row, in px. */
static int content_width(const struct screen_place *p)
{
    char title[SCREEN_LABEL];
    int widest;

    screen_place_title(p, title, sizeof title);
    widest = canvas_large_text_width(title);
    for (int i = 0, n = p->screen->rows(p->context); i < n; i++) {
        const struct screen_row row = screen_place_row(p, i);
        const int w =
            canvas_large_text_width(row.label) +
            (row.value[0] ? canvas_large_text_width(row.value) + canvas_large_text_width("<  >") + 2 * PADDING : 0);
        widest = w > widest ? w : widest;
    }
    return widest;
}

/* Returns the number of lines of the longest help, at most HELP_LINES. */
static int help_lines(const struct screen_place *p, int w)
{
    int max_lines = 0;

    for (int i = 0, n = p->screen->rows(p->context); i < n; i++) {
        const struct screen_row row = screen_place_row(p, i);
        const int lines = line_count(row.help, w);
        max_lines = lines > max_lines ? lines : max_lines;
    }
    return max_lines < HELP_LINES ? max_lines : HELP_LINES;
}

/* Returns the screen's area: a box in the middle, as small as possible, or the whole picture. */
static struct screen_area screen_area(const struct screen_place *p, const struct canvas *canvas, const char *text)
{
    const int w = canvas->fb->w, h = canvas->fb->h;

    if (!p->screen->small)
        return (struct screen_area){ 0, 0, w, h };
    int width = content_width(p) + 6 * PADDING;
    if (width < w * 2 / 3)
        width = w * 2 / 3;
    width = int_min(width, w);
    const int lines = line_count(text, width - 2 * PADDING);
    const int help = help_lines(p, width - 2 * PADDING);
    int height = TITLE + PADDING + (lines + p->screen->rows(p->context) + help) * LINE + (help ? 2 : 1) * PADDING +
                 (lines ? PADDING : 0);
    height = int_min(height, h);
    return (struct screen_area){ (w - width) / 2, (h - height) / 2, width, height };
}

static void draw_title(const struct screen_place *p, const struct canvas *canvas, const struct screen_area *a)
{
    char title[SCREEN_LABEL];

    screen_place_title(p, title, sizeof title);
    canvas_rect(canvas, a->x, a->y, a->w, TITLE, CANVAS_CYAN);
    canvas_large_text(canvas, a->x + PADDING, a->y + TEXT_TOP + 1, CANVAS_DARK, title);
}

/* Draws the line of screens_show_message or the chosen row's help below the list. */
static void draw_help(const struct screens *s, const struct screen_place *p, const struct canvas *canvas,
                      const struct screen_area *a)
{
    struct screen_row row = { 0 };

    if (p->screen->rows(p->context) > 0)
        row = screen_place_row(p, p->row);
    canvas_rect(canvas, a->x, a->y - PADDING / 2, a->w, 1, CANVAS_GREY);
    draw_lines(canvas, a->x + PADDING, a->y, a->w - 2 * PADDING, HELP_LINES,
               s->message_frames ? CANVAS_YELLOW : CANVAS_GREY, s->message_frames ? s->message : row.help);
}

/* Draws the picture of the chosen row above the list. */
static void draw_picture(const struct screen_place *p, const struct canvas *canvas, struct screen_area *list)
{
    const struct screen_def *s = p->screen;
    const int h = s->height ? s->height(p->context, list->w, list->h) : 0;

    if (h <= 0 || s->rows(p->context) == 0)
        return;
    s->draw(p->context, p->row, canvas, (struct screen_area){ list->x, list->y, list->w, h });
    list->y += h;
    list->h -= h;
}

void screens_draw(struct screens *s, const struct canvas *canvas, const char *footer)
{
    if (s->depth == 0)
        return;
    struct screen_place *p = &s->place[s->depth - 1];
    screens_settle(s);
    char text[SCREEN_TEXT];
    screen_place_text(p, text, sizeof text);
    const struct screen_area a = screen_area(p, canvas, text);
    const bool has_footer = !p->screen->small && footer[0] && a.h >= MIN_FOOTER_HEIGHT;
    const int max_lines = a.h < MIN_HELP_HEIGHT ? 0 : a.h < 2 * MIN_HELP_HEIGHT ? 1 : HELP_LINES;
    const int lines = p->screen->small ? help_lines(p, a.w - 2 * PADDING) : max_lines;
    const int help = lines ? lines * LINE + PADDING : 0, bottom = a.y + a.h - (has_footer ? LINE + 1 : 0) - help;

    canvas_rect(canvas, a.x, a.y, a.w, a.h, CANVAS_DARK);
    if (p->screen->small)
        canvas_outline(canvas, a.x - 1, a.y - 1, a.w + 2, a.h + 2, CANVAS_GREY);
    draw_title(p, canvas, &a);
    int y = a.y + TITLE + PADDING;
    y = draw_lines(canvas, a.x + PADDING, y, a.w - 2 * PADDING, a.h / LINE / 2, CANVAS_WHITE, text);
    struct screen_area list = { a.x, y + (text[0] ? PADDING : 0), a.w, 0 };
    list.h = bottom - list.y - PADDING / 2;
    draw_picture(p, canvas, &list);
    draw_list(s, p, canvas, list);
    if (help)
        draw_help(s, p, canvas, &(struct screen_area){ a.x, bottom + PADDING / 2, a.w, help });
    if (has_footer)
        canvas_large_text(canvas, a.x + PADDING, a.y + a.h - LINE + TEXT_TOP - 1, CANVAS_CYAN, footer);
}
