/*
 * values.h - values of one Lua machine as bytes, for another one to have: nothing of a board's heap leaves it.
 */
#ifndef SCRIPT_VALUES_H
#define SCRIPT_VALUES_H

#include <lua.h>
#include <stddef.h>
#include <stdint.h>

enum {
    VALUES_BYTES = 1 << 18, /* room that is enough for what a test looks at */
    VALUES_DEEP = 8         /* tables in tables */
};

struct values {
    uint8_t *bytes;
    size_t n, room;
    int count;
};

/* Puts away the whole stack: nil, booleans, numbers, texts, and tables of these; what is none of them, as the words
 * that print has for it. Raises an error for tables deeper than VALUES_DEEP, and for more than there is room for. */
void values_put(lua_State *L, struct values *v);

/* Pushes all of them again; returns how many. */
int values_push(lua_State *L, const struct values *v);

#endif
