/*
 * symbols_parts.h - what symbols.c and symbols_names.c share.
 */
#ifndef WORKBENCH_SYMBOLS_PARTS_H
#define WORKBENCH_SYMBOLS_PARTS_H

#include "symbols.h"

struct local {
    const char *s; /* inside the text */
    size_t n;
    struct symbol_origin from; /* of the only value it ever gets */
    int table;                 /* that value is this table; -1 */
    int writes;                /* assignments after its declaration */
    int values;                /* uses as a value that may go anywhere */
    bool empty;                /* declared without a value */
    bool unknown;              /* its value is not `from` after all */
};

/* Where the expression that comes next stands. */
struct context {
    struct symbol_origin from; /* name NULL: nowhere special */
    int key;                   /* whose value it is, or -1 */
};

struct pending_walk {
    int line, local; /* local -1: of is the origin */
    const char *how;
    struct symbol_origin of;
};

struct parse {
    struct symbols *f;
    struct lex l;
    struct local *locals; /* all, in order of declaration */
    int *active;          /* those in sight, indices of locals */
    struct pending_walk *walks;
    int n_locals, n_active, n_walks;
    int depth, functions;
    int base; /* of active: where those of this function begin */
    bool (*is_builtin)(const char *name);
};

enum kind {
    X_OTHER,
    X_GLOBAL, /* name */
    X_FIELD,  /* space.name of a global */
    X_INDEX,  /* name[...] of a global */
    X_LOCAL,  /* at */
    X_MEMBER, /* local at, .name */
    X_INSIDE, /* local at, [...] */
    X_CALL,   /* of space.name, or of name */
    X_STRING, /* at: index of texts */
    X_NUMBER,
    X_TABLE, /* at: index of tables */
};

struct expr {
    enum kind kind;
    int line, at;
    const char *space, *name;
    bool zero;
};

/* This is no Lua: every loop ends. */
void symbols_stop(struct parse *p);

/* Room for one more at the end of a list of n; lists grow when n is a power of two. */
bool symbols_room(struct parse *p, void *list, int n, size_t size);
const char *symbols_copy(struct parse *p, struct token t);

/* A new local; it is in sight after symbols_show. */
int symbols_declare(struct parse *p, struct token name);
int symbols_declare_unknown(struct parse *p, struct token name);
void symbols_show(struct parse *p, int local);

/* The local in sight of that name, or -1. */
int symbols_find_local(const struct parse *p, const char *s, size_t n);

/* A global is used. */
void symbols_use(struct parse *p, enum symbol_use how, int line, const char *name, const char *field);
int symbols_add_text(struct parse *p, struct token t, int how);

/* The expression was read as a value, or written. */
void symbols_value(struct parse *p, const struct expr *e);
void symbols_store(struct parse *p, const struct expr *e);
struct symbol_origin symbols_origin(const struct expr *e);

/* A local gets the value of e, its i-th assignment. */
void symbols_give(struct parse *p, int local, const struct expr *e);

#define ADD(p, list, n, ...)                                                                                           \
    (symbols_room(p, &(list), n, sizeof *(list)) ? (void)((list)[(n)++] = __VA_ARGS__) : (void)0) /* adds to a list */

#endif
