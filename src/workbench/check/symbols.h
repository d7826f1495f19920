/*
 * symbols.h - the symbol table of a Lua script, made without running it: its globals and fields, strings, calls and
 * tables, and some certain mistakes.
 *
 * A single pass of a parser for Lua 5.4 resolves every name to a local, an upvalue or a global. Lines are those of the
 * Lua compiler. All strings are in the arena; a string with a zero byte is "" there.
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
    const char *name, *field; /* field: for USE_FIELD and the uses after it; otherwise NULL */
    const char *local;        /* a visible local with a similar name, or NULL */
};

/* The origin of a value: the result of a call, or a parameter of a function in an argument of a call. */
struct symbol_origin {
    const char *space, *name; /* the call of space.name, or of name (space NULL); name NULL: unknown */
    const char *key;          /* in the argument's table, at any depth: the function's key, or NULL */
    int arg;                  /* number of the argument, from 1; 0: the value is the result of the call */
    int param;                /* number of the function's parameter, from 1 */
};

/* pairs(x), ipairs(x) or #x for a value with a known origin. */
struct symbol_iteration {
    int line;
    const char *operation;
    struct symbol_origin origin;
};

/* A division by the number 0: / // or %. */
struct symbol_division {
    int line;
    const char *operation;
    bool left_is_zero, left_is_number; /* properties of the left side */
};

enum { SYMBOL_FIRST = 1, SYMBOL_LAST = 2, SYMBOL_KEY = 4 };

struct symbol_text {
    int line;
    const char *s;
    int how; /* SYMBOL_FIRST: before ..; SYMBOL_LAST: after ..; SYMBOL_KEY: a key or field, not a string */
};

enum { SYMBOL_ARGS = 3 };

/* A call of space.name or of the global name. */
struct symbol_call {
    int line;
    const char *space, *name;
    const char *arg[SYMBOL_ARGS]; /* string arguments; NULL: anything else */
    int args;                     /* number of arguments, including a table or string without parentheses */
};

/* A table constructor in an argument of a call, at any depth. */
struct symbol_table {
    int line;
    const char *space, *name; /* the call; name NULL: none */
    int arg;                  /* number of the argument, from 1 */
    int key;                  /* index in keys of the key that has it as value; -1: it is the argument itself */
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
    struct symbol_iteration *iterations;
    struct symbol_division *divisions;
    struct symbol_text *formats; /* first arguments of string.format and text:format */
    struct symbol_text *texts;
    struct symbol_call *calls;
    struct symbol_table *tables;
    struct symbol_key *keys;
    struct symbol_member *members;
    int n_globals, n_iterations, n_divisions, n_formats, n_texts, n_calls, n_tables, n_keys, n_members;
    int result_local, result_table; /* the local and the table that the script returns, or -1 */
    bool result_open;               /* the local is also used elsewhere, so the table may have more fields */
    bool complete; /* false: invalid Lua, nested too deeply, or out of memory, so symbols are missing */
};

/* Fills f; free it in either case. is_builtin: names for which no similar local is searched; may be NULL. Returns
 * f->complete, which is true for every text that the Lua compiler accepts. */
bool symbols_read(struct symbols *f, const char *text, size_t n, bool (*is_builtin)(const char *name));
void symbols_free(struct symbols *f);

/* Compares two names, each of which may be NULL. */
static inline bool symbols_same(const char *a, const char *b)
{
    return a == b || (a != NULL && b != NULL && strcmp(a, b) == 0);
}

/* Returns whether the call is one of space.name, or of the global name (space NULL). */
static inline bool symbol_call_is(const struct symbol_call *call, const char *space, const char *name)
{
    return symbols_same(call->space, space) && symbols_same(call->name, name);
}

/* Returns whether the table that the script returns may have the key. */
bool symbols_returns(const struct symbols *f, const char *key);

/* Returns the line of a key in the table that the script returns, by its path: "sheets", "small", "file", NULL. If the
 * key doesn't exist, the line is that of the last existing key of the path, or 1. */
int symbols_line(const struct symbols *f, const char *const *path);

#endif
