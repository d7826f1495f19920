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
#include "../host/clean.h"
#include "../host/files.h"

enum {
    LOOK_EVERY = 15,  /* frames between two looks at the game's folder */
    BAR_STAYS = 120,  /* frames the time bar is shown after its last use */
    WORK_USEC = 12000 /* of a frame spent on a seek or a reload */
};

/* ---- messages ---- */

/* Into the window's log, which has the frame as well. */
static void note(enum log_kind kind, const char *line)
{
    const struct board *b = cab.session.now ? cab_live() : NULL;

    log_add(&cab.log, kind, b ? board_frame(b) : 0, line);
}

void cab_say(const char *format, ...)
{
    char line[2 * FILES_PATH + 256];
    va_list args;

    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    clean_line(line);
    plat_log(line);
    note(LOG_TOLD, line);
}

const char *cab_game(void)
{
    return cab.options.path ? cab.options.path : cab.options.cart->m.id;
}

const struct cart *cab_cart(void)
{
    return cab.session.now ? cab.session.now->cart : cab.options.cart;
}

struct board *cab_live(void)
{
    return session_board(&cab.session);
}

const struct board_fault *cab_fault(void)
{
    return board_last(cab_live())->fault;
}

void cab_notice(int frames, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    vsnprintf(cab.notice, sizeof cab.notice, format, args);
    va_end(args);
    cab.notice_left = frames;
}

void cab_check_recording(bool good)
{
    if (good)
        return;
    cab_say("curtain: %s", cab.session.err);
    cab.result = RESULT_HOST;
}

void cab_mark_assisted(void)
{
    cab_save_nvram(); /* what was reached so far; nothing more of this run */
    cab_check_recording(session_mark_assisted(&cab.session));
}

void cab_free_name(char name[CAB_NAME], const char *where, const char *what)
{
    int i = 1;
    do
        snprintf(name, CAB_NAME, "%s%s-%d.%s", where, cab_cart()->m.id, i++, what);
    while (plat_size(name) >= 0);
}

/* ---- tick output ---- */

void cab_log_lines(const struct board_out *out)
{
    char line[4097];
    for (size_t i = 0; i < out->log_size;) {
        const char *end = memchr(out->log + i, '\n', out->log_size - i);
        size_t n = end ? (size_t)(end - (out->log + i)) : out->log_size - i;
        snprintf(line, sizeof line, "%.*s", (int)n, out->log + i);
        clean_line(line);
        plat_log(line);
        note(LOG_PRINTED, line);
        i += n + 1;
    }
}

static void play_sound(const struct board *b)
{
    if (!cab.quiet)
        speaker_hear(&cab.speaker, b, SPEAKER_ON, cab.slow);
}

void cab_hear_once(enum speaker_way way)
{
    speaker_hear(&cab.speaker, cab.attracting ? cab.attract_guard.board : cab_live(), way, 1);
}

void cab_report_fault(void)
{
    char line[FILES_PATH + sizeof((struct board_fault *)0)->message];

    if (!cab.fault_reported) {
        struct board_fault fault = *cab_fault();
        snprintf(line, sizeof line, "curtain: %s: %s", cab_game(), fault.message);
        clean_line(line);
        plat_log(line);
        note(LOG_WRONG, fault.message);
        clean_lines(fault.trace);
        if (fault.trace[0])
            plat_log(fault.trace);
        note(LOG_WRONG, fault.trace);
        cab.fault_top = 0;
        cab_report_write(cab_fault());
    }
    cab.fault_reported = true;
}

/* ---- attract: a second board while the live one stands still ---- */

static bool find_attract(const char *name, struct lump *lump)
{
    char full[80];
    snprintf(full, sizeof full, "demo/%s", name);
    int i = rom_find(cab_cart()->rom, full);
    if (i < 0)
        cab_say("curtain: %s: board.attract: there is no demo \"%s\"", cab_game(), name);
    else
        rom_lump(cab_cart()->rom, i, lump);
    return i >= 0;
}

void cab_attract_end(void)
{
    guard_close(&cab.attract_guard);
    demo_free(&cab.attract);
    cab.attracting = false;
}

static void attract_begin(const char *name)
{
    char err[256];
    struct lump lump;
    if (!find_attract(name, &lump))
        return;
    cab.attracting = demo_read(&cab.attract, lump.data, lump.size, err, sizeof err) &&
                     demo_fits(&cab.attract, cab_cart(), err, sizeof err) &&
                     guard_power(&cab.attract_guard, cab_cart()->rom, &cab.attract.start, err, sizeof err);
    if (cab.attracting)
        return;
    cab_say("curtain: demo \"%s\": %s", name, err);
    cab_attract_end();
}

static void attract_tick(void)
{
    uint16_t pads[PADS];
    const struct board *b = cab.attract_guard.board;
    if (board_last(b)->fault || board_last(b)->request == REQUEST_QUIT || board_frame(b) >= cab.attract.frames) {
        cab_attract_end();
        return;
    }
    demo_pads(&cab.attract, board_frame(b), pads);
    guard_tick(&cab.attract_guard, pads);
    play_sound(b);
}

/* ---- forward ---- */

/* Handles the output of the last tick. fresh: the player has just made it; else it was recorded, and what it asked of
 * the cabinet then is not done again. */
static void handle_output(bool fresh)
{
    const struct board_out *out = board_last(cab_live());

    cab_log_lines(out);
    play_sound(cab_live());
    practice_after_tick(&cab.practice, out);
    if (out->fault)
        cab_report_fault();
    else if (out->request == REQUEST_QUIT)
        cab.quit = true;
    else if (out->request == REQUEST_ATTRACT && fresh)
        attract_begin(out->attract);
    else if (out->request == REQUEST_ASK && fresh)
        cab_asked(out->ask);
}

/* Reports, once, that a playback is not the run that was recorded. */
static void report_difference(void)
{
    if (!cab.session.differs || cab.differs == cab.session.differs)
        return;
    cab.differs = cab.session.differs;
    cab_notice(CAB_NOTICE_FRAMES, "from frame %u on this is not the run that was recorded", (unsigned)cab.differs);
    cab_say("curtain: %s: %s", cab_game(), cab.notice);
}

/* At its end a playback quits, or pauses if the player has moved in time. */
static bool at_end(void)
{
    if (!cab.session.demo || board_frame(cab_live()) < cab.session.demo->frames)
        return false;
    cab.quit = !cab.scrubbed && !cab.guest.demo;
    if (!cab.paused && cab.guest.watching)
        cab_open_menu();
    cab.paused = true;
    return true;
}

void cab_tick(void)
{
    uint16_t pads[PADS] = { 0 };

    if (cab.quit || screens_are_open(&cab.screens))
        return;
    if (cab.attracting) {
        attract_tick();
        return;
    }
    if (cab_fault() || at_end())
        return;
    if (!cab.session.demo)
        cab_pads_tick(pads);
    memcpy(cab.last_pads, pads, sizeof pads);
    cab.ticked = true;
    cab_check_recording(session_tick(&cab.session, pads));
    report_difference();
    cab_keep_tick();
    handle_output(!cab.session.demo);
}

void cab_step(void)
{
    if (cab.attracting || cab_fault())
        return;
    if (board_frame(cab_live()) < session_last(&cab.session)) {
        session_replay_tick(&cab.session);
        handle_output(false);
    } else {
        cab_mark_assisted();
        cab_tick();
    }
}

/* ---- moving in time ---- */

static void notice_first_frame(void)
{
    cab_notice(BAR_STAYS, "what was before frame %u is not known", (unsigned)session_first(&cab.session));
}

void cab_goto(uint32_t frame)
{
    if (!cab.session.demo && !cab.session.rewound)
        cab_save_nvram();
    if (frame < session_first(&cab.session))
        notice_first_frame();
    session_goto(&cab.session, frame);
    practice_stop_counting(&cab.practice);
    cab.scrubbed = true;
    cab.fault_reported = cab.fault_reported && cab_fault();
    cab.timebar_left = BAR_STAYS;
}

void cab_rewind(uint32_t frames)
{
    uint32_t now = board_frame(cab_live());
    cab_goto(now > frames ? now - frames : 0);
}

void cab_take_over(void)
{
    static char name[CAB_NAME];
    char shown[FILES_PATH];

    if (!cab.session.demo) {
        cab_notice(CAB_NOTICE_FRAMES, "nothing to take over: it is you who plays");
        return;
    }
    cab.taken = true;
    if (cab.guest.watching) {
        cab_check_recording(session_take_over(&cab.session, NULL));
        cab_notice(CAB_NOTICE_FRAMES, "you play, for practice: nothing of it counts");
    } else {
        cab_free_name(name, "", "demo");
        bool given = cab.options.record != NULL;
        cab_check_recording(session_take_over(&cab.session, given ? cab.options.record : name));
        if (given || !plat_path(name, shown, sizeof shown))
            snprintf(shown, sizeof shown, "%s", given ? cab.options.record : name);
        cab_notice(CAB_NOTICE_FRAMES, "you play; recording %s", shown);
        cab_say("curtain: %s: %s", cab_game(), cab.notice);
    }
    cab.paused = false;
    cab.timebar_left = 0;
}

/* ---- reload ---- */

static void report_reload_failure(void)
{
    cab_notice(-1, "%s", cab.session.err);
    cab_say("curtain: not taken in: %s", cab.session.err);
}

void cab_reload(void)
{
    if (cab.guest.home) {
        cab_notice(CAB_NOTICE_FRAMES, "the game before your changes: they show at its title");
        return;
    }
    if (!cab.options.path) {
        cab_notice(CAB_NOTICE_FRAMES, "the built-in game cannot be reloaded");
        return;
    }
    cab_save_nvram(); /* does nothing once the run is touched */
    if (session_reload(&cab.session, cab.options.path, cab.options.nearest)) {
        cab.notice_left = 0;
        return;
    }
    report_reload_failure();
}

void cab_check_folder(void)
{
    if (cab.guest.demo && cab.session.demo) /* it shows the game as it was */
        return;
    if (cab.reload_due) {
        cab.reload_due = false;
        cab_reload();
    }
    if (++cab.since_check < LOOK_EVERY)
        return;
    cab.since_check = 0;
    cab.reload_due = folder_changed(&cab.folder);
    if (cab.reload_due) /* loading may stop the picture for long: say why first */
        cab_notice(CAB_NOTICE_FRAMES, "taking in what changed");
}

void cab_fit_cart(void)
{
    const struct manifest *m = &cab_cart()->m;
    const int w = cab.picture.fb.w, h = cab.picture.fb.h;

    cab.fault_reported = false;
    practice_reloaded(&cab.practice, cab_cart());
    cab_report_ready();
    cab_picture_close(&cab.picture);
    if (!cab_picture_open(&cab.picture, cab_live())) {
        plat_log("curtain: not enough memory for the picture");
        cab.result = RESULT_HOST;
        cab.quit = true;
        return;
    }
    if (w != m->screen_w || h != m->screen_h || strcmp(cab.title, m->title) != 0 || cab.want.rate != cab_sound_rate())
        cab.quit = !cab_open_window() || cab.quit;
}

/* The new ROM runs: it may have another screen and other capacities. */
static void finish_reload(void)
{
    if (cab.attracting) /* its board reads the ROM that is freed */
        cab_attract_end();
    cab_fit_cart();
    cab_say("curtain: %s: reloaded", cab_game());
    if (cab.session.gone[0])
        cab_say("curtain: %s: the music \"%s\", which played, is gone", cab_game(), cab.session.gone);
    cab_notice(CAB_NOTICE_FRAMES / 3, "reloaded");
}

void cab_seek_or_reload(uint64_t now)
{
    bool reloads = cab.session.state == SESSION_RELOADING;

    if (!session_work(&cab.session, now + WORK_USEC)) {
        if (reloads)
            report_reload_failure();
        else
            cab_check_recording(false);
    } else if (reloads && cab.session.state == SESSION_PLAYING) {
        finish_reload();
    }
    if (cab.session.state == SESSION_PLAYING)
        cab_resume_arrived();
    report_difference();
    if (cab_fault())
        cab_report_fault();
}
