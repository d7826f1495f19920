/*
 * api_register.c - the rules and names of registers, of ships (player.def) and of the run (game.def).
 */
#include <stdio.h>
#include <string.h>
#include "../../base/edit.h"
#include "api_parts.h"

/* Registry, by kind of ship or RUN_REGISTERS: { name -> number }; and { number -> { show, at, label, mark } }, for
 * registers that declare how they are shown. */
static const char names_key = 0, shows_key = 0;

static const char *const shows[] = { "none", "number", "icons", "bar", "times", NULL }, *const places[] = { "top",
                                                                                                            "low",
                                                                                                            NULL };

enum { S_START, S_MIN, S_MAX, S_DRAIN, S_EVERY, S_HOLD, S_SHOW, S_AT, S_LABEL, S_MARK };

const struct api_param api_register_settings[REGISTER_SETTINGS] = {
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
    PARAM("show", A_STR, OPT, 0, 0, NULL, NULL,
          "how the HUD shows the register: none, number, icons, bar or times; a bar needs `max`"),
    PARAM("at", A_STR, OPT, 0, 0, NULL, NULL,
          "where the HUD shows the register: top, or low (at the lower edge of the field)"),
    PARAM("label", A_STR, OPT, 0, 31, NULL, NULL, "word shown before the register; defaults to its name"),
    PARAM("mark", A_INT, OPT, -INT32_MAX, INT32_MAX, NULL, NULL,
          "lowest value at which the HUD shows the register in the bright colour"),
};

struct reg {
    const char *name, *show, *place, *label; /* NULL: not given; the declared table keeps the strings alive */
    bool marked;
    int32_t mark;
    struct register_rule rule;
};

/* Pushes the registry table under that key, creating it on first use. */
static void registry(lua_State *L, const void *key)
{
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, key) == LUA_TTABLE)
        return;
    lua_pop(L, 1);
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_rawsetp(L, LUA_REGISTRYINDEX, key);
}

/* Returns the element of `words` that setting v[which] equals; NULL if the setting is not given. */
static const char *read_word(lua_State *L, const char *entry, const char *name, const struct api_value *v, int which,
                             const char *const *words, const char *expected)
{
    if (!v[which].given)
        return NULL;
    for (int i = 0; words[i]; i++)
        if (!strcmp(words[i], lua_tostring(L, v[which].at)))
            return words[i];
    api_error(L, entry, "%s.%s: expected %s, got \"%s\"", name, api_register_settings[which].name, expected,
              lua_tostring(L, v[which].at));
    return NULL;
}

/* Returns the integer in v, or `otherwise` if v is not given. */
static int32_t setting(const struct api_value *v, int32_t otherwise)
{
    if (!v->given)
        return otherwise;
    return v->i == LUA_MAXINTEGER ? DRAIN_FOREVER : (int32_t)v->i;
}

static void check_rule(lua_State *L, const char *entry, const char *name, const struct reg *r)
{
    const struct register_rule *rule = &r->rule;

    if (rule->least > rule->most)
        api_error(L, entry, "%s: min %d is greater than max %d", name, (int)rule->least, (int)rule->most);
    if (rule->start > rule->most)
        api_error(L, entry, "%s: start %d is greater than max %d", name, (int)rule->start, (int)rule->most);
    if (rule->start < rule->least)
        api_error(L, entry, "%s: start %d is less than min %d", name, (int)rule->start, (int)rule->least);
    if (rule->most == REGISTER_MOST && r->show && !strcmp(r->show, "bar"))
        api_error(L, entry, "%s: `show = \"bar\"` requires `max`", name);
    if (!rule->drain && rule->hold)
        api_error(L, entry, "%s: `hold` requires `drain` (a number or forever)", name);
}

/* Reads the rule { start = 3, max = 6, show = "icons" } at `at`. */
static void read_rule(lua_State *L, const char *entry, const char *name, int at, struct reg *r)
{
    static const struct api_fields fields = { api_register_settings, REGISTER_SETTINGS, NAME_LISTS };
    struct register_rule *rule = &r->rule;
    struct api_value v[REGISTER_SETTINGS];

    api_read_fields(L, entry, name, &fields, at, v);
    rule->least = setting(&v[S_MIN], 0);
    rule->most = setting(&v[S_MAX], REGISTER_MOST);
    rule->start = setting(&v[S_START], rule->least > 0 ? rule->least : 0);
    rule->drain = setting(&v[S_DRAIN], 0);
    rule->every = setting(&v[S_EVERY], 1);
    rule->hold = setting(&v[S_HOLD], 0);
    r->show = read_word(L, entry, name, v, S_SHOW, shows, "none, number, icons, bar or times");
    r->place = read_word(L, entry, name, v, S_AT, places, "top or low");
    r->label = v[S_LABEL].given ? lua_tostring(L, v[S_LABEL].at) : NULL;
    r->marked = v[S_MARK].given;
    r->mark = setting(&v[S_MARK], 0);
    check_rule(L, entry, name, r);
}

/* Raises an error if the name is already used by players or by the table game. */
static void check_name(lua_State *L, const char *entry, int32_t kind, const char *name)
{
    static const char *const of_run[] = { "def", "stage", "mode", "continues", "frames", NULL };

    if (kind == RUN_REGISTERS) {
        for (int i = 0; of_run[i]; i++)
            if (!strcmp(of_run[i], name))
                api_error(L, entry, "registers: game.%s already exists", name);
        return;
    }
    if (api_property(api_of(L)->things[H_PLAYER], name) || !strcmp(name, "alive"))
        api_error(L, entry, "registers: \"%s\" is already a property of players", name);
    if (api_push_method(L, H_PLAYER, name))
        api_error(L, entry, "registers: \"%s\" is already a method of players", name);
    lua_pop(L, 1);
}

/* Reads the register named `of`, whose declared value is on top of the stack. */
static struct reg read_register(lua_State *L, const char *entry, int32_t kind, const char *of)
{
    struct reg r = { .name = of, .rule = { .most = REGISTER_MOST, .every = 1 } };
    struct api_value v = { 0 };
    char name[64];

    check_name(L, entry, kind, r.name);
    snprintf(name, sizeof name, "registers.%s", r.name);
    if (lua_istable(L, -1)) {
        read_rule(L, entry, name, lua_gettop(L), &r);
        return r;
    }
    const struct api_param whole = { name, A_INT, REQ, 0, INT32_MAX, NULL, NULL, NULL };
    api_check(L, entry, &whole, lua_gettop(L), &v);
    r.rule.start = (int32_t)v.i;
    return r;
}

static void set_word(lua_State *L, const char *field, const char *word)
{
    if (!word)
        return;
    lua_pushstring(L, word);
    lua_setfield(L, -2, field);
}

/* Stores how register i is shown. Creates the table on first use. */
static void keep_show(lua_State *L, int32_t kind, int i, const struct reg *r)
{
    int top = lua_gettop(L);

    if (!r->show)
        return;
    registry(L, &shows_key);
    if (lua_rawgeti(L, -1, kind) != LUA_TTABLE) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_rawseti(L, -3, kind);
    }
    lua_newtable(L);
    set_word(L, "show", r->show);
    set_word(L, "at", r->place);
    set_word(L, "label", r->label);
    if (r->marked) {
        lua_pushinteger(L, r->mark);
        lua_setfield(L, -2, "mark");
    }
    lua_rawseti(L, -2, i);
    lua_settop(L, top);
}

void api_register_show(lua_State *L, int32_t kind, int i)
{
    static const char *const fields[] = { "show", "at", "label", "mark" };
    int top = lua_gettop(L);

    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &shows_key) == LUA_TTABLE && lua_rawgeti(L, -1, kind) == LUA_TTABLE &&
        lua_rawgeti(L, -1, i) == LUA_TTABLE)
        for (int k = 0; k < 4; k++) {
            lua_getfield(L, -1, fields[k]);
            lua_setfield(L, top, fields[k]);
        }
    lua_settop(L, top);
}

static void add_rows(lua_State *L, const char *entry, int32_t kind, const struct reg *regs, int n)
{
    struct registers *rows = &vm_board(L)->registers;

    registry(L, &names_key);
    lua_createtable(L, 0, n);
    for (int i = 0; i < n; i++) {
        if (registers_add(rows, &regs[i].rule) == NO_SLOT)
            api_error(L, entry, "registers: too many (at most %d in all); raise `board.registers` in rom.lua",
                      (int)rows->s.cap);
        keep_show(L, kind, i, &regs[i]);
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
    const char *names[PLAYER_REGISTERS];
    struct reg regs[PLAYER_REGISTERS];
    const int top = lua_gettop(L),
              n = api_sorted_names(L, entry, "registers", "{ NAME = n, .. }", at, names, PLAYER_REGISTERS);

    for (int i = 0; i < n; i++) {
        lua_getfield(L, at, names[i]);
        regs[i] = read_register(L, entry, kind, names[i]);
        lua_settop(L, top);
    }
    add_rows(L, entry, kind, regs, n);
    return n;
}

int api_ship_register(lua_State *L, int32_t kind, const char *name)
{
    int i = -1, top = lua_gettop(L);

    registry(L, &names_key);
    if (lua_rawgeti(L, -1, kind) == LUA_TTABLE && lua_getfield(L, -1, name) == LUA_TNUMBER)
        i = (int)lua_tointeger(L, -1);
    lua_settop(L, top);
    return i;
}

int api_player_register(lua_State *L, const struct board *b, uint32_t slot, const char *name)
{
    return slot < PADS ? api_ship_register(L, b->player.kind[slot], name) : -1;
}

int api_run_register(lua_State *L, const char *name)
{
    return api_ship_register(L, RUN_REGISTERS, name);
}

bool api_register_declared(lua_State *L, const char *name)
{
    const uint32_t kinds = vm_board(L)->player_kinds.s.live;
    bool found = api_run_register(L, name) >= 0;

    for (uint32_t kind = 0; !found && kind < kinds; kind++)
        found = api_ship_register(L, (int32_t)kind, name) >= 0;
    return found;
}

static void suggest(lua_State *L, int32_t kind, const char *name, int *best, const char **found)
{
    const char *names[PLAYER_REGISTERS];

    for (int n = api_player_registers(L, kind, names), i = 0; i < n; i++)
        api_suggest_nearer(name, names[i], best, found);
}

const char *api_register_near(lua_State *L, const char *name)
{
    const char *found = NULL;
    int best = EDIT_FAR;

    suggest(L, RUN_REGISTERS, name, &best, &found);
    for (uint32_t kind = 0; kind < vm_board(L)->player_kinds.s.live; kind++)
        suggest(L, (int32_t)kind, name, &best, &found);
    return found;
}

int api_register_expect(lua_State *L, const char *entry, const char *what, int32_t kind, const char *name)
{
    const int i = api_ship_register(L, kind, name);
    const char *found = NULL;
    int best = EDIT_FAR;

    if (i >= 0)
        return i;
    suggest(L, kind, name, &best, &found);
    if (found)
        return api_error(L, entry, "%s: unknown register \"%s\" (did you mean \"%s\"?)", what, name, found);
    return api_error(L, entry, "%s: unknown register \"%s\" (add registers = { %s = 0 } to player.def)", what, name,
                     name);
}

int api_player_registers(lua_State *L, int32_t kind, const char *names[PLAYER_REGISTERS])
{
    int top = lua_gettop(L), n = 0;

    registry(L, &names_key);
    if (lua_rawgeti(L, -1, kind) == LUA_TTABLE)
        for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1), n++)
            names[lua_tointeger(L, -1)] = lua_tostring(L, -2); /* the table keeps the string alive */
    lua_settop(L, top);
    return n;
}

int64_t api_register_value(lua_State *L, const char *of, const char *name, uint32_t row, int at)
{
    const double least = registers_rule(&vm_board(L)->registers, row).least;
    const struct api_param p = { name, A_INT, REQ, least, INT32_MAX, NULL, NULL, NULL };
    struct api_value v = { 0 };
    int whole = 0;

    if (lua_type(L, at) == LUA_TNUMBER) {
        v.i = lua_tointegerx(L, at, &whole);
        if (whole && v.i <= INT32_MAX)
            return v.i;
    }
    api_check(L, of, &p, at, &v);
    return v.i;
}
