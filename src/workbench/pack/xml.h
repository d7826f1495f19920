/*
 * xml.h - reads XML element by element, for files that must be readable on a host without libexpat.
 *
 * UTF-8 alone. Comments, processing instructions and a document type without declarations are skipped; CDATA sections
 * and declared entities are refused. Every refusal is one sentence with file and line.
 */
#ifndef WORKBENCH_XML_H
#define WORKBENCH_XML_H

#include <stdbool.h>
#include <stddef.h>

enum { XML_ATTRIBUTES = 32, XML_NEST = 32 };

enum xml_event {
    XML_OPEN,  /* <name key="value"> */
    XML_CLOSE, /* </name>; of <name/> it follows XML_OPEN */
    XML_END,   /* of the document */
    XML_BAD    /* err has the sentence */
};

struct xml_attribute {
    const char *key, *value; /* character references are decoded */
};

struct xml {
    char *at, *end;
    const char *file;
    int line;
    const char *name; /* of the last element opened or closed */
    int name_line;
    struct xml_attribute attribute[XML_ATTRIBUTES];
    int n;                      /* attributes of the last element opened */
    const char *open[XML_NEST]; /* names of the elements around the place */
    int depth;
    bool empty, started; /* the last element was <name/>; the first one was met */
    char *err;
    size_t err_size;
};

/* Starts reading n bytes of text, which is changed and must outlive x; text[n] is 0. False and one sentence: the text
 * is not UTF-8. */
bool xml_start(struct xml *x, char *text, size_t n, const char *file, char *err, size_t err_size);

/* The next element's start or end; text other than blanks between them is refused. */
enum xml_event xml_next(struct xml *x);

/* Skips the rest of the element that was opened last, with all that is in it. */
bool xml_skip(struct xml *x);

/* Text up to the next tag: sets *text, returns its bytes. */
size_t xml_text(struct xml *x, const char **text);

/* The attribute's value; NULL: there is none of that name. */
const char *xml_value(const struct xml *x, const char *key);

/* Sets the sentence "FILE:LINE: what". Returns false. */
bool xml_refuse(struct xml *x, int line, const char *format, ...) __attribute__((format(printf, 3, 4)));

#endif
