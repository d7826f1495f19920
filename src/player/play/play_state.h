/*
 * play_state.h - the state of a window, one struct for each file that owns it, and the functions its files share.
 */
#ifndef PLAYER_PLAY_STATE_H
#define PLAYER_PLAY_STATE_H

#include "play.h"
#include "../settings/config.h"
#include "../../common/byte_buffer.h"
#include "../../common/files.h"
#include "folder.h"
#include "pace.h"
#include "practice.h"
#include "session.h"
#include "../input/pad_modes.h"
#include "../input/controllers.h"
#include "../overlay/console.h"
#include "../overlay/overlay.h"
#include "../overlay/prompt.h"
#include "../picture/compose.h"
#include "../picture/shade.h"
#include "../replays/replays.h"
#include "../replays/unsaved.h"
#include "../run/ahead.h"
#include "../run/guard.h"
#include "../screens/log.h"
#include "../screens/screen.h"
#include "../speaker/speaker.h"

enum {
    PLAY_NAME_SIZE = 96,       /* bytes of a file's name */
    PLAY_FULL_SPEED = 100,     /* percent; 60 ticks a second */
    MESSAGE_FRAMES = 180,      /* how long a message is shown */
    MESSAGE_STAYS = INT32_MAX, /* until another one replaces it */
    MESSAGE_UNTIL_RELOAD = -1, /* shown as a page until a reload works */
    PLAY_MAX_CODES = 16        /* codes that wait for their tick; further ones are dropped */
};

/* play.c: time in the game. */
struct play_time {
    uint64_t frames; /* of the window since it was opened */
    bool ticked;     /* the live board has ticked in this frame */
    bool paused, step;
    bool waits_for_button; /* the pause ends when a button is pressed */
    bool stopped;          /* the board does not tick in this frame, because a screen is open or was */
    bool rewinding;
    bool quiet; /* ticks make no sound: single steps, or turbo */
    int speed;  /* percent of full speed: 25 to 100 */
    int due;    /* percent of a tick that has passed since the last one */
};

/* play_tick.c: a second board, which shows an attract demo while the live one waits. */
struct attract {
    bool on;
    struct guard guard;
    struct demo demo;
};

/* play_seek.c: moving in time. */
struct play_seek {
    bool used;                      /* the player has moved in a playback: it pauses at its end instead of quitting */
    int bar_frames;                 /* for which the time bar is still shown */
    uint32_t reported_difference;   /* the value of session.differs that was reported last */
    char recording[PLAY_NAME_SIZE]; /* of a playback that was taken over, unless --record names one */
};

/* play_reload.c: changes in the game's folder. */
struct play_reload {
    struct folder folder;
    int frames_since_check;
    bool due; /* load in the next frame, when the picture shows the message */
};

/* play_nvram.c: the score file. */
struct play_nvram {
    uint8_t *image;       /* start.nvram, if it was loaded from the file; malloc */
    uint32_t saved_count; /* board_nvram's count when it was last saved */
    int frames_since_save;
    bool disabled; /* the file could not be read, so it is not written */
};

/* play_messages.c: the line over the picture. */
struct message {
    char text[FILES_PATH_SIZE + 256];
    int frames; /* for which it is still shown, or MESSAGE_UNTIL_RELOAD */
};

/* play_draw.c. fb, rgb: the board's picture, drawn with the view of the settings. composed, composed_rgb: a copy with
 * the overlay on it. */
struct picture {
    struct fb fb, composed;
    void *memory;
    void *scratch;
    uint32_t rgb[256], composed_rgb[256];
    struct shade_cache shades;
};

struct drawing {
    struct picture picture;
    struct ahead ahead;
    uint16_t last_pads[MAX_PLAYERS]; /* of the last tick */
    bool clip_due;                   /* write the clip in the next frame, when the picture shows the message */
};

/* play_window.c: the window, and how the last picture was shown in it. */
struct play_window {
    struct plat_config config;
    char title[sizeof((struct manifest *)0)->title];
    struct compose compose;
    struct border border; /* of the ROM; rgba NULL: it has none */
    uint8_t *border_rgba; /* malloc */
    bool border_read;
    uint32_t border_crc; /* of the ROM whose border was read */
    bool has_icon;
    uint32_t icon_crc;            /* of the ROM whose icon the window shows */
    uint64_t handed_over;         /* usec: when the last picture was passed to the port */
    int refresh;                  /* thousandths of a Hz at which showing a picture returns; 0: it returns at once */
    bool will_compose;            /* this picture will be composed */
    bool cannot_compose;          /* the port has no plat_paint, or there is no memory */
    bool composed;                /* the last picture was composed */
    enum rotation shown_rotation; /* of the last picture, if it was not composed */
    int w, h;                     /* of the last picture, before rotation; 0: none was shown */
    uint8_t *rotated;             /* the rotated picture; malloc */
    size_t rotated_size;
    struct fb side; /* the area next to the picture */
    void *side_memory;
    bool has_side;
};

/* play_wait.c: waiting for a change of the game's folder or of the settings file. */
struct waiting {
    bool on;
    bool settings; /* for the settings file */
    bool checking; /* it has changed; read it in the next frame, after the picture shows this */
    char why[FILES_ERR_SIZE + CONFIG_LINE], details[sizeof((struct board_fault *)0)->trace];
    int top, max_top; /* scroll position, and its maximum */
};

/* play_report.c: reports of faults. */
struct report {
    char where[FILES_PATH_SIZE]; /* the last report's path; "": none */
    uint32_t frame;              /* and the fault in it */
    char message[sizeof((struct board_fault *)0)->message];
    bool fault_reported;        /* of the board's present fault */
    int page_top, page_max_top; /* scroll position of the fault's page, and its maximum */
};

/* play_autosave.c: the run in progress, and the replay of the last run. */
struct autosave {
    uint32_t frames; /* of the recording at the last tick */
    bool on;         /* a run is in progress, since frame `first` */
    uint32_t first;
    struct thumb thumb;                          /* of a moment in the run; w 0: none yet */
    bool resumable;                              /* user:resume/ID.demo is of this run */
    char stem[REPLAY_STEM];                      /* the last run's replay; "": none, or it could not be written yet */
    struct replay_meta_row row[REPLAY_MAX_ROWS]; /* entered during the run */
    int rows;
    bool last_run_unsaved; /* it is the first of play_unsaved.runs */
};

/* A run whose replay could not be written yet. malloc, and so are its bytes. */
struct unsaved_run {
    struct unsaved_run *next;
    uint8_t *bytes;
    size_t size;
    struct replay_meta meta;
    struct thumb thumb;
};

/* play_autosave.c: what could not be written. It is tried again each minute, and when the window closes. */
struct play_unsaved {
    struct unsaved *files;
    struct unsaved_run *runs; /* the newest first */
    bool settings;
    bool resume_file;    /* user:resume/ID.demo of the run in progress */
    bool unfinished_run; /* user:resume/ID.demo is of an earlier run, whose replay could not be written yet */
    bool shown;          /* a message was shown, and something is still unsaved */
    int frames;          /* until the next try */
};

/* play_replay.c: a replay or an unfinished run that the window has opened. */
struct play_replay {
    struct demo *demo;            /* malloc; the session plays it, or started as its playback */
    const struct cart *home;      /* the game's current ROM while the session runs an older one; otherwise NULL */
    struct session_rom *home_rom; /* owns home; NULL: the caller of play_open does */
    bool watching;                /* a replay is shown, or was until the player took over */
    uint32_t first;               /* the frame from which it is shown */
    int hint_frames;              /* frames for which its hints are still shown: after its start and each press */
    bool taken_over;              /* the player continues from a playback: nothing is saved */
    bool resuming;                /* an unfinished run is replayed, to be continued at its end */
    uint8_t *nvram;               /* the saved image when the run was resumed; malloc */
    size_t nvram_size;
    bool same;        /* the run's image was identical to `nvram` once, so it may replace the saved image */
    uint32_t changed; /* board_nvram's count at the last comparison */
};

/* play_pads.c: controllers, and the players' pads. */
struct play_pads {
    uint16_t held[MAX_PLAYERS];    /* buttons held since the last tick, the input of pad_modes_tick */
    uint16_t ignored[MAX_PLAYERS]; /* held since a screen was open; the game does not see them */
    struct controllers controllers;
    struct pad_modes modes[MAX_PLAYERS];
    struct pad_mode_state mode_state[MAX_PLAYERS];
    uint32_t next_frame; /* the frame after the last tick with pads of pad_modes_tick */
    bool unplugged;      /* a player's controller was unplugged, and the game is paused for it */
    struct {
        uint8_t player, code; /* enum pad_code */
    } codes[PLAY_MAX_CODES];  /* sent to the game, one in each tick */
    int code_count;
};

/* play_typing.c: name entry by keyboard. */
struct play_typing {
    uint8_t hidden[PLAT_KEYS / 8]; /* keys used for typing, hidden from everything else until they are released */
    bool open, waits;              /* a name is typed; keys that were held before that are still held */
};

/* play_keys.c. */
struct play_mouse {
    bool held; /* the button, at the last poll */
    int x, y;
};

/* play_screens.c: a game dropped on the window. */
struct play_drop {
    char asked[FILES_PATH_SIZE];    /* while the player is asked */
    char accepted[FILES_PATH_SIZE]; /* is played after this game; "": none */
};

/* screen_keys.c: the key that the player is about to press. */
struct key_capture {
    bool listening;
    int action;
    struct keys_capture capture;
    bool started;   /* capture has seen the keys held before */
    uint16_t asked; /* the key to add after the question */
};

/* screen_replays.c, screen_replay.c. */
#define REPLAY_EXPORTS "user:exports" /* the folder of exported replays */

enum replay_sort { REPLAYS_BY_DATE, REPLAYS_BY_SCORE, REPLAYS_BY_FAVOURITE, REPLAY_SORTS };

enum replay_version {
    REPLAY_CURRENT,
    REPLAY_OLDER, /* recorded in an older version of the game, which is stored */
    REPLAY_LOST   /* recorded in an older version, which is not stored */
};

struct replay_list {
    struct replays list;
    struct replay_order {
        int64_t key;
        int i;
    } * order; /* the rows: replays of `list`, sorted; malloc */
    enum replay_sort sort;
    uint64_t rom, game; /* hashes of the game's current ROM */
    int chosen;         /* the replay that thumb and version are of; -1: none */
    struct thumb thumb;
    enum replay_version version;
    char (*file)[96]; /* names in REPLAY_EXPORTS; malloc */
    int files;
    char typed[REPLAY_NAME_SIZE];
    bool typing, fresh; /* fresh: the first letter replaces the proposed name */
    uint8_t held[PLAT_KEYS / 8];
    uint32_t buttons;
    char text[SCREEN_HELP];
    char watched[REPLAY_STEM]; /* the replay that was watched last */
};

/* screen_resume.c: the unfinished run. */
struct resume_offer {
    char text[SCREEN_HELP];
    bool possible; /* its ROM is stored, and this engine plays it identically */
    bool changed;  /* the game has changed since */
};

/* The sounds of screens: a jukebox of the game. */
struct screen_sound {
    void *block;         /* malloc; the jukebox is its 64-byte aligned part */
    struct board *board; /* NULL: not opened yet */
    struct rom rom;      /* that the jukebox was opened with */
    bool playing;
};

struct play {
    struct play_options options;
    struct config config, saved_config; /* in use; in the file, or about to be written */
    bool quit;
    enum result result; /* of play_close */

    /* the run */
    struct board_start start;
    struct session session;
    struct practice_menu practice;
    struct attract attract;
    struct play_time time;
    struct play_seek seek;
    struct play_reload reload;
    struct play_replay replay;

    /* files */
    struct play_nvram nvram;
    struct autosave autosave;
    struct play_unsaved unsaved;
    struct report report;

    /* input */
    struct play_pads pads;
    struct play_typing typing;
    struct play_mouse mouse;
    struct play_drop drop;
    bool had_focus; /* at the last poll */

    /* output */
    struct pace pace;
    struct speaker speaker;
    struct screen_sound screen_sound;
    struct play_window window;
    struct drawing drawing;
    struct message message;
    struct overlay overlay;
    struct console console;
    struct prompt prompt;
    struct waiting waiting;

    /* screens */
    struct screens screens;
    struct log log;
    struct key_capture key_capture;
    struct replay_list replay_list;
    struct resume_offer resume_offer;
    const char *settings_page;                          /* screen_settings.c: the open page of settings */
    char lang_before[sizeof((struct config *)0)->lang]; /* when the settings were opened */
    int large_hud_before;
    int32_t dips_before[MAX_DIPS];
    uint32_t controllers_held[PLAT_MAX_CONTROLLERS]; /* screen_controllers.c: buttons, also of unassigned ones */
};

/* ---- play.c ---- */

/* Powers the session on with the options and opens its window. On failure, returns false: either sets play->quit and
 * play->result and logs the reason, or the window waits for the folder. */
bool play_power_on(struct play *play);

/* Starts with the loaded settings: powers on, or waits for a folder. */
void play_start(struct play *play);

/* Changes the speed, in percent; a recording in progress is marked as assisted. */
void play_set_speed(struct play *play, int percent);

/* ---- play_wait.c ---- */

/* Shows why the game's folder can't be played, and waits for a change. Returns false if there is no window. */
bool play_wait_for_folder(struct play *play, const char *why, const char *more);

/* Shows why the settings can't be read, and waits until their file is fixed or the player accepts the defaults; then
 * calls play_start. Returns false if there is no window. */
bool play_wait_for_settings(struct play *play, const char *why);

void play_wait_frame(struct play *play);

/* ---- play_report.c ---- */

/* Logs the board's fault, if it has one, and writes its report; once for each fault. */
void play_report_fault(struct play *play);

/* ---- play_messages.c ---- */

/* Adds a line to the window's log. */
void play_log_add(struct play *play, enum log_kind kind, const char *line);

/* Writes a line to the port's log and to the window's, without control characters. */
void play_log(struct play *play, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Shows a line over the picture for this many frames. */
void play_show_message(struct play *play, int frames, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Shows a line over the picture, and logs it with "curtain: " before it. */
void play_warn(struct play *play, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Return the game's name as the user typed it; the running cart; its board; its fault, or NULL. */
const char *play_game_name(const struct play *play);
const struct cart *play_cart(const struct play *play);
struct board *play_board(const struct play *play);
const struct board_fault *play_fault(const struct play *play);

/* Returns the board that is shown and heard: the attract demo's, or the live one. */
struct board *play_shown_board(const struct play *play);

/* Writes the first unused name "ID-N.TYPE". where: "pictures:", or "" for the current directory. */
void play_unused_name(struct play *play, char name[PLAY_NAME_SIZE], const char *where, const char *type);

/* Logs what scripts printed in the last tick. */
void play_log_output(struct play *play);

/* Queues the sound of the present frame, with that of screens; slow: sixtieths that it lasts. */
void play_queue_sound(struct play *play, enum speaker_mode mode);

/* Queues the sound of screens alone, in frames in which no board ticks. */
void play_queue_screen_sound(struct play *play, int sixtieths);

/* Starts the sounds of the screens' last input. */
void play_start_screen_sounds(struct play *play);

/* Reports, once, that a playback differs from its recording. */
void play_report_difference(struct play *play);

/* Ends the attract demo, if one is shown. */
void attract_end(struct attract *a);

/* ---- play_nvram.c ---- */

/* Loads the saved image for a start without nvram, and lets start point to it. Returns the image, from malloc, or NULL
 * if there is none, or for a practice start, which has empty nvram. */
uint8_t *play_load_nvram(struct play *play, struct board_start *start);

/* Saves nvram if it has changed, in a live run that was neither rewound nor touched. */
void play_save_nvram(struct play *play);

/* Saves nvram, and flags the recording: slow motion or steps were used. From now on nvram is not saved. */
void play_mark_assisted(struct play *play);

/* ---- play_seek.c ---- */

/* Moves to a frame, or back by this many frames, and shows the time bar. */
void play_seek(struct play *play, uint32_t frame);
void play_rewind(struct play *play, uint32_t frames);

/* Ends a playback; the player continues from here. */
void play_take_over(struct play *play);

/* ---- play_reload.c ---- */

/* play_reload loads the game again. play_check_folder does so if files in its folder have changed. */
void play_reload(struct play *play);
void play_check_folder(struct play *play);

/* Adapts the picture, the window and practice to another ROM in the session. */
void play_apply_rom(struct play *play);

/* Continues a seek or a reload for a part of a frame that started at `now`. */
void play_continue_work(struct play *play, uint64_t now);

/* ---- play_tick.c ---- */

/* play_tick runs one frame, of the attract demo if one is shown. play_step does too, but replays recorded frames after
 * the present. */
void play_tick(struct play *play);
void play_step(struct play *play);

/* Returns whether a playback has reached its last frame. */
bool play_is_at_end(const struct play *play);

/* ---- play_practice.c ---- */

/* Resets the state of the previous run, when the board was powered on with this start. */
void play_reset_run(struct play *play, const struct board_start *start);

/* Sets what the settings decide in a start: the language, if it is not given and the game has it, and a larger HUD. */
void play_set_host_start(struct play *play, struct board_start *start);

/* Returns the value of the game's DIP switch i in the settings. */
int32_t play_dip_value(const struct play *play, int i);

uint64_t play_clock_seed(void);

/* play_practice_keys handles the keys for the menu and retry. play_practice_poll applies what was chosen in a frame of
 * the open menu. */
void play_practice_keys(struct play *play, const struct keys_state *k);
void play_practice_poll(struct play *play);

/* Powers the board on again with the same practice start. */
void play_retry_practice(struct play *play);

/* Opens the practice menu, if this run can be left for it. */
void play_open_practice(struct play *play);

/* Closes all screens and starts the game again at its title. of: the struct play, as for screens_ask. */
void play_restart(void *context);

/* Makes a start of the game at its title, without nvram. */
void play_title_start(struct play *play, struct board_start *start);

/* ---- play_autosave.c ---- */

/* Call it with the result of a call that may write the recording. On failure, logs session.err and sets exit code 3. */
void play_check_recording(struct play *play, bool good);

/* Returns whether the present run is long enough to be resumed, and is saved for that. */
bool play_is_resumable(const struct play *play);

/* Call autosave_tick after each new tick of the session, autosave_end before the session ends or the game is powered on
 * again: saves the run in progress. */
void play_autosave_tick(struct play *play);
void play_autosave_end(struct play *play);

/* Starts writing the present run to its resume file. */
void play_autosave_start(struct play *play);

/* Finds the run in progress in the recording, when the session was changed in the middle of a run. */
void play_autosave_sync(struct play *play);

/* play_resume_path writes the path of the resume file. play_archive_unfinished saves the unfinished run in it as a
 * replay; if that fails, the file stays until it succeeds. */
void play_resume_path(struct play *play, char path[PLAY_NAME_SIZE]);
void play_archive_unfinished(struct play *play);

/* Writes a file. If it can't be written yet, shows a message and returns false. */
bool play_save(struct play *play, const char *path, const void *bytes, size_t size);

/* Logs that something can't be written; shows one message until everything is saved. */
void play_save_failed(struct play *play, const char *err);

/* play_retry_saves, called in each frame, tries unsaved data again every minute. play_final_retry tries a last time,
 * and logs what is lost. */
void play_retry_saves(struct play *play);
void play_final_retry(struct play *play);

/* ---- play_replay.c ---- */

/* Shows a replay from a frame on, and ends the present run. If it can't be shown, shows a message and returns false. */
bool play_watch(struct play *play, const char *path, uint32_t frame);

enum { REPLAY_HINT_FRAMES = 240 };

/* Returns whether a replay from the list is shown. */
bool play_is_watching(const struct play *play);

/* Returns the game's current ROM, also while an older one runs. */
const struct cart *play_home_cart(const struct play *play);

/* Returns to the game's title. */
void play_return_to_title(struct play *play);

/* play_free_replay frees the last opened demo, which no session may play any more; play_close_replay also frees the
 * game's current ROM. */
void play_free_replay(struct play *play);
void play_close_replay(struct play *play);

/* Replays the unfinished run, then pauses. If that is impossible, shows a message and returns false. */
bool play_resume(struct play *play);

/* Call it when a seek has ended. */
void play_resume_finish(struct play *play);

/* Reads the unfinished run's metadata. Returns false if there is none. */
bool play_find_unfinished(struct play *play, struct replay_meta *c);

/* ---- play_screens.c, screen_*.c ---- */

/* Writes the changed settings to their file; shows a message if that fails. */
void play_save_settings(struct play *play);

/* Opens the screen that the game requests; does nothing except in a new tick of a live run. */
void play_open_requested(struct play *play, enum board_host_screen screen);

/* Returns whether the player would lose a run by leaving. */
bool play_has_run(const struct play *play);

/* Applies play->config; call it after any change. */
void play_apply_settings(struct play *play);

extern const struct screen_def keys_screen;
void play_open_menu(struct play *play);

/* Ends a replay and returns to the list of replays. context: the struct play, as for screens. */
void play_quit_replay(void *context);

/* Returns whether the game shows a page on which a button means Back; Escape presses it. */
bool play_page_leads_back(const struct play *play);

/* Quits; asks first if a run would be lost. */
void play_quit(struct play *play);

void play_open_settings(struct play *play);

/* Sets the language of the screens to that of the next start of the game. */
void play_translate_screens(struct play *play);
void play_open_keys(struct play *play);
void play_open_controllers(struct play *play);
void play_open_log(struct play *play);
void play_open_replays(struct play *play);

/* The actions on replay_list.chosen, and the question before it is deleted. */
extern const struct screen_def replay_screen;
void play_ask_to_delete_replay(struct play *play);

/* Call it when replay_list.list has changed. */
void replay_list_changed(struct play *play);

/* Writes a replay's name or, if it has none, the titles of its mission or stage and of its ship. */
void replay_list_title(struct play *play, const struct replay_meta *c, char *out, size_t size);

/* Imports a demo file, and shows whether that worked or why it didn't. */
void play_import_replay(struct play *play, const char *path);

/* Asks whether to resume the unfinished run, if there is one. */
void play_offer_resume(struct play *play);

/* Passes input to the screens, and to the keys that open them. Returns true if a screen is open or was: the board
 * doesn't tick, and the keys left in k->pressed are those that no screen used. */
bool play_screen_keys(struct play *play, const struct plat_input *in, struct keys_state *k);

/* Checks whether a game was dropped on the window; asks before a run is lost, and reports games that can't be
 * played. */
void play_check_drop(struct play *play);

/* ---- play_draw.c ---- */

/* Allocate the pictures of a board, or pictures of any size. Return false when out of memory. */
bool picture_open(struct picture *p, const struct board *b);
bool picture_alloc(struct picture *p, int w, int h);
void picture_close(struct picture *p);

/* If enabled, ticks the board a frame ahead, until ahead_end. */
void play_look_ahead(struct play *play);

/* play_draw draws the visible board. play_show shows the picture with the overlay on it. */
void play_draw(struct play *play, struct picture *p);
void play_show(struct play *play, struct picture *p);

/* Returns true while the player moves in time, and in a playback when the mouse is on the time bar. */
bool play_timebar_shown(const struct play *play);

/* Saves the board's picture in the user's pictures folder, without the overlay and unaffected by the settings. */
void play_screenshot(struct play *play, struct picture *p);

/* play_request_clip requests a GIF of the last seconds in the user's pictures folder. play_save_clip writes it before
 * the next frame, all at once. */
void play_request_clip(struct play *play);
void play_save_clip(struct play *play, struct picture *p);

/* ---- play_window.c ---- */

/* Returns the sample rate to open: 0 for a silent game, and for one that starts muted. */
int play_sound_rate(struct play *play);

/* Sets the fields of window.config that don't depend on the game. w, h: the picture. */
void play_window_configure(struct play *play, int w, int h, const char *title);

/* Opens or changes the window according to play->config and the game's manifest. Returns false if there is no window.
 * */
bool play_open_window(struct play *play);

/* Changes the window; quits if that fails. */
void play_update_window(struct play *play);

void play_toggle_fullscreen(struct play *play);

/* Turns text input of the window on or off. */
void play_set_text_input(struct play *play, bool on);

void play_window_close(struct play_window *w);

/* Call play_window_begin before a picture of w x h is shown: gets the window's size. play_window_side then returns the
 * area next to the picture, with the picture's palette; NULL: there is no space, or it is disabled. */
void play_window_begin(struct play *play, int w, int h);
struct fb *play_window_side(struct play_window *w);

/* Shows a picture, and the area next to it if `side` is set. */
void play_window_show(struct play *play, const struct fb *fb, const uint32_t rgb[256], bool side);

/* Converts a position of plat_input to a pixel of the picture; -1, -1: none. */
void play_window_mouse(const struct play_window *w, int *x, int *y);

/* ---- play_keys.c ---- */

/* Scrolls a page with a pad's up and down, and with the mouse wheel. */
void play_scroll(const struct play *play, int *top, int end, uint16_t pad, int wheel);

/* Reads the input and handles the program's keys. */
void play_poll(struct play *play, struct keys_state *k);

/* ---- play_typing.c ---- */

/* Returns the player (from 0) who enters a name and has the keyboard, or -1. */
int play_typist(const struct play *play);

/* While a player enters a name, sends the typed characters, Backspace and Enter as codes, and hides their keys in *in.
 * Call it before keys_read. */
void play_type_name(struct play *play, struct plat_input *in);

/* ---- play_pads.c ---- */

void play_pads_open(struct play *play);

/* Applies each player's settings for autofire, focus and one-handed play. */
void play_pads_apply(struct play *play);

/* Call it when the board was powered on. */
void play_pads_power(struct play_pads *pads);

/* Sends a code (enum pad_code) to the game of a player (from 0) in the next tick, or in a later one if other codes
 * are waiting. */
void play_send_code(struct play *play, int player, unsigned code);

/* Computes the pads of the live board's next tick from pads.held and the waiting codes. */
void play_pads_tick(struct play *play, uint16_t pads[MAX_PLAYERS]);

/* Call play_poll_controllers before keys_read, and play_report_controllers after it. The first updates the assignment
 * of controllers to players. The second shows changes, pauses when a controller in use is unplugged, and resumes at
 * START. */
void play_poll_controllers(struct play *play, const struct plat_input *in);
void play_report_controllers(struct play *play, const struct keys_state *k);

/* Returns the controller's own name, or its kind. */
const char *play_controller_name(const struct plat_controller *c);

#endif
