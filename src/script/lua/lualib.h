/*
 * lualib.h - the library scripts see: stock Lua 5.4 without functions that are unbounded or differ between hosts.
 *
 * The remaining functions of base, string, table, math and utf8 behave as in Lua 5.4, except:
 * - pairs visits the keys that existed when it was called: integer keys in ascending order, then string keys in byte
 *   order. Keys of other types, and anything but a table, raise an error.
 * - table.sort is a stable merge sort that accepts any comparator, writes only elements that move, and leaves the table
 *   unchanged if a comparison fails.
 * - Converting a value to a string never shows an address, and writes NaN as "nan". Strings have no __pow.
 * - string.format refuses %a %A %p; %q writes an integral float in decimal and refuses a fraction.
 * - sin cos tan asin acos atan use trig.h: accurate to about 1e-9, or to x / 2^52 for large x.
 * - A malformed pattern is an error even if matching would not have reached the malformed part.
 * - load accepts source text only, reports what script.h forbids as a syntax error, and propagates an error in its
 *   reader.
 * - setmetatable refuses __gc, __mode, and a __call that is not a function.
 * - A string has at most MAX_TEXT bytes.
 * - pcall catches only what error and assert raise.
 *
 * Work done in C is charged with vm_charge. tests/unit/test_lua_reference.c compares this library with stock Lua.
 */
#ifndef SCRIPT_LUALIB_H
#define SCRIPT_LUALIB_H

#include <lua.h>
#include <stdbool.h>
#include <stddef.h>

/* Opens the stock base, string, table, math and utf8 libraries as globals, and replaces and removes functions in them.
 * Call it once, in a new state. Removes every name that lualib_retained_names does not list, including unknown globals,
 * print and require; the host provides its own print and require. */
void lualib_open(lua_State *L);

/* Returns the names remaining in a library ("math"; "": the globals), separated by spaces, or NULL if it does not
 * exist. */
const char *lualib_retained_names(const char *library);

/* Pushes and returns the string that tostring and print show for the value at idx. Honours __tostring and __name. */
const char *lualib_tolstring(lua_State *L, int idx, size_t *size);

/* lualib_is_raised returns whether the value at idx was raised by error or assert. It is then a wrapper (luaerror.c),
 * and lualib_push_error_value pushes the script's value that it carries. */
bool lualib_is_raised(lua_State *L, int idx);
void lualib_push_error_value(lua_State *L, int idx);

/* Pushes the traceback, taken where the fault was raised, of the first fault that passed through a pcall, or nil if
 * there was none. */
void lualib_push_trace(lua_State *L);

/* Raises an error if any metatable set with setmetatable has since gained a field that setmetatable refuses. Called
 * before each turn of the garbage collector. */
void lualib_check_metatables(lua_State *L);

/* Pops a __newindex and, below it, an __index, and sets them as the permanent metatable of the value that is then on
 * top. */
void lualib_seal(lua_State *L);

/* Strips the names of locals from the Lua function on top; chunk is the chunk name it was loaded with. For the
 * standard library, whose faults are then reported without names of locals. */
void lualib_strip_locals(lua_State *L, const char *chunk);

#endif
