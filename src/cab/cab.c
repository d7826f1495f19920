/*
 * cab.c - see cab.h.
 *
 * Two boards at most: the live one, and while it is parked the one that shows an attract demo. plat_loop calls frame(),
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
#include "config.h"
#include "guard.h"
#include "message.h"
#include "png.h"
#include "speaker.h"

enum {
    SECOND = 1000000,
    MAX_LATE = 4,
    MAX_TURBO = 32,     /* ticks a frame */
    TURBO_USEC = 12000, /* of a frame spent on them */
    MAX_SLOW = 4,
    SAVE_EVERY = 60, /* frames */
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
    struct guard live, shown; /* shown: of an attract demo */
    struct demo attract;
    bool attracting;
    struct demo_writer writer;
    struct speaker speaker;
    struct picture picture;
    uint64_t base;        /* frames are due from here */
    uint64_t frames;      /* since base */
    int since_save;       /* frames since nvram was last looked at */
    uint32_t nvram_saved; /* board_nvram's count when it was last saved */
    uint16_t pads[PADS];  /* held since the last tick */
    bool paused, step;
    bool rewinding; /* time runs backwards */
    bool rewound;   /* it did, once: scores do not count any more */
    bool quiet;     /* not at full speed: no sound */
    int slow;       /* 1, 2, 4: frames a tick */
    int waited;     /* frames since the last tick */
    const struct board_fault *fault;
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

static bool keeps_nvram(void)
{
    return !cab.rewound && !cab.options.demo && !cab.options.start.practice.mark[0] && !cab.options.start.nvram &&
           !(cab.writer.demo.flags & (DEMO_BRANCHED | DEMO_TOUCHED));
}

static void nvram_name(char name[NAME])
{
    snprintf(name, NAME, "user:%s.nv", cab.options.cart->m.id);
}

static void load_nvram(void)
{
    char name[NAME];
    nvram_name(name);
    if (!keeps_nvram() || plat_size(name) <= 0)
        return;
    cab.nvram = malloc(NVRAM_BYTES);
    long size = cab.nvram ? plat_load(name, cab.nvram, NVRAM_BYTES) : -1;
    if (size <= 0)
        return;
    cab.start.nvram = cab.nvram;
    cab.start.nvram_size = (size_t)size;
}

static void save_nvram(void)
{
    char name[NAME];
    uint32_t changed;
    const uint8_t *image = board_nvram(cab.live.board, &changed);
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

static void halt(const struct board_fault *fault)
{
    cab.fault = fault;
    cab.code = 2;
    say("curtain: %s: %s", game(), fault->message);
    if (fault->trace[0])
        plat_log(fault->trace);
}

static void write_demo(bool good)
{
    if (good)
        return;
    say("curtain: %s%s", cab.writer.err, "");
    cab.code = cab.code ? cab.code : 3;
}

static void assisted(void)
{
    write_demo(demo_flag(&cab.writer, DEMO_ASSISTED));
}

/* ---- attract: a second board while the live one stands still ---- */

static bool find_attract(const char *name, struct lump *lump)
{
    char full[80];
    snprintf(full, sizeof full, "demo/%s", name);
    int i = rom_find(cab.options.cart->rom, full);
    if (i < 0)
        say("curtain: %s: board.attract: there is no demo \"%s\"", game(), name);
    else
        rom_lump(cab.options.cart->rom, i, lump);
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
                     demo_fits(&cab.attract, cab.options.cart, err, sizeof err) &&
                     guard_power(&cab.shown, cab.options.cart->rom, &cab.attract.start, err, sizeof err);
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

/* ---- the live board ---- */

static void live_pads(uint16_t pads[PADS])
{
    if (cab.options.demo)
        demo_pads(cab.options.demo, board_frame(cab.live.board), pads);
    else
        memcpy(pads, cab.pads, sizeof cab.pads);
}

static void live_tick(void)
{
    uint16_t pads[PADS];
    if (cab.options.demo && board_frame(cab.live.board) >= cab.options.demo->frames) {
        cab.quit = true;
        return;
    }
    live_pads(pads);
    const struct board_out *out = guard_tick(&cab.live, pads);
    write_demo(demo_frame(&cab.writer, cab.live.board, pads));
    log_lines(out);
    hear(out);
    if (out->fault)
        halt(out->fault);
    else if (out->request == REQUEST_QUIT)
        cab.quit = true;
    else if (out->request == REQUEST_ATTRACT && !cab.options.demo)
        attract_begin(out->attract);
}

/* A demo is of a run that went forward. */
static bool has_past(void)
{
    return !cab.options.demo && !cab.options.record;
}

/* Back by so many frames, as far as they are remembered. */
static void go_back(uint32_t frames)
{
    uint32_t now = board_frame(cab.live.board), first = rewind_first(&cab.live.past);
    if (now <= first)
        return;
    if (!cab.rewound)
        save_nvram();
    cab.rewound = true;
    guard_back(&cab.live, now - first > frames ? now - frames : first);
}

static void tick(void)
{
    if (cab.fault || cab.quit)
        return;
    if (cab.attracting)
        attract_tick();
    else
        live_tick();
}

/* ---- picture ---- */

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

static void picture_draw(struct picture *p)
{
    const struct board *b = cab.attracting ? cab.shown.board : cab.live.board;
    if (!cab.fault)
        board_draw(b, &p->fb, p->rgb, p->scratch);
}

static void words_over(struct picture *p, const char *text)
{
    struct ink ink;
    for (int y = 0; y < p->fb.h; y++)
        memcpy(p->over.pix + y * p->over.pitch, p->fb.pix + y * p->fb.pitch, (size_t)p->fb.w);
    memcpy(p->over_rgb, p->rgb, sizeof p->rgb);
    ink_open(&ink, &p->over, p->over_rgb);
    message_draw(&ink, 0, text);
}

/* What we have to say over the picture; false: nothing. */
static bool words(char *text, size_t size)
{
    uint32_t at = board_frame(cab.live.board);
    if (cab.fault)
        snprintf(text, size, "%s\n\n%s", cab.fault->message, cab.fault->trace);
    else if (cab.rewinding)
        snprintf(text, size, "rewind  frame %u", (unsigned)at);
    else if (cab.paused)
        snprintf(text, size, "paused at frame %u", (unsigned)at);
    else if (cab.slow > 1)
        snprintf(text, size, "1/%d speed  frame %u", cab.slow, (unsigned)at);
    return cab.fault || cab.rewinding || cab.paused || cab.slow > 1;
}

static void picture_show(struct picture *p)
{
    char text[sizeof cab.fault->message + sizeof cab.fault->trace + 4];
    bool over = words(text, sizeof text);
    if (over)
        words_over(p, text);
    const struct fb *fb = over ? &p->over : &p->fb;
    plat_show(fb->pix, fb->pitch, fb->w, fb->h, over ? p->over_rgb : p->rgb);
}

/* The board's picture without our words, under the first free number. */
static void screenshot(const struct picture *p)
{
    char name[NAME];
    uint8_t *png;
    size_t size;
    int i = 1;
    do
        snprintf(name, sizeof name, "%s-%d.png", cab.options.cart->m.id, i++);
    while (plat_size(name) >= 0);
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
    if (!plat_open(&cab.want))
        cab.quit = true;
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
    if (k->pressed & 1 << CAB_STEP) {
        assisted();
        cab.paused = cab.step = true;
    }
    if (k->pressed & 1 << CAB_REWIND && !has_past())
        say("curtain: %s: no way back while a demo is recorded or played%s", game(), "");
    if (k->pressed & 1 << CAB_SLOW) {
        assisted();
        cab.slow = cab.slow == MAX_SLOW ? 1 : cab.slow * 2;
    }
    if (k->pressed & 1 << CAB_SCREENSHOT)
        screenshot(&cab.picture);
}

static void poll(struct keys_read *k)
{
    struct plat_input in;
    plat_poll(&in);
    keys_read(&cab.config.keys, &in, k);
    cab.quit = cab.quit || in.quit;
    for (int i = 0; i < PADS; i++)
        cab.pads[i] |= k->pads[i];
    cabinet_keys(k);
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
    cab.rewinding = k->held & 1 << CAB_REWIND && has_past() && !cab.attracting && !cab.fault;
    cab.quiet = cab.rewinding || cab.paused || fast || cab.slow > 1;
    if (cab.rewinding) {
        go_back((uint32_t)frames);
        cab.step = false;
        memset(cab.pads, 0, sizeof cab.pads);
        return;
    }
    if (cab.paused && cab.step)
        tick();
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
    write_demo(demo_end(&cab.writer, cab.live.board));
    demo_free(&cab.writer.demo);
    if (cab.attracting)
        attract_end();
    guard_close(&cab.live);
    picture_close(&cab.picture);
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
    run(frames_due(now), &k, now);
    if (++cab.since_save >= SAVE_EVERY) {
        cab.since_save = 0;
        save_nvram();
    }
    picture_draw(&cab.picture);
    picture_show(&cab.picture);
    if (cab.quit)
        finish();
    return !cab.quit;
}

/* ---- power ---- */

static int refuse(int code, const char *what)
{
    say("curtain: %s: %s", game(), what);
    guard_close(&cab.live);
    picture_close(&cab.picture);
    free(cab.nvram);
    plat_close();
    return code;
}

static uint64_t seed_from_clock(void)
{
    return hash_fold(hash_fold(0, (uint64_t)time(0)), plat_usec());
}

static void want_window(void)
{
    const struct cab_options *o = &cab.options;
    const struct manifest *m = &o->cart->m;
    cab.want = (struct plat_want){ .w = m->screen_w,
                                   .h = m->screen_h,
                                   .scale = o->scale ? o->scale : cab.config.scale,
                                   .fullscreen = o->fullscreen || cab.config.fullscreen,
                                   .title = m->title,
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
    load_nvram();
    if (!guard_power(&cab.live, options->cart->rom, &cab.start, err, sizeof err))
        return refuse(2, err);
    if (has_past())
        guard_remember(&cab.live, REWIND_BYTES);
    want_window();
    if (!plat_open(&cab.want))
        return refuse(3, "there is no window to play in");
    if (!picture_open(&cab.picture, cab.live.board))
        return refuse(3, "not enough memory for the picture");
    if (options->record)
        write_demo(demo_begin(&cab.writer, options->record, options->cart, cab.live.board, &cab.start, 0));
    log_lines(board_last(cab.live.board));
    if (board_last(cab.live.board)->fault)
        halt(board_last(cab.live.board)->fault);
    cab.base = plat_usec();
    plat_loop(frame);
    return cab.code;
}
