/*
 * lex.c - see lex.h. The rules are those of the reference manual of Lua 5.4, section 3.1.
 */
#include "lex.h"

#include <stdlib.h>
#include <string.h>

/* ---- the arena ---- */

enum { ARENA_BLOCK = 1 << 16 };

struct arena_block {
    struct arena_block *before;
    size_t used;
    char bytes[];
};

static bool arena_grow(struct arena *a, size_t least)
{
    size_t room = least > ARENA_BLOCK ? least : ARENA_BLOCK;
    struct arena_block *b = malloc(sizeof *b + room);

    a->failed = a->failed || b == NULL;
    if (b == NULL)
        return false;
    *b = (struct arena_block){ a->last, 0 };
    a->last = b;
    a->left = room;
    return true;
}

const char *arena_copy(struct arena *a, const char *s, size_t n)
{
    if (n >= a->left && !arena_grow(a, n + 1))
        return "";
    char *to = a->last->bytes + a->last->used;
    if (n > 0)
        memcpy(to, s, n);
    to[n] = '\0';
    a->last->used += n + 1;
    a->left -= n + 1;
    return to;
}

void arena_close(struct arena *a)
{
    while (a->last != NULL) {
        struct arena_block *before = a->last->before;
        free(a->last);
        a->last = before;
    }
    a->left = 0;
}

/* ---- characters ---- */

static bool digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static int hex(char c)
{
    if (digit(c))
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

static bool blank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* The character k after this one; 0 past the end. */
static char peek(const struct lex *l, size_t k)
{
    return k < (size_t)(l->end - l->p) ? l->p[k] : '\0';
}

/* Goes on by one character; \r\n and \n\r are one line's end. */
static void step(struct lex *l)
{
    char c = *l->p++;

    if (c != '\n' && c != '\r')
        return;
    l->line++;
    if ((peek(l, 0) == '\n' || peek(l, 0) == '\r') && peek(l, 0) != c)
        l->p++;
}

/* ---- strings ---- */

static void keep(struct lex *l, unsigned c)
{
    if (l->n == l->room) {
        size_t room = l->room == 0 ? 256 : l->room * 2;
        char *more = realloc(l->value, room);
        l->arena->failed = l->arena->failed || more == NULL;
        if (more == NULL)
            return;
        l->value = more;
        l->room = room;
    }
    l->value[l->n++] = (char)c;
}

/* The = signs of a long bracket that opens here, or -1. */
static int long_level(const struct lex *l)
{
    size_t n = 1;

    while (peek(l, n) == '=')
        n++;
    return peek(l, n) == '[' ? (int)n - 1 : -1;
}

static bool closes(const struct lex *l, int level)
{
    for (int i = 1; i <= level; i++)
        if (peek(l, (size_t)i) != '=')
            return false;
    return peek(l, 0) == ']' && peek(l, (size_t)level + 1) == ']';
}

/* A long bracket to its end; false: it has none. A line's end in it is \n, and none right at its start. */
static bool long_string(struct lex *l, int level)
{
    l->p += level + 2;
    l->n = 0;
    if (peek(l, 0) == '\n' || peek(l, 0) == '\r')
        step(l);
    while (l->p < l->end && !closes(l, level)) {
        keep(l, *l->p == '\r' ? '\n' : (unsigned char)*l->p);
        step(l);
    }
    if (l->p == l->end)
        return false;
    l->p += level + 2;
    return true;
}

/* A code point as UTF-8, in up to six bytes. */
static void keep_utf8(struct lex *l, uint32_t c)
{
    int more = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : c < 0x200000 ? 3 : c < 0x4000000 ? 4 : 5;
    static const unsigned first[] = { 0, 0xc0, 0xe0, 0xf0, 0xf8, 0xfc };

    keep(l, first[more] | c >> (6 * more));
    while (more-- > 0)
        keep(l, 0x80 | (c >> (6 * more) & 0x3f));
}

/* \u{XXX} */
static bool escape_unicode(struct lex *l)
{
    uint32_t v = 0;

    l->p++;
    if (peek(l, 0) != '{' || hex(peek(l, 1)) < 0)
        return false;
    for (l->p++; hex(peek(l, 0)) >= 0; l->p++)
        v = v >> 27 ? v : v * 16 + (uint32_t)hex(*l->p);
    keep_utf8(l, v);
    return peek(l, 0) == '}' ? l->p++, true : false;
}

static bool escape_decimal(struct lex *l)
{
    unsigned v = 0;

    for (int i = 0; i < 3 && digit(peek(l, 0)); i++)
        v = v * 10 + (unsigned)(*l->p++ - '0');
    keep(l, v);
    return v < 256;
}

static bool escape_hex(struct lex *l)
{
    int high = hex(peek(l, 1)), low = hex(peek(l, 2));

    if (high < 0 || low < 0)
        return false;
    l->p += 3;
    keep(l, (unsigned)(high * 16 + low));
    return true;
}

static bool escape_letter(struct lex *l)
{
    static const char letters[] = "abfnrtv\\\"'", means[] = "\a\b\f\n\r\t\v\\\"'";
    const char *at = *l->p != '\0' ? strchr(letters, *l->p) : NULL;

    if (at == NULL)
        return false;
    keep(l, (unsigned char)means[at - letters]);
    l->p++;
    return true;
}

/* What follows a backslash. */
static bool escape(struct lex *l)
{
    char c = peek(l, 0);

    if (l->p == l->end)
        return false;
    if (digit(c))
        return escape_decimal(l);
    if (c == 'x')
        return escape_hex(l);
    if (c == 'u')
        return escape_unicode(l);
    if (c == '\n' || c == '\r') {
        keep(l, '\n');
        step(l);
        return true;
    }
    if (c != 'z')
        return escape_letter(l);
    for (l->p++; l->p < l->end && blank(*l->p);)
        step(l);
    return true;
}

static bool quoted(struct lex *l)
{
    char quote = *l->p++;

    l->n = 0;
    while (l->p < l->end && *l->p != quote) {
        if (*l->p == '\n' || *l->p == '\r')
            return false;
        if (*l->p != '\\')
            keep(l, (unsigned char)*l->p++);
        else if (l->p++, !escape(l))
            return false;
    }
    return l->p < l->end ? l->p++, true : false;
}

static int string(struct lex *l, struct token *t, bool good)
{
    t->s = good ? arena_copy(l->arena, l->n > 0 ? l->value : "", l->n) : "";
    t->n = good ? l->n : 0;
    return good ? T_STRING : T_BAD;
}

/* ---- the others ---- */

/* 0 whatever its exponent says. */
static bool is_zero(const char *s, size_t n)
{
    bool is_hex = n > 1 && (s[1] == 'x' || s[1] == 'X');

    for (size_t i = is_hex ? 2 : 0; i < n && (is_hex ? s[i] != 'p' && s[i] != 'P' : s[i] != 'e' && s[i] != 'E'); i++)
        if (s[i] != '0' && s[i] != '.')
            return false;
    return true;
}

static int number(struct lex *l, struct token *t)
{
    const char *from = l->p;
    bool is_hex = *from == '0' && (peek(l, 1) == 'x' || peek(l, 1) == 'X');

    if (is_hex)
        l->p += 2;
    for (;; l->p++) {
        char c = peek(l, 0);
        bool exponent = is_hex ? c == 'p' || c == 'P' : c == 'e' || c == 'E';
        if (exponent && (peek(l, 1) == '+' || peek(l, 1) == '-'))
            l->p++;
        else if (!exponent && hex(c) < 0 && c != '.')
            break;
    }
    t->zero = is_zero(from, (size_t)(l->p - from));
    return letter(peek(l, 0)) ? T_BAD : T_NUMBER;
}

static int name(struct lex *l, struct token *t)
{
    static const char *const reserved[] = { "and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                            "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                            "repeat",   "return", "then", "true", "until",  "while" };

    t->s = l->p;
    while (letter(peek(l, 0)) || digit(peek(l, 0)))
        l->p++;
    t->n = (size_t)(l->p - t->s);
    for (size_t i = 0; i < sizeof reserved / sizeof reserved[0]; i++)
        if (strlen(reserved[i]) == t->n && memcmp(reserved[i], t->s, t->n) == 0)
            return T_AND + (int)i;
    return T_NAME;
}

static int sign(struct lex *l)
{
    static const struct {
        char s[4];
        int type;
    } signs[] = { { "...", T_DOTS }, { "..", T_CONCAT }, { "==", T_EQ },  { "~=", T_NE },   { "<=", T_LE },
                  { ">=", T_GE },    { "<<", T_SHL },    { ">>", T_SHR }, { "//", T_IDIV }, { "::", T_LABEL } };

    for (size_t i = 0; i < sizeof signs / sizeof signs[0]; i++) {
        size_t n = strlen(signs[i].s);
        if (n <= (size_t)(l->end - l->p) && memcmp(l->p, signs[i].s, n) == 0) {
            l->p += n;
            return signs[i].type;
        }
    }
    char c = *l->p++;
    return c != '\0' && strchr("+-*/%^#&~|<>=(){}[];:,.", c) != NULL ? c : T_BAD;
}

/* Past blanks and comments; false: a comment has no end. */
static bool skip(struct lex *l)
{
    while (l->p < l->end) {
        if (blank(*l->p)) {
            step(l);
        } else if (*l->p == '-' && peek(l, 1) == '-') {
            l->p += 2;
            int level = peek(l, 0) == '[' ? long_level(l) : -1;
            if (level >= 0 && !long_string(l, level))
                return false;
            while (level < 0 && l->p < l->end && *l->p != '\n' && *l->p != '\r')
                l->p++;
        } else {
            break;
        }
    }
    return true;
}

static void read_token(struct lex *l, struct token *t)
{
    bool good = skip(l);
    char c = peek(l, 0);

    *t = (struct token){ .line = l->line };
    if (!good)
        t->type = T_BAD;
    else if (l->p == l->end)
        t->type = T_END;
    else if (letter(c))
        t->type = name(l, t);
    else if (digit(c) || (c == '.' && digit(peek(l, 1))))
        t->type = number(l, t);
    else if (c == '"' || c == '\'')
        t->type = string(l, t, quoted(l));
    else if (c == '[' && long_level(l) >= 0)
        t->type = string(l, t, long_string(l, long_level(l)));
    else
        t->type = sign(l);
}

void lex_step(struct lex *l)
{
    if (l->now.type == T_BAD)
        return;
    if (l->peeked)
        l->now = l->next;
    else
        read_token(l, &l->now);
    l->peeked = false;
}

int lex_peek(struct lex *l)
{
    if (l->now.type == T_BAD)
        return T_BAD;
    if (!l->peeked)
        read_token(l, &l->next);
    l->peeked = true;
    return l->next.type;
}

void lex_open(struct lex *l, const char *text, size_t n, struct arena *arena)
{
    *l = (struct lex){ .p = text, .end = text + n, .line = 1, .arena = arena };
    lex_step(l);
}

void lex_close(struct lex *l)
{
    free(l->value);
    l->value = NULL;
}
