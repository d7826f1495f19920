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

/* Ends the reading with a sentence about a place. The first one counts. */
void document_bad(struct document_reader *r, struct xml_place place, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Tells a sentence about a node. */
void document_told(struct document_reader *r, int32_t node, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* A new node below parent, the last of its children; DOCUMENT_NONE: the reading has ended. */
int32_t document_add(struct document_reader *r, int32_t parent, enum document_element element, struct xml_place place);

/* n bytes that live as long as the document; NULL: out of memory, and the reading has ended. */
void *document_keep(struct document_reader *r, const void *bytes, size_t n);

/* The element of that name; NODE_ELEMENTS: there is none, and *near is the one that was meant, "": nobody knows. */
enum document_element document_element_of(const char *name, const char **near);

/* Has it a number for its text? */
bool document_has_number(enum document_element element);

/* What a ref's label is one of. */
enum document_element document_meant(enum document_element ref);

/* XML to the tree. */
void document_xml(struct document_reader *r, const char *bytes, size_t n);

/* Is each element where it may be, and has what it must have? */
void document_check(struct document_reader *r);

/* Of a document that passed. */
void document_warn(struct document_reader *r);

#endif
