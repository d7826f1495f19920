/*
 * session.h - a run without a window: board, recording, history, and moving in time.
 *
 * All input to the board is recorded, at least in memory, so any frame of the run can be restored and the whole run can
 * be repeated on a changed ROM. A run is live, or it plays back a demo until the player takes over. Going back in a
 * live run and then playing starts a branch: the frames after that point are dropped, and the demo is flagged.
 *
 * Seeking far ahead in a demo and repeating the run on a changed ROM take long. session_work does them in slices, one
 * per picture.
 */
#ifndef PLAYER_SESSION_H
#define PLAYER_SESSION_H

#include "../../demo/demo.h"
#include "../run/guard.h"
#include "../game/rom_image.h"

/* A ROM that the session owns, loaded by a reload. */
struct session_rom {
    struct rom_image image;
    struct cart cart;
};

/* Loads a .rom file or packs a folder. On failure, returns NULL and sets err. */
struct session_rom *session_rom_load(rom_loader *load, const char *path, bool nearest, char *err, size_t err_size);
void session_rom_free(struct session_rom *r);

struct session_run {
    const struct cart *cart;
    struct session_rom *rom; /* owns cart; NULL: the caller owns it */
    struct guard guard;
    struct demo_writer writer; /* writer.demo: the whole run; after going back it has frames after the board's */
};

enum session_state {
    SESSION_PLAYING,  /* no seek and no reload is in progress */
    SESSION_SEEKING,  /* ticks to a frame ahead */
    SESSION_RELOADING /* repeats the run on a changed ROM */
};

struct session {
    struct board_start start;
    const struct demo *demo;        /* played back; NULL: live */
    const char *record;             /* NULL: in memory only */
    struct session_run *now, *next; /* next: the run on the new ROM; it will replace now */
    enum session_state state;
    uint32_t from, to; /* frames of the seek or reload */
    uint32_t differs;  /* the first frame of a playback that differs from its recording; 0: none */
    bool rewound;      /* a live run went back once: its scores no longer count */
    void (*ticked)(void *context, const struct session *s); /* called after each tick of the board; may be NULL */
    void *context;
    char missing_music[64];        /* the music that was playing and is missing after a reload; "" */
    char err[DEMO_PATH_SIZE + 64]; /* one sentence, from the last session_* call that failed */
};

/* Powers the board on and starts recording. start is the demo's if there is one; cart, start.nvram, demo and record
 * must outlive the session. If the ROM cannot run, sets s->err and returns false, and there is nothing to close; a
 * script fault at power-on is not such a failure. If only the recording's file cannot be written, sets s->err and
 * returns true. */
bool session_open(struct session *s, const struct cart *cart, const struct board_start *start, const struct demo *demo,
                  const char *record);

/* Ends the recording and frees everything. If the file could not be finished, returns false and sets s->err. Does
 * nothing if *s is zeroed. */
bool session_close(struct session *s);

/* Powers the board on again with another start, and starts a new recording. On failure, returns false and changes
 * nothing. */
bool session_restart(struct session *s, const struct board_start *start);

static inline struct board *session_board(const struct session *s)
{
    return s->now->guard.board;
}

/* Ticks one frame: a playback with the demo's pads, a live run with these pads, which drops the frames recorded after
 * the present. A fault is in board_last_output; after it only going back works. If the recording could not be written,
 * returns false and sets s->err, once; the frame was played anyway. */
bool session_tick(struct session *s, const uint16_t pads[MAX_PLAYERS]);

/* Ticks one recorded frame, if there is one after the present. */
bool session_replay_tick(struct session *s);

/* Return the first and last frame that session_goto can reach: in the stored past of the run, and in a playback in the
 * whole demo. */
uint32_t session_first(const struct session *s);
uint32_t session_last(const struct session *s);

/* Moves to a frame, clamped to that range. Frames played before are reached at once, others by session_work. */
void session_goto(struct session *s, uint32_t frame);

/* Continues a seek or a reload until the host's clock (plat_usec) reaches `until`. If a reload failed, which then has
 * changed nothing, or the recording could not be written, returns false and sets s->err. */
bool session_work(struct session *s, uint64_t until);

/* Stops a seek or a reload at the present frame. */
void session_stop(struct session *s);

/* Returns the progress of the seek or reload in thousandths. */
int session_progress(const struct session *s);

/* Ends a playback; the player continues. The demo's frames so far become a new recording, flagged DEMO_BRANCHED, in
 * this file (NULL: in memory). If it is not a playback, or the file cannot be written, returns false and sets s->err.
 * */
bool session_take_over(struct session *s, const char *record);

/* Ends a playback at the demo's last frame; the player continues the recorded run, without a branch. The recording gets
 * the demo's flags and these. If it is at another frame, or differs from the recording, returns false and sets s->err.
 * */
bool session_resume(struct session *s, unsigned flags);

/* Call it when the console has changed the board of a live run between two ticks: drops its past and the frames
 * recorded after the present, and flags the recording DEMO_TOUCHED. If the recording could not be written, returns
 * false and sets s->err. */
bool session_mark_touched(struct session *s);

/* Call it when single steps or slow motion are used: flags the recording DEMO_ASSISTED. If it could not be written,
 * returns false and sets s->err. */
bool session_mark_assisted(struct session *s);

/* Returns the known markers of the run, or in a playback those of the demo, and sets *n to their number. */
const struct demo_marker *session_markers(const struct session *s, uint32_t *n);

/* Packs a folder, or loads a file, again. If the ROM has changed, a new board is powered on with it; session_work runs
 * it with the pads of the old one, and at the same frame it replaces the old one. If the ROM can't run, a script has an
 * error or the run ends early, returns false and sets s->err, and the old run continues. Returns true if the ROM hasn't
 * changed (SESSION_PLAYING) or the reload has started. */
bool session_reload(struct session *s, rom_loader *load, const char *path, bool nearest);

#endif
