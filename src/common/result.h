/*
 * result.h - what a command of the program, or a part of one, came to.
 *
 * In order: of several results the greatest is the worst.
 */
#ifndef COMMON_RESULT_H
#define COMMON_RESULT_H

#include <stdbool.h>
#include <stddef.h>

enum result {
    RESULT_DONE,
    RESULT_DIFFERS, /* the thing checked does not hold */
    RESULT_REFUSED, /* bad input or a script fault */
    RESULT_HOST     /* the host failed, or ran out of memory */
};

/* err_set, where the host is why: there is no memory, or a file cannot be written. What such a sentence is put into
 * later does not matter: result_cause knows that one was made since it was asked last. result_is_why: of one that is
 * made otherwise. */
bool result_host(char *err, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));
void result_is_why(void);

/* Why game_open, demo_load, packing or unpacking has said no: RESULT_HOST when the host is (result_host), else
 * RESULT_REFUSED. To be asked once, right after it. */
enum result result_cause(void);

/* What a command leaves to be called from frame to frame, by whoever has the loop. */
struct running {
    bool (*frame)(void *of); /* NULL: there is nothing, the command is done. False: it is over */
    enum result (*close)(void *of);
    void *of;
};

#endif
