/*
 * diagnostics.h - a list of what is wrong with a game, or may be: file, line, sentence.
 */
#ifndef WORKBENCH_DIAGNOSTICS_H
#define WORKBENCH_DIAGNOSTICS_H

#include <stdbool.h>

struct diagnostic {
    char *file, *text; /* malloc */
    int line;          /* 0: none */
    int order;         /* in which it came */
    bool note;         /* may be right: the game is fine all the same */
};

struct diagnostics {
    struct diagnostic *list;
    int n;
    int notes;   /* how many of the n are notes */
    bool failed; /* out of memory: some are lost */
};

/* Adds one, unless the same stands there already. */
void diagnostics_add(struct diagnostics *f, const char *file, int line, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* The same of what may be right: "note: " stands before it. */
void diagnostics_note(struct diagnostics *f, const char *file, int line, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Adds the sentence of a loader or a fault: "FILE:LINE: what", "FILE: what"; file is that of one that names none. */
void diagnostics_add_sentence(struct diagnostics *f, const char *file, const char *sentence);

/* Is there one at that place that says that nothing of that name is there? */
bool diagnostics_misses(const struct diagnostics *f, const char *file, int line, const char *name);

/* By file, line, and as they came. Of those at one place that say the same, or the same and more, one stays. */
void diagnostics_sort(struct diagnostics *f);

/* A line a diagnostic: "stages/one.lua:42: what". */
void diagnostics_print(const struct diagnostics *f, void (*line)(const char *));

void diagnostics_close(struct diagnostics *f);

#endif
