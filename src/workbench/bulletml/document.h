/*
 * document.h - reads a BulletML document into a tree, with errors by line and column.
 *
 * Reads BulletML 0.21 as libbulletml does. The tree is valid: each element has its required children in the right
 * order, no others, and a number where one is required; each ref's label exists.
 */
#ifndef WORKBENCH_DOCUMENT_H
#define WORKBENCH_DOCUMENT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "expression.h"
#include "../xml/xml.h"

enum {
    DOCUMENT_MAX_FILE = 1 << 20,  /* bytes */
    DOCUMENT_MAX_NODES = 1 << 16, /* elements */
    DOCUMENT_NONE = -1            /* no node */
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

/* The attribute `type`; NODE_PLAIN if it is missing. A speed of type aim is NODE_ABSOLUTE, as in libbulletml. */
enum document_type { NODE_PLAIN, NODE_AIM, NODE_ABSOLUTE, NODE_RELATIVE, NODE_SEQUENCE };

struct document_node {
    enum document_element element;
    enum document_type type;
    const char *label;                 /* "": none */
    struct xml_place place;            /* of its "<" */
    int32_t parent, first, last, next; /* numbers of nodes, or DOCUMENT_NONE; children are in the order of the file */
    int32_t target;                    /* of a ref: the element it refers to */
    const struct expression_op *op;    /* of direction, speed, horizontal, vertical, term, times, wait, param */
    int ops;                           /* 0: no number */
};

struct document {
    struct document_node *node; /* [0] is bulletml; a node comes after its parent. malloc */
    int32_t n;
    bool horizontal; /* bulletml type="horizontal" */
    void *store;     /* labels and numbers; private to document.c */
};

/* Reads n bytes. file: the name for messages, which start with "bulletml/a.xml:12:7: ". warn (may be NULL) receives a
 * sentence for each construct that is valid but probably unintended. Free d in either case. */
bool document_read(struct document *d, const char *bytes, size_t n, const char *file,
                   void (*warn)(void *context, const char *sentence), void *context, char *err, size_t err_size);
void document_free(struct document *d);

/* Returns the name of an element, such as "changeDirection". */
const char *document_element_name(enum document_element element);

/* Returns the name of a type, such as "aim"; "" for NODE_PLAIN. */
const char *document_type_name(enum document_type type);

/* Returns the first child with the element, or DOCUMENT_NONE. */
int32_t document_child(const struct document *d, int32_t node, enum document_element element);

/* Returns the bullet, action or fire with a label: the last one in the file, at any depth; or DOCUMENT_NONE. `element`
 * may be that of a ref: bulletRef finds a bullet. */
int32_t document_find(const struct document *d, enum document_element element, const char *label);

/* Returns the highest parameter in a node's number; 0: none. */
int document_param(const struct document_node *node);

/* Returns whether the node is an action or a ref to one. */
bool document_is_action(const struct document *d, int32_t node);

/* Returns whether the node is an action that starts by itself, because its label starts with "top". */
bool document_is_top(const struct document *d, int32_t node);

#endif
