/*
 * play_reload.c - changes in the game's folder, and the work of a seek or a reload (session.c does it).
 */
#include <string.h>
#include "../../../platform/platform.h"
#include "play_state.h"

enum {
    CHECK_EVERY = 15, /* frames between two checks of the game's folder */
    WORK_USEC = 12000 /* of a frame spent on a seek or a reload */
};

static void reload_failed(struct play *play)
{
    play_show_message(play, MESSAGE_UNTIL_RELOAD, "%s", play->session.err);
    play_log(play, "curtain: reload failed: %s", play->session.err);
}

void play_reload(struct play *play)
{
    const struct play_options *o = &play->options;

    if (play->replay.home) {
        play_show_message(play, MESSAGE_FRAMES, "An older version is running: changes take effect at the title");
        return;
    }
    if (!o->path) {
        play_show_message(play, MESSAGE_FRAMES, "The built-in game cannot be reloaded");
        return;
    }
    play_save_nvram(play); /* a reloaded run's nvram is not saved */
    if (session_reload(&play->session, o->load, o->path, o->nearest))
        play->message.frames = 0;
    else
        reload_failed(play);
}

void play_check_folder(struct play *play)
{
    struct play_reload *r = &play->reload;

    if (play->replay.demo && play->session.demo) /* a replay is shown as it was recorded */
        return;
    if (r->due) {
        r->due = false;
        play_reload(play);
    }
    if (++r->frames_since_check < CHECK_EVERY)
        return;
    r->frames_since_check = 0;
    r->due = folder_changed(&r->folder);
    if (r->due) /* loading may take long: show the reason first */
        play_show_message(play, MESSAGE_FRAMES, "Reloading");
}

void play_apply_rom(struct play *play)
{
    const struct manifest *m = &play_cart(play)->manifest;
    struct picture *p = &play->drawing.picture;
    const int w = p->fb.w, h = p->fb.h;

    play->report.fault_reported = false;
    practice_reloaded(&play->practice, play_cart(play));
    picture_close(p);
    if (!picture_open(p, play_board(play))) {
        plat_log("curtain: out of memory for the picture");
        play->result = RESULT_HOST_FAILED;
        play->quit = true;
        return;
    }
    if (w != m->screen_w || h != m->screen_h || strcmp(play->window.title, m->title) != 0 ||
        play->window.config.sound_rate != play_sound_rate(play))
        play_update_window(play);
}

static void finish_reload(struct play *play)
{
    attract_end(&play->attract); /* its board reads the ROM that was freed */
    play_apply_rom(play);
    play_log(play, "curtain: %s: reloaded", play_game_name(play));
    if (play->session.missing_music[0])
        play_log(play, "curtain: %s: the music \"%s\" was playing and is no longer in the game", play_game_name(play),
                 play->session.missing_music);
    play_show_message(play, MESSAGE_FRAMES / 3, "Reloaded");
}

void play_continue_work(struct play *play, uint64_t now)
{
    const struct session *s = &play->session;
    const bool reloads = s->state == SESSION_RELOADING;

    if (!session_work(&play->session, now + WORK_USEC)) {
        if (reloads)
            reload_failed(play);
        else
            play_check_recording(play, false);
    } else if (reloads && s->state == SESSION_PLAYING) {
        finish_reload(play);
    }
    if (s->state == SESSION_PLAYING)
        play_resume_finish(play);
    play_report_difference(play);
    play_report_fault(play);
}
