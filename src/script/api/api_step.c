/*
 * api_step.c - motion steps with a table of settings: emit, wait_for, path.
 */
#include <stdio.h>
#include <string.h>
#include "api_parts.h"

static const char def_entry[] = "motion.def";

enum {
    E_PATTERN,
    E_N,
    E_SPREAD,
    E_SWEEP,
    E_SPEED_TO,
    E_WIDTH,
    E_SKIP,
    E_FIRE,
    E_KIND,
    E_SPEED,
    E_DIR,
    E_AIM,
    E_BANK,
    E_TAG,
    E_MOTION,
    E_DELAY,
    E_AROUND,
    E_VX,
    E_VY
};

const struct api_param api_emit_params[EMIT_PARAM_COUNT] = {
    DEFAULT("pattern", A_EMIT_PATTERN, "one",
            "arrangement of the bullets, as in pattern.NAME; \"one\" fires a single bullet"),
    PARAM("n", A_INT, OPT, 0, 65535, "bullets", NULL,
          "number of bullets to fire; required unless `pattern` is \"one\""),
    PARAM("spread", A_NUM, OPT, -32767, 32767, "degrees", NULL, "angle between the first and the last bullet of a fan"),
    PARAM("sweep", A_NUM, OPT, -32767, 32767, "degrees", NULL,
          "angle from the first to the last bullet of an arc, clockwise"),
    SPEED("speed_to", A_NUM, OPT, "speed of the last bullet of a stack"),
    COORDINATE("width", A_NUM, OPT, "distance between the first and the last bullet of a line"),
    PARAM("skip", A_SPAN, OPT, -65535, 65535, NULL, NULL, "range of bullets to skip; the first bullet is number 1"),
    DEFAULT("fire", A_EMIT_FIRE, "bullet", "what to fire; shots belong to the owner of the shot that fires them"),
    REQUIRED("kind", A_BULLET_KIND, "declared kind to fire"),
    SPEED("speed", A_FX, UNLESS_VXY, "speed of flight; if negative, it flies backwards"),
    OPTIONAL("dir", A_DIR,
             "direction of flight, clockwise from the right; defaults to the direction of the bullet that fires; with "
             "`aim`, the default is 0, and the angle is added to the direction towards the target"),
    DEFAULT("aim", A_BOOL, "false", "fire at the nearest target"),
    BANK(OPT, NULL, "number added to the palette bank of the sprite; overrides the kind's"),
    LABEL("tag", OPT, "name of a group to put the bullets in"),
    OPTIONAL("motion", A_MOTION, "motion program that steers the bullets"),
    PARAM("delay", A_INT, OPT, 0, 1e9, "frames", "0", "frames the bullets wait in place before they fly"),
    THING("around", OPT, POSITION_HANDLE_KINDS, "thing that the bullets circle in the `orbit` steps of their motion"),
    VXY_PARAMS,
};

/* The name of each pattern, and the argument that gives its size (-1: it has none). */
static const struct {
    const char *name;
    int size_param;
} patterns[EMIT_PATTERNS] = {
    [EMIT_ONE] = { "one", -1 },      [EMIT_RING] = { "ring", -1 },           [EMIT_FAN] = { "fan", E_SPREAD },
    [EMIT_ARC] = { "arc", E_SWEEP }, [EMIT_STACK] = { "stack", E_SPEED_TO }, [EMIT_LINE] = { "line", E_WIDTH },
};

/* The number of an emit that each argument sets, plus 1, if the name of a declared value may replace the number;
 * otherwise 0. */
static const uint8_t emit_numbers[EMIT_PARAM_COUNT] = {
    [E_N] = EMIT_NUMBER_N + 1,           [E_SPREAD] = EMIT_NUMBER_SIZE + 1, [E_SWEEP] = EMIT_NUMBER_SIZE + 1,
    [E_SPEED_TO] = EMIT_NUMBER_SIZE + 1, [E_WIDTH] = EMIT_NUMBER_SIZE + 1,  [E_SPEED] = EMIT_NUMBER_SPEED + 1,
    [E_DIR] = EMIT_NUMBER_DIR + 1,       [E_BANK] = EMIT_NUMBER_BANK + 1,   [E_DELAY] = EMIT_NUMBER_DELAY + 1,
};

/* An emit being read. From stack index `first`: its arguments, then the values declared for what it fires. */
struct emit_reader {
    int step, first_at;
    bool fires_shots;
    enum name_kind value_kind;
    struct api_value v[EMIT_PARAM_COUNT + MAX_VALUES];
    uint64_t named_bits;
};

/* Raises the error for the unknown key on top of the stack. */
static void raise_unknown_key(lua_State *L, const struct emit_reader *r, const struct api_fields *fields)
{
    static const char *const place_names[] = { "x", "y", "from", "dx", "dy" };
    const char *key = luakeys_text(L, -1);
    char context[48];

    for (size_t i = 0; key && i < sizeof place_names / sizeof *place_names; i++)
        if (!strcmp(key, place_names[i]))
            api_error(L, def_entry, "step %d: emit: `%s` is not allowed (`emit` fires from the bullet's position)",
                      r->step, key);
    if (key && !strcmp(key, "each"))
        api_error(L, def_entry, "step %d: emit: `each` is not allowed (a motion runs without Lua; use `motion`)",
                  r->step);
    snprintf(context, sizeof context, "%s: step %d: emit", def_entry, r->step);
    api_raise_unknown_key(L, context, fields);
}

/* Spreads the arguments and values of the table at `at` over the stack. */
static void push_settings(lua_State *L, struct emit_reader *r, int at)
{
    const struct api_fields fields = { api_emit_params, EMIT_PARAM_COUNT, r->value_kind };

    luaL_checkstack(L, EMIT_PARAM_COUNT + MAX_VALUES + 16, NULL);
    if (luakeys_push_unknown(L, at, api_is_known_field, &fields))
        raise_unknown_key(L, r, &fields);
    r->first_at = lua_gettop(L) + 1;
    for (int k = 0; k < EMIT_PARAM_COUNT; k++)
        lua_getfield(L, at, api_emit_params[k].name);
    for (int k = 0; k < api_value_count(vm_board(L), r->value_kind); k++)
        lua_getfield(L, at, board_name(vm_board(L), r->value_kind, k));
}

/* Checks argument k against its parameter, or reads the name of a declared value given in place of the number `number`
 * (-1: none). */
static void check_setting(lua_State *L, struct emit_reader *r, int k, const struct api_param *p, int number)
{
    const int at = r->first_at + k;
    char context[48];

    r->v[k] = (struct api_value){ 0 };
    if (number >= 0 && lua_type(L, at) == LUA_TSTRING) {
        r->named_bits |= api_find_step_value(L, r->step, p->name, at) << number * NAMED_VALUE_BITS;
        r->v[k].given = true;
        return;
    }
    snprintf(context, sizeof context, "%s: step %d: emit", def_entry, r->step);
    api_check(L, context, p, at, &r->v[k]);
}

/* Resolves `vx` and `vy`, or raises an error if the required `speed` is not given either. */
static void resolve_velocity(lua_State *L, struct emit_reader *r)
{
    struct api_value *v = r->v;
    char context[48];

    snprintf(context, sizeof context, "%s: step %d: emit", def_entry, r->step);
    if (api_resolve_velocity(L, context,
                             (struct api_velocity){ &v[E_SPEED], &v[E_DIR], &v[E_AIM], &v[E_VX], &v[E_VY] }))
        return;
    if (!v[E_SPEED].given)
        api_check_value(L, context, &api_emit_params[E_SPEED], &v[E_SPEED]);
}

static void check_settings(lua_State *L, struct emit_reader *r)
{
    for (int k = 0; k < EMIT_PARAM_COUNT; k++) {
        struct api_param p = api_emit_params[k];
        if (k == E_KIND && r->fires_shots)
            p.type = A_SHOT_KIND;
        check_setting(L, r, k, &p, emit_numbers[k] - 1);
    }
    resolve_velocity(L, r);
    for (int k = 0; k < api_value_count(vm_board(L), r->value_kind); k++) {
        struct api_param p = api_value_param(board_name(vm_board(L), r->value_kind, k));
        p.optional = OPT;
        check_setting(L, r, EMIT_PARAM_COUNT + k, &p, EMIT_NUMBER_VALUE + k);
    }
}

/* Raises an error if the settings do not belong to the pattern, or are incomplete. */
static void check_pattern(lua_State *L, const struct emit_reader *r, int pattern)
{
    const char *name = patterns[pattern].name;

    for (int k = E_SPREAD; k <= E_WIDTH; k++) {
        if (r->v[k].given && k != patterns[pattern].size_param)
            api_error(L, def_entry, "step %d: emit: `%s` does not apply to pattern \"%s\"", r->step,
                      api_emit_params[k].name, name);
        if (!r->v[k].given && k == patterns[pattern].size_param)
            api_error(L, def_entry, "step %d: emit: pattern \"%s\" requires `%s`", r->step, name,
                      api_emit_params[k].name);
    }
    if (pattern == EMIT_ONE && r->v[E_N].given)
        api_error(L, def_entry, "step %d: emit: `n` does not apply to pattern \"one\" (did you forget `pattern`?)",
                  r->step);
    if (pattern != EMIT_ONE && !r->v[E_N].given)
        api_error(L, def_entry, "step %d: emit: pattern \"%s\" requires `n`", r->step, name);
    if (r->fires_shots && r->v[E_DELAY].given)
        api_error(L, def_entry, "step %d: emit: `delay` does not apply to shots", r->step);
}

static void read_skip(lua_State *L, const struct api_value *v, struct motion_emit *e)
{
    if (!v->given)
        return;
    lua_rawgeti(L, v->at, 1);
    lua_rawgeti(L, v->at, 2);
    e->first = (int32_t)lua_tointeger(L, -2);
    e->skip_last = (int32_t)lua_tointeger(L, -1);
    lua_pop(L, 2);
}

static void fill_emit(lua_State *L, const struct emit_reader *r, struct motion_emit *e)
{
    const struct api_value *v = r->v;
    const int pattern = (int)v[E_PATTERN].i, size = patterns[pattern].size_param;

    *e = (struct motion_emit){ .pattern = (uint8_t)pattern,
                               .flags = (uint8_t)((r->fires_shots ? EMIT_SHOTS : 0) | (v[E_AIM].i ? EMIT_AIM : 0) |
                                                  (v[E_DIR].given ? EMIT_DIR : 0) | (v[E_BANK].given ? EMIT_BANK : 0)),
                               .bank = (uint8_t)v[E_BANK].i,
                               .kind = (uint16_t)v[E_KIND].i,
                               .motion = v[E_MOTION].given ? (uint16_t)v[E_MOTION].i : 0,
                               .n = pattern == EMIT_ONE ? 1 : (uint16_t)v[E_N].i,
                               .delay = (uint32_t)v[E_DELAY].i,
                               .dir = v[E_DIR].n,
                               .speed = v[E_SPEED].n,
                               .size = size < 0 ? 0 : v[size].n,
                               .orbit_target = v[E_AROUND].given ? v[E_AROUND].i : 0,
                               .named_values = r->named_bits };
    if (v[E_TAG].given)
        e->tag = api_intern_tag(L, def_entry, v[E_TAG].at);
    read_skip(L, &v[E_SKIP], e);
    for (int k = 0; k < api_value_count(vm_board(L), r->value_kind); k++) {
        if (v[EMIT_PARAM_COUNT + k].given)
            e->flags |= (uint8_t)(EMIT_VALUE << k);
        e->value[k] = v[EMIT_PARAM_COUNT + k].f;
    }
}

void api_read_emit_step(lua_State *L, int step, int at, struct motion_emit *e)
{
    struct emit_reader r = { .step = step };
    const struct board *b = vm_board(L);
    const int top = lua_gettop(L);

    r.fires_shots = lua_getfield(L, at, "fire") == LUA_TSTRING && !strcmp(lua_tostring(L, -1), "shot");
    r.value_kind = r.fires_shots ? N_SHOT_VALUE : N_BULLET_VALUE;
    push_settings(L, &r, at);
    check_settings(L, &r);
    check_pattern(L, &r, (int)r.v[E_PATTERN].i);
    api_check_around(L, r.fires_shots ? &b->shots : &b->bullets, def_entry, &r.v[E_AROUND]);
    fill_emit(L, &r, e);
    lua_settop(L, top);
}

/* ---- wait_for ---- */

enum { W_X, W_Y, W_NEAR, W_TAG, W_LIMIT };

const struct api_param api_await_params[AWAIT_PARAM_COUNT] = {
    COORDINATE("x", A_FX, OPT, "the motion continues once the bullet reaches or crosses this vertical line"),
    COORDINATE("y", A_FX, OPT, "the motion continues once the bullet reaches or crosses this horizontal line"),
    PARAM("near", A_FX, OPT, 0, WORLD_EDGE, "px", NULL, "the motion continues once a target is nearer than this"),
    LABEL("tag", OPT, "the motion continues when group:signal() is called for this tag"),
    PARAM("limit", A_COUNT, OPT, 1, 1e9, "frames", "forever", "frames after which the motion continues anyway"),
};

static uint64_t read_await(lua_State *L, int step, int at, struct api_value v[AWAIT_PARAM_COUNT])
{
    static const struct api_fields fields = { api_await_params, AWAIT_PARAM_COUNT, NAME_LISTS };
    static const uint8_t numbers[AWAIT_PARAM_COUNT] = {
        [W_X] = NUMBER_X + 1, [W_Y] = NUMBER_Y + 1, [W_NEAR] = NUMBER_SIZE + 1, [W_LIMIT] = NUMBER_DURATION + 1
    };
    char context[48];

    snprintf(context, sizeof context, "%s: step %d: wait_for", def_entry, step);
    if (luakeys_push_unknown(L, at, api_is_known_field, &fields))
        api_raise_unknown_key(L, context, &fields);
    return api_read_step_keys(L, step, context, api_await_params, AWAIT_PARAM_COUNT, numbers, at, v);
}

void api_read_await_step(lua_State *L, int step, int at, struct motion_step *s)
{
    struct api_value v[AWAIT_PARAM_COUNT];
    const int top = lua_gettop(L);
    const uint64_t named_values = read_await(L, step, at, v);
    int n = 0;

    for (int k = W_X; k <= W_TAG; k++)
        n += v[k].given;
    if (n != 1)
        api_error(L, def_entry, "step %d: wait_for: expected one of `x`, `y`, `near` and `tag`, got %d", step, n);
    *s = (struct motion_step){ .actions = DOES_AWAIT | (named_values ? DOES_USE_VALUES : 0u),
                               .duration = UINT32_MAX,
                               .mode = (uint8_t)(v[W_X].given      ? MODE_X
                                                 : v[W_Y].given    ? MODE_Y
                                                 : v[W_NEAR].given ? MODE_TARGET_NEAR
                                                                   : MODE_SIGNAL),
                               .x = v[W_X].f,
                               .y = v[W_Y].f,
                               .size = v[W_NEAR].f,
                               .named_values = named_values };
    if (v[W_TAG].given)
        s->count = api_intern_tag(L, def_entry, v[W_TAG].at);
    if (v[W_LIMIT].given && v[W_LIMIT].i != LUA_MAXINTEGER)
        s->duration = (uint32_t)v[W_LIMIT].i;
    lua_settop(L, top);
}

/* ---- path ---- */

/* Pops the point on top of the stack and returns the point's position, rounded like that of an enemy on the route.
 * place_at is the stack index of path.place. */
static void pop_position(lua_State *L, int step, int place_at, bool mirror, fx *x, fx *y)
{
    lua_pushvalue(L, place_at);
    lua_insert(L, -2);
    lua_pushboolean(L, mirror);
    lua_pushinteger(L, 0);
    lua_pushinteger(L, 0);
    lua_call(L, 4, 2);
    if (!fx_from_double(lua_tonumber(L, -2), x) || !fx_from_double(lua_tonumber(L, -1), y))
        api_error(L, def_entry, "step %d: path: the route leaves the world", step);
    lua_pop(L, 2);
}

/* Pops the point on top of the stack and fills `leg` with the leg to it. Returns false if the leg takes no time. */
static bool read_leg(lua_State *L, int step, int place_at, struct api_route_reader *reader, struct motion_step *leg)
{
    static const struct api_param ease_param = OPTIONAL("ease", A_EASE, NULL);
    const int point = lua_gettop(L);
    struct api_value v = { 0 };
    fx x = reader->x, y = reader->y;

    leg->actions |= DOES_GO_TO;
    leg->mode = MODE_RELATIVE;
    if (lua_getfield(L, point, "wait") != LUA_TNIL)
        leg->duration = (uint32_t)lua_tointeger(L, -1);
    else {
        lua_getfield(L, point, "over");
        leg->duration = (uint32_t)lua_tointeger(L, -1);
        lua_getfield(L, point, "ease");
        api_check(L, def_entry, &ease_param, lua_gettop(L), &v);
        leg->mode |= (uint8_t)v.i;
        lua_pushvalue(L, point);
        pop_position(L, step, place_at, reader->is_mirrored, &x, &y);
    }
    leg->x = x - reader->x;
    leg->y = y - reader->y;
    reader->x = x;
    reader->y = y;
    lua_settop(L, point - 1);
    return leg->duration > 0;
}

bool api_read_step_leg(lua_State *L, int step, struct api_route_reader *reader, struct motion_step *leg)
{
    const int top = lua_gettop(L);
    const uint32_t initial = leg->actions;
    char message[80];

    luaL_checkstack(L, 16, NULL);
    snprintf(message, sizeof message, "step %d: path: expected a route (from path.def)", step);
    api_push_path_module(L, def_entry, reader->route_at, message);
    lua_getfield(L, -1, "place");
    if (!reader->i) {
        lua_rawgeti(L, reader->route_at, reader->i = 1);
        pop_position(L, step, top + 2, reader->is_mirrored, &reader->x, &reader->y);
    }
    bool found = false;
    while (!found && lua_rawgeti(L, reader->route_at, ++reader->i) == LUA_TTABLE) {
        leg->actions = initial;
        found = read_leg(L, step, top + 2, reader, leg);
    }
    lua_settop(L, top);
    return found;
}
