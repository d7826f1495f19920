/*
 * luakeys.h - a table's keys in an order that is the same on every run.
 *
 * lua_next visits keys in an order that differs between runs. These walk over all of them and choose: numbers come
 * first, then false, true, other types, and then text by its bytes.
 */
#ifndef SCRIPT_LUAKEYS_H
#define SCRIPT_LUAKEYS_H

#include <lua.h>
#include <stdbool.h>

/* The text of the key at `at`; NULL: it is none, or has a \0, which no name has. */
const char *luakeys_text(lua_State *L, int at);

/* Replaces the key on top (nil: before the first) by the next key of the table at `at`. Returns how many no order tells
 * from it, itself included: several tables, or functions. 0: there is none, and the key is popped. */
int luakeys_next(lua_State *L, int at);

/* Pushes the value to show for the key on top, for which luakeys_next returned `like`; of several: "...". */
void luakeys_push_value(lua_State *L, int at, int like);

/* Ends a C function that walked over a table: moves its n results to the bottom of its stack and clears the slots
 * above, where keys remain in an order that differs between runs. The counter of work (vm_count.c) weighs all slots of
 * a frame, stale ones included. Returns n. */
int luakeys_return(lua_State *L, int n);

/* Is the key on top, whose text is `key` (luakeys_text), one that the reader `of` knows? */
typedef bool luakeys_known(lua_State *L, const char *key, const void *of);

/* Pushes the first key of the table at `at` that is not known; false, and nothing is pushed: all are. */
bool luakeys_push_stray(lua_State *L, int at, luakeys_known *known, const void *of);

#endif
