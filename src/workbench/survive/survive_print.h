/*
 * survive_print.h - the results of `curtain survive` as text and as JSON.
 */
#ifndef WORKBENCH_SURVIVE_PRINT_H
#define WORKBENCH_SURVIVE_PRINT_H

#include "section.h"

struct survive_output {
    const char *section;              /* "": from the title */
    const char *difficulty;           /* "": the game has none */
    const char *demo, *picture, *map; /* files that were written; NULL: none */
};

/* Print a section's result to standard output, as lines of text or as a JSON object on one line. */
void survive_print_section(const struct survive_output *of, const struct section_run *s);
void survive_print_json(const struct survive_output *of, const struct section_run *s);

/* Print the head and a row of the table of --all. */
void survive_print_head(void);
void survive_print_row(const struct survive_output *of, const struct section_run *s);

/* The same with --bots. */
void survive_print_bots_head(void);
void survive_print_bots_row(const struct survive_output *of, const struct section_run *s);

#endif
