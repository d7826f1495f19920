/*
 * api_player.c - player, pad, score.
 */
#include <stdio.h>
#include <string.h>
#include "../../../base/edit.h"
#include "../../events_run.h"
#include "../api_parts.h"

extern const struct api_thing api_player_thing;

static const char registers_key = 0; /* registry: kind -> { name -> register } */

enum {
    D_NAME,
    D_SPRITE,
    D_HIT,
    D_GRAZE,
    D_SPEED,
    D_FOCUS,
    D_LIVES,
    D_SAFE,
    D_REGISTERS,
    D_RUN,
    D_MAGNET,
    D_LINE,
    D_FULL,
    D_PULL,
    D_PICTURES
};

static const struct api_param def[] = {
    { "name", A_STR, REQ, 0, 0, NULL, NULL },
    { "sprite", A_SPRITE, REQ, 0, 0, NULL, NULL },
    { "hit", A_HIT, REQ, HIT_PLAYERS, 0, NULL, NULL },
    { "graze", A_FX, OPT, 0, MAX_SPEED, "px", "16" },
    { "speed", A_FX, OPT, 0, MAX_SPEED, "px/frame", "4" },
    { "focus", A_FX, OPT, 0, MAX_SPEED, "px/frame", "2" },
    { "lives", A_INT, OPT, 1, MOST_LIVES, NULL, "3" },
    { "safe", A_INT, OPT, 0, 100000, "frames", "120" },
    { "registers", A_TABLE, OPT, 0, 0, NULL, NULL },
    { "run", A_FUNC, OPT, 0, 0, NULL, NULL },
    { "magnet", A_FX, OPT, 0, MAX_SPEED, "px", "24" },
    { "collect_line", A_FX, OPT, -WORLD, WORLD, "px", NULL },
    { "collect_full", A_STR, OPT, 1, 31, NULL, NULL },
    { "pull", A_FX, OPT, 0, MAX_SPEED, "px/frame", "6" },
    { "pictures", A_TABLE, OPT, 0, 0, NULL, NULL },
};

static const char *const first_pictures[] = { "left", "right", NULL };

static void registry(lua_State *L)
{
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &registers_key) == LUA_TTABLE)
        return;
    lua_pop(L, 1);
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &registers_key);
}

static const char shows_key = 0; /* registry: kind -> { register -> show }, of those that say it */

struct reg {
    const char *name, *show; /* show NULL: not said */
    int32_t start, most;     /* most 0: none */
};

static const char *const shows[] = { "none", "number", "icons", "bar", NULL };

/* How the register whose table is at `at` is shown. */
static const char *read_show(lua_State *L, int at, const char *name)
{
    lua_getfield(L, at, "show");
    const char *word = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : NULL;

    for (int i = 0; word && shows[i]; i++)
        if (!strcmp(shows[i], word))
            return lua_pop(L, 1), shows[i];
    if (!lua_isnil(L, -1))
        api_error(L, "player.def", "%s.show: expected none, number, icons or bar, got %s", name,
                  word ? lua_pushfstring(L, "\"%s\"", word) : luaL_typename(L, -1));
    lua_pop(L, 1);
    return NULL;
}

static int32_t register_field(lua_State *L, const char *name, const char *field, int at, int64_t lo)
{
    char full[64];
    struct api_value v = { 0 };

    snprintf(full, sizeof full, "%s.%s", name, field);
    const struct api_param p = { full, A_INT, OPT, (double)lo, INT32_MAX, NULL, NULL };
    lua_getfield(L, at, field);
    api_check(L, "player.def", &p, lua_gettop(L), &v);
    lua_pop(L, 1);
    return v.given ? (int32_t)v.i : 0;
}

/* Reads { start = 3, max = 6, show = "icons" } at `at`. */
static void register_table(lua_State *L, const char *name, int at, struct reg *r)
{
    for (lua_pushnil(L); lua_next(L, at); lua_pop(L, 1)) {
        const char *key = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : NULL;
        if (!key)
            api_error(L, "player.def", "%s: expected a whole number, or { start = n, max = n }", name);
        if (strcmp(key, "start") && strcmp(key, "max") && strcmp(key, "show"))
            api_error(L, "player.def", "%s: unknown setting \"%s\" (there are start, max, show)", name, key);
    }
    r->start = register_field(L, name, "start", at, 0);
    r->most = register_field(L, name, "max", at, 1);
    r->show = read_show(L, at, name);
    if (r->most && r->start > r->most)
        api_error(L, "player.def", "%s: start %d is more than max %d", name, (int)r->start, (int)r->most);
    if (!r->most && r->show && !strcmp(r->show, "bar"))
        api_error(L, "player.def", "%s: a bar needs a max", name);
}

/* The register whose name and value are on top. */
static struct reg read_register(lua_State *L)
{
    struct reg r = { 0 };
    struct api_value v = { 0 };
    char name[48];

    if (lua_type(L, -2) != LUA_TSTRING)
        api_error(L, "player.def", "registers: expected names with whole numbers");
    r.name = lua_tostring(L, -2);
    if (api_property(&api_player_thing, r.name))
        api_error(L, "player.def", "registers: \"%s\" is a property of every player already", r.name);
    snprintf(name, sizeof name, "registers.%s", r.name);
    if (lua_istable(L, -1)) {
        register_table(L, name, lua_gettop(L), &r);
        return r;
    }
    const struct api_param whole = { name, A_INT, REQ, 0, INT32_MAX, NULL, NULL };
    api_check(L, "player.def", &whole, lua_gettop(L), &v);
    r.start = (int32_t)v.i;
    return r;
}

/* Keeps how register i is shown. Only a game that says it has the table. */
static void keep_show(lua_State *L, int32_t kind, int i, const char *show)
{
    int top = lua_gettop(L);

    if (!show)
        return;
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &shows_key) != LUA_TTABLE) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &shows_key);
    }
    if (lua_rawgeti(L, -1, kind) != LUA_TTABLE) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_rawseti(L, -3, kind);
    }
    lua_pushstring(L, show);
    lua_rawseti(L, -2, i);
    lua_settop(L, top);
}

void api_register_show(lua_State *L, int32_t kind, int i)
{
    int top = lua_gettop(L);

    lua_pushnil(L);
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &shows_key) == LUA_TTABLE && lua_rawgeti(L, -1, kind) == LUA_TTABLE) {
        lua_rawgeti(L, -1, i);
        lua_replace(L, top + 1);
    }
    lua_settop(L, top + 1);
}

/* Registers get their numbers in byte order of their names, so that no table order decides. */
static void define_registers(lua_State *L, struct player_kinds *k, int32_t kind, int at)
{
    struct reg regs[PLAYER_REGISTERS];
    int n = 0;

    for (lua_pushnil(L); lua_next(L, at); lua_pop(L, 1)) {
        struct reg r = read_register(L);
        if (n == PLAYER_REGISTERS)
            api_error(L, "player.def", "registers: at most %d", PLAYER_REGISTERS);
        int i = n++;
        for (; i > 0 && strcmp(regs[i - 1].name, r.name) > 0; i--)
            regs[i] = regs[i - 1];
        regs[i] = r;
    }
    registry(L);
    lua_newtable(L);
    for (int i = 0; i < n; i++) {
        k->start[kind * PLAYER_REGISTERS + i] = regs[i].start;
        k->most[kind * PLAYER_REGISTERS + i] = regs[i].most;
        keep_show(L, kind, i, regs[i].show);
        lua_pushinteger(L, i);
        lua_setfield(L, -2, regs[i].name);
    }
    lua_rawseti(L, -2, kind);
    lua_pop(L, 1);
}

int api_ship_register(lua_State *L, int32_t kind, const char *name)
{
    int i = -1, top = lua_gettop(L);

    registry(L);
    if (lua_rawgeti(L, -1, kind) == LUA_TTABLE && lua_getfield(L, -1, name) == LUA_TNUMBER)
        i = (int)lua_tointeger(L, -1);
    lua_settop(L, top);
    return i;
}

int api_player_register(lua_State *L, const struct board *b, uint32_t slot, const char *name)
{
    return slot < PADS ? api_ship_register(L, b->player.kind[slot], name) : -1;
}

bool api_register_declared(lua_State *L, const char *name)
{
    int top = lua_gettop(L);
    bool found = false;

    registry(L);
    for (uint32_t kind = 0; !found && kind < vm_board(L)->player_kinds.s.live; kind++) {
        found = lua_rawgeti(L, -1, kind) == LUA_TTABLE && lua_getfield(L, -1, name) == LUA_TNUMBER;
        lua_settop(L, top + 1);
    }
    lua_settop(L, top);
    return found;
}

const char *api_register_near(lua_State *L, const char *name)
{
    const char *names[PLAYER_REGISTERS], *found = NULL;
    int best = EDIT_FAR;

    for (uint32_t kind = 0; kind < vm_board(L)->player_kinds.s.live; kind++)
        for (int n = api_player_registers(L, (int32_t)kind, names), i = 0; i < n; i++)
            api_suggest_nearer(name, names[i], &best, &found);
    return found;
}

int api_player_registers(lua_State *L, int32_t kind, const char *names[PLAYER_REGISTERS])
{
    int top = lua_gettop(L), n = 0;

    registry(L);
    if (lua_rawgeti(L, -1, kind) == LUA_TTABLE)
        for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1), n++)
            names[lua_tointeger(L, -1)] = lua_tostring(L, -2); /* the table keeps it */
    lua_settop(L, top);
    return n;
}

static const char run_key = 0; /* registry: kind -> run */

static void keep_run(lua_State *L, int32_t kind, int at)
{
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &run_key) != LUA_TTABLE) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &run_key);
    }
    lua_pushvalue(L, at);
    lua_rawseti(L, -2, kind);
    lua_pop(L, 1);
}

static void refuse_full(lua_State *L, int32_t kind, const char *name)
{
    const char *names[PLAYER_REGISTERS], *found = NULL;
    int best = EDIT_FAR;

    for (int n = api_player_registers(L, kind, names), i = 0; i < n; i++)
        api_suggest_nearer(name, names[i], &best, &found);
    if (found)
        api_error(L, "player.def", "collect_full: \"%s\" is no register of this ship (did you mean \"%s\"?)", name,
                  found);
    api_error(L, "player.def", "collect_full: \"%s\" is no register of this ship", name);
}

/* The register, + 1, at whose most all items come. */
static uint8_t full_register(lua_State *L, const struct player_kinds *k, int32_t kind, const struct api_value *full)
{
    const char *name = full->given ? lua_tostring(L, full->at) : "";
    int i = full->given ? api_ship_register(L, kind, name) : -1;

    if (!full->given)
        return 0;
    if (i < 0)
        refuse_full(L, kind, name);
    if (!k->most[kind * PLAYER_REGISTERS + i])
        api_error(L, "player.def", "collect_full: the register \"%s\" has no max (registers = { %s = { max = n } })",
                  name, name);
    return (uint8_t)(i + 1);
}

/* How the ship attracts items. */
static void define_items(lua_State *L, struct board *b, int32_t kind, const struct api_value *v)
{
    struct player_kinds *k = &b->player_kinds;
    const char *line = api_off(&b->cart.m, "item");

    for (int p = D_MAGNET; p <= D_PULL; p++)
        if (line && v[p].given)
            api_error(L, "player.def", "%s: " API_OFF, def[p].name, line);
    if (line)
        return;
    k->magnet[kind] = v[D_MAGNET].f;
    k->line[kind] = v[D_LINE].given ? v[D_LINE].f : FX_MIN;
    k->pull[kind] = v[D_PULL].f;
    k->full[kind] = full_register(L, k, kind, &v[D_FULL]);
}

static int player_def(lua_State *L, struct board *b, struct api_value *v)
{
    struct player_kinds *k = &b->player_kinds;

    fx r = api_hit(L, "player.def", v[D_HIT].at, HIT_PLAYERS).row[0].a;
    struct api_pictures pictures;
    uint32_t before = k->s.live;

    api_pictures_read(L, "player.def", &v[D_PICTURES], (uint16_t)v[D_SPRITE].i, first_pictures, PLAYER_PICTURES,
                      &pictures);
    api_pictures_rows(L, "player.def", &k->s, k->sprite, &pictures);
    for (; before < k->s.live; before++)
        k->radius[before] = PICTURE_ROW;
    int32_t i = slots_append(&k->s);
    if (i == NO_SLOT)
        return api_error(L, "player.def", "more than %d kinds", (int)k->s.cap);
    api_names_declare(L, N_PLAYER, "player.def", lua_tostring(L, v[D_NAME].at), i);
    k->sprite[i] = (uint16_t)v[D_SPRITE].i;
    k->radius[i] = r;
    k->graze[i] = v[D_GRAZE].f;
    k->speed[i] = v[D_SPEED].f;
    k->focus[i] = v[D_FOCUS].f;
    k->lives[i] = (int32_t)v[D_LIVES].i;
    k->safe[i] = (uint32_t)v[D_SAFE].i;
    if (v[D_REGISTERS].given)
        define_registers(L, k, i, v[D_REGISTERS].at);
    define_items(L, b, i, v);
    api_pictures_keep(L, N_PLAYER, i, &pictures);
    if (v[D_RUN].given)
        keep_run(L, i, v[D_RUN].at);
    return 0;
}

/* sys.join: in C because it starts the kind's task. */
int api_player_enter(lua_State *L, struct board *b, uint32_t i, uint16_t kind)
{
    fx x, y;

    if (b->player.in[i])
        player_leave(&b->player, i);
    if (player_retired(&b->player, i))
        return vm_fault(L, FAULT_SCRIPT, "player %d has been in %d games: the board has to be powered anew", (int)i + 1,
                        GENERATIONS - 1);
    b->player.in[i] = PLAYER_IN;
    for (uint32_t p = 0; p <= i; p++) { /* with two in, both stand aside */
        events_player_start(b, p, &x, &y);
        if (b->player.in[p] && p != i)
            player_place(&b->player, p, x, y);
    }
    player_join(&b->player, &b->player_kinds, i, kind, x, y);
    api_items_check(L, b);
    b->core.extended[i] = 0;
    b->core.over = 0;
    input_forget(&b->input, i, PRESS_GAME, PAD_ALL); /* earlier presses are not for its ship */
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &run_key) == LUA_TTABLE && lua_rawgeti(L, -1, kind) == LUA_TFUNCTION) {
        lua_pushinteger(L, board_handle(b, H_PLAYER, (int32_t)i));
        tasks_start(b, L, board_handle(b, H_PLAYER, (int32_t)i), 1);
    }
    return 0;
}

enum { ARG_PLAYER = 0, ARG_X = 0, ARG_Y = 1, ARG_F = 0 };

static const struct api_param index_only[] = { { "i", A_PAD, REQ, 0, 0, NULL, NULL } };
static const struct api_param xy[] = { { "x", A_FX, REQ, -WORLD, WORLD, "px", NULL },
                                       { "y", A_FX, REQ, -WORLD, WORLD, "px", NULL } };
static const struct api_param f_only[] = { { "f", A_FUNC, REQ, 0, 0, NULL, NULL } };

static int player_get(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushinteger(L, board_handle(b, H_PLAYER, (int32_t)v[ARG_PLAYER].i - 1));
    return 1;
}

static int player_nearest(lua_State *L, struct board *b, struct api_value *v)
{
    struct targets t = board_players(b);

    lua_pushinteger(L, board_handle(b, H_PLAYER, targets_nearest(&t, v[ARG_X].f, v[ARG_Y].f)));
    return 1;
}

static int player_each(lua_State *L, struct board *b, struct api_value *v)
{
    for (int32_t i = 0; i < PADS; i++) {
        if (!b->player.in[i])
            continue;
        lua_pushvalue(L, v[ARG_F].at);
        lua_pushinteger(L, board_handle(b, H_PLAYER, i));
        lua_call(L, 1, 0);
    }
    return 0;
}

enum { P_X, P_Y, P_LIVES, P_SAFE, P_FOCUS, P_GRAZES, P_SCORE, P_INDEX, P_KIND, P_PICTURE, P_FLIP_X, P_HIDDEN, PROPS };

static const struct api_prop props[PROPS] = {
    { { "x", A_FX, REQ, -WORLD, WORLD, "px", NULL }, PROP_WRITE, "where it is, px; a write is a teleport" },
    { { "y", A_FX, REQ, -WORLD, WORLD, "px", NULL }, PROP_WRITE, "where it is, px" },
    { { "lives", A_INT, REQ, 0, MOST_LIVES, NULL, NULL },
      PROP_WRITE,
      "lives left besides this one; -1 in on.death: that was the last" },
    { { "safe", A_INT, REQ, 0, INT32_MAX, "frames", NULL }, PROP_WRITE, "frames nothing can hit it" },
    { { "focus", A_BOOL, REQ, 0, 0, NULL, NULL }, PROP_READ, "is it moving slowly?" },
    { { "grazes", A_INT, REQ, 0, 0, NULL, NULL }, PROP_LASTS, "bullets grazed in this game" },
    { { "score", A_INT, REQ, 0, 0, NULL, NULL }, PROP_LASTS, "points; score.add changes them" },
    { { "index", A_INT, REQ, 0, 0, NULL, NULL }, PROP_LASTS, "1 or 2" },
    { { "kind", A_PLAYER_KIND, REQ, 0, 0, NULL, NULL }, PROP_LASTS, "name of its kind" },
    { { "picture", A_STR, OPT, 0, 0, NULL, NULL },
      PROP_WRITE,
      "which of its kind's pictures it shows; nil: the sprite, or left or right as it flies" },
    { { "flip_x", A_BOOL, REQ, 0, 0, NULL, NULL }, PROP_WRITE, "left and right exchanged" },
    { { "hidden", A_BOOL, REQ, 0, 0, NULL, NULL }, PROP_WRITE, "not drawn, but there as before" },
};

static const uint8_t flag_of[PROPS] = { [P_FLIP_X] = PLAYER_FLIP, [P_HIDDEN] = PLAYER_HIDDEN };

static void get(lua_State *L, struct board *b, uint32_t i, int p)
{
    const struct player *s = &b->player;

    switch (p) {
    case P_X:
        lua_pushnumber(L, fx_to_double(s->x[i]));
        break;
    case P_Y:
        lua_pushnumber(L, fx_to_double(s->y[i]));
        break;
    case P_LIVES:
        lua_pushinteger(L, s->lives[i]);
        break;
    case P_SAFE:
        lua_pushinteger(L, s->safe[i]);
        break;
    case P_FOCUS:
        lua_pushboolean(L, s->flags[i] & PLAYER_FOCUS);
        break;
    case P_PICTURE:
        api_picture_push(L, N_PLAYER, s->kind[i], s->flags[i] / PLAYER_PICTURE_ONE);
        break;
    case P_FLIP_X:
    case P_HIDDEN:
        lua_pushboolean(L, s->flags[i] & flag_of[p]);
        break;
    case P_GRAZES:
        lua_pushinteger(L, s->grazes[i]);
        break;
    case P_SCORE:
        lua_pushinteger(L, s->score[i]);
        break;
    case P_INDEX:
        lua_pushinteger(L, i + 1);
        break;
    default:
        api_names_push(L, N_PLAYER, s->kind[i]);
    }
}

static void set(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    struct player *s = &b->player;

    switch (p) {
    case P_X:
        player_place(s, i, v->f, s->y[i]);
        break;
    case P_Y:
        player_place(s, i, s->x[i], v->f);
        break;
    case P_LIVES:
        s->lives[i] = (int32_t)v->i;
        break;
    case P_PICTURE:
        s->flags[i] = (uint8_t)((unsigned)(s->flags[i] & ~(PLAYER_PICTURE | PLAYER_POSED)) |
                                api_picture_named(L, N_PLAYER, s->kind[i], "player", v) * PLAYER_PICTURE_ONE |
                                (v->given ? PLAYER_POSED : 0));
        break;
    case P_FLIP_X:
    case P_HIDDEN:
        s->flags[i] = (uint8_t)(v->i ? s->flags[i] | flag_of[p] : s->flags[i] & ~flag_of[p]);
        break;
    default:
        s->safe[i] = (uint32_t)v->i;
    }
}

const struct api_thing api_player_thing = { "player", props, PROPS, get, set };

/* ---- pad ---- */

enum { BUTTON_NAME, BUTTON_PLAYER };

static const struct api_param button[] = { { "button", A_BUTTON, REQ, 0, 0, NULL, NULL },
                                           { "p", A_PAD, OPT, 0, 0, NULL, "1" } };

enum { TAKE_BUTTON, TAKE_AGE, TAKE_PLAYER };

static const struct api_param take[] = { { "button", A_BUTTON, REQ, 0, 0, NULL, NULL },
                                         { "n", A_INT, REQ, 0, PRESS_KEPT, "frames", NULL },
                                         { "p", A_PAD, OPT, 0, 0, NULL, "1" } };

static int read_pad(lua_State *L, const struct board *b, const uint16_t *pads, const struct api_value *v)
{
    uint32_t p = (uint32_t)v[BUTTON_PLAYER].i - 1;

    lua_pushboolean(L, v[BUTTON_PLAYER].i && (pads[p] & ~board_withheld(b, p)) >> v[BUTTON_NAME].i & 1);
    return 1;
}

static int pad_down(lua_State *L, struct board *b, struct api_value *v)
{
    return read_pad(L, b, b->input.held, v);
}

static int pad_pressed(lua_State *L, struct board *b, struct api_value *v)
{
    return read_pad(L, b, b->input.pressed, v);
}

static int pad_take(lua_State *L, struct board *b, struct api_value *v)
{
    uint32_t p = (uint32_t)v[TAKE_PLAYER].i - 1, k = (uint32_t)v[TAKE_BUTTON].i;

    lua_pushboolean(L, v[TAKE_PLAYER].i && !(board_withheld(b, p) >> k & 1) &&
                           input_take(&b->input, p, k, (uint32_t)v[TAKE_AGE].i, board_presses(b)));
    return 1;
}

static int pad_released(lua_State *L, struct board *b, struct api_value *v)
{
    return read_pad(L, b, b->input.released, v);
}

static int pad_repeated(lua_State *L, struct board *b, struct api_value *v)
{
    return read_pad(L, b, b->input.repeated, v);
}

/* ---- score ---- */

enum { ADD_POINTS, ADD_PLAYER };

static const struct api_param add[] = { { "n", A_INT, REQ, -1e12, 1e12, "points", NULL },
                                        { "p", A_PAD, OPT, 0, 0, NULL, "1" } };

enum { ARG_TABLE };

static const struct api_param table_only[] = { { "table", A_STR, REQ, 1, 31, NULL, NULL } };

enum { ENTER_TABLE, ENTER_NAME, ENTER_SCORE };

static const struct api_param enter[] = { { "table", A_STR, REQ, 1, 31, NULL, NULL },
                                          { "name", A_STR, REQ, 1, NV_NAME, NULL, NULL },
                                          { "score", A_INT, REQ, -1e15, 1e15, "points", NULL } };

static int score_add(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    if (v[ADD_PLAYER].i && b->player.in[v[ADD_PLAYER].i - 1])
        board_score(b, (uint32_t)v[ADD_PLAYER].i - 1, v[ADD_POINTS].i);
    return 0;
}

static int score_rows(lua_State *L, struct board *b, struct api_value *v)
{
    char name[NV_NAME + 1];
    int64_t score;

    vm_charge(L, b->nvram.s.live / NVRAM_STEP);
    lua_newtable(L);
    for (int r = 0; nvram_row(&b->nvram, lua_tostring(L, v[ARG_TABLE].at), r, name, &score); r++) {
        lua_createtable(L, 0, 2);
        lua_pushstring(L, name);
        lua_setfield(L, -2, "name");
        lua_pushinteger(L, score);
        lua_setfield(L, -2, "score");
        lua_rawseti(L, -2, r + 1);
    }
    return 1;
}

static int score_enter(lua_State *L, struct board *b, struct api_value *v)
{
    vm_charge(L, b->nvram.s.live / NVRAM_STEP);
    int r =
        nvram_enter(&b->nvram, lua_tostring(L, v[ENTER_TABLE].at), lua_tostring(L, v[ENTER_NAME].at), v[ENTER_SCORE].i);

    if (r == -2)
        return api_error(L, "score.enter", NO_NVRAM, b->cart.m.nvram_kib);
    if (r < 0)
        return lua_pushnil(L), 1;
    if (!board_lists(b))
        board_add_marker(b, MARKER_ROW, lua_tostring(L, v[ENTER_TABLE].at), "", "", r + 1);
    lua_pushinteger(L, r + 1);
    return 1;
}

static const struct api_entry entries[] = {
    { "player.def", player_def, PARAMS(def), 1, API_CHANGES | API_LOAD, NULL, "declares a ship" },
    { "player.get", player_get, PARAMS(index_only), 1, 0, "player", "player 1 or 2, in the game or not" },
    { "player.nearest", player_nearest, PARAMS(xy), 2, 0, "player", "the living player nearest to a point" },
    { "player.each", player_each, PARAMS(f_only), 1, API_CHANGES, NULL,
      "calls f(player) for each in the game; f cannot wait" },
    { "pad.down", pad_down, PARAMS(button), 2, 0, "boolean", "is the button held?" },
    { "pad.pressed", pad_pressed, PARAMS(button), 2, 0, "boolean", "did it go down this frame?" },
    { "pad.take", pad_take, PARAMS(take), 3, API_CHANGES, "boolean",
      "takes a press at most n frames old, once: the oldest that nobody took; n = 0: of this frame" },
    { "pad.released", pad_released, PARAMS(button), 2, 0, "boolean", "did it come up this frame?" },
    { "pad.repeated", pad_repeated, PARAMS(button), 2, 0, "boolean",
      "pressed, then again every 5 frames once held for 20" },
    { "score.add", score_add, PARAMS(add), 2, API_CHANGES, NULL,
      "points for a player, from 0 to 999,999,999,999 in all; extends come by themselves" },
    { "score.rows", score_rows, PARAMS(table_only), 1, API_CHANGES, "list",
      "a lasting table's rows, best first: { name=, score= }" },
    { "score.enter", score_enter, PARAMS(enter), 1, API_CHANGES, "row",
      "enters a score into a lasting table; its row, or nil when it is not good enough" },
};
const struct api_module api_player = { entries, sizeof entries / sizeof *entries };
