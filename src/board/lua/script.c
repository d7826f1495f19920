/*
 * script.c - see script.h. A scanner of Lua's tokens as far as they matter: comments, strings with their escapes,
 * names. A string's value is decoded, so that "\95_gc" does not slip through; no more of it is kept than tells the
 * names apart.
 */
#include "../script.h"

#include <lauxlib.h>
#include <lua.h>
#include <stdio.h>
#include <string.h>
#include "../../base/heap.h"
#include "../../base/host.h"

static const char no_power[] =
    "the operator ^ is not available (results differ between machines); use x*x or math.sqrt";
static const char no_gc[] = "the name __gc is not available (when it would run differs between machines)";
static const char no_mode[] = "the name __mode is not available (what it keeps differs between machines)";

struct scan {
    const char *p, *end;
    int line;
    char word[8]; /* the first bytes of the last name or string */
    size_t size;  /* all its bytes */
};

static bool letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static bool digit(char c)
{
    return c >= '0' && c <= '9';
}

static int hex(char c)
{
    if (digit(c))
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* The character k after this one; 0 past the end. */
static char peek(const struct scan *s, size_t k)
{
    return k < (size_t)(s->end - s->p) ? s->p[k] : '\0';
}

/* Goes on by one character; \r\n and \n\r are one line's end. */
static void step(struct scan *s)
{
    char c = *s->p++;

    if (c != '\n' && c != '\r')
        return;
    s->line++;
    if ((peek(s, 0) == '\n' || peek(s, 0) == '\r') && peek(s, 0) != c)
        s->p++;
}

static void keep(struct scan *s, unsigned c)
{
    if (s->size < sizeof s->word)
        s->word[s->size] = (char)c;
    s->size++;
}

static const char *refused(const struct scan *s)
{
    if (s->size == 4 && memcmp(s->word, "__gc", 4) == 0)
        return no_gc;
    return s->size == 6 && memcmp(s->word, "__mode", 6) == 0 ? no_mode : NULL;
}

/* The = signs of a long bracket that opens here, or -1. */
static int long_level(const struct scan *s)
{
    size_t n = 1;

    while (peek(s, n) == '=')
        n++;
    return peek(s, n) == '[' ? (int)n - 1 : -1;
}

static bool closes(const struct scan *s, int level)
{
    for (int i = 1; i <= level; i++)
        if (peek(s, (size_t)i) != '=')
            return false;
    return peek(s, 0) == ']' && peek(s, (size_t)level + 1) == ']';
}

/* A long bracket to its end. Its first line end is not part of the string. */
static void long_string(struct scan *s, int level)
{
    s->p += level + 2;
    s->size = 0;
    if (peek(s, 0) == '\n' || peek(s, 0) == '\r')
        step(s);
    while (s->p < s->end && !closes(s, level)) {
        keep(s, (unsigned char)*s->p);
        step(s);
    }
    if (s->p < s->end)
        s->p += level + 2;
}

static void comment(struct scan *s)
{
    s->p += 2;
    int level = peek(s, 0) == '[' ? long_level(s) : -1;

    if (level >= 0) {
        long_string(s, level);
        return;
    }
    while (s->p < s->end && *s->p != '\n' && *s->p != '\r')
        s->p++;
}

/* \u{XXX}: the names are ASCII, so what is above counts as one odd byte. */
static void escape_unicode(struct scan *s)
{
    unsigned v = 0;

    s->p++;
    if (peek(s, 0) == '{')
        s->p++;
    for (; hex(peek(s, 0)) >= 0; s->p++)
        v = v > 255 ? v : v * 16 + (unsigned)hex(*s->p);
    if (peek(s, 0) == '}')
        s->p++;
    keep(s, v > 127 ? 255 : v);
}

static void escape_decimal(struct scan *s)
{
    unsigned v = 0;

    for (int i = 0; i < 3 && digit(peek(s, 0)); i++)
        v = v * 10 + (unsigned)(*s->p++ - '0');
    keep(s, v);
}

static void escape_hex(struct scan *s)
{
    unsigned v = 0;

    s->p++;
    for (int i = 0; i < 2 && hex(peek(s, 0)) >= 0; i++)
        v = v * 16 + (unsigned)hex(*s->p++);
    keep(s, v);
}

/* What follows a backslash inside quotes. */
static void escape(struct scan *s)
{
    char c = peek(s, 0);

    if (digit(c)) {
        escape_decimal(s);
    } else if (c == 'x') {
        escape_hex(s);
    } else if (c == 'u') {
        escape_unicode(s);
    } else if (c == 'z') {
        for (s->p++; s->p < s->end && strchr(" \t\n\v\f\r", *s->p) != NULL && *s->p != '\0';)
            step(s);
    } else if (s->p < s->end) {
        keep(s, '\n'); /* a letter or a line's end: some character that is in neither name */
        step(s);
    }
}

static void quoted(struct scan *s)
{
    char quote = *s->p++;

    s->size = 0;
    while (s->p < s->end && *s->p != quote && *s->p != '\n' && *s->p != '\r') {
        if (*s->p == '\\') {
            s->p++;
            escape(s);
        } else {
            keep(s, (unsigned char)*s->p++);
        }
    }
    if (s->p < s->end && *s->p == quote)
        s->p++;
}

static void name(struct scan *s)
{
    s->size = 0;
    while (letter(peek(s, 0)) || digit(peek(s, 0)))
        keep(s, (unsigned char)*s->p++);
}

/* One token; returns what is wrong with it. */
static const char *token(struct scan *s)
{
    char c = *s->p;

    if (c == '-' && peek(s, 1) == '-') {
        comment(s);
        return NULL;
    }
    if (c == '^') {
        s->p++;
        return no_power;
    }
    if (letter(c))
        name(s);
    else if (c == '"' || c == '\'')
        quoted(s);
    else if (c == '[' && long_level(s) >= 0)
        long_string(s, long_level(s));
    else {
        step(s);
        return NULL;
    }
    return refused(s);
}

bool script_scan_on(const char *text, size_t n, struct script_place *place, int *line, const char **what)
{
    struct scan s = { text + place->at, text + n, place->line, { 0 }, 0 };

    while (s.p < s.end) {
        *line = s.line;
        *what = token(&s);
        if (*what == NULL)
            continue;
        *place = (struct script_place){ (size_t)(s.p - text), s.line };
        return false;
    }
    return true;
}

bool script_scan(const char *text, size_t n, int *line, const char **what)
{
    struct script_place start = { 0, 1 };

    return script_scan_on(text, n, &start, line, what);
}

static void *allocate(void *heap, void *p, size_t old, size_t size)
{
    return heap_realloc(heap, p, p == NULL ? 0 : old, size);
}

static bool compile(const char *text, size_t n, const char *chunk, void *work, size_t work_size, char *err,
                    size_t err_size)
{
    lua_State *lua = lua_newstate(allocate, heap_init(work, work_size));
    bool good;

    if (lua == NULL) {
        snprintf(err, err_size, "%s: out of memory", chunk + 1);
        return false;
    }
    good = luaL_loadbufferx(lua, text, n, chunk, "t") == LUA_OK;
    if (!good)
        snprintf(err, err_size, "%s", lua_tostring(lua, -1));
    for (char *c = err; !good && *c != '\0'; c++) /* one line, whatever it quotes */
        if ((unsigned char)*c < 32 || *c == 127)
            *c = ' ';
    lua_close(lua);
    return good;
}

bool script_compile(const char *text, size_t n, const char *chunk, void *work, size_t work_size, char *err,
                    size_t err_size)
{
    struct host host;

    if (n > 0 && text[0] == LUA_SIGNATURE[0]) {
        snprintf(err, err_size, "%s:1: compiled Lua, expected text", chunk + 1);
        return false;
    }
    host_enter(&host);
    bool good = compile(text, n, chunk, work, work_size, err, err_size);
    host_leave(&host);
    return good;
}

bool script_check(const char *text, size_t n, const char *chunk, void *work, size_t work_size, char *err,
                  size_t err_size)
{
    const char *what;
    int line;

    if (script_scan(text, n, &line, &what))
        return script_compile(text, n, chunk, work, work_size, err, err_size);
    snprintf(err, err_size, "%s:%d: %s", chunk + 1, line, what);
    return false;
}
