/*
 * lex.h - Lua 5.4's tokens.
 *
 * The text is taken to be what the Lua compiler accepts. Anything else ends in T_BAD sooner or later, and is never read
 * beyond its end.
 */
#ifndef WORKBENCH_LEX_H
#define WORKBENCH_LEX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../base/cursor.h"

/* Texts that live until the arena is closed. */
struct arena {
    struct arena_block *last;
    size_t left; /* bytes free at the end of it */
    bool failed; /* out of memory: some text was given as "" */
};

/* A copy of n bytes with a 0 behind it. */
const char *arena_copy(struct arena *a, const char *s, size_t n);
void arena_close(struct arena *a);

/* A token of one character is that character. */
enum {
    T_END = 256, /* of the text */
    T_BAD,       /* not Lua: stays the token from there on */
    T_NAME,
    T_STRING,
    T_NUMBER,
    T_CONCAT, /* .. */
    T_DOTS,   /* ... */
    T_EQ,
    T_NE,
    T_LE,
    T_GE,
    T_SHL,
    T_SHR,
    T_IDIV,  /* // */
    T_LABEL, /* :: */
    T_AND,   /* the reserved words, in byte order */
    T_BREAK,
    T_DO,
    T_ELSE,
    T_ELSEIF,
    T_ENDS, /* the word end */
    T_FALSE,
    T_FOR,
    T_FUNCTION,
    T_GOTO,
    T_IF,
    T_IN,
    T_LOCAL,
    T_NIL,
    T_NOT,
    T_OR,
    T_REPEAT,
    T_RETURN,
    T_THEN,
    T_TRUE,
    T_UNTIL,
    T_WHILE,
};

struct token {
    int type;
    int line;      /* where it starts */
    const char *s; /* a name: inside the text, n bytes; a string: its value, in the arena */
    size_t n;      /* of a string too, for it may hold zeros */
    bool zero;     /* a number: is it 0? */
};

struct lex {
    struct token now, next; /* next: only good after lex_peek */
    bool peeked;
    /* the rest is lex.c's */
    struct cursor at;
    struct arena *arena;
    char *value; /* of the string being read; malloc */
    size_t n;
};

/* Starts; the first token is in ->now. The text must outlive it. */
void lex_open(struct lex *l, const char *text, size_t n, struct arena *arena);
void lex_close(struct lex *l);

/* Goes on by a token. */
void lex_step(struct lex *l);

/* The type of the token after ->now. */
int lex_peek(struct lex *l);

#endif
