/*
 * api_bomb.c - bomb.def, and starting a player's bomb. players_run.c starts bombs when the button is pressed, and ends
 * them.
 */
#include <string.h>
#include "../events_run.h"
#include "../../machine/sound.h"
#include "api_parts.h"

/* Registry: the list of bombs. Keys: number -> struct bomb, -number -> run function,
 * name -> number. */
static const char bombs_key = 0;

enum { MAX_BOMBS = 255, NAME_SIZE = 32 };

struct bomb {
    int32_t duration, safe_frames, cost;
    char stock_register[NAME_SIZE];
};

enum { D_NAME, D_OVER, D_RUN, D_SAFE, D_STOCK, D_COST };

static const struct api_param def_params[] = {
    LABEL("name", REQ, "name of the bomb, for `bomb` and `bomb_focus` in player.def; must be new"),
    PARAM("over", A_INT, REQ, 1, INT32_MAX, "frames", NULL,
          "duration of the bomb; then `run` stops, and everything that `run` started or spawned is removed"),
    REQUIRED("run", A_FUNC, "run(p): task of the bomb"),
    PARAM("safe", A_INT, OPT, 0, INT32_MAX, "frames", NULL,
          "frames for which nothing can hit the ship; defaults to `over`"),
    PARAM("stock", A_STR, OPT, 1, 31, NULL, "bombs", "name of the ship's register from which the bomb is paid"),
    PARAM("cost", A_INT, OPT, 0, INT32_MAX, NULL, "1", "amount that the bomb takes from `stock`; 0 needs no register"),
};

static int bomb_def(lua_State *L, struct board *b, struct api_value *v)
{
    const char *name = lua_tostring(L, v[D_NAME].at);

    (void)b;
    vm_push_registry_table(L, &bombs_key);
    const int list = lua_gettop(L);
    const lua_Integer n = (lua_Integer)lua_rawlen(L, list) + 1;
    if (lua_getfield(L, list, name) != LUA_TNIL)
        return api_error(L, "bomb.def", "bomb \"%s\" is already declared", name);
    if (n > MAX_BOMBS)
        return api_error(L, "bomb.def", "too many bombs (at most %d)", MAX_BOMBS);
    struct bomb *bomb = lua_newuserdatauv(L, sizeof *bomb, 0);
    memset(bomb, 0, sizeof *bomb);
    bomb->duration = (int32_t)v[D_OVER].i;
    bomb->safe_frames = v[D_SAFE].given ? (int32_t)v[D_SAFE].i : bomb->duration;
    bomb->cost = (int32_t)v[D_COST].i;
    strcpy(bomb->stock_register, v[D_STOCK].given ? lua_tostring(L, v[D_STOCK].at) : "bombs");
    lua_rawseti(L, list, n);
    lua_pushvalue(L, v[D_RUN].at);
    lua_rawseti(L, list, -n);
    lua_pushinteger(L, n);
    lua_setfield(L, list, name);
    return 0;
}

/* Pushes the list of bombs; returns bomb i (from 1). */
static const struct bomb *get_bomb(lua_State *L, int i)
{
    vm_push_registry_table(L, &bombs_key);
    lua_rawgeti(L, -1, i);
    const struct bomb *bomb = lua_touserdata(L, -1);
    lua_pop(L, 1); /* the list keeps the bomb alive */
    return bomb;
}

static void raise_unknown_bomb(lua_State *L, const char *param_name, const char *name)
{
    struct api_suggestion s = { .word = name };

    vm_push_registry_table(L, &bombs_key);
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1))
        if (lua_type(L, -2) == LUA_TSTRING)
            api_consider(&s, lua_tostring(L, -2));
    api_error(L, "player.def", "%s: unknown bomb \"%s\"%s", param_name, name,
              api_push_did_you_mean(L, &s, " (declare it with bomb.def first)"));
}

uint8_t api_find_bomb(lua_State *L, const char *param_name, int32_t ship, const struct api_value *v)
{
    const int top = lua_gettop(L);

    if (!v->given)
        return 0;
    const char *name = lua_tostring(L, v->at);
    vm_push_registry_table(L, &bombs_key);
    if (lua_getfield(L, -1, name) != LUA_TNUMBER)
        raise_unknown_bomb(L, param_name, name);
    const int i = (int)lua_tointeger(L, -1);
    const struct bomb *bomb = get_bomb(L, i);
    if (bomb->cost)
        api_register_expect(L, "player.def", lua_pushfstring(L, "%s: stock of bomb \"%s\"", param_name, name), ship,
                            bomb->stock_register);
    lua_settop(L, top);
    return (uint8_t)i;
}

/* Subtracts the bomb's cost from player p's stock. Returns false if the stock is too low. */
static bool pay_cost(lua_State *L, struct board *b, uint32_t p, const struct bomb *bomb)
{
    const int reg = bomb->cost ? api_find_player_register(L, b, p, bomb->stock_register) : -1;

    if (reg < 0)
        return true;
    const int32_t stock = board_get_register(b, p, (uint32_t)reg);
    if (stock < bomb->cost)
        return false;
    board_set_register(b, p, (uint32_t)reg, (int64_t)stock - bomb->cost);
    return true;
}

void api_bomb_ensure_stock(lua_State *L, struct board *b, uint32_t p)
{
    const struct player_kinds *k = &b->player_kinds;
    const int numbers[] = { k->bomb[b->player.kind[p]], k->bomb_focus[b->player.kind[p]] }, top = lua_gettop(L);

    for (int i = 0; i < 2; i++) {
        const struct bomb *bomb = numbers[i] ? get_bomb(L, numbers[i]) : NULL;
        const int reg = bomb && bomb->cost ? api_find_player_register(L, b, p, bomb->stock_register) : -1;
        if (reg >= 0 && board_get_register(b, p, (uint32_t)reg) < bomb->cost)
            board_set_register(b, p, (uint32_t)reg, bomb->cost);
    }
    lua_settop(L, top);
}

bool api_bomb_start(lua_State *L, struct board *b, uint32_t p)
{
    struct player *s = &b->player;
    const struct player_kinds *k = &b->player_kinds;
    const uint16_t kind = s->kind[p];
    const bool is_focused = input_held(&b->input, p) & PAD_FOCUS, is_deathbomb = s->deathbomb_left[p];
    const int i = is_focused && k->bomb_focus[kind] ? k->bomb_focus[kind] : k->bomb[kind], top = lua_gettop(L);

    if (!s->in_game[p] || !i || s->bomb_left[p])
        return false;
    const struct bomb *bomb = get_bomb(L, i);
    if (!pay_cost(L, b, p, bomb))
        return lua_settop(L, top), false;
    s->deathbomb_left[p] = 0;
    s->bomb_left[p] = (uint32_t)bomb->duration;
    s->safe_left[p] = s->safe_left[p] > (uint32_t)bomb->safe_frames ? s->safe_left[p] : (uint32_t)bomb->safe_frames;
    s->bomb_scope[p] = tasks_new_scope(b, board_handle(b, H_PLAYER, (int32_t)p), true);
    lua_rawgeti(L, -1, -i);
    lua_pushinteger(L, board_handle(b, H_PLAYER, (int32_t)p));
    tasks_start(b, L, s->bomb_scope[p], 1);
    sound_play_cue(b, CUE_BOMB, b->player.x[p]);
    board_raise_event(b, EV_BOMB, board_handle(b, H_PLAYER, (int32_t)p), is_deathbomb);
    lua_settop(L, top);
    return true;
}

enum { ARG_SELF };

static const struct api_param self_params[] = { THING("self", REQ, 1 << H_PLAYER, "the thing itself") };

static int player_bomb(lua_State *L, struct board *b, struct api_value *v)
{
    const int64_t h = v[ARG_SELF].i;

    lua_pushboolean(L, board_is_alive(b, h) && api_bomb_start(L, b, handle_slot(h)));
    return 1;
}

static const struct api_entry entries[] = {
    { "bomb.def", bomb_def, PARAMS(def_params), 1, API_CHANGES | API_LOAD_ONLY, NULL,
      HELP("declares a bomb: a task that a ship starts, at a cost deducted from a register") },
    API_VERB("player:bomb", player_bomb, self_params, 1, "boolean",
             "starts the bomb of the player's ship; returns false if the ship has no bomb, can't pay for it or is "
             "still bombing"),
};
const struct api_module api_bomb = { entries, sizeof entries / sizeof *entries };
