/*
 * api_parts.h - what the files of the API table share among themselves.
 * floor: board
 */
#ifndef BOARD_API_PARTS_H
#define BOARD_API_PARTS_H

#include "../api.h"

enum { MAX_PARAMS = 40 };

/* The entry of bullet.fire, whose parameters patterns (API_FIRE) take too. */
extern const struct api_entry *const api_fire;

/* An entry by name; NULL: none. */
const struct api_entry *api_find(const char *name);

/* "a bullet", "an enemy": a thing of that kind in a sentence. */
extern const char *const api_thing_names[HANDLES];

/* Keeps the better of two suggestions for a misspelt word: the nearer, then the first in byte order. *best is EDIT_FAR
 * and *found is NULL before the first call. */
void api_suggest_nearer(const char *word, const char *candidate, int *best, const char **found);

/* All parameters of an entry, those of bullet.fire that it takes included. */
int api_param_count(const struct api_entry *e);
const struct api_param *api_param_at(const struct api_entry *e, int i);

/* Checks the call's arguments (stack 1 to top), spreads them over the stack and fills v, one a parameter. */
void api_arguments(lua_State *L, const struct api_entry *e, struct api_value *v);

/* Folds the value at `at` into the script digest. */
void api_fold(lua_State *L, struct board *b, int at);

/* Sets the number type's metatable: handles' properties and methods. Pushes the table of a handle kind's methods. */
void api_open_handles(lua_State *L);
void api_push_methods(lua_State *L, int kind);

/* Whose hit shape it is: they may have different ones. */
enum hit_whose { HIT_PLAYERS, HIT_ENEMIES, HIT_BULLETS /* and shots */ };

/* What they may be, in words. */
extern const char *const api_hit_forms[];

/* A hit shape as rows of kinds (motion.h). */
struct api_shape {
    uint8_t shape;
    uint32_t rows;
    struct {
        fx a, b, x, y;
    } row[SHAPE_PARTS];
};

/* Reads the hit shape at `at`. */
struct api_shape api_hit(lua_State *L, const char *entry, int at, enum hit_whose whose);

/* Declares a kind of that shape; returns its index. */
int32_t api_kind(lua_State *L, const char *entry, struct slots *kinds, const struct shape_columns *k,
                 const struct api_shape *s);

/* Calls the function at stack index f with each live thing of a pool that has the tag (0: all), in slot order. Things
 * that come during the calls are not visited. */
int api_each(lua_State *L, struct board *b, enum handle_kind kind, const struct slots *s, const uint16_t *tags,
             uint32_t tag, int f);

/* Is it a property of that kind of thing? */
bool api_property(const struct api_thing *t, const char *name);

/* The number of a register of player `slot`'s kind, or -1. */
int api_player_register(lua_State *L, const struct board *b, uint32_t slot, const char *name);

/* Has any kind of player a register of that name? */
bool api_register_declared(lua_State *L, const char *name);

/* Names of a player kind's registers, in the order of their numbers; returns how many. Valid as long as the board. */
int api_player_registers(lua_State *L, int32_t kind, const char *names[PLAYER_REGISTERS]);

/* Player i enters as that kind of player; the kind's run starts as a task. */
int api_player_enter(lua_State *L, struct board *b, uint32_t i, uint16_t kind);

/* A wait of the running task is passed over, if the task is on its way to a practice mark (TASK_SKIPS); else nothing
 * happens. After MAX_SKIPS in one turn it is a fault, or, under PRACTICE_LIST, the task is stopped so that the others
 * go on. */
int api_pass_wait(lua_State *L, struct board *b);

/* Makes the tables of declared names. */
void api_open_names(lua_State *L);

#endif
