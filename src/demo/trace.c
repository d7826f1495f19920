/*
 * trace.c - dumps the state of a board (trace.h). An hour of play is several gigabytes of lines, so they are formatted
 * by hand.
 */
#include "trace.h"

#include <string.h>

enum {
    LINE_SIZE = 16384,
    MAX_VALUE_SIZE = 128 /* maximum bytes of one value with its column name */
};

struct trace {
    FILE *out;
    uint32_t frame;
    const char *part;
    int64_t slot;      /* slot of the current line */
    bool line_open;    /* a line is in progress */
    bool should_print; /* the line is not an all-zero list entry */
    size_t n;
    char line[LINE_SIZE];
};

static void put_str(struct trace *t, const char *s)
{
    size_t n = strlen(s);

    memcpy(t->line + t->n, s, n);
    t->n += n;
}

static void put_decimal(struct trace *t, uint64_t v)
{
    char digits[20];
    size_t n = sizeof digits;

    do
        digits[--n] = (char)('0' + v % 10);
    while (v /= 10);
    memcpy(t->line + t->n, digits + n, sizeof digits - n);
    t->n += sizeof digits - n;
}

static void put_value(struct trace *t, uint64_t v, int width)
{
    uint64_t sign = 1ull << (width * 8 - 1);

    for (int i = width * 8 - 4; i >= 0; i -= 4)
        t->line[t->n++] = "0123456789abcdef"[v >> i & 15];
    if (v < 10 || width == 8)
        return;
    put_str(t, v & sign ? "(-" : "(");
    put_decimal(t, v & sign ? (sign << 1) - v : v);
    put_str(t, ")");
}

static void flush_line(struct trace *t)
{
    fwrite(t->line, 1, t->n, t->out);
    t->n = 0;
}

static void close_line(struct trace *t)
{
    if (t->line_open && t->should_print) {
        put_str(t, "\n");
        flush_line(t);
    }
    t->n = 0;
    t->line_open = false;
}

static void open_line(struct trace *t, const struct slots_value *v)
{
    t->line_open = true;
    t->slot = v->slot;
    t->should_print = v->slot == NO_SLOT || v->gen;
    put_decimal(t, t->frame);
    put_str(t, " ");
    put_str(t, t->part);
    put_str(t, " ");
    if (v->slot == NO_SLOT)
        put_str(t, "-");
    else
        put_decimal(t, (uint64_t)v->slot);
    put_str(t, " ");
    if (v->gen)
        put_decimal(t, v->gen);
    else
        put_str(t, "-");
}

static void trace_value(void *context, const struct slots_value *v)
{
    struct trace *t = context;

    if (t->line_open && t->slot != v->slot)
        close_line(t);
    if (!t->line_open)
        open_line(t, v);
    if (t->n > LINE_SIZE - MAX_VALUE_SIZE) {
        t->should_print = true;
        flush_line(t);
    }
    t->should_print |= v->value != 0;
    put_str(t, v->i == 0 ? " " : ",");
    if (v->i == 0) {
        put_str(t, v->column);
        put_str(t, "=");
    }
    put_value(t, v->value, v->width);
}

void trace_frame(FILE *out, const struct board *b, uint64_t parts)
{
    struct trace t = { .out = out, .frame = board_frame(b) };

    for (int i = 0; i < board_part_count(b); i++) {
        if (!(parts >> i & 1))
            continue;
        t.part = board_part_name(b, i);
        board_trace(b, i, trace_value, &t);
        close_line(&t);
    }
}
