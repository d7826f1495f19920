/*
 * log.h - the log: the last lines and errors that were printed, on a screen that scrolls.
 */
#ifndef PLAYER_LOG_H
#define PLAYER_LOG_H

#include <stdint.h>
#include "screen.h"

enum { LOG_LINES = 400, LOG_LINE = 240 /* bytes of a stored line, with its NUL */ };

enum log_kind {
    LOG_SCRIPT,  /* printed by the game */
    LOG_PROGRAM, /* a message of the program */
    LOG_FAULT
};

struct log {
    struct log_line {
        enum log_kind kind;
        uint32_t frame; /* in which it was first written */
        uint32_t times; /* that it was written in succession */
        char text[LOG_LINE];
    } line[LOG_LINES];
    uint32_t lines; /* written in total; the last LOG_LINES are stored */
};

/* Adds the non-empty lines of a text. Only counts a line that is the same as the last one. */
void log_add(struct log *log, enum log_kind kind, uint32_t frame, const char *text);

/* Opens the screen, with the newest line chosen. */
void log_open(struct log *log, struct screens *screens);

/* Opens it above the open screens, or closes it if it is the topmost. */
void log_toggle(struct log *log, struct screens *screens);

/* Return the number of stored lines, and line i, from the oldest. */
int log_count(const struct log *log);
const struct log_line *log_line(const struct log *log, int i);

#endif
