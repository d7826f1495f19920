/*
 * api_sys.c - sys, which only the standard library (@std) sees.
 */
#include <string.h>
#include "../../base/edit.h"
#include "../../../fb/utf8.h"
#include "api_parts.h"
#include "../events_run.h"
#include "../lasers_run.h"
#include "../sound.h"

/* Parameters by place; ARG_: the only one of its entry. */
enum { ARG_NAME = 0, ARG_PLAYER = 0, ARG_KIND = 0, ARG_OWNER = 0, ARG_SCOPE = 0, ARG_ON = 0 };
enum { FAIL_ENTRY, FAIL_MESSAGE };
enum { NEAR_WORD, NEAR_LIST };
enum { JOIN_PLAYER, JOIN_KIND };
enum { M_KIND, M_NAME, M_OF, M_TITLE, M_VALUE };
enum { HOLD_ENEMY, HOLD_ON };
enum { AIM_X, AIM_Y, AIM_SHOTS };
enum { DROPS_ENTRY, DROPS_LIST };
enum { DROP_LIST, DROP_X, DROP_Y };

static const struct api_param fail[] = { { "name", A_STR, REQ, 0, 0, NULL, NULL },
                                         { "message", A_STR, REQ, 0, 0, NULL, NULL } };
static const struct api_param sys_near[] = { { "word", A_ANY, REQ, 0, 0, NULL, NULL },
                                             { "list", A_TABLE, REQ, 0, 0, NULL, NULL } };
static const struct api_param join[] = { { "i", A_PAD, REQ, 0, 0, NULL, NULL },
                                         { "kind", A_PLAYER_KIND, REQ, 0, 0, NULL, NULL } };
static const struct api_param name_req[] = { { "name", A_STR, REQ, 0, 0, NULL, NULL } };
static const struct api_param pad_only[] = { { "i", A_PAD, REQ, 0, 0, NULL, NULL } };
static const struct api_param mark[] = { { "kind", A_STR, REQ, 0, 0, NULL, NULL },
                                         { "name", A_STR, REQ, 0, 0, NULL, NULL },
                                         { "of", A_STR, OPT, 0, 0, NULL, NULL },
                                         { "title", A_STR, OPT, 0, 0, NULL, NULL },
                                         { "value", A_INT, OPT, INT32_MIN, INT32_MAX, NULL, NULL } };
static const struct api_param ship[] = { { "kind", A_PLAYER_KIND, REQ, 0, 0, NULL, NULL } };
static const struct api_param owner_req[] = { { "owner", A_THING, REQ, OWNERS, 0, NULL, NULL } };
static const struct api_param scope_opt[] = { { "scope", A_THING, OPT, 1 << H_TASK, 0, NULL, NULL } };
static const struct api_param wipe[] = { { "keep", A_BOOL, OPT, 0, 0, NULL, NULL } };
static const struct api_param hold[] = { { "e", A_THING, REQ, 1 << H_ENEMY, 0, NULL, NULL },
                                         { "on", A_BOOL, REQ, 0, 0, NULL, NULL } };

static const struct api_param drops[] = { { "name", A_STR, REQ, 0, 0, NULL, NULL },
                                          { "drops", A_TABLE, REQ, 0, 0, NULL, NULL } };
static const struct api_param drop[] = { { "list", A_ANY, REQ, 0, 0, NULL, NULL },
                                         { "x", A_FX, REQ, -WORLD, WORLD, "px", NULL },
                                         { "y", A_FX, REQ, -WORLD, WORLD, "px", NULL } };

static int sys_fail(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    return api_error(L, lua_tostring(L, v[FAIL_ENTRY].at), "%s", lua_tostring(L, v[FAIL_MESSAGE].at));
}

static int sys_near_run(lua_State *L, struct board *b, struct api_value *v)
{
    int best = EDIT_FAR;
    lua_Integer found = 0, n = (lua_Integer)lua_rawlen(L, v[NEAR_LIST].at);

    (void)b;
    if (lua_type(L, v[NEAR_WORD].at) != LUA_TSTRING)
        return lua_pushnil(L), 1;
    for (lua_Integer i = 1; i <= n; i++) {
        if (lua_rawgeti(L, v[NEAR_LIST].at, i) == LUA_TSTRING) {
            int d = edit_distance(lua_tostring(L, v[NEAR_WORD].at), lua_tostring(L, -1));
            if (d < best)
                best = d, found = i;
        }
        lua_pop(L, 1);
    }
    if (!found)
        lua_pushnil(L);
    else
        lua_rawgeti(L, v[NEAR_LIST].at, found);
    return 1;
}

static int sys_loading(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushboolean(L, b->vm.loading);
    return 1;
}

/* On the board only where there are items. */
static int sys_drops(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    api_drops(L, lua_tostring(L, v[DROPS_ENTRY].at), v[DROPS_LIST].at);
    return 1;
}

static int sys_drop(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushvalue(L, v[DROP_LIST].at);
    api_drop_list(L, b, v[DROP_X].f, v[DROP_Y].f);
    return 0;
}

static int sys_read(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    vm_read_piece(L, lua_tostring(L, v[ARG_NAME].at));
    return 1;
}

static int sys_emit(lua_State *L, struct board *b, struct api_value *v)
{
    const char *name = lua_tostring(L, v[ARG_NAME].at);
    int n = lua_gettop(L) - 1;

    if (!events_emit(b, L, name, n))
        return api_error(L, "sys.emit", "no event \"%s\"", name);
    return 0;
}

/* Changes no RAM: marks are for the cabinet. */
static int sys_mark(lua_State *L, struct board *b, struct api_value *v)
{
    static const char *const kinds[MARKER_KINDS] = { "stage",  "point", "wave", "boss",  "phase", "death",
                                                     "clear",  "won",   "lost", "start", "ship",  "register",
                                                     "listed", "game",  "over", "row" };
    const char *of = v[M_OF].given ? lua_tostring(L, v[M_OF].at) : "",
               *title = v[M_TITLE].given ? lua_tostring(L, v[M_TITLE].at) : "";

    for (int k = 0; k < MARKER_KINDS; k++)
        if (!strcmp(kinds[k], lua_tostring(L, v[M_KIND].at)))
            return board_add_marker(b, (enum board_marker_kind)k, lua_tostring(L, v[M_NAME].at), of, title,
                                    (int32_t)v[M_VALUE].i),
                   0;
    return api_error(L, "sys.mark", "no mark \"%s\"", lua_tostring(L, v[M_KIND].at));
}

/* One { name, value } of a list, at place i. */
static void push_register(lua_State *L, const char *name, int32_t value, int i)
{
    lua_createtable(L, 0, 2);
    lua_pushstring(L, name);
    lua_setfield(L, -2, "name");
    lua_pushinteger(L, value);
    lua_setfield(L, -2, "value");
    lua_rawseti(L, -2, i);
}

static int sys_practice(lua_State *L, struct board *b, struct api_value *v)
{
    const struct practice *p = &b->start.practice;

    (void)v;
    b->vm.practice_read = true;
    lua_pushstring(L, p->section);
    lua_createtable(L, 0, 2);
    lua_pushinteger(L, p->lives);
    lua_setfield(L, -2, "lives");
    lua_createtable(L, p->registers, 0);
    for (int i = 0; i < p->registers; i++)
        push_register(L, p->reg[i].name, p->reg[i].value, i + 1);
    lua_setfield(L, -2, "registers");
    return 2;
}

static int sys_ship(lua_State *L, struct board *b, struct api_value *v)
{
    const char *names[PLAYER_REGISTERS];
    int32_t kind = (int32_t)v[ARG_KIND].i;
    int n = api_player_registers(L, kind, names);

    lua_createtable(L, 0, 2);
    lua_pushinteger(L, b->player_kinds.lives[kind]);
    lua_setfield(L, -2, "lives");
    lua_createtable(L, n, 0);
    for (int i = 0; i < n; i++) {
        push_register(L, names[i], b->player_kinds.start[kind * PLAYER_REGISTERS + i], i + 1);
        lua_rawgeti(L, -1, i + 1);
        api_register_show(L, kind, i);
        lua_setfield(L, -2, "show");
        lua_pushinteger(L, b->player_kinds.most[kind * PLAYER_REGISTERS + i]);
        lua_setfield(L, -2, "max");
        lua_pop(L, 1);
    }
    lua_setfield(L, -2, "registers");
    return 1;
}

static int sys_join(lua_State *L, struct board *b, struct api_value *v)
{
    return v[JOIN_PLAYER].i ? api_player_enter(L, b, (uint32_t)v[JOIN_PLAYER].i - 1, (uint16_t)v[JOIN_KIND].i) : 0;
}

static int sys_leave(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    if (v[ARG_PLAYER].i)
        player_leave(&b->player, (uint32_t)v[ARG_PLAYER].i - 1);
    return 0;
}

/* No background, and the colours of rom.lua. */
static void wipe_scenery(struct board *b)
{
    const uint8_t *p = cart_palette(&b->cart, "main");

    bg_clear(&b->bg, &b->bg_lines);
    bg_fade(&b->bg, 0);
    screen_empty(&b->screen);
    pal_stop(&b->pal);
    for (int i = 0; i < COLOURS; i++, p += 3)
        pal_set(&b->pal, i, (uint32_t)p[0] << 16 | (uint32_t)p[1] << 8 | p[2]);
}

static int sys_wipe(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    EACH_LIVE (i, &b->bullets.s)
        bullets_drop(&b->bullets, i);
    EACH_LIVE (i, &b->shots.s)
        bullets_drop(&b->shots, i);
    bullets_release_all(&b->bullets);
    bullets_release_all(&b->shots);
    EACH_LIVE (i, &b->enemies.s)
        enemies_drop(&b->enemies, i);
    EACH_LIVE (i, &b->lasers.s)
        lasers_remove(b, i);
    EACH_LIVE (i, &b->items.s)
        slots_drop(&b->items.s, i);
    EACH_LIVE (i, &b->sparks.s)
        slots_drop(&b->sparks.s, i);
    EACH_LIVE (i, &b->sprites.s)
        slots_drop(&b->sprites.s, i);
    EACH_LIVE (i, &b->lines.s)
        slots_drop(&b->lines.s, i);
    if (!v[ARG_ON].i)
        wipe_scenery(b);
    fix_clear(&b->fix, 0, 0, (int)b->fix.cols, (int)b->fix.rows);
    return 0;
}

static int sys_freeze(lua_State *L, struct board *b, struct api_value *v)
{
    if (b->tasks.current == NO_SLOT)
        return api_error(L, "sys.freeze", "only a task can freeze the board");
    b->core.frozen = v[ARG_SCOPE].given ? v[ARG_SCOPE].i : 0;
    for (uint32_t p = 0; p < PADS && v[ARG_SCOPE].given; p++)
        input_forget(&b->input, p, PRESS_PAUSE); /* of the screen before */
    return 0;
}

/* A scope owned by the board: it outlasts the task that makes it. */
static int sys_scope(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, tasks_scope(b, 0, false));
    return 1;
}

static int sys_scene(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushinteger(L, tasks_scope(b, v[ARG_OWNER].i, true));
    return 1;
}

static const struct api_param on_only[] = { { "on", A_BOOL, REQ, 0, 0, NULL, NULL } };

static int sys_skip(lua_State *L, struct board *b, struct api_value *v)
{
    if (b->tasks.current == NO_SLOT)
        return api_error(L, "sys.skip", "only a task can skip");
    uint8_t *flags = &b->tasks.flags[b->tasks.current];
    *flags = (uint8_t)(v[ARG_ON].i ? *flags | TASK_SKIPS : *flags & ~TASK_SKIPS);
    return 0;
}

static const struct api_param cue[] = { { "name", A_STR, REQ, 1, 32, NULL, NULL } };

/* Sounds are outside the hash, and so is this call. */
static int sys_cue(lua_State *L, struct board *b, struct api_value *v)
{
    const int sound = b->voices.s.cap ? cart_find_sound(&b->cart, lua_tostring(L, v[ARG_NAME].at)) : -1;

    if (sound >= 0)
        sound_play(b, &(struct cue){ cart_sound(&b->cart, sound), 256, 0, 0 });
    return 0;
}

static int sys_skipping(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushboolean(L, b->tasks.current != NO_SLOT && b->tasks.flags[b->tasks.current] & TASK_SKIPS);
    return 1;
}

/* nil: no task has its turn. */
static int sys_task(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    if (b->tasks.current == NO_SLOT)
        lua_pushnil(L);
    else
        lua_pushinteger(L, board_handle(b, H_TASK, b->tasks.current));
    return 1;
}

static int sys_pass(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    return api_pass_wait(L, b);
}

static int sys_hold(lua_State *L, struct board *b, struct api_value *v)
{
    uint32_t i = handle_slot(v[HOLD_ENEMY].i);

    (void)L;
    if (board_alive(b, v[HOLD_ENEMY].i))
        b->enemies.flags[i] =
            (uint8_t)(v[HOLD_ON].i ? b->enemies.flags[i] | ENEMY_UNDYING : b->enemies.flags[i] & ~ENEMY_UNDYING);
    return 0;
}

static int sys_kinds(lua_State *L, struct board *b, struct api_value *v)
{
    static const char *const words[] = { "bullet", "shot", "enemy", "player", "spark", "item" };
    const struct slots *s[] = { &b->bullet_kinds.s, &b->shot_kinds.s,  &b->enemy_kinds.s,
                                &b->player_kinds.s, &b->spark_kinds.s, &b->item_kinds.s };

    for (int k = 0; k < 6; k++) {
        if (strcmp(words[k], lua_tostring(L, v[ARG_NAME].at)))
            continue;
        lua_newtable(L);
        lua_Integer n = 0;
        for (uint32_t i = 0; i < s[k]->live; i++) {
            if (!api_names_at(b, (enum api_names)k, (int)i)) /* a row of the next kind, or of the one before */
                continue;
            api_names_push(L, (enum api_names)k, (int)i);
            lua_rawseti(L, -2, ++n);
        }
        return 1;
    }
    return api_error(L, "sys.kinds", "no kinds of \"%s\"", lua_tostring(L, v[ARG_NAME].at));
}

static int sys_players(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, b->cart.m.players);
    return 1;
}

static int sys_difficulties(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_newtable(L);
    for (int i = 0; i < b->cart.m.n_difficulties; i++) {
        lua_pushstring(L, b->cart.m.difficulties[i]);
        lua_rawseti(L, -2, i + 1);
    }
    return 1;
}

static int sys_glyphs(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, b->cart.n_glyphs);
    return 1;
}

static const struct api_param sys_cells[] = { { "text", A_STR, REQ, 0, 0, NULL, NULL } };

static int sys_cells_run(lua_State *L, struct board *b, struct api_value *v)
{
    size_t n;
    const char *s = lua_tolstring(L, v[0].at, &n);

    (void)b;
    vm_charge(L, n / 8);
    lua_pushinteger(L, (lua_Integer)utf8_count(s, n, n, NULL));
    return 1;
}

enum { WRAP_TEXT, WRAP_WIDTH };
static const struct api_param sys_wrap[] = { { "text", A_STR, REQ, 0, 0, NULL, NULL },
                                             { "width", A_INT, REQ, 1, MAX_TEXT, "cells", NULL } };

/* Adds a word, of no more than width characters, to the row on top of the stack, or begins the next with it. */
static void wrap_word(lua_State *L, int list, const char *word, size_t n, size_t width)
{
    size_t m;
    const char *row = lua_tolstring(L, -1, &m);
    size_t cells = utf8_count(row, m, width + 1, NULL), more = utf8_count(word, n, width, NULL);

    if (m && cells + 1 + more <= width) {
        lua_pushliteral(L, " ");
        lua_pushlstring(L, word, n);
        lua_concat(L, 3);
        return;
    }
    if (m)
        lua_rawseti(L, list, (lua_Integer)lua_rawlen(L, list) + 1);
    else
        lua_pop(L, 1);
    lua_pushlstring(L, word, n);
}

static int sys_wrap_run(lua_State *L, struct board *b, struct api_value *v)
{
    static const char blanks[] = " \t\n\v\f\r";
    size_t n, bytes, width = (size_t)v[WRAP_WIDTH].i;
    const char *s = lua_tolstring(L, v[WRAP_TEXT].at, &n), *end = s + n;

    (void)b;
    vm_charge(L, n);
    lua_newtable(L);
    int list = lua_gettop(L);
    if (utf8_count(s, n, width + 1, NULL) <= width) {
        lua_pushvalue(L, v[WRAP_TEXT].at);
        lua_rawseti(L, list, 1);
        return 1;
    }
    lua_pushliteral(L, "");
    for (; s < end; s++) {
        size_t word = 0;
        while (s + word < end && (s[word] == '\0' || strchr(blanks, s[word]) == NULL))
            word++;
        for (; word > 0; s += bytes, word -= bytes) {
            utf8_count(s, word, width, &bytes);
            wrap_word(L, list, s, bytes, width);
        }
    }
    lua_rawseti(L, list, (lua_Integer)lua_rawlen(L, list) + 1);
    return 1;
}

/* A place may be so far from a thing that is anywhere in the world. */
static const struct api_param sys_aim[] = { { "x", A_FX, REQ, -2 * WORLD, 2 * WORLD, "px", NULL },
                                            { "y", A_FX, REQ, -2 * WORLD, 2 * WORLD, "px", NULL },
                                            { "shots", A_BOOL, REQ, 0, 0, NULL, NULL } };

static int sys_aim_run(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushnumber(L, trig_to_degrees(api_aim(b, v[AIM_SHOTS].i, v[AIM_X].f, v[AIM_Y].f)));
    return 1;
}

static int sys_clock(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, b->core.clock);
    return 1;
}

#define NO_PARAMS NULL, 0
static const struct api_entry entries[] = {
    { "sys.fail", sys_fail, PARAMS(fail), 2, API_SYS, NULL, "raises an entry's error" },
    { "sys.near", sys_near_run, PARAMS(sys_near), 2, API_SYS, "word", "the nearest word of a list" },
    { "sys.loading", sys_loading, NO_PARAMS, 0, API_SYS, "boolean", "are scripts loading?" },
    { "sys.read", sys_read, PARAMS(name_req), 1, API_SYS, "any", "runs a piece of the library, \"screens/title\"" },
    { "sys.emit", sys_emit, PARAMS(name_req), 1, API_SYS | API_MORE | API_CHANGES, NULL, "queues an event" },
    { "sys.mark", sys_mark, PARAMS(mark), 5, API_SYS, NULL, "a moment of the run, for the cabinet" },
    { "sys.practice", sys_practice, NO_PARAMS, 0, API_SYS, "mark, more", "the practice start; more: lives, registers" },
    { "sys.ship", sys_ship, PARAMS(ship), 1, API_SYS, "table", "lives and registers of a kind of player" },
    { "sys.join", sys_join, PARAMS(join), 2, API_SYS | API_CHANGES, NULL, "player i enters the game" },
    { "sys.leave", sys_leave, PARAMS(pad_only), 1, API_SYS | API_CHANGES, NULL, "player i leaves" },
    { "sys.wipe", sys_wipe, PARAMS(wipe), 1, API_SYS | API_CHANGES, NULL,
      "an empty field and screen; keep: background and palette stay" },
    { "sys.freeze", sys_freeze, PARAMS(scope_opt), 1, API_SYS | API_CHANGES, NULL, "only that scope's tasks go on" },
    { "sys.scope", sys_scope, NO_PARAMS, 0, API_SYS | API_CHANGES, "scope", "an owner that is the board's" },
    { "sys.scene", sys_scene, PARAMS(owner_req), 1, API_SYS | API_CHANGES, "scope",
      "a scope that takes what is spawned and put in it along" },
    { "sys.skip", sys_skip, PARAMS(on_only), 1, API_SYS | API_CHANGES, NULL,
      "from now on this task waits for nothing" },
    { "sys.skipping", sys_skipping, NO_PARAMS, 0, API_SYS, "boolean", "does it?" },
    { "sys.pass", sys_pass, NO_PARAMS, 0, API_SYS, NULL, "something is passed over that waits when not skipped" },
    { "sys.task", sys_task, NO_PARAMS, 0, API_SYS, "task", "the task that has its turn" },
    { "sys.hold", sys_hold, PARAMS(hold), 2, API_SYS | API_CHANGES, NULL, "hp stops at 0 without death" },
    { "sys.kinds", sys_kinds, PARAMS(name_req), 1, API_SYS, "list", "declared names" },
    { "sys.players", sys_players, NO_PARAMS, 0, API_SYS, "count", "players the manifest allows" },
    { "sys.difficulties", sys_difficulties, NO_PARAMS, 0, API_SYS, "list", "names, easiest first" },
    { "sys.glyphs", sys_glyphs, NO_PARAMS, 0, API_SYS, "count", "characters of the font" },
    { "sys.cells", sys_cells_run, PARAMS(sys_cells), 1, API_SYS, "count", "characters of a text" },
    { "sys.wrap", sys_wrap_run, PARAMS(sys_wrap), 2, API_SYS, "list",
      "rows of at most so many characters; a text that fits stays as it is, a word that does not is broken" },
    { "sys.volley", api_volley, PARAMS(name_req), 1, API_SYS, "function",
      "fires all of that pattern at once; false, and nothing was done: it takes the loop in Lua" },
    { "sys.aim", sys_aim_run, PARAMS(sys_aim), 3, API_SYS, "degrees", "where aim points from x, y" },
    { "sys.drops", sys_drops, PARAMS(drops), 2, API_SYS | API_CHANGES, "list", "a list of drops, checked" },
    { "sys.drop", sys_drop, PARAMS(drop), 3, API_SYS | API_CHANGES, NULL, "drops it" },
    { "sys.cue", sys_cue, PARAMS(cue), 1, API_SYS, NULL, "plays the sound of that name, if the game has one" },
    { "sys.clock", sys_clock, NO_PARAMS, 0, API_SYS, "frames", "game time" },
};
const struct api_module api_sys = { entries, sizeof entries / sizeof *entries };
