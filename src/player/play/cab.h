/*
 * cab.h - the cabinet of a game that is played: window, switches, clock, speaker, demos, saves.
 *
 * The clock is cut into sixtieths of a second. Each one polls the switches, maps them to pads, ticks (not when paused,
 * several times when late or in turbo), draws once and shows the picture. Invariant: of all this, only pads reach the
 * board.
 */
#ifndef PLAYER_CAB_H
#define PLAYER_CAB_H

#include "../../board/board.h"
#include "../../rom/cart.h"
#include "../../demo/demo.h"
#include "../../common/result.h"
#include "../game/rom_image.h"

struct cab_options;

/* What became of an attempt to open the game: it is in the options; its folder is wrong; the arguments are. */
enum cab_opened { CAB_OPENED, CAB_WRONG, CAB_REFUSED };

struct cab_options {
    const struct cart *cart;  /* open, and its ROM; NULL: `wrong` says why there is none */
    const char *path;         /* what the user typed; NULL: the built-in game */
    struct board_start start; /* nvram NULL: the cabinet loads and saves user:<id>.nv, but not of practice or a demo */
    bool seeded;              /* start.seed was given; else it comes from the host's clock */
    const struct demo *demo;  /* NULL: a live run; else start is the demo's, and play ends with it */
    const char *record;       /* NULL: no recording */
    int scale;                /* 0: as configured */
    bool fullscreen, mute;    /* true: on, even if configured off */
    const char *version;      /* Curtain's release, for reports */
    bool verbose;             /* say at the end how the sound did */
    bool resume, no_resume;   /* go on with the run that was left, or begin at the title: without asking */
    rom_loader *load;         /* for games that are reloaded or dropped on the window */
    bool nearest;             /* as pack: for a folder that is packed again when it changes */
    bool sealed;              /* a game by itself: no keys of those who make games, and no other game */

    /* For a folder, else NULL: opens the game anew, which gives cart, start and demo. With it, what is wrong with the
     * folder is shown in the window, and waited for. */
    enum cab_opened (*open)(void *user, struct cab_options *o, char *err, size_t err_size);
    void *user;
    const char *wrong; /* a sentence, without cart */
};

/* A cabinet. There may be several at once, each with what it knows to itself, all called from one thread. What they ask
 * of the port they ask in these calls, so a port with several windows knows whose it is meant to be. */
struct cab;

/* Opens a cabinet and its window. The options' pointers must last until it is closed. NULL: there is no memory. */
struct cab *cab_open(const struct cab_options *options);

/* Does what is due: waits for the next sixtieth by plat_wait, and returns at once where that does. False: it is over,
 * by whatever was pressed or went wrong, and stays so; close it. */
bool cab_frame(struct cab *cab);

/* Hands out the folder or ROM that was dropped on the window and is to be played next. False: there is none. */
bool cab_next(const struct cab *cab, char *path, size_t size);

/* Ends what is on as quitting does, and gives everything back: nothing is kept. At any time between two frames.
 * RESULT_REFUSED: a script fault, a folder that did not become right, or a bad settings file; RESULT_HOST_FAILED: the
 * host failed. With these a line that says why has gone to plat_log; after a script fault its traceback too. */
enum result cab_close(struct cab *cab);

#endif
