/*
 * bisect.c - see bisect.h.
 *
 * Both files are read in parallel. In traces, the lines of a frame are merged: each part starts with its registers, so
 * a slot's line has no partner if the next line of the other file belongs to a later slot, part or frame.
 */
#include "bisect.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../common/clean.h"
#include "../../common/files.h"
#include "../../demo/demo.h"
#include "../../common/report.h"

enum {
    LINE = 1 << 16,
    MOST = 40, /* differences that are printed */
    HASH_DIGITS = 16,
    NAMES = 512
};

/* A file, and the line it is at. */
struct side {
    const char *path; /* for messages */
    FILE *file;
    unsigned long line;
    bool trace; /* otherwise a track */
    bool end;
    uint32_t frame;
    char part[32];   /* of a trace */
    int64_t slot;    /* -1: registers */
    const char *gen; /* "-" of a list */
    char *values;    /* "COLUMN=... COLUMN=..." of a trace, "HASH PART=HASH ..." of a track */
    char *text;      /* LINE bytes; the others point into it */
};

struct bisect {
    struct side a, b;
    uint32_t first;  /* frame of the first line */
    uint32_t frame;  /* the last frame looked at */
    uint32_t frames; /* number of frames */
    unsigned long found;
    char err[2200];
};

/* ---- lines ---- */

static bool all_of(const char *p, size_t n, const char *set)
{
    return n > 0 && strspn(p, set) >= n;
}

/* Ends the word at *p at its blank, and moves *p after it. */
static char *take_word(char **p)
{
    char *word = *p, *blank = strchr(word, ' ');

    *p = blank ? blank + 1 : word + strlen(word);
    if (blank)
        *blank = 0;
    return word;
}

static bool take_number(const char *word, uint32_t *out)
{
    size_t n = strlen(word);
    unsigned long long v = n <= 10 && all_of(word, n, "0123456789") ? strtoull(word, NULL, 10) : UINT64_MAX;

    *out = (uint32_t)v;
    return v <= UINT32_MAX;
}

/* Returns the value in NAME=VALUE, with its length in *n; NULL: no such name. */
static const char *value_of(const char *values, const char *name, size_t name_n, size_t *n)
{
    for (const char *p = values; *p;) {
        size_t word = strcspn(p, " ");
        if (word > name_n && p[name_n] == '=' && memcmp(p, name, name_n) == 0) {
            *n = word - name_n - 1;
            return p + name_n + 1;
        }
        p += word + (p[word] == ' ');
    }
    return NULL;
}

/* Returns whether all words are NAME=VALUE, with unique names and values of the characters in `set`. */
static bool good_values(const char *p, const char *set)
{
    const char *values = p;

    while (*p) {
        size_t name = strspn(p, "abcdefghijklmnopqrstuvwxyz0123456789_"), n;
        if (name == 0 || p[name] != '=' || value_of(values, p, name, &n) != p + name + 1)
            return false;
        p += name + 1;
        n = strcspn(p, " ");
        if (!all_of(p, n, set))
            return false;
        p += n;
        if (*p == ' ' && *++p == 0)
            return false;
    }
    return true;
}

static bool is_hash(const char *p)
{
    return all_of(p, HASH_DIGITS, "0123456789abcdef") && (p[HASH_DIGITS] == ' ' || p[HASH_DIGITS] == 0);
}

static bool parse_track(struct side *f, char *p)
{
    f->values = p;
    return is_hash(p) &&
           (!p[HASH_DIGITS] || (p[HASH_DIGITS + 1] && good_values(p + HASH_DIGITS + 1, "0123456789abcdef")));
}

static bool parse_trace(struct side *f, char *p)
{
    const char *part = take_word(&p), *slot = take_word(&p);
    uint32_t number = 0;

    f->gen = take_word(&p);
    f->values = p;
    f->slot = -1;
    snprintf(f->part, sizeof f->part, "%s", part);
    if (strcmp(slot, "-") != 0) {
        if (!take_number(slot, &number))
            return false;
        f->slot = number;
    }
    return all_of(part, strlen(part), "abcdefghijklmnopqrstuvwxyz0123456789_") && strlen(part) < sizeof f->part &&
           all_of(f->gen, strlen(f->gen), "-0123456789") && *p && good_values(p, "0123456789abcdef,()-");
}

/* Returns whether the line follows the one before; in a trace, the one of the same part. */
static bool in_order(const struct side *now, const struct side *before)
{
    if (before->line == 0)
        return !now->trace || now->slot < 0;
    if (now->trace != before->trace || now->frame < before->frame)
        return false;
    if (!now->trace || now->frame > before->frame)
        return now->frame > before->frame && (!now->trace || now->slot < 0);
    return now->slot < 0 || (now->slot > before->slot && strcmp(now->part, before->part) == 0);
}

static bool read_failed(struct bisect *s, struct side *f)
{
    if (ferror(f->file))
        return err_set(s->err, sizeof s->err, "%s: cannot be read", f->path);
    f->end = true;
    return f->line > 0 || err_set(s->err, sizeof s->err, "%s: empty", f->path);
}

static bool next(struct bisect *s, struct side *f)
{
    struct side before = *f;
    size_t n;

    if (f->end)
        return true;
    if (!fgets(f->text, LINE, f->file))
        return read_failed(s, f);
    n = strlen(f->text);
    if (f->line++ == 0)
        files_strip_bom(f->text, &n);
    if (n == 0 || f->text[n - 1] != '\n')
        return err_set(s->err, sizeof s->err, "%s:%lu: truncated line", f->path, f->line);
    f->text[n - 1] = 0;
    char *p = f->text;
    bool number = take_number(take_word(&p), &f->frame);
    f->trace = !is_hash(p);
    if (!number || !(f->trace ? parse_trace(f, p) : parse_track(f, p)))
        return err_set(s->err, sizeof s->err, "%s:%lu: expected a line printed by \"hash\" or \"hash --trace\"",
                       f->path, f->line);
    if (!in_order(f, &before))
        return err_set(s->err, sizeof s->err, "%s:%lu: out of order", f->path, f->line);
    return true;
}

static bool next_both(struct bisect *s)
{
    return next(s, &s->a) && next(s, &s->b);
}

/* ---- differences ---- */

/* Counts a difference, and prints the frame of the first; false: enough have been printed. */
static bool found(struct bisect *s, uint32_t frame)
{
    if (s->found == 0)
        report_print("first difference: frame %u\n", (unsigned)frame);
    return s->found++ < MOST;
}

static void name_slot(const struct side *f)
{
    report_print("  %s", f->part);
    if (f->slot >= 0)
        report_print(" %lld", (long long)f->slot);
}

/* Prints a difference of a column, or of its i-th value if it has several; an empty value is zero. */
static void differ(struct bisect *s, const struct side *f, const char *column, int column_n, int i, bool several,
                   const char *a, int a_n, const char *b, int b_n)
{
    if (!found(s, f->frame))
        return;
    name_slot(f);
    report_print(" %.*s", column_n, column);
    if (several)
        report_print("[%d]", i);
    report_print(": %.*s in %s, %.*s in %s\n", a_n ? a_n : 1, a_n ? a : "0", s->a.path, b_n ? b_n : 1, b_n ? b : "0",
                 s->b.path);
}

/* Compares the values of a column, separated by commas; a missing one (of an empty list entry) is zero. */
static void compare_values(struct bisect *s, const struct side *f, const char *column, int column_n, const char *a,
                           size_t a_n, const char *b, size_t b_n)
{
    bool several = memchr(a, ',', a_n) || memchr(b, ',', b_n);

    for (int i = 0; a_n || b_n; i++) {
        const char *comma_a = memchr(a, ',', a_n), *comma_b = memchr(b, ',', b_n);
        size_t n = comma_a ? (size_t)(comma_a - a) : a_n, m = comma_b ? (size_t)(comma_b - b) : b_n;
        bool zero = (n == 0 && all_of(b, m, "0")) || (m == 0 && all_of(a, n, "0"));
        if (!zero && (n != m || memcmp(a, b, n) != 0))
            differ(s, f, column, column_n, i, several, a, (int)n, b, (int)m);
        a += n + (comma_a != NULL);
        a_n -= n + (comma_a != NULL);
        b += m + (comma_b != NULL);
        b_n -= m + (comma_b != NULL);
    }
}

/* Compares the columns of a line with its partner, or with no values. swapped: the line is b's. */
static void compare_columns(struct bisect *s, const struct side *f, const char *mine, const char *theirs, bool swapped,
                            bool only_missing)
{
    for (const char *p = mine; *p;) {
        size_t word = strcspn(p, " "), name = strcspn(p, "="), n = 0;
        const char *other = value_of(theirs, p, name, &n), *value = p + name + 1;
        size_t value_n = word - name - 1;
        if (!other)
            other = "";
        if (!only_missing || n == 0)
            compare_values(s, f, p, (int)name, swapped ? other : value, swapped ? n : value_n, swapped ? value : other,
                           swapped ? value_n : n);
        p += word + (p[word] == ' ');
    }
}

/* Compares two lines of the same slot, or registers. */
static void compare_lines(struct bisect *s)
{
    const struct side *a = &s->a, *b = &s->b;

    if (strcmp(a->gen, b->gen) != 0)
        differ(s, a, "generation", 10, 0, false, a->gen, (int)strlen(a->gen), b->gen, (int)strlen(b->gen));
    if (strcmp(a->values, b->values) == 0)
        return;
    compare_columns(s, a, a->values, b->values, false, false);
    compare_columns(s, b, b->values, a->values, true, true);
}

/* Prints a slot that is only in one file: alive there, or an entry of a list that is not zero. */
static void compare_alone(struct bisect *s, const struct side *f)
{
    bool b = f == &s->b;

    if (strcmp(f->gen, "-") == 0) {
        compare_columns(s, f, f->values, "", b, false);
        return;
    }
    if (!found(s, f->frame))
        return;
    name_slot(f);
    report_print(" is alive only in %s (generation %s)\n", f->path, f->gen);
}

/* ---- traces ---- */

static bool set_mismatch(struct bisect *s)
{
    const struct side *a = &s->a, *b = &s->b;

    if (a->end || b->end)
        return err_set(s->err, sizeof s->err,
                       "%s ends in frame %u; %s is longer, and the two are equal up to that frame",
                       (a->end ? a : b)->path, (unsigned)s->frame, (a->end ? b : a)->path);
    if (a->frame == b->frame)
        return err_set(s->err, sizeof s->err,
                       "%s:%lu has part %s, but %s:%lu has part %s: the traces cover different parts", a->path, a->line,
                       a->part, b->path, b->line, b->part);
    return err_set(s->err, sizeof s->err,
                   "%s:%lu has frame %u, but %s:%lu has frame %u: the traces cover different frames", a->path, a->line,
                   (unsigned)a->frame, b->path, b->line, (unsigned)b->frame);
}

/* Returns whether a slot's line has no partner: the next line of the other file is of a later slot, part or frame. */
static bool is_alone(const struct bisect *s, const struct side *f, const struct side *other)
{
    if (f->end || f->slot < 0 || f->frame != s->frame)
        return false;
    return other->end || other->frame > f->frame || other->slot < 0 || other->slot > f->slot;
}

/* Returns whether both lines are of the same part and slot. */
static bool partners(const struct side *a, const struct side *b)
{
    return !a->end && !b->end && a->frame == b->frame && a->slot == b->slot && strcmp(a->part, b->part) == 0;
}

static bool is_over(const struct bisect *s)
{
    const struct side *a = &s->a, *b = &s->b;

    if (a->end && b->end)
        return true;
    return s->found && (a->end || a->frame > s->frame) && (b->end || b->frame > s->frame);
}

static void enter_frame(struct bisect *s, uint32_t frame)
{
    if (s->frames && frame == s->frame)
        return;
    s->first = s->frames ? s->first : frame;
    s->frame = frame;
    s->frames++;
}

static bool compare_traces(struct bisect *s)
{
    while (!is_over(s)) {
        bool ok;
        if (is_alone(s, &s->a, &s->b)) {
            compare_alone(s, &s->a);
            ok = next(s, &s->a);
        } else if (is_alone(s, &s->b, &s->a)) {
            compare_alone(s, &s->b);
            ok = next(s, &s->b);
        } else if (partners(&s->a, &s->b)) {
            enter_frame(s, s->a.frame);
            compare_lines(s);
            ok = next_both(s);
        } else {
            return s->found ? true : set_mismatch(s);
        }
        if (!ok)
            return false;
    }
    return true;
}

/* ---- tracks ---- */

static void add_name(char *names, size_t size, const char *name, size_t n)
{
    size_t at = strlen(names);

    snprintf(names + at, size - at, "%s%.*s", at ? "," : "", (int)n, name);
}

/* Compares the parts of one line with those of the other; adds the names of different parts to `names`. */
static void compare_parts(struct bisect *s, const struct side *mine, const struct side *theirs, bool only_missing,
                          char *names)
{
    const char *other = theirs->values + HASH_DIGITS;

    for (const char *p = mine->values + HASH_DIGITS; *p == ' ';) {
        size_t word = strcspn(++p, " "), name = strcspn(p, "="), n = 0;
        const char *hash = p + name + 1, *against = value_of(other + (*other == ' '), p, name, &n);
        bool same = against && n == word - name - 1 && memcmp(hash, against, n) == 0;
        if (!same && !(against && only_missing)) {
            add_name(names, NAMES, p, name);
            s->found++;
            report_print("  %.*s: %.*s in %s, %.*s in %s\n", (int)name, p, (int)(word - name - 1), hash, mine->path,
                         against ? (int)n : 7, against ? against : "missing", theirs->path);
        }
        p += word;
    }
}

static void compare_rows(struct bisect *s)
{
    char names[NAMES] = "";

    report_print("first difference: frame %u\n", (unsigned)s->frame);
    compare_parts(s, &s->a, &s->b, false, names);
    compare_parts(s, &s->b, &s->a, true, names);
    if (s->found == 0) {
        s->found = 1;
        report_print("  %.*s in %s, %.*s in %s; use hash --parts to compare parts\n", HASH_DIGITS, s->a.values,
                     s->a.path, HASH_DIGITS, s->b.values, s->b.path);
        return;
    }
    report_print("to compare columns and slots, run in both builds: hash ROM --demo DEMO --trace %s --frames %u:%u\n",
                 names, (unsigned)(s->frame ? s->frame - 1 : 0), (unsigned)s->frame);
}

static bool compare_tracks(struct bisect *s)
{
    while (!s->a.end && !s->b.end) {
        if (s->a.frame != s->b.frame)
            return set_mismatch(s);
        enter_frame(s, s->a.frame);
        if (strcmp(s->a.values, s->b.values) != 0) {
            compare_rows(s);
            return true;
        }
        if (!next_both(s))
            return false;
    }
    return (s->a.end && s->b.end) || set_mismatch(s);
}

/* ---- files ---- */

static bool compare(struct bisect *s)
{
    if (!next_both(s))
        return false;
    if (s->a.trace != s->b.trace)
        return err_set(s->err, sizeof s->err, "%s is a %s, %s a %s", s->a.path, s->a.trace ? "trace" : "track",
                       s->b.path, s->b.trace ? "trace" : "track");
    return s->a.trace ? compare_traces(s) : compare_tracks(s);
}

static enum result print_report(const struct bisect *s)
{
    if (s->found > MOST)
        report_print("  and %lu more\n", s->found - MOST);
    if (s->found && s->a.end != s->b.end)
        report_print("  (%s ends in this frame: it may be truncated)\n", (s->a.end ? &s->a : &s->b)->path);
    if (s->found == 0)
        report_print("%s and %s are equal: %u frames, %u to %u\n", s->a.path, s->b.path, (unsigned)s->frames,
                     (unsigned)s->first, (unsigned)s->frame);
    return s->found ? RESULT_DIFFERS : RESULT_DONE;
}

/* Returns a path for printing. */
static const char *shown(char out[DEMO_PATH_SIZE], const char *path)
{
    snprintf(out, DEMO_PATH_SIZE, "%s", path);
    clean_line(out);
    return out;
}

enum result bisect_files(FILE *a, const char *a_name, FILE *b, const char *b_name, char *err, size_t err_size)
{
    struct bisect *s = calloc(1, sizeof *s);
    char *lines = malloc((size_t)LINE * 2), names[2][DEMO_PATH_SIZE];
    enum result result = RESULT_HOST_FAILED;

    if (s && lines) {
        s->a = (struct side){ .path = shown(names[0], a_name), .file = a, .text = lines };
        s->b = (struct side){ .path = shown(names[1], b_name), .file = b, .text = lines + LINE };
        result = compare(s) ? print_report(s) : RESULT_REFUSED;
    }
    if (result == RESULT_HOST_FAILED || result == RESULT_REFUSED)
        snprintf(err, err_size, "%s", result == RESULT_REFUSED ? s->err : "out of memory");
    free(lines);
    free(s);
    return result;
}

/* Opens a file; "-" becomes "standard input". */
static FILE *open_input(const char **path)
{
    if (strcmp(*path, "-") != 0)
        return plat_open_stream(*path, false);
    *path = "standard input";
    return stdin;
}

enum result bisect_paths(const char *a, const char *b, char *err, size_t err_size)
{
    FILE *first = open_input(&a), *second = first ? open_input(&b) : NULL;
    enum result result = RESULT_REFUSED;

    if (second)
        result = bisect_files(first, a, second, b, err, err_size);
    else
        snprintf(err, err_size, "%s: %s", first ? b : a, strerror(errno));
    if (first && first != stdin)
        fclose(first);
    if (second && second != stdin)
        fclose(second);
    return result;
}

enum result bisect_command(const struct args *a)
{
    char err[2200];

    if (a->n_words != 2)
        return report_line(RESULT_REFUSED, "verify --bisect: expected two outputs of curtain hash");
    if (strcmp(a->words[0], "-") == 0 && strcmp(a->words[1], "-") == 0)
        return report_line(RESULT_REFUSED, "verify --bisect: only one of the outputs can be standard input");
    enum result result = bisect_paths(a->words[0], a->words[1], err, sizeof err);
    if (result > RESULT_DIFFERS)
        return report_line(result, "%s", err);
    return report_stdout(result);
}
