/*
 * symbols.h - the symbol table of a Lua script, made without running it: its globals and fields, strings, calls and
 * tables, and some certain mistakes.
 *
 * It is made in one pass over Lua 5.4's grammar, which resolves every name to a local, an upvalue or a global. Lines
 * are those of the Lua compiler. All texts are in the arena; a text with a zero byte is "" there.
 */
#ifndef WORKBENCH_SYMBOLS_H
#define WORKBENCH_SYMBOLS_H

#include <stdbool.h>
#include <stddef.h>
#include <string.h>
#include "lex.h"

enum symbol_use {
    USE_VALUE,  /* name is read as a value */
    USE_INDEX,  /* name[...] is read */
    USE_WRITE,  /* name = ..., function name() */
    USE_FIELD,  /* name.field is read */
    USE_MEMBER, /* name.field = ..., function name.field() */
    USE_METHOD, /* name:field() */
    USE_SELF,   /* function name:field(), in which self is the value of name */
};

struct symbol_global {
    enum symbol_use use;
    int line;
    const char *name, *field; /* field: of the last four, otherwise NULL */
    const char *local;        /* a visible local with a similar name; NULL: none */
};

/* The origin of a value: the result of a call, or a parameter of a function in an argument of a call. */
struct symbol_origin {
    const char *space, *name; /* the call of space.name, or name (space NULL); name NULL: not known */
    const char *key;          /* in the argument's table, at any depth: the function's key, or NULL */
    int arg;                  /* number of the argument, from 1; 0: the value is the result of the call */
    int param;                /* number of the function's parameter, from 1 */
};

/* pairs(x), ipairs(x) or #x of a value with a known origin. */
struct symbol_walk {
    int line;
    const char *how;
    struct symbol_origin of;
};

/* A division by the number 0: / // or %. */
struct symbol_zero {
    int line;
    const char *how;
    bool zero, constant; /* properties of the left side */
};

enum { SYMBOL_FIRST = 1, SYMBOL_LAST = 2, SYMBOL_KEY = 4 };

struct symbol_text {
    int line;
    const char *s;
    int how; /* SYMBOL_FIRST: .. follows it; SYMBOL_LAST: .. precedes it; SYMBOL_KEY: a key or field, not a string */
};

enum { SYMBOL_ARGS = 3 };

/* A call of space.name or of the global name. */
struct symbol_call {
    int line;
    const char *space, *name;
    const char *arg[SYMBOL_ARGS]; /* string arguments; NULL: anything else */
    int args;                     /* arguments, including a table or string without brackets */
};

/* A table constructor in an argument of a call, at any depth. */
struct symbol_table {
    int line;
    const char *space, *name; /* the call; name NULL: none */
    int arg;                  /* number of the argument, from 1 */
    int key;                  /* index in keys of the key whose value it is; -1: it is the argument */
};

struct symbol_key {
    int table, line;
    const char *name;
    const char *value; /* a string; NULL: anything else */
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
    int result_local, result_table; /* the local and the table that the script returns, or -1 */
    bool result_open;               /* the local is used elsewhere too, so the table may have other fields */
    bool whole;                     /* false: not Lua, nested too deep, or out of memory: symbols are missing */
};

/* Fills f; free it either way. is_builtin: names for which no similar local is searched, or NULL. Returns f->whole,
 * which is true for every text that the Lua compiler accepts. */
bool symbols_read(struct symbols *f, const char *text, size_t n, bool (*is_builtin)(const char *name));
void symbols_free(struct symbols *f);

/* Compares two names, each of which may be NULL. */
static inline bool symbols_same(const char *a, const char *b)
{
    return a == b || (a != NULL && b != NULL && strcmp(a, b) == 0);
}

/* Returns whether it is a call of space.name, or of the global name (space NULL). */
static inline bool symbol_call_is(const struct symbol_call *call, const char *space, const char *name)
{
    return symbols_same(call->space, space) && symbols_same(call->name, name);
}

/* Returns whether the table that the script returns may have the key. */
bool symbols_returns(const struct symbols *f, const char *key);

/* Returns the line of a key in the table that the script returns: "sheets", "small", "file", NULL; or of the last key
 * of the path that exists, or 1. */
int symbols_line(const struct symbols *f, const char *const *path);

#endif
