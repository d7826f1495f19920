/*
 * licences.h - the command `licences`: lists the software in this program with authors, versions and licences; with
 * --full also prints the texts that must accompany it.
 */
#ifndef PLAYER_LICENCES_H
#define PLAYER_LICENCES_H

#include <stdbool.h>
#include "../common/byte_buffer.h"
#include "../common/result.h"

/* Appends the notices for all software in downloads of a game, for any system. */
void licences_notices(struct byte_buffer *out);

/* Runs the command. full: also prints the texts. */
enum result licences_run(bool full);

#endif
