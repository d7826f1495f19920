/*
 * cab.h - the cabinet around a board that somebody plays: window, switches, clock, speaker, demos, saves.
 * floor: cab    used by: cli
 *
 * The clock is cut into sixtieths of a second. In each: poll, map keys to pads, tick (none when paused, several when
 * late or in turbo), draw once, show. A tick never waits for a picture nor the other way round; nothing here can reach
 * the board but pads.
 */
#ifndef CAB_CAB_H
#define CAB_CAB_H

#include "../../board/board.h"
#include "../../board/rom/cart.h"
#include "../demo/demo.h"
#include "../host/result.h"

struct cab_options {
    const struct cart *cart; /* open, and its ROM */
    const char *path;        /* what the user typed; NULL: the built-in game */
    struct board_start
        start;               /* nvram NULL: the cabinet loads and saves user:<id>.nv, unless it is practice or a demo */
    bool seeded;             /* start.seed was given; else it is drawn from the host's clock */
    const struct demo *demo; /* NULL: live. Else start is the demo's, and play ends with it */
    const char *record;      /* NULL: no recording */
    int scale;               /* 0: as configured */
    bool fullscreen, mute;   /* on, whatever is configured */
    bool nearest;            /* as pack: for a folder that is packed again when it changes */
};

/* Plays until quit. RESULT_REFUSED: a script fault or a bad settings file; RESULT_HOST: the host failed. With these a
 * line that says why has gone to plat_log; after a script fault its traceback too. */
enum result cab_play(const struct cab_options *options);

#endif
