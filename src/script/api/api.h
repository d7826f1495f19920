/*
 * api.h - what the functions of the Lua API share: the check of arguments against the table (api_table.h), errors, the
 * script digest, declared names.
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

/* Under a motion's name when there was no room for its program: a bullet that names it flies straight. */
enum { NO_MOTION = 0x7fffffff };

/* An argument after the check. */
struct api_value {
    bool given;
    bool whole;   /* it is a whole number (Lua's integer) */
    int8_t type;  /* Lua's, LUA_T */
    int at;       /* its stack index */
    int64_t bits; /* a number's: the whole number, or those of the double */
    int64_t i;    /* whole number, handle, index of a kind, 0/1 */
    double n;
    fx f;
    ang a;
};

/* Said when board.nvram is full; a number of KiB. */
#define NO_NVRAM "nvram full (%d KiB); raise `board.nvram` in rom.lua"

enum { NVRAM_STEP = 32 /* bytes of nvram that are walked or moved at the price of a VM instruction */ };

#define PARAMS(list) list, sizeof list / sizeof *list
#define NO_PARAMS    NULL, 0

/* Puts the API into the globals and leaves the sys table on the stack. */
void api_open(lua_State *L);

/* Some tables of the API are made when a script first names them: pushes the one of that name, or false. */
bool api_open_late(lua_State *L, const char *name);

/* Makes all functions of the table at `at`, if it is one of the API's: for who walks over it. */
void api_fill(lua_State *L, int at);

/* Raises "FILE:LINE: entry: message". */
int api_error(lua_State *L, const char *entry, const char *format, ...);

/* Checks the value at `at` against p and fills v; raises the standard error. */
void api_check(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v);

/* Declared names: declare gives one its index (an error when it is taken), find returns the index or NO_SLOT, push
 * pushes the name of an index. */
void api_names_declare(lua_State *L, enum name_kind what, const char *entry, const char *name, int index);
int api_names_find(lua_State *L, enum name_kind what, const char *name);
void api_names_push(lua_State *L, enum name_kind what, int index);

/* Pushes the nearest of the declared names to a misspelt one, or nil. */
void api_names_suggest(lua_State *L, enum name_kind what, const char *name);

/* From now on a read of a reserved field is a fault; all tables must be there. */
void api_reserved_install(lua_State *L);

/* The tag's number, made when new; raises when 4,095 are used up. */
uint16_t api_tag(lua_State *L, const char *entry, int at);
void api_push_tag(lua_State *L, uint16_t tag);

/* The number of a register of player `slot`'s kind, or -1. */
int api_player_register(lua_State *L, const struct board *b, uint32_t slot, const char *name);

/* The number of a register of the run, or -1. */
int api_run_register(lua_State *L, const char *name);

/* Fills the stock of player p's bombs up to what one costs. */
void api_bomb_afford(lua_State *L, struct board *b, uint32_t p);

/* Player p's bomb begins, if its ship has one, has enough for it, and none is going on. */
bool api_bomb_start(lua_State *L, struct board *b, uint32_t p);

/* Drops the list of items on top of the stack (popped), which api_drops made, from that place; nothing if it is no
 * list. */
void api_drop_list(lua_State *L, struct board *b, fx x, fx y);

/* A place: x, y or from, moved by dx, dy: the parameters PLACE, which stand in an entry in this order. */
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

/* Reads a place from the values of PLACE. False: from is dead. */
bool api_place(lua_State *L, struct board *b, const char *entry, const struct api_value *v, fx *x, fx *y);

enum { ALIGN_LEFT, ALIGN_CENTER, ALIGN_RIGHT }; /* values of A_ALIGN */

/* Runs f(L) protected between two frames, then the effects of the events it raised; over `limit` of work it is a fault
 * too. False: a fault; the board's out does not have it. What was printed is in output->log. */
bool api_between(struct board *b, lua_CFunction f, uint64_t limit);

/* Fills the rom table (api_board.c). */
void api_rom_open(lua_State *L);

/* Pushes " (did you mean "x"?)" for the name of no global, or "". A local in sight is meant or, if it is read, a
 * global. */
const char *api_push_meant(lua_State *L, const char *name, bool read);

#endif
