/*
 * document_warn.c - warns about constructs that are valid but probably unintended: a repeat with times 0, which runs
 * once, several actions of a bullet, labels that are never used, loops that never wait.
 */
#include "document_parts.h"

#include <stdlib.h>

enum { TOO_MANY = 50000 /* this many repeats without a wait are a mistake */ };

static bool get_constant(const struct document *d, int32_t node, double *value)
{
    return node != DOCUMENT_NONE && expression_constant(d->node[node].op, d->node[node].ops, value);
}

/* ---- waits ---- */

/* The search for waits. The budget, in nodes, limits it in documents with many repeats. */
struct search {
    int32_t *visited; /* number of the last search that visited the node, to stop at cycles */
    int32_t number;
    long budget;
};

/* Returns whether the node may wait for a frame. */
static bool may_wait(const struct document *d, int32_t node, struct search *s)
{
    double frames;

    if (s->visited[node] == s->number)
        return false;
    s->visited[node] = s->number;
    s->budget--;
    if (d->node[node].element == NODE_WAIT)
        return !get_constant(d, node, &frames) || frames >= 1;
    if (d->node[node].element == NODE_ACTION_REF)
        return may_wait(d, d->node[node].target, s);
    if (d->node[node].element != NODE_ACTION && d->node[node].element != NODE_REPEAT)
        return false;
    for (int32_t i = d->node[node].first; i != DOCUMENT_NONE; i = d->node[i].next)
        if (may_wait(d, i, s))
            return true;
    return false;
}

static void warn_repeat(struct document_reader *r, int32_t node, struct search *s)
{
    const struct document *d = r->d;
    int bodies = 0;
    double times;

    for (int32_t i = d->node[node].first; i != DOCUMENT_NONE; i = d->node[i].next)
        bodies += d->node[i].element != NODE_TIMES;
    if (bodies > 1)
        document_warn_at(r, node, "elements after the first action are repeated, too");
    if (!get_constant(d, document_child(d, node, NODE_TIMES), &times))
        return;
    if (times < 1)
        document_warn_at(r, node, "times is %g, but a repeat runs at least once", times);
    s->number++;
    if (times >= TOO_MANY && s->budget > 0 && !may_wait(d, node, s))
        document_warn_at(r, node, "%.0f times without a wait: too many for one frame", times);
}

/* ---- parameters ---- */

/* Fills most[] with the highest parameter in each node and its descendants: a node comes after its parent. */
static void find_params(const struct document *d, uint8_t *most)
{
    for (int32_t i = d->n - 1; i >= 0; i--) {
        const int own = document_param(&d->node[i]);
        const int32_t parent = d->node[i].parent;
        most[i] = most[i] > own ? most[i] : (uint8_t)own;
        if (parent != DOCUMENT_NONE && most[parent] < most[i])
            most[parent] = most[i];
    }
}

static void warn_params(struct document_reader *r, int32_t ref, const uint8_t *most)
{
    const struct document *d = r->d;
    int count = 0;

    for (int32_t i = d->node[ref].first; i != DOCUMENT_NONE; i = d->node[i].next)
        count++;
    if (count > 9)
        document_warn_at(r, ref, "%d params, but only the first 9 have names ($1 to $9)", count);
    else if (most[d->node[ref].target] > count)
        document_warn_at(r, ref, "\"%s\" uses $%d, which is 1 because only %d param%s given", d->node[ref].label,
                         most[d->node[ref].target], count, count == 1 ? " is" : "s are");
}

/* ---- labels ---- */

/* Checks the label of a child of <bulletml>, which runs only by its label. */
static void warn_label(struct document_reader *r, int32_t node, const uint8_t *used)
{
    const struct document *d = r->d;

    if (d->node[node].label[0] == '\0')
        document_warn_at(r, node, "no label, so it never runs");
    else if (!used[node] && !document_is_top(d, node) &&
             document_find(d, d->node[node].element, d->node[node].label) == node)
        document_warn_at(r, node, "label \"%s\" is never used", d->node[node].label);
}

static void warn_top(struct document_reader *r)
{
    const struct document *d = r->d;

    for (int32_t i = 0; i < d->n; i++)
        if (document_is_top(d, i))
            return;
    document_warn_at(r, 0, "no action has a label that starts with \"top\", so nothing runs");
}

/* ---- nodes ---- */

static void warn_wait(struct document_reader *r, int32_t node)
{
    double frames;

    if (get_constant(r->d, node, &frames) && frames < 1 && frames != 0)
        document_warn_at(r, node, "a wait of %g frames has no effect: the action continues immediately", frames);
}

static void warn_bullet(struct document_reader *r, int32_t node)
{
    const struct document *d = r->d;
    int actions = 0;

    for (int32_t i = d->node[node].first; i != DOCUMENT_NONE; i = d->node[i].next)
        actions += document_is_action(d, i);
    if (actions > 1)
        document_warn_at(r, node, "its %d actions run one after another, not in parallel", actions);
}

struct facts {
    uint8_t *most, *used; /* per node: highest parameter; whether it is a ref's target */
    struct search search;
};

static void warn_node(struct document_reader *r, int32_t node, struct facts *l)
{
    const struct document_node *n = &r->d->node[node];

    if (n->parent == 0)
        warn_label(r, node, l->used);
    if (n->element == NODE_REPEAT)
        warn_repeat(r, node, &l->search);
    else if (n->element == NODE_WAIT)
        warn_wait(r, node);
    else if (n->element == NODE_BULLET)
        warn_bullet(r, node);
    else if (n->target != DOCUMENT_NONE)
        warn_params(r, node, l->most);
}

void document_warn(struct document_reader *r)
{
    const struct document *d = r->d;
    const size_t n = (size_t)d->n;
    struct facts l = { calloc(n, 1), calloc(n, 1), { calloc(n, sizeof(int32_t)), 0, 16 * DOCUMENT_MAX_NODES } };

    if (l.most && l.used && l.search.visited) {
        find_params(d, l.most);
        for (int32_t i = 0; i < d->n; i++)
            if (d->node[i].target != DOCUMENT_NONE)
                l.used[d->node[i].target] = 1;
        warn_top(r);
        for (int32_t i = 0; i < d->n; i++)
            warn_node(r, i, &l);
    }
    free(l.most);
    free(l.used);
    free(l.search.visited);
}
