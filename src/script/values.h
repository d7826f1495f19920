/*
 * values.h - serializes Lua values to bytes, to copy them between Lua states without sharing a board's heap.
 */
#ifndef SCRIPT_VALUES_H
#define SCRIPT_VALUES_H

#include <lua.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    VALUES_CAPACITY = 1 << 18, /* capacity, enough for the values a test inspects */
    VALUES_MAX_DEPTH = 8       /* nesting depth of tables */
};

struct values {
    uint8_t *bytes;
    size_t n, capacity;
    int count;
};

/* Serializes the whole stack: nil, booleans, numbers, strings, and tables of these. Any other value, and a table with
 * __tostring or __name, is stored as the string that print shows for it. Raises an error for tables nested deeper than
 * VALUES_MAX_DEPTH and for more than `capacity` bytes. */
void values_put(lua_State *L, struct values *v);

/* Pushes all stored values. Returns their count. */
int values_push(lua_State *L, const struct values *v);

/* Returns whether tostring shows the table at idx by its metatable's __tostring or __name. */
bool values_have_text_form(lua_State *L, int idx);

#endif
