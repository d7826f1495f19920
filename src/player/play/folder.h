/*
 * folder.h - tells when a file of a game's folder has changed.
 */
#ifndef PLAYER_FOLDER_H
#define PLAYER_FOLDER_H

#include <stdbool.h>
#include <stdint.h>

struct folder {
    const char *path;
    uint64_t seen;  /* stamp of what is known */
    uint64_t fresh; /* of the last look, when it was another */
};

/* Watches a folder from now on: what is in it is known. False: it is none; looks then find nothing. */
bool folder_open(struct folder *f, const char *path);

/* True once after a change, when two looks in a row find the same: so that an editor has time to finish. Names and
 * times of all files count, but for hidden ones (a dot first) and those below demos/, where recordings go, and
 * tests/. */
bool folder_changed(struct folder *f);

#endif
