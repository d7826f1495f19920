/*
 * cab_parts.h - what the files of the cabinet share: cab.c (frame, power), cab_run.c (ticks, attract demos, moving in
 * time, reload), cab_practice.c (the practice menu), cab_show.c (window and picture), cab_keys.c (switches).
 * floor: cab
 */
#ifndef CAB_CAB_PARTS_H
#define CAB_CAB_PARTS_H

#include "../overlay/prompt.h"
#include "cab.h"
#include "../host/config.h"
#include "../overlay/console.h"
#include "../host/folder.h"
#include "../run/guard.h"
#include "../overlay/overlay.h"
#include "practice.h"
#include "../screens/screen.h"
#include "session.h"
#include "../host/speaker.h"
#include "../store/replays.h"

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
};

/* What is known of the run that is on, and of its replay. */
struct cab_keep {
    uint32_t frames; /* of the recording at the last look */
    bool on;         /* a run is on, since frame `first` */
    uint32_t first;
    bool spare;                     /* user:resume/ID.demo is of this run */
    char stem[REPLAY_STEM];         /* of the replay of the run that was over last; "": none */
    struct card_row row[CARD_ROWS]; /* entered while the run was on */
    int rows;
};

/* A session that is not the game from its title on: a demo that the cabinet opened. */
struct cab_guest {
    struct demo *demo;            /* malloc; what the session plays, or began as */
    const struct cart *home;      /* the game's own ROM while the session runs an older one; else NULL */
    struct session_rom *home_rom; /* owns it; NULL: the caller of cab_play does */
    bool watching;                /* it is shown, or was until the player took over */
    bool resuming;                /* it is played again, to go on at its end */
    uint8_t *nvram;               /* the saved image when it was resumed; malloc */
    size_t nvram_size;
    bool same;        /* the run had just that image once, so it may be replaced by the run's */
    uint32_t changed; /* board_nvram's count at the last look */
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
    uint64_t base;        /* usec: when frame 0 was due */
    uint64_t frames;      /* counted from base: the next one that is due */
    int since_save;       /* frames since nvram was last looked at */
    uint32_t nvram_saved; /* board_nvram's count when it was last saved */
    bool no_scores;       /* the score file could not be read: it is left as it is */
    struct practice_menu practice;
    struct cab_keep keep;
    struct cab_guest guest;
    bool taken;   /* the player plays on from a playback: nothing of it is kept */
    bool waiting; /* paused until a button is pressed */
    struct screens screens;
    bool focus;           /* at the last poll */
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

/* Powers on from this start: what the player had chosen and seen of the run before is forgotten. */
void cab_powered(const struct board_start *start);

/* Loads the saved image for a start without nvram: malloc'ed, and start points to it. NULL where there is none or none
 * is wanted: a practice run starts with a blank one. */
uint8_t *cab_load_nvram(struct board_start *start);

/* Gives a start the settings' language, if the game has it. */
void cab_take_lang(struct board_start *start);

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

/* Picture, window and practice for another ROM in the session. */
void cab_fit_cart(void);
void cab_check_folder(void);
void cab_seek_or_reload(uint64_t now);

/* ---- cab_practice.c ---- */

uint64_t cab_seed_from_clock(void);

/* Handles the keys that open the menu and retry; runs a frame of the open menu, which reads player 1's pad while the
 * board stands still. */
void cab_practice_keys(const struct keys_read *k);
void cab_menu(const struct keys_read *k);

/* Opens the practice menu, if this run may be left for it. Begins the game anew, from its title. */
void cab_open_practice(void);
void cab_begin_anew(void);

/* A start of the game from its title, without nvram. */
void cab_home_start(struct board_start *start);

/* ---- cab_keep.c: replays of runs, and where a run was left ---- */

/* After each new tick of the session; before the session ends or the game is powered anew: a run that is on is kept. */
void cab_keep_tick(void);
void cab_keep_leave(void);

/* The file of the run that was left, and what becomes of it when another begins: it is kept as a replay. From now on
 * the present run is written there. */
void cab_resume_path(char path[CAB_NAME]);
void cab_keep_left(void);
void cab_keep_here(void);

/* The run that is on is found in the recording again: after a session was changed under way. */
void cab_keep_follow(void);

/* ---- cab_guest.c: demos that the cabinet opens ---- */

/* Shows a demo from a frame on. False, and a notice: it cannot be shown. What is on is left as by quitting. */
bool cab_watch(const char *path, uint32_t frame);

/* Back to the game, from its title; harmless when it is there. */
void cab_home(void);

/* Gives back the demo that was opened last, which no session plays any more; and the game's own ROM. */
void cab_guest_forget(void);
void cab_guest_close(void);

/* Goes on with the run that was left: plays it again up to there, and waits. False, and a notice: it cannot. */
bool cab_resume(void);

/* To be called when a seek is over. */
void cab_resume_arrived(void);

/* A run was left: what it was; false: none was. */
bool cab_was_left(struct card *c);

/* ---- cab_screens.c, screen_*.c: the cabinet's own screens ---- */

/* Is something on that leaving would throw away? */
bool cab_run_is_on(void);

/* Makes so what cab.config says; to be called after any change of it. */
void cab_apply_settings(void);

/* Writes the settings that differ from their file's into it; says so where it cannot. */
void cab_save_settings(void);

/* The game asks for a screen: only in a live run's new ticks. */
void cab_asked(enum board_ask what);

void cab_open_menu(void);
void cab_open_settings(void);
void cab_open_keys(void);
void cab_open_replays(void);
void cab_open_resume(void);

/* Switches of a frame for the screens, and for what opens them. True: the screens have them, the board stands. */
bool cab_screen_keys(const struct plat_input *in, const struct keys_read *k);

/* The line below a screen: what to press. */
void cab_screens_foot(char *text, size_t size);

/* ---- cab_show.c ---- */

/* Allocates the pictures of a board. False: not enough memory. */
bool cab_picture_open(struct picture *p, const struct board *b);
void cab_picture_close(struct picture *p);

/* The rate of the speaker that is wanted: 0 for a game that is silent, and for one that starts muted. */
int cab_sound_rate(void);

/* Opens the window, or changes it, as cab.want and the game's manifest say. False: there is none. */
bool cab_open_window(void);

/* Draws the board that is to be seen; shows the picture with the overlay on it. */
void cab_picture_draw(struct picture *p);
void cab_picture_show(struct picture *p);

/* Is the time bar shown? It is while the player moves in time, and in a playback when the mouse is on it. */
bool cab_timebar_shown(void);

/* Saves the board's picture, without the overlay, under the first free number. */
void cab_screenshot(const struct picture *p);

/* ---- cab_keys.c ---- */

/* Reads the switches and carries out the cabinet's own keys. */
void cab_poll(struct keys_read *k);

#endif
