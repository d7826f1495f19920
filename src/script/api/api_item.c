/*
 * api_item.c - the Lua table item.
 */
#include <string.h>
#include "../../base/trig.h"
#include "api_parts.h"

/* ---- item.def ---- */

enum { D_NAME, D_GIVES = 3, D_FULL };

static const struct api_param def_params[] = {
    REQUIRED("name", A_STR, "name of the kind, used as `kind = NAME`; must be new"),
    REQUIRED("sprite", A_SPRITE, "sprite to draw", STORED(item_kinds.sprite)),
    LENGTH("radius", REQ, NULL, "radius of the circle that a ship's hitbox must touch to take the item",
           STORED(item_kinds.radius)),
    [D_GIVES] = OPTIONAL("gives", A_TABLE,
                         "amounts that the player gets for taking the item, { score = n, lives = n, REGISTER = n }"),
    LABEL("full", OPT,
          "register of the ship or the run; while the register is at its max, the item gives only its score"),
    PARAM("gravity", A_FX, OPT, 0, MAX_SPEED, "px/frame", "0.04",
          "downward acceleration, the speed added in each frame", STORED(item_kinds.gravity)),
    PARAM("top", A_FX, OPT, 0, MAX_SPEED, "px/frame", "2", "maximum falling speed", STORED(item_kinds.max_fall_speed)),
    DEFAULT("magnet", A_BOOL, "true",
            "whether it flies to ships that attract it; if false, only item:pull makes it fly",
            BITS_OF(item_kinds.flags, ITEM_MAGNET)),
    BANK(OPT, "0", "number added to the palette bank of its sprite", STORED(item_kinds.bank)),
    BLEND_PARAM(item_kinds.flags, ITEM_BLEND),
    OPTIONAL("on_take", A_FUNC, "on_take(p, item): called after the player has received what the item gives",
             PROPERTY("item's on_take")),
};

static const char def_entry[] = "item.def";

/* Returns the number of a register in the list of registers that `gives` and `full` name; adds a new register to the
 * list. */
static int intern_register(lua_State *L, const char *name)
{
    int i = api_names_find(L, N_ITEM_REGISTER, name);

    if (i != NO_SLOT)
        return i;
    i = (int)vm_board(L)->names[N_ITEM_REGISTER].n;
    if (i == ITEM_MAX_REGISTERS)
        api_error(L, def_entry, "gives: too many registers (items can give at most %d different ones)",
                  ITEM_MAX_REGISTERS);
    api_names_declare(L, N_ITEM_REGISTER, def_entry, name, i);
    return i;
}

/* Reads the field `score` of `gives`: n, or { low, high }. */
static void read_score(lua_State *L, struct item_kinds *k, int32_t i, int gives_at)
{
    static const struct api_param score_span = PARAM("gives.score", A_SPAN, REQ, 0, ITEM_MAX_POINTS, NULL, NULL, NULL);
    struct api_value v;

    if (lua_getfield(L, gives_at, "score") == LUA_TTABLE) {
        int at = lua_gettop(L);
        api_check(L, def_entry, &score_span, at, &v);
        lua_rawgeti(L, at, 1);
        lua_rawgeti(L, at, 2);
        k->low_points[i] = lua_tointeger(L, -2);
        k->high_points[i] = lua_tointeger(L, -1);
        lua_settop(L, at - 1);
        return;
    }
    lua_pop(L, 1);
    k->low_points[i] = k->high_points[i] =
        api_read_named_number(L, def_entry, "gives", gives_at, "score", 0, ITEM_MAX_POINTS);
}

static void read_gives(lua_State *L, struct item_kinds *k, int32_t i, int gives_at)
{
    const char *names[MAX_ITEM_NAMES];
    int n = api_read_sorted_keys(L, def_entry, "gives", ITEM_TABLE_FORM, gives_at, names, MAX_ITEM_NAMES);

    for (int j = 0; j < n; j++)
        if (!strcmp(names[j], "score"))
            read_score(L, k, i, gives_at);
        else if (!strcmp(names[j], "lives"))
            k->lives[i] = (int32_t)api_read_named_number(L, def_entry, "gives", gives_at, names[j], 0, MAX_LIVES);
        else
            k->register_amounts[i * ITEM_MAX_REGISTERS + intern_register(L, names[j])] =
                (int32_t)api_read_named_number(L, def_entry, "gives", gives_at, names[j], -INT32_MAX, INT32_MAX);
}

static int item_def(lua_State *L, struct board *b, struct api_value *v)
{
    struct item_kinds *k = &b->item_kinds;
    const int32_t i = api_append_kind(L, def_entry, &k->s, N_ITEM, v);

    if (v[D_GIVES].given)
        read_gives(L, k, i, v[D_GIVES].at);
    if (v[D_FULL].given)
        k->full_register[i] = (uint16_t)(intern_register(L, lua_tostring(L, v[D_FULL].at)) + 1);
    if (v[D_GIVES].given || v[D_FULL].given)
        api_record_location(L, def_entry, lua_tostring(L, v[D_NAME].at));
    return 0;
}

static bool has_max(const struct board *b, uint32_t row)
{
    return registers_rule(&b->registers, row).max_value != REGISTER_NO_MAX;
}

/* Returns whether any ship, or the run, has a register of that name with a max. */
static bool has_register_with_max(lua_State *L, const struct board *b, const char *name)
{
    const int run_register = api_find_run_register(L, name);

    for (uint32_t ship = 0; ship < b->player_kinds.s.live; ship++) {
        int reg = api_find_ship_register(L, (int32_t)ship, name);
        if (reg >= 0 && has_max(b, b->player_kinds.first_register[ship] + (uint32_t)reg))
            return true;
    }
    return run_register >= 0 && has_max(b, b->registers.first_run_row + (uint32_t)run_register);
}

/* Raises the error for the items' register r, which neither a ship nor the run has. */
static void raise_unknown_register(lua_State *L, const struct board *b, int r)
{
    const struct item_kinds *k = &b->item_kinds;
    const char *name = board_name(b, N_ITEM_REGISTER, r), *nearest = api_find_nearest_register(L, name);
    uint32_t i = 0;

    while (i + 1 < k->s.live && !k->register_amounts[i * ITEM_MAX_REGISTERS + (uint32_t)r] &&
           k->full_register[i] != r + 1)
        i++;
    const char *item = board_name(b, N_ITEM, (int)i);
    if (nearest)
        api_error_at(L, def_entry, item, "item \"%s\": unknown register \"%s\" (did you mean \"%s\"?)", item, name,
                     nearest);
    api_error_at(L, def_entry, item,
                 "item \"%s\": unknown register \"%s\" (add registers = { %s = 0 } to player.def or game.def)", item,
                 name, name);
}

void api_items_check(lua_State *L, struct board *b)
{
    for (int r = 0; r < (int)b->names[N_ITEM_REGISTER].n; r++)
        if (!api_register_is_declared(L, board_name(b, N_ITEM_REGISTER, r)))
            raise_unknown_register(L, b, r);
    for (uint32_t i = 0; i < b->item_kinds.s.live; i++) {
        const char *name = board_name(b, N_ITEM_REGISTER, (int)b->item_kinds.full_register[i] - 1);
        if (name && !has_register_with_max(L, b, name))
            api_error_at(
                L, def_entry, board_name(b, N_ITEM, (int)i),
                "full: register \"%s\" has no max (write registers = { %s = { max = n } } in player.def or game.def)",
                name, name);
    }
}

/* ---- item.drop ---- */

enum { P_KIND, P_POSITION, P_N = P_POSITION + POSITION_PARAM_COUNT, P_DIR, P_SPREAD, P_SPEED, P_TAG };

static const struct api_param drop_params[] = {
    REQUIRED("kind", A_ITEM_KIND, "declared kind to drop"),
    POSITION_PARAMS,
    PARAM("n", A_INT, OPT, 0, UINT16_MAX, "items", "1", "number of items"),
    DEFAULT("dir", A_DIR, "270", "middle of the range of directions, clockwise from the right"),
    PARAM("spread", A_NUM, OPT, 0, 360, "degrees", "60",
          "angle over which the items are evenly spread, centred on `dir`"),
    PARAM("speed", A_FX, OPT, -MAX_SPEED, MAX_SPEED, "px/frame", "1.5", "initial speed"),
    LABEL("tag", OPT, "name of a group to put the items in"),
};

static uint64_t spread_from_degrees(double degrees)
{
    ang a;

    if (degrees >= 360)
        return 1ull << 32;
    trig_from_degrees(degrees, &a);
    return a;
}

static int drop_items(lua_State *L, struct board *b, struct api_value *v)
{
    const uint16_t kind = (uint16_t)v[P_KIND].i, n = (uint16_t)v[P_N].i;
    struct item_drop d = { .dir = v[P_DIR].a, .spread = spread_from_degrees(v[P_SPREAD].n), .speed = v[P_SPEED].f };

    d.tag = api_read_tag(L, "item.drop", &v[P_TAG]);
    vm_charge(L, DROP_WORK * (uint64_t)n);
    if (api_read_position(L, b, "item.drop", v + P_POSITION, &d.x, &d.y))
        board_drop_items(b, &d, &kind, &n, 1);
    return 0;
}

/* ---- properties ---- */

/* The last property exists only for groups. */
static const struct api_param props[] = {
    COORDINATE("x", A_FX, REQ, "horizontal position in the field", STORED(items.x), WRITABLE),
    COORDINATE("y", A_FX, REQ, "vertical position in the field", STORED(items.y), WRITABLE),
    SPEED("vx", A_FX, REQ, "horizontal velocity", STORED(items.vx), WRITABLE),
    SPEED("vy", A_FX, REQ, "vertical velocity; positive is downwards", STORED(items.vy), WRITABLE),
    LABEL("tag", OPT, "tag of its group, or nil", STORED(items.tag), WRITABLE),
    PARAM("frozen", A_COUNT, REQ, 0, INT32_MAX, "frames", NULL, "frames it stays frozen, or forever; 0 unfreezes it",
          STORED(items.frozen_left), WRITABLE),
    REQUIRED("kind", A_ITEM_KIND, "name of its kind", STORED(items.kind)),
    REQUIRED("age", A_INT, "frames since it was dropped, not counting frozen frames", AGE_OF(items.born)),
    COUNT_PROP("items"),
};

enum { GROUP_PROP_COUNT = sizeof props / sizeof *props };
const struct api_thing api_item_thing = { "item", props, GROUP_PROP_COUNT - 1, POOL(items) };
const struct api_thing api_items_thing = { "items",          props,          GROUP_PROP_COUNT, POOL(items),
                                           .member = H_ITEM, .write_work = 1 };

/* ---- verbs ---- */

enum { ARG_SELF, PULL_PLAYER };

#define SELF_PARAM THING("self", REQ, 1 << H_ITEM | 1 << H_ITEMS, "the thing itself")
static const struct api_param pull_params[] = { SELF_PARAM, OPTIONAL("p", A_PLAYER,
                                                                     "player to fly to; defaults to the nearest one") };
static const struct api_param self_params[] = { SELF_PARAM };

/* Pulls an item to the given player or, if none is given, to the nearest. A player who is not in the game attracts
 * nothing. */
static int item_pull(lua_State *L, struct board *b, struct api_value *v)
{
    const uint32_t i = handle_slot(v[ARG_SELF].i);
    const struct targets t = board_targets(b, false);
    int32_t p =
        v[PULL_PLAYER].given ? (int32_t)v[PULL_PLAYER].i - 1 : targets_find_nearest(&t, b->items.x[i], b->items.y[i]);

    (void)L;
    if (p >= 0 && b->player.in_game[p])
        items_pull(&b->items, i, (uint32_t)p);
    return 0;
}

static int item_remove(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    slots_drop(&b->items.s, handle_slot(v[ARG_SELF].i));
    return 0;
}

#ifndef WITHOUT_HELP
static const struct api_param gives_params[] = {
    PARAM("score", A_ANY, OPT, 0, 0, "number or { low, high }", "0",
          "points; { low, high } gives `low` at the bottom of the field and `high` at or above the collect line"),
    PARAM("lives", A_INT, OPT, 0, MAX_LIVES, NULL, "0", "extra lives"),
};
#endif

static const struct api_entry entries[] = {
    { "item.def", item_def, PARAMS(def_params), 1, API_CHANGES | API_LOAD_ONLY, NULL,
      HELP("declares a kind of item: its sprite, how it falls and what it gives; needs `board = { items = n }`") },
    { "item.drop", drop_items, PARAMS(drop_params), 0, API_CHANGES, NULL,
      HELP("drops items from a position or a thing, in evenly spread directions") },
    API_GROUPS("item"),
    API_EACH_VERB("item:pull", item_pull, pull_params, 2,
                  "makes it fly to a player until it is taken; it falls again if that player dies"),
    API_EACH_VERB("item:remove", item_remove, self_params, 1, "removes it; no player gets anything"),
    API_EACH_VERB("items:pull", item_pull, pull_params, 2,
                  "makes each item fly to a player until it is taken; it falls again if that player dies"),
    API_EACH_VERB("items:remove", item_remove, self_params, 1, "removes each item; no player gets anything"),
#ifndef WITHOUT_HELP
    { "item.def gives", NULL, PARAMS(gives_params), 0, API_LUA | API_SYS, NULL,
      HELP("amounts that the player gets; any other key names a register of the ship or the run, to which the amount "
           "is added") },
#endif
};
const struct api_module api_item = { entries, sizeof entries / sizeof *entries };
