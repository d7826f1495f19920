/*
 * running.h - what a command leaves to be called from frame to frame, by whoever has the loop.
 * floor: cab
 */
#ifndef CAB_RUNNING_H
#define CAB_RUNNING_H

#include <stdbool.h>
#include "result.h"

struct running {
    bool (*frame)(void *of); /* NULL: there is nothing, the command is done. False: it is over */
    enum result (*close)(void *of);
    void *of;
};

#endif
