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

/* Stops reading with an error. Only the first error is stored. */
void document_fail(struct document_reader *r, struct xml_place place, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Warns about a node. */
void document_warn_at(struct document_reader *r, int32_t node, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Appends a child to parent; DOCUMENT_NONE: an error, and reading has stopped. */
int32_t document_add(struct document_reader *r, int32_t parent, enum document_element element, struct xml_place place);

/* Copies n bytes for the document's lifetime; NULL: out of memory, and reading has stopped. */
void *document_store(struct document_reader *r, const void *bytes, size_t n);

/* Returns the element with the name; NODE_ELEMENTS: unknown, and *near is a similar name or "". */
enum document_element document_find_element(const char *name, const char **near);

/* Returns whether the element's text is a number. */
bool document_has_number(enum document_element element);

/* Returns the element to which a ref refers; for any other element, the element itself. */
enum document_element document_ref_element(enum document_element ref);

/* Reads the XML into the tree. */
void document_xml(struct document_reader *r, const char *bytes, size_t n);

/* Checks the structure of the document. */
void document_check(struct document_reader *r);

/* Adds warnings about a valid document. */
void document_warn(struct document_reader *r);

#endif
