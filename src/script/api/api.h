/*
 * api.h - declarations shared by the Lua API: argument checks against the table (api_table.h), errors, the script
 * digest, declared names.
 */
#ifndef SCRIPT_API_H
#define SCRIPT_API_H

#include <lauxlib.h>
#include <lua.h>
#include <stdbool.h>
#include <stdint.h>
#include "../../base/fx.h"
#include "api_table.h"
#include "../../machine/machine.h"
#include "../tasks.h"
#include "../vm.h"

/* The value under a motion's name when its program did not fit: bullets with that motion fly straight. */
enum { NO_MOTION = 0x7fffffff };

/* An argument, filled in by the check. */
struct api_value {
    bool given;
    bool whole;   /* true for a Lua integer */
    int8_t type;  /* Lua type, LUA_T... */
    int at;       /* stack index */
    int64_t bits; /* of a number: the integer itself, or the bits of the double */
    int64_t i;    /* integer, handle, index of a kind, or 0/1 */
    double n;
    fx f;
    ang a;
};

/* The error when board.nvram is full; %d is its size in KiB. */
#define NO_NVRAM "nvram full (%d KiB); raise `board.nvram` in rom.lua"

enum { NVRAM_STEP = 32 /* bytes of nvram scanned or moved per VM instruction charged */ };

#define PARAMS(list) list, sizeof list / sizeof *list
#define NO_PARAMS    NULL, 0

/* Sets the globals of the API and leaves the sys table on the stack. */
void api_open(lua_State *L);

/* Pushes the API table `name` if it is one of those created on first use, otherwise false. */
bool api_open_late(lua_State *L, const char *name);

/* Creates all functions of the table at `at` if it is an API table; call it before iterating over the table. */
void api_fill(lua_State *L, int at);

/* Raises "FILE:LINE: entry: message". */
int api_error(lua_State *L, const char *entry, const char *format, ...);

/* Checks the value at `at` against p and fills v; raises the standard error if it does not match. */
void api_check(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v);

/* Declared names: declare binds a name to an index (an error if the name is taken), find returns the index or NO_SLOT,
 * push pushes the name of an index. */
void api_names_declare(lua_State *L, enum name_kind what, const char *entry, const char *name, int index);
int api_names_find(lua_State *L, enum name_kind what, const char *name);
void api_names_push(lua_State *L, enum name_kind what, int index);

/* Pushes the declared name nearest to a misspelt one, or nil. */
void api_names_suggest(lua_State *L, enum name_kind what, const char *name);

/* Makes every later read of a reserved field a fault; all tables must exist already. */
void api_reserved_install(lua_State *L);

/* Returns the number of the tag at `at`, adding a new one; raises an error when all 4,095 are used. */
uint16_t api_tag(lua_State *L, const char *entry, int at);
void api_push_tag(lua_State *L, uint16_t tag);

/* Returns the number of a register of the ship kind of player `slot`, or -1. */
int api_player_register(lua_State *L, const struct board *b, uint32_t slot, const char *name);

/* Returns the number of a register of the run, or -1. */
int api_run_register(lua_State *L, const char *name);

/* Raises the bomb stock of player p to the cost of one bomb. */
void api_bomb_afford(lua_State *L, struct board *b, uint32_t p);

/* Starts player p's bomb if its ship has one, the stock pays for it, and none is running. Returns whether it
 * started. */
bool api_bomb_start(lua_State *L, struct board *b, uint32_t p);

/* Pops the list of items that api_drops made and drops the items at (x, y); does nothing if it is not such a list. */
void api_drop_list(lua_State *L, struct board *b, fx x, fx y);

/* The parameters PLACE, in this order in every entry: x, y or from, offset by dx, dy. */
enum { PLACE_X, PLACE_Y, PLACE_FROM, PLACE_DX, PLACE_DY, PLACE_PARAMS };
#define PLACE                                                                                                          \
    PARAM("x", A_FX, OPT, -WORLD, WORLD, "px", NULL, "horizontal position in the field; give `x` and `y`, or `from`"), \
        PARAM("y", A_FX, OPT, -WORLD, WORLD, "px", NULL, "vertical position in the field"),                            \
        PARAM("from", A_THING, OPT, PLACES, 0, NULL, NULL, "thing whose position is used instead of `x` and `y`"),     \
        PARAM("dx", A_FX, OPT, -WORLD, WORLD, "px", "0", "distance added to `x`, or to the position of `from`"),       \
        PARAM("dy", A_FX, OPT, -WORLD, WORLD, "px", "0", "distance added to `y`, or to the position of `from`")
enum {
    PLACES = 1 << H_BULLET | 1 << H_SHOT | 1 << H_ENEMY | 1 << H_PLAYER | 1 << H_SPRITE | 1 << H_ITEM | 1 << H_LASER |
             1 << H_OPTION,
    OWNERS = 1 << H_BULLET | 1 << H_SHOT | 1 << H_ENEMY | 1 << H_PLAYER | 1 << H_SPRITE | 1 << H_TASK | 1 << H_LASER |
             1 << H_OPTION,
};

/* Reads a position from the values of PLACE. Returns false if `from` is dead. */
bool api_place(lua_State *L, struct board *b, const char *entry, const struct api_value *v, fx *x, fx *y);

enum { ALIGN_LEFT, ALIGN_CENTER, ALIGN_RIGHT }; /* values of A_ALIGN */

/* Runs f(L) protected between two frames, then the effects of the events it raised. More than `limit` of work is a
 * fault. Returns false on a fault, which the board's `out` does not report. Printed text is in output->log. */
bool api_between(struct board *b, lua_CFunction f, uint64_t limit);

/* Fills the table rom (api_board.c). */
void api_rom_open(lua_State *L);

/* Pushes " (did you mean "x"?)" for the name of an unknown global, or "". Suggests a visible local or, if the name is
 * read, a global. */
const char *api_push_meant(lua_State *L, const char *name, bool read);

#endif
