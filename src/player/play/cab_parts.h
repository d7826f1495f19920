/*
 * cab_parts.h - what the files of the cabinet share: cab.c (frame, power), cab_run.c (ticks, attract demos, moving in
 * time, reload), cab_practice.c (the practice menu), cab_show.c (the picture and what is over it), cab_window.c (the
 * window), cab_screens.c and screen_*.c (the cabinet's screens), cab_keys.c (switches), cab_pads.c (controllers, and
 * how players press).
 */
#ifndef PLAYER_CAB_PARTS_H
#define PLAYER_CAB_PARTS_H

#include "../overlay/prompt.h"
#include "cab.h"
#include "../settings/config.h"
#include "../../common/byte_buffer.h"
#include "../../common/files.h"
#include "../overlay/console.h"
#include "folder.h"
#include "pace.h"
#include "../picture/compose.h"
#include "../run/ahead.h"
#include "../run/guard.h"
#include "../overlay/overlay.h"
#include "../picture/shade.h"
#include "../input/press.h"
#include "../input/seats.h"
#include "practice.h"
#include "../screens/log.h"
#include "../screens/screen.h"
#include "../screens/screen_state.h"
#include "session.h"
#include "../speaker/speaker.h"
#include "../replays/replays.h"
#include "../replays/unsaved.h"

#ifdef __GNUC__
#define CAB_PRINTF(at, first) __attribute__((format(printf, at, first)))
#else
#define CAB_PRINTF(at, first)
#endif

enum {
    CAB_NAME = 96,
    CAB_NOTICE_STAYS = INT32_MAX, /* until it is taken away */
    CAB_NOTICE_FRAMES = 180       /* how long a notice is shown */
};

/* fb, rgb: the board's picture as it drew it, by the view of the settings. composed, composed_rgb: a copy with the
 * overlay drawn on it. */
struct picture {
    struct fb fb, composed;
    void *memory;
    void *scratch;
    uint32_t rgb[256], composed_rgb[256];
    struct shade_kept shades;
    bool ahead; /* fb is the picture of the frame after the present one */
};

/* The window, and how the last picture was shown in it. */
struct cab_window {
    struct compose compose;
    struct border border; /* of the ROM; rgba NULL: it has none */
    uint8_t *border_rgba; /* malloc */
    bool border_read;
    uint32_t border_crc; /* of the ROM it was read from */
    bool has_icon;
    uint32_t icon_crc;       /* the same, of the one the window has */
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

/* A folder, or the settings' file, that is waited for. */
struct waiting {
    bool on;
    bool settings; /* it is their file */
    bool looks;    /* it has changed: it is read in the next frame, once the picture says so */
    char why[FILES_ERR_SIZE + CONFIG_LINE], more[sizeof((struct board_fault *)0)->trace];
    int top, most; /* lines scrolled, and the most */
};

/* What a report is made of. */
struct report {
    char known[4096]; /* lines that are written before there is anything to report */
    size_t n;
    char stem[128];  /* the name, without its number */
    uint8_t *memory; /* of demo_dump; NULL: reports are without a demo */
    size_t size;
    struct byte_buffer text;     /* of a fault's report */
    char where[FILES_PATH_SIZE]; /* the path of the last one; "": none */
    uint32_t frame;              /* and what it was of */
    char message[sizeof((struct board_fault *)0)->message];
};

/* What is known of the run that is on, and of its replay. */
struct cab_keep {
    uint32_t frames; /* of the recording at the last look */
    bool on;         /* a run is on, since frame `first` */
    uint32_t first;
    bool spare;             /* user:resume/ID.demo is of this run */
    char stem[REPLAY_STEM]; /* of the replay of the run that was over last; "": none, or it waits */
    struct replay_meta_row row[REPLAY_MAX_ROWS]; /* entered while the run was on */
    int rows;
    bool waits; /* the run that was over last is the first of cab_unsaved.runs */
};

/* A run of which no replay could be written yet. malloc, and so are its bytes. */
struct cab_run {
    struct cab_run *next;
    uint8_t *bytes;
    size_t size;
    struct replay_meta meta;
    struct thumb thumb;
};

/* What could not be written: it is tried again each minute, and when the cabinet closes. */
struct cab_unsaved {
    struct unsaved *files;
    struct cab_run *runs; /* the newest first */
    bool settings;
    bool spare;    /* user:resume/ID.demo of the run that is on */
    bool left_run; /* user:resume/ID.demo is of a run of which no replay could be written yet */
    bool shown;    /* the player was told, and something still waits */
    int wait;      /* frames until it is tried again */
};

/* A session that is not the game from its title on: a demo that the cabinet opened. */
struct cab_guest {
    struct demo *demo;            /* malloc; what the session plays, or began as */
    const struct cart *home;      /* the game's own ROM while the session runs an older one; else NULL */
    struct session_rom *home_rom; /* owns it; NULL: the caller of cab_open does */
    bool watching;                /* it is shown, or was until the player took over */
    bool resuming;                /* it is played again, to go on at its end */
    uint8_t *nvram;               /* the saved image when it was resumed; malloc */
    size_t nvram_size;
    bool same;        /* the run had just that image once, so it may be replaced by the run's */
    uint32_t changed; /* board_nvram's count at the last look */
};

/* A cabinet. All that it knows is here, so there may be several, each called by its host from frame to frame. */
struct cab {
    struct cab_options options;
    struct board_start start;
    uint8_t *nvram;             /* what start.nvram points to, if the cabinet loaded it; malloc */
    struct config config, kept; /* as it is now; as it is in the file, or goes there */
    struct plat_config want;
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
    uint16_t last_pads[MAX_PLAYERS]; /* of the last tick */
    bool ticked;                     /* the live board did, in this frame */
    int since_save;                  /* frames since nvram was last looked at */
    uint32_t nvram_saved;            /* board_nvram's count when it was last saved */
    struct waiting waiting;
    struct report report;
    int fault_top, fault_most; /* lines of a fault's page that are scrolled, and the most */
    bool no_scores;            /* the score file could not be read: it is left as it is */
    struct practice_menu practice;
    struct cab_keep keep;
    struct cab_unsaved unsaved;
    struct cab_guest guest;
    bool taken;  /* the player plays on from a playback: nothing of it is kept */
    bool awaits; /* paused until a button is pressed */
    struct screens screens;
    struct log log;
    struct keys_wait wait;
    struct replays_view view;
    struct resume_left left;
    struct settings_list list;
    /* At the last poll of the screen of controllers, also what no player gets. */
    uint32_t pressed[PLAT_MAX_CONTROLLERS];
    bool stands;                 /* the board does in this frame, for a screen is open or was */
    bool here;                   /* at the last poll the window had the keys, and was seen */
    uint16_t pads[MAX_PLAYERS];  /* buttons held since the last tick, before press */
    uint16_t stale[MAX_PLAYERS]; /* held since the menu was open: the game does not get them */
    struct seats seats;
    struct press_modes modes[MAX_PLAYERS];
    struct press press[MAX_PLAYERS];
    uint32_t pressed_to; /* the frame after the last tick that got pads of press */
    bool unplugged;      /* a player's controller is gone, and the game pauses for it */
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
    bool film_due;    /* the last seconds are filmed in the next frame, once the picture says so */
    bool reload_due;  /* the folder changed: reload in the next frame, once the picture says so */
    char notice[FILES_PATH_SIZE + 256];
    int notice_left;     /* frames; -1: until a reload works */
    bool fault_reported; /* of the fault that the board has now */
    bool quit;
    char asked[FILES_PATH_SIZE];   /* the game that was dropped, while it is asked whether it is to be played */
    char took[CAB_NAME];           /* the recording of a playback that was taken over, if it was given no name */
    char dropped[FILES_PATH_SIZE]; /* what is played next, once this has ended; "": nothing */
    enum result result;            /* of cab_close */
};

/* ---- cab.c ---- */

/* Powers the session with cab->options and opens its window. False: it cannot be, a line has said why, and cab->result
 * tells; or it is waited for. */
bool cab_power(struct cab *cab);

/* Begins with the settings there are: powers on, or waits for a folder. */
void cab_begin(struct cab *cab);

/* ---- cab_screens.c ---- */

/* Looks whether a game was dropped on the window: asks if that would end a run, and says what cannot be played. */
void cab_drop(struct cab *cab);

/* ---- cab_wait.c ---- */

/* Shows why the game's folder cannot be played, and waits for a change of it. False: there is no window. */
bool cab_wait(struct cab *cab, const char *why, const char *more);

/* Shows why the settings cannot be read, and waits for a change of their file, or for a word to do without it; then
 * cab_begin. False: there is no window. */
bool cab_wait_settings(struct cab *cab, const char *why);

/* A frame of either. */
void cab_wait_frame(struct cab *cab);

/* ---- cab_report.c ---- */

/* Makes ready what a crash would leave: to be called when a board was powered, and when settings changed. */
void cab_report_ready(struct cab *cab);

/* Writes the board's fault to the log, and a report of it to a file; once for each fault. */
void cab_report_fault(struct cab *cab);

/* Tells, once, of a crash that ended Curtain when it last ran. */
void cab_report_last_crash(struct cab *cab);

/* A crash from here on is this cabinet's: to be called in each frame, for there may be others. */
void cab_report_arm(struct cab *cab);

void cab_report_close(struct cab *cab);

/* ---- cab_state.c ---- */

/* Adds a line to the window's log, which stores the frame with it. */
void cab_note(struct cab *cab, enum log_kind kind, const char *line);

/* Writes a line to the port's log and to that of the window, cleaned of control characters. */
CAB_PRINTF(2, 3) void cab_say(struct cab *cab, const char *format, ...);

/* Shows a line over the picture for so many frames; -1: until a reload works. */
CAB_PRINTF(3, 4) void cab_notice(struct cab *cab, int frames, const char *format, ...);

/* The name the user typed for the game; the cart that runs, its board, and its fault or NULL. */
const char *cab_game(const struct cab *cab);
const struct cart *cab_cart(const struct cab *cab);
struct board *cab_live(const struct cab *cab);
const struct board_fault *cab_fault(const struct cab *cab);

/* Finds a name "ID-N.what" that no file of a folder has: where is what stands before it, "pictures:", or "" for the
 * current one. */
void cab_free_name(struct cab *cab, char name[CAB_NAME], const char *where, const char *what);

/* Writes to the log what scripts printed in the last tick. */
void cab_log_lines(struct cab *cab, const struct board_out *out);

/* The frame that was reached is heard, for a sixtieth. */
void cab_hear_once(struct cab *cab, enum speaker_way way);

/* Ends the attract demo. */
void cab_attract_end(struct cab *cab);

/* ---- cab_nvram.c ---- */

/* Loads the saved image for a start without nvram: malloc'ed, and start points to it. NULL where there is none or none
 * is wanted: a practice run starts with a blank one. */
uint8_t *cab_load_nvram(struct cab *cab, struct board_start *start);

/* Saves nvram if it has changed, in a live run that was neither rewound nor touched. */
void cab_save_nvram(struct cab *cab);

/* Flags the recording: slow motion or steps were used. What was reached until now is saved, and nothing after it. */
void cab_mark_assisted(struct cab *cab);

/* ---- cab_seek.c ---- */

/* Moves to a frame, or so many frames back, and shows the time bar. */
void cab_goto(struct cab *cab, uint32_t frame);
void cab_rewind(struct cab *cab, uint32_t frames);

/* Ends a playback: from here the player plays. */
void cab_take_over(struct cab *cab);

/* Reloads the game from its folder. Reports that a reload failed. Reloads if files in the folder have changed. */
void cab_reload(struct cab *cab);
void cab_reload_failed(struct cab *cab);
void cab_check_folder(struct cab *cab);

/* Fits the picture, the window and practice to another ROM in the session. */
void cab_fit_cart(struct cab *cab);

/* ---- cab_run.c ---- */

/* cab_tick runs one frame, of the attract demo if one is shown. cab_step does too, but repeats what is recorded if the
 * present is not the end of the recording. */
void cab_tick(struct cab *cab);
void cab_step(struct cab *cab);

/* Continues a seek or a reload until `now` plus a part of a frame. */
void cab_seek_or_reload(struct cab *cab, uint64_t now);

/* ---- cab_practice.c ---- */

/* Powers on from this start: what the player had chosen and seen of the run before is forgotten. */
void cab_powered(struct cab *cab, const struct board_start *start);

/* Gives a start the settings' language, if the game has it. */
void cab_take_lang(struct cab *cab, struct board_start *start);

uint64_t cab_seed_from_clock(void);

/* Handles the keys that open the menu and retry; does what was chosen in a frame of the open menu. */
void cab_practice_keys(struct cab *cab, const struct keys_read *k);
void cab_practice_screen(struct cab *cab);

/* Opens the practice menu, if this run may be left for it. Begins the game anew, from its title. */
void cab_open_practice(struct cab *cab);
void cab_begin_anew(struct cab *cab);

/* A start of the game from its title, without nvram. */
void cab_home_start(struct cab *cab, struct board_start *start);

/* ---- cab_keep.c: replays of runs, and where a run was left ---- */

/* Takes the result of a call that may write the recording. false: session.err goes to the log, and the exit code is
 * 3. */
void cab_check_recording(struct cab *cab, bool good);

/* After each new tick of the session; before the session ends or the game is powered anew: a run that is on is kept. */
void cab_keep_tick(struct cab *cab);
void cab_keep_leave(struct cab *cab);

/* The file of the run that was left, and what becomes of it when another begins: it is kept as a replay. If it cannot
 * be, it stays where it is, until it can. From now on the present run is written there. */
void cab_resume_path(struct cab *cab, char path[CAB_NAME]);
void cab_keep_left(struct cab *cab);
void cab_keep_here(struct cab *cab);

/* Writes a file; one that cannot be written waits, and the player is told. */
bool cab_save(struct cab *cab, const char *path, const void *bytes, size_t size);

/* Something of the player's cannot be written: a line of the log, and once a notice in plain words. */
void cab_save_failed(struct cab *cab, const char *err);

/* In each frame: tries what waits, each minute. In the end: tries it once more, and says what is lost. */
void cab_retry(struct cab *cab);
void cab_retry_last(struct cab *cab);

/* The run that is on is found in the recording again: after a session was changed under way. */
void cab_keep_follow(struct cab *cab);

/* ---- cab_guest.c: demos that the cabinet opens ---- */

/* Shows a demo from a frame on. False, and a notice: it cannot be shown. What is on is left as by quitting. */
bool cab_watch(struct cab *cab, const char *path, uint32_t frame);

/* Back to the game, from its title; harmless when it is there. */
void cab_home(struct cab *cab);

/* Gives back the demo that was opened last, which no session plays any more; and the game's own ROM. */
void cab_guest_forget(struct cab *cab);
void cab_guest_close(struct cab *cab);

/* Goes on with the run that was left: plays it again up to there, and waits. False, and a notice: it cannot. */
bool cab_resume(struct cab *cab);

/* To be called when a seek is over. */
void cab_resume_arrived(struct cab *cab);

/* A run was left: what it was; false: none was. */
bool cab_was_left(struct cab *cab, struct replay_meta *c);

/* ---- cab_screens.c, screen_*.c: the cabinet's own screens ---- */

/* Writes the settings that differ from their file's into it; says so where it cannot. */
void cab_save_settings(struct cab *cab);

/* The game asks for a screen: only in a live run's new ticks. */
void cab_asked(struct cab *cab, enum board_host_screen what);

/* Is something on that leaving would throw away? */
bool cab_run_is_on(const struct cab *cab);

/* Makes so what cab->config says; to be called after any change of it. */
void cab_apply_settings(struct cab *cab);

void cab_open_menu(struct cab *cab);
void cab_open_settings(struct cab *cab);
extern const struct screen_def keys_screen;
void cab_open_keys(struct cab *cab);
void cab_open_controllers(struct cab *cab);
void cab_open_log(struct cab *cab);
void cab_open_replays(struct cab *cab);
void cab_open_resume(struct cab *cab);

/* Switches of a frame for the screens, and for what opens them. True: the screens have them, the board stands, and what
 * is left in k->pressed are the cabinet's keys that none of them took. */
bool cab_screen_keys(struct cab *cab, const struct plat_input *in, struct keys_read *k);

/* ---- cab_show.c ---- */

/* Looks a frame ahead if that is wanted, and goes back: between them everything is drawn. */
void cab_look_ahead(struct cab *cab);
void cab_look_back(struct cab *cab);

/* Allocates the pictures of a board, or pictures of a size that no board draws. False: not enough memory. */
bool cab_picture_open(struct picture *p, const struct board *b);
bool cab_picture_alloc(struct picture *p, int w, int h);
void cab_picture_close(struct picture *p);

/* Draws the board that is to be seen; shows the picture with the overlay on it. */
void cab_picture_draw(struct cab *cab, struct picture *p);
void cab_picture_show(struct cab *cab, struct picture *p);

/* Is the time bar shown? It is while the player moves in time, and in a playback when the mouse is on it. */
bool cab_timebar_shown(const struct cab *cab);

/* The line below a screen: what to press. */
void cab_screens_foot(struct cab *cab, char *text, size_t size);

/* Saves the board's picture, without the overlay and as no view changes it, in the user's pictures under the first free
 * number, and says where. */
void cab_screenshot(struct cab *cab, struct picture *p);

/* The last seconds of the play are wanted as a GIF in the user's pictures; and, before the next frame, made one, in one
 * go: nothing of the run is another for it. */
void cab_film_ask(struct cab *cab);
void cab_film(struct cab *cab, struct picture *p);

/* ---- cab_window.c ---- */

/* The rate of the speaker that is wanted: 0 for a game that is silent, and for one that starts muted. */
int cab_sound_rate(struct cab *cab);

/* Opens the window, or changes it, as cab->config and the game's manifest say: at any time. False: there is none. */
bool cab_open_window(struct cab *cab);
void cab_window_close(struct cab *cab);

/* To be called before a picture of w x h is shown: looks how large the window is. Afterwards cab_window_side is what
 * can be drawn on beside the picture, in its colours; NULL: there is no room, or it is not wanted. */
void cab_window_begin(struct cab *cab, int w, int h);
struct fb *cab_window_side(struct cab *cab);

/* Shows a picture; side: and what stands beside it. */
void cab_window_show(struct cab *cab, const struct fb *fb, const uint32_t rgb[256], bool side);

/* From what plat_input says to a pixel of the picture; -1, -1: none. */
void cab_window_mouse(struct cab *cab, int *x, int *y);

/* ---- cab_keys.c ---- */

/* Scrolls a page by up and down of a pad, and by the mouse's wheel. */
void cab_scroll(struct cab *cab, int *top, int most, uint16_t pad, int wheel);

/* Reads the switches and carries out the cabinet's own keys. */
void cab_poll(struct cab *cab, struct keys_read *k);

/* ---- cab_pads.c ---- */

void cab_pads_open(struct cab *cab);

/* Takes over the settings of how each player presses; at any time. */
void cab_pads_apply(struct cab *cab);

/* The board was powered anew. */
void cab_pads_power(struct cab *cab);

/* The pads of the live board's next tick, from cab->pads. */
void cab_pads_tick(struct cab *cab, uint16_t pads[MAX_PLAYERS]);

/* Before keys_read: what is plugged in, and who plays with it. After it: tells of what changed, pauses for a player
 * whose controller is gone, and goes on at START. */
void cab_seats_poll(struct cab *cab, const struct plat_input *in);
void cab_seats_told(struct cab *cab, const struct keys_read *k);

/* Its own name, or what kind it is. */
const char *cab_controller_name(const struct plat_controller *c);

#endif
