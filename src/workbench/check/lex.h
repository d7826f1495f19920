/*
 * lex.h - a lexer for Lua 5.4.
 *
 * It reads any text, and never returns T_BAD for a text that the Lua compiler accepts.
 */
#ifndef WORKBENCH_LEX_H
#define WORKBENCH_LEX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../base/cursor.h"

/* Memory for strings, which are freed together. */
struct arena {
    struct arena_block *last;
    size_t left; /* free bytes of the last block */
    bool failed; /* out of memory: some strings are "" */
};

/* Returns a NUL-terminated copy of n bytes. */
const char *arena_copy(struct arena *a, const char *s, size_t n);
void arena_close(struct arena *a);

/* The type of a token of one character is the character. */
enum {
    T_END = 256, /* end of the text */
    T_BAD,       /* invalid; so are all tokens after it */
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
    size_t n;      /* bytes; a string may contain zeros */
    bool zero;     /* the number 0 */
};

struct lex {
    struct token now, next; /* next: set by lex_peek */
    bool peeked;
    /* private: */
    struct cursor at;
    struct arena *arena;
    char *value; /* of the string being read; malloc */
    size_t n;
};

/* Starts at the first token. The text must outlive it. */
void lex_open(struct lex *l, const char *text, size_t n, struct arena *arena);
void lex_close(struct lex *l);

/* Moves to the next token. */
void lex_step(struct lex *l);

/* Returns the type of the token after `now`. */
int lex_peek(struct lex *l);

#endif
