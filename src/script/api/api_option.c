/*
 * api_option.c - option.def, and the options of ships in player.def.
 */
#include <stdio.h>
#include <string.h>
#include "api_parts.h"

enum { D_SPRITE = 1, D_TURNS = 5 };

static const struct api_param def_params[] = {
    LABEL("name", REQ, "name of the kind, used in `options` of player.def; must be new"),
    REQUIRED("sprite", A_SPRITE, "sprite to draw", STORED(option_kinds.sprite)),
    BANK(OPT, "0", "number added to the palette bank of its sprite", STORED(option_kinds.bank)),
    DEFAULT("layer", A_LAYER, "front", "sprite layer to draw it in", BITS_OF(option_kinds.layer, OPTION_LAYER)),
    OPTIONAL("run", A_FUNC, "run(o): task of each option; it ends with the option", PROPERTY("option's run")),
    [D_TURNS] = DEFAULT("turns", A_BOOL, "false",
                        "rotate the sprite to the direction in which the option moves; the sprite needs `rotations` in "
                        "rom.lua; needs `board = { transforms = true }`",
                        BITS_OF(option_kinds.layer, OPTION_TURNS)),
};

static int option_def(lua_State *L, struct board *b, struct api_value *v)
{
    api_check_transforms(L, v, D_TURNS, 1);
    if (v[D_TURNS].i)
        api_check_rotations(L, "option.def", "turns", &v[D_SPRITE]);
    api_append_kind(L, "option.def", &b->option_kinds.s, N_OPTION, v);
    return 0;
}

/* ---- options of player.def ---- */

static const char player_entry[] = "player.def", *const style_names[] = { "fixed", "trail", "orbit" };

enum { O_KIND, O_REGISTER, O_LEVELS, O_OVER, O_STYLE, O_SPACING, O_RADIUS, O_CLOSE, O_SPIN, O_PARAM_COUNT };

static const struct api_param options_params[O_PARAM_COUNT] = {
    REQUIRED("kind", A_OPTION_KIND, "declared kind of the options"),
    LABEL("by", OPT, "register of the ship that selects the level; without it, the last level applies"),
    REQUIRED("levels", A_TABLE, "list of 1 to 16 levels, each with a higher `at` than the one before"),
    PARAM("over", A_INT, OPT, 0, 65535, "frames", "8",
          "frames the options take to reach new positions; not for style trail"),
    DEFAULT("style", A_STR, "fixed",
            "how the options fly: fixed (at positions around the ship), trail (along its path) or orbit (on a circle)"),
    PARAM("apart", A_INT, OPT, 1, OPTION_PATH_LENGTH - 1, "frames", "8",
          "frames of flight between one option and the next; only for style trail"),
    LENGTH("radius", OPT, NULL, "radius of the circle; only for style orbit, where it is required"),
    LENGTH("close", OPT, NULL, "radius while focused; defaults to `radius`; only for style orbit"),
    DEFAULT("spin", A_DIR, "0", "degrees the circle turns per frame, clockwise; only for style orbit"),
};

enum { L_AT, L_N, L_WIDE, L_CLOSE, L_PARAM_COUNT };

static const struct api_param level_params[L_PARAM_COUNT] = {
    PARAM("at", A_INT, OPT, INT32_MIN, INT32_MAX, NULL, "0", "lowest value of the register at which the level applies"),
    PARAM("n", A_INT, OPT, 0, OPTION_MAX_PER_SHIP, "options", NULL,
          "number of options; only for styles trail and orbit, where it is required"),
    OPTIONAL("wide", A_TABLE,
             "positions around the ship, { { dx, dy }, .. } in px; only for style fixed, where it is required"),
    OPTIONAL("close", A_TABLE,
             "positions while focused, as many as in `wide`; defaults to `wide`; only for style fixed"),
};

static fx read_axis(lua_State *L, const char *setting, int axis)
{
    const struct api_param p = COORDINATE(setting, A_FX, REQ, NULL);
    struct api_value v = { 0 };

    lua_rawgeti(L, -1, axis + 1);
    api_check(L, player_entry, &p, lua_gettop(L), &v);
    lua_pop(L, 1);
    return v.f;
}

/* Reads { { dx, dy }, .. } at `at`; returns the number of positions. */
static uint32_t read_positions(lua_State *L, const char *setting, int at, fx positions[OPTION_MAX_PER_SHIP][2])
{
    const lua_Unsigned n = lua_rawlen(L, at);
    char full_name[80];

    if (n > OPTION_MAX_PER_SHIP)
        api_error(L, player_entry, "%s: expected at most %d options, got %d", setting, OPTION_MAX_PER_SHIP, (int)n);
    for (lua_Unsigned i = 0; i < n; i++) {
        snprintf(full_name, sizeof full_name, "%s[%d]", setting, (int)i + 1);
        if (lua_rawgeti(L, at, (lua_Integer)i + 1) != LUA_TTABLE)
            api_error(L, player_entry, "%s: expected { dx, dy }, got %s", full_name, luaL_typename(L, -1));
        for (int axis = 0; axis < 2; axis++)
            positions[i][axis] = read_axis(L, full_name, axis);
        lua_pop(L, 1);
    }
    return (uint32_t)n;
}

static void read_fixed_level(lua_State *L, const char *setting, const struct api_value *v, struct option_level *level)
{
    char full_name[64];

    if (!v[L_WIDE].given)
        api_error(L, player_entry, "%s: wide: expected a list { { dx, dy }, .. }, got nil", setting);
    if (v[L_N].given)
        api_error(L, player_entry,
                  "%s: `n` applies to styles trail and orbit; a level of style fixed has one option for each position "
                  "in `wide`",
                  setting);
    snprintf(full_name, sizeof full_name, "%s.wide", setting);
    level->n = read_positions(L, full_name, v[L_WIDE].at, level->unfocused_offset);
    memcpy(level->focused_offset, level->unfocused_offset, sizeof level->focused_offset);
    if (!v[L_CLOSE].given)
        return;
    snprintf(full_name, sizeof full_name, "%s.close", setting);
    const uint32_t n = read_positions(L, full_name, v[L_CLOSE].at, level->focused_offset);
    if (n != level->n)
        api_error(L, player_entry, "%s: expected as many positions as in `wide` (%d), got %d", full_name, (int)level->n,
                  (int)n);
}

static void read_counted_level(lua_State *L, const char *setting, const struct api_value *v,
                               const struct option_plan *plan, struct option_level *level)
{
    if (v[L_WIDE].given || v[L_CLOSE].given)
        api_error(L, player_entry, "%s: `%s` applies to style fixed; use `n` with style %s", setting,
                  v[L_WIDE].given ? "wide" : "close", style_names[plan->style]);
    if (!v[L_N].given)
        api_error(L, player_entry, "%s: n: expected a whole number from 0 to %d options, got nil", setting,
                  OPTION_MAX_PER_SHIP);
    level->n = (uint32_t)v[L_N].i;
    if (plan->style == OPTION_TRAIL && level->n * plan->spacing >= OPTION_PATH_LENGTH)
        api_error(L, player_entry,
                  "%s: `n` times `apart`: expected at most %d frames (the length of the recorded trail), got %d",
                  setting, OPTION_PATH_LENGTH - 1, (int)(level->n * plan->spacing));
}

static void read_level(lua_State *L, int list, int i, struct option_plan *plan)
{
    struct option_level *level = &plan->level[i];
    struct api_value v[L_PARAM_COUNT];
    char setting[32];
    const int top = lua_gettop(L);

    snprintf(setting, sizeof setting, "options.levels[%d]", i + 1);
    if (lua_rawgeti(L, list, i + 1) != LUA_TTABLE)
        api_error(L, player_entry, "%s: expected { at = n, .. }, got %s", setting, luaL_typename(L, -1));
    api_read_fields(L, player_entry, setting, &(struct api_fields){ level_params, L_PARAM_COUNT, NAME_LISTS }, top + 1,
                    v);
    level->min_value = v[L_AT].given ? (int32_t)v[L_AT].i : 0;
    if (i && level->min_value <= plan->level[i - 1].min_value)
        api_error(L, player_entry, "%s.at: expected more than the level before (%d), got %d", setting,
                  (int)plan->level[i - 1].min_value, (int)level->min_value);
    if (plan->style == OPTION_FIXED)
        read_fixed_level(L, setting, v, level);
    else
        read_counted_level(L, setting, v, plan, level);
    lua_settop(L, top);
}

static enum option_style read_style(lua_State *L, const struct api_value *v)
{
    struct api_suggestion s = { .word = v->given ? lua_tostring(L, v->at) : "fixed" };

    for (int i = 0; i <= OPTION_ORBIT; i++) {
        if (!strcmp(s.word, style_names[i]))
            return (enum option_style)i;
        api_consider(&s, style_names[i]);
    }
    return (enum option_style)api_error(L, player_entry, "options.style: expected fixed, trail or orbit, got \"%s\"%s",
                                        s.word, api_push_did_you_mean(L, &s, ""));
}

/* Raises an error for settings that belong to another style. */
static void check_style(lua_State *L, const struct api_value *v, enum option_style style)
{
    static const struct {
        int param;
        enum option_style style;
    } style_settings[] = {
        { O_SPACING, OPTION_TRAIL }, { O_RADIUS, OPTION_ORBIT }, { O_CLOSE, OPTION_ORBIT }, { O_SPIN, OPTION_ORBIT }
    };

    for (size_t i = 0; i < sizeof style_settings / sizeof *style_settings; i++)
        if (v[style_settings[i].param].given && style_settings[i].style != style)
            api_error(L, player_entry, "options.%s: requires style = \"%s\"",
                      options_params[style_settings[i].param].name, style_names[style_settings[i].style]);
    if (style == OPTION_ORBIT && !v[O_RADIUS].given)
        api_error(L, player_entry, "options.radius: expected a number of px, got nil");
}

static const char plans_key = 0; /* registry: kind of ship -> struct option_plan */

/* Stores the plan on top of the stack as the plan of a ship. The plans and the array of pointers to them are all in
 * Lua's heap. */
static void store_plan(lua_State *L, struct board *b, int32_t ship, struct option_plan *plan)
{
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &plans_key) != LUA_TTABLE) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &plans_key);
        b->option_plans = lua_newuserdatauv(L, b->player_kinds.s.cap * sizeof *b->option_plans, 0);
        memset(b->option_plans, 0, b->player_kinds.s.cap * sizeof *b->option_plans);
        lua_rawseti(L, -2, -1);
    }
    lua_insert(L, -2);
    lua_rawseti(L, -2, ship);
    b->option_plans[ship] = plan;
}

void api_options_read(lua_State *L, struct board *b, int32_t ship, const struct api_value *options)
{
    const char *disabled_reason = api_disabled_reason(&b->cart.manifest, "option");
    struct api_value v[O_PARAM_COUNT];
    const int top = lua_gettop(L);

    if (!options->given)
        return;
    if (disabled_reason)
        api_error(L, player_entry, "options: " API_DISABLED_FORMAT, disabled_reason);
    api_read_fields(L, player_entry, "options", &(struct api_fields){ options_params, O_PARAM_COUNT, NAME_LISTS },
                    options->at, v);
    const enum option_style style = read_style(L, &v[O_STYLE]);
    check_style(L, v, style);
    const lua_Unsigned n = lua_rawlen(L, v[O_LEVELS].at);
    if (n < 1 || n > OPTION_MAX_LEVELS)
        api_error(L, player_entry, "options.levels: expected a list of 1 to %d levels, got %d", OPTION_MAX_LEVELS,
                  (int)n);
    const size_t size = sizeof(struct option_plan) + (size_t)n * sizeof(struct option_level);
    struct option_plan *plan = memset(lua_newuserdatauv(L, size, 0), 0, size);
    const int plan_at = lua_gettop(L);
    plan->kind = (uint16_t)v[O_KIND].i;
    plan->style = style;
    plan->level_register = v[O_REGISTER].given ? api_register_expect(L, player_entry, "options.by", ship,
                                                                     lua_tostring(L, v[O_REGISTER].at))
                                               : -1;
    plan->move_duration = v[O_OVER].given ? (uint32_t)v[O_OVER].i : 8;
    plan->spacing = v[O_SPACING].given ? (uint32_t)v[O_SPACING].i : 8;
    plan->unfocused_offset = v[O_RADIUS].f;
    plan->focused_offset = v[O_CLOSE].given ? v[O_CLOSE].f : v[O_RADIUS].f;
    plan->spin = v[O_SPIN].given ? v[O_SPIN].a : 0;
    for (; plan->n_levels < n; plan->n_levels++)
        read_level(L, v[O_LEVELS].at, (int)plan->n_levels, plan);
    lua_pushvalue(L, plan_at);
    store_plan(L, b, ship, plan);
    lua_settop(L, top);
}

/* ---- properties ---- */

enum { P_X, P_Y, P_PLAYER, P_INDEX, P_FOCUS, P_AGE, P_KIND, P_BANK, P_HIDDEN, P_DIR, PROPS };

static const struct api_param props[PROPS] = {
    PARAM("x", A_FX, REQ, 0, 0, "px", NULL, "horizontal position in the field", STORED(options.x)),
    PARAM("y", A_FX, REQ, 0, 0, "px", NULL, "vertical position in the field", STORED(options.y)),
    THING("by", REQ, 1 << H_PLAYER, "player it belongs to"),
    REQUIRED("index", A_INT, "number among the player's options, from 1"),
    REQUIRED("focus", A_BOOL, "true while its player flies at focus speed"),
    REQUIRED("age", A_INT, "frames since it spawned", AGE_OF(options.born)),
    REQUIRED("kind", A_OPTION_KIND, "name of its kind", STORED(options.kind)),
    BANK(REQ, NULL, "number added to the palette bank of its sprite", STORED(options.bank), WRITABLE),
    REQUIRED("hidden", A_BOOL, "true if not drawn; it still flies and fires", BITS_OF(options.flags, OPTION_HIDDEN),
             WRITABLE),
    REQUIRED("dir", A_DIR, "direction to which its sprite is turned, 0 to 360; needs `board = { transforms = true }`",
             STORED(options.dir), WRITABLE),
};

static void get_option(lua_State *L, struct board *b, uint32_t i, int p)
{
    const struct options *o = &b->options;

    if (p == P_PLAYER)
        lua_pushinteger(L, board_handle(b, H_PLAYER, o->player[i]));
    else if (p == P_INDEX)
        lua_pushinteger(L, o->index[i] + 1);
    else
        lua_pushboolean(L, b->player.flags[o->player[i]] & PLAYER_FOCUS);
}

const struct api_thing api_option_thing = { "option", props, PROPS, .get = get_option,
                                            .slots_offset = offsetof(struct board, options.s) };

static const struct api_entry entries[] = {
    { "option.def", option_def, PARAMS(def_params), 1, API_CHANGES | API_LOAD_ONLY, NULL,
      HELP("declares a kind of option, a thing that flies with a ship and fires; needs `board = { options = n }`") },
    { "player.def options", NULL, PARAMS(options_params), 0, API_LUA | API_SYS, NULL,
      HELP("which options fly with the ship, and how") },
    { "player.def level", NULL, PARAMS(level_params), 0, API_LUA | API_SYS, NULL,
      HELP("one level of options; of the levels whose `at` the register has reached, the highest applies") },
};
const struct api_module api_option = { entries, sizeof entries / sizeof *entries };
