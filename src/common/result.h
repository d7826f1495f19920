/*
 * result.h - the outcome of one of the program's commands, or of a step of a command.
 *
 * Results are ordered: the greatest is the worst.
 */
#ifndef COMMON_RESULT_H
#define COMMON_RESULT_H

#include <stdbool.h>
#include <stddef.h>

enum result {
    RESULT_DONE,
    RESULT_DIFFERS,    /* a check failed */
    RESULT_REFUSED,    /* bad input or a script fault */
    RESULT_HOST_FAILED /* the host failed, or ran out of memory */
};

/* Sets err and returns false like err_set, and records for result_take_cause that the host failed: it is out of memory,
 * or a file cannot be written. The record does not depend on the message, which may become part of another message.
 * result_set_host_failed only records the failure, for messages that are made some other way. */
bool result_set_host_error(char *err, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));
void result_set_host_failed(void);

/* Returns why game_open, demo_load, packing or unpacking failed: RESULT_HOST_FAILED when the host failed
 * (result_set_host_error), otherwise RESULT_REFUSED. Call it once, right after the failure; it resets the cause. */
enum result result_take_cause(void);

/* A command that runs frame by frame, called by the owner of the main loop. */
struct frame_command {
    bool (*run_frame)(void *owner); /* runs a frame; returns false when the command is over; NULL: it is already over */
    enum result (*close)(void *owner);
    void *context;
};

#endif
