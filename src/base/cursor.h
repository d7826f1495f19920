/*
 * cursor.h - a position in Lua source text, and the code its scanners share: character classes, line ends, long
 * brackets. The rules are those of the Lua 5.4 reference manual, section 3.1, in the C locale.
 */
#ifndef BASE_CURSOR_H
#define BASE_CURSOR_H

#include <stdbool.h>
#include <stddef.h>

struct cursor {
    const char *p, *end;
    int line; /* counted from 1 */
};

static inline bool cursor_is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static inline bool cursor_is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static inline bool cursor_is_blank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* Returns the value of a hexadecimal digit, or -1. */
static inline int cursor_hex_value(char c)
{
    if (cursor_is_digit(c))
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* Returns the character k places ahead, or 0 past the end. */
static inline char cursor_peek(const struct cursor *c, size_t k)
{
    return k < (size_t)(c->end - c->p) ? c->p[k] : '\0';
}

/* Advances by one character; requires p < end. \r\n and \n\r each count as one line end. */
static inline void cursor_step(struct cursor *c)
{
    char consumed = *c->p++;

    if (consumed != '\n' && consumed != '\r')
        return;
    c->line++;
    if ((cursor_peek(c, 0) == '\n' || cursor_peek(c, 0) == '\r') && cursor_peek(c, 0) != consumed)
        c->p++;
}

/* Returns the level (the number of = signs) of the long bracket that opens at the cursor, or -1 if none opens there.
 * The character at the cursor must be '['. */
static inline int cursor_long_level(const struct cursor *c)
{
    size_t n = 1;

    while (cursor_peek(c, n) == '=')
        n++;
    return cursor_peek(c, n) == '[' ? (int)n - 1 : -1;
}

/* Returns whether a long bracket of level `level` closes at the cursor. */
static inline bool cursor_is_at_long_close(const struct cursor *c, int level)
{
    for (int i = 1; i <= level; i++)
        if (cursor_peek(c, (size_t)i) != '=')
            return false;
    return cursor_peek(c, 0) == ']' && cursor_peek(c, (size_t)level + 1) == ']';
}

#endif
