/*
 * session.h - a run that is played: its board, its recording, its past, and moving in time. It has no window and no
 * keys.
 *
 * All input to the board is recorded, in memory at least, so any frame of the run can be restored and the whole run can
 * be repeated on a changed ROM. A run is live, or it is the playback of a demo until the player takes over. Going back
 * in a live run and playing on starts another branch: the frames after that point are dropped, and the demo is flagged.
 *
 * Seeking far ahead in a demo and repeating the run on a changed ROM take long. They are done in parts, by
 * session_work, one a picture.
 */
#ifndef PLAYER_SESSION_H
#define PLAYER_SESSION_H

#include "../../demo/demo.h"
#include "../run/guard.h"
#include "../game/rom_image.h"

/* A ROM that the session owns: a reload read it. */
struct session_rom {
    struct rom_image image;
    struct cart cart;
};

/* Loads a .rom file or packs a folder. NULL and one sentence. */
struct session_rom *session_rom_load(rom_loader *load, const char *path, bool nearest, char *err, size_t err_size);
void session_rom_free(struct session_rom *r);

struct session_run {
    const struct cart *cart;
    struct session_rom *rom; /* owns cart; NULL: the caller owns it */
    struct guard guard;
    struct demo_writer writer; /* writer.demo: the whole run; after going back it has frames after the board's */
};

enum session_state {
    SESSION_PLAYING,  /* no seek and no reload is under way */
    SESSION_SEEKING,  /* ticks to a frame ahead */
    SESSION_RELOADING /* repeats the run on a changed ROM */
};

struct session {
    struct board_start start;
    const struct demo *demo;        /* played back; NULL: live */
    const char *record;             /* NULL: in memory only */
    struct session_run *now, *next; /* next: what a reload is making; it replaces now */
    enum session_state state;
    uint32_t from, to;     /* frames: of the seek or reload */
    uint32_t differs;      /* the first frame of a playback found not to be as it was recorded; 0: none */
    volatile uint32_t at;  /* the frame that the tick under way began in, for a report of a crash in it */
    volatile bool ticking; /* one is */
    bool rewound;          /* a live run went back once: scores do not count any more */
    void (*ticked)(void *of, const struct session *s); /* called after each tick of the board; may be NULL */
    void *of;
    char gone[64];                 /* the piece of music that played when a reload took its name away; "" */
    char err[DEMO_PATH_SIZE + 64]; /* one sentence: why the last session_* call failed */
};

/* Powers the board and begins to record. start is the demo's if there is one; cart, start.nvram, demo and record must
 * outlive the session. False and s->err: the ROM cannot run, and there is nothing to close; a script fault at power-on
 * is not such a failure. True with s->err: the run is open, but its file cannot be written. */
bool session_open(struct session *s, const struct cart *cart, const struct board_start *start, const struct demo *demo,
                  const char *record);

/* Ends the recording and frees everything. False and s->err: the file could not be finished. Harmless on zeroes. */
bool session_close(struct session *s);

/* Powers the board again, with another start, and begins a new recording. False: all is as it was. */
bool session_restart(struct session *s, const struct board_start *start);

static inline struct board *session_board(const struct session *s)
{
    return s->now->guard.board;
}

/* Ticks one frame: of a playback with the demo's pads, of a live run with these, and then frames recorded after the
 * present are dropped. A fault is in board_last_output; after it only going back works. False and s->err, once: the
 * recording could not be written; the frame was played all the same. */
bool session_tick(struct session *s, const uint16_t pads[MAX_PLAYERS]);

/* Ticks one recorded frame, if there is one after the present. */
bool session_replay_tick(struct session *s);

/* The first and last frame session_goto can reach: the run's past that is kept, and in a playback the demo to its
 * end. */
uint32_t session_first(const struct session *s);
uint32_t session_last(const struct session *s);

/* Goes to a frame, clamped to those. Frames that were played are reached at once; for others session_work seeks. */
void session_goto(struct session *s, uint32_t frame);

/* Goes on with a seek or a reload until the host's clock (plat_usec) says `until`. False and s->err: a reload failed,
 * and all is as it was, or the recording could not be written. */
bool session_work(struct session *s, uint64_t until);

/* Ends a seek or a reload where it is. */
void session_stop(struct session *s);

/* How much of the seek or reload is done, in thousandths. */
int session_progress(const struct session *s);

/* Ends a playback: the player plays on. The demo's frames so far become a new recording, flagged DEMO_BRANCHED, in this
 * file (NULL: in memory). False and s->err: it is not a playback, or the file cannot be written. */
bool session_take_over(struct session *s, const char *record);

/* Ends a playback at the demo's last frame, and the player goes on as if nothing had been: nothing is branched. The
 * recording has the demo's flags and these. False and s->err: it is not there, or is another run than was recorded. */
bool session_go_on(struct session *s, unsigned flags);

/* To be called when the board of a live run was changed between two ticks (by the console): drops its past and the
 * frames recorded after the present, and flags the recording DEMO_TOUCHED. False and s->err: it could not be
 * written. */
bool session_mark_touched(struct session *s);

/* To be called when steps or slow motion are used: flags the recording DEMO_ASSISTED. False and s->err: it could not be
 * written. */
bool session_mark_assisted(struct session *s);

/* The markers of the run that are known, and how many; in a playback the demo's. */
const struct demo_marker *session_markers(const struct session *s, uint32_t *n);

/* Packs a folder, or loads a file, again. If the ROM has changed, a new board is powered with it; session_work gives it
 * the pads of the old one, and at the same frame it replaces the old one. False and s->err: the ROM cannot run, a
 * script has an error or the run ends early, and all is as it was. True: nothing has changed
 * (SESSION_PLAYING), or it has begun. */
bool session_reload(struct session *s, rom_loader *load, const char *path, bool nearest);

#endif
