/*
 * cab_run.c - the run: its ticks, the work of a seek or a reload (session.c does it), and attract demos.
 *
 * There are two boards at most: the session's, and while that one stands still the one that shows an attract demo.
 */
#include <stdio.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "cab_parts.h"
#include "../../common/files.h"

enum { WORK_USEC = 12000 /* of a frame spent on a seek or a reload */ };

static void play_sound(struct cab *cab, const struct board *b)
{
    if (!cab->quiet)
        speaker_hear(&cab->speaker, b, SPEAKER_ON, cab->slow);
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

static void attract_begin(struct cab *cab, const char *name)
{
    char err[256];
    struct lump lump;
    if (!find_attract(cab, name, &lump))
        return;
    cab->attracting = demo_read(&cab->attract, lump.data, lump.size, err, sizeof err) &&
                      demo_check_cart(&cab->attract, cab_cart(cab), err, sizeof err) &&
                      guard_power(&cab->attract_guard, cab_cart(cab)->rom, &cab->attract.start, err, sizeof err);
    if (cab->attracting)
        return;
    cab_say(cab, "curtain: demo \"%s\": %s", name, err);
    cab_attract_end(cab);
}

static void attract_tick(struct cab *cab)
{
    uint16_t pads[MAX_PLAYERS];
    const struct board *b = cab->attract_guard.board;
    if (board_last_output(b)->fault || board_last_output(b)->request == REQUEST_QUIT ||
        board_frame(b) >= cab->attract.frames) {
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
    const struct board_out *out = board_last_output(cab_live(cab));

    cab_log_lines(cab, out);
    play_sound(cab, cab_live(cab));
    practice_after_tick(&cab->practice, out);
    if (out->fault)
        cab_report_fault(cab);
    else if (out->request == REQUEST_QUIT)
        cab->quit = true;
    else if (out->request == REQUEST_ATTRACT && fresh)
        attract_begin(cab, out->attract);
    else if (out->request == REQUEST_HOST_SCREEN && fresh)
        cab_asked(cab, out->host_screen);
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
    uint16_t pads[MAX_PLAYERS] = { 0 };

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

/* ---- reload ---- */

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
            cab_reload_failed(cab);
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
