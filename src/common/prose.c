/*
 * prose.c - text that grows in memory (prose.h).
 */
#include "prose.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

/* Reserves n more bytes and the 0. */
static bool grow(struct prose *p, size_t n)
{
    size_t room = p->room ? p->room : 4096;

    while (room - p->n <= n)
        room *= 2;
    if (room == p->room)
        return true;
    char *more = realloc(p->bytes, room);
    if (!more)
        return false;
    p->bytes = more;
    p->room = room;
    return true;
}

void prose_add(struct prose *p, const char *format, ...)
{
    va_list args, again;

    va_start(args, format);
    va_copy(again, args);
    int n = vsnprintf(NULL, 0, format, args);
    if (n < 0 || p->failed || !grow(p, (size_t)n))
        p->failed = true;
    else
        p->n += (size_t)vsnprintf(p->bytes + p->n, (size_t)n + 1, format, again);
    va_end(again);
    va_end(args);
}
