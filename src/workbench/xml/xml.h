/*
 * xml.h - reads XML element by element.
 *
 * Comments, processing instructions and a document type without declarations are skipped; CDATA sections and declared
 * entities are errors. Every error is one sentence with file and line.
 */
#ifndef WORKBENCH_XML_H
#define WORKBENCH_XML_H

#include <stdbool.h>
#include <stddef.h>

enum { XML_ATTRIBUTES = 32, XML_NEST = 64 };

enum xml_event {
    XML_OPEN,  /* <name key="value"> */
    XML_CLOSE, /* </name>; follows XML_OPEN for <name/> */
    XML_END,   /* of the document */
    XML_BAD    /* err has the sentence */
};

/* Line and column from 1; columns count characters. */
struct xml_place {
    int line, column;
};

struct xml_attribute {
    const char *key, *value; /* character references are decoded, and blanks are spaces */
};

struct xml {
    char *text, *at, *end;
    const char *file;
    struct xml_place place; /* of at */
    const char *name;       /* of the last element opened or closed */
    struct xml_place start; /* of the "<" of the last tag */
    struct xml_attribute attribute[XML_ATTRIBUTES];
    int n;                      /* attributes of the last element opened */
    const char *open[XML_NEST]; /* names of the open elements */
    int depth;
    bool empty;       /* the last tag was <name/> */
    bool started;     /* the root element was opened */
    bool columns;     /* errors contain the column too */
    bool approximate; /* the encoding is only good enough for comments: other characters are ASCII or wrong */
    char *err;
    size_t err_size;
};

/* Reads a copy of n bytes, in UTF-8, ISO-8859-1, Shift_JIS or EUC-JP. False and one sentence: out of memory, another
 * encoding, or invalid characters. Close x either way. */
bool xml_open(struct xml *x, const char *bytes, size_t n, const char *file, bool columns, char *err, size_t err_size);
void xml_close(struct xml *x);

/* The next element's start or end. Text between them is an error, except blanks. */
enum xml_event xml_next(struct xml *x);

/* Skips the rest of the element that was opened last, with its content. */
bool xml_skip(struct xml *x);

/* Text up to the next tag or comment: sets *text, returns its size in bytes. */
size_t xml_text(struct xml *x, const char **text);

/* Skips one comment, processing instruction or document type. *skipped: there was one. False and one sentence: it has
 * no end, or is not supported. */
bool xml_skip_markup(struct xml *x, bool *skipped);

/* The attribute's value, or NULL if it is missing. */
const char *xml_value(const struct xml *x, const char *key);

/* The place of the character after c. */
struct xml_place xml_next_place(struct xml_place place, char c);

/* Sets the sentence "FILE:LINE: ..." or "FILE:LINE:COLUMN: ...". Returns false. */
bool xml_refuse(struct xml *x, struct xml_place place, const char *format, ...) __attribute__((format(printf, 3, 4)));

#endif
