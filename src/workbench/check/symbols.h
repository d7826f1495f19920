/*
 * symbols.h - the symbol table of a Lua script, made without running it: the globals and fields it names, its strings,
 * calls and tables, and what is wrong on its face.
 *
 * One pass over Lua 5.4's grammar that resolves every name to a local, an upvalue or a global. Lines are those of the
 * Lua compiler. All texts are in the arena, or "" for one that holds a zero byte.
 */
#ifndef WORKBENCH_SYMBOLS_H
#define WORKBENCH_SYMBOLS_H

#include <stdbool.h>
#include <stddef.h>
#include "lex.h"

enum symbol_use {
    USE_VALUE,  /* name is read, and may go anywhere from there */
    USE_INDEX,  /* name[...] is read */
    USE_WRITE,  /* name = ..., function name() */
    USE_FIELD,  /* name.field is read */
    USE_MEMBER, /* name.field = ..., function name.field() */
    USE_METHOD, /* name:field() */
    USE_SELF,   /* function name:field(): in there, name is handed around as self */
};

struct symbol_global {
    enum symbol_use use;
    int line;
    const char *name, *field; /* field: NULL but for the last four */
    const char *local;        /* the nearest local in sight, one slip of the finger away; NULL: none */
};

/* Where a value comes from. */
struct symbol_origin {
    const char *space, *name; /* the function space.name, or name (space NULL); name NULL: not known */
    const char *key;          /* of its table argument, at any depth, or NULL */
    int arg;                  /* which argument, from 1; 0: it is what the call returns */
    int param;                /* ...is a function whose param-th parameter this is, from 1 */
};

/* pairs(x), ipairs(x) or #x of a value from there. */
struct symbol_walk {
    int line;
    const char *how;
    struct symbol_origin of;
};

/* A division by the number 0: / // or %. */
struct symbol_zero {
    int line;
    const char *how;
    bool zero, constant; /* of the left side */
};

enum { SYMBOL_FIRST = 1, SYMBOL_LAST = 2, SYMBOL_KEY = 4 };

struct symbol_text {
    int line;
    const char *s;
    int how; /* SYMBOL_FIRST: ..stands to its right, END_OF_LIST: to its left; KEY: a key or field, not a string */
};

enum { SYMBOL_ARGS = 3 };

/* A call of space.name or of the global name. */
struct symbol_call {
    int line;
    const char *space, *name;
    const char *arg[SYMBOL_ARGS]; /* those that are strings; NULL: something else */
    int args;                     /* how many; a table or string without brackets is one */
};

/* { ... } that stands in an argument of a call, or in such a table. */
struct symbol_table {
    int line;
    const char *space, *name; /* the call; name NULL: none */
    int arg;                  /* which argument, from 1 */
    int key;                  /* whose value it is, an index of keys; -1: it is the argument itself */
};

struct symbol_key {
    int table, line;
    const char *name;
    const char *value; /* a string; NULL: something else */
};

/* local.field = ... */
struct symbol_member {
    int local;
    const char *field;
};

struct symbols {
    struct arena arena;
    struct symbol_global *globals;
    struct symbol_walk *walks;
    struct symbol_zero *zeros;
    struct symbol_text *formats; /* first arguments of string.format and text:format */
    struct symbol_text *texts;
    struct symbol_call *calls;
    struct symbol_table *tables;
    struct symbol_key *keys;
    struct symbol_member *members;
    int n_globals, n_walks, n_zeros, n_formats, n_texts, n_calls, n_tables, n_keys, n_members;
    int result_local, result_table; /* what the script returns at its end, or -1 */
    bool result_open;               /* the local it returns went elsewhere too: others may have put fields into it */
    bool whole;                     /* false: not Lua, nested too deep, or out of memory; then symbols up to there */
};

/* Fills f; free it whatever this returns. is_builtin: globals that are sure to be there (no near local is looked for),
 * or NULL. Returns f->whole: true for every text the Lua compiler accepts. */
bool symbols_read(struct symbols *f, const char *text, size_t n, bool (*is_builtin)(const char *name));
void symbols_free(struct symbols *f);

/* May the table the script returns have that key? */
bool symbols_returns(const struct symbols *f, const char *key);

/* The line of a key in the table the script returns: "sheets", "small", "file", NULL. As deep as it is found; 1 when
 * nothing is. */
int symbols_line(const struct symbols *f, const char *const *path);

#endif
