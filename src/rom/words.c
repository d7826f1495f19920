/*
 * words.c - see words.h.
 */
#include "words.h"

#include <inttypes.h>
#include <string.h>
#include "../base/bytes.h"
#include "../base/err.h"

enum { HEADER_SIZE = 4, ENTRY_SIZE = 8 };

const char *words_entry(const struct words *w, uint32_t i, const char **translation)
{
    const uint8_t *entry = w->data + HEADER_SIZE + (size_t)i * ENTRY_SIZE;

    if (translation)
        *translation = (const char *)w->data + bytes_get32(entry + 4);
    return (const char *)w->data + bytes_get32(entry);
}

/* Returns whether a string of valid length starts at offset `at`, which must not be before `first`. */
static bool string_ok(const uint8_t *data, size_t size, size_t first, uint32_t at)
{
    size_t limit = at < size ? size - at : 0;

    return at >= first && memchr(data + at, 0, limit < WORDS_MAX_TEXT ? limit : WORDS_MAX_TEXT) != NULL;
}

struct words words_of(const uint8_t *data)
{
    return (struct words){ data, bytes_get32(data) };
}

bool words_open(struct words *w, const uint8_t *data, size_t size, char *err, size_t err_size)
{
    *w = (struct words){ data, size >= HEADER_SIZE ? bytes_get32(data) : 0 };
    if (size < HEADER_SIZE || w->n > WORDS_MAX_ENTRIES || size - HEADER_SIZE < (size_t)w->n * ENTRY_SIZE ||
        (size > HEADER_SIZE && data[size - 1] != 0))
        return err_set(err, err_size, "not a table of %" PRIu32 " translations (%zu bytes)", w->n, size);
    for (uint32_t i = 0; i < w->n; i++) {
        const uint8_t *entry = data + HEADER_SIZE + (size_t)i * ENTRY_SIZE;
        if (!string_ok(data, size, HEADER_SIZE + (size_t)w->n * ENTRY_SIZE, bytes_get32(entry)) ||
            !string_ok(data, size, HEADER_SIZE + (size_t)w->n * ENTRY_SIZE, bytes_get32(entry + 4)))
            return err_set(err, err_size, "translation %" PRIu32 " is missing", i);
        if (i > 0 && strcmp(words_entry(w, i - 1, NULL), words_entry(w, i, NULL)) >= 0)
            return err_set(err, err_size, "translation %" PRIu32 " is out of order (expected byte order)", i);
    }
    return true;
}

/* Like strcmp, but `text` is n bytes long and has no NUL. */
static int compare(const char *s, const char *text, size_t n)
{
    size_t m = strlen(s);
    int order = memcmp(s, text, m < n ? m : n);

    return order ? order : (m > n) - (m < n);
}

const char *words_find(const struct words *w, const char *text, size_t n)
{
    uint32_t lo = 0, hi = w->data ? w->n : 0;
    const char *translation;

    while (lo < hi) {
        uint32_t mid = lo + (hi - lo) / 2;
        int order = compare(words_entry(w, mid, &translation), text, n);
        if (!order)
            return translation;
        if (order < 0)
            lo = mid + 1;
        else
            hi = mid;
    }
    return NULL;
}
