/*
 * api_query.c - the Lua table query; and api_place, which reads the position of every fire, spawn and burst.
 */
#include <string.h>
#include "../../machine/lasers_run.h"
#include "api_parts.h"

bool api_place(lua_State *L, struct board *b, const char *entry, const struct api_value *v, fx *x, fx *y)
{
    const struct api_value *from = &v[PLACE_FROM];

    if (from->given ? v[PLACE_X].given || v[PLACE_Y].given : !(v[PLACE_X].given && v[PLACE_Y].given)) {
        if (from->given || v[PLACE_X].given || v[PLACE_Y].given)
            return api_error(L, entry, "place: expected either `x` and `y`, or `from`");
        return api_error(L, entry, "place: expected `x` and `y`, or `from` (a thing), got neither");
    }
    if (!from->given) {
        *x = fx_add(v[PLACE_X].f, v[PLACE_DX].f);
        *y = fx_add(v[PLACE_Y].f, v[PLACE_DY].f);
    } else if (board_where(b, from->i, x, y)) {
        *x = fx_add(*x, v[PLACE_DX].f);
        *y = fx_add(*y, v[PLACE_DY].f);
    } else
        return false;
    const fx edge = (fx)WORLD << 16;
    *x = *x > edge ? edge : *x < -edge ? -edge : *x;
    *y = *y > edge ? edge : *y < -edge ? -edge : *y;
    return true;
}

/* A pool to search: its positions and tags. For lasers, x and y are NULL until found() computes the positions. */
struct field {
    enum handle_kind kind;
    const struct slots *s;
    const fx *x, *y;
    const uint16_t *tag;
    const uint8_t *in;
};

static struct field field_named(lua_State *L, struct board *b, const char *entry, const char *what)
{
    if (!strcmp(what, "bullet"))
        return (struct field){ H_BULLET, &b->bullets.s, b->bullets.x, b->bullets.y, b->bullets.tag, NULL };
    if (!strcmp(what, "shot"))
        return (struct field){ H_SHOT, &b->shots.s, b->shots.x, b->shots.y, b->shots.tag, NULL };
    if (!strcmp(what, "enemy"))
        return (struct field){ H_ENEMY, &b->enemies.s, b->enemies.x, b->enemies.y, b->enemies.tag, NULL };
    if ((!strcmp(what, "item") || !strcmp(what, "laser")) && api_off(&b->cart.m, what))
        api_error(L, entry, "what: " API_OFF, api_off(&b->cart.m, what));
    if (!strcmp(what, "item"))
        return (struct field){ H_ITEM, &b->items.s, b->items.x, b->items.y, b->items.tag, NULL };
    if (!strcmp(what, "laser"))
        return (struct field){ H_LASER, &b->lasers.s, NULL, NULL, b->laser_heads.tag, NULL };
    if (strcmp(what, "player"))
        api_error(L, entry, "what: expected bullet, enemy, item, laser, shot or player, got \"%s\"", what);
    return (struct field){ H_PLAYER, &b->player.s, b->player.x, b->player.y, NULL, b->player.in };
}

static uint64_t distance_squared(const struct field *f, uint32_t i, fx x, fx y)
{
    int64_t dx = (int64_t)f->x[i] - x, dy = (int64_t)f->y[i] - y;

    return (uint64_t)(dx * dx) + (uint64_t)(dy * dy);
}

/* Sinks element i of the heap in the list of slots at `list` (1..n), ordered by distance, then slot. Heapsort in place,
 * which has no quadratic worst case. */
static void sift(lua_State *L, int list, lua_Integer i, lua_Integer n, const struct field *f, fx x, fx y)
{
    for (;;) {
        lua_Integer far = i;
        for (lua_Integer c = 2 * i; c <= 2 * i + 1 && c <= n; c++) {
            lua_rawgeti(L, list, far);
            lua_rawgeti(L, list, c);
            uint32_t s = (uint32_t)lua_tointeger(L, -2), t = (uint32_t)lua_tointeger(L, -1);
            uint64_t ds = distance_squared(f, s, x, y), dt = distance_squared(f, t, x, y);
            lua_pop(L, 2);
            if (dt > ds || (dt == ds && t > s))
                far = c;
        }
        if (far == i)
            return;
        lua_rawgeti(L, list, i);
        lua_rawgeti(L, list, far);
        lua_rawseti(L, list, i);
        lua_rawseti(L, list, far);
        i = far;
    }
}

static void sort_near(lua_State *L, int list, lua_Integer n, const struct field *f, fx x, fx y)
{
    for (lua_Integer i = n / 2; i >= 1; i--)
        sift(L, list, i, n, f, x, y);
    for (lua_Integer end = n; end > 1; end--) {
        lua_rawgeti(L, list, 1);
        lua_rawgeti(L, list, end);
        lua_rawseti(L, list, 1);
        lua_rawseti(L, list, end);
        sift(L, list, 1, end - 1, f, x, y);
    }
}

static bool in_region(const struct board *b, const struct field *f, const struct api_region *r, uint32_t i)
{
    return f->kind == H_LASER ? api_region_laser(b, r, i) : api_region_has(r, f->x[i], f->y[i]);
}

enum { A_CORNER = 3, A_LINE = 3, AN_ENTRY = 12, A_LEVEL = 6 /* work; the last two per sorted entry */ };

/* Sets f's position of each laser to the point of the laser nearest to the region's position. Leaves the userdata that
 * holds the positions on the stack. */
static void place_lasers(lua_State *L, const struct board *b, struct field *f, const struct api_region *r)
{
    const uint32_t n = f->s->top;
    fx *x = lua_newuserdatauv(L, 2 * (n ? n : 1) * sizeof *x, 0), *y = x + n;

    EACH_LIVE (i, f->s) {
        lasers_nearest(b, i, r->x, r->y, &x[i], &y[i]);
        vm_charge(L, A_CORNER * (uint64_t)lasers_corners(b, i));
    }
    f->x = x;
    f->y = y;
}

/* Returns the work of sort_near for n entries. */
static uint64_t sort_work(uint64_t n)
{
    uint64_t levels = 0;

    while (n >> levels)
        levels++;
    return n * (AN_ENTRY + A_LEVEL * levels);
}

/* Pushes the list of entities in the region, nearest to the region's position first, or an empty list if `there` is
 * false. */
static int found(lua_State *L, struct board *b, struct field *f, uint32_t tag, const struct api_region *r, bool there)
{
    uint32_t end = there ? f->s->used ? f->s->top : f->s->live : 0;
    lua_Integer n = 0;

    if (f->kind == H_LASER)
        place_lasers(L, b, f, r);
    lua_newtable(L);
    int list = lua_gettop(L);
    for (uint32_t i = slots_next(f->s, 0); i < end; i = slots_next(f->s, i + 1)) {
        if ((f->in && !f->in[i]) || !board_alive(b, board_handle(b, f->kind, (int32_t)i)) ||
            (tag && (!f->tag || f->tag[i] != tag)) || !in_region(b, f, r, i))
            continue;
        lua_pushinteger(L, i);
        lua_rawseti(L, list, ++n);
    }
    vm_charge(L, (r->shape == REGION_LINE ? A_LINE : 1) * (uint64_t)f->s->live + sort_work((uint64_t)n));
    sort_near(L, list, n, f, r->x, r->y);
    for (lua_Integer i = 1; i <= n; i++) {
        lua_rawgeti(L, list, i);
        lua_pushinteger(L, board_handle(b, f->kind, (int32_t)lua_tointeger(L, -1)));
        lua_rawseti(L, list, i);
        lua_pop(L, 1);
    }
    return 1;
}

static int query(lua_State *L, struct board *b, const char *entry, const struct api_value *what,
                 const struct api_value *tag, const struct api_value place[REGION_PARAMS])
{
    struct field f = field_named(L, b, entry, lua_tostring(L, what->at));
    uint32_t number = tag->given ? api_tag(L, entry, tag->at) : 0;
    struct api_region r;
    bool there = api_region(L, b, entry, place, &r);

    return found(L, b, &f, number, &r, there);
}

/* Calls are folded with the indices of their arguments, so newer parameters come last, to keep old demos valid. */
enum { NEAR_WHAT, NEAR_X, NEAR_Y, NEAR_RADIUS, NEAR_TAG, NEAR_FROM, NEAR_DX, NEAR_DY };

static const struct api_param near[] = {
    PARAM("what", A_STR, REQ, 0, 0, NULL, NULL, "what to look for: bullet, shot, enemy, item, laser or player"),
    PARAM("x", A_FX, OPT, -WORLD, WORLD, "px", NULL, "horizontal position in the field; give `x` and `y`, or `from`"),
    PARAM("y", A_FX, OPT, -WORLD, WORLD, "px", NULL, "vertical position in the field"),
    SHAPE_CIRCLE_PARAMS(REQ, 32767),
    PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "return only things with this tag"),
    PARAM("from", A_THING, OPT, PLACES, 0, NULL, NULL, "thing whose position is used instead of `x` and `y`"),
    PARAM("dx", A_FX, OPT, -WORLD, WORLD, "px", "0", "distance added to `x`, or to the position of `from`"),
    PARAM("dy", A_FX, OPT, -WORLD, WORLD, "px", "0", "distance added to `y`, or to the position of `from`"),
};

static int query_near(lua_State *L, struct board *b, struct api_value *v)
{
    const struct api_value place[REGION_PARAMS] = { v[NEAR_X],  v[NEAR_Y],  v[NEAR_FROM],
                                                    v[NEAR_DX], v[NEAR_DY], v[NEAR_RADIUS] };

    return query(L, b, "query.near", &v[NEAR_WHAT], &v[NEAR_TAG], place);
}

/* Indices of the parameters of query.box and query.line; the parameters of the shape come last. */
enum { ARG_WHAT, ARG_TAG, ARG_PLACE, ARG_SHAPE = ARG_PLACE + PLACE_PARAMS };
#define ASKED                                                                                                          \
    PARAM("what", A_STR, REQ, 0, 0, NULL, NULL, "what to look for: bullet, shot, enemy, item, laser or player"),       \
        PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "return only things with this tag"), PLACE

static const struct api_param box[] = { ASKED, SHAPE_BOX_PARAMS(REQ) };
static const struct api_param line[] = { ASKED, SHAPE_LINE_PARAMS(REQ) };

static int query_box(lua_State *L, struct board *b, struct api_value *v)
{
    struct api_value place[REGION_PARAMS] = { { 0 } };

    memcpy(place, v + ARG_PLACE, PLACE_PARAMS * sizeof *v);
    memcpy(place + REGION_W, v + ARG_SHAPE, 2 * sizeof *v);
    return query(L, b, "query.box", &v[ARG_WHAT], &v[ARG_TAG], place);
}

static int query_line(lua_State *L, struct board *b, struct api_value *v)
{
    struct api_value place[REGION_PARAMS] = { { 0 } };

    memcpy(place, v + ARG_PLACE, PLACE_PARAMS * sizeof *v);
    memcpy(place + REGION_TO_X, v + ARG_SHAPE, 3 * sizeof *v);
    return query(L, b, "query.line", &v[ARG_WHAT], &v[ARG_TAG], place);
}

static const struct api_entry entries[] = {
    { "query.near", query_near, PARAMS(near), 0, API_CHANGES, "list",
      HELP("returns the things in a circle, nearest first") },
    { "query.box", query_box, PARAMS(box), 0, API_CHANGES, "list",
      HELP("returns the things in a box, nearest to its centre first") },
    { "query.line", query_line, PARAMS(line), 0, API_CHANGES, "list",
      HELP("returns the things along a line, nearest to its start first") },
};
const struct api_module api_query = { entries, sizeof entries / sizeof *entries };
