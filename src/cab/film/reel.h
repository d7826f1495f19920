/*
 * reel.h - bytes of a file in the making: a buffer that grows.
 */
#ifndef CAB_REEL_H
#define CAB_REEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { REEL_MOST = 1 << 30 };

/* Zeroes are an empty one. Once it has failed (no memory, or more than REEL_MOST bytes) nothing is added any more. */
struct reel {
    uint8_t *bytes; /* malloc */
    size_t n, room;
    bool failed;
};

/* Adds n bytes, which are whatever they are, and returns where they begin; NULL: it has failed. */
uint8_t *reel_take(struct reel *r, size_t n);

void reel_put(struct reel *r, const void *bytes, size_t n);
void reel_byte(struct reel *r, uint8_t byte);

/* Adds text as printf does, without its NUL. */
void reel_print(struct reel *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Frees the bytes; harmless on zeroes, or twice. */
void reel_close(struct reel *r);

#endif
