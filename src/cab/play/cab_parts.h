/*
 * cab_parts.h - what the files of the cabinet share: cab.c (frame, power), cab_run.c (ticks, attract demos, moving in
 * time, reload), cab_practice.c (the practice menu), cab_show.c (the picture and what is over it), cab_window.c (the
 * window), cab_keys.c (switches).
 * floor: cab
 */
#ifndef CAB_CAB_PARTS_H
#define CAB_CAB_PARTS_H

#include "../overlay/prompt.h"
#include "cab.h"
#include "../host/config.h"
#include "../overlay/console.h"
#include "../host/folder.h"
#include "../host/pace.h"
#include "../picture/compose.h"
#include "../run/ahead.h"
#include "../run/guard.h"
#include "../overlay/overlay.h"
#include "practice.h"
#include "session.h"
#include "../host/speaker.h"

#ifdef __GNUC__
#define CAB_PRINTF(at, first) __attribute__((format(printf, at, first)))
#else
#define CAB_PRINTF(at, first)
#endif

enum {
    CAB_NAME = 96,
    CAB_NOTICE_FRAMES = 180 /* how long a notice is shown */
};

/* fb, rgb: the board's picture as it drew it. composed, composed_rgb: a copy with the overlay drawn on it. */
struct picture {
    struct fb fb, composed;
    void *memory;
    void *scratch;
    uint32_t rgb[256], composed_rgb[256];
    bool ahead; /* fb is the picture of the frame after the present one */
};

/* The window, and how the last picture was shown in it. */
struct cab_window {
    struct compose compose;
    struct border border; /* of the ROM; rgba NULL: it has none */
    uint8_t *border_rgba; /* malloc */
    bool border_read;
    uint32_t border_crc;     /* of the ROM it was read from */
    uint64_t handed;         /* usec: when the last picture was handed to the port */
    int refresh;             /* thousandths of a Hz at which showing a picture returns; 0: it does at once */
    bool composes;           /* this picture will be composed */
    bool cannot;             /* the port has no plat_paint, or there is no memory */
    bool composed;           /* the last one was */
    enum quarter shown_turn; /* if not, how it was turned */
    int w, h;                /* its size, not turned; 0: none was shown */
    uint8_t *turned;         /* malloc */
    size_t turned_room;
    struct fb side; /* beside the picture */
    void *side_memory;
    bool has_side;
};

/* The cabinet's state. It is one static struct because the host's own timer may call frame(), without a context. */
struct cab {
    struct cab_options options;
    struct board_start start;
    uint8_t *nvram; /* what start.nvram points to, if the cabinet loaded it; malloc */
    struct config config;
    struct plat_want want;
    char title[sizeof((struct manifest *)0)->title];
    struct session session;
    struct guard attract_guard; /* runs an attract demo */
    struct demo attract;
    bool attracting;
    struct speaker speaker;
    struct picture picture;
    struct cab_window window;
    struct pace pace;
    uint64_t frames; /* of the cabinet, since the beginning */
    struct ahead ahead;
    uint16_t last_pads[PADS]; /* of the last tick */
    bool ticked;              /* the live board did, in this frame */
    int since_save;           /* frames since nvram was last looked at */
    uint32_t nvram_saved;     /* board_nvram's count when it was last saved */
    bool no_scores;           /* the score file could not be read: it is left as it is */
    struct practice_menu practice;
    uint16_t pads[PADS];  /* held since the last tick */
    uint16_t stale[PADS]; /* held since the menu was open: the game does not get them */
    bool paused, step;
    bool rewinding;   /* time runs backwards */
    bool scrubbed;    /* the player moved in time in a playback: at its end it pauses and does not quit */
    bool quiet;       /* ticks are not heard: they are steps, or one of many */
    int slow;         /* 1, 2, 4: frames a tick */
    int slow_frames;  /* frames since the last tick */
    int timebar_left; /* frames that the time bar is still shown */
    bool mouse;       /* the mouse button was held at the last poll */
    int mouse_x, mouse_y;
    struct prompt prompt;
    struct overlay overlay;
    struct console console;
    struct folder folder;
    uint32_t differs; /* the value of session.differs that was last reported */
    int since_check;  /* frames since the folder was last looked at */
    bool reload_due;  /* the folder changed: reload in the next frame, once the picture says so */
    char notice[DEMO_PATH + 128];
    int notice_left;     /* frames; -1: until a reload works */
    bool fault_reported; /* of the fault that the board has now */
    bool quit;
    enum result result; /* of cab_play */
};
extern struct cab cab;

/* ---- cab.c ---- */

/* Loads the saved image for a start without nvram: malloc'ed, and start points to it. NULL where there is none or none
 * is wanted: a practice run starts with a blank one. */
uint8_t *cab_load_nvram(struct board_start *start);

/* Saves nvram if it has changed, in a live run that was neither rewound nor touched. */
void cab_save_nvram(void);

/* ---- cab_run.c ---- */

/* Writes a line to the log, cleaned of control characters. */
CAB_PRINTF(1, 2) void cab_say(const char *format, ...);

/* Shows a line over the picture for so many frames; -1: until a reload works. */
CAB_PRINTF(2, 3) void cab_notice(int frames, const char *format, ...);

/* Takes the result of a call that may write the recording. false: session.err goes to the log, and the exit code is
 * 3. */
void cab_check_recording(bool good);

/* The name the user typed for the game; the cart that runs, its board, and its fault or NULL. */
const char *cab_game(void);
const struct cart *cab_cart(void);
struct board *cab_live(void);
const struct board_fault *cab_fault(void);

/* Flags the recording: slow motion or steps were used. */
void cab_mark_assisted(void);

/* Finds a name "ID-N.what" that no file in the current folder has. */
void cab_free_name(char name[CAB_NAME], const char *what);

/* Writes to the log what scripts printed in the last tick. */
void cab_log_lines(const struct board_out *out);

/* Writes the board's fault to the log, once. */
void cab_report_fault(void);

/* The frame that was reached is heard, for a sixtieth. */
void cab_hear_once(enum speaker_way way);

/* Ends the attract demo. */
void cab_attract_end(void);

/* cab_tick runs one frame, of the attract demo if one is shown. cab_step does too, but repeats what is recorded if the
 * present is not the end of the recording. */
void cab_tick(void);
void cab_step(void);

/* Moves to a frame, or so many frames back, and shows the time bar. */
void cab_goto(uint32_t frame);
void cab_rewind(uint32_t frames);

/* Ends a playback: from here the player plays. */
void cab_take_over(void);

/* Reloads the game from its folder; reloads if files in the folder have changed; goes on with a seek or a reload
 * that is under way, until now + a slice of a frame. */
void cab_reload(void);
void cab_check_folder(void);
void cab_seek_or_reload(uint64_t now);

/* ---- cab_practice.c ---- */

uint64_t cab_seed_from_clock(void);

/* Handles the keys that open the menu and retry; runs a frame of the open menu, which reads player 1's pad while the
 * board stands still. */
void cab_practice_keys(const struct keys_read *k);
void cab_menu(const struct keys_read *k);

/* ---- cab_show.c ---- */

/* Looks a frame ahead if that is wanted, and goes back: between them everything is drawn. */
void cab_look_ahead(void);
void cab_look_back(void);

/* Allocates the pictures of a board. False: not enough memory. */
bool cab_picture_open(struct picture *p, const struct board *b);
void cab_picture_close(struct picture *p);

/* Draws the board that is to be seen; shows the picture with the overlay on it. */
void cab_picture_draw(struct picture *p);
void cab_picture_show(struct picture *p);

/* Is the time bar shown? It is while the player moves in time, and in a playback when the mouse is on it. */
bool cab_timebar_shown(void);

/* Saves the board's picture, without the overlay, under the first free number. */
void cab_screenshot(struct picture *p);

/* ---- cab_window.c ---- */

/* The rate of the speaker that is wanted: 0 for a game that is silent, and for one that starts muted. */
int cab_sound_rate(void);

/* Opens the window, or changes it, as cab.config and the game's manifest say: at any time. False: there is none. */
bool cab_open_window(void);
void cab_window_close(void);

/* To be called before a picture of w x h is shown: looks how large the window is. Afterwards cab_window_side is what
 * can be drawn on beside the picture, in its colours; NULL: there is no room, or it is not wanted. */
void cab_window_begin(int w, int h);
struct fb *cab_window_side(void);

/* Shows a picture; side: and what stands beside it. */
void cab_window_show(const struct fb *fb, const uint32_t rgb[256], bool side);

/* From what plat_input says to a pixel of the picture; -1, -1: none. */
void cab_window_mouse(int *x, int *y);

/* ---- cab_keys.c ---- */

/* Reads the switches and carries out the cabinet's own keys. */
void cab_poll(struct keys_read *k);

#endif
