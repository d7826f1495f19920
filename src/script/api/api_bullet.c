/*
 * api_bullet.c - bullet, shot, motion.
 */
#include <stdio.h>
#include <string.h>
#include "../../base/trig.h"
#include "../../base/int.h"
#include "../../base/edit.h"
#include "api_parts.h"
#include "../events_run.h"
#include "../../machine/sound.h"

/* A number of the script in Q32, nearest. It was checked against a range within +-2^15. */
static int64_t q32(double v)
{
    return fx_nearest(v * 4294967296.0);
}

/* A number in Q32 for what is fine; for what is not, rounded to fx. */
int64_t api_units(bool fine, const struct api_value *v)
{
    return fine ? q32(v->n) : (int64_t)v->f * (1 << PACE_BITS);
}

bool api_motion_fine(const struct board *b, uint16_t motion)
{
    return motion && b->motions.fine[motion - 1];
}

/* ---- hit shapes ---- */

static fx extent(lua_State *L, const char *entry, const char *name, int at)
{
    struct api_param p = { name, A_FX, REQ, 0, MAX_SPEED, "px", NULL, NULL };
    struct api_value v = { 0 };

    api_check(L, entry, &p, at, &v);
    return v.f;
}

#define HIT_MANY "{ circles = { { x, y, r }, .. } }, { sprite = name }"
const char *const api_hit_forms[] = {
    [HIT_PLAYERS] = "{ circle = r } or { sprite = name }",
    [HIT_ENEMIES] =
        "{ circle = r }, { box = { w, h } }, { capsule = { length, radius, dir } }, " HIT_MANY " or \"none\"",
    [HIT_LASERS] = "{ share = s }, s from 0 to 1, or \"none\"",
    [HIT_BULLETS] = "{ circle = r }, { box = { w, h } }, { capsule = { length, radius } }, " HIT_MANY " or \"none\"",
};

/* The one key of the table at `at`; it has no other. */
static const char *hit_key(lua_State *L, const char *entry, int at, enum hit_whose whose)
{
    static const struct api_param keys[] = {
        { .name = "circle" }, { .name = "sprite" }, { .name = "box" }, { .name = "capsule" }, { .name = "circles" }
    };
    const struct api_fields known = { keys, whose == HIT_PLAYERS ? 2 : sizeof keys / sizeof *keys, NAME_LISTS };
    const char *key = NULL;

    if (luakeys_push_stray(L, at, api_knows_field, &known))
        api_error(L, entry, "hit: expected %s, got a table with key %s", api_hit_forms[whose], api_push_got(L, -1));
    for (int k = 0; k < known.n; k++) {
        if (lua_getfield(L, at, keys[k].name) != LUA_TNIL && key)
            api_error(L, entry, "hit: expected %s, got a table with both \"%s\" and \"%s\"", api_hit_forms[whose], key,
                      keys[k].name);
        key = lua_isnil(L, -1) ? key : keys[k].name;
        lua_pop(L, 1);
    }
    if (!key)
        api_error(L, entry, "hit: expected %s, got an empty table", api_hit_forms[whose]);
    return key;
}

/* Item i of the list on top of the stack (which stays there), a number of px or degrees. */
static struct api_value item(lua_State *L, const char *entry, enum hit_whose whose, int i, const struct api_param *p)
{
    struct api_value v = { 0 };
    int list = lua_gettop(L);

    if (lua_type(L, list) != LUA_TTABLE)
        api_error(L, entry, "hit: expected %s", api_hit_forms[whose]);
    lua_rawgeti(L, list, i);
    api_check(L, entry, p, list + 1, &v);
    lua_settop(L, list);
    return v;
}

#define LENGTH(name)                                                                                                   \
    &(const struct api_param)                                                                                          \
    {                                                                                                                  \
        name, A_FX, REQ, 0, MAX_SPEED, "px", NULL, NULL                                                                \
    }
#define OFFSET(name)                                                                                                   \
    &(const struct api_param)                                                                                          \
    {                                                                                                                  \
        name, A_FX, REQ, -MAX_SPEED, MAX_SPEED, "px", NULL, NULL                                                       \
    }

/* A shape reaches no further than a radius may. */
static void check_reach(lua_State *L, const char *entry, int64_t reach)
{
    if (reach > (int64_t)MAX_SPEED << 16)
        api_error(L, entry, "hit: the shape reaches %d px from its centre, expected at most %d", (int)(reach >> 16),
                  MAX_SPEED);
}

/* A bullet's bar lies along its dir; an enemy, which has none, gives one. */
static void read_capsule(lua_State *L, const char *entry, enum hit_whose whose, struct api_shape *s)
{
    const struct api_param dir = { "hit.capsule dir", A_DIR, OPT, 0, 0, NULL, "90", NULL };
    fx half = item(L, entry, whose, 1, LENGTH("hit.capsule length")).f / 2;

    s->shape = SHAPE_CAPSULE;
    s->row[0].a = item(L, entry, whose, 2, LENGTH("hit.capsule radius")).f;
    check_reach(L, entry, (int64_t)s->row[0].a + half);
    if (whose == HIT_BULLETS) {
        if (lua_rawgeti(L, -1, 3) != LUA_TNIL)
            api_error(L, entry,
                      "hit.capsule: expected { length, radius }, got a third value (a bullet's capsule lies along its "
                      "`dir`)");
        s->row[0].b = half;
        return;
    }
    struct api_value v = item(L, entry, whose, 3, &dir);
    trig_polar(half, v.given ? v.a : 0x40000000, &s->row[0].x, &s->row[0].y);
}

static void read_circles(lua_State *L, const char *entry, enum hit_whose whose, struct api_shape *s)
{
    uint32_t n = lua_type(L, -1) == LUA_TTABLE ? (uint32_t)lua_rawlen(L, -1) : 0;

    if (n < 1 || n > SHAPE_PARTS)
        api_error(L, entry, "hit.circles: expected a list of 1 to %d circles { x, y, r }", SHAPE_PARTS);
    s->shape = SHAPE_CIRCLES;
    s->rows = n;
    for (uint32_t i = 0; i < n; i++) {
        lua_rawgeti(L, -1, (int)i + 1);
        s->row[i].x = item(L, entry, whose, 1, OFFSET("hit.circles x")).f;
        s->row[i].y = item(L, entry, whose, 2, OFFSET("hit.circles y")).f;
        s->row[i].a = item(L, entry, whose, 3, LENGTH("hit.circles r")).f;
        s->row[i].b = (fx)(n - 1 - i);
        check_reach(L, entry, (int64_t)fx_abs(s->row[i].x) + fx_abs(s->row[i].y) + s->row[i].a + 2);
        lua_pop(L, 1);
    }
}

/* The shape that was drawn with a sprite, whose name is on top of the stack. */
static void read_drawn(lua_State *L, const char *entry, enum hit_whose whose, struct api_shape *s)
{
    const struct api_param sprite = { "hit.sprite", A_SPRITE, REQ, 0, 0, NULL, NULL, NULL };
    const int at = lua_gettop(L);
    struct api_value v = { 0 };
    struct cart_hit hit;

    api_check(L, entry, &sprite, at, &v);
    const char *name = lua_tostring(L, at);
    if (!cart_find_hit(&vm_board(L)->cart, name, &hit))
        api_error(L, entry, "hit.sprite: sprite \"%s\" has no hit shape (add a slice named \"hit\" to its .ase file)",
                  name);
    if (whose == HIT_PLAYERS && hit.shape != SHAPE_CIRCLE)
        api_error(L, entry,
                  "hit.sprite: expected one circle at the player's position, got a different hit shape from \"%s\"",
                  name);
    if (whose == HIT_BULLETS && hit.shape == SHAPE_CAPSULE && hit.row[0].y != 0)
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
    if (whose == HIT_BULLETS && hit.shape == SHAPE_CAPSULE) {
        s->row[0].b = hit.row[0].x;
        s->row[0].x = 0;
    }
}

struct api_shape api_hit(lua_State *L, const char *entry, int at, enum hit_whose whose)
{
    struct api_shape s = { .shape = SHAPE_NONE, .rows = 1 };
    int top = lua_gettop(L);

    if (lua_type(L, at) == LUA_TSTRING) {
        if (whose == HIT_PLAYERS || strcmp(lua_tostring(L, at), "none"))
            api_error(L, entry, "hit: expected %s, got \"%s\"", api_hit_forms[whose], lua_tostring(L, at));
        return s;
    }
    const char *key = hit_key(L, entry, at, whose);
    lua_getfield(L, at, key);
    if (!strcmp(key, "circle")) {
        s.shape = SHAPE_CIRCLE;
        s.row[0].a = extent(L, entry, "hit.circle", lua_gettop(L));
    } else if (!strcmp(key, "capsule"))
        read_capsule(L, entry, whose, &s);
    else if (!strcmp(key, "sprite"))
        read_drawn(L, entry, whose, &s);
    else if (!strcmp(key, "circles"))
        read_circles(L, entry, whose, &s);
    else {
        s.shape = SHAPE_BOX;
        s.row[0].a = item(L, entry, whose, 1, LENGTH("hit.box width")).f / 2;
        s.row[0].b = item(L, entry, whose, 2, LENGTH("hit.box height")).f / 2;
    }
    lua_settop(L, top);
    return s;
}

int32_t api_kind(lua_State *L, const char *entry, struct slots *kinds, const struct shape_columns *k,
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

/* ---- kinds ---- */

/* Places of bullet_def and of shot_def. */
enum { D_NAME, D_SPRITE, D_HIT, D_BANK, D_GRAZE, D_DAMAGE = D_GRAZE, D_TURNS, D_SWEPT, D_BLEND, D_SPIN, D_ORDER };

/* Of bullet_def alone. */
enum { D_CLOUD = D_ORDER + 1, D_VANISH, D_CLEARABLE, D_HP, D_SCORE, D_SPARK, D_ON_DEATH, D_DROPS, D_HARMLESS };

/* Of shot_def alone. */
enum { D_CANCELS = D_ORDER + 1, D_PIERCE, D_EVERY };

enum { MOST_ORDER = 100 };

static const char NO_HP[] = "bullet hp is disabled; add `hp = true` to `board` in rom.lua";

static const struct api_param bullet_def[] = {
    PARAM("name", A_STR, REQ, 0, 0, NULL, NULL, "name of the kind, used as `kind = NAME`; must be new"),
    PARAM("sprite", A_SPRITE, REQ, 0, 0, NULL, NULL, "sprite to draw"),
    PARAM("hit", A_HIT, REQ, HIT_BULLETS, 0, NULL, NULL,
          "hitbox, relative to the thing's position; \"none\" never hits"),
    PARAM("bank", A_INT, OPT, 0, 15, NULL, "0", "number added to the palette bank of its sprite"),
    PARAM("graze", A_BOOL, OPT, 0, 0, NULL, "true", "whether players can graze it"),
    PARAM("turns", A_BOOL, OPT, 0, 0, NULL, "false",
          "rotate the sprite to the direction of flight; the sprite needs `rotations` in rom.lua"),
    PARAM("swept", A_BOOL, OPT, 0, 0, NULL, "true",
          "check the entire path flown in each frame for hits; if false, check only the position at the end of the "
          "frame"),
    PARAM("blend", A_BLEND, OPT, 0, 0, NULL, NULL,
          "blend to draw it with, from `blends` in rom.lua; nil draws it opaque"),
    PARAM("spin", A_DIR, OPT, 0, 0, NULL, "0",
          "degrees the sprite rotates per frame, clockwise; the sprite needs `rotations` in rom.lua"),
    PARAM("order", A_INT, OPT, -MOST_ORDER, MOST_ORDER, NULL, "0", "drawing order; higher is drawn over lower"),
    PARAM("cloud", A_SPRITE, OPT, 0, 0, NULL, NULL,
          "sprite shown instead of `sprite` during the bullet's delay; nil keeps `sprite`"),
    PARAM("vanish", A_SPARK_KIND, OPT, 0, 0, NULL, NULL,
          "kind of spark left when the bullet is cleared, unless the call that clears it names another kind; nil "
          "leaves none"),
    PARAM("clearable", A_BOOL, OPT, 0, 0, NULL, "true", "whether it can be cleared without `all = true`"),
    PARAM("hp", A_COUNT, OPT, 1, INT32_MAX, NULL, NULL,
          "damage it takes from shots before it is destroyed; without `hp`, shots pass through it"),
    PARAM("score", A_INT, OPT, 0, 1e12, "points", "0", "points for the player who destroys it; needs `hp`"),
    PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark left when the bullet's hp runs out; needs `hp`"),
    PARAM("on_death", A_FUNC, OPT, 0, 0, NULL, NULL,
          "on_death(b, p): called with the bullet and the player whose shot destroyed it; p may be nil; needs `hp`"),
    PARAM("drops", A_TABLE, OPT, 0, 0, NULL, NULL,
          "items dropped when the bullet's hp runs out, { NAME = count }; needs `hp`"),
    PARAM("harmless", A_BOOL, OPT, 0, 0, NULL, "false", "if true, it can't hit players or be grazed"),
};

static const struct api_param shot_def[] = {
    PARAM("name", A_STR, REQ, 0, 0, NULL, NULL, "name of the kind, used as `kind = NAME`; must be new"),
    PARAM("sprite", A_SPRITE, REQ, 0, 0, NULL, NULL, "sprite to draw"),
    PARAM("hit", A_HIT, REQ, HIT_BULLETS, 0, NULL, NULL,
          "hitbox, relative to the thing's position; \"none\" never hits"),
    PARAM("bank", A_INT, OPT, 0, 15, NULL, "0", "number added to the palette bank of its sprite"),
    PARAM("damage", A_INT, OPT, 0, 1000000, "hp", "1", "damage to each enemy or bullet it hits"),
    PARAM("turns", A_BOOL, OPT, 0, 0, NULL, "false",
          "rotate the sprite to the direction of flight; the sprite needs `rotations` in rom.lua"),
    PARAM("swept", A_BOOL, OPT, 0, 0, NULL, "true",
          "check the entire path flown in each frame for hits; if false, check only the position at the end of the "
          "frame"),
    PARAM("blend", A_BLEND, OPT, 0, 0, NULL, NULL,
          "blend to draw it with, from `blends` in rom.lua; nil draws it opaque"),
    PARAM("spin", A_DIR, OPT, 0, 0, NULL, "0",
          "degrees the sprite rotates per frame, clockwise; the sprite needs `rotations` in rom.lua"),
    PARAM("order", A_INT, OPT, -MOST_ORDER, MOST_ORDER, NULL, "0", "drawing order; higher is drawn over lower"),
    PARAM(
        "cancels", A_BOOL, OPT, 0, 0, NULL, "false",
        "whether it removes one clearable bullet that it touches; a bullet with `hp` takes the shot's damage instead"),
    PARAM("pierce", A_COUNT, OPT, 0, 1000000, NULL, "0",
          "number of hits that the shot survives; the next hit removes it; with forever, no hit removes it"),
    PARAM("every", A_COUNT, OPT, 1, 1000000, "frames", NULL,
          "frames before the shot can hit the same target again; defaults to 6; needs `pierce`"),
};

/* The ROW_CLOUD of the kind that is declared next. */
static void declare_cloud(lua_State *L, struct bullet_kinds *k)
{
    const struct api_shape none = { .shape = SHAPE_NONE, .rows = 1 };
    const struct shape_columns columns = { k->shape, k->a, k->b, k->x, k->y };

    api_kind(L, "bullet.def", &k->s, &columns, &none);
}

/* Sets the cloud of kind i. */
static void set_cloud(struct bullet_kinds *k, int i, uint16_t sprite)
{
    const int cloud = i + ROW_CLOUD;

    k->sprite[cloud] = sprite;
    k->bank[cloud] = k->bank[i];
    k->order[cloud] = k->order[i];
    k->flags[cloud] = (uint16_t)(KIND_CLOUD | (k->flags[i] & (KIND_TURNS | KIND_BLEND)));
    k->flags[i] |= KIND_CLOUDED;
}

/* Declares a kind of bullets or shots but for graze and damage; returns its index. */
static int define(lua_State *L, struct bullet_kinds *k, enum name_kind what, const char *entry, struct api_value *v)
{
    const struct api_shape shape = api_hit(L, entry, v[D_HIT].at, HIT_BULLETS);
    const struct shape_columns columns = { k->shape, k->a, k->b, k->x, k->y };

    if (v[D_SPIN].a && vm_board(L)->pictures[v[D_SPRITE].i].rotations == 1)
        api_error(L, entry, "spin: sprite \"%s\" has no rotations (add `rotations` to it in rom.lua)",
                  lua_tostring(L, v[D_SPRITE].at));
    int32_t i = api_kind(L, entry, &k->s, &columns, &shape);

    api_names_declare(L, what, entry, lua_tostring(L, v[D_NAME].at), i);
    k->sprite[i] = (uint16_t)v[D_SPRITE].i;
    k->bank[i] = (uint8_t)v[D_BANK].i;
    k->spin[i] = v[D_SPIN].a;
    k->order[i] = (int8_t)v[D_ORDER].i;
    k->flags[i] =
        (uint16_t)((v[D_TURNS].i ? KIND_TURNS : 0) | (v[D_SWEPT].i ? KIND_SWEPT : 0) | v[D_BLEND].i * KIND_BLEND_ONE);
    return i;
}

/* hp and what is told of their end. */
static void define_hp(lua_State *L, struct board *b, int i, const struct api_value *v)
{
    struct bullet_kinds *k = &b->bullet_kinds;

    for (int p = D_SCORE; p <= D_DROPS; p++)
        if (v[p].given && !v[D_HP].given)
            api_error(L, "bullet.def", "%s: requires `hp`", bullet_def[p].name);
    if (!v[D_HP].given)
        return;
    if (!k->hp)
        api_error(L, "bullet.def", "hp: %s", NO_HP);
    k->hp[i] = api_or_forever(&v[D_HP]);
    k->score[i] = v[D_SCORE].i;
    k->spark[i] = v[D_SPARK].given ? (uint16_t)(v[D_SPARK].i + 1) : 0;
    if (v[D_DROPS].given) {
        api_drops(L, "bullet.def", v[D_DROPS].at);
        events_set_function(L, (uint16_t)i, "bullet's drops");
    }
    if (!v[D_ON_DEATH].given)
        return;
    lua_pushvalue(L, v[D_ON_DEATH].at);
    events_set_function(L, (uint16_t)i, "bullet's on_death");
}

static int bullet_define(lua_State *L, struct board *b, struct api_value *v)
{
    if (v[D_CLOUD].given)
        declare_cloud(L, &b->bullet_kinds);
    int i = define(L, &b->bullet_kinds, N_BULLET, "bullet.def", v);

    if (v[D_GRAZE].i)
        b->bullet_kinds.flags[i] |= KIND_GRAZE;
    if (!v[D_CLEARABLE].i)
        b->bullet_kinds.flags[i] |= KIND_FIXED;
    if (v[D_HARMLESS].i)
        b->bullet_kinds.flags[i] |= KIND_HARMLESS;
    b->bullet_kinds.vanish[i] = v[D_VANISH].given ? (uint16_t)(v[D_VANISH].i + 1) : 0;
    define_hp(L, b, i, v);
    if (v[D_CLOUD].given)
        set_cloud(&b->bullet_kinds, i, (uint16_t)v[D_CLOUD].i);
    return 0;
}

/* How it goes through what it hits. */
static void define_pierce(lua_State *L, struct bullet_kinds *k, int i, const struct api_value *v)
{
    enum { USUAL = 6 };

    if (v[D_PIERCE].i && !k->pierce)
        api_error(L, "shot.def", "pierce: " API_OFF, "piercing is disabled; add `pierce = true` to `board`");
    if (v[D_EVERY].given && !v[D_PIERCE].i)
        api_error(L, "shot.def", "every: requires `pierce`");
    if (!k->pierce)
        return;
    k->pierce[i] = api_or_forever(&v[D_PIERCE]);
    k->every[i] = v[D_EVERY].given ? api_or_forever(&v[D_EVERY]) : USUAL;
}

static int shot_define(lua_State *L, struct board *b, struct api_value *v)
{
    int i = define(L, &b->shot_kinds, N_SHOT, "shot.def", v);

    b->shot_kinds.damage[i] = (int32_t)v[D_DAMAGE].i;
    if (v[D_CANCELS].i)
        b->shot_kinds.flags[i] |= KIND_CANCELS;
    define_pierce(L, &b->shot_kinds, i, v);
    return 0;
}

/* ---- firing ---- */

void api_check_around(lua_State *L, const struct bullets *s, const char *entry, const struct api_value *v)
{
    if (v->given && !s->around)
        api_error(L, entry, "around: orbits around things are disabled; add `around = true` to `board` in rom.lua");
}

#define FLIGHT(kind_type, def_dir)                                                                                     \
    PARAM("kind", kind_type, REQ, 0, 0, NULL, NULL, "declared kind to fire"),                                          \
        PARAM("speed", A_FX, REQ, -MAX_SPEED, MAX_SPEED, "px/frame", NULL,                                             \
              "speed of flight; if negative, it flies backwards"),                                                     \
        PLACE,                                                                                                         \
        PARAM("dir", A_DIR, OPT, 0, 0, NULL, def_dir,                                                                  \
              "direction of flight, clockwise from the right; with `aim`, the default is 0, and the angle is added "   \
              "to the direction towards the target"),                                                                  \
        PARAM("aim", A_BOOL, OPT, 0, 0, NULL, "false",                                                                 \
              "fire at the nearest target: a player for bullets, an enemy for shots"),                                 \
        PARAM("bank", A_INT, OPT, 0, 15, NULL, NULL,                                                                   \
              "number added to the palette bank of its sprite; overrides its kind's"),                                 \
        PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "name of a group to put it in"),                                   \
        PARAM("motion", A_MOTION, OPT, 0, 0, NULL, NULL, "motion program that steers it")
#define AROUND                                                                                                         \
    PARAM("around", A_THING, OPT, PLACES, 0, NULL, NULL,                                                               \
          "thing that it circles in the `orbit` steps of its motion; needs `board = { around = true }`")

static const struct api_param bullet_fire[] = {
    FLIGHT(A_BULLET_KIND, "90"),
    PARAM("delay", A_INT, OPT, 0, 1e9, "frames", "0",
          "frames the bullet waits in place before it flies; until then, it is harmless and drawn as its cloud"),
    AROUND
};
static const struct api_param shot_fire[] = {
    FLIGHT(A_SHOT_KIND, "270"),
    PARAM("by", A_THING, OPT, 1 << H_PLAYER, 0, NULL, NULL,
          "player who owns the shot and gets its score; defaults to the owner of `from`"),
    AROUND
};

enum { A_TARGET = 8 /* looking at so many is a unit of work */ };

ang api_aim(struct board *b, bool shot, fx x, fx y)
{
    struct targets t = board_world(b, shot).targets;

    b->vm.work += shot ? b->enemies.s.top / A_TARGET : 0;
    return targets_aim(&t, x, y, shot ? 0xc0000000u : 0x40000000u);
}

/* The player whose shot it is + 1, or 0. */
static uint8_t shooter(const struct board *b, const struct api_value *v)
{
    const struct api_value *by = v[FIRE_BY].given ? &v[FIRE_BY] : &v[FIRE_PLACE + PLACE_FROM];

    return by->given ? board_player_of(b, by->i) : 0;
}

bool api_flight(lua_State *L, struct board *b, const char *entry, const struct api_value *v, bool shot,
                struct bullet_shape *s)
{
    const struct bullet_kinds *kinds = shot ? &b->shot_kinds : &b->bullet_kinds;

    *s = (struct bullet_shape){ .speed = v[FIRE_SPEED].f,
                                .dir = v[FIRE_DIR].a,
                                .kind = (uint16_t)v[FIRE_KIND].i,
                                .bank = v[FIRE_BANK].given ? (uint8_t)v[FIRE_BANK].i : kinds->bank[v[FIRE_KIND].i],
                                .motion = v[FIRE_MOTION].given ? (uint16_t)v[FIRE_MOTION].i : 0,
                                .fine = v[FIRE_MOTION].given && api_motion_fine(b, (uint16_t)v[FIRE_MOTION].i),
                                .player = shot ? shooter(b, v) : 0,
                                .delay = shot ? 0 : (uint32_t)v[FIRE_DELAY].i,
                                .by = tasks_serial(b) };
    if (!api_place(L, b, entry, v + FIRE_PLACE, &s->x, &s->y))
        return false;
    if (s->player && b->player.hit[s->player - 1]) /* it cannot fire */
        return false;
    if (v[FIRE_TAG].given)
        s->tag = api_tag(L, entry, v[FIRE_TAG].at);
    api_check_around(L, shot ? &b->shots : &b->bullets, entry, &v[FIRE_AROUND]);
    s->around = v[FIRE_AROUND].given ? v[FIRE_AROUND].i : 0;
    if (s->player)
        sound_cue(b, CUE_SHOT, b->player.x[s->player - 1]);
    return true;
}

static int fire(lua_State *L, struct board *b, const struct api_value *v, bool shot)
{
    struct bullet_shape s;
    int32_t i = NO_SLOT;

    if (api_flight(L, b, shot ? "shot.fire" : "bullet.fire", v, shot, &s)) {
        if (v[FIRE_AIM].i)
            s.dir = api_aim(b, shot, s.x, s.y) + (v[FIRE_DIR].given ? v[FIRE_DIR].a : 0);
        i = emit_fire(b, shot, &s, api_units(true, &v[FIRE_SPEED]), b->core.clock);
    }
    if (i != NO_SLOT)
        api_value_set(b, shot ? N_SHOT_VALUE : N_BULLET_VALUE, (uint32_t)i, v + FIRE_VALUES);
    lua_pushinteger(L, board_handle(b, shot ? H_SHOT : H_BULLET, i));
    return 1;
}

static int bullet_fire_run(lua_State *L, struct board *b, struct api_value *v)
{
    return fire(L, b, v, false);
}

static int shot_fire_run(lua_State *L, struct board *b, struct api_value *v)
{
    return fire(L, b, v, true);
}

/* ---- groups ---- */

const struct api_param api_tag_params[TAG_PARAMS] = { PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL,
                                                            "tag to select by; if omitted, all are included") };
const struct api_param api_each_params[EACH_PARAMS] = {
    PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "tag to select by; nil selects all"),
    PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, "function to call; it cannot wait")
};

int api_group(lua_State *L, enum handle_kind kind, const char *entry, const struct api_value *tag)
{
    lua_pushinteger(L, handle_of(kind, 1, tag->given ? api_tag(L, entry, tag->at) : 0));
    return 1;
}

static int bullet_group(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    return api_group(L, H_GROUP, "bullet.group", &v[EACH_TAG]);
}

static int shot_group(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    return api_group(L, H_SHOTS, "shot.group", &v[EACH_TAG]);
}

enum { VISIT = 4 /* VM instructions that a visit counts for, besides those of the function */ };

/* The handles of those with the tag, in memory that Lua holds on top of the stack. */
static const int64_t *list_tagged(lua_State *L, const struct board *b, enum handle_kind kind, const struct slots *s,
                                  const uint16_t *tags, uint32_t tag, uint32_t *n)
{
    int64_t *list = lua_newuserdatauv(L, s->live * sizeof *list, 0);

    *n = 0;
    EACH_LIVE (i, s)
        if (api_has_tag(tags, i, tag))
            list[(*n)++] = board_handle(b, kind, (int32_t)i);
    return list;
}

int api_each(lua_State *L, struct board *b, enum handle_kind kind, const char *entry, const struct slots *s,
             const uint16_t *tags, const struct api_value v[EACH_PARAMS])
{
    uint32_t tag = v[EACH_TAG].given ? api_tag(L, entry, v[EACH_TAG].at) : 0;
    uint32_t n;
    const int64_t *list = list_tagged(L, b, kind, s, tags, tag, &n);

    vm_charge(L, VISIT * (uint64_t)n);
    for (uint32_t k = 0; k < n; k++) {
        if (!board_alive(b, list[k]))
            continue;
        lua_pushvalue(L, v[EACH_F].at);
        lua_pushinteger(L, list[k]);
        lua_call(L, 1, 0);
    }
    return 0;
}

static int bullet_each(lua_State *L, struct board *b, struct api_value *v)
{
    return api_each(L, b, H_BULLET, "bullet.each", &b->bullets.s, b->bullets.tag, v);
}

static int shot_each(lua_State *L, struct board *b, struct api_value *v)
{
    return api_each(L, b, H_SHOT, "shot.each", &b->shots.s, b->shots.tag, v);
}

static const struct api_param bullet_sweep[] = {
    PLACE,
    PARAM("follow", A_THING, OPT, PLACES, 0, NULL, NULL,
          "thing that the circle moves with; the sweep ends when the thing dies"),
    PARAM("radius", A_FX, OPT, 0, MAX_SPEED, "px", "0", "radius of the circle at the start"),
    PARAM("radius_to", A_FX, REQ, 0, MAX_SPEED, "px", NULL, "radius of the circle at the end"),
    PARAM("over", A_INT, REQ, 1, 65535, "frames", NULL, "duration of the sweep"),
    PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "remove only bullets with this tag"),
    PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark that each bullet leaves; overrides `vanish`"),
    PARAM("hurt", A_INT, OPT, 0, INT32_MAX, "hp", "0", "damage dealt once to each enemy the circle reaches"),
    PARAM("by", A_PAD, OPT, 0, 0, NULL, NULL, "player who gets the score for enemies that `hurt` kills"),
    PARAM("all", A_BOOL, OPT, 0, 0, NULL, "false", "also remove bullets with `clearable = false`"),
    PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, "kind of item that replaces each bullet"),
    PARAM("lasers", A_BOOL, OPT, 0, 0, NULL, "true", "also remove lasers that the circle touches"),
};

/* ---- properties ---- */

#define FLIGHT_PROPS(kind_type)                                                                                        \
    { PARAM("x", A_FX, REQ, -WORLD, WORLD, "px", NULL,                                                                 \
            "horizontal position in the field; a write teleports it, without collisions on the way"),                  \
      PROP_WRITE },                                                                                                    \
        { PARAM("y", A_FX, REQ, -WORLD, WORLD, "px", NULL,                                                             \
                "vertical position in the field; a write teleports it, without collisions on the way"),                \
          PROP_WRITE },                                                                                                \
        { PARAM("dir", A_DIR, REQ, 0, 0, NULL, NULL, "direction of flight, 0 to 360; unchanged at speed 0"),           \
          PROP_WRITE },                                                                                                \
        { PARAM("speed", A_FX, REQ, -MAX_SPEED, MAX_SPEED, "px/frame", NULL,                                           \
                "speed of flight; if negative, it flies backwards"),                                                   \
          PROP_WRITE },                                                                                                \
        { PARAM("vx", A_FX, REQ, -MAX_SPEED, MAX_SPEED, "px/frame", NULL,                                              \
                "horizontal velocity; a write changes `dir` and `speed`"),                                             \
          PROP_WRITE },                                                                                                \
        { PARAM("vy", A_FX, REQ, -MAX_SPEED, MAX_SPEED, "px/frame", NULL,                                              \
                "vertical velocity; a write changes `dir` and `speed`"),                                               \
          PROP_WRITE },                                                                                                \
        { PARAM("kind", kind_type, REQ, 0, 0, NULL, NULL,                                                              \
                "name of its kind; a write also sets `bank` to the bank of the new kind"),                             \
          PROP_WRITE },                                                                                                \
        { PARAM("bank", A_INT, REQ, 0, 15, NULL, NULL, "number added to the palette bank of its sprite"),              \
          PROP_WRITE },                                                                                                \
        { PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "tag of its group, or nil"), PROP_WRITE },                       \
        { PARAM("motion", A_MOTION, OPT, 0, 0, NULL, NULL,                                                             \
                "motion program it runs, or nil; a write starts the program from its first step"),                     \
          PROP_WRITE },                                                                                                \
        { PARAM("around", A_THING, OPT, PLACES, 0, NULL, NULL, "thing that it circles in `orbit` steps, or nil"),      \
          PROP_WRITE },                                                                                                \
        { PARAM("age", A_INT, REQ, 0, 0, NULL, NULL,                                                                   \
                "frames since it was fired, not counting its delay or frozen frames"),                                 \
          PROP_READ },                                                                                                 \
    {                                                                                                                  \
        PARAM("frozen", A_COUNT, REQ, 0, INT32_MAX, "frames", NULL,                                                    \
              "frames it stays frozen, or forever; 0 unfreezes it"),                                                   \
            PROP_WRITE                                                                                                 \
    }

#define HP_PROP                                                                                                        \
    {                                                                                                                  \
        PARAM("hp", A_COUNT, REQ, 0, INT32_MAX, NULL, NULL,                                                            \
              "damage it can still take, or forever; at 0, shots pass through it"),                                    \
            PROP_WRITE                                                                                                 \
    }

static const struct api_prop bullet_props[] = {
    FLIGHT_PROPS(A_BULLET_KIND),
    { PARAM("delay", A_INT, REQ, 0, 0, NULL, NULL, "frames left before it flies; 0 once it flies"), PROP_READ },
    HP_PROP,
};
static const struct api_prop shot_props[] = {
    FLIGHT_PROPS(A_SHOT_KIND),
    { PARAM("by", A_THING, REQ, 1 << H_PLAYER, 0, NULL, NULL, "player who fired it, or nil"), PROP_READ }
};

/* Q32 as a number: exact, for a place or a speed has 48 bits. */
static void push_q32(lua_State *L, int64_t v)
{
    lua_pushnumber(L, (double)v / 4294967296.0);
}

void api_get_flight(lua_State *L, struct board *b, const struct bullets *s, enum name_kind names, uint32_t i, int p)
{
    const struct bullet_kinds *kinds = names == N_SHOT ? &b->shot_kinds : &b->bullet_kinds;
    int64_t x, y;

    switch (p) {
    case FLIES_X:
    case FLIES_Y:
        bullets_place(s, i, &x, &y);
        push_q32(L, p == FLIES_X ? x : y);
        break;
    case FLIES_DIR:
        lua_pushnumber(L, trig_to_degrees(s->dir[i]));
        break;
    case FLIES_SPEED:
        push_q32(L, bullets_speed(s, i));
        break;
    case FLIES_VX:
    case FLIES_VY:
        bullets_velocity(s, i, &x, &y);
        push_q32(L, p == FLIES_VX ? x : y);
        break;
    case FLIES_KIND:
        api_names_push(L, names, bullets_kind(s, kinds, i));
        break;
    case FLIES_BANK:
        lua_pushinteger(L, s->bank[i]);
        break;
    case FLIES_TAG:
        api_push_tag(L, s->tag[i]);
        break;
    case FLIES_MOTION:
        if (s->motion[i])
            lua_pushinteger(L, handle_of(H_MOTION, 1, s->motion[i] - 1u));
        else
            lua_pushnil(L);
        break;
    case FLIES_AROUND:
        if (s->around && s->around[i])
            lua_pushinteger(L, s->around[i]);
        else
            lua_pushnil(L);
        break;
    case FLIES_AGE:
        lua_pushinteger(L, bullets_age(s, i, b->core.clock));
        break;
    case FLIES_FROZEN:
        api_push_or_forever(L, s->frozen[i]);
        break;
    default:
        if (s->player[i])
            lua_pushinteger(L, board_handle(b, H_PLAYER, s->player[i] - 1));
        else
            lua_pushnil(L);
    }
}

/* A script's write to dir or speed ends the running motion step's drive of it. */
void api_override(struct bullets *s, uint32_t i, unsigned what)
{
    if (s->mute[i] & STEP_BEGUN)
        s->mute[i] |= (uint8_t)what;
}

/* Sets x, y, vx or vy and leaves the other of the pair as it is. */
static void set_part(struct bullets *s, uint32_t i, int p, int64_t v)
{
    int64_t x, y;

    if (p == FLIES_X || p == FLIES_Y) {
        bullets_place(s, i, &x, &y);
        bullets_set_place(s, i, p == FLIES_X ? v : x, p == FLIES_Y ? v : y);
    } else {
        bullets_velocity(s, i, &x, &y);
        bullets_set_velocity(s, i, p == FLIES_VX ? v : x, p == FLIES_VY ? v : y);
    }
}

/* A write of the place takes a bullet away from the step that leads it. */
static void let_go(const struct board *b, struct bullets *s, uint32_t i)
{
    if (!s->motion[i] || !(s->mute[i] & STEP_BEGUN))
        return;
    if (b->steps.does[b->motions.first[s->motion[i] - 1] + s->pc[i]] & DOES_LEAD) {
        api_override(s, i, OVERRIDE_PLACE);
        bullets_steer(s, i);
    }
}

void api_set_flight(lua_State *L, struct board *b, struct bullets *s, const struct bullet_kinds *kinds, uint32_t i,
                    int p, const struct api_value *v)
{
    bool fine = s->flags[i] & BULLET_FINE;

    switch (p) {
    case FLIES_X:
    case FLIES_Y:
        set_part(s, i, p, api_units(fine, v));
        let_go(b, s, i);
        break;
    case FLIES_DIR:
        s->dir[i] = v->a;
        api_override(s, i, OVERRIDE_DIR);
        bullets_steer(s, i);
        break;
    case FLIES_SPEED:
        api_override(s, i, OVERRIDE_SPEED);
        bullets_set_speed(s, i, api_units(fine, v));
        break;
    case FLIES_VX:
    case FLIES_VY:
        api_override(s, i, OVERRIDE_DIR | OVERRIDE_SPEED);
        set_part(s, i, p, api_units(fine, v));
        break;
    case FLIES_KIND:
        bullets_set_kind(s, kinds, i, (uint16_t)v->i);
        break;
    case FLIES_BANK:
        s->bank[i] = (uint8_t)v->i;
        break;
    case FLIES_TAG:
        s->tag[i] = v->given ? api_tag(L, "tag", v->at) : 0;
        break;
    case FLIES_FROZEN:
        bullets_freeze(s, i, api_or_forever(v));
        break;
    case FLIES_AROUND:
        api_check_around(L, s, s == &b->shots ? "shot" : s == &b->bullets ? "bullet" : "laser", v);
        if (s->around)
            s->around[i] = v->given ? v->i : 0;
        break;
    case FLIES_MOTION:
        bullets_program(s, i, v->given ? (uint16_t)v->i : 0, v->given && api_motion_fine(b, (uint16_t)v->i));
        break;
    default:
        break;
    }
}

/* The column of hp; a fault where there is none. */
static int32_t *hp_of(lua_State *L, struct board *b)
{
    if (!b->bullets.hp)
        vm_fault(L, FAULT_SCRIPT, "bullet: hp: %s", NO_HP);
    return b->bullets.hp;
}

static void get_bullet(lua_State *L, struct board *b, uint32_t i, int p)
{
    const struct bullets *s = &b->bullets;

    if (p == FLIES_DELAY)
        lua_pushinteger(L, s->flags[i] & BULLET_DELAYED ? s->end[i] - b->core.clock : 0);
    else if (p == FLIES_HP)
        api_push_or_forever(L, hp_of(L, b)[i]);
    else
        api_get_flight(L, b, &b->bullets, N_BULLET, i, p);
}

static void set_bullet(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    if (p == FLIES_HP)
        hp_of(L, b)[i] = api_or_forever(v);
    else
        api_set_flight(L, b, &b->bullets, &b->bullet_kinds, i, p, v);
}

static void get_shot(lua_State *L, struct board *b, uint32_t i, int p)
{
    api_get_flight(L, b, &b->shots, N_SHOT, i, p);
}

static void set_shot(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    api_set_flight(L, b, &b->shots, &b->shot_kinds, i, p, v);
}

/* ---- groups' properties ---- */

#define COUNT_PROP(what)                                                                                               \
    {                                                                                                                  \
        PARAM("count", A_INT, REQ, 0, 0, NULL, NULL,                                                                   \
              "number of live " what " with the tag; no other property of a group can be read"),                       \
            PROP_READ                                                                                                  \
    }
static const struct api_prop group_props[] = { FLIGHT_PROPS(A_BULLET_KIND), COUNT_PROP("bullets"), HP_PROP };
static const struct api_prop shots_props[] = { FLIGHT_PROPS(A_SHOT_KIND), COUNT_PROP("shots") };

static void count_tagged(lua_State *L, const struct bullets *s, uint32_t tag)
{
    lua_Integer n = 0;

    EACH_LIVE (i, &s->s)
        n += api_has_tag(s->tag, i, tag);
    vm_charge(L, s->s.live);
    lua_pushinteger(L, n);
}

static void get_group(lua_State *L, struct board *b, uint32_t tag, int p)
{
    if (p != FLIES_LAST)
        vm_fault(L, FAULT_SCRIPT, "group: %s cannot be read from a group (only `count` can)",
                 group_props[p].value.name);
    count_tagged(L, &b->bullets, tag);
}

static void get_shots(lua_State *L, struct board *b, uint32_t tag, int p)
{
    if (p != FLIES_LAST)
        vm_fault(L, FAULT_SCRIPT, "shots: %s cannot be read from a group (only `count` can)",
                 shots_props[p].value.name);
    count_tagged(L, &b->shots, tag);
}

enum { A_WRITE = 10, AN_ACT = 2, AN_AIM = 4 /* work, of a thing of a group */ };

static void set_group(lua_State *L, struct board *b, uint32_t tag, int p, const struct api_value *v)
{
    vm_charge(L, A_WRITE * (uint64_t)b->bullets.s.live);
    EACH_LIVE (i, &b->bullets.s)
        if (api_has_tag(b->bullets.tag, i, tag))
            set_bullet(L, b, i, p, v);
}

static void set_shots(lua_State *L, struct board *b, uint32_t tag, int p, const struct api_value *v)
{
    vm_charge(L, A_WRITE * (uint64_t)b->shots.s.live);
    EACH_LIVE (i, &b->shots.s)
        if (api_has_tag(b->shots.tag, i, tag))
            set_shot(L, b, i, p, v);
}

const struct api_thing api_bullet_thing = { "bullet", bullet_props, FLIES_HP + 1, get_bullet, set_bullet };
const struct api_thing api_shot_thing = { "shot", shot_props, FLIES_LAST + 1, get_shot, set_shot };
const struct api_thing api_group_thing = { "group", group_props, FLIES_HP + 1, get_group, set_group };
const struct api_thing api_shots_thing = { "shots", shots_props, FLIES_LAST + 1, get_shots, set_shots };

/* ---- verbs of bullets, shots and groups ---- */

enum verb { V_AIM, V_TURN, V_SHIFT, V_REMOVE };
enum { ARG_SELF, ARG_BY /* or add */, ARG_DX = ARG_BY, ARG_DY };

/* A place in Q32, moved within the world. */
static int64_t shifted(int64_t at, int64_t by)
{
    const int64_t edge = (int64_t)WORLD << 32;

    return int64_clamp(at + by, -edge, edge);
}

static void shift(const struct board *b, struct bullets *s, uint32_t i, const struct api_value *v)
{
    bool fine = s->flags[i] & BULLET_FINE;
    int64_t x, y;

    bullets_place(s, i, &x, &y);
    bullets_set_place(s, i, shifted(x, api_units(fine, &v[ARG_DX])), shifted(y, api_units(fine, &v[ARG_DY])));
    let_go(b, s, i);
}

static void act(struct board *b, bool shot, const struct targets *targets, uint32_t i, enum verb verb,
                const struct api_value *v)
{
    struct bullets *s = shot ? &b->shots : &b->bullets;

    switch (verb) {
    case V_AIM:
        s->dir[i] = targets_aim(targets, s->x[i], s->y[i], shot ? 0xc0000000u : 0x40000000u) + v[ARG_BY].a;
        break;
    case V_TURN:
        s->dir[i] += v[ARG_BY].a;
        break;
    case V_SHIFT:
        shift(b, s, i, v);
        return;
    case V_REMOVE:
        bullets_drop(s, i);
        return;
    }
    api_override(s, i, OVERRIDE_DIR);
    bullets_steer(s, i);
}

static int verb(lua_State *L, struct board *b, const struct api_value *v, enum verb verb)
{
    int64_t h = v[ARG_SELF].i;
    bool shot = handle_kind(h) == H_SHOT || handle_kind(h) == H_SHOTS;
    struct bullets *s = shot ? &b->shots : &b->bullets;
    const struct targets targets = board_world(b, shot).targets;
    const uint64_t each = verb != V_AIM ? AN_ACT : AN_AIM + (shot ? b->enemies.s.top / A_TARGET : 0);

    vm_charge(L, each);
    if (!handle_kind_group(handle_kind(h))) {
        if (board_alive(b, h))
            act(b, shot, &targets, handle_slot(h), verb, v);
        else if (verb == V_REMOVE && board_there(b, h)) /* held: what else it touched is spared */
            bullets_release(s, handle_slot(h));
        return 0;
    }
    vm_charge(L, each * s->s.live);
    EACH_LIVE (i, &s->s)
        if (api_has_tag(s->tag, i, handle_slot(h)))
            act(b, shot, &targets, i, verb, v);
    if (verb == V_REMOVE)
        EACH_HELD (i, &s->s)
            if (api_has_tag(s->tag, i, handle_slot(h)))
                bullets_release(s, i);
    return 0;
}

static int verb_aim(lua_State *L, struct board *b, struct api_value *v)
{
    return verb(L, b, v, V_AIM);
}

static int verb_turn(lua_State *L, struct board *b, struct api_value *v)
{
    return verb(L, b, v, V_TURN);
}

static int verb_shift(lua_State *L, struct board *b, struct api_value *v)
{
    return verb(L, b, v, V_SHIFT);
}

static int verb_remove(lua_State *L, struct board *b, struct api_value *v)
{
    return verb(L, b, v, V_REMOVE);
}

/* What waits for the group's tag need not have it. */
static int verb_signal(lua_State *L, struct board *b, struct api_value *v)
{
    const int64_t h = v[ARG_SELF].i;
    const bool shots = handle_kind(h) == H_SHOTS;
    struct bullets *s = shots ? &b->shots : &b->bullets;
    const struct motion_world w = board_world(b, shots);

    vm_charge(L, s->s.live);
    EACH_LIVE (i, &s->s)
        bullets_signal(s, &w, i, (uint16_t)handle_slot(h));
    return 0;
}

enum { FLYING = 1 << H_BULLET | 1 << H_SHOT | 1 << H_GROUP | 1 << H_SHOTS };
static const struct api_param self_add[] = { SELF_OF(FLYING), AIM_ADD };
static const struct api_param self_by[] = { SELF_OF(FLYING), TURN_BY };
static const struct api_param self_shift[] = { SELF_OF(FLYING), SHIFT_DX, SHIFT_DY };
static const struct api_param self_only[] = { SELF_OF(FLYING) };
static const struct api_param self_group[] = { SELF_OF(1 << H_GROUP | 1 << H_SHOTS) };

/* ---- motion programs ---- */

enum {
    M_WAIT,
    M_KIND,
    M_BANK,
    M_DIR,
    M_AIM,
    M_TURN,
    M_HOME,
    M_SPEED,
    M_ACCEL,
    M_DIE,
    M_OVER,
    M_LOOP,
    M_GO_TO,
    M_POLAR,
    M_WAVE,
    M_ORBIT,
    M_EASE,
    M_SPIN,
    M_AT,
    M_EVERY,
    M_PHASE,
    M_RADIUS_TO,
    M_BOUNCE,
    M_WALLS,
    M_EMIT,
    M_PATH,
    M_MIRROR,
    M_WAIT_FOR,
    M_KEYS
};

static const struct api_param step_keys[M_KEYS] = {
    PARAM("wait", A_COUNT, OPT, 0, 1e9, "frames", NULL, "frames to fly unchanged before the next step"),
    PARAM("kind", A_BULLET_KIND, OPT, 0, 0, NULL, NULL, "kind of bullet to turn into"),
    PARAM("bank", A_INT, OPT, 0, 15, NULL, NULL, "number added to the palette bank of its sprite from now on"),
    PARAM("dir", A_DIR, OPT, 0, 0, NULL, NULL, "new direction of flight, clockwise from the right"),
    PARAM("aim", A_BOOL, OPT, 0, 0, NULL, NULL, "aim at the nearest target; with `over`, aim again in every frame"),
    PARAM("turn", A_DIR, OPT, 0, 0, NULL, NULL, "degrees to turn, clockwise; with `over`, degrees per frame"),
    PARAM("home", A_NUM, OPT, 0, 180, "degrees per frame", NULL,
          "maximum turn per frame towards the nearest target; needs `over`"),
    PARAM("speed", A_FX, OPT, -MAX_SPEED, MAX_SPEED, "px/frame", NULL,
          "new speed; with `over`, it is reached in equal steps; with `go_to`, it is the speed of travel"),
    PARAM("accel", A_FX, OPT, -MAX_SPEED, MAX_SPEED, "px/frame per frame", NULL,
          "change in speed; with `over`, the change per frame"),
    PARAM("die", A_BOOL, OPT, 0, 0, NULL, NULL, "despawn the bullet"),
    PARAM("over", A_COUNT, OPT, 1, 1e9, "frames", NULL,
          "duration of the step; without `over`, the step takes effect immediately"),
    PARAM("loop", A_COUNT, OPT, 0, 65534, "times", NULL, "number of times to run the steps nested in this one"),
    PARAM("go_to", A_TABLE, OPT, 0, 0, NULL, NULL, "point { x, y } in the field to fly to; needs `over` or `speed`"),
    PARAM("polar", A_FX, OPT, -MAX_SPEED, MAX_SPEED, "px/frame", NULL,
          "speed away from `at`, or from where the step starts if `at` is omitted; needs `over`"),
    PARAM("wave", A_FX, OPT, -MAX_SPEED, MAX_SPEED, "px", NULL,
          "distance the bullet swings to each side of its path; needs `over` and `every`"),
    PARAM("orbit", A_FX, OPT, 0, MAX_SPEED, "px", NULL,
          "radius of a circle around `at`, or around the thing in `around` if `at` is omitted; needs `over`"),
    PARAM("ease", A_EASE, OPT, 0, 0, NULL, NULL, "easing of `go_to`"),
    PARAM("spin", A_DIR, OPT, 0, 0, NULL, NULL, "degrees per frame around the centre of `polar` or `orbit`, clockwise"),
    PARAM("at", A_TABLE, OPT, 0, 0, NULL, NULL, "centre of `polar` or `orbit`, a point { x, y } in the field"),
    PARAM("every", A_INT, OPT, 1, 65535, "frames", NULL, "period of `wave`"),
    PARAM("phase", A_DIR, OPT, 0, 0, NULL, NULL, "phase at which `wave` starts; 360 degrees is one period"),
    PARAM("radius_to", A_FX, OPT, 0, MAX_SPEED, "px", NULL, "radius that `orbit` reaches at the end of `over`"),
    PARAM("bounce", A_COUNT, OPT, 1, 65534, "times", NULL,
          "number of bounces off the edges of the field; the steps nested in this one run after each bounce"),
    PARAM("walls", A_STR, OPT, 1, 31, NULL, NULL,
          "edges to bounce off: any of left, right, top and bottom, separated by spaces; all four if omitted"),
    PARAM("emit", A_TABLE, OPT, 0, 0, NULL, NULL, "bullets or shots to fire from the bullet's position"),
    PARAM("path", A_ROUTE, OPT, 0, 0, NULL, NULL, "route to follow, moved so that it starts at the bullet's position"),
    PARAM("mirror", A_BOOL, OPT, 0, 0, NULL, "false", "mirror `path` left to right"),
    PARAM("wait_for", A_TABLE, OPT, 0, 0, NULL, NULL,
          "what to wait for while flying unchanged: a position, a nearby target or a signal"),
};

enum { MAX_STEPS = 1024, MAX_ROUNDS = 4096 };

/* A program being read. */
struct reader {
    struct motion_step steps[MAX_STEPS];
    uint32_t n;
    int bounces; /* open ones */
    bool fine;
    uint32_t brief; /* after which row the last step stands that lasts, but may be over at once */
    const char
        *brief_is; /* which, and when: "`orbit` takes no time once its thing has despawned"; NULL: there was none */
};

static const char DEF[] = "motion.def";

static struct motion_step *add_step(lua_State *L, struct reader *r)
{
    if (r->n == MAX_STEPS)
        api_error(L, DEF, "too many steps (at most %d)", MAX_STEPS);
    r->steps[r->n] = (struct motion_step){ 0 };
    return &r->steps[r->n++];
}

static void step_error(lua_State *L, int step, const char *message)
{
    api_error(L, DEF, "step %d: %s", step, message);
}

static const struct api_fields step_fields = { step_keys, M_KEYS, NAME_LISTS };

static bool knows_step_key(lua_State *L, const char *key, const void *of)
{
    vm_charge(L, 1);
    return lua_type(L, -1) == LUA_TNUMBER || api_knows_field(L, key, of);
}

/* The error for the unknown key of a step on top. */
static void unknown_key(lua_State *L, int step, const char *where)
{
    const char *name = luakeys_text(L, -1);

    if (name && (!strcmp(name, "fine") || !strcmp(name, "name")))
        api_error(L, DEF, "step %d: %s is not part of a step; write { %s = ..., { ... }, { ... } }", step, name, name);
    api_refuse_key(L, where, &step_fields);
}

/* The number of a step that key k sets, if a value's name may stand for it; else STEP_NUMBERS. */
static enum step_number step_number(int k)
{
    switch (k) {
    case M_WAIT:
    case M_OVER:
        return NUMBER_OVER;
    case M_BANK:
        return NUMBER_BANK;
    case M_DIR:
        return NUMBER_DIR;
    case M_TURN:
        return NUMBER_TURN;
    case M_HOME:
        return NUMBER_HOME;
    case M_SPEED:
        return NUMBER_SPEED;
    case M_ACCEL:
        return NUMBER_ACCEL;
    case M_POLAR:
        return NUMBER_SPEED;
    case M_WAVE:
    case M_ORBIT:
        return NUMBER_SIZE;
    case M_RADIUS_TO:
        return NUMBER_SIZE_TO;
    case M_SPIN:
        return NUMBER_TURN;
    case M_EVERY:
        return NUMBER_COUNT;
    case M_PHASE:
        return NUMBER_DIR;
    default:
        return STEP_NUMBERS;
    }
}

uint64_t api_step_name(lua_State *L, int step, const char *key, int at)
{
    const struct board *b = vm_board(L);
    const char *name = lua_tostring(L, at), *found = NULL;
    int bullet = api_names_find(L, N_BULLET_VALUE, name), shot = api_names_find(L, N_SHOT_VALUE, name);
    int best = EDIT_FAR;

    if (bullet != NO_SLOT || shot != NO_SLOT)
        return (uint64_t)(bullet + 1) + (uint64_t)(shot + 1) * NAMED_SHOTS;
    for (int k = 0; k < api_values(b, N_BULLET_VALUE); k++)
        api_suggest_nearer(name, board_name(b, N_BULLET_VALUE, k), &best, &found);
    for (int k = 0; k < api_values(b, N_SHOT_VALUE); k++)
        api_suggest_nearer(name, board_name(b, N_SHOT_VALUE, k), &best, &found);
    if (found)
        api_error(L, DEF, "step %d: %s: unknown value \"%s\" (did you mean \"%s\"?)", step, key, name, found);
    api_error(L, DEF, "step %d: %s: expected a number or the name of a value (value.def), got \"%s\"", step, key, name);
    return 0;
}

/* Reads the keys of the step table at `at` into v; a loop's list entries are left alone. Returns the names in it. */
static uint64_t read_keys(lua_State *L, int at, int step, struct api_value v[M_KEYS])
{
    uint64_t named = 0;
    char where[40];

    luaL_checkstack(L, M_KEYS + 8, NULL);
    snprintf(where, sizeof where, "%s: step %d", DEF, step);
    if (luakeys_push_stray(L, at, knows_step_key, &step_fields))
        unknown_key(L, step, where);
    for (int k = 0; k < M_KEYS; k++) {
        enum step_number number = step_number(k);
        v[k] = (struct api_value){ 0 };
        if (lua_getfield(L, at, step_keys[k].name) == LUA_TSTRING && number != STEP_NUMBERS) {
            named |= api_step_name(L, step, step_keys[k].name, lua_gettop(L)) << number * NAMED_BITS;
            v[k] = (struct api_value){ .given = true, .i = number == NUMBER_OVER || number == NUMBER_COUNT };
        } else
            api_check(L, where, &step_keys[k], lua_gettop(L), &v[k]);
    }
    return named;
}

/* The settings that each step that leads may have beside kind and bank. */
static const struct {
    int key;
    uint32_t may, must;
} leads[] = {
    { M_GO_TO, 1u << M_OVER | 1u << M_SPEED | 1u << M_EASE, 0 },
    { M_POLAR, 1u << M_OVER | 1u << M_SPIN | 1u << M_AT, 1u << M_OVER },
    { M_WAVE, 1u << M_OVER | 1u << M_EVERY | 1u << M_PHASE, 1u << M_OVER | 1u << M_EVERY },
    { M_ORBIT, 1u << M_OVER | 1u << M_SPIN | 1u << M_RADIUS_TO | 1u << M_AT, 1u << M_OVER },
};
enum { LEADS = sizeof leads / sizeof *leads };

static void go_to_alone(lua_State *L, const struct api_value v[M_KEYS], int step)
{
    if (v[M_OVER].given == v[M_SPEED].given)
        step_error(L, step, "`go_to` requires either `over` (frames) or `speed`");
    if (v[M_SPEED].given && v[M_EASE].given)
        step_error(L, step, "go_to: `ease` requires `over` (with `speed`, the motion is linear)");
    if (v[M_SPEED].given && v[M_SPEED].at && v[M_SPEED].f <= 0)
        step_error(L, step, "go_to: speed: expected a number above 0");
    if (v[M_OVER].i == LUA_MAXINTEGER)
        step_error(L, step, "`go_to` with `over = forever` never arrives");
}

/* The key that leads, alone but for its settings; and its settings with it alone. */
static void lead_alone(lua_State *L, const struct api_value v[M_KEYS], int step, bool fine)
{
    int found = -1;

    for (int i = 0; i < LEADS; i++)
        if (v[leads[i].key].given) {
            if (found >= 0)
                api_error(L, DEF, "step %d: `%s` and `%s` cannot be combined", step, step_keys[leads[found].key].name,
                          step_keys[leads[i].key].name);
            found = i;
        }
    const uint32_t own = 1u << M_EASE | 1u << M_SPIN | 1u << M_AT | 1u << M_EVERY | 1u << M_PHASE | 1u << M_RADIUS_TO;
    if (v[M_WALLS].given)
        step_error(L, step, "`walls` requires `bounce`");
    if (v[M_MIRROR].given)
        step_error(L, step, "`mirror` requires `path`");
    for (int k = 0; k < M_KEYS; k++) {
        if (found < 0 && v[k].given && own >> k & 1)
            api_error(L, DEF, "step %d: `%s` requires `go_to`, `polar`, `wave` or `orbit`", step, step_keys[k].name);
        if (found < 0 || k == leads[found].key)
            continue;
        const char *word = step_keys[leads[found].key].name;
        if (v[k].given && k != M_KIND && k != M_BANK && !(leads[found].may >> k & 1))
            api_error(L, DEF, "step %d: `%s` cannot be combined with `%s`", step, step_keys[k].name, word);
        if (!v[k].given && leads[found].must >> k & 1)
            api_error(L, DEF, "step %d: `%s` requires `%s`", step, word, step_keys[k].name);
    }
    if (found >= 0 && fine)
        api_error(L, DEF, "step %d: `%s` cannot be used in a fine motion (this step is always exact)", step,
                  step_keys[leads[found].key].name);
    if (v[M_GO_TO].given)
        go_to_alone(L, v, step);
    if (v[M_RADIUS_TO].given && v[M_OVER].i == LUA_MAXINTEGER)
        step_error(L, step, "`radius_to` with `over = forever` never arrives");
    if (v[M_ORBIT].given && !v[M_AT].given && !vm_board(L)->bullets.around && !vm_board(L)->shots.around)
        step_error(L, step,
                   "`orbit` requires `at = { x, y }`; to orbit a thing, add `around = true` to `board` in rom.lua");
}

/* A number of a place: itself, or a value's name. */
static uint64_t read_part(lua_State *L, int step, const char *key, int at, enum step_number number, fx *out)
{
    struct api_param p = { key, A_FX, REQ, -WORLD, WORLD, "px", NULL, NULL };
    struct api_value v = { 0 };
    char where[40];

    if (lua_type(L, at) == LUA_TSTRING)
        return api_step_name(L, step, key, at) << number * NAMED_BITS;
    snprintf(where, sizeof where, "%s: step %d", DEF, step);
    api_check(L, where, &p, at, &v);
    *out = v.f;
    return 0;
}

/* { x, y } at v, of go_to or at; returns the names in it. */
static uint64_t read_place(lua_State *L, int step, const struct api_value *v, const char *key, struct motion_step *s)
{
    int keys = 0, top = lua_gettop(L);

    if (!v->given)
        return 0;
    for (lua_pushnil(L); lua_next(L, v->at); lua_pop(L, 1))
        keys++;
    if (keys != 2 || lua_rawlen(L, v->at) != 2)
        api_error(L, DEF, "step %d: %s: expected { x, y }", step, key);
    lua_rawgeti(L, v->at, 1);
    lua_rawgeti(L, v->at, 2);
    uint64_t named = read_part(L, step, key, top + 1, NUMBER_X, &s->x);
    named |= read_part(L, step, key, top + 2, NUMBER_Y, &s->y);
    lua_settop(L, top);
    return named;
}

/* Sets what a step that leads has beside the others; returns the names in it. */
static uint64_t fill_lead(lua_State *L, struct motion_step *s, const struct api_value v[M_KEYS], int step, bool fine)
{
    s->size = v[M_WAVE].given ? v[M_WAVE].f : v[M_ORBIT].f;
    s->size_to = v[M_RADIUS_TO].f;
    s->count = (uint16_t)v[M_EVERY].i;
    s->how = (uint8_t)(v[M_EASE].i | (v[M_AT].given ? HOW_AT : 0) | (v[M_RADIUS_TO].given ? HOW_TO : 0) |
                       (v[M_GO_TO].given && v[M_SPEED].given ? HOW_SPEED : 0));
    if (v[M_SPIN].given)
        s->turn = (int32_t)v[M_SPIN].a;
    if (v[M_PHASE].given)
        s->dir = v[M_PHASE].a;
    if (v[M_POLAR].given)
        s->speed = api_units(fine, &v[M_POLAR]);
    if (s->does & DOES_GO_TO) /* speed is its setting */
        s->does &= ~(uint32_t)DOES_SPEED;
    return read_place(L, step, &v[M_GO_TO], "go_to", s) | read_place(L, step, &v[M_AT], "at", s);
}

/* v's frames; forever is the most there are. */
static uint32_t frames(const struct api_value *v)
{
    return v->i > 1000000000 ? UINT32_MAX : (uint32_t)v->i;
}

static void fill_step(lua_State *L, struct motion_step *s, const struct api_value v[M_KEYS], uint64_t named, int step,
                      bool fine)
{
    static const uint32_t does[M_KEYS] = { DOES_WAIT,  DOES_KIND,  DOES_BANK,  DOES_DIR,  DOES_AIM, DOES_TURN,
                                           DOES_HOME,  DOES_SPEED, DOES_ACCEL, DOES_DIE,  0,        0,
                                           DOES_GO_TO, DOES_POLAR, DOES_WAVE,  DOES_ORBIT };

    for (int k = 0; k < M_KEYS; k++)
        if (v[k].given && !(step_keys[k].type == A_BOOL && !v[k].i))
            s->does |= does[k];
    lead_alone(L, v, step, fine);
    if (!s->does)
        step_error(L, step, "does nothing");
    if (s->does & DOES_WAIT && (s->does != DOES_WAIT || v[M_OVER].given))
        step_error(L, step, "`wait` cannot be combined with anything else");
    if (s->does & DOES_DIR && v[M_OVER].given)
        step_error(L, step, "`dir` takes effect immediately; with `over`, use `turn`, `aim` or `home`");
    if (s->does & DOES_SPEED && !v[M_GO_TO].given && v[M_OVER].i == LUA_MAXINTEGER)
        step_error(L, step, "`speed` with `over = forever` never arrives");
    if (s->does & DOES_DIE && v[M_OVER].given)
        step_error(L, step, "`die` takes effect immediately; put a `wait` before it");
    if (s->does & DOES_HOME && !v[M_OVER].given)
        step_error(L, step, "`home` requires `over` (frames)");
    s->over = frames(&v[s->does & DOES_WAIT ? M_WAIT : M_OVER]);
    s->kind = (uint16_t)v[M_KIND].i;
    s->bank = (uint8_t)v[M_BANK].i;
    s->dir = v[M_DIR].a;
    s->turn = (int32_t)v[M_TURN].a;
    trig_from_degrees(v[M_HOME].n, &s->home);
    s->speed = api_units(fine, &v[M_SPEED]);
    s->accel = api_units(fine, &v[M_ACCEL]);
    named |= fill_lead(L, s, v, step, fine);
    s->named = named;
    s->does |= named ? DOES_NAMED : 0;
}

/* The error for a loop, whose first row is `open`, that may run on without a frame of time. */
static void untimed(lua_State *L, const struct reader *r, uint32_t open, const char *what, int step)
{
    if (r->brief_is && r->brief > open)
        api_error(L, DEF, "step %d: %s (%s: add { wait = 1 })", step, what, r->brief_is);
    step_error(L, step, what);
}

/* Checks that a loop without a frame of time inside ends, and soon. Returns the steps it runs at once. */
static uint64_t loop_work(lua_State *L, const struct reader *r, uint32_t open, bool timed, uint64_t inside,
                          int64_t count, int step)
{
    uint64_t rounds = timed ? 1 : (uint64_t)count;

    if (!timed && count == LUA_MAXINTEGER)
        untimed(L, r, open, "infinite loop: with `loop = forever`, at least one step must take time", step);
    if (rounds > MAX_ROUNDS || inside * rounds > MAX_ROUNDS)
        untimed(L, r, open, "this loop runs too many steps in one frame; at least one of them must take time", step);
    return inside * rounds;
}

/* The step that was read last may be over at once; `is` says when. */
static bool is_brief(struct reader *r, const char *is)
{
    r->brief = r->n;
    r->brief_is = is;
    return false;
}

/* Does time pass in the step that was read last? */
static bool takes_time(struct reader *r, const struct motion_step *s)
{
    if (s->does & DOES_ORBIT && !(s->how & HOW_AT))
        return is_brief(r, "`orbit` takes no time once its thing has despawned");
    return s->over > 0 || s->how & HOW_SPEED;
}

/* A step whose word is `word`, beside which may stand what `may` has bits of. */
static void word_alone(lua_State *L, const struct api_value v[M_KEYS], int step, int word, uint32_t may)
{
    for (int k = 0; k < M_KEYS; k++)
        if (v[k].given && k != word && !(may >> k & 1))
            api_error(L, DEF, "step %d: `%s` cannot be combined with `%s`", step, step_keys[k].name,
                      step_keys[word].name);
}

/* Adds the legs of a route, kind and bank with the first. */
static void read_path(lua_State *L, struct reader *r, const struct api_value v[M_KEYS], int step)
{
    const uint32_t before = r->n;
    struct motion_step leg = { .kind = (uint16_t)v[M_KIND].i, .bank = (uint8_t)v[M_BANK].i };
    struct api_leg at = { .route = v[M_PATH].at, .mirror = v[M_MIRROR].i };

    word_alone(L, v, step, M_PATH, 1u << M_MIRROR | 1u << M_KIND | 1u << M_BANK);
    if (r->fine)
        step_error(L, step, "`path` cannot be used in a fine motion (this step is always exact)");
    leg.does = (v[M_KIND].given ? DOES_KIND : 0u) | (v[M_BANK].given ? DOES_BANK : 0u);
    while (api_step_leg(L, step, &at, &leg)) {
        *add_step(L, r) = leg;
        leg = (struct motion_step){ 0 };
    }
    if (r->n == before)
        step_error(L, step, "path: the route has no length; add a second point");
}

/* Reads a step that holds no others; does time pass in it? */
static bool read_step(lua_State *L, struct reader *r, const struct api_value v[M_KEYS], uint64_t named, int step)
{
    struct motion_step *s, rows[EMIT_ROWS];
    struct motion_emit e;

    if (v[M_EMIT].given) {
        word_alone(L, v, step, M_EMIT, 0);
        api_step_emit(L, step, v[M_EMIT].at, &e);
        motion_emit_steps(&e, rows);
        for (int k = 0; k < EMIT_ROWS; k++)
            *add_step(L, r) = rows[k];
        return false;
    }
    if (v[M_PATH].given) {
        read_path(L, r, v, step);
        return true;
    }
    s = add_step(L, r);
    if (v[M_WAIT_FOR].given) {
        word_alone(L, v, step, M_WAIT_FOR, 0);
        api_step_await(L, step, v[M_WAIT_FOR].at, s);
        return s->how == HOW_SIGNAL || is_brief(r, "`wait_for` takes no time if its condition already holds");
    }
    fill_step(L, s, v, named, step, r->fine);
    return takes_time(r, s);
}

static uint64_t read_steps(lua_State *L, struct reader *r, int at, int depth, bool *timed);

/* The walls that a list of words names. */
static uint8_t read_walls(lua_State *L, int step, const struct api_value *v)
{
    static const char *const words[] = { "left", "right", "top", "bottom" };
    uint8_t walls = 0;

    if (!v->given)
        return HOW_WALLS;
    for (const char *at = lua_tostring(L, v->at); *at; at += strspn(at, " ")) {
        size_t n = 0;
        int k = 0;
        while (at[n] && at[n] != ' ')
            n++;
        while (k < 4 && (strlen(words[k]) != n || strncmp(words[k], at, n)))
            k++;
        if (k == 4)
            api_error(L, DEF, "step %d: walls: expected one or more of \"left right top bottom\", got \"%s\"", step,
                      lua_tostring(L, v->at));
        walls |= (uint8_t)(1 << k);
        at += n;
    }
    if (!walls)
        step_error(L, step, "walls: expected one or more of \"left right top bottom\"");
    return walls;
}

/* The way to a wall, inside the loop of bounces that step `open` opens. */
static void add_bounce(lua_State *L, struct reader *r, const struct api_value v[M_KEYS], int step)
{
    if (r->fine)
        step_error(L, step, "`bounce` cannot be used in a fine motion (this step is always exact)");
    if (r->bounces++)
        step_error(L, step, "`bounce` cannot be nested in `bounce`");
    r->steps[r->n - 1].does |= DOES_BOUNCE;
    struct motion_step *s = add_step(L, r);
    s->does = DOES_BOUNCE;
    s->how = read_walls(L, step, &v[M_WALLS]);
    s->over = v[M_OVER].given ? frames(&v[M_OVER]) : UINT32_MAX;
}

/* Reads a loop or bounces, with the steps inside, from the table at `at`. Returns the steps it runs at once. */
static uint64_t read_loop(lua_State *L, struct reader *r, int at, int depth, const struct api_value v[M_KEYS], int step,
                          bool *timed)
{
    const int word = v[M_BOUNCE].given ? M_BOUNCE : M_LOOP;
    const bool bounce = word == M_BOUNCE;
    const uint32_t open = r->n;
    bool inner;

    if (depth == MOTION_DEPTH)
        step_error(L, step, "loops nested more than 4 deep");
    for (int k = 0; k < M_KEYS; k++)
        if (v[k].given && k != word && !(bounce && (k == M_WALLS || k == M_OVER)))
            api_error(L, DEF, "step %d: `%s` cannot be combined with `%s`", step, step_keys[k].name,
                      step_keys[word].name);
    struct motion_step *s = add_step(L, r);
    s->does = DOES_LOOP;
    s->depth = (uint8_t)depth;
    s->count = v[word].i == LUA_MAXINTEGER ? MOTION_FOREVER : (uint16_t)v[word].i;
    if (bounce)
        add_bounce(L, r, v, step);
    uint64_t inside = read_steps(L, r, at, depth + 1, &inner);
    r->bounces -= bounce;
    inner |= bounce;
    *timed |= inner && v[word].i > 0;
    s = add_step(L, r);
    *s = (struct motion_step){ .does = DOES_NEXT, .depth = (uint8_t)depth, .jump = (uint16_t)(open + 1) };
    r->steps[open].jump = (uint16_t)r->n;
    if (bounce)
        r->steps[open + 1].jump = (uint16_t)r->n;
    return loop_work(L, r, open, inner, inside, v[word].i, step);
}

/* Reads the list of steps in the table at `at`; returns the most steps it runs without time passing. *timed: time
 * passes. */
static uint64_t read_steps(lua_State *L, struct reader *r, int at, int depth, bool *timed)
{
    uint64_t work = 1;
    int n = (int)lua_rawlen(L, at);

    *timed = false;
    for (int i = 1; i <= n; i++) {
        struct api_value v[M_KEYS];
        int top = lua_gettop(L);
        if (lua_rawgeti(L, at, i) != LUA_TTABLE)
            step_error(L, i, "expected a table");
        uint64_t named = read_keys(L, top + 1, i, v);
        if (!v[M_LOOP].given && !v[M_BOUNCE].given) {
            if (lua_rawlen(L, top + 1))
                step_error(L, i, "nested steps require `loop = n` or `bounce = n`");
            *timed |= read_step(L, r, v, named, i);
        } else
            work += read_loop(L, r, top + 1, depth, v, i, timed);
        work++;
        lua_settop(L, top);
    }
    return work;
}

bool api_step_word(const char *name)
{
    for (int k = 0; k < M_KEYS; k++)
        if (!strcmp(name, step_keys[k].name))
            return true;
    return false;
}

enum { HEAD_NAME, HEAD_FINE, HEADS };

/* What is next to the steps: name and fine. Returns the name or NULL. */
static const char *read_head(lua_State *L, struct reader *r)
{
    static const struct api_param head[] = { PARAM("name", A_STR, OPT, 0, 0, NULL, NULL, ""),
                                             PARAM("fine", A_BOOL, OPT, 0, 0, NULL, "false", "") };
    static const struct api_fields fields = { head, HEADS, NAME_LISTS };
    struct api_value v[HEADS] = { { 0 } };

    if (luakeys_push_stray(L, 1, knows_step_key, &fields)) {
        const char *key = luakeys_text(L, -1);
        if (key && api_step_word(key))
            api_error(L, DEF, "unknown argument \"%s\" (steps are tables: { { %s = ... } })", key, key);
        api_refuse_key(L, DEF, &fields);
    }
    for (int i = 0; i < HEADS; i++) {
        lua_getfield(L, 1, head[i].name);
        api_check(L, DEF, &head[i], lua_gettop(L), &v[i]);
    }
    r->n = 0;
    r->bounces = 0;
    r->brief_is = NULL;
    r->fine = v[HEAD_FINE].i;
    return v[HEAD_NAME].given ? lua_tostring(L, v[HEAD_NAME].at) : NULL;
}

static int motion_def(lua_State *L, struct board *b, struct api_value *v)
{
    struct reader r;
    bool timed;

    (void)v;
    luaL_checktype(L, 1, LUA_TTABLE);
    const char *name = read_head(L, &r);
    if (!lua_rawlen(L, 1) && !r.fine)
        api_error(L, DEF, "expected at least one step");
    if (read_steps(L, &r, 1, 0, &timed) > MAX_ROUNDS)
        api_error(L, DEF, "too many steps in one frame");
    uint32_t refused_before = b->steps.s.refused; /* tells which of the two pools was full */
    int32_t m = motion_define(&b->motions, &b->steps, r.steps, r.n, r.fine);
    if (m == NO_SLOT)
        board_full(b, b->steps.s.refused > refused_before ? &b->steps.s : &b->motions.s);
    if (name && api_names_find(L, N_MOTION, name) != (m == NO_SLOT ? NO_MOTION : m))
        api_names_declare(L, N_MOTION, DEF, name, m == NO_SLOT ? NO_MOTION : m);
    script_fold(b, (uint64_t)(uint32_t)m);
    lua_pushinteger(L, m == NO_SLOT ? handle_of(H_MOTION, 0, 0) : handle_of(H_MOTION, 1, (uint32_t)m));
    return 1;
}

static void no_get(lua_State *L, struct board *b, uint32_t slot, int p)
{
    (void)b, (void)slot, (void)p;
    lua_pushnil(L);
}

const struct api_thing api_motion_thing = { "motion", NULL, 0, no_get, NULL };

static const struct api_param motion_params[] = { PARAM(
    "steps", A_TABLE, REQ, 0, 0, NULL, NULL,
    "list of steps, run in order; `name = STRING` and `fine = true` can be set in the same table") };

/* Patterns take the parameters of these two, or of lasers. */
#define BULLET_FIRE                                                                                                    \
    {                                                                                                                  \
        "bullet.fire", bullet_fire_run, PARAMS(bullet_fire), 0, API_CHANGES | API_VALUES, "bullet",                    \
            HELP("fires one bullet from a position or a thing")                                                        \
    }
#define SHOT_FIRE                                                                                                      \
    {                                                                                                                  \
        "shot.fire", shot_fire_run, PARAMS(shot_fire), 0, API_CHANGES | API_VALUES, "shot",                            \
            HELP("fires one player shot from a position or a thing")                                                   \
    }
const struct api_entry api_fire_bullet = BULLET_FIRE, api_fire_shot = SHOT_FIRE;

#define CLEAR_ONE(thing)                                                                                               \
    API_VERB(thing ":clear", api_clear_self, api_clear_self_params, 1, NULL, "removes it and leaves a spark or an item")
#define CLEAR_GROUP(thing)                                                                                             \
    API_VERB(thing ":clear", api_clear_group, api_clear_group_params, 1, "count",                                      \
             "removes the entire group, or only its members in a circle, a box or a line; returns the number removed")
/* The verbs of one and of a group; `it` names who does it. */
#define FLYING_VERBS(thing, it, target, CLEAR)                                                                         \
    API_VERB(thing ":aim", verb_aim, self_add, 2, NULL, "points " it " at the nearest " target),                       \
        API_VERB(thing ":turn", verb_turn, self_by, 2, NULL, "turns " it " by an angle"),                              \
        API_VERB(thing ":shift", verb_shift, self_shift, 3, NULL,                                                      \
                 "teleports " it " by a distance, without collisions on the way"),                                     \
        CLEAR(thing), API_VERB(thing ":remove", verb_remove, self_only, 1, NULL, "removes " it " and leaves nothing")

static const struct api_entry entries[] = {
    { "bullet.def", bullet_define, PARAMS(bullet_def), 1, API_CHANGES | API_LOAD, NULL,
      HELP("declares a kind of bullet: its sprite, its hitbox and its rules") },
    BULLET_FIRE,
    API_GROUPS("bullet", bullet_group, bullet_each),
    { "bullet.clear", api_clear, PARAMS(api_clear_params), 0, API_CHANGES, "count",
      HELP("removes all bullets, or only those in a circle, a box or a line; returns the number removed") },
    { "bullet.meet", api_meet, PARAMS(api_meet_params), 2, API_CHANGES | API_LOAD, NULL,
      HELP("makes bullets with one tag collide with bullets with another tag; needs `board = { meet = true }`") },
    { "bullet.sweep", NULL, PARAMS(bullet_sweep), 0, API_LUA, "task",
      HELP("starts a task that removes the bullets in a growing circle; the task has the same owner as the calling "
           "task") },
    FLYING_VERBS("bullet", "it", "player", CLEAR_ONE),
    FLYING_VERBS("group", "each bullet", "player", CLEAR_GROUP),
    API_VERB("group:signal", verb_signal, self_group, 1, NULL,
             "resumes every bullet whose motion waits for a signal to the group's tag (`wait_for`); a group without a "
             "tag signals all tags"),
    { "motion.def", motion_def, PARAMS(motion_params), 1, API_CHANGES, "motion",
      HELP("creates a motion program: a list of steps that any number of bullets can run") },
    { "motion.def step", NULL, PARAMS(step_keys), 0, API_LUA | API_SYS, NULL,
      HELP("one step; instead of any number, you can write the name of a value (value.def)") },
    { "motion.def emit", NULL, PARAMS(api_emit_params), 0, API_LUA | API_SYS, NULL,
      HELP("what to fire from the position of the bullet") },
    { "motion.def wait_for", NULL, PARAMS(api_await_params), 0, API_LUA | API_SYS, NULL,
      HELP("condition to wait for: exactly one of `x`, `y`, `near` and `tag`") },
    { "shot.def", shot_define, PARAMS(shot_def), 1, API_CHANGES | API_LOAD, NULL,
      HELP("declares a kind of player shot: its sprite, its hitbox and its damage") },
    SHOT_FIRE,
    API_GROUPS("shot", shot_group, shot_each),
    FLYING_VERBS("shot", "it", "enemy", CLEAR_ONE),
    FLYING_VERBS("shots", "each shot", "enemy", CLEAR_GROUP),
    API_VERB("shots:signal", verb_signal, self_group, 1, NULL,
             "resumes every shot whose motion waits for a signal to the group's tag (`wait_for`); a group without a "
             "tag signals all tags"),
};
const struct api_module api_bullet = { entries, sizeof entries / sizeof *entries };
