/*
 * api_body.c - enemies with parts: enemy.def{ parts }, enemy.spawn{ follow }, orbits and wandering.
 *
 * The parts of a kind are stored as a string in the registry, like drops: the nesting depth, then PART_BYTES per part.
 */
#include "../../base/bytes.h"
#include "../../base/int.h"
#include "../events_run.h"
#include "api_enemy.h"
#include <string.h>
#include "../../base/trig.h"

static const char bodies_disabled[] = "disabled; add `bodies = true` to `board`";

void api_check_bodies(lua_State *L, const char *entry, const char *feature)
{
    if (!vm_board(L)->enemies.rate)
        api_error(L, entry, "%s: " API_DISABLED_FORMAT, feature, bodies_disabled);
}

/* ---- the parts of a kind ---- */

enum { MAX_BODY_PARTS = 64, DEPTH_BYTES = 4, PART_BYTES = 24 };
enum { P_KIND, P_DX, P_DY, P_SHARE, P_TAG, P_HP, P_RATE };

static const struct api_param part_params[] = {
    REQUIRED("kind", A_ENEMY_KIND, "declared kind of the part"),
    OFFSET("dx", A_FX, "distance to the right of the body"),
    OFFSET("dy", A_FX, "distance below the body"),
    PARAM("share", A_FX, OPT, 0, 1, NULL, "0", "fraction of the damage to the part that is also dealt to the body"),
    LABEL("tag", OPT, "name of a group to put the part in"),
    PARAM("hp", A_INT, OPT, 1, INT32_MAX, NULL, NULL, "hit points; overrides its kind's"),
    PARAM("rate", A_FX, OPT, 0, MAX_RATE, NULL, NULL, "damage multiplier; overrides its kind's"),
};
static const struct api_entry part_entry = { .name = "enemy.def part", .params = part_params, .count = P_RATE + 1 };

struct body_part {
    uint16_t kind, tag;
    fx dx, dy;
    int32_t share, hp, rate; /* hp 0, rate -1: use the kind's value */
};

static struct body_part unpack_part(const uint8_t *p)
{
    return (struct body_part){ bytes_get16(p),
                               bytes_get16(p + 2),
                               (fx)bytes_get32(p + 4),
                               (fx)bytes_get32(p + 8),
                               (int32_t)bytes_get32(p + 12),
                               (int32_t)bytes_get32(p + 16),
                               (int32_t)bytes_get32(p + 20) };
}

/* Pushes the string with a kind's parts, or nil if the kind has no parts. Returns the string, or NULL if there are no
 * parts. *n receives the number of parts. */
static const uint8_t *push_parts(lua_State *L, uint16_t kind, int *n)
{
    size_t size = 0;

    events_push_property(L, kind, "parts");
    const char *list = lua_type(L, -1) == LUA_TSTRING ? lua_tolstring(L, -1, &size) : NULL;
    *n = size < DEPTH_BYTES ? 0 : (int)((size - DEPTH_BYTES) / PART_BYTES);
    return *n ? (const uint8_t *)list : NULL;
}

/* Returns the nesting depth of a kind's parts; 0: no parts. */
static int get_parts_depth(lua_State *L, uint16_t kind)
{
    int n;
    const uint8_t *list = push_parts(L, kind, &n);
    const int d = list ? (int)bytes_get32(list) : 0;

    lua_pop(L, 1);
    return d;
}

/* Packs the table on the stack, which describes one part, into a string and pushes the string. */
static int push_packed_part(lua_State *L)
{
    struct api_value v[P_RATE + 1];
    const struct api_entry *fired_entry;
    uint8_t out[PART_BYTES];

    api_read_arguments(L, &part_entry, v, &fired_entry);
    bytes_put16(out, (uint16_t)v[P_KIND].i);
    bytes_put16(out + 2, api_read_tag(L, part_entry.name, &v[P_TAG]));
    bytes_put32(out + 4, (uint32_t)v[P_DX].f);
    bytes_put32(out + 8, (uint32_t)v[P_DY].f);
    bytes_put32(out + 12, (uint32_t)v[P_SHARE].f);
    bytes_put32(out + 16, v[P_HP].given ? (uint32_t)v[P_HP].i : 0);
    bytes_put32(out + 20, v[P_RATE].given ? (uint32_t)v[P_RATE].f : UINT32_MAX);
    lua_pushlstring(L, (const char *)out, PART_BYTES);
    return 1;
}

void api_body_define(lua_State *L, int32_t kind, int at)
{
    const lua_Integer n = (lua_Integer)lua_rawlen(L, at);
    uint8_t list[DEPTH_BYTES + MAX_BODY_PARTS * PART_BYTES];
    int max_depth = 0;

    api_check_bodies(L, "enemy.def", "parts");
    if (!n || n > MAX_BODY_PARTS)
        api_error(L, "enemy.def", "parts: expected a list of 1 to %d parts { kind = .., dx = .., dy = .. }, got %d",
                  MAX_BODY_PARTS, (int)n);
    for (int i = 0; i < n; i++) {
        lua_pushcfunction(L, push_packed_part);
        if (lua_rawgeti(L, at, i + 1) != LUA_TTABLE)
            api_error(L, "enemy.def", "parts[%d]: expected { kind = .., dx = .., dy = .. }, got %s", i + 1,
                      luaL_typename(L, -1));
        lua_call(L, 1, 1);
        memcpy(list + DEPTH_BYTES + i * PART_BYTES, lua_tostring(L, -1), PART_BYTES);
        lua_pop(L, 1);
        max_depth = (int)int64_max(max_depth, get_parts_depth(L, bytes_get16(list + DEPTH_BYTES + i * PART_BYTES)));
    }
    if (max_depth == MAX_PART_DEPTH)
        api_error(L, "enemy.def", "parts: nested more than %d deep", MAX_PART_DEPTH);
    bytes_put32(list, (uint32_t)max_depth + 1);
    lua_pushlstring(L, (const char *)list, DEPTH_BYTES + (size_t)n * PART_BYTES);
    api_fold_stack_value(L, vm_board(L), lua_gettop(L));
    events_set_property(L, (uint16_t)kind, "parts");
}

/* ---- spawning ---- */

void api_body_check_depth(lua_State *L, const struct board *b, uint16_t kind, int64_t body)
{
    if (enemies_part_depth(&b->enemies, handle_slot(body)) + 1 + get_parts_depth(L, kind) > MAX_PART_DEPTH)
        api_error(L, "enemy.spawn", "follow: parts nested more than %d deep", MAX_PART_DEPTH);
}

void api_body_spawn_parts(lua_State *L, struct board *b, uint32_t body)
{
    struct enemies *e = &b->enemies;
    int n;

    luaL_checkstack(L, 8, NULL);
    const uint8_t *list = push_parts(L, e->kind[body], &n);
    for (int k = 0; k < n; k++) {
        const struct body_part p = unpack_part(list + DEPTH_BYTES + k * PART_BYTES);
        int32_t i = api_enemy_spawn(L, b, p.kind, 0, 0, e->owner[body]);
        if (i == NO_SLOT)
            continue;
        enemies_attach(e, (uint32_t)i, body, p.dx, p.dy, p.share);
        e->tag[i] = p.tag;
        e->hp[i] = p.hp ? p.hp : e->hp[i];
        e->rate[i] = p.rate >= 0 ? p.rate : e->rate[i];
        api_body_spawn_parts(L, b, (uint32_t)i);
    }
    lua_pop(L, 1);
}

void api_body_start_part_tasks(lua_State *L, struct board *b, uint32_t body)
{
    struct enemies *e = &b->enemies;

    EACH_LIVE (i, &e->s) {
        if (e->body[i] != body + 1)
            continue;
        api_enemy_start_task(L, b, i);
        api_body_start_part_tasks(L, b, i);
    }
}

static int enemy_parts(lua_State *L, struct board *b, struct api_value *v)
{
    const struct enemies *e = &b->enemies;
    const int64_t h = v[0].i;
    lua_Integer n = 0;

    api_check_bodies(L, "enemy:parts", "parts");
    lua_newtable(L);
    if (!board_is_readable(b, h))
        return 1;
    vm_charge(L, e->s.live);
    const uint32_t tag = api_read_tag(L, "enemy:parts", &v[1]);
    EACH_LIVE (i, &e->s) {
        if (e->body[i] != handle_slot(h) + 1 || e->flags[i] & ENEMY_DYING || !api_has_tag(e->tag, i, tag))
            continue;
        lua_pushinteger(L, board_handle(b, H_ENEMY, (int32_t)i));
        lua_rawseti(L, -2, ++n);
    }
    return 1;
}

/* ---- properties ---- */

void api_body_get(lua_State *L, const struct board *b, uint32_t i, enum api_body_prop p)
{
    const struct enemies *e = &b->enemies;
    const fx values[] = { [BODY_DX] = e->dx[i], [BODY_DY] = e->dy[i], [BODY_SHARE] = e->damage_share[i] };

    if (!e->body[i])
        lua_pushnil(L);
    else if (p == BODY_FOLLOW)
        lua_pushinteger(L, board_handle(b, H_ENEMY, e->body[i] - 1));
    else
        lua_pushnumber(L, fx_to_double(values[p]));
}

void api_body_set(lua_State *L, struct board *b, uint32_t i, enum api_body_prop p, fx v)
{
    static const char *const names[] = { [BODY_DX] = "dx", [BODY_DY] = "dy", [BODY_SHARE] = "share" };
    struct enemies *e = &b->enemies;
    const uint32_t body = e->body[i] - 1u;

    if (!e->body[i])
        vm_fault(L, FAULT_SCRIPT, "enemy: %s: this enemy is not a part (enemy.spawn { follow = .. } spawns one)",
                 names[p]);
    if (p == BODY_SHARE)
        e->damage_share[i] = v;
    else if (p == BODY_DX)
        enemies_set_position(e, i, fx_add(e->x[body], v), e->y[i]);
    else
        enemies_set_position(e, i, e->x[i], fx_add(e->y[body], v));
}

/* ---- orbits and wandering ---- */

#define SELF_PARAM THING("self", REQ, 1 << H_ENEMY | 1 << H_ENEMIES, "the thing itself")

enum { ARG_SELF, O_AROUND, O_X, O_Y, O_RADIUS, O_RADIUS_TO, O_SPIN, O_DIR, O_OVER };
static const struct api_param orbit_params[] = {
    SELF_PARAM,
    THING("around", OPT, POSITION_HANDLE_KINDS,
          "thing to circle; after it despawns, the enemy circles its last position; give `around`, or `x` and `y`"),
    COORDINATE("x", A_FX, OPT, "horizontal position of the circle's centre"),
    COORDINATE("y", A_FX, OPT, "vertical position of the circle's centre"),
    PARAM("radius", A_FX, OPT, 0, WORLD_EDGE, "px", NULL,
          "radius at the start; defaults to the current distance from the centre"),
    PARAM("radius_to", A_FX, OPT, 0, WORLD_EDGE, "px", NULL,
          "radius at the end of `over`; defaults to `radius`; needs `over`"),
    REQUIRED("spin", A_DIR, "degrees the enemy moves around the centre per frame, clockwise"),
    OPTIONAL("dir", A_DIR, "direction from the centre to the enemy at the start; defaults to the current one"),
    PARAM("over", A_COUNT, OPT, 1, 1e9, "frames", "forever", "duration of the orbit"),
};

enum { W_W = 1, W_H, W_EVERY, W_OVER, W_X, W_Y, W_EASE };
static const struct api_param wander_params[] = {
    SELF_PARAM,
    PARAM("w", A_FX, REQ, 0, 32767, "px", NULL, "width of the area, centred on `x` and `y`"),
    PARAM("h", A_FX, REQ, 0, 32767, "px", NULL, "height of the area, centred on `x` and `y`"),
    PARAM("every", A_INT, REQ, 1, 1e9, "frames", NULL, "frames from the start of one move to the start of the next"),
    PARAM("over", A_INT, REQ, 1, 1e9, "frames", NULL, "duration of each move; must not exceed `every`"),
    COORDINATE("x", A_FX, OPT, "horizontal position of the area's centre; defaults to the enemy's position"),
    COORDINATE("y", A_FX, OPT, "vertical position of the area's centre; defaults to the enemy's position"),
    DEFAULT("ease", A_EASE, "linear",
            "how the speed changes on the way: `in` starts slowly, `out` ends slowly, `both` starts and ends slowly"),
};

static bool is_forever(const struct api_value *v)
{
    return v->i == LUA_MAXINTEGER;
}

static void check_orbit(lua_State *L, const struct api_value *v)
{
    const char *name = api_current_binding(L)->entry->name;
    const bool has_centre = v[O_X].given || v[O_Y].given;

    api_check_bodies(L, name, "orbit");
    if (v[O_AROUND].given ? has_centre : !(v[O_X].given && v[O_Y].given))
        api_error(L, name, "expected either `around` (a thing) or `x` and `y`");
    if (v[O_RADIUS_TO].given && is_forever(&v[O_OVER]))
        api_error(L, name, "radius_to: requires `over`");
}

static int orbit_one(lua_State *L, struct board *b, struct api_value *v)
{
    const uint32_t i = handle_slot(v[ARG_SELF].i);
    struct enemies *e = &b->enemies;
    struct enemies_orbit o = { v[O_AROUND].given ? v[O_AROUND].i : 0, v[O_X].f, v[O_Y].f, 0, 0, 0, 0, 0 };

    if (o.orbit_target == v[ARG_SELF].i)
        api_error(L, api_current_binding(L)->entry->name, "around: an enemy cannot orbit itself");
    if (o.orbit_target && !board_get_position(b, o.orbit_target, &o.x, &o.y))
        return 0;
    const fx dx = fx_sub(e->x[i], o.x), dy = fx_sub(e->y[i], o.y);
    o.radius = v[O_RADIUS].given ? v[O_RADIUS].f : fx_min(fx_hypot(dx, dy), (fx)WORLD_EDGE << 16);
    o.radius_to = v[O_RADIUS_TO].given ? v[O_RADIUS_TO].f : o.radius;
    o.angle = v[O_DIR].given ? v[O_DIR].a : trig_atan2(dy, dx);
    o.spin = (int32_t)v[O_SPIN].a;
    o.duration = is_forever(&v[O_OVER]) ? 0 : (uint32_t)v[O_OVER].i;
    enemies_start_orbit(e, i, &o);
    return 0;
}

static int wander_one(lua_State *L, struct board *b, struct api_value *v)
{
    const uint32_t i = handle_slot(v[ARG_SELF].i);
    const struct enemies *e = &b->enemies;
    const struct enemies_wander_area g = { v[W_X].given ? v[W_X].f : e->x[i],
                                           v[W_Y].given ? v[W_Y].f : e->y[i],
                                           v[W_W].f / 2,
                                           v[W_H].f / 2,
                                           (uint32_t)v[W_EVERY].i,
                                           (uint32_t)v[W_OVER].i,
                                           (enum ease)v[W_EASE].i };

    (void)L;
    enemies_start_wandering(&b->enemies, i, &g);
    return 0;
}

static int enemy_orbit(lua_State *L, struct board *b, struct api_value *v)
{
    check_orbit(L, v);
    return api_start_movement(L, b, v, orbit_one);
}

static int enemy_wander(lua_State *L, struct board *b, struct api_value *v)
{
    api_check_bodies(L, api_current_binding(L)->entry->name, "wander");
    if (v[W_OVER].i > v[W_EVERY].i)
        return api_error(L, api_current_binding(L)->entry->name, "over: expected at most `every` (%d frames), got %d",
                         (int)v[W_EVERY].i, (int)v[W_OVER].i);
    return api_start_movement(L, b, v, wander_one);
}

static const struct api_param parts_params[] = { THING("self", REQ, 1 << H_ENEMY, "the thing itself"),
                                                 LABEL("tag", OPT, "tag of the parts to list; all parts if omitted") };

#define MOVEMENT_ENDS_HELP                                                                                             \
    "; a later `move`, `orbit`, `wander` or write to `x` or `y` stops the movement; needs `board = { bodies = true }`"
#define VERBS(thing, it, moves, waits)                                                                                 \
    API_VERB(thing ":orbit", enemy_orbit, orbit_params, 1, moves,                                                      \
             "starts moving " it " in a circle and returns immediately" waits MOVEMENT_ENDS_HELP),                     \
        API_VERB(thing ":wander", enemy_wander, wander_params, 1, moves,                                               \
                 "starts moving " it " to random positions in an area and returns immediately" MOVEMENT_ENDS_HELP)

static const struct api_entry entries[] = {
    VERBS("enemy", "it", "move", API_MOVE_HELP),
    VERBS("enemies", "each enemy", NULL, ""),
    { "enemy:parts", enemy_parts, PARAMS(parts_params), 2, API_METHOD, "list",
      HELP("returns a list of the enemy's parts in slot order, not including parts of parts; needs `board = { bodies = "
           "true }`") },
    { "enemy.def part", NULL, PARAMS(part_params), 0, API_LUA | API_SYS, NULL,
      HELP("one enemy attached to the body; it spawns, moves and dies with the body") },
};
const struct api_module api_body = { entries, sizeof entries / sizeof *entries };
