/*
 * play_tick.c - ticks, and attract demos.
 *
 * There are at most two boards: the session's, and one that shows an attract demo while the session's waits.
 */
#include <stdio.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "play_state.h"

static void queue_tick_sound(struct play *play)
{
    if (!play->time.quiet)
        play_queue_sound(play, SPEAKER_FORWARD);
}

/* ---- attract demos ---- */

static bool find_attract(struct play *play, const char *name, struct lump *lump)
{
    const struct rom *rom = play_cart(play)->rom;
    char full[80];

    snprintf(full, sizeof full, "demo/%s", name);
    const int i = rom_find(rom, full);
    if (i < 0)
        play_log(play, "curtain: %s: board.attract: no demo \"%s\" in the game", play_game_name(play), name);
    else
        rom_lump(rom, i, lump);
    return i >= 0;
}

/* Shows a demo in the player's language, whatever it was recorded in; its checksums are not compared. */
static void start_attract(struct play *play, const char *name)
{
    struct attract *a = &play->attract;
    const struct cart *cart = play_cart(play);
    char err[256];
    struct lump lump;

    if (!find_attract(play, name, &lump))
        return;
    a->on =
        demo_read(&a->demo, lump.data, lump.size, err, sizeof err) && demo_check_cart(&a->demo, cart, err, sizeof err);
    memcpy(a->demo.start.lang, play->start.lang, sizeof a->demo.start.lang);
    a->on = a->on && guard_power(&a->guard, cart->rom, &a->demo.start, err, sizeof err);
    if (a->on)
        return;
    play_log(play, "curtain: demo \"%s\": %s", name, err);
    attract_end(a);
}

static void attract_tick(struct play *play)
{
    struct attract *a = &play->attract;
    uint16_t pads[MAX_PLAYERS];
    const struct board_out *out = board_last_output(a->guard.board);
    const uint32_t frame = board_frame(a->guard.board);

    if (out->fault || out->request == REQUEST_QUIT || frame >= a->demo.frames) {
        attract_end(a);
        return;
    }
    demo_pads(&a->demo, frame, pads);
    guard_tick(&a->guard, pads);
    queue_tick_sound(play);
}

/* ---- the live board ---- */

/* A player who has finished a run knows the buttons: turns the hints on them off, for good. */
static void end_hints(struct play *play, const struct board_out *out)
{
    for (int i = 0; i < out->marker_count && play->config.hints; i++)
        if (out->marker[i].kind == MARKER_OVER && strcmp(out->marker[i].name, "quit") != 0) {
            play->config.hints = play->saved_config.hints = 0;
            play_save_settings(play);
        }
}

/* Handles the output of the last tick. replayed: the tick was recorded before, so its requests are ignored. */
static void handle_output(struct play *play, bool replayed)
{
    const struct board_out *out = board_last_output(play_board(play));

    play_log_output(play);
    queue_tick_sound(play);
    practice_after_tick(&play->practice, out);
    if (!replayed && !play->session.demo)
        end_hints(play, out);
    if (out->fault)
        play_report_fault(play);
    else if (out->request == REQUEST_QUIT)
        play->quit = true;
    else if (out->request == REQUEST_ATTRACT && !replayed)
        start_attract(play, out->attract);
    else if (out->request == REQUEST_HOST_SCREEN && !replayed)
        play_open_requested(play, out->host_screen);
}

bool play_is_at_end(const struct play *play)
{
    return play->session.demo && board_frame(play_board(play)) >= play->session.demo->frames;
}

/* At its end a playback quits, or pauses if the player has moved in time. */
static bool at_end(struct play *play)
{
    if (!play_is_at_end(play))
        return false;
    play->quit = !play->seek.used && !play->replay.demo;
    if (!play->time.paused && play->replay.watching)
        play_open_menu(play);
    play->time.paused = true;
    return true;
}

void play_tick(struct play *play)
{
    uint16_t pads[MAX_PLAYERS] = { 0 };

    if (play->quit || screens_are_open(&play->screens))
        return;
    if (play->attract.on) {
        attract_tick(play);
        return;
    }
    if (play_fault(play) || at_end(play))
        return;
    if (!play->session.demo)
        play_pads_tick(play, pads);
    for (int p = 0; p < MAX_PLAYERS; p++)
        play->drawing.last_pads[p] = pads[p] & PAD_ALL; /* a code is for one tick */
    play->time.ticked = true;
    play_check_recording(play, session_tick(&play->session, pads));
    play_report_difference(play);
    play_autosave_tick(play);
    handle_output(play, play->session.demo != NULL);
}

void play_step(struct play *play)
{
    if (play->attract.on || play_fault(play))
        return;
    if (board_frame(play_board(play)) < session_last(&play->session)) {
        session_replay_tick(&play->session);
        handle_output(play, true);
    } else {
        play_mark_assisted(play);
        play_tick(play);
    }
}
