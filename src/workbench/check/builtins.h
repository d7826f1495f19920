/*
 * builtins.h - the names that a game's scripts may use: those of Lua in the sandbox, the API and the standard library.
 */
#ifndef WORKBENCH_BUILTINS_H
#define WORKBENCH_BUILTINS_H

#include <stdbool.h>
#include "symbols.h"

struct name_set_entry {
    const char *space, *name; /* space NULL: a global */
};

/* Names of globals and of fields. */
struct name_set {
    struct arena arena;
    struct name_set_entry *list;
    int n;
    bool failed; /* out of memory */
};

void name_set_free(struct name_set *s);

/* Adds a name, once. */
void name_set_add(struct name_set *s, const char *space, const char *name);

/* Returns whether the set has the name; space NULL: as a global. */
bool name_set_has(const struct name_set *s, const char *space, const char *name);

/* Returns the name most similar to a misspelt one, or NULL. */
const char *name_set_nearest(const struct name_set *s, const char *space, const char *name);

/* Fills *s with the names of Lua and the API; free it with name_set_free. */
void builtins_open(struct name_set *s);

/* The same with the names of Lua only. */
void builtins_open_lua(struct name_set *s);

/* Adds the names that a script of the standard library defines: globals ("prelude"), or the fields of its table. False:
 * its table may have other fields. */
bool builtins_add_library(struct name_set *s, const char *script, const struct symbols *f);

/* Returns whether the name is a global of every game. */
bool builtins_global(const char *name);

/* Returns the kind of handle that a function returns ("bullet", "group"), or NULL. */
const char *builtins_handle(const char *space, const char *name);

/* Returns whether a parameter of a callback is a handle. arg and param are set. */
bool builtins_is_handle_param(const struct symbol_origin *of);

#endif
