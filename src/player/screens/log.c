/*
 * log.c - the log and its screen (log.h). A row shows the start of a line; the whole line is shown below the list while
 * the row is chosen.
 */
#include "log.h"

#include <stdio.h>
#include <string.h>
#include "../../common/clean.h"

int log_count(const struct log *log)
{
    return log->lines < LOG_LINES ? (int)log->lines : LOG_LINES;
}

const struct log_line *log_line(const struct log *log, int i)
{
    return &log->line[(log->lines - (uint32_t)log_count(log) + (uint32_t)i) % LOG_LINES];
}

static bool repeats_last(const struct log *log, enum log_kind kind, const char *text)
{
    if (log->lines == 0)
        return false;
    const struct log_line *last = log_line(log, log_count(log) - 1);
    return last->kind == kind && strcmp(last->text, text) == 0;
}

/* Copies the first n bytes of text. If they don't fit, an ellipsis follows the last whole character that does. */
static void copy(char *out, size_t size, const char *text, size_t n)
{
    const bool cut = n >= size;

    n = cut ? size - 4 : n;
    while (cut && n > 0 && ((unsigned char)text[n] & 0xc0) == 0x80)
        n--;
    memcpy(out, text, n);
    memcpy(out + n, cut ? "..." : "", cut ? 4 : 1);
    clean_line(out);
}

static void add(struct log *log, enum log_kind kind, uint32_t frame, const char *text, size_t n)
{
    struct log_line line = { .kind = kind, .frame = frame, .times = 1 };

    copy(line.text, sizeof line.text, text, n);
    if (repeats_last(log, kind, line.text))
        log->line[(log->lines - 1) % LOG_LINES].times++;
    else
        log->line[log->lines++ % LOG_LINES] = line;
}

void log_add(struct log *log, enum log_kind kind, uint32_t frame, const char *text)
{
    while (*text) {
        const size_t n = strcspn(text, "\n");
        if (n > 0)
            add(log, kind, frame, text, n);
        text += n + (text[n] == '\n');
    }
}

/* ---- the screen ---- */

static int rows(void *context)
{
    return log_count(context);
}

static void row(void *context, int at, struct screen_row *row)
{
    static const enum canvas_colour colours[] = {
        [LOG_SCRIPT] = CANVAS_WHITE, [LOG_PROGRAM] = CANVAS_GREY, [LOG_FAULT] = CANVAS_RED
    };
    const struct log_line *line = log_line(context, at);

    copy(row->label, sizeof row->label, line->text, strlen(line->text));
    row->colour = colours[line->kind];
    row->value_colour = CANVAS_GREY;
    if (line->times > 1)
        snprintf(row->value, sizeof row->value, "%u x  %u", (unsigned)line->times, (unsigned)line->frame);
    else
        snprintf(row->value, sizeof row->value, "%u", (unsigned)line->frame);
    copy(row->help, sizeof row->help, line->text, strlen(line->text));
}

static const char *text(void *context)
{
    return log_count(context) ? "" : "No messages yet.";
}

static const struct screen_def screen = { .title = "Log", .rows = rows, .row = row, .text = text };

void log_open(struct log *log, struct screens *screens)
{
    screens_open(screens, &screen, log);
    screens_choose(screens, log_count(log) - 1);
}

void log_toggle(struct log *log, struct screens *screens)
{
    if (screens_top(screens) == &screen)
        screens_close(screens);
    else
        log_open(log, screens);
}
