/*
 * luakeys.h - visits a table's keys in an order that is the same on every run.
 *
 * lua_next visits keys in an order that differs between runs. These functions scan all keys and pick the next one:
 * numbers first, then false, true, other types, and then strings in byte order.
 */
#ifndef SCRIPT_LUAKEYS_H
#define SCRIPT_LUAKEYS_H

#include <lua.h>
#include <stdbool.h>

/* Returns the string key at stack index `at`, or NULL if it is not a string or contains \0, which no name does. */
const char *luakeys_text(lua_State *L, int at);

/* Replaces the key on top (nil: before the first) by the next key of the table at `at`. Returns how many keys share
 * its place in the order, itself included: several tables or functions do. Pops the key and returns 0 at the end. */
int luakeys_next(lua_State *L, int at);

/* Pushes the value to show for the key on top. `like` is what luakeys_next returned; above 1 the value is "...". */
void luakeys_push_value(lua_State *L, int at, int like);

/* Ends a C function that walked a table: moves its n results to the bottom of its stack and clears the slots above,
 * where keys remain in an order that differs between runs. The work counter (vm_count.c) weighs all stack slots of a
 * call, stale ones included. Returns n. */
int luakeys_return(lua_State *L, int n);

/* Returns whether the key on top is known. `key` is its text (luakeys_text), `of` the context given to
 * luakeys_push_stray. */
typedef bool luakeys_known(lua_State *L, const char *key, const void *of);

/* Pushes the first unknown key of the table at `at`. Returns false, with nothing pushed, if all keys are known. */
bool luakeys_push_stray(lua_State *L, int at, luakeys_known *known, const void *of);

#endif
