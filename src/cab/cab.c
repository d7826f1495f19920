/*
 * cab.c - see cab.h. What a player may do with time is in session.c.
 *
 * Two boards at most: the session's, and while it is parked the one that shows an attract demo. plat_loop calls frame(),
 * which may be the host's own timer, so everything is in one static struct and frame() itself cleans up at the end.
 *
 * A frame is due every 1/60 s, counted from a base so that nothing is lost to rounding. When the host was late, up to
 * MAX_LATE ticks are made up for; what is later than that is forgotten and the game slows down.
 */
#include "cab.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../platform/platform.h"
#include "../base/hash.h"
#include "ask.h"
#include "config.h"
#include "console.h"
#include "folder.h"
#include "guard.h"
#include "message.h"
#include "overlay.h"
#include "png.h"
#include "practice.h"
#include "session.h"
#include "speaker.h"
#include "timebar.h"

enum {
    SECOND = 1000000,
    MAX_LATE = 4,
    MAX_TURBO = 32,     /* ticks a frame */
    TURBO_USEC = 12000, /* of a frame spent on them */
    MAX_SLOW = 4,
    SAVE_EVERY = 60,   /* frames */
    LOOK_EVERY = 15,   /* frames between two looks at the game's folder */
    BAR_STAYS = 120,   /* frames after it was used */
    SAY_STAYS = 180,   /* frames a notice stands */
    WORK_USEC = 12000, /* of a frame spent on a long way */
    NAME = 96,
};

/* What is on the screen: the board's picture, untouched, and a copy with our words on it. */
struct picture {
    struct fb fb, over;
    void *memory;
    void *scratch;
    uint32_t rgb[256], over_rgb[256];
};

static struct cab {
    struct cab_options options;
    struct board_start start;
    uint8_t *nvram; /* what start.nvram points to, if we loaded it */
    struct config config;
    struct plat_want want;
    char title[sizeof((struct manifest *)0)->title];
    struct session session;
    struct guard shown; /* of an attract demo */
    struct demo attract;
    bool attracting;
    struct speaker speaker;
    struct picture picture;
    uint64_t base;        /* frames are due from here */
    uint64_t frames;      /* since base */
    int since_save;       /* frames since nvram was last looked at */
    uint32_t nvram_saved; /* board_nvram's count when it was last saved */
    struct practice_menu practice;
    uint16_t pads[PADS];  /* held since the last tick */
    uint16_t stale[PADS]; /* held since the menu was open: not meant for the game */
    bool paused, step;
    bool rewinding; /* time runs backwards */
    bool scrubbed;  /* somebody went to and fro in a playback: it waits at its end */
    bool quiet;     /* not at full speed: no sound */
    int slow;       /* 1, 2, 4: frames a tick */
    int waited;     /* frames since the last tick */
    int bar;        /* frames the bar of time is still shown */
    bool mouse;     /* its button was held at the last poll */
    int mouse_x, mouse_y;
    struct ask ask;
    struct overlay overlay;
    struct console console;
    struct folder folder;
    int since_look;
    char notice[DEMO_PATH + 64];
    int notice_left; /* frames; -1: until it is put right */
    bool told;       /* the fault that stands in the board */
    bool quit;
    int code;
} cab;

static void say(const char *format, const char *a, const char *b)
{
    char line[2048];
    snprintf(line, sizeof line, format, a, b);
    plat_log(line);
}

static const char *game(void)
{
    return cab.options.path ? cab.options.path : cab.options.cart->m.id;
}

/* ---- nvram: <id>.nv, of live runs that nobody tampered with ---- */

static const struct cart *cart(void)
{
    return cab.session.now ? cab.session.now->cart : cab.options.cart;
}

static struct board *live(void)
{
    return session_board(&cab.session);
}

static bool keeps_nvram(void)
{
    const struct session *s = &cab.session;
    unsigned flags = s->now ? s->now->writer.demo.flags : 0;

    return !s->rewound && !cab.options.demo && !cab.start.practice.mark[0] && !cab.options.start.nvram &&
           !(flags & (DEMO_BRANCHED | DEMO_TOUCHED));
}

static void nvram_name(char name[NAME])
{
    snprintf(name, NAME, "user:%s.nv", cart()->m.id);
}

/* The file's image for a start that has none of its own: malloc'ed, and start points to it. A practice start has a blank
 * one. NULL: none. */
static uint8_t *load_nvram(struct board_start *start)
{
    char name[NAME];
    nvram_name(name);
    if (start->nvram || start->practice.mark[0] || cab.options.demo || plat_size(name) <= 0)
        return NULL;
    uint8_t *image = malloc(NVRAM_BYTES);
    long size = image ? plat_load(name, image, NVRAM_BYTES) : -1;
    if (size > 0) {
        start->nvram = image;
        start->nvram_size = (size_t)size;
    }
    return image;
}

static void save_nvram(void)
{
    char name[NAME];
    uint32_t changed;
    const uint8_t *image = board_nvram(live(), &changed);
    if (changed == cab.nvram_saved || !keeps_nvram())
        return;
    cab.nvram_saved = changed;
    nvram_name(name);
    if (!plat_save(name, image, NVRAM_BYTES))
        say("curtain: %s: the scores cannot be saved%s", name, "");
}

/* ---- what a tick hands out ---- */

static void log_lines(const struct board_out *out)
{
    char line[4097];
    for (size_t i = 0; i < out->log_size;) {
        const char *end = memchr(out->log + i, '\n', out->log_size - i);
        size_t n = end ? (size_t)(end - (out->log + i)) : out->log_size - i;
        snprintf(line, sizeof line, "%.*s", (int)n, out->log + i);
        plat_log(line);
        i += n + 1;
    }
}

static void hear(const struct board_out *out)
{
    if (!cab.quiet)
        speaker_play(&cab.speaker, out->sound);
}

/* A line for the log and for a while, or until it is put right, over the picture. */
static void notice(const char *text, int frames)
{
    snprintf(cab.notice, sizeof cab.notice, "%s", text);
    cab.notice_left = frames;
}

static const struct board_fault *fault(void)
{
    return board_last(live())->fault;
}

/* The board has a fault: told once. */
static void halt(void)
{
    if (!cab.told) {
        say("curtain: %s: %s", game(), fault()->message);
        if (fault()->trace[0])
            plat_log(fault()->trace);
    }
    cab.told = true;
}

/* What the session said no with goes to the log. */
static void wrote(bool good)
{
    if (good)
        return;
    say("curtain: %s%s", cab.session.err, "");
    cab.code = 3;
}

static void assisted(void)
{
    wrote(demo_flag(&cab.session.now->writer, DEMO_ASSISTED));
}

/* ---- attract: a second board while the live one stands still ---- */

static bool find_attract(const char *name, struct lump *lump)
{
    char full[80];
    snprintf(full, sizeof full, "demo/%s", name);
    int i = rom_find(cart()->rom, full);
    if (i < 0)
        say("curtain: %s: board.attract: there is no demo \"%s\"", game(), name);
    else
        rom_lump(cart()->rom, i, lump);
    return i >= 0;
}

static void attract_end(void)
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
                     demo_fits(&cab.attract, cart(), err, sizeof err) &&
                     guard_power(&cab.shown, cart()->rom, &cab.attract.start, err, sizeof err);
    if (cab.attracting)
        return;
    say("curtain: demo \"%s\": %s", name, err);
    attract_end();
}

static void attract_tick(void)
{
    uint16_t pads[PADS];
    const struct board *b = cab.shown.board;
    if (board_last(b)->fault || board_last(b)->request == REQUEST_QUIT || board_frame(b) >= cab.attract.frames) {
        attract_end();
        return;
    }
    demo_pads(&cab.attract, board_frame(b), pads);
    hear(guard_tick(&cab.shown, pads));
}

/* ---- the session ---- */

/* What the tick just over hands out. */
static void hand_out(void)
{
    const struct board_out *out = board_last(live());

    log_lines(out);
    hear(out);
    practice_hear(&cab.practice, out);
    if (out->fault)
        halt();
    else if (out->request == REQUEST_QUIT)
        cab.quit = true;
    else if (out->request == REQUEST_ATTRACT && !cab.session.demo)
        attract_begin(out->attract);
}

/* A playback is over at its end, or waits there for who went to and fro in it. */
static bool at_end(void)
{
    if (!cab.session.demo || board_frame(live()) < cab.session.demo->frames)
        return false;
    cab.quit = !cab.scrubbed;
    cab.paused = true;
    return true;
}

static void tick(void)
{
    if (cab.quit)
        return;
    if (cab.attracting) {
        attract_tick();
        return;
    }
    if (fault() || at_end())
        return;
    wrote(session_tick(&cab.session, cab.pads));
    hand_out();
}

/* A single frame on: as it was, if it was. */
static void step(void)
{
    if (cab.attracting || fault())
        return;
    if (board_frame(live()) < session_last(&cab.session)) {
        session_again(&cab.session);
        hand_out();
    } else {
        assisted();
        tick();
    }
}

/* To another frame; the bar of time shows where that is. */
static void go(uint32_t frame)
{
    if (!cab.session.demo && !cab.session.rewound)
        save_nvram();
    session_goto(&cab.session, frame);
    practice_void(&cab.practice);
    cab.scrubbed = true;
    cab.told = cab.told && fault();
    cab.bar = BAR_STAYS;
}

static void go_back(uint32_t frames)
{
    uint32_t now = board_frame(live());
    go(now > frames ? now - frames : 0);
}

/* A name "ID-N.what" in the current folder that is free. */
static void free_name(char name[NAME], const char *what)
{
    int i = 1;
    do
        snprintf(name, NAME, "%s-%d.%s", cart()->m.id, i++, what);
    while (plat_size(name) >= 0);
}

static void take_over(void)
{
    static char name[NAME];
    char text[NAME + 32];

    if (!cab.session.demo) {
        notice("nothing to take over: it is you who plays", SAY_STAYS);
        return;
    }
    free_name(name, "demo");
    bool given = cab.options.record != NULL;
    wrote(session_take_over(&cab.session, given ? cab.options.record : name));
    snprintf(text, sizeof text, "you play; recording %s", given ? cab.options.record : name);
    notice(text, SAY_STAYS);
    say("curtain: %s: %s", game(), text);
    cab.paused = false;
    cab.bar = 0;
}

/* ---- the window ---- */

static bool picture_open(struct picture *p, const struct board *b)
{
    int w, h;
    board_screen(b, &w, &h);
    p->memory = calloc(2, fb_size(w, h));
    p->scratch = malloc(board_scratch(b) + 1);
    if (!p->memory || !p->scratch)
        return false;
    fb_init(&p->fb, p->memory, w, h);
    fb_init(&p->over, (char *)p->memory + fb_size(w, h), w, h);
    return true;
}

static void picture_close(struct picture *p)
{
    free(p->memory);
    free(p->scratch);
    *p = (struct picture){ 0 };
}

/* The window as cab.want and the game's manifest say. False: there is none. */
static bool open_window(void)
{
    const struct manifest *m = &cart()->m;

    cab.want.w = m->screen_w;
    cab.want.h = m->screen_h;
    snprintf(cab.title, sizeof cab.title, "%s", m->title); /* the manifest may go */
    cab.want.title = cab.title;
    return plat_open(&cab.want);
}

/* ---- reload ---- */

static void reload(void)
{
    if (!cab.options.path) {
        notice("the built-in game cannot be reloaded", SAY_STAYS);
        return;
    }
    if (session_reload(&cab.session, cab.options.path, cab.options.nearest)) {
        cab.notice_left = 0;
        return;
    }
    notice(cab.session.err, -1);
    say("curtain: %s", cab.session.err, "");
}

static void look_for_changes(void)
{
    if (++cab.since_look < LOOK_EVERY)
        return;
    cab.since_look = 0;
    if (folder_changed(&cab.folder))
        reload();
}

/* The changed game may have another screen and other capacities. */
static void landed(void)
{
    const struct manifest *m = &cart()->m;

    cab.told = false;
    practice_reloaded(&cab.practice, cart());
    picture_close(&cab.picture);
    if (!picture_open(&cab.picture, live())) {
        plat_log("curtain: not enough memory for the picture");
        cab.code = 3;
        cab.quit = true;
        return;
    }
    if (cab.want.w != m->screen_w || cab.want.h != m->screen_h || strcmp(cab.title, m->title) != 0)
        cab.quit = !open_window() || cab.quit;
    say("curtain: %s: reloaded%s", game(), "");
    notice("reloaded", SAY_STAYS / 3);
}

/* A piece of a long way. */
static void work(uint64_t now)
{
    bool reloads = cab.session.way == SESSION_RELOADS;

    if (!session_work(&cab.session, now + WORK_USEC)) {
        notice(cab.session.err, reloads ? -1 : SAY_STAYS);
        say("curtain: %s%s", cab.session.err, "");
    } else if (reloads && cab.session.way == SESSION_THERE) {
        landed();
    }
    if (fault())
        halt();
}

/* ---- practice ---- */

static uint64_t seed_from_clock(void)
{
    return hash_fold(hash_fold(0, (uint64_t)time(0)), plat_usec());
}

/* The board anew with another start. */
static void power_anew(struct board_start start)
{
    bool reloads = cab.session.way == SESSION_RELOADS;
    const struct session_run *before = cab.session.now;

    save_nvram();
    start.nvram = cab.options.start.nvram;
    start.nvram_size = cab.options.start.nvram_size;
    uint8_t *nvram = load_nvram(&start);
    if (!session_restart(&cab.session, &start)) {
        notice(cab.session.err, SAY_STAYS);
        say("curtain: %s%s", cab.session.err, "");
    }
    if (cab.session.now == before) { /* as it was */
        free(nvram);
        return;
    }
    free(cab.nvram);
    cab.nvram = nvram;
    cab.start = start;
    cab.nvram_saved = 0;
    cab.told = cab.paused = cab.scrubbed = false;
    cab.bar = cab.waited = 0;
    memset(cab.pads, 0, sizeof cab.pads);
    practice_began(&cab.practice, &start);
    if (cab.slow > 1)
        assisted();
    log_lines(board_last(live()));
    if (fault())
        halt();
    if (reloads)
        reload();
}

/* A demo is played to its end; one that is recorded of a game is not lost to a piece. */
static bool may_practise(void)
{
    bool records = cab.session.record && !cab.start.practice.mark[0];

    if (cab.session.demo || records)
        notice(records ? "no practice while the game is recorded" : "no practice in a demo", SAY_STAYS);
    return !cab.session.demo && !records;
}

static void retry(void)
{
    cab.practice.open = false;
    if (cab.start.practice.mark[0])
        power_anew(cab.start);
    else
        notice("nothing to try again: choose a piece first", SAY_STAYS);
}

static void practice_keys(const struct keys_read *k)
{
    bool menu = k->pressed & 1 << CAB_PRACTICE, again = k->pressed & 1 << CAB_RETRY;

    if (!(menu || again) || !may_practise())
        return;
    if (cab.attracting)
        attract_end();
    if (again)
        retry();
    else if (cab.practice.open)
        cab.practice.open = false;
    else {
        practice_open(&cab.practice, cab.slow);
        cab.practice.hitbox = cab.overlay.on[OVERLAY_SHAPES];
    }
}

/* The open menu has player 1's pad, and the board stands still. */
static void menu(const struct keys_read *k)
{
    struct board_start start;

    memcpy(cab.stale, k->pads, sizeof cab.stale);
    memset(cab.pads, 0, sizeof cab.pads);
    enum practice_choice choice = practice_poll(&cab.practice, k->pads[0]);
    if (cab.practice.slow != cab.slow)
        assisted();
    cab.slow = cab.practice.slow;
    cab.overlay.on[OVERLAY_SHAPES] = cab.practice.hitbox;
    if (choice != PRACTICE_START)
        return;
    practice_chosen(&cab.practice, &start);
    if (!start.practice.mark[0] && !cab.options.seeded)
        start.seed = seed_from_clock();
    power_anew(start);
}

/* ---- picture ---- */

static void picture_draw(struct picture *p)
{
    const struct board *b = cab.attracting ? cab.shown.board : live();
    if (cab.attracting || !fault())
        board_draw(b, &p->fb, p->rgb, p->scratch);
}

static struct ink picture_copy(struct picture *p)
{
    struct ink ink;

    for (int y = 0; y < p->fb.h; y++)
        memcpy(p->over.pix + y * p->over.pitch, p->fb.pix + y * p->fb.pitch, (size_t)p->fb.w);
    memcpy(p->over_rgb, p->rgb, sizeof p->rgb);
    ink_open(&ink, &p->over, p->over_rgb);
    return ink;
}

/* What we have to say over the picture; "": nothing. */
static void words(char *text, size_t size)
{
    const struct board_fault *f = fault();
    uint32_t at = board_frame(live());

    text[0] = 0;
    if (cab.session.way != SESSION_THERE)
        snprintf(text, size, "%s %d%%", cab.session.way == SESSION_SEEKS ? "seeking" : "reloading",
                 session_progress(&cab.session) / 10);
    else if (cab.ask.open)
        snprintf(text, size, "go to frame %s_", cab.ask.digits);
    else if (cab.notice_left)
        snprintf(text, size, "%s", cab.notice);
    else if (f)
        snprintf(text, size, "%s\n\n%s", f->message, f->trace);
    else if (cab.rewinding)
        snprintf(text, size, "rewind  frame %u", (unsigned)at);
    else if (cab.paused)
        snprintf(text, size, "paused at frame %u", (unsigned)at);
    else if (cab.slow > 1)
        snprintf(text, size, "1/%d speed  frame %u", cab.slow, (unsigned)at);
}

/* Shown where time is gone to and fro, and in a playback under the mouse. */
static bool bar_shown(void)
{
    return !cab.attracting && (cab.ask.open || cab.rewinding || cab.bar > 0 || (cab.session.demo && cab.paused));
}

static void progress_draw(const struct ink *ink)
{
    int w = ink->fb->w, done = (int)((int64_t)w * session_progress(&cab.session) / 1000);

    ink_rect(ink, 0, INK_CELL_H + 1, w, 2, INK_GREY);
    ink_rect(ink, 0, INK_CELL_H + 1, done, 2, INK_GREEN);
}

static void picture_show(struct picture *p)
{
    char text[sizeof((struct board_fault *)0)->message + sizeof((struct board_fault *)0)->trace + 4];

    if (cab.practice.open) {
        struct ink ink = picture_copy(p);
        practice_draw(&cab.practice, &ink);
        plat_show(p->over.pix, p->over.pitch, p->over.w, p->over.h, p->over_rgb);
        return;
    }
    words(text, sizeof text);
    if (!text[0] && !bar_shown() && !cab.console.open && !overlay_on(&cab.overlay)) {
        plat_show(p->fb.pix, p->fb.pitch, p->fb.w, p->fb.h, p->rgb);
        return;
    }
    struct ink ink = picture_copy(p);
    int y0 = text[0] ? message_draw(&ink, 0, text) : 0, y1 = console_draw(&cab.console, &ink);
    overlay_draw(&cab.overlay, &ink, y0, bar_shown() && !cab.console.open ? y1 - TIMEBAR_H : y1,
                 cab.attracting ? cab.shown.board : live(), cab.mouse_x, cab.mouse_y);
    if (cab.session.way != SESSION_THERE)
        progress_draw(&ink);
    if (bar_shown() && !cab.console.open)
        timebar_draw(&ink, &cab.session);
    plat_show(p->over.pix, p->over.pitch, p->over.w, p->over.h, p->over_rgb);
}

/* The board's picture without our words, under the first free number. */
static void screenshot(const struct picture *p)
{
    char name[NAME];
    uint8_t *png;
    size_t size;

    free_name(name, "png");
    if (!png_write(p->fb.pix, p->fb.pitch, p->fb.w, p->fb.h, p->rgb, &png, &size)) {
        plat_log("curtain: no memory for a screenshot");
        return;
    }
    say(plat_save(name, png, size) ? "wrote %s%s" : "curtain: %s: cannot be written%s", name, "");
    free(png);
}

/* ---- switches ---- */

static void reopen(void)
{
    cab.want.fullscreen = !cab.want.fullscreen;
    cab.quit = !open_window() || cab.quit;
}

static void cabinet_keys(const struct keys_read *k)
{
    if (k->pressed & 1 << CAB_QUIT)
        cab.quit = true;
    if (k->pressed & 1 << CAB_FULLSCREEN)
        reopen();
    if (k->pressed & 1 << CAB_MUTE)
        cab.speaker.muted = !cab.speaker.muted;
    if (k->pressed & 1 << CAB_PAUSE)
        cab.paused = !cab.paused;
    if (k->pressed & 1 << CAB_STEP)
        cab.paused = cab.step = true;
    if (k->pressed & 1 << CAB_SLOW) {
        assisted();
        cab.slow = cab.slow == MAX_SLOW ? 1 : cab.slow * 2;
    }
    if (k->pressed & 1 << CAB_SCREENSHOT)
        screenshot(&cab.picture);
}

/* Those that go to and fro in time. */
static void time_keys(const struct keys_read *k)
{
    uint32_t now = board_frame(live());

    if (cab.attracting)
        return;
    if (k->pressed & 1 << CAB_BACK) {
        cab.paused = true;
        go_back(1);
    }
    if (k->pressed & 1 << CAB_BEFORE)
        go(timebar_before(&cab.session, now));
    if (k->pressed & 1 << CAB_AFTER)
        go(timebar_after(&cab.session, now));
    if (k->pressed & 1 << CAB_TAKE_OVER)
        take_over();
    if (k->pressed & 1 << CAB_RELOAD)
        reload();
}

/* In a playback, and wherever the bar is shown, a click on it leads there. */
static void mouse(const struct plat_input *in)
{
    uint32_t frame;
    bool held = in->mouse & 1, pressed = held && !cab.mouse;

    cab.mouse = held;
    if (cab.attracting || cab.console.open || !(cab.session.demo || bar_shown()) ||
        !timebar_at(&cab.session, cab.picture.fb.w, cab.picture.fb.h, in->mouse_x, in->mouse_y, &frame))
        return;
    cab.bar = cab.bar ? cab.bar : 1;
    if (pressed || (held && cab.session.way == SESSION_THERE && frame != board_frame(live())))
        go(frame);
}

/* True while a frame is asked for: the keys are for that, and time stands still. */
static bool ask(const struct plat_input *in)
{
    uint32_t frame;

    if (!cab.ask.open)
        return false;
    if (ask_poll(&cab.ask, in, &frame)) {
        cab.paused = true;
        go(frame);
    }
    return true;
}

/* Buttons gather until a tick has seen them. */
static void take_pads(const struct keys_read *k)
{
    for (int i = 0; i < PADS; i++) {
        cab.stale[i] &= k->pads[i];
        cab.pads[i] |= (uint16_t)(k->pads[i] & ~cab.stale[i]);
    }
}

/* While the console is open it has all keys. Scores are saved before a line can touch them. */
static void console_keys(const struct plat_input *in, struct keys_read *k)
{
    bool stands = !fault() && !cab.attracting && !cab.practice.open && cab.session.way == SESSION_THERE;
    if (k->pressed & 1 << CAB_CONSOLE)
        save_nvram();
    console_poll(&cab.console, in, k, stands ? live() : NULL, !cab.session.demo);
    if (console_kept(&cab.console)) {
        wrote(session_touch(&cab.session));
        practice_void(&cab.practice);
    }
    if (cab.want.text == cab.console.open)
        return;
    cab.want.text = cab.console.open;
    cab.quit = !open_window() || cab.quit;
}

static void poll(struct keys_read *k)
{
    struct plat_input in;
    plat_poll(&in);
    cab.mouse_x = in.mouse_x;
    cab.mouse_y = in.mouse_y;
    cab.quit = cab.quit || in.quit;
    if (ask(&in)) {
        memset(k, 0, sizeof *k);
        return;
    }
    keys_read(&cab.config.keys, &in, k);
    console_keys(&in, k);
    overlay_keys(&cab.overlay, k->pressed);
    take_pads(k);
    cabinet_keys(k);
    practice_keys(k);
    if (cab.practice.open)
        return;
    time_keys(k);
    if (k->pressed & 1 << CAB_GOTO && !cab.attracting)
        ask_open(&cab.ask, &in);
    mouse(&in);
    if (cab.attracting && k->fresh)
        attract_end();
}

/* ---- time ---- */

static uint64_t due(uint64_t frame)
{
    return cab.base + frame * SECOND / 60;
}

/* Frames that are due by now, at least one; what is too late is forgotten. */
static int frames_due(uint64_t now)
{
    int n = 1;
    while (n < MAX_LATE && due(cab.frames + (uint64_t)n) <= now)
        n++;
    cab.frames += (uint64_t)n;
    if (due(cab.frames) <= now) {
        cab.base = now;
        cab.frames = 1;
    }
    return n;
}

static void turbo(uint64_t now)
{
    for (int i = 0; i < MAX_TURBO && plat_usec() - now < TURBO_USEC; i++)
        tick();
}

/* True when a slowed board's turn has come. */
static bool turn(void)
{
    cab.waited = (cab.waited + 1) % cab.slow;
    return cab.waited == 0;
}

/* Presses gather in cab.pads until a tick has seen them; those of a pause are lost. */
static void run(int frames, const struct keys_read *k, uint64_t now)
{
    bool fast = k->held & 1 << CAB_TURBO, ticked = cab.paused;
    cab.rewinding = k->held & 1 << CAB_REWIND && !cab.attracting;
    cab.quiet = cab.rewinding || cab.paused || fast || cab.slow > 1;
    if (cab.ask.open)
        return;
    if (cab.rewinding) {
        go_back((uint32_t)frames);
        cab.step = false;
        memset(cab.pads, 0, sizeof cab.pads);
        return;
    }
    if (cab.paused && cab.step)
        step();
    else if (fast && !cab.paused)
        turbo(now);
    for (int i = 0; i < frames && !cab.paused && !fast; i++)
        if (turn()) {
            tick();
            ticked = true;
        }
    cab.step = false;
    if (ticked || fast)
        memset(cab.pads, 0, sizeof cab.pads);
}

static void finish(void)
{
    save_nvram();
    practice_close(&cab.practice);
    if (fault())
        cab.code = 2;
    bool good = session_close(&cab.session);
    cab.code = good || cab.code ? cab.code : 3;
    if (!good)
        say("curtain: %s%s", cab.session.err, "");
    if (cab.attracting)
        attract_end();
    picture_close(&cab.picture);
    console_close(&cab.console);
    free(cab.nvram);
    plat_close();
}

static bool frame(void)
{
    struct keys_read k;
    plat_wait(due(cab.frames));
    uint64_t now = plat_usec();
    if (now < due(cab.frames))
        return true;
    poll(&k);
    look_for_changes();
    int n = frames_due(now);
    overlay_begin(&cab.overlay, cab.attracting ? &cab.shown : &cab.session.now->guard);
    if (cab.practice.open)
        menu(&k);
    else if (cab.session.way != SESSION_THERE)
        work(now);
    else if (cab.console.open)
        memset(cab.pads, 0, sizeof cab.pads);
    else
        run(n, &k, now);
    cab.bar -= cab.bar > 0;
    cab.notice_left -= cab.notice_left > 0;
    if (++cab.since_save >= SAVE_EVERY) {
        cab.since_save = 0;
        save_nvram();
        records_save(&cab.practice.records);
    }
    overlay_lap(&cab.overlay, SPLIT_CABINET);
    picture_draw(&cab.picture);
    overlay_lap(&cab.overlay, SPLIT_DRAW);
    picture_show(&cab.picture);
    overlay_lap(&cab.overlay, SPLIT_SHOW);
    overlay_end(&cab.overlay);
    if (cab.quit)
        finish();
    return !cab.quit;
}

/* ---- power ---- */

static int refuse(int code, const char *what)
{
    say("curtain: %s: %s", game(), what);
    practice_close(&cab.practice);
    session_close(&cab.session);
    picture_close(&cab.picture);
    free(cab.nvram);
    plat_close();
    return code;
}

static void want_window(void)
{
    const struct cab_options *o = &cab.options;

    cab.want = (struct plat_want){ .scale = o->scale ? o->scale : cab.config.scale,
                                   .fullscreen = o->fullscreen || cab.config.fullscreen,
                                   .rate = SPEAKER_RATE };
}

int cab_play(const struct cab_options *options)
{
    char err[512];
    memset(&cab, 0, sizeof cab);
    cab.options = *options;
    cab.start = options->start;
    cab.slow = 1;
    if (!config_load(&cab.config, err, sizeof err)) {
        say("curtain: %s%s", err, "");
        return 2;
    }
    cab.speaker = (struct speaker){ .volume = cab.config.volume, .muted = options->mute || cab.config.mute };
    if (!options->seeded && !options->demo)
        cab.start.seed = seed_from_clock();
    cab.nvram = load_nvram(&cab.start);
    if (!session_open(&cab.session, options->cart, &cab.start, options->demo, options->record))
        return refuse(2, cab.session.err);
    want_window();
    if (!open_window())
        return refuse(3, "there is no window to play in");
    if (!picture_open(&cab.picture, live()))
        return refuse(3, "not enough memory for the picture");
    practice_init(&cab.practice, options->cart, &cab.start);
    if (!options->demo)
        practice_began(&cab.practice, &cab.start);
    wrote(!cab.session.now->writer.err[0]);
    log_lines(board_last(live()));
    if (fault())
        halt();
    folder_open(&cab.folder, options->path);
    cab.base = plat_usec();
    plat_loop(frame);
    return cab.code;
}
