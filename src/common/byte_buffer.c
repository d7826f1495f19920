/*
 * byte_buffer.c - a buffer that grows (byte_buffer.h).
 */
#include "byte_buffer.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool grow(struct byte_buffer *b, size_t n)
{
    size_t capacity = b->capacity ? b->capacity : 1 << 16;

    while (capacity - b->n < n && capacity < BYTE_BUFFER_MAX)
        capacity *= 2;
    uint8_t *more = capacity - b->n >= n ? realloc(b->bytes, capacity) : NULL;
    b->failed = more == NULL;
    if (more) {
        b->bytes = more;
        b->capacity = capacity;
    }
    return more != NULL;
}

uint8_t *byte_buffer_take(struct byte_buffer *b, size_t n)
{
    if (b->failed || (b->capacity - b->n < n && !grow(b, n)))
        return NULL;
    b->n += n;
    return b->bytes + b->n - n;
}

void byte_buffer_put(struct byte_buffer *b, const void *bytes, size_t n)
{
    uint8_t *to = byte_buffer_take(b, n);

    if (to && n)
        memcpy(to, bytes, n);
}

void byte_buffer_byte(struct byte_buffer *b, uint8_t byte)
{
    if (!b->failed && b->n < b->capacity)
        b->bytes[b->n++] = byte;
    else
        byte_buffer_put(b, &byte, 1);
}

void byte_buffer_print(struct byte_buffer *b, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    const int n = vsnprintf(NULL, 0, format, args);
    va_end(args);
    char *to = n < 0 ? NULL : (char *)byte_buffer_take(b, (size_t)n + 1);
    if (!to)
        return;
    va_start(args, format);
    vsnprintf(to, (size_t)n + 1, format, args);
    va_end(args);
    b->n--;
}

const char *byte_buffer_text(const struct byte_buffer *b)
{
    return b->bytes ? (const char *)b->bytes : "";
}

void byte_buffer_close(struct byte_buffer *b)
{
    free(b->bytes);
    *b = (struct byte_buffer){ 0 };
}
