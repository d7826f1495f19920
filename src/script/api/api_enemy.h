/*
 * api_enemy.h - declarations shared by api_enemy.c and api_body.c (enemies with parts).
 */
#ifndef SCRIPT_API_ENEMY_H
#define SCRIPT_API_ENEMY_H

#include "api_parts.h"

enum { MAX_RATE = ENEMY_MAX_RATE / ENEMY_RATE_ONE };

/* Spawns an enemy without starting the task of its kind. Returns its slot, or NO_SLOT. */
int32_t api_enemy_spawn(lua_State *L, struct board *b, uint16_t kind, fx x, fx y, int64_t owner);

/* Starts the run function of enemy i's kind as a task, if the kind has one. */
void api_enemy_start_task(lua_State *L, struct board *b, uint32_t i);

/* Stores the parts listed in the table at `at` as the parts of an enemy kind. */
void api_body_define(lua_State *L, int32_t kind, int at);

/* Raises an error if an enemy of that kind, as a part of `body`, would be nested too deep. */
void api_body_check_depth(lua_State *L, const struct board *b, uint16_t kind, int64_t body);

/* api_body_spawn_parts spawns the parts of a new enemy and, recursively, the parts of those parts.
 * api_body_start_part_tasks then starts the tasks of all of them. */
void api_body_spawn_parts(lua_State *L, struct board *b, uint32_t body);
void api_body_start_part_tasks(lua_State *L, struct board *b, uint32_t body);

/* Properties that require `bodies` in rom.lua. api_body_set raises an error if enemy i is not a part, except for
 * BODY_RATE, which every enemy has. */
enum api_body_prop { BODY_RATE, BODY_DX, BODY_DY, BODY_SHARE, BODY_FOLLOW };
void api_body_get(lua_State *L, const struct board *b, uint32_t i, enum api_body_prop p);
void api_body_set(lua_State *L, struct board *b, uint32_t i, enum api_body_prop p, fx v);

#endif
