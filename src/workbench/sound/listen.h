/*
 * listen.h - `curtain sound`: the sounds and the music of a game, listed, measured, written.
 */
#ifndef WORKBENCH_LISTEN_H
#define WORKBENCH_LISTEN_H

#include "../../player/args/args.h"
#include "../../common/result.h"

/* *running is to be called where a sound is heard. */
enum result listen_run(const struct args *a, struct frame_command *running);

#endif
