/*
 * api_parts.h - declarations shared by the source files of the API.
 */
#ifndef SCRIPT_API_PARTS_H
#define SCRIPT_API_PARTS_H

#include <string.h>
#include "api.h"
#include "../luakeys.h"

enum { MAX_PARAMS = 40 };

/* The upvalue of an API function: a userdata whose user value keeps `plan` alive. */
struct api_bound {
    const struct api_entry *entry;
    uint64_t hash;         /* of its name */
    struct api_plan *plan; /* api_plan.c; NULL: none made yet */
    uint32_t tables;       /* calls that could have made a plan */
    bool walks;            /* may iterate over a table passed to it */
};

/* Pushes f as a function bound to e. */
void api_push_bound(lua_State *L, const struct api_entry *e, lua_CFunction f);

static inline const struct api_table *api_of(lua_State *L)
{
    return vm_board(L)->vm.api;
}

/* Pushes the function that scripts call for the entry. */
void api_push_call(lua_State *L, const struct api_entry *e);

/* Returns the binding of the running function. */
static inline struct api_bound *api_bound(lua_State *L)
{
    return lua_touserdata(L, lua_upvalueindex(1));
}

/* Reads the type and the number of the value at index `now` into v, once for the check, the digest and the caller. `at`
 * is the stack index the value will have. */
static inline void api_look(lua_State *L, int at, int now, struct api_value *v)
{
    v->at = at;
    v->whole = lua_isinteger(L, now);
    v->type = v->whole ? LUA_TNUMBER : (int8_t)lua_type(L, now);
    v->given = v->type > LUA_TNIL;
    if (v->whole) {
        v->bits = lua_tointeger(L, now);
    } else if (v->type == LUA_TNUMBER) {
        const double d = lua_tonumber(L, now);
        memcpy(&v->bits, &d, sizeof d);
    }
}

/* api_note_place records where `entry` is called under a name, for an error found later; api_error_at raises that error
 * with the recorded place. */
void api_note_place(lua_State *L, const char *entry, const char *name);
int api_error_at(lua_State *L, const char *entry, const char *name, const char *format, ...);

/* Pushes a description of the value at `at` for an error message. */
const char *api_push_got(lua_State *L, int at);

/* api_check_looked checks a value read by api_look, given or not; api_fill_default sets v to p's default. */
void api_check_looked(lua_State *L, const char *entry, const struct api_param *p, struct api_value *v);
void api_fill_default(const struct api_param *p, struct api_value *v);

/* Returns the place, below VM_GUESSES, where the last index found for a name of n bytes in list `of` is stored. The
 * hash uses letters, never addresses. The index is only a guess: callers compare the whole name and search if it
 * differs, so the contents of struct vm_guesses cannot change a result. */
static inline unsigned api_guess(const char *name, size_t n, unsigned of)
{
    const uint8_t *c = (const uint8_t *)name;

    return ((unsigned)n * 16u + c[0] + c[n - (n > 0)] * 5u + of * 41u) % VM_GUESSES;
}

/* The entries a pattern can fire with. */
extern const struct api_entry api_fire_bullet, api_fire_shot, api_fire_bolt, api_fire_curve, api_fire_beam;

/* Indices of the arguments of bullet.fire and shot.fire. */
enum {
    FIRE_KIND,
    FIRE_SPEED,
    FIRE_PLACE,
    FIRE_DIR = FIRE_PLACE + PLACE_PARAMS,
    FIRE_AIM,
    FIRE_BANK,
    FIRE_TAG,
    FIRE_MOTION,
    FIRE_BY,              /* shots only */
    FIRE_DELAY = FIRE_BY, /* bullets only */
    FIRE_AROUND,          /* both */
    FIRE_VALUES
};

/* Fills s from the arguments of a bullet (or shot), except `aim`. Returns false if `from` is dead or the ship that
 * would fire was hit. */
bool api_flight(lua_State *L, struct board *b, const char *entry, const struct api_value *v, bool shot,
                struct bullet_shape *s);

/* Indices of the properties of bullets and shots. */
enum {
    FLIES_X,
    FLIES_Y,
    FLIES_DIR,
    FLIES_SPEED,
    FLIES_VX,
    FLIES_VY,
    FLIES_KIND,
    FLIES_BANK,
    FLIES_TAG,
    FLIES_MOTION,
    FLIES_AROUND,
    FLIES_AGE,
    FLIES_FROZEN,
    FLIES_LAST,
    FLIES_DELAY = FLIES_LAST,
    FLIES_HP
};

/* Get or set property p, below FLIES_LAST, of bullet, shot or laser head i in s. */
void api_get_flight(lua_State *L, struct board *b, const struct bullets *s, enum name_kind names, uint32_t i, int p);
void api_set_flight(lua_State *L, struct board *b, struct bullets *s, const struct bullet_kinds *kinds, uint32_t i,
                    int p, const struct api_value *v);

/* Returns whether the motion (index + 1, 0: none) is fine. */
static inline bool api_motion_fine(const struct board *b, uint16_t motion)
{
    return motion && b->motions.fine[motion - 1];
}

/* Converts a number from a script to Q32, rounding to nearest. The caller has checked a range within +-2^15. */
static inline int64_t api_q32(double v)
{
    return fx_nearest(v * 4294967296.0);
}

/* Converts a number to Q32; unless fine, it is rounded to fx first. */
static inline int64_t api_units(bool fine, const struct api_value *v)
{
    return fine ? api_q32(v->n) : (int64_t)v->f * (1 << PACE_BITS);
}

/* Records that a script wrote a property (OVERRIDE_), which ends the running motion step's control of it. */
void api_override(struct bullets *s, uint32_t i, unsigned what);

/* A search for the known name nearest to a misspelt one. `list` holds the names seen, for api_hint_push. */
struct api_hint {
    const char *word, *found;
    int best, n;
    bool long_; /* the list is too long for a sentence */
    char list[128];
};
void api_hint_begin(struct api_hint *h, const char *word);
void api_hint_add(struct api_hint *h, const char *name);

/* Pushes " (did you mean "x"?)", otherwise " (LABEL: a, b, c)", or "" if the list is too long. */
const char *api_hint_push(lua_State *L, const struct api_hint *h, const char *label);

/* The settings a table may hold: n parameters (the key is the part of the name after the last dot), and declared values
 * (NAME_LISTS: none). */
struct api_fields {
    const struct api_param *params;
    int n;
    enum name_kind values;
};
bool api_knows_field(lua_State *L, const char *key, const void *of);

/* Raises the error for the unknown key on top of the stack, suggesting the nearest key in f. */
void api_refuse_key(lua_State *L, const char *entry, const struct api_fields *f);

/* Reads the table at `at` into v, checked in the order of f's parameters, and leaves the values on the stack. `where`
 * ("registers.power") precedes a setting's name in errors; NULL: no prefix. */
void api_read_fields(lua_State *L, const char *entry, const char *where, const struct api_fields *f, int at,
                     struct api_value *v);

/* Collects the keys of the table at `at`, which must be names, in byte order. Returns their number, at most `most`. The
 * strings are valid while the table holds them. */
int api_sorted_names(lua_State *L, const char *entry, const char *what, const char *expected, int at,
                     const char **names, int most);

/* The number of parameters of an entry, and parameter i: the entry's own first, then those of `fire`, for a pattern;
 * fire NULL: none. */
int api_param_count(const struct api_entry *e, const struct api_entry *fire);
const struct api_param *api_param_at(const struct api_entry *e, const struct api_entry *fire, int i);

/* Checks the call's arguments (stack 1 to top), spreads them over the stack and fills v, one element per parameter,
 * followed by the declared values the entry takes. Returns the number of parameters; *fire is the entry whose
 * parameters e takes in addition, or NULL. */
int api_arguments(lua_State *L, const struct api_entry *e, struct api_value *v, const struct api_entry **fire);

/* As api_arguments, for the running function, but faster if its table has the keys of earlier calls. */
int api_arguments_planned(lua_State *L, struct api_bound *f, struct api_value *v, const struct api_entry **fire);

/* api_fires returns the entry whose parameters a call of e takes in addition, chosen by the field `fire` of the table
 * at `at`, or NULL. api_search_param returns the index of the named parameter, or -1. */
const struct api_entry *api_fires(lua_State *L, const struct api_entry *e, int at);
int api_search_param(const struct api_entry *e, const struct api_entry *fire, const char *name);

/* Pushes a table of the call's arguments, checked against e, with defaults filled in; returns 1. Errors begin with e's
 * name, which may carry a quoted detail: "boss.def phase \"rain\"". */
int api_checked(lua_State *L, const struct api_entry *e);

/* sys.check(name, ...): returns a table of the arguments, checked against the entry of that name, with its defaults. */
int api_sys_check(lua_State *L);

/* Folds the value at `at` into the script digest. */
void api_fold(lua_State *L, struct board *b, int at);

/* api_fold_looked folds the value at v->at, read by api_look, and uses the number in v instead of asking Lua again;
 * api_fold_text folds n bytes. */
void api_fold_looked(lua_State *L, struct board *b, const struct api_value *v);
void api_fold_text(lua_State *L, struct board *b, const char *s, size_t n);

/* Folds a call: the hash of the entry's name, and the arguments that were given, before defaults. */
void api_fold_call(lua_State *L, struct board *b, uint64_t entry, const struct api_value *v, int n);

/* sys.volley: api_volley.c. */
int api_volley(lua_State *L, struct board *b, struct api_value *v);

/* Pushes the function of the entry named `of`, `split`, `name`. Returns false and pushes nothing if there is none. */
bool api_push_member(lua_State *L, const char *of, char split, const char *name);

/* Opens the tables of the API; `missing` is their __index. */
void api_open_spaces(lua_State *L, lua_CFunction missing);

/* Makes the table on top, the global of that name, one of the API's tables. */
void api_add_space(lua_State *L, const char *name);

/* Pushes and returns the name of the API table at `at`; pushes nil and returns NULL for any other table. */
const char *api_push_space(lua_State *L, int at);

/* Raises the fault for reading a missing field of an API table, if the field is reserved, disabled in rom.lua, or
 * belongs to a library module that is not loaded. */
void api_no_field(lua_State *L, const char *of, const char *name);

/* Returns whether the name is a key of a motion step. */
bool api_step_word(lua_State *L, const char *name);

/* Sets the number type's metatable: handles' properties and methods. */
void api_open_handles(lua_State *L);

/* Pushes the method of that name, or false. Returns whether there is one. */
bool api_push_method(lua_State *L, int kind, const char *name);

/* Returns the direction `aim` gives at (x, y): towards the nearest player, or for a shot the nearest enemy. Without a
 * target, or exactly on it: down, for a shot up. */
ang api_aim(struct board *b, bool shot, fx x, fx y);

/* A hit shape, in the rows that kinds store (motion.h). */
struct api_shape {
    uint8_t shape;
    uint32_t rows;
    struct {
        fx a, b, x, y;
    } row[SHAPE_PARTS];
};

/* Reads the hit shape at `at`. */
struct api_shape api_hit(lua_State *L, const char *entry, int at, enum hit_whose whose);

/* Declares a kind with that shape; returns its index. */
int32_t api_kind(lua_State *L, const char *entry, struct slots *kinds, const struct shape_columns *k,
                 const struct api_shape *s);

/* Returns the list of values declared for what the entry makes (API_VALUES, API_FIRE), or for that kind of thing;
 * NAME_LISTS: none. */
enum name_kind api_value_names(const struct api_entry *e);
enum name_kind api_value_names_of(enum handle_kind kind);

/* Returns the number of declared values; `names` may be NAME_LISTS. */
int api_values(const struct board *b, enum name_kind names);

/* Returns the parameter that checks a value of that name. */
struct api_param api_value_param(const char *name);

/* Returns the column of value k of a list, one element per slot. */
fx *api_value_column(struct board *b, enum name_kind names, int k);

/* Sets the values of the new entity in slot i from v, where api_arguments put them. */
void api_value_set(struct board *b, enum name_kind names, uint32_t i, const struct api_value *v);

/* Converts a count (A_COUNT) to the 32 bits a chip stores, -1 for forever, and back. */
enum { COUNT_FOREVER = -1 };
static inline int32_t api_or_forever(const struct api_value *v)
{
    return v->i == LUA_MAXINTEGER ? COUNT_FOREVER : (int32_t)v->i;
}

static inline void api_push_or_forever(lua_State *L, int32_t n)
{
    lua_pushinteger(L, n == COUNT_FOREVER ? LUA_MAXINTEGER : n);
}
_Static_assert((int)COUNT_FOREVER == FROZEN_FOREVER && (int)COUNT_FOREVER == SAFE_FOREVER &&
                   (int)COUNT_FOREVER == HP_FOREVER,
               "the chips store forever as -1");

/* Returns whether slot i has the tag; tag 0 matches all. */
static inline bool api_has_tag(const uint16_t *tags, uint32_t i, uint32_t tag)
{
    return !tag || tags[i] == tag;
}

/* Arguments of functions that select by tag only, and of those that call a function for each thing. */
enum { EACH_TAG, EACH_F, EACH_PARAMS, TAG_PARAMS = 1 };
extern const struct api_param api_tag_params[TAG_PARAMS], api_each_params[EACH_PARAMS];

/* The table row of a method. */
#define API_VERB(name, run, params, plain, returns, help)                                                              \
    {                                                                                                                  \
        name, run, PARAMS(params), plain, API_CHANGES | API_METHOD, returns, HELP(help)                                \
    }

/* The rows of `noun`.group and `noun`.each. */
#define API_GROUPS(noun, group, each)                                                                                  \
    { noun ".group",                                                                                                   \
      group,                                                                                                           \
      PARAMS(api_tag_params),                                                                                          \
      1,                                                                                                               \
      API_CHANGES,                                                                                                     \
      "group",                                                                                                         \
      HELP("returns a group; writes and method calls on it apply to every live " noun " with the given tag") },        \
    {                                                                                                                  \
        noun ".each", each, PARAMS(api_each_params), 2, API_CHANGES, NULL,                                             \
            HELP("calls f(" noun ") for each live " noun " with the given tag, in slot order")                         \
    }

/* Pushes a handle for the group of things with the given tag, or of all. */
int api_group(lua_State *L, enum handle_kind kind, const char *entry, const struct api_value *tag);

/* Calls the function in v with each live entity of a pool that has the tag in v (none: all), in slot order. Entities
 * spawned during the calls are not visited. */
int api_each(lua_State *L, struct board *b, enum handle_kind kind, const char *entry, const struct slots *s,
             const uint16_t *tags, const struct api_value v[EACH_PARAMS]);

/* A region given by a place and shape words: everywhere, a circle, a box or a line with a width. */
enum api_region_shape { REGION_ALL, REGION_CIRCLE, REGION_BOX, REGION_LINE };
struct api_region {
    enum api_region_shape shape;
    fx x, y;       /* centre; start of a line */
    fx a, b;       /* radius; half width and half height; half the width of a line */
    fx to_x, to_y; /* end of a line */
};

/* Arguments of the verbs of bullets, shots and lasers, single or as groups. */
#define SELF_OF(kinds) PARAM("self", A_THING, REQ, kinds, 0, NULL, NULL, "the thing itself")

#define AIM_ADD PARAM("add", A_DIR, OPT, 0, 0, NULL, "0", "angle added to the direction towards the target, clockwise")

#define TURN_BY                                                                                                        \
    PARAM("by", A_DIR, REQ, 0, 0, NULL, NULL, "degrees to turn clockwise; a negative number turns counterclockwise")

#define SHIFT_DX                                                                                                       \
    PARAM("dx", A_FX, REQ, -WORLD, WORLD, "px", NULL, "distance to the right; a negative distance moves left")
#define SHIFT_DY PARAM("dy", A_FX, REQ, -WORLD, WORLD, "px", NULL, "distance down; a negative distance moves up")

/* Indices of the shape words, which follow PLACE in this order. */
enum { REGION_RADIUS = PLACE_PARAMS, REGION_W, REGION_H, REGION_TO_X, REGION_TO_Y, REGION_WIDTH, REGION_PARAMS };
#define SHAPE_CIRCLE_PARAMS(must, most)                                                                                \
    PARAM("radius", A_FX, must, 0, most, "px", NULL, "radius of a circle around the position")
/* The help of an optional argument of a box or line names the arguments it needs. */
#define SHAPE_NEEDS_OPT(others) "; needs " others
#define SHAPE_NEEDS_REQ(others) ""
#define SHAPE_BOX_PARAMS(must)                                                                                         \
    PARAM("w", A_FX, must, 0, 32767, "px", NULL, "width of a box centred on the position" SHAPE_NEEDS_##must("`h`")),  \
        PARAM("h", A_FX, must, 0, 32767, "px", NULL,                                                                   \
              "height of a box centred on the position" SHAPE_NEEDS_##must("`w`"))
#define SHAPE_LINE_PARAMS(must)                                                                                        \
    PARAM("to_x", A_FX, must, -WORLD, WORLD, "px", NULL,                                                               \
          "x of the end of a line that starts at the position" SHAPE_NEEDS_##must("`to_y` and `width`")),              \
        PARAM("to_y", A_FX, must, -WORLD, WORLD, "px", NULL, "y of the end of the line"),                              \
        PARAM("width", A_FX, must, 0, WORLD, "px", NULL, "width of the line; its ends are round")

/* Reads a region from REGION_PARAMS values. Returns false if the thing that places it is dead, so it is nowhere. */
bool api_region(lua_State *L, struct board *b, const char *entry, const struct api_value *v, struct api_region *r);

/* Returns whether the region contains the point, edge included. The test is exact. */
bool api_region_has(const struct api_region *r, fx x, fx y);

/* Returns whether any part of laser i, as drawn, is in the region. */
bool api_region_laser(const struct board *b, const struct api_region *r, uint32_t i);

/* The parameters and functions of bullet.clear, laser.clear and the clear verbs of bullets, shots, lasers and
 * groups. */
enum {
    CLEAR_PARAMS = 16,
    CLEAR_SELF_PARAMS = 3,
    CLEAR_GROUP_PARAMS = 4 + REGION_PARAMS,
    LASER_CLEAR_PARAMS = 16,
    LASER_CLEAR_SELF_PARAMS = 4,
    LASER_CLEAR_GROUP_PARAMS = 5 + REGION_PARAMS
};
extern const struct api_param api_clear_params[CLEAR_PARAMS], api_clear_self_params[CLEAR_SELF_PARAMS],
    api_clear_group_params[CLEAR_GROUP_PARAMS], api_laser_clear_params[LASER_CLEAR_PARAMS],
    api_laser_clear_self_params[LASER_CLEAR_SELF_PARAMS], api_laser_clear_group_params[LASER_CLEAR_GROUP_PARAMS];
int api_clear(lua_State *L, struct board *b, struct api_value *v);
int api_clear_self(lua_State *L, struct board *b, struct api_value *v);
int api_clear_group(lua_State *L, struct board *b, struct api_value *v);
int api_laser_clear(lua_State *L, struct board *b, struct api_value *v);
int api_laser_clear_self(lua_State *L, struct board *b, struct api_value *v);
int api_laser_clear_group(lua_State *L, struct board *b, struct api_value *v);

/* bullet.meet. */
enum { MEET_PARAMS = 6 };
extern const struct api_param api_meet_params[MEET_PARAMS];
int api_meet(lua_State *L, struct board *b, struct api_value *v);
/* Raises an error if `around` is given and rom.lua has not given the pool the column for it. */
void api_check_around(lua_State *L, const struct bullets *s, const char *entry, const struct api_value *around);

/* Reads the name of a value, at `at`, that a motion step uses in place of a number; returns its NAMED_BITS. */
uint64_t api_step_name(lua_State *L, int step, const char *key, int at);

/* Read the tables at `at` of the steps emit and wait_for (api_step.c). */
enum { EMIT_PARAMS = 17, AWAIT_PARAMS = 5 };
extern const struct api_param api_emit_params[EMIT_PARAMS], api_await_params[AWAIT_PARAMS];
void api_step_emit(lua_State *L, int step, int at, struct motion_emit *e);
void api_step_await(lua_State *L, int step, int at, struct motion_step *s);

/* Reads the legs of the route at stack index `route`, one per call; the other fields start at 0. Returns false after
 * the last leg. */
struct api_leg {
    int route, i;
    bool mirror;
    fx x, y;
};
bool api_step_leg(lua_State *L, int step, struct api_leg *at, struct motion_step *leg);

/* Pushes the module path; raises `message` unless the value at `at` is a route. */
void api_push_routes(lua_State *L, const char *entry, int at, const char *message);

/* The pictures of a kind of enemy or player in addition to its sprite, with their names (api_looks.c). */
enum { MOST_PICTURES = 15 };
struct api_pictures {
    int n;
    const char *name[MOST_PICTURES];
    uint16_t sprite[MOST_PICTURES];
};

/* Reads at most `most` pictures from the table `pictures`: first the names in `first`, up to its NULL (those omitted
 * use the kind's own sprite), then the others in byte order. Not given: none. */
void api_pictures_read(lua_State *L, const char *entry, const struct api_value *table, uint16_t own,
                       const char *const *first, int most, struct api_pictures *p);

/* api_pictures_rows appends the pictures' rows to the list of kinds; the kind itself must be appended next. */
void api_pictures_rows(lua_State *L, const char *entry, struct slots *kinds, uint16_t *sprite,
                       const struct api_pictures *p);
void api_pictures_keep(lua_State *L, enum name_kind of, int32_t kind, const struct api_pictures *p);

/* api_picture_named returns the number of the named picture, 0 for nil, or raises an error; api_picture_push pushes the
 * picture's name, or nil. */
unsigned api_picture_named(lua_State *L, enum name_kind of, int32_t kind, const char *thing,
                           const struct api_value *name);
void api_picture_push(lua_State *L, enum name_kind of, int32_t kind, unsigned n);

/* Returns the line rom.lua needs before names of that sort can be declared, or NULL if they already can. */
const char *api_names_off(lua_State *L, enum name_kind what);

/* Returns whether that kind of thing has the property. */
bool api_property(const struct api_thing *t, const char *name);

/* A table of items or registers: { NAME = n }. */
enum { MOST_ITEM_NAMES = ITEM_REGISTERS + 2, AN_ITEM = 6 /* work per dropped item */ };
#define ITEM_NAMES "{ NAME = n }"

/* Returns the integer under `name` in the table at `at`. */
int64_t api_named_number(lua_State *L, const char *entry, const char *what, int at, const char *name, double lo,
                         double hi);

/* Both pack the items in the table at `at` (drops = { NAME = n }) into a string, in byte order of the names, and push
 * it; api_drops also folds it. */
void api_push_drops(lua_State *L, const char *entry, int at);
void api_drops(lua_State *L, const char *entry, int at);

/* Raises an error if an item gives a register that no ship has, or fills one that has no max anywhere. */
void api_items_check(lua_State *L, struct board *b);

/* Reads the argument `options` of player.def for that kind of ship. */
void api_options_read(lua_State *L, struct board *b, int32_t ship, const struct api_value *options);

/* Returns the number of the bomb named by an argument of player.def; 0: not given. */
uint8_t api_bomb_named(lua_State *L, const char *what, int32_t ship, const struct api_value *v);

/* In place of a kind of ship: the registers of the run. */
enum { RUN_REGISTERS = -1 };

/* Declares the registers in the table at `at`, { NAME = n or { start = n, .. } }; returns their number. Their rows are
 * consecutive. */
int api_registers_define(lua_State *L, const char *entry, int32_t kind, int at);

/* The settings a register's table may hold. */
enum { REGISTER_SETTINGS = 10 };
extern const struct api_param api_register_settings[REGISTER_SETTINGS];

/* Returns the number of the register named by the argument `what`; raises an error if it is unknown. */
int api_register_expect(lua_State *L, const char *entry, const char *what, int32_t kind, const char *name);

/* Returns the integer at `at`, to be written to a register. Any value is accepted below, because writes clamp to min
 * and max. */
int64_t api_register_value(lua_State *L, const char *of, const char *name, uint32_t row, int at);

/* Returns the number of a register of that kind of ship, or -1. */
int api_ship_register(lua_State *L, int32_t kind, const char *name);

/* Adds to the table on top how register i of a ship kind is displayed: show, at, label, mark, as far as declared. */
void api_register_show(lua_State *L, int32_t kind, int i);

/* Pushes the name of the unlock that a kind of ship needs, or nil. */
void api_player_needs(lua_State *L, int32_t kind);

/* Returns whether any kind of ship, or the run, has a register of that name. */
bool api_register_declared(lua_State *L, const char *name);

/* Returns the register name nearest to a misspelt one, or NULL. */
const char *api_register_near(lua_State *L, const char *name);

/* Fills names with the registers of a kind of ship, by number; returns their number. The strings are valid as long as
 * the board. */
int api_player_registers(lua_State *L, int32_t kind, const char *names[PLAYER_REGISTERS]);

/* Player i joins with that kind of ship; the kind's run function starts as a task. */
int api_player_enter(lua_State *L, struct board *b, uint32_t i, uint16_t kind);

/* Counts a wait that the running task skips while fast-forwarding to a practice mark (TASK_SKIPS); does nothing
 * otherwise. More than MAX_SKIPS in one turn is a fault. Under PRACTICE_LIST the task is stopped instead, also once
 * half of a tick's work is used, so that the others continue. Returns 0 if the caller may continue. */
int api_pass_wait(lua_State *L, struct board *b);

/* Call after loading a palette. If it is another one, rebuilds the tables for the plane's fog and for a fade to
 * black. */
void api_bg_shade(lua_State *L, struct board *b, bool other);

/* Creates the tables of declared names. */
void api_open_names(lua_State *L);

/* Raises an error quoting the line for rom.lua if the game has no bodies. */
void api_body_check(lua_State *L, const char *entry, const char *what);

#endif
