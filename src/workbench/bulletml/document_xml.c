/*
 * document_xml.c - reads a document's XML into nodes, labels and types.
 *
 * Old documents are often Shift_JIS or EUC-JP because of their comments; labels in these encodings are errors.
 */
#include "document_parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/edit.h"
#include "../../common/result.h"

enum { TEXT = 8192 /* bytes of a number */ };

struct reader {
    struct document_reader *r;
    struct xml xml;
    int32_t open; /* the innermost element's node */
    char text[TEXT];
    size_t n;
    struct xml_place text_place; /* where the text starts */
    bool closed;                 /* a comment followed the number, so later text is ignored, as in libbulletml */
    bool warned;
};

/* Returns the number of blanks at the start. */
static size_t count_blanks(const char *s, size_t n)
{
    size_t i = 0;

    while (i < n && (s[i] == ' ' || s[i] == '\t' || s[i] == '\n' || s[i] == '\r'))
        i++;
    return i;
}

static enum document_element get_element(const struct reader *x, int32_t node)
{
    return node == DOCUMENT_NONE ? NODE_ELEMENTS : x->r->d->node[node].element;
}

static const char *get_name(const struct reader *x, int32_t node)
{
    return document_element_name(x->r->d->node[node].element);
}

/* Returns the position of a byte of a text that starts at `place`. */
static struct xml_place position_in(struct xml_place place, const char *text, size_t at)
{
    for (size_t i = 0; i < at; i++)
        place = xml_next_place(place, text[i]);
    return place;
}

/* ---- attributes ---- */

static void read_label(struct document_reader *r, struct document_node *node, const char *value, bool approximate)
{
    const char *name = document_element_name(node->element);
    const size_t n = strlen(value);

    for (size_t i = 0; approximate && i < n; i++)
        if (value[i] & 0x80) {
            document_fail(r, node->place, "<%s>: non-ASCII label; save the document as UTF-8", name);
            return;
        }
    const char *copy = document_store(r, value, n + 1);
    if (copy)
        node->label = copy;
}

/* Reports an unknown type, with the valid types and a similar one. */
static void fail_type(struct document_reader *r, const struct document_node *node, const char *const *names, int n,
                      const char *value)
{
    char list[80] = "";
    struct edit_nearest near = { .word = value };

    for (int i = 0; i < n; i++) {
        const size_t at = strlen(list);
        snprintf(list + at, sizeof list - at, "%s%s", i == 0 ? "" : i == n - 1 ? " or " : ", ", names[i]);
        edit_consider(&near, names[i]);
    }
    document_fail(r, node->place, "<%s>: type: expected %s, got \"%.40s\"%s%s%s", document_element_name(node->element),
                  list, value, near.found ? " (did you mean \"" : "", near.found ? near.found : "",
                  near.found ? "\"?)" : "");
}

static void read_type(struct document_reader *r, struct document_node *node, const char *value)
{
    static const char *const names[] = { "aim", "absolute", "relative", "sequence" };
    static const char *const orientations[] = { "none", "vertical", "horizontal" };
    const bool root = node->element == NODE_BULLETML, is_direction = node->element == NODE_DIRECTION;

    for (int i = 0; root && i < 3; i++)
        if (strcmp(value, orientations[i]) == 0) {
            r->d->horizontal = i == 2;
            return;
        }
    for (int i = 0; !root && i < 4; i++)
        if (strcmp(value, names[i]) == 0) {
            node->type = (enum document_type)(NODE_AIM + i);
            if (node->type != NODE_AIM || is_direction)
                return;
            node->type = NODE_ABSOLUTE;
            document_warn_at(r, (int32_t)(node - r->d->node), "type \"aim\" means \"absolute\" here");
            return;
        }
    if (root)
        fail_type(r, node, orientations, 3, value);
    else
        fail_type(r, node, names + !is_direction, is_direction ? 4 : 3, value);
}

static bool has_type(enum document_element element)
{
    return element == NODE_BULLETML || (element >= NODE_DIRECTION && element <= NODE_VERTICAL);
}

static bool has_label(enum document_element element)
{
    return (element >= NODE_BULLET && element <= NODE_FIRE) || (element >= NODE_BULLET_REF && element <= NODE_FIRE_REF);
}

/* Returns whether other programs write the attribute. */
static bool is_foreign_attribute(enum document_element element, const char *name)
{
    return strncmp(name, "xml", 3) == 0 ||
           (element == NODE_BULLETML && (strcmp(name, "name") == 0 || strcmp(name, "description") == 0));
}

static void read_attributes(struct document_reader *r, int32_t at, const struct xml *x)
{
    struct document_node *node = &r->d->node[at];

    for (int i = 0; i < x->n && !r->failed; i++) {
        const char *key = x->attribute[i].key, *value = x->attribute[i].value;
        if (strcmp(key, "label") == 0 && has_label(node->element))
            read_label(r, node, value, x->approximate);
        else if (strcmp(key, "type") == 0 && has_type(node->element))
            read_type(r, node, value);
        else if (!is_foreign_attribute(node->element, key))
            document_warn_at(r, at, "attribute \"%.40s\" has no effect here", key);
    }
}

/* ---- elements ---- */

static void open_element(struct reader *x)
{
    const char *name = x->xml.name, *near;
    const struct xml_place at = x->xml.start;

    if (get_element(x, x->open) == NODE_VANISH) {
        if (!x->warned)
            document_warn_at(x->r, x->open, "its content has no effect");
        x->warned = true;
        x->r->failed = !xml_skip(&x->xml);
        return;
    }
    const enum document_element element = document_find_element(name, &near);
    if (element == NODE_ELEMENTS)
        document_fail(x->r, at, "<%.40s> is not a BulletML element%s%s%s", name, near[0] ? " (did you mean <" : "",
                      near, near[0] ? ">?)" : "");
    else if (x->open == DOCUMENT_NONE && element != NODE_BULLETML)
        document_fail(x->r, at, "<%s>: expected <bulletml> as the root element", name);
    else if (x->open != DOCUMENT_NONE && element == NODE_BULLETML)
        document_fail(x->r, at, "<%s> is inside another element", name);
    if (x->r->failed)
        return;
    const int32_t node = document_add(x->r, x->open, element, at);
    if (node == DOCUMENT_NONE)
        return;
    x->open = node;
    x->n = 0;
    x->closed = x->warned = false;
    read_attributes(x->r, node, &x->xml);
}

static void read_number(struct reader *x, int32_t at)
{
    struct document_node *node = &x->r->d->node[at];
    struct expression_op ops[EXPRESSION_OPS];
    struct expression_error error;
    bool large;

    if (count_blanks(x->text, x->n) == x->n) {
        document_fail(x->r, node->place, "<%s>: expected a number, got nothing", get_name(x, at));
        return;
    }
    node->ops = expression_read(x->text, x->n, ops, &large, &error);
    if (node->ops == 0) {
        document_fail(x->r, position_in(x->text_place, x->text, error.at), "<%s>: %s", get_name(x, at), error.text);
        return;
    }
    node->op = document_store(x->r, ops, (size_t)node->ops * sizeof *ops);
    if (large)
        document_warn_at(x->r, at, "numbers above 2147483647 are clamped to 2147483647");
}

static void close_element(struct reader *x)
{
    if (document_has_number(get_element(x, x->open)))
        read_number(x, x->open);
    x->open = x->r->d->node[x->open].parent;
    x->n = 0;
}

/* ---- text ---- */

static void add_text(struct reader *x, struct xml_place place, const char *s, size_t n)
{
    const enum document_element element = get_element(x, x->open);
    const size_t start = count_blanks(s, n);

    if (element == NODE_VANISH || (start == n && (x->closed || !document_has_number(element))))
        return;
    if (!document_has_number(element)) {
        document_fail(x->r, position_in(place, s, start), "<%s>: expected elements, got text", get_name(x, x->open));
    } else if (x->closed) {
        if (!x->warned)
            document_warn_at(x->r, x->open, "text after the comment is ignored");
        x->warned = true;
    } else if (n > TEXT - x->n) {
        document_fail(x->r, place, "<%s>: number longer than %d bytes", get_name(x, x->open), (int)TEXT);
    } else {
        memcpy(x->text, s, n);
        x->text_place = place;
        x->n = n;
    }
}

/* Reads text and comments up to the next tag. A comment before the number has no effect; a comment after it ends it. */
static void read_text(struct reader *x)
{
    bool skipped = true;

    while (skipped && !x->r->failed) {
        const struct xml_place place = x->xml.place;
        const char *s;
        const size_t n = xml_text(&x->xml, &s);
        add_text(x, place, s, n);
        if (!x->r->failed)
            x->r->failed = !xml_skip_markup(&x->xml, &skipped);
        if (skipped)
            x->closed = count_blanks(x->text, x->n) < x->n;
    }
}

/* ---- documents ---- */

static void read_elements(struct reader *x)
{
    while (!x->r->failed) {
        if (x->open != DOCUMENT_NONE)
            read_text(x);
        const enum xml_event event = x->r->failed ? XML_BAD : xml_next(&x->xml);
        if (event == XML_BAD)
            x->r->failed = true;
        else if (event == XML_OPEN)
            open_element(x);
        else if (event == XML_CLOSE)
            close_element(x);
        else
            break;
    }
    if (!x->r->failed && x->r->d->n == 0)
        document_fail(x->r, x->xml.place, "expected <bulletml> as the root element");
}

void document_xml(struct document_reader *r, const char *bytes, size_t n)
{
    struct reader *x = calloc(1, sizeof *x);

    if (!x) {
        result_set_host_failed();
        document_fail(r, (struct xml_place){ 1, 1 }, "out of memory");
        return;
    }
    x->r = r;
    x->open = DOCUMENT_NONE;
    r->failed = !xml_open(&x->xml, bytes, n, r->file, true, r->err, r->err_size);
    read_elements(x);
    xml_close(&x->xml);
    free(x);
}
