/*
 * api_bullet.c - the Lua tables bullet and shot.
 */
#include "../../base/trig.h"
#include "../../machine/lasers_run.h"
#include "../../machine/sound.h"
#include "../events_run.h"
#include "api_parts.h"

/* ---- kinds ---- */

/* Indices shared by bullet_def_params and shot_def_params, of bullet_def_params only, and of shot_def_params only. */
enum { D_NAME, D_SPRITE, D_HIT, D_SPIN = 8 };
enum { D_CLOUD = 10, D_CLEARABLE = 12, D_HP, D_SCORE, D_DROPS = 17, D_BULLET_SCALE = 19 };
enum { D_PIERCE = 11, D_EVERY, D_SHOT_SCALE };
enum { SCALE_PARAM_COUNT = 2 };

enum { MAX_ORDER = 100 };

static const char hp_disabled[] = "bullet hp is disabled; add `hp = true` to `board` in rom.lua";

/* Parameters of bullet.def and shot.def. */
#define KIND_SHAPE_PARAMS(kinds)                                                                                       \
    REQUIRED("name", A_STR, "name of the kind, used as `kind = NAME`; must be new"),                                   \
        REQUIRED("sprite", A_SPRITE, "sprite to draw", STORED(kinds.sprite)),                                          \
        PARAM("hit", A_HIT_SHAPE, REQ, HIT_BULLETS, 0, NULL, NULL,                                                     \
              "hitbox, relative to the thing's position; \"none\" never hits"),                                        \
        BANK(OPT, "0", "number added to the palette bank of its sprite", STORED(kinds.bank))
#define KIND_FLIGHT_PARAMS(kinds)                                                                                      \
    DEFAULT("turns", A_BOOL, "false",                                                                                  \
            "rotate the sprite to the direction of flight; the sprite needs `rotations` in rom.lua",                   \
            BITS_OF(kinds.flags, KIND_TURNS)),                                                                         \
        DEFAULT(                                                                                                       \
            "swept", A_BOOL, "true",                                                                                   \
            "check the entire path flown in each frame for hits; if false, check only the position at the end of the " \
            "frame",                                                                                                   \
            BITS_OF(kinds.flags, KIND_SWEPT)),                                                                         \
        BLEND_PARAM(kinds.flags, KIND_BLEND),                                                                          \
        DEFAULT("spin", A_DIR, "0",                                                                                    \
                "degrees the sprite rotates per frame, clockwise; the sprite needs `rotations` in rom.lua",            \
                STORED(kinds.spin)),                                                                                   \
        PARAM("order", A_INT, OPT, -MAX_ORDER, MAX_ORDER, NULL, "0", "drawing order; higher is drawn over lower",      \
              STORED(kinds.draw_order))
#define KIND_SCALE_PARAMS(kinds)                                                                                       \
    SCALE(OPT, "1", "factor on the size of its sprite; needs `board = { transforms = true }`", STORED(kinds.scale)),   \
        DEFAULT("scale_hit", A_BOOL, "false",                                                                          \
                "apply `scale` to its hitbox, too; needs `board = { transforms = true }`")

static const struct api_param bullet_def_params[] = {
    KIND_SHAPE_PARAMS(bullet_kinds),
    DEFAULT("graze", A_BOOL, "true", "whether players can graze it", BITS_OF(bullet_kinds.flags, KIND_GRAZE)),
    KIND_FLIGHT_PARAMS(bullet_kinds),
    [D_CLOUD] =
        OPTIONAL("cloud", A_SPRITE, "sprite shown instead of `sprite` during the bullet's delay; nil keeps `sprite`"),
    OPTIONAL("vanish", A_SPARK_KIND,
             "kind of spark left when the bullet is cleared, unless the call that clears it names another kind; nil "
             "leaves none",
             STORED(bullet_kinds.vanish_spark)),
    [D_CLEARABLE] = DEFAULT("clearable", A_BOOL, "true", "whether it can be cleared without `all = true`"),
    PARAM("hp", A_COUNT, OPT, 1, INT32_MAX, NULL, NULL,
          "damage it takes from shots before it is destroyed; without `hp`, shots pass through it",
          STORED(bullet_kinds.hp)),
    PARAM("score", A_INT, OPT, 0, 1e12, "points", "0", "points for the player who destroys it; needs `hp`",
          STORED(bullet_kinds.score)),
    OPTIONAL("spark", A_SPARK_KIND, "kind of spark left when the bullet's hp runs out; needs `hp`",
             STORED(bullet_kinds.spark)),
    OPTIONAL("on_death", A_FUNC,
             "on_death(b, p): called with the bullet and the player whose shot destroyed it; p may be nil; needs `hp`",
             PROPERTY("bullet's on_death")),
    [D_DROPS] = OPTIONAL("drops", A_TABLE, "items dropped when the bullet's hp runs out, { NAME = count }; needs `hp`"),
    DEFAULT("harmless", A_BOOL, "false", "if true, it can't hit players or be grazed",
            BITS_OF(bullet_kinds.flags, KIND_HARMLESS)),
    [D_BULLET_SCALE] = KIND_SCALE_PARAMS(bullet_kinds),
};

static const struct api_param shot_def_params[] = {
    KIND_SHAPE_PARAMS(shot_kinds),
    PARAM("damage", A_INT, OPT, 0, 1000000, "hp", "1", "damage to each enemy or bullet it hits",
          STORED(shot_kinds.damage)),
    KIND_FLIGHT_PARAMS(shot_kinds),
    DEFAULT(
        "cancels", A_BOOL, "false",
        "whether it removes one clearable bullet that it touches; a bullet with `hp` takes the shot's damage instead",
        BITS_OF(shot_kinds.flags, KIND_CANCELS)),
    [D_PIERCE] =
        PARAM("pierce", A_COUNT, OPT, 0, 1000000, NULL, "0",
              "number of hits that the shot survives; the next hit removes it; with forever, no hit removes it",
              STORED(shot_kinds.pierce_hits)),
    PARAM("every", A_COUNT, OPT, 1, 1000000, "frames", NULL,
          "frames before the shot can hit the same target again; defaults to 6; needs `pierce`"),
    [D_SHOT_SCALE] = KIND_SCALE_PARAMS(shot_kinds),
};

/* Appends the ROW_CLOUD row of the kind declared next. */
static void declare_cloud(lua_State *L, struct bullet_kinds *k)
{
    const struct api_shape none = { .shape = SHAPE_NONE, .rows = 1 };
    const struct shape_columns columns = { k->shape, k->a, k->b, k->x, k->y };

    api_declare_kind(L, "bullet.def", &k->s, &columns, &none);
}

/* Fills the cloud row of kind i. */
static void set_cloud(struct bullet_kinds *k, int i, uint16_t sprite)
{
    const int cloud = i + ROW_CLOUD;

    k->sprite[cloud] = sprite;
    k->bank[cloud] = k->bank[i];
    k->draw_order[cloud] = k->draw_order[i];
    if (k->scale)
        k->scale[cloud] = k->scale[i];
    k->flags[cloud] = (uint16_t)(KIND_IS_CLOUD_ROW | (k->flags[i] & (KIND_TURNS | KIND_BLEND)));
    k->flags[i] |= KIND_HAS_CLOUD;
}

/* Declares a kind of bullet or shot from the arguments common to bullet.def and shot.def; returns the kind's index. */
static int define_kind(lua_State *L, struct bullet_kinds *k, enum name_kind names, const char *entry,
                       struct api_value *v)
{
    const int scale = names == N_BULLET ? D_BULLET_SCALE : D_SHOT_SCALE;
    struct api_shape shape = api_read_hit_shape(L, entry, v[D_HIT].at, HIT_BULLETS);

    api_check_transforms(L, v, scale, SCALE_PARAM_COUNT);
    if (v[scale + 1].i)
        api_scale_hit_shape(L, entry, &shape, (int32_t)v[scale].i);
    if (v[D_SPIN].a)
        api_check_rotations(L, entry, "spin", &v[D_SPRITE]);
    vm_reserve(L, &k->s, MAX_KIND_ROWS);
    const struct shape_columns columns = { k->shape, k->a, k->b, k->x, k->y };
    int32_t i = api_declare_kind(L, entry, &k->s, &columns, &shape);
    api_names_declare(L, names, entry, lua_tostring(L, v[D_NAME].at), i);
    api_store_arguments(L, vm_board(L), i, v);
    return i;
}

/* Sets a kind's hp and the effects of its death. */
static void define_hp(lua_State *L, struct board *b, int i, const struct api_value *v)
{
    struct bullet_kinds *k = &b->bullet_kinds;

    for (int p = D_SCORE; p <= D_DROPS; p++)
        if (v[p].given && !v[D_HP].given)
            api_error(L, "bullet.def", "%s: requires `hp`", bullet_def_params[p].name);
    if (!v[D_HP].given)
        return;
    if (!k->hp)
        api_error(L, "bullet.def", "hp: %s", hp_disabled);
    if (v[D_DROPS].given) {
        api_push_folded_drops(L, "bullet.def", v[D_DROPS].at);
        events_set_property(L, (uint16_t)i, "bullet's drops");
    }
}

static int bullet_define(lua_State *L, struct board *b, struct api_value *v)
{
    vm_reserve(L, &b->bullet_kinds.s, MAX_KIND_ROWS);
    if (v[D_CLOUD].given)
        declare_cloud(L, &b->bullet_kinds);
    int i = define_kind(L, &b->bullet_kinds, N_BULLET, "bullet.def", v);

    if (!v[D_CLEARABLE].i)
        b->bullet_kinds.flags[i] |= KIND_FIXED;
    define_hp(L, b, i, v);
    if (v[D_CLOUD].given)
        set_cloud(&b->bullet_kinds, i, (uint16_t)v[D_CLOUD].i);
    return 0;
}

/* Sets the piercing of a kind of shot (`pierce` and `every`). */
static void define_pierce(lua_State *L, struct bullet_kinds *k, int i, const struct api_value *v)
{
    enum { DEFAULT_REHIT_INTERVAL = 6 };

    if (v[D_PIERCE].i && !k->pierce_hits)
        api_error(L, "shot.def", "pierce: " API_DISABLED_FORMAT,
                  "piercing is disabled; add `pierce = true` to `board`");
    if (v[D_EVERY].given && !v[D_PIERCE].i)
        api_error(L, "shot.def", "every: requires `pierce`");
    if (k->pierce_hits)
        k->rehit_interval[i] = v[D_EVERY].given ? api_to_count(&v[D_EVERY]) : DEFAULT_REHIT_INTERVAL;
}

static int shot_define(lua_State *L, struct board *b, struct api_value *v)
{
    define_pierce(L, &b->shot_kinds, define_kind(L, &b->shot_kinds, N_SHOT, "shot.def", v), v);
    return 0;
}

/* ---- firing ---- */

void api_check_around(lua_State *L, const struct bullets *s, const char *entry, const struct api_value *around)
{
    if (around->given && !s->orbit_target)
        api_error(L, entry, "around: orbits around things are disabled; add `around = true` to `board` in rom.lua");
}

#define FIRE_PARAMS(kind_type, def_dir)                                                                                \
    REQUIRED("kind", kind_type, "declared kind to fire"),                                                              \
        SPEED("speed", A_FX, UNLESS_VXY, "speed of flight; if negative, it flies backwards"), POSITION_PARAMS,         \
        DEFAULT("dir", A_DIR, def_dir,                                                                                 \
                "direction of flight, clockwise from the right; with `aim`, the default is 0, and the angle is added " \
                "to the direction towards the target"),                                                                \
        DEFAULT("aim", A_BOOL, "false", "fire at the nearest target: a player for bullets, an enemy for shots"),       \
        BANK(OPT, NULL, "number added to the palette bank of its sprite; overrides its kind's"),                       \
        LABEL("tag", OPT, "name of a group to put it in"),                                                             \
        OPTIONAL("motion", A_MOTION, "motion program that steers it")
#define AROUND_PARAM                                                                                                   \
    THING("around", OPT, POSITION_HANDLE_KINDS,                                                                        \
          "thing that it circles in the `orbit` steps of its motion; needs `board = { around = true }`"),              \
        VXY_PARAMS

static const struct api_param bullet_fire_params[] = {
    FIRE_PARAMS(A_BULLET_KIND, "90"),
    PARAM("delay", A_INT, OPT, 0, 1e9, "frames", "0",
          "frames the bullet waits in place before it flies; until then, it is harmless and drawn as its cloud"),
    AROUND_PARAM
};
static const struct api_param shot_fire_params[] = {
    FIRE_PARAMS(A_SHOT_KIND, "270"),
    THING("by", OPT, 1 << H_PLAYER, "player who owns the shot and gets its score; defaults to the owner of `from`"),
    AROUND_PARAM
};

ang api_aim_direction(struct board *b, bool is_shot, fx x, fx y)
{
    struct targets t = board_targets(b, is_shot);

    b->vm.work += emit_aim_work(b, is_shot);
    return targets_aim(&t, x, y, is_shot ? ANG_UP : ANG_DOWN);
}

uint8_t api_find_shooter(const struct board *b, const struct api_value *owner, const struct api_value *from)
{
    const struct api_value *v = owner->given ? owner : from;

    return v->given ? board_player_of(b, v->i) : 0;
}

bool api_read_flight(lua_State *L, struct board *b, const char *entry, const struct api_value *v, bool is_shot,
                     struct bullet_spec *s)
{
    const struct bullet_kinds *kinds = is_shot ? &b->shot_kinds : &b->bullet_kinds;

    *s = (struct bullet_spec){ .speed = v[FIRE_SPEED].f,
                               .dir = v[FIRE_DIR].a,
                               .kind = (uint16_t)v[FIRE_KIND].i,
                               .bank = v[FIRE_BANK].given ? (uint8_t)v[FIRE_BANK].i : kinds->bank[v[FIRE_KIND].i],
                               .motion = v[FIRE_MOTION].given ? (uint16_t)v[FIRE_MOTION].i : 0,
                               .is_fine = v[FIRE_MOTION].given && api_motion_is_fine(b, (uint16_t)v[FIRE_MOTION].i),
                               .player =
                                   is_shot ? api_find_shooter(b, &v[FIRE_OWNER], &v[FIRE_POSITION + POSITION_FROM]) : 0,
                               .delay = is_shot ? 0 : (uint32_t)v[FIRE_DELAY].i,
                               .owner_task = tasks_current_serial(b) };
    if (!api_read_position(L, b, entry, v + FIRE_POSITION, &s->x, &s->y))
        return false;
    if (s->player && b->player.deathbomb_left[s->player - 1]) /* a hit ship cannot fire */
        return false;
    s->tag = api_read_tag(L, entry, &v[FIRE_TAG]);
    api_check_around(L, is_shot ? &b->shots : &b->bullets, entry, &v[FIRE_AROUND]);
    s->orbit_target = v[FIRE_AROUND].given ? v[FIRE_AROUND].i : 0;
    if (s->player)
        sound_play_cue(b, CUE_SHOT, b->player.x[s->player - 1]);
    return true;
}

void api_set_fired_velocity(struct bullets *s, uint32_t i, const struct api_value *vxy)
{
    const bool fine = s->flags[i] & BULLET_FINE;

    if (vxy[0].f || vxy[1].f)
        bullets_set_velocity(s, i, api_value_to_q32(fine, &vxy[0]), api_value_to_q32(fine, &vxy[1]));
}

/* bullet.fire and shot.fire. */
static int fire(lua_State *L, struct board *b, struct api_value *v)
{
    const char *entry = api_current_binding(L)->entry->name;
    const bool is_shot = entry[0] == 's';
    struct bullet_spec s;
    int32_t i = NO_SLOT;

    if (api_read_flight(L, b, entry, v, is_shot, &s)) {
        if (v[FIRE_AIM].i)
            s.dir = api_aim_direction(b, is_shot, s.x, s.y) + (v[FIRE_DIR].given ? v[FIRE_DIR].a : 0);
        i = emit_fire(b, is_shot, &s, api_value_to_q32(true, &v[FIRE_SPEED]), b->core.clock);
    }
    if (i != NO_SLOT)
        api_set_fired_velocity(is_shot ? &b->shots : &b->bullets, (uint32_t)i, v + FIRE_VX);
    if (i != NO_SLOT)
        api_set_values(b, is_shot ? N_SHOT_VALUE : N_BULLET_VALUE, (uint32_t)i, v + FIRE_FIRST_VALUE);
    lua_pushinteger(L, board_handle(b, is_shot ? H_SHOT : H_BULLET, i));
    return 1;
}

static const struct api_param bullet_sweep_params[] = {
    POSITION_PARAMS,
    THING("follow", OPT, POSITION_HANDLE_KINDS, "thing that the circle moves with; the sweep ends when the thing dies"),
    LENGTH("radius", OPT, "0", "radius of the circle at the start"),
    LENGTH("radius_to", REQ, NULL, "radius of the circle at the end"),
    PARAM("over", A_INT, REQ, 1, 65535, "frames", NULL, "duration of the sweep"),
    LABEL("tag", OPT, "remove only bullets with this tag"),
    OPTIONAL("spark", A_SPARK_KIND, "kind of spark that each bullet leaves; overrides `vanish`"),
    PARAM("hurt", A_INT, OPT, 0, INT32_MAX, "hp", "0", "damage dealt once to each enemy the circle reaches"),
    OPTIONAL("by", A_PLAYER, "player who gets the score for enemies that `hurt` kills"),
    DEFAULT("all", A_BOOL, "false", "also remove bullets with `clearable = false`"),
    OPTIONAL("items", A_ITEM_KIND, "kind of item that replaces each bullet"),
    DEFAULT("lasers", A_BOOL, "true", "also remove lasers that the circle touches"),
};

/* ---- properties ---- */

#define FLIGHT_PROPS(kind_type, pool)                                                                                  \
    COORDINATE("x", A_FX, REQ,                                                                                         \
               "horizontal position in the field; a write teleports it, without collisions on the way", SETTER),       \
        COORDINATE("y", A_FX, REQ,                                                                                     \
                   "vertical position in the field; a write teleports it, without collisions on the way", SETTER),     \
        REQUIRED("dir", A_DIR, "direction of flight, 0 to 360; unchanged at speed 0", STORED(pool.dir), SETTER),       \
        SPEED("speed", A_FX, REQ, "speed of flight; if negative, it flies backwards", SETTER),                         \
        SPEED("vx", A_FX, REQ, "horizontal velocity; a write changes `dir` and `speed`", SETTER),                      \
        SPEED("vy", A_FX, REQ, "vertical velocity; a write changes `dir` and `speed`", SETTER),                        \
        REQUIRED("kind", kind_type, "name of its kind; a write also sets `bank` to the bank of the new kind", SETTER), \
        BANK(REQ, NULL, "number added to the palette bank of its sprite", STORED(pool.bank), WRITABLE),                \
        LABEL("tag", OPT, "tag of its group, or nil", STORED(pool.tag), WRITABLE),                                     \
        OPTIONAL("motion", A_MOTION, "motion program it runs, or nil; a write starts the program from its first step", \
                 SETTER),                                                                                              \
        THING("around", OPT, POSITION_HANDLE_KINDS, "thing that it circles in `orbit` steps, or nil", SETTER),         \
        REQUIRED("age", A_INT, "frames since it was fired, not counting its delay or frozen frames"),                  \
        PARAM("frozen", A_COUNT, REQ, 0, INT32_MAX, "frames", NULL,                                                    \
              "frames it stays frozen, or forever; 0 unfreezes it", STORED(pool.frozen_left), SETTER)

#define HP_PROP                                                                                                        \
    PARAM("hp", A_COUNT, REQ, 0, INT32_MAX, NULL, NULL,                                                                \
          "damage it can still take, or forever; at 0, shots pass through it", SETTER)

static const struct api_param bullet_props[] = {
    FLIGHT_PROPS(A_BULLET_KIND, bullets),
    REQUIRED("delay", A_INT, "frames left before it flies; 0 once it flies"),
    HP_PROP,
};
static const struct api_param shot_props[] = { FLIGHT_PROPS(A_SHOT_KIND, shots),
                                               THING("by", REQ, 1 << H_PLAYER, "player who fired it, or nil") };

/* Pushes a Q32 number as a double. The conversion is exact, because positions and speeds have 48 bits. */
static void push_q32(lua_State *L, int64_t v)
{
    lua_pushnumber(L, (double)v / 4294967296.0);
}

void api_get_flight_prop(lua_State *L, struct board *b, const struct bullets *s, uint32_t i, int p)
{
    const bool is_shot = s == &b->shots;
    int64_t x, y;

    switch (p) {
    case FLIGHT_X:
    case FLIGHT_Y:
        bullets_get_position(s, i, &x, &y);
        push_q32(L, p == FLIGHT_X ? x : y);
        break;
    case FLIGHT_SPEED:
        push_q32(L, bullets_speed(s, i));
        break;
    case FLIGHT_VX:
    case FLIGHT_VY:
        bullets_get_velocity(s, i, &x, &y);
        push_q32(L, p == FLIGHT_VX ? x : y);
        break;
    case FLIGHT_KIND:
        api_names_push(L, is_shot ? N_SHOT : N_BULLET, bullets_kind(s, is_shot ? &b->shot_kinds : &b->bullet_kinds, i));
        break;
    case FLIGHT_MOTION:
        api_push_handle(L, s->motion[i] ? handle_make(H_MOTION, 1, s->motion[i] - 1u) : 0);
        break;
    case FLIGHT_AROUND:
        api_push_handle(L, s->orbit_target ? s->orbit_target[i] : 0);
        break;
    case FLIGHT_AGE:
        lua_pushinteger(L, bullets_age(s, i, b->core.clock));
        break;
    default:
        api_push_handle(L, s->player[i] ? board_handle(b, H_PLAYER, s->player[i] - 1) : 0);
    }
}

/* Ends the running motion step's control of a property that a script wrote. */
static void override_property(struct bullets *s, uint32_t i, unsigned property)
{
    if (s->step_flags[i] & STEP_BEGUN)
        s->step_flags[i] |= (uint8_t)property;
}

static void set_direction(struct bullets *s, uint32_t i, ang dir)
{
    s->dir[i] = dir;
    override_property(s, i, OVERRIDE_DIR);
    bullets_update_velocity(s, i);
}

/* Sets x, y, vx or vy and leaves the other coordinate of the pair unchanged. */
static void set_coordinate(struct bullets *s, uint32_t i, int p, int64_t v)
{
    int64_t x, y;

    if (p == FLIGHT_X || p == FLIGHT_Y) {
        bullets_get_position(s, i, &x, &y);
        bullets_set_position(s, i, p == FLIGHT_X ? v : x, p == FLIGHT_Y ? v : y);
    } else {
        bullets_get_velocity(s, i, &x, &y);
        bullets_set_velocity(s, i, p == FLIGHT_VX ? v : x, p == FLIGHT_VY ? v : y);
    }
}

/* After a script wrote bullet i's position, ends the lead of the running motion step (DOES_LEAD), if it leads. */
static void end_lead(const struct board *b, struct bullets *s, uint32_t i)
{
    if (!s->motion[i] || !(s->step_flags[i] & STEP_BEGUN))
        return;
    if (b->steps.actions[b->motions.first[s->motion[i] - 1] + s->pc[i]] & DOES_LEAD) {
        override_property(s, i, OVERRIDE_POSITION);
        bullets_update_velocity(s, i);
    }
}

void api_set_flight_prop(lua_State *L, struct board *b, struct bullets *s, uint32_t i, int p, const struct api_value *v)
{
    bool fine = s->flags[i] & BULLET_FINE;

    switch (p) {
    case FLIGHT_X:
    case FLIGHT_Y:
        set_coordinate(s, i, p, api_value_to_q32(fine, v));
        end_lead(b, s, i);
        break;
    case FLIGHT_DIR:
        set_direction(s, i, v->a);
        break;
    case FLIGHT_SPEED:
        override_property(s, i, OVERRIDE_SPEED);
        bullets_set_speed(s, i, api_value_to_q32(fine, v));
        break;
    case FLIGHT_VX:
    case FLIGHT_VY:
        override_property(s, i, OVERRIDE_DIR | OVERRIDE_SPEED);
        set_coordinate(s, i, p, api_value_to_q32(fine, v));
        break;
    case FLIGHT_KIND:
        bullets_set_kind(s, s == &b->shots ? &b->shot_kinds : &b->bullet_kinds, i, (uint16_t)v->i);
        break;
    case FLIGHT_FROZEN:
        bullets_freeze(s, i, api_to_count(v));
        break;
    case FLIGHT_AROUND:
        api_check_around(L, s, s == &b->shots ? "shot" : s == &b->bullets ? "bullet" : "laser", v);
        if (s->orbit_target)
            s->orbit_target[i] = v->given ? v->i : 0;
        break;
    case FLIGHT_MOTION:
        bullets_start_program(s, i, v->given ? (uint16_t)v->i : 0, v->given && api_motion_is_fine(b, (uint16_t)v->i));
        break;
    default:
        break;
    }
}

/* Returns the bullets' column hp; raises a fault if the pool has none. */
static int32_t *get_hp_column(lua_State *L, struct board *b)
{
    if (!b->bullets.hp)
        vm_fault(L, FAULT_SCRIPT, "bullet: hp: %s", hp_disabled);
    return b->bullets.hp;
}

static void get_bullet_prop(lua_State *L, struct board *b, uint32_t i, int p)
{
    const struct bullets *s = &b->bullets;

    if (p == FLIGHT_DELAY)
        lua_pushinteger(L, s->flags[i] & BULLET_DELAYED ? s->step_end[i] - b->core.clock : 0);
    else if (p == FLIGHT_HP)
        api_push_count(L, get_hp_column(L, b)[i]);
    else
        api_get_flight_prop(L, b, s, i, p);
}

static void set_bullet_prop(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    if (p == FLIGHT_HP)
        get_hp_column(L, b)[i] = api_to_count(v);
    else
        api_set_flight_prop(L, b, &b->bullets, i, p, v);
}

static void get_shot_prop(lua_State *L, struct board *b, uint32_t i, int p)
{
    api_get_flight_prop(L, b, &b->shots, i, p);
}

static void set_shot_prop(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    api_set_flight_prop(L, b, &b->shots, i, p, v);
}

/* ---- groups ---- */

static const struct api_param group_props[] = { FLIGHT_PROPS(A_BULLET_KIND, bullets), COUNT_PROP("bullets"), HP_PROP };
static const struct api_param shots_props[] = { FLIGHT_PROPS(A_SHOT_KIND, shots), COUNT_PROP("shots") };

enum { WRITE_WORK = 10 /* work per entity of a group */ };

const struct api_thing api_bullet_thing = { "bullet",        bullet_props,    FLIGHT_HP + 1,
                                            get_bullet_prop, set_bullet_prop, POOL(bullets) };
const struct api_thing api_shot_thing = {
    "shot", shot_props, FLIGHT_SHARED_COUNT + 1, .get = get_shot_prop, .set = set_shot_prop, POOL(shots)
};
const struct api_thing api_group_thing = { "group",       group_props,        FLIGHT_HP + 1,
                                           POOL(bullets), .member = H_BULLET, .write_work = WRITE_WORK };
const struct api_thing api_shots_thing = { "shots",     shots_props,      FLIGHT_SHARED_COUNT + 1,
                                           POOL(shots), .member = H_SHOT, .write_work = WRITE_WORK };

/* ---- verbs of bullets, shots, lasers and groups ---- */

enum { ARG_SELF, ARG_ANGLE /* aim: its parameter `add` */, ARG_DX = ARG_ANGLE, ARG_DY };

struct bullets *api_flight_pool(struct board *b, int64_t h)
{
    switch (handle_kind(h)) {
    case H_SHOT:
    case H_SHOTS:
        return &b->shots;
    case H_LASER:
    case H_LASERS:
        return &b->laser_heads;
    default:
        return &b->bullets;
    }
}

/* What a verb does to bullet, shot or laser i. targets: of the bullets or shots; lasers choose theirs by their kind. */
typedef void flight_verb(struct board *b, struct bullets *s, uint32_t i, const struct api_value *v,
                         const struct targets *targets);

/* Applies a verb to a thing or to those of a group. Inlined, so that each verb is one loop (rows "price aim_all",
 * "turn_all" and "shift" of `make compare`: 0.5 to 0.7). */
__attribute__((always_inline)) static inline int apply_verb(lua_State *L, struct board *b, const struct api_value *v,
                                                            flight_verb *verb)
{
    const int64_t h = v[ARG_SELF].i;
    struct bullets *s = api_flight_pool(b, h);
    const struct targets targets = board_targets(b, s == &b->shots);

    if (!handle_kind_is_group(handle_kind(h))) {
        if (board_is_alive(b, h))
            verb(b, s, handle_slot(h), v, &targets);
        return 0;
    }
    vm_charge(L, api_get_table(L)->things[handle_kind(h)]->write_work * s->s.live);
    EACH_LIVE (i, &s->s)
        if (api_has_tag(s->tag, i, handle_slot(h)))
            verb(b, s, i, v, &targets);
    return 0;
}

static void aim(struct board *b, struct bullets *s, uint32_t i, const struct api_value *v,
                const struct targets *targets)
{
    const bool is_shot = s == &b->shots;

    if (s == &b->laser_heads) {
        const bool hits_enemies = b->laser_kinds.flags[s->kind[i]] & LASER_HITS_ENEMIES;
        set_direction(s, i, api_aim_direction(b, hits_enemies, s->x[i], s->y[i]) + v[ARG_ANGLE].a);
        lasers_update_tail(b, i);
        return;
    }
    b->vm.work += is_shot ? emit_aim_work(b, true) : 0;
    set_direction(s, i, targets_aim(targets, s->x[i], s->y[i], is_shot ? ANG_UP : ANG_DOWN) + v[ARG_ANGLE].a);
}

int api_verb_aim(lua_State *L, struct board *b, struct api_value *v)
{
    return apply_verb(L, b, v, aim);
}

static void turn(struct board *b, struct bullets *s, uint32_t i, const struct api_value *v,
                 const struct targets *targets)
{
    (void)targets;
    set_direction(s, i, s->dir[i] + v[ARG_ANGLE].a);
    if (s == &b->laser_heads)
        lasers_update_tail(b, i);
}

int api_verb_turn(lua_State *L, struct board *b, struct api_value *v)
{
    return apply_verb(L, b, v, turn);
}

/* Returns a Q32 coordinate moved by `distance`, clamped to the world. */
static int64_t shift_coordinate(int64_t coordinate, int64_t distance)
{
    const int64_t edge = (int64_t)WORLD_EDGE << 32;

    return int64_clamp(coordinate + distance, -edge, edge);
}

static void shift(struct board *b, struct bullets *s, uint32_t i, const struct api_value *v,
                  const struct targets *targets)
{
    (void)targets;
    const bool fine = s->flags[i] & BULLET_FINE;
    int64_t x, y;

    if (s == &b->laser_heads) {
        lasers_move_to(b, i, motion_shift(s->x[i], v[ARG_DX].f), motion_shift(s->y[i], v[ARG_DY].f));
        return;
    }
    bullets_get_position(s, i, &x, &y);
    bullets_set_position(s, i, shift_coordinate(x, api_value_to_q32(fine, &v[ARG_DX])),
                         shift_coordinate(y, api_value_to_q32(fine, &v[ARG_DY])));
    end_lead(b, s, i);
}

int api_verb_shift(lua_State *L, struct board *b, struct api_value *v)
{
    return apply_verb(L, b, v, shift);
}

void api_release_held(struct board *b, int64_t h)
{
    struct bullets *s = api_flight_pool(b, h);
    const uint32_t i = handle_slot(h);

    if (!handle_kind_is_group(handle_kind(h))) {
        if (slots_has_held(&s->s, i, handle_gen(h)))
            bullets_release(s, i);
        return;
    }
    EACH_HELD (k, &s->s)
        if (api_has_tag(s->tag, k, i))
            bullets_release(s, k);
}

static void remove_one(struct board *b, struct bullets *s, uint32_t i, const struct api_value *v,
                       const struct targets *targets)
{
    (void)v, (void)targets;
    if (s == &b->laser_heads)
        lasers_remove(b, i);
    else
        bullets_drop(s, i);
}

int api_verb_remove(lua_State *L, struct board *b, struct api_value *v)
{
    const int64_t h = v[ARG_SELF].i;

    apply_verb(L, b, v, remove_one);
    api_release_held(b, h);
    return 0;
}

/* Signals all bullets, shots or lasers that wait for the group's tag, whether or not they have the tag themselves. */
int api_verb_signal(lua_State *L, struct board *b, struct api_value *v)
{
    const int64_t h = v[ARG_SELF].i;
    struct bullets *s = api_flight_pool(b, h);
    const struct motion_world w = board_motion_world(b, s == &b->shots);

    vm_charge(L, s->s.live);
    EACH_LIVE (i, &s->s)
        bullets_signal(s, &w, i, (uint16_t)handle_slot(h));
    return 0;
}

enum { FLYING_HANDLE_KINDS = 1 << H_BULLET | 1 << H_SHOT | 1 << H_GROUP | 1 << H_SHOTS };
static const struct api_param aim_params[] = { SELF_PARAM_OF(FLYING_HANDLE_KINDS), AIM_ADD_PARAM };
static const struct api_param turn_params[] = { SELF_PARAM_OF(FLYING_HANDLE_KINDS), TURN_BY_PARAM };
static const struct api_param shift_params[] = { SELF_PARAM_OF(FLYING_HANDLE_KINDS), SHIFT_DX_PARAM, SHIFT_DY_PARAM };
static const struct api_param self_params[] = { SELF_PARAM_OF(FLYING_HANDLE_KINDS) };
static const struct api_param signal_params[] = { SELF_PARAM_OF(1 << H_GROUP | 1 << H_SHOTS) };
static const struct api_param clear_params[] = {
    CLEAR_PARAMS,
    PARAM("lasers", A_BOOL, OPT, 0, 0, NULL, "true",
          "also remove enemy lasers; with a shape, only lasers that touch it"),
};
static const struct api_param clear_self_params[] = { SELF_PARAM_OF(1 << H_BULLET | 1 << H_SHOT), CLEAR_SPARK_PARAM,
                                                      CLEAR_ITEMS_PARAM("it") };
static const struct api_param clear_group_params[] = {
    PARAM("self", A_THING, REQ, 1 << H_GROUP | 1 << H_SHOTS, 0, NULL, NULL, "the group itself"), CLEAR_GROUP_PARAMS
};

/* The entries bullet.fire and shot.fire. Patterns take their parameters through api_bullet_fire_entry and
 * api_shot_fire_entry. */
#define BULLET_FIRE                                                                                                    \
    {                                                                                                                  \
        "bullet.fire", fire, PARAMS(bullet_fire_params), 0, API_CHANGES | API_TAKES_VALUES, "bullet",                  \
            HELP("fires one bullet from a position or a thing")                                                        \
    }
#define SHOT_FIRE                                                                                                      \
    {                                                                                                                  \
        "shot.fire", fire, PARAMS(shot_fire_params), 0, API_CHANGES | API_TAKES_VALUES, "shot",                        \
            HELP("fires one player shot from a position or a thing")                                                   \
    }
const struct api_entry api_bullet_fire_entry = BULLET_FIRE, api_shot_fire_entry = SHOT_FIRE;

#define CLEAR_ONE(thing)                                                                                               \
    API_VERB(thing ":clear", api_clear_self, clear_self_params, 1, NULL, "removes it and leaves a spark or an item")
#define CLEAR_GROUP(thing)                                                                                             \
    API_VERB(thing ":clear", api_clear_group, clear_group_params, 1, "count",                                          \
             "removes the entire group, or only its members in a circle, a box or a line; returns the number removed")
/* The verbs of a single entity or of a group; the macro parameter `it` is how the help refers to the entity or
 * group. */
#define FLYING_VERBS(thing, it, target, CLEAR)                                                                         \
    API_VERB(thing ":aim", api_verb_aim, aim_params, 2, NULL, "points " it " at the nearest " target),                 \
        API_VERB(thing ":turn", api_verb_turn, turn_params, 2, NULL, "turns " it " by an angle"),                      \
        API_VERB(thing ":shift", api_verb_shift, shift_params, 3, NULL,                                                \
                 "teleports " it " by a distance, without collisions on the way"),                                     \
        CLEAR(thing),                                                                                                  \
        API_VERB(thing ":remove", api_verb_remove, self_params, 1, NULL, "removes " it " and leaves nothing")

static const struct api_entry entries[] = {
    { "bullet.def", bullet_define, PARAMS(bullet_def_params), 1, API_CHANGES | API_LOAD_ONLY, NULL,
      HELP("declares a kind of bullet: its sprite, its hitbox and its rules") },
    BULLET_FIRE,
    API_GROUPS("bullet"),
    { "bullet.clear", api_clear, PARAMS(clear_params), 0, API_CHANGES, "count",
      HELP("removes all bullets, or only those in a circle, a box or a line; returns the number removed") },
    { "bullet.meet", api_bullet_meet, PARAMS(api_bullet_meet_params), 2, API_CHANGES | API_LOAD_ONLY, NULL,
      HELP("makes bullets with one tag collide with bullets with another tag; needs `board = { meet = true }`") },
    { "bullet.sweep", NULL, PARAMS(bullet_sweep_params), 0, API_LUA, "task",
      HELP("starts a task that removes the bullets in a growing circle; the task has the same owner as the calling "
           "task") },
    FLYING_VERBS("bullet", "it", "player", CLEAR_ONE),
    FLYING_VERBS("group", "each bullet", "player", CLEAR_GROUP),
    API_VERB("group:signal", api_verb_signal, signal_params, 1, NULL,
             "resumes every bullet whose motion waits for a signal to the group's tag (`wait_for`); a group without a "
             "tag signals all tags"),
    { "shot.def", shot_define, PARAMS(shot_def_params), 1, API_CHANGES | API_LOAD_ONLY, NULL,
      HELP("declares a kind of player shot: its sprite, its hitbox and its damage") },
    SHOT_FIRE,
    API_GROUPS("shot"),
    FLYING_VERBS("shot", "it", "enemy", CLEAR_ONE),
    FLYING_VERBS("shots", "each shot", "enemy", CLEAR_GROUP),
    API_VERB("shots:signal", api_verb_signal, signal_params, 1, NULL,
             "resumes every shot whose motion waits for a signal to the group's tag (`wait_for`); a group without a "
             "tag signals all tags"),
};
const struct api_module api_bullet = { entries, sizeof entries / sizeof *entries };
