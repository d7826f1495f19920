/*
 * headless.h - running a board with no window: render and hash.
 *
 * Nothing of the host but files gets near these runs: no clock, no nvram, seed 0 unless told. A request for attract or
 * to quit is passed over. What scripts print goes to plat_log. What is not done has been told on plat_log.
 */
#ifndef WORKBENCH_HEADLESS_H
#define WORKBENCH_HEADLESS_H

#include "../../player/args/args.h"
#include "../../common/result.h"

enum result headless_render(const struct args *a);
enum result headless_hash(const struct args *a);

#endif
