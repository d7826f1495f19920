/*
 * headless.h - running a board with no window: render and hash.
 * floor: cab    used by: cli
 *
 * Nothing of the host but files gets near these runs: no clock, no nvram, seed 0 unless told. A request for attract or
 * to quit is passed over. What scripts print goes to plat_log. Each returns an exit code of cli.h.
 */
#ifndef CAB_HEADLESS_H
#define CAB_HEADLESS_H

#include "args.h"

int headless_render(const struct args *a);
int headless_hash(const struct args *a);

#endif
