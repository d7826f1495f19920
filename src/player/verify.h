/*
 * verify.h - the command `verify`: replays demos, reports whether they hold, and updates or rerecords them.
 *
 * Prints one line per demo to standard output:
 *
 *     PATH: holds, N frames[, ends in the recorded fault][, restamped][ (DOUBT)]
 *     PATH: frame F: PARTS differ[ (DOUBT)]              or: frames F to G, if there are no checksums
 *     PATH: frame F: fault that is not in the demo: WHAT[ (DOUBT)]
 *     PATH: frame F: the recorded fault does not occur[ (DOUBT)]
 *
 * With --rerecord, if the file was written, one of
 *
 *     PATH: rerecorded: holds, N frames[...][ (DOUBT)]
 *     PATH: rerecorded: DIFFERENCE; score A -> B; markers: WHAT F -> G, ...; length N unchanged[ (DOUBT)]
 *
 * and otherwise (RESULT_REFUSED)
 *
 *     PATH: DIFFERENCE[; length N -> F]; not rerecorded: WHY[ (DOUBT)]
 *
 * With --json, every demo is one JSON object on a line (verify_json.h).
 *
 * Otherwise a demo that cannot be replayed is reported with plat_log, or with names from standard input as `PATH: WHY`
 * on standard output.
 */
#ifndef PLAYER_VERIFY_H
#define PLAYER_VERIFY_H

#include "args/args.h"
#include "../common/result.h"

/* Returns the worst result of all demos. */
enum result verify_run(const struct args *a);

#endif
