/*
 * console.h - the console: runs lines of Lua while the game is paused.
 *
 * RAM is saved before a line runs and restored afterwards, so inspecting the game doesn't change it. If a line starts
 * with "keep " and succeeds, its changes are kept. The past and the recording must then be marked as touched
 * (console_take_kept).
 */
#ifndef PLAYER_CONSOLE_H
#define PLAYER_CONSOLE_H

#include "../../../platform/platform.h"
#include "../../board/board.h"
#include "canvas.h"
#include "../input/keys.h"

enum {
    CONSOLE_LINE_SIZE = 256,  /* bytes, including the NUL */
    CONSOLE_HISTORY = 32,     /* input lines */
    CONSOLE_MAX_OUTPUT = 128, /* output lines */
    CONSOLE_OUTPUT_SIZE = 160 /* bytes of an output line, including the NUL; longer ones are split */
};

struct console_output {
    enum canvas_colour colour;
    char text[CONSOLE_OUTPUT_SIZE];
};

struct console {
    bool open;
    char line[CONSOLE_LINE_SIZE];
    int length, cursor;
    char history[CONSOLE_HISTORY][CONSOLE_LINE_SIZE]; /* a ring buffer */
    int history_count;                                /* lines entered so far */
    int history_back; /* which line is shown: 0 the new one, 1 the last one in history */
    struct console_output output[CONSOLE_MAX_OUTPUT]; /* a ring buffer */
    int output_count;                                 /* lines printed so far */
    uint8_t held[PLAT_KEYS / 8];                      /* at the last poll */
    unsigned repeat_key;                              /* the held key that repeats; 0: none */
    int repeat_polls;                                 /* for which it has been held */
    bool kept;                                        /* a line was kept since console_take_kept */
    void *snapshot;
    size_t snapshot_capacity;
};

/* Call it at every poll. b: the board that lines run in; NULL closes the console. can_keep: `keep` is available. An
 * open console uses all keys and therefore clears *k. The caller must not tick the board meanwhile. */
void console_poll(struct console *c, const struct plat_input *in, struct keys_state *k, struct board *b, bool can_keep);

/* Returns whether a line was kept since the last call. The caller must then mark the run as touched. */
bool console_take_kept(struct console *c);

/* Draws the console over the lower part of the picture. Returns the first row that it covers, or the picture's height
 * if it is closed. */
int console_draw(const struct console *c, const struct canvas *canvas);

/* Frees the memory. Does nothing if *c is zeroed. */
void console_close(struct console *c);

#endif
