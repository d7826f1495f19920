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

/* Watches a folder: its present contents are known. False: it isn't a folder; checks then find nothing. */
bool folder_open(struct folder *f, const char *path);

/* True once after a change, when two checks in a row find the same stamp, so that an editor has time to finish. Names
 * and times of all files count, except hidden ones (starting with a dot) and those in demos/ and tests/. */
bool folder_changed(struct folder *f);

#endif
