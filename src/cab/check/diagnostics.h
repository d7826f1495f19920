/*
 * diagnostics.h - a list of what is wrong with a game: file, line, sentence.
 * floor: cab
 */
#ifndef CAB_DIAGNOSTICS_H
#define CAB_DIAGNOSTICS_H

#include <stdbool.h>

struct diagnostic {
    char *file, *text; /* malloc */
    int line;          /* 0: none */
    int order;         /* in which it came */
};

struct diagnostics {
    struct diagnostic *list;
    int n, room;
    bool failed; /* out of memory: some are lost */
};

/* Adds one, unless the same stands there already. */
void diagnostics_add(struct diagnostics *f, const char *file, int line, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Adds the sentence of a loader or a fault: "FILE:LINE: what", "FILE: what"; file is that of one that names none. */
void diagnostics_add_sentence(struct diagnostics *f, const char *file, const char *sentence);

/* Is there one at that place already? */
bool diagnostics_at(const struct diagnostics *f, const char *file, int line);

/* By file, line, and as they came. */
void diagnostics_sort(struct diagnostics *f);

/* A line a diagnostic: "stages/one.lua:42: what". */
void diagnostics_print(const struct diagnostics *f, void (*line)(const char *));

void diagnostics_close(struct diagnostics *f);

#endif
