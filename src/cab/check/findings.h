/*
 * findings.h - a list of what is wrong with a game: file, line, sentence.
 * floor: cab    used by: check
 */
#ifndef CAB_FINDINGS_H
#define CAB_FINDINGS_H

#include <stdbool.h>

struct finding {
    char *file, *text; /* malloc */
    int line;          /* 0: none */
    int order;         /* in which it came */
};

struct findings {
    struct finding *list;
    int n, room;
    bool failed; /* out of memory: some are lost */
};

/* Adds one, unless the same stands there already. */
void findings_add(struct findings *f, const char *file, int line, const char *format, ...);

/* Adds the sentence of a loader or a fault: "FILE:LINE: what", "FILE: what"; file is that of one that names none. */
void findings_add_sentence(struct findings *f, const char *file, const char *sentence);

/* Is there one at that place already? */
bool findings_at(const struct findings *f, const char *file, int line);

/* By file, line, and as they came. */
void findings_sort(struct findings *f);

/* A line a finding: "stages/one.lua:42: what". */
void findings_print(const struct findings *f, void (*line)(const char *));

void findings_close(struct findings *f);

#endif
