/*
 * demo_text.c - writes and reads demos as base64 lines (demo_text.h).
 */
#include "demo_text.h"

#include <string.h>
#include "../base/bytes.h"

static const char digits[65] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/* ---- writing ---- */

static void end_line(struct demo_text *t)
{
    if (t->line_length == 0)
        return;
    t->line[t->line_length++] = '\n';
    t->write(t->context, t->line, (size_t)t->line_length);
    t->line_length = 0;
}

/* Writes the pending bytes as four characters. */
static void write_pending(struct demo_text *t)
{
    const uint32_t v = (uint32_t)t->pending[0] << 16 | (uint32_t)t->pending[1] << 8 | t->pending[2];

    for (int i = 0; i < 4; i++)
        t->line[t->line_length++] = i <= t->n_pending ? digits[v >> (18 - 6 * i) & 63] : '=';
    memset(t->pending, 0, sizeof t->pending);
    t->n_pending = 0;
    if (t->line_length == DEMO_TEXT_LINE_LENGTH)
        end_line(t);
}

void demo_text_begin(struct demo_text *t, void (*write)(void *context, const void *bytes, size_t n), void *context)
{
    static const char first[] = DEMO_TEXT_BEGIN "\n";

    *t = (struct demo_text){ .write = write, .context = context };
    write(context, first, sizeof first - 1);
}

void demo_text_add(struct demo_text *t, const void *bytes, size_t n)
{
    const uint8_t *p = bytes;

    for (size_t i = 0; i < n; i++) {
        t->pending[t->n_pending++] = p[i];
        if (t->n_pending == 3)
            write_pending(t);
    }
}

void demo_text_end(struct demo_text *t)
{
    static const char last[] = DEMO_TEXT_END "\n";

    if (t->n_pending > 0)
        write_pending(t);
    end_line(t);
    t->write(t->context, last, sizeof last - 1);
}

/* ---- reading ---- */

/* Returns the offset of the line after the first DEMO_TEXT_BEGIN line, or 0 when there is none. */
static size_t find_start(const uint8_t *data, size_t size)
{
    const size_t n = sizeof DEMO_TEXT_BEGIN - 1;

    for (size_t i = 0; i + n < size; i++) {
        const uint8_t *end = memchr(data + i, '\n', size - i);
        if (!end)
            return 0;
        if (memcmp(data + i, DEMO_TEXT_BEGIN, n) == 0)
            return (size_t)(end - data) + 1;
        i = (size_t)(end - data);
    }
    return 0;
}

bool demo_text_decode(uint8_t *data, size_t *size)
{
    size_t i = find_start(data, *size), n = 0;
    uint32_t v = 0;
    int bits = 0;

    if (i == 0)
        return false;
    for (; i < *size; i++) {
        if (data[i] == '\n' || data[i] == '\r' || data[i] == ' ' || data[i] == '\t')
            continue;
        if (bytes_base64_digit(data[i]) < 0)
            break;
        v = (v << 6 | (uint32_t)bytes_base64_digit(data[i])) & 0xffffff;
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            data[n++] = (uint8_t)(v >> bits);
        }
    }
    *size = n;
    return true;
}
