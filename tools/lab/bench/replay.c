/*
 * replay.c - section "replay": what it takes to play a run again without a picture: to verify its demo, and to bring it
 * onto a changed game.
 */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../../src/player/replay.h"
#include "../../../src/player/play/session.h"
#include "../../../src/workbench/pack/pack.h"
#include "bench.h"

enum { ROUNDS = 3, FIVE_MINUTES = 5 * 60 * 60, MINUTE = 60 * 60, SLICE_USEC = 12000 };

/* Seconds that verifying takes. */
static double verify(const struct cart *cart, const struct demo *d)
{
    static struct replay r;
    struct verdict v;
    char err[256];
    double from = bench_now();

    if (replay_run(&r, cart, d, NULL, &v, err, sizeof err) != RESULT_DONE)
        report_fail(err);
    bench_claim(v.kind == VERDICT_HOLDS ? NULL : "the demo does not hold", "verifying");
    replay_close(&r);
    return bench_since(from) / 1e9;
}

/* A copy of the game's folder with a comment more in its entry script; its folder's name is the game's id. */
static void change_game(char path[256])
{
    char command[1024], dir[] = "/tmp/curtain-bench-XXXXXX";
    const char *name = strrchr(BENCH_GAME, '/') + 1;

    if (!mkdtemp(dir))
        report_fail("no folder for a copy of the game");
    snprintf(command, sizeof command, "cp -R '%s' '%s/' && echo '-- changed' >>'%s/%s/main.lua'", BENCH_GAME, dir, dir,
             name);
    if (system(command) != 0)
        report_fail("the game cannot be copied");
    snprintf(path, 256, "%s/%s", dir, name);
}

static void remove_game(const char *path)
{
    char command[512];

    snprintf(command, sizeof command, "rm -rf '%.*s'", (int)(strrchr(path, '/') - path), path);
    if (system(command) != 0)
        report_fail("the copy of the game cannot be removed");
}

/* Plays so many frames, then seconds from the change of a file to the same frame of the changed game. */
static double reload(const struct cart *cart, const struct board_start *start, const struct demo *d, uint32_t frames,
                     const char *changed)
{
    static struct session s;

    if (!session_open(&s, cart, start, NULL, NULL))
        report_fail(s.err);
    while (board_frame(session_board(&s)) < frames) {
        uint16_t pads[MAX_PLAYERS];
        demo_pads(d, board_frame(session_board(&s)), pads);
        session_tick(&s, pads);
    }
    uint64_t hash = board_hash(session_board(&s));
    double from = bench_now();
    bool good = session_reload(&s, pack_load_game, changed, false) && s.state == SESSION_RELOADING;
    while (good && s.state != SESSION_PLAYING)
        good = session_work(&s, plat_usec() + SLICE_USEC);
    double took = bench_since(from) / 1e9;
    bench_claim(good && board_hash(session_board(&s)) == hash ? NULL : "it does not land on the same frame",
                "reloading");
    session_close(&s);
    return took;
}

void section_replay(void)
{
    static struct demo demo;
    struct rom_image image;
    struct cart cart;
    struct samples rate = { 0 };
    char err[256], changed[256];
    struct board_start phase;

    bench_game(&image, &demo);
    if (!cart_open(&cart, &image.rom, err, sizeof err))
        report_fail(err);
    for (int i = 0; i < ROUNDS; i++)
        samples_add(&rate, demo.frames / verify(&cart, &demo));
    change_game(changed);
    double whole = reload(&cart, &demo.start, &demo, FIVE_MINUTES, changed);
    phase = demo.start;
    snprintf(phase.practice.section, sizeof phase.practice.section, "one");
    double piece = reload(&cart, &phase, &demo, MINUTE, changed);
    remove_game(changed);

    double median = samples_median(&rate);
    report_section("Replay and reload");
    report_text("**Verifying** a demo of the complete run processes **%s frames a second** on one core (the median of "
                "%d runs). Verifying compares the checksums of all parts of the state after every frame, and their "
                "full hashes once a second.",
                report_count((int64_t)median), ROUNDS);
    report_text("**Reloading.** If a script changes after five minutes of play (%s frames), the changed game reaches "
                "the same frame **%s s** later. This time includes packing the folder. After one minute of play from a "
                "practice start, a reload takes %s s.",
                report_count(FIVE_MINUTES), report_figure(whole), report_figure(piece));
    bench_target("verifying a demo of the complete run", "3,000 frames a second",
                 report_string("%s frames a second", report_count((int64_t)median)), median >= 3000);
    bench_target("a reload after five minutes of play", "8 s", report_string("%s s", report_figure(whole)), whole <= 8);
    bench_target("a reload after a minute of play from a practice start", "1 s",
                 report_string("%s s", report_figure(piece)), piece <= 1);
    samples_free(&rate);
    demo_free(&demo);
    rom_image_free(&image);
}
