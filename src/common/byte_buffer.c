/*
 * byte_buffer.c - see byte_buffer.h.
 */
#include "byte_buffer.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool grow(struct byte_buffer *r, size_t n)
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

uint8_t *byte_buffer_take(struct byte_buffer *r, size_t n)
{
    if (r->failed || (r->room - r->n < n && !grow(r, n)))
        return NULL;
    r->n += n;
    return r->bytes + r->n - n;
}

void byte_buffer_put(struct byte_buffer *r, const void *bytes, size_t n)
{
    uint8_t *to = byte_buffer_take(r, n);

    if (to && n)
        memcpy(to, bytes, n);
}

void byte_buffer_byte(struct byte_buffer *r, uint8_t byte)
{
    if (!r->failed && r->n < r->room)
        r->bytes[r->n++] = byte;
    else
        byte_buffer_put(r, &byte, 1);
}

void byte_buffer_print(struct byte_buffer *r, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    const int n = vsnprintf(NULL, 0, format, args);
    va_end(args);
    char *to = n < 0 ? NULL : (char *)byte_buffer_take(r, (size_t)n + 1);
    if (!to)
        return;
    va_start(args, format);
    vsnprintf(to, (size_t)n + 1, format, args);
    va_end(args);
    r->n--;
}

void byte_buffer_close(struct byte_buffer *r)
{
    free(r->bytes);
    *r = (struct byte_buffer){ 0 };
}
