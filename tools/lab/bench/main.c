/*
 * main.c - the bench's command line: bench [--out FOLDER] [SECTION...]
 *
 * Prints the measurements of the named sections. Without sections it runs all of them and also writes the page,
 * FOLDER/speed.md and FOLDER/speed/NAME.svg; FOLDER is docs/measured by default. Run it from the repository's folder.
 * Exit 1: something that must hold on any machine did not; missed targets are only reported.
 */
#include <stdio.h>
#include <time.h>
#include "bench.h"

/* Each ends with what the clock did. */
#define CLOCKED(name)                                                                                                  \
    static void clocked_##name(void)                                                                                   \
    {                                                                                                                  \
        section_##name();                                                                                              \
        bench_say_clock();                                                                                             \
    }
CLOCKED(boss)
CLOCKED(crowd)
CLOCKED(prices)
CLOCKED(battle)
CLOCKED(pictures)
CLOCKED(lasers)
CLOCKED(together)
CLOCKED(threads)

static const struct report_part SECTIONS[] = {
    { "machine", section_machine }, { "boss", clocked_boss },         { "crowd", clocked_crowd },
    { "prices", clocked_prices },   { "battle", clocked_battle },     { "pictures", clocked_pictures },
    { "lasers", clocked_lasers },   { "together", clocked_together }, { "threads", clocked_threads },
    { "game", section_game },       { "rewind", section_rewind },     { "replay", section_replay },
    { "games", section_games },     { "memory", section_memory },     { "sound", section_sound },
    { "guards", section_guards },
};
enum { COUNT = sizeof SECTIONS / sizeof *SECTIONS };

static struct {
    struct rom_image image;
    bool wrong;
} bench;

static const char ABOUT[] =
    "# Speed: the cost of a frame\n"
    "\n"
    "`make bench` measures and writes this page and its plots; do not edit them. Each run also checks the engine "
    "against\n"
    "three [independent programs](#the-crowd): all four must agree on every move, hit and pixel, or the run fails.\n"
    "\n"
    "All measurements except those under [Threads](#threads) use one thread, and none uses a graphics card. The "
    "machine and\n"
    "the compiler flags are named below.\n"
    "\n"
    "* Each number is the median over many frames. The number after **±** is half the interquartile range. Short times "
    "are\n"
    "  wall-clock times. Long times are CPU times, which exclude interruptions.\n"
    "* The CPU's speed can change within seconds on a shared machine. Programs that are compared therefore take turns, "
    "a few\n"
    "  frames at a time. The first frame of each turn is a warm-up and does not count. Most sections end with the "
    "CPU's speed\n"
    "  during the measurement.\n"
    "* **▶** marks the standard case in a table. The columns *difference* and *ratio*, if present, compare the other "
    "rows\n"
    "  with the standard case. A ratio is the median of many ratios, so it can differ slightly from the ratio of the "
    "printed\n"
    "  medians.\n"
    "* px means pixels, and 1 GB is 10^9 bytes.\n"
    "\n"
    "A *frame* is the work done sixty times a second, so it may take up to 16.67 ms. The tables divide a frame into "
    "these\n"
    "parts:\n"
    "\n"
    "* the *tick*: scripts, motion, hits, events, and the rest. Bullets are tested against players as they move, so "
    "*motion*\n"
    "  includes these tests. *Hits* turns the results of these tests into events, and runs all other collision tests.\n"
    "* *draw*: drawing the picture\n"
    "* *present*: converting the picture to 32-bit pixels\n"
    "\n"
    "A demo stores a hash of the state once a second; *hash* is the time to compute it, and is not part of the sums. A "
    "bullet\n"
    "that flies *straight* runs no motion program and never comes near a player.\n"
    "\n";

const struct rom *bench_rom(void)
{
    char err[256];

    if (!bench.image.bytes && !pack_load_game("roms/bench", false, &bench.image, err, sizeof err))
        report_fail(err);
    return &bench.image.rom;
}

void bench_game(struct rom_image *game, struct demo *run)
{
    char err[512];

    if (!pack_load_game(BENCH_GAME, false, game, err, sizeof err) || !demo_load(run, BENCH_DEMO, err, sizeof err))
        report_fail(err);
}

void bench_scene(struct scene *s, const struct scene_want *want)
{
    char err[256];

    if (!scene_open(s, bench_rom(), want, err, sizeof err))
        report_fail(err);
}

void bench_tick(struct scene *s)
{
    if (!scene_tick(s))
        report_fail(board_last_output(s->b)->fault->message);
}

void bench_target(const char *what, const char *goal, const char *measured, bool met)
{
    const char *const cells[] = { what, measured, goal, met ? "met" : "**missed**" };

    report_conclude(cells, 4);
}

void bench_claim(const char *wrong, const char *where)
{
    if (!wrong)
        return;
    fprintf(stderr, "bench: %s: %s\n", where, wrong);
    bench.wrong = true;
}

int main(int argc, char **argv)
{
    struct report_options o = { .usage = "bench [--out FOLDER]" };
    char intro[8192];

    if (!report_options(&o, argc, argv, SECTIONS, COUNT))
        return 2;
    setvbuf(stdout, NULL, _IOLBF, 0);
    report_begin(&(struct report){ .program = "bench",
                                   .folder = o.folder ? o.folder
                                             : o.all  ? "docs/measured"
                                                      : NULL,
                                   .page = "speed",
                                   .echo = true });
    double from = bench_now();
    bench_own_clock(false);
    report_run(&o, SECTIONS, COUNT);
    snprintf(intro, sizeof intro, "%sThe bench was running for %s of the time.\n\n", ABOUT,
             report_percent((double)clock() / CLOCKS_PER_SEC * 1e9 / (bench_now() - from)));
    report_finish(intro, "## Targets\n"
                         "\n"
                         "The table shows the engine's design targets and whether this run met them.\n"
                         "\n"
                         "| | measured | target | |\n"
                         "|---|---|---|---|\n");
    rom_image_free(&bench.image);
    return bench.wrong;
}
