/*
 * unsaved.h - files that could not be written: their bytes wait here until they can be.
 */
#ifndef PLAYER_UNSAVED_H
#define PLAYER_UNSAVED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* One file; the newest bytes of a path replace older ones that wait. malloc. */
struct unsaved {
    struct unsaved *next;
    uint8_t *bytes;
    size_t size;
    char path[];
};

/* files_save, of a whole file. False and one sentence: it cannot be written, and waits in the list. */
bool unsaved_save(struct unsaved **list, const char *path, const void *bytes, size_t size, char *err, size_t err_size);

/* The bytes that wait for a path: what is in the file is older. NULL: none do. */
const uint8_t *unsaved_bytes(const struct unsaved *list, const char *path, size_t *size);

/* Tries all of them again. Hands out a sentence for each that still cannot be written; returns whether none is left. */
bool unsaved_retry(struct unsaved **list, void (*failed)(void *of, const char *err), void *of);

void unsaved_free(struct unsaved **list);

#endif
