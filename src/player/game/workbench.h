/*
 * workbench.h - the functions that `curtain` has and `curtain-player` does not: the author's commands, and loading
 * games from folders.
 */
#ifndef PLAYER_WORKBENCH_H
#define PLAYER_WORKBENCH_H

#include "../../common/result.h"
#include "rom_image.h"

struct args;

struct workbench {
    /* Runs the command if it belongs to the workbench, and returns false if not. *running: as of command_play. */
    bool (*run)(const struct args *a, struct frame_command *running, enum result *result);

    rom_loader *load; /* .rom files and folders */
};

static inline rom_loader *workbench_loader(const struct workbench *w)
{
    return w ? w->load : rom_image_read;
}

#endif
