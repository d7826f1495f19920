/*
 * events_run.h - applies a frame's events, in order, after hit detection: carries out each event's effects and calls
 * the scripts' handlers.
 */
#ifndef SCRIPT_EVENTS_RUN_H
#define SCRIPT_EVENTS_RUN_H

#include "../machine/machine.h"
#include "tasks.h"
#include "vm.h"

/* Applies all queued events, including events raised by handlers in the process. Called through vm_call. */
int events_run(lua_State *L);

/* Kills enemy i: adds its score to `player` (1 or 2; 0: nobody), emits sparks, raises EV_KILL, drops items and calls
 * the enemy's on_death. */
void events_kill_enemy(struct board *b, lua_State *L, uint32_t i, uint32_t player);

/* Takes n hp from enemy i unless it is safe. Returns whether the enemy died. */
bool events_hurt_enemy(struct board *b, lua_State *L, uint32_t i, int32_t n, uint32_t player);

/* Returns the points that player p gets for taking an item of this kind at p's current position. */
int64_t events_item_points(const struct board *b, uint32_t p, uint16_t kind);

/* Events that only scripts raise. */
enum { EV_PHASE = EV_SCRIPT, EV_STAGE, EV_START };

/* Raises EV_GAME_OVER, once, if no player is in the game and none can continue. */
void events_check_game_over(struct board *b);

/* Calls the on.start handlers immediately. Tasks started by the handlers belong to the scope `game`. */
void events_call_start_handlers(lua_State *L, int64_t game);

/* Takes a life from player p and raises EV_DEATH. */
void events_kill_player(struct board *b, uint32_t p);

/* Starts and ends bombs, and counts down the deathbomb window after a hit. Called once a frame, before the moves. */
void events_step_players(struct board *b, lua_State *L);

/* Sets *x, *y to the position where player p enters and respawns. */
void events_get_start_position(const struct board *b, uint32_t p, fx *x, fx *y);

/* Adds the function on top of the stack (popped) to the handlers of the event `name`. */
void events_add_handler(lua_State *L, const char *name);

/* Queues the event `name` with the n values on top of L's stack (popped) as arguments. If there is no such event,
 * returns false and pops nothing. */
bool events_emit(struct board *b, lua_State *L, const char *name, int n);

/* Sets a kind's function, drops or parts, as named by `property` ("on_hit", "bullet's drops"), to the value on top of
 * the stack (popped). */
void events_set_property(lua_State *L, uint16_t kind, const char *property);

/* Sets on_death (a function or nil) or the drops (a list made by api_push_folded_drops, or nil) of the enemy just
 * spawned in `slot` to the value on top of the stack (popped). */
enum enemy_property { ENEMY_ON_DEATH = 1, ENEMY_DROPS = -1 };
void events_set_enemy_property(lua_State *L, uint32_t slot, enum enemy_property property);

/* Pushes the value that events_set_property set for this kind and `property`, or nil. */
void events_push_property(lua_State *L, uint16_t kind, const char *property);

/* Pushes a kind's function such as "run" or "on_hit". Returns false, with nothing pushed, if the kind has none. */
bool events_push_function(lua_State *L, uint16_t kind, const char *property);

#endif
