/*
 * events_run.h - after the hits of a tick: the effects of this frame's events and the scripts' handlers, in the order
 * of the events.
 */
#ifndef SCRIPT_EVENTS_RUN_H
#define SCRIPT_EVENTS_RUN_H

#include "../machine/machine.h"
#include "tasks.h"
#include "vm.h"

/* The names of on.NAME: the first eleven in the order of enum event_kind, NULL for EV_SHOT, which has no handlers; then
 * those that only scripts raise. */
extern const char *const events_names[];

/* Applies all events, those raised meanwhile too. For vm_call. */
int events_run(lua_State *L);

/* Enemy i dies: score for player (1, 2; 0: nobody), sparks, EV_KILL. */
void events_enemy_die(struct board *b, lua_State *L, uint32_t i, uint32_t player);

/* Takes n from enemy i unless it is safe; true when that killed it. */
bool events_enemy_hurt(struct board *b, lua_State *L, uint32_t i, int32_t n, uint32_t player);

/* What an item of that kind is worth to player p where it is. */
int64_t events_item_points(const struct board *b, uint32_t p, uint16_t kind);

/* Handlers of events that only scripts raise, by the number of their name. */
enum { EV_PHASE = EV_SCRIPT, EV_STAGE, EV_START };

/* EV_GAME_OVER, if nobody is in, and nobody can go on. */
void events_game_over(struct board *b);

/* A game begins: calls the handlers of on.start at once. What they start belongs to that scope. */
void events_start(lua_State *L, int64_t game);

/* Player p loses a life: EV_DEATH. */
void events_player_die(struct board *b, uint32_t p);

/* Bombs, and the frames after a hit in which one saves: once a frame, before the moves. */
void events_players(struct board *b, lua_State *L);

/* Where player p enters and returns. */
void events_player_start(const struct board *b, uint32_t p, fx *x, fx *y);

/* Makes the empty tables of handlers. */
void events_open(lua_State *L);

/* Adds the function on top of the stack (popped) to the handlers of on.NAME, NAME = events_names[kind]. */
void events_on(lua_State *L, int kind);

/* Queues the n values on top of L's stack (popped) for the handlers of `name`. False: no such event. */
bool events_emit(struct board *b, lua_State *L, const char *name, int n);

/* Sets an enemy kind's run, on_hit, on_death, drops or parts to what is on top of the stack (popped). */
void events_set_function(lua_State *L, uint16_t kind, const char *what);

/* The same of the on_death, or nil, of the enemy just spawned in that slot. */
void events_set_death(lua_State *L, uint32_t slot);

/* The same of its drops: a list that api_drops made, or nil. */
void events_set_drops(lua_State *L, uint32_t slot);

/* Pushes what events_set_function set, or nil. */
void events_push_set(lua_State *L, uint16_t kind, const char *what);

/* Pushes an enemy kind's run, on_hit or on_death; false (nothing pushed): it has none. */
bool events_push_function(lua_State *L, uint16_t kind, const char *what);

#endif
