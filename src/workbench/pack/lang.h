/*
 * lang.h - language files, lang/NAME.txt.
 *
 *     # a comment
 *     PRESS START = Bitte START drücken
 *     Wave %d\nof %d = Welle %d\nvon %d
 *
 * A line is `text = words`, UTF-8; blanks at its ends and around the = are ignored. Escapes: \n new line, \= equals
 * sign, \# number sign at the start, \\ backslash, and a backslash before a blank that is not ignored.
 */
#ifndef WORKBENCH_LANG_H
#define WORKBENCH_LANG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LANG_FILE = 1 << 20 /* bytes */ };

struct lang_line {
    const char *text, *words;
    int line;
};

struct lang {
    char *block;            /* all texts; malloc */
    struct lang_line *list; /* ascending by text; malloc */
    int n;
};

/* Reads the n bytes; file is their name for messages. False and one sentence; close it either way. */
bool lang_read(struct lang *l, const char *bytes, size_t n, const char *file, char *err, size_t err_size);
void lang_close(struct lang *l);

/* The lump of words.h; *out is malloc, NULL: out of memory. */
size_t lang_make(const struct lang *l, uint8_t **out);

#endif
