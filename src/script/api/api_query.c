/*
 * api_query.c - the Lua table query; and api_read_position, which reads the position of every fire, spawn and burst.
 */
#include <string.h>
#include "../../machine/lasers_run.h"
#include "api_parts.h"

bool api_read_position(lua_State *L, struct board *b, const char *entry, const struct api_value *v, fx *x, fx *y)
{
    const struct api_value *from = &v[POSITION_FROM];

    if (from->given ? v[POSITION_X].given || v[POSITION_Y].given : !(v[POSITION_X].given && v[POSITION_Y].given)) {
        if (from->given || v[POSITION_X].given || v[POSITION_Y].given)
            return api_error(L, entry, "place: expected either `x` and `y`, or `from`");
        return api_error(L, entry, "place: expected `x` and `y`, or `from` (a thing), got neither");
    }
    if (!from->given) {
        *x = v[POSITION_X].f;
        *y = v[POSITION_Y].f;
    } else if (!board_get_position(b, from->i, x, y))
        return false;
    *x = motion_shift(*x, v[POSITION_DX].f);
    *y = motion_shift(*y, v[POSITION_DY].f);
    return true;
}

/* A pool to search: its positions and tags. For lasers, x and y are NULL until push_found_entities() computes the
 * positions. */
struct search_pool {
    enum handle_kind kind;
    const struct slots *s;
    const fx *x, *y;
    const uint16_t *tag;
    const uint8_t *in_game;
};

static struct search_pool find_pool(lua_State *L, struct board *b, const char *entry, const char *pool_name)
{
    if (!strcmp(pool_name, "bullet"))
        return (struct search_pool){ H_BULLET, &b->bullets.s, b->bullets.x, b->bullets.y, b->bullets.tag, NULL };
    if (!strcmp(pool_name, "shot"))
        return (struct search_pool){ H_SHOT, &b->shots.s, b->shots.x, b->shots.y, b->shots.tag, NULL };
    if (!strcmp(pool_name, "enemy"))
        return (struct search_pool){ H_ENEMY, &b->enemies.s, b->enemies.x, b->enemies.y, b->enemies.tag, NULL };
    if ((!strcmp(pool_name, "item") || !strcmp(pool_name, "laser")) &&
        api_disabled_reason(&b->cart.manifest, pool_name))
        api_error(L, entry, "what: " API_DISABLED_FORMAT, api_disabled_reason(&b->cart.manifest, pool_name));
    if (!strcmp(pool_name, "item"))
        return (struct search_pool){ H_ITEM, &b->items.s, b->items.x, b->items.y, b->items.tag, NULL };
    if (!strcmp(pool_name, "laser"))
        return (struct search_pool){ H_LASER, &b->lasers.s, NULL, NULL, b->laser_heads.tag, NULL };
    if (strcmp(pool_name, "player"))
        api_error(L, entry, "what: expected bullet, enemy, item, laser, shot or player, got \"%s\"", pool_name);
    return (struct search_pool){ H_PLAYER, &b->player.s, b->player.x, b->player.y, NULL, b->player.in_game };
}

static uint64_t distance_squared(const struct search_pool *f, uint32_t i, fx x, fx y)
{
    int64_t dx = (int64_t)f->x[i] - x, dy = (int64_t)f->y[i] - y;

    return (uint64_t)(dx * dx) + (uint64_t)(dy * dy);
}

/* Sinks element i of the heap in the list of slots at `list` (1..n), ordered by distance, then slot. Heapsort in place,
 * which has no quadratic worst case. */
static void sift_down(lua_State *L, int list, lua_Integer i, lua_Integer n, const struct search_pool *f, fx x, fx y)
{
    for (;;) {
        lua_Integer farthest = i;
        for (lua_Integer c = 2 * i; c <= 2 * i + 1 && c <= n; c++) {
            lua_rawgeti(L, list, farthest);
            lua_rawgeti(L, list, c);
            uint32_t s = (uint32_t)lua_tointeger(L, -2), t = (uint32_t)lua_tointeger(L, -1);
            uint64_t ds = distance_squared(f, s, x, y), dt = distance_squared(f, t, x, y);
            lua_pop(L, 2);
            if (dt > ds || (dt == ds && t > s))
                farthest = c;
        }
        if (farthest == i)
            return;
        lua_rawgeti(L, list, i);
        lua_rawgeti(L, list, farthest);
        lua_rawseti(L, list, i);
        lua_rawseti(L, list, farthest);
        i = farthest;
    }
}

static void sort_by_distance(lua_State *L, int list, lua_Integer n, const struct search_pool *f, fx x, fx y)
{
    for (lua_Integer i = n / 2; i >= 1; i--)
        sift_down(L, list, i, n, f, x, y);
    for (lua_Integer end = n; end > 1; end--) {
        lua_rawgeti(L, list, 1);
        lua_rawgeti(L, list, end);
        lua_rawseti(L, list, 1);
        lua_rawseti(L, list, end);
        sift_down(L, list, 1, end - 1, f, x, y);
    }
}

static bool is_in_region(const struct board *b, const struct search_pool *f, const struct api_region *r, uint32_t i)
{
    return f->kind == H_LASER ? api_region_touches_laser(b, r, i) : api_region_contains(r, f->x[i], f->y[i]);
}

enum {
    CORNER_WORK = 3,
    LINE_WORK = 3,
    ENTRY_WORK = 12,
    LEVEL_WORK = 6 /* work per corner, per line, per sorted entry, and per entry and level */
};

/* Sets f's position of each laser to the point of the laser nearest to the region's position. Leaves the userdata that
 * holds the positions on the stack. */
static void locate_lasers(lua_State *L, const struct board *b, struct search_pool *f, const struct api_region *r)
{
    const uint32_t n = f->s->top;
    fx *x = lua_newuserdatauv(L, 2 * (n ? n : 1) * sizeof *x, 0), *y = x + n;

    EACH_LIVE (i, f->s) {
        lasers_get_nearest_point(b, i, r->x, r->y, &x[i], &y[i]);
        vm_charge(L, CORNER_WORK * (uint64_t)lasers_corner_count(b, i));
    }
    f->x = x;
    f->y = y;
}

/* Returns the work of sort_by_distance for n entries. */
static uint64_t compute_sort_work(uint64_t n)
{
    uint64_t levels = 0;

    while (n >> levels)
        levels++;
    return n * (ENTRY_WORK + LEVEL_WORK * levels);
}

/* Pushes the list of entities in the region, nearest to the region's position first, or an empty list if `has_position`
 * is false. */
static int push_found_entities(lua_State *L, struct board *b, struct search_pool *f, uint32_t tag,
                               const struct api_region *r, bool has_position)
{
    uint32_t end = has_position ? f->s->live_bits ? f->s->top : f->s->live : 0;
    lua_Integer n = 0;

    if (f->kind == H_LASER)
        locate_lasers(L, b, f, r);
    lua_newtable(L);
    int list = lua_gettop(L);
    for (uint32_t i = slots_next(f->s, 0); i < end; i = slots_next(f->s, i + 1)) {
        if ((f->in_game && !f->in_game[i]) || !board_is_alive(b, board_handle(b, f->kind, (int32_t)i)) ||
            (tag && (!f->tag || f->tag[i] != tag)) || !is_in_region(b, f, r, i))
            continue;
        lua_pushinteger(L, i);
        lua_rawseti(L, list, ++n);
    }
    vm_charge(L, (r->shape == REGION_LINE ? LINE_WORK : 1) * (uint64_t)f->s->live + compute_sort_work((uint64_t)n));
    sort_by_distance(L, list, n, f, r->x, r->y);
    for (lua_Integer i = 1; i <= n; i++) {
        lua_rawgeti(L, list, i);
        lua_pushinteger(L, board_handle(b, f->kind, (int32_t)lua_tointeger(L, -1)));
        lua_rawseti(L, list, i);
        lua_pop(L, 1);
    }
    return 1;
}

static int run_query(lua_State *L, struct board *b, const char *entry, const struct api_value *pool,
                     const struct api_value *tag, const struct api_value region_args[REGION_PARAM_COUNT])
{
    struct search_pool f = find_pool(L, b, entry, lua_tostring(L, pool->at));
    uint32_t tag_number = api_read_tag(L, entry, tag);
    struct api_region r;
    bool has_position = api_read_region(L, b, entry, region_args, &r);

    return push_found_entities(L, b, &f, tag_number, &r, has_position);
}

/* Calls are folded with the indices of their arguments, so newer parameters come last, to keep old demos valid. */
enum { NEAR_POOL, NEAR_X, NEAR_Y, NEAR_RADIUS, NEAR_TAG, NEAR_FROM, NEAR_DX, NEAR_DY };

static const struct api_param near_params[] = {
    PARAM("what", A_STR, REQ, 0, 0, NULL, NULL, "what to look for: bullet, shot, enemy, item, laser or player"),
    PARAM("x", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", NULL,
          "horizontal position in the field; give `x` and `y`, or `from`"),
    PARAM("y", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", NULL, "vertical position in the field"),
    SHAPE_CIRCLE_PARAMS(REQ, 32767),
    PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "return only things with this tag"),
    PARAM("from", A_THING, OPT, POSITION_HANDLE_KINDS, 0, NULL, NULL,
          "thing whose position is used instead of `x` and `y`"),
    PARAM("dx", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", "0", "distance added to `x`, or to the position of `from`"),
    PARAM("dy", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", "0", "distance added to `y`, or to the position of `from`"),
};

static int query_near(lua_State *L, struct board *b, struct api_value *v)
{
    const struct api_value region_args[REGION_PARAM_COUNT] = { v[NEAR_X],  v[NEAR_Y],  v[NEAR_FROM],
                                                               v[NEAR_DX], v[NEAR_DY], v[NEAR_RADIUS] };

    return run_query(L, b, "query.near", &v[NEAR_POOL], &v[NEAR_TAG], region_args);
}

/* Indices of the parameters of query.box and query.line; the parameters of the shape come last. */
enum { ARG_POOL, ARG_TAG, ARG_POSITION, ARG_SHAPE = ARG_POSITION + POSITION_PARAM_COUNT };
#define TARGET_PARAMS                                                                                                  \
    PARAM("what", A_STR, REQ, 0, 0, NULL, NULL, "what to look for: bullet, shot, enemy, item, laser or player"),       \
        PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "return only things with this tag"), POSITION_PARAMS

static const struct api_param box_params[] = { TARGET_PARAMS, SHAPE_BOX_PARAMS(REQ) };
static const struct api_param line_params[] = { TARGET_PARAMS, SHAPE_LINE_PARAMS(REQ) };

static int query_box(lua_State *L, struct board *b, struct api_value *v)
{
    struct api_value region_args[REGION_PARAM_COUNT] = { { 0 } };

    memcpy(region_args, v + ARG_POSITION, POSITION_PARAM_COUNT * sizeof *v);
    memcpy(region_args + REGION_W, v + ARG_SHAPE, 2 * sizeof *v);
    return run_query(L, b, "query.box", &v[ARG_POOL], &v[ARG_TAG], region_args);
}

static int query_line(lua_State *L, struct board *b, struct api_value *v)
{
    struct api_value region_args[REGION_PARAM_COUNT] = { { 0 } };

    memcpy(region_args, v + ARG_POSITION, POSITION_PARAM_COUNT * sizeof *v);
    memcpy(region_args + REGION_TO_X, v + ARG_SHAPE, 3 * sizeof *v);
    return run_query(L, b, "query.line", &v[ARG_POOL], &v[ARG_TAG], region_args);
}

static const struct api_entry entries[] = {
    { "query.near", query_near, PARAMS(near_params), 0, API_CHANGES, "list",
      HELP("returns the things in a circle, nearest first") },
    { "query.box", query_box, PARAMS(box_params), 0, API_CHANGES, "list",
      HELP("returns the things in a box, nearest to its centre first") },
    { "query.line", query_line, PARAMS(line_params), 0, API_CHANGES, "list",
      HELP("returns the things along a line, nearest to its start first") },
};
const struct api_module api_query = { entries, sizeof entries / sizeof *entries };
