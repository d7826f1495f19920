/*
 * result.h - the outcome of a command of the program, or of one step of it.
 *
 * Results are ordered: the greatest is the worst.
 */
#ifndef COMMON_RESULT_H
#define COMMON_RESULT_H

#include <stdbool.h>
#include <stddef.h>

enum result {
    RESULT_DONE,
    RESULT_DIFFERS, /* a check failed */
    RESULT_REFUSED, /* bad input or a script fault */
    RESULT_HOST     /* the host failed, or ran out of memory */
};

/* Sets err like err_set, for failures of the host: out of memory, or a file that cannot be written. It does not matter
 * what the message becomes part of later: result_cause knows that the host failed since its last call. result_is_why
 * records a host failure whose message was made some other way. */
bool result_host(char *err, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));
void result_is_why(void);

/* Returns why game_open, demo_load, packing or unpacking failed: RESULT_HOST when the host failed (result_host),
 * otherwise RESULT_REFUSED. Call it once, right after the failure; it resets the cause. */
enum result result_cause(void);

/* A command that runs frame by frame, called by the owner of the main loop. */
struct running {
    bool (*frame)(void *of); /* returns false when it is over; NULL: nothing to run, the command is done */
    enum result (*close)(void *of);
    void *of;
};

#endif
