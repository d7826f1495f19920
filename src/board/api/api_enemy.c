/*
 * api_enemy.c - enemy.
 */
#include "../../base/trig.h"
#include "api_parts.h"
#include "../events_run.h"

enum {
    D_NAME,
    D_SPRITE,
    D_HIT,
    D_HP,
    D_SCORE,
    D_BANK,
    D_TOUCH,
    D_SPARK,
    D_DROPS,
    D_RUN,
    D_ON_HIT,
    D_ON_DEATH,
    D_SWEPT,
    D_BLEND,
    D_BLOCKS
};

static const struct api_param def[] = {
    { "name", A_STR, REQ, 0, 0, NULL, NULL },          { "sprite", A_SPRITE, REQ, 0, 0, NULL, NULL },
    { "hit", A_HIT, REQ, HIT_ENEMIES, 0, NULL, NULL }, { "hp", A_INT, OPT, 1, INT32_MAX, NULL, "1" },
    { "score", A_INT, OPT, 0, 1e12, "points", "0" },   { "bank", A_INT, OPT, 0, 15, NULL, "0" },
    { "touch", A_BOOL, OPT, 0, 0, NULL, "true" },      { "spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL },
    { "drops", A_TABLE, OPT, 0, 0, NULL, NULL },       { "run", A_FUNC, OPT, 0, 0, NULL, NULL },
    { "on_hit", A_FUNC, OPT, 0, 0, NULL, NULL },       { "on_death", A_FUNC, OPT, 0, 0, NULL, NULL },
    { "swept", A_BOOL, OPT, 0, 0, NULL, "true" },      { "blend", A_BLEND, OPT, 0, 0, NULL, NULL },
    { "blocks", A_BOOL, OPT, 0, 0, NULL, "false" },
};

static void keep_function(lua_State *L, const struct api_value *v, int32_t kind, const char *what)
{
    if (!v->given)
        return;
    lua_pushvalue(L, v->at);
    events_set_function(L, (uint16_t)kind, what);
}

static int enemy_def(lua_State *L, struct board *b, struct api_value *v)
{
    struct enemy_kinds *k = &b->enemy_kinds;

    if (v[D_DROPS].given)
        return api_error(L, "enemy.def", "drops: this board has no items yet");
    const struct api_shape shape = api_hit(L, "enemy.def", v[D_HIT].at, HIT_ENEMIES);
    const struct shape_columns columns = { k->shape, k->a, k->b, k->x, k->y };
    int32_t i = api_kind(L, "enemy.def", &k->s, &columns, &shape);
    api_names_declare(L, N_ENEMY, "enemy.def", lua_tostring(L, v[D_NAME].at), i);
    k->sprite[i] = (uint16_t)v[D_SPRITE].i;
    k->hp[i] = (int32_t)v[D_HP].i;
    k->score[i] = v[D_SCORE].i;
    k->bank[i] = (uint8_t)v[D_BANK].i;
    k->flags[i] = (uint8_t)((v[D_TOUCH].i ? ENEMY_TOUCH : 0) | (v[D_SWEPT].i ? ENEMY_SWEPT : 0) |
                            v[D_BLEND].i * ENEMY_BLEND_ONE | (v[D_BLOCKS].i ? ENEMY_BLOCKS : 0));
    k->spark[i] = v[D_SPARK].given ? (uint16_t)(v[D_SPARK].i + 1) : 0;
    keep_function(L, &v[D_RUN], i, "run");
    keep_function(L, &v[D_ON_HIT], i, "on_hit");
    keep_function(L, &v[D_ON_DEATH], i, "on_death");
    return 0;
}

enum { S_KIND, S_PLACE, S_PATH = S_PLACE + PLACE_PARAMS, S_MIRROR, S_HP, S_BANK, S_TAG, S_RUN, S_ON_DEATH, S_STAY };

static const struct api_param spawn[] = {
    { "kind", A_ENEMY_KIND, REQ, 0, 0, NULL, NULL }, PLACE,
    { "path", A_ROUTE, OPT, 0, 0, NULL, NULL },      { "mirror", A_BOOL, OPT, 0, 0, NULL, "false" },
    { "hp", A_INT, OPT, 1, INT32_MAX, NULL, NULL },  { "bank", A_INT, OPT, 0, 15, NULL, NULL },
    { "tag", A_STR, OPT, 0, 0, NULL, NULL },         { "run", A_FUNC, OPT, 0, 0, NULL, NULL },
    { "on_death", A_FUNC, OPT, 0, 0, NULL, NULL },   { "stay", A_BOOL, OPT, 0, 0, NULL, "false" },
};

/* A task owned by enemy h: the function at `at` gets h, then the n values on top of the stack (popped). */
static void start_task(lua_State *L, struct board *b, int64_t h, int n)
{
    lua_pushinteger(L, h);
    lua_insert(L, -n - 1);
    tasks_start(b, L, h, n + 1);
}

/* Routes belong to path.lua: path.place says where one starts, path.travel follows it and removes the enemy. */
static void path_start(lua_State *L, const struct api_value *v, fx *x, fx *y)
{
    double px, py;

    lua_getglobal(L, "path");
    lua_getfield(L, -1, "known");
    lua_pushvalue(L, v[S_PATH].at);
    lua_call(L, 1, 1);
    if (!lua_toboolean(L, -1))
        api_error(L, "enemy.spawn", "path: expected a route (what path.def returned)");
    lua_getfield(L, -2, "place");
    lua_rawgeti(L, v[S_PATH].at, 1);
    lua_pushboolean(L, (int)v[S_MIRROR].i);
    lua_pushnumber(L, v[S_PLACE + PLACE_DX].n);
    lua_pushnumber(L, v[S_PLACE + PLACE_DY].n);
    lua_call(L, 4, 2);
    px = lua_tonumber(L, -2);
    py = lua_tonumber(L, -1);
    if (!fx_from_double(px, x) || !fx_from_double(py, y))
        api_error(L, "enemy.spawn", "path: it starts outside the world");
    lua_pop(L, 4);
}

static void follow(lua_State *L, struct board *b, int64_t h, const struct api_value *v)
{
    lua_getglobal(L, "path");
    lua_getfield(L, -1, "travel");
    lua_remove(L, -2);
    lua_pushvalue(L, v[S_PATH].at);
    lua_pushboolean(L, (int)v[S_MIRROR].i);
    lua_pushnumber(L, v[S_PLACE + PLACE_DX].n);
    lua_pushnumber(L, v[S_PLACE + PLACE_DY].n);
    start_task(L, b, h, 4);
}

static int enemy_spawn(lua_State *L, struct board *b, struct api_value *v)
{
    uint16_t kind = (uint16_t)v[S_KIND].i;
    int64_t owner;
    fx x, y;

    if (v[S_PATH].given && (v[S_PLACE + PLACE_X].given || v[S_PLACE + PLACE_Y].given || v[S_PLACE + PLACE_FROM].given))
        return api_error(L, "enemy.spawn", "give a place or a path, not both");
    if (v[S_PATH].given)
        path_start(L, v, &x, &y);
    else if (!api_place(L, b, "enemy.spawn", v + S_PLACE, &x, &y))
        return lua_pushinteger(L, board_handle(b, H_ENEMY, NO_SLOT)), 1;
    if (!tasks_owner_of_new(b, v[S_STAY].i, &owner))
        return lua_pushinteger(L, board_handle(b, H_ENEMY, NO_SLOT)), 1;
    int32_t i = enemies_spawn(&b->enemies, &b->enemy_kinds, kind, x, y, b->core.clock);
    int64_t h = board_handle(b, H_ENEMY, i);
    if (i == NO_SLOT)
        board_full(b, &b->enemies.s);
    else {
        b->enemies.by[i] = tasks_serial(b);
        b->enemies.owner[i] = owner;
        if (v[S_HP].given)
            b->enemies.hp[i] = (int32_t)v[S_HP].i;
        if (v[S_BANK].given)
            b->enemies.bank[i] = (uint8_t)v[S_BANK].i;
        if (v[S_TAG].given)
            b->enemies.tag[i] = api_tag(L, "enemy.spawn", v[S_TAG].at);
        lua_pushvalue(L, v[S_ON_DEATH].at);
        events_set_death(L, (uint32_t)i);
        if (v[S_RUN].given)
            lua_pushvalue(L, v[S_RUN].at);
        if (v[S_RUN].given || events_push_function(L, kind, "run"))
            start_task(L, b, h, 0);
        if (v[S_PATH].given)
            follow(L, b, h, v);
    }
    lua_pushinteger(L, h);
    return 1;
}

enum { EACH_TAG, EACH_F, ARG_TAG = 0 };

static const struct api_param tag_f[] = { { "tag", A_STR, OPT, 0, 0, NULL, NULL },
                                          { "f", A_FUNC, REQ, 0, 0, NULL, NULL } };
static const struct api_param tag_only[] = { { "tag", A_STR, OPT, 0, 0, NULL, NULL } };

static int enemy_each(lua_State *L, struct board *b, struct api_value *v)
{
    uint32_t tag = v[EACH_TAG].given ? api_tag(L, "enemy.each", v[EACH_TAG].at) : 0;

    return api_each(L, b, H_ENEMY, &b->enemies.s, b->enemies.tag, tag, v[EACH_F].at);
}

static int enemy_count(lua_State *L, struct board *b, struct api_value *v)
{
    uint32_t tag = v[ARG_TAG].given ? api_tag(L, "enemy.count", v[ARG_TAG].at) : 0;
    lua_Integer n = 0;

    vm_charge(L, b->enemies.s.live);
    EACH_LIVE (i, &b->enemies.s)
        n += !(b->enemies.flags[i] & ENEMY_GONE) && (!tag || b->enemies.tag[i] == tag);
    lua_pushinteger(L, n);
    return 1;
}

/* ---- properties and verbs ---- */

enum { P_X, P_Y, P_HP, P_BANK, P_TAG, P_SAFE, P_KIND, P_AGE, PROPS };

static const struct api_prop props[PROPS] = {
    { { "x", A_FX, REQ, -WORLD, WORLD, "px", NULL }, PROP_WRITE, "where it is, px; a write ends its move" },
    { { "y", A_FX, REQ, -WORLD, WORLD, "px", NULL }, PROP_WRITE, "where it is, px; a write ends its move" },
    { { "hp", A_INT, REQ, 0, INT32_MAX, NULL, NULL }, PROP_WRITE, "hit points left" },
    { { "bank", A_INT, REQ, 0, 15, NULL, NULL }, PROP_WRITE, "palette banks to add" },
    { { "tag", A_STR, OPT, 0, 0, NULL, NULL }, PROP_WRITE, "its group's tag, or nil" },
    { { "safe", A_COUNT, REQ, 0, INT32_MAX, "frames", NULL }, PROP_WRITE, "frames it takes no damage, or forever" },
    { { "kind", A_ENEMY_KIND, REQ, 0, 0, NULL, NULL }, PROP_READ, "name of its kind" },
    { { "age", A_INT, REQ, 0, 0, NULL, NULL }, PROP_READ, "frames since it came" },
};

static void get(lua_State *L, struct board *b, uint32_t i, int p)
{
    const struct enemies *e = &b->enemies;

    switch (p) {
    case P_X:
        lua_pushnumber(L, fx_to_double(e->x[i]));
        break;
    case P_Y:
        lua_pushnumber(L, fx_to_double(e->y[i]));
        break;
    case P_HP:
        lua_pushinteger(L, e->hp[i]);
        break;
    case P_BANK:
        lua_pushinteger(L, e->bank[i]);
        break;
    case P_TAG:
        api_push_tag(L, e->tag[i]);
        break;
    case P_SAFE:
        lua_pushinteger(L, e->safe[i] == SAFE_FOREVER ? LUA_MAXINTEGER : e->safe[i]);
        break;
    case P_KIND:
        api_names_push(L, N_ENEMY, e->kind[i]);
        break;
    default:
        lua_pushinteger(L, b->core.clock - e->born[i]);
    }
}

static void set(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    struct enemies *e = &b->enemies;

    switch (p) {
    case P_X:
        e->x[i] = v->f;
        e->over[i] = 0;
        break;
    case P_Y:
        e->y[i] = v->f;
        e->over[i] = 0;
        break;
    case P_HP:
        e->hp[i] = (int32_t)v->i;
        break;
    case P_BANK:
        e->bank[i] = (uint8_t)v->i;
        break;
    case P_TAG:
        e->tag[i] = v->given ? api_tag(L, "tag", v->at) : 0;
        break;
    default:
        e->safe[i] = v->i == LUA_MAXINTEGER ? SAFE_FOREVER : (int32_t)v->i;
    }
}

const struct api_thing api_enemy_thing = { "enemy", props, PROPS, get, set };

enum { ARG_SELF, MOVE_X, MOVE_Y, MOVE_OVER, MOVE_EASE, HURT_HP = 1, KILL_PLAYER = 1 };

#define SELF                                                                                                           \
    {                                                                                                                  \
        "self", A_THING, REQ, 1 << H_ENEMY, 0, NULL, NULL                                                              \
    }
static const struct api_param move[] = {
    SELF,
    { "x", A_FX, REQ, -WORLD, WORLD, "px", NULL },
    { "y", A_FX, REQ, -WORLD, WORLD, "px", NULL },
    { "over", A_INT, REQ, 1, 1e9, "frames", NULL },
    { "ease", A_EASE, OPT, 0, 0, NULL, "linear" },
};
static const struct api_param hurt[] = { SELF, { "n", A_INT, REQ, 0, INT32_MAX, "hp", NULL } };
static const struct api_param kill_by[] = { SELF, { "p", A_PAD, OPT, 0, 0, NULL, NULL } };
static const struct api_param self[] = { SELF };

static int enemy_move(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    if (board_alive(b, v[ARG_SELF].i))
        enemies_go(&b->enemies, handle_slot(v[ARG_SELF].i), v[MOVE_X].f, v[MOVE_Y].f, (uint32_t)v[MOVE_OVER].i,
                   (enum ease)v[MOVE_EASE].i);
    return 0;
}

/* The player a script's kill counts for: the nearest living one, 1 or 2; 0: none. */
static uint32_t credit(const struct board *b, uint32_t i)
{
    struct targets t = board_players(b);

    return (uint32_t)(targets_nearest(&t, b->enemies.x[i], b->enemies.y[i]) + 1);
}

static int enemy_hurt_run(lua_State *L, struct board *b, struct api_value *v)
{
    if (board_alive(b, v[ARG_SELF].i))
        events_enemy_hurt(b, L, handle_slot(v[ARG_SELF].i), (int32_t)v[HURT_HP].i,
                          credit(b, handle_slot(v[ARG_SELF].i)));
    return 0;
}

static int enemy_kill(lua_State *L, struct board *b, struct api_value *v)
{
    uint32_t i = handle_slot(v[ARG_SELF].i);

    if (board_alive(b, v[ARG_SELF].i))
        events_enemy_die(b, L, i, v[KILL_PLAYER].given ? (uint32_t)v[KILL_PLAYER].i : credit(b, i));
    return 0;
}

static int enemy_remove(lua_State *L, struct board *b, struct api_value *v)
{
    uint32_t i = handle_slot(v[ARG_SELF].i);

    (void)L;
    /* also one that leaves in this frame: what else it touched is spared */
    if (board_there(b, v[ARG_SELF].i) && !(b->enemies.flags[i] & ENEMY_DYING))
        enemies_drop(&b->enemies, i);
    return 0;
}

static const struct api_entry entries[] = {
    { "enemy.def", enemy_def, PARAMS(def), 1, API_CHANGES | API_LOAD, NULL, "declares a kind of enemy" },
    { "enemy.spawn", enemy_spawn, PARAMS(spawn), 0, API_CHANGES, "enemy",
      "brings an enemy; run(e) is a task it owns; with a path it follows that and goes at its end; with stay the "
      "boss's phase "
      "it came from does not take it along" },
    { "enemy.each", enemy_each, PARAMS(tag_f), 2, API_CHANGES, NULL,
      "calls f(enemy) for each with that tag (nil: all), in slot order; f cannot wait" },
    { "enemy.count", enemy_count, PARAMS(tag_only), 1, 0, "count", "how many enemies live, of that tag or of all" },
    { "enemy:move", enemy_move, PARAMS(move), 1, API_CHANGES | API_METHOD, NULL,
      "starts a move to x, y and returns at once; in each frame it is at the nearest 1/65536 px of its way" },
    { "enemy:hurt", enemy_hurt_run, PARAMS(hurt), 2, API_CHANGES | API_METHOD, NULL, "damage, unless it is safe" },
    { "enemy:kill", enemy_kill, PARAMS(kill_by), 2, API_CHANGES | API_METHOD, NULL,
      "dies with score (p's; without p the nearest player's), spark and on_death" },
    { "enemy:remove", enemy_remove, PARAMS(self), 1, API_CHANGES | API_METHOD, NULL, "just goes" },
};
const struct api_module api_enemy = { entries, sizeof entries / sizeof *entries };
