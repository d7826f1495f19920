/*
 * api_region.c - regions, described by a position and shape arguments, and clearing the bullets, shots and lasers in a
 * region.
 */
#include "../../base/geom.h"
#include "../../entities/sparks.h"
#include "../../machine/lasers_run.h"
#include "api_parts.h"

static bool are_all_given(const struct api_value *v, int first, int n)
{
    for (int i = first; i < first + n; i++)
        if (!v[i].given)
            return false;
    return true;
}

static bool is_any_given(const struct api_value *v, int first, int n)
{
    for (int i = first; i < first + n; i++)
        if (v[i].given)
            return true;
    return false;
}

enum { BOX_ARG_COUNT = 2, LINE_ARG_COUNT = 3 };

/* Returns the shape whose arguments are given; raises an error for arguments of several shapes, or for only some of the
 * arguments of one shape. */
static enum api_region_shape find_shape(lua_State *L, const char *entry, const struct api_value *v)
{
    bool has_circle = v[REGION_RADIUS].given, has_box = is_any_given(v, REGION_W, BOX_ARG_COUNT),
         has_line = is_any_given(v, REGION_TO_X, LINE_ARG_COUNT);

    if (has_circle + has_box + has_line > 1)
        api_error(L, entry,
                  "shape: expected `radius`, or `w` and `h`, or `to_x`, `to_y` and `width`, got arguments of %s",
                  !has_box      ? "a circle and a line"
                  : !has_line   ? "a circle and a box"
                  : !has_circle ? "a box and a line"
                                : "all three");
    if (has_box && !are_all_given(v, REGION_W, BOX_ARG_COUNT))
        api_error(L, entry, "shape: expected both `w` and `h`, got only `%s`", v[REGION_W].given ? "w" : "h");
    if (has_line && !are_all_given(v, REGION_TO_X, LINE_ARG_COUNT))
        api_error(L, entry, "shape: expected all of `to_x`, `to_y` and `width`, got no `%s`",
                  !v[REGION_TO_X].given   ? "to_x"
                  : !v[REGION_TO_Y].given ? "to_y"
                                          : "width");
    return has_circle ? REGION_CIRCLE : has_box ? REGION_BOX : has_line ? REGION_LINE : REGION_ALL;
}

bool api_read_region(lua_State *L, struct board *b, const char *entry, const struct api_value *v, struct api_region *r)
{
    *r = (struct api_region){ .shape = find_shape(L, entry, v) };
    if (r->shape == REGION_ALL) {
        if (is_any_given(v, 0, POSITION_PARAM_COUNT))
            api_error(L, entry,
                      "shape: expected `radius`, or `w` and `h`, or `to_x`, `to_y` and `width`, got only a place");
        return true;
    }
    if (!api_read_position(L, b, entry, v, &r->x, &r->y))
        return false;
    r->a = r->shape == REGION_CIRCLE ? v[REGION_RADIUS].f : v[r->shape == REGION_BOX ? REGION_W : REGION_WIDTH].f / 2;
    r->b = v[REGION_H].f / 2;
    r->to_x = v[REGION_TO_X].f;
    r->to_y = v[REGION_TO_Y].f;
    return true;
}

bool api_region_contains(const struct api_region *r, fx x, fx y)
{
    switch (r->shape) {
    case REGION_CIRCLE:
        return geom_circles(x, y, r->x, r->y, r->a);
    case REGION_BOX:
        return geom_boxes(r->x, r->y, r->a, r->b, x, y, 0, 0);
    case REGION_LINE:
        return geom_capsule_circle(r->x, r->y, r->to_x, r->to_y, r->a, x, y, 0);
    default:
        return true;
    }
}

bool api_region_touches_laser(const struct board *b, const struct api_region *r, uint32_t i)
{
    switch (r->shape) {
    case REGION_CIRCLE:
        return lasers_overlap_circle(b, i, r->x, r->y, r->a);
    case REGION_BOX:
        return lasers_overlap_box(b, i, r->x, r->y, r->a, r->b);
    case REGION_LINE:
        return lasers_overlap_line(b, i, r->x, r->y, r->to_x, r->to_y, r->a);
    default:
        return true;
    }
}

/* ---- clears ---- */

static const struct bullet_kinds *get_bullet_kinds(const struct board *b, const struct bullets *s)
{
    return s == &b->bullets ? &b->bullet_kinds : &b->shot_kinds;
}

/* Emits the spark of a cleared bullet: the spark `spark` or, if not given, the one of the bullet's kind. */
static void leave_spark(struct board *b, const struct bullets *s, const struct api_value *spark, uint32_t i)
{
    if (spark->given)
        board_burst_sparks(b, &(struct spark_burst){ .x = s->x[i], .y = s->y[i], .kind = (uint16_t)spark->i, .n = 1 });
    else if (s == &b->bullets)
        board_spawn_vanish_spark(b, i);
}

/* Spawns the item a cleared bullet turns into, if one is given. */
static void leave_item(struct board *b, const struct bullets *s, const struct api_value *item, uint32_t i)
{
    if (item->given)
        board_replace_with_item(b, (uint16_t)item->i, s->x[i], s->y[i]);
}

/* A clear removes entities that have the tag (0: any), are in the region, and are clearable unless `include_fixed`. */
struct clear_filter {
    struct api_region region;
    const struct api_value *spark, *item; /* arguments as given */
    uint32_t tag;
    bool include_fixed;
};

static bool matches_filter(const struct board *b, const struct bullets *s, const struct clear_filter *c, uint32_t i)
{
    const struct bullet_kinds *kinds = get_bullet_kinds(b, s);

    return api_has_tag(s->tag, i, c->tag) && api_region_contains(&c->region, s->x[i], s->y[i]) &&
           (c->include_fixed || !(kinds->flags[bullets_kind(s, kinds, i)] & KIND_FIXED));
}

enum { LINE_WORK = 3, CLEAR_WORK = 10 /* work: per bullet tested against a line; per bullet cleared */ };

/* Removes the matching bullets and returns how many. Also releases, without counting them, matching held bullets (those
 * that left the field this frame), so their pending hits have no effect. */
static lua_Integer clear_bullets(lua_State *L, struct board *b, struct bullets *s, const struct clear_filter *c)
{
    lua_Integer n = 0;

    vm_charge(L, (c->region.shape == REGION_LINE ? LINE_WORK : 1) * (uint64_t)s->s.live);
    EACH_LIVE (i, &s->s) {
        if (!matches_filter(b, s, c, i))
            continue;
        leave_spark(b, s, c->spark, i);
        leave_item(b, s, c->item, i);
        bullets_drop(s, i);
        n++;
    }
    vm_charge(L, CLEAR_WORK * (uint64_t)n);
    EACH_HELD (i, &s->s)
        if (matches_filter(b, s, c, i))
            bullets_release(s, i);
    return n;
}

/* Calls are folded with the indices of their arguments, so newer parameters come last, to keep old demos valid. */
enum {
    C_TAG,
    C_X,
    C_Y,
    C_RADIUS,
    C_SPARK,
    C_FROM,
    C_DX,
    C_DY,
    C_W,
    C_H,
    C_TO_X,
    C_TO_Y,
    C_WIDTH,
    C_ALL,
    C_ITEMS,
    C_LASERS,
    C_EVERY = C_LASERS
};

/* Parameters that all clears of bullets and of lasers share. */
#define COMMON_CLEAR_PARAMS                                                                                            \
    PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "remove only things with this tag"),                                   \
        PARAM("x", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", NULL,                                                     \
              "horizontal position of the shape; give `x` and `y`, or `from`"),                                        \
        PARAM("y", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", NULL, "vertical position of the shape"),                  \
        SHAPE_CIRCLE_PARAMS(OPT, MAX_SPEED),                                                                           \
        PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark to leave behind; overrides `vanish`"),      \
        PARAM("from", A_THING, OPT, POSITION_HANDLE_KINDS, 0, NULL, NULL,                                              \
              "thing whose position is used instead of `x` and `y`"),                                                  \
        PARAM("dx", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", "0",                                                     \
              "distance added to `x`, or to the position of `from`"),                                                  \
        PARAM("dy", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", "0",                                                     \
              "distance added to `y`, or to the position of `from`"),                                                  \
        SHAPE_BOX_PARAMS(OPT), SHAPE_LINE_PARAMS(OPT),                                                                 \
        PARAM("all", A_BOOL, OPT, 0, 0, NULL, "false", "also remove kinds with `clearable = false`"),                  \
        PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, "kind of item that replaces each thing removed")

const struct api_param api_bullet_clear_params[BULLET_CLEAR_PARAM_COUNT] = {
    COMMON_CLEAR_PARAMS,
    PARAM("lasers", A_BOOL, OPT, 0, 0, NULL, "true",
          "also remove enemy lasers; with a shape, only lasers that touch it"),
};

/* ---- clearing lasers ---- */

enum { DEFAULT_REMAINS_SPACING = 12 /* px between the sparks and items along a cleared laser */ };

/* The spark and item a cleared laser leaves. */
struct remains {
    bool has_spark;
    uint16_t spark_kind;
    const struct api_value *item;
};

/* Emits the spark and spawns the item at one position on a cleared laser. */
static void leave_remains(struct board *b, fx x, fx y, void *context)
{
    const struct remains *r = context;

    if (r->has_spark)
        board_burst_sparks(b, &(struct spark_burst){ .x = x, .y = y, .kind = r->spark_kind, .n = 1 });
    if (r->item->given)
        board_replace_with_item(b, (uint16_t)r->item->i, x, y);
}

/* Removes the whole of laser i. Every `spacing` px along it, emits the given spark (otherwise the one of its kind) and
 * spawns the given item, if any. */
static void clear_laser(lua_State *L, struct board *b, uint32_t i, const struct api_value *spark,
                        const struct api_value *item, fx spacing)
{
    const uint16_t vanish = b->laser_kinds.vanish_spark[b->laser_heads.kind[i]];
    struct remains r = { spark->given || vanish, (uint16_t)(spark->given ? spark->i : vanish - 1), item };

    vm_charge(L, lasers_corner_count(b, i));
    if (r.has_spark || item->given)
        vm_charge(L, lasers_visit_positions(b, i, spacing, leave_remains, &r));
    lasers_remove(b, i);
}

/* Removes the lasers that match c and returns how many; includes players' lasers only if `include_player_lasers`. */
static lua_Integer clear_lasers(lua_State *L, struct board *b, const struct clear_filter *c, fx spacing,
                                bool include_player_lasers)
{
    const struct laser_kinds *kinds = &b->laser_kinds;
    lua_Integer n = 0;

    EACH_LIVE (i, &b->lasers.s) {
        const unsigned flags = kinds->flags[b->laser_heads.kind[i]];
        vm_charge(L, lasers_corner_count(b, i));
        if (!api_has_tag(b->laser_heads.tag, i, c->tag) || (flags & LASER_HITS_ENEMIES && !include_player_lasers) ||
            (flags & LASER_FIXED && !c->include_fixed) || !api_region_touches_laser(b, &c->region, i))
            continue;
        clear_laser(L, b, i, c->spark, c->item, spacing);
        n++;
    }
    return n;
}

int api_bullet_clear(lua_State *L, struct board *b, struct api_value *v)
{
    const struct api_value region_args[REGION_PARAM_COUNT] = { v[C_X],    v[C_Y],      v[C_FROM], v[C_DX],
                                                               v[C_DY],   v[C_RADIUS], v[C_W],    v[C_H],
                                                               v[C_TO_X], v[C_TO_Y],   v[C_WIDTH] };
    struct clear_filter c = { .spark = &v[C_SPARK], .item = &v[C_ITEMS], .include_fixed = v[C_ALL].i };

    if (v[C_TAG].given)
        c.tag = api_intern_tag(L, "bullet.clear", v[C_TAG].at);
    bool has_position = api_read_region(L, b, "bullet.clear", region_args, &c.region);
    lua_Integer n = has_position ? clear_bullets(L, b, &b->bullets, &c) : 0;
    if (has_position && v[C_LASERS].i)
        n += clear_lasers(L, b, &c, DEFAULT_REMAINS_SPACING << 16, false);
    lua_pushinteger(L, n);
    return 1;
}

enum {
    ARG_SELF,
    ARG_SPARK,
    SELF_ITEMS,
    ARG_POSITION = SELF_ITEMS,
    ARG_ALL = ARG_POSITION + REGION_PARAM_COUNT,
    ARG_ITEMS
};

const struct api_param api_bullet_clear_self_params[BULLET_CLEAR_SELF_PARAM_COUNT] = {
    PARAM("self", A_THING, REQ, 1 << H_BULLET | 1 << H_SHOT, 0, NULL, NULL, "the thing itself"),
    PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark to leave behind; overrides `vanish`"),
    PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, "kind of item that replaces it"),
};

int api_bullet_clear_self(lua_State *L, struct board *b, struct api_value *v)
{
    int64_t h = v[ARG_SELF].i;
    uint32_t i = handle_slot(h);
    struct bullets *s = handle_kind(h) == H_SHOT ? &b->shots : &b->bullets;

    (void)L;
    if (board_is_alive(b, h)) {
        leave_spark(b, s, &v[ARG_SPARK], i);
        leave_item(b, s, &v[SELF_ITEMS], i);
        bullets_drop(s, i);
    } else if (board_is_readable(b, h))
        bullets_release(s, handle_slot(h));
    return 0;
}

const struct api_param api_bullet_clear_group_params[BULLET_CLEAR_GROUP_PARAM_COUNT] = {
    PARAM("self", A_THING, REQ, 1 << H_GROUP | 1 << H_SHOTS, 0, NULL, NULL, "the group itself"),
    PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark to leave behind; overrides `vanish`"),
    POSITION_PARAMS,
    SHAPE_CIRCLE_PARAMS(OPT, MAX_SPEED),
    SHAPE_BOX_PARAMS(OPT),
    SHAPE_LINE_PARAMS(OPT),
    PARAM("all", A_BOOL, OPT, 0, 0, NULL, "false", "also remove kinds with `clearable = false`"),
    PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, "kind of item that replaces each thing removed"),
};

int api_bullet_clear_group(lua_State *L, struct board *b, struct api_value *v)
{
    bool is_shots = handle_kind(v[ARG_SELF].i) == H_SHOTS;
    struct clear_filter c = {
        .spark = &v[ARG_SPARK], .item = &v[ARG_ITEMS], .tag = handle_slot(v[ARG_SELF].i), .include_fixed = v[ARG_ALL].i
    };
    bool has_position = api_read_region(L, b, is_shots ? "shots:clear" : "group:clear", v + ARG_POSITION, &c.region);

    lua_pushinteger(L, has_position ? clear_bullets(L, b, is_shots ? &b->shots : &b->bullets, &c) : 0);
    return 1;
}

/* ---- laser.clear ---- */

#define EVERY_PARAM                                                                                                    \
    PARAM("every", A_FX, OPT, 1, LASER_MAX_SIZE, "px", "12",                                                           \
          "distance along the laser between the sparks or items it leaves")

const struct api_param api_laser_clear_params[LASER_CLEAR_PARAM_COUNT] = {
    COMMON_CLEAR_PARAMS,
    EVERY_PARAM,
};

int api_laser_clear(lua_State *L, struct board *b, struct api_value *v)
{
    const struct api_value region_args[REGION_PARAM_COUNT] = { v[C_X],    v[C_Y],      v[C_FROM], v[C_DX],
                                                               v[C_DY],   v[C_RADIUS], v[C_W],    v[C_H],
                                                               v[C_TO_X], v[C_TO_Y],   v[C_WIDTH] };
    struct clear_filter c = { .spark = &v[C_SPARK], .item = &v[C_ITEMS], .include_fixed = v[C_ALL].i };

    if (v[C_TAG].given)
        c.tag = api_intern_tag(L, "laser.clear", v[C_TAG].at);
    bool has_position = api_read_region(L, b, "laser.clear", region_args, &c.region);
    lua_pushinteger(L, has_position ? clear_lasers(L, b, &c, v[C_EVERY].f, false) : 0);
    return 1;
}

const struct api_param api_laser_clear_self_params[LASER_CLEAR_SELF_PARAM_COUNT] = {
    PARAM("self", A_THING, REQ, 1 << H_LASER, 0, NULL, NULL, "the laser itself"),
    PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark to leave behind; overrides `vanish`"),
    PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, "kind of item that replaces it"),
    EVERY_PARAM,
};

int api_laser_clear_self(lua_State *L, struct board *b, struct api_value *v)
{
    if (board_is_alive(b, v[ARG_SELF].i))
        clear_laser(L, b, handle_slot(v[ARG_SELF].i), &v[ARG_SPARK], &v[SELF_ITEMS], v[SELF_ITEMS + 1].f);
    return 0;
}

const struct api_param api_laser_clear_group_params[LASER_CLEAR_GROUP_PARAM_COUNT] = {
    PARAM("self", A_THING, REQ, 1 << H_LASERS, 0, NULL, NULL, "the group itself"),
    PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark to leave behind; overrides `vanish`"),
    POSITION_PARAMS,
    SHAPE_CIRCLE_PARAMS(OPT, MAX_SPEED),
    SHAPE_BOX_PARAMS(OPT),
    SHAPE_LINE_PARAMS(OPT),
    PARAM("all", A_BOOL, OPT, 0, 0, NULL, "false", "also remove kinds with `clearable = false`"),
    PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, "kind of item that replaces each thing removed"),
    EVERY_PARAM,
};

int api_laser_clear_group(lua_State *L, struct board *b, struct api_value *v)
{
    struct clear_filter c = {
        .spark = &v[ARG_SPARK], .item = &v[ARG_ITEMS], .tag = handle_slot(v[ARG_SELF].i), .include_fixed = v[ARG_ALL].i
    };
    bool has_position = api_read_region(L, b, "lasers:clear", v + ARG_POSITION, &c.region);

    lua_pushinteger(L, has_position ? clear_lasers(L, b, &c, v[ARG_ITEMS + 1].f, true) : 0);
    return 1;
}
