/*
 * known.h - the names a game's scripts may use: Lua's that the sandbox keeps, the API's, and the standard library's.
 * floor: cab    used by: check tests/
 */
#ifndef CAB_KNOWN_H
#define CAB_KNOWN_H

#include <stdbool.h>
#include "facts.h"

struct known_name {
    const char *space, *name; /* space NULL: a global */
};

struct known {
    struct arena arena;
    struct known_name *list;
    int n, room;
    bool failed; /* out of memory */
};

/* Fills *k with Lua's and the API's names. Close it. */
void known_open(struct known *k);
void known_close(struct known *k);

/* Adds a name, once. */
void known_add(struct known *k, const char *space, const char *name);

/* Adds what the standard library's script of that name hands to games: its globals ("prelude") or its table's fields.
 * False: what it returns cannot be told from its text. */
bool known_add_library(struct known *k, const char *script, const struct facts *f);

/* Is it there? space NULL: among the globals. */
bool known_has(const struct known *k, const char *space, const char *name);

/* The nearest name to a misspelt one, or NULL. */
const char *known_near(const struct known *k, const char *space, const char *name);

/* A global of every game, whatever its scripts say. */
bool known_global(const char *name);

/* What to use in place of a name that stock Lua has and the sandbox lacks (space NULL: a global); NULL: it is none. */
const char *known_instead(const char *space, const char *name);

/* What a call of that function returns, when it is a handle: "bullet", "group" ...; else NULL. */
const char *known_handle(const char *space, const char *name);

/* Does that parameter of a function get a handle? of.arg and of.param are set. */
bool known_handed(const struct fact_origin *of);

#endif
