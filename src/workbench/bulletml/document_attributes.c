/*
 * document_attributes.c - labels and types of a document's elements.
 */
#include "document_parts.h"

#include <stdio.h>
#include <string.h>
#include "../../base/edit.h"

static void read_label(struct document_reader *r, struct document_node *node, const char *value, bool foreign)
{
    const char *name = document_element_name(node->element);
    const size_t n = strlen(value);

    for (size_t i = 0; foreign && i < n; i++)
        if (value[i] & 0x80) {
            document_bad(r, node->line, node->column, "<%s>: non-ASCII label; save the document as UTF-8", name);
            return;
        }
    const char *kept = document_keep(r, value, n + 1);
    if (kept)
        node->label = kept;
}

/* The types an element may have, and the one that was meant, if any. */
static void bad_type(struct document_reader *r, const struct document_node *node, const char *const *names, int n,
                     const char *value)
{
    char list[80] = "";
    struct edit_nearest near = { .word = value };

    for (int i = 0; i < n; i++) {
        const size_t at = strlen(list);
        snprintf(list + at, sizeof list - at, "%s%s", i == 0 ? "" : i == n - 1 ? " or " : ", ", names[i]);
        edit_consider(&near, names[i]);
    }
    document_bad(r, node->line, node->column, "<%s>: type: expected %s, got \"%.40s\"%s%s%s",
                 document_element_name(node->element), list, value, near.found ? " (did you mean \"" : "",
                 near.found ? near.found : "", near.found ? "\"?)" : "");
}

static void read_type(struct document_reader *r, struct document_node *node, const char *value)
{
    static const char *const names[] = { "aim", "absolute", "relative", "sequence" };
    static const char *const ways[] = { "none", "vertical", "horizontal" };
    const bool root = node->element == NODE_BULLETML, turns = node->element == NODE_DIRECTION;

    for (int i = 0; root && i < 3; i++)
        if (strcmp(value, ways[i]) == 0) {
            r->d->horizontal = i == 2;
            return;
        }
    for (int i = 0; !root && i < 4; i++)
        if (strcmp(value, names[i]) == 0) {
            node->type = (enum document_type)(NODE_AIM + i);
            if (node->type != NODE_AIM || turns)
                return;
            node->type = NODE_ABSOLUTE;
            document_told(r, (int32_t)(node - r->d->node), "type \"aim\" means \"absolute\" here");
            return;
        }
    if (root)
        bad_type(r, node, ways, 3, value);
    else
        bad_type(r, node, names + !turns, turns ? 4 : 3, value);
}

static bool has_type(enum document_element element)
{
    return element == NODE_BULLETML || (element >= NODE_DIRECTION && element <= NODE_VERTICAL);
}

static bool has_label(enum document_element element)
{
    return (element >= NODE_BULLET && element <= NODE_FIRE) || (element >= NODE_BULLET_REF && element <= NODE_FIRE_REF);
}

/* Names that other programs put on the root, for their readers. */
static bool known_elsewhere(enum document_element element, const char *name)
{
    return strncmp(name, "xml", 3) == 0 ||
           (element == NODE_BULLETML && (strcmp(name, "name") == 0 || strcmp(name, "description") == 0));
}

void document_attributes(struct document_reader *r, int32_t at, const char **attributes, bool foreign)
{
    struct document_node *node = &r->d->node[at];

    for (int i = 0; attributes[i] && !r->failed; i += 2) {
        if (strcmp(attributes[i], "label") == 0 && has_label(node->element))
            read_label(r, node, attributes[i + 1], foreign);
        else if (strcmp(attributes[i], "type") == 0 && has_type(node->element))
            read_type(r, node, attributes[i + 1]);
        else if (!known_elsewhere(node->element, attributes[i]))
            document_told(r, at, "attribute \"%.40s\" has no effect here", attributes[i]);
    }
}
