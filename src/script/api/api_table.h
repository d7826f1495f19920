/*
 * api_table.h - the Lua API as data: names, arguments, units, help. Needs no Lua headers, because the program includes
 * it.
 */
#ifndef SCRIPT_API_TABLE_H
#define SCRIPT_API_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../machine/handle.h"
#include "../../machine/names.h"

struct lua_State;
struct board;
struct manifest;
struct api_value;

enum api_type {
    A_INT,   /* an integer */
    A_COUNT, /* an integer, or forever */
    A_NUM,   /* any finite number */
    A_FX,    /* a number stored as Q15.16 */
    A_DIR,   /* degrees */
    A_SCALE, /* a number in steps of 1 / SCALE_ONE; i is the number of steps */
    A_STR,
    A_BOOL,
    A_FUNC,
    A_TABLE,
    A_ANY,
    A_SPAN,        /* { first, last }: two integers from lo to hi, in order */
    A_ROUTE,       /* a route returned by path.def */
    A_THING,       /* a handle; `lo` is a mask of 1 << handle_kind */
    A_HIT_SHAPE,   /* a hit shape; lo is an enum hit_owner */
    A_MOTION,      /* a motion, by handle or name */
    A_BULLET_KIND, /* declared names; A_BULLET_KIND + k is category k of enum name_kind */
    A_SHOT_KIND,
    A_ENEMY_KIND,
    A_PLAYER_KIND,
    A_SPARK_KIND,
    A_ITEM_KIND,
    A_LASER_KIND,
    A_OPTION_KIND,
    A_SPRITE,
    A_BLEND, /* a name from rom.lua; i is its index + 1, or 0 if omitted */
    A_FONT,  /* a font in rom.lua, encoded as A_BLEND */
    A_MAP,   /* a map in rom.lua, encoded as A_BLEND */
    A_SOUND, /* a sound or a piece of music in rom.lua, encoded as A_BLEND */
    A_TUNE,
    A_BUTTON,
    A_PLAYER, /* a player: 1, 2 or a player's handle; 0 for a dead handle, which player.nearest may return */
    A_EASE,
    A_LAYER,
    A_SPARK_LAYER, /* i counts from LAYER_MIDDLE */
    A_DEPTH,       /* whether a background layer is behind or in front of all things */
    A_ALIGN,
    A_FIRE,         /* what a pattern fires */
    A_EMIT_FIRE,    /* what an `emit` step fires */
    A_MEET,         /* which of two colliding bullets are removed */
    A_EMIT_PATTERN, /* a pattern of an `emit` step */
    A_BARS_DOWN,    /* how many bars of a cast must be emptied */
    A_HOST_SCREEN,  /* a host screen */
};

/* Whether a parameter is required or optional. VXY: `vx` and `vy`, optional, which replace `speed` and `dir`;
 * UNLESS_VXY: required unless one of these is given. */
enum { REQ = 0, OPT = 1, VXY, UNLESS_VXY };

/* Text printed only by `curtain help lua`. A build without that command contains none of it. */
#ifdef WITHOUT_HELP
#define HELP(text) NULL
#else
#define HELP(text) text
#endif

/* How a property can be used. PROP_SET: a write calls `set` of struct api_thing. PROP_PERSISTENT: read-only; a player's
 * can still be read after the player is out. */
enum { PROP_READ = 0, PROP_WRITE = 1, PROP_SET = PROP_WRITE | 2, PROP_PERSISTENT = 4 };

/* Where the value of a parameter is stored. */
struct api_column {
    size_t offset;        /* in struct board, of the pointer to the column */
    uint8_t size;         /* bytes of an element; 0: no column */
    bool is_signed;       /* the elements are signed */
    bool is_birth;        /* the elements are the clock at birth; the value is the age */
    uint16_t bits;        /* the bits of an element that hold the value; 0: all */
    const char *property; /* instead of a column: a property of a kind (events_set_property); NULL: none */
};

/* A parameter of a function, or a property of a thing. */
struct api_param {
    const char *name;
    enum api_type type;
    int optional;
    double lo, hi;
    const char *unit;         /* may be NULL */
    const char *def;          /* default in Lua syntax; NULL: none */
    const char *help;         /* meaning, in HELP(); for a function, also the arguments passed to it; NULL: none */
    struct api_column column; /* of a property, and of an argument that declares a kind */
    int access;               /* of a property: PROP_ */
};

/* A row of a parameter list. REQUIRED, OPTIONAL and DEFAULT are for types without a range, and the others for ranges
 * that many functions have. After `help`, a row may name the column (STORED), and the access of a property. */
#define WRITABLE   .access = PROP_WRITE
#define SETTER     .access = PROP_SET
#define PERSISTENT .access = PROP_PERSISTENT
#define PARAM(name, type, need, lo, hi, unit, def, ...)                                                                \
    {                                                                                                                  \
        name, type, need, lo, hi, unit, def, HELP_AND_REST(__VA_ARGS__, )                                              \
    }
#define HELP_AND_REST(text, ...)          .help = HELP(text), __VA_ARGS__
#define REQUIRED(name, type, ...)         PARAM(name, type, REQ, 0, 0, NULL, NULL, __VA_ARGS__)
#define OPTIONAL(name, type, ...)         PARAM(name, type, OPT, 0, 0, NULL, NULL, __VA_ARGS__)
#define DEFAULT(name, type, def, ...)     PARAM(name, type, OPT, 0, 0, NULL, def, __VA_ARGS__)
#define THING(name, need, kinds, ...)     PARAM(name, A_THING, need, kinds, 0, NULL, NULL, __VA_ARGS__)
#define LABEL(name, need, ...)            PARAM(name, A_STR, need, 1, 31, NULL, NULL, __VA_ARGS__)
#define COORDINATE(name, type, need, ...) PARAM(name, type, need, -WORLD_EDGE, WORLD_EDGE, "px", NULL, __VA_ARGS__)
#define OFFSET(name, type, ...)           PARAM(name, type, OPT, -WORLD_EDGE, WORLD_EDGE, "px", "0", __VA_ARGS__)
#define LENGTH(name, need, def, ...)      PARAM(name, A_FX, need, 0, MAX_SPEED, "px", def, __VA_ARGS__)
#define BANK(need, def, ...)              PARAM("bank", A_INT, need, 0, 15, NULL, def, __VA_ARGS__)
#define SCALE(need, def, ...)             PARAM("scale", A_SCALE, need, 0.25, 4, NULL, def, __VA_ARGS__)
#define ALPHA(need, def, ...)             PARAM("alpha", A_INT, need, 0, 8, "eighths", def, __VA_ARGS__)
#define SPEED(name, type, need, ...)      PARAM(name, type, need, -MAX_SPEED, MAX_SPEED, "px/frame", NULL, __VA_ARGS__)
#define VXY_PARAMS                                                                                                     \
    SPEED("vx", A_FX, VXY, "horizontal velocity; with `vy`, instead of `dir` and `speed`"),                            \
        SPEED("vy", A_FX, VXY, "vertical velocity; with `vx`, instead of `dir` and `speed`")

enum {
    API_CHANGES = 1 << 0,   /* can change RAM: folded into the script digest */
    API_LOAD_ONLY = 1 << 1, /* only callable while scripts load */
    API_METHOD = 1 << 2,    /* the first argument is the thing before the colon */
    API_LUA = 1 << 3,       /* written in Lua (@std); the table only lists its arguments */
    API_SYS = 1 << 4,       /* only callable by @std */
    API_VARARGS = 1 << 5,   /* any further arguments are passed on */
    API_PATTERN = 1 << 6,   /* a pattern: also takes the arguments of the function that fires its bullets (FIRES_) */
    API_GLOBAL = 1 << 7,    /* is a global */
    API_TAKES_VALUES =
        1 << 8,        /* takes the values declared for what it creates; with API_PATTERN, for what the pattern fires */
    API_EACH = 1 << 9, /* a method run only for live things: not for a dead one, once for each member of a group */
};

/* The C function of an entry. Returns the number of results pushed. */
typedef int api_function(struct lua_State *L, struct board *b, struct api_value *v);

struct api_entry {
    const char *name; /* "bullet.fire", "bullet:aim", "wait" */
    api_function *run;
    const struct api_param *params;
    uint8_t count;            /* number of params */
    uint8_t positional_count; /* number of positional arguments; the others are named, in one table */
    uint16_t flags;
    const char *returns; /* NULL: nothing */
    const char *help;    /* one sentence on what the entry does, in HELP() */
};

/* The properties of a kind of handle. get pushes property p of a live thing, unless its row names a column; set writes
 * property p if its row has PROP_SET. A group has no get or set, but its members' kind and pool. */
struct api_thing {
    const char *name; /* "bullet" */
    const struct api_param *props;
    int n;
    void (*get)(struct lua_State *L, struct board *b, uint32_t slot, int p);
    void (*set)(struct lua_State *L, struct board *b, uint32_t slot, int p, const struct api_value *v);
    size_t slots_offset, tags_offset; /* offset in struct board of the pool, and of the pointer to its tags */
    enum handle_kind member;          /* of a group, whose properties have the same indices; 0: not a group */
    uint64_t write_work;              /* work per live slot of a write or a verb (API_EACH) on a group */
    bool (*has_member)(const struct board *b, uint32_t slot, int p); /* a further condition; NULL: none */
};

struct api_module {
    const struct api_entry *entries;
    int n;
};

/* A documented name that is not an API function ("rom.title"), or a function of @std whose arguments are unchecked
 * ("hud.banner(lines, frames)"). */
struct api_doc_name {
    const char *name, *help;
};

/* What a pattern (API_PATTERN) fires, selected by the pattern's argument `fire`. The pattern then also takes the
 * parameters of the entry of that index in `fire_entries` of struct api_table. */
enum { FIRES_BULLETS, FIRES_SHOTS, FIRES_BOLTS, FIRES_CURVES, FIRES_BEAMS, FIRE_ENTRY_COUNT };

/* The whole API. The argument checks reach it through the board, which receives it at power-on (struct vm), not through
 * api_table: the table's entries need the checks, so a direct reference would be circular. */
struct api_table {
    const struct api_module *const *modules;
    int n;                                       /* number of modules */
    const struct api_thing *const *things;       /* by enum handle_kind; entry 0 is NULL */
    const struct api_entry *const *fire_entries; /* by FIRES_ */
    const struct api_doc_name *doc_names;
    int doc_name_count;
};
extern const struct api_table api_table;

/* The words accepted for a sprite's `layer`, indexed by LAYER_. */
extern const char *const api_layer_names[];

/* api_count_entries returns the number of entries, api_get_entry returns the i-th entry, and api_find_entry returns the
 * entry with that name, or NULL. */
int api_count_entries(const struct api_table *t);
const struct api_entry *api_get_entry(const struct api_table *t, int i);
const struct api_entry *api_find_entry(const struct api_table *t, const char *name);

/* If the entry's name starts with `owner` and the character `separator`, returns the rest ("bullet.fire", "bullet",
 * '.': "fire"). Otherwise, and for entries written in Lua, returns NULL. */
const char *api_member_name(const struct api_entry *e, const char *owner, char separator);

/* Returns the words that an argument of that type accepts and stores the number of words in *n. Returns NULL if the
 * type is not a word list. */
const char *const *api_get_type_words(enum api_type type, int *n);

/* Each kind of thing with its article, for use in a sentence: "a bullet", "an enemy". */
extern const char *const api_thing_names[HANDLE_KINDS];

/* The suggestion for a misspelt word: the nearest candidate so far, the first in byte order of several, and its edit
 * distance. nearest is NULL if no candidate is near; only `word` is set at the start. */
struct api_suggestion {
    const char *word, *nearest;
    int distance;
};
void api_consider(struct api_suggestion *s, const char *candidate);

/* The owner of a hit shape; owners accept different shapes. */
enum hit_owner { HIT_PLAYERS, HIT_ENEMIES, HIT_BULLETS /* bullets and shots */, HIT_LASERS };

/* The accepted shapes in words, by enum hit_owner. */
extern const char *const api_hit_forms[];

/* Returns whether things of that kind can die and therefore have the property `alive`. */
bool api_can_die(enum handle_kind kind);

/* The message for a global reserved for a later feature. */
#define RESERVED_MESSAGE "is reserved for a later version"

/* The reserved globals, separated by spaces, and whether a name is one of them. */
extern const char api_reserved_globals[];
bool api_is_reserved(const char *global);

/* If the table, thing or group of that name ("item", "items") is disabled, returns the text for the %s of
 * API_DISABLED_FORMAT, otherwise NULL. Some API tables belong to a chip that exists only if rom.lua gives it a
 * capacity; games without the chip have neither the table nor the methods of its things. */
const char *api_disabled_reason(const struct manifest *m, const char *name);

/* The error message for a disabled name; %s is the text returned by api_disabled_reason. */
#define API_DISABLED_FORMAT "%s in rom.lua"

/* Returns the names that scripts see in a Lua library ("math"; "": the globals), separated by spaces, or NULL if the
 * library does not exist. */
const char *api_library_names(const char *library);

/* api_replacement returns what to use instead of a standard Lua name that this board lacks (a field of library
 * `library`, or a global if library is NULL), or NULL for any other name. api_find_replacement searches every library
 * for the field `name` and stores the library's name in *library. */
const char *api_replacement(const char *library, const char *name);
const char *api_find_replacement(const char *name, const char **library);

/* Writes to `out` the names of the callable functions whose last word is nearest to `name`, as in "bullet.fire or
 * shot.fire". Returns false if there are none, or more than three. */
bool api_suggest_calls(const struct api_table *t, const char *name, char *out, size_t size);

#endif
