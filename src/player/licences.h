/*
 * licences.h - the command `licences`: whose work is linked into this program, which version, and under which licence;
 * with --full the texts that must be given along with it.
 */
#ifndef PLAYER_LICENCES_H
#define PLAYER_LICENCES_H

#include <stdbool.h>
#include "../common/byte_buffer.h"
#include "../common/result.h"

/* Adds the notices of everything that may be in a download of a game, on any system. */
void licences_notices(struct byte_buffer *out);

/* full: with the texts. */
enum result licences_run(bool full);

#endif
