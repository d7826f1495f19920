/*
 * cab_practice.c - the practice menu and the retry key. Each attempt is a power-on.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "../../base/hash.h"
#include "cab_parts.h"

uint64_t cab_seed_from_clock(void)
{
    return hash_fold(hash_fold(0, (uint64_t)time(0)), plat_usec());
}

/* Powers the board again, with another start. */
static void power_anew(struct cab *cab, struct board_start start)
{
    bool reloads = cab->session.state == SESSION_RELOADING;
    const struct session_run *before = cab->session.now;

    cab_keep_leave(cab);
    cab_save_nvram(cab);
    start.nvram = cab->options.start.nvram;
    start.nvram_size = cab->options.start.nvram_size;
    uint8_t *nvram = cab_load_nvram(cab, &start);
    if (!session_restart(&cab->session, &start)) {
        cab_notice(cab, CAB_NOTICE_FRAMES, "%s", cab->session.err);
        cab_say(cab, "curtain: %s", cab->session.err);
    }
    if (cab->session.now == before) { /* as it was */
        free(nvram);
        return;
    }
    free(cab->nvram);
    cab->nvram = nvram;
    cab_guest_forget(cab);
    cab_powered(cab, &start);
    practice_began(&cab->practice, &start);
    cab_report_ready(cab);
    cab_log_lines(cab, board_last_output(cab_live(cab)));
    if (cab_fault(cab))
        cab_report_fault(cab);
    if (reloads)
        cab_reload(cab);
}

/* Practice may not end a playback, nor the recording of a game from its title. */
static bool may_practise(struct cab *cab)
{
    bool records = cab->session.record && !cab->start.practice.section[0];

    if (cab->session.demo || records)
        cab_notice(cab, CAB_NOTICE_FRAMES,
                   records ? "Practice is unavailable while this run is being recorded"
                           : "Practice is unavailable in a replay");
    return !cab->session.demo && !records;
}

static void retry(struct cab *cab)
{
    if (cab->start.practice.section[0])
        power_anew(cab, cab->start);
    else
        cab_notice(cab, CAB_NOTICE_FRAMES, "Nothing to retry: choose a section first");
}

void cab_open_practice(struct cab *cab)
{
    if (!may_practise(cab))
        return;
    if (cab->attracting)
        cab_attract_end(cab);
    cab->practice.hitbox = cab->overlay.on[OVERLAY_SHAPES];
    practice_open(&cab->practice, &cab->screens, cab->slow);
}

void cab_home_start(struct cab *cab, struct board_start *start)
{
    *start = cab->practice.home;
    start->nvram = cab->options.start.nvram;
    start->nvram_size = cab->options.start.nvram_size;
    snprintf(start->lang, sizeof start->lang, "%s", cab->options.start.lang);
    if (!start->lang[0])
        cab_take_lang(cab, start);
    if (!cab->options.seeded)
        start->seed = cab_seed_from_clock();
}

void cab_begin_anew(struct cab *cab)
{
    struct board_start start;
    char path[CAB_NAME];

    if (cab->guest.home || cab->session.demo) {
        cab_home(cab);
        return;
    }
    cab_home_start(cab, &start);
    power_anew(cab, start);
    cab_resume_path(cab, path);
    if (!cab->unsaved.runs && !cab->unsaved.left_run)
        plat_remove(path); /* it was ended, not left: a replay is all that stays */
}

void cab_practice_keys(struct cab *cab, const struct keys_read *k)
{
    if (k->pressed & 1 << CAB_RETRY && may_practise(cab)) {
        if (cab->attracting)
            cab_attract_end(cab);
        retry(cab);
    } else if (k->pressed & 1 << CAB_PRACTICE) {
        cab_open_practice(cab);
    }
}

void cab_practice_screen(struct cab *cab)
{
    struct board_start start;

    if (cab->practice.slow != cab->slow)
        cab_mark_assisted(cab);
    cab->slow = cab->practice.slow;
    cab->overlay.on[OVERLAY_SHAPES] = cab->practice.hitbox;
    if (!cab->practice.start_chosen)
        return;
    cab->practice.start_chosen = false;
    practice_chosen(&cab->practice, &start);
    if (!start.practice.section[0] && cab->guest.home) {
        cab_home(cab);
        return;
    }
    if (!start.practice.section[0] && !cab->options.seeded)
        start.seed = cab_seed_from_clock();
    power_anew(cab, start);
    if (!start.practice.section[0])
        cab_open_resume(cab);
}

void cab_powered(struct cab *cab, const struct board_start *start)
{
    cab->start = *start;
    cab->nvram_saved = 0;
    cab->fault_reported = cab->paused = cab->scrubbed = cab->awaits = cab->taken = false;
    cab->timebar_left = cab->slow_frames = 0;
    memset(cab->pads, 0, sizeof cab->pads);
    cab_pads_power(cab);
    if (cab->slow > 1 && !cab->session.demo)
        cab_mark_assisted(cab);
}

void cab_take_lang(struct cab *cab, struct board_start *start)
{
    struct words words;

    if (cart_open_lang(cab->options.cart, cab->config.lang, &words))
        snprintf(start->lang, sizeof start->lang, "%s", cab->config.lang);
}
