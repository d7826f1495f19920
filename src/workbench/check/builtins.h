/*
 * builtins.h - the names a game's scripts may use: Lua's that the sandbox keeps, the API's, and the standard library's.
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

void name_set_close(struct name_set *s);

/* Adds a name, once. */
void name_set_add(struct name_set *s, const char *space, const char *name);

/* Is it there? space NULL: among the globals. */
bool name_set_has(const struct name_set *s, const char *space, const char *name);

/* The nearest name to a misspelt one, or NULL. */
const char *name_set_near(const struct name_set *s, const char *space, const char *name);

/* Fills *s with Lua's and the API's names. Close it. */
void builtins_open(struct name_set *s);

/* The same of Lua's names alone. */
void builtins_open_lua(struct name_set *s);

/* Adds what the standard library's script of that name hands to games: its globals ("prelude") or its table's fields.
 * False: what it returns cannot be told from its text. */
bool builtins_add_library(struct name_set *s, const char *script, const struct symbols *f);

/* A global of every game, whatever its scripts say. */
bool builtins_global(const char *name);

/* What a call of that function returns, when it is a handle: "bullet", "group" ...; else NULL. */
const char *builtins_handle(const char *space, const char *name);

/* Does that parameter of a function get a handle? of.arg and of.param are set. */
bool builtins_handed(const struct symbol_origin *of);

#endif
