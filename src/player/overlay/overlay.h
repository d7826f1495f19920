/*
 * overlay.h - the diagnostics over the picture: hit shapes, panels of gauges, frame times and tasks, and the object
 * under the mouse. The program draws all of it, and none of it is in RAM.
 */
#ifndef PLAYER_OVERLAY_H
#define PLAYER_OVERLAY_H

#include "../../board/board.h"
#include "../../board/inspect.h"
#include "../run/guard.h"
#include "canvas.h"
#include "../input/keys.h"
#include "../speaker/speaker.h"

/* In the order of the hotkeys from HOTKEY_SHAPES on. */
enum overlay_panel { OVERLAY_SHAPES, OVERLAY_GAUGES, OVERLAY_SPLIT, OVERLAY_TASKS, OVERLAY_MIXER, OVERLAYS };

/* What a frame of the program consists of: the phases of its ticks, then these. */
enum {
    SPLIT_PROGRAM = PHASES, /* everything else: keys, key frames, recording, sound */
    SPLIT_DRAW,
    SPLIT_SHOW, /* this overlay, and the port showing the picture */
    SPLITS
};

/* The split: microseconds each part of a frame takes, over windows of SPLIT_WINDOW frames. */
enum { SPLIT_WINDOW = 30 };
struct split {
    uint64_t last;        /* when the clock was last read */
    uint64_t now[SPLITS]; /* of this frame */
    uint64_t sum[SPLITS]; /* of this window's frames; their worst */
    uint64_t most[SPLITS];
    int frames;
    uint32_t slowest;                                /* whole frame of this window */
    uint32_t mean[SPLITS], peak[SPLITS], all, worst; /* of the window before; all, worst: whole frames */
};

/* The mixer: levels as they fall, of 32768. */
struct mixer {
    int voice[VOICES], out[2];
    const struct speaker *speaker;
};

struct overlay {
    bool on[OVERLAYS];
    struct split split;
    struct mixer mixer;
};

/* Toggles what was pressed. */
void overlay_keys(struct overlay *o, uint32_t pressed);

/* Is anything shown? */
bool overlay_on(const struct overlay *o);

/* Begins a frame in which g may tick. The clock is read only while the split is shown. */
void overlay_begin(struct overlay *o, struct guard *g);

/* Adds the time since the last call to `part`. */
void overlay_lap(struct overlay *o, int part);

/* Looks at what the board's frame sounds like, while the mixer is shown. */
void overlay_listen(struct overlay *o, const struct board *b, const struct speaker *speaker);

/* Ends the frame. */
void overlay_end(struct overlay *o);

/* Where it is drawn: shapes over the picture, panels there too, or beside it if that is not NULL, between its lines y0
 * and y1. */
struct overlay_place {
    const struct canvas *picture, *beside;
    int y0, y1;
};

/* Draws what is on over the picture of b. (mouse_x, mouse_y): a pixel of it, or -1, -1. */
void overlay_draw(const struct overlay *o, const struct overlay_place *place, const struct board *b, int mouse_x,
                  int mouse_y);

/* The hit shapes of the ships that are seen, on the field, for who plays: white, in a ring of a colour a player. */
void overlay_ships(const struct canvas *canvas, const struct board *b);

#endif
