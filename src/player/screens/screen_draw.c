/*
 * screen_draw.c - see screen.h: draws a screen. From the top: title, text, list, help of the chosen row, foot. The list
 * scrolls and text wraps, so every screen fits every picture; a label is cut off before it reaches its value.
 */
#include <stdio.h>
#include <string.h>
#include "screen.h"
#include "../../base/int.h"

enum {
    LINE = CANVAS_LARGE_LINE_HEIGHT,
    LETTER = 3, /* px from a line's top to the top of a capital */
    EDGE = 5,   /* px between a frame and its contents */
    TITLE = LINE + 2,
    HELP_LINES = 3,
    HELP_FROM = 100, /* px: the least height with a line of help; twice as many for more lines */
    FOOT_FROM = 120  /* px: the least height with a foot */
};

int screen_row_height(void)
{
    return LINE;
}

/* The number of lines of a text wrapped at w px. */
static int lines_of(const char *text, int w)
{
    int n = 0;

    while (*text) {
        text += canvas_large_text_fit(text, w);
        text += *text == '\n';
        n++;
    }
    return n;
}

/* Draws at most `most` lines from y down; returns the y below them. */
static int draw_lines(const struct canvas *canvas, int x, int y, int w, int most, enum canvas_colour c,
                      const char *text)
{
    char line[SCREEN_HELP];

    for (int i = 0; i < most && *text; i++, y += LINE) {
        const int n = canvas_large_text_fit(text, w);
        snprintf(line, sizeof line, "%.*s", n, text);
        canvas_large_text(canvas, x, y + LETTER, c, line);
        text += n;
        text += *text == '\n';
    }
    return y;
}

static enum canvas_colour label_ink(const struct screen_row *row)
{
    if (row->ink)
        return row->ink;
    return row->heading ? CANVAS_CYAN : row->faint ? CANVAS_GREY : CANVAS_WHITE;
}

static enum canvas_colour value_ink(const struct screen_row *row)
{
    if (row->value_ink)
        return row->value_ink;
    return row->faint ? CANVAS_GREY : CANVAS_YELLOW;
}

static void draw_row(const struct screen_place *p, int at, const struct canvas *canvas, struct screen_area to)
{
    const struct screen_row row = screen_place_row(p, at);
    char value[SCREEN_VALUE + 4];
    const bool chosen = at == p->row;

    if (chosen)
        canvas_rect(canvas, to.x, to.y, to.w, LINE, CANVAS_WHITE);
    snprintf(value, sizeof value, chosen && row.changes ? "< %s >" : "%s", row.value);
    const int room = to.w - 2 * EDGE, beside = room - canvas_large_text_width(row.label) - 2 * EDGE;
    const int most = beside > room / 2 ? beside : room / 2, wide = canvas_large_text_width(value);
    const int right = wide < most ? wide : most;
    const int x = to.x + to.w - EDGE - right;
    canvas_large_text_truncated(canvas, to.x + EDGE, to.y + LETTER, chosen ? CANVAS_DARK : label_ink(&row), row.label,
                                x - to.x - 2 * EDGE);
    canvas_large_text_truncated(canvas, x, to.y + LETTER, chosen ? CANVAS_DARK : value_ink(&row), value, right);
}

/* The first visible row, such that the chosen one and its neighbours are visible: the one above may be a heading. */
static int scrolled(const struct screen_place *p, int n, int shown)
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
    const int n = p->screen->rows(p->of);

    s->list = to;
    s->shown = to.h / LINE;
    p->top = scrolled(p, n, s->shown);
    for (int i = 0; i < s->shown && p->top + i < n; i++)
        draw_row(p, p->top + i, canvas, (struct screen_area){ to.x, to.y + i * LINE, to.w, LINE });
    if (n > s->shown && n > 0) {
        const int h = s->shown * LINE;
        canvas_rect(canvas, to.x + to.w - 1, to.y + h * p->top / n, 1, h * s->shown / n, CANVAS_GREY);
    }
}

/* Width of the widest row in px. */
static int widest(const struct screen_place *p)
{
    int most = canvas_large_text_width(p->screen->title);

    for (int i = 0, n = p->screen->rows(p->of); i < n; i++) {
        const struct screen_row row = screen_place_row(p, i);
        const int w =
            canvas_large_text_width(row.label) +
            (row.value[0] ? canvas_large_text_width(row.value) + canvas_large_text_width("<  >") + 2 * EDGE : 0);
        most = w > most ? w : most;
    }
    return most;
}

/* The most lines that the help of a row has. */
static int help_lines(const struct screen_place *p, int w)
{
    int most = 0;

    for (int i = 0, n = p->screen->rows(p->of); i < n; i++) {
        const struct screen_row row = screen_place_row(p, i);
        const int lines = lines_of(row.help, w);
        most = lines > most ? lines : most;
    }
    return most < HELP_LINES ? most : HELP_LINES;
}

/* The screen's area: a box in the middle, as small as possible, or the whole picture. */
static struct screen_area area_of(const struct screen_place *p, const struct canvas *canvas, const char *text)
{
    const int w = canvas->fb->w, h = canvas->fb->h;

    if (!p->screen->small)
        return (struct screen_area){ 0, 0, w, h };
    int wide = widest(p) + 6 * EDGE;
    if (wide < w * 2 / 3)
        wide = w * 2 / 3;
    wide = int_min(wide, w);
    const int lines = lines_of(text, wide - 2 * EDGE);
    const int help = help_lines(p, wide - 2 * EDGE);
    int high =
        TITLE + EDGE + (lines + p->screen->rows(p->of) + help) * LINE + (help ? 2 : 1) * EDGE + (lines ? EDGE : 0);
    high = int_min(high, h);
    return (struct screen_area){ (w - wide) / 2, (h - high) / 2, wide, high };
}

static void draw_title(const struct screen_def *screen, const struct canvas *canvas, const struct screen_area *a)
{
    canvas_rect(canvas, a->x, a->y, a->w, TITLE, CANVAS_CYAN);
    canvas_large_text(canvas, a->x + EDGE, a->y + LETTER + 1, CANVAS_DARK, screen->title);
}

/* Below the list: the line of screens_say, or the chosen row's help. */
static void draw_help(const struct screens *s, const struct screen_place *p, const struct canvas *canvas,
                      const struct screen_area *a)
{
    struct screen_row row = { 0 };

    if (p->screen->rows(p->of) > 0)
        p->screen->row(p->of, p->row, &row);
    canvas_rect(canvas, a->x, a->y - EDGE / 2, a->w, 1, CANVAS_GREY);
    draw_lines(canvas, a->x + EDGE, a->y, a->w - 2 * EDGE, HELP_LINES, s->said_for ? CANVAS_YELLOW : CANVAS_GREY,
               s->said_for ? s->said : row.help);
}

/* Draws the picture of the chosen row above the list. */
static void take_picture(const struct screen_place *p, const struct canvas *canvas, struct screen_area *list)
{
    const struct screen_def *s = p->screen;
    const int h = s->height ? s->height(p->of, list->w, list->h) : 0;

    if (h <= 0 || s->rows(p->of) == 0)
        return;
    s->draw(p->of, p->row, canvas, (struct screen_area){ list->x, list->y, list->w, h });
    list->y += h;
    list->h -= h;
}

void screens_draw(struct screens *s, const struct canvas *canvas, const char *foot)
{
    if (s->deep == 0)
        return;
    struct screen_place *p = &s->place[s->deep - 1];
    screens_settle(s);
    const char *text = p->screen->text ? p->screen->text(p->of) : "";
    const struct screen_area a = area_of(p, canvas, text);
    const bool feet = !p->screen->small && foot[0] && a.h >= FOOT_FROM;
    const int most = a.h < HELP_FROM ? 0 : a.h < 2 * HELP_FROM ? 1 : HELP_LINES;
    const int lines = p->screen->small ? help_lines(p, a.w - 2 * EDGE) : most;
    const int help = lines ? lines * LINE + EDGE : 0, bottom = a.y + a.h - (feet ? LINE + 1 : 0) - help;

    canvas_rect(canvas, a.x, a.y, a.w, a.h, CANVAS_DARK);
    if (p->screen->small)
        canvas_outline(canvas, a.x - 1, a.y - 1, a.w + 2, a.h + 2, CANVAS_GREY);
    draw_title(p->screen, canvas, &a);
    int y = a.y + TITLE + EDGE;
    y = draw_lines(canvas, a.x + EDGE, y, a.w - 2 * EDGE, a.h / LINE / 2, CANVAS_WHITE, text);
    struct screen_area list = { a.x, y + (text[0] ? EDGE : 0), a.w, 0 };
    list.h = bottom - list.y - EDGE / 2;
    take_picture(p, canvas, &list);
    draw_list(s, p, canvas, list);
    if (help)
        draw_help(s, p, canvas, &(struct screen_area){ a.x, bottom + EDGE / 2, a.w, help });
    if (feet)
        canvas_large_text(canvas, a.x + EDGE, a.y + a.h - LINE + LETTER - 1, CANVAS_CYAN, foot);
}
