/*
 * records.c - practice records (records.h). Lines stay in the order of the file, and new records are added at its end.
 */
#include "records.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../common/array.h"
#include "../../common/files.h"
#include "../../common/report.h"

static const char first_line[] = "practice 1";

/* ---- lines ---- */

static struct records_line *add(struct records *r)
{
    struct records_line *line = array_append(&r->line, (size_t)r->n, sizeof *line);

    if (line) {
        *line = (struct records_line){ 0 };
        r->n++;
    }
    return line;
}

static bool set_other(struct records_line *line, const char *text)
{
    line->other = malloc(strlen(text) + 1);
    if (line->other)
        strcpy(line->other, text);
    return line->other != NULL;
}

static struct record *find(const struct records *r, const char *section, const char *difficulty)
{
    for (int i = 0; i < r->n; i++) {
        struct record *at = &r->line[i].r;
        if (at->section[0] && strcmp(at->section, section) == 0 && strcmp(at->difficulty, difficulty) == 0)
            return at;
    }
    return NULL;
}

const struct record *records_find(const struct records *r, const char *section, const char *difficulty)
{
    return find(r, section, difficulty);
}

void records_free(struct records *r)
{
    for (int i = 0; i < r->n; i++)
        free(r->line[i].other);
    free(r->line);
    *r = (struct records){ 0 };
}

/* ---- reading ---- */

/* Reads a number and the blank after it. Returns -1 if there is none. */
static int32_t read_number(const char **s)
{
    int64_t v = 0;
    size_t n = strspn(*s, "0123456789");

    if (n < 1 || n > 9 || (*s)[n] != ' ')
        return -1;
    for (; **s != ' '; ++*s)
        v = v * 10 + (**s - '0');
    ++*s;
    return (int32_t)v;
}

/* Copies the text up to the next character of `ends`. Returns false if it is empty or too long. */
static bool read_word(const char **s, const char *ends, char *out, size_t size)
{
    size_t n = strcspn(*s, ends);

    if (n < 1 || n >= size)
        return false;
    memcpy(out, *s, n);
    out[n] = 0;
    *s += n;
    return true;
}

static bool read_record(struct record *r, const char *s)
{
    r->captures = read_number(&s);
    r->attempts = read_number(&s);
    return r->captures >= 0 && r->attempts >= r->captures && read_word(&s, " ", r->difficulty, sizeof r->difficulty) &&
           *s++ == ' ' && read_word(&s, "", r->section, sizeof r->section);
}

static bool read_line(struct records *r, const char *s, const char **why)
{
    struct record got = { 0 };
    bool digit = s[0] >= '0' && s[0] <= '9';

    *why = "expected CAPTURES ATTEMPTS DIFFICULTY MARK";
    if (digit && !read_record(&got, s))
        return false;
    *why = "duplicate record for this section";
    if (digit && find(r, got.section, got.difficulty))
        return false;
    *why = "out of memory";
    struct records_line *line = add(r);
    if (!line)
        return false;
    line->r = got;
    return digit || set_other(line, s);
}

/* Copies a line of n bytes. Returns false if it is too long or not printable ASCII. */
static bool plain_line(const char *text, size_t n, char out[RECORDS_LINE])
{
    if (n >= RECORDS_LINE)
        return false;
    for (size_t i = 0; i < n; i++)
        if (text[i] < 32 || text[i] > 126)
            return false;
    memcpy(out, text, n);
    out[n] = 0;
    return true;
}

static bool read_lines(struct records *r, const char *text, size_t size, int *at, const char **why)
{
    char line[RECORDS_LINE];

    for (size_t i = 0; i < size; ++*at) {
        const char *end = memchr(text + i, '\n', size - i);
        *why = "truncated";
        if (!end)
            return false;
        size_t n = (size_t)(end - (text + i));
        *why = "expected a line of text";
        if (!plain_line(text + i, n, line))
            return false;
        *why = "expected \"practice 1\"";
        if (*at == 1 ? strcmp(line, first_line) != 0 : !read_line(r, line, why))
            return false;
        i += n + 1;
    }
    *why = "empty";
    return size > 0;
}

bool records_read(struct records *r, const char *text, size_t size, char *err, size_t err_size)
{
    const char *why;
    int at = 1;

    *r = (struct records){ 0 };
    if (read_lines(r, text, size, &at, &why))
        return true;
    records_free(r);
    return err_set(err, err_size, "line %d: %s", at, why);
}

/* ---- writing ---- */

char *records_text(const struct records *r, size_t *size)
{
    size_t room = sizeof first_line + 1 + (size_t)r->n * RECORDS_LINE, n;
    char *text = malloc(room);

    if (!text)
        return NULL;
    n = (size_t)snprintf(text, room, "%s\n", first_line);
    for (int i = 0; i < r->n; i++) {
        const struct record *at = &r->line[i].r;
        if (r->line[i].other)
            n += (size_t)snprintf(text + n, room - n, "%s\n", r->line[i].other);
        else
            n += (size_t)snprintf(text + n, room - n, "%d %d %s %s\n", (int)at->captures, (int)at->attempts,
                                  at->difficulty, at->section);
    }
    *size = n;
    return text;
}

/* ---- the file ---- */

void records_load(struct records *r, const char *id)
{
    char file[sizeof r->file], why[FILES_ERR_SIZE], shown[FILES_PATH_SIZE];
    uint8_t *text = NULL;
    size_t size;

    snprintf(file, sizeof file, "user:%s.practice", id);
    *r = (struct records){ 0 };
    bool good = plat_file_size(file) < 0;
    if (!good && !files_read_text(file, file, RECORDS_BYTES, &text, &size, why, sizeof why))
        err_set(why, sizeof why, "cannot be read, or is larger than %d bytes", RECORDS_BYTES);
    else
        good = good || records_read(r, (const char *)text, size, why, sizeof why);
    free(text);
    memcpy(r->file, file, sizeof file);
    r->damaged = !good;
    if (!good)
        report_line(RESULT_DONE, "%s: %s; attempts are not counted, and the file is not changed",
                    files_display_name(file, shown), why);
}

bool records_save(struct records *r, struct unsaved **unsaved, char *err, size_t err_size)
{
    size_t size;

    if (!r->changed || r->damaged)
        return true;
    char *text = records_text(r, &size);
    if (!text)
        return result_set_host_error(err, err_size, "%s: out of memory", r->file);
    r->changed = false;
    const bool good = unsaved_save(unsaved, r->file, text, size, err, err_size);
    free(text);
    return good;
}

/* ---- counting ---- */

static bool fits(const char *section, const char *difficulty)
{
    const struct record *r = NULL;

    return section[0] && difficulty[0] && strlen(section) < sizeof r->section &&
           strlen(difficulty) < sizeof r->difficulty;
}

void records_attempt(struct records *r, const char *section, const char *difficulty)
{
    struct record *at = find(r, section, difficulty);

    if (r->damaged || !fits(section, difficulty))
        return;
    if (!at) {
        struct records_line *line = add(r);
        if (!line)
            return;
        at = &line->r;
        snprintf(at->section, sizeof at->section, "%s", section);
        snprintf(at->difficulty, sizeof at->difficulty, "%s", difficulty);
    }
    if (at->attempts == MAX_RECORD_COUNT)
        return;
    at->attempts++;
    r->changed = true;
}

void records_capture(struct records *r, const char *section, const char *difficulty)
{
    struct record *at = find(r, section, difficulty);

    if (r->damaged || !at || at->captures == at->attempts)
        return;
    at->captures++;
    r->changed = true;
}

/* ---- reached sections ---- */

static const char reached[] = "reached ";

bool records_reached(const struct records *r, const char *section)
{
    const size_t n = sizeof reached - 1;

    for (int i = 0; i < r->n; i++) {
        const char *line = r->line[i].other;
        if (line && strncmp(line, reached, n) == 0 && strcmp(line + n, section) == 0)
            return true;
    }
    return false;
}

void records_reach(struct records *r, const char *section)
{
    char text[RECORDS_LINE];

    if (r->damaged || !section[0] || snprintf(text, sizeof text, "%s%s", reached, section) >= (int)sizeof text ||
        records_reached(r, section))
        return;
    struct records_line *line = add(r);
    if (line && set_other(line, text))
        r->changed = true;
    else
        r->n -= line != NULL;
}
