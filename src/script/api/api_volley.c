/*
 * api_volley.c - pattern.ring, fan, arc, stack and line as one call that fires all their bullets. It fires exactly
 * the same bullets as the loops in scripts/pattern.lua, in a tenth of the time. Only the loops handle `each`, lasers,
 * and arguments that are invalid for only some of the bullets. The digest folds a volley as one call, because its
 * arguments determine all of its bullets.
 */
#include <string.h>
#include "../../base/hash.h"
#include "../../base/trig.h"
#include "../../machine/emit.h"
#include "api_parts.h"

/* Indices of a pattern's own parameters: n, its size (except for a ring), then the rest. */
enum { OWN_N, OWN_SIZE, OWN_SKIP_FROM_END = 3 /* counted from the end */ };

static uint8_t find_pattern(const char *name)
{
    static const char *const names[] = {
        [EMIT_RING] = "ring", [EMIT_FAN] = "fan", [EMIT_ARC] = "arc", [EMIT_STACK] = "stack", [EMIT_LINE] = "line"
    };

    for (uint8_t i = EMIT_RING; i <= EMIT_LINE; i++)
        if (!strncmp(name, "pattern.", 8) && !strcmp(name + 8, names[i]))
            return i;
    return EMIT_ONE;
}

static bool is_within(double v, double limit)
{
    return v >= -limit && v <= limit;
}

/* Returns whether the loop in Lua must run instead. The loop also handles an argument that is not a table, to raise its
 * own error. */
static bool needs_lua_loop(lua_State *L)
{
    if (lua_gettop(L) != 1 || lua_type(L, 1) != LUA_TTABLE)
        return true;
    lua_pushliteral(L, "each");
    bool needs_loop = lua_rawget(L, 1) != LUA_TNIL;
    lua_pushliteral(L, "fire");
    if (lua_rawget(L, 1) != LUA_TNIL)
        needs_loop |= lua_type(L, -1) != LUA_TSTRING ||
                      (strcmp(lua_tostring(L, -1), "bullet") != 0 && strcmp(lua_tostring(L, -1), "shot") != 0);
    lua_settop(L, 1);
    return needs_loop;
}

static lua_Integer read_skip_bound(lua_State *L, const struct api_value *skip, int i)
{
    lua_rawgeti(L, skip->at, i);
    const lua_Integer n = lua_tointeger(L, -1);
    lua_pop(L, 1);
    return n;
}

/* Sets where a line starts and from where it is aimed. A bullet's offset is added to the unrounded part of the
 * position, then the sum is rounded. The line is aimed from its middle: from (x, y), ignoring dx and dy, or from the
 * thing's position plus (dx, dy); like settle in pattern.lua. */
static void set_line_position(struct board *b, struct volley *v, const struct api_value *place)
{
    if (place[POSITION_FROM].given) {
        board_get_position(b, place[POSITION_FROM].i, &v->x, &v->y);
        v->dx = place[POSITION_DX].n;
        v->dy = place[POSITION_DY].n;
        fx_from_double(fx_to_double(v->x) + v->dx, &v->aim_x);
        fx_from_double(fx_to_double(v->y) + v->dy, &v->aim_y);
    } else {
        v->x = place[POSITION_DX].f;
        v->y = place[POSITION_DY].f;
        v->dx = place[POSITION_X].n;
        v->dy = place[POSITION_Y].n;
        fx_from_double(v->dx, &v->aim_x);
        fx_from_double(v->dy, &v->aim_y);
    }
}

/* Returns whether bullet.fire would accept the arguments of the first and the last bullet. The arguments of every other
 * bullet lie between those two. */
static bool ends_are_valid(const struct volley *v)
{
    for (int end = 0; end < 2; end++) {
        struct volley_bullet w;
        ang a;
        emit_compute_bullet(v, end ? v->n - 1 : 0, &w);
        if (!trig_from_degrees(w.dir, &a) || !is_within(w.speed, MAX_SPEED) || !is_within(v->dx + w.dx, WORLD_EDGE) ||
            !is_within(v->dy + w.dy, WORLD_EDGE))
            return false;
    }
    return true;
}

/* Reads the pattern's own arguments, and those of bullet.fire that are numbers. */
static void read_volley(lua_State *L, const struct board *b, const struct api_entry *e,
                        const struct api_value *pattern_args, struct volley *v)
{
    const struct api_value *fire_args = pattern_args + e->count, *skip = pattern_args + e->count - OWN_SKIP_FROM_END;

    *v = (struct volley){ .pattern = find_pattern(e->name),
                          .is_aimed = fire_args[FIRE_AIM].i,
                          .fires_shots = skip[1].given && !strcmp(lua_tostring(L, skip[1].at), "shot"),
                          .n = (int32_t)pattern_args[OWN_N].i,
                          .skip_last = -1,
                          .dir = fire_args[FIRE_DIR].given || !fire_args[FIRE_AIM].i ? fire_args[FIRE_DIR].n : 0,
                          .speed = fire_args[FIRE_SPEED].n };
    if (v->pattern != EMIT_RING)
        v->size = pattern_args[OWN_SIZE].n;
    if (skip->given) {
        v->skip_first = read_skip_bound(L, skip, 1);
        v->skip_last = read_skip_bound(L, skip, 2);
    }
    for (int k = 0; k < api_value_count(b, v->fires_shots ? N_SHOT_VALUE : N_BULLET_VALUE); k++) {
        v->has_values |= (uint8_t)(fire_args[FIRE_FIRST_VALUE + k].given << k);
        v->value[k] = fire_args[FIRE_FIRST_VALUE + k].f;
    }
}

/* Fires the pattern. Returns false without firing if the loop in Lua must run instead. */
static bool fire_volley(lua_State *L, struct board *b, const struct api_entry *e, const struct api_value *pattern_args)
{
    const struct api_value *fire_args = pattern_args + e->count;
    struct volley v;

    read_volley(L, b, e, pattern_args, &v);
    if (!emit_count_left(&v, 0))
        return true;
    if (!api_read_flight(L, b, e->name, fire_args, v.fires_shots, &v.spec))
        return true; /* the thing `from` is dead, or the ship that would fire was hit */
    v.x = v.aim_x = v.spec.x;
    v.y = v.aim_y = v.spec.y;
    if (v.pattern == EMIT_LINE)
        set_line_position(b, &v, fire_args + FIRE_POSITION);
    emit_aim_volley(b, &v);
    if (!ends_are_valid(&v))
        return false;
    b->vm.work += v.is_aimed ? emit_aim_work(b, v.fires_shots) : 0;
    vm_charge(L, WORK_FIRE * (uint64_t)emit_count_left(&v, 0));
    emit_fire_volley(b, &v, b->core.clock);
    return true;
}

/* The function that sys.volley returns, bound to the pattern's entry. */
static int run_volley(lua_State *L)
{
    struct api_binding *f = api_current_binding(L);
    const struct api_entry *e = f->entry, *fired_entry;
    struct board *b = vm_board(L);
    struct api_value v[MAX_PARAMS];

    if (needs_lua_loop(L))
        return lua_pushboolean(L, false), 1;
    vm_charge(L, WORK_CALL);
    const int n = api_read_planned_arguments(L, f, v, &fired_entry);
    const struct api_value *skip = v + e->count - OWN_SKIP_FROM_END;
    api_fold_call(L, b, f->hash, v, n);
    for (int i = 1; skip->given && i <= 2; i++)
        script_update_digest(b, (uint64_t)read_skip_bound(L, skip, i));
    lua_pushboolean(L, fire_volley(L, b, e, v));
    return luakeys_return(L, 1);
}

int api_push_volley(lua_State *L, struct board *b, struct api_value *v)
{
    const char *name = lua_tostring(L, v[0].at);
    const struct api_entry *e = api_find_entry(api_get_table(L), name);

    (void)b;
    if (!e || !(e->flags & API_PATTERN) || find_pattern(name) == EMIT_ONE)
        return api_error(L, "sys.volley", "unknown volley \"%s\"", name);
    api_push_bound_function(L, e, run_volley);
    return 1;
}
