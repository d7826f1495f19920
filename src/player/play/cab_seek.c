/*
 * cab_seek.c - the player moves the run: to another frame, out of a playback, or to a changed game.
 */
#include <stdio.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/files.h"
#include "cab_parts.h"

enum {
    LOOK_EVERY = 15, /* frames between two looks at the game's folder */
    BAR_STAYS = 120  /* frames the time bar is shown after its last use */
};

/* ---- to another frame ---- */

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

/* ---- out of a playback ---- */

void cab_take_over(struct cab *cab)
{
    char shown[FILES_PATH_SIZE];

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

/* ---- to a changed game ---- */

void cab_reload_failed(struct cab *cab)
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
    if (session_reload(&cab->session, cab->options.load, cab->options.path, cab->options.nearest)) {
        cab->notice_left = 0;
        return;
    }
    cab_reload_failed(cab);
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
    const struct manifest *m = &cab_cart(cab)->manifest;
    const int w = cab->picture.fb.w, h = cab->picture.fb.h;

    cab->fault_reported = false;
    practice_reloaded(&cab->practice, cab_cart(cab));
    cab_report_ready(cab);
    cab_picture_close(&cab->picture);
    if (!cab_picture_open(&cab->picture, cab_live(cab))) {
        plat_log("curtain: out of memory for the picture");
        cab->result = RESULT_HOST_FAILED;
        cab->quit = true;
        return;
    }
    if (w != m->screen_w || h != m->screen_h || strcmp(cab->title, m->title) != 0 ||
        cab->want.sound_rate != cab_sound_rate(cab))
        cab->quit = !cab_open_window(cab) || cab->quit;
}
