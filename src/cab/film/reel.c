/*
 * reel.c - see reel.h.
 */
#include "reel.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool grow(struct reel *r, size_t n)
{
    size_t room = r->room ? r->room : 1 << 16;

    while (room - r->n < n && room < REEL_MOST)
        room *= 2;
    uint8_t *more = room - r->n >= n ? realloc(r->bytes, room) : NULL;
    r->failed = more == NULL;
    if (more) {
        r->bytes = more;
        r->room = room;
    }
    return more != NULL;
}

uint8_t *reel_take(struct reel *r, size_t n)
{
    if (r->failed || (r->room - r->n < n && !grow(r, n)))
        return NULL;
    r->n += n;
    return r->bytes + r->n - n;
}

void reel_put(struct reel *r, const void *bytes, size_t n)
{
    uint8_t *to = reel_take(r, n);

    if (to && n)
        memcpy(to, bytes, n);
}

void reel_byte(struct reel *r, uint8_t byte)
{
    if (!r->failed && r->n < r->room)
        r->bytes[r->n++] = byte;
    else
        reel_put(r, &byte, 1);
}

void reel_print(struct reel *r, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    const int n = vsnprintf(NULL, 0, format, args);
    va_end(args);
    char *to = n < 0 ? NULL : (char *)reel_take(r, (size_t)n + 1);
    if (!to)
        return;
    va_start(args, format);
    vsnprintf(to, (size_t)n + 1, format, args);
    va_end(args);
    r->n--;
}

void reel_close(struct reel *r)
{
    free(r->bytes);
    *r = (struct reel){ 0 };
}
