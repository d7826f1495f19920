/*
 * sound_command.h - `curtain sound`: lists, measures, plays and writes the sounds and the music of a game.
 */
#ifndef WORKBENCH_SOUND_COMMAND_H
#define WORKBENCH_SOUND_COMMAND_H

#include "../../common/result.h"
#include "../../player/args/args.h"

/* The command. Sets *running if a sound is played in a window. */
enum result sound_command(const struct args *a, struct frame_command *running);

#endif
