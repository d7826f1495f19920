/*
 * console.h - a line of Lua, typed over a picture that stands still.
 * floor: cab    used by: cab
 *
 * RAM is saved before a line runs and put back after it, so a look at the game cannot change it. A line that begins with
 * "keep " is not undone, if it works: the run is then touched, and who owns its past and its demo must be told.
 */
#ifndef CAB_CONSOLE_H
#define CAB_CONSOLE_H

#include "../../../platform/platform.h"
#include "../../board/board.h"
#include "ink.h"
#include "../host/keys.h"

enum {
    CONSOLE_LINE = 256, /* bytes of a line, the NUL included */
    CONSOLE_PAST = 32,  /* lines that are remembered */
    CONSOLE_SAID = 128, /* lines that were said */
    CONSOLE_WORDS = 160 /* bytes of one of these; longer ones go on in the next */
};

struct console_said {
    enum ink_colour colour;
    char text[CONSOLE_WORDS];
};

struct console {
    bool open;
    char line[CONSOLE_LINE];
    int length, at;                        /* bytes typed, and where the cursor is */
    char past[CONSOLE_PAST][CONSOLE_LINE]; /* the newest is entry (lines - 1) % CONSOLE_PAST */
    int lines, back;                       /* typed so far; how far back the line shown is, 0: a new one */
    struct console_said said[CONSOLE_SAID];
    int told; /* the newest is entry (told - 1) % CONSOLE_SAID */
    uint8_t held[PLAT_KEYS / 8];
    unsigned repeats; /* the key that is held, */
    int polls;        /* and since how many polls */
    bool kept;
    void *snapshot;
    size_t room;
};

/* Call it at every poll. b: the board lines run in, NULL: there is none to be asked now, and the console closes. keeps:
 * may a line be kept? While the console is open the board is to stand still, and *k is emptied: the keys are its own. */
void console_poll(struct console *c, const struct plat_input *in, struct keys_read *k, struct board *b, bool keeps);

/* Was a line kept since the last call? Then the board's past is not its own any more, and its demo is touched. */
bool console_kept(struct console *c);

/* Draws it over the lower part of the picture; returns the first line it covers, the picture's height when closed. */
int console_draw(const struct console *c, const struct ink *ink);

/* Gives its memory back. Harmless on one of zeroes. */
void console_close(struct console *c);

#endif
