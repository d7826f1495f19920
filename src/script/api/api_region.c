/*
 * api_region.c - regions, described by a position and shape arguments, and clearing the bullets, shots and lasers in a
 * region.
 */
#include "../../base/geom.h"
#include "../../entities/sparks.h"
#include "../../machine/lasers_run.h"
#include "api_parts.h"

static bool all_given(const struct api_value *v, int first, int n)
{
    for (int i = first; i < first + n; i++)
        if (!v[i].given)
            return false;
    return true;
}

static bool any_given(const struct api_value *v, int first, int n)
{
    for (int i = first; i < first + n; i++)
        if (v[i].given)
            return true;
    return false;
}

enum { BOX_WORDS = 2, LINE_WORDS = 3 };

/* Returns the shape whose arguments are given; raises an error for arguments of several shapes, or for only some of the
 * arguments of one shape. */
static enum api_region_shape shape_given(lua_State *L, const char *entry, const struct api_value *v)
{
    bool circle = v[REGION_RADIUS].given, box = any_given(v, REGION_W, BOX_WORDS),
         line = any_given(v, REGION_TO_X, LINE_WORDS);

    if (circle + box + line > 1)
        api_error(L, entry,
                  "shape: expected `radius`, or `w` and `h`, or `to_x`, `to_y` and `width`, got arguments of %s",
                  !box      ? "a circle and a line"
                  : !line   ? "a circle and a box"
                  : !circle ? "a box and a line"
                            : "all three");
    if (box && !all_given(v, REGION_W, BOX_WORDS))
        api_error(L, entry, "shape: expected both `w` and `h`, got only `%s`", v[REGION_W].given ? "w" : "h");
    if (line && !all_given(v, REGION_TO_X, LINE_WORDS))
        api_error(L, entry, "shape: expected all of `to_x`, `to_y` and `width`, got no `%s`",
                  !v[REGION_TO_X].given   ? "to_x"
                  : !v[REGION_TO_Y].given ? "to_y"
                                          : "width");
    return circle ? REGION_CIRCLE : box ? REGION_BOX : line ? REGION_LINE : REGION_ALL;
}

bool api_region(lua_State *L, struct board *b, const char *entry, const struct api_value *v, struct api_region *r)
{
    *r = (struct api_region){ .shape = shape_given(L, entry, v) };
    if (r->shape == REGION_ALL) {
        if (any_given(v, 0, PLACE_PARAMS))
            api_error(L, entry,
                      "shape: expected `radius`, or `w` and `h`, or `to_x`, `to_y` and `width`, got only a place");
        return true;
    }
    if (!api_place(L, b, entry, v, &r->x, &r->y))
        return false;
    r->a = r->shape == REGION_CIRCLE ? v[REGION_RADIUS].f : v[r->shape == REGION_BOX ? REGION_W : REGION_WIDTH].f / 2;
    r->b = v[REGION_H].f / 2;
    r->to_x = v[REGION_TO_X].f;
    r->to_y = v[REGION_TO_Y].f;
    return true;
}

bool api_region_has(const struct api_region *r, fx x, fx y)
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

bool api_region_laser(const struct board *b, const struct api_region *r, uint32_t i)
{
    switch (r->shape) {
    case REGION_CIRCLE:
        return lasers_in_circle(b, i, r->x, r->y, r->a);
    case REGION_BOX:
        return lasers_in_box(b, i, r->x, r->y, r->a, r->b);
    case REGION_LINE:
        return lasers_in_line(b, i, r->x, r->y, r->to_x, r->to_y, r->a);
    default:
        return true;
    }
}

/* ---- clears ---- */

static const struct bullet_kinds *kinds_of(const struct board *b, const struct bullets *s)
{
    return s == &b->bullets ? &b->bullet_kinds : &b->shot_kinds;
}

/* Emits the spark of a cleared bullet: the spark `given` or, if not given, the one of the bullet's kind. */
static void leave_spark(struct board *b, const struct bullets *s, const struct api_value *given, uint32_t i)
{
    if (given->given)
        board_sparks(b, &(struct spark_burst){ .x = s->x[i], .y = s->y[i], .kind = (uint16_t)given->i, .n = 1 });
    else if (s == &b->bullets)
        board_vanish(b, i);
}

/* Spawns the item a cleared bullet turns into, if one is given. */
static void leave_item(struct board *b, const struct bullets *s, const struct api_value *given, uint32_t i)
{
    if (given->given)
        board_turn_into(b, (uint16_t)given->i, s->x[i], s->y[i]);
}

/* A clear removes entities that have the tag (0: any), are in the region, and are clearable unless `all`. */
struct clearing {
    struct api_region region;
    const struct api_value *spark, *items; /* arguments as given */
    uint32_t tag;
    bool all;
};

static bool takes(const struct board *b, const struct bullets *s, const struct clearing *c, uint32_t i)
{
    const struct bullet_kinds *kinds = kinds_of(b, s);

    return api_has_tag(s->tag, i, c->tag) && api_region_has(&c->region, s->x[i], s->y[i]) &&
           (c->all || !(kinds->flags[bullets_kind(s, kinds, i)] & KIND_FIXED));
}

enum { A_LINE = 3, A_CLEAR = 10 /* work: per bullet tested against a line; per bullet cleared */ };

/* Removes the matching bullets and returns how many. Also releases, without counting them, matching held bullets (those
 * that left the field this frame), so their pending hits have no effect. */
static lua_Integer clear(lua_State *L, struct board *b, struct bullets *s, const struct clearing *c)
{
    lua_Integer n = 0;

    vm_charge(L, (c->region.shape == REGION_LINE ? A_LINE : 1) * (uint64_t)s->s.live);
    EACH_LIVE (i, &s->s) {
        if (!takes(b, s, c, i))
            continue;
        leave_spark(b, s, c->spark, i);
        leave_item(b, s, c->items, i);
        bullets_drop(s, i);
        n++;
    }
    vm_charge(L, A_CLEAR * (uint64_t)n);
    EACH_HELD (i, &s->s)
        if (takes(b, s, c, i))
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
#define CLEAR_PARAMS_OF_ALL                                                                                            \
    PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "remove only things with this tag"),                                   \
        PARAM("x", A_FX, OPT, -WORLD, WORLD, "px", NULL,                                                               \
              "horizontal position of the shape; give `x` and `y`, or `from`"),                                        \
        PARAM("y", A_FX, OPT, -WORLD, WORLD, "px", NULL, "vertical position of the shape"),                            \
        SHAPE_CIRCLE_PARAMS(OPT, MAX_SPEED),                                                                           \
        PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark to leave behind; overrides `vanish`"),      \
        PARAM("from", A_THING, OPT, PLACES, 0, NULL, NULL, "thing whose position is used instead of `x` and `y`"),     \
        PARAM("dx", A_FX, OPT, -WORLD, WORLD, "px", "0", "distance added to `x`, or to the position of `from`"),       \
        PARAM("dy", A_FX, OPT, -WORLD, WORLD, "px", "0", "distance added to `y`, or to the position of `from`"),       \
        SHAPE_BOX_PARAMS(OPT), SHAPE_LINE_PARAMS(OPT),                                                                 \
        PARAM("all", A_BOOL, OPT, 0, 0, NULL, "false", "also remove kinds with `clearable = false`"),                  \
        PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, "kind of item that replaces each thing removed")

const struct api_param api_clear_params[CLEAR_PARAMS] = {
    CLEAR_PARAMS_OF_ALL,
    PARAM("lasers", A_BOOL, OPT, 0, 0, NULL, "true",
          "also remove enemy lasers; with a shape, only lasers that touch it"),
};

/* ---- clearing lasers ---- */

enum { EVERY = 12 /* px between the sparks and items along a cleared laser */ };

/* The spark and item a cleared laser leaves. */
struct remains {
    bool spark;
    uint16_t kind;
    const struct api_value *items;
};

/* Emits the spark and spawns the item at one position on a cleared laser. */
static void leave_one(struct board *b, fx x, fx y, void *context)
{
    const struct remains *r = context;

    if (r->spark)
        board_sparks(b, &(struct spark_burst){ .x = x, .y = y, .kind = r->kind, .n = 1 });
    if (r->items->given)
        board_turn_into(b, (uint16_t)r->items->i, x, y);
}

/* Removes the whole of laser i. Every `every` px along it, emits the given spark (otherwise the one of its kind) and
 * spawns the given item, if any. */
static void clear_laser(lua_State *L, struct board *b, uint32_t i, const struct api_value *spark,
                        const struct api_value *items, fx every)
{
    const uint16_t vanish = b->laser_kinds.vanish[b->laser_heads.kind[i]];
    struct remains r = { spark->given || vanish, (uint16_t)(spark->given ? spark->i : vanish - 1), items };

    vm_charge(L, lasers_corners(b, i));
    if (r.spark || items->given)
        vm_charge(L, lasers_places(b, i, every, leave_one, &r));
    lasers_remove(b, i);
}

/* Removes the lasers that match c and returns how many; includes players' lasers only if `shooting`. */
static lua_Integer clear_lasers(lua_State *L, struct board *b, const struct clearing *c, fx every, bool shooting)
{
    const struct laser_kinds *kinds = &b->laser_kinds;
    lua_Integer n = 0;

    EACH_LIVE (i, &b->lasers.s) {
        const unsigned flags = kinds->flags[b->laser_heads.kind[i]];
        vm_charge(L, lasers_corners(b, i));
        if (!api_has_tag(b->laser_heads.tag, i, c->tag) || (flags & LASER_SHOOTS && !shooting) ||
            (flags & LASER_FIXED && !c->all) || !api_region_laser(b, &c->region, i))
            continue;
        clear_laser(L, b, i, c->spark, c->items, every);
        n++;
    }
    return n;
}

int api_clear(lua_State *L, struct board *b, struct api_value *v)
{
    const struct api_value place[REGION_PARAMS] = { v[C_X], v[C_Y], v[C_FROM], v[C_DX],   v[C_DY],   v[C_RADIUS],
                                                    v[C_W], v[C_H], v[C_TO_X], v[C_TO_Y], v[C_WIDTH] };
    struct clearing c = { .spark = &v[C_SPARK], .items = &v[C_ITEMS], .all = v[C_ALL].i };

    if (v[C_TAG].given)
        c.tag = api_tag(L, "bullet.clear", v[C_TAG].at);
    bool there = api_region(L, b, "bullet.clear", place, &c.region);
    lua_Integer n = there ? clear(L, b, &b->bullets, &c) : 0;
    if (there && v[C_LASERS].i)
        n += clear_lasers(L, b, &c, EVERY << 16, false);
    lua_pushinteger(L, n);
    return 1;
}

enum { ARG_SELF, ARG_SPARK, SELF_ITEMS, ARG_PLACE = SELF_ITEMS, ARG_ALL = ARG_PLACE + REGION_PARAMS, ARG_ITEMS };

const struct api_param api_clear_self_params[CLEAR_SELF_PARAMS] = {
    PARAM("self", A_THING, REQ, 1 << H_BULLET | 1 << H_SHOT, 0, NULL, NULL, "the thing itself"),
    PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark to leave behind; overrides `vanish`"),
    PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, "kind of item that replaces it"),
};

int api_clear_self(lua_State *L, struct board *b, struct api_value *v)
{
    int64_t h = v[ARG_SELF].i;
    uint32_t i = handle_slot(h);
    struct bullets *s = handle_kind(h) == H_SHOT ? &b->shots : &b->bullets;

    (void)L;
    if (board_alive(b, h)) {
        leave_spark(b, s, &v[ARG_SPARK], i);
        leave_item(b, s, &v[SELF_ITEMS], i);
        bullets_drop(s, i);
    } else if (board_there(b, h))
        bullets_release(s, handle_slot(h));
    return 0;
}

const struct api_param api_clear_group_params[CLEAR_GROUP_PARAMS] = {
    PARAM("self", A_THING, REQ, 1 << H_GROUP | 1 << H_SHOTS, 0, NULL, NULL, "the group itself"),
    PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark to leave behind; overrides `vanish`"),
    PLACE,
    SHAPE_CIRCLE_PARAMS(OPT, MAX_SPEED),
    SHAPE_BOX_PARAMS(OPT),
    SHAPE_LINE_PARAMS(OPT),
    PARAM("all", A_BOOL, OPT, 0, 0, NULL, "false", "also remove kinds with `clearable = false`"),
    PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, "kind of item that replaces each thing removed"),
};

int api_clear_group(lua_State *L, struct board *b, struct api_value *v)
{
    bool shots = handle_kind(v[ARG_SELF].i) == H_SHOTS;
    struct clearing c = {
        .spark = &v[ARG_SPARK], .items = &v[ARG_ITEMS], .tag = handle_slot(v[ARG_SELF].i), .all = v[ARG_ALL].i
    };
    bool there = api_region(L, b, shots ? "shots:clear" : "group:clear", v + ARG_PLACE, &c.region);

    lua_pushinteger(L, there ? clear(L, b, shots ? &b->shots : &b->bullets, &c) : 0);
    return 1;
}

/* ---- laser.clear ---- */

#define EVERY_PARAM                                                                                                    \
    PARAM("every", A_FX, OPT, 1, LASER_LONGEST, "px", "12",                                                            \
          "distance along the laser between the sparks or items it leaves")

const struct api_param api_laser_clear_params[LASER_CLEAR_PARAMS] = {
    CLEAR_PARAMS_OF_ALL,
    EVERY_PARAM,
};

int api_laser_clear(lua_State *L, struct board *b, struct api_value *v)
{
    const struct api_value place[REGION_PARAMS] = { v[C_X], v[C_Y], v[C_FROM], v[C_DX],   v[C_DY],   v[C_RADIUS],
                                                    v[C_W], v[C_H], v[C_TO_X], v[C_TO_Y], v[C_WIDTH] };
    struct clearing c = { .spark = &v[C_SPARK], .items = &v[C_ITEMS], .all = v[C_ALL].i };

    if (v[C_TAG].given)
        c.tag = api_tag(L, "laser.clear", v[C_TAG].at);
    bool there = api_region(L, b, "laser.clear", place, &c.region);
    lua_pushinteger(L, there ? clear_lasers(L, b, &c, v[C_EVERY].f, false) : 0);
    return 1;
}

const struct api_param api_laser_clear_self_params[LASER_CLEAR_SELF_PARAMS] = {
    PARAM("self", A_THING, REQ, 1 << H_LASER, 0, NULL, NULL, "the laser itself"),
    PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark to leave behind; overrides `vanish`"),
    PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, "kind of item that replaces it"),
    EVERY_PARAM,
};

int api_laser_clear_self(lua_State *L, struct board *b, struct api_value *v)
{
    if (board_alive(b, v[ARG_SELF].i))
        clear_laser(L, b, handle_slot(v[ARG_SELF].i), &v[ARG_SPARK], &v[SELF_ITEMS], v[SELF_ITEMS + 1].f);
    return 0;
}

const struct api_param api_laser_clear_group_params[LASER_CLEAR_GROUP_PARAMS] = {
    PARAM("self", A_THING, REQ, 1 << H_LASERS, 0, NULL, NULL, "the group itself"),
    PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark to leave behind; overrides `vanish`"),
    PLACE,
    SHAPE_CIRCLE_PARAMS(OPT, MAX_SPEED),
    SHAPE_BOX_PARAMS(OPT),
    SHAPE_LINE_PARAMS(OPT),
    PARAM("all", A_BOOL, OPT, 0, 0, NULL, "false", "also remove kinds with `clearable = false`"),
    PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, "kind of item that replaces each thing removed"),
    EVERY_PARAM,
};

int api_laser_clear_group(lua_State *L, struct board *b, struct api_value *v)
{
    struct clearing c = {
        .spark = &v[ARG_SPARK], .items = &v[ARG_ITEMS], .tag = handle_slot(v[ARG_SELF].i), .all = v[ARG_ALL].i
    };
    bool there = api_region(L, b, "lasers:clear", v + ARG_PLACE, &c.region);

    lua_pushinteger(L, there ? clear_lasers(L, b, &c, v[ARG_ITEMS + 1].f, true) : 0);
    return 1;
}
