/*
 * play_practice.c - starting the game again: from the practice menu, with the retry key, at the title. Each attempt is
 * a power-on.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "../../base/hash.h"
#include "play_state.h"

/* ---- starts ---- */

uint64_t play_clock_seed(void)
{
    return hash_fold(hash_fold(0, (uint64_t)time(0)), plat_usec());
}

void play_set_host_start(struct play *play, struct board_start *start)
{
    const struct manifest *m = &play->options.cart->manifest;
    struct words words;

    for (int i = 0; i < m->n_dips; i++)
        if (play->options.start.dip[i] == m->dips[i].default_value)
            start->dip[i] = play_dip_value(play, i);
    start->large_hud = play->options.start.large_hud || play->config.large_hud;
    if (!start->lang[0] && cart_open_lang(play->options.cart, play->config.lang, &words))
        snprintf(start->lang, sizeof start->lang, "%s", play->config.lang);
}

void play_title_start(struct play *play, struct board_start *start)
{
    const struct board_start *given = &play->options.start;

    *start = play->practice.home;
    start->nvram = given->nvram;
    start->nvram_size = given->nvram_size;
    snprintf(start->lang, sizeof start->lang, "%s", given->lang);
    play_set_host_start(play, start);
    start->at_title = true;
    if (!play->options.seeded)
        start->seed = play_clock_seed();
}

/* ---- power ---- */

void play_reset_run(struct play *play, const struct board_start *start)
{
    struct play_time *time = &play->time;

    play->start = *start;
    play->nvram.saved_count = 0;
    play->report.fault_reported = play->seek.used = play->replay.taken_over = false;
    time->paused = time->waits_for_button = false;
    time->due = play->seek.bar_frames = 0;
    memset(play->pads.held, 0, sizeof play->pads.held);
    play_pads_power(&play->pads);
    if (time->speed < PLAY_FULL_SPEED && !play->session.demo)
        play_mark_assisted(play);
}

/* Powers the board on again with another start. */
static void power_again(struct play *play, struct board_start start)
{
    bool reloads = play->session.state == SESSION_RELOADING;
    const struct session_run *before = play->session.now;

    play_autosave_end(play);
    play_save_nvram(play);
    start.nvram = play->options.start.nvram;
    start.nvram_size = play->options.start.nvram_size;
    uint8_t *nvram = play_load_nvram(play, &start);
    if (!session_restart(&play->session, &start))
        play_warn(play, "%s", play->session.err);
    if (play->session.now == before) { /* it failed */
        free(nvram);
        return;
    }
    free(play->nvram.image);
    play->nvram.image = nvram;
    play_free_replay(play);
    play_reset_run(play, &start);
    practice_start_run(&play->practice, &start);
    play_log_output(play);
    play_report_fault(play);
    if (reloads)
        play_reload(play);
}

void play_restart(void *context)
{
    struct play *play = context;
    struct board_start start;
    char path[PLAY_NAME_SIZE];

    screens_close_all(&play->screens);
    if (play->replay.home || play->session.demo) {
        play_return_to_title(play);
        return;
    }
    play_title_start(play, &start);
    power_again(play, start);
    play_resume_path(play, path);
    if (!play->unsaved.runs && !play->unsaved.unfinished_run)
        plat_remove(path); /* the player ended the run: it stays only as a replay */
}

/* ---- practice ---- */

/* Practice can't end a playback, nor the recording of a game from its title. */
static bool may_practise(struct play *play)
{
    bool records = play->session.record && !play->start.practice.section[0];

    if (play->session.demo || records)
        play_show_message(play, MESSAGE_FRAMES,
                          records ? "Practice is unavailable while this run is being recorded"
                                  : "Practice is unavailable in a replay");
    return !play->session.demo && !records;
}

void play_open_practice(struct play *play)
{
    if (!may_practise(play))
        return;
    attract_end(&play->attract);
    play->practice.hitbox = play->overlay.on[OVERLAY_HITBOXES];
    practice_open(&play->practice, &play->screens, play->time.speed);
}

void play_retry_practice(struct play *play)
{
    if (!may_practise(play))
        return;
    attract_end(&play->attract);
    if (play->start.practice.section[0])
        power_again(play, play->start);
    else
        play_show_message(play, MESSAGE_FRAMES, "Nothing to retry: choose a section first");
}

void play_practice_keys(struct play *play, const struct keys_state *k)
{
    if (keys_pressed(k, HOTKEY_RETRY)) {
        play_retry_practice(play);
    } else if (keys_pressed(k, HOTKEY_PRACTICE)) {
        play_open_practice(play);
    }
}

static void start_practice(void *context)
{
    struct play *play = context;
    struct board_start start;

    practice_chosen(&play->practice, &start);
    power_again(play, start);
}

/* Asks first if a run would be lost. */
void play_practice_poll(struct play *play)
{
    struct practice_menu *menu = &play->practice;

    play_set_speed(play, menu->speed);
    play->overlay.on[OVERLAY_HITBOXES] = menu->hitbox;
    if (!menu->start_chosen)
        return;
    menu->start_chosen = false;
    if (play_has_run(play) && !play->start.practice.section[0])
        screens_ask(&play->screens, "Practise? This run ends.", "Practice", start_practice, play);
    else
        start_practice(play);
}
