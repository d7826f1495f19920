/*
 * cab.c - see cab.h: power, the frame, and its clock.
 *
 * Whoever has the loop calls cab_frame, so all state is in one struct. When a frame is due, and how many ticks it has,
 * pace.h says. The switches are read just before the tick, so nothing of them is older than what the tick and the
 * picture take.
 */
#include "cab.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/clock.h"
#include "cab_parts.h"
#include "../../common/files.h"

enum {
    SECOND = 1000000,
    MAX_TURBO = 32,     /* ticks a frame */
    TURBO_USEC = 12000, /* of a frame spent on them */
    LOOK_USEC = 1000,   /* between two looks at what waits at the speaker */
    SAVE_EVERY = 60     /* frames */
};

/* ---- time ---- */

/* Where the speaker's clock leads, a frame is due when it has used one up; or after a second, for it may be stuck. */
static bool speaker_says(struct cab *cab, uint64_t now)
{
    pace_refresh(&cab->pace, 0, now);
    if (!speaker_due(&cab->speaker) && now < pace_due(&cab->pace) + SECOND) {
        plat_wait(now + LOOK_USEC);
        return false;
    }
    pace_follow(&cab->pace, now);
    return true;
}

/* Waits for the next frame. False: it has not come. */
static bool frame_comes(struct cab *cab)
{
    if (speaker_leads(&cab->speaker))
        return speaker_says(cab, plat_usec());
    pace_refresh(&cab->pace, cab->window.refresh, plat_usec());
    plat_wait(pace_due(&cab->pace));
    return pace_comes(&cab->pace, plat_usec());
}

/* Frames that are due by now, at least one. */
static struct speaker_time frames_due(struct cab *cab, uint64_t now)
{
    const struct pace_frame f = pace_take(&cab->pace, now);

    cab->frames += (uint64_t)f.ticks;
    return (struct speaker_time){ .sixtieths = f.ticks, .late = f.due, .lost = f.lost };
}

/* What was ticked is heard. */
static void frame_sounds(struct cab *cab, struct speaker_time *time)
{
    time->slow = cab->slow;
    time->late = clock_since(time->late);
    speaker_frame(&cab->speaker, time);
    cab->speaker.meter = cab->overlay.on[OVERLAY_MIXER];
    overlay_listen(&cab->overlay, cab->attracting ? cab->attract_guard.board : cab_live(cab), &cab->speaker);
}

static void turbo(struct cab *cab, uint64_t now)
{
    const bool attracting = cab->attracting;
    const uint32_t before = board_frame(cab_live(cab));

    for (int i = 0; i < MAX_TURBO && plat_usec() - now < TURBO_USEC; i++)
        cab_tick(cab);
    if (attracting ? cab->attracting : board_frame(cab_live(cab)) != before)
        cab_hear_once(cab, SPEAKER_FAST);
}

/* Frame by frame, as each of them is heard. */
static void rewind_by(struct cab *cab, int frames)
{
    for (int i = 0; i < frames; i++) {
        const uint32_t before = board_frame(cab_live(cab));
        cab_rewind(cab, 1);
        if (cab->session.state == SESSION_PLAYING && board_frame(cab_live(cab)) < before)
            cab_hear_once(cab, SPEAKER_BACK);
    }
}

/* In slow motion: is this one of the frames that tick? */
static bool slow_tick_due(struct cab *cab)
{
    cab->slow_frames = (cab->slow_frames + 1) % cab->slow;
    return cab->slow_frames == 0;
}

/* Presses are collected in cab.pads until a tick has seen them; those of a pause are lost. */
static void run(struct cab *cab, int frames, const struct keys_read *k, uint64_t now)
{
    bool fast = k->held & 1 << CAB_TURBO, ticked = cab->paused;
    cab->rewinding = k->held & 1 << CAB_REWIND && !cab->attracting;
    cab->quiet = cab->paused || fast;
    if (cab->prompt.open)
        return;
    if (cab->rewinding) {
        rewind_by(cab, frames);
        cab->step = false;
        memset(cab->pads, 0, sizeof cab->pads);
        return;
    }
    if (cab->paused && cab->step)
        cab_step(cab);
    else if (fast && !cab->paused)
        turbo(cab, now);
    for (int i = 0; i < frames && !cab->paused && !fast; i++)
        if (slow_tick_due(cab)) {
            cab_tick(cab);
            ticked = true;
        }
    cab->step = false;
    if (ticked || fast)
        memset(cab->pads, 0, sizeof cab->pads);
}

/* ---- nvram ---- */

static void save_records(struct cab *cab)
{
    char err[FILES_ERR_SIZE];

    if (!records_save(&cab->practice.records, &cab->unsaved.files, err, sizeof err))
        cab_save_failed(cab, err);
}

/* ---- power ---- */

static void report_sound(struct cab *cab)
{
    char line[256];

    speaker_report(&cab->speaker, line, sizeof line);
    cab_say(cab, "curtain: %s", line);
}

/* Ends a run. */
static void finish(struct cab *cab)
{
    screens_close_all(&cab->screens);
    cab_keep_leave(cab);
    cab_save_nvram(cab);
    save_records(cab);
    if (cab_fault(cab))
        cab->result = RESULT_REFUSED;
    if (cab->options.verbose)
        report_sound(cab);
    if (cab->attracting)
        cab_attract_end(cab);
}

/* A frame while a folder is waited for. */
static bool wait_frame(struct cab *cab, uint64_t now)
{
    frames_due(cab, now);
    cab_wait_frame(cab);
    return !cab->quit;
}

bool cab_frame(struct cab *cab)
{
    struct keys_read k;
    if (cab->quit)
        return false;
    if (!frame_comes(cab))
        return true;
    cab_report_arm(cab);
    cab_film(cab, &cab->picture);
    uint64_t now = plat_usec();
    if (cab->waiting.on)
        return wait_frame(cab, now);
    cab_poll(cab, &k);
    cab_check_folder(cab);
    struct speaker_time time = frames_due(cab, now);
    cab->ticked = false;
    overlay_begin(&cab->overlay, cab->attracting ? &cab->attract_guard : &cab->session.now->guard);
    if (cab->session.state != SESSION_PLAYING)
        cab_seek_or_reload(cab, now);
    else if (cab->console.open || cab->stands || screens_are_open(&cab->screens))
        memset(cab->pads, 0, sizeof cab->pads);
    else
        run(cab, time.sixtieths, &k, now);
    frame_sounds(cab, &time);
    cab_retry(cab);
    cab->timebar_left -= cab->timebar_left > 0;
    cab->notice_left -= cab->notice_left > 0;
    if (++cab->since_save >= SAVE_EVERY) {
        cab->since_save = 0;
        cab_save_nvram(cab);
        save_records(cab);
    }
    overlay_lap(&cab->overlay, SPLIT_CABINET);
    cab_look_ahead(cab);
    cab_picture_draw(cab, &cab->picture);
    overlay_lap(&cab->overlay, SPLIT_DRAW);
    cab_picture_show(cab, &cab->picture);
    cab_look_back(cab);
    pace_worked(&cab->pace, cab->window.handed - now);
    overlay_lap(&cab->overlay, SPLIT_SHOW);
    overlay_end(&cab->overlay);
    return !cab->quit;
}

/* All that belongs to a run; harmless where there is none. */
static void close_run(struct cab *cab)
{
    cab_report_close(cab);
    practice_close(&cab->practice);
    if (!session_close(&cab->session)) {
        cab_say(cab, "curtain: %s", cab->session.err);
        cab->result = cab->result == RESULT_DONE ? RESULT_HOST_FAILED : cab->result;
    }
    cab_picture_close(&cab->picture);
    cab_window_close(cab);
    free(cab->nvram);
    cab->nvram = NULL;
}

/* The run cannot be: a folder's is waited for, if its own files are why. */
static bool refuse(struct cab *cab, enum result result, const char *what)
{
    char why[FILES_ERR_SIZE + sizeof cab->session.err];

    snprintf(why, sizeof why, "%s: %s", cab_game(cab), what);
    close_run(cab);
    cab->result = result;
    if (result == RESULT_REFUSED && cab->options.open && cab_wait(cab, why, ""))
        return false;
    if (result != RESULT_REFUSED || !cab->options.open)
        cab_say(cab, "curtain: %s", why);
    cab->quit = true;
    return false;
}

/* A folder's scripts that fault at power-on are as one that cannot be loaded: nothing has been played yet. */
static bool wait_for_fault(struct cab *cab)
{
    struct board_fault fault = *cab_fault(cab);
    char why[FILES_PATH_SIZE + sizeof fault.message + 4];

    cab_log_lines(cab, board_last_output(cab_live(cab)));
    snprintf(why, sizeof why, "%s: %s", cab_game(cab), fault.message);
    close_run(cab);
    if (!cab_wait(cab, why, fault.trace))
        cab->quit = true;
    return false;
}

/* What was typed comes before what is in the file. */
static void take_options(struct cab *cab)
{
    const struct cab_options *o = &cab->options;

    cab->config.scale = o->scale ? o->scale : cab->config.scale;
    cab->config.fullscreen = o->fullscreen || cab->config.fullscreen;
}

/* Why plat_open failed. */
static const char *no_window(void)
{
    char about[128];

    plat_describe_build(about, sizeof about);
    if (strcmp(about, "no window") == 0)
        return "cannot open a window: this build has no window support. Play with curtain, or write pictures with "
               "curtain-null "
               "render";
    return "cannot open a window";
}

bool cab_power(struct cab *cab)
{
    const struct cab_options *o = &cab->options;

    cab->result = RESULT_DONE; /* what was waited for is there */
    cab->start = o->start;
    if (!cab->start.lang[0] && !o->demo)
        cab_take_lang(cab, &cab->start);
    if (!o->seeded && !o->demo)
        cab->start.seed = cab_seed_from_clock();
    cab->nvram = cab_load_nvram(cab, &cab->start);
    if (!session_open(&cab->session, o->cart, &cab->start, o->demo, o->record))
        return refuse(cab, RESULT_REFUSED, cab->session.err);
    if (cab_fault(cab) && o->open && !o->demo)
        return wait_for_fault(cab);
    if (!cab_open_window(cab))
        return refuse(cab, RESULT_HOST_FAILED, no_window());
    cab_picture_close(&cab->picture);
    if (!cab_picture_open(&cab->picture, cab_live(cab)))
        return refuse(cab, RESULT_HOST_FAILED, "out of memory for the picture");
    practice_init(&cab->practice, o->cart, &cab->start);
    if (!o->demo)
        practice_began(&cab->practice, &cab->start);
    cab_report_last_crash(cab);
    cab_report_ready(cab);
    cab_check_recording(cab, !cab->session.err[0]);
    if (cab->slow > 1 && !o->demo)
        cab_mark_assisted(cab);
    cab_log_lines(cab, board_last_output(cab_live(cab)));
    if (cab_fault(cab))
        cab_report_fault(cab);
    folder_open(&cab->folder, o->path);
    cab_open_resume(cab);
    cab_pads_power(cab);
    pace_open(&cab->pace, plat_usec());
    return true;
}

void cab_begin(struct cab *cab)
{
    const struct cab_options *o = &cab->options;

    cab->kept = cab->config;
    speaker_open(&cab->speaker, cab->config.volume, o->mute || cab->config.mute, !cab->config.resample);
    speaker_levels(&cab->speaker, cab->config.music, cab->config.sounds);
    cab->slow = 1 << cab->config.speed;
    take_options(cab);
    cab_pads_open(cab);
    pace_open(&cab->pace, plat_usec());
    if (o->cart)
        cab_power(cab);
    else
        cab->quit = !cab_wait(cab, o->wrong, "");
}

struct cab *cab_open(const struct cab_options *options)
{
    char err[FILES_ERR_SIZE + CONFIG_LINE];
    struct cab *cab = calloc(1, sizeof *cab);

    if (!cab)
        return NULL;
    cab->options = *options;
    if (config_load(&cab->config, err, sizeof err)) {
        cab_begin(cab);
    } else {
        cab_pads_open(cab);
        cab->quit = !cab_wait_settings(cab, err);
    }
    return cab;
}

bool cab_next(const struct cab *cab, char *path, size_t size)
{
    return cab->dropped[0] && snprintf(path, size, "%s", cab->dropped) < (int)size;
}

enum result cab_close(struct cab *cab)
{
    if (cab->session.now)
        finish(cab);
    cab_retry_last(cab);
    close_run(cab);
    cab_guest_close(cab);
    speaker_close(&cab->speaker);
    console_close(&cab->console);
    ahead_close(&cab->ahead);
    plat_close();
    const enum result result = cab->result;
    free(cab);
    return result;
}
