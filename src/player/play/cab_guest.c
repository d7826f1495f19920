/*
 * cab_guest.c - demos that the cabinet opens while it runs: replays that are watched, and the run that was left, which
 * is played again as fast as it goes and then gone on with. They may need an older ROM of the game, which is kept by
 * its hash; the game's own waits meanwhile.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/files.h"
#include "../replays/roms.h"
#include "cab_parts.h"

static bool refuse(struct cab *cab, const char *what, const char *why)
{
    cab_notice(cab, CAB_NOTICE_FRAMES, "%s: %s", what, why);
    screens_say(&cab->screens, "%s", cab->notice);
    cab_say(cab, "curtain: %s", cab->notice);
    return false;
}

void cab_guest_forget(struct cab *cab)
{
    if (cab->guest.demo)
        demo_free(cab->guest.demo);
    free(cab->guest.demo);
    free(cab->guest.nvram);
    cab->guest.demo = NULL;
    cab->guest.nvram = NULL;
    cab->guest.watching = cab->guest.resuming = cab->guest.same = false;
}

void cab_guest_close(struct cab *cab)
{
    cab_guest_forget(cab);
    session_rom_free(cab->guest.home_rom);
    memset(&cab->guest, 0, sizeof cab->guest);
}

/* ---- another session ---- */

/* Opens a session in place of the present one, which is left as by quitting. rom owns the cart, NULL where it is the
 * present one's or the home's; it is taken. */
static bool change_session(struct cab *cab, const struct cart *cart, struct session_rom *rom,
                           const struct board_start *start, struct demo *demo, const char *what)
{
    struct session new;
    struct session_run *old;

    if (cab->attracting)
        cab_attract_end(cab);
    if (!session_open(&new, cart, start, demo, demo ? NULL : cab->options.record)) {
        session_rom_free(rom);
        return refuse(cab, what, new.err);
    }
    cab_keep_leave(cab);
    cab_save_nvram(cab);
    old = cab->session.now;
    if (cart == old->cart) { /* it goes on in the new session */
        new.now->rom = old->rom;
        old->rom = NULL;
    } else if (cart == cab->guest.home) {
        new.now->rom = cab->guest.home_rom;
        cab->guest.home = NULL;
        cab->guest.home_rom = NULL;
    } else {
        new.now->rom = rom;
        if (!cab->guest.home) {
            cab->guest.home = old->cart;
            cab->guest.home_rom = old->rom;
            old->rom = NULL;
        }
    }
    if (!session_close(&cab->session))
        cab_check_recording(cab, false);
    cab->session = new;
    cab_guest_forget(cab);
    cab->guest.demo = demo;
    cab->taken = cab->awaits = false;
    cab->differs = 0;
    cab_powered(cab, start);
    cab_fit_cart(cab);
    return true;
}

/* The ROM that a demo is played on: the game's own if it is the same game, else the kept one that it was recorded on.
 * NULL: *cart is one that is there already. */
static bool find_cart(struct cab *cab, const struct demo *d, const struct cart **cart, struct session_rom **rom,
                      char *err, size_t err_size)
{
    const struct cart *home = cab->guest.home ? cab->guest.home : cab_cart(cab);
    char path[ROMS_PATH];

    *rom = NULL;
    *cart = home;
    if (rom_hash(home->rom) == d->rom_hash || rom_game_hash(home->rom) == d->game_hash)
        return true;
    if (rom_hash(cab_cart(cab)->rom) == d->rom_hash) {
        *cart = cab_cart(cab);
        return true;
    }
    roms_path(path, d->id, d->rom_hash);
    if (!roms_has(d->id, d->rom_hash)) {
        snprintf(err, err_size, "the game has changed and its old version is not stored (%s)", path);
        return false;
    }
    *rom = session_rom_load(rom_image_read, path, false, err, err_size);
    *cart = *rom ? &(*rom)->cart : home;
    return *rom != NULL;
}

/* Reads a demo and opens a playback of it. */
static bool open_demo(struct cab *cab, const char *path, const char *what, bool exact)
{
    struct demo *d = calloc(1, sizeof *d);
    const struct cart *cart = NULL;
    struct session_rom *rom = NULL;
    char err[DEMO_ERR_SIZE] = "out of memory", why[256];

    bool good = d && demo_load(d, path, err, sizeof err);
    if (good && !find_cart(cab, d, &cart, &rom, err, sizeof err)) {
        good = !exact; /* as far as it goes on the game as it is */
        cart = cab->guest.home ? cab->guest.home : cab_cart(cab);
    }
    if (good && !demo_check_cart(d, cart, err, sizeof err))
        good = false;
    if (good && exact && demo_replay_warning(d, cart, why, sizeof why)) {
        snprintf(err, sizeof err, "%s", why);
        good = false;
    }
    if (!good)
        refuse(cab, what, err);
    else if (change_session(cab, cart, rom, &d->start, d, what))
        return true;
    else
        rom = NULL; /* it was taken */
    session_rom_free(rom);
    if (d)
        demo_free(d);
    free(d);
    return false;
}

/* ---- to watch ---- */

bool cab_watch(struct cab *cab, const char *path, uint32_t frame)
{
    if (cab->options.record || cab->options.demo)
        return refuse(cab, "Replay unavailable", "not available with --record or --demo");
    if (!open_demo(cab, path, "Cannot show this replay", false))
        return false;
    cab->guest.watching = true;
    session_goto(&cab->session, frame);
    return true;
}

void cab_home(struct cab *cab)
{
    struct board_start start;

    if (!cab->guest.home && !cab->guest.demo && !cab->session.demo) {
        cab_begin_anew(cab);
        return;
    }
    cab_home_start(cab, &start);
    uint8_t *nvram = cab_load_nvram(cab, &start);
    if (!change_session(cab, cab->guest.home ? cab->guest.home : cab_cart(cab), NULL, &start, NULL,
                        "Cannot start the game")) {
        free(nvram);
        return;
    }
    free(cab->nvram);
    cab->nvram = nvram;
    practice_began(&cab->practice, &start);
    cab_log_lines(cab, board_last_output(cab_live(cab)));
    if (cab_fault(cab))
        cab_report_fault(cab);
    cab_open_resume(cab); /* a run may have been left for this */
}

/* ---- to go on with ---- */

bool cab_was_left(struct cab *cab, struct replay_meta *c)
{
    struct demo d;
    char path[CAB_NAME], err[DEMO_ERR_SIZE];

    cab_resume_path(cab, path);
    if (plat_file_size(path) < 0)
        return false;
    if (!demo_load(&d, path, err, sizeof err)) {
        cab_say(cab, "curtain: %s; the unfinished run is lost", err);
        cab_notice(cab, CAB_NOTICE_FRAMES, "The unfinished run is lost: its file is damaged");
        return false;
    }
    bool good = replay_meta_of_demo(c, &d) && c->end == REPLAY_LEFT && strcmp(c->id, cab_cart(cab)->manifest.id) == 0;
    demo_free(&d);
    return good;
}

/* Has the run now just the saved image? Looked at whenever it has written to it. */
static void watch_nvram(void *of, const struct session *s)
{
    struct cab *cab = of;
    struct cab_guest *g = &cab->guest;
    size_t size;
    uint32_t changed;
    const uint8_t *image = board_nvram(session_board(s), &size, &changed);

    if (changed == g->changed)
        return;
    g->changed = changed;
    g->same = g->same || (size == g->nvram_size && memcmp(image, g->nvram, size) == 0);
}

/* Keeps the saved image to compare, and compares it with that of the start. */
static void begin_watch(struct cab *cab)
{
    struct cab_guest *g = &cab->guest;
    struct board_start saved = { 0 };
    const struct board_start *start = &g->demo->start;

    g->nvram = cab_load_nvram(cab, &saved);
    g->nvram_size = g->nvram ? saved.nvram_size : 0;
    g->changed = 0;
    g->same = g->nvram_size == start->nvram_size &&
              (g->nvram_size == 0 || memcmp(g->nvram, start->nvram, g->nvram_size) == 0);
    cab->session.ticked = g->nvram ? watch_nvram : NULL;
    cab->session.of = cab;
}

bool cab_resume(struct cab *cab)
{
    static const char what[] = "Cannot resume the run";
    char path[CAB_NAME];

    cab_resume_path(cab, path);
    if (cab->options.record || cab->options.demo)
        return refuse(cab, what, "not available with --record or --demo");
    if (!open_demo(cab, path, what, true)) {
        cab_keep_left(cab);
        return false;
    }
    begin_watch(cab);
    cab->guest.resuming = true;
    session_goto(&cab->session, cab->guest.demo->frames);
    if (cab->session.state == SESSION_PLAYING)
        cab_resume_arrived(cab);
    return true;
}

void cab_resume_arrived(struct cab *cab)
{
    const struct demo *d = &cab->session.now->writer.demo;

    if (!cab->guest.resuming)
        return;
    cab->guest.resuming = false;
    cab->session.ticked = NULL;
    if (!session_go_on(&cab->session, DEMO_RESUMED)) {
        refuse(cab, "Cannot resume the run", cab->session.err);
        cab_keep_left(cab);
        cab_home(cab);
        return;
    }
    cab->nvram_saved = 0; /* the run's image is written anew */
    cab_keep_follow(cab);
    cab->paused = cab->awaits = true;
    cab->timebar_left = 0;
    cab_notice(cab, CAB_NOTICE_STAYS, "Run resumed: press a button%s",
               cab->guest.same ? ""
                               : ". High scores have changed since you left this run, so its scores are not saved");
    cab_say(cab, "curtain: %s: resumed at frame %u%s", cab_game(cab), (unsigned)d->frames,
            cab->guest.same ? ""
                            : "; high scores have changed since the run was interrupted, so its scores are not saved");
}
