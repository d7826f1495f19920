/*
 * help_lua.h - `curtain help lua`: the Lua API as text.
 */
#ifndef WORKBENCH_HELP_LUA_H
#define WORKBENCH_HELP_LUA_H

#include "../../script/api/api_table.h"

/* Prints every entry (NULL), the entry `name`, the entries of the table `name`, or those with this word in their name
 * or text. False: none. */
bool help_write(const char *name, void (*line)(const char *));

/* Returns the entry with the most similar name, or NULL. */
const char *help_nearest(const char *name);

/* Writes the values of an argument: "whole number from 0 to 15 (default 0)", or "(required)" at the end. */
void help_argument_words(const struct api_param *p, char *out, size_t size);

/* The same for a property: its type, with the range of writes. */
void help_property_words(const struct api_param *p, char *out, size_t size);

/* Print parts of the help: wrapped text, whose later lines are indented; an argument; an entry with its arguments, or
 * (not whole) on one line. */
void help_wrapped(const char *text, int indent, void (*line)(const char *));
void help_param(const struct api_param *p, void (*line)(const char *));
void help_entry(const struct api_entry *e, bool whole, void (*line)(const char *));

/* Print what has the word in its name or text, the best match first (false: nothing); and the functions by task. */
bool help_search(const char *word, void (*line)(const char *));
void help_tasks(void (*line)(const char *));

#endif
