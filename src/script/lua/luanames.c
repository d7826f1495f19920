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

enum {
    HEADER_BYTES = 4 + 1 + 1 + 6 + 3 + 8 + 8, /* bytes of a dump's header */
    MAX_NESTING = 32                          /* maximum nesting depth of functions */
};

/* A dump that is read and rewritten in place. */
struct dump {
    unsigned char *at, *end, *to; /* read position and end; write position */
    bool is_malformed;
};

/* Copies n bytes to the output. */
static void copy_bytes(struct dump *d, size_t n)
{
    if (n > (size_t)(d->end - d->at)) {
        d->is_malformed = true;
        d->at = d->end;
        return;
    }
    memmove(d->to, d->at, n);
    d->at += n;
    d->to += n;
}

/* Copies and returns a number, stored as 7 bits per byte, most significant first; bit 7 marks its last byte. */
static size_t copy_number(struct dump *d)
{
    size_t n = 0;

    while (d->at < d->end && n < SIZE_MAX >> 7) {
        unsigned char c = *d->at;
        copy_bytes(d, 1);
        n = n << 7 | (c & 127u);
        if (c & 128)
            return n;
    }
    d->is_malformed = true;
    return 0;
}

static void copy_string(struct dump *d)
{
    size_t n = copy_number(d); /* length + 1; 0: no string */

    copy_bytes(d, n ? n - 1 : 0);
}

static void copy_constant(struct dump *d)
{
    enum { INTEGER = 3, FLOAT = 19, SHORT_STRING = 4, LONG_STRING = 20 };
    int type = d->at < d->end ? *d->at : 0;

    copy_bytes(d, 1);
    if (type == INTEGER || type == FLOAT)
        copy_bytes(d, 8);
    else if (type == SHORT_STRING || type == LONG_STRING)
        copy_string(d);
}

/* Replaces the list of locals by an empty one. */
static void strip_locals(struct dump *d)
{
    unsigned char *list = d->to;
    size_t n = copy_number(d);

    for (size_t i = 0; i < n && !d->is_malformed; i++) {
        copy_string(d);
        copy_number(d);
        copy_number(d);
    }
    d->to = list;
    *d->to++ = 128; /* encodes the number 0: no locals */
}

static void copy_function(struct dump *d, int depth)
{
    copy_string(d);
    copy_number(d);
    copy_number(d);
    copy_bytes(d, 3);
    copy_bytes(d, 4 * copy_number(d)); /* code */
    for (size_t i = copy_number(d); i > 0 && !d->is_malformed; i--)
        copy_constant(d);
    copy_bytes(d, 3 * copy_number(d)); /* upvalues */
    d->is_malformed = d->is_malformed || depth == MAX_NESTING;
    for (size_t i = copy_number(d); i > 0 && !d->is_malformed; i--)
        copy_function(d, depth + 1);
    copy_bytes(d, copy_number(d)); /* lines */
    for (size_t i = 2 * copy_number(d); i > 0 && !d->is_malformed; i--)
        copy_number(d);
    strip_locals(d);
    for (size_t i = copy_number(d); i > 0 && !d->is_malformed; i--)
        copy_string(d); /* names of upvalues */
}

/* A buffer for a dump. lua_dump needs the function on top of the stack, so the buffer is only initialized when the
 * first bytes arrive. */
struct dump_buffer {
    luaL_Buffer b;
    bool is_started;
};

static int append_dump(lua_State *L, const void *bytes, size_t n, void *context)
{
    struct dump_buffer *c = context;

    if (!c->is_started)
        luaL_buffinit(L, &c->b);
    c->is_started = true;
    luaL_addlstring(&c->b, bytes, n);
    return 0;
}

void lualib_strip_locals(lua_State *L, const char *chunk)
{
    const int f = lua_gettop(L);
    struct dump_buffer c = { .is_started = false };

    luaL_checkstack(L, 8, NULL);
    lua_dump(L, append_dump, &c, 0);
    unsigned char *bytes = (unsigned char *)luaL_buffaddr(&c.b);
    struct dump d = { bytes, bytes + luaL_bufflen(&c.b), bytes, false };
    copy_bytes(&d, HEADER_BYTES + 1);
    copy_function(&d, 0);
    if (!d.is_malformed && d.at == d.end &&
        luaL_loadbufferx(L, (char *)bytes, (size_t)(d.to - bytes), chunk, "b") == LUA_OK)
        lua_replace(L, f);
    lua_settop(L, f);
}
