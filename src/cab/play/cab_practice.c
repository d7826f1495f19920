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
static void power_anew(struct board_start start)
{
    bool reloads = cab.session.state == SESSION_RELOADING;
    const struct session_run *before = cab.session.now;

    cab_keep_leave();
    cab_save_nvram();
    start.nvram = cab.options.start.nvram;
    start.nvram_size = cab.options.start.nvram_size;
    uint8_t *nvram = cab_load_nvram(&start);
    if (!session_restart(&cab.session, &start)) {
        cab_notice(CAB_NOTICE_FRAMES, "%s", cab.session.err);
        cab_say("curtain: %s", cab.session.err);
    }
    if (cab.session.now == before) { /* as it was */
        free(nvram);
        return;
    }
    free(cab.nvram);
    cab.nvram = nvram;
    cab_guest_forget();
    cab_powered(&start);
    practice_began(&cab.practice, &start);
    cab_report_ready();
    cab_log_lines(board_last(cab_live()));
    if (cab_fault())
        cab_report_fault();
    if (reloads)
        cab_reload();
}

/* Practice may not end a playback, nor the recording of a game from its title. */
static bool may_practise(void)
{
    bool records = cab.session.record && !cab.start.practice.section[0];

    if (cab.session.demo || records)
        cab_notice(CAB_NOTICE_FRAMES,
                   records ? "no practice: this recording is of the game from its title" : "no practice in a demo");
    return !cab.session.demo && !records;
}

static void retry(void)
{
    if (cab.start.practice.section[0])
        power_anew(cab.start);
    else
        cab_notice(CAB_NOTICE_FRAMES, "nothing to try again: choose a piece first");
}

void cab_open_practice(void)
{
    if (!may_practise())
        return;
    if (cab.attracting)
        cab_attract_end();
    cab.practice.hitbox = cab.overlay.on[OVERLAY_SHAPES];
    practice_open(&cab.practice, &cab.screens, cab.slow);
}

void cab_home_start(struct board_start *start)
{
    *start = cab.practice.home;
    start->nvram = cab.options.start.nvram;
    start->nvram_size = cab.options.start.nvram_size;
    snprintf(start->lang, sizeof start->lang, "%s", cab.options.start.lang);
    if (!start->lang[0])
        cab_take_lang(start);
    if (!cab.options.seeded)
        start->seed = cab_seed_from_clock();
}

void cab_begin_anew(void)
{
    struct board_start start;
    char path[CAB_NAME];

    if (cab.guest.home || cab.session.demo) {
        cab_home();
        return;
    }
    cab_home_start(&start);
    power_anew(start);
    cab_resume_path(path);
    plat_remove(path); /* it was ended, not left: a replay is all that stays */
}

void cab_practice_keys(const struct keys_read *k)
{
    if (k->pressed & 1 << CAB_RETRY && may_practise()) {
        if (cab.attracting)
            cab_attract_end();
        retry();
    } else if (k->pressed & 1 << CAB_PRACTICE) {
        cab_open_practice();
    }
}

void cab_practice_screen(void)
{
    struct board_start start;

    if (cab.practice.slow != cab.slow)
        cab_mark_assisted();
    cab.slow = cab.practice.slow;
    cab.overlay.on[OVERLAY_SHAPES] = cab.practice.hitbox;
    if (!cab.practice.start_chosen)
        return;
    cab.practice.start_chosen = false;
    practice_chosen(&cab.practice, &start);
    if (!start.practice.section[0] && cab.guest.home) {
        cab_home();
        return;
    }
    if (!start.practice.section[0] && !cab.options.seeded)
        start.seed = cab_seed_from_clock();
    power_anew(start);
    if (!start.practice.section[0])
        cab_open_resume();
}
