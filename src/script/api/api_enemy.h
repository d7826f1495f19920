/*
 * api_enemy.h - what the functions of enemies share: api_enemy.c, and api_body.c for those with parts.
 */
#ifndef SCRIPT_API_ENEMY_H
#define SCRIPT_API_ENEMY_H

#include "api_parts.h"

enum { MOST_RATE = ENEMY_MOST_RATE / ENEMY_WHOLE };

/* What a verb does with one enemy; and with the enemy or group that is its first argument. */
typedef void api_enemy_verb(lua_State *L, struct board *b, uint32_t i, const struct api_value *v);
int api_enemy_act(lua_State *L, struct board *b, api_enemy_verb *verb, const struct api_value *v);

/* A new enemy, without the task of its kind, or NO_SLOT. */
int32_t api_enemy_bring(lua_State *L, struct board *b, uint16_t kind, fx x, fx y, int64_t owner);

/* Starts its kind's run, if it has one. */
void api_enemy_run(lua_State *L, struct board *b, uint32_t i);

/* Keeps the parts that the table at `at` says for a kind. */
void api_body_define(lua_State *L, int32_t kind, int at);

/* Raises if a new part of a kind would be too deep. */
void api_body_check_depth(lua_State *L, const struct board *b, uint16_t kind, int64_t body);

/* Brings the parts of a new enemy's kind, and theirs; then starts their tasks. */
void api_body_spawn_parts(lua_State *L, struct board *b, uint32_t body);
void api_body_run_parts(lua_State *L, struct board *b, uint32_t body);

/* Properties, where there are bodies. set raises if i is no part, but for its rate. */
enum api_body_prop { BODY_RATE, BODY_DX, BODY_DY, BODY_SHARE, BODY_FOLLOW };
void api_body_get(lua_State *L, const struct board *b, uint32_t i, enum api_body_prop p);
void api_body_set(lua_State *L, struct board *b, uint32_t i, enum api_body_prop p, fx v);

#endif
