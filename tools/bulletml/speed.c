/*
 * speed.c - how long a frame takes, on the board and in libbulletml: the same documents from the same places, in one
 * process, a frame of the one and a frame of the other by turns.
 *
 * A frame of the board is all of its tick, hits included; one of libbulletml is its runners, and the moves. What it is
 * given is what a host can do for speed: a runner that has ended is dropped, and a bullet's velocity is worked out when
 * its direction or speed change.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "../../src/board/machine.h"
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
    { "/usr/share/games/noiz2sa/boss/[daiouzyou]_hibati_2_2_b.xml", "turns again and again", 130, 100, 168 },
    { "/usr/share/doc/libbulletml-dev/doc/sample/[G_DARIUS]_homing_laser.xml", "homing", 130, 100, 72 },
    { "/usr/share/doc/libbulletml-dev/doc/sample/[Progear]_round_6_boss_parabola_shot.xml", "accel", 200, 100, 49 },
    { "/usr/share/doc/libbulletml-dev/doc/sample/[Progear]_round_3_boss_back_burst.xml", "waits, then bursts", 300, 100,
      119 },
    { "/usr/share/games/noiz2sa/boss/double_roll_seeds.xml", "bullets that fire", 100, 100, 82 },
};
enum { DOCUMENTS = sizeof documents / sizeof *documents, SIZES = 4, STRAIGHT_ROOTS = 50 };
static const int sizes[SIZES] = { 1000, 4000, 16000, 64000 };

/* Both, and what they took. */
struct race {
    struct reference *r;
    struct board_game g;
    uint32_t stream;
    struct reference_counts last;
    struct samples library, board;
    double bullets, scripted, library_bullets, library_scripted; /* sums over the frames */
    char err[SIDE_ERROR];
};

enum { EDGE_X = 160 + 1024, EDGE_Y = 120 + 1024, PLACES_X = 20, PLACES_Y = 10, APART = 10, FIRST_X = -95 };

static bool open_race(struct race *c, const char *path, int roots)
{
    const struct side_setup setup = { path, 0.5, TOOL_SEED, false };

    *c = (struct race){ .stream = TOOL_SEED };
    const struct reference_setup s = { .file = path,
                                       .rank = 0.5,
                                       .random = { side_random, &c->stream },
                                       .most = 1 << 18,
                                       .root_x = FIRST_X,
                                       .root_y = REFERENCE_ROOT_Y,
                                       .box_x = EDGE_X,
                                       .box_y = EDGE_Y };
    c->r = reference_open(&s, c->err, sizeof c->err);
    if (!c->r || !board_game_open(&c->g, "crowd", &setup, roots, c->err, sizeof c->err))
        return false;
    for (int i = 1; i < roots; i++)
        reference_root(c->r, FIRST_X + i % PLACES_X * APART, REFERENCE_ROOT_Y + i / PLACES_X % PLACES_Y * APART);
    return true;
}

static void close_race(struct race *c)
{
    if (c->r)
        reference_close(c->r);
    board_game_close(&c->g);
    samples_free(&c->library);
    samples_free(&c->board);
}

static bool library_frame(struct race *c, int f, bool timed)
{
    struct reference_counts now;
    const double from = bench_now();
    const bool fine = reference_frame(c->r, side_player_x(f), side_player_y(f), c->err, sizeof c->err);
    const double took = bench_since(from);

    reference_count(c->r, &now);
    if (timed) {
        samples_add(&c->library, took);
        c->library_bullets += (double)(now.moved - c->last.moved);
        c->library_scripted += (double)(now.ran - c->last.ran);
    }
    c->last = now;
    return fine;
}

static bool board_frame_of(struct race *c, int f, bool timed)
{
    const double from = bench_now();
    const bool fine = board_game_tick(&c->g, side_player_x(f), side_player_y(f), c->err, sizeof c->err);
    const double took = bench_since(from);

    if (timed) {
        samples_add(&c->board, took);
        c->bullets += c->g.b->bullets.s.live;
        c->scripted += c->g.b->ml_runners.s.live;
    }
    return fine;
}

static bool run_race(struct race *c, int from, int frames)
{
    for (int f = 0; f < from + frames; f++) {
        const bool timed = f >= from;
        if (f & 1 ? !(library_frame(c, f, timed) && board_frame_of(c, f, timed))
                  : !(board_frame_of(c, f, timed) && library_frame(c, f, timed)))
            return false;
    }
    return true;
}

/* A row of the table. */
static void tell(const struct race *c, const char *what, int frames, double *ratio)
{
    const double library = samples_median(&c->library), board = samples_median(&c->board);
    const double n = c->bullets / frames, scripted = c->scripted / frames;

    *ratio = library / board;
    report_row(0, what, report_count((int64_t)n), report_count((int64_t)scripted),
               report_string("%.1f", library / 1000), report_string("%.1f", board / 1000),
               report_string("%.1f", library / (c->library_bullets / frames)), report_string("%.1f", board / n),
               report_string("%.1f", *ratio), NULL);
}

static bool race(const char *path, const char *what, int roots, int from, int frames, double *ratio)
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

static const char columns[] = "document|bullets>|of them scripted>|libbulletml, us a frame>|board>|"
                              "ns a bullet>|board>|times as fast>";

static int by_size(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;

    return (p > q) - (p < q);
}

static double median(double *v, int n)
{
    qsort(v, (size_t)n, sizeof *v, by_size);
    return n % 2 ? v[n / 2] : (v[n / 2 - 1] + v[n / 2]) / 2;
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

static bool straight(double ratio[SIZES])
{
    char path[] = "/tmp/curtain-straight-XXXXXX";
    const int fd = mkstemp(path);
    bool fine = fd >= 0;

    if (fine)
        close(fd);
    report_table("Bullets without actions", columns);
    for (int k = 0; k < SIZES && fine; k++)
        fine = write_straight(path, sizes[k] / STRAIGHT_ROOTS) &&
               race(path, "straight", STRAIGHT_ROOTS, 20, 100, &ratio[k]);
    report_table_end();
    unlink(path);
    return fine;
}

bool tool_speed(double *scripted, double *straight_on)
{
    double ratio[DOCUMENTS * SIZES], line[SIZES];
    int n = 0;

    report_section("Speed");
    report_text("%s", report_machine());
    report_table("Bullets with actions", columns);
    for (int i = 0; i < DOCUMENTS; i++)
        for (int k = 0; k < SIZES; k++) {
            const struct timed *t = &documents[i];
            if (!race(t->path, report_string("%s (%s)", list_name(t->path), t->what), sizes[k] / t->scripted, t->from,
                      t->frames, &ratio[n++]))
                return false;
        }
    report_table_end();
    if (!straight(line))
        return false;
    *scripted = median(ratio, n);
    *straight_on = median(line, SIZES);
    return true;
}

int tool_speed_alone(int argc, char **argv)
{
    double scripted, straight_on;

    (void)argc;
    (void)argv;
    report_begin(&(struct report){ .program = "bulletml", .echo = true });
    if (!tool_speed(&scripted, &straight_on))
        return 1;
    printf("medians: %.1f times, straight %.1f times\n", scripted, straight_on);
    return 0;
}
