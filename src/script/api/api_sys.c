/*
 * api_sys.c - the table sys, which only the standard library (@std) can access.
 */
#include <string.h>
#include "../../base/edit.h"
#include "../../base/trig.h"
#include "../../machine/lasers_run.h"
#include "../../machine/sound.h"
#include "../../machine/window.h"
#include "../events_run.h"
#include "api_parts.h"

/* Indices of parameters. The only parameter of an entry is v[0]. */
enum { FAIL_ENTRY, FAIL_MESSAGE, FAIL_NAME };
enum { NOTE_ENTRY, NOTE_NAME };
enum { NEAR_WORD, NEAR_LIST };
enum { JOIN_PLAYER, JOIN_KIND };
enum { M_KIND, M_NAME, M_PARENT, M_TITLE, M_VALUE };
enum { HOLD_ENEMY, HOLD_ENABLED };
enum { AIM_X, AIM_Y, AIM_SHOTS };
enum { DROPS_ENTRY, DROPS_LIST };
enum { DROP_LIST, DROP_X, DROP_Y };
enum { VALUE_PLAYER, VALUE_NAME, VALUE_OF_RUN };
enum { RUN_NAME, RUN_VALUE };
enum { CONTINUES_PLAYER, CONTINUES_N };

enum { MUSIC_FADE_FRAMES = 60 /* frames for music to fade out */ };

static int sys_fail(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    const char *entry = lua_tostring(L, v[FAIL_ENTRY].at), *message = lua_tostring(L, v[FAIL_MESSAGE].at);

    if (v[FAIL_NAME].given)
        return api_error_at(L, entry, lua_tostring(L, v[FAIL_NAME].at), "%s", message);
    return api_error(L, entry, "%s", message);
}

static int sys_record_location(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    api_record_location(L, lua_tostring(L, v[NOTE_ENTRY].at), lua_tostring(L, v[NOTE_NAME].at));
    return 0;
}

static int sys_find_nearest_word(lua_State *L, struct board *b, struct api_value *v)
{
    int best_distance = EDIT_TOO_FAR;
    lua_Integer nearest = 0, n = (lua_Integer)lua_rawlen(L, v[NEAR_LIST].at);

    (void)b;
    if (lua_type(L, v[NEAR_WORD].at) != LUA_TSTRING)
        return lua_pushnil(L), 1;
    for (lua_Integer i = 1; i <= n; i++) {
        if (lua_rawgeti(L, v[NEAR_LIST].at, i) == LUA_TSTRING) {
            int d = edit_distance(lua_tostring(L, v[NEAR_WORD].at), lua_tostring(L, -1));
            if (d < best_distance)
                best_distance = d, nearest = i;
        }
        lua_pop(L, 1);
    }
    if (!nearest)
        lua_pushnil(L);
    else
        lua_rawgeti(L, v[NEAR_LIST].at, nearest);
    return 1;
}

static int sys_loading(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushboolean(L, b->vm.loading);
    return 1;
}

/* Raises the errors that sys.drops would raise, but changes nothing. */
static int sys_check_drops(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    api_push_drops(L, lua_tostring(L, v[DROPS_ENTRY].at), v[DROPS_LIST].at);
    return 0;
}

/* Returns the keys of a table in an order that is the same in every run; includes only one of several keys that the
 * order cannot distinguish. */
static int sys_keys(lua_State *L, struct board *b, struct api_value *v)
{
    uint64_t keys = 0;

    (void)b;
    for (lua_pushnil(L); lua_next(L, v[0].at); lua_pop(L, 1))
        keys++;
    lua_newtable(L);
    const int list = lua_gettop(L);
    lua_pushnil(L);
    for (lua_Integer n = 1; luakeys_next(L, v[0].at) > 0; n++) {
        vm_charge(L, 4 * keys); /* each step examines all keys */
        lua_pushvalue(L, -1);
        lua_rawseti(L, list, n);
    }
    return 1;
}

/* Packs a list of drops into a string; raises an error in a game without items. */
static int sys_pack_drops(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    api_push_folded_drops(L, lua_tostring(L, v[DROPS_ENTRY].at), v[DROPS_LIST].at);
    return 1;
}

static int sys_drop(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushvalue(L, v[DROP_LIST].at);
    api_drop_items(L, b, v[DROP_X].f, v[DROP_Y].f);
    return 0;
}

static int sys_run_library_file(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    vm_run_library_file(L, lua_tostring(L, v[0].at));
    return 1;
}

enum { WORTH_THING, WORTH_PLAYER };

/* An item's points depend on the player's position, so call this while the player is still where the item was taken. */
static int sys_get_points(lua_State *L, struct board *b, struct api_value *v)
{
    const uint32_t i = handle_slot(v[WORTH_THING].i);

    if (!board_is_readable(b, v[WORTH_THING].i) || !v[WORTH_PLAYER].i)
        lua_pushinteger(L, 0);
    else if (handle_kind(v[WORTH_THING].i) == H_ENEMY)
        lua_pushinteger(L, b->enemy_kinds.score[b->enemies.kind[i]]);
    else
        lua_pushinteger(L, events_item_points(b, (uint32_t)v[WORTH_PLAYER].i - 1, b->items.kind[i]));
    return 1;
}

static int sys_emit(lua_State *L, struct board *b, struct api_value *v)
{
    const char *name = lua_tostring(L, v[0].at);
    int n = lua_gettop(L) - 1;

    if (!events_emit(b, L, name, n))
        return api_error(L, "sys.emit", "unknown event \"%s\"", name);
    return 0;
}

/* Changes no RAM: marks are for the program. */
static int sys_mark(lua_State *L, struct board *b, struct api_value *v)
{
    static const char *const kinds[MARKER_KINDS] = { "stage",  "point", "wave", "boss",  "phase",      "death",
                                                     "clear",  "won",   "lost", "start", "ship",       "register",
                                                     "listed", "game",  "over", "row",   "difficulty", "mission" };
    const char *parent = v[M_PARENT].given ? lua_tostring(L, v[M_PARENT].at) : "",
               *title = v[M_TITLE].given ? lua_tostring(L, v[M_TITLE].at) : "";

    for (int k = 0; k < MARKER_KINDS; k++)
        if (!strcmp(kinds[k], lua_tostring(L, v[M_KIND].at)))
            return board_add_marker(b, (enum board_marker_kind)k, lua_tostring(L, v[M_NAME].at), parent, title,
                                    (int32_t)v[M_VALUE].i),
                   0;
    return api_error(L, "sys.mark", "unknown mark \"%s\"", lua_tostring(L, v[M_KIND].at));
}

static int sys_enemy_sprite(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushstring(L, cart_name(&b->cart, CART_SPRITES, b->enemy_kinds.sprite[v[0].i]));
    return 1;
}

/* Changes no RAM: key hints are for the program. */
static int sys_tell_key(lua_State *L, struct board *b, struct api_value *v)
{
    size_t n;
    const char *meaning = lua_tolstring(L, v[1].at, &n), *translation = words_find(&b->words, meaning, n);

    if (strcmp(meaning, "Back") == 0)
        b->output->out.back = (uint16_t)(1 << v[0].i);
    board_add_key_hint(b, v[2].given ? (int)v[2].i - 1 : 0, (uint32_t)v[0].i, translation ? translation : meaning);
    return 0;
}

/* Without p: for old ROMs, in every frame of their menus. */
static int sys_tell_keys(lua_State *L, struct board *b, struct api_value *v)
{
    static const char *const meanings[PAD_BUTTON_COUNT] = { NULL,   NULL,    NULL, NULL,   "Fire",
                                                            "Bomb", "Focus", NULL, "Start" };

    (void)L;
    if (v[0].given && v[0].i)
        b->output->out.typing |= (uint8_t)(1 << (v[0].i - 1));
    for (uint32_t i = 0; i < PAD_BUTTON_COUNT && !v[0].given; i++)
        if (meanings[i])
            board_add_key_hint(b, 0, i, meanings[i]);
    return 0;
}

/* ---- codes from the program ---- */

static int sys_listen(lua_State *L, struct board *b, struct api_value *v)
{
    if (!v[0].given)
        return channel_close(&b->channel), 0;
    channel_open(&b->channel);
    for (lua_Integer i = 1; lua_rawgeti(L, v[0].at, i) == LUA_TSTRING; i++, lua_pop(L, 1))
        channel_add_entry(&b->channel, lua_tostring(L, -1));
    return 0;
}

/* Returns the code of player p in this frame: "restart", "quit" or the number of an entry while the game is listening;
 * "backspace", "enter" or a character; nil if there is none. */
static int sys_get_code(lua_State *L, struct board *b, struct api_value *v)
{
    static const char *const names[] = {
        [CODE_RESTART] = "restart", [CODE_QUIT] = "quit", [CODE_BACKSPACE] = "backspace", [CODE_ENTER] = "enter"
    };
    const unsigned code = v[0].i ? b->channel.code[v[0].i - 1] : CODE_NONE;

    if (code == CODE_NONE || (code < CODE_BACKSPACE && !b->channel.is_listening))
        lua_pushnil(L);
    else if (code >= CODE_CHARACTER)
        lua_pushlstring(L, CODE_CHARACTERS + (code - CODE_CHARACTER), 1);
    else if (names[code])
        lua_pushstring(L, names[code]);
    else
        lua_pushinteger(L, (lua_Integer)code - CODE_ENTRY + 1);
    return 1;
}

/* Stores { name, value } at index i of the list on top of the stack. */
static void set_register_entry(lua_State *L, const char *name, int32_t value, int i)
{
    lua_createtable(L, 0, 2);
    api_set_string(L, "name", name);
    api_set_integer(L, "value", value);
    lua_rawseti(L, -2, i);
}

static int sys_practice(lua_State *L, struct board *b, struct api_value *v)
{
    const struct practice *p = &b->start.practice;

    (void)v;
    b->vm.practice_read = true;
    lua_pushstring(L, p->section);
    lua_createtable(L, 0, 2);
    api_set_integer(L, "lives", p->lives);
    lua_createtable(L, p->register_count, 0);
    for (int i = 0; i < p->register_count; i++)
        set_register_entry(L, p->reg[i].name, p->reg[i].value, i + 1);
    lua_setfield(L, -2, "registers");
    return 2;
}

/* Appends the registers of a kind of ship, or of the run, to the list on top of the stack. */
static void append_registers(lua_State *L, const struct board *b, int32_t kind, uint32_t first)
{
    const char *names[PLAYER_MAX_REGISTERS];
    const int n = api_player_register_names(L, kind, names), old_count = (int)lua_rawlen(L, -1);

    for (int i = 0; i < n; i++) {
        const struct register_rule rule = registers_rule(&b->registers, first + (uint32_t)i);
        set_register_entry(L, names[i], rule.start, old_count + i + 1);
        lua_rawgeti(L, -1, old_count + i + 1);
        api_register_add_display(L, kind, i);
        api_set_integer(L, "max", rule.max_value);
        lua_pushboolean(L, kind == RUN_REGISTERS);
        lua_setfield(L, -2, "run");
        lua_pop(L, 1);
    }
}

static int sys_ship(lua_State *L, struct board *b, struct api_value *v)
{
    int32_t kind = (int32_t)v[0].i;

    lua_createtable(L, 0, 8);
    api_set_string(L, "sprite", cart_name(&b->cart, CART_SPRITES, b->player_kinds.sprite[kind]));
    lua_pushnumber(L, fx_to_double(b->player_kinds.speed[kind]));
    lua_setfield(L, -2, "speed");
    lua_pushnumber(L, fx_to_double(b->player_kinds.focus_speed[kind]));
    lua_setfield(L, -2, "focus");
    lua_pushnumber(L, fx_to_double(b->player_kinds.graze_radius[kind]));
    lua_setfield(L, -2, "graze");
    lua_pushboolean(L, b->player_kinds.bomb[kind]);
    lua_setfield(L, -2, "bomb");
    api_set_integer(L, "lives", b->player_kinds.lives[kind]);
    lua_newtable(L);
    append_registers(L, b, kind, b->player_kinds.first_register[kind]);
    append_registers(L, b, RUN_REGISTERS, b->registers.first_run_row);
    lua_setfield(L, -2, "registers");
    events_push_property(L, (uint16_t)kind, "ship's needs");
    lua_setfield(L, -2, "needs");
    return 1;
}

static int sys_join(lua_State *L, struct board *b, struct api_value *v)
{
    return v[JOIN_PLAYER].i ? api_player_enter(L, b, (uint32_t)v[JOIN_PLAYER].i - 1, (uint16_t)v[JOIN_KIND].i) : 0;
}

/* Sets the register of that name, of player 1's ship or, if the ship has none, of the run, to the value of a practice
 * start. */
static void set_practice_register(lua_State *L, struct board *b, const char *name, int32_t value)
{
    int reg = api_find_player_register(L, b, 0, name);

    if (reg >= 0)
        board_set_register(b, 0, (uint32_t)reg, value);
    else if ((reg = api_find_run_register(L, name)) >= 0)
        board_set_run_register(b, (uint32_t)reg, value);
}

/* Starts a game: resets the state of the run, then calls the handlers of on.start, then applies the practice start. */
static int sys_start(lua_State *L, struct board *b, struct api_value *v)
{
    const struct practice *practice = &b->start.practice;

    registers_reset(&b->registers, b->registers.first_run_row, b->registers.n_run_rows, 0);
    b->core.game_start = b->core.clock;
    if (b->voices.s.cap)
        sound_start_game(b);
    memset(b->core.continues_left, 0, sizeof b->core.continues_left);
    memset(b->core.continues_used, 0, sizeof b->core.continues_used);
    events_call_start_handlers(L, v[0].i);
    if (practice->lives > 0)
        b->player.lives[0] = practice->lives - 1;
    for (int i = 0; i < practice->register_count; i++)
        set_practice_register(L, b, practice->reg[i].name, practice->reg[i].value);
    return 0;
}

static int sys_run_registers(lua_State *L, struct board *b, struct api_value *v)
{
    b->registers.first_run_row = b->registers.s.live;
    b->registers.n_run_rows = (uint32_t)api_registers_define(L, "game.def", RUN_REGISTERS, v[0].at);
    return 0;
}

/* Returns the number of the run's register named at stack index `at`, or -1. */
static int find_run_register(lua_State *L, int at)
{
    return lua_type(L, at) == LUA_TSTRING ? api_find_run_register(L, lua_tostring(L, at)) : -1;
}

/* Returns a property of the run, or nil if the name is unknown. */
static int sys_get_run_property(lua_State *L, struct board *b, struct api_value *v)
{
    const char *name = lua_type(L, v[0].at) == LUA_TSTRING ? lua_tostring(L, v[0].at) : "";
    const int reg = find_run_register(L, v[0].at);

    if (reg >= 0)
        lua_pushinteger(L, board_get_run_register(b, (uint32_t)reg));
    else if (!strcmp(name, "continues"))
        lua_pushinteger(L, b->core.continues_used[0] + b->core.continues_used[1]);
    else if (!strcmp(name, "frames"))
        lua_pushinteger(L, b->core.clock - b->core.game_start);
    else
        lua_pushnil(L);
    return 1;
}

/* Returns a register of a player's ship, or of the run; nil if there is no such register or the player is out. */
static int sys_get_register(lua_State *L, struct board *b, struct api_value *v)
{
    const uint32_t p = (uint32_t)v[VALUE_PLAYER].i - 1;
    const char *name = lua_tostring(L, v[VALUE_NAME].at);
    const bool is_run_register = v[VALUE_OF_RUN].given && v[VALUE_OF_RUN].i;
    const int reg = is_run_register ? find_run_register(L, v[VALUE_NAME].at) : api_find_player_register(L, b, p, name);

    if (reg < 0 || (!is_run_register && !b->player.in_game[p]))
        lua_pushnil(L);
    else if (is_run_register)
        lua_pushinteger(L, board_get_run_register(b, (uint32_t)reg));
    else
        lua_pushinteger(L, board_get_register(b, p, (uint32_t)reg));
    return 1;
}

/* Sets a register of the run. Returns false if the run has no such register. */
static int sys_run_set(lua_State *L, struct board *b, struct api_value *v)
{
    const int reg = find_run_register(L, v[RUN_NAME].at);
    const uint32_t row = b->registers.first_run_row + (uint32_t)reg;

    if (reg >= 0)
        registers_set(&b->registers, row, 0,
                      api_read_register_value(L, "game", lua_tostring(L, v[RUN_NAME].at), row, v[RUN_VALUE].at));
    lua_pushboolean(L, reg >= 0);
    return 1;
}

static int sys_run_names(lua_State *L, struct board *b, struct api_value *v)
{
    const char *names[PLAYER_MAX_REGISTERS];
    const int n = api_player_register_names(L, RUN_REGISTERS, names);

    (void)b, (void)v;
    lua_createtable(L, n, 0);
    for (int i = 0; i < n; i++) {
        lua_pushstring(L, names[i]);
        lua_rawseti(L, -2, i + 1);
    }
    return 1;
}

/* Returns how many continues player p has left; with n, sets the number first. Setting 0 may end the game. */
static int sys_continues(lua_State *L, struct board *b, struct api_value *v)
{
    const uint32_t p = (uint32_t)v[CONTINUES_PLAYER].i - 1;

    if (p >= MAX_PLAYERS) /* a dead handle */
        return 0;
    if (v[CONTINUES_N].given) {
        b->core.continues_left[p] = (uint8_t)v[CONTINUES_N].i;
        if (!v[CONTINUES_N].i)
            events_check_game_over(b);
    }
    lua_pushinteger(L, b->core.continues_left[p]);
    return 1;
}

static int sys_use_continue(lua_State *L, struct board *b, struct api_value *v)
{
    const uint32_t p = (uint32_t)v[0].i - 1;

    if (p >= MAX_PLAYERS || b->player.in_game[p] || !b->core.continues_left[p])
        return 0;
    b->core.continues_left[p]--;
    b->core.continues_used[p]++;
    api_player_enter(L, b, p, b->player.kind[p]);
    b->player.score[p] = b->core.continues_used[p] < 9 ? b->core.continues_used[p] : 9;
    board_raise_event(b, EV_CONTINUE, board_handle(b, H_PLAYER, (int32_t)p), 0);
    return 0;
}

static int sys_leave(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    if (!v[0].i)
        return 0;
    player_leave(&b->player, (uint32_t)v[0].i - 1);
    options_drop_from(&b->options, (uint32_t)v[0].i - 1, 0);
    if (input_end_play(&b->input, (uint32_t)v[0].i - 1)) /* it was shown on a page, whose music continues */
        return 0;
    if (b->voices.s.cap && !b->player.in_game[0] && !b->player.in_game[1]) /* the game is over */
        sound_stop_music(b, MUSIC_FADE_FRAMES);
    return 0;
}

/* Removes the background and restores the colours of rom.lua. */
static void wipe_scenery(struct board *b)
{
    const uint8_t *p = cart_palette(&b->cart, "main");

    bg_clear(&b->bg, &b->bg_lines);
    bg_fade(&b->bg, 0);
    screen_reset(&b->screen);
    pal_stop(&b->pal);
    for (int i = 0; i < COLOURS; i++, p += 3)
        pal_set(&b->pal, i, (uint32_t)p[0] << 16 | (uint32_t)p[1] << 8 | p[2]);
}

static int sys_wipe(lua_State *L, struct board *b, struct api_value *v)
{
    struct slots *const pools[] = { &b->items.s, &b->sparks.s, &b->sprites.s, &b->lines.s };

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
    for (uint32_t p = 0; p < MAX_PLAYERS; p++)
        options_drop_from(&b->options, p, 0);
    for (int k = 0; k < 4; k++)
        EACH_LIVE (i, pools[k])
            slots_drop(pools[k], i);
    if (!v[0].i)
        wipe_scenery(b);
    fix_clear(&b->fix, 0, 0, (int)b->fix.cols, (int)b->fix.rows);
    return 0;
}

static int sys_show_whole(lua_State *L, struct board *b, struct api_value *v)
{
    const struct manifest *m = &b->cart.manifest;
    const struct window w = window_of(b);

    (void)L;
    b->screen.shows_whole = v[0].i && (w.w < m->screen_w || w.h < m->screen_h);
    return 0;
}

/* Pushes (number - a) * factor / divisor + b2 for the number at stack index `at`. An integer stays one, unless it must
 * be divided. */
static void convert(lua_State *L, int at, int a, int factor, int divisor, int b2)
{
    lua_pushvalue(L, at);
    lua_pushinteger(L, a);
    lua_arith(L, LUA_OPSUB);
    if (factor != 1) {
        lua_pushinteger(L, factor);
        lua_arith(L, LUA_OPMUL);
    }
    if (divisor != 1) {
        lua_pushinteger(L, divisor);
        lua_arith(L, LUA_OPDIV);
    }
    lua_pushinteger(L, b2);
    lua_arith(L, LUA_OPADD);
}

static const struct api_param place_params[] = { PARAM("x", A_NUM, REQ, -WORLD_EDGE, WORLD_EDGE, "px", NULL, ""),
                                                 PARAM("y", A_NUM, REQ, -WORLD_EDGE, WORLD_EDGE, "px", NULL, "") };

static int sys_to_field(lua_State *L, struct board *b, struct api_value *v)
{
    const struct window w = window_of(b);

    convert(L, v[0].at, w.x, 1, w.zoom, w.left);
    convert(L, v[1].at, w.y, 1, w.zoom, w.top);
    return 2;
}

static int sys_to_screen(lua_State *L, struct board *b, struct api_value *v)
{
    const struct window w = window_of(b);

    convert(L, v[0].at, w.left, w.zoom, 1, w.x);
    convert(L, v[1].at, w.top, w.zoom, 1, w.y);
    return 2;
}

static int sys_freeze(lua_State *L, struct board *b, struct api_value *v)
{
    if (b->tasks.current == NO_SLOT)
        return api_error(L, "sys.freeze", "only a task can freeze the board");
    b->core.frozen = v[0].given ? v[0].i : 0;
    for (uint32_t p = 0; p < MAX_PLAYERS && v[0].given; p++)
        input_drop_presses(&b->input, p, PRESS_PAUSE, PAD_ALL); /* left over from the previous screen */
    return 0;
}

/* Creates a scope owned by the board, which therefore outlives the task that creates it. */
static int sys_new_scope(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, tasks_new_scope(b, 0, false));
    return 1;
}

static int sys_new_scene(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushinteger(L, tasks_new_scope(b, v[0].i, true));
    return 1;
}

enum { SKIP_ENABLED, SKIP_TASK };

static int sys_skip(lua_State *L, struct board *b, struct api_value *v)
{
    if (b->tasks.current == NO_SLOT)
        return api_error(L, "sys.skip", "only a task can skip");
    uint32_t i = v[SKIP_TASK].given ? handle_slot(v[SKIP_TASK].i) : (uint32_t)b->tasks.current;
    uint8_t *flags = &b->tasks.flags[i];
    if (v[SKIP_TASK].given && !board_is_alive(b, v[SKIP_TASK].i))
        return 0;
    *flags = (uint8_t)(v[SKIP_ENABLED].i ? *flags | TASK_SKIPS : *flags & ~TASK_SKIPS);
    if (v[SKIP_TASK].given)
        b->tasks.wait[i] = 0;
    else if (b->voices.s.cap)
        sound_set_skipping(b, v[SKIP_ENABLED].i && !board_is_listing(b));
    return 0;
}

static int sys_run_turn(lua_State *L, struct board *b, struct api_value *v)
{
    if (b->tasks.current == NO_SLOT || !lua_isyieldable(L))
        return api_error(L, "sys.turn", "only a task can run another task");
    if (board_is_alive(b, v[0].i) && handle_slot(v[0].i) != (uint32_t)b->tasks.current)
        tasks_run_turn(b, L, handle_slot(v[0].i));
    return 0;
}

static int sys_finish_fades(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L, (void)v;
    for (int i = 0; i < COLOURS; i++)
        if (b->pal.fade_frames[i])
            pal_set(&b->pal, i, b->pal.to[i]);
    return 0;
}

/* Sets which buttons are hidden from the game: 0 none, 1 those that fire, 2 all that control the ship. Presses of those
 * buttons from before the call, or made while they were hidden, are dropped. */
static int sys_hold_players(lua_State *L, struct board *b, struct api_value *v)
{
    static const uint8_t hold_flags[] = { 0, PLAYER_NO_FIRE, PLAYER_NO_FIRE | PLAYER_NO_MOVE };
    struct player *p = &b->player;

    (void)L;
    for (uint32_t i = 0; i < MAX_PLAYERS; i++) {
        unsigned old_ignored = player_ignored_buttons(p, i);
        if (p->in_game[i])
            p->in_game[i] = PLAYER_IN_GAME | hold_flags[v[0].i];
        input_drop_presses(&b->input, i, PRESS_GAME, old_ignored | player_ignored_buttons(p, i));
    }
    return 0;
}

enum { PLAY_PLAYER, PLAY_PADS };

static int sys_play_ship(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    if (v[PLAY_PLAYER].i)
        input_play(&b->input, (uint32_t)v[PLAY_PLAYER].i - 1, (unsigned)v[PLAY_PADS].i);
    return 0;
}

enum { PAD_STATE, PAD_BUTTON, PAD_PLAYER };

static int sys_read_button(lua_State *L, struct board *b, struct api_value *v)
{
    const char *state = lua_tostring(L, v[PAD_STATE].at);
    const int64_t p = v[PAD_PLAYER].i;

    lua_pushboolean(L, p && api_get_pads(b, state, (uint32_t)p - 1) >> v[PAD_BUTTON].i & 1);
    return 1;
}

static int sys_get_sprite_size(lua_State *L, struct board *b, struct api_value *v)
{
    const struct sprite *s = &b->sprite_images[v[0].i];

    lua_pushinteger(L, s->w);
    lua_pushinteger(L, s->h);
    lua_pushinteger(L, s->ox);
    lua_pushinteger(L, s->oy);
    return 4;
}

enum { CUE_NAME, CUE_PAN };

/* Not folded: sounds are outside the state hash. */
static int sys_play_cue(lua_State *L, struct board *b, struct api_value *v)
{
    const int sound = b->voices.s.cap ? cart_find(&b->cart, CART_SOUNDS, lua_tostring(L, v[CUE_NAME].at)) : -1;
    const int16_t pan = (int16_t)(v[CUE_PAN].n * TUNE_PAN_CENTRE);

    if (sound >= 0 && !tasks_is_skipping(&b->tasks))
        sound_play(b, &(struct cue){ cart_tune_offset(&b->cart, CART_SOUNDS, sound), 256, pan, 0 });
    return 0;
}

enum { MUSIC_NAME, MUSIC_FADE, MIN_FADE = 30 };

static int32_t clamp_fade(const struct api_value *v)
{
    return !v->given ? 0 : v->i < MIN_FADE ? MIN_FADE : (int32_t)v->i;
}

static int sys_interrupt_music(lua_State *L, struct board *b, struct api_value *v)
{
    const struct music_options options = { .fade = clamp_fade(&v[MUSIC_FADE]), .suspend_current = true };

    lua_pushboolean(L, sound_start_music(b, (int)v[MUSIC_NAME].i - 1, &options));
    return 1;
}

static int sys_resume_music(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    sound_end_music(b, (int)v[MUSIC_NAME].i - 1, v[MUSIC_FADE].given ? (int32_t)v[MUSIC_FADE].i : MUSIC_FADE_FRAMES);
    return 0;
}

static int sys_skip_music_clock(lua_State *L, struct board *b, struct api_value *v)
{
    if (b->music.is_skipping)
        vm_charge(L, sound_skip_clock(b, v[0].i));
    return 0;
}

/* While music fast-forwards to a mark, applies all music changes of boss/fight.lua at once; otherwise does nothing. */
static int sys_skip_fight_music(lua_State *L, struct board *b, struct api_value *v)
{
    const struct music_options options = { .fade = clamp_fade(&v[MUSIC_FADE]), .suspend_current = true };

    if (!b->music.is_skipping)
        return 0;
    const bool switched = v[MUSIC_NAME].given && sound_start_music(b, (int)v[MUSIC_NAME].i - 1, &options);
    vm_charge(L, sound_skip_fight(b));
    if (switched)
        sound_end_music(b, (int)v[MUSIC_NAME].i - 1, MUSIC_FADE_FRAMES);
    return 0;
}

/* Returns { name, title, heard } for each piece in rom.lua, in order of name. */
static int sys_list_tunes(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_createtable(L, b->cart.count[CART_TUNES], 0);
    for (int i = 0; i < b->cart.count[CART_TUNES]; i++) {
        const struct tune t = tune_of(b->cart.tune_data + cart_tune_offset(&b->cart, CART_TUNES, i));
        lua_createtable(L, 0, 3);
        api_set_string(L, "name", cart_name(&b->cart, CART_TUNES, i));
        api_set_string(L, "title", tune_title(&t));
        lua_pushboolean(L, i < SEQ_MAX_PIECES && b->music.started_tunes[i / 64] >> i % 64 & 1);
        lua_setfield(L, -2, "heard");
        lua_rawseti(L, -2, i + 1);
    }
    return 1;
}

static int sys_is_skipping(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushboolean(L, tasks_is_skipping(&b->tasks));
    return 1;
}

/* Returns the running task, or nil. */
static int sys_task(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    api_push_handle(L, b->tasks.current == NO_SLOT ? 0 : board_handle(b, H_TASK, b->tasks.current));
    return 1;
}

static int sys_skip_wait(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    return api_count_skipped_wait(L, b);
}

/* Returns whether a value is a handle with the property `alive`. */
static int sys_is_waitable(lua_State *L, struct board *b, struct api_value *v)
{
    const int64_t h = lua_isinteger(L, 1) ? lua_tointeger(L, 1) : 0;

    (void)b;
    (void)v;
    return lua_pushboolean(L, handle_is_well_formed(h) && !handle_kind_is_group(handle_kind(h))), 1;
}

static int sys_set_undying(lua_State *L, struct board *b, struct api_value *v)
{
    uint32_t i = handle_slot(v[HOLD_ENEMY].i);

    (void)L;
    if (board_is_alive(b, v[HOLD_ENEMY].i))
        b->enemies.flags[i] =
            (uint8_t)(v[HOLD_ENABLED].i ? b->enemies.flags[i] | ENEMY_UNDYING : b->enemies.flags[i] & ~ENEMY_UNDYING);
    return 0;
}

static int sys_kinds(lua_State *L, struct board *b, struct api_value *v)
{
    static const char *const kind_names[] = { "bullet", "shot", "enemy", "player", "spark", "item" };

    for (int k = 0; k < 6; k++) {
        if (strcmp(kind_names[k], lua_tostring(L, v[0].at)))
            continue;
        lua_newtable(L);
        lua_Integer n = 0;
        for (uint32_t i = 0; i < b->names[k].n; i++) {
            if (!board_name(b, (enum name_kind)k, (int)i)) /* a row without a name, which belongs to another kind */
                continue;
            api_names_push(L, (enum name_kind)k, (int)i);
            lua_rawseti(L, -2, ++n);
        }
        return 1;
    }
    return api_error(L, "sys.kinds", "unknown kinds \"%s\"", lua_tostring(L, v[0].at));
}

static int sys_players(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, b->cart.manifest.players);
    return 1;
}

static int sys_is_at_title(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushboolean(L, b->start.at_title);
    return 1;
}

static int sys_has_large_hud(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushboolean(L, b->start.large_hud);
    return 1;
}

static int sys_difficulties(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_newtable(L);
    for (int i = 0; i < b->cart.manifest.n_difficulties; i++) {
        lua_pushstring(L, b->cart.manifest.difficulties[i]);
        lua_rawseti(L, -2, i + 1);
    }
    return 1;
}

static int sys_is_enabled(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushboolean(L, api_disabled_reason(&b->cart.manifest, lua_tostring(L, v[0].at)) == NULL);
    return 1;
}

static int sys_get_aim_direction(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushnumber(L, trig_to_degrees(api_aim_direction(b, v[AIM_SHOTS].i, v[AIM_X].f, v[AIM_Y].f)));
    return 1;
}

static int sys_clock(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, b->core.clock);
    return 1;
}

#define SYS_ENTRY(name, run, flags, returns, help, ...)                                                                \
    {                                                                                                                  \
        name, run, PARAM_ROWS(__VA_ARGS__), PARAM_ROW_COUNT(__VA_ARGS__), API_SYS | (flags), returns, HELP(help)       \
    }
static const struct api_entry entries[] = {
    SYS_ENTRY("sys.fail", sys_fail, 0, NULL,
              "raises an entry's error; of: the name under which sys.note_place recorded the line to report",
              REQUIRED("name", A_STR, ""), REQUIRED("message", A_ANY, ""), /* may quote a \0 */
              OPTIONAL("of", A_STR, "")),
    SYS_ENTRY("sys.note_place", sys_record_location, 0, NULL,
              "records the author's line that calls an entry, for an error found later", REQUIRED("name", A_STR, ""),
              REQUIRED("of", A_STR, "")),
    SYS_ENTRY("sys.keys", sys_keys, 0, "list", "returns all keys of a table, of any type, in order",
              REQUIRED("list", A_TABLE, "")),
    SYS_ENTRY("sys.check_drops", sys_check_drops, 0, NULL, "raises an error unless drops is a list of items",
              REQUIRED("name", A_STR, ""), REQUIRED("drops", A_TABLE, "")),
    SYS_ENTRY("sys.near", sys_find_nearest_word, 0, "word", "returns the nearest word in a list",
              REQUIRED("word", A_ANY, ""), REQUIRED("list", A_TABLE, "")),
    { "sys.loading", sys_loading, NO_PARAMS, 0, API_SYS, "boolean", HELP("returns true while scripts load") },
    SYS_ENTRY("sys.read", sys_run_library_file, 0, "any", "runs a file of the library, such as \"screens/title\"",
              REQUIRED("name", A_STR, "")),
    SYS_ENTRY("sys.emit", sys_emit, API_VARARGS | API_CHANGES, NULL, "queues an event", REQUIRED("name", A_STR, "")),
    SYS_ENTRY("sys.mark", sys_mark, 0, NULL, "marks a moment of the run for the program", REQUIRED("kind", A_STR, ""),
              REQUIRED("name", A_STR, ""), OPTIONAL("of", A_STR, ""), OPTIONAL("title", A_STR, ""),
              PARAM("value", A_INT, OPT, INT32_MIN, INT32_MAX, NULL, NULL, "")),
    SYS_ENTRY(
        "sys.tell_key", sys_tell_key, 0, NULL,
        "called in every frame of a page: tells the program what a button of player p (1) does, which shows it to "
        "new players",
        REQUIRED("button", A_BUTTON, ""), REQUIRED("meaning", A_STR, ""), OPTIONAL("p", A_PLAYER, "")),
    SYS_ENTRY("sys.tell_keys", sys_tell_keys, 0, NULL,
              "called in every frame of name entry: player p gets the characters of the keyboard as codes",
              OPTIONAL("p", A_PLAYER, "")),
    SYS_ENTRY("sys.listen", sys_listen, API_CHANGES, NULL,
              "starts obeying the program's pause menu, with these entries of the game; nil: stops",
              OPTIONAL("labels", A_TABLE, "")),
    SYS_ENTRY("sys.code", sys_get_code, 0, "code",
              "returns what the program tells player p's game in this frame: \"restart\", \"quit\", the number of an "
              "entry, \"backspace\", \"enter\" or a character; nil: nothing",
              REQUIRED("p", A_PLAYER, "")),
    { "sys.practice", sys_practice, NO_PARAMS, 0, API_SYS, "mark, more",
      HELP("returns the practice start; more: lives, registers") },
    SYS_ENTRY("sys.ship", sys_ship, 0, "table",
              "returns what the screens show for a player kind: picture, speed, graze radius, bomb, lives, needs, "
              "registers, then the run's registers",
              REQUIRED("kind", A_PLAYER_KIND, "")),
    SYS_ENTRY("sys.join", sys_join, API_CHANGES, NULL, "makes player i enter the game", REQUIRED("i", A_PLAYER, ""),
              REQUIRED("kind", A_PLAYER_KIND, "")),
    SYS_ENTRY("sys.start", sys_start, API_CHANGES, NULL,
              "starts a game in that scope; a practice start sets lives and registers",
              THING("scope", REQ, 1 << H_TASK, "")),
    SYS_ENTRY("sys.run_registers", sys_run_registers, API_CHANGES, NULL, "declares the run's registers",
              REQUIRED("list", A_TABLE, "")),
    SYS_ENTRY("sys.run", sys_get_run_property, 0, "number", "returns a register of the run, continues or frames",
              REQUIRED("name", A_ANY, "")),
    SYS_ENTRY("sys.value", sys_get_register, 0, "number",
              "returns a register of player i, or of the run; nil if the player is out", REQUIRED("i", A_PLAYER, ""),
              REQUIRED("name", A_STR, ""), OPTIONAL("run", A_BOOL, "")),
    SYS_ENTRY("sys.run_set", sys_run_set, API_CHANGES, "boolean", "sets a register of the run",
              REQUIRED("name", A_ANY, ""), OPTIONAL("value", A_ANY, "")),
    { "sys.run_names", sys_run_names, NO_PARAMS, 0, API_SYS, "list", HELP("returns the names of the run's registers") },
    SYS_ENTRY("sys.continues", sys_continues, API_CHANGES, "count",
              "returns the number of continues player i has left; n sets it", REQUIRED("i", A_PLAYER, ""),
              PARAM("n", A_INT, OPT, 0, 99, NULL, NULL, "")),
    SYS_ENTRY("sys.go_on", sys_use_continue, API_CHANGES, NULL, "uses one of player i's continues",
              REQUIRED("i", A_PLAYER, "")),
    SYS_ENTRY("sys.leave", sys_leave, API_CHANGES, NULL, "makes player i leave the game", REQUIRED("i", A_PLAYER, "")),
    SYS_ENTRY("sys.wipe", sys_wipe, API_CHANGES, NULL,
              "empties the field and the screen; keep: leaves background and palette unchanged",
              OPTIONAL("keep", A_BOOL, "")),
    SYS_ENTRY("sys.show_whole", sys_show_whole, API_CHANGES, NULL,
              "draws the field's picture over the whole screen, or only in the field", REQUIRED("on", A_BOOL, "")),
    { "sys.to_field", sys_to_field, PARAMS(place_params), 2, API_SYS, "x, y",
      HELP("returns the position in the field that a position of the screen shows") },
    { "sys.to_screen", sys_to_screen, PARAMS(place_params), 2, API_SYS, "x, y",
      HELP("returns where the screen shows a position of the field") },
    SYS_ENTRY("sys.freeze", sys_freeze, API_CHANGES, NULL,
              "freezes the board except for that scope's tasks; nil unfreezes it",
              THING("scope", OPT, 1 << H_TASK, "")),
    { "sys.scope", sys_new_scope, NO_PARAMS, 0, API_SYS | API_CHANGES, "scope",
      HELP("returns a scope that the board owns") },
    SYS_ENTRY("sys.scene", sys_new_scene, API_CHANGES, "scope",
              "returns a scope that, when it ends, removes everything spawned or put in it",
              THING("owner", REQ, OWNER_HANDLE_KINDS, "")),
    SYS_ENTRY("sys.skip", sys_skip, API_CHANGES, NULL, "makes this task, or the given one, skip its waits from now on",
              REQUIRED("on", A_BOOL, ""), THING("task", OPT, 1 << H_TASK, "")),
    SYS_ENTRY("sys.turn", sys_run_turn, API_CHANGES, NULL, "runs a task's turn immediately",
              THING("task", REQ, 1 << H_TASK, "")),
    { "sys.faded", sys_finish_fades, NO_PARAMS, 0, API_SYS | API_CHANGES, NULL, HELP("completes all palette fades") },
    SYS_ENTRY("sys.hold_players", sys_hold_players, API_CHANGES, NULL,
              "hides buttons from the game: 0 hides none, 1 hides fire buttons, 2 hides all buttons that control the "
              "ship",
              PARAM("how", A_INT, REQ, 0, 2, NULL, NULL, "")),
    SYS_ENTRY("sys.play_ship", sys_play_ship, API_CHANGES, NULL,
              "lets the ship of player i play by these buttons (PAD_ bits) in this frame, for a page that shows it",
              REQUIRED("i", A_PLAYER, ""), PARAM("pads", A_INT, REQ, 0, PAD_ALL, NULL, NULL, "")),
    SYS_ENTRY("sys.pad", sys_read_button, 0, "boolean",
              "returns the state of a button, even if it is hidden from the game", REQUIRED("how", A_STR, ""),
              REQUIRED("button", A_BUTTON, ""), REQUIRED("p", A_PLAYER, "")),
    SYS_ENTRY("sys.size", sys_get_sprite_size, 0, "w, h, x, y", "returns a sprite's size and origin in px",
              REQUIRED("sprite", A_SPRITE, "")),
    { "sys.skipping", sys_is_skipping, NO_PARAMS, 0, API_SYS, "boolean",
      HELP("returns true while the task skips its waits") },
    { "sys.pass", sys_skip_wait, NO_PARAMS, 0, API_SYS, NULL, HELP("skips one wait in a task that skips its waits") },
    SYS_ENTRY("sys.is_waitable", sys_is_waitable, 0, "boolean", "returns whether wait_for can wait for a value",
              REQUIRED("value", A_ANY, "")),
    { "sys.task", sys_task, NO_PARAMS, 0, API_SYS, "task", HELP("returns the running task") },
    SYS_ENTRY("sys.hold", sys_set_undying, API_CHANGES, NULL, "lets an enemy's hp reach 0 without killing it",
              THING("e", REQ, 1 << H_ENEMY, ""), REQUIRED("on", A_BOOL, "")),
    SYS_ENTRY("sys.enemy_sprite", sys_enemy_sprite, 0, "sprite", "returns the sprite of a kind of enemy",
              REQUIRED("kind", A_ENEMY_KIND, "")),
    SYS_ENTRY("sys.kinds", sys_kinds, 0, "list", "returns the declared names", REQUIRED("name", A_STR, "")),
    { "sys.players", sys_players, NO_PARAMS, 0, API_SYS, "count",
      HELP("returns the number of players the manifest allows") },
    { "sys.large_hud", sys_has_large_hud, NO_PARAMS, 0, API_SYS, "boolean",
      HELP("returns true if the player chose a larger HUD") },
    { "sys.at_title", sys_is_at_title, NO_PARAMS, 0, API_SYS, "boolean",
      HELP("returns true if the board begins with the title's menu") },
    { "sys.difficulties", sys_difficulties, NO_PARAMS, 0, API_SYS, "list",
      HELP("returns the names of the difficulties, easiest first") },
    SYS_ENTRY("sys.on", sys_is_enabled, 0, "boolean",
              "returns true if this board has the capacity for the entry with that name", REQUIRED("name", A_STR, "")),
    SYS_ENTRY(
        "sys.volley", api_push_volley, 0, "function",
        "returns a function that fires an entire pattern at once; it fires nothing and returns false if the loop in "
        "Lua must do it",
        REQUIRED("name", A_STR, "")),
    /* The range is twice the world's, because a position may be WORLD_EDGE px away from a thing anywhere in it. */
    SYS_ENTRY("sys.aim", sys_get_aim_direction, 0, "degrees", "returns the direction in which `aim` points from x, y",
              PARAM("x", A_FX, REQ, -2 * WORLD_EDGE, 2 * WORLD_EDGE, "px", NULL, ""),
              PARAM("y", A_FX, REQ, -2 * WORLD_EDGE, 2 * WORLD_EDGE, "px", NULL, ""), REQUIRED("shots", A_BOOL, "")),
    SYS_ENTRY("sys.drops", sys_pack_drops, API_CHANGES, "list", "checks drops and returns them as a list",
              REQUIRED("name", A_STR, ""), REQUIRED("drops", A_TABLE, "")),
    SYS_ENTRY("sys.drop", sys_drop, API_CHANGES, NULL, "drops the items of a list from sys.drops",
              REQUIRED("list", A_ANY, ""), COORDINATE("x", A_FX, REQ, ""), COORDINATE("y", A_FX, REQ, "")),
    SYS_ENTRY("sys.worth", sys_get_points, 0, "points", "returns the points that a dead enemy or a taken item gave",
              THING("thing", REQ, 1 << H_ENEMY | 1 << H_ITEM, ""), REQUIRED("p", A_PLAYER, "")),
    SYS_ENTRY("sys.cue", sys_play_cue, 0, NULL, "plays the sound with that name, if the game has one",
              PARAM("name", A_STR, REQ, 1, 32, NULL, NULL, ""), PARAM("pan", A_NUM, OPT, -1, 1, NULL, "0", "")),
    SYS_ENTRY(
        "sys.music_on", sys_interrupt_music, API_CHANGES, "boolean",
        "sets the current music aside for that piece, after a fade; returns false if the piece is already playing",
        REQUIRED("name", A_TUNE, ""), PARAM("fade", A_INT, OPT, 0, 65535, "frames", NULL, "")),
    SYS_ENTRY("sys.music_back", sys_resume_music, API_CHANGES, NULL, "ends that piece and resumes the music set aside",
              REQUIRED("name", A_TUNE, ""), PARAM("fade", A_INT, OPT, 0, 65535, "frames", NULL, "")),
    SYS_ENTRY("sys.music_clock", sys_skip_music_clock, API_CHANGES, NULL,
              "advances the stage's clock by that many frames on the way to a mark",
              PARAM("n", A_INT, REQ, 0, INT32_MAX, "frames", NULL, "")),
    SYS_ENTRY("sys.music_fight", sys_skip_fight_music, API_CHANGES, NULL,
              "notes that a fight with that music was skipped on the way to a mark", OPTIONAL("name", A_TUNE, ""),
              PARAM("fade", A_INT, REQ, 0, 65535, "frames", NULL, "")),
    { "sys.pieces", sys_list_tunes, NO_PARAMS, 0, API_SYS, "list", HELP("returns the pieces of music from rom.lua") },
    { "sys.clock", sys_clock, NO_PARAMS, 0, API_SYS, "frames", HELP("returns the game time") },
};
const struct api_module api_sys = { entries, sizeof entries / sizeof *entries };
