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

/* Returns the key at stack index `at` if it is a string without \0 bytes (names contain none), otherwise NULL. */
const char *luakeys_text(lua_State *L, int at);

/* Replaces the key on top (nil to start) by the next key of the table at `at`. Returns the number of keys at this place
 * in the order, which is above 1 if several keys are, say, tables or functions. After the last key, pops the key and
 * returns 0. */
int luakeys_next(lua_State *L, int at);

/* Pushes the value to show for the key on top. `ties` is what luakeys_next returned; above 1 the value is "...". */
void luakeys_push_value(lua_State *L, int at, int ties);

/* Ends a C function that walked a table: moves the n results to the bottom of the stack and clears the slots above
 * them, which hold keys in an order that differs between runs. The work counter (vm_count.c) weighs all stack slots of
 * a call, stale ones included. Returns n. */
int luakeys_return(lua_State *L, int n);

/* Returns whether the key on top is known. `key` is its text (luakeys_text), `context` the context given to
 * luakeys_push_unknown. */
typedef bool luakeys_is_known(lua_State *L, const char *key, const void *context);

/* Pushes the first unknown key of the table at `at`. Returns false, with nothing pushed, if all keys are known. */
bool luakeys_push_unknown(lua_State *L, int at, luakeys_is_known *is_known, const void *context);

#endif
