/*
 * lang.c - see lang.h. All strings are copied to a block of twice the size of the file.
 */
#include "lang.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../fb/utf8.h"
#include "../../base/bytes.h"
#include "../../base/err.h"
#include "../../common/array.h"
#include "../../common/result.h"
#include "../../rom/words.h"

struct reader {
    struct lang *l;
    const char *file;
    char *err;
    size_t err_size, used;
    int line;
};

static bool refuse(const struct reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

static bool refuse(const struct reader *r, const char *format, ...)
{
    va_list args;
    int n = snprintf(r->err, r->err_size, "%s:%d: ", r->file, r->line);

    va_start(args, format);
    if (n > 0 && (size_t)n < r->err_size)
        vsnprintf(r->err + n, r->err_size - (size_t)n, format, args);
    va_end(args);
    return false;
}

/* Invalid UTF-8 and control characters except tabs are errors, because they would be drawn as boxes. */
static bool check_bytes(const struct reader *r, const char *p, const char *end)
{
    while (p < end) {
        const uint8_t byte = (uint8_t)*p;
        uint32_t code;
        if (!utf8_read(&p, end, &code))
            return refuse(r, "expected UTF-8, got byte %d", byte);
        if (!utf8_may_show(code) && code != '\t')
            return refuse(r, "control character U+%04X", (unsigned)code);
    }
    return true;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/* Returns the = between text and translation, or NULL. */
static const char *find_equals(const char *p, const char *end)
{
    for (; p < end && *p != '='; p++)
        p += *p == '\\' && p + 1 < end;
    return p < end ? p : NULL;
}

/* Copies [p, end) without spaces at its ends, and replaces escapes. NULL: an error. */
static const char *copy_unescaped(struct reader *r, const char *p, const char *end)
{
    char *out = r->l->block + r->used, *to = out;

    while (p < end && is_blank(*p))
        p++;
    while (end > p && is_blank(end[-1]) && !(end - 1 > p && end[-2] == '\\'))
        end--;
    for (; p < end; p++) {
        if (*p != '\\') {
            *to++ = *p;
            continue;
        }
        const char c = p + 1 < end ? *++p : '\0';
        if (c == '\0' || strchr("n=#\\ ", c) == NULL) {
            refuse(r, "unknown escape \\%.*s (escapes are \\n \\= \\# \\\\ and \\ before a space)", c != '\0', &c);
            return NULL;
        }
        *to++ = c == 'n' ? '\n' : c;
    }
    if (to - out >= WORDS_MAX_TEXT) {
        refuse(r, "text of %d bytes, expected at most %d", (int)(to - out), WORDS_MAX_TEXT - 1);
        return NULL;
    }
    *to++ = '\0';
    r->used += (size_t)(to - out);
    return out;
}

static bool read_line(struct reader *r, const char *p, const char *end)
{
    struct lang_line one = { .line = r->line };

    while (p < end && is_blank(*p))
        p++;
    if (p == end || *p == '#')
        return true;
    if (end[-1] == '\r')
        end--;
    if (!check_bytes(r, p, end))
        return false;
    const char *middle = find_equals(p, end);
    if (middle == NULL)
        return refuse(r, "expected text = translation, got \"%.*s\"", (int)(end - p < 60 ? end - p : 60), p);
    one.text = copy_unescaped(r, p, middle);
    one.words = one.text != NULL ? copy_unescaped(r, middle + 1, end) : NULL;
    if (one.words == NULL)
        return false;
    if (one.text[0] == '\0' || one.words[0] == '\0')
        return refuse(r, "expected %s the =", one.text[0] == '\0' ? "text before" : "a translation after");
    if (r->l->n == WORDS_MAX_ENTRIES)
        return refuse(r, "more than %d texts", WORDS_MAX_ENTRIES);
    if (!array_append(&r->l->list, (size_t)r->l->n, sizeof one))
        return result_set_host_error(r->err, r->err_size, "out of memory");
    r->l->list[r->l->n++] = one;
    return true;
}

static int compare_lines(const void *a, const void *b)
{
    const struct lang_line *x = a, *y = b;
    int order = strcmp(x->text, y->text);

    return order ? order : (x->line > y->line) - (x->line < y->line);
}

static bool sort_lines(struct reader *r)
{
    struct lang *l = r->l;

    if (l->n > 0)
        qsort(l->list, (size_t)l->n, sizeof *l->list, compare_lines);
    for (int i = 1; i < l->n; i++) {
        r->line = l->list[i].line;
        if (strcmp(l->list[i - 1].text, l->list[i].text) == 0)
            return refuse(r, "duplicate \"%.60s\": line %d already has it", l->list[i].text, l->list[i - 1].line);
    }
    return true;
}

bool lang_read(struct lang *l, const char *bytes, size_t n, const char *file, char *err, size_t err_size)
{
    struct reader r = { .l = l, .file = file, .err = err, .err_size = err_size, .line = 1 };
    const char *end = bytes + n;

    *l = (struct lang){ .block = malloc(2 * n + 2) };
    if (l->block == NULL)
        return result_set_host_error(err, err_size, "out of memory");
    if (n > LANG_MAX_FILE)
        return err_set(err, err_size, "%s: longer than %d bytes", file, LANG_MAX_FILE);
    for (const char *p = bytes; p < end; r.line++) {
        const char *newline = memchr(p, '\n', (size_t)(end - p)), *stop = newline != NULL ? newline : end;
        if (!read_line(&r, p, stop))
            return false;
        p = stop + (newline != NULL);
    }
    return sort_lines(&r);
}

void lang_free(struct lang *l)
{
    free(l->block);
    free(l->list);
    *l = (struct lang){ 0 };
}

size_t lang_make(const struct lang *l, uint8_t **out)
{
    size_t at = 4 + 8 * (size_t)l->n, size = at;

    for (int i = 0; i < l->n; i++)
        size += strlen(l->list[i].text) + strlen(l->list[i].words) + 2;
    *out = malloc(size);
    if (*out == NULL)
        return 0;
    bytes_put32(*out, (uint32_t)l->n);
    for (int i = 0; i < l->n; i++) {
        const char *both[] = { l->list[i].text, l->list[i].words };
        for (int k = 0; k < 2; k++) {
            bytes_put32(*out + 4 + 8 * (size_t)i + 4 * (size_t)k, (uint32_t)at);
            memcpy(*out + at, both[k], strlen(both[k]) + 1);
            at += strlen(both[k]) + 1;
        }
    }
    return size;
}
