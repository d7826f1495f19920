/*
 * session.h - a run that is played: its board, its recording and its past, and what a player may do with time. No window,
 * no keys.
 * floor: cab    used by: cab tests/
 *
 * All that reaches the board is recorded, in memory at least, so any frame of the run can be gone to, and the whole of
 * it played again on a changed ROM. A run is live, or it is the playback of a demo until somebody takes over. Who goes
 * back in a live run and plays on starts another branch: what came after is forgotten, and the demo says so.
 *
 * What takes long (far ahead in a demo, the run again on a changed ROM) goes on in pieces: session_work, once a picture.
 */
#ifndef CAB_SESSION_H
#define CAB_SESSION_H

#include "../demo/demo.h"
#include "../run/guard.h"
#include "../pack/pack.h"

/* A ROM of the session's own, read while it runs. */
struct session_rom {
    struct rom_image image;
    struct cart cart;
};

struct session_run {
    const struct cart *cart;
    struct session_rom *rom; /* what cart is in; NULL: the caller's */
    struct guard guard;
    struct demo_writer writer; /* .demo: all that was played; frames after the board's are a future that was */
};

enum session_way {
    SESSION_THERE, /* nothing to be done */
    SESSION_SEEKS, /* on its way to a frame ahead */
    SESSION_RELOADS
};

struct session {
    struct board_start start;
    const struct demo *demo;        /* played back; NULL: live */
    const char *record;             /* NULL: in memory only */
    struct session_run *now, *next; /* next: being made by a reload, to take its place */
    enum session_way way;
    uint32_t from, to;        /* the frames of the way */
    uint32_t differs;         /* the first frame of a playback found not to be as it was recorded; 0: none */
    bool rewound;             /* a live run went back once: scores do not count any more */
    char err[DEMO_PATH + 64]; /* what session_* said no with */
};

/* Powers the board and begins to record. start is the demo's if there is one; cart, start.nvram, demo and record outlive
 * the session. False and s->err for a ROM that cannot run, with nothing to close; a script fault at power-on is none.
 * True with s->err: the run is open, but its file cannot be written. */
bool session_open(struct session *s, const struct cart *cart, const struct board_start *start, const struct demo *demo,
                  const char *record);

/* Ends the recording and gives everything back; false: the file could not be finished, s->err. Harmless on zeroes. */
bool session_close(struct session *s);

/* Power-on again, with another start: a practice piece, a try more. The recording begins anew. False: as it was. */
bool session_restart(struct session *s, const struct board_start *start);

static inline struct board *session_board(const struct session *s)
{
    return s->now->guard.board;
}

/* One frame on. Of a playback: the demo's, pads count for nothing. Of a live run: pads, and what may have been recorded
 * after the present is forgotten. A fault is in board_last; then only going back helps. False: the recording could not
 * be written (once; s->err), the frame was played all the same. */
bool session_tick(struct session *s, const uint16_t pads[PADS]);

/* One frame on as it was recorded, when there is one. */
bool session_again(struct session *s);

/* The frames that can be gone to: what is remembered, and in a playback the demo to its end. */
uint32_t session_first(const struct session *s);
uint32_t session_last(const struct session *s);

/* To a frame, clamped to those. Back and over what was played it is there at once; farther, session_work goes on. */
void session_goto(struct session *s, uint32_t frame);

/* Goes on with the way until the host's clock (plat_usec) says `until`. False: something went wrong, s->err says what:
 * a reload failed, and all is as it was. */
bool session_work(struct session *s, uint64_t until);

/* Stops where it is. */
void session_stop(struct session *s);

/* How much of the way is done, in thousandths. */
int session_progress(const struct session *s);

/* From here on the player plays: the demo's frames so far become a recording of its own, DEMO_BRANCHED, in this file
 * (NULL: in memory). False: it is not a playback, or the file cannot be written (s->err). */
bool session_take_over(struct session *s, const char *record);

/* Somebody changed the board from outside, between two ticks of a live run: its past is not its own any more, what was
 * recorded after the present is forgotten, and the recording is DEMO_TOUCHED. False: it could not be written (s->err). */
bool session_touch(struct session *s);

/* The run is played with steps or slow motion: the recording is DEMO_ASSISTED. False: it could not be written (s->err). */
bool session_assist(struct session *s);

/* The markers of the run that are known, and how many: in a playback the demo's. */
const struct demo_marker *session_markers(const struct session *s, uint32_t *n);

/* Packs a folder (or loads a file) anew. Unless the ROM is the same, a new board is powered with it, and gets all that
 * the old one got, in session_work; landing on the same frame it takes its place. A ROM that cannot run, a script error
 * or a run that ends early: s->err, and all is as it was. True: it is the same (SESSION_THERE), or it has begun. */
bool session_reload(struct session *s, const char *path, bool nearest);

#endif
