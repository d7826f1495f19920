/*
 * api_register.c - the rules and names of registers, of ships (player.def) and of the run (game.def).
 */
#include <stdio.h>
#include <string.h>
#include "api_parts.h"

/* Registry, by kind of ship or RUN_REGISTERS: { name -> number }; and { number -> { show, at, label, mark } }, for
 * registers that declare how they are shown. */
static const char names_key = 0, displays_key = 0;

static const char *const show_modes[] = { "none", "number", "icons", "bar", "times", NULL }, *const show_positions[] = {
    "top", "low", NULL
};

enum { S_START, S_MIN, S_MAX, S_DRAIN, S_EVERY, S_HOLD, S_SHOW, S_AT, S_LABEL, S_MARK };

const struct api_param api_register_settings[REGISTER_SETTING_COUNT] = {
    PARAM("start", A_INT, OPT, -INT32_MAX, INT32_MAX, NULL, NULL,
          "value in a new game; defaults to 0, or to `min` if that is higher"),
    PARAM("min", A_INT, OPT, -INT32_MAX, INT32_MAX, NULL, NULL, "lowest value; defaults to 0"),
    PARAM("max", A_INT, OPT, -INT32_MAX, INT32_MAX, NULL, NULL, "highest value; no limit if omitted"),
    PARAM("drain", A_COUNT, OPT, -INT32_MAX, INT32_MAX, NULL, NULL,
          "amount that the register loses at each interval, down to `min`; a negative amount raises it, up to `max`; "
          "with forever, the register returns to `start` in one step"),
    PARAM("every", A_INT, OPT, 1, INT32_MAX, "frames", NULL, "frames from one drain to the next; defaults to 1"),
    PARAM("hold", A_INT, OPT, 0, INT32_MAX, "frames", NULL,
          "frames for which the drain pauses after a script or an item changes the register in the opposite direction; "
          "needs `drain`"),
    OPTIONAL("show", A_STR, "how the HUD shows the register: none, number, icons, bar or times; a bar needs `max`"),
    OPTIONAL("at", A_STR, "where the HUD shows the register: top, or low (at the lower edge of the field)"),
    PARAM("label", A_STR, OPT, 0, 31, NULL, NULL, "word shown before the register; defaults to its name"),
    PARAM("mark", A_INT, OPT, -INT32_MAX, INT32_MAX, NULL, NULL,
          "lowest value at which the HUD shows the register in the bright colour"),
};

struct register_declaration {
    const char *name, *show_mode, *position, *label; /* NULL: not given; the declared table keeps the strings alive */
    bool has_mark;
    int32_t mark;
    struct register_rule rule;
};

/* Returns the element of `choices` that setting v[setting] equals; NULL if the setting is not given. */
static const char *read_choice(lua_State *L, const char *entry, const char *name, const struct api_value *v,
                               int setting, const char *const *choices, const char *expected)
{
    if (!v[setting].given)
        return NULL;
    for (int i = 0; choices[i]; i++)
        if (!strcmp(choices[i], lua_tostring(L, v[setting].at)))
            return choices[i];
    api_error(L, entry, "%s.%s: expected %s, got \"%s\"", name, api_register_settings[setting].name, expected,
              lua_tostring(L, v[setting].at));
    return NULL;
}

/* Returns the integer in v (DRAIN_TO_START for forever), or `fallback` if v is not given. */
static int32_t read_setting(const struct api_value *v, int32_t fallback)
{
    if (!v->given)
        return fallback;
    return v->i == LUA_MAXINTEGER ? DRAIN_TO_START : (int32_t)v->i;
}

static void check_rule(lua_State *L, const char *entry, const char *name, const struct register_declaration *r)
{
    const struct register_rule *rule = &r->rule;

    if (rule->min_value > rule->max_value)
        api_error(L, entry, "%s: min %d is greater than max %d", name, (int)rule->min_value, (int)rule->max_value);
    if (rule->start > rule->max_value)
        api_error(L, entry, "%s: start %d is greater than max %d", name, (int)rule->start, (int)rule->max_value);
    if (rule->start < rule->min_value)
        api_error(L, entry, "%s: start %d is less than min %d", name, (int)rule->start, (int)rule->min_value);
    if (rule->max_value == REGISTER_NO_MAX && r->show_mode && !strcmp(r->show_mode, "bar"))
        api_error(L, entry, "%s: `show = \"bar\"` requires `max`", name);
    if (!rule->drain && rule->hold)
        api_error(L, entry, "%s: `hold` requires `drain` (a number or forever)", name);
}

/* Reads the rule { start = 3, max = 6, show = "icons" } at `at`. */
static void read_rule(lua_State *L, const char *entry, const char *name, int at, struct register_declaration *r)
{
    static const struct api_fields fields = { api_register_settings, REGISTER_SETTING_COUNT, NAME_LISTS };
    struct register_rule *rule = &r->rule;
    struct api_value v[REGISTER_SETTING_COUNT];

    api_read_fields(L, entry, name, &fields, at, v);
    rule->min_value = read_setting(&v[S_MIN], 0);
    rule->max_value = read_setting(&v[S_MAX], REGISTER_NO_MAX);
    rule->start = read_setting(&v[S_START], rule->min_value > 0 ? rule->min_value : 0);
    rule->drain = read_setting(&v[S_DRAIN], 0);
    rule->interval = read_setting(&v[S_EVERY], 1);
    rule->hold = read_setting(&v[S_HOLD], 0);
    r->show_mode = read_choice(L, entry, name, v, S_SHOW, show_modes, "none, number, icons, bar or times");
    r->position = read_choice(L, entry, name, v, S_AT, show_positions, "top or low");
    r->label = v[S_LABEL].given ? lua_tostring(L, v[S_LABEL].at) : NULL;
    r->has_mark = v[S_MARK].given;
    r->mark = read_setting(&v[S_MARK], 0);
    check_rule(L, entry, name, r);
}

/* Raises an error if the name is already used by players or by the table game. */
static void check_register_name(lua_State *L, const char *entry, int32_t kind, const char *name)
{
    static const char *const game_fields[] = { "def", "stage", "mode", "continues", "frames", NULL };

    if (kind == RUN_REGISTERS) {
        for (int i = 0; game_fields[i]; i++)
            if (!strcmp(game_fields[i], name))
                api_error(L, entry, "registers: game.%s already exists", name);
        return;
    }
    if (api_has_property(api_get_table(L)->things[H_PLAYER], name) || !strcmp(name, "alive"))
        api_error(L, entry, "registers: \"%s\" is already a property of players", name);
    if (api_push_method(L, H_PLAYER, name))
        api_error(L, entry, "registers: \"%s\" is already a method of players", name);
    lua_pop(L, 1);
}

/* Reads the register named `register_name`, whose declared value is on top of the stack. */
static struct register_declaration read_register(lua_State *L, const char *entry, int32_t kind,
                                                 const char *register_name)
{
    struct register_declaration r = { .name = register_name, .rule = { .max_value = REGISTER_NO_MAX, .interval = 1 } };
    struct api_value v = { 0 };
    char name[64];

    check_register_name(L, entry, kind, r.name);
    snprintf(name, sizeof name, "registers.%s", r.name);
    if (lua_istable(L, -1)) {
        read_rule(L, entry, name, lua_gettop(L), &r);
        return r;
    }
    const struct api_param param = PARAM(name, A_INT, REQ, 0, INT32_MAX, NULL, NULL, NULL);
    api_check(L, entry, &param, lua_gettop(L), &v);
    r.rule.start = (int32_t)v.i;
    return r;
}

/* Stores how register i is shown. Creates the table on first use. */
static void store_display(lua_State *L, int32_t kind, int i, const struct register_declaration *r)
{
    int top = lua_gettop(L);

    if (!r->show_mode)
        return;
    vm_push_registry_table(L, &displays_key);
    if (lua_rawgeti(L, -1, kind) != LUA_TTABLE) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_rawseti(L, -3, kind);
    }
    lua_newtable(L);
    api_set_string(L, "show", r->show_mode);
    api_set_string(L, "at", r->position);
    api_set_string(L, "label", r->label);
    if (r->has_mark)
        api_set_integer(L, "mark", r->mark);
    lua_rawseti(L, -2, i);
    lua_settop(L, top);
}

void api_register_add_display(lua_State *L, int32_t kind, int i)
{
    static const char *const fields[] = { "show", "at", "label", "mark" };
    int top = lua_gettop(L);

    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &displays_key) == LUA_TTABLE && lua_rawgeti(L, -1, kind) == LUA_TTABLE &&
        lua_rawgeti(L, -1, i) == LUA_TTABLE)
        for (int k = 0; k < 4; k++) {
            lua_getfield(L, -1, fields[k]);
            lua_setfield(L, top, fields[k]);
        }
    lua_settop(L, top);
}

static void add_register_rows(lua_State *L, const char *entry, int32_t kind, const struct register_declaration *regs,
                              int n)
{
    struct registers *rows = &vm_board(L)->registers;

    vm_push_registry_table(L, &names_key);
    lua_createtable(L, 0, n);
    for (int i = 0; i < n; i++) {
        if (registers_add(rows, &regs[i].rule) == NO_SLOT)
            api_error(L, entry, "registers: too many (at most %d in all); raise `board.registers` in rom.lua",
                      (int)rows->s.cap);
        store_display(L, kind, i, &regs[i]);
        lua_pushinteger(L, i);
        lua_setfield(L, -2, regs[i].name);
    }
    lua_rawseti(L, -2, kind);
    lua_pop(L, 1);
}

/* Numbers the registers in byte order of their names, so that the numbers do not depend on the iteration order of the
 * table. */
int api_registers_define(lua_State *L, const char *entry, int32_t kind, int at)
{
    const char *names[PLAYER_MAX_REGISTERS];
    struct register_declaration regs[PLAYER_MAX_REGISTERS];
    const int top = lua_gettop(L),
              n = api_read_sorted_keys(L, entry, "registers", "{ NAME = n, .. }", at, names, PLAYER_MAX_REGISTERS);

    for (int i = 0; i < n; i++) {
        lua_getfield(L, at, names[i]);
        regs[i] = read_register(L, entry, kind, names[i]);
        lua_settop(L, top);
    }
    add_register_rows(L, entry, kind, regs, n);
    return n;
}

int api_find_ship_register(lua_State *L, int32_t kind, const char *name)
{
    int i = -1, top = lua_gettop(L);

    vm_push_registry_table(L, &names_key);
    if (lua_rawgeti(L, -1, kind) == LUA_TTABLE && lua_getfield(L, -1, name) == LUA_TNUMBER)
        i = (int)lua_tointeger(L, -1);
    lua_settop(L, top);
    return i;
}

int api_find_player_register(lua_State *L, const struct board *b, uint32_t slot, const char *name)
{
    return slot < MAX_PLAYERS ? api_find_ship_register(L, b->player.kind[slot], name) : -1;
}

int api_find_run_register(lua_State *L, const char *name)
{
    return api_find_ship_register(L, RUN_REGISTERS, name);
}

bool api_register_is_declared(lua_State *L, const char *name)
{
    const uint32_t kinds = vm_board(L)->player_kinds.s.live;
    bool found = api_find_run_register(L, name) >= 0;

    for (uint32_t kind = 0; !found && kind < kinds; kind++)
        found = api_find_ship_register(L, (int32_t)kind, name) >= 0;
    return found;
}

static void suggest_register(lua_State *L, int32_t kind, struct api_suggestion *s)
{
    const char *names[PLAYER_MAX_REGISTERS];

    for (int n = api_player_register_names(L, kind, names), i = 0; i < n; i++)
        api_consider(s, names[i]);
}

const char *api_find_nearest_register(lua_State *L, const char *name)
{
    struct api_suggestion s = { .word = name };

    suggest_register(L, RUN_REGISTERS, &s);
    for (uint32_t kind = 0; kind < vm_board(L)->player_kinds.s.live; kind++)
        suggest_register(L, (int32_t)kind, &s);
    return s.nearest;
}

int api_register_expect(lua_State *L, const char *entry, const char *param_name, int32_t kind, const char *name)
{
    const int i = api_find_ship_register(L, kind, name);
    struct api_suggestion s = { .word = name };

    if (i >= 0)
        return i;
    suggest_register(L, kind, &s);
    if (s.nearest)
        return api_error(L, entry, "%s: unknown register \"%s\" (did you mean \"%s\"?)", param_name, name, s.nearest);
    return api_error(L, entry, "%s: unknown register \"%s\" (add registers = { %s = 0 } to player.def)", param_name,
                     name, name);
}

int api_player_register_names(lua_State *L, int32_t kind, const char *names[PLAYER_MAX_REGISTERS])
{
    int top = lua_gettop(L), n = 0;

    vm_push_registry_table(L, &names_key);
    if (lua_rawgeti(L, -1, kind) == LUA_TTABLE)
        for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1), n++)
            names[lua_tointeger(L, -1)] = lua_tostring(L, -2); /* the table keeps the string alive */
    lua_settop(L, top);
    return n;
}

int64_t api_read_register_value(lua_State *L, const char *entry, const char *name, uint32_t row, int at)
{
    const double min_value = registers_rule(&vm_board(L)->registers, row).min_value;
    const struct api_param p = PARAM(name, A_INT, REQ, min_value, INT32_MAX, NULL, NULL, NULL);
    struct api_value v = { 0 };
    int is_integer = 0;

    if (lua_type(L, at) == LUA_TNUMBER) {
        v.i = lua_tointegerx(L, at, &is_integer);
        if (is_integer && v.i <= INT32_MAX)
            return v.i;
    }
    api_check(L, entry, &p, at, &v);
    return v.i;
}
