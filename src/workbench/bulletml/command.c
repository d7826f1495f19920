/*
 * command.c - see command.h.
 */
#include "command.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../common/clean.h"
#include "../../common/files.h"
#include "../../common/report.h"
#include "as_lua.h"
#include "compile.h"
#include "document.h"

enum { SENTENCE = 1200 };

static void print_line(char *text)
{
    clean_line(text);
    puts(text);
}

static void warn(void *context, const char *sentence)
{
    char text[SENTENCE];

    (void)context;
    snprintf(text, sizeof text, "%s", sentence);
    print_line(text);
}

/* ---- the description ---- */

static int count(const struct document *d, enum document_element element)
{
    int n = 0;

    for (int32_t i = 0; i < d->n; i++)
        n += d->node[i].element == element;
    return n;
}

/* Appends ", 2 actions" or ", 1 bullet". */
static void add_count(char *text, size_t size, int n, const char *what)
{
    const size_t at = strlen(text);

    snprintf(text + at, size - at, ", %d %s%s", n, what, n == 1 ? "" : "s");
}

struct uses {
    bool rand, rank, aims;
    int param; /* the highest, 0: none */
};

static struct uses find_uses(const struct document *d)
{
    struct uses u = { 0 };

    for (int32_t i = 0; i < d->n; i++) {
        const struct document_node *n = &d->node[i];
        u.aims |= n->element == NODE_DIRECTION && (n->type == NODE_PLAIN || n->type == NODE_AIM);
        u.aims |= n->element == NODE_FIRE && document_child(d, i, NODE_DIRECTION) == DOCUMENT_NONE;
        u.param = document_param(n) > u.param ? document_param(n) : u.param;
        for (int k = 0; k < n->ops; k++) {
            u.rand |= n->op[k].kind == EXPRESSION_RAND;
            u.rank |= n->op[k].kind == EXPRESSION_RANK;
        }
    }
    return u;
}

static void add_word(char *text, size_t size, const char *before, const char *word)
{
    const size_t at = strlen(text);

    snprintf(text + at, size - at, "%s%s", at ? ", " : before, word);
}

static void print_uses(const struct document *d)
{
    const struct uses u = find_uses(d);
    char text[160] = "", params[32];

    if (u.aims)
        add_word(text, sizeof text, "  uses ", "the player's position");
    if (u.rank)
        add_word(text, sizeof text, "  uses ", "$rank");
    if (u.rand)
        add_word(text, sizeof text, "  uses ", "$rand");
    snprintf(params, sizeof params, u.param > 1 ? "$1 to $%d" : "$%d", u.param);
    if (u.param)
        add_word(text, sizeof text, "  uses ", params);
    if (d->horizontal)
        add_word(text, sizeof text, "  uses ", "type=\"horizontal\" (left is up)");
    if (text[0])
        puts(text);
}

/* Prints the labels of an element in the order of the document: "  bullets: petal, seed". */
static void print_labels(const struct document *d, enum document_element element, bool tops, const char *head)
{
    size_t size = 64, n = 0;
    char *text = NULL;

    for (int32_t i = 0; i < d->n; i++)
        size += d->node[i].element == element ? strlen(d->node[i].label) + 2 : 0;
    text = malloc(size);
    for (int32_t i = 0; text && i < d->n; i++)
        if (d->node[i].element == element && d->node[i].label[0] && document_is_top(d, i) == tops &&
            document_find(d, element, d->node[i].label) == i)
            n += (size_t)snprintf(text + n, size - n, "%s%s", n ? ", " : head, d->node[i].label);
    if (n)
        print_line(text);
    free(text);
}

static void describe(const struct document *d, const char *file)
{
    char text[FILES_PATH_SIZE];
    int tops = 0;

    for (int32_t i = 0; i < d->n; i++)
        tops += document_is_top(d, i);
    snprintf(text, sizeof text, "%s: %d top action%s", file, tops, tops == 1 ? "" : "s");
    add_count(text, sizeof text, count(d, NODE_ACTION) - tops, "other action");
    add_count(text, sizeof text, count(d, NODE_FIRE), "fire");
    add_count(text, sizeof text, count(d, NODE_BULLET), "bullet");
    add_count(text, sizeof text, d->n, "element");
    print_line(text);
    print_uses(d);
    print_labels(d, NODE_ACTION, true, "  top actions: ");
    print_labels(d, NODE_ACTION, false, "  other actions: ");
    print_labels(d, NODE_FIRE, false, "  fires: ");
    print_labels(d, NODE_BULLET, false, "  bullets: ");
}

/* ---- the command ---- */

static enum result print_lua(const struct document *d, const char *file)
{
    char *script = as_lua(d, file);

    if (!script)
        return report_line(RESULT_HOST_FAILED, "%s: out of memory", file);
    fputs(script, stdout);
    free(script);
    return RESULT_DONE;
}

static enum result process_file(const char *file, bool lua)
{
    char err[SENTENCE];
    uint8_t *text, *program = NULL;
    struct document d;
    size_t size;

    if (files_size(file) < 0)
        return report_line(RESULT_REFUSED, "%s", files_set_missing_error(file, "file", err, sizeof err));
    if (!files_read(file, file, DOCUMENT_MAX_FILE, &text, &size, err, sizeof err))
        return report_error(err);
    enum result result = RESULT_DONE;
    if (!document_read(&d, (const char *)text, size, file, lua ? NULL : warn, NULL, err, sizeof err) ||
        !bulletml_compile(&d, file, &program, &size, err, sizeof err))
        result = report_line(RESULT_REFUSED, "%s", err);
    else if (lua)
        result = print_lua(&d, file);
    else
        describe(&d, file);
    free(program);
    free(text);
    document_free(&d);
    return result;
}

enum result bulletml_command(char *const *files, int n, bool lua)
{
    enum result worst = RESULT_DONE;

    if (lua && n > 1)
        return report_line(RESULT_REFUSED, "bulletml: --lua takes one document, got %d", n);
    for (int i = 0; i < n; i++) {
        const enum result one = process_file(files[i], lua);
        worst = one > worst ? one : worst;
    }
    return report_stdout(worst);
}
