/*
 * lex.c - see lex.h. The rules are those of the reference manual of Lua 5.4, section 3.1.
 */
#include "lex.h"

#include <stdlib.h>
#include <string.h>
#include "../../common/array.h"

/* ---- the arena ---- */

enum { ARENA_BLOCK = 1 << 16 };

struct arena_block {
    struct arena_block *previous;
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
        struct arena_block *before = a->last->previous;
        free(a->last);
        a->last = before;
    }
    a->left = 0;
}

/* ---- strings ---- */

static void add_byte(struct lex *l, unsigned c)
{
    if (array_append(&l->value, l->n, 1))
        l->value[l->n++] = (char)c;
    else
        l->arena->failed = true;
}

/* Reads a long string or comment; false: it has no end. Line breaks become \n; one at the start is skipped. */
static bool read_long_string(struct lex *l, int level)
{
    l->at.p += level + 2;
    l->n = 0;
    if (cursor_peek(&l->at, 0) == '\n' || cursor_peek(&l->at, 0) == '\r')
        cursor_step(&l->at);
    while (l->at.p < l->at.end && !cursor_is_at_long_close(&l->at, level)) {
        add_byte(l, *l->at.p == '\r' ? '\n' : (unsigned char)*l->at.p);
        cursor_step(&l->at);
    }
    if (l->at.p == l->at.end)
        return false;
    l->at.p += level + 2;
    return true;
}

/* Appends a code point as UTF-8, in up to six bytes. */
static void add_utf8(struct lex *l, uint32_t c)
{
    int more = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : c < 0x200000 ? 3 : c < 0x4000000 ? 4 : 5;
    static const unsigned first[] = { 0, 0xc0, 0xe0, 0xf0, 0xf8, 0xfc };

    add_byte(l, first[more] | c >> (6 * more));
    while (more-- > 0)
        add_byte(l, 0x80 | (c >> (6 * more) & 0x3f));
}

/* Reads \u{XXX} after the backslash. */
static bool escape_unicode(struct lex *l)
{
    uint32_t v = 0;

    l->at.p++;
    if (cursor_peek(&l->at, 0) != '{' || cursor_hex_value(cursor_peek(&l->at, 1)) < 0)
        return false;
    for (l->at.p++; cursor_hex_value(cursor_peek(&l->at, 0)) >= 0; l->at.p++)
        v = v >> 27 ? v : v * 16 + (uint32_t)cursor_hex_value(*l->at.p);
    add_utf8(l, v);
    return cursor_peek(&l->at, 0) == '}' ? l->at.p++, true : false;
}

static bool escape_decimal(struct lex *l)
{
    unsigned v = 0;

    for (int i = 0; i < 3 && cursor_is_digit(cursor_peek(&l->at, 0)); i++)
        v = v * 10 + (unsigned)(*l->at.p++ - '0');
    add_byte(l, v);
    return v < 256;
}

static bool escape_hex(struct lex *l)
{
    int high = cursor_hex_value(cursor_peek(&l->at, 1)), low = cursor_hex_value(cursor_peek(&l->at, 2));

    if (high < 0 || low < 0)
        return false;
    l->at.p += 3;
    add_byte(l, (unsigned)(high * 16 + low));
    return true;
}

static bool escape_letter(struct lex *l)
{
    static const char letters[] = "abfnrtv\\\"'", means[] = "\a\b\f\n\r\t\v\\\"'";
    const char *at = *l->at.p != '\0' ? strchr(letters, *l->at.p) : NULL;

    if (at == NULL)
        return false;
    add_byte(l, (unsigned char)means[at - letters]);
    l->at.p++;
    return true;
}

/* Reads an escape sequence after its backslash. */
static bool escape(struct lex *l)
{
    char c = cursor_peek(&l->at, 0);

    if (l->at.p == l->at.end)
        return false;
    if (cursor_is_digit(c))
        return escape_decimal(l);
    if (c == 'x')
        return escape_hex(l);
    if (c == 'u')
        return escape_unicode(l);
    if (c == '\n' || c == '\r') {
        add_byte(l, '\n');
        cursor_step(&l->at);
        return true;
    }
    if (c != 'z')
        return escape_letter(l);
    for (l->at.p++; l->at.p < l->at.end && cursor_is_blank(*l->at.p);)
        cursor_step(&l->at);
    return true;
}

static bool read_quoted(struct lex *l)
{
    char quote = *l->at.p++;

    l->n = 0;
    while (l->at.p < l->at.end && *l->at.p != quote) {
        if (*l->at.p == '\n' || *l->at.p == '\r')
            return false;
        if (*l->at.p != '\\')
            add_byte(l, (unsigned char)*l->at.p++);
        else if (l->at.p++, !escape(l))
            return false;
    }
    return l->at.p < l->at.end ? l->at.p++, true : false;
}

static int finish_string(struct lex *l, struct token *t, bool good)
{
    t->s = good ? arena_copy(l->arena, l->n > 0 ? l->value : "", l->n) : "";
    t->n = good ? l->n : 0;
    return good ? T_STRING : T_BAD;
}

/* ---- other tokens ---- */

/* Returns whether a number is 0, with any exponent. */
static bool is_zero(const char *s, size_t n)
{
    bool is_hex = n > 1 && (s[1] == 'x' || s[1] == 'X');

    for (size_t i = is_hex ? 2 : 0; i < n && (is_hex ? s[i] != 'p' && s[i] != 'P' : s[i] != 'e' && s[i] != 'E'); i++)
        if (s[i] != '0' && s[i] != '.')
            return false;
    return true;
}

static int read_number(struct lex *l, struct token *t)
{
    const char *from = l->at.p;
    bool is_hex = *from == '0' && (cursor_peek(&l->at, 1) == 'x' || cursor_peek(&l->at, 1) == 'X');

    if (is_hex)
        l->at.p += 2;
    for (;; l->at.p++) {
        char c = cursor_peek(&l->at, 0);
        bool exponent = is_hex ? c == 'p' || c == 'P' : c == 'e' || c == 'E';
        if (exponent && (cursor_peek(&l->at, 1) == '+' || cursor_peek(&l->at, 1) == '-'))
            l->at.p++;
        else if (!exponent && cursor_hex_value(c) < 0 && c != '.')
            break;
    }
    t->zero = is_zero(from, (size_t)(l->at.p - from));
    return cursor_is_letter(cursor_peek(&l->at, 0)) ? T_BAD : T_NUMBER;
}

static int read_name(struct lex *l, struct token *t)
{
    static const char *const reserved[] = { "and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                            "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                            "repeat",   "return", "then", "true", "until",  "while" };

    t->s = l->at.p;
    while (cursor_is_letter(cursor_peek(&l->at, 0)) || cursor_is_digit(cursor_peek(&l->at, 0)))
        l->at.p++;
    t->n = (size_t)(l->at.p - t->s);
    for (size_t i = 0; i < sizeof reserved / sizeof reserved[0]; i++)
        if (strlen(reserved[i]) == t->n && memcmp(reserved[i], t->s, t->n) == 0)
            return T_AND + (int)i;
    return T_NAME;
}

static int read_operator(struct lex *l)
{
    static const struct {
        char s[4];
        int type;
    } signs[] = { { "...", T_DOTS }, { "..", T_CONCAT }, { "==", T_EQ },  { "~=", T_NE },   { "<=", T_LE },
                  { ">=", T_GE },    { "<<", T_SHL },    { ">>", T_SHR }, { "//", T_IDIV }, { "::", T_LABEL } };

    for (size_t i = 0; i < sizeof signs / sizeof signs[0]; i++) {
        size_t n = strlen(signs[i].s);
        if (n <= (size_t)(l->at.end - l->at.p) && memcmp(l->at.p, signs[i].s, n) == 0) {
            l->at.p += n;
            return signs[i].type;
        }
    }
    char c = *l->at.p++;
    return c != '\0' && strchr("+-*/%^#&~|<>=(){}[];:,.", c) != NULL ? c : T_BAD;
}

/* Skips whitespace and comments; false: a comment has no end. */
static bool skip_space(struct lex *l)
{
    while (l->at.p < l->at.end) {
        if (cursor_is_blank(*l->at.p)) {
            cursor_step(&l->at);
        } else if (*l->at.p == '-' && cursor_peek(&l->at, 1) == '-') {
            l->at.p += 2;
            int level = cursor_peek(&l->at, 0) == '[' ? cursor_long_level(&l->at) : -1;
            if (level >= 0 && !read_long_string(l, level))
                return false;
            while (level < 0 && l->at.p < l->at.end && *l->at.p != '\n' && *l->at.p != '\r')
                l->at.p++;
        } else {
            break;
        }
    }
    return true;
}

static void read_token(struct lex *l, struct token *t)
{
    bool good = skip_space(l);
    char c = cursor_peek(&l->at, 0);

    *t = (struct token){ .line = l->at.line };
    if (!good)
        t->type = T_BAD;
    else if (l->at.p == l->at.end)
        t->type = T_END;
    else if (cursor_is_letter(c))
        t->type = read_name(l, t);
    else if (cursor_is_digit(c) || (c == '.' && cursor_is_digit(cursor_peek(&l->at, 1))))
        t->type = read_number(l, t);
    else if (c == '"' || c == '\'')
        t->type = finish_string(l, t, read_quoted(l));
    else if (c == '[' && cursor_long_level(&l->at) >= 0)
        t->type = finish_string(l, t, read_long_string(l, cursor_long_level(&l->at)));
    else
        t->type = read_operator(l);
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
    *l = (struct lex){ .at = { text, text + n, 1 }, .arena = arena };
    lex_step(l);
}

void lex_close(struct lex *l)
{
    free(l->value);
    l->value = NULL;
}
