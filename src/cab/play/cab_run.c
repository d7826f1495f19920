/*
 * cab_run.c - the run: its ticks, to and fro in time (which is session.c's doing), reload, and attract demos.
 *
 * Two boards at most: the session's, and while it is parked the one that shows an attract demo.
 */
#include <stdio.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "cab_parts.h"
#include "../host/clean.h"

enum {
    LOOK_EVERY = 15,  /* frames between two looks at the game's folder */
    BAR_STAYS = 120,  /* frames after it was used */
    WORK_USEC = 12000 /* of a frame spent on a long way */
};

/* ---- words ---- */

void cab_say(const char *format, const char *a, const char *b)
{
    char line[2048];
    snprintf(line, sizeof line, format, a, b);
    clean_line(line);
    plat_log(line);
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

void cab_notice(const char *text, int frames)
{
    snprintf(cab.notice, sizeof cab.notice, "%s", text);
    cab.notice_left = frames;
}

void cab_wrote(bool good)
{
    if (good)
        return;
    cab_say("curtain: %s%s", cab.session.err, "");
    cab.result = RESULT_HOST;
}

void cab_assisted(void)
{
    cab_wrote(session_assist(&cab.session));
}

void cab_free_name(char name[CAB_NAME], const char *what)
{
    int i = 1;
    do
        snprintf(name, CAB_NAME, "%s-%d.%s", cab_cart()->m.id, i++, what);
    while (plat_size(name) >= 0);
}

/* ---- what a tick hands out ---- */

void cab_log_lines(const struct board_out *out)
{
    char line[4097];
    for (size_t i = 0; i < out->log_size;) {
        const char *end = memchr(out->log + i, '\n', out->log_size - i);
        size_t n = end ? (size_t)(end - (out->log + i)) : out->log_size - i;
        snprintf(line, sizeof line, "%.*s", (int)n, out->log + i);
        clean_line(line);
        plat_log(line);
        i += n + 1;
    }
}

static void hear(const struct board_out *out)
{
    if (!cab.quiet)
        speaker_play(&cab.speaker, out->sound);
}

void cab_halt(void)
{
    if (!cab.told) {
        struct board_fault fault = *cab_fault();
        cab_say("curtain: %s: %s", cab_game(), fault.message);
        clean_lines(fault.trace);
        if (fault.trace[0])
            plat_log(fault.trace);
    }
    cab.told = true;
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
    guard_close(&cab.shown);
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
                     guard_power(&cab.shown, cab_cart()->rom, &cab.attract.start, err, sizeof err);
    if (cab.attracting)
        return;
    cab_say("curtain: demo \"%s\": %s", name, err);
    cab_attract_end();
}

static void attract_tick(void)
{
    uint16_t pads[PADS];
    const struct board *b = cab.shown.board;
    if (board_last(b)->fault || board_last(b)->request == REQUEST_QUIT || board_frame(b) >= cab.attract.frames) {
        cab_attract_end();
        return;
    }
    demo_pads(&cab.attract, board_frame(b), pads);
    hear(guard_tick(&cab.shown, pads));
}

/* ---- forward ---- */

/* What the tick just over hands out. */
static void hand_out(void)
{
    const struct board_out *out = board_last(cab_live());

    cab_log_lines(out);
    hear(out);
    practice_hear(&cab.practice, out);
    if (out->fault)
        cab_halt();
    else if (out->request == REQUEST_QUIT)
        cab.quit = true;
    else if (out->request == REQUEST_ATTRACT && !cab.session.demo)
        attract_begin(out->attract);
}

/* A playback that is another run than was recorded says so, once. */
static void tell_difference(void)
{
    char text[96];

    if (!cab.session.differs || cab.differs == cab.session.differs)
        return;
    cab.differs = cab.session.differs;
    snprintf(text, sizeof text, "from frame %u on this is not the run that was recorded", (unsigned)cab.differs);
    cab_notice(text, CAB_SAYS);
    cab_say("curtain: %s: %s", cab_game(), text);
}

/* A playback is over at its end, or waits there for who went to and fro in it. */
static bool at_end(void)
{
    if (!cab.session.demo || board_frame(cab_live()) < cab.session.demo->frames)
        return false;
    cab.quit = !cab.scrubbed;
    cab.paused = true;
    return true;
}

void cab_tick(void)
{
    if (cab.quit)
        return;
    if (cab.attracting) {
        attract_tick();
        return;
    }
    if (cab_fault() || at_end())
        return;
    cab_wrote(session_tick(&cab.session, cab.pads));
    tell_difference();
    hand_out();
}

void cab_step(void)
{
    if (cab.attracting || cab_fault())
        return;
    if (board_frame(cab_live()) < session_last(&cab.session)) {
        session_again(&cab.session);
        hand_out();
    } else {
        cab_assisted();
        cab_tick();
    }
}

/* ---- to and fro ---- */

static void not_before(void)
{
    char text[64];

    snprintf(text, sizeof text, "what was before frame %u is not known", (unsigned)session_first(&cab.session));
    cab_notice(text, BAR_STAYS);
}

void cab_go(uint32_t frame)
{
    if (!cab.session.demo && !cab.session.rewound)
        cab_save_nvram();
    if (frame < session_first(&cab.session))
        not_before();
    session_goto(&cab.session, frame);
    practice_void(&cab.practice);
    cab.scrubbed = true;
    cab.told = cab.told && cab_fault();
    cab.bar = BAR_STAYS;
}

void cab_go_back(uint32_t frames)
{
    uint32_t now = board_frame(cab_live());
    cab_go(now > frames ? now - frames : 0);
}

void cab_take_over(void)
{
    static char name[CAB_NAME];
    char text[CAB_NAME + 32];

    if (!cab.session.demo) {
        cab_notice("nothing to take over: it is you who plays", CAB_SAYS);
        return;
    }
    cab_free_name(name, "demo");
    bool given = cab.options.record != NULL;
    cab_wrote(session_take_over(&cab.session, given ? cab.options.record : name));
    snprintf(text, sizeof text, "you play; recording %s", given ? cab.options.record : name);
    cab_notice(text, CAB_SAYS);
    cab_say("curtain: %s: %s", cab_game(), text);
    cab.paused = false;
    cab.bar = 0;
}

/* ---- reload ---- */

static void not_taken_in(void)
{
    char text[sizeof cab.session.err + 32];

    snprintf(text, sizeof text, "not taken in: %s", cab.session.err);
    cab_notice(text, -1);
    cab_say("curtain: %s%s", text, "");
}

void cab_reload(void)
{
    if (!cab.options.path) {
        cab_notice("the built-in game cannot be reloaded", CAB_SAYS);
        return;
    }
    cab_save_nvram(); /* a run that was touched does not */
    if (session_reload(&cab.session, cab.options.path, cab.options.nearest)) {
        cab.notice_left = 0;
        return;
    }
    not_taken_in();
}

void cab_look_for_changes(void)
{
    if (cab.taking_in) {
        cab.taking_in = false;
        cab_reload();
    }
    if (++cab.since_look < LOOK_EVERY)
        return;
    cab.since_look = 0;
    cab.taking_in = folder_changed(&cab.folder);
    if (cab.taking_in) /* a script that loads for long stops the picture: it should say why */
        cab_notice("taking in what changed", CAB_SAYS);
}

/* The changed game may have another screen and other capacities. */
static void landed(void)
{
    const struct manifest *m = &cab_cart()->m;

    if (cab.attracting) /* its board was of the ROM that is gone */
        cab_attract_end();
    cab.told = false;
    practice_reloaded(&cab.practice, cab_cart());
    cab_picture_close(&cab.picture);
    if (!cab_picture_open(&cab.picture, cab_live())) {
        plat_log("curtain: not enough memory for the picture");
        cab.result = RESULT_HOST;
        cab.quit = true;
        return;
    }
    if (cab.want.w != m->screen_w || cab.want.h != m->screen_h || strcmp(cab.title, m->title) != 0)
        cab.quit = !cab_open_window() || cab.quit;
    cab_say("curtain: %s: reloaded%s", cab_game(), "");
    cab_notice("reloaded", CAB_SAYS / 3);
}

void cab_work(uint64_t now)
{
    bool reloads = cab.session.way == SESSION_RELOADS;

    if (!session_work(&cab.session, now + WORK_USEC)) {
        if (reloads)
            not_taken_in();
        else
            cab_wrote(false);
    } else if (reloads && cab.session.way == SESSION_THERE) {
        landed();
    }
    tell_difference();
    if (cab_fault())
        cab_halt();
}
