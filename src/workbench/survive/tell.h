/*
 * tell.h - what was found, in words and as JSON.
 */
#ifndef WORKBENCH_TELL_H
#define WORKBENCH_TELL_H

#include "section.h"

/* Where it was looked. */
struct tell_of {
    const char *section;              /* "": from the title */
    const char *difficulty;           /* "": the game has none */
    const char *demo, *picture, *map; /* that were written; NULL: none */
};

/* Some lines on standard output, or a JSON object on one. */
void tell_section(const struct tell_of *of, const struct section_run *s);
void tell_json(const struct tell_of *of, const struct section_run *s);

/* A line of the table of --all, and the line above it. */
void tell_head(void);
void tell_row(const struct tell_of *of, const struct section_run *s);

/* The same of bots that fly on. */
void tell_bots_head(void);
void tell_bots_row(const struct tell_of *of, const struct section_run *s);

/* "proved unavoidable" */
const char *tell_verdict(enum seek_verdict v);

#endif
