/*
 * verify_json.h - `verify --json`: what is known of a demo as one JSON object on a line. docs/reference/demo-format.md
 * lists its keys.
 *
 * Score, ship, difficulty and moments are those of the replay that was just run, not what the file says of itself: a
 * file can be written by anybody. So they are left out where the demo does not hold.
 */
#ifndef PLAYER_VERIFY_JSON_H
#define PLAYER_VERIFY_JSON_H

#include "replay.h"

struct verify_told {
    const char *path, *doubt; /* doubt NULL: none */
    const struct cart *cart;
    const struct demo *demo, *again; /* as it was read; as it was recorded while it was replayed */
    const struct replay *replay;
    const struct verdict *verdict;
};

/* A demo that was replayed. */
void verify_json_told(const struct verify_told *t);

/* One that could not be: failed for the host's reasons, or refused. */
void verify_json_refused(const char *path, bool failed, const char *why);

#endif
