/*
 * verify_json.h - `verify --json`: prints one JSON object per demo, on one line. docs/reference/demo-format.md lists
 * its keys.
 *
 * Score, ship, difficulty and moments are taken from the replay, because anybody can write anything into a file. They
 * are therefore left out if the demo does not hold.
 */
#ifndef PLAYER_VERIFY_JSON_H
#define PLAYER_VERIFY_JSON_H

#include "replay.h"

struct verify_result {
    const char *path, *doubt; /* doubt NULL: none */
    const struct cart *cart;
    const struct demo *demo, *again; /* the demo, and the recording of its replay */
    const struct replay *replay;
    const struct verdict *verdict;
};

/* Prints the object of a demo that was replayed. */
void verify_json_replayed(const struct verify_result *t);

/* Prints the object of a demo that could not be replayed. host_failed: the host is to blame, not the demo. */
void verify_json_refused(const char *path, bool host_failed, const char *why);

#endif
