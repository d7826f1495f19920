/*
 * api_parts.h - what the files of the API table share among themselves.
 */
#ifndef SCRIPT_API_PARTS_H
#define SCRIPT_API_PARTS_H

#include <string.h>
#include "api.h"
#include "../luakeys.h"

enum { MAX_PARAMS = 40 };

/* What a function of the API is bound to, its upvalue: a userdata, whose user value is what plan points to. */
struct api_bound {
    const struct api_entry *entry;
    uint64_t hash;         /* of its name */
    struct api_plan *plan; /* api_plan.c; NULL: none was made */
    uint32_t tables;       /* calls that could have made one */
    bool walks;            /* may walk over a table that it is given */
};

/* Pushes f as a function that is bound to e. */
void api_push_bound(lua_State *L, const struct api_entry *e, lua_CFunction f);

static inline const struct api_table *api_of(lua_State *L)
{
    return vm_board(L)->vm.api;
}

/* Pushes the entry as scripts call it. */
void api_push_call(lua_State *L, const struct api_entry *e);

/* What the function that runs is bound to. */
static inline struct api_bound *api_bound(lua_State *L)
{
    return lua_touserdata(L, lua_upvalueindex(1));
}

/* What Lua says of the value at index `now`, which is to stand at `at`: once for its check, the digest and who wants
 * the number. */
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

/* Notes where `entry` is called, under a name, for an error that is found later; and raises that error there. */
void api_note_place(lua_State *L, const char *entry, const char *name);
int api_error_at(lua_State *L, const char *entry, const char *name, const char *format, ...);

/* Pushes how the value at `at` looks in an error. */
const char *api_push_got(lua_State *L, int at);

/* Checks a value that was looked at, given or not; and fills in what p says where none is given. */
void api_check_looked(lua_State *L, const char *entry, const struct api_param *p, struct api_value *v);
void api_fill_default(const struct api_param *p, struct api_value *v);

/* Where a name is likely to be found: the place, among VM_GUESSES, under which it is kept where a name of n bytes was
 * found last among those of `of`. It hashes letters and no address. It is only a guess: who takes it compares the whole
 * name, and searches if it is another, so whatever stands among struct vm_guesses, a search ends the same way. */
static inline unsigned api_guess(const char *name, size_t n, unsigned of)
{
    const uint8_t *c = (const uint8_t *)name;

    return ((unsigned)n * 16u + c[0] + c[n - (n > 0)] * 5u + of * 41u) % VM_GUESSES;
}

/* The entries that a pattern fires with. */
extern const struct api_entry api_fire_bullet, api_fire_shot, api_fire_bolt, api_fire_curve, api_fire_beam;

/* The arguments of bullet.fire and shot.fire, in their order. */
enum {
    FIRE_KIND,
    FIRE_SPEED,
    FIRE_PLACE,
    FIRE_DIR = FIRE_PLACE + PLACE_PARAMS,
    FIRE_AIM,
    FIRE_BANK,
    FIRE_TAG,
    FIRE_MOTION,
    FIRE_BY,              /* of a shot */
    FIRE_DELAY = FIRE_BY, /* of a bullet */
    FIRE_AROUND,          /* of both */
    FIRE_VALUES
};

/* What they are of a bullet (or shot), but for aim. False: it would come from a thing that is gone, or from a ship that
 * was hit. */
bool api_flight(lua_State *L, struct board *b, const char *entry, const struct api_value *v, bool shot,
                struct bullet_shape *s);

/* Properties of what flies, in their order. */
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

/* Property p of bullet, shot or laser head i of s; those before FLIES_LAST. */
void api_get_flight(lua_State *L, struct board *b, const struct bullets *s, enum name_kind names, uint32_t i, int p);
void api_set_flight(lua_State *L, struct board *b, struct bullets *s, const struct bullet_kinds *kinds, uint32_t i,
                    int p, const struct api_value *v);

/* Is the motion (index + 1, 0: none) a fine one? */
static inline bool api_motion_fine(const struct board *b, uint16_t motion)
{
    return motion && b->motions.fine[motion - 1];
}

/* A number of the script in Q32, nearest. It was checked against a range within +-2^15. */
static inline int64_t api_q32(double v)
{
    return fx_nearest(v * 4294967296.0);
}

/* A number in Q32 for what is fine; for what is not, rounded to fx. */
static inline int64_t api_units(bool fine, const struct api_value *v)
{
    return fine ? api_q32(v->n) : (int64_t)v->f * (1 << PACE_BITS);
}

/* A script's write (OVERRIDE_) ends the running motion step's drive. */
void api_override(struct bullets *s, uint32_t i, unsigned what);

/* The same, and all that there are; `list` is for api_hint_push. */
struct api_hint {
    const char *word, *found;
    int best, n;
    bool long_; /* too many for a sentence */
    char list[128];
};
void api_hint_begin(struct api_hint *h, const char *word);
void api_hint_add(struct api_hint *h, const char *name);

/* Pushes " (did you mean "x"?)", or else " (HAS a, b, c)", or nothing where they are many. */
const char *api_hint_push(lua_State *L, const struct api_hint *h, const char *label);

/* What a table of settings may hold: values for n parameters (a key is what is behind the last dot of a name), and
 * declared values (NAME_LISTS: none). */
struct api_fields {
    const struct api_param *params;
    int n;
    enum name_kind values;
};
bool api_knows_field(lua_State *L, const char *key, const void *of);

/* Raises the error for the stray key on top, which suggests the nearest that f knows. */
void api_refuse_key(lua_State *L, const char *entry, const struct api_fields *f);

/* Reads the table at `at`, its values checked in the order of f's parameters, into v, and leaves them on the stack.
 * `where` ("registers.power") stands before a setting's name in errors; NULL: nothing does. */
void api_read_fields(lua_State *L, const char *entry, const char *where, const struct api_fields *f, int at,
                     struct api_value *v);

/* The keys of the table at `at`, which are names, in byte order; returns how many, at most `most`. Good while the table
 * has them. */
int api_sorted_names(lua_State *L, const char *entry, const char *what, const char *expected, int at,
                     const char **names, int most);

/* All parameters of an entry: its own, then those of `fire`, which a pattern takes; fire NULL: none. */
int api_param_count(const struct api_entry *e, const struct api_entry *fire);
const struct api_param *api_param_at(const struct api_entry *e, const struct api_entry *fire, int i);

/* Checks the call's arguments (stack 1 to top), spreads them over the stack and fills v, one a parameter; behind them
 * stand the declared values that the entry takes. Returns how many there are in all; *fire is whose parameters e takes
 * besides its own, or NULL. */
int api_arguments(lua_State *L, const struct api_entry *e, struct api_value *v, const struct api_entry **fire);

/* api_arguments of the function that runs, in less time if its table looks like those before. */
int api_arguments_planned(lua_State *L, struct api_bound *f, struct api_value *v, const struct api_entry **fire);

/* Whose parameters a call of e takes besides its own, by the field `fire` of its table at `at`; NULL: none. And the
 * number of the parameter of that name, or -1. */
const struct api_entry *api_fires(lua_State *L, const struct api_entry *e, int at);
int api_search_param(const struct api_entry *e, const struct api_entry *fire, const char *name);

/* Pushes a table of the call's arguments, checked as those of e, with its defaults; returns 1. Errors begin with e's
 * name, which may say more, in quotes: "boss.def phase \"rain\"". */
int api_checked(lua_State *L, const struct api_entry *e);

/* sys.check(name, ...): a table of the arguments of the entry of that name, checked, with its defaults. */
int api_sys_check(lua_State *L);

/* Folds the value at `at` into the script digest. */
void api_fold(lua_State *L, struct board *b, int at);

/* The same of a value that was looked at, and stands at v->at: of a number, nothing more is asked of Lua. And of a
 * text. */
void api_fold_looked(lua_State *L, struct board *b, const struct api_value *v);
void api_fold_text(lua_State *L, struct board *b, const char *s, size_t n);

/* Folds a call: a hash of the entry's name, and the arguments that were given of v, as they were given. */
void api_fold_call(lua_State *L, struct board *b, uint64_t entry, const struct api_value *v, int n);

/* sys.volley: api_volley.c. */
int api_volley(lua_State *L, struct board *b, struct api_value *v);

/* Pushes the function of the entry that is so called; false, and nothing is pushed: there is none. */
bool api_push_member(lua_State *L, const char *of, char split, const char *name);

/* The tables of the API. `missing` answers reads of what one of them has not. */
void api_open_spaces(lua_State *L, lua_CFunction missing);

/* From now on the table on top, the global of that name, is one of the API's. */
void api_add_space(lua_State *L, const char *name);

/* Pushes the name of the API's table at `at`, or nil; returns it, or NULL. */
const char *api_push_space(lua_State *L, int at);

/* Raises the fault of a read of a field that a table of the API does not have, if it is reserved or of a module that is
 * not there. */
void api_no_field(lua_State *L, const char *of, const char *name);

/* Is it a word of a motion's step? */
bool api_step_word(lua_State *L, const char *name);

/* Sets the number type's metatable: handles' properties and methods. */
void api_open_handles(lua_State *L);

/* Pushes the method of that name, or false. */
bool api_push_method(lua_State *L, int kind, const char *name);

/* Where `aim` points from a place: at the nearest player, of a shot at the nearest enemy; if there is none, or just
 * there, down, and of a shot up. */
ang api_aim(struct board *b, bool shot, fx x, fx y);

/* A hit shape as rows of kinds (motion.h). */
struct api_shape {
    uint8_t shape;
    uint32_t rows;
    struct {
        fx a, b, x, y;
    } row[SHAPE_PARTS];
};

/* Reads the hit shape at `at`. */
struct api_shape api_hit(lua_State *L, const char *entry, int at, enum hit_whose whose);

/* Declares a kind of that shape; returns its index. */
int32_t api_kind(lua_State *L, const char *entry, struct slots *kinds, const struct shape_columns *k,
                 const struct api_shape *s);

/* The values declared for what the entry makes (API_VALUES, API_FIRE), or for that kind of thing; NAME_LISTS: it has
 * none. */
enum name_kind api_value_names(const struct api_entry *e);
enum name_kind api_value_names_of(enum handle_kind kind);

/* How many are declared; `names` may be NAME_LISTS. */
int api_values(const struct board *b, enum name_kind names);

/* What a value of that name may be. */
struct api_param api_value_param(const char *name);

/* Value k of a list: its column, one a slot. */
fx *api_value_column(struct board *b, enum name_kind names, int k);

/* Sets the new thing in slot i to the values that api_arguments put at v. */
void api_value_set(struct board *b, enum name_kind names, uint32_t i, const struct api_value *v);

/* A count (A_COUNT) as a chip keeps it, in 32 bits with -1 for forever, and back. */
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

/* Has slot i the tag? 0: any. */
static inline bool api_has_tag(const uint16_t *tags, uint32_t i, uint32_t tag)
{
    return !tag || tags[i] == tag;
}

/* Arguments of what names things by a tag alone, and of what visits them. */
enum { EACH_TAG, EACH_F, EACH_PARAMS, TAG_PARAMS = 1 };
extern const struct api_param api_tag_params[TAG_PARAMS], api_each_params[EACH_PARAMS];

/* A method's row. */
#define API_VERB(name, run, params, plain, returns, help)                                                              \
    {                                                                                                                  \
        name, run, PARAMS(params), plain, API_CHANGES | API_METHOD, returns, HELP(help)                                \
    }

/* The rows of the functions that do. `noun` names one of the things. */
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

/* Pushes the group of things with the tag that is given, or of all. */
int api_group(lua_State *L, enum handle_kind kind, const char *entry, const struct api_value *tag);

/* Calls the function among the arguments v with each live thing of a pool that has their tag (none: all), in slot
 * order. Things that come during the calls are not visited. */
int api_each(lua_State *L, struct board *b, enum handle_kind kind, const char *entry, const struct slots *s,
             const uint16_t *tags, const struct api_value v[EACH_PARAMS]);

/* What place and shape words name together: everywhere, a circle, a box or a line with a width. */
enum api_region_shape { REGION_ALL, REGION_CIRCLE, REGION_BOX, REGION_LINE };
struct api_region {
    enum api_region_shape shape;
    fx x, y;       /* the middle; where a line begins */
    fx a, b;       /* radius; half width and half height; half the width of a line */
    fx to_x, to_y; /* where a line ends */
};

/* Arguments of what flies: bullets, shots and lasers, alone and as groups. */
#define SELF_OF(kinds) PARAM("self", A_THING, REQ, kinds, 0, NULL, NULL, "the thing itself")

#define AIM_ADD PARAM("add", A_DIR, OPT, 0, 0, NULL, "0", "angle added to the direction towards the target, clockwise")

#define TURN_BY                                                                                                        \
    PARAM("by", A_DIR, REQ, 0, 0, NULL, NULL, "degrees to turn clockwise; a negative number turns counterclockwise")

#define SHIFT_DX                                                                                                       \
    PARAM("dx", A_FX, REQ, -WORLD, WORLD, "px", NULL, "distance to the right; a negative distance moves left")
#define SHIFT_DY PARAM("dy", A_FX, REQ, -WORLD, WORLD, "px", NULL, "distance down; a negative distance moves up")

/* Shape words stand behind those of PLACE, in this order. */
enum { REGION_RADIUS = PLACE_PARAMS, REGION_W, REGION_H, REGION_TO_X, REGION_TO_Y, REGION_WIDTH, REGION_PARAMS };
#define SHAPE_CIRCLE_PARAMS(must, most)                                                                                \
    PARAM("radius", A_FX, must, 0, most, "px", NULL, "radius of a circle around the position")
/* An argument of a box or line that is optional needs the others. */
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

/* Reads REGION_PARAMS values. False: the thing it is placed by is dead, so it is nowhere. */
bool api_region(lua_State *L, struct board *b, const char *entry, const struct api_value *v, struct api_region *r);

/* Is the point in it? Exactly, its edge included. */
bool api_region_has(const struct api_region *r, fx x, fx y);

/* Is laser i, as it is drawn, anywhere in it? */
bool api_region_laser(const struct board *b, const struct api_region *r, uint32_t i);

/* bullet.clear and the clears of bullets, shots and their groups. */
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
/* Raises when `around` is given and the pool has no room for it, which rom.lua gives. */
void api_check_around(lua_State *L, const struct bullets *s, const char *entry, const struct api_value *around);

/* Motion steps: a value's name stands at `at` in place of a number: its NAMED_BITS. */
uint64_t api_step_name(lua_State *L, int step, const char *key, int at);

/* What the tables at `at` of emit and wait_for say (api_step.c). */
enum { EMIT_PARAMS = 17, AWAIT_PARAMS = 5 };
extern const struct api_param api_emit_params[EMIT_PARAMS], api_await_params[AWAIT_PARAMS];
void api_step_emit(lua_State *L, int step, int at, struct motion_emit *e);
void api_step_await(lua_State *L, int step, int at, struct motion_step *s);

/* The legs of the route that stands at `route`, one a call; the rest begins as 0. False: that was the last. */
struct api_leg {
    int route, i;
    bool mirror;
    fx x, y;
};
bool api_step_leg(lua_State *L, int step, struct api_leg *at, struct motion_step *leg);

/* Pushes the module path; raises with `message` unless a route stands at `at`. */
void api_push_routes(lua_State *L, const char *entry, int at, const char *message);

/* The pictures of a kind of enemy or player beside its sprite, and their names (api_looks.c). */
enum { MOST_PICTURES = 15 };
struct api_pictures {
    int n;
    const char *name[MOST_PICTURES];
    uint16_t sprite[MOST_PICTURES];
};

/* Reads the table `pictures`: at most `most`, first those that `first` names, up to its NULL (the kind's own sprite for
 * those that are left out), then the others in byte order. Not given: none. */
void api_pictures_read(lua_State *L, const char *entry, const struct api_value *table, uint16_t own,
                       const char *const *first, int most, struct api_pictures *p);

/* Appends their rows to the list of kinds: the kind itself must be the next. */
void api_pictures_rows(lua_State *L, const char *entry, struct slots *kinds, uint16_t *sprite,
                       const struct api_pictures *p);
void api_pictures_keep(lua_State *L, enum name_kind of, int32_t kind, const struct api_pictures *p);

/* The number of the picture that is named, 0 for nil, or an error; and its name, or nil. */
unsigned api_picture_named(lua_State *L, enum name_kind of, int32_t kind, const char *thing,
                           const struct api_value *name);
void api_picture_push(lua_State *L, enum name_kind of, int32_t kind, unsigned n);

/* Where names of that sort cannot be declared: the line of rom.lua that it takes; else NULL. */
const char *api_names_off(lua_State *L, enum name_kind what);

/* Is it a property of that kind of thing? */
bool api_property(const struct api_thing *t, const char *name);

/* A table of items or registers: { NAME = n }. */
enum { MOST_ITEM_NAMES = ITEM_REGISTERS + 2, AN_ITEM = 6 /* work: one that is dropped */ };
#define ITEM_NAMES "{ NAME = n }"

/* The whole number under a name of the table at `at`. */
int64_t api_named_number(lua_State *L, const char *entry, const char *what, int at, const char *name, double lo,
                         double hi);

/* Pushes a list, as a text, of what a table at `at` (drops = { NAME = n }) names, in byte order of the names; api_drops
 * folds it, too. */
void api_push_drops(lua_State *L, const char *entry, int at);
void api_drops(lua_State *L, const char *entry, int at);

/* Raises if an item gives a register that no ship has, or fills one that has a max nowhere. */
void api_items_check(lua_State *L, struct board *b);

/* Reads the argument options of player.def for that kind of ship. */
void api_options_read(lua_State *L, struct board *b, int32_t ship, const struct api_value *options);

/* The number of the bomb that an argument of player.def names, 0: not given. */
uint8_t api_bomb_named(lua_State *L, const char *what, int32_t ship, const struct api_value *v);

/* In place of a kind of ship: the registers of a run. */
enum { RUN_REGISTERS = -1 };

/* Declares the registers of the table at `at`, { NAME = n or { start = n, .. } }; returns how many. Their rows come one
 * after the other. */
int api_registers_define(lua_State *L, const char *entry, int32_t kind, int at);

/* What the table of a register may hold. */
enum { REGISTER_SETTINGS = 10 };
extern const struct api_param api_register_settings[REGISTER_SETTINGS];

/* The number of a register that the argument `what` names, or an error. */
int api_register_expect(lua_State *L, const char *entry, const char *what, int32_t kind, const char *name);

/* The whole number at `at` that is written to a register; none is too small, for a write stops at min and max.
 */
int64_t api_register_value(lua_State *L, const char *of, const char *name, uint32_t row, int at);

/* The number of a register of that kind of ship, or -1. */
int api_ship_register(lua_State *L, int32_t kind, const char *name);

/* Tells the table on top how a kind of player wants its register i shown: show, at, label, mark, where it says so. */
void api_register_show(lua_State *L, int32_t kind, int i);

/* Pushes the name of the unlock that a kind of player needs, or nil. */
void api_player_needs(lua_State *L, int32_t kind);

/* Has any kind of player, or the run, a register of that name? */
bool api_register_declared(lua_State *L, const char *name);

/* The nearest to a misspelt one of all registers, or NULL. */
const char *api_register_near(lua_State *L, const char *name);

/* Names of a player kind's registers, in the order of their numbers; returns how many. Valid as long as the board. */
int api_player_registers(lua_State *L, int32_t kind, const char *names[PLAYER_REGISTERS]);

/* Player i enters as that kind of player; the kind's run starts as a task. */
int api_player_enter(lua_State *L, struct board *b, uint32_t i, uint16_t kind);

/* A wait of the running task is passed over, if the task is on its way to a practice mark (TASK_SKIPS); else nothing
 * happens. After MAX_SKIPS in one turn it is a fault. Under PRACTICE_LIST the task is stopped then, or after half of a
 * tick's work, so that the others continue. */
int api_pass_wait(lua_State *L, struct board *b);

/* A palette was loaded; if it is another one, the tables of the plane's fog and of a fade's black follow. */
void api_bg_shade(lua_State *L, struct board *b, bool other);

/* Makes the tables of declared names. */
void api_open_names(lua_State *L);

/* Raises the line of rom.lua, in a game without bodies. */
void api_body_check(lua_State *L, const char *entry, const char *what);

#endif
