/*
 * api_table.h - the Lua API as data: names, arguments, units, help. Without Lua's headers: the cabinet includes it.
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
    A_INT,   /* a whole number */
    A_COUNT, /* a whole number, or forever */
    A_NUM,   /* any finite number */
    A_FX,    /* a number kept in Q15.16 */
    A_DIR,   /* degrees */
    A_STR,
    A_BOOL,
    A_FUNC,
    A_TABLE,
    A_ANY,
    A_SPAN,        /* { first, last }: two whole numbers from lo to hi, in order */
    A_ROUTE,       /* what path.def returned */
    A_THING,       /* a handle; `lo` is a mask of 1 << handle_kind */
    A_HIT,         /* a hit shape; lo: whose (api_parts.h) */
    A_MOTION,      /* a motion, by handle or name */
    A_BULLET_KIND, /* names that were declared; A_BULLET_KIND + k is category k of enum name_kind */
    A_SHOT_KIND,
    A_ENEMY_KIND,
    A_PLAYER_KIND,
    A_SPARK_KIND,
    A_ITEM_KIND,
    A_LASER_KIND,
    A_OPTION_KIND,
    A_SPRITE,
    A_BLEND, /* of rom.lua, by name; i is its index + 1, and 0 when it is left out */
    A_FACE,  /* a font of rom.lua, the same way */
    A_MAP,   /* of rom.lua, as A_BLEND */
    A_SOUND, /* a sound of rom.lua, and a piece of its music, the same way */
    A_TUNE,
    A_BUTTON,
    A_PAD, /* a player: 1, 2 or a player's handle; 0: a dead handle, as player.nearest may return */
    A_EASE,
    A_LAYER,
    A_SPARK_LAYER, /* i counts from LAYER_MIDDLE */
    A_DEPTH,       /* which side of all things a layer of the background is on */
    A_ALIGN,
    A_FIRE,  /* what a pattern fires */
    A_SHOOT, /* what the step emit fires */
    A_MEET,  /* which of two bullets that meet goes */
    A_EMIT,  /* a pattern of the step emit */
    A_DOWN,  /* how many bars of a cast must be emptied */
    A_ASK,   /* a screen of the host */
};

enum { REQ = 0, OPT = 1 }; /* must it be given? */

/* Text that only `curtain help lua` prints. A build without that command carries none of it. */
#ifdef WITHOUT_HELP
#define HELP(text) NULL
#else
#define HELP(text) text
#endif

struct api_param {
    const char *name;
    enum api_type type;
    int optional;
    double lo, hi;
    const char *unit; /* may be NULL */
    const char *def;  /* default, as Lua spells it; NULL: none */
    const char *help; /* its meaning, HELP(); of a function also what it is called with; NULL: none */
};

/* A row of a list of parameters. */
#define PARAM(name, type, need, lo, hi, unit, def, help)                                                               \
    {                                                                                                                  \
        name, type, need, lo, hi, unit, def, HELP(help)                                                                \
    }

enum {
    API_CHANGES = 1 << 0, /* can change RAM: folded into the script digest */
    API_LOAD = 1 << 1,    /* only while scripts load */
    API_METHOD = 1 << 2,  /* the first argument is the thing before the colon */
    API_LUA = 1 << 3,     /* written in Lua (@std); the table only knows its arguments */
    API_SYS = 1 << 4,     /* only @std can call it */
    API_MORE = 1 << 5,    /* any further arguments are passed on */
    API_FIRE = 1 << 6,    /* a pattern: takes every argument of bullet.fire, or shot.fire, besides its own */
    API_GLOBAL = 1 << 7,  /* stands among the globals */
    API_VALUES =
        1 << 8, /* takes the values declared for what its name begins with, as API_FIRE those of what it fires */
};

struct api_entry {
    const char *name;                                                      /* "bullet.fire", "bullet:aim", "wait" */
    int (*run)(struct lua_State *L, struct board *b, struct api_value *v); /* returns how many results it pushed */
    const struct api_param *params;
    uint8_t count; /* of params */
    uint8_t plain; /* so many are plain arguments; the others stand in one table */
    uint16_t flags;
    const char *returns; /* NULL: nothing */
    const char *help;    /* one sentence: what it is for; HELP() */
};

/* A property of a thing. PROP_LASTS: only read, and of a player even after it is out. */
enum { PROP_READ = 0, PROP_WRITE = 1, PROP_LASTS = 2 };

struct api_prop {
    struct api_param value; /* name, type, range, unit, meaning */
    int write;              /* PROP_ */
};

/* What a kind of handle can do. get pushes property p of a live thing; set writes it. */
struct api_thing {
    const char *name; /* "bullet" */
    const struct api_prop *props;
    int n;
    void (*get)(struct lua_State *L, struct board *b, uint32_t slot, int p);
    void (*set)(struct lua_State *L, struct board *b, uint32_t slot, int p, const struct api_value *v);
};

struct api_module {
    const struct api_entry *entries;
    int n;
};

/* A name that is no function of the API, "rom.title", or a function of @std's without a check of its arguments,
 * "hud.banner(lines, frames)". */
struct api_plain {
    const char *name, *help;
};

/* A pattern (API_FIRE) takes the parameters of one of these entries too: of what its argument `fire` names. */
enum { FIRES_BULLETS, FIRES_SHOTS, FIRES_BOLTS, FIRES_CURVES, FIRES_BEAMS, FIRES };

/* The whole API. Scripts' calls read it through the board, which is given it when it powers on (struct vm): what
 * checks arguments needs the table, and the table's entries need the check. */
struct api_table {
    const struct api_module *const *modules;
    int n;                                 /* of modules */
    const struct api_thing *const *things; /* by enum handle_kind; 0: NULL */
    const struct api_entry *const *fire;   /* by FIRES_ */
    const struct api_plain *plain;
    int plains;
};
extern const struct api_table api_table;

/* The words of a sprite's `layer`, by LAYER_. */
extern const char *const api_layers[];

/* The number of entries; the i-th one; and that of a name, or NULL. */
int api_count(const struct api_table *t);
const struct api_entry *api_entry(const struct api_table *t, int i);
const struct api_entry *api_find(const struct api_table *t, const char *name);

/* What stands behind `of` and the split in the name of an entry in C: of "bullet.fire", "bullet" and '.', "fire"; else
 * NULL. */
const char *api_member(const struct api_entry *e, const char *of, char split);

/* The words that an argument of that type takes, *n of them; NULL: it is not of the types of a few words. */
const char *const *api_type_list(enum api_type type, int *n);

/* "a bullet", "an enemy": a thing of that kind in a sentence. */
extern const char *const api_thing_names[HANDLES];

/* Keeps the better of two suggestions for a misspelt word: the nearer, then the first in byte order. *best is EDIT_FAR
 * and *found is NULL before the first call. */
void api_suggest_nearer(const char *word, const char *candidate, int *best, const char **found);

/* Whose hit shape it is: they may have different ones. */
enum hit_whose { HIT_PLAYERS, HIT_ENEMIES, HIT_BULLETS /* and shots */, HIT_LASERS };

/* What they may be, in words. */
extern const char *const api_hit_forms[];

/* Does that kind of thing end, so that it has `alive`? */
bool api_ends(enum handle_kind kind);

/* The message for a reserved name: one that is kept for a later feature. */
#define NOT_YET "is reserved for a later version"

/* Is the name reserved? how '.': as a field of the table `of` ("board"; "": the globals); '{': as an argument of the
 * function `of` ("bullet.fire"); ':': as a property or a verb of the thing `of` ("bullet"). */
bool api_reserved(const char *of, char how, const char *name);

/* Some tables of the API belong to a chip that a game has only if rom.lua gives it a capacity. Other games have neither
 * the table nor the methods of its things. Returns the part of API_OFF for the table, thing or group of that name
 * ("item", "items") if it is disabled, otherwise NULL. */
const char *api_off(const struct manifest *m, const char *name);

/* The message for a disabled name; %s is from api_off. */
#define API_OFF "%s in rom.lua"

/* The i-th row of the list of reserved names, words with a blank between; NULL: there are no more. For tests. */
const char *api_reserved_row(int i, const char **of, char *how);

/* The names scripts see of a library of Lua's ("math"; "": the globals), with blanks between; NULL: there is no such
 * library. */
const char *api_library_names(const char *library);

/* What to use in place of a name that Lua has elsewhere and this board has not: the field of a library, or a global
 * (space NULL); NULL: it is none. And of a field of that name, of whichever library: *space is that. */
const char *api_instead(const char *space, const char *name);
const char *api_instead_field(const char *name, const char **space);

/* Functions that scripts can call whose last word is next to `name`, three at most: "bullet.fire or shot.fire"; false:
 * none. */
bool api_near_calls(const struct api_table *t, const char *name, char *out, size_t size);

#endif
