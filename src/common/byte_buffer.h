/*
 * byte_buffer.h - a buffer that grows, for making files in memory.
 */
#ifndef COMMON_BYTE_BUFFER_H
#define COMMON_BYTE_BUFFER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { BYTE_BUFFER_MAX = 1 << 30 };

/* Zero it before use. After a failure (out of memory, or more than BYTE_BUFFER_MAX bytes), nothing more is added. */
struct byte_buffer {
    uint8_t *bytes; /* malloc */
    size_t n, capacity;
    bool failed;
};

/* Appends n uninitialised bytes and returns them; NULL if the buffer has failed. */
uint8_t *byte_buffer_take(struct byte_buffer *b, size_t n);

/* Append bytes. */
void byte_buffer_put(struct byte_buffer *b, const void *bytes, size_t n);
void byte_buffer_byte(struct byte_buffer *b, uint8_t byte);

/* Appends text like printf. A NUL follows the bytes but is not counted. */
void byte_buffer_print(struct byte_buffer *b, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Returns what byte_buffer_print has appended; "" if the buffer is empty. */
const char *byte_buffer_text(const struct byte_buffer *b);

/* Frees the bytes and empties the buffer. */
void byte_buffer_close(struct byte_buffer *b);

#endif
