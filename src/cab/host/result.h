/*
 * result.h - what a command of the program, or a part of one, came to.
 * floor: cab
 *
 * In order: of several results the greatest is the worst.
 */
#ifndef CAB_RESULT_H
#define CAB_RESULT_H

#include <stdbool.h>

enum result {
    RESULT_DONE,
    RESULT_DIFFERS, /* the thing checked does not hold */
    RESULT_REFUSED, /* bad input or a script fault */
    RESULT_HOST     /* the host failed, or ran out of memory */
};

/* What a command leaves to be called from frame to frame, by whoever has the loop. */
struct running {
    bool (*frame)(void *of); /* NULL: there is nothing, the command is done. False: it is over */
    enum result (*close)(void *of);
    void *of;
};

#endif
