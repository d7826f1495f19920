/*
 * overlay.h - diagnostics over the picture: hitboxes, panels of gauges, frame times and tasks, and the entity under the
 * mouse. The overlay only reads the board.
 */
#ifndef PLAYER_OVERLAY_H
#define PLAYER_OVERLAY_H

#include "../../board/board.h"
#include "../../board/inspect.h"
#include "../run/guard.h"
#include "canvas.h"
#include "../input/keys.h"
#include "../speaker/speaker.h"

/* In the order of the hotkeys that start with HOTKEY_HITBOXES. */
enum overlay_panel { OVERLAY_HITBOXES, OVERLAY_GAUGES, OVERLAY_FRAME_TIMES, OVERLAY_TASKS, OVERLAY_MIXER, OVERLAYS };

/* The steps of a frame: the phases of its ticks, then these. */
enum {
    STEP_PROGRAM = PHASES, /* input, key frames, recording, sound */
    STEP_DRAW,             /* the board's picture */
    STEP_SHOW,             /* the overlay, and the port showing the picture */
    STEPS
};

/* The microseconds that each step takes. Results are shown for FRAME_TIMES_WINDOW frames, so that they can be read. */
enum { FRAME_TIMES_WINDOW = 30 };
struct frame_times {
    uint64_t last_read;      /* when the clock was last read */
    uint64_t current[STEPS]; /* of the current frame */

    /* The current window. */
    uint64_t sum[STEPS], max[STEPS];
    uint32_t max_frame; /* the longest frame */
    int frames;

    /* The results of the previous window. */
    uint32_t shown_mean[STEPS], shown_max[STEPS];
    uint32_t shown_frame_mean, shown_frame_max; /* of whole frames */
};

/* Peak levels, 0 to 32768, which decay from frame to frame. */
struct mixer {
    int voice[VOICES], out[2];
    const struct speaker *speaker;
};

struct overlay {
    bool on[OVERLAYS];
    struct frame_times frame_times;
    struct mixer mixer;
};

/* Toggles the panels whose hotkeys were pressed. */
void overlay_toggle(struct overlay *o, uint32_t pressed);

/* Returns whether anything is shown. */
bool overlay_is_visible(const struct overlay *o);

/* Starts measuring a frame in which g may tick. The clock is read only while frame times are shown. */
void overlay_begin_frame(struct overlay *o, struct guard *g);

/* Adds the time since the last call to `step`. */
void overlay_add_time(struct overlay *o, int step);

/* Updates the mixer's levels with the board's last frame, while the mixer is shown. */
void overlay_update_mixer(struct overlay *o, const struct board *b, const struct speaker *speaker);

/* Ends the frame that overlay_begin_frame started. */
void overlay_end_frame(struct overlay *o);

/* Hitboxes are drawn on the picture. Panels are drawn on `side`, or on the picture if `side` is NULL, in rows y0 to
 * y1 - 1. */
struct overlay_target {
    const struct canvas *picture, *side;
    int y0, y1;
};

/* Draws everything that is shown. (mouse_x, mouse_y): a pixel of the picture of b, or -1, -1. */
void overlay_draw(const struct overlay *o, const struct overlay_target *target, const struct board *b, int mouse_x,
                  int mouse_y);

/* Draws the hitboxes of visible ships for the player: white, in a ring whose colour identifies the player. Clips them
 * to the field. */
void overlay_draw_hitboxes(const struct canvas *canvas, const struct board *b);

#endif
