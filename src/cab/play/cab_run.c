/*
 * cab_run.c - the run: its ticks, moving in time (session.c does the work), reload, and attract demos.
 *
 * There are two boards at most: the session's, and while that one stands still the one that shows an attract demo.
 */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "cab_parts.h"
#include "../../common/clean.h"
#include "../../common/files.h"

enum {
    LOOK_EVERY = 15,  /* frames between two looks at the game's folder */
    BAR_STAYS = 120,  /* frames the time bar is shown after its last use */
    WORK_USEC = 12000 /* of a frame spent on a seek or a reload */
};

/* ---- messages ---- */

/* Into the window's log, which has the frame as well. */
static void note(struct cab *cab, enum log_kind kind, const char *line)
{
    const struct board *b = cab->session.now ? cab_live(cab) : NULL;

    log_add(&cab->log, kind, b ? board_frame(b) : 0, line);
}

void cab_say(struct cab *cab, const char *format, ...)
{
    char line[2 * FILES_PATH + 256];
    va_list args;

    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    clean_line(line);
    plat_log(line);
    note(cab, LOG_TOLD, line);
}

const char *cab_game(const struct cab *cab)
{
    return cab->options.path ? cab->options.path : cab->options.cart->m.id;
}

const struct cart *cab_cart(const struct cab *cab)
{
    return cab->session.now ? cab->session.now->cart : cab->options.cart;
}

struct board *cab_live(const struct cab *cab)
{
    return session_board(&cab->session);
}

const struct board_fault *cab_fault(const struct cab *cab)
{
    return board_last(cab_live(cab))->fault;
}

void cab_notice(struct cab *cab, int frames, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    vsnprintf(cab->notice, sizeof cab->notice, format, args);
    va_end(args);
    cab->notice_left = frames;
}

void cab_check_recording(struct cab *cab, bool good)
{
    const struct demo_writer *writer = &cab->session.now->writer;

    if (good)
        return;
    if (writer->file.lost) { /* it is tried again, and the last time when the session closes */
        cab_save_failed(cab, cab->session.err);
        return;
    }
    cab_say(cab, "curtain: %s", cab->session.err);
    cab->result = RESULT_HOST;
}

void cab_mark_assisted(struct cab *cab)
{
    cab_save_nvram(cab); /* what was reached so far; nothing more of this run */
    cab_check_recording(cab, session_mark_assisted(&cab->session));
}

void cab_free_name(struct cab *cab, char name[CAB_NAME], const char *where, const char *what)
{
    size_t size;
    int i = 1;
    do
        snprintf(name, CAB_NAME, "%s%s-%d.%s", where, cab_cart(cab)->m.id, i++, what);
    while (plat_size(name) >= 0 || unsaved_bytes(cab->unsaved.files, name, &size));
}

/* ---- tick output ---- */

void cab_log_lines(struct cab *cab, const struct board_out *out)
{
    char line[4097];
    for (size_t i = 0; i < out->log_size;) {
        const char *end = memchr(out->log + i, '\n', out->log_size - i);
        size_t n = end ? (size_t)(end - (out->log + i)) : out->log_size - i;
        snprintf(line, sizeof line, "%.*s", (int)n, out->log + i);
        clean_line(line);
        plat_log(line);
        note(cab, LOG_PRINTED, line);
        i += n + 1;
    }
}

static void play_sound(struct cab *cab, const struct board *b)
{
    if (!cab->quiet)
        speaker_hear(&cab->speaker, b, SPEAKER_ON, cab->slow);
}

void cab_hear_once(struct cab *cab, enum speaker_way way)
{
    speaker_hear(&cab->speaker, cab->attracting ? cab->attract_guard.board : cab_live(cab), way, 1);
}

void cab_report_fault(struct cab *cab)
{
    char line[FILES_PATH + sizeof((struct board_fault *)0)->message];

    if (!cab->fault_reported) {
        struct board_fault fault = *cab_fault(cab);
        snprintf(line, sizeof line, "curtain: %s: %s", cab_game(cab), fault.message);
        clean_line(line);
        plat_log(line);
        note(cab, LOG_WRONG, fault.message);
        clean_lines(fault.trace);
        if (fault.trace[0])
            plat_log(fault.trace);
        note(cab, LOG_WRONG, fault.trace);
        cab->fault_top = 0;
        cab_report_write(cab, cab_fault(cab));
    }
    cab->fault_reported = true;
}

/* ---- attract: a second board while the live one stands still ---- */

static bool find_attract(struct cab *cab, const char *name, struct lump *lump)
{
    char full[80];
    snprintf(full, sizeof full, "demo/%s", name);
    int i = rom_find(cab_cart(cab)->rom, full);
    if (i < 0)
        cab_say(cab, "curtain: %s: board.attract: no demo \"%s\" in the game", cab_game(cab), name);
    else
        rom_lump(cab_cart(cab)->rom, i, lump);
    return i >= 0;
}

void cab_attract_end(struct cab *cab)
{
    guard_close(&cab->attract_guard);
    demo_free(&cab->attract);
    cab->attracting = false;
}

static void attract_begin(struct cab *cab, const char *name)
{
    char err[256];
    struct lump lump;
    if (!find_attract(cab, name, &lump))
        return;
    cab->attracting = demo_read(&cab->attract, lump.data, lump.size, err, sizeof err) &&
                      demo_fits(&cab->attract, cab_cart(cab), err, sizeof err) &&
                      guard_power(&cab->attract_guard, cab_cart(cab)->rom, &cab->attract.start, err, sizeof err);
    if (cab->attracting)
        return;
    cab_say(cab, "curtain: demo \"%s\": %s", name, err);
    cab_attract_end(cab);
}

static void attract_tick(struct cab *cab)
{
    uint16_t pads[PADS];
    const struct board *b = cab->attract_guard.board;
    if (board_last(b)->fault || board_last(b)->request == REQUEST_QUIT || board_frame(b) >= cab->attract.frames) {
        cab_attract_end(cab);
        return;
    }
    demo_pads(&cab->attract, board_frame(b), pads);
    guard_tick(&cab->attract_guard, pads);
    play_sound(cab, b);
}

/* ---- forward ---- */

/* Handles the output of the last tick. fresh: the player has just made it; else it was recorded, and what it asked of
 * the cabinet then is not done again. */
static void handle_output(struct cab *cab, bool fresh)
{
    const struct board_out *out = board_last(cab_live(cab));

    cab_log_lines(cab, out);
    play_sound(cab, cab_live(cab));
    practice_after_tick(&cab->practice, out);
    if (out->fault)
        cab_report_fault(cab);
    else if (out->request == REQUEST_QUIT)
        cab->quit = true;
    else if (out->request == REQUEST_ATTRACT && fresh)
        attract_begin(cab, out->attract);
    else if (out->request == REQUEST_ASK && fresh)
        cab_asked(cab, out->ask);
}

/* Reports, once, that a playback is not the run that was recorded. */
static void report_difference(struct cab *cab)
{
    if (!cab->session.differs || cab->differs == cab->session.differs)
        return;
    cab->differs = cab->session.differs;
    cab_notice(cab, CAB_NOTICE_FRAMES, "Playback diverged from the recording at frame %u", (unsigned)cab->differs);
    cab_say(cab, "curtain: %s: %s", cab_game(cab), cab->notice);
}

/* At its end a playback quits, or pauses if the player has moved in time. */
static bool at_end(struct cab *cab)
{
    if (!cab->session.demo || board_frame(cab_live(cab)) < cab->session.demo->frames)
        return false;
    cab->quit = !cab->scrubbed && !cab->guest.demo;
    if (!cab->paused && cab->guest.watching)
        cab_open_menu(cab);
    cab->paused = true;
    return true;
}

void cab_tick(struct cab *cab)
{
    uint16_t pads[PADS] = { 0 };

    if (cab->quit || screens_are_open(&cab->screens))
        return;
    if (cab->attracting) {
        attract_tick(cab);
        return;
    }
    if (cab_fault(cab) || at_end(cab))
        return;
    if (!cab->session.demo)
        cab_pads_tick(cab, pads);
    memcpy(cab->last_pads, pads, sizeof pads);
    cab->ticked = true;
    cab_check_recording(cab, session_tick(&cab->session, pads));
    report_difference(cab);
    cab_keep_tick(cab);
    handle_output(cab, !cab->session.demo);
}

void cab_step(struct cab *cab)
{
    if (cab->attracting || cab_fault(cab))
        return;
    if (board_frame(cab_live(cab)) < session_last(&cab->session)) {
        session_replay_tick(&cab->session);
        handle_output(cab, false);
    } else {
        cab_mark_assisted(cab);
        cab_tick(cab);
    }
}

/* ---- moving in time ---- */

static void notice_first_frame(struct cab *cab)
{
    cab_notice(cab, BAR_STAYS, "Cannot go back before frame %u", (unsigned)session_first(&cab->session));
}

void cab_goto(struct cab *cab, uint32_t frame)
{
    if (!cab->session.demo && !cab->session.rewound)
        cab_save_nvram(cab);
    if (frame < session_first(&cab->session))
        notice_first_frame(cab);
    session_goto(&cab->session, frame);
    practice_stop_counting(&cab->practice);
    cab->scrubbed = true;
    cab->fault_reported = cab->fault_reported && cab_fault(cab);
    cab->timebar_left = BAR_STAYS;
}

void cab_rewind(struct cab *cab, uint32_t frames)
{
    uint32_t now = board_frame(cab_live(cab));
    cab_goto(cab, now > frames ? now - frames : 0);
}

void cab_take_over(struct cab *cab)
{
    char shown[FILES_PATH];

    if (!cab->session.demo) {
        cab_notice(cab, CAB_NOTICE_FRAMES, "Nothing to take over: you are already playing");
        return;
    }
    cab->taken = true;
    if (cab->guest.watching) {
        cab_check_recording(cab, session_take_over(&cab->session, NULL));
        cab_notice(cab, CAB_NOTICE_FRAMES, "Practice: nothing is saved");
    } else {
        cab_free_name(cab, cab->took, "", "demo");
        bool given = cab->options.record != NULL;
        cab_check_recording(cab, session_take_over(&cab->session, given ? cab->options.record : cab->took));
        if (given || !plat_path(cab->took, shown, sizeof shown))
            snprintf(shown, sizeof shown, "%s", given ? cab->options.record : cab->took);
        cab_notice(cab, CAB_NOTICE_FRAMES, "You are playing from here. Recording: %s", shown);
        cab_say(cab, "curtain: %s: %s", cab_game(cab), cab->notice);
    }
    cab->paused = false;
    cab->timebar_left = 0;
}

/* ---- reload ---- */

static void report_reload_failure(struct cab *cab)
{
    cab_notice(cab, -1, "%s", cab->session.err);
    cab_say(cab, "curtain: reload failed: %s", cab->session.err);
}

void cab_reload(struct cab *cab)
{
    if (cab->guest.home) {
        cab_notice(cab, CAB_NOTICE_FRAMES, "An older version is running: changes take effect at the title");
        return;
    }
    if (!cab->options.path) {
        cab_notice(cab, CAB_NOTICE_FRAMES, "The built-in game cannot be reloaded");
        return;
    }
    cab_save_nvram(cab); /* does nothing once the run is touched */
    if (session_reload(&cab->session, cab->options.path, cab->options.nearest)) {
        cab->notice_left = 0;
        return;
    }
    report_reload_failure(cab);
}

void cab_check_folder(struct cab *cab)
{
    if (cab->guest.demo && cab->session.demo) /* it shows the game as it was */
        return;
    if (cab->reload_due) {
        cab->reload_due = false;
        cab_reload(cab);
    }
    if (++cab->since_check < LOOK_EVERY)
        return;
    cab->since_check = 0;
    cab->reload_due = folder_changed(&cab->folder);
    if (cab->reload_due) /* loading may stop the picture for long: say why first */
        cab_notice(cab, CAB_NOTICE_FRAMES, "Reloading");
}

void cab_fit_cart(struct cab *cab)
{
    const struct manifest *m = &cab_cart(cab)->m;
    const int w = cab->picture.fb.w, h = cab->picture.fb.h;

    cab->fault_reported = false;
    practice_reloaded(&cab->practice, cab_cart(cab));
    cab_report_ready(cab);
    cab_picture_close(&cab->picture);
    if (!cab_picture_open(&cab->picture, cab_live(cab))) {
        plat_log("curtain: out of memory for the picture");
        cab->result = RESULT_HOST;
        cab->quit = true;
        return;
    }
    if (w != m->screen_w || h != m->screen_h || strcmp(cab->title, m->title) != 0 ||
        cab->want.rate != cab_sound_rate(cab))
        cab->quit = !cab_open_window(cab) || cab->quit;
}

/* The new ROM runs: it may have another screen and other capacities. */
static void finish_reload(struct cab *cab)
{
    if (cab->attracting) /* its board reads the ROM that is freed */
        cab_attract_end(cab);
    cab_fit_cart(cab);
    cab_say(cab, "curtain: %s: reloaded", cab_game(cab));
    if (cab->session.gone[0])
        cab_say(cab, "curtain: %s: the music \"%s\" was playing and is no longer in the game", cab_game(cab),
                cab->session.gone);
    cab_notice(cab, CAB_NOTICE_FRAMES / 3, "Reloaded");
}

void cab_seek_or_reload(struct cab *cab, uint64_t now)
{
    bool reloads = cab->session.state == SESSION_RELOADING;

    if (!session_work(&cab->session, now + WORK_USEC)) {
        if (reloads)
            report_reload_failure(cab);
        else
            cab_check_recording(cab, false);
    } else if (reloads && cab->session.state == SESSION_PLAYING) {
        finish_reload(cab);
    }
    if (cab->session.state == SESSION_PLAYING)
        cab_resume_arrived(cab);
    report_difference(cab);
    if (cab_fault(cab))
        cab_report_fault(cab);
}
