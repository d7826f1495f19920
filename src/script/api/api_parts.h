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
struct api_binding {
    const struct api_entry *entry;
    uint64_t hash;             /* of the entry's name */
    struct api_plan *plan;     /* api_plan.c; NULL: none made yet */
    uint32_t table_call_count; /* number of calls, before the plan was made, that could have used one */
    bool may_iterate;          /* the function may iterate over a table argument */
};

/* Pushes f as a function bound to e. */
void api_push_bound_function(lua_State *L, const struct api_entry *e, lua_CFunction f);

static inline const struct api_table *api_get_table(lua_State *L)
{
    return vm_board(L)->vm.api;
}

/* Pushes the function that scripts call for the entry. */
void api_push_function(lua_State *L, const struct api_entry *e);

/* Returns the binding of the running function. */
static inline struct api_binding *api_current_binding(lua_State *L)
{
    return lua_touserdata(L, lua_upvalueindex(1));
}

/* Reads the value at stack index `from` into v: its type and, for a number, its bits. The check, the digest and the
 * caller then use v instead of asking Lua again. `at` is the stack index the value will be moved to. */
static inline void api_read_value(lua_State *L, int at, int from, struct api_value *v)
{
    v->at = at;
    v->is_integer = lua_isinteger(L, from);
    v->type = v->is_integer ? LUA_TNUMBER : (int8_t)lua_type(L, from);
    v->given = v->type > LUA_TNIL;
    if (v->is_integer) {
        v->bits = lua_tointeger(L, from);
    } else if (v->type == LUA_TNUMBER) {
        const double d = lua_tonumber(L, from);
        memcpy(&v->bits, &d, sizeof d);
    }
}

/* api_record_location records the source line of the current call of `entry` that declares `name`. api_error_at raises
 * an error about that declaration, found later, with the recorded line. */
void api_record_location(lua_State *L, const char *entry, const char *name);
int api_error_at(lua_State *L, const char *entry, const char *name, const char *format, ...);

/* Pushes a description of the value at `at` for an error message. */
const char *api_push_description(lua_State *L, int at);

/* api_check_value checks a value read by api_read_value, whether or not it was given. api_fill_default sets v to p's
 * default. */
void api_check_value(lua_State *L, const char *entry, const struct api_param *p, struct api_value *v);
void api_fill_default(const struct api_param *p, struct api_value *v);

/* Returns the element of a guess array (struct vm_guesses), below VM_GUESS_COUNT, that stores the index last found for
 * a name of n bytes in list `list`. The element depends on the name's bytes, never on addresses. The stored index is
 * only a guess: callers compare the whole name and search if it differs, so the guesses cannot change a result. */
static inline unsigned api_guess_index(const char *name, size_t n, unsigned list)
{
    const uint8_t *c = (const uint8_t *)name;

    return ((unsigned)n * 16u + c[0] + c[n - (n > 0)] * 5u + list * 41u) % VM_GUESS_COUNT;
}

/* The entries for what a pattern can fire; the pattern also takes their parameters. */
extern const struct api_entry api_bullet_fire_entry, api_shot_fire_entry, api_bolt_entry, api_curve_entry,
    api_beam_entry;

/* Indices of the arguments of bullet.fire and shot.fire. */
enum {
    FIRE_KIND,
    FIRE_SPEED,
    FIRE_POSITION,
    FIRE_DIR = FIRE_POSITION + POSITION_PARAM_COUNT,
    FIRE_AIM,
    FIRE_BANK,
    FIRE_TAG,
    FIRE_MOTION,
    FIRE_OWNER,              /* shots only */
    FIRE_DELAY = FIRE_OWNER, /* bullets only */
    FIRE_AROUND,             /* shots and bullets, like the rest */
    FIRE_VX,
    FIRE_VY,
    FIRE_FIRST_VALUE
};

/* Fills s from the arguments of bullet.fire (or shot.fire), except `aim`. Returns false if the thing `from` is dead or
 * the ship that would fire was hit. */
bool api_read_flight(lua_State *L, struct board *b, const char *entry, const struct api_value *v, bool is_shot,
                     struct bullet_spec *s);

/* The arguments of a velocity, in both forms. */
struct api_velocity {
    struct api_value *speed, *dir, *aim, *vx, *vy;
};

/* If `vx` or `vy` is given, sets speed and dir to theirs, as if these had been given instead, and returns true. Raises
 * an error if both forms are given. */
bool api_resolve_velocity(lua_State *L, const char *entry, struct api_velocity w);

/* Gives a thing just fired with the arguments `vx` and `vy` at vxy exactly this velocity, of which its dir and speed
 * are rounded; does nothing if they were not given. */
void api_set_fired_velocity(struct bullets *s, uint32_t i, const struct api_value *vxy);

/* Returns the number, 1 or 2, of the player who owns what is fired, or 0: the argument `by` or, if it is not given, the
 * owner of the thing that fires. */
uint8_t api_find_shooter(const struct board *b, const struct api_value *owner, const struct api_value *from);

/* Indices of the properties of bullets and shots. */
enum {
    FLIGHT_X,
    FLIGHT_Y,
    FLIGHT_DIR,
    FLIGHT_SPEED,
    FLIGHT_VX,
    FLIGHT_VY,
    FLIGHT_KIND,
    FLIGHT_BANK,
    FLIGHT_TAG,
    FLIGHT_MOTION,
    FLIGHT_AROUND,
    FLIGHT_AGE,
    FLIGHT_FROZEN,
    FLIGHT_SHARED_COUNT,
    FLIGHT_DELAY = FLIGHT_SHARED_COUNT,
    FLIGHT_HP
};

/* Get or set property p, below FLIGHT_SHARED_COUNT, of bullet, shot or laser head i in s. */
void api_get_flight_prop(lua_State *L, struct board *b, const struct bullets *s, uint32_t i, int p);
void api_set_flight_prop(lua_State *L, struct board *b, struct bullets *s, uint32_t i, int p,
                         const struct api_value *v);

/* Returns whether a motion (index + 1; 0: none) runs with 32 fraction bits (BULLET_FINE). */
static inline bool api_motion_is_fine(const struct board *b, uint16_t motion)
{
    return motion && b->motions.is_fine[motion - 1];
}

/* Converts a number from a script to Q32, rounding to nearest. The caller has checked a range within +-2^19. */
static inline int64_t api_to_q32(double v)
{
    return fx_nearest(v * 4294967296.0);
}

/* Converts a number to Q32. Unless `is_fine`, rounds it to fx first. */
static inline int64_t api_value_to_q32(bool is_fine, const struct api_value *v)
{
    return is_fine ? api_to_q32(v->n) : (int64_t)v->f * (1 << Q32_EXTRA_BITS);
}

/* Returns the pool of a bullet, shot or laser head, or of the members of such a group. */
struct bullets *api_flight_pool(struct board *b, int64_t h);

/* The verbs of bullets, shots, lasers and their groups. */
api_function api_verb_aim, api_verb_turn, api_verb_shift, api_verb_remove, api_verb_signal;

/* After a verb removed bullet h, or a group: releases h or the group's bullets if they are held, because they left the
 * field in this frame, so that their pending hits have no effect. */
void api_release_held(struct board *b, int64_t h);

/* A search for the known name nearest to a misspelt word. `list` collects the known names for api_hint_push. */
struct api_hint {
    struct api_suggestion suggestion;
    int n;
    bool is_list_long; /* the list is too long for a sentence */
    char list[128];
};
void api_hint_begin(struct api_hint *h, const char *word);
void api_hint_add(struct api_hint *h, const char *name);

/* Pushes " (did you mean "x"?)" or, if no name is near, `otherwise`. */
const char *api_push_did_you_mean(lua_State *L, const struct api_suggestion *s, const char *otherwise);

/* Pushes " (did you mean "x"?)" or, if no name is near, " (LABEL: a, b, c)"; "" if that list is too long. */
const char *api_hint_push(lua_State *L, const struct api_hint *h, const char *label);

/* The settings a table may hold: n parameters (the key is the part of the name after the last dot) and the declared
 * values of list `value_names` (NAME_LISTS: none). */
struct api_fields {
    const struct api_param *params;
    int n;
    enum name_kind value_names;
};
bool api_is_known_field(lua_State *L, const char *key, const void *fields);

/* Raises the error for the unknown key on top of the stack, suggesting the nearest key in f. */
void api_raise_unknown_key(lua_State *L, const char *entry, const struct api_fields *f);

/* Reads the settings in the table at `at` into v, checks them in the order of f's parameters, and leaves their values
 * on the stack. `prefix` ("registers.power") precedes a setting's name in errors; NULL: no prefix. */
void api_read_fields(lua_State *L, const char *entry, const char *prefix, const struct api_fields *f, int at,
                     struct api_value *v);

/* Stores the keys of the table at `at` in `names`, in byte order, and returns how many there are. Raises an error if a
 * key is not a name or there are more than `max`. The strings are valid while the table holds them. */
int api_read_sorted_keys(lua_State *L, const char *entry, const char *param_name, const char *expected, int at,
                         const char **names, int max);

/* api_param_count returns the number of parameters of a call of e, and api_param_at returns parameter i. If e is a
 * pattern, `fired_entry` is the entry for what it fires, whose parameters follow e's own; otherwise it is NULL. */
int api_param_count(const struct api_entry *e, const struct api_entry *fired_entry);
const struct api_param *api_param_at(const struct api_entry *e, const struct api_entry *fired_entry, int i);

/* Checks the call's arguments (stack 1 to top), spreads them over the stack and fills v: one element per parameter,
 * then one per declared value the entry takes. Returns the number of elements. *fired_entry receives the entry whose
 * parameters e takes in addition, or NULL. */
int api_read_arguments(lua_State *L, const struct api_entry *e, struct api_value *v,
                       const struct api_entry **fired_entry);

/* Like api_read_arguments, for the running function f, but faster if the call's table has the same keys as the tables
 * of earlier calls. */
int api_read_planned_arguments(lua_State *L, struct api_binding *f, struct api_value *v,
                               const struct api_entry **fired_entry);

/* api_find_fired_entry returns the entry whose parameters a call of e also accepts, selected by the field `fire` of the
 * table at `at`, or NULL. api_search_param returns the index of the named parameter, or -1. */
const struct api_entry *api_find_fired_entry(lua_State *L, const struct api_entry *e, int at);
int api_search_param(const struct api_entry *e, const struct api_entry *fired_entry, const char *name);

/* Pushes a table of the call's arguments, checked against e, with defaults filled in; returns 1. Errors begin with e's
 * name, which may carry a quoted detail: "boss.def phase \"rain\"". */
int api_push_checked_arguments(lua_State *L, const struct api_entry *e);

/* sys.check(name, ...): returns a table of the arguments, checked against the entry of that name, with its defaults. */
int api_sys_check(lua_State *L);

/* Folds the value at `at` into the script digest. */
void api_fold_stack_value(lua_State *L, struct board *b, int at);

/* api_fold_value folds the value at v->at, read by api_read_value, and uses the number in v instead of asking Lua
 * again; api_fold_bytes folds n bytes. */
void api_fold_value(lua_State *L, struct board *b, const struct api_value *v);
void api_fold_bytes(lua_State *L, struct board *b, const char *s, size_t n);

/* Folds a call: the hash of the entry's name, and the arguments that were given, before defaults. */
void api_fold_call(lua_State *L, struct board *b, uint64_t entry_hash, const struct api_value *v, int n);

/* The entry sys.volley (api_volley.c). */
int api_push_volley(lua_State *L, struct board *b, struct api_value *v);

/* Pushes the function of the entry whose name is `owner`, the character `separator` and `name` in sequence
 * ("bullet.fire"). Returns false and pushes nothing if there is none. */
bool api_push_member(lua_State *L, const char *owner, char separator, const char *name);

/* Creates the metatable that the API's tables share, with `on_missing` as __index. Call this before api_add_namespace.
 * */
void api_create_namespace_metatable(lua_State *L, lua_CFunction on_missing);

/* Registers the table on top of the stack as the API table of that name. */
void api_add_namespace(lua_State *L, const char *name);

/* Pushes and returns the name of the API table at `at`; pushes nil and returns NULL for any other table. */
const char *api_push_namespace_name(lua_State *L, int at);

/* Raises the fault for reading a missing field of an API table, if the field is reserved, disabled in rom.lua, or
 * belongs to a library module that is not loaded. */
void api_fault_missing_field(lua_State *L, const char *owner, const char *name);

/* Returns whether the name is a key of a motion step. */
bool api_is_step_key(lua_State *L, const char *name);

/* Sets the metatable of the number type, which implements the properties and methods of handles. */
void api_open_handles(lua_State *L);

/* Pushes the method `name` of handles of that kind, or false if there is none. Returns whether there is one. */
bool api_push_method(lua_State *L, int kind, const char *name);

/* Returns the direction from (x, y) to the nearest player, or for a shot to the nearest enemy. If there is no target,
 * or it is exactly at (x, y), returns down, or up for a shot. */
ang api_aim_direction(struct board *b, bool is_shot, fx x, fx y);

/* A hit shape, as the rows that a kind stores (motion.h). */
struct api_shape {
    uint8_t shape;
    uint32_t rows;
    struct {
        fx a, b, x, y;
    } row[SHAPE_MAX_CIRCLES];
};

/* Reads the hit shape at stack index `at`; raises an error if the shape is not accepted by its owner (`owner`). The
 * share of a laser is row[0].a; its shape is SHAPE_CIRCLE, or SHAPE_NONE for "none". */
struct api_shape api_read_hit_shape(lua_State *L, const char *entry, int at, enum hit_owner owner);

/* Applies a scale to the lengths of a hit shape (motion_scale_length). Raises an error if it becomes too large. */
void api_scale_hit_shape(lua_State *L, const char *entry, struct api_shape *s, int32_t scale);

/* Declares a kind with hit shape s; returns the kind's index. */
int32_t api_declare_kind(lua_State *L, const char *entry, struct slots *kinds, const struct shape_columns *k,
                         const struct api_shape *s);

/* api_entry_value_names returns the list of values declared for the things that entry e creates (API_TAKES_VALUES,
 * API_PATTERN), api_kind_value_names the list for a kind of thing. NAME_LISTS: none. */
enum name_kind api_entry_value_names(const struct api_entry *e);
enum name_kind api_kind_value_names(enum handle_kind kind);

/* Returns the number of values declared in list `names`; 0 for NAME_LISTS. */
int api_value_count(const struct board *b, enum name_kind names);

/* Returns the parameter against which the declared value of that name is checked. */
struct api_param api_value_param(const char *name);

/* Returns the column that stores value k of list `names`, one element per slot. */
fx *api_value_column(struct board *b, enum name_kind names, int k);

/* Sets the declared values of the new entity in slot i from v, the elements that api_read_arguments filled for them. */
void api_set_values(struct board *b, enum name_kind names, uint32_t i, const struct api_value *v);

/* Converts a count (A_COUNT) to the 32 bits a chip stores, -1 for forever, and back. */
enum { COUNT_FOREVER = -1 };
static inline int32_t api_to_count(const struct api_value *v)
{
    return v->i == LUA_MAXINTEGER ? COUNT_FOREVER : (int32_t)v->i;
}

static inline void api_push_count(lua_State *L, int32_t n)
{
    lua_pushinteger(L, n == COUNT_FOREVER ? LUA_MAXINTEGER : n);
}
_Static_assert((int)COUNT_FOREVER == FROZEN_FOREVER && (int)COUNT_FOREVER == SAFE_FOREVER &&
                   (int)COUNT_FOREVER == HP_FOREVER,
               "the chips store forever as -1");

/* Returns the number of the tag given as an argument; 0: not given. */
static inline uint16_t api_read_tag(lua_State *L, const char *entry, const struct api_value *tag)
{
    return tag->given ? api_intern_tag(L, entry, tag->at) : 0;
}

/* Returns whether slot i has the tag; tag 0 matches all. */
static inline bool api_has_tag(const uint16_t *tags, uint32_t i, uint32_t tag)
{
    return !tag || tags[i] == tag;
}

/* Arguments of the functions that only select by tag (`group`), and of those that call a function for each thing
 * (`each`). */
enum { EACH_TAG, EACH_F, EACH_PARAM_COUNT, TAG_PARAM_COUNT = 1 };
extern const struct api_param api_tag_params[TAG_PARAM_COUNT], api_each_params[EACH_PARAM_COUNT];

/* Where a parameter's row stores the value: STORED(enemies.x), BITS_OF(enemies.flags, ENEMY_HIDDEN). AGE_OF names the
 * column of birth times, PROPERTY the property of a kind. */
#define IS_SIGNED(columns)                                                                                             \
    _Generic(&(columns), int8_t * * : 1, int16_t * * : 1, int32_t * * : 1, int64_t * * : 1, uint8_t * * : 0,           \
             uint16_t * * : 0, uint32_t * * : 0)
#define IN_COLUMN(columns, ...)                                                                                        \
    .column = { .offset = offsetof(struct board, columns),                                                             \
                .size = sizeof *((struct board *)0)->columns,                                                          \
                .is_signed = IS_SIGNED(((struct board *)0)->columns),                                                  \
                __VA_ARGS__ }
#define STORED(columns)        IN_COLUMN(columns, )
#define BITS_OF(columns, mask) IN_COLUMN(columns, .bits = mask)
#define AGE_OF(columns)        IN_COLUMN(columns, .is_birth = true)
#define PROPERTY(name)         .column = { .property = name }

/* The argument `blend` of a declaration. */
#define BLEND_PARAM(columns, mask)                                                                                     \
    OPTIONAL("blend", A_BLEND, "blend to draw it with, from `blends` in rom.lua; nil draws it opaque",                 \
             BITS_OF(columns, mask))

/* Stores v in element i of the column that p names. */
void api_store_value(lua_State *L, const struct board *b, const struct api_param *p, uint32_t i,
                     const struct api_value *v);

/* Stores the arguments v of the running function in the columns and properties that their rows name, for kind i. */
void api_store_arguments(lua_State *L, struct board *b, int32_t i, const struct api_value *v);

/* The row of a group's property `count`. */
#define COUNT_PROP(members)                                                                                            \
    REQUIRED("count", A_INT, "number of live " members " with the tag; no other property of a group can be read")

/* Where the things of a kind, or a group's members, are stored: the struct's name in struct board. */
#define POOL(pool) .slots_offset = offsetof(struct board, pool.s), .tags_offset = offsetof(struct board, pool.tag)

/* Runs a method of the thing v[0] if the thing is alive. If it is a group, runs the method for each live member, in
 * slot order, with the member as v[0]. Returns 0, the number of results. */
int api_run_each(lua_State *L, struct board *b, struct api_value *v, api_function *run);

/* Runs a method that starts a movement, with api_run_each. Returns 1, with the movement (H_MOVE) of an enemy on the
 * stack, or 0 for a group. */
int api_start_movement(lua_State *L, struct board *b, struct api_value *v, api_function *start);
#define API_MOVE_HELP "; wait_for waits until what it returns has ended"

/* The table rows (struct api_entry) of a method, and of one that is run with api_run_each. */
#define API_VERB(name, run, params, plain, returns, help)                                                              \
    {                                                                                                                  \
        name, run, PARAMS(params), plain, API_CHANGES | API_METHOD, returns, HELP(help)                                \
    }

#define API_EACH_VERB(name, run, params, plain, help)                                                                  \
    {                                                                                                                  \
        name, run, PARAMS(params), plain, API_CHANGES | API_METHOD | API_EACH, NULL, HELP(help)                        \
    }

/* The rows of `noun`.group and `noun`.each. */
#define API_GROUPS(noun)                                                                                               \
    { noun ".group",                                                                                                   \
      api_push_group,                                                                                                  \
      PARAMS(api_tag_params),                                                                                          \
      1,                                                                                                               \
      API_CHANGES,                                                                                                     \
      "group",                                                                                                         \
      HELP("returns a group; writes and method calls on it apply to every live " noun " with the given tag") },        \
    {                                                                                                                  \
        noun ".each", api_call_each, PARAMS(api_each_params), 2, API_CHANGES, NULL,                                    \
            HELP("calls f(" noun ") for each live " noun " with the given tag, in slot order")                         \
    }

/* The functions `group`, `each` and `count` of all kinds of things: "bullet.group". */
api_function api_push_group, api_call_each, api_push_count_of_kind;

/* A region given by a place and shape words: everywhere, a circle, a box or a line with a width. */
enum api_region_shape { REGION_ALL, REGION_CIRCLE, REGION_BOX, REGION_LINE };
struct api_region {
    enum api_region_shape shape;
    fx x, y;       /* centre; start of a line */
    fx a, b;       /* radius; half width and half height; half the width of a line */
    fx to_x, to_y; /* end of a line */
};

/* Arguments of the verbs of bullets, shots, lasers and their groups. */
#define SELF_PARAM_OF(kinds) THING("self", REQ, kinds, "the thing itself")

#define AIM_ADD_PARAM DEFAULT("add", A_DIR, "0", "angle added to the direction towards the target, clockwise")

#define TURN_BY_PARAM REQUIRED("by", A_DIR, "degrees to turn clockwise; a negative number turns counterclockwise")

#define SHIFT_DX_PARAM COORDINATE("dx", A_FX, REQ, "distance to the right; a negative distance moves left")
#define SHIFT_DY_PARAM COORDINATE("dy", A_FX, REQ, "distance down; a negative distance moves up")

/* Indices of the shape words, which follow PLACE in this order. */
enum {
    REGION_RADIUS = POSITION_PARAM_COUNT,
    REGION_W,
    REGION_H,
    REGION_TO_X,
    REGION_TO_Y,
    REGION_WIDTH,
    REGION_PARAM_COUNT
};
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
    COORDINATE("to_x", A_FX, must,                                                                                     \
               "x of the end of a line that starts at the position" SHAPE_NEEDS_##must("`to_y` and `width`")),         \
        COORDINATE("to_y", A_FX, must, "y of the end of the line"),                                                    \
        PARAM("width", A_FX, must, 0, WORLD_EDGE, "px", NULL, "width of the line; its ends are round")

/* Reads a region from REGION_PARAM_COUNT values. Returns false if the thing `from` is dead, so that the region has no
 * position. */
bool api_read_region(lua_State *L, struct board *b, const char *entry, const struct api_value *v, struct api_region *r);

/* Returns whether the region contains the point, edge included. The test is exact. */
bool api_region_contains(const struct api_region *r, fx x, fx y);

/* Returns whether any part of laser i, as drawn, is in the region. */
bool api_region_touches_laser(const struct board *b, const struct api_region *r, uint32_t i);

/* bullet.clear and laser.clear; the verb `clear` of a bullet, shot or laser; and of a group. */
api_function api_clear, api_clear_self, api_clear_group;

#define CLEAR_SPARK_PARAM                                                                                              \
    PARAM("spark", A_SPARK_KIND, OPT, 0, 0, NULL, NULL, "kind of spark to leave behind; overrides `vanish`")
#define CLEAR_ALL_PARAM PARAM("all", A_BOOL, OPT, 0, 0, NULL, "false", "also remove kinds with `clearable = false`")
#define CLEAR_ITEMS_PARAM(replaced)                                                                                    \
    PARAM("items", A_ITEM_KIND, OPT, 0, 0, NULL, NULL, "kind of item that replaces " replaced)

/* Calls are folded with the indices of their arguments, so newer parameters come last, to keep old demos valid. */
#define CLEAR_PARAMS                                                                                                   \
    PARAM("tag", A_STR, OPT, 1, 31, NULL, NULL, "remove only things with this tag"),                                   \
        PARAM("x", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", NULL,                                                     \
              "horizontal position of the shape; give `x` and `y`, or `from`"),                                        \
        PARAM("y", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", NULL, "vertical position of the shape"),                  \
        SHAPE_CIRCLE_PARAMS(OPT, MAX_SPEED), CLEAR_SPARK_PARAM,                                                        \
        PARAM("from", A_THING, OPT, POSITION_HANDLE_KINDS, 0, NULL, NULL,                                              \
              "thing whose position is used instead of `x` and `y`"),                                                  \
        PARAM("dx", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", "0",                                                     \
              "distance added to `x`, or to the position of `from`"),                                                  \
        PARAM("dy", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, "px", "0",                                                     \
              "distance added to `y`, or to the position of `from`"),                                                  \
        SHAPE_BOX_PARAMS(OPT), SHAPE_LINE_PARAMS(OPT), CLEAR_ALL_PARAM, CLEAR_ITEMS_PARAM("each thing removed")
#define CLEAR_GROUP_PARAMS                                                                                             \
    CLEAR_SPARK_PARAM, POSITION_PARAMS, SHAPE_CIRCLE_PARAMS(OPT, MAX_SPEED), SHAPE_BOX_PARAMS(OPT),                    \
        SHAPE_LINE_PARAMS(OPT), CLEAR_ALL_PARAM, CLEAR_ITEMS_PARAM("each thing removed")

/* The parameters and the function of bullet.meet. */
enum { MEET_PARAM_COUNT = 6 };
extern const struct api_param api_bullet_meet_params[MEET_PARAM_COUNT];
int api_bullet_meet(lua_State *L, struct board *b, struct api_value *v);
/* Raises an error if `around` is given but the pool has no column for it, because rom.lua does not enable it. */
void api_check_around(lua_State *L, const struct bullets *s, const char *entry, const struct api_value *around);

/* Reads the name of a declared value, at stack index `at`, that a motion step uses in place of a number. Returns the
 * value's NAMED_VALUE_BITS (motion.h). */
uint64_t api_find_step_value(lua_State *L, int step, const char *key, int at);

/* Reads the keys `params` of a step's table at `at` into v and leaves their values on the stack. numbers: by key, the
 * number of the step that the name of a declared value may replace, plus 1, or 0. Returns the NAMED_VALUE_BITS of all
 * values used. */
uint64_t api_read_step_keys(lua_State *L, int step, const char *entry, const struct api_param *params, int n,
                            const uint8_t *numbers, int at, struct api_value *v);

/* Read the table of settings, at stack index `at`, of an `emit` or `wait_for` step (api_step.c). */
enum { EMIT_PARAM_COUNT = 19, AWAIT_PARAM_COUNT = 5 };
extern const struct api_param api_emit_params[EMIT_PARAM_COUNT], api_await_params[AWAIT_PARAM_COUNT];
void api_read_emit_step(lua_State *L, int step, int at, struct motion_emit *e);
void api_read_await_step(lua_State *L, int step, int at, struct motion_step *s);

/* State of reading the route at stack index `route`; i, x and y start at 0. Each call of api_read_step_leg reads the
 * next leg; returns false after the last one. */
struct api_route_reader {
    int route_at, i;
    bool is_mirrored;
    fx x, y;
};
bool api_read_step_leg(lua_State *L, int step, struct api_route_reader *reader, struct motion_step *leg);

/* Pushes the Lua module `path`. Raises `message` if the game lacks that module or the value at `at` is not a route. */
void api_push_path_module(lua_State *L, const char *entry, int at, const char *message);

/* The pictures of a kind of enemy or player in addition to its sprite, with their names (api_looks.c). */
enum { MAX_PICTURES = 15 };
struct api_pictures {
    int n;
    const char *name[MAX_PICTURES];
    uint16_t sprite[MAX_PICTURES];
};

/* Reads at most `max` pictures from the table `pictures`: first the names in `fixed_names`, which ends with NULL (an
 * omitted picture uses the kind's own sprite), then the other names in byte order. If the table is not given,
 * there are none. */
void api_pictures_read(lua_State *L, const char *entry, const struct api_value *owner, uint16_t default_sprite,
                       const char *const *fixed_names, int max, struct api_pictures *p);

/* api_pictures_append_rows appends the pictures' rows to the list of kinds; the kind itself must be appended next.
 * api_pictures_store_names then stores the pictures' names. */
void api_pictures_append_rows(lua_State *L, const char *entry, struct slots *kinds, uint16_t *sprite,
                              const struct api_pictures *p);
void api_pictures_store_names(lua_State *L, enum name_kind names, int32_t kind, const struct api_pictures *p);

/* api_picture_find returns the number of the named picture, 0 for nil, or raises an error; api_picture_push pushes the
 * picture's name, or nil. */
unsigned api_picture_find(lua_State *L, enum name_kind names, int32_t kind, const char *thing,
                          const struct api_value *name);
void api_picture_push(lua_State *L, enum name_kind names, int32_t kind, unsigned n);

/* If rom.lua disables names of that sort, returns the text for the %s of API_DISABLED_FORMAT, otherwise NULL. */
const char *api_names_disabled_reason(lua_State *L, enum name_kind kind);

/* Returns whether that kind of thing has a property of that name. */
bool api_has_property(const struct api_thing *t, const char *name);

/* A table of items or registers: { NAME = n }. */
enum { MAX_ITEM_NAMES = ITEM_MAX_REGISTERS + 2, DROP_WORK = 6 /* work per dropped item */ };
#define ITEM_TABLE_FORM "{ NAME = n }"

/* Returns the integer under `name` in the table at `at`; raises an error unless it is from lo to hi. */
int64_t api_read_named_number(lua_State *L, const char *entry, const char *param_name, int at, const char *name,
                              double lo, double hi);

/* Both functions pack the items in the table at `at` (drops = { NAME = n }) into a string, in byte order of the names,
 * and push the string; api_push_folded_drops also folds the string. */
void api_push_drops(lua_State *L, const char *entry, int at);
void api_push_folded_drops(lua_State *L, const char *entry, int at);

/* Raises an error if an item's `gives` or `full` names a register that neither a ship nor the run has, or its `full`
 * names one that has no max on any ship or in the run. */
void api_items_check(lua_State *L, struct board *b);

/* Reads the argument `options` of player.def for that kind of ship. */
void api_options_read(lua_State *L, struct board *b, int32_t ship, const struct api_value *options);

/* Returns the number of the bomb named by an argument of player.def; 0: not given. */
uint8_t api_find_bomb(lua_State *L, const char *param_name, int32_t ship, const struct api_value *v);

/* Appends a kind to the list of kinds, stores the arguments v, of which the first is its name, and returns its index.
 */
int32_t api_append_kind(lua_State *L, const char *entry, struct slots *kinds, enum name_kind names,
                        const struct api_value *v);

/* Passed instead of a kind of ship: the registers of the run. */
enum { RUN_REGISTERS = -1 };

/* Declares the registers in the table at `at`, { NAME = n or { start = n, .. } }, in consecutive rows; returns how many
 * there are. */
int api_registers_define(lua_State *L, const char *entry, int32_t kind, int at);

/* The settings a register's table may hold. */
enum { REGISTER_SETTING_COUNT = 10 };
extern const struct api_param api_register_settings[REGISTER_SETTING_COUNT];

/* Returns the number of the register `name`; if there is none, raises an error about the argument `param_name`. */
int api_register_expect(lua_State *L, const char *entry, const char *param_name, int32_t kind, const char *name);

/* Returns the integer at `at`, to be written to a register. Raises an error for anything but an integer up to
 * INT32_MAX; integers below the register's min are accepted, because writes clamp to min and max. */
int64_t api_read_register_value(lua_State *L, const char *entry, const char *name, uint32_t row, int at);

/* Returns the number of a register of that kind of ship, or -1. */
int api_find_ship_register(lua_State *L, int32_t kind, const char *name);

/* Adds to the table on top of the stack how register i of a kind of ship is displayed: show, at, label and mark, if
 * declared. */
void api_register_add_display(lua_State *L, int32_t kind, int i);

/* Returns whether any kind of ship, or the run, has a register of that name. */
bool api_register_is_declared(lua_State *L, const char *name);

/* Returns the register name nearest to a misspelt one, or NULL. */
const char *api_find_nearest_register(lua_State *L, const char *name);

/* Fills `names` with the names of the registers of a kind of ship, indexed by register number; returns how many there
 * are. The strings are valid as long as the board is. */
int api_player_register_names(lua_State *L, int32_t kind, const char *names[PLAYER_MAX_REGISTERS]);

/* Adds player i to the game with that kind of ship and starts the kind's run function, if any, as a task. */
int api_player_enter(lua_State *L, struct board *b, uint32_t i, uint16_t kind);

/* Returns the buttons of player p that are in a state: "down", "pressed", "released" or "repeated". */
unsigned api_get_pads(const struct board *b, const char *state, uint32_t p);

/* Counts a wait that the running task skips while fast-forwarding to a practice mark (TASK_SKIPS); does nothing
 * otherwise. More than MAX_SKIPS in one turn is a fault. If the board only runs through its stages, the task is stopped
 * instead, and also once half of a tick's work limit is used, so that the other tasks continue. Returns 0 if the caller
 * may continue. */
int api_count_skipped_wait(lua_State *L, struct board *b);

/* Returns the text at `at`, a string or a finite number; raises an error for any other value. */
const char *api_check_text(lua_State *L, const char *entry, int at, size_t *n);

/* Call after loading a palette. If the palette changed (`changed`), rebuilds the tables of shades for the plane's fog
 * and for a fade to black. */
void api_bg_rebuild_shades(lua_State *L, struct board *b, bool changed);

/* Set a field of the table on top of the stack; NULL sets nil. */
static inline void api_set_string(lua_State *L, const char *field, const char *value)
{
    lua_pushstring(L, value);
    lua_setfield(L, -2, field);
}

static inline void api_set_integer(lua_State *L, const char *field, lua_Integer value)
{
    lua_pushinteger(L, value);
    lua_setfield(L, -2, field);
}

/* Creates the tables of declared names. */
void api_open_names(lua_State *L);

/* If rom.lua does not enable bodies, raises an error that quotes the line to add. */
void api_check_bodies(lua_State *L, const char *entry, const char *feature);

/* Raises an error if the sprite given as an argument has no rotated copies, which `argument` needs. */
void api_check_rotations(lua_State *L, const char *entry, const char *argument, const struct api_value *sprite);

/* Raises an error that quotes the line to add to rom.lua if transforms are not enabled and one of the n arguments of
 * the running function from `first` on is given. */
void api_check_transforms(lua_State *L, const struct api_value *v, int first, int n);

#endif
