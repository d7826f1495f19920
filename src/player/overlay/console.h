/*
 * console.h - the console: runs lines of Lua while the game is paused.
 *
 * RAM is saved before a line runs and restored afterwards, so inspecting the game doesn't change it. If a line starts
 * with "keep " and succeeds, its changes are kept. The past and the recording must then be marked as touched
 * (console_kept).
 */
#ifndef PLAYER_CONSOLE_H
#define PLAYER_CONSOLE_H

#include "../../../platform/platform.h"
#include "../../board/board.h"
#include "canvas.h"
#include "../input/keys.h"

enum {
    CONSOLE_LINE = 256,   /* bytes of a line, the NUL included */
    CONSOLE_HISTORY = 32, /* lines that are remembered */
    CONSOLE_OUTPUT = 128, /* lines of output that are kept */
    CONSOLE_TEXT = 160    /* bytes of one of these; longer ones go on in the next */
};

struct console_output {
    enum canvas_colour colour;
    char text[CONSOLE_TEXT];
};

struct console {
    bool open;
    char line[CONSOLE_LINE];
    int length, at;                              /* bytes typed, and where the cursor is */
    char history[CONSOLE_HISTORY][CONSOLE_LINE]; /* the newest is entry (lines - 1) % CONSOLE_HISTORY */
    int lines, back;                             /* typed so far; how far back the line shown is, 0: a new one */
    struct console_output output[CONSOLE_OUTPUT];
    int outputs; /* printed so far; the newest is entry (outputs - 1) % CONSOLE_OUTPUT */
    uint8_t held[PLAT_KEYS / 8];
    unsigned repeats; /* the key that is held, */
    int polls;        /* and since how many polls */
    bool kept;
    void *snapshot;
    size_t room;
};

/* Call it at every poll. b: the board that lines run in; NULL closes the console. keeps: may a line be kept? While the
 * console is open the caller must not tick the board, and *k is cleared, for the console has all keys. */
void console_poll(struct console *c, const struct plat_input *in, struct keys_read *k, struct board *b, bool keeps);

/* Returns whether a line was kept since the last call; the run is then touched. */
bool console_kept(struct console *c);

/* Draws it over the lower part of the picture; returns the first line it covers, the picture's height when closed. */
int console_draw(const struct console *c, const struct canvas *canvas);

/* Frees the memory. Does nothing if *c is zeroed. */
void console_close(struct console *c);

#endif
