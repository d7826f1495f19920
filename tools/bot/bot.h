/*
 * bot.h - a program that plays a game: the run it makes, the way through the menus, and the pilot.
 */
#ifndef TOOLS_BOT_H
#define TOOLS_BOT_H

#include "../../src/workbench/survive/simulation.h"

/* A run: a board, and what was pressed from power-on to where it is. */
struct run {
    struct simulation t;
    const struct cart *cart;
    struct board_start start;
    uint32_t limit;                /* frames, at most */
    uint16_t (*pads)[MAX_PLAYERS]; /* per frame */
    bool quiet;
};

/* Ticks, and writes the pads down. */
enum simulation_end run_tick(struct run *r, const uint16_t pads[MAX_PLAYERS]);

/* Says why and ends the program. */
void bot_fail(const char *what) __attribute__((noreturn));

/* ---- menus.c ---- */

struct menus_wish {
    const char *ship[MAX_PLAYERS]; /* kinds of players; NULL: any */
    int difficulty;                /* an index; -1: any */
    int players;
    const char *first; /* stage; NULL: any */
};

/* Looks for what to press from where the run is until a game begins as it is wished, and presses it. False: no way was
 * found, and the run is where it was. */
bool menus_enter(struct run *r, const struct menus_wish *wish);

/* ---- pilot.c ---- */

struct pilot {
    struct run *r;
    int deaths;                            /* so often it lets itself be hit, before it begins to dodge */
    int lose;                              /* after so many seconds it dodges no more, and never goes on; 0: it does */
    bool finish;                           /* it stops two seconds after a score was entered */
    unsigned bombs, specials, hits, backs; /* what it came to */
};

/* Plays on to the limit, or to where it is to stop; false: it lost, and was not to. */
bool pilot_play(struct pilot *p);

#endif
