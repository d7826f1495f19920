/*
 * api_hit.c - declaring kinds, and their hit shapes: `hit = { circle = 3 }`.
 */
#include <string.h>
#include "../../base/trig.h"
#include "../events_run.h"
#include "api_parts.h"

/* Returns the only key of the table at `at`; raises an error if there are none or several. */
static const char *find_hit_key(lua_State *L, const char *entry, int at, enum hit_owner owner)
{
    static const struct api_param keys[] = { { .name = "circle" },  { .name = "sprite" },  { .name = "box" },
                                             { .name = "capsule" }, { .name = "circles" }, { .name = "share" } };
    static const int counts[] = { [HIT_PLAYERS] = 2, [HIT_ENEMIES] = 5, [HIT_BULLETS] = 5, [HIT_LASERS] = 1 };
    const struct api_fields known = { owner == HIT_LASERS ? &keys[5] : keys, counts[owner], NAME_LISTS };
    const char *key = NULL;

    if (luakeys_push_unknown(L, at, api_is_known_field, &known))
        api_error(L, entry, "hit: expected %s, got a table with key %s", api_hit_forms[owner],
                  api_push_description(L, -1));
    for (int k = 0; k < known.n; k++) {
        const char *name = known.params[k].name;
        if (lua_getfield(L, at, name) != LUA_TNIL && key)
            api_error(L, entry, "hit: expected %s, got a table with both \"%s\" and \"%s\"", api_hit_forms[owner], key,
                      name);
        key = lua_isnil(L, -1) ? key : name;
        lua_pop(L, 1);
    }
    if (!key)
        api_error(L, entry, "hit: expected %s, got an empty table", api_hit_forms[owner]);
    return key;
}

/* Checks element i of the list on top of the stack against p (px or degrees) and returns it. The list stays on the
 * stack. */
static struct api_value check_element(lua_State *L, const char *entry, enum hit_owner owner, int i,
                                      const struct api_param *p)
{
    struct api_value v = { 0 };
    int list = lua_gettop(L);

    if (lua_type(L, list) != LUA_TTABLE)
        api_error(L, entry, "hit: expected %s", api_hit_forms[owner]);
    lua_rawgeti(L, list, i);
    api_check(L, entry, p, list + 1, &v);
    lua_settop(L, list);
    return v;
}

#define LENGTH_PARAM(name) &(const struct api_param)LENGTH(name, REQ, NULL, NULL)
#define OFFSET_PARAM(name) &(const struct api_param)PARAM(name, A_FX, REQ, -MAX_SPEED, MAX_SPEED, "px", NULL, NULL)

/* Raises an error if a shape reaches further from its centre than MAX_SPEED px, the largest radius. */
static void check_reach(lua_State *L, const char *entry, int64_t reach)
{
    if (reach > (int64_t)MAX_SPEED << 16)
        api_error(L, entry, "hit: the shape reaches %d px from its centre, expected at most %d", (int)(reach >> 16),
                  MAX_SPEED);
}

/* Reads a capsule. A bullet's capsule lies along its dir; an enemy, which has no dir, must give one. */
static void read_capsule(lua_State *L, const char *entry, enum hit_owner owner, struct api_shape *s)
{
    const struct api_param dir = PARAM("hit.capsule dir", A_DIR, OPT, 0, 0, NULL, "90", NULL);
    fx half = check_element(L, entry, owner, 1, LENGTH_PARAM("hit.capsule length")).f / 2;

    s->shape = SHAPE_CAPSULE;
    s->row[0].a = check_element(L, entry, owner, 2, LENGTH_PARAM("hit.capsule radius")).f;
    check_reach(L, entry, (int64_t)s->row[0].a + half);
    if (owner == HIT_BULLETS) {
        if (lua_rawgeti(L, -1, 3) != LUA_TNIL)
            api_error(L, entry,
                      "hit.capsule: expected { length, radius }, got a third value (a bullet's capsule lies along its "
                      "`dir`)");
        s->row[0].b = half;
        return;
    }
    struct api_value v = check_element(L, entry, owner, 3, &dir);
    trig_polar(half, v.given ? v.a : ANG_DOWN, &s->row[0].x, &s->row[0].y);
}

static void read_circles(lua_State *L, const char *entry, enum hit_owner owner, struct api_shape *s)
{
    uint32_t n = lua_type(L, -1) == LUA_TTABLE ? (uint32_t)lua_rawlen(L, -1) : 0;

    if (n < 1 || n > SHAPE_MAX_CIRCLES)
        api_error(L, entry, "hit.circles: expected a list of 1 to %d circles { x, y, r }", SHAPE_MAX_CIRCLES);
    s->shape = SHAPE_CIRCLES;
    s->rows = n;
    for (uint32_t i = 0; i < n; i++) {
        lua_rawgeti(L, -1, (int)i + 1);
        s->row[i].x = check_element(L, entry, owner, 1, OFFSET_PARAM("hit.circles x")).f;
        s->row[i].y = check_element(L, entry, owner, 2, OFFSET_PARAM("hit.circles y")).f;
        s->row[i].a = check_element(L, entry, owner, 3, LENGTH_PARAM("hit.circles r")).f;
        s->row[i].b = (fx)(n - 1 - i);
        check_reach(L, entry, (int64_t)fx_abs(s->row[i].x) + fx_abs(s->row[i].y) + s->row[i].a + 2);
        lua_pop(L, 1);
    }
}

/* Reads the hit shape drawn with the sprite whose name is on top of the stack. */
static void read_sprite_shape(lua_State *L, const char *entry, enum hit_owner owner, struct api_shape *s)
{
    const struct api_param sprite = REQUIRED("hit.sprite", A_SPRITE, NULL);
    const int at = lua_gettop(L);
    struct api_value v = { 0 };
    struct cart_hitbox hit;

    api_check(L, entry, &sprite, at, &v);
    const char *name = lua_tostring(L, at);
    if (!cart_find_hitbox(&vm_board(L)->cart, name, &hit))
        api_error(L, entry, "hit.sprite: sprite \"%s\" has no hit shape (add a slice named \"hit\" to its .ase file)",
                  name);
    if (owner == HIT_PLAYERS && hit.shape != SHAPE_CIRCLE)
        api_error(L, entry,
                  "hit.sprite: expected one circle at the player's position, got a different hit shape from \"%s\"",
                  name);
    if (owner == HIT_BULLETS && hit.shape == SHAPE_CAPSULE && hit.row[0].y != 0)
        api_error(L, entry,
                  "hit.sprite: the capsule of \"%s\" is vertical, but a bullet's capsule lies along its `dir` (draw "
                  "it pointing right)",
                  name);
    s->shape = (uint8_t)hit.shape;
    s->rows = hit.rows;
    for (uint32_t i = 0; i < hit.rows; i++) {
        s->row[i].a = hit.row[i].a;
        s->row[i].b = hit.shape == SHAPE_CIRCLES ? (fx)(hit.rows - 1 - i) : hit.row[i].b;
        s->row[i].x = hit.row[i].x;
        s->row[i].y = hit.row[i].y;
    }
    if (owner == HIT_BULLETS && hit.shape == SHAPE_CAPSULE) {
        s->row[0].b = hit.row[0].x;
        s->row[0].x = 0;
    }
}

struct api_shape api_read_hit_shape(lua_State *L, const char *entry, int at, enum hit_owner owner)
{
    static const struct api_param radius = LENGTH("hit.circle", REQ, NULL, NULL),
                                  share = PARAM("hit.share", A_FX, REQ, 0, 1, NULL, NULL, NULL);
    struct api_shape s = { .shape = SHAPE_NONE, .rows = 1 };
    struct api_value v;
    int top = lua_gettop(L);

    if (lua_type(L, at) == LUA_TSTRING) {
        if (owner == HIT_PLAYERS || strcmp(lua_tostring(L, at), "none"))
            api_error(L, entry, "hit: expected %s, got \"%s\"", api_hit_forms[owner], lua_tostring(L, at));
        return s;
    }
    const char *key = find_hit_key(L, entry, at, owner);
    lua_getfield(L, at, key);
    if (!strcmp(key, "circle") || owner == HIT_LASERS) {
        s.shape = SHAPE_CIRCLE;
        api_check(L, entry, owner == HIT_LASERS ? &share : &radius, top + 1, &v);
        s.row[0].a = v.f;
    } else if (!strcmp(key, "capsule"))
        read_capsule(L, entry, owner, &s);
    else if (!strcmp(key, "sprite"))
        read_sprite_shape(L, entry, owner, &s);
    else if (!strcmp(key, "circles"))
        read_circles(L, entry, owner, &s);
    else {
        s.shape = SHAPE_BOX;
        s.row[0].a = check_element(L, entry, owner, 1, LENGTH_PARAM("hit.box width")).f / 2;
        s.row[0].b = check_element(L, entry, owner, 2, LENGTH_PARAM("hit.box height")).f / 2;
    }
    lua_settop(L, top);
    return s;
}

void api_scale_hit_shape(lua_State *L, const char *entry, struct api_shape *s, int32_t scale)
{
    for (uint32_t i = 0; i < s->rows; i++) {
        fx *const a = &s->row[i].a, *const b = &s->row[i].b, *const x = &s->row[i].x, *const y = &s->row[i].y;
        *a = motion_scale_length(*a, scale);
        *x = motion_scale_length(*x, scale);
        *y = motion_scale_length(*y, scale);
        if (s->shape == SHAPE_CIRCLES) { /* b is a number of circles */
            check_reach(L, entry, (int64_t)fx_abs(*x) + fx_abs(*y) + *a + 2);
            continue;
        }
        *b = motion_scale_length(*b, scale);
        if (s->shape == SHAPE_CAPSULE)
            check_reach(L, entry, (int64_t)*a + *b + fx_max(fx_abs(*x), fx_abs(*y)));
        else
            check_reach(L, entry, fx_max(*a, *b));
    }
}

void api_check_rotations(lua_State *L, const char *entry, const char *argument, const struct api_value *sprite)
{
    if (vm_board(L)->sprite_images[sprite->i].rotations == 1)
        api_error(L, entry, "%s: sprite \"%s\" has no rotations (add `rotations` to it in rom.lua)", argument,
                  lua_tostring(L, sprite->at));
}

void api_check_transforms(lua_State *L, const struct api_value *v, int first, int n)
{
    const struct api_entry *e = api_current_binding(L)->entry;

    for (int i = first; i < first + n && !vm_board(L)->cart.manifest.has_transforms; i++)
        if (v[i].given)
            api_error(L, e->name, "%s: " API_DISABLED_FORMAT, e->params[i].name,
                      "transforms are disabled; add `transforms = true` to `board`");
}

int32_t api_declare_kind(lua_State *L, const char *entry, struct slots *kinds, const struct shape_columns *k,
                         const struct api_shape *s)
{
    int32_t first = (int32_t)kinds->live;

    for (uint32_t i = 0; i < s->rows; i++) {
        int32_t row = slots_append(kinds);
        if (row == NO_SLOT)
            api_error(L, entry,
                      "no free kind: the pool's capacity in rom.lua is 0, or all %d kinds are declared (a cloud, and "
                      "each circle after the first, counts as one)",
                      MAX_KINDS);
        k->shape[row] = s->shape;
        k->a[row] = s->row[i].a;
        k->b[row] = s->row[i].b;
        k->x[row] = s->row[i].x;
        k->y[row] = s->row[i].y;
    }
    return first;
}

int32_t api_append_kind(lua_State *L, const char *entry, struct slots *kinds, enum name_kind names,
                        const struct api_value *v)
{
    vm_reserve(L, kinds, 1);
    const int32_t i = slots_append(kinds);
    if (i == NO_SLOT)
        api_error(L, entry, "too many kinds (at most %d)", (int)kinds->cap);
    api_names_declare(L, names, entry, lua_tostring(L, v->at), i);
    api_store_arguments(L, vm_board(L), i, v);
    return i;
}
