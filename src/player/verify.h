/*
 * verify.h - the command `verify`: replays demos and says whether they hold; stamps or records them anew; compares
 * two tracks.
 *
 * A demo is a line on standard output, as soon as it is known:
 *
 *     PATH: holds, N frames[, ends in the recorded fault][, restamped][ (DOUBT)]
 *     PATH: frame F: PARTS differ[ (DOUBT)]              or: frames F to G, where there are no checksums
 *     PATH: frame F: fault that is not in the demo: WHAT[ (DOUBT)]
 *     PATH: frame F: the recorded fault does not occur[ (DOUBT)]
 *
 * With --rerecord, when it was written, one of
 *
 *     PATH: rerecorded: holds, N frames[...][ (DOUBT)]
 *     PATH: rerecorded: DIFFERENCE; score A -> B; markers: WHAT F -> G, ...; length N unchanged[ (DOUBT)]
 *
 * and when it was not (RESULT_REFUSED)
 *
 *     PATH: DIFFERENCE[; length N -> F]; not rerecorded: WHY[ (DOUBT)]
 *
 * With --json a demo is one JSON object on a line, whatever becomes of it: verify_json.h.
 *
 * Else what cannot be replayed is one sentence on plat_log; with names from standard input `PATH: WHY` in the same
 * stream.
 */
#ifndef PLAYER_VERIFY_H
#define PLAYER_VERIFY_H

#include "args/args.h"
#include "../common/result.h"

/* Returns the worst result of all demos. */
enum result verify_run(const struct args *a);

#endif
