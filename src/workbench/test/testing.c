/*
 * testing.c - see testing.h. Tests end in any order and are told in theirs.
 */
#include "testing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/clock.h"
#include "../../base/edit.h"
#include "../../common/files.h"
#include "../../common/progress.h"
#include "../../common/report.h"
#include "../../common/tree.h"
#include "golden.h"
#include "one.h"
#include "page.h"

struct all {
    const struct testing *t;
    struct test *tests;
    int n, over, told; /* over: of them all, those that are done */
    int width;
    bool no_memory;
    struct sums sums;
};

/* ---- which there are ---- */

struct listing {
    struct tree *files;
    const char *folder, *ending;
};

static void list_file(void *user, const struct plat_folder_entry *file)
{
    struct listing *l = user;

    if (!file->is_folder && file->name[0] != '.' && files_has_suffix(file->name, l->ending))
        tree_add(l->files, l->folder, file->name);
}

static void list_folder(const char *dir, const char *folder, const char *ending, struct tree *files)
{
    struct listing l = { files, folder, ending };
    char path[TREE_PATH];

    if (tree_join(path, dir, folder))
        plat_list(path, list_file, &l);
}

/* Does a word of the command line name it? The whole name, or the file's with or without its ending. */
static bool is_named(const char *name, const char *word)
{
    const char *base = strrchr(name, '/') + 1, *dot = strrchr(base, '.');

    return !strcmp(name, word) || !strcmp(base, word) ||
           (strlen(word) == (size_t)(dot - base) && !strncmp(base, word, strlen(word)));
}

static enum result unknown_test(const struct all *a, const struct tree *files, const char *word)
{
    const char *near = NULL;
    int best = EDIT_TOO_FAR;
    char stem[TREE_PATH];

    for (int i = 0; i < files->n; i++) {
        const char *base = strrchr(files->name[i], '/') + 1;
        snprintf(stem, sizeof stem, "%.*s", (int)strcspn(base, "."), base);
        if (edit_distance(word, stem) < best) {
            best = edit_distance(word, stem);
            near = files->name[i];
        }
    }
    if (near)
        return report_line(RESULT_REFUSED, "test: %s has no test \"%s\" (did you mean %s?)", a->t->dir, word, near);
    return report_line(RESULT_REFUSED, "test: %s has no test \"%s\" (tests are demos/*.demo and tests/*.lua)",
                       a->t->dir, word);
}

static bool is_wanted(const struct testing *t, const char *name)
{
    for (int i = 0; i < t->n_names; i++)
        if (is_named(name, t->names[i]))
            return true;
    return t->n_names == 0;
}

/* The first word that names nothing, or NULL. */
static const char *nobody(const struct testing *t, const struct tree *files)
{
    for (int i = 0; i < t->n_names; i++) {
        bool found = false;
        for (int k = 0; k < files->n && !found; k++)
            found = is_named(files->name[k], t->names[i]);
        if (!found)
            return t->names[i];
    }
    return NULL;
}

/* The tests of the files that are wanted; their names are the files' own. */
static enum result choose(struct all *a, const struct tree *files)
{
    const char *word = nobody(a->t, files);

    if (files->failed)
        return report_line(RESULT_HOST_FAILED, "%s: %s", a->t->dir, tree_failed(files));
    if (files->n <= 0)
        return report_line(RESULT_REFUSED, "%s: no tests: no demos/*.demo and no tests/*.lua (see curtain help test)",
                           a->t->dir);
    if (word)
        return unknown_test(a, files, word);
    a->tests = calloc((size_t)files->n, sizeof *a->tests);
    if (!a->tests)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    for (int i = 0; i < files->n; i++) {
        if (!is_wanted(a->t, files->name[i]))
            continue;
        const int width = (int)strlen(files->name[i]);
        a->tests[a->n++] = (struct test){ .name = files->name[i], .script = files_has_suffix(files->name[i], ".lua") };
        a->width = width > a->width ? width : a->width;
    }
    a->sums.tests = a->n;
    return RESULT_DONE;
}

/* ---- the folder of what failed ---- */

struct stale {
    const char *dir;
    struct tree files;
};

static void list_stale(void *user, const struct plat_folder_entry *file)
{
    struct stale *s = user;
    const bool ours = files_has_suffix(file->name, ".expected.png") || files_has_suffix(file->name, ".got.png") ||
                      files_has_suffix(file->name, ".difference.png") || !strcmp(file->name, "failed.html");

    if (!file->is_folder && ours)
        tree_add(&s->files, FAILED, file->name);
}

/* What an earlier run has left goes, and nothing else: the folder shows the newest. */
static void clear_failed(const struct testing *t)
{
    struct stale s = { .dir = t->dir };
    char path[TREE_PATH];

    if (tree_join(path, t->dir, FAILED))
        plat_list(path, list_stale, &s);
    for (int i = 0; i < s.files.n; i++)
        if (tree_join(path, t->dir, s.files.name[i]))
            plat_remove(path);
    tree_close(&s.files);
}

/* What is made for looking at is nothing to be committed. */
static void ignore_failed(const struct testing *t)
{
    static const char ignore[] = "*\n";
    char path[TREE_PATH];

    if (tree_join(path, t->dir, FAILED "/.gitignore") && plat_file_size(path) < 0)
        plat_save(path, ignore, sizeof ignore - 1);
}

/* ---- running ---- */

static void do_one(void *context, int i, FILE *out)
{
    const struct all *a = context;
    const struct test *t = &a->tests[i];

    (t->script ? one_script : one_demo)(a->t, t->name, out);
}

/* Has an earlier test taken that file? Two of them would overwrite each other's. */
struct taken {
    struct all *a;
    int i, by;
    const char *words;
};

static void is_taken(void *context, const char *words)
{
    struct taken *t = context;

    t->by = strcmp(words, t->words) == 0 ? t->i : t->by;
}

static void look_for_taken(void *context, const char *words)
{
    struct taken *mine = context;
    struct all *a = mine->a;
    char sentence[300];

    for (int k = 0; k < mine->i; k++) {
        struct taken other = { .a = a, .i = k, .by = -1, .words = words };
        outcome_each(&a->tests[k], SAYS_TAKEN, is_taken, &other);
        if (other.by < 0)
            continue;
        snprintf(sentence, sizeof sentence, "%.100s is also used by %.100s: tests cannot share pictures and hashes",
                 words, a->tests[k].name);
        a->no_memory |= !outcome_add(&a->tests[mine->i], sentence);
    }
}

static void tell(struct all *a, int i)
{
    struct taken mine = { .a = a, .i = i };
    struct test copy = a->tests[i]; /* its lines grow while they are read */

    copy.said = a->tests[i].said ? strdup(a->tests[i].said) : NULL;
    if (copy.said)
        outcome_each(&copy, SAYS_TAKEN, look_for_taken, &mine);
    free(copy.said);
    const struct test *t = &a->tests[i];
    a->sums.frames += t->frames;
    a->sums.fail += t->verdict != TEST_HOLDS;
    a->sums.host += t->verdict == TEST_HOST;
    progress_wipe();
    if (a->t->tap)
        reporter_tap(t, i + 1);
    else
        reporter_line(t, a->width);
    fflush(stdout);
}

static void done(void *context, int i, const char *said, size_t n, int signal)
{
    struct all *a = context;

    a->over++;
    a->no_memory |= !outcome_take(&a->tests[i], said, n, signal);
    for (; a->told < a->n && a->tests[a->told].done; a->told++)
        tell(a, a->told);
}

static void waits(void *context)
{
    struct all *a = context;

    if (a->over < a->n)
        progress_tell((uint64_t)a->over, (uint64_t)a->n, "%d of %d tests done", a->over, a->n);
}

/* ---- afterwards ---- */

/* A report's file. False: the host is why, and has been told of. */
static bool report_file(const struct all *a, const char *path, void (*write)(FILE *out, const struct all *a))
{
    char err[FILES_ERR_SIZE], *text = NULL;
    FILE *out = plat_open_temp_file();
    bool good = out != NULL;
    long size = -1;

    if (good) {
        write(out, a);
        size = fflush(out) == 0 && !ferror(out) ? ftell(out) : -1;
        rewind(out);
        text = size >= 0 ? malloc((size_t)size + 1) : NULL;
        good = text && fread(text, 1, (size_t)size, out) == (size_t)size;
        fclose(out);
    }
    if (!good)
        report_line(RESULT_HOST_FAILED, "%s: cannot create a temporary file", path);
    else if (!(good = files_save(path, text, (size_t)size, err, sizeof err)))
        report_line(RESULT_HOST_FAILED, "%s", err);
    free(text);
    return good;
}

static const char *title_of(const struct all *a)
{
    return a->t->cart->manifest.title;
}

static void write_page(FILE *out, const struct all *a)
{
    page_write(out, a->t->dir, title_of(a), a->tests, &a->sums);
}

static void write_junit(FILE *out, const struct all *a)
{
    reporter_junit(out, title_of(a), a->tests, &a->sums);
}

struct orphans {
    const struct all *a;
    const char *name;
    bool taken;
};

static void is_orphans(void *context, const char *words)
{
    struct orphans *o = context;

    o->taken |= strcmp(words, o->name) == 0;
}

/* What stands in tests/golden and no test has asked for. */
static void tell_orphans(const struct all *a)
{
    struct tree files = { 0 };

    list_folder(a->t->dir, GOLDEN, ".png", &files);
    list_folder(a->t->dir, GOLDEN, ".hash", &files);
    tree_sort(&files);
    for (int i = 0; i < files.n; i++) {
        struct orphans o = { a, files.name[i], false };
        for (int k = 0; k < a->n && !o.taken; k++)
            outcome_each(&a->tests[k], SAYS_TAKEN, is_orphans, &o);
        if (!o.taken)
            report_print("%s%s: not used by any test\n", a->t->tap ? "# " : "", files.name[i]);
    }
    tree_close(&files);
}

static enum result reports(struct all *a)
{
    char path[TREE_PATH];
    const bool fails = a->sums.fail > 0;
    bool good = true;

    if (!a->t->tap)
        reporter_sums(&a->sums);
    if (!fails && a->t->n_names == 0)
        tell_orphans(a);
    if (fails)
        ignore_failed(a->t);
    if (a->t->junit)
        good = report_file(a, a->t->junit, write_junit) && good;
    if (a->t->page)
        good = report_file(a, a->t->page, write_page) && good;
    else if (fails && tree_join(path, a->t->dir, FAILED "/failed.html") && report_file(a, path, write_page))
        report_print("%spage: %s\n", a->t->tap ? "# " : "", path);
    else
        good = good && !fails;
    return a->sums.host || !good ? RESULT_HOST_FAILED : fails ? RESULT_DIFFERS : RESULT_DONE;
}

static enum result run_all(struct all *a)
{
    const struct plat_job_callbacks work = { .context = a, .run = do_one, .on_done = done, .on_wait = waits };
    const uint64_t begun = plat_usec();

    clear_failed(a->t);
    if (a->t->tap)
        reporter_tap_plan(a->n);
    progress_begin();
    const bool good = plat_run_jobs(a->n, a->t->jobs ? a->t->jobs : plat_processor_count(), &work);
    progress_end();
    a->sums.usec = clock_since(begun);
    if (!good || a->no_memory)
        return report_line(RESULT_HOST_FAILED,
                           good ? "out of memory" : "test: cannot start a process, or out of memory");
    return reports(a);
}

enum result testing_run(const struct testing *t)
{
    struct all a = { .t = t };
    struct tree files = { 0 };

    list_folder(t->dir, "demos", ".demo", &files);
    list_folder(t->dir, "tests", ".lua", &files);
    tree_sort(&files);
    enum result result = choose(&a, &files);
    if (result == RESULT_DONE)
        result = report_stdout(run_all(&a));
    for (int i = 0; i < a.n; i++)
        free(a.tests[i].said);
    free(a.tests);
    tree_close(&files);
    return result;
}

void testing_help(void (*line)(const char *))
{
    line("Test scripts, tests/*.lua, are Lua scripts that can also use these names (docs/guide/27-testing.md):");
    trial_help(line);
}
