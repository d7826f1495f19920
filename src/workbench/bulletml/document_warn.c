/*
 * document_warn.c - what is allowed in a document and hardly meant: a repeat of 0, which runs once, actions one after
 * another, labels nobody asks for, loops that never wait.
 */
#include "document_parts.h"

#include <stdlib.h>

enum { MANY = 50000 /* passes without a wait that nobody means */ };

static bool constant(const struct document *d, int32_t node, double *value)
{
    return node != DOCUMENT_NONE && expression_constant(d->node[node].op, d->node[node].ops, value);
}

static bool is_action(const struct document_node *node)
{
    return node->element == NODE_ACTION || node->element == NODE_ACTION_REF;
}

/* ---- waits ---- */

/* What is looked for waits in a document with ever so many repeats ends with the budget, in nodes. */
struct search {
    int32_t *seen; /* the search that last looked into a node: in a circle there is nothing new */
    int32_t now;
    long budget;
};

/* May a frame end in it? */
static bool may_wait(const struct document *d, int32_t node, struct search *s)
{
    double frames;

    if (s->seen[node] == s->now)
        return false;
    s->seen[node] = s->now;
    s->budget--;
    if (d->node[node].element == NODE_WAIT)
        return !constant(d, node, &frames) || frames >= 1;
    if (d->node[node].element == NODE_ACTION_REF)
        return may_wait(d, d->node[node].target, s);
    if (d->node[node].element != NODE_ACTION && d->node[node].element != NODE_REPEAT)
        return false;
    for (int32_t i = d->node[node].first; i != DOCUMENT_NONE; i = d->node[i].next)
        if (may_wait(d, i, s))
            return true;
    return false;
}

static void look_at_repeat(struct document_reader *r, int32_t node, struct search *s)
{
    const struct document *d = r->d;
    int bodies = 0;
    double times;

    for (int32_t i = d->node[node].first; i != DOCUMENT_NONE; i = d->node[i].next)
        bodies += d->node[i].element != NODE_TIMES;
    if (bodies > 1)
        document_told(r, node, "elements after the first action are repeated, too");
    if (!constant(d, document_child(d, node, NODE_TIMES), &times))
        return;
    if (times < 1)
        document_told(r, node, "times is %g, but a repeat runs at least once", times);
    s->now++;
    if (times >= MANY && s->budget > 0 && !may_wait(d, node, s))
        document_told(r, node, "%.0f times without a wait: too many for one frame", times);
}

/* ---- parameters ---- */

static int param_in(const struct document_node *node)
{
    int most = 0;

    for (int i = 0; i < node->ops; i++)
        if (node->op[i].kind == EXPRESSION_PARAM && node->op[i].number > most)
            most = (int)node->op[i].number;
    return most;
}

/* Fills most[] with the highest parameter in each node and what is in it: a node comes after its parent. */
static void find_params(const struct document *d, uint8_t *most)
{
    for (int32_t i = d->n - 1; i >= 0; i--) {
        const int own = param_in(&d->node[i]);
        const int32_t parent = d->node[i].parent;
        most[i] = most[i] > own ? most[i] : (uint8_t)own;
        if (parent != DOCUMENT_NONE && most[parent] < most[i])
            most[parent] = most[i];
    }
}

static void look_at_params(struct document_reader *r, int32_t ref, const uint8_t *most)
{
    const struct document *d = r->d;
    int given = 0;

    for (int32_t i = d->node[ref].first; i != DOCUMENT_NONE; i = d->node[i].next)
        given++;
    if (given > 9)
        document_told(r, ref, "%d params, but only the first 9 have names ($1 to $9)", given);
    else if (most[d->node[ref].target] > given)
        document_told(r, ref, "\"%s\" uses $%d, which is 1 because only %d param%s given", d->node[ref].label,
                      most[d->node[ref].target], given, given == 1 ? " is" : "s are");
}

/* ---- labels ---- */

/* Something right below bulletml runs by its label alone. */
static void look_at_label(struct document_reader *r, int32_t node, const uint8_t *used)
{
    const struct document *d = r->d;

    if (d->node[node].label[0] == '\0')
        document_told(r, node, "no label, so it never runs");
    else if (!used[node] && !document_is_top(d, node) &&
             document_find(d, d->node[node].element, d->node[node].label) == node)
        document_told(r, node, "label \"%s\" is never used", d->node[node].label);
}

static void look_at_top(struct document_reader *r)
{
    const struct document *d = r->d;

    for (int32_t i = 0; i < d->n; i++)
        if (document_is_top(d, i))
            return;
    document_told(r, 0, "no action has a label that starts with \"top\", so nothing runs");
}

/* ---- the whole ---- */

static void look_at_wait(struct document_reader *r, int32_t node)
{
    double frames;

    if (constant(r->d, node, &frames) && frames < 1 && frames != 0)
        document_told(r, node, "a wait of %g frames has no effect: the action continues immediately", frames);
}

static void look_at_bullet(struct document_reader *r, int32_t node)
{
    const struct document *d = r->d;
    int actions = 0;

    for (int32_t i = d->node[node].first; i != DOCUMENT_NONE; i = d->node[i].next)
        actions += is_action(&d->node[i]);
    if (actions > 1)
        document_told(r, node, "its %d actions run one after another, not in parallel", actions);
}

struct looks {
    uint8_t *most, *used; /* the highest parameter in a node; is it what a ref stands for? */
    struct search search;
};

static void look_at(struct document_reader *r, int32_t node, struct looks *l)
{
    const struct document_node *n = &r->d->node[node];

    if (n->parent == 0)
        look_at_label(r, node, l->used);
    if (n->element == NODE_REPEAT)
        look_at_repeat(r, node, &l->search);
    else if (n->element == NODE_WAIT)
        look_at_wait(r, node);
    else if (n->element == NODE_BULLET)
        look_at_bullet(r, node);
    else if (n->target != DOCUMENT_NONE)
        look_at_params(r, node, l->most);
}

void document_warn(struct document_reader *r)
{
    const struct document *d = r->d;
    const size_t n = (size_t)d->n;
    struct looks l = { calloc(n, 1), calloc(n, 1), { calloc(n, sizeof(int32_t)), 0, 16 * DOCUMENT_NODES } };

    if (l.most && l.used && l.search.seen) {
        find_params(d, l.most);
        for (int32_t i = 0; i < d->n; i++)
            if (d->node[i].target != DOCUMENT_NONE)
                l.used[d->node[i].target] = 1;
        look_at_top(r);
        for (int32_t i = 0; i < d->n; i++)
            look_at(r, i, &l);
    }
    free(l.most);
    free(l.used);
    free(l.search.seen);
}
