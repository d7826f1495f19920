/*
 * diagnostics.c - see diagnostics.h.
 */
#include "diagnostics.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../host/clean.h"

enum { TEXT = 640 };

static char *copy(const char *s)
{
    size_t n = strlen(s) + 1;
    char *to = malloc(n);

    if (to != NULL)
        memcpy(to, s, n);
    return to;
}

static bool grow(struct diagnostics *f)
{
    int room = f->room == 0 ? 64 : f->room * 2;
    struct diagnostic *more = realloc(f->list, (size_t)room * sizeof *more);

    if (more == NULL)
        return false;
    f->list = more;
    f->room = room;
    return true;
}

static void drop(struct diagnostic *one)
{
    free(one->file);
    free(one->text);
}

static void add(struct diagnostics *f, const char *file, int line, const char *text)
{
    struct diagnostic one = { copy(file), copy(text), line, f->n };
    if (one.file == NULL || one.text == NULL || (f->n == f->room && !grow(f))) {
        drop(&one);
        f->failed = true;
        return;
    }
    f->list[f->n++] = one;
}

void diagnostics_add(struct diagnostics *f, const char *file, int line, const char *format, ...)
{
    char text[TEXT];
    va_list args;

    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    clean_line(text);
    add(f, file, line, text);
}

void diagnostics_add_sentence(struct diagnostics *f, const char *file, const char *sentence)
{
    const char *end = strchr(sentence, ':');
    char name[TEXT];

    if (end == NULL || memchr(sentence, ' ', (size_t)(end - sentence)) != NULL) {
        diagnostics_add(f, file, 0, "%s", sentence);
        return;
    }
    snprintf(name, sizeof name, "%.*s", (int)(end - sentence), sentence);
    char *rest;
    long line = strtol(end + 1, &rest, 10);
    bool numbered = rest > end + 1 && *rest == ':' && line > 0 && line < 1 << 30;
    const char *what = numbered ? rest + 1 : end + 1;
    diagnostics_add(f, name, numbered ? (int)line : 0, "%s", what + strspn(what, " "));
}

bool diagnostics_at(const struct diagnostics *f, const char *file, int line)
{
    for (int i = 0; i < f->n; i++)
        if (f->list[i].line == line && strcmp(f->list[i].file, file) == 0)
            return true;
    return false;
}

static int by_place(const void *a, const void *b)
{
    const struct diagnostic *p = a, *q = b;
    int files = strcmp(p->file, q->file);

    if (files != 0)
        return files;
    return p->line != q->line ? (p->line < q->line ? -1 : 1) : p->order - q->order;
}

/* Is it told already, among those from `first` on, which are of its place? */
static bool is_told(const struct diagnostics *f, int first, int n, const struct diagnostic *one)
{
    for (int i = first; i < n; i++)
        if (strcmp(f->list[i].text, one->text) == 0)
            return true;
    return false;
}

void diagnostics_sort(struct diagnostics *f)
{
    int n = 0, first = 0; /* kept; the first of them at the present place */

    if (f->n > 0)
        qsort(f->list, (size_t)f->n, sizeof f->list[0], by_place);
    for (int i = 0; i < f->n; i++) {
        struct diagnostic *one = &f->list[i];
        if (n > 0 && (f->list[n - 1].line != one->line || strcmp(f->list[n - 1].file, one->file) != 0))
            first = n;
        if (is_told(f, first, n, one))
            drop(one);
        else
            f->list[n++] = *one;
    }
    f->n = n;
}

/* Does it begin with a column, as of MML? */
static bool has_column(const char *text)
{
    size_t n = strspn(text, "0123456789");

    return n > 0 && text[n] == ':';
}

void diagnostics_print(const struct diagnostics *f, void (*line)(const char *))
{
    char text[2 * TEXT];

    for (int i = 0; i < f->n; i++) {
        const struct diagnostic *one = &f->list[i];
        if (one->line > 0)
            snprintf(text, sizeof text, "%s:%d:%s%s", one->file, one->line, has_column(one->text) ? "" : " ",
                     one->text);
        else
            snprintf(text, sizeof text, "%s: %s", one->file, one->text);
        clean_line(text);
        line(text);
    }
}

void diagnostics_close(struct diagnostics *f)
{
    for (int i = 0; i < f->n; i++)
        drop(&f->list[i]);
    free(f->list);
    *f = (struct diagnostics){ 0 };
}
