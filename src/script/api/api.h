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

/* The index declared for a motion's name when a pool was too full for its program. Bullets with such a motion fly
 * straight. */
enum { NO_MOTION = 0x7fffffff };

/* An argument of a call, filled in when it is checked. */
struct api_value {
    bool given;
    bool is_integer; /* true for a Lua integer */
    int8_t type;     /* Lua type, LUA_T... */
    int at;          /* stack index */
    int64_t bits;    /* for a number: the integer itself, or the bits of the double */
    int64_t i;       /* integer, handle, index of a declared name, or 0/1 for a boolean */
    double n;
    fx f;
    ang a;
};

/* The error message when the nvram is full; %d is the size of the nvram in KiB. */
#define NVRAM_FULL_MESSAGE "nvram full (%d KiB); raise `board.nvram` in rom.lua"

enum { NVRAM_BYTES_PER_WORK = 32 /* bytes of nvram scanned or moved per VM instruction charged */ };

#define PARAMS(list) list, sizeof list / sizeof *list
#define NO_PARAMS    NULL, 0

/* The parameters of an entry, written as rows in the entry itself. */
#define PARAM_ROWS(...)      (const struct api_param[]){ __VA_ARGS__ }, PARAM_ROW_COUNT(__VA_ARGS__)
#define PARAM_ROW_COUNT(...) sizeof((const struct api_param[]){ __VA_ARGS__ }) / sizeof(struct api_param)

/* Sets the globals of the API and leaves the sys table on the stack. */
void api_open_globals(lua_State *L);

/* If `name` is an API table that is created on first use, pushes it and returns true. Otherwise returns false and
 * pushes nothing. */
bool api_push_lazy_table(lua_State *L, const char *name);

/* If the table at `at` is an API table, creates all of its functions. Call this before iterating over a table. */
void api_fill_table(lua_State *L, int at);

/* Raises "FILE:LINE: entry: message". */
int api_error(lua_State *L, const char *entry, const char *format, ...);

/* Checks the value at `at` against p and fills v; raises the standard error if the value does not match. */
void api_check(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v);

/* Declared names. api_names_declare binds a name to an index and raises an error if the name is taken. api_names_find
 * returns the index of a name, or NO_SLOT. api_names_push pushes the name of an index. */
void api_names_declare(lua_State *L, enum name_kind kind, const char *entry, const char *name, int index);
int api_names_find(lua_State *L, enum name_kind kind, const char *name);
void api_names_push(lua_State *L, enum name_kind kind, int index);

/* Makes later reads of missing fields of library tables explain why the field is missing (api_fault_missing_field).
 * Call this after all tables have been created. */
void api_explain_missing_fields(lua_State *L);

/* Pushes a handle, or nil for 0. */
static inline void api_push_handle(lua_State *L, int64_t h)
{
    if (h)
        lua_pushinteger(L, h);
    else
        lua_pushnil(L);
}

/* api_intern_tag returns the number of the tag whose name is at stack index `at`, and assigns a number to a new tag;
 * raises an error when all 4,095 are used. api_push_tag pushes a tag's name, or nil for 0. */
uint16_t api_intern_tag(lua_State *L, const char *entry, int at);
void api_push_tag(lua_State *L, uint16_t tag);

/* Returns the number of the register `name` of the ship that player `slot` flies, or -1 if the ship has none of that
 * name. */
int api_find_player_register(lua_State *L, const struct board *b, uint32_t slot, const char *name);

/* Returns the number of the run's register `name`, or -1 if there is none. */
int api_find_run_register(lua_State *L, const char *name);

/* Raises each of player p's bomb stocks, with and without focus, to the cost of one bomb if it is lower. */
void api_bomb_ensure_stock(lua_State *L, struct board *b, uint32_t p);

/* Starts player p's bomb if the ship has one, the stock covers its cost, and no bomb is running. Returns whether a bomb
 * started. */
bool api_bomb_start(lua_State *L, struct board *b, uint32_t p);

/* Pops a list of items packed by api_push_drops and drops the items at (x, y). Drops nothing if the popped value is not
 * such a list. */
void api_drop_items(lua_State *L, struct board *b, fx x, fx y);

/* Indices of the parameters PLACE, which are consecutive in every entry: the position x, y or the thing `from`, offset
 * by dx, dy. */
enum { POSITION_X, POSITION_Y, POSITION_FROM, POSITION_DX, POSITION_DY, POSITION_PARAM_COUNT };
#define POSITION_PARAMS                                                                                                \
    COORDINATE("x", A_FX, OPT, "horizontal position in the field; give `x` and `y`, or `from`"),                       \
        COORDINATE("y", A_FX, OPT, "vertical position in the field"), FROM_PARAMS
#define FROM_PARAMS                                                                                                    \
    THING("from", OPT, POSITION_HANDLE_KINDS, "thing whose position is used instead of `x` and `y`"),                  \
        OFFSET("dx", A_FX, "distance added to `x`, or to the position of `from`"),                                     \
        OFFSET("dy", A_FX, "distance added to `y`, or to the position of `from`")
enum {
    POSITION_HANDLE_KINDS = 1 << H_BULLET | 1 << H_SHOT | 1 << H_ENEMY | 1 << H_PLAYER | 1 << H_SPRITE | 1 << H_ITEM |
                            1 << H_LASER | 1 << H_OPTION,
    OWNER_HANDLE_KINDS = 1 << H_BULLET | 1 << H_SHOT | 1 << H_ENEMY | 1 << H_PLAYER | 1 << H_SPRITE | 1 << H_TASK |
                         1 << H_LASER | 1 << H_OPTION,
};

/* Reads a position from v, the values of the PLACE parameters. Returns false if the thing `from` is dead. */
bool api_read_position(lua_State *L, struct board *b, const char *entry, const struct api_value *v, fx *x, fx *y);

enum { ALIGN_LEFT, ALIGN_CENTER, ALIGN_RIGHT }; /* values of A_ALIGN */

/* Between two frames, runs f(L) in protected mode, then handles the events that f raised. Using more work than `limit`
 * is a fault. Returns false on a fault, which is not reported in the output's `out`. Printed text is in the output's
 * `log`. */
bool api_run_between_frames(struct board *b, lua_CFunction f, uint64_t limit);

/* Fills the table rom (api_board.c). */
void api_open_rom(lua_State *L);

/* Pushes " (did you mean "x"?)" for an unknown global name, or "" if no name is near. The suggestion is a visible local
 * or, if the script reads the name instead of assigning it, a global. */
const char *api_push_suggestion(lua_State *L, const char *name, bool is_read);

#endif
