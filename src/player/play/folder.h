/*
 * folder.h - detects changed files in a game's folder.
 */
#ifndef PLAYER_FOLDER_H
#define PLAYER_FOLDER_H

#include <stdbool.h>
#include <stdint.h>

struct folder {
    const char *path;
    uint64_t seen;  /* stamp of the known contents */
    uint64_t fresh; /* stamp at the last check, if it was different */
};

/* Starts watching a folder. If it isn't a folder, returns false, and folder_changed never finds a change. */
bool folder_open(struct folder *f, const char *path);

/* Returns true once after a change, when two calls in a row find the same stamp, so that an editor has time to finish.
 * Compares names and times of all files except hidden ones (starting with a dot) and those in demos/ and tests/. */
bool folder_changed(struct folder *f);

#endif
