/*
 * play_replay.c - demos opened during play: replays that are watched, and the unfinished run, which is replayed as fast
 * as possible and then continued. They may need an older ROM of the game, stored by its hash; the game's current ROM
 * waits meanwhile.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/files.h"
#include "../replays/roms.h"
#include "play_state.h"

static bool refuse(struct play *play, const char *what, const char *why)
{
    play_warn(play, "%s: %s", what, why);
    screens_show_message(&play->screens, "%s", play->message.text);
    return false;
}

void play_free_replay(struct play *play)
{
    struct play_replay *r = &play->replay;

    if (r->demo)
        demo_free(r->demo);
    free(r->demo);
    free(r->nvram);
    r->demo = NULL;
    r->nvram = NULL;
    r->watching = r->resuming = r->same = false;
}

void play_close_replay(struct play *play)
{
    play_free_replay(play);
    session_rom_free(play->replay.home_rom);
    memset(&play->replay, 0, sizeof play->replay);
}

/* ---- changing the session ---- */

const struct cart *play_home_cart(const struct play *play)
{
    return play->replay.home ? play->replay.home : play_cart(play);
}

/* Moves the ownership of ROMs from the old run to the new one, and to play->replay while an older ROM runs. */
static void move_roms(struct play_replay *r, struct session_run *old, struct session_run *new, struct session_rom *rom)
{
    if (new->cart == old->cart) {
        new->rom = old->rom;
        old->rom = NULL;
    } else if (new->cart == r->home) {
        new->rom = r->home_rom;
        r->home = NULL;
        r->home_rom = NULL;
    } else {
        new->rom = rom;
        if (!r->home) {
            r->home = old->cart;
            r->home_rom = old->rom;
            old->rom = NULL;
        }
    }
}

/* Replaces the session and ends the present run. Takes ownership of rom, which owns the cart. If rom is NULL, the cart
 * is the present one or the current one. */
static bool change_session(struct play *play, const struct cart *cart, struct session_rom *rom,
                           const struct board_start *start, struct demo *demo, const char *what)
{
    struct session new;

    attract_end(&play->attract);
    if (!session_open(&new, cart, start, demo, demo ? NULL : play->options.record)) {
        session_rom_free(rom);
        return refuse(play, what, new.err);
    }
    play_autosave_end(play);
    play_save_nvram(play);
    move_roms(&play->replay, play->session.now, new.now, rom);
    if (!session_close(&play->session))
        play_check_recording(play, false);
    play->session = new;
    play_free_replay(play);
    play->replay.demo = demo;
    play->seek.reported_difference = 0;
    play_reset_run(play, start);
    play_apply_rom(play);
    return true;
}

/* Finds the ROM to play a demo on: the current one if the game is the same, otherwise the stored one that the demo was
 * recorded on. Sets *rom to NULL if *cart is loaded already. On failure, returns false and sets err. */
static bool find_cart(struct play *play, const struct demo *d, const struct cart **cart, struct session_rom **rom,
                      char *err, size_t err_size)
{
    const struct cart *home = play_home_cart(play);
    char path[ROMS_PATH];

    *rom = NULL;
    *cart = home;
    if (rom_hash(home->rom) == d->rom_hash || rom_game_hash(home->rom) == d->game_hash)
        return true;
    if (rom_hash(play_cart(play)->rom) == d->rom_hash) {
        *cart = play_cart(play);
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

/* Loads a demo and starts its playback. exact: only if it can be played as it was recorded. */
static bool open_demo(struct play *play, const char *path, const char *what, bool exact)
{
    struct demo *d = calloc(1, sizeof *d);
    const struct cart *cart = NULL;
    struct session_rom *rom = NULL;
    char err[DEMO_ERR_SIZE] = "out of memory", why[256];

    bool good = d && demo_load(d, path, err, sizeof err);
    if (good && !find_cart(play, d, &cart, &rom, err, sizeof err))
        good = false;
    if (good && !demo_check_cart(d, cart, err, sizeof err))
        good = false;
    if (good && exact && demo_replay_warning(d, cart, why, sizeof why)) {
        snprintf(err, sizeof err, "%s", why);
        good = false;
    }
    if (!good) {
        session_rom_free(rom);
        refuse(play, what, err);
    } else if (change_session(play, cart, rom, &d->start, d, what)) {
        return true;
    }
    if (d)
        demo_free(d);
    free(d);
    return false;
}

/* ---- watching ---- */

bool play_is_watching(const struct play *play)
{
    return play->replay.watching && play->session.demo && !play->attract.on;
}

bool play_watch(struct play *play, const char *path, uint32_t frame)
{
    if (play->options.record || play->options.demo)
        return refuse(play, "Replay unavailable", "not available with --record or --demo");
    if (!open_demo(play, path, "Cannot show this replay", false))
        return false;
    play->replay.watching = true;
    play->replay.first = frame;
    play->replay.hint_frames = REPLAY_HINT_FRAMES;
    session_goto(&play->session, frame);
    return true;
}

void play_return_to_title(struct play *play)
{
    struct board_start start;

    if (!play->replay.home && !play->replay.demo && !play->session.demo) {
        play_restart(play);
        return;
    }
    play_title_start(play, &start);
    uint8_t *nvram = play_load_nvram(play, &start);
    if (!change_session(play, play_home_cart(play), NULL, &start, NULL, "Cannot start the game")) {
        free(nvram);
        return;
    }
    free(play->nvram.image);
    play->nvram.image = nvram;
    practice_start_run(&play->practice, &start);
    play_log_output(play);
    play_report_fault(play);
    play_offer_resume(play); /* the replay may have interrupted a run */
}

/* ---- resuming ---- */

bool play_find_unfinished(struct play *play, struct replay_meta *c)
{
    struct demo d;
    char path[PLAY_NAME_SIZE], err[DEMO_ERR_SIZE];

    play_resume_path(play, path);
    if (plat_file_size(path) < 0)
        return false;
    if (!demo_load(&d, path, err, sizeof err)) {
        play_log(play, "curtain: %s; the unfinished run is lost", err);
        play_show_message(play, MESSAGE_FRAMES, "The unfinished run is lost: its file is damaged");
        return false;
    }
    bool good = replay_meta_of_demo(c, &d) && c->end == REPLAY_LEFT && strcmp(c->id, play_cart(play)->manifest.id) == 0;
    demo_free(&d);
    return good;
}

/* Compares the run's image with the saved one, whenever the run has written to it. */
static void compare_nvram(void *context, const struct session *s)
{
    struct play_replay *r = context;
    size_t size;
    uint32_t changed;
    const uint8_t *image = board_nvram(session_board(s), &size, &changed);

    if (changed == r->changed)
        return;
    r->changed = changed;
    r->same = r->same || (size == r->nvram_size && memcmp(image, r->nvram, size) == 0);
}

/* Loads the saved image, and compares it with that of the start. */
static void start_comparing(struct play *play)
{
    struct play_replay *r = &play->replay;
    struct board_start saved = { 0 };
    const struct board_start *start = &r->demo->start;

    r->nvram = play_load_nvram(play, &saved);
    r->nvram_size = r->nvram ? saved.nvram_size : 0;
    r->changed = 0;
    r->same = r->nvram_size == start->nvram_size &&
              (r->nvram_size == 0 || memcmp(r->nvram, start->nvram, r->nvram_size) == 0);
    play->session.ticked = r->nvram ? compare_nvram : NULL;
    play->session.context = r;
}

bool play_resume(struct play *play)
{
    static const char what[] = "Cannot resume the run";
    char path[PLAY_NAME_SIZE];

    play_resume_path(play, path);
    if (play->options.record || play->options.demo)
        return refuse(play, what, "not available with --record or --demo");
    if (!open_demo(play, path, what, true)) {
        play_archive_unfinished(play);
        return false;
    }
    start_comparing(play);
    play->replay.resuming = true;
    session_goto(&play->session, play->replay.demo->frames);
    if (play->session.state == SESSION_PLAYING)
        play_resume_finish(play);
    return true;
}

void play_resume_finish(struct play *play)
{
    const uint32_t frames = play->session.now->writer.demo.frames;
    const bool same = play->replay.same;

    if (!play->replay.resuming)
        return;
    play->replay.resuming = false;
    play->session.ticked = NULL;
    if (!session_resume(&play->session, DEMO_RESUMED)) {
        refuse(play, "Cannot resume the run", play->session.err);
        play_archive_unfinished(play);
        play_return_to_title(play);
        return;
    }
    play->nvram.saved_count = 0; /* save the run's image */
    play_autosave_sync(play);
    play->time.paused = play->time.waits_for_button = true;
    play->seek.bar_frames = 0;
    play_show_message(play, MESSAGE_STAYS,
                      same ? "Run resumed: press a button"
                           : "Run resumed: press a button. High scores have changed since you left this run, so its "
                             "scores are not saved");
    play_log(play, "curtain: %s: resumed at frame %u%s", play_game_name(play), (unsigned)frames,
             same ? "" : "; high scores have changed since the run was interrupted, so its scores are not saved");
}
