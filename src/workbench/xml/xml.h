/*
 * xml.h - reads XML element by element.
 *
 * Comments, processing instructions and a document type without declarations are skipped; CDATA sections and declared
 * entities are errors. Every error has file and line.
 */
#ifndef WORKBENCH_XML_H
#define WORKBENCH_XML_H

#include <stdbool.h>
#include <stddef.h>

enum { XML_MAX_ATTRIBUTES = 32, XML_MAX_DEPTH = 64 };

enum xml_event {
    XML_OPEN,  /* <name key="value"> */
    XML_CLOSE, /* </name>; follows XML_OPEN for <name/> */
    XML_END,   /* of the document */
    XML_BAD    /* an error; err is set */
};

/* Line and column from 1; columns count characters. */
struct xml_place {
    int line, column;
};

struct xml_attribute {
    const char *key, *value; /* character references are decoded, and whitespace is replaced by spaces */
};

struct xml {
    char *text, *at, *end;
    const char *file;
    struct xml_place place; /* of `at` */
    const char *name;       /* of the last opened or closed element */
    struct xml_place start; /* of the "<" of the last tag */
    struct xml_attribute attribute[XML_MAX_ATTRIBUTES];
    int n;                           /* attributes of the last opened element */
    const char *open[XML_MAX_DEPTH]; /* names of the open elements */
    int depth;
    bool empty;       /* the last tag was <name/> */
    bool started;     /* the root element was opened */
    bool columns;     /* errors include the column */
    bool approximate; /* the encoding is not decoded, so non-ASCII characters are wrong (harmless in comments) */
    char *err;
    size_t err_size;
};

/* Copies n bytes in UTF-8, ISO-8859-1, Shift_JIS or EUC-JP. False: out of memory, another encoding, or invalid
 * characters. Close x in either case. */
bool xml_open(struct xml *x, const char *bytes, size_t n, const char *file, bool columns, char *err, size_t err_size);
void xml_close(struct xml *x);

/* Reads the next start or end of an element. Text in between is an error, except whitespace. */
enum xml_event xml_next(struct xml *x);

/* Skips the rest of the element that was opened last, with its content. */
bool xml_skip(struct xml *x);

/* Reads text up to the next tag or comment: sets *text and returns its size in bytes. */
size_t xml_text(struct xml *x, const char **text);

/* Skips a comment, processing instruction or document type, if there is one (*skipped). False: it has no end, or is not
 * supported. */
bool xml_skip_markup(struct xml *x, bool *skipped);

/* Returns the attribute's value, or NULL if it is missing. */
const char *xml_value(const struct xml *x, const char *key);

/* Returns the position after a character c at `place`. */
struct xml_place xml_next_place(struct xml_place place, char c);

/* Sets the sentence "FILE:LINE: ..." or "FILE:LINE:COLUMN: ...". Returns false. */
bool xml_refuse(struct xml *x, struct xml_place place, const char *format, ...) __attribute__((format(printf, 3, 4)));

#endif
