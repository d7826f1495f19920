/*
 * lualib.h - the library scripts see: stock Lua 5.4 without what is unbounded or differs between hosts.
 *
 * What stays of base, string, table, math and utf8 behaves as in Lua 5.4, with these differences. pairs visits whole
 * numbers ascending, then strings in byte order, as they were when it was called, and refuses other keys and what is
 * no table. table.sort is a stable merge sort that takes any comparator, writes only what moves and, when it fails,
 * leaves the table as it was. Texts never hold an address, a NaN is "nan", and there is no __pow of texts;
 * string.format refuses %a %A %p; its %q writes a whole float in decimal and refuses a fraction. sin cos tan asin
 * acos atan go through trig.h: good to about 1e-9, or to x / 2^52 where x is large. A malformed pattern is an error
 * even where matching would not have reached the flaw. load takes text only, what script.h forbids is an error as of
 * syntax, and an error in its reader is passed on. setmetatable refuses __gc, __mode, and a __call that is no
 * function. A text has MAX_TEXT bytes at most. pcall catches what error and assert raised and nothing else. Work in
 * C is charged with vm_charge. tests/unit/test_lua_reference.c compares the two.
 */
#ifndef SCRIPT_LUALIB_H
#define SCRIPT_LUALIB_H

#include <lua.h>
#include <stdbool.h>
#include <stddef.h>

/* Replaces and removes, once, right after the stock base, string, table, math and utf8 were opened into globals. What
 * is not listed goes, unknown globals included; so do print and require, which are the host's. */
void lualib_open(lua_State *L);

/* The names that stay of a library ("math"; "": the globals), with blanks between; NULL: there is no such library. */
const char *lualib_names(const char *library);

/* Pushes the text of the value at idx as tostring and print show it. Honours __tostring and __name. */
const char *lualib_tolstring(lua_State *L, int idx, size_t *size);

/* True for what error and assert raise: a carrier around the script's value. lualib_unwrap pushes that value. */
bool lualib_raised(lua_State *L, int idx);
void lualib_unwrap(lua_State *L, int idx);

/* Pushes the traceback of the first fault that went through a pcall, taken where it was raised, or nil. */
void lualib_trace(lua_State *L);

/* An error when a metatable that setmetatable ever set has got since what setmetatable refuses. Before each step of the
 * collector. */
void lualib_check_metatables(lua_State *L);

/* Takes two values off the stack: what answers reads of fields, and on top what answers writes. They become the
 * metatable of the value below, for good. */
void lualib_seal(lua_State *L);

/* The Lua function on top becomes one whose locals have no names; chunk is what it was loaded with. For the standard
 * library: a fault in it is told without the name of a local. */
void lualib_drop_locals(lua_State *L, const char *chunk);

#endif
