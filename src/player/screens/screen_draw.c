/*
 * screen_draw.c - draws a screen (screen.h) like the pages of the game, in a frame over the darkened picture. From the
 * top: title, text, picture, list, help of the chosen row. Titles, help and frames of all large screens are at the same
 * places. The list scrolls and text wraps, so every screen fits every picture. A label is truncated before it reaches
 * its value.
 */
#include <stdio.h>
#include <string.h>
#include "../../../fb/line_break.h"
#include "../../../fb/utf8.h"
#include "../../base/int.h"
#include "screen.h"

enum {
    MARGIN = 8,    /* px around the frame of a large screen, which show the game; none on a low picture */
    AIR = 8,       /* px above the title of a large screen; none on a compact one */
    PADDING = 5,   /* px between the frame's border and its contents */
    ROW_GAP = 3,   /* px between rows */
    RULE = 8,      /* px, height of a rule */
    THIN_RULE = 3, /* px, on a low picture */
    SCROLL_BAR = 3,
    SMALL_WIDTH = 240,     /* px: a small screen is no wider, unless its rows are */
    HELP_LINES = 3,        /* on a large screen, or more if a row needs them and there is space */
    WIDE = 280,            /* px: in frames as wide, a line of help less */
    LOW = 200,             /* px: rows of lower pictures have no gap, and their rules are thin */
    COMPACT = 288,         /* px: titles of lower pictures have less space */
    MIN_HELP_HEIGHT = 100, /* px: the least height with help */
    MAX_RULE_CELLS = 128
};

/* The characters for menus that fonts may have (scripts/menu/page.lua). */
enum { GLYPH_LEFT = 139, GLYPH_RIGHT, GLYPH_LINE, GLYPH_LINE_START, GLYPH_LINE_END, GLYPH_JEWEL };

static bool is_low(const struct canvas *canvas)
{
    return canvas->fb->h < LOW;
}

/* Capitals are exactly in the middle of a row. */
static int row_height(const struct canvas *canvas)
{
    const int h = canvas_line_height(canvas) + (is_low(canvas) ? 0 : ROW_GAP);

    return h - (h - canvas->capital_height) % 2;
}

static int rule_height(const struct canvas *canvas)
{
    return is_low(canvas) ? THIN_RULE : RULE;
}

/* ---- text ---- */

static int centred_x(const struct canvas *canvas, const struct screen_area *a, const char *text)
{
    return a->x + int_max(0, a->w - canvas_large_text_width(canvas, text)) / 2;
}

/* Draws a line at the area's top, truncated to its width. */
static void draw_centred(const struct canvas *canvas, const struct screen_area *a, enum canvas_colour c,
                         const char *text)
{
    canvas_large_text_truncated(canvas, centred_x(canvas, a, text), a->y + canvas->ascent, c, text, a->w);
}

/* Returns how many lines end inside a word when text is wrapped at `width` px. */
static int broken_words(const struct canvas *canvas, const char *text, int width)
{
    int broken = 0;

    for (const char *from = text; *text; text += *text == '\n') {
        text += canvas_large_text_fit(canvas, text, width);
        broken +=
            *text && *text != '\n' && line_break_before(from, strlen(from), (size_t)(text - from)) != LINE_BREAK_WORD;
    }
    return broken;
}

int screen_balanced_width(const struct canvas *canvas, const char *text, int width)
{
    enum { STEP = 4 };
    const int lines = canvas_large_text_lines(canvas, text, width);
    int best = width, fewest = lines > 1 ? broken_words(canvas, text, width) : 0;

    for (int w = width - STEP; lines > 1 && w > width / 2; w -= STEP) {
        if (canvas_large_text_lines(canvas, text, w) != lines)
            break;
        const int broken = broken_words(canvas, text, w);
        if (broken > fewest)
            continue;
        best = w;
        fewest = broken;
    }
    return best;
}

/* Draws at most max_lines lines, centred or not; the last is truncated. Returns the y below them. */
static int draw_lines(const struct canvas *canvas, const struct screen_area *a, int max_lines, enum canvas_colour c,
                      const char *text, bool centred)
{
    const int width = screen_balanced_width(canvas, text, a->w);
    struct screen_area line = *a;
    char part[SCREEN_HELP];

    for (int i = 0; i < max_lines && *text; i++, line.y += canvas_line_height(canvas)) {
        const int fitting = canvas_large_text_fit(canvas, text, width);
        const int n = i == max_lines - 1 ? (int)strcspn(text, "\n") : fitting;
        int shown = n; /* without the space at which the line was broken */
        while (shown > 0 && text[shown - 1] == ' ')
            shown--;
        snprintf(part, sizeof part, "%.*s", shown, text);
        if (centred)
            draw_centred(canvas, &line, c, part);
        else
            canvas_large_text_truncated(canvas, line.x, line.y + canvas->ascent, c, part, a->w);
        text += n;
        text += *text == '\n';
    }
    return line.y;
}

/* Appends a character of the game's font or, if the font lacks it, a plain one. */
static size_t put_glyph(const struct canvas *canvas, char *out, uint32_t code, uint32_t plain)
{
    const size_t n = utf8_put(out, canvas_glyph(canvas, code, plain));

    out[n] = 0;
    return n;
}

/* Draws a rule in the middle of the area's first rule_height pixels. */
static void draw_rule(const struct canvas *canvas, int x, int y, int w)
{
    const int cells = int_min(w / 8, MAX_RULE_CELLS);
    char text[MAX_RULE_CELLS * UTF8_MAX_BYTES + 1];
    size_t n = 0;

    if (is_low(canvas) || cells < 4 || canvas_glyph(canvas, GLYPH_LINE, 0) == 0) {
        canvas_rect(canvas, x, y + rule_height(canvas) / 2, w, 1, CANVAS_CYAN);
        return;
    }
    for (int i = 0; i < cells; i++) {
        const uint32_t end = i == 0 ? GLYPH_LINE_START : i == cells - 1 ? GLYPH_LINE_END : GLYPH_LINE;
        n += put_glyph(canvas, text + n, i == 1 || i == cells - 2 ? GLYPH_JEWEL : end, GLYPH_LINE);
    }
    const int top = y + (canvas->theme->height > RULE ? (RULE - canvas->theme->height) / 2 : 0);
    canvas_large_text(canvas, x + (w - canvas_large_text_width(canvas, text)) / 2, top + canvas->theme->capital_top,
                      CANVAS_CYAN, text);
}

/* ---- rows ---- */

/* Writes the character in front of the chosen row. */
static void cursor_text(const struct canvas *canvas, char out[UTF8_MAX_BYTES + 1])
{
    put_glyph(canvas, out, canvas->theme ? canvas->theme->cursor : '>', '>');
}

/* Returns the px in front of a label that the cursor takes. */
static int cursor_width(const struct canvas *canvas)
{
    char cursor[UTF8_MAX_BYTES + 1];

    cursor_text(canvas, cursor);
    return PADDING + canvas_large_text_width(canvas, cursor) + PADDING;
}

static enum canvas_colour label_colour(const struct screen_row *row, bool chosen)
{
    if (row->disabled)
        return CANVAS_GREY;
    if (chosen)
        return CANVAS_YELLOW;
    return row->colour ? row->colour : row->heading ? CANVAS_CYAN : CANVAS_WHITE;
}

static enum canvas_colour value_colour(const struct screen_row *row, bool chosen)
{
    if (chosen && !row->disabled)
        return CANVAS_YELLOW;
    return row->value_colour ? row->value_colour : row->disabled ? CANVAS_GREY : CANVAS_WHITE;
}

/* Writes the arrows on both sides of a value that changes. */
static void arrow_texts(const struct canvas *canvas, char left[UTF8_MAX_BYTES + 2], char right[UTF8_MAX_BYTES + 2])
{
    const size_t n = put_glyph(canvas, left, GLYPH_LEFT, '<');

    memcpy(left + n, " ", 2);
    right[0] = ' ';
    put_glyph(canvas, right + 1, GLYPH_RIGHT, '>');
}

/* Returns the px that an arrow and its space take on each side of a value; 0: no row changes. */
static int arrow_width(const struct screen_place *p, const struct canvas *canvas)
{
    char left[UTF8_MAX_BYTES + 2], right[UTF8_MAX_BYTES + 2];

    arrow_texts(canvas, left, right);
    for (int i = 0, n = p->screen->rows(p->context); i < n; i++)
        if (screen_place_row(p, i).changes)
            return canvas_large_text_width(canvas, right);
    return 0;
}

/* Draws the plate and the cursor of the chosen row. y: the top of its capitals. */
static void draw_cursor(const struct canvas *canvas, struct screen_area to, int y)
{
    char cursor[UTF8_MAX_BYTES + 1];

    cursor_text(canvas, cursor);
    canvas_plate(canvas, to.x, to.y, to.w, to.h, CANVAS_YELLOW);
    canvas_large_text(canvas, to.x + PADDING, y, CANVAS_WHITE, cursor);
}

/* Draws a row with the label at the left and the value at the right, `arrow` px from the end, which the chosen row
 * fills with an arrow. y: the top of capitals. Returns whether one of them was truncated. */
static bool draw_columns(const struct canvas *canvas, const struct screen_row *row, bool chosen, struct screen_area in,
                         int y, int arrow)
{
    const bool arrows = chosen && row->changes;
    const int gap = row->value[0] ? canvas_large_text_width(canvas, " ") : 0, before = arrows ? arrow : 0;
    const int width = canvas_large_text_width(canvas, row->value),
              label_w = canvas_large_text_width(canvas, row->label);
    char left[UTF8_MAX_BYTES + 2], right[UTF8_MAX_BYTES + 2];

    in.w -= row->value[0] ? arrow : 0;
    const int value_w = int_min(width, int_max(in.w - label_w - gap, in.w / 2) - before);
    const int x = in.x + in.w - value_w, label_end = x - before - gap;
    canvas_large_text_truncated(canvas, in.x, y, label_colour(row, chosen), row->label, label_end - in.x);
    canvas_large_text_truncated(canvas, x, y, value_colour(row, chosen), row->value, value_w);
    if (arrows) {
        arrow_texts(canvas, left, right);
        canvas_large_text(canvas, x - arrow, y, value_colour(row, chosen), left);
        canvas_large_text(canvas, x + value_w, y, value_colour(row, chosen), right);
    }
    return value_w < width || label_end - in.x < label_w;
}

/* Returns whether the label or the value was truncated. */
static bool draw_row(const struct screen_place *p, int at, const struct canvas *canvas, struct screen_area to,
                     bool centred, int arrow)
{
    const struct screen_row row = screen_place_row(p, at);
    const int y = to.y + (to.h - canvas->capital_height) / 2, indent = cursor_width(canvas);
    const bool chosen = at == p->row && !row.heading;
    const struct screen_area inside = { to.x + indent, to.y, to.w - indent - (centred ? indent : PADDING), to.h };

    if (chosen)
        draw_cursor(canvas, to, y);
    if (!centred)
        return draw_columns(canvas, &row, chosen, inside, y, arrow);
    canvas_large_text_truncated(canvas, centred_x(canvas, &inside, row.label), y, label_colour(&row, chosen), row.label,
                                inside.w);
    return canvas_large_text_width(canvas, row.label) > inside.w;
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

/* Returns whether the chosen row was truncated. */
static bool draw_list(struct screens *s, struct screen_place *p, const struct canvas *canvas, struct screen_area to,
                      bool centred)
{
    bool truncated = false;
    const int n = p->screen->rows(p->context), h = row_height(canvas), arrow = arrow_width(p, canvas);

    s->list = to;
    s->row_height = h;
    s->shown = to.h / h;
    p->top = first_visible_row(p, n, s->shown);
    if (n > s->shown && n > 0) {
        const int x = to.x + to.w - SCROLL_BAR, track = s->shown * h, thumb = int_max(track * s->shown / n, SCROLL_BAR);
        to.w -= SCROLL_BAR + 2;
        canvas_rect(canvas, x + SCROLL_BAR / 2, to.y, 1, track, CANVAS_GREY);
        canvas_rect(canvas, x, to.y + (track - thumb) * p->top / (n - s->shown), SCROLL_BAR, thumb, CANVAS_CYAN);
    }
    for (int i = p->top; i < p->top + s->shown && i < n; i++) {
        const struct screen_area row = { to.x, to.y + (i - p->top) * h, to.w, h };
        truncated = (draw_row(p, i, canvas, row, centred, arrow) && i == p->row) || truncated;
    }
    return truncated;
}

/* ---- layout ---- */

/* Returns the width of the title or the widest row, in px; *has_values: whether a row has a value. */
static int content_width(const struct screen_place *p, const struct canvas *canvas, bool *has_values)
{
    char title[SCREEN_LABEL];
    int widest;

    screen_place_title(p, title, sizeof title);
    widest = canvas_large_text_width(canvas, title);
    *has_values = false;
    for (int i = 0, n = p->screen->rows(p->context); i < n; i++) {
        const struct screen_row row = screen_place_row(p, i);
        const int value_w =
            row.value[0] ? canvas_large_text_width(canvas, row.value) + 2 * (arrow_width(p, canvas) + PADDING) : 0;
        widest = int_max(widest, canvas_large_text_width(canvas, row.label) + value_w);
        *has_values = *has_values || row.value[0];
    }
    return widest + 2 * cursor_width(canvas);
}

/* Returns the number of lines of the longest help, or of the message that is shown instead. */
static int help_lines(const struct screen_place *p, const struct canvas *canvas, const char *message, int w)
{
    int max_lines = canvas_large_text_lines(canvas, message, w);

    for (int i = 0, n = p->screen->rows(p->context); i < n; i++) {
        const struct screen_row row = screen_place_row(p, i);
        max_lines = int_max(max_lines, canvas_large_text_lines(canvas, row.help, w));
    }
    return max_lines;
}

/* Where the parts of a screen are. */
struct layout {
    struct screen_area frame, inside; /* inside: of the frame, without its padding */
    int air;                          /* px above the title */
    int lines, help;                  /* of text above the list; of help */
    bool centred;                     /* the rows' labels, as no row has a value */
};

/* A large screen covers the picture except for the margin. */
static void lay_out_large(struct layout *l, const struct screen_place *p, const struct canvas *canvas, int edge, int h,
                          const char *message)
{
    const int margin = is_low(canvas) ? 0 : MARGIN, line = canvas_line_height(canvas);

    l->air = canvas->fb->h < COMPACT ? 0 : AIR;
    l->frame = (struct screen_area){ margin, margin, canvas->fb->w - 2 * margin, h - 2 * margin };
    l->help =
        int_max(help_lines(p, canvas, message, l->frame.w - 2 * edge), l->frame.w < WIDE ? HELP_LINES : HELP_LINES - 1);
    l->help = h < MIN_HELP_HEIGHT ? 0 : int_min(l->help, h / (5 * line));
}

/* A small screen is as large as its rows need. */
static void lay_out_small(struct layout *l, const struct screen_place *p, const struct canvas *canvas, int edge, int h,
                          const char *text, const char *message)
{
    const int w = canvas->fb->w, line = canvas_line_height(canvas), rule = rule_height(canvas);
    bool has_values;
    const int needed = content_width(p, canvas, &has_values) + 2 * edge;

    l->centred = !has_values;
    l->frame.w = int_min(int_max(needed, int_min(w * 4 / 5, SMALL_WIDTH)), w);
    l->frame.x = (w - l->frame.w) / 2;
    l->lines = canvas_large_text_lines(canvas, text, l->frame.w - 2 * edge);
    l->help = help_lines(p, canvas, message, l->frame.w - 2 * edge);
    l->frame.h = 2 * edge + line + rule + l->lines * line + (l->lines ? PADDING : 0) +
                 p->screen->rows(p->context) * row_height(canvas) + (l->help ? rule + l->help * line : 0);
    l->frame.h = int_min(l->frame.h, h);
    l->frame.y = (h - l->frame.h) / 2;
}

/* h: of the picture above the buttons. */
static struct layout lay_out(const struct screen_place *p, const struct canvas *canvas, const char *text,
                             const char *message, int h)
{
    const int edge = canvas_frame_width(canvas) + PADDING;
    struct layout l = { 0 };

    if (p->screen->small)
        lay_out_small(&l, p, canvas, edge, h, text, message);
    else
        lay_out_large(&l, p, canvas, edge, h, message);
    l.inside = (struct screen_area){ l.frame.x + edge, l.frame.y + edge, l.frame.w - 2 * edge, l.frame.h - 2 * edge };
    return l;
}

/* ---- the screen ---- */

/* Draws the line of screens_show_message or the chosen row's help, after the row itself if that was
 * truncated. */
static void draw_help(const struct screens *s, const struct screen_place *p, const struct canvas *canvas,
                      const struct screen_area *a, const struct layout *l, bool truncated)
{
    struct screen_row row = { 0 };
    char text[SCREEN_LABEL + SCREEN_VALUE + SCREEN_HELP] = "";
    int n = 0;

    if (p->screen->rows(p->context) > 0)
        row = screen_place_row(p, p->row);
    if (truncated)
        n = snprintf(text, sizeof text, "%s%s%s\n", row.label, row.value[0] ? ": " : "", row.value);
    snprintf(text + n, sizeof text - (size_t)n, "%s", row.help);
    const char *shown = s->message_frames ? s->message : text;
    struct screen_area area = *a;
    if (l->centred)
        area.y += int_max(0, a->h - canvas_large_text_lines(canvas, shown, a->w) * canvas_line_height(canvas)) / 2;
    draw_lines(canvas, &area, l->help, s->message_frames ? CANVAS_YELLOW : CANVAS_WHITE, shown, l->centred);
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

void screens_draw(struct screens *s, const struct canvas *canvas, int height)
{
    if (s->depth == 0)
        return;
    struct screen_place *p = &s->place[s->depth - 1];
    screens_settle(s);
    char title[SCREEN_LABEL], text[SCREEN_TEXT];
    screen_place_title(p, title, sizeof title);
    screen_place_text(p, text, sizeof text);
    const struct layout l = lay_out(p, canvas, text, s->message_frames ? s->message : "", height);
    const struct screen_area *a = &l.inside;
    const int line = canvas_line_height(canvas), rule = rule_height(canvas);
    const int help_y = a->y + a->h - l.help * line, bottom = help_y - (l.help ? rule : 0);
    struct screen_area heading = { a->x, a->y + l.air, a->w, line };

    canvas_frame(canvas, l.frame.x, l.frame.y, l.frame.w, l.frame.h);
    draw_centred(canvas, &heading, CANVAS_YELLOW, title);
    draw_rule(canvas, a->x, heading.y + line + l.air / 2, a->w);
    const int top = heading.y + line + l.air / 2 + rule + l.air;
    struct screen_area list = { a->x, top, a->w, 0 };
    list.y = draw_lines(canvas, &list, p->screen->small ? l.lines : (bottom - top) / line / 2, CANVAS_WHITE, text,
                        l.centred);
    list.y += text[0] ? PADDING : 0;
    list.h = bottom - list.y;
    draw_picture(p, canvas, &list);
    const bool truncated = draw_list(s, p, canvas, list, l.centred);
    if (l.help) {
        draw_rule(canvas, a->x, bottom, a->w);
        draw_help(s, p, canvas, &(struct screen_area){ a->x, help_y, a->w, l.help * line }, &l, truncated);
    }
}
