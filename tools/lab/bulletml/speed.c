/*
 * speed.c - how long a frame takes, on the board and in libbulletml: the same documents from the same places, in one
 * process, some frames of the one and some of the other by turns.
 *
 * A frame of the board is all of its tick, hits included; one of libbulletml is its runners, and the moves.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "../../../src/machine/machine.h"
#include "../bench/bench.h"
#include "board.h"
#include "list.h"
#include "reference.h"
#include "tool.h"

/* Documents whose bullets have much to do for long: the frames that are timed, and the most of them at once. */
static const struct timed {
    const char *path, *what;
    int from, frames, scripted;
} documents[] = {
    { "/usr/share/games/noiz2sa/boss/[daiouzyou]_hibati_2_2_b.xml", "turns repeatedly", 130, 100, 168 },
    { "/usr/share/doc/libbulletml-dev/doc/sample/[G_DARIUS]_homing_laser.xml", "homing", 130, 100, 72 },
    { "/usr/share/doc/libbulletml-dev/doc/sample/[Progear]_round_6_boss_parabola_shot.xml", "accel", 200, 100, 49 },
    { "/usr/share/doc/libbulletml-dev/doc/sample/[Progear]_round_3_boss_back_burst.xml", "waits, then bursts", 300, 100,
      119 },
    { "/usr/share/games/noiz2sa/boss/double_roll_seeds.xml", "bullets that fire", 100, 100, 82 },
};
enum { DOCUMENTS = sizeof documents / sizeof *documents, SIZES = 4, STRAIGHT_ROOTS = 50 };
static const int sizes[SIZES] = { 1000, 4000, 16000, 64000 };

/* The hosts of libbulletml: one that works sine and cosine of every bullet out in each frame, as is plain, and one that
 * keeps velocities. And the board. */
enum { PLAIN, QUICK, HOSTS, BOARD = HOSTS, RUNNERS, BLOCK = 10 /* frames */ };

struct race {
    struct reference *r[HOSTS];
    struct board_game g;
    uint32_t stream[HOSTS];
    struct samples took[RUNNERS];
    double last, bullets, scripted; /* ns of the board's last frame; sums over the frames */
    char err[SIDE_ERROR];
};

enum { EDGE_X = 160 + 1024, EDGE_Y = 120 + 1024, PLACES_X = 20, PLACES_Y = 10, APART = 10, FIRST_X = -95 };

static bool open_host(struct race *c, int host, const char *path, int roots)
{
    const struct reference_setup s = { .file = path,
                                       .rank = 0.5,
                                       .random = { side_random, &c->stream[host] },
                                       .most = 1 << 18,
                                       .root_x = FIRST_X,
                                       .root_y = REFERENCE_ROOT_Y,
                                       .box_x = EDGE_X,
                                       .box_y = EDGE_Y,
                                       .plain = host == PLAIN };

    c->stream[host] = TOOL_SEED;
    c->r[host] = reference_open(&s, c->err, sizeof c->err);
    for (int i = 1; c->r[host] && i < roots; i++)
        reference_root(c->r[host], FIRST_X + i % PLACES_X * APART, REFERENCE_ROOT_Y + i / PLACES_X % PLACES_Y * APART);
    return c->r[host];
}

static bool open_race(struct race *c, const char *path, int roots)
{
    const struct side_setup setup = { path, 0.5, TOOL_SEED, false };

    *c = (struct race){ 0 };
    return open_host(c, PLAIN, path, roots) && open_host(c, QUICK, path, roots) &&
           board_game_open(&c->g, "crowd", &setup, roots, c->err, sizeof c->err);
}

static void close_race(struct race *c)
{
    for (int i = 0; i < HOSTS; i++)
        if (c->r[i])
            reference_close(c->r[i]);
    board_game_close(&c->g);
    for (int i = 0; i < RUNNERS; i++)
        samples_free(&c->took[i]);
}

/* A frame of one of them. */
static bool frame_of(struct race *c, int runner, int f, bool timed)
{
    const int32_t x = side_player_x(f), y = side_player_y(f);
    const double from = bench_now();
    const bool fine = runner == BOARD ? board_game_tick(&c->g, x, y, c->err, sizeof c->err)
                                      : reference_frame(c->r[runner], x, y, c->err, sizeof c->err);
    const double took = bench_since(from);

    if (timed)
        samples_add(&c->took[runner], took);
    if (runner == BOARD)
        c->last = took;
    return fine;
}

/* Some frames of each by turns, so that each finds its own in the caches as it would without the others. */
static bool run_race(struct race *c, int from, int frames)
{
    for (int f = 0; f < from; f++)
        for (int k = 0; k < RUNNERS; k++)
            if (!frame_of(c, k, f, false))
                return false;
    bench_clock_for(c->last);
    for (int block = from; block < from + frames; block += BLOCK)
        for (int k = 0; k < RUNNERS; k++)
            for (int f = block; f < block + BLOCK; f++) {
                const int runner = (block / BLOCK + k) % RUNNERS;
                if (!frame_of(c, runner, f, true))
                    return false;
                c->bullets += runner == BOARD ? c->g.b->bullets.s.live : 0;
                c->scripted += runner == BOARD ? c->g.b->ml_runners.s.live : 0;
            }
    return true;
}

/* A row of the table. */
static void tell(const struct race *c, const char *what, int frames, double ratio[HOSTS])
{
    const double n = c->bullets / frames, scripted = c->scripted / frames;
    double ns[RUNNERS];

    for (int i = 0; i < RUNNERS; i++)
        ns[i] = samples_median(&c->took[i]);
    for (int i = 0; i < HOSTS; i++)
        ratio[i] = ns[i] / ns[BOARD];
    report_row(0, what, report_count((int64_t)n), report_count((int64_t)scripted), report_string("%.1f", ns[PLAIN] / n),
               report_string("%.1f", ns[QUICK] / n), report_string("%.1f", ns[BOARD] / n),
               report_string("%.1f", ratio[PLAIN]), report_string("%.1f", ratio[QUICK]), NULL);
}

static bool race(const char *path, const char *what, int roots, int from, int frames, double ratio[HOSTS])
{
    struct race c;
    const bool fine = open_race(&c, path, roots) && run_race(&c, from, frames);

    if (fine)
        tell(&c, what, frames, ratio);
    else
        fprintf(stderr, "bulletml: %s: %s\n", path, c.err);
    close_race(&c);
    return fine;
}

static const char columns[] =
    "document|bullets>|runners>|plain host>|fast host>|Curtain>|ratio to plain>|ratio to fast>";

static int by_size(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;

    return (p > q) - (p < q);
}

/* Bullets without actions, n of them from some roots, at once. */
static bool write_straight(const char *path, int n)
{
    FILE *f = fopen(path, "w");

    if (!f)
        return false;
    fprintf(f,
            "<?xml version=\"1.0\"?>\n<bulletml><action label=\"top\"><repeat><times>%d</times><action><fire>"
            "<direction type=\"absolute\">360*$rand</direction><speed>0.1+$rand</speed><bullet/></fire></action>"
            "</repeat></action></bulletml>\n",
            n);
    return fclose(f) == 0;
}

static bool straight(double ratio[SIZES][HOSTS])
{
    char path[] = "/tmp/curtain-straight-XXXXXX";
    const int fd = mkstemp(path);
    bool fine = fd >= 0;

    if (fine)
        close(fd);
    report_table("Bullets without actions", columns);
    for (int k = 0; k < SIZES && fine; k++)
        fine = write_straight(path, sizes[k] / STRAIGHT_ROOTS) &&
               race(path, "straight", STRAIGHT_ROOTS, 20, 100, ratio[k]);
    report_table_end();
    unlink(path);
    return fine;
}

static bool scripted(double ratio[DOCUMENTS * SIZES][HOSTS])
{
    int n = 0;

    report_table("Bullets with actions", columns);
    for (int i = 0; i < DOCUMENTS; i++)
        for (int k = 0; k < SIZES; k++) {
            const struct timed *t = &documents[i];
            if (!race(t->path, report_string("%s (%s)", list_name(t->path), t->what), sizes[k] / t->scripted, t->from,
                      t->frames, ratio[n++]))
                return false;
        }
    report_table_end();
    return true;
}

static double median(double (*ratio)[HOSTS], int n, int host)
{
    double v[DOCUMENTS * SIZES];

    for (int i = 0; i < n; i++)
        v[i] = ratio[i][host];
    qsort(v, (size_t)n, sizeof *v, by_size);
    return n % 2 ? v[n / 2] : (v[n / 2 - 1] + v[n / 2]) / 2;
}

bool tool_speed(struct tool_times *out)
{
    double ratio[DOCUMENTS * SIZES][HOSTS], line[SIZES][HOSTS];

    report_section("Speed");
    report_text(
        "libbulletml only computes the directions and speeds of bullets; a *host* moves them. The *plain host* "
        "computes a bullet's velocity in every frame; the *fast host* computes it only when the direction or speed "
        "changes. Both hosts free a bullet's actions when they have ended, and test whether bullets have left a box.\n"
        "\n"
        "Curtain and both hosts run the same documents from the same positions, in one process, alternating every ten "
        "frames. A document runs in as many copies as needed for 1,000 to 64,000 active bullets. *Runners* is the "
        "number of bullets and documents whose actions are running. The times are medians of 100 frames, in ns per "
        "bullet. A ratio is a host's time divided by Curtain's time. Curtain's frame is a whole tick, including hit "
        "tests. With the largest numbers of bullets, the hosts are slow because the bullets do not fit in the CPU's "
        "caches.");
    if (!scripted(ratio) || !straight(line))
        return false;
    *out = (struct tool_times){ median(ratio, DOCUMENTS * SIZES, PLAIN), median(ratio, DOCUMENTS * SIZES, QUICK),
                                median(line, SIZES, PLAIN), median(line, SIZES, QUICK) };
    return true;
}
