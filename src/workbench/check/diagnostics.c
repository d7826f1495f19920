/*
 * diagnostics.c - see diagnostics.h.
 */
#include "diagnostics.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../common/array.h"
#include "../../common/clean.h"

enum { TEXT = 640 };

static char *copy(const char *s)
{
    size_t n = strlen(s) + 1;
    char *to = malloc(n);

    if (to != NULL)
        memcpy(to, s, n);
    return to;
}

static void free_diagnostic(struct diagnostic *one)
{
    free(one->file);
    free(one->text);
}

static void add(struct diagnostics *f, const char *file, int line, bool note, const char *format, va_list args)
{
    char text[TEXT];

    vsnprintf(text, sizeof text, format, args);
    clean_line(text);
    struct diagnostic one = { copy(file), copy(text), line, f->n, note };
    if (one.file == NULL || one.text == NULL || !array_append(&f->list, (size_t)f->n, sizeof one)) {
        free_diagnostic(&one);
        f->failed = true;
        return;
    }
    f->list[f->n++] = one;
    f->notes += note;
}

void diagnostics_add(struct diagnostics *f, const char *file, int line, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    add(f, file, line, false, format, args);
    va_end(args);
}

void diagnostics_note(struct diagnostics *f, const char *file, int line, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    add(f, file, line, true, format, args);
    va_end(args);
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

bool diagnostics_misses(const struct diagnostics *f, const char *file, int line, const char *name)
{
    for (int i = 0; i < f->n; i++) {
        const struct diagnostic *one = &f->list[i];
        if (one->line == line && strcmp(one->file, file) == 0 && strstr(one->text, name) != NULL &&
            (strstr(one->text, "has no ") || strstr(one->text, "is not available") ||
             strstr(one->text, "undeclared global")))
            return true;
    }
    return false;
}

static int compare_diagnostics(const void *a, const void *b)
{
    const struct diagnostic *p = a, *q = b;
    int files = strcmp(p->file, q->file);

    if (files != 0)
        return files;
    return p->line != q->line ? (p->line < q->line ? -1 : 1) : p->order - q->order;
}

static bool same_position(const struct diagnostic *a, const struct diagnostic *b)
{
    return a->line == b->line && strcmp(a->file, b->file) == 0;
}

/* Returns whether the text is part of another finding at the same position. Of equal texts, the first remains. */
static bool is_redundant(const struct diagnostics *f, int i)
{
    int first = i;

    while (first > 0 && same_position(&f->list[first - 1], &f->list[i]))
        first--;
    for (int k = first; k < f->n && same_position(&f->list[k], &f->list[i]); k++) {
        const struct diagnostic *other = &f->list[k], *one = &f->list[i];
        if (k == i || other->note > one->note || strstr(other->text, one->text) == NULL)
            continue;
        if (k < i || other->note < one->note || strcmp(other->text, one->text) != 0)
            return true;
    }
    return false;
}

void diagnostics_sort(struct diagnostics *f)
{
    int n = 0;

    if (f->n > 0)
        qsort(f->list, (size_t)f->n, sizeof f->list[0], compare_diagnostics);
    for (int i = 0; i < f->n; i++)
        f->list[i].order = is_redundant(f, i);
    for (int i = 0; i < f->n; i++) {
        if (f->list[i].order) {
            f->notes -= f->list[i].note;
            free_diagnostic(&f->list[i]);
        } else {
            f->list[n++] = f->list[i];
        }
    }
    f->n = n;
}

/* Returns whether the text starts with a column, as for MML. */
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
            snprintf(text, sizeof text, "%s:%d:%s%s%s", one->file, one->line, has_column(one->text) ? "" : " ",
                     one->note ? "note: " : "", one->text);
        else
            snprintf(text, sizeof text, "%s: %s%s", one->file, one->note ? "note: " : "", one->text);
        clean_line(text);
        line(text);
    }
}

void diagnostics_close(struct diagnostics *f)
{
    for (int i = 0; i < f->n; i++)
        free_diagnostic(&f->list[i]);
    free(f->list);
    *f = (struct diagnostics){ 0 };
}
