/*
 * unsaved.h - stores files that could not be written, until they can be.
 */
#ifndef PLAYER_UNSAVED_H
#define PLAYER_UNSAVED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A file in the list, from malloc; a list has at most one per path. */
struct unsaved {
    struct unsaved *next;
    uint8_t *bytes;
    size_t size;
    char path[];
};

/* Saves a file with files_save. If it cannot be written, adds it to the list, sets err and returns false. */
bool unsaved_save(struct unsaved **list, const char *path, const void *bytes, size_t size, char *err, size_t err_size);

/* Returns the listed bytes of a path, which are newer than the file; NULL if the path is not listed. */
const uint8_t *unsaved_bytes(const struct unsaved *list, const char *path, size_t *size);

/* Saves the listed files again. Calls `failed` for each that still cannot be written. Returns whether none is left. */
bool unsaved_retry(struct unsaved **list, void (*failed)(void *context, const char *err), void *context);

void unsaved_free(struct unsaved **list);

#endif
