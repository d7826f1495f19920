/*
 * main.c - the bench's command line: bench [--out FOLDER] [SECTION...]
 * floor: tools
 *
 * Prints what it measures; without sections all of them, and then the page is written as well: FOLDER/speed.md and
 * FOLDER/speed/NAME.svg, FOLDER being docs unless named. Run from the repository's folder. Exit 1: something that must
 * hold on any machine did not; a target that was missed is only said.
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
    "# Speed: what a frame costs\n"
    "\n"
    "`make bench` measures this page and writes it with its plots; do not edit it. All figures are of one core and of "
    "the\n"
    "machine named below; another has others. What holds on every machine, that the engine and three programs that "
    "share\n"
    "nothing with it move, hit and draw the same, is compared in each run, and a difference fails it.\n"
    "\n"
    "* A figure is the median over many frames; **±** is half the distance of the quartiles. Times are the wall's, but "
    "of\n"
    "  what takes long and is likely to be interrupted they are the bench's own share.\n"
    "* A machine that others share changes its clock within seconds, so a time says little without its second. What "
    "is\n"
    "  compared runs in turns, a slice of frames each (the first of a slice warms up), and a ratio is the median of "
    "the ratios\n"
    "  of the same turn. Sections end with what the clock did meanwhile.\n"
    "* A *frame* is what a cabinet does sixty times a second: the tick (scripts, motion, hits, events, rest), the "
    "picture\n"
    "  (draw), and its colours as 32-bit pixels (present). *Hash* is the state's hash, which a demo takes once a "
    "second; it\n"
    "  is not in the sums. Bullets are tested against players as they move, so *motion* has that too; *hits* raises "
    "what came\n"
    "  of it, and has the other collisions. Sixty frames a second leave 16.67 ms each.\n"
    "* A *straight* bullet runs no program, and no player comes near it.\n"
    "* Nothing is drawn by the graphics card, no other thread helps, and the compiler's flags are those named below.\n"
    "* px is a pixel, a frame 1/60 s, 1 GB 10^9 bytes.\n"
    "\n";

const struct rom *bench_rom(void)
{
    char err[256];

    if (!bench.image.bytes && !rom_image_load("roms/bench", false, &bench.image, err, sizeof err))
        report_fail(err);
    return &bench.image.rom;
}

void bench_game(struct rom_image *game, struct demo *run)
{
    char err[512];

    if (!rom_image_load(BENCH_GAME, false, game, err, sizeof err) || !demo_load(run, BENCH_DEMO, err, sizeof err))
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
        report_fail(board_last(s->b)->fault->message);
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
                                             : o.all  ? "docs"
                                                      : NULL,
                                   .page = "speed",
                                   .echo = true });
    printf("%s\n\n", report_machine());
    double from = bench_now();
    bench_own_clock(false);
    report_run(&o, SECTIONS, COUNT);
    snprintf(intro, sizeof intro, "%sMeasured on: %s; the bench had its core for %s of the time.\n\n", ABOUT,
             report_machine(), report_percent((double)clock() / CLOCKS_PER_SEC * 1e9 / (bench_now() - from)));
    report_finish(intro,
                  "## Targets\n\nWhat was asked of the engine before it was built this way, and whether this run "
                  "met it.\n\n| | measured | target | |\n|---|---|---|---|\n");
    rom_image_free(&bench.image);
    return bench.wrong;
}
