/*
 * play.c - opening a window, its frames, and closing it (play.h).
 *
 * The caller has the loop and calls play_frame, so all state is in one struct. pace.h decides when a frame is due and
 * how many ticks it has. The input is read just before the tick, so it is no older than the time that the tick and the
 * picture take.
 */
#include "play.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/clock.h"
#include "play_state.h"
#include "../../common/files.h"

enum {
    SECOND = 1000000,
    MAX_TURBO = 32,     /* ticks a frame */
    TURBO_USEC = 12000, /* of a frame spent on turbo ticks */
    CHECK_USEC = 1000,  /* between two checks of the speaker's queue */
    SAVE_EVERY = 60     /* frames */
};

/* ---- time ---- */

/* Returns whether a frame is due by the sound card's clock, or after a second in case the card is stuck. */
static bool speaker_frame_due(struct play *play, uint64_t now)
{
    pace_refresh(&play->pace, 0, now);
    if (!speaker_is_due(&play->speaker) && now < pace_due(&play->pace) + SECOND) {
        plat_wait(now + CHECK_USEC);
        return false;
    }
    pace_follow(&play->pace, now);
    return true;
}

/* Returns false if plat_wait returned before the frame is due. */
static bool wait_for_frame(struct play *play)
{
    if (speaker_sets_pace(&play->speaker))
        return speaker_frame_due(play, plat_usec());
    pace_refresh(&play->pace, play->window.refresh, plat_usec());
    plat_wait(pace_due(&play->pace));
    return pace_frame_due(&play->pace, plat_usec());
}

/* Takes the frames that are due by now, at least one. */
static struct speaker_elapsed take_frames(struct play *play, uint64_t now)
{
    const struct pace_frame f = pace_take(&play->pace, now);

    play->time.frames += (uint64_t)f.ticks;
    return (struct speaker_elapsed){ .sixtieths = f.ticks, .late = f.due, .lost = f.lost };
}

static void play_frame_audio(struct play *play, struct speaker_elapsed *time)
{
    time->speed = play->time.rewinding || play->time.quiet || play->time.stopped ? PLAY_FULL_SPEED : play->time.speed;
    time->late = clock_since(time->late);
    speaker_advance(&play->speaker, time);
    play->speaker.metering = play->overlay.on[OVERLAY_MIXER];
    overlay_update_mixer(&play->overlay, play_shown_board(play), &play->speaker);
}

static void turbo(struct play *play, uint64_t now)
{
    const bool attract = play->attract.on;
    const uint32_t before = board_frame(play_board(play));

    for (int i = 0; i < MAX_TURBO && plat_usec() - now < TURBO_USEC; i++)
        play_tick(play);
    if (attract ? play->attract.on : board_frame(play_board(play)) != before)
        play_queue_sound(play, SPEAKER_FAST);
}

/* Rewinds frame by frame, because each frame is heard. */
static void rewind_by(struct play *play, int frames)
{
    for (int i = 0; i < frames; i++) {
        const uint32_t before = board_frame(play_board(play));
        play_rewind(play, 1);
        if (play->session.state == SESSION_PLAYING && board_frame(play_board(play)) < before)
            play_queue_sound(play, SPEAKER_REVERSE);
    }
}

void play_set_speed(struct play *play, int percent)
{
    if (percent != play->time.speed)
        play_mark_assisted(play);
    play->time.speed = percent;
}

/* Returns whether the board ticks in this frame. */
static bool tick_due(struct play_time *time)
{
    const bool due = (time->due += time->speed) >= PLAY_FULL_SPEED;

    time->due -= due ? PLAY_FULL_SPEED : 0;
    return due;
}

/* Presses accumulate in pads.held until a tick has seen them; those of a pause are dropped. */
static void run(struct play *play, int frames, const struct keys_state *k, uint64_t now)
{
    struct play_time *time = &play->time;
    bool fast = k->held & 1 << HOTKEY_TURBO, clear = time->paused || fast;

    time->rewinding = k->held & 1 << HOTKEY_REWIND && !play->attract.on;
    time->quiet = time->paused || fast;
    if (play->prompt.open)
        return;
    if (time->rewinding) {
        rewind_by(play, frames);
        clear = true;
    } else {
        if (time->paused && time->step)
            play_step(play);
        else if (fast && !time->paused)
            turbo(play, now);
        for (int i = 0; i < frames && !time->paused && !fast; i++)
            if (tick_due(time)) {
                play_tick(play);
                clear = true;
            }
    }
    time->step = false;
    if (clear)
        memset(play->pads.held, 0, sizeof play->pads.held);
}

/* ---- the frame ---- */

static void save_scores(struct play *play)
{
    char err[FILES_ERR_SIZE];

    play_save_nvram(play);
    if (!records_save(&play->practice.records, &play->unsaved.files, err, sizeof err))
        play_save_failed(play, err);
}

static void save_regularly(struct play *play)
{
    if (++play->nvram.frames_since_save < SAVE_EVERY)
        return;
    play->nvram.frames_since_save = 0;
    save_scores(play);
}

/* Returns whether no board ticks in this frame. */
static bool is_frozen(const struct play *play)
{
    return play->session.state != SESSION_PLAYING || play->console.open || play->time.stopped ||
           screens_are_open(&play->screens);
}

static void draw_frame(struct play *play)
{
    struct drawing *d = &play->drawing;

    play_look_ahead(play);
    play_draw(play, &d->picture);
    overlay_add_time(&play->overlay, STEP_DRAW);
    play_show(play, &d->picture);
    ahead_end(&d->ahead, &play->session.now->guard);
}

bool play_frame(struct play *play)
{
    struct keys_state k;

    if (play->quit)
        return false;
    if (!wait_for_frame(play))
        return true;
    play_save_clip(play, &play->drawing.picture);
    const uint64_t now = plat_usec();
    if (play->waiting.on) {
        take_frames(play, now);
        play_wait_frame(play);
        return !play->quit;
    }
    play_poll(play, &k);
    play_check_folder(play);
    play_start_screen_sounds(play);
    struct speaker_elapsed time = take_frames(play, now);
    play->time.ticked = false;
    overlay_begin_frame(&play->overlay, play->attract.on ? &play->attract.guard : &play->session.now->guard);
    if (play->session.state != SESSION_PLAYING)
        play_continue_work(play, now);
    else if (is_frozen(play))
        memset(play->pads.held, 0, sizeof play->pads.held);
    else
        run(play, time.sixtieths, &k, now);
    if (is_frozen(play))
        play_queue_screen_sound(play, time.sixtieths);
    play_frame_audio(play, &time);
    play_retry_saves(play);
    play->seek.bar_frames -= play->seek.bar_frames > 0;
    play->message.frames -= play->message.frames > 0;
    play->replay.hint_frames -= play->replay.hint_frames > 0;
    save_regularly(play);
    overlay_add_time(&play->overlay, STEP_PROGRAM);
    draw_frame(play);
    pace_worked(&play->pace, play->window.handed_over - now);
    overlay_add_time(&play->overlay, STEP_SHOW);
    overlay_end_frame(&play->overlay);
    return !play->quit;
}

/* ---- opening and closing ---- */

/* Saves everything of a run. */
static void end_run(struct play *play)
{
    char line[256];

    screens_close_all(&play->screens);
    play_autosave_end(play);
    save_scores(play);
    if (play_fault(play))
        play->result = RESULT_REFUSED;
    if (play->options.verbose) {
        speaker_report(&play->speaker, line, sizeof line);
        play_log(play, "curtain: %s", line);
    }
    attract_end(&play->attract);
}

/* Frees everything of a run; harmless if there is none. */
static void close_run(struct play *play)
{
    practice_close(&play->practice);
    if (!session_close(&play->session)) {
        play_log(play, "curtain: %s", play->session.err);
        play->result = play->result == RESULT_DONE ? RESULT_HOST_FAILED : play->result;
    }
    picture_close(&play->drawing.picture);
    play_window_close(&play->window);
    free(play->nvram.image);
    play->nvram.image = NULL;
}

/* Reports that the game can't run. If the reason is in the files of a folder, waits for a change. */
static bool refuse(struct play *play, enum result result, const char *reason)
{
    char why[FILES_ERR_SIZE + sizeof play->session.err];

    snprintf(why, sizeof why, "%s: %s", play_game_name(play), reason);
    close_run(play);
    play->result = result;
    if (result == RESULT_REFUSED && play->options.open && play_wait_for_folder(play, why, ""))
        return false;
    if (result != RESULT_REFUSED || !play->options.open)
        play_log(play, "curtain: %s", why);
    play->quit = true;
    return false;
}

/* A fault at power-on is treated like a folder that can't be loaded: nothing has been played yet. */
static bool wait_for_fault(struct play *play)
{
    struct board_fault fault = *play_fault(play);
    char why[FILES_PATH_SIZE + sizeof fault.message + 4];

    play_log_output(play);
    snprintf(why, sizeof why, "%s: %s", play_game_name(play), fault.message);
    close_run(play);
    if (!play_wait_for_folder(play, why, fault.trace))
        play->quit = true;
    return false;
}

/* Returns why plat_open failed. */
static const char *window_error(void)
{
    char about[128];

    plat_describe_build(about, sizeof about);
    if (strcmp(about, "no window") == 0)
        return "cannot open a window: this build has no window support. Play with curtain, or write pictures with "
               "curtain-null render";
    return "cannot open a window";
}

static bool open_session(struct play *play)
{
    const struct play_options *o = &play->options;

    play->start = o->start;
    if (!o->demo)
        play_set_host_start(play, &play->start);
    if (!o->seeded && !o->demo)
        play->start.seed = play_clock_seed();
    play->nvram.image = play_load_nvram(play, &play->start);
    return session_open(&play->session, o->cart, &play->start, o->demo, o->record);
}

bool play_power_on(struct play *play)
{
    const struct play_options *o = &play->options;

    play->result = RESULT_DONE; /* also after an error that was waited out */
    if (!open_session(play))
        return refuse(play, RESULT_REFUSED, play->session.err);
    if (play_fault(play) && o->open && !o->demo)
        return wait_for_fault(play);
    if (!play_open_window(play))
        return refuse(play, RESULT_HOST_FAILED, window_error());
    picture_close(&play->drawing.picture);
    if (!picture_open(&play->drawing.picture, play_board(play)))
        return refuse(play, RESULT_HOST_FAILED, "out of memory for the picture");
    practice_init(&play->practice, o->cart, &play->start, o->open != NULL);
    if (!o->demo)
        practice_start_run(&play->practice, &play->start);
    play_check_recording(play, !play->session.err[0]);
    if (play->time.speed < PLAY_FULL_SPEED && !o->demo)
        play_mark_assisted(play);
    play_log_output(play);
    play_report_fault(play);
    folder_open(&play->reload.folder, o->path);
    play_offer_resume(play);
    play_pads_power(&play->pads);
    pace_open(&play->pace, plat_usec());
    return true;
}

void play_start(struct play *play)
{
    const struct play_options *o = &play->options;
    struct config *c = &play->config;

    play->saved_config = *c;
    speaker_open(&play->speaker, c->volume, o->mute || c->mute, !c->resample);
    speaker_set_levels(&play->speaker, c->music, c->sounds);
    play->time.speed = c->speed;
    c->scale = o->scale ? o->scale : c->scale;
    c->fullscreen = o->fullscreen || c->fullscreen;
    play_pads_open(play);
    pace_open(&play->pace, plat_usec());
    if (o->cart)
        play_power_on(play);
    else
        play->quit = !play_wait_for_folder(play, o->wrong, "");
}

struct play *play_open(const struct play_options *options)
{
    char err[FILES_ERR_SIZE + CONFIG_LINE];
    struct play *play = calloc(1, sizeof *play);

    if (!play)
        return NULL;
    play->options = *options;
    if (config_load(&play->config, err, sizeof err)) {
        play_start(play);
    } else {
        play_pads_open(play);
        play->quit = !play_wait_for_settings(play, err);
    }
    return play;
}

bool play_dropped_game(const struct play *play, char *path, size_t size)
{
    return play->drop.accepted[0] && snprintf(path, size, "%s", play->drop.accepted) < (int)size;
}

enum result play_close(struct play *play)
{
    if (play->session.now)
        end_run(play);
    play_final_retry(play);
    close_run(play);
    play_close_replay(play);
    speaker_close(&play->speaker);
    free(play->screen_sound.block);
    console_close(&play->console);
    ahead_close(&play->drawing.ahead);
    plat_close();
    const enum result result = play->result;
    free(play);
    return result;
}
