/*
 * document.c - see document.h. Nodes are indices into an array that grows. Labels and the operations of numbers are
 * stored in separate blocks, which do not move.
 */
#include "document_parts.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/edit.h"
#include "../../base/err.h"
#include "../../common/array.h"
#include "../../common/result.h"

static const char *const elements[NODE_ELEMENTS] = {
    [NODE_BULLETML] = "bulletml",
    [NODE_BULLET] = "bullet",
    [NODE_ACTION] = "action",
    [NODE_FIRE] = "fire",
    [NODE_CHANGE_DIRECTION] = "changeDirection",
    [NODE_CHANGE_SPEED] = "changeSpeed",
    [NODE_ACCEL] = "accel",
    [NODE_WAIT] = "wait",
    [NODE_VANISH] = "vanish",
    [NODE_REPEAT] = "repeat",
    [NODE_BULLET_REF] = "bulletRef",
    [NODE_ACTION_REF] = "actionRef",
    [NODE_FIRE_REF] = "fireRef",
    [NODE_DIRECTION] = "direction",
    [NODE_SPEED] = "speed",
    [NODE_HORIZONTAL] = "horizontal",
    [NODE_VERTICAL] = "vertical",
    [NODE_TERM] = "term",
    [NODE_TIMES] = "times",
    [NODE_PARAM] = "param",
};

struct block {
    struct block *previous;
    _Alignas(16) char bytes[];
};

/* ---- building ---- */

void document_fail(struct document_reader *r, struct xml_place place, const char *format, ...)
{
    char why[512];
    va_list args;

    if (r->failed)
        return;
    r->failed = true;
    va_start(args, format);
    vsnprintf(why, sizeof why, format, args);
    va_end(args);
    err_set(r->err, r->err_size, "%s:%d:%d: %s", r->file, place.line, place.column, why);
}

void document_warn_at(struct document_reader *r, int32_t node, const char *format, ...)
{
    const struct document_node *at = &r->d->node[node];
    char why[512], sentence[1024];
    va_list args;

    if (!r->warn)
        return;
    va_start(args, format);
    vsnprintf(why, sizeof why, format, args);
    va_end(args);
    snprintf(sentence, sizeof sentence, "%s:%d:%d: <%s>: %s", r->file, at->place.line, at->place.column,
             elements[at->element], why);
    r->warn(r->context, sentence);
}

void *document_store(struct document_reader *r, const void *bytes, size_t n)
{
    struct block *block = malloc(sizeof *block + n);

    if (!block) {
        result_set_host_failed();
        document_fail(r, (struct xml_place){ 1, 1 }, "out of memory");
        return NULL;
    }
    memcpy(block->bytes, bytes, n);
    block->previous = r->d->store;
    r->d->store = block;
    return block->bytes;
}

int32_t document_add(struct document_reader *r, int32_t parent, enum document_element element, struct xml_place place)
{
    struct document *d = r->d;

    if (d->n == DOCUMENT_MAX_NODES)
        document_fail(r, place, "<%s>: more than %d elements", elements[element], (int)DOCUMENT_MAX_NODES);
    else if (!array_append(&d->node, (size_t)d->n, sizeof *d->node)) {
        result_set_host_failed();
        document_fail(r, place, "out of memory");
    }
    if (r->failed)
        return DOCUMENT_NONE;
    d->node[d->n] = (struct document_node){ .element = element,
                                            .label = "",
                                            .place = place,
                                            .parent = parent,
                                            .first = DOCUMENT_NONE,
                                            .last = DOCUMENT_NONE,
                                            .next = DOCUMENT_NONE,
                                            .target = DOCUMENT_NONE };
    if (parent != DOCUMENT_NONE) {
        struct document_node *p = &d->node[parent];
        if (p->last == DOCUMENT_NONE)
            p->first = d->n;
        else
            d->node[p->last].next = d->n;
        p->last = d->n;
    }
    return d->n++;
}

enum document_element document_find_element(const char *name, const char **near)
{
    struct edit_nearest nearest = { .word = name };

    for (int i = 0; i < NODE_ELEMENTS; i++) {
        edit_consider(&nearest, elements[i]);
        if (strcmp(name, elements[i]) == 0)
            return (enum document_element)i;
    }
    *near = nearest.found ? nearest.found : "";
    return NODE_ELEMENTS;
}

bool document_has_number(enum document_element element)
{
    return element == NODE_WAIT || element >= NODE_DIRECTION;
}

enum document_element document_ref_element(enum document_element ref)
{
    switch (ref) {
    case NODE_BULLET_REF:
        return NODE_BULLET;
    case NODE_ACTION_REF:
        return NODE_ACTION;
    case NODE_FIRE_REF:
        return NODE_FIRE;
    default:
        return ref;
    }
}

/* ---- reading ---- */

bool document_read(struct document *d, const char *bytes, size_t n, const char *file,
                   void (*warn)(void *context, const char *sentence), void *context, char *err, size_t err_size)
{
    struct document_reader r = {
        .d = d, .file = file, .warn = warn, .context = context, .err = err, .err_size = err_size
    };

    memset(d, 0, sizeof *d);
    if (n > DOCUMENT_MAX_FILE)
        return err_set(err, err_size, "%s: expected a document of at most %d bytes, got %zu", file,
                       (int)DOCUMENT_MAX_FILE, n);
    document_xml(&r, bytes, n);
    if (!r.failed)
        document_check(&r);
    if (!r.failed && warn)
        document_warn(&r);
    return !r.failed;
}

void document_free(struct document *d)
{
    for (struct block *p = d->store, *before; p; p = before) {
        before = p->previous;
        free(p);
    }
    free(d->node);
    memset(d, 0, sizeof *d);
}

/* ---- queries ---- */

const char *document_element_name(enum document_element element)
{
    return elements[element];
}

const char *document_type_name(enum document_type type)
{
    static const char *const names[] = { "", "aim", "absolute", "relative", "sequence" };

    return names[type];
}

int32_t document_child(const struct document *d, int32_t node, enum document_element element)
{
    for (int32_t i = d->node[node].first; i != DOCUMENT_NONE; i = d->node[i].next)
        if (d->node[i].element == element)
            return i;
    return DOCUMENT_NONE;
}

int32_t document_find(const struct document *d, enum document_element element, const char *label)
{
    element = document_ref_element(element);
    for (int32_t i = d->n - 1; i >= 0; i--)
        if (d->node[i].element == element && d->node[i].label[0] != '\0' && strcmp(d->node[i].label, label) == 0)
            return i;
    return DOCUMENT_NONE;
}

int document_param(const struct document_node *node)
{
    int most = 0;

    for (int i = 0; i < node->ops; i++)
        if (node->op[i].kind == EXPRESSION_PARAM && node->op[i].number > most)
            most = (int)node->op[i].number;
    return most;
}

bool document_is_action(const struct document *d, int32_t node)
{
    return d->node[node].element == NODE_ACTION || d->node[node].element == NODE_ACTION_REF;
}

bool document_is_top(const struct document *d, int32_t node)
{
    return d->node[node].element == NODE_ACTION && strncmp(d->node[node].label, "top", 3) == 0;
}
