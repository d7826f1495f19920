/*
 * api_motion.c - motion.def: reads a list of steps into a motion program. api_step.c reads the settings of emit,
 * wait_for and path.
 */
#include <stdio.h>
#include <string.h>
#include "../../base/trig.h"
#include "api_parts.h"

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
    M_TURN_TO,
    M_AX,
    M_AY,
    M_LIMIT,
    M_VX,
    M_VY,
    M_KEY_COUNT
};

static const struct api_param step_keys[M_KEY_COUNT] = {
    PARAM("wait", A_COUNT, OPT, 0, 1e9, "frames", NULL, "frames to fly unchanged before the next step"),
    OPTIONAL("kind", A_BULLET_KIND, "kind of bullet to turn into"),
    BANK(OPT, NULL, "number added to the palette bank of its sprite from now on"),
    OPTIONAL("dir", A_DIR, "new direction of flight, clockwise from the right"),
    OPTIONAL("aim", A_BOOL, "aim at the nearest target; with `over`, aim again in every frame"),
    OPTIONAL("turn", A_DIR, "degrees to turn, clockwise; with `over`, degrees per frame"),
    PARAM("home", A_NUM, OPT, 0, 180, "degrees per frame", NULL,
          "maximum turn per frame towards the nearest target; needs `over`"),
    SPEED("speed", A_FX, OPT,
          "new speed; with `over`, it is reached in equal steps; with `go_to`, it is the speed of travel"),
    PARAM("accel", A_FX, OPT, -MAX_SPEED, MAX_SPEED, "px/frame per frame", NULL,
          "change in speed; with `over`, the change per frame"),
    OPTIONAL("die", A_BOOL, "despawn the bullet"),
    PARAM("over", A_COUNT, OPT, 1, 1e9, "frames", NULL,
          "duration of the step; without `over`, the step takes effect immediately"),
    PARAM("loop", A_COUNT, OPT, 0, 65534, "times", NULL, "number of times to run the steps nested in this one"),
    OPTIONAL("go_to", A_TABLE, "point { x, y } in the field to fly to; needs `over` or `speed`"),
    SPEED("polar", A_FX, OPT, "speed away from `at`, or from where the step starts if `at` is omitted; needs `over`"),
    PARAM("wave", A_FX, OPT, -MAX_SPEED, MAX_SPEED, "px", NULL,
          "distance the bullet swings to each side of its path; needs `over` and `every`"),
    LENGTH("orbit", OPT, NULL,
           "radius of a circle around `at`, or around the thing in `around` if `at` is omitted; needs `over`"),
    OPTIONAL("ease", A_EASE, "easing of `go_to`"),
    OPTIONAL("spin", A_DIR, "degrees per frame around the centre of `polar` or `orbit`, clockwise"),
    OPTIONAL("at", A_TABLE, "centre of `polar` or `orbit`, a point { x, y } in the field"),
    PARAM("every", A_INT, OPT, 1, 65535, "frames", NULL, "period of `wave`"),
    OPTIONAL("phase", A_DIR, "phase at which `wave` starts; 360 degrees is one period"),
    LENGTH("radius_to", OPT, NULL, "radius that `orbit` reaches at the end of `over`"),
    PARAM("bounce", A_COUNT, OPT, 1, 65534, "times", NULL,
          "number of bounces off the edges of the field; the steps nested in this one run after each bounce"),
    LABEL("walls", OPT,
          "edges to bounce off: any of left, right, top and bottom, separated by spaces; all four if omitted"),
    OPTIONAL("emit", A_TABLE, "bullets or shots to fire from the bullet's position"),
    OPTIONAL("path", A_ROUTE, "route to follow, moved so that it starts at the bullet's position"),
    DEFAULT("mirror", A_BOOL, "false", "mirror `path` left to right"),
    OPTIONAL("wait_for", A_TABLE, "what to wait for while flying unchanged: a position, a nearby target or a signal"),
    OPTIONAL("turn_to", A_DIR, "degrees per frame that `turn` changes to, evenly, by the end of `over`"),
    PARAM("ax", A_FX, OPT, -MAX_SPEED, MAX_SPEED, "px/frame per frame", NULL,
          "change in the horizontal velocity; with `over`, the change per frame"),
    PARAM("ay", A_FX, OPT, -MAX_SPEED, MAX_SPEED, "px/frame per frame", NULL,
          "change in the vertical velocity; with `over`, the change per frame"),
    OPTIONAL("limit", A_ANY,
             "speed up to which `ax` and `ay` accelerate, 0 to 8191 px/frame on each axis, or { x, y } for one each"),
    SPEED("vx", A_FX, OPT, "new horizontal velocity; with `over`, it is reached in equal steps"),
    SPEED("vy", A_FX, OPT, "new vertical velocity; with `over`, it is reached in equal steps"),
};

_Static_assert(M_KEY_COUNT <= 64, "masks of keys have 64 bits");

enum { MAX_STEPS = 1024, MAX_ROUNDS = 4096 };

/* A program being read. */
struct program_reader {
    struct motion_step steps[MAX_STEPS];
    uint32_t n;
    int open_bounce_count; /* number of `bounce` steps whose end has not been read yet */
    bool is_fine;
    uint32_t instant_step_end;  /* number of rows up to the last step that takes time, but may end at once */
    const char *instant_reason; /* that step and the condition: "`orbit` takes no time once its thing has despawned";
                                 * NULL: none */
};

static const char def_entry[] = "motion.def";

static struct motion_step *add_step(lua_State *L, struct program_reader *r)
{
    if (r->n == MAX_STEPS)
        api_error(L, def_entry, "too many steps (at most %d)", MAX_STEPS);
    r->steps[r->n] = (struct motion_step){ 0 };
    return &r->steps[r->n++];
}

static void raise_step_error(lua_State *L, int step, const char *message)
{
    api_error(L, def_entry, "step %d: %s", step, message);
}

static const struct api_fields step_fields = { step_keys, M_KEY_COUNT, NAME_LISTS };

static bool is_known_step_key(lua_State *L, const char *key, const void *context)
{
    vm_charge(L, 1);
    return lua_type(L, -1) == LUA_TNUMBER || api_is_known_field(L, key, context);
}

/* Raises the error for the unknown key of a step on top of the stack. */
static void raise_unknown_key(lua_State *L, int step, const char *entry)
{
    const char *name = luakeys_text(L, -1);

    if (name && (!strcmp(name, "fine") || !strcmp(name, "name")))
        api_error(L, def_entry, "step %d: %s is not part of a step; write { %s = ..., { ... }, { ... } }", step, name,
                  name);
    api_raise_unknown_key(L, entry, &step_fields);
}

/* The number of a step that each key sets, plus 1, if the name of a declared value may replace the number; otherwise
 * 0. */
static const uint8_t step_numbers[M_KEY_COUNT] = {
    [M_WAIT] = NUMBER_DURATION + 1, [M_OVER] = NUMBER_DURATION + 1, [M_BANK] = NUMBER_BANK + 1,
    [M_DIR] = NUMBER_DIR + 1,       [M_TURN] = NUMBER_TURN + 1,     [M_HOME] = NUMBER_HOME + 1,
    [M_SPEED] = NUMBER_SPEED + 1,   [M_ACCEL] = NUMBER_ACCEL + 1,   [M_POLAR] = NUMBER_SPEED + 1,
    [M_WAVE] = NUMBER_SIZE + 1,     [M_ORBIT] = NUMBER_SIZE + 1,    [M_RADIUS_TO] = NUMBER_SIZE_TO + 1,
    [M_SPIN] = NUMBER_TURN + 1,     [M_EVERY] = NUMBER_COUNT + 1,   [M_PHASE] = NUMBER_DIR + 1,
    [M_TURN_TO] = NUMBER_DIR + 1,   [M_AX] = NUMBER_SPEED + 1,      [M_AY] = NUMBER_ACCEL + 1,
    [M_VX] = NUMBER_SPEED + 1,      [M_VY] = NUMBER_ACCEL + 1,
};

uint64_t api_find_step_value(lua_State *L, int step, const char *key, int at)
{
    const struct board *b = vm_board(L);
    const char *name = lua_tostring(L, at);
    struct api_suggestion s = { .word = name };
    int bullet_value = api_names_find(L, N_BULLET_VALUE, name), shot_value = api_names_find(L, N_SHOT_VALUE, name);

    if (bullet_value != NO_SLOT || shot_value != NO_SLOT)
        return (uint64_t)(bullet_value + 1) + (uint64_t)(shot_value + 1) * NAMED_SHOT_STRIDE;
    for (int k = 0; k < api_value_count(b, N_BULLET_VALUE); k++)
        api_consider(&s, board_name(b, N_BULLET_VALUE, k));
    for (int k = 0; k < api_value_count(b, N_SHOT_VALUE); k++)
        api_consider(&s, board_name(b, N_SHOT_VALUE, k));
    if (s.nearest)
        api_error(L, def_entry, "step %d: %s: unknown value \"%s\" (did you mean \"%s\"?)", step, key, name, s.nearest);
    api_error(L, def_entry, "step %d: %s: expected a number or the name of a value (value.def), got \"%s\"", step, key,
              name);
    return 0;
}

uint64_t api_read_step_keys(lua_State *L, int step, const char *entry, const struct api_param *params, int n,
                            const uint8_t *numbers, int at, struct api_value *v)
{
    uint64_t named_bits = 0;

    luaL_checkstack(L, n + 8, NULL);
    for (int k = 0; k < n; k++) {
        const int number = numbers[k] - 1;
        v[k] = (struct api_value){ 0 };
        if (lua_getfield(L, at, params[k].name) == LUA_TSTRING && number >= 0) {
            named_bits |= api_find_step_value(L, step, params[k].name, lua_gettop(L)) << number * NAMED_VALUE_BITS;
            v[k] = (struct api_value){ .given = true, .i = number == NUMBER_DURATION || number == NUMBER_COUNT };
        } else
            api_check(L, entry, &params[k], lua_gettop(L), &v[k]);
    }
    return named_bits;
}

/* Reads the keys of the step table at `at` into v, but not the nested steps of a loop. Returns the NAMED_VALUE_BITS of
 * all declared values used in place of numbers. */
static uint64_t read_keys(lua_State *L, int at, int step, struct api_value v[M_KEY_COUNT])
{
    char entry[40];

    snprintf(entry, sizeof entry, "%s: step %d", def_entry, step);
    if (luakeys_push_unknown(L, at, is_known_step_key, &step_fields))
        raise_unknown_key(L, step, entry);
    return api_read_step_keys(L, step, entry, step_keys, M_KEY_COUNT, step_numbers, at, v);
}

#define KEY(key) (1ull << M_##key)

/* The settings that each leading step may have and must have, in addition to kind and bank. */
static const struct {
    int key;
    uint64_t allowed, required;
} lead_rules[] = {
    { M_GO_TO, KEY(OVER) | KEY(SPEED) | KEY(EASE), 0 },
    { M_POLAR, KEY(OVER) | KEY(SPIN) | KEY(AT), KEY(OVER) },
    { M_WAVE, KEY(OVER) | KEY(EVERY) | KEY(PHASE), KEY(OVER) | KEY(EVERY) },
    { M_ORBIT, KEY(OVER) | KEY(SPIN) | KEY(RADIUS_TO) | KEY(AT), KEY(OVER) },
    { M_AX, KEY(AY) | KEY(OVER) | KEY(LIMIT), 0 },
    { M_AY, KEY(AX) | KEY(OVER) | KEY(LIMIT), 0 },
    { M_VX, KEY(VY) | KEY(OVER), 0 },
    { M_VY, KEY(VX) | KEY(OVER), 0 },
};
enum { LEAD_RULE_COUNT = sizeof lead_rules / sizeof *lead_rules };

static void check_go_to(lua_State *L, const struct api_value v[M_KEY_COUNT], int step)
{
    if (v[M_OVER].given == v[M_SPEED].given)
        raise_step_error(L, step, "`go_to` requires either `over` (frames) or `speed`");
    if (v[M_SPEED].given && v[M_EASE].given)
        raise_step_error(L, step, "go_to: `ease` requires `over` (with `speed`, the motion is linear)");
    if (v[M_SPEED].given && v[M_SPEED].at && v[M_SPEED].f <= 0)
        raise_step_error(L, step, "go_to: speed: expected a number above 0");
    if (v[M_OVER].i == LUA_MAXINTEGER)
        raise_step_error(L, step, "`go_to` with `over = forever` never arrives");
}

/* Raises an error if a leading key is combined with anything but its settings, or a setting lacks its leading key. */
static void check_lead(lua_State *L, const struct api_value v[M_KEY_COUNT], int step, bool fine)
{
    int found = -1;

    for (int i = 0; i < LEAD_RULE_COUNT; i++)
        if (v[lead_rules[i].key].given) {
            if (found >= 0 && !(lead_rules[found].allowed >> lead_rules[i].key & 1))
                api_error(L, def_entry, "step %d: `%s` and `%s` cannot be combined", step,
                          step_keys[lead_rules[found].key].name, step_keys[lead_rules[i].key].name);
            found = found < 0 ? i : found;
        }
    const uint64_t lead_settings = KEY(EASE) | KEY(SPIN) | KEY(AT) | KEY(EVERY) | KEY(PHASE) | KEY(RADIUS_TO);
    if (v[M_WALLS].given)
        raise_step_error(L, step, "`walls` requires `bounce`");
    if (v[M_MIRROR].given)
        raise_step_error(L, step, "`mirror` requires `path`");
    if (v[M_LIMIT].given && !v[M_AX].given && !v[M_AY].given)
        raise_step_error(L, step, "`limit` requires `ax` or `ay`");
    for (int k = 0; k < M_KEY_COUNT; k++) {
        if (found < 0 && v[k].given && lead_settings >> k & 1)
            api_error(L, def_entry, "step %d: `%s` requires `go_to`, `polar`, `wave` or `orbit`", step,
                      step_keys[k].name);
        if (found < 0 || k == lead_rules[found].key)
            continue;
        const char *lead_name = step_keys[lead_rules[found].key].name;
        if (v[k].given && k != M_KIND && k != M_BANK && !(lead_rules[found].allowed >> k & 1))
            api_error(L, def_entry, "step %d: `%s` cannot be combined with `%s`", step, step_keys[k].name, lead_name);
        if (!v[k].given && lead_rules[found].required >> k & 1)
            api_error(L, def_entry, "step %d: `%s` requires `%s`", step, lead_name, step_keys[k].name);
    }
    if (found >= 0 && fine)
        api_error(L, def_entry, "step %d: `%s` cannot be used in a fine motion (this step is always exact)", step,
                  step_keys[lead_rules[found].key].name);
    if (v[M_GO_TO].given)
        check_go_to(L, v, step);
    if ((v[M_VX].given || v[M_VY].given) && v[M_OVER].i == LUA_MAXINTEGER)
        api_error(L, def_entry, "step %d: `%s` with `over = forever` never arrives", step, v[M_VX].given ? "vx" : "vy");
    if (v[M_RADIUS_TO].given && v[M_OVER].i == LUA_MAXINTEGER)
        raise_step_error(L, step, "`radius_to` with `over = forever` never arrives");
    if (v[M_ORBIT].given && !v[M_AT].given && !vm_board(L)->bullets.orbit_target && !vm_board(L)->shots.orbit_target)
        raise_step_error(
            L, step, "`orbit` requires `at = { x, y }`; to orbit a thing, add `around = true` to `board` in rom.lua");
}

/* Reads a coordinate: stores a number in *out, or returns the NAMED_VALUE_BITS of a declared value. */
static uint64_t read_coordinate(lua_State *L, int step, const char *key, int at, enum step_number number, fx *out)
{
    struct api_param p = COORDINATE(key, A_FX, REQ, NULL);
    struct api_value v = { 0 };
    char entry[40];

    if (lua_type(L, at) == LUA_TSTRING)
        return api_find_step_value(L, step, key, at) << number * NAMED_VALUE_BITS;
    snprintf(entry, sizeof entry, "%s: step %d", def_entry, step);
    api_check(L, entry, &p, at, &v);
    *out = v.f;
    return 0;
}

/* Reads the { x, y } of `go_to` or `at`; returns the NAMED_VALUE_BITS of the declared values used. */
static uint64_t read_point(lua_State *L, int step, const struct api_value *v, const char *key, struct motion_step *s)
{
    int n_keys = 0, top = lua_gettop(L);

    if (!v->given)
        return 0;
    for (lua_pushnil(L); lua_next(L, v->at); lua_pop(L, 1))
        n_keys++;
    if (n_keys != 2 || lua_rawlen(L, v->at) != 2)
        api_error(L, def_entry, "step %d: %s: expected { x, y }", step, key);
    lua_rawgeti(L, v->at, 1);
    lua_rawgeti(L, v->at, 2);
    uint64_t named_bits = read_coordinate(L, step, key, top + 1, NUMBER_X, &s->x);
    named_bits |= read_coordinate(L, step, key, top + 2, NUMBER_Y, &s->y);
    lua_settop(L, top);
    return named_bits;
}

/* Reads the `limit` of an acceleration into s; returns the NAMED_VALUE_BITS of the declared values used. */
static uint64_t read_limit(lua_State *L, int step, const struct api_value *v, struct motion_step *s)
{
    static const struct api_param limit_param = PARAM("limit", A_FX, REQ, 0, MAX_SPEED, "px/frame", NULL, NULL);
    const int top = lua_gettop(L);
    fx *const limits[2] = { &s->size, &s->size_to };
    uint64_t named_bits = 0;
    char entry[40];

    if (!v->given)
        return 0;
    if (lua_istable(L, v->at) && lua_rawlen(L, v->at) != 2)
        raise_step_error(L, step, "limit: expected a number or { x, y }");
    snprintf(entry, sizeof entry, "%s: step %d", def_entry, step);
    for (int axis = 0; axis < 2; axis++) {
        struct api_value limit = { 0 };
        if (lua_istable(L, v->at))
            lua_rawgeti(L, v->at, axis + 1);
        else
            lua_pushvalue(L, v->at);
        if (lua_type(L, -1) == LUA_TSTRING)
            named_bits |= api_find_step_value(L, step, "limit", lua_gettop(L))
                          << (axis ? NUMBER_SIZE_TO : NUMBER_SIZE) * NAMED_VALUE_BITS;
        else
            api_check(L, entry, &limit_param, lua_gettop(L), &limit);
        *limits[axis] = limit.f;
    }
    lua_settop(L, top);
    return named_bits;
}

/* Sets the fields of a leading step; returns the NAMED_VALUE_BITS of the declared values used. */
static uint64_t fill_lead(lua_State *L, struct motion_step *s, const struct api_value v[M_KEY_COUNT], int step,
                          bool fine)
{
    s->size = v[M_WAVE].given ? v[M_WAVE].f : v[M_ORBIT].f;
    s->size_to = v[M_RADIUS_TO].f;
    s->count = (uint16_t)v[M_EVERY].i;
    s->mode =
        (uint8_t)(v[M_EASE].i | (v[M_AT].given ? MODE_HAS_CENTRE : 0) | (v[M_RADIUS_TO].given ? MODE_HAS_SIZE_TO : 0) |
                  (v[M_GO_TO].given && v[M_SPEED].given ? MODE_SPEED : 0));
    if (v[M_SPIN].given)
        s->turn = (int32_t)v[M_SPIN].a;
    if (v[M_PHASE].given)
        s->dir = v[M_PHASE].a;
    if (v[M_POLAR].given)
        s->speed = api_value_to_q32(fine, &v[M_POLAR]);
    if (s->actions & DOES_ACCEL_XY) {
        s->speed = api_value_to_q32(true, &v[v[M_VX].given ? M_VX : M_AX]);
        s->accel = api_value_to_q32(true, &v[v[M_VY].given ? M_VY : M_AY]);
        s->mode = (uint8_t)((v[M_VX].given ? MODE_TO_VX : 0) | (v[M_VY].given ? MODE_TO_VY : 0) |
                            (v[M_LIMIT].given ? MODE_HAS_LIMIT : 0));
        return read_limit(L, step, &v[M_LIMIT], s);
    }
    if (s->actions & DOES_GO_TO) /* a go_to has its own speed; the bullet's is not set */
        s->actions &= ~(uint32_t)DOES_SPEED;
    return read_point(L, step, &v[M_GO_TO], "go_to", s) | read_point(L, step, &v[M_AT], "at", s);
}

/* Returns the frames in v; forever is UINT32_MAX. */
static uint32_t get_frames(const struct api_value *v)
{
    return v->i > 1000000000 ? UINT32_MAX : (uint32_t)v->i;
}

static void fill_step(lua_State *L, struct motion_step *s, const struct api_value v[M_KEY_COUNT], uint64_t named_bits,
                      int step, bool fine)
{
    static const uint32_t key_flags[M_KEY_COUNT] = {
        [M_WAIT] = DOES_WAIT,   [M_KIND] = DOES_KIND,   [M_BANK] = DOES_BANK,   [M_DIR] = DOES_DIR,
        [M_AIM] = DOES_AIM,     [M_TURN] = DOES_TURN,   [M_HOME] = DOES_HOME,   [M_SPEED] = DOES_SPEED,
        [M_ACCEL] = DOES_ACCEL, [M_DIE] = DOES_DIE,     [M_GO_TO] = DOES_GO_TO, [M_POLAR] = DOES_POLAR,
        [M_WAVE] = DOES_WAVE,   [M_ORBIT] = DOES_ORBIT, [M_AX] = DOES_ACCEL_XY, [M_AY] = DOES_ACCEL_XY,
        [M_VX] = DOES_ACCEL_XY, [M_VY] = DOES_ACCEL_XY,
    };

    for (int k = 0; k < M_KEY_COUNT; k++)
        if (v[k].given && !(step_keys[k].type == A_BOOL && !v[k].i))
            s->actions |= key_flags[k];
    check_lead(L, v, step, fine);
    if (v[M_TURN_TO].given && !(v[M_TURN].given && v[M_OVER].given))
        raise_step_error(L, step, "`turn_to` requires `turn` and `over`");
    if (!s->actions)
        raise_step_error(L, step, "does nothing");
    if (s->actions & DOES_WAIT && (s->actions != DOES_WAIT || v[M_OVER].given))
        raise_step_error(L, step, "`wait` cannot be combined with anything else");
    if (s->actions & DOES_DIR && v[M_OVER].given)
        raise_step_error(L, step, "`dir` takes effect immediately; with `over`, use `turn`, `aim` or `home`");
    if (s->actions & DOES_SPEED && !v[M_GO_TO].given && v[M_OVER].i == LUA_MAXINTEGER)
        raise_step_error(L, step, "`speed` with `over = forever` never arrives");
    if (s->actions & DOES_DIE && v[M_OVER].given)
        raise_step_error(L, step, "`die` takes effect immediately; put a `wait` before it");
    if (v[M_TURN_TO].given && v[M_OVER].i == LUA_MAXINTEGER)
        raise_step_error(L, step, "`turn_to` with `over = forever` never arrives");
    if (s->actions & DOES_HOME && !v[M_OVER].given)
        raise_step_error(L, step, "`home` requires `over` (frames)");
    s->duration = get_frames(&v[s->actions & DOES_WAIT ? M_WAIT : M_OVER]);
    s->kind = (uint16_t)v[M_KIND].i;
    s->bank = (uint8_t)v[M_BANK].i;
    s->dir = v[M_TURN_TO].given ? v[M_TURN_TO].a : v[M_DIR].a;
    s->turn = (int32_t)v[M_TURN].a;
    if (v[M_TURN_TO].given)
        s->actions ^= DOES_TURN | DOES_TURN_TO;
    trig_from_degrees(v[M_HOME].n, &s->home);
    s->speed = api_value_to_q32(fine, &v[M_SPEED]);
    s->accel = api_value_to_q32(fine, &v[M_ACCEL]);
    named_bits |= fill_lead(L, s, v, step, fine);
    s->named_values = named_bits;
    s->actions |= named_bits ? DOES_USE_VALUES : 0;
}

/* Raises the error for a loop, with first row `loop_row`, that could run without taking a frame. */
static void raise_untimed_loop(lua_State *L, const struct program_reader *r, uint32_t loop_row, const char *message,
                               int step)
{
    if (r->instant_reason && r->instant_step_end > loop_row)
        api_error(L, def_entry, "step %d: %s (%s: add { wait = 1 })", step, message, r->instant_reason);
    raise_step_error(L, step, message);
}

/* Raises an error if a loop that takes no time does not end, or runs too many steps. Returns how many steps the loop
 * runs in one frame. */
static uint64_t check_loop_work(lua_State *L, const struct program_reader *r, uint32_t loop_row, bool is_timed,
                                uint64_t inner_steps, int64_t count, int step)
{
    uint64_t rounds = is_timed ? 1 : (uint64_t)count;

    if (!is_timed && count == LUA_MAXINTEGER)
        raise_untimed_loop(L, r, loop_row, "infinite loop: with `loop = forever`, at least one step must take time",
                           step);
    if (rounds > MAX_ROUNDS || inner_steps * rounds > MAX_ROUNDS)
        raise_untimed_loop(L, r, loop_row,
                           "this loop runs too many steps in one frame; at least one of them must take time", step);
    return inner_steps * rounds;
}

/* Records that the last step read may end at once, under the condition `reason`; returns false. */
static bool record_instant_step(struct program_reader *r, const char *reason)
{
    r->instant_step_end = r->n;
    r->instant_reason = reason;
    return false;
}

/* Returns whether the last step read takes time. */
static bool takes_time(struct program_reader *r, const struct motion_step *s)
{
    if (s->actions & DOES_ORBIT && !(s->mode & MODE_HAS_CENTRE))
        return record_instant_step(r, "`orbit` takes no time once its thing has despawned");
    return s->duration > 0 || s->mode & MODE_SPEED;
}

/* Raises an error if the key `key` is combined with a key that is not in the mask `allowed`. */
static void check_key_alone(lua_State *L, const struct api_value v[M_KEY_COUNT], int step, int key, uint64_t allowed)
{
    for (int k = 0; k < M_KEY_COUNT; k++)
        if (v[k].given && k != key && !(allowed >> k & 1))
            api_error(L, def_entry, "step %d: `%s` cannot be combined with `%s`", step, step_keys[k].name,
                      step_keys[key].name);
}

/* Adds the legs of a route; the first one sets kind and bank. */
static void read_path(lua_State *L, struct program_reader *r, const struct api_value v[M_KEY_COUNT], int step)
{
    const uint32_t first_row = r->n;
    struct motion_step leg = { .kind = (uint16_t)v[M_KIND].i, .bank = (uint8_t)v[M_BANK].i };
    struct api_route_reader route = { .route_at = v[M_PATH].at, .is_mirrored = v[M_MIRROR].i };

    check_key_alone(L, v, step, M_PATH, KEY(MIRROR) | KEY(KIND) | KEY(BANK));
    if (r->is_fine)
        raise_step_error(L, step, "`path` cannot be used in a fine motion (this step is always exact)");
    leg.actions = (v[M_KIND].given ? DOES_KIND : 0u) | (v[M_BANK].given ? DOES_BANK : 0u);
    while (api_read_step_leg(L, step, &route, &leg)) {
        *add_step(L, r) = leg;
        leg = (struct motion_step){ 0 };
    }
    if (r->n == first_row)
        raise_step_error(L, step, "path: the route has no length; add a second point");
}

/* Reads a step without nested steps; returns whether it takes time. */
static bool read_step(lua_State *L, struct program_reader *r, const struct api_value v[M_KEY_COUNT],
                      uint64_t named_bits, int step)
{
    struct motion_step *s, rows[EMIT_STEPS];
    struct motion_emit e;

    if (v[M_EMIT].given) {
        check_key_alone(L, v, step, M_EMIT, 0);
        api_read_emit_step(L, step, v[M_EMIT].at, &e);
        motion_pack_emit(&e, rows);
        for (int k = 0; k < EMIT_STEPS; k++)
            *add_step(L, r) = rows[k];
        return false;
    }
    if (v[M_PATH].given) {
        read_path(L, r, v, step);
        return true;
    }
    s = add_step(L, r);
    if (v[M_WAIT_FOR].given) {
        check_key_alone(L, v, step, M_WAIT_FOR, 0);
        api_read_await_step(L, step, v[M_WAIT_FOR].at, s);
        return s->mode == MODE_SIGNAL ||
               record_instant_step(r, "`wait_for` takes no time if its condition already holds");
    }
    fill_step(L, s, v, named_bits, step, r->is_fine);
    return takes_time(r, s);
}

static uint64_t read_steps(lua_State *L, struct program_reader *r, int at, int depth, bool *is_timed);

/* Returns the walls named in a list of words. */
static uint8_t read_walls(lua_State *L, int step, const struct api_value *v)
{
    static const char *const words[] = { "left", "right", "top", "bottom" };
    uint8_t walls = 0;

    if (!v->given)
        return MODE_WALLS;
    for (const char *at = lua_tostring(L, v->at); *at; at += strspn(at, " ")) {
        size_t n = 0;
        int k = 0;
        while (at[n] && at[n] != ' ')
            n++;
        while (k < 4 && (strlen(words[k]) != n || strncmp(words[k], at, n)))
            k++;
        if (k == 4)
            api_error(L, def_entry, "step %d: walls: expected one or more of \"left right top bottom\", got \"%s\"",
                      step, lua_tostring(L, v->at));
        walls |= (uint8_t)(1 << k);
        at += n;
    }
    if (!walls)
        raise_step_error(L, step, "walls: expected one or more of \"left right top bottom\"");
    return walls;
}

/* Adds the step that moves the bullet to a wall, inside the loop whose step was just added. */
static void add_bounce(lua_State *L, struct program_reader *r, const struct api_value v[M_KEY_COUNT], int step)
{
    if (r->is_fine)
        raise_step_error(L, step, "`bounce` cannot be used in a fine motion (this step is always exact)");
    if (r->open_bounce_count++)
        raise_step_error(L, step, "`bounce` cannot be nested in `bounce`");
    r->steps[r->n - 1].actions |= DOES_BOUNCE;
    struct motion_step *s = add_step(L, r);
    s->actions = DOES_BOUNCE;
    s->mode = read_walls(L, step, &v[M_WALLS]);
    s->duration = v[M_OVER].given ? get_frames(&v[M_OVER]) : UINT32_MAX;
}

/* Reads a `loop` or `bounce` step and its nested steps from the table at `at`. Returns how many steps it can run in one
 * frame. */
static uint64_t read_loop(lua_State *L, struct program_reader *r, int at, int depth,
                          const struct api_value v[M_KEY_COUNT], int step, bool *is_timed)
{
    const int key = v[M_BOUNCE].given ? M_BOUNCE : M_LOOP;
    const bool is_bounce = key == M_BOUNCE;
    const uint32_t loop_row = r->n;
    bool inner_timed;

    if (depth == MOTION_MAX_DEPTH)
        raise_step_error(L, step, "loops nested more than 4 deep");
    check_key_alone(L, v, step, key, is_bounce ? KEY(WALLS) | KEY(OVER) : 0);
    struct motion_step *s = add_step(L, r);
    s->actions = DOES_LOOP;
    s->depth = (uint8_t)depth;
    s->count = v[key].i == LUA_MAXINTEGER ? MOTION_FOREVER : (uint16_t)v[key].i;
    if (is_bounce)
        add_bounce(L, r, v, step);
    uint64_t inner_steps = read_steps(L, r, at, depth + 1, &inner_timed);
    r->open_bounce_count -= is_bounce;
    inner_timed |= is_bounce;
    *is_timed |= inner_timed && v[key].i > 0;
    s = add_step(L, r);
    *s = (struct motion_step){ .actions = DOES_LOOP_END, .depth = (uint8_t)depth, .jump = (uint16_t)(loop_row + 1) };
    r->steps[loop_row].jump = (uint16_t)r->n;
    if (is_bounce)
        r->steps[loop_row + 1].jump = (uint16_t)r->n;
    return check_loop_work(L, r, loop_row, inner_timed, inner_steps, v[key].i, step);
}

/* Reads the list of steps in the table at `at`. Returns an upper bound on the number of steps that the list runs in one
 * frame; sets *is_timed to whether the list takes time. */
static uint64_t read_steps(lua_State *L, struct program_reader *r, int at, int depth, bool *is_timed)
{
    uint64_t work = 1;
    int n = (int)lua_rawlen(L, at);

    *is_timed = false;
    for (int i = 1; i <= n; i++) {
        struct api_value v[M_KEY_COUNT];
        int top = lua_gettop(L);
        if (lua_rawgeti(L, at, i) != LUA_TTABLE)
            raise_step_error(L, i, "expected a table");
        uint64_t named_bits = read_keys(L, top + 1, i, v);
        if (!v[M_LOOP].given && !v[M_BOUNCE].given) {
            if (lua_rawlen(L, top + 1))
                raise_step_error(L, i, "nested steps require `loop = n` or `bounce = n`");
            *is_timed |= read_step(L, r, v, named_bits, i);
        } else
            work += read_loop(L, r, top + 1, depth, v, i, is_timed);
        work++;
        lua_settop(L, top);
    }
    return work;
}

enum { HEAD_NAME, HEAD_FINE, HEAD_PARAM_COUNT };

/* Initializes r and reads the named arguments of motion.def, `name` and `fine`. Returns the name, or NULL. */
static const char *read_head(lua_State *L, struct program_reader *r)
{
    static const struct api_param head_params[] = { OPTIONAL("name", A_STR, ""), DEFAULT("fine", A_BOOL, "false", "") };
    static const struct api_fields fields = { head_params, HEAD_PARAM_COUNT, NAME_LISTS };
    struct api_value v[HEAD_PARAM_COUNT] = { { 0 } };

    if (luakeys_push_unknown(L, 1, is_known_step_key, &fields)) {
        const char *key = luakeys_text(L, -1);
        if (key && api_is_step_key(L, key))
            api_error(L, def_entry, "unknown argument \"%s\" (steps are tables: { { %s = ... } })", key, key);
        api_raise_unknown_key(L, def_entry, &fields);
    }
    for (int i = 0; i < HEAD_PARAM_COUNT; i++) {
        lua_getfield(L, 1, head_params[i].name);
        api_check(L, def_entry, &head_params[i], lua_gettop(L), &v[i]);
    }
    r->n = 0;
    r->open_bounce_count = 0;
    r->instant_reason = NULL;
    r->is_fine = v[HEAD_FINE].i;
    return v[HEAD_NAME].given ? lua_tostring(L, v[HEAD_NAME].at) : NULL;
}

static int motion_def(lua_State *L, struct board *b, struct api_value *v)
{
    struct program_reader r;
    bool is_timed;

    (void)v;
    luaL_checktype(L, 1, LUA_TTABLE);
    const char *name = read_head(L, &r);
    if (!lua_rawlen(L, 1) && !r.is_fine)
        api_error(L, def_entry, "expected at least one step");
    if (read_steps(L, &r, 1, 0, &is_timed) > MAX_ROUNDS)
        api_error(L, def_entry, "too many steps in one frame");
    vm_reserve(L, &b->motions.s, 1);
    vm_reserve(L, &b->steps.s, r.n);
    uint32_t refused_before = b->steps.s.refused; /* to find out which pool was full */
    int32_t m = motion_define(&b->motions, &b->steps, r.steps, r.n, r.is_fine);
    if (m == NO_SLOT)
        board_report_full(b, b->steps.s.refused > refused_before ? &b->steps.s : &b->motions.s);
    if (name && api_names_find(L, N_MOTION, name) != (m == NO_SLOT ? NO_MOTION : m))
        api_names_declare(L, N_MOTION, def_entry, name, m == NO_SLOT ? NO_MOTION : m);
    script_update_digest(b, (uint64_t)(uint32_t)m);
    lua_pushinteger(L, m == NO_SLOT ? handle_make(H_MOTION, 0, 0) : handle_make(H_MOTION, 1, (uint32_t)m));
    return 1;
}

const struct api_thing api_motion_thing = { .name = "motion" };

static const struct api_param motion_params[] = { REQUIRED(
    "steps", A_TABLE, "list of steps, run in order; `name = STRING` and `fine = true` can be set in the same table") };

static const struct api_entry entries[] = {
    { "motion.def", motion_def, PARAMS(motion_params), 1, API_CHANGES, "motion",
      HELP("creates a motion program: a list of steps that any number of bullets can run") },
    { "motion.def step", NULL, PARAMS(step_keys), 0, API_LUA | API_SYS, NULL,
      HELP("one step; instead of any number, you can write the name of a value (value.def)") },
    { "motion.def emit", NULL, PARAMS(api_emit_params), 0, API_LUA | API_SYS, NULL,
      HELP("what to fire from the position of the bullet") },
    { "motion.def wait_for", NULL, PARAMS(api_await_params), 0, API_LUA | API_SYS, NULL,
      HELP("condition to wait for: exactly one of `x`, `y`, `near` and `tag`") },
};
const struct api_module api_motion = { entries, sizeof entries / sizeof *entries };
