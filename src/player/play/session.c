/*
 * session.c - runs, seeks and reloads (session.h). A session_run owns everything that is freed with its board; reloads
 * and restarts make a new one.
 */
#include "session.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/result.h"

enum { CLOCK_EVERY = 16 /* ticks between two readings of the clock */ };

static bool fail(struct session *s, const char *what)
{
    snprintf(s->err, sizeof s->err, "%s", what);
    return false;
}

/* ---- runs ---- */

void session_rom_free(struct session_rom *r)
{
    if (r)
        rom_image_free(&r->image);
    free(r);
}

static void run_free(struct session_run *r)
{
    if (!r)
        return;
    guard_close(&r->guard);
    demo_writer_free(&r->writer);
    session_rom_free(r->rom);
    free(r);
}

/* Powers a board on and records it in memory. Takes ownership of `rom`, even on failure. On failure, returns NULL and
 * sets s->err. */
static struct session_run *run_power(struct session *s, const struct cart *cart, struct session_rom *rom,
                                     const struct board_start *start)
{
    struct session_run *r = calloc(1, sizeof *r);

    if (!r) {
        session_rom_free(rom);
        fail(s, "out of memory");
        return NULL;
    }
    r->cart = cart;
    r->rom = rom;
    if (guard_power(&r->guard, cart->rom, start, s->err, sizeof s->err)) {
        if (guard_store_past(&r->guard)) {
            demo_begin(&r->writer, NULL, cart, r->guard.board, start, 0);
            return r;
        }
        fail(s, "out of memory");
    }
    run_free(r);
    return NULL;
}

static bool check_written(struct session *s, bool ok)
{
    return ok || fail(s, s->now->writer.err);
}

bool session_open(struct session *s, const struct cart *cart, const struct board_start *start, const struct demo *demo,
                  const char *record)
{
    *s = (struct session){ .start = *start, .demo = demo, .record = record };
    s->now = run_power(s, cart, NULL, start);
    if (s->now && record)
        check_written(s, demo_record_to_file(&s->now->writer, record));
    return s->now != NULL;
}

/* Ends the recording at the present. */
static bool finish(struct session *s)
{
    struct demo_writer *w = &s->now->writer;
    const struct board *b = session_board(s);
    bool ok = true;

    if (!board_last_output(b)->fault && board_frame(b) < w->demo.frames)
        ok = demo_rewind(w, board_frame(b));
    return check_written(s, demo_end(w, b) && ok);
}

bool session_close(struct session *s)
{
    bool ok = !s->now || finish(s);

    run_free(s->now);
    run_free(s->next);
    s->now = s->next = NULL;
    return ok;
}

bool session_restart(struct session *s, const struct board_start *start)
{
    struct session_run *r = run_power(s, s->now->cart, NULL, start);

    if (!r)
        return false;
    finish(s);
    session_stop(s);
    r->rom = s->now->rom;
    s->now->rom = NULL;
    run_free(s->now);
    s->now = r;
    s->start = *start;
    s->demo = NULL;
    s->differs = 0;
    s->rewound = false;
    return !s->record || check_written(s, demo_record_to_file(&r->writer, s->record));
}

/* ---- forward ---- */

/* Finds the recorded pads of the board's next tick. Returns false if there are none. */
static bool known_pads(const struct session *s, uint16_t pads[MAX_PLAYERS])
{
    uint32_t frame = board_frame(session_board(s));
    const struct demo *d = frame < s->now->writer.demo.frames || !s->demo ? &s->now->writer.demo : s->demo;

    demo_pads(d, frame, pads);
    return frame < d->frames;
}

/* Compares the newest frame of a playback with its recording. Parts that only one of the two builds has are
 * ignored. */
static void compare(struct session *s)
{
    const struct session_run *r = s->now;
    uint64_t hashes[MAX_PARTS];
    uint64_t missing = demo_reorder_hashes(s->demo, r->guard.board, r->writer.hashes, hashes);

    if (demo_differing_parts(s->demo, r->writer.demo.frames, hashes) & ~missing)
        s->differs = r->writer.demo.frames;
}

static bool tick(struct session *s, const uint16_t pads[MAX_PLAYERS])
{
    struct session_run *r = s->now;
    bool seen = board_frame(r->guard.board) < r->writer.demo.frames;

    guard_tick(&r->guard, pads);
    if (s->ticked)
        s->ticked(s->context, s);
    if (seen)
        return true;
    bool ok = demo_record_frame(&r->writer, r->guard.board, pads);
    if (s->demo && !s->differs && r->writer.recording && !board_last_output(r->guard.board)->fault)
        compare(s);
    return check_written(s, ok);
}

bool session_replay_tick(struct session *s)
{
    uint16_t pads[MAX_PLAYERS];

    if (board_last_output(session_board(s))->fault || !known_pads(s, pads))
        return true;
    return tick(s, pads);
}

bool session_tick(struct session *s, const uint16_t pads[MAX_PLAYERS])
{
    const struct board *b = session_board(s);
    struct demo_writer *w = &s->now->writer;
    bool ok = true;

    if (s->demo)
        return session_replay_tick(s);
    if (board_last_output(b)->fault)
        return true;
    if (board_frame(b) < w->demo.frames)
        ok = check_written(s, demo_rewind(w, board_frame(b)));
    return tick(s, pads) && ok;
}

/* ---- moving in time ---- */

uint32_t session_first(const struct session *s)
{
    return rewind_first(s->now->guard.past);
}

uint32_t session_last(const struct session *s)
{
    const struct demo *d = s->demo && !board_last_output(session_board(s))->fault ? s->demo : &s->now->writer.demo;
    uint32_t frame = board_frame(session_board(s));
    bool fault = d->frames > d->checksum_frames; /* the tick that faulted adds no frame */

    return d->frames - fault > frame ? d->frames - fault : frame;
}

void session_goto(struct session *s, uint32_t frame)
{
    uint32_t first = session_first(s), last = session_last(s), end = rewind_end(s->now->guard.past);

    session_stop(s);
    frame = frame < first ? first : frame > last ? last : frame;
    if (frame < board_frame(session_board(s)) && !s->demo)
        s->rewound = true;
    s->from = board_frame(session_board(s));
    s->to = frame;
    guard_rewind(&s->now->guard, frame < end ? frame : end);
    s->state = board_frame(session_board(s)) == frame ? SESSION_PLAYING : SESSION_SEEKING;
}

void session_stop(struct session *s)
{
    run_free(s->next);
    s->next = NULL;
    s->state = SESSION_PLAYING;
}

int session_progress(const struct session *s)
{
    const struct session_run *r = s->next ? s->next : s->now;
    uint32_t at = board_frame(r->guard.board);

    if (s->state == SESSION_PLAYING || at >= s->to)
        return 1000;
    return at < s->from ? 0 : (int)((uint64_t)(at - s->from) * 1000 / (s->to - s->from));
}

bool session_take_over(struct session *s, const char *record)
{
    const struct board *b = session_board(s);
    uint32_t frame = board_frame(b) + (board_last_output(b)->fault != NULL); /* the tick that faulted is recorded too */

    if (!s->demo)
        return fail(s, "Nothing to take over: you are already playing");
    session_stop(s);
    s->demo = NULL;
    s->differs = 0;
    s->rewound = true;
    s->record = record ? record : s->record;
    if (!check_written(s, demo_rewind(&s->now->writer, frame)))
        return false;
    return !s->record || check_written(s, demo_record_to_file(&s->now->writer, s->record));
}

bool session_resume(struct session *s, unsigned flags)
{
    const struct board *b = session_board(s);

    if (!s->demo || board_last_output(b)->fault || board_frame(b) != s->demo->frames)
        return fail(s, "the run's recording does not replay to the end");
    if (s->differs)
        return fail(s, "playback diverged from the recording");
    session_stop(s);
    flags |= s->demo->flags;
    s->demo = NULL;
    return check_written(s, demo_add_flags(&s->now->writer, flags));
}

bool session_mark_assisted(struct session *s)
{
    return check_written(s, demo_add_flags(&s->now->writer, DEMO_ASSISTED));
}

bool session_mark_touched(struct session *s)
{
    struct demo_writer *w = &s->now->writer;
    uint32_t frame = board_frame(session_board(s));
    bool ok = frame >= w->demo.frames || demo_rewind(w, frame);

    session_stop(s);
    rewind_forget(s->now->guard.past, frame);
    return check_written(s, demo_add_flags(w, DEMO_TOUCHED) && ok);
}

const struct demo_marker *session_markers(const struct session *s, uint32_t *n)
{
    const struct demo *d = s->demo && s->demo->n_markers ? s->demo : &s->now->writer.demo;

    *n = d->n_markers;
    return d->markers;
}

/* ---- reload ---- */

struct session_rom *session_rom_load(rom_loader *load, const char *path, bool nearest, char *err, size_t err_size)
{
    struct session_rom *r = calloc(1, sizeof *r);

    if (!r) {
        result_set_host_error(err, err_size, "out of memory");
        return NULL;
    }
    if (load(path, nearest, &r->image, err, err_size) && cart_open(&r->cart, &r->image.rom, err, err_size))
        return r;
    session_rom_free(r);
    return NULL;
}

/* Ends the reload if the new board has a fault or its game has ended. */
static bool reload_ended(struct session *s)
{
    const struct board *b = s->next->guard.board;
    const struct board_out *out = board_last_output(b);

    if (out->fault)
        snprintf(s->err, sizeof s->err, "%s (in frame %u of the run)", out->fault->message, (unsigned)board_frame(b));
    else if (out->request == REQUEST_QUIT)
        snprintf(s->err, sizeof s->err, "the reloaded game ends at frame %u of the run", (unsigned)board_frame(b));
    else
        return false;
    session_stop(s);
    return true;
}

bool session_reload(struct session *s, rom_loader *load, const char *path, bool nearest)
{
    struct session_rom *rom = session_rom_load(load, path, nearest, s->err, sizeof s->err);

    if (!rom)
        return false;
    session_stop(s);
    if (rom_hash(&rom->image.rom) == rom_hash(s->now->cart->rom)) {
        session_rom_free(rom);
        return true;
    }
    if (strcmp(rom->cart.manifest.id, s->now->cart->manifest.id) != 0) {
        snprintf(s->err, sizeof s->err, "the folder now contains another game (\"%s\", was \"%s\")",
                 rom->cart.manifest.id, s->now->cart->manifest.id);
        session_rom_free(rom);
        return false;
    }
    s->next = run_power(s, &rom->cart, rom, &s->start);
    if (!s->next || reload_ended(s))
        return false;
    s->state = SESSION_RELOADING;
    s->from = 0;
    s->to = board_frame(session_board(s));
    return true;
}

/* Replaces the old run with the new one, which continues its file. */
static bool finish_reload(struct session *s)
{
    struct session_run *old = s->now;
    unsigned flags = old->writer.demo.flags | DEMO_TOUCHED;

    s->now = s->next;
    s->next = NULL;
    s->state = SESSION_PLAYING;
    s->differs = 0;
    const char *song = board_music_name(old->guard.board);
    snprintf(s->missing_music, sizeof s->missing_music, "%s",
             song[0] && cart_find(s->now->cart, CART_TUNES, song) < 0 ? song : "");
    run_free(old);
    demo_add_flags(&s->now->writer, flags);
    return !s->record || check_written(s, demo_record_to_file(&s->now->writer, s->record));
}

/* ---- work ---- */

static bool reload_tick(struct session *s)
{
    struct session_run *r = s->next;
    uint16_t pads[MAX_PLAYERS];

    demo_pads(&s->now->writer.demo, board_frame(r->guard.board), pads);
    guard_tick(&r->guard, pads);
    demo_record_frame(&r->writer, r->guard.board, pads);
    return !reload_ended(s);
}

static bool reached_target(const struct session *s)
{
    const struct board *b = s->next ? s->next->guard.board : session_board(s);

    return board_frame(b) >= s->to || board_last_output(b)->fault;
}

/* Returns whether `until` is not reached; false also if the clock was set back. */
static bool time_left(uint64_t start, uint64_t until)
{
    const uint64_t now = plat_usec();

    return now >= start && now < until;
}

bool session_work(struct session *s, uint64_t until)
{
    const uint64_t start = plat_usec();
    bool ok = true;

    for (int i = 1; s->state != SESSION_PLAYING && !reached_target(s) && ok; i++) {
        ok = s->next ? reload_tick(s) : session_replay_tick(s);
        if (i % CLOCK_EVERY == 0 && !time_left(start, until))
            return ok;
    }
    if (!ok || s->state == SESSION_PLAYING)
        return ok;
    if (s->state == SESSION_RELOADING)
        return finish_reload(s);
    session_stop(s);
    return true;
}
