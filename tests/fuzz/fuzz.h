/* fuzz.h - what the fuzz targets share. */
#ifndef TESTS_FUZZ_H
#define TESTS_FUZZ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static inline void need(bool good)
{
    if (!good)
        abort();
}

/* An error is one line. */
static inline void need_line(const char *err)
{
    need(err[0] != '\0' && strchr(err, '\n') == NULL);
}

/* A copy of exactly this size: a sanitizer sees every read beyond it. */
static inline void *fuzz_copy(const uint8_t *data, size_t size)
{
    uint8_t *copy = calloc(size + (size == 0), 1);

    need(copy != NULL);
    if (size > 0)
        memcpy(copy, data, size);
    return copy;
}

/* A copy with a NUL behind it. */
static inline char *fuzz_text(const uint8_t *data, size_t size)
{
    char *copy = malloc(size + 1);

    need(copy != NULL);
    if (size > 0)
        memcpy(copy, data, size);
    copy[size] = '\0';
    return copy;
}

#endif
