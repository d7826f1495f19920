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
#include "../cursor.h"
#include "../../base/heap.h"
#include "../../base/host.h"

static const char no_power[] =
    "the operator ^ is not available (results differ between machines); use x*x or math.sqrt";
static const char no_gc[] = "the name __gc is not available (when it would run differs between machines)";
static const char no_mode[] = "the name __mode is not available (what it keeps differs between machines)";

struct scan {
    struct cursor at;
    char word[8]; /* the first bytes of the last name or string */
    size_t size;  /* all its bytes */
};

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

/* A long bracket to its end. Its first line end is not part of the string. */
static void long_string(struct scan *s, int level)
{
    s->at.p += level + 2;
    s->size = 0;
    if (cursor_peek(&s->at, 0) == '\n' || cursor_peek(&s->at, 0) == '\r')
        cursor_step(&s->at);
    while (s->at.p < s->at.end && !cursor_closes(&s->at, level)) {
        keep(s, (unsigned char)*s->at.p);
        cursor_step(&s->at);
    }
    if (s->at.p < s->at.end)
        s->at.p += level + 2;
}

static void comment(struct scan *s)
{
    s->at.p += 2;
    int level = cursor_peek(&s->at, 0) == '[' ? cursor_long_level(&s->at) : -1;

    if (level >= 0) {
        long_string(s, level);
        return;
    }
    while (s->at.p < s->at.end && *s->at.p != '\n' && *s->at.p != '\r')
        s->at.p++;
}

/* \u{XXX}: the names are ASCII, so what is above counts as one odd byte. */
static void escape_unicode(struct scan *s)
{
    unsigned v = 0;

    s->at.p++;
    if (cursor_peek(&s->at, 0) == '{')
        s->at.p++;
    for (; cursor_hex(cursor_peek(&s->at, 0)) >= 0; s->at.p++)
        v = v > 255 ? v : v * 16 + (unsigned)cursor_hex(*s->at.p);
    if (cursor_peek(&s->at, 0) == '}')
        s->at.p++;
    keep(s, v > 127 ? 255 : v);
}

static void escape_decimal(struct scan *s)
{
    unsigned v = 0;

    for (int i = 0; i < 3 && cursor_digit(cursor_peek(&s->at, 0)); i++)
        v = v * 10 + (unsigned)(*s->at.p++ - '0');
    keep(s, v);
}

static void escape_hex(struct scan *s)
{
    unsigned v = 0;

    s->at.p++;
    for (int i = 0; i < 2 && cursor_hex(cursor_peek(&s->at, 0)) >= 0; i++)
        v = v * 16 + (unsigned)cursor_hex(*s->at.p++);
    keep(s, v);
}

/* What follows a backslash inside quotes. */
static void escape(struct scan *s)
{
    char c = cursor_peek(&s->at, 0);

    if (cursor_digit(c)) {
        escape_decimal(s);
    } else if (c == 'x') {
        escape_hex(s);
    } else if (c == 'u') {
        escape_unicode(s);
    } else if (c == 'z') {
        for (s->at.p++; s->at.p < s->at.end && strchr(" \t\n\v\f\r", *s->at.p) != NULL && *s->at.p != '\0';)
            cursor_step(&s->at);
    } else if (s->at.p < s->at.end) {
        keep(s, '\n'); /* a letter or a line's end: some character that is in neither name */
        cursor_step(&s->at);
    }
}

static void quoted(struct scan *s)
{
    char quote = *s->at.p++;

    s->size = 0;
    while (s->at.p < s->at.end && *s->at.p != quote && *s->at.p != '\n' && *s->at.p != '\r') {
        if (*s->at.p == '\\') {
            s->at.p++;
            escape(s);
        } else {
            keep(s, (unsigned char)*s->at.p++);
        }
    }
    if (s->at.p < s->at.end && *s->at.p == quote)
        s->at.p++;
}

static void name(struct scan *s)
{
    s->size = 0;
    while (cursor_letter(cursor_peek(&s->at, 0)) || cursor_digit(cursor_peek(&s->at, 0)))
        keep(s, (unsigned char)*s->at.p++);
}

/* One token; returns what is wrong with it. */
static const char *token(struct scan *s)
{
    char c = *s->at.p;

    if (c == '-' && cursor_peek(&s->at, 1) == '-') {
        comment(s);
        return NULL;
    }
    if (c == '^') {
        s->at.p++;
        return no_power;
    }
    if (cursor_letter(c))
        name(s);
    else if (c == '"' || c == '\'')
        quoted(s);
    else if (c == '[' && cursor_long_level(&s->at) >= 0)
        long_string(s, cursor_long_level(&s->at));
    else {
        cursor_step(&s->at);
        return NULL;
    }
    return refused(s);
}

bool script_scan_on(const char *text, size_t n, struct script_place *place, int *line, const char **what)
{
    struct scan s = { .at = { text + place->at, text + n, place->line } };

    while (s.at.p < s.at.end) {
        *line = s.at.line;
        *what = token(&s);
        if (*what == NULL)
            continue;
        *place = (struct script_place){ (size_t)(s.at.p - text), s.at.line };
        return false;
    }
    return true;
}

bool script_scan(const char *text, size_t n, int *line, const char **what)
{
    struct script_place start = { 0, 1 };

    return script_scan_on(text, n, &start, line, what);
}

/* A numeral, which may end in a point: "3. x" has no field x. */
static void numeral(struct cursor *at)
{
    bool hex = *at->p == '0' && (cursor_peek(at, 1) == 'x' || cursor_peek(at, 1) == 'X');
    const char *exponent = hex ? "pP" : "eE";

    for (at->p += hex ? 2 : 0; at->p < at->end && *at->p != '\0'; at->p++) {
        if (strchr(exponent, *at->p) != NULL)
            at->p += cursor_peek(at, 1) == '+' || cursor_peek(at, 1) == '-';
        else if (cursor_hex(*at->p) < 0 && *at->p != '.')
            return;
    }
}

static bool skips_space(struct scan *s)
{
    if (cursor_blank(*s->at.p))
        cursor_step(&s->at);
    else if (*s->at.p == '-' && cursor_peek(&s->at, 1) == '-')
        comment(s);
    else
        return false;
    return true;
}

/* Does a single = follow? */
static bool is_assigned(struct scan s)
{
    while (s.at.p < s.at.end && skips_space(&s))
        continue;
    return cursor_peek(&s.at, 0) == '=' && cursor_peek(&s.at, 1) != '=';
}

bool script_next_read(const char *text, size_t n, size_t *at, const char **first, size_t *size)
{
    struct scan s = { .at = { text + *at, text + n, 1 } };
    int points = 0; /* . or : in a row right before; a single one is before a field */

    while (s.at.p < s.at.end) {
        char c = *s.at.p;
        if (skips_space(&s))
            continue;
        if (cursor_letter(c)) {
            *first = s.at.p;
            name(&s);
            *at = (size_t)(s.at.p - text);
            *size = s.size;
            if (points != 1 && !is_assigned(s))
                return true;
            points = 0;
        } else if (cursor_digit(c) || (c == '.' && cursor_digit(cursor_peek(&s.at, 1)))) {
            numeral(&s.at);
            points = 0;
        } else if (c == '.' || c == ':') {
            for (points = 0; cursor_peek(&s.at, 0) == c; points++)
                s.at.p++;
        } else {
            token(&s);
            points = 0;
        }
    }
    return false;
}

const char *script_field(const char *text, size_t n, size_t at, size_t *size)
{
    struct scan s = { .at = { text + at, text + n, 1 } };

    while (s.at.p < s.at.end && skips_space(&s))
        continue;
    if (cursor_peek(&s.at, 0) != '.' || cursor_peek(&s.at, 1) == '.')
        return NULL;
    s.at.p++;
    while (s.at.p < s.at.end && skips_space(&s))
        continue;
    if (!cursor_letter(cursor_peek(&s.at, 0)))
        return NULL;
    const char *first = s.at.p;
    name(&s);
    *size = s.size;
    return first;
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
