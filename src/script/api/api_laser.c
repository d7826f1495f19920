/*
 * api_laser.c - the Lua table laser: kinds, beams, bolts and curves, their properties and verbs. A game with no
 * capacity for lasers has no table `laser` (api_reserved.c).
 */
#include <string.h>
#include "../../base/trig.h"
#include "../../machine/lasers_run.h"
#include "api_parts.h"

enum { MAX_FRAMES = 1000000 /* longest warning, growth or fade */ };

/* ---- kinds ---- */

enum { D_HIT = 3, D_CLEARABLE = 9, D_DAMAGE = 11, D_EVERY };

static const struct api_param laser_def_params[] = {
    REQUIRED("name", A_STR, "name of the kind, used as `kind = NAME`; must be new"),
    REQUIRED("strip", A_SPRITE, "sprite, drawn pointing right; repeated along the laser and stretched to its width",
             STORED(laser_kinds.strip)),
    PARAM("width", A_FX, REQ, 0, LASER_MAX_SIZE, "px", NULL, "full width, once it has grown",
          STORED(laser_kinds.width)),
    [D_HIT] = PARAM("hit", A_HIT_SHAPE, REQ, HIT_LASERS, 0, NULL, NULL,
                    "fraction of the width that hits; \"none\" never hits"),
    OPTIONAL("head", A_SPRITE, "sprite drawn where a beam starts or at the front of a bolt or curve; nil draws none",
             STORED(laser_kinds.head_sprite)),
    OPTIONAL("tail", A_SPRITE, "sprite drawn at the other end; nil draws none", STORED(laser_kinds.tail_sprite)),
    BANK(OPT, "0", "number added to the palette banks of its sprites", STORED(laser_kinds.bank)),
    BLEND_PARAM(laser_kinds.flags, LASER_BLEND),
    PARAM("graze", A_INT, OPT, 0, 65535, "frames", "8",
          "frames until a player can graze the laser again; 0 makes grazing impossible",
          STORED(laser_kinds.graze_interval)),
    [D_CLEARABLE] = DEFAULT("clearable", A_BOOL, "true", "whether it can be cleared without `all = true`"),
    OPTIONAL(
        "vanish", A_SPARK_KIND,
        "kind of spark left along the laser when it is cleared, unless the call that clears it names another kind; "
        "nil leaves none",
        STORED(laser_kinds.vanish_spark)),
    [D_DAMAGE] = PARAM("damage", A_INT, OPT, 0, 1000000, "hp", NULL,
                       "damage to each enemy it touches; makes the kind a player laser, which is harmless to players",
                       STORED(laser_kinds.damage)),
    PARAM("every", A_INT, OPT, 1, 65535, "frames", "4", "frames from one hit to the next; needs `damage`",
          STORED(laser_kinds.hit_interval)),
};

static int laser_define(lua_State *L, struct board *b, struct api_value *v)
{
    struct laser_kinds *k = &b->laser_kinds;
    const struct api_shape hit = api_read_hit_shape(L, "laser.def", v[D_HIT].at, HIT_LASERS);

    if (v[D_EVERY].given && !v[D_DAMAGE].given)
        api_error(L, "laser.def", "every: requires `damage`");
    const int32_t i = api_append_kind(L, "laser.def", &k->s, N_LASER, v);
    k->hit_share[i] = hit.shape == SHAPE_NONE ? -1 : hit.row[0].a;
    k->flags[i] |= (uint8_t)((v[D_CLEARABLE].i ? 0 : LASER_FIXED) | (v[D_DAMAGE].given ? LASER_HITS_ENEMIES : 0));
    return 0;
}

/* ---- firing ---- */

/* Parameters shared by beams, bolts and curves, in this order. `owners`: the help's words for the
 * arguments that determine the owner by default. */
#define LASER_PARAMS(owners)                                                                                           \
    REQUIRED("kind", A_LASER_KIND, "declared kind to fire"), POSITION_PARAMS,                                          \
        DEFAULT("dir", A_DIR, "90",                                                                                    \
                "direction, clockwise from the right; with `aim`, the default is 0, and the angle is added to the "    \
                "direction towards the target"),                                                                       \
        DEFAULT("aim", A_BOOL, "false",                                                                                \
                "point at the nearest target: an enemy for player lasers, otherwise a player"),                        \
        BANK(OPT, NULL, "number added to the palette banks of its sprites; overrides its kind's"),                     \
        LABEL("tag", OPT, "name of a group to put it in"),                                                             \
        PARAM("width", A_FX, OPT, 0, LASER_MAX_SIZE, "px", NULL,                                                       \
              "full width, once it has grown; overrides its kind's"),                                                  \
        THING("by", OPT, 1 << H_PLAYER, "player who owns it and gets its score; defaults to the owner of " owners)
enum {
    F_KIND,
    F_POSITION,
    F_DIR = F_POSITION + POSITION_PARAM_COUNT,
    F_AIM,
    F_BANK,
    F_TAG,
    F_WIDTH,
    F_PLAYER,
    SHARED_PARAM_COUNT, /* the following parameters differ between beams, bolts and curves */
    F_SPEED = SHARED_PARAM_COUNT,
    F_MOTION,
    F_DELAY,
    F_AROUND,
    F_VX,
    F_VY,
    F_LENGTH,
    F_POINTS = F_LENGTH,
    F_FOLLOW = SHARED_PARAM_COUNT,
    F_TURNS,
    F_BEAM_LENGTH,
    F_HOLD,
    F_WARN,
    F_GROW,
    F_FADE,
    F_SPIN
};

#define FLIGHT_PARAMS                                                                                                  \
    SPEED("speed", A_FX, UNLESS_VXY, "speed of flight; if negative, it flies backwards"),                              \
        OPTIONAL("motion", A_MOTION, "motion program that steers its head"),                                           \
        PARAM("delay", A_INT, OPT, 0, 1e9, "frames", "0", "frames the laser waits in place before it flies"),          \
        THING("around", OPT, POSITION_HANDLE_KINDS,                                                                    \
              "thing that it circles in the `orbit` steps of its motion; needs `board = { around = true }`"),          \
        VXY_PARAMS

static const struct api_param bolt_params[] = { LASER_PARAMS("`from`"), FLIGHT_PARAMS,
                                                PARAM("length", A_FX, REQ, 0, LASER_MAX_SIZE, "px", NULL,
                                                      "full length, once it has emerged") };
static const struct api_param curve_params[] = { LASER_PARAMS("`from`"), FLIGHT_PARAMS,
                                                 PARAM("points", A_INT, OPT, 2, LASER_MAX_POINTS, "frames", "32",
                                                       "length of its body, in frames of flight") };
static const struct api_param beam_params[] = {
    LASER_PARAMS("`from` or `follow`"),
    THING("follow", OPT, POSITION_HANDLE_KINDS,
          "thing to start from, at a distance of `dx` and `dy`; the beam ends with the thing; use it instead of `x` "
          "and `y`, or `from`"),
    DEFAULT("turns", A_BOOL, "false", "turn with the followed bullet, shot or laser; needs `follow`"),
    PARAM("length", A_FX, REQ, 0, LASER_MAX_SIZE, "px", NULL, "distance from the start of the beam to its end"),
    PARAM("hold", A_COUNT, REQ, 0, 1e9, "frames", NULL, "frames the beam stays at its full width"),
    PARAM("warn", A_INT, OPT, 0, MAX_FRAMES, "frames", "40",
          "frames at the start during which the beam is a dotted line that never hits"),
    PARAM("grow", A_INT, OPT, 0, MAX_FRAMES, "frames", "8",
          "frames the beam takes to reach its full width; it hits during these frames, too"),
    PARAM("fade", A_INT, OPT, 0, MAX_FRAMES, "frames", "12",
          "frames the beam takes to fade out; it doesn't hit during these frames"),
    DEFAULT("spin", A_DIR, "0", "degrees the beam turns per frame once `warn` is over, clockwise"),
};

/* Builds the head of a laser at (x, y) from the shared arguments. */
static struct bullet_spec make_head(lua_State *L, struct board *b, const char *entry, const struct api_value *v, fx x,
                                    fx y)
{
    const struct laser_kinds *k = &b->laser_kinds;
    const uint16_t kind = (uint16_t)v[F_KIND].i;
    struct bullet_spec s = { .x = x,
                             .y = y,
                             .dir = v[F_DIR].a,
                             .kind = kind,
                             .bank = v[F_BANK].given ? (uint8_t)v[F_BANK].i : k->bank[kind],
                             .player = api_find_shooter(b, &v[F_PLAYER], &v[F_POSITION + POSITION_FROM]),
                             .owner_task = tasks_current_serial(b) };

    if (v[F_AIM].i)
        s.dir = api_aim_direction(b, k->flags[kind] & LASER_HITS_ENEMIES, x, y) + (v[F_DIR].given ? v[F_DIR].a : 0);
    s.tag = api_read_tag(L, entry, &v[F_TAG]);
    return s;
}

/* Returns whether the laser must not be fired: it is a ship's laser (LASER_HITS_ENEMIES), and the ship was hit. */
static bool is_fire_blocked(const struct board *b, const struct bullet_spec *s)
{
    return s->player && b->player.deathbomb_left[s->player - 1] && b->laser_kinds.flags[s->kind] & LASER_HITS_ENEMIES;
}

static fx get_width(const struct board *b, const struct api_value *v)
{
    return v[F_WIDTH].given ? v[F_WIDTH].f : b->laser_kinds.width[v[F_KIND].i];
}

static int push_laser(lua_State *L, const struct board *b, int32_t i)
{
    lua_pushinteger(L, board_handle(b, H_LASER, i));
    return 1;
}

enum { FADE_FRAMES = 12 /* frames, for bolts and curves */ };

/* laser.bolt and laser.curve. */
static int fire_flying_laser(lua_State *L, struct board *b, struct api_value *v)
{
    const char *entry = api_current_binding(L)->entry->name;
    struct laser_spec shape = { .width = get_width(b, v), .hold_frames = LASER_FOREVER, .fade_frames = FADE_FRAMES };
    fx x, y;

    if (!api_read_position(L, b, entry, v + F_POSITION, &x, &y))
        return push_laser(L, b, NO_SLOT);
    struct bullet_spec s = make_head(L, b, entry, v, x, y);
    s.speed = v[F_SPEED].f;
    s.motion = v[F_MOTION].given ? (uint16_t)v[F_MOTION].i : 0;
    s.is_fine = api_motion_is_fine(b, s.motion);
    s.delay = (uint32_t)v[F_DELAY].i;
    api_check_around(L, &b->laser_heads, entry, &v[F_AROUND]);
    s.orbit_target = v[F_AROUND].given ? v[F_AROUND].i : 0;
    shape.form = !strcmp(entry, "laser.bolt") ? LASER_BOLT : LASER_CURVE;
    if (shape.form == LASER_BOLT)
        shape.length = v[F_LENGTH].f;
    else
        shape.max_points = (uint16_t)v[F_POINTS].i;
    int32_t i = is_fire_blocked(b, &s) ? NO_SLOT : lasers_fire(b, &s, &shape);
    if (i != NO_SLOT && s.is_fine)
        bullets_set_speed(&b->laser_heads, (uint32_t)i, api_value_to_q32(true, &v[F_SPEED]));
    if (i != NO_SLOT)
        api_set_fired_velocity(&b->laser_heads, (uint32_t)i, v + F_VX);
    return push_laser(L, b, i);
}

/* Reads the start of a beam. Returns false if the thing `from` or `follow` is dead. */
static bool read_beam_position(lua_State *L, struct board *b, const struct api_value *v, fx *x, fx *y)
{
    struct api_value position[POSITION_PARAM_COUNT];

    memcpy(position, v + F_POSITION, sizeof position);
    if (v[F_FOLLOW].given) {
        if (position[POSITION_X].given || position[POSITION_Y].given || position[POSITION_FROM].given)
            api_error(L, "laser.beam", "`follow` cannot be combined with `x`, `y` or `from`");
        position[POSITION_FROM] = v[F_FOLLOW];
    }
    return api_read_position(L, b, "laser.beam", position, x, y);
}

static int fire_beam(lua_State *L, struct board *b, struct api_value *v)
{
    const bool follows = v[F_FOLLOW].given;
    fx x, y;

    if (v[F_TURNS].i && !follows)
        api_error(L, "laser.beam", "turns: requires `follow`");
    if (!read_beam_position(L, b, v, &x, &y) || (follows && !board_is_alive(b, v[F_FOLLOW].i)))
        return push_laser(L, b, NO_SLOT);
    struct bullet_spec s = make_head(L, b, "laser.beam", v, x, y);
    struct laser_spec shape = { .form = LASER_BEAM,
                                .flags = v[F_TURNS].i ? LASER_TURNS : 0,
                                .length = v[F_BEAM_LENGTH].f,
                                .width = get_width(b, v),
                                .dx = follows ? v[F_POSITION + POSITION_DX].f : 0,
                                .dy = follows ? v[F_POSITION + POSITION_DY].f : 0,
                                .spin = v[F_SPIN].a,
                                .warn_frames = (int32_t)v[F_WARN].i,
                                .grow_frames = (int32_t)v[F_GROW].i,
                                .hold_frames = v[F_HOLD].i == LUA_MAXINTEGER ? LASER_FOREVER : (int32_t)v[F_HOLD].i,
                                .fade_frames = (int32_t)v[F_FADE].i,
                                .follow_target = follows ? v[F_FOLLOW].i : 0 };
    if (follows)
        s.player = api_find_shooter(b, &v[F_PLAYER], &v[F_FOLLOW]);
    return push_laser(L, b, is_fire_blocked(b, &s) ? NO_SLOT : lasers_fire(b, &s, &shape));
}

/* ---- properties ---- */

/* Indices of the properties after those of all flying things. */
enum { L_LENGTH = FLIGHT_SHARED_COUNT, L_STATE = L_LENGTH + 5, L_FORM, L_FOLLOW };

#define LASER_PROPS                                                                                                    \
    COORDINATE("x", A_FX, REQ,                                                                                         \
               "horizontal position of its head: the start of a beam, or the front of a bolt or curve; a write moves " \
               "the entire laser",                                                                                     \
               SETTER),                                                                                                \
        COORDINATE("y", A_FX, REQ, "vertical position of its head; a write moves the entire laser", SETTER),           \
        REQUIRED("dir", A_DIR, "direction in which a beam points or a bolt or curve flies, 0 to 360",                  \
                 STORED(laser_heads.dir), SETTER),                                                                     \
        SPEED("speed", A_FX, REQ, "speed of flight; a beam has none", SETTER),                                         \
        SPEED("vx", A_FX, REQ, "horizontal velocity; a write changes `dir` and `speed`", SETTER),                      \
        SPEED("vy", A_FX, REQ, "vertical velocity; a write changes `dir` and `speed`", SETTER),                        \
        REQUIRED("kind", A_LASER_KIND, "name of its kind", STORED(laser_heads.kind)),                                  \
        BANK(REQ, NULL, "number added to the palette banks of its sprites", STORED(laser_heads.bank), WRITABLE),       \
        LABEL("tag", OPT, "tag of its group, or nil", STORED(laser_heads.tag), WRITABLE),                              \
        OPTIONAL("motion", A_MOTION,                                                                                   \
                 "motion program of a bolt or curve, or nil; a write starts the program from its first step", SETTER), \
        THING("around", OPT, POSITION_HANDLE_KINDS, "thing that it circles in `orbit` steps, or nil", SETTER),         \
        REQUIRED("age", A_INT, "frames since it was fired, not counting frozen frames"),                               \
        PARAM("frozen", A_COUNT, REQ, 0, INT32_MAX, "frames", NULL,                                                    \
              "frames it stays frozen, or forever; 0 unfreezes it", STORED(laser_heads.frozen_left), SETTER),          \
        PARAM("length", A_FX, REQ, 0, LASER_MAX_SIZE, "px", NULL, "length; read-only for a curve", SETTER),            \
        PARAM("width", A_FX, REQ, 0, LASER_MAX_SIZE, "px", NULL, "full width, once it has grown",                      \
              STORED(lasers.width), WRITABLE),                                                                         \
        REQUIRED("spin", A_DIR, "degrees a beam turns per frame once `warn` is over, clockwise", STORED(lasers.spin),  \
                 WRITABLE),                                                                                            \
        COORDINATE("dx", A_FX, REQ, "for a beam, distance to the right of the followed thing", STORED(lasers.dx),      \
                   WRITABLE),                                                                                          \
        COORDINATE("dy", A_FX, REQ, "for a beam, distance below the followed thing", STORED(lasers.dy), WRITABLE)

static const struct api_param laser_props[] = {
    LASER_PROPS,
    [L_STATE] = REQUIRED("state", A_STR, "\"warn\", \"grow\", \"on\" or \"fade\"; it hits only in \"grow\" and \"on\""),
    REQUIRED("form", A_STR, "\"beam\", \"bolt\" or \"curve\""),
    THING("follow", REQ, POSITION_HANDLE_KINDS, "thing that a beam follows, or nil"),
    THING("by", REQ, 1 << H_PLAYER, "player who owns it, or nil"),
};

static const struct api_param lasers_props[] = {
    LASER_PROPS,
    COUNT_PROP("lasers"),
};

static fx measure_length(const struct board *b, uint32_t i)
{
    int64_t sum = 0;
    fx x, y, to_x, to_y;

    if (b->lasers.form[i] != LASER_CURVE)
        return b->lasers.length[i];
    lasers_get_corner(b, i, 0, &x, &y);
    for (uint32_t k = 1; k < lasers_corner_count(b, i); k++, x = to_x, y = to_y) {
        lasers_get_corner(b, i, k, &to_x, &to_y);
        sum += fx_hypot(fx_sub(to_x, x), fx_sub(to_y, y));
    }
    return fx_sat(sum);
}

static void get_laser(lua_State *L, struct board *b, uint32_t i, int p)
{
    static const char *const states[LASER_STATES] = { "warn", "grow", "on", "fade" }, *const forms[] = { "beam", "bolt",
                                                                                                         "curve" };
    const struct lasers *l = &b->lasers;

    switch (p) {
    case L_LENGTH:
        vm_charge(L, lasers_corner_count(b, i));
        lua_pushnumber(L, fx_to_double(measure_length(b, i)));
        break;
    case L_STATE:
        lua_pushstring(L, states[lasers_state_of(b, i, lasers_age(b, i))]);
        break;
    case L_FORM:
        lua_pushstring(L, forms[l->form[i]]);
        break;
    case L_FOLLOW:
        api_push_handle(L, l->follow_target[i]);
        break;
    default:
        api_get_flight_prop(L, b, &b->laser_heads, i, p);
    }
}

static void set_length(lua_State *L, struct board *b, uint32_t i, fx length)
{
    struct lasers *l = &b->lasers;

    if (l->form[i] == LASER_CURVE)
        vm_fault(L, FAULT_SCRIPT, "laser: length: cannot be set on a curve (`points` sets its length)");
    l->length[i] = length;
    l->grown_length[i] = fx_min(l->grown_length[i], length);
}

static void set_laser(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    struct lasers *l = &b->lasers;
    struct bullets *h = &b->laser_heads;

    switch (p) {
    case FLIGHT_X:
        lasers_move_to(b, i, v->f, h->y[i]);
        api_set_flight_prop(L, b, h, i, p, v); /* also sets the fraction bits that an fx lacks */
        return;
    case FLIGHT_Y:
        lasers_move_to(b, i, h->x[i], v->f);
        api_set_flight_prop(L, b, h, i, p, v);
        return;
    case FLIGHT_SPEED:
    case FLIGHT_VX:
    case FLIGHT_VY:
    case FLIGHT_MOTION:
        if (l->form[i] != LASER_BEAM) /* a beam does not fly */
            api_set_flight_prop(L, b, h, i, p, v);
        break;
    case L_LENGTH:
        set_length(L, b, i, v->f);
        break;
    default:
        api_set_flight_prop(L, b, h, i, p, v);
    }
    lasers_update_tail(b, i);
}

const struct api_thing api_laser_thing = { "laser", PARAMS(laser_props), .get = get_laser, .set = set_laser,
                                           POOL(laser_heads) };
const struct api_thing api_lasers_thing = { "lasers", PARAMS(lasers_props), POOL(laser_heads), .member = H_LASER,
                                            .write_work = 1 };

/* ---- verbs ---- */

static int laser_fade(lua_State *L, struct board *b, struct api_value *v)
{
    const uint32_t i = handle_slot(v[0].i);

    (void)L;
    lasers_fade(&b->lasers, i, lasers_age(b, i));
    return 0;
}

enum { LASER_HANDLE_KINDS = 1 << H_LASER | 1 << H_LASERS };
static const struct api_param aim_params[] = { SELF_PARAM_OF(LASER_HANDLE_KINDS), AIM_ADD_PARAM };
static const struct api_param turn_params[] = { SELF_PARAM_OF(LASER_HANDLE_KINDS), TURN_BY_PARAM };
static const struct api_param shift_params[] = { SELF_PARAM_OF(LASER_HANDLE_KINDS), SHIFT_DX_PARAM, SHIFT_DY_PARAM };
static const struct api_param self_params[] = { SELF_PARAM_OF(LASER_HANDLE_KINDS) };
static const struct api_param signal_params[] = { SELF_PARAM_OF(1 << H_LASERS) };

#define EVERY_PARAM                                                                                                    \
    PARAM("every", A_FX, OPT, 1, LASER_MAX_SIZE, "px", "12",                                                           \
          "distance along the laser between the sparks or items it leaves")
static const struct api_param clear_params[] = { CLEAR_PARAMS, EVERY_PARAM };
static const struct api_param clear_self_params[] = { PARAM("self", A_THING, REQ, 1 << H_LASER, 0, NULL, NULL,
                                                            "the laser itself"),
                                                      CLEAR_SPARK_PARAM, CLEAR_ITEMS_PARAM("it"), EVERY_PARAM };
static const struct api_param clear_group_params[] = {
    PARAM("self", A_THING, REQ, 1 << H_LASERS, 0, NULL, NULL, "the group itself"), CLEAR_GROUP_PARAMS, EVERY_PARAM
};

/* ---- entries ---- */

#define BEAM_ENTRY                                                                                                     \
    {                                                                                                                  \
        "laser.beam", fire_beam, PARAMS(beam_params), 0, API_CHANGES, "laser",                                         \
            HELP("fires a straight laser from a position or a thing; it warns, grows, holds and fades")                \
    }
#define BOLT_ENTRY                                                                                                     \
    {                                                                                                                  \
        "laser.bolt", fire_flying_laser, PARAMS(bolt_params), 0, API_CHANGES, "laser",                                 \
            HELP("fires a straight laser of a fixed length that flies like a bullet")                                  \
    }
#define CURVE_ENTRY                                                                                                    \
    {                                                                                                                  \
        "laser.curve", fire_flying_laser, PARAMS(curve_params), 0, API_CHANGES, "laser",                               \
            HELP("fires a laser whose head flies like a bullet and whose body follows its path")                       \
    }
const struct api_entry api_beam_entry = BEAM_ENTRY, api_bolt_entry = BOLT_ENTRY, api_curve_entry = CURVE_ENTRY;

static const struct api_entry entries[] = {
    { "laser.def", laser_define, PARAMS(laser_def_params), 1, API_CHANGES | API_LOAD_ONLY, NULL,
      HELP("declares a kind of laser: its sprites, its width and its rules; needs `board = { lasers = n }`") },
    BEAM_ENTRY,
    BOLT_ENTRY,
    CURVE_ENTRY,
    API_GROUPS("laser"),
    { "laser.clear", api_clear, PARAMS(clear_params), 0, API_CHANGES, "count",
      HELP(
          "removes all enemy lasers, or only those that touch a circle, a box or a line; returns the number removed") },
    API_VERB("laser:aim", api_verb_aim, aim_params, 2, NULL,
             "points it at the nearest player or, if it is a player laser, at the nearest enemy"),
    API_VERB("laser:turn", api_verb_turn, turn_params, 2, NULL, "turns it by an angle"),
    API_VERB("laser:shift", api_verb_shift, shift_params, 3, NULL,
             "teleports the entire laser by a distance, without collisions on the way"),
    API_EACH_VERB("laser:fade", laser_fade, self_params, 1, "fades it out; it stops hitting immediately"),
    { "laser:clear", api_clear_self, PARAMS(clear_self_params), 1, API_CHANGES | API_METHOD, NULL,
      HELP("removes it and leaves sparks or items along it") },
    API_VERB("laser:remove", api_verb_remove, self_params, 1, NULL, "removes it and leaves nothing"),
    API_VERB("lasers:aim", api_verb_aim, aim_params, 2, NULL,
             "points each laser at the nearest player and each player laser at the nearest enemy"),
    API_VERB("lasers:turn", api_verb_turn, turn_params, 2, NULL, "turns each laser by an angle"),
    API_VERB("lasers:shift", api_verb_shift, shift_params, 3, NULL,
             "teleports each laser by a distance, without collisions on the way"),
    API_EACH_VERB("lasers:fade", laser_fade, self_params, 1, "fades each laser out; it stops hitting immediately"),
    { "lasers:clear", api_clear_group, PARAMS(clear_group_params), 1, API_CHANGES | API_METHOD, "count",
      HELP("removes all lasers of the group, or only those that touch a circle, a box or a line; returns the number "
           "removed") },
    API_VERB("lasers:signal", api_verb_signal, signal_params, 1, NULL,
             "resumes every laser whose motion waits for a signal to the group's tag (`wait_for`); a group without a "
             "tag signals all tags"),
    API_VERB("lasers:remove", api_verb_remove, self_params, 1, NULL, "removes each laser and leaves nothing"),
};
const struct api_module api_laser = { entries, sizeof entries / sizeof *entries };
