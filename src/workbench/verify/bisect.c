/*
 * bisect.c - see bisect.h.
 *
 * Both files are read in parallel. In traces, the lines of a frame are merged. Each part starts with its registers, so
 * a slot is missing in the other file if the next line there belongs to a later slot, part or frame.
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
    MAX_PRINTED = 40, /* differences that are printed */
    HASH_DIGITS = 16,
    NAMES = 512
};

/* A file and its current line. */
struct side {
    const char *path; /* for messages */
    FILE *file;
    unsigned long line;
    bool trace; /* otherwise a track */
    bool at_end;
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
    unsigned long count_difference;
    char err[2200];
};

/* ---- lines ---- */

static bool has_only(const char *p, size_t n, const char *set)
{
    return n > 0 && strspn(p, set) >= n;
}

/* Terminates the word at *p, and moves *p past it. */
static char *parse_word(char **p)
{
    char *word = *p, *blank = strchr(word, ' ');

    *p = blank ? blank + 1 : word + strlen(word);
    if (blank)
        *blank = 0;
    return word;
}

static bool parse_number(const char *word, uint32_t *out)
{
    size_t n = strlen(word);
    unsigned long long v = n <= 10 && has_only(word, n, "0123456789") ? strtoull(word, NULL, 10) : UINT64_MAX;

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
static bool valid_values(const char *p, const char *set)
{
    const char *values = p;

    while (*p) {
        size_t name = strspn(p, "abcdefghijklmnopqrstuvwxyz0123456789_"), n;
        if (name == 0 || p[name] != '=' || value_of(values, p, name, &n) != p + name + 1)
            return false;
        p += name + 1;
        n = strcspn(p, " ");
        if (!has_only(p, n, set))
            return false;
        p += n;
        if (*p == ' ' && *++p == 0)
            return false;
    }
    return true;
}

static bool is_hash(const char *p)
{
    return has_only(p, HASH_DIGITS, "0123456789abcdef") && (p[HASH_DIGITS] == ' ' || p[HASH_DIGITS] == 0);
}

static bool parse_track(struct side *f, char *p)
{
    f->values = p;
    return is_hash(p) &&
           (!p[HASH_DIGITS] || (p[HASH_DIGITS + 1] && valid_values(p + HASH_DIGITS + 1, "0123456789abcdef")));
}

static bool parse_trace(struct side *f, char *p)
{
    const char *part = parse_word(&p), *slot = parse_word(&p);
    uint32_t number = 0;

    f->gen = parse_word(&p);
    f->values = p;
    f->slot = -1;
    snprintf(f->part, sizeof f->part, "%s", part);
    if (strcmp(slot, "-") != 0) {
        if (!parse_number(slot, &number))
            return false;
        f->slot = number;
    }
    return has_only(part, strlen(part), "abcdefghijklmnopqrstuvwxyz0123456789_") && strlen(part) < sizeof f->part &&
           has_only(f->gen, strlen(f->gen), "-0123456789") && *p && valid_values(p, "0123456789abcdef,()-");
}

/* Returns whether the line may follow the one before it. */
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
    f->at_end = true;
    return f->line > 0 || err_set(s->err, sizeof s->err, "%s: empty", f->path);
}

static bool next_line(struct bisect *s, struct side *f)
{
    struct side before = *f;
    size_t n;

    if (f->at_end)
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
    bool number = parse_number(parse_word(&p), &f->frame);
    f->trace = !is_hash(p);
    if (!number || !(f->trace ? parse_trace(f, p) : parse_track(f, p)))
        return err_set(s->err, sizeof s->err, "%s:%lu: expected a line printed by \"hash\" or \"hash --trace\"",
                       f->path, f->line);
    if (!in_order(f, &before))
        return err_set(s->err, sizeof s->err, "%s:%lu: out of order", f->path, f->line);
    return true;
}

static bool next_lines(struct bisect *s)
{
    return next_line(s, &s->a) && next_line(s, &s->b);
}

/* ---- differences ---- */

/* Counts a difference, and prints the frame of the first one. False: enough differences have been printed. */
static bool count_difference(struct bisect *s, uint32_t frame)
{
    if (s->count_difference == 0)
        report_print("first difference: frame %u\n", (unsigned)frame);
    return s->count_difference++ < MAX_PRINTED;
}

static void print_slot(const struct side *f)
{
    report_print("  %s", f->part);
    if (f->slot >= 0)
        report_print(" %lld", (long long)f->slot);
}

/* Prints a difference in a column, or in its i-th value if it has several. An empty value is zero. */
static void print_difference(struct bisect *s, const struct side *f, const char *column, int column_n, int i,
                             bool several, const char *a, int a_n, const char *b, int b_n)
{
    if (!count_difference(s, f->frame))
        return;
    print_slot(f);
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
        bool zero = (n == 0 && has_only(b, m, "0")) || (m == 0 && has_only(a, n, "0"));
        if (!zero && (n != m || memcmp(a, b, n) != 0))
            print_difference(s, f, column, column_n, i, several, a, (int)n, b, (int)m);
        a += n + (comma_a != NULL);
        a_n -= n + (comma_a != NULL);
        b += m + (comma_b != NULL);
        b_n -= m + (comma_b != NULL);
    }
}

/* Compares the columns of two lines; `theirs` may be empty. swapped: `mine` is from file b. */
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

/* Compares two lines of the same slot, or of registers. */
static void compare_lines(struct bisect *s)
{
    const struct side *a = &s->a, *b = &s->b;

    if (strcmp(a->gen, b->gen) != 0)
        print_difference(s, a, "generation", 10, 0, false, a->gen, (int)strlen(a->gen), b->gen, (int)strlen(b->gen));
    if (strcmp(a->values, b->values) == 0)
        return;
    compare_columns(s, a, a->values, b->values, false, false);
    compare_columns(s, b, b->values, a->values, true, true);
}

/* Prints a slot that is only in one file: a live slot, or a list entry that is not zero. */
static void print_unpaired(struct bisect *s, const struct side *f)
{
    bool b = f == &s->b;

    if (strcmp(f->gen, "-") == 0) {
        compare_columns(s, f, f->values, "", b, false);
        return;
    }
    if (!count_difference(s, f->frame))
        return;
    print_slot(f);
    report_print(" is alive only in %s (generation %s)\n", f->path, f->gen);
}

/* ---- traces ---- */

static bool set_mismatch(struct bisect *s)
{
    const struct side *a = &s->a, *b = &s->b;

    if (a->at_end || b->at_end)
        return err_set(s->err, sizeof s->err,
                       "%s ends in frame %u; %s is longer, and the two are equal up to that frame",
                       (a->at_end ? a : b)->path, (unsigned)s->frame, (a->at_end ? b : a)->path);
    if (a->frame == b->frame)
        return err_set(s->err, sizeof s->err,
                       "%s:%lu has part %s, but %s:%lu has part %s: the traces cover different parts", a->path, a->line,
                       a->part, b->path, b->line, b->part);
    return err_set(s->err, sizeof s->err,
                   "%s:%lu has frame %u, but %s:%lu has frame %u: the traces cover different frames", a->path, a->line,
                   (unsigned)a->frame, b->path, b->line, (unsigned)b->frame);
}

/* Returns whether the other file has no line for this slot: its next line is for a later slot, part or frame. */
static bool is_unpaired(const struct bisect *s, const struct side *f, const struct side *other)
{
    if (f->at_end || f->slot < 0 || f->frame != s->frame)
        return false;
    return other->at_end || other->frame > f->frame || other->slot < 0 || other->slot > f->slot;
}

/* Returns whether both lines are of the same part and slot. */
static bool is_pair(const struct side *a, const struct side *b)
{
    return !a->at_end && !b->at_end && a->frame == b->frame && a->slot == b->slot && strcmp(a->part, b->part) == 0;
}

static bool is_done(const struct bisect *s)
{
    const struct side *a = &s->a, *b = &s->b;

    if (a->at_end && b->at_end)
        return true;
    return s->count_difference && (a->at_end || a->frame > s->frame) && (b->at_end || b->frame > s->frame);
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
    while (!is_done(s)) {
        bool ok;
        if (is_unpaired(s, &s->a, &s->b)) {
            print_unpaired(s, &s->a);
            ok = next_line(s, &s->a);
        } else if (is_unpaired(s, &s->b, &s->a)) {
            print_unpaired(s, &s->b);
            ok = next_line(s, &s->b);
        } else if (is_pair(&s->a, &s->b)) {
            enter_frame(s, s->a.frame);
            compare_lines(s);
            ok = next_lines(s);
        } else {
            return s->count_difference ? true : set_mismatch(s);
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

/* Compares the parts of two lines; appends the names of differing parts to `names`. */
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
            s->count_difference++;
            report_print("  %.*s: %.*s in %s, %.*s in %s\n", (int)name, p, (int)(word - name - 1), hash, mine->path,
                         against ? (int)n : 7, against ? against : "missing", theirs->path);
        }
        p += word;
    }
}

static void compare_track_lines(struct bisect *s)
{
    char names[NAMES] = "";

    report_print("first difference: frame %u\n", (unsigned)s->frame);
    compare_parts(s, &s->a, &s->b, false, names);
    compare_parts(s, &s->b, &s->a, true, names);
    if (s->count_difference == 0) {
        s->count_difference = 1;
        report_print("  %.*s in %s, %.*s in %s; use hash --parts to compare parts\n", HASH_DIGITS, s->a.values,
                     s->a.path, HASH_DIGITS, s->b.values, s->b.path);
        return;
    }
    report_print("to compare columns and slots, run in both builds: hash ROM --demo DEMO --trace %s --frames %u:%u\n",
                 names, (unsigned)(s->frame ? s->frame - 1 : 0), (unsigned)s->frame);
}

static bool compare_tracks(struct bisect *s)
{
    while (!s->a.at_end && !s->b.at_end) {
        if (s->a.frame != s->b.frame)
            return set_mismatch(s);
        enter_frame(s, s->a.frame);
        if (strcmp(s->a.values, s->b.values) != 0) {
            compare_track_lines(s);
            return true;
        }
        if (!next_lines(s))
            return false;
    }
    return (s->a.at_end && s->b.at_end) || set_mismatch(s);
}

/* ---- files ---- */

static bool compare(struct bisect *s)
{
    if (!next_lines(s))
        return false;
    if (s->a.trace != s->b.trace)
        return err_set(s->err, sizeof s->err, "%s is a %s, %s a %s", s->a.path, s->a.trace ? "trace" : "track",
                       s->b.path, s->b.trace ? "trace" : "track");
    return s->a.trace ? compare_traces(s) : compare_tracks(s);
}

static enum result print_report(const struct bisect *s)
{
    if (s->count_difference > MAX_PRINTED)
        report_print("  and %lu more\n", s->count_difference - MAX_PRINTED);
    if (s->count_difference && s->a.at_end != s->b.at_end)
        report_print("  (%s ends in this frame: it may be truncated)\n", (s->a.at_end ? &s->a : &s->b)->path);
    if (s->count_difference == 0)
        report_print("%s and %s are equal: %u frames, %u to %u\n", s->a.path, s->b.path, (unsigned)s->frames,
                     (unsigned)s->first, (unsigned)s->frame);
    return s->count_difference ? RESULT_DIFFERS : RESULT_DONE;
}

/* Returns a path for printing. */
static const char *printable_path(char out[DEMO_PATH_SIZE], const char *path)
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
        s->a = (struct side){ .path = printable_path(names[0], a_name), .file = a, .text = lines };
        s->b = (struct side){ .path = printable_path(names[1], b_name), .file = b, .text = lines + LINE };
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
