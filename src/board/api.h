/*
 * api.h - the Lua API as one table: names, arguments, units, help. It checks the arguments of every call, words the
 * errors, feeds the script digest, and prints `curtain help lua`. floor: board    used by: board/ cab/
 */
#ifndef BOARD_API_H
#define BOARD_API_H

#include <lauxlib.h>
#include <lua.h>
#include <stdbool.h>
#include <stdint.h>
#include "../base/fx.h"
#include "machine.h"

enum api_type {
    A_INT,   /* a whole number */
    A_COUNT, /* a whole number, or forever */
    A_NUM,   /* any finite number */
    A_FX,    /* a number kept in Q15.16 */
    A_DIR,   /* degrees */
    A_STR,
    A_BOOL,
    A_FUNC,
    A_TABLE,
    A_ANY,
    A_ROUTE,       /* what path.def returned */
    A_THING,       /* a handle; `lo` is a mask of 1 << handle_kind */
    A_HIT,         /* a hit shape */
    A_MOTION,      /* a motion, by handle or name */
    A_BULLET_KIND, /* names that were declared; A_BULLET_KIND + k is category k of enum api_names */
    A_SHOT_KIND,
    A_ENEMY_KIND,
    A_PLAYER_KIND,
    A_SPARK_KIND,
    A_SPRITE,
    A_BLEND, /* of rom.lua, by name; i is its index + 1, and 0 when it is left out */
    A_BUTTON,
    A_PAD, /* a player: 1, 2 or a player's handle; 0: the handle of nobody, as player.nearest may return */
    A_EASE,
    A_LAYER,
    A_ALIGN,
};

/* Under a motion's name when there was no room for its program: a bullet that names it flies straight. */
enum { NO_MOTION = 0x7fffffff };

enum { REQ = 0, OPT = 1 }; /* must it be given? */

struct api_param {
    const char *name;
    enum api_type type;
    int optional;
    double lo, hi;
    const char *unit; /* may be NULL */
    const char *def;  /* default, as Lua spells it; NULL: none */
};

/* An argument after the check. */
struct api_value {
    bool given;
    int at;    /* its stack index */
    int64_t i; /* whole number, handle, index of a kind, 0/1 */
    double n;
    fx f;
    ang a;
};

enum {
    API_CHANGES = 1 << 0, /* can change RAM: folded into the script digest */
    API_LOAD = 1 << 1,    /* only while scripts load */
    API_METHOD = 1 << 2,  /* the first argument is the thing before the colon */
    API_LUA = 1 << 3,     /* written in Lua (@std); the table only knows its arguments */
    API_SYS = 1 << 4,     /* only @std can call it */
    API_MORE = 1 << 5,    /* any further arguments are passed on */
    API_FIRE = 1 << 6,    /* takes every argument of bullet.fire besides its own */
    API_GLOBAL = 1 << 7,  /* stands among the globals */
};

struct api_entry {
    const char *name;                                               /* "bullet.fire", "bullet:aim", "wait" */
    int (*run)(lua_State *L, struct board *b, struct api_value *v); /* returns how many results it pushed */
    const struct api_param *params;
    uint8_t count; /* of params */
    uint8_t plain; /* so many are plain arguments; the others stand in one table */
    uint16_t flags;
    const char *returns; /* NULL: nothing */
    const char *help;
};

/* A property of a thing. PROP_LASTS: only read, and of a player even after it is out. */
enum { PROP_READ = 0, PROP_WRITE = 1, PROP_LASTS = 2 };

struct api_prop {
    struct api_param value; /* name, type, range, unit */
    int write;              /* PROP_ */
    const char *help;
};

/* What a kind of handle can do. get pushes property p of a live thing; set writes it. */
struct api_thing {
    const char *name; /* "bullet" */
    const struct api_prop *props;
    int n;
    void (*get)(lua_State *L, struct board *b, uint32_t slot, int p);
    void (*set)(lua_State *L, struct board *b, uint32_t slot, int p, const struct api_value *v);
};

struct api_module {
    const struct api_entry *entries;
    int n;
};

extern const struct api_thing *const api_things[HANDLES];
extern const struct api_module *const api_modules[];
extern const int api_module_count;

#define PARAMS(list) list, sizeof list / sizeof *list

/* Puts the API into the globals and leaves the sys table on the stack. */
void api_open(lua_State *L);

/* Raises "FILE:LINE: entry: message". */
int api_error(lua_State *L, const char *entry, const char *format, ...);

/* Checks the value at `at` against p and fills v; raises the standard error. */
void api_check(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v);

/* Names: declare gives a name its index (an error when it is taken), find looks one up (NO_SLOT), name pushes it back.
 */
void api_names_declare(lua_State *L, enum api_names what, const char *entry, const char *name, int index);
int api_names_find(lua_State *L, enum api_names what, const char *name);
void api_names_push(lua_State *L, enum api_names what, int index);

/* The name of an index, the last of several; NULL: it has none. Good until the next tick. */
const char *api_names_at(const struct board *b, enum api_names what, int index);

/* Pushes the nearest of the declared names to a misspelt one, or nil. */
void api_names_suggest(lua_State *L, enum api_names what, const char *name);

/* What is said of a name that is kept for what is not there yet. */
#define NOT_YET "is not there yet; the name is kept for it"

/* Is it such a name? of: a table of the API ("board"; "": the globals) with how '.', a function ("bullet.fire") with '{'
 * for an argument, a thing ("bullet") with ':' for a property or a verb. */
bool api_later(const char *of, char how, const char *name);

/* The i-th row of the list of such names, words with a blank between; NULL: there are no more. */
const char *api_later_row(int i, const char **of, char *how);

/* A read of such a field of the API's tables is a fault from now on; all tables must be there. */
void api_watch_fields(lua_State *L);

/* An argument's default as a number. */
double api_default(const struct api_param *p);

/* The tag's number, made when new; raises when 4,095 are used up. */
uint16_t api_tag(lua_State *L, const char *entry, int at);
void api_push_tag(lua_State *L, uint16_t tag);

/* "curtain help lua": every entry, or those whose name begins so; a line a call. False: none. */
bool api_help(const char *name, void (*line)(const char *));

/* Number of API entries and the i-th one's name; how often the running board's scripts called it (tests). */
int api_count(void);
const struct api_entry *api_entry(int i);

/* A place: x, y or from, moved by dx, dy. Indices are those of PLACE in the entry's params. False: from is dead. */
#define PLACE                                                                                                          \
    { "x", A_FX, OPT, -WORLD, WORLD, "px", NULL }, { "y", A_FX, OPT, -WORLD, WORLD, "px", NULL },                      \
        { "from", A_THING, OPT, PLACES, 0, NULL, NULL }, { "dx", A_FX, OPT, -WORLD, WORLD, "px", "0" },                \
    {                                                                                                                  \
        "dy", A_FX, OPT, -WORLD, WORLD, "px", "0"                                                                      \
    }
enum {
    PLACES = 1 << H_BULLET | 1 << H_SHOT | 1 << H_ENEMY | 1 << H_PLAYER | 1 << H_SPRITE,
    OWNERS = 1 << H_BULLET | 1 << H_SHOT | 1 << H_ENEMY | 1 << H_PLAYER | 1 << H_SPRITE | 1 << H_TASK,
};
bool api_place(lua_State *L, struct board *b, const char *entry, const struct api_value *v, fx *x, fx *y);

/* Fills the rom table (api_board.c). */
void api_rom_open(lua_State *L);

#endif
