/*
 * crowds.c - section "crowd": the engine and the three references through the same frames, in turns.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../src/base/rng.h"
#include "bench.h"
#include "crowd.h"
#include "../../../platform/platform.h"
#include "../../../src/machine/video/video.h"

enum {
    REFERENCES = 3,
    RIVALS = 1 + REFERENCES,
    MOST_FRAMES = 64,
    MOST_SIZES = 20,
    MOST_GUESSES = 4,
    K1 = 1024,
    K16 = 16384,
    M1 = 1048576,
    OWN_CLOCK = 60000,
    BYTES_MOVED = 24,
    STORES = 8
};
static const double FRAME = 1e9 / 60, AIM = 0.994e9 / 60; /* ns; a guess is to fall just below */
static const struct reference *const references[REFERENCES] = { &reference_array, &reference_columns,
                                                                &reference_least };

/* What was measured at one n, in ns a frame. */
struct size {
    int n, frames;
    struct samples laps[LAPS], total[RIVALS], hash;
    struct samples tick[RIVALS], draw[RIVALS], present[RIVALS];
    struct crowd_counts counts[RIVALS];
    double update; /* bytes a ns of this many bullets' columns */
};

static struct size sizes[MOST_SIZES];
static int n_sizes;

/* A slice: the engine's frames, then each reference's, with the player as it was. */
struct arena {
    struct scene scene;
    struct laps laps;
    struct crowd crowd;
    void *data[REFERENCES];
    uint32_t *shown[RIVALS];
    struct crowd_player players[MOST_FRAMES];
};

static void open_arena(struct arena *a, int n)
{
    bench_scene(&a->scene, &(struct scene_want){ .does = "crowd", .n = n, .bullets = n, .seed = 1 + (uint64_t)n });
    while (board_live_count(a->scene.b, "bullets") < n) /* the largest crowds take more than a frame to fire */
        bench_tick(&a->scene);
    if (!crowd_take(&a->crowd, &a->scene) || a->crowd.n != n)
        report_fail("the crowd is not what it should be");
    for (int i = 0; i < REFERENCES; i++)
        if (!(a->data[i] = references[i]->open(&a->crowd)))
            report_fail("out of memory");
    for (int i = 0; i < RIVALS; i++)
        if (!(a->shown[i] = calloc((size_t)(a->crowd.w * a->crowd.h), sizeof **a->shown)))
            report_fail("out of memory");
    board_set_phase_callback(a->scene.b, laps_phase, &a->laps);
}

static void close_arena(struct arena *a)
{
    for (int i = 0; i < RIVALS; i++)
        free(a->shown[i]);
    for (int i = 0; i < REFERENCES; i++)
        references[i]->close(a->data[i]);
    free((void *)(uintptr_t)a->crowd.bullets);
    scene_close(&a->scene);
}

static void engine_frame(struct arena *a, struct size *s, bool count)
{
    struct laps *l = &a->laps;
    double sum = 0;

    laps_begin(l);
    bench_tick(&a->scene);
    scene_draw(&a->scene);
    laps_end(l, LAP_DRAW);
    plat_convert_to_rgb(a->shown[0], a->crowd.w, a->scene.fb.pix, a->scene.fb.pitch, a->crowd.w, a->crowd.h,
                        a->scene.rgb);
    laps_end(l, LAP_PRESENT);
    crowd_count(&s->counts[0], &a->scene, true);
    for (int i = 0; i < LAPS; i++)
        sum += l->ns[i];
    if (!count)
        return;
    for (int i = 0; i < LAPS; i++)
        samples_add(&s->laps[i], l->ns[i]);
    samples_add(&s->total[0], sum);
    samples_add(&s->tick[0], sum - l->ns[LAP_DRAW] - l->ns[LAP_PRESENT]);
    samples_add(&s->draw[0], l->ns[LAP_DRAW]);
    samples_add(&s->present[0], l->ns[LAP_PRESENT]);
}

static void reference_frame(struct arena *a, struct size *s, int which, const struct crowd_player *p, bool count)
{
    const struct reference *r = references[which];
    struct crowd_counts *counts = &s->counts[1 + which];
    double tick, draw, show, from = bench_now();
    int pitch;

    r->tick(a->data[which], p, counts);
    tick = bench_since(from);
    from = bench_now();
    r->draw(a->data[which], counts);
    draw = bench_since(from);
    from = bench_now();
    const uint8_t *pix = r->picture(a->data[which], &pitch);
    reference_expand(a->shown[1 + which], pix, pitch, a->crowd.w, a->crowd.h, a->scene.rgb);
    show = bench_since(from);
    if (!count)
        return;
    samples_add(&s->total[1 + which], tick + draw + show);
    samples_add(&s->tick[1 + which], tick);
    samples_add(&s->draw[1 + which], draw);
    samples_add(&s->present[1 + which], show);
}

/* Each in turn. The first frame of a turn warms up, because the caches still hold another's bullets. */
static void slice(struct arena *a, struct size *s, int frames, bool count)
{
    bench_look();
    for (int f = 0; f < frames; f++) {
        engine_frame(a, s, count && f > 0);
        a->players[f] = crowd_player(&a->scene);
    }
    for (int i = 0; i < REFERENCES; i++)
        for (int f = 0; f < frames; f++)
            reference_frame(a, s, i, &a->players[f], count && f > 0);
    double from = bench_now();
    board_hash(a->scene.b);
    if (count)
        samples_add(&s->hash, bench_since(from));
    s->frames += frames;
}

/* What must be so at the end of each n, whatever the machine. */
static void check(const struct arena *a, const struct size *s)
{
    const char *where = report_string("a crowd of %s", report_count(s->n));
    size_t bytes = (size_t)(a->crowd.w * a->crowd.h) * sizeof **a->shown;

    for (int i = 0; i < REFERENCES; i++) {
        const char *who = report_string("%s, %s", where, references[i]->name);
        const struct crowd_counts *all = &s->counts[0], *its = &s->counts[1 + i];
        bool equal = references[i] == &reference_least
                         ? all->moved == its->moved && all->hit == its->hit && all->drawn == its->drawn
                         : !memcmp(all, its, sizeof *all);
        bench_claim(equal ? NULL : "it does not count what the engine counts", who);
        bench_claim(crowd_differs(&a->crowd, &a->scene, references[i], a->data[i]), who);
        bench_claim(memcmp(a->shown[0], a->shown[1 + i], bytes) ? "other pixels are shown" : NULL, who);
    }
    bench_claim(s->counts[0].tested && s->counts[0].hit && s->counts[0].grazed ? NULL : "nothing is hit or grazed",
                where);
    bench_claim(crowd_misdrawn(&a->crowd, &a->scene), where);
}

/* The measured size of n bullets. */
static struct size *size_of(int n)
{
    for (int i = 0; i < n_sizes; i++)
        if (sizes[i].n == n)
            return &sizes[i];
    return NULL;
}

/* Runs a crowd of n; its times stay in sizes[]. */
static struct size *run(int n)
{
    struct size *s = &sizes[n_sizes++];
    struct arena a = { .data = { NULL } };
    int frames = n < 3000 ? 48 : n < 10000 ? 24 : n < 40000 ? 16 : n < 150000 ? 8 : 6;
    int rounds = n <= 100000 ? 25 : n <= 600000 ? 15 : n < 2000000 ? 11 : 5;

    *s = (struct size){ .n = n, .update = limit_update((size_t)n * 16) };
    open_arena(&a, n);
    bench_own_clock(n >= OWN_CLOCK);
    for (int round = -1; round < rounds; round++) /* the first warms up */
        slice(&a, s, frames, round >= 0);
    bench_own_clock(false);
    check(&a, s);
    close_arena(&a);
    fprintf(stderr, "bench: a crowd of %s: %s ms a frame\n", report_count(n),
            report_figure(samples_median(&s->total[0]) / 1e6)); /* the tables come when all are measured */
    return s;
}

static double total(struct size *s)
{
    return samples_median(&s->total[0]);
}

/* How many times the engine's frame reference r takes: in the same turns. */
static double times(struct size *s, int r)
{
    return samples_ratio(&s->total[r], &s->total[0]);
}

/* ---- what is said of it ---- */

static const char *per_bullet(const struct samples *s, int n)
{
    return report_figure(samples_median(s) / n);
}

static void split_table(void)
{
    static const char *const names[LAPS] = { "scripts", "motion", "hits", "events", "rest", "draw", "present" };

    report_table("Nanoseconds per bullet and frame, by part of the frame",
                 "n> | scripts> | motion> | hits> | events> | rest> | draw> | present> | sum> | (hash)>");
    for (int i = 0; i < n_sizes; i++) {
        const char *cells[LAPS + 3] = { report_count(sizes[i].n) };
        for (int k = 0; k < LAPS; k++)
            cells[1 + k] = per_bullet(&sizes[i].laps[k], sizes[i].n);
        cells[LAPS + 1] = samples_figure(&sizes[i].total[0], sizes[i].n);
        cells[LAPS + 2] = per_bullet(&sizes[i].hash, sizes[i].n);
        report_cells(0, cells, LAPS + 3);
    }
    report_table_end();
    report_plot(&(struct report_plot){
        "split", "A frame of the crowd, by part", "bullets", "ns per bullet and frame", .timed = true,
        .described = "Nanoseconds per bullet by number of bullets, one line for each part of a frame" });
    for (int k = 0; k < LAPS; k++) {
        double x[MOST_SIZES], y[MOST_SIZES];
        if (k == LAP_SCRIPTS || k == LAP_REST) /* they do not depend on n */
            continue;
        for (int i = 0; i < n_sizes; i++) {
            x[i] = sizes[i].n;
            y[i] = samples_median(&sizes[i].laps[k]) / sizes[i].n;
        }
        report_plot_line(names[k], k == LAP_DRAW, x, y, n_sizes);
    }
    report_plot_end();
}

/* The engine's tick and draw in those of reference r. */
static const char *beside(struct size *s, int r)
{
    return report_string("%s", report_figure((samples_median(&s->tick[0]) + samples_median(&s->draw[0])) /
                                             (samples_median(&s->tick[r]) + samples_median(&s->draw[r]))));
}

static void parts_table(void)
{
    report_table("Nanoseconds per bullet and frame, by part of the frame. Each cell lists the engine's time, "
                 "then the times of (a), (b) and (c). The last two columns are the engine's tick plus draw, divided by "
                 "the tick plus draw of (b) or (c)",
                 "n> | tick> | draw> | present> | vs (b)> | vs (c)>");
    for (int i = 0; i < n_sizes; i++) {
        struct size *s = &sizes[i];
        const struct samples *part[] = { s->tick, s->draw, s->present };
        const char *cells[6] = { report_count(s->n) };
        for (int k = 0; k < 3; k++)
            cells[1 + k] =
                report_string("%s / %s / %s / %s", per_bullet(&part[k][0], s->n), per_bullet(&part[k][1], s->n),
                              per_bullet(&part[k][2], s->n), per_bullet(&part[k][3], s->n));
        cells[4] = beside(s, 2);
        cells[5] = beside(s, 3);
        report_cells(0, cells, 6);
    }
    report_table_end();
}

static void rivals_table(void)
{
    static const char *const names[RIVALS] = { "the engine", "doubles, byte loop", "columns, words", "the minimum" };

    report_text(
        "**Compared with plain C.** Three programs without an engine run the same crowd from the same first frame, "
        "with the player on the same path:\n"
        "\n"
        "* (a) *array*: an array of structs of doubles. The program tests every bullet in full and branches for every "
        "pixel.\n"
        "* (b) *columns*: columns of int32. The program tests 64 bullets at a time, and draws with masked 8-byte words "
        "that are prepared once per bullet kind.\n"
        "* (c) *minimum*: like (b), but reduced to what this scene needs. The program has no grazes and no test for "
        "leaving the field. Every sprite must be 8x8 px with one palette bank, so the program draws two rows at once.\n"
        "\n"
        "All three programs store bullets grouped by kind, so no sorting is needed. None of the programs has scripts, "
        "motion programs, handles, deaths, or a state that can be saved. Each program converts its picture with one "
        "table lookup per pixel.");
    report_table("Microseconds per frame; ratios are relative to the engine",
                 "n> | engine> | frames a second> | (a) array> | ratio> | (b) columns> | ratio> | (c) minimum> | "
                 "ratio>");
    for (int i = 0; i < n_sizes; i++) {
        struct size *s = &sizes[i];
        const char *cells[3 + 2 * REFERENCES] = { report_count(s->n), samples_figure(&s->total[0], 1e3),
                                                  report_count((int64_t)(1e9 / total(s))) };
        for (int r = 1; r < RIVALS; r++) {
            cells[1 + 2 * r] = samples_figure(&s->total[r], 1e3);
            cells[2 + 2 * r] = report_string("%s x", report_figure(times(s, r)));
        }
        report_cells(0, cells, 3 + 2 * REFERENCES);
    }
    report_table_end();
    report_plot(&(struct report_plot){
        "crowd", "A frame of the crowd: motion, hits, picture, pixels", "bullets", "ns per bullet and frame",
        .timed = true,
        .described = "Nanoseconds per bullet by number of bullets, for the engine and the three programs in plain C" });
    for (int r = 0; r < RIVALS; r++) {
        double x[MOST_SIZES], y[MOST_SIZES];
        for (int i = 0; i < n_sizes; i++) {
            x[i] = sizes[i].n;
            y[i] = samples_median(&sizes[i].total[r]) / sizes[i].n;
        }
        report_plot_line(names[r], r == 0, x, y, n_sizes);
    }
    report_plot_end();
    parts_table();
}

static void counts_table(void)
{
    report_table(
        "Counts over all frames. The engine and the three programs agree, but (c) counts neither tests nor grazes",
        "n> | frames> | moved> | tested> | hit> | grazed> | drawn>");
    for (int i = 0; i < n_sizes; i++) {
        const struct crowd_counts *c = &sizes[i].counts[0];
        report_row(0, report_count(sizes[i].n), report_count(sizes[i].frames), report_count((int64_t)c->moved),
                   report_count((int64_t)c->tested), report_count((int64_t)c->hit), report_count((int64_t)c->grazed),
                   report_count((int64_t)c->drawn), NULL);
    }
    report_table_end();
    report_text("A bullet is *tested* in a frame if the box around its path comes close enough to the player for an "
                "exact test. Each bullet can graze a player only once. After the last frame for each n, all programs "
                "have every bullet at the same position and show the same pixels. The picture is also the same as that "
                "of a simple renderer that copies byte by byte.");
}

static void limits_table(void)
{
    report_text("**Limits of the machine.** Moving a bullet reads 16 bytes and writes 8. In the next table, the limit "
                "for motion and hits is the memory bandwidth of `x[i] += v[i]` over the same amount of memory. The "
                "limit for drawing a bullet is the time of the 8 stores that an 8x8 sprite needs.");
    report_table(NULL, "n> | motion + hits> | share of the limit> | draw> | share of the limit>");
    for (int i = 0; i < n_sizes; i++) {
        struct size *s = &sizes[i];
        double tick = samples_median(&s->laps[LAP_MOTION]) + samples_median(&s->laps[LAP_HITS]);
        double draw = samples_median(&s->draw[0]);
        report_row(0, report_count(s->n),
                   report_string("%s GB/s (limit %s)", report_figure(BYTES_MOVED * (double)s->n / tick),
                                 report_figure(s->update)),
                   report_percent(BYTES_MOVED * (double)s->n / tick / s->update),
                   report_string("%s ns (limit %s)", report_figure(draw / s->n), report_figure(STORES * limit_store())),
                   report_percent(STORES * limit_store() * s->n / draw), NULL);
    }
    report_table_end();
}

static int by_n(const void *a, const void *b)
{
    return ((const struct size *)a)->n - ((const struct size *)b)->n;
}
static int whole_blocks(double n)
{
    return (int)(n > 1 << 22 ? 1 << 22 : n) / 64 * 64;
}

/* The measurement of n, made if it was not. */
static struct size *measured(int n)
{
    return size_of(n) ? size_of(n) : run(n);
}

/*
 * The largest measured n whose frame takes no more than a sixtieth of a second. From n on, each guess lies on the line
 * through the two n measured last (the first on that through 0), until one is just below.
 */
static int find_60(int n)
{
    struct size *before = NULL, *last = measured(n);
    int found = 0;

    for (int k = 0; k < MOST_GUESSES; k++) {
        double slope = before ? (total(last) - total(before)) / (last->n - before->n) : total(last) / last->n;
        bool close = total(last) <= FRAME && total(last) >= 2 * AIM - FRAME;
        n = whole_blocks(last->n + (AIM - total(last)) / slope);
        if (slope <= 0 || n < 64 || n == last->n || close)
            break;
        before = last;
        last = measured(n);
    }
    for (int i = 0; i < n_sizes; i++)
        if (total(&sizes[i]) <= FRAME && sizes[i].n > found)
            found = sizes[i].n;
    return found;
}

static void targets(struct size *found)
{
    struct size *k16 = size_of(K16), *m1 = size_of(M1);
    double words = times(k16, 2), bytes = times(k16, 1);
    double growth = total(m1) / m1->n / (total(k16) / k16->n);

    bench_target("bullets at 60 frames a second", "2,500,000",
                 report_string("%s in %s ms", report_count(found->n), report_figure(total(found) / 1e6)),
                 found->n >= 2500000);
    bench_target("a frame with 1,048,576 bullets of 8x8 px", "6 ms, ideally 4.5 ms",
                 report_string("%s ms", report_figure(total(m1) / 1e6)), total(m1) <= 6e6);
    bench_target("16,384 bullets, compared with plain C on columns of int32", "1.3 times as fast",
                 report_string("%s times as fast", report_figure(words)), words >= 1.3);
    bench_target("16,384 bullets, compared with plain C on structs of doubles", "4 times as fast",
                 report_string("%s times as fast", report_figure(bytes)), bytes >= 4);
    bench_target("cost per bullet in a crowd of 1,048,576, relative to a crowd of 16,384", "less than 2 times",
                 report_string("%s times", report_figure(growth)), growth < 2);
}

/* 16,384 bullets without programs: what the move, the keep box, the swept hit and the graze of one cost. */
static void without_programs(void)
{
    enum { N = 16384, FRAMES = 400 };
    struct scene s;
    struct laps l;
    struct samples ns = { 0 };

    bench_scene(&s, &(struct scene_want){ .does = "creep", .n = N, .bullets = N, .seed = 5 });
    board_set_phase_callback(s.b, laps_phase, &l);
    for (int f = 0; f < FRAMES; f++) {
        laps_begin(&l);
        bench_tick(&s);
        if (f >= FRAMES / 8)
            samples_add(&ns, l.ns[LAP_MOTION] + l.ns[LAP_HITS]);
    }
    report_text("**Without programs.** In a scene of %s bullets that fly straight all over the field around a player, "
                "motion and the tests for hits, grazes and leaving the field take %s ns per bullet and frame.",
                report_count(N), samples_figure(&ns, N));
    bench_target("motion and the tests for hits, grazes and leaving the field, per bullet, with 16,384 bullets that "
                 "run no programs",
                 "0.5 ns", report_string("%s ns", report_figure(samples_median(&ns) / N)),
                 samples_median(&ns) / N <= 0.5);
    samples_free(&ns);
    scene_close(&s);
}

void section_crowd(void)
{
    static const int USUAL[] = { K1, 4096, K16, 65536, 262144, M1 };

    report_section("The crowd");
    report_text("In this scene, n bullets of 8x8 px fly all over a field of 320x240 px at 0.5 to 3 px/frame. There are "
                "16 bullet kinds and 8 palette banks. Bullets have a hit radius of 3 px. Each bullet flies for 60 "
                "frames, then turns around and comes back. In every frame, one bullet in sixty therefore runs a step "
                "of its motion program, and the others fly straight. A player with a hit radius of 2 px and a graze "
                "radius of 12 px moves among the bullets. The scene is in `roms/bench` (DIP switch `does=crowd`).");
    for (size_t i = 0; i < sizeof USUAL / sizeof *USUAL; i++)
        run(USUAL[i]);
    const int n = find_60(2 * M1);
    qsort(sizes, (size_t)n_sizes, sizeof *sizes, by_n);
    split_table();
    rivals_table();
    counts_table();
    limits_table();
    struct size *k1 = size_of(K1), *k16 = size_of(K16), *m1 = size_of(M1), *found = size_of(n);
    report_text("**Growth.** A bullet costs %s ns in a crowd of %s, %s ns in a crowd of %s, and %s ns in a crowd of "
                "%s. From the second crowd to the third, the cost changes by a factor of %s. In the first crowd, much "
                "of the cost is for presenting, which takes the same time for every crowd.",
                per_bullet(&k1->total[0], k1->n), report_count(k1->n), per_bullet(&k16->total[0], k16->n),
                report_count(k16->n), per_bullet(&m1->total[0], m1->n), report_count(m1->n),
                report_figure(total(m1) / m1->n / (total(k16) / k16->n)));
    report_text(
        "**Sixty frames a second.** One core reaches 60 frames a second with **%s bullets**. A frame then takes %s of "
        "the 16.67 ms. A board can have at most %s bullets.",
        report_count(found->n), samples_figure(&found->total[0], 1e6), report_count(1 << 22));
    without_programs();
    targets(found);
    for (int i = 0; i < n_sizes; i++) {
        struct size *s = &sizes[i];
        for (int k = 0; k < LAPS; k++)
            samples_free(&s->laps[k]);
        for (int k = 0; k < RIVALS; k++) {
            samples_free(&s->total[k]);
            samples_free(&s->tick[k]);
            samples_free(&s->draw[k]);
            samples_free(&s->present[k]);
        }
        samples_free(&s->hash);
    }
}
