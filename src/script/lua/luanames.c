/*
 * luanames.c - strips the names of locals from a function of the standard library. The names take about a twelfth of
 * the library's heap memory, and appear only in messages about a fault of the library itself.
 *
 * Lua has no call for this, so the function is dumped and loaded again without the names. The dump format is that of
 * Lua 5.4 (ldump.c). If a dump cannot be parsed to exactly its last byte, the function stays unchanged.
 */
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include <lauxlib.h>
#include "lualib.h"

enum { HEADER = 4 + 1 + 1 + 6 + 3 + 8 + 8, DEEP = 32 }; /* bytes of a dump's header; nesting depth of functions */

/* A dump that is read and rewritten in place. */
struct dump {
    unsigned char *at, *end, *to; /* read position and end; write position */
    bool wrong;
};

/* Copies n bytes to the output. */
static void keep(struct dump *d, size_t n)
{
    if (n > (size_t)(d->end - d->at)) {
        d->wrong = true;
        d->at = d->end;
        return;
    }
    memmove(d->to, d->at, n);
    d->at += n;
    d->to += n;
}

/* Copies and returns a number, stored as 7 bits per byte, most significant first; bit 7 marks its last byte. */
static size_t number(struct dump *d)
{
    size_t n = 0;

    while (d->at < d->end && n < SIZE_MAX >> 7) {
        unsigned char c = *d->at;
        keep(d, 1);
        n = n << 7 | (c & 127u);
        if (c & 128)
            return n;
    }
    d->wrong = true;
    return 0;
}

static void text(struct dump *d)
{
    size_t n = number(d); /* length + 1; 0: no string */

    keep(d, n ? n - 1 : 0);
}

static void constant(struct dump *d)
{
    enum { INTEGER = 3, FLOAT = 19, SHORT = 4, LONG = 20 };
    int type = d->at < d->end ? *d->at : 0;

    keep(d, 1);
    if (type == INTEGER || type == FLOAT)
        keep(d, 8);
    else if (type == SHORT || type == LONG)
        text(d);
}

/* Replaces the list of locals by an empty one. */
static void locals(struct dump *d)
{
    unsigned char *list = d->to;
    size_t n = number(d);

    for (size_t i = 0; i < n && !d->wrong; i++) {
        text(d);
        number(d);
        number(d);
    }
    d->to = list;
    *d->to++ = 128; /* encodes the number 0: no locals */
}

static void function(struct dump *d, int deep)
{
    text(d);
    number(d);
    number(d);
    keep(d, 3);
    keep(d, 4 * number(d)); /* code */
    for (size_t i = number(d); i > 0 && !d->wrong; i--)
        constant(d);
    keep(d, 3 * number(d)); /* upvalues */
    d->wrong = d->wrong || deep == DEEP;
    for (size_t i = number(d); i > 0 && !d->wrong; i--)
        function(d, deep + 1);
    keep(d, number(d)); /* lines */
    for (size_t i = 2 * number(d); i > 0 && !d->wrong; i--)
        number(d);
    locals(d);
    for (size_t i = number(d); i > 0 && !d->wrong; i--)
        text(d); /* names of upvalues */
}

/* A buffer for a dump. lua_dump needs the function on top of the stack, so the buffer is only initialized when the
 * first bytes arrive. */
struct collected {
    luaL_Buffer b;
    bool begun;
};

static int collect(lua_State *L, const void *bytes, size_t n, void *to)
{
    struct collected *c = to;

    if (!c->begun)
        luaL_buffinit(L, &c->b);
    c->begun = true;
    luaL_addlstring(&c->b, bytes, n);
    return 0;
}

void lualib_drop_locals(lua_State *L, const char *chunk)
{
    const int f = lua_gettop(L);
    struct collected c = { .begun = false };

    luaL_checkstack(L, 8, NULL);
    lua_dump(L, collect, &c, 0);
    unsigned char *bytes = (unsigned char *)luaL_buffaddr(&c.b);
    struct dump d = { bytes, bytes + luaL_bufflen(&c.b), bytes, false };
    keep(&d, HEADER + 1);
    function(&d, 0);
    if (!d.wrong && d.at == d.end && luaL_loadbufferx(L, (char *)bytes, (size_t)(d.to - bytes), chunk, "b") == LUA_OK)
        lua_replace(L, f);
    lua_settop(L, f);
}
