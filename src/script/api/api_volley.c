/*
 * api_volley.c - pattern.ring, fan, arc, stack and line as one call that fires all their bullets. It fires exactly the
 * same bullets as the loops in scripts/pattern.lua, in a tenth of the time. Only the loops handle `each`, lasers, and
 * arguments that only some of the bullets reject. The digest folds a volley as one call, because its arguments
 * determine all of its bullets.
 */
#include <string.h>
#include "../../base/hash.h"
#include "../../base/trig.h"
#include "../../machine/emit.h"
#include "api_parts.h"

/* Indices of a pattern's own parameters: n, its size (except for a ring), then the rest. */
enum { OWN_N, OWN_SIZE, OWN_SKIP_BACK = 3 /* counted from the end */ };

struct volley {
    struct emit_figure f;
    struct bullet_shape shape;
    bool shots, aim;
    lua_Integer first, last; /* first and last skipped bullet, counted from 1 */
    fx x, y;                 /* line: the part of the position that is already rounded */
    double dx, dy;           /* line: the part to which a bullet's own offset is added before rounding */
};

static uint8_t pattern_of(const char *name)
{
    static const char *const names[] = {
        [EMIT_RING] = "ring", [EMIT_FAN] = "fan", [EMIT_ARC] = "arc", [EMIT_STACK] = "stack", [EMIT_LINE] = "line"
    };

    for (uint8_t i = EMIT_RING; i <= EMIT_LINE; i++)
        if (!strncmp(name, "pattern.", 8) && !strcmp(name + 8, names[i]))
            return i;
    return EMIT_ONE;
}

static fx nearest(double v)
{
    fx out = 0;

    fx_from_double(v, &out);
    return out;
}

static bool within(double v, double most)
{
    return v >= -most && v <= most;
}

/* Returns whether the loop in Lua must run instead. The loop also handles an argument that is not a table, to raise its
 * own error. */
static bool is_for_lua(lua_State *L)
{
    if (lua_gettop(L) != 1 || lua_type(L, 1) != LUA_TTABLE)
        return true;
    lua_pushliteral(L, "each");
    bool lua = lua_rawget(L, 1) != LUA_TNIL;
    lua_pushliteral(L, "fire");
    if (lua_rawget(L, 1) != LUA_TNIL)
        lua |= lua_type(L, -1) != LUA_TSTRING ||
               (strcmp(lua_tostring(L, -1), "bullet") != 0 && strcmp(lua_tostring(L, -1), "shot") != 0);
    lua_settop(L, 1);
    return lua;
}

static lua_Integer end_of(lua_State *L, const struct api_value *skip, int i)
{
    lua_rawgeti(L, skip->at, i);
    const lua_Integer n = lua_tointeger(L, -1);
    lua_pop(L, 1);
    return n;
}

/* Returns the number of bullets to fire from index i on, not counting skipped bullets. */
static lua_Integer left(const struct volley *v, lua_Integer i)
{
    const lua_Integer first = v->first > i + 1 ? v->first : i + 1, last = v->last < v->f.n ? v->last : v->f.n;

    return v->f.n - i - (last >= first ? last - first + 1 : 0);
}

/* Sets the base position of a line. A bullet's offset is added to the unrounded part, then the sum is rounded. */
static void line_place(struct board *b, struct volley *v, const struct api_value *place)
{
    if (place[PLACE_FROM].given) {
        board_where(b, place[PLACE_FROM].i, &v->x, &v->y);
        v->dx = place[PLACE_DX].n;
        v->dy = place[PLACE_DY].n;
    } else {
        v->x = place[PLACE_DX].f;
        v->y = place[PLACE_DY].f;
        v->dx = place[PLACE_X].n;
        v->dy = place[PLACE_Y].n;
    }
}

/* Aims a line once, from its middle: from x, y without dx, dy, as in pattern.lua. */
static void settle(struct board *b, struct volley *v, bool from)
{
    if (v->aim) {
        const fx x = nearest(from ? fx_to_double(v->x) + v->dx : v->dx);
        const fx y = nearest(from ? fx_to_double(v->y) + v->dy : v->dy);
        v->f.dir = trig_to_degrees(api_aim(b, v->shots, x, y)) + v->f.dir;
        v->aim = false;
    }
    emit_turn(&v->f);
}

/* Returns whether bullet.fire would accept the arguments of the first and the last bullet. The arguments of every other
 * bullet lie between those two. */
static bool all_fit(const struct volley *v)
{
    for (int end = 0; end < 2; end++) {
        struct emit_way w;
        ang a;
        emit_way(&v->f, end ? v->f.n - 1 : 0, &w);
        if (!trig_from_degrees(w.dir, &a) || !within(w.speed, MAX_SPEED) || !within(v->dx + w.dx, WORLD) ||
            !within(v->dy + w.dy, WORLD))
            return false;
    }
    return true;
}

/* Fires bullet i; returns false if the pool is full. */
static bool fire_one(struct board *b, struct volley *v, int32_t i, ang aimed, const struct api_value *values)
{
    struct bullet_shape *s = &v->shape;
    struct emit_way w;

    emit_way(&v->f, i, &w);
    trig_from_degrees(w.dir, &s->dir);
    s->dir += aimed;
    s->speed = nearest(w.speed);
    if (v->f.pattern == EMIT_LINE) {
        s->x = fx_clamp(fx_add(v->x, nearest(v->dx + w.dx)), -WORLD * FX_ONE, WORLD * FX_ONE);
        s->y = fx_clamp(fx_add(v->y, nearest(v->dy + w.dy)), -WORLD * FX_ONE, WORLD * FX_ONE);
    }
    const int32_t at = emit_fire(b, v->shots, s, fx_nearest(w.speed * 4294967296.0), b->core.clock);
    if (at != NO_SLOT)
        api_value_set(b, v->shots ? N_SHOT_VALUE : N_BULLET_VALUE, (uint32_t)at, values);
    return at != NO_SLOT;
}

static void fire_all(struct board *b, struct volley *v, const struct api_value *values)
{
    const ang aimed = v->aim ? api_aim(b, v->shots, v->shape.x, v->shape.y) : 0;

    for (int32_t i = 0; i < v->f.n; i++) {
        if (i + 1 >= v->first && i + 1 <= v->last)
            continue;
        if (!fire_one(b, v, i, aimed, values)) { /* the remaining bullets are refused too */
            emit_refuse(b, v->shots, (uint64_t)(left(v, i) - 1));
            return;
        }
    }
}

/* Reads the pattern's own arguments, and the arguments of bullet.fire that all bullets share. */
static void read(lua_State *L, const struct api_entry *e, const struct api_value *own, struct volley *v)
{
    const struct api_value *fire = own + e->count, *skip = own + e->count - OWN_SKIP_BACK;

    *v = (struct volley){ .aim = fire[FIRE_AIM].i, .last = -1 };
    v->shots = skip[1].given && !strcmp(lua_tostring(L, skip[1].at), "shot");
    v->f = (struct emit_figure){ .pattern = pattern_of(e->name),
                                 .n = (int32_t)own[OWN_N].i,
                                 .dir = fire[FIRE_DIR].given || !v->aim ? fire[FIRE_DIR].n : 0,
                                 .speed = fire[FIRE_SPEED].n };
    if (v->f.pattern != EMIT_RING)
        v->f.size = own[OWN_SIZE].n;
    if (skip->given) {
        v->first = end_of(L, skip, 1);
        v->last = end_of(L, skip, 2);
    }
}

/* Fires the pattern. Returns false without firing if the loop in Lua must run instead. */
static bool fire(lua_State *L, struct board *b, const struct api_entry *e, const struct api_value *own)
{
    const struct api_value *args = own + e->count;
    struct volley v;

    read(L, e, own, &v);
    if (left(&v, 0) <= 0)
        return true;
    if (!api_flight(L, b, e->name, args, v.shots, &v.shape))
        return true; /* the thing `from` is dead, or the ship that would fire was hit */
    if (v.f.pattern == EMIT_LINE) {
        line_place(b, &v, args + FIRE_PLACE);
        settle(b, &v, args[FIRE_PLACE + PLACE_FROM].given);
    }
    if (!all_fit(&v))
        return false;
    vm_charge(L, WORK_FIRE * (uint64_t)left(&v, 0));
    fire_all(b, &v, args + FIRE_VALUES);
    return true;
}

/* The function that sys.volley returns, bound to the pattern's entry. */
static int volley(lua_State *L)
{
    struct api_bound *f = api_bound(L);
    const struct api_entry *e = f->entry, *fires;
    struct board *b = vm_board(L);
    struct api_value v[MAX_PARAMS];

    if (is_for_lua(L))
        return lua_pushboolean(L, false), 1;
    vm_charge(L, WORK_CALL);
    const int n = api_read_planned_arguments(L, f, v, &fires);
    const struct api_value *skip = v + e->count - OWN_SKIP_BACK;
    api_fold_call(L, b, f->hash, v, n);
    for (int i = 1; skip->given && i <= 2; i++)
        script_fold(b, (uint64_t)end_of(L, skip, i));
    lua_pushboolean(L, fire(L, b, e, v));
    return luakeys_return(L, 1);
}

int api_volley(lua_State *L, struct board *b, struct api_value *v)
{
    const char *name = lua_tostring(L, v[0].at);
    const struct api_entry *e = api_find(api_of(L), name);

    (void)b;
    if (!e || !(e->flags & API_FIRE) || pattern_of(name) == EMIT_ONE)
        return api_error(L, "sys.volley", "unknown volley \"%s\"", name);
    api_push_bound(L, e, volley);
    return 1;
}
