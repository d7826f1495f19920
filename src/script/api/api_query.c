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

/* A pool to search: its positions (for lasers, of their heads) and tags. */
struct search_pool {
    enum handle_kind kind;
    const struct slots *s;
    const fx *x, *y;
    const uint16_t *tag;
};

static struct search_pool find_pool(lua_State *L, struct board *b, const char *entry, const char *name)
{
    const struct search_pool pools[] = {
        { H_BULLET, &b->bullets.s, b->bullets.x, b->bullets.y, b->bullets.tag },
        { H_SHOT, &b->shots.s, b->shots.x, b->shots.y, b->shots.tag },
        { H_ENEMY, &b->enemies.s, b->enemies.x, b->enemies.y, b->enemies.tag },
        { H_ITEM, &b->items.s, b->items.x, b->items.y, b->items.tag },
        { H_LASER, &b->lasers.s, b->laser_heads.x, b->laser_heads.y, b->laser_heads.tag },
        { H_PLAYER, &b->player.s, b->player.x, b->player.y, NULL },
    };
    const size_t n = sizeof pools / sizeof *pools;
    size_t i = 0;

    while (i < n && strcmp(api_get_table(L)->things[pools[i].kind]->name, name) != 0)
        i++;
    if (i == n)
        api_error(L, entry, "what: expected bullet, enemy, item, laser, shot or player, got \"%s\"", name);
    if (api_disabled_reason(&b->cart.manifest, name))
        api_error(L, entry, "what: " API_DISABLED_FORMAT, api_disabled_reason(&b->cart.manifest, name));
    return pools[i];
}

/* An entity that was found. */
struct found {
    uint64_t distance_sq, slot;
};

static bool precedes(const struct found *a, const struct found *b)
{
    return a->distance_sq < b->distance_sq || (a->distance_sq == b->distance_sq && a->slot < b->slot);
}

static void swap(struct found *a, struct found *b)
{
    const struct found c = *a;

    *a = *b;
    *b = c;
}

/* Sinks element i of a heap of n elements, whose root comes last in order. */
static void sift_down(struct found *heap, size_t i, size_t n)
{
    for (size_t child = 2 * i + 1; child < n; i = child, child = 2 * i + 1) {
        child += child + 1 < n && precedes(&heap[child], &heap[child + 1]);
        if (!precedes(&heap[i], &heap[child]))
            return;
        swap(&heap[i], &heap[child]);
    }
}

/* Sorts by distance, then slot. Heapsort is in place and has no quadratic worst case. */
static void sort_by_distance(struct found *list, size_t n)
{
    for (size_t i = n / 2; i-- > 0;)
        sift_down(list, i, n);
    for (; n > 1; n--) {
        swap(&list[0], &list[n - 1]);
        sift_down(list, 0, n - 1);
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

/* Returns the square of the distance from entity i to the region's position; for a laser, from its nearest point. */
static uint64_t distance_squared(const struct board *b, const struct search_pool *f, const struct api_region *r,
                                 uint32_t i)
{
    fx x = f->x[i], y = f->y[i];

    if (f->kind == H_LASER)
        lasers_get_nearest_point(b, i, r->x, r->y, &x, &y);
    const int64_t dx = (int64_t)x - r->x, dy = (int64_t)y - r->y;
    return (uint64_t)(dx * dx) + (uint64_t)(dy * dy);
}

/* Returns the work of sort_by_distance for n entries. */
static uint64_t compute_sort_work(uint64_t n)
{
    uint64_t levels = 0;

    while (n >> levels)
        levels++;
    return n * (ENTRY_WORK + LEVEL_WORK * levels);
}

/* Pushes the list of entities in the region, nearest to the region's position first. */
static void push_found_entities(lua_State *L, struct board *b, const struct search_pool *f, uint32_t tag,
                                const struct api_region *r)
{
    const uint32_t end = f->s->live_bits ? f->s->top : f->s->live;
    luaL_Buffer buffer;

    lua_pushnil(L); /* replaced by the list, below the buffer */
    const int at = lua_gettop(L);
    luaL_buffinit(L, &buffer);
    for (uint32_t i = slots_next(f->s, 0); i < end; i = slots_next(f->s, i + 1)) {
        if (f->kind == H_LASER)
            vm_charge(L, CORNER_WORK * (uint64_t)lasers_corner_count(b, i));
        if ((tag && (!f->tag || f->tag[i] != tag)) || !is_in_region(b, f, r, i) ||
            !board_is_alive(b, board_handle(b, f->kind, (int32_t)i)))
            continue;
        const struct found e = { distance_squared(b, f, r, i), i };
        luaL_addlstring(&buffer, (const char *)&e, sizeof e);
    }
    const size_t size = luaL_bufflen(&buffer), n = size / sizeof(struct found);
    struct found *found = (struct found *)(void *)luaL_buffaddr(&buffer);
    vm_charge(L, (r->shape == REGION_LINE ? LINE_WORK : 1) * (uint64_t)f->s->live + compute_sort_work(n));
    sort_by_distance(found, n);
    lua_createtable(L, (int)n, 0);
    lua_replace(L, at);
    for (size_t i = 0; i < n; i++) {
        lua_pushinteger(L, board_handle(b, f->kind, (int32_t)found[i].slot));
        lua_rawseti(L, at, (lua_Integer)i + 1);
    }
    luaL_buffsub(&buffer, size);
    luaL_pushresult(&buffer); /* frees the buffer; a function that returns with an open one loses its caller's locals */
    lua_pop(L, 1);
}

static int run_query(lua_State *L, struct board *b, const char *entry, const struct api_value *pool,
                     const struct api_value *tag, const struct api_value region_args[REGION_PARAM_COUNT])
{
    struct search_pool f = find_pool(L, b, entry, lua_tostring(L, pool->at));
    uint32_t tag_number = api_read_tag(L, entry, tag);
    struct api_region r;

    if (api_read_region(L, b, entry, region_args, &r))
        push_found_entities(L, b, &f, tag_number, &r);
    else
        lua_newtable(L);
    return 1;
}

/* Calls are folded with the indices of their arguments, so newer parameters come last, to keep old demos valid. */
enum { NEAR_POOL, NEAR_X, NEAR_Y, NEAR_RADIUS, NEAR_TAG, NEAR_FROM, NEAR_DX, NEAR_DY };

static const struct api_param near_params[] = {
    REQUIRED("what", A_STR, "what to look for: bullet, shot, enemy, item, laser or player"),
    COORDINATE("x", A_FX, OPT, "horizontal position in the field; give `x` and `y`, or `from`"),
    COORDINATE("y", A_FX, OPT, "vertical position in the field"),
    SHAPE_CIRCLE_PARAMS(REQ, 32767),
    LABEL("tag", OPT, "return only things with this tag"),
    FROM_PARAMS,
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
    REQUIRED("what", A_STR, "what to look for: bullet, shot, enemy, item, laser or player"),                           \
        LABEL("tag", OPT, "return only things with this tag"), POSITION_PARAMS

static const struct api_param box_params[] = { TARGET_PARAMS, SHAPE_BOX_PARAMS(REQ) };
static const struct api_param line_params[] = { TARGET_PARAMS, SHAPE_LINE_PARAMS(REQ) };

static int query_box_or_line(lua_State *L, struct board *b, struct api_value *v)
{
    const char *entry = api_current_binding(L)->entry->name;
    const bool is_line = !strcmp(entry, "query.line");
    struct api_value region_args[REGION_PARAM_COUNT] = { { 0 } };

    memcpy(region_args, v + ARG_POSITION, POSITION_PARAM_COUNT * sizeof *v);
    memcpy(region_args + (is_line ? REGION_TO_X : REGION_W), v + ARG_SHAPE, (is_line ? 3 : 2) * sizeof *v);
    return run_query(L, b, entry, &v[ARG_POOL], &v[ARG_TAG], region_args);
}

static const struct api_entry entries[] = {
    { "query.near", query_near, PARAMS(near_params), 0, API_CHANGES, "list",
      HELP("returns the things in a circle, nearest first") },
    { "query.box", query_box_or_line, PARAMS(box_params), 0, API_CHANGES, "list",
      HELP("returns the things in a box, nearest to its centre first") },
    { "query.line", query_box_or_line, PARAMS(line_params), 0, API_CHANGES, "list",
      HELP("returns the things along a line, nearest to its start first") },
};
const struct api_module api_query = { entries, sizeof entries / sizeof *entries };
