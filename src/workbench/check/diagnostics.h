/*
 * diagnostics.h - the findings of `curtain check`: file, line, message.
 */
#ifndef WORKBENCH_DIAGNOSTICS_H
#define WORKBENCH_DIAGNOSTICS_H

#include <stdbool.h>

struct diagnostic {
    char *file, *text; /* malloc */
    int line;          /* 0: none */
    int order;         /* in which it was added */
    bool note;         /* may be intended */
};

struct diagnostics {
    struct diagnostic *list;
    int n;
    int notes;   /* how many of the n are notes */
    bool failed; /* out of memory: some are lost */
};

/* Adds a finding: a mistake. `curtain check` then exits with 1. */
void diagnostics_add(struct diagnostics *f, const char *file, int line, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Adds a note, which is printed after "note: " and does not change the exit code. */
void diagnostics_note(struct diagnostics *f, const char *file, int line, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Adds the message of a loader or a fault, "FILE:LINE: text" or "FILE: text". file: used if the message has none. */
void diagnostics_add_sentence(struct diagnostics *f, const char *file, const char *sentence);

/* Returns whether a finding at the position reports the name as missing. */
bool diagnostics_misses(const struct diagnostics *f, const char *file, int line, const char *name);

/* Sorts by file, line and order, and removes findings whose text is part of another finding at the same position. */
void diagnostics_sort(struct diagnostics *f);

/* Prints a line for each finding: "stages/one.lua:42: text". */
void diagnostics_print(const struct diagnostics *f, void (*line)(const char *));

void diagnostics_close(struct diagnostics *f);

#endif
