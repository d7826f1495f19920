/*
 * api_board.c - the Lua tables board and rom.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../../base/hash.h"
#include "../../machine/window.h"
#include "api.h"
#include "../lua/lualib.h"
#include "api_parts.h"

/* Parameter indices: each entry has only one parameter. */
enum { ARG_FRAMES = 0, ARG_NAME = 0, ARG_CHIP = 0, ARG_DEMO = 0, ARG_VALUE = 0, ARG_SCREEN = 0 };

static const struct api_param difficulty_params[] = { OPTIONAL(
    "name", A_STR, "difficulty from rom.lua to switch to; if omitted, the difficulty doesn't change") };
static const struct api_param dip_params[] = { REQUIRED("name", A_STR,
                                                        "name of a switch declared in `dip` in rom.lua") };
static const struct api_param file_params[] = { REQUIRED("name", A_STR,
                                                         "name of a sprite, or of a file in the game's folder") };
static const struct api_param text_params[] = { REQUIRED("name", A_STR, "name of a .txt file in the game's folder") };
static const struct api_param chip_params[] = { REQUIRED("chip", A_STR,
                                                         "name of a pool, such as bullets, enemies, sparks or tasks") };
static const struct api_param demo_params[] = { PARAM("demo", A_STR, REQ, 1, 63, NULL, NULL,
                                                      "name of a demo in the ROM") };
static const struct api_param screen_params[] = { REQUIRED("what", A_HOST_SCREEN, "screen to open") };
static const struct api_param stop_params[] = { PARAM(
    "n", A_INT, REQ, 1, 60, "frames", NULL,
    "length of the stop; of several stops in the same frame, the longest counts") };
static const struct api_param note_params[] = { REQUIRED("v", A_ANY, "number, string or boolean to fold in") };

static int push_frame_number(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, b->core.frame);
    return 1;
}

static int raise_unknown_difficulty(lua_State *L, const struct manifest *m, const char *name)
{
    struct api_hint hint;

    api_hint_begin(&hint, name);
    for (int i = 0; i < m->n_difficulties; i++)
        api_hint_add(&hint, m->difficulties[i]);
    return api_error(L, "board.difficulty", "unknown difficulty \"%s\"%s", name, api_hint_push(L, &hint, "in rom.lua"));
}

static int board_difficulty(lua_State *L, struct board *b, struct api_value *v)
{
    const struct manifest *m = &b->cart.manifest;

    if (v[ARG_NAME].given) {
        int i = 0;
        while (i < m->n_difficulties && strcmp(m->difficulties[i], lua_tostring(L, v[ARG_NAME].at)))
            i++;
        if (i == m->n_difficulties)
            return raise_unknown_difficulty(L, m, lua_tostring(L, v[ARG_NAME].at));
        b->core.difficulty = (uint32_t)i;
    }
    lua_pushstring(L, m->difficulties[b->core.difficulty]);
    return 1;
}

static int board_dip(lua_State *L, struct board *b, struct api_value *v)
{
    const struct manifest *m = &b->cart.manifest;

    for (int i = 0; i < m->n_dips; i++) {
        if (strcmp(m->dips[i].name, lua_tostring(L, v[ARG_NAME].at)))
            continue;
        if (m->dips[i].is_number)
            lua_pushinteger(L, b->start.dip[i]);
        else
            lua_pushstring(L, m->dips[i].value_name[b->start.dip[i]]);
        return 1;
    }
    struct api_hint hint;
    api_hint_begin(&hint, lua_tostring(L, v[ARG_NAME].at));
    for (int i = 0; i < m->n_dips; i++)
        api_hint_add(&hint, m->dips[i].name);
    return api_error(L, "board.dip", "unknown DIP switch \"%s\"%s", hint.suggestion.word,
                     api_hint_push(L, &hint, "in rom.lua"));
}

static int request_board_reset(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L, (void)v;
    b->reset_requested = true;
    return 0;
}

/* Returns the slots of the pool named at stack index `at`; raises an error if there is no such pool. */
static const struct slots *check_pool(lua_State *L, struct board *b, const char *entry, int at)
{
    const struct slots *s = part_find(b, lua_tostring(L, at));

    if (!s) {
        struct api_hint hint;
        api_hint_begin(&hint, lua_tostring(L, at));
        for (int i = 0; i < PART_COUNT; i++)
            api_hint_add(&hint, machine_parts[i].chip->name);
        api_error(L, entry, "unknown pool \"%s\"%s", hint.suggestion.word, api_hint_push(L, &hint, "chips"));
    }
    return s;
}

/* board.live and board.refused. */
static int push_pool_count(lua_State *L, struct board *b, struct api_value *v)
{
    const char *entry = api_current_binding(L)->entry->name;
    const struct slots *s = check_pool(L, b, entry, v[ARG_CHIP].at);

    lua_pushinteger(L, !strcmp(entry, "board.live") ? s->live : s->refused);
    return 1;
}

/* Has no effect during a pause or a longer stop, or in a task that fast-forwards to a practice mark. */
static int board_stop(lua_State *L, struct board *b, struct api_value *v)
{
    const int64_t frozen = -v[ARG_FRAMES].i - 1;

    if (b->vm.loading)
        return api_error(L, "board.stop", "cannot be called while scripts load");
    if (frozen < b->core.frozen && b->core.frozen <= 0 && !tasks_is_skipping(&b->tasks))
        b->core.frozen = frozen;
    return 0;
}

static int board_attract(lua_State *L, struct board *b, struct api_value *v)
{
    b->output->out.request = REQUEST_ATTRACT;
    strcpy(b->output->out.attract, lua_tostring(L, v[ARG_DEMO].at));
    return 0;
}

static int request_host_screen(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    b->output->out.request = REQUEST_HOST_SCREEN;
    b->output->out.host_screen = (enum board_host_screen)v[ARG_SCREEN].i;
    return 0;
}

static int board_note(lua_State *L, struct board *b, struct api_value *v)
{
    double d = lua_tonumber(L, v[ARG_VALUE].at);
    uint64_t bits;
    size_t n;
    const char *s;

    switch (lua_type(L, v[ARG_VALUE].at)) {
    case LUA_TNUMBER:
        memcpy(&bits, &d, sizeof bits);
        if (!isfinite(d))
            return api_error(L, "board.note", "v: expected a finite number");
        b->core.note_digest =
            hash_fold(b->core.note_digest,
                      lua_isinteger(L, v[ARG_VALUE].at) ? (uint64_t)lua_tointeger(L, v[ARG_VALUE].at) : bits);
        return 0;
    case LUA_TSTRING:
        s = lua_tolstring(L, v[ARG_VALUE].at, &n);
        b->core.note_digest = hash_bytes(b->core.note_digest, s, n);
        return 0;
    case LUA_TBOOLEAN:
        b->core.note_digest = hash_fold(b->core.note_digest, 2 + (uint64_t)lua_toboolean(L, v[ARG_VALUE].at));
        return 0;
    default:
        return api_error(L, "board.note", "v: expected a number, string or boolean, got a %s",
                         luaL_typename(L, v[ARG_VALUE].at));
    }
}

/* ---- rom ---- */

static int rom_has(lua_State *L, struct board *b, struct api_value *v)
{
    const char *name = lua_tostring(L, v[ARG_NAME].at), *text;
    size_t n;

    lua_pushboolean(L, cart_find(&b->cart, CART_SPRITES, name) >= 0 || cart_find_text(&b->cart, name, &text, &n) ||
                           rom_find(b->cart.rom, name) >= 0);
    return 1;
}

static int rom_text(lua_State *L, struct board *b, struct api_value *v)
{
    const char *text;
    size_t n;

    if (!cart_find_text(&b->cart, lua_tostring(L, v[ARG_NAME].at), &text, &n))
        return api_error(L, "rom.text", "no text file \"%s\" in the game", lua_tostring(L, v[ARG_NAME].at));
    lua_pushlstring(L, text, n);
    return 1;
}

/* __newindex of a read-only table. Upvalue 1: the table's name. */
static int raise_read_only(lua_State *L)
{
    const char *key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : NULL, *dot = key ? "." : "";

    return vm_fault(L, FAULT_SCRIPT, "%s%s%s is read-only", lua_tostring(L, lua_upvalueindex(1)), dot, key ? key : "");
}

/* Replaces the table on top of the stack with a read-only view of that table. */
static void make_read_only(lua_State *L, const char *name)
{
    lua_newtable(L);
    lua_rotate(L, -2, 1);
    lua_pushstring(L, name);
    lua_pushcclosure(L, raise_read_only, 1);
    lualib_seal(L);
}

static void set_rect(lua_State *L, const char *name, int x, int y, int w, int h)
{
    const char *const keys[] = { "x", "y", "w", "h" };
    const int values[] = { x, y, w, h };
    char full_name[16];

    lua_createtable(L, 0, 4);
    for (int i = 0; i < 4; i++) {
        lua_pushinteger(L, values[i]);
        lua_setfield(L, -2, keys[i]);
    }
    snprintf(full_name, sizeof full_name, "rom.%s", name);
    make_read_only(L, full_name);
    lua_setfield(L, -2, name);
}

void api_open_rom(lua_State *L)
{
    const struct manifest *m = &vm_board(L)->cart.manifest;

    lua_getglobal(L, "rom");
    api_set_string(L, "title", m->title);
    set_rect(L, "screen", 0, 0, m->screen_w, m->screen_h);
    set_rect(L, "field", m->field_x, m->field_y, m->field_w, m->field_h);
    if (m->view_w || m->zoom > 1) {
        const struct window w = window_of(vm_board(L));
        set_rect(L, "view", w.x, w.y, w.w, w.h);
    } else {
        lua_getfield(L, -1, "field");
        lua_setfield(L, -2, "view");
    }
    make_read_only(L, "rom");
    lua_setglobal(L, "rom");
}

static const struct api_entry entries[] = {
    { "board.frame", push_frame_number, NO_PARAMS, 0, 0, "frames",
      HELP("returns the number of frames since power-on") },
    { "board.difficulty", board_difficulty, PARAMS(difficulty_params), 1, API_CHANGES, "name",
      HELP("returns the name of the current difficulty; given a name, switches to that difficulty first") },
    { "board.dip", board_dip, PARAMS(dip_params), 1, 0, "value",
      HELP("returns the setting of a DIP switch, a name or a number") },
    { "board.reset", request_board_reset, NO_PARAMS, 0, API_CHANGES, NULL,
      HELP("restarts the board after this frame, as if power had been cut") },
    { "board.live", push_pool_count, PARAMS(chip_params), 1, 0, "count",
      HELP("returns how many entries of a pool are in use") },
    { "board.refused", push_pool_count, PARAMS(chip_params), 1, 0, "count",
      HELP("returns how many entries weren't created because the pool was full") },
    { "board.attract", board_attract, PARAMS(demo_params), 1, API_CHANGES, NULL,
      HELP("shows a demo from the ROM and pauses this board until the demo ends") },
    { "board.ask", request_host_screen, PARAMS(screen_params), 1, API_CHANGES, NULL,
      HELP("opens one of the program's own screens and pauses the board until the player closes it, or quits the "
           "program; "
           "does nothing in a demo") },
    { "board.stop", board_stop, PARAMS(stop_params), 1, API_CHANGES, NULL,
      HELP("freezes the field and all tasks after this frame (hit-stop); button presses during the stop take effect "
           "after it") },
    { "board.note", board_note, PARAMS(note_params), 1, API_CHANGES, NULL,
      HELP("folds a value into the state hash; a demo in which the value differs is reported as diverged") },
    { "rom.has", rom_has, PARAMS(file_params), 1, 0, "boolean",
      HELP("returns true if the game has a sprite or a file with that name") },
    { "rom.text", rom_text, PARAMS(text_params), 1, 0, "string",
      HELP("returns the contents of a text file in the game") },
};
const struct api_module api_board = { entries, sizeof entries / sizeof *entries };
