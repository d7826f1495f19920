/*
 * tool.h - what `make bulletml` is made of.
 * floor: tools
 */
#ifndef BULLETML_TOOL_H
#define BULLETML_TOOL_H

#include "side.h"

#define TOOL_DOCUMENTS  "tools/bulletml/documents.list"
#define TOOL_TESTS      "tests/bulletml"
#define TOOL_EXCEPTIONS "tools/bulletml/last_bit.list"
enum { TOOL_SEED = 305419896, TOOL_EXCEPTIONS_MOST = 10 };

/* Each takes what is behind its name on the command line, and returns the exit code. */
int tool_answers(int argc, char **argv);
int tool_rounding(int argc, char **argv);
int tool_all(int argc, char **argv);
int tool_one(int argc, char **argv);

/* Takes times, as a section of the page; the medians of how many times as fast the board is. False: a run went wrong. */
bool tool_speed(double *scripted, double *straight_on);
int tool_speed_alone(int argc, char **argv);

#endif
