/*
 * document_check.c - checks that each element of a document is allowed where it is and has its required children.
 * Accepts everything that libbulletml accepts, such as <term> before <direction>, except documents that make it crash.
 */
#include "document_parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/edit.h"
#include "../../common/result.h"

#define BIT(element) (1u << (element))

enum {
    ACTIONS = BIT(NODE_ACTION) | BIT(NODE_ACTION_REF),
    BULLETS = BIT(NODE_BULLET) | BIT(NODE_BULLET_REF),
    AIMS = BIT(NODE_DIRECTION) | BIT(NODE_SPEED),
    COMMANDS = ACTIONS | BIT(NODE_REPEAT) | BIT(NODE_FIRE) | BIT(NODE_FIRE_REF) | BIT(NODE_CHANGE_SPEED) |
               BIT(NODE_CHANGE_DIRECTION) | BIT(NODE_ACCEL) | BIT(NODE_WAIT) | BIT(NODE_VANISH),
    ONCE = AIMS | BIT(NODE_HORIZONTAL) | BIT(NODE_VERTICAL) | BIT(NODE_TERM) | BIT(NODE_TIMES)
};

/* The elements that are allowed in an element; one of each set in `must` is required. */
static const struct {
    unsigned may, must[2];
} rules[NODE_ELEMENTS] = {
    [NODE_BULLETML] = { BIT(NODE_BULLET) | BIT(NODE_FIRE) | BIT(NODE_ACTION), { 0, 0 } },
    [NODE_BULLET] = { AIMS | ACTIONS, { 0, 0 } },
    [NODE_ACTION] = { COMMANDS, { 0, 0 } },
    [NODE_FIRE] = { AIMS | BULLETS, { BULLETS, 0 } },
    [NODE_CHANGE_DIRECTION] = { BIT(NODE_DIRECTION) | BIT(NODE_TERM), { BIT(NODE_DIRECTION), BIT(NODE_TERM) } },
    [NODE_CHANGE_SPEED] = { BIT(NODE_SPEED) | BIT(NODE_TERM), { BIT(NODE_SPEED), BIT(NODE_TERM) } },
    [NODE_ACCEL] = { BIT(NODE_HORIZONTAL) | BIT(NODE_VERTICAL) | BIT(NODE_TERM), { BIT(NODE_TERM), 0 } },
    [NODE_REPEAT] = { COMMANDS | BIT(NODE_TIMES), { BIT(NODE_TIMES), ACTIONS } },
    [NODE_BULLET_REF] = { BIT(NODE_PARAM), { 0, 0 } },
    [NODE_ACTION_REF] = { BIT(NODE_PARAM), { 0, 0 } },
    [NODE_FIRE_REF] = { BIT(NODE_PARAM), { 0, 0 } },
};

static void fail_at(struct document_reader *r, int32_t node, const char *why, const char *what)
{
    const struct document_node *n = &r->d->node[node];

    document_fail(r, n->place, why, document_element_name(n->element), what);
}

/* Writes a set of elements: "<direction>", "<bullet> or <bulletRef>". */
static void write_set(unsigned set, char out[64])
{
    size_t at = 0;

    out[0] = '\0';
    for (int e = 0; e < NODE_ELEMENTS && at < 64; e++)
        if (set >> e & 1)
            at += (size_t)snprintf(out + at, 64 - at, "%s<%s>", at ? " or " : "",
                                   document_element_name((enum document_element)e));
}

/* ---- children ---- */

/* Checks that the bullet of a fire and the body of a repeat are last, because libbulletml reads them last. */
static void check_order(struct document_reader *r, int32_t node, int32_t child, unsigned before)
{
    const enum document_element in = r->d->node[node].element;
    const unsigned is = BIT(r->d->node[child].element);

    if (in == NODE_FIRE && (is & AIMS) && (before & BULLETS))
        fail_at(r, child, "<%s> must be before the %s in its <fire>", "bullet");
    else if (in == NODE_FIRE && (is & BULLETS) && (before & BULLETS))
        fail_at(r, child, "<%s>: %s bullet in one <fire>; use a separate <fire> for each", "second");
    else if (in == NODE_REPEAT && (is & BIT(NODE_TIMES)) && before)
        fail_at(r, child, "<%s> must be before the %s in its <repeat>", "action");
    else if (in == NODE_REPEAT && (is & COMMANDS & ~(unsigned)ACTIONS) && !(before & ACTIONS))
        fail_at(r, child, "<%s> in <repeat> must be inside %s", "an <action>");
}

static void check_children(struct document_reader *r, int32_t node)
{
    const struct document *d = r->d;
    const enum document_element in = d->node[node].element;
    unsigned before = 0;
    char set[64];

    for (int32_t i = d->node[node].first; i != DOCUMENT_NONE && !r->failed; i = d->node[i].next) {
        const unsigned is = BIT(d->node[i].element);
        if (!(rules[in].may & is))
            fail_at(r, i, "<%s> is not allowed in <%s>", document_element_name(in));
        else if (before & is & ONCE)
            fail_at(r, i, "more than one <%s> in <%s>", document_element_name(in));
        else
            check_order(r, node, i, before);
        before |= is;
    }
    for (int k = 0; k < 2 && !r->failed; k++)
        if (rules[in].must[k] && !(rules[in].must[k] & before)) {
            write_set(rules[in].must[k], set);
            fail_at(r, node, "<%s> has no %s", set);
        }
}

/* ---- labels ---- */

struct label {
    const struct document_node *node;
    int32_t at;
};

static int compare_labels(const void *a, const void *b)
{
    const struct label *x = a, *y = b;
    const int d = (int)x->node->element - (int)y->node->element;

    return d ? d : strcmp(x->node->label, y->node->label);
}

static int compare_labels_and_positions(const void *a, const void *b)
{
    const struct label *x = a, *y = b;
    const int d = compare_labels(a, b);

    return d ? d : (x->at > y->at) - (x->at < y->at);
}

static void fail_label(struct document_reader *r, int32_t ref, const struct label *labels, int n)
{
    const struct document_node *at = &r->d->node[ref];
    const enum document_element meant = document_ref_element(at->element);
    struct edit_nearest near = { .word = at->label };

    for (int i = 0; i < n; i++)
        if (labels[i].node->element == meant)
            edit_consider(&near, labels[i].node->label);
    document_fail(r, at->place, "<%s>: no <%s label=\"%s\">%s%s%s", document_element_name(at->element),
                  document_element_name(meant), at->label, near.found ? " (did you mean \"" : "",
                  near.found ? near.found : "", near.found ? "\"?)" : "");
}

/* Returns the last element with the ref's label. labels: sorted by element, label and position. */
static int32_t find_target(const struct document *d, int32_t ref, const struct label *labels, int n)
{
    struct document_node wanted = { .element = document_ref_element(d->node[ref].element),
                                    .label = d->node[ref].label };
    const struct label key = { &wanted, 0 };
    int low = 0, high = n; /* the first that is greater than the key */

    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (compare_labels(&labels[middle], &key) > 0)
            high = middle;
        else
            low = middle + 1;
    }
    return low > 0 && compare_labels(&labels[low - 1], &key) == 0 ? labels[low - 1].at : DOCUMENT_NONE;
}

/* Warns about two elements with the same label if a ref uses it. Bullets inside fires may share a label. */
static void warn_duplicates(struct document_reader *r, const struct label *labels, int n)
{
    uint8_t *used = calloc((size_t)r->d->n, 1);

    for (int32_t i = 0; used && i < r->d->n; i++)
        if (r->d->node[i].target != DOCUMENT_NONE)
            used[r->d->node[i].target] = 1;
    for (int last = n - 1, i = n - 2; used && i >= 0; i--) {
        if (compare_labels(&labels[i], &labels[last]) != 0)
            last = i;
        else if (used[labels[last].at])
            document_warn_at(r, labels[i].at,
                             "duplicate label \"%s\": line %d defines it again; the last definition is used",
                             labels[i].node->label, labels[last].node->place.line);
    }
    free(used);
}

static void check_labels(struct document_reader *r)
{
    struct document *d = r->d;
    struct label *labels = malloc((size_t)d->n * sizeof *labels);
    int n = 0;

    if (!labels) {
        result_set_host_failed();
        document_fail(r, (struct xml_place){ 1, 1 }, "out of memory");
        return;
    }
    for (int32_t i = 0; i < d->n; i++)
        if (d->node[i].element >= NODE_BULLET && d->node[i].element <= NODE_FIRE && d->node[i].label[0] != '\0')
            labels[n++] = (struct label){ &d->node[i], i };
    qsort(labels, (size_t)n, sizeof *labels, compare_labels_and_positions);
    for (int32_t i = 0; i < d->n && !r->failed; i++) {
        if (d->node[i].element < NODE_BULLET_REF || d->node[i].element > NODE_FIRE_REF)
            continue;
        if (d->node[i].label[0] == '\0')
            fail_at(r, i, "<%s> has no %s", "label");
        else if ((d->node[i].target = find_target(d, i, labels, n)) == DOCUMENT_NONE)
            fail_label(r, i, labels, n);
    }
    if (!r->failed)
        warn_duplicates(r, labels, n);
    free(labels);
}

void document_check(struct document_reader *r)
{
    for (int32_t i = 0; i < r->d->n && !r->failed; i++)
        check_children(r, i);
    if (!r->failed)
        check_labels(r);
}
