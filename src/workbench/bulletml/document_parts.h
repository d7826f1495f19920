/*
 * document_parts.h - shared by document.c (the tree), document_xml.c (reading), document_check.c (errors in the
 * structure) and document_warn.c (warnings).
 */
#ifndef WORKBENCH_DOCUMENT_PARTS_H
#define WORKBENCH_DOCUMENT_PARTS_H

#include "document.h"

struct document_reader {
    struct document *d;
    const char *file;
    void (*warn)(void *context, const char *sentence);
    void *context;
    bool failed;
    char *err;
    size_t err_size;
};

/* Ends reading with a sentence about a place. The first one counts. */
void document_bad(struct document_reader *r, struct xml_place place, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Warns about a node. */
void document_suspect(struct document_reader *r, int32_t node, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Adds the last child of parent; DOCUMENT_NONE: reading has ended. */
int32_t document_add(struct document_reader *r, int32_t parent, enum document_element element, struct xml_place place);

/* Copies n bytes for the document's lifetime; NULL: out of memory, and reading has ended. */
void *document_keep(struct document_reader *r, const void *bytes, size_t n);

/* The element of that name; NODE_ELEMENTS: unknown, and *near is a similar name or "". */
enum document_element document_element_of(const char *name, const char **near);

/* True if its text is a number. */
bool document_has_number(enum document_element element);

/* The element that a ref's label names; any other element itself. */
enum document_element document_meant(enum document_element ref);

/* XML to the tree. */
void document_xml(struct document_reader *r, const char *bytes, size_t n);

/* Checks that each element is in its place and has all it needs. */
void document_check(struct document_reader *r);

/* Warns about a document that is valid. */
void document_warn(struct document_reader *r);

#endif
