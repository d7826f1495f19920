/*
 * byte_buffer.h - bytes of a file in the making: a buffer that grows.
 */
#ifndef COMMON_BYTE_BUFFER_H
#define COMMON_BYTE_BUFFER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { REEL_MOST = 1 << 30 };

/* Zeroes are an empty one. Once it has failed (no memory, or more than REEL_MOST bytes) nothing is added any more. */
struct byte_buffer {
    uint8_t *bytes; /* malloc */
    size_t n, room;
    bool failed;
};

/* Adds n bytes, which are whatever they are, and returns where they begin; NULL: it has failed. */
uint8_t *byte_buffer_take(struct byte_buffer *r, size_t n);

void byte_buffer_put(struct byte_buffer *r, const void *bytes, size_t n);
void byte_buffer_byte(struct byte_buffer *r, uint8_t byte);

/* Adds text as printf does, without its NUL. */
void byte_buffer_print(struct byte_buffer *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Frees the bytes; harmless on zeroes, or twice. */
void byte_buffer_close(struct byte_buffer *r);

#endif
