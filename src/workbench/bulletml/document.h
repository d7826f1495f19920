/*
 * document.h - a BulletML document: XML to a tree, with errors by line and column.
 *
 * Reads BulletML 0.21 as libbulletml does. A tree is well formed: each element has the children it must have, in their
 * order, no others, and a number where one is needed; each ref's label exists. compile.h gives it a meaning.
 */
#ifndef WORKBENCH_DOCUMENT_H
#define WORKBENCH_DOCUMENT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "expression.h"
#include "../xml/xml.h"

enum {
    DOCUMENT_FILE = 1 << 20,  /* bytes */
    DOCUMENT_NODES = 1 << 16, /* elements */
    DOCUMENT_NONE = -1        /* no such node */
};

enum document_element {
    NODE_BULLETML,
    NODE_BULLET,
    NODE_ACTION,
    NODE_FIRE,
    NODE_CHANGE_DIRECTION,
    NODE_CHANGE_SPEED,
    NODE_ACCEL,
    NODE_WAIT,
    NODE_VANISH,
    NODE_REPEAT,
    NODE_BULLET_REF,
    NODE_ACTION_REF,
    NODE_FIRE_REF,
    NODE_DIRECTION,
    NODE_SPEED,
    NODE_HORIZONTAL,
    NODE_VERTICAL,
    NODE_TERM,
    NODE_TIMES,
    NODE_PARAM,
    NODE_ELEMENTS
};

/* The attribute `type`: NODE_PLAIN where none is written. A speed of type aim is NODE_ABSOLUTE here, as it is there. */
enum document_type { NODE_PLAIN, NODE_AIM, NODE_ABSOLUTE, NODE_RELATIVE, NODE_SEQUENCE };

struct document_node {
    enum document_element element;
    enum document_type type;
    const char *label;                 /* "": none */
    struct xml_place place;            /* of its "<" */
    int32_t parent, first, last, next; /* numbers of nodes, or DOCUMENT_NONE; children are in the order of the file */
    int32_t target;                    /* of a ref: what it stands for */
    const struct expression_op *op;    /* of direction, speed, horizontal, vertical, term, times, wait, param */
    int ops;                           /* 0: it has no number */
};

struct document {
    struct document_node *node; /* [0] is bulletml; a node comes after its parent. malloc */
    int32_t n;
    bool horizontal; /* bulletml type="horizontal" */
    void *store;     /* labels and numbers; document.c's */
};

/* Reads n bytes; file is their name for messages. warn gets a sentence for each construct that is valid but probably
 * unintended, "bulletml/a.xml:12:7: ..."; it may be NULL. False and one sentence that starts the same way. Close d
 * either way. */
bool document_read(struct document *d, const char *bytes, size_t n, const char *file,
                   void (*warn)(void *context, const char *sentence), void *context, char *err, size_t err_size);
void document_close(struct document *d);

/* "changeDirection" */
const char *document_element_name(enum document_element element);

/* "aim", "absolute"; "" for NODE_PLAIN. */
const char *document_type_name(enum document_type type);

/* The child of that element, or DOCUMENT_NONE. */
int32_t document_child(const struct document *d, int32_t node, enum document_element element);

/* The element that a label of bullet, action or fire names: the last one in the file, at any depth; or DOCUMENT_NONE.
 * A ref's element may be given: bulletRef looks for a bullet. */
int32_t document_find(const struct document *d, enum document_element element, const char *label);

/* The highest parameter in a node's number, 0: none. */
int document_param(const struct document_node *node);

/* True for an action or a ref to one. */
bool document_is_action(const struct document *d, int32_t node);

/* True for an action that starts by itself, because its label starts with "top". */
bool document_is_top(const struct document *d, int32_t node);

#endif
