/*
 * log.h - what was printed and what went wrong, the last lines of it, on a screen that scrolls.
 */
#ifndef PLAYER_LOG_H
#define PLAYER_LOG_H

#include <stdint.h>
#include "screen.h"

enum { LOG_LINES = 400, LOG_LINE = 240 /* bytes of a line that are kept, its end included */ };

enum log_kind {
    LOG_PRINTED, /* by the game's scripts */
    LOG_TOLD,    /* by the cabinet */
    LOG_WRONG    /* a fault */
};

struct log {
    struct log_line {
        enum log_kind kind;
        uint32_t frame; /* in which it was written, for the first time */
        uint32_t times; /* that it was written, one after another */
        char text[LOG_LINE];
    } line[LOG_LINES];
    uint32_t lines; /* since the beginning; the last LOG_LINES of them are kept */
};

/* Adds a line, or of a text with several each that is not empty. A line that is the same as the last one is counted. */
void log_add(struct log *log, enum log_kind kind, uint32_t frame, const char *text);

/* Opens the screen, the newest line chosen. */
void log_open(struct log *log, struct screens *screens);

/* Opens it above the screens that are open, or closes it where it is the topmost: these stay. */
void log_toggle(struct log *log, struct screens *screens);

/* How many lines are kept, and the i-th of them, the oldest first. */
int log_kept(const struct log *log);
const struct log_line *log_line(const struct log *log, int i);

#endif
