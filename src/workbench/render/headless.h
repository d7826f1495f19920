/*
 * headless.h - the commands `render` and `hash`, which run a game without a window.
 *
 * These runs have no clock and no nvram; without --seed, the seed is 0. Requests for attract or to quit are ignored.
 * Output of scripts and errors go to plat_log.
 */
#ifndef WORKBENCH_HEADLESS_H
#define WORKBENCH_HEADLESS_H

#include "../../player/args/args.h"
#include "../../common/result.h"

enum result headless_render(const struct args *a);
enum result headless_hash(const struct args *a);

#endif
