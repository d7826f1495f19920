/*
 * lang.h - language files, lang/NAME.txt.
 *
 *     # a comment
 *     Press Start = Bitte Start drücken
 *     Wave %d\nof %d = Welle %d\nvon %d
 *
 * A line is `text = translation` in UTF-8. Spaces at its ends and around the = are ignored. Escapes: \n newline, \=
 * equals sign, \# number sign at the start, \\ backslash, and a backslash before a space that is not ignored.
 */
#ifndef WORKBENCH_LANG_H
#define WORKBENCH_LANG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { LANG_MAX_FILE = 1 << 20 /* bytes */ };

struct lang_line {
    const char *text, *words;
    int line;
};

struct lang {
    char *block;            /* all texts; malloc */
    struct lang_line *list; /* ascending by text; malloc */
    int n;
};

/* Reads n bytes. file: the name for messages. Free l in either case. */
bool lang_read(struct lang *l, const char *bytes, size_t n, const char *file, char *err, size_t err_size);
void lang_free(struct lang *l);

/* Makes the lump of words.h in *out (malloc); NULL: out of memory. Returns its size. */
size_t lang_make(const struct lang *l, uint8_t **out);

#endif
