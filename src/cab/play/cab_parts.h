/*
 * cab_parts.h - the cabinet's insides, shared by its files: cab.c (the frame, power), cab_run.c (the session's ticks, attract,
 * to and fro in time, reload), cab_practice.c, cab_show.c (window and picture), cab_keys.c (switches).
 * floor: cab    used by: cab.c cab_*.c
 */
#ifndef CAB_CAB_PARTS_H
#define CAB_CAB_PARTS_H

#include "../overlay/ask.h"
#include "cab.h"
#include "../host/config.h"
#include "../overlay/console.h"
#include "../host/folder.h"
#include "../run/guard.h"
#include "../overlay/overlay.h"
#include "practice.h"
#include "session.h"
#include "../host/speaker.h"

enum {
    CAB_NAME = 96,
    CAB_SAYS = 180 /* frames a notice stands */
};

/* What is on the screen: the board's picture, untouched, and a copy with our words on it. */
struct picture {
    struct fb fb, over;
    void *memory;
    void *scratch;
    uint32_t rgb[256], over_rgb[256];
};

/* All of it. frame() may be called by the host's own timer, hence one for all. */
struct cab {
    struct cab_options options;
    struct board_start start;
    uint8_t *nvram; /* what start.nvram points to, if we loaded it */
    struct config config;
    struct plat_want want;
    char title[sizeof((struct manifest *)0)->title];
    struct session session;
    struct guard shown; /* of an attract demo */
    struct demo attract;
    bool attracting;
    struct speaker speaker;
    struct picture picture;
    uint64_t base;        /* frames are due from here */
    uint64_t frames;      /* since base */
    int since_save;       /* frames since nvram was last looked at */
    uint32_t nvram_saved; /* board_nvram's count when it was last saved */
    bool no_scores;       /* the score file could not be read: it is left as it is */
    struct practice_menu practice;
    uint16_t pads[PADS];  /* held since the last tick */
    uint16_t stale[PADS]; /* held since the menu was open: not meant for the game */
    bool paused, step;
    bool rewinding; /* time runs backwards */
    bool scrubbed;  /* somebody went to and fro in a playback: it waits at its end */
    bool quiet;     /* not at full speed: no sound */
    int slow;       /* 1, 2, 4: frames a tick */
    int waited;     /* frames since the last tick */
    int bar;        /* frames the bar of time is still shown */
    bool mouse;     /* its button was held at the last poll */
    int mouse_x, mouse_y;
    struct ask ask;
    struct overlay overlay;
    struct console console;
    struct folder folder;
    uint32_t differs; /* what was told of session.differs */
    int since_look;
    bool taking_in; /* something has: once the picture says so */
    char notice[DEMO_PATH + 128];
    int notice_left; /* frames; -1: until it is put right */
    bool told;       /* the fault that stands in the board */
    bool quit;
    enum result result; /* of cab_play */
};
extern struct cab cab;

/* ---- cab.c ---- */

/* The saved image for a start that has none of its own: malloc'ed, and start points to it. A practice start has a blank
 * one. NULL: none. */
uint8_t *cab_load_nvram(struct board_start *start);

/* Saves nvram if it has changed, of a live run that nobody tampered with. */
void cab_save_nvram(void);

/* ---- cab_run.c ---- */

/* A line for the log: format has two %s. */
void cab_say(const char *format, const char *a, const char *b);

/* A line over the picture for so many frames; -1: until it is put right. */
void cab_notice(const char *text, int frames);

/* After what may write a demo: with false, what the session said goes to the log. */
void cab_wrote(bool good);

/* What the user calls the game; the ROM that runs, its board, and its fault or NULL. */
const char *cab_game(void);
const struct cart *cab_cart(void);
struct board *cab_live(void);
const struct board_fault *cab_fault(void);

/* Slow motion or steps were used. */
void cab_assisted(void);

/* A name "ID-N.what" in the current folder that is free. */
void cab_free_name(char name[CAB_NAME], const char *what);

/* What scripts printed in the last tick. */
void cab_log_lines(const struct board_out *out);

/* The board has a fault: told once. */
void cab_halt(void);

/* The demo that is shown ends. */
void cab_attract_end(void);

/* One frame on, of the attract demo if one is shown; a single step, which is as it was, if it was. */
void cab_tick(void);
void cab_step(void);

/* To another frame, or so many back; the bar of time shows where that is. */
void cab_go(uint32_t frame);
void cab_go_back(uint32_t frames);

/* The player plays on in a playback. */
void cab_take_over(void);

/* Takes in what changed in the game's folder; looks whether something has; a piece of a long way of the session's. */
void cab_reload(void);
void cab_look_for_changes(void);
void cab_work(uint64_t now);

/* ---- cab_practice.c ---- */

uint64_t cab_seed_from_clock(void);

/* The keys that open the menu and try again; a frame of the open menu, which has player 1's pad while the board stands
 * still. */
void cab_practice_keys(const struct keys_read *k);
void cab_menu(const struct keys_read *k);

/* ---- cab_show.c ---- */

/* Memory for the pictures of a board; false: not enough. */
bool cab_picture_open(struct picture *p, const struct board *b);
void cab_picture_close(struct picture *p);

/* The window as cab.want and the game's manifest say. False: there is none. */
bool cab_open_window(void);

/* Draws the board that is to be seen; shows it, with all that stands over it. */
void cab_picture_draw(struct picture *p);
void cab_picture_show(struct picture *p);

/* Shown where time is gone to and fro, and in a playback under the mouse. */
bool cab_bar_shown(void);

/* The board's picture without our words, under the first free number. */
void cab_screenshot(const struct picture *p);

/* ---- cab_keys.c ---- */

/* Reads the switches and does what the cabinet's own say. */
void cab_poll(struct keys_read *k);

#endif
