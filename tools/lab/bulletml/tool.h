/*
 * tool.h - what `make bulletml` is made of.
 */
#ifndef BULLETML_TOOL_H
#define BULLETML_TOOL_H

#include "list.h"
#include "side.h"

#define TOOL_DOCUMENTS  "tools/lab/bulletml/documents.list"
#define TOOL_TESTS      "tests/bulletml"
#define TOOL_EXCEPTIONS "tools/lab/bulletml/last_bit.list"
#define TOOL_SHEET      "docs/images/bulletml.png"
enum { TOOL_SEED = 305419896, TOOL_EXCEPTIONS_MOST = 10 };

/* The page, or sections of it; each takes what is behind the program's name, or its own, and returns the exit code. */
int tool_page(int argc, char **argv);
int tool_answers(int argc, char **argv);
int tool_one(int argc, char **argv);

/* How many times as fast as libbulletml the board was, beside a plain host and a quick one: medians. */
struct tool_times {
    double scripted, scripted_quick, straight, straight_quick;
};

/* Takes times, as a section of the page. False: a run went wrong. */
bool tool_speed(struct tool_times *out);

/* Writes a PNG of 64 of the documents. False: a run went wrong, or it cannot be written. */
bool tool_sheet(const struct list *documents, const char *path);

#endif
