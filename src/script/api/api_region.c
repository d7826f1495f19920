/*
 * api_region.c - regions, described by a position and shape arguments, and clearing the bullets, shots and lasers in a
 * region.
 */
#include "../../base/geom.h"
#include "../../entities/sparks.h"
#include "../../machine/lasers_run.h"
#include "api_parts.h"

static int count_given(const struct api_value *v, int first, int n)
{
    int given = 0;

    for (int i = first; i < first + n; i++)
        given += v[i].given;
    return given;
}

enum { BOX_ARG_COUNT = 2, LINE_ARG_COUNT = 3 };

/* Returns the shape whose arguments are given; raises an error for arguments of several shapes, or for only some of the
 * arguments of one shape. */
static enum api_region_shape find_shape(lua_State *L, const char *entry, const struct api_value *v)
{
    const int n_box = count_given(v, REGION_W, BOX_ARG_COUNT), n_line = count_given(v, REGION_TO_X, LINE_ARG_COUNT);
    const bool has_circle = v[REGION_RADIUS].given, has_box = n_box > 0, has_line = n_line > 0;

    if (has_circle + has_box + has_line > 1)
        api_error(L, entry,
                  "shape: expected `radius`, or `w` and `h`, or `to_x`, `to_y` and `width`, got arguments of %s",
                  !has_box      ? "a circle and a line"
                  : !has_line   ? "a circle and a box"
                  : !has_circle ? "a box and a line"
                                : "all three");
    if (has_box && n_box < BOX_ARG_COUNT)
        api_error(L, entry, "shape: expected both `w` and `h`, got only `%s`", v[REGION_W].given ? "w" : "h");
    if (has_line && n_line < LINE_ARG_COUNT)
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
        if (count_given(v, 0, POSITION_PARAM_COUNT))
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
        return lasers_overlap_line(b, i, r->x, r->y, r->x, r->y, r->a);
    case REGION_BOX:
        return lasers_overlap_box(b, i, r->x, r->y, r->a, r->b);
    case REGION_LINE:
        return lasers_overlap_line(b, i, r->x, r->y, r->to_x, r->to_y, r->a);
    default:
        return true;
    }
}

/* ---- clears ---- */

/* A clear removes entities that have the tag (0: any), are in the region, and are clearable unless `include_fixed`.
 * `spark`, `item`: what each of them leaves, as given as arguments. `spacing`: distance between the sparks and items
 * along a laser. */
struct clear {
    struct api_region region;
    const struct api_value *spark, *item;
    uint32_t tag;
    fx spacing;
    bool include_fixed, include_player_lasers;
};

/* What an entity leaves: a kind of spark + 1 (0: none), and an item, if given. */
struct remains {
    uint16_t spark;
    const struct api_value *item;
};

/* Emits the spark and spawns the item at one position. */
static void leave_remains(struct board *b, fx x, fx y, void *context)
{
    const struct remains *r = context;

    if (r->spark)
        board_burst_sparks(b, &(struct spark_burst){ .x = x, .y = y, .kind = (uint16_t)(r->spark - 1), .n = 1 });
    if (r->item->given)
        board_replace_with_item(b, (uint16_t)r->item->i, x, y);
}

/* Returns what a bullet, shot or laser head of that kind leaves. */
static struct remains find_remains(const struct board *b, const struct bullets *s, uint16_t kind, const struct clear *c)
{
    const uint16_t vanish = s == &b->laser_heads ? b->laser_kinds.vanish_spark[kind]
                            : s == &b->bullets   ? b->bullet_kinds.vanish_spark[kind]
                                                 : 0;

    return (struct remains){ c->spark->given ? (uint16_t)(c->spark->i + 1) : vanish, c->item };
}

static const struct bullet_kinds *get_kinds(const struct board *b, const struct bullets *s)
{
    return s == &b->bullets ? &b->bullet_kinds : &b->shot_kinds;
}

static void clear_bullet(struct board *b, struct bullets *s, uint32_t i, const struct clear *c)
{
    struct remains r = find_remains(b, s, bullets_kind(s, get_kinds(b, s), i), c);

    leave_remains(b, s->x[i], s->y[i], &r);
    bullets_drop(s, i);
}

/* Removes the whole of laser i. */
static void clear_laser(lua_State *L, struct board *b, uint32_t i, const struct clear *c)
{
    struct remains r = find_remains(b, &b->laser_heads, b->laser_heads.kind[i], c);

    vm_charge(L, lasers_corner_count(b, i));
    if (r.spark || r.item->given)
        vm_charge(L, lasers_visit_positions(b, i, c->spacing, leave_remains, &r));
    lasers_remove(b, i);
}

static bool is_cleared(const struct board *b, const struct bullets *s, const struct clear *c, uint32_t i)
{
    const struct bullet_kinds *kinds = get_kinds(b, s);

    return api_has_tag(s->tag, i, c->tag) && api_region_contains(&c->region, s->x[i], s->y[i]) &&
           (c->include_fixed || !(kinds->flags[bullets_kind(s, kinds, i)] & KIND_FIXED));
}

enum { LINE_WORK = 3, CLEAR_WORK = 10 /* work: per bullet tested against a line; per bullet cleared */ };

/* Removes the matching bullets and returns how many. Also releases, without counting them, matching held bullets (those
 * that left the field this frame), so their pending hits have no effect. */
static lua_Integer clear_bullets(lua_State *L, struct board *b, struct bullets *s, const struct clear *c)
{
    lua_Integer n = 0;

    vm_charge(L, (c->region.shape == REGION_LINE ? LINE_WORK : 1) * (uint64_t)s->s.live);
    EACH_LIVE (i, &s->s) {
        if (!is_cleared(b, s, c, i))
            continue;
        clear_bullet(b, s, i, c);
        n++;
    }
    vm_charge(L, CLEAR_WORK * (uint64_t)n);
    EACH_HELD (i, &s->s)
        if (is_cleared(b, s, c, i))
            bullets_release(s, i);
    return n;
}

/* Removes the matching lasers and returns how many. */
static lua_Integer clear_lasers(lua_State *L, struct board *b, const struct clear *c)
{
    const struct laser_kinds *kinds = &b->laser_kinds;
    lua_Integer n = 0;

    EACH_LIVE (i, &b->lasers.s) {
        const unsigned flags = kinds->flags[b->laser_heads.kind[i]];
        vm_charge(L, lasers_corner_count(b, i));
        if (!api_has_tag(b->laser_heads.tag, i, c->tag) || (flags & LASER_HITS_ENEMIES && !c->include_player_lasers) ||
            (flags & LASER_FIXED && !c->include_fixed) || !api_region_touches_laser(b, &c->region, i))
            continue;
        clear_laser(L, b, i, c);
        n++;
    }
    return n;
}

/* Indices of the arguments of bullet.clear and laser.clear (CLEAR_PARAMS). */
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
    C_LASERS, /* bullet.clear only */
    C_EVERY = C_LASERS
};

enum { DEFAULT_SPACING = 12 /* px */ };

int api_clear(lua_State *L, struct board *b, struct api_value *v)
{
    const char *entry = api_current_binding(L)->entry->name;
    const bool is_laser_clear = entry[0] == 'l';
    const struct api_value region_args[REGION_PARAM_COUNT] = { v[C_X],    v[C_Y],      v[C_FROM], v[C_DX],
                                                               v[C_DY],   v[C_RADIUS], v[C_W],    v[C_H],
                                                               v[C_TO_X], v[C_TO_Y],   v[C_WIDTH] };
    struct clear c = { .spark = &v[C_SPARK],
                       .item = &v[C_ITEMS],
                       .tag = api_read_tag(L, entry, &v[C_TAG]),
                       .spacing = is_laser_clear ? v[C_EVERY].f : DEFAULT_SPACING << 16,
                       .include_fixed = v[C_ALL].i };
    lua_Integer n = 0;

    if (api_read_region(L, b, entry, region_args, &c.region)) {
        n = is_laser_clear ? 0 : clear_bullets(L, b, &b->bullets, &c);
        n += is_laser_clear || v[C_LASERS].i ? clear_lasers(L, b, &c) : 0;
    }
    lua_pushinteger(L, n);
    return 1;
}

enum { ARG_SELF, ARG_SPARK, SELF_ITEMS, SELF_EVERY };

static int clear_one(lua_State *L, struct board *b, struct api_value *v)
{
    struct bullets *s = api_flight_pool(b, v[ARG_SELF].i);
    const bool is_laser = s == &b->laser_heads;
    const struct clear c = { .spark = &v[ARG_SPARK],
                             .item = &v[SELF_ITEMS],
                             .spacing = is_laser ? v[SELF_EVERY].f : 0 };

    if (is_laser)
        clear_laser(L, b, handle_slot(v[ARG_SELF].i), &c);
    else
        clear_bullet(b, s, handle_slot(v[ARG_SELF].i), &c);
    return 0;
}

int api_clear_self(lua_State *L, struct board *b, struct api_value *v)
{
    const int64_t h = v[ARG_SELF].i;

    api_run_each(L, b, v, clear_one);
    api_release_held(b, h);
    return 0;
}

enum { ARG_POSITION = ARG_SPARK + 1, ARG_ALL = ARG_POSITION + REGION_PARAM_COUNT, ARG_ITEMS, ARG_EVERY };

int api_clear_group(lua_State *L, struct board *b, struct api_value *v)
{
    const int64_t h = v[ARG_SELF].i;
    const bool is_lasers = handle_kind(h) == H_LASERS;
    struct clear c = { .spark = &v[ARG_SPARK],
                       .item = &v[ARG_ITEMS],
                       .tag = handle_slot(h),
                       .spacing = is_lasers ? v[ARG_EVERY].f : 0,
                       .include_fixed = v[ARG_ALL].i,
                       .include_player_lasers = true };
    lua_Integer n = 0;

    if (api_read_region(L, b, api_current_binding(L)->entry->name, v + ARG_POSITION, &c.region))
        n = is_lasers ? clear_lasers(L, b, &c) : clear_bullets(L, b, api_flight_pool(b, h), &c);
    lua_pushinteger(L, n);
    return 1;
}
