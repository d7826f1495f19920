/*
 * overlay.h - looking inside: hit shapes over the picture, panels of gauges, times and tasks, and what is under the
 * mouse. All of it is drawn by the cabinet and none of it is in RAM.
 * floor: cab    used by: cab
 */
#ifndef CAB_OVERLAY_H
#define CAB_OVERLAY_H

#include "../../board/board.h"
#include "../run/guard.h"
#include "ink.h"
#include "../host/keys.h"

/* In the order of the cabinet keys from CAB_SHAPES on. */
enum overlay_panel { OVERLAY_SHAPES, OVERLAY_GAUGES, OVERLAY_SPLIT, OVERLAY_TASKS, OVERLAYS };

/* What a frame of the cabinet consists of: the phases of its ticks, then these. */
enum {
    SPLIT_CABINET = PHASES, /* all that is none of the others: keys, key frames, recording, sound */
    SPLIT_DRAW,
    SPLIT_SHOW, /* this overlay and the port's work */
    SPLITS
};

/* Microseconds of the parts of a frame, over SPLIT_WINDOW frames. */
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

struct overlay {
    bool on[OVERLAYS];
    struct split split;
};

/* Toggles what was pressed. */
void overlay_keys(struct overlay *o, uint32_t pressed);

/* Is anything shown? */
bool overlay_on(const struct overlay *o);

/* A frame begins, in which g may tick. The clock is read only while the split is shown. */
void overlay_begin(struct overlay *o, struct guard *g);

/* The time since the last call went to `part`. */
void overlay_lap(struct overlay *o, int part);

/* The frame is over. */
void overlay_end(struct overlay *o);

/* Draws what is on over the picture of b, panels between the lines y0 and y1. (mouse_x, mouse_y): a pixel, or -1, -1. */
void overlay_draw(const struct overlay *o, const struct ink *ink, int y0, int y1, const struct board *b, int mouse_x,
                  int mouse_y);

#endif
