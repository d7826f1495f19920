/*
 * testing.c - see testing.h. Tests end in any order, and are reported in the order of their names.
 */
#include "testing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../common/byte_buffer.h"
#include "../../common/clock.h"
#include "../../base/edit.h"
#include "../../common/files.h"
#include "../../common/progress.h"
#include "../../common/report.h"
#include "../../common/tree.h"
#include "demo_test.h"
#include "golden.h"
#include "reporter.h"
#include "test_script.h"

struct test_suite {
    const struct testing *t;
    struct test *tests;
    int n, done, reported;
    int width;
    bool no_memory;
    struct sums sums;
};

/* ---- choosing tests ---- */

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

/* Returns whether a word of the command line names the test: its whole name, or its file's name, or that without the
 * ending. */
static bool is_named(const char *name, const char *word)
{
    const char *base = strrchr(name, '/') + 1, *dot = strrchr(base, '.');

    return !strcmp(name, word) || !strcmp(base, word) ||
           (strlen(word) == (size_t)(dot - base) && !strncmp(base, word, strlen(word)));
}

static enum result unknown_test(const struct test_suite *a, const struct tree *files, const char *word)
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

/* Returns the first word of the command line that names no test, or NULL. */
static const char *unknown_word(const struct testing *t, const struct tree *files)
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

/* Lists the wanted tests; their names belong to `files`. */
static enum result choose(struct test_suite *a, const struct tree *files)
{
    const char *word = unknown_word(a->t, files);

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
        a->tests[a->n++] =
            (struct test){ .name = files->name[i], .is_script = files_has_suffix(files->name[i], ".lua") };
        a->width = width > a->width ? width : a->width;
    }
    a->sums.tests = a->n;
    return RESULT_DONE;
}

/* ---- tests/failed ---- */

static void add_picture(void *files, const struct plat_folder_entry *file)
{
    const bool ours = files_has_suffix(file->name, ".expected.png") || files_has_suffix(file->name, ".got.png") ||
                      files_has_suffix(file->name, ".difference.png");

    if (!file->is_folder && ours)
        tree_add(files, FAILED, file->name);
}

/* Lists the pictures in tests/failed that a run wrote. */
static void list_pictures(const struct testing *t, struct tree *files)
{
    char path[TREE_PATH];

    if (tree_join(path, t->dir, FAILED))
        plat_list(path, add_picture, files);
}

/* Removes the pictures of earlier runs, and no other files. */
static void clear_failed(const struct testing *t)
{
    struct tree files = { 0 };
    char path[TREE_PATH];

    list_pictures(t, &files);
    for (int i = 0; i < files.n; i++)
        if (tree_join(path, t->dir, files.name[i]))
            plat_remove(path);
    tree_close(&files);
}

static void print_failed(const struct testing *t)
{
    struct tree files = { 0 };

    list_pictures(t, &files);
    if (files.n > 0)
        report_print("%spictures: %s/" FAILED "\n", t->args->tap ? "# " : "", t->dir);
    tree_close(&files);
}

/* Keeps the pictures out of Git. */
static void write_gitignore(const struct testing *t)
{
    static const char ignore[] = "*\n";
    char path[TREE_PATH];

    if (tree_join(path, t->dir, FAILED "/.gitignore") && plat_file_size(path) < 0)
        plat_save(path, ignore, sizeof ignore - 1);
}

/* ---- running ---- */

static void run_test(void *context, int i, FILE *out)
{
    const struct test_suite *a = context;
    const struct test *t = &a->tests[i];

    (t->is_script ? test_script_run : demo_test_run)(a->t, t->name, out);
}

/* Searches a test's lines for a file in tests/golden. */
struct golden_search {
    const char *file;
    bool found;
};

static void match_golden(void *context, const char *file)
{
    struct golden_search *search = context;

    search->found |= strcmp(file, search->file) == 0;
}

static bool uses_golden(const struct test *t, const char *file)
{
    struct golden_search search = { .file = file };

    outcome_each(t, LINE_GOLDEN, match_golden, &search);
    return search.found;
}

struct shared_check {
    struct test_suite *a;
    int i;
};

/* Fails test i for each earlier test that uses the same file: with --update, they would overwrite each other's. */
static void check_shared(void *context, const char *file)
{
    const struct shared_check *s = context;
    struct test_suite *a = s->a;
    char sentence[300];

    for (int k = 0; k < s->i; k++) {
        if (!uses_golden(&a->tests[k], file))
            continue;
        snprintf(sentence, sizeof sentence, "%.100s is also used by %.100s: tests cannot share pictures and hashes",
                 file, a->tests[k].name);
        a->no_memory |= !outcome_add(&a->tests[s->i], sentence);
    }
}

static void report(struct test_suite *a, int i)
{
    struct shared_check shared_check = { a, i };
    struct test copy = a->tests[i]; /* check_shared adds lines to the test */

    copy.lines = a->tests[i].lines ? strdup(a->tests[i].lines) : NULL;
    if (copy.lines)
        outcome_each(&copy, LINE_GOLDEN, check_shared, &shared_check);
    free(copy.lines);
    const struct test *t = &a->tests[i];
    a->sums.frames += t->frames;
    a->sums.fail += t->verdict != TEST_PASSES;
    a->sums.host += t->verdict == TEST_HOST_ERROR;
    progress_clear();
    if (a->t->args->tap)
        reporter_tap(t, i + 1);
    else
        reporter_line(t, a->width);
    fflush(stdout);
}

static void test_done(void *context, int i, const char *lines, size_t n, int signal)
{
    struct test_suite *a = context;

    a->done++;
    a->no_memory |= !outcome_read(&a->tests[i], lines, n, signal);
    for (; a->reported < a->n && a->tests[a->reported].done; a->reported++)
        report(a, a->reported);
}

static void show_progress(void *context)
{
    struct test_suite *a = context;

    if (a->done < a->n)
        progress_update((uint64_t)a->done, (uint64_t)a->n, "%d of %d tests done", a->done, a->n);
}

/* ---- reports ---- */

/* Returns false if the file cannot be written; this has been reported. */
static bool write_junit(const struct test_suite *a, const char *path)
{
    char err[FILES_ERR_SIZE] = "";
    struct byte_buffer text = { 0 };

    reporter_junit(&text, a->t->game->cart.manifest.title, a->tests, &a->sums);
    if (text.failed)
        err_set(err, sizeof err, "%s: out of memory", path);
    else
        files_save(path, text.bytes, text.n, err, sizeof err);
    byte_buffer_close(&text);
    if (err[0])
        report_line(RESULT_HOST_FAILED, "%s", err);
    return !err[0];
}

/* Prints the files in tests/golden that no test used. */
static void print_unused_goldens(const struct test_suite *a)
{
    struct tree files = { 0 };

    list_folder(a->t->dir, GOLDEN, ".png", &files);
    list_folder(a->t->dir, GOLDEN, ".hash", &files);
    tree_sort(&files);
    for (int i = 0; i < files.n; i++) {
        bool used = false;
        for (int k = 0; k < a->n && !used; k++)
            used = uses_golden(&a->tests[k], files.name[i]);
        if (!used)
            report_print("%s%s: not used by any test\n", a->t->args->tap ? "# " : "", files.name[i]);
    }
    tree_close(&files);
}

static enum result write_reports(struct test_suite *a)
{
    const bool fails = a->sums.fail > 0;

    if (!a->t->args->tap)
        reporter_sums(&a->sums);
    if (!fails && a->t->n_names == 0)
        print_unused_goldens(a);
    if (fails) {
        write_gitignore(a->t);
        print_failed(a->t);
    }
    const bool good = !a->t->args->junit || write_junit(a, a->t->args->junit);
    return a->sums.host || !good ? RESULT_HOST_FAILED : fails ? RESULT_DIFFERS : RESULT_DONE;
}

static enum result run_all(struct test_suite *a)
{
    const struct plat_job_callbacks work = {
        .context = a, .run = run_test, .on_done = test_done, .on_wait = show_progress
    };
    const uint64_t start = plat_usec();

    clear_failed(a->t);
    if (a->t->args->tap)
        reporter_tap_plan(a->n);
    progress_begin();
    const bool good = plat_run_jobs(a->n, a->t->args->jobs ? a->t->args->jobs : plat_processor_count(), &work);
    progress_end();
    a->sums.usec = clock_since(start);
    if (!good || a->no_memory)
        return report_line(RESULT_HOST_FAILED,
                           good ? "out of memory" : "test: cannot start a process, or out of memory");
    return write_reports(a);
}

static enum result run_tests(const struct testing *t)
{
    struct test_suite a = { .t = t };
    struct tree files = { 0 };

    list_folder(t->dir, "demos", ".demo", &files);
    list_folder(t->dir, "tests", ".lua", &files);
    tree_sort(&files);
    enum result result = choose(&a, &files);
    if (result == RESULT_DONE)
        result = report_stdout(run_all(&a));
    for (int i = 0; i < a.n; i++)
        free(a.tests[i].lines);
    free(a.tests);
    tree_close(&files);
    return result;
}

/* ---- the command ---- */

enum result testing_command(const struct args *a)
{
    struct game *g = calloc(1, sizeof *g);
    const struct testing t = {
        .dir = a->words[0], .game = g, .args = a, .names = a->words + 1, .n_names = a->n_words - 1
    };
    char err[1024];
    enum result result;

    if (!g)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    if (plat_file_size(t.dir) >= 0)
        result = report_line(RESULT_REFUSED, "%s: expected a game's folder, got a file", t.dir);
    else if (!game_open(g, t.dir, a, err, sizeof err))
        result = report_error(err);
    else
        result = run_tests(&t);
    game_close(g);
    free(g);
    return result;
}
