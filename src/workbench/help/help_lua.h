/*
 * help_lua.h - `curtain help lua`: the Lua API as text.
 */
#ifndef WORKBENCH_HELP_LUA_H
#define WORKBENCH_HELP_LUA_H

#include "../../script/api/api_table.h"

/* "curtain help lua": every entry; the one of that name; those of that table; or what has the word `name` in its name
 * or text. Calls line for each line. False: none. */
bool help_write(const char *name, void (*line)(const char *));

/* The entry whose name is nearest to that; NULL: none is near. */
const char *help_nearest(const char *name);

/* What an argument may be, in words: "whole number from 0 to 15 (default 0)"; or "(required)" in the end. */
void help_argument_words(const struct api_param *p, char *out, size_t size);

/* The same of a property: what it reads as, with the range of what is written to it. */
void help_property_words(const struct api_param *p, char *out, size_t size);

/* Parts of the help: a line, wrapped, its later lines indented; an argument; an entry with its arguments or (not whole)
 * on a line. */
void help_wrapped(const char *text, int indent, void (*line)(const char *));
void help_param(const struct api_param *p, void (*line)(const char *));
void help_entry(const struct api_entry *e, bool whole, void (*line)(const char *));

/* All that has the word in its name or text, the nearest first; false: nothing has. And what to begin with. */
bool help_search(const char *word, void (*line)(const char *));
void help_tasks(void (*line)(const char *));

#endif
