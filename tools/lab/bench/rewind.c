/*
 * rewind.c - section "rewind": what a snapshot of the built-in game takes, what the past that a window keeps of a run
 * costs, and how long a step back takes. The run is played up to the end of its densest minute, which is then gone back
 * through, a frame a step; then on to frame LATE, and ten seconds back from there.
 */
#include <stdlib.h>
#include <string.h>
#include "../../../src/player/run/guard.h"
#include "bench.h"

enum { SECOND = 60, MINUTE = 60 * SECOND, ALIGN = 64, SAVES = 3, ROUNDS = 3, LATE = 10 * MINUTE, LATE_STEPS = 600 };
static const double SNAPSHOT_US = 20, STEP_MS = 16;

/* The run as far as it was played, and what was measured on the way. */
struct past_run {
    const struct demo *demo;
    struct guard guard;
    uint32_t end;   /* of the densest minute */
    double bullets; /* in it, on average */
    uint64_t *hash; /* of each frame to end */
    uint8_t *copy;  /* a snapshot's room */
    size_t copy_room;
    struct samples bytes, again, key, plain; /* snapshots: their size; into memory just used; as key frames; copies */
    struct samples step, late;               /* steps back: through the minute, from frame LATE */
    uint64_t most_ticks;
};

static void *aligned_bytes(size_t n)
{
    void *p = aligned_alloc(ALIGN, (n + ALIGN - 1) / ALIGN * ALIGN);

    if (!p)
        report_fail("out of memory");
    memset(p, 0, n);
    return p;
}

static void power(struct past_run *r, const struct rom *rom)
{
    char err[256];

    if (!guard_power(&r->guard, rom, &r->demo->start, err, sizeof err))
        report_fail(err);
}

static void tick(struct board *b, const uint16_t pads[MAX_PLAYERS])
{
    if (board_tick(b, pads)->fault)
        report_fail(board_last_output(b)->fault->message);
}

/* The minute of the run with the most bullets. */
static void find_densest(struct past_run *r, const struct rom *rom)
{
    uint32_t *live = calloc(r->demo->frames, sizeof *live);
    uint64_t sum = 0, most = 0;

    if (!live)
        report_fail("out of memory");
    power(r, rom);
    for (uint32_t f = 0; f < r->demo->frames; f++) {
        uint16_t pads[MAX_PLAYERS];
        demo_pads(r->demo, f, pads);
        tick(r->guard.board, pads);
        sum += live[f] = (uint32_t)board_live_count(r->guard.board, "bullets");
        sum -= f >= MINUTE ? live[f - MINUTE] : 0;
        if (f + 1 >= MINUTE && sum > most) {
            most = sum;
            r->end = f + 1;
        }
    }
    if (most == 0)
        report_fail(BENCH_DEMO ": no minute with bullets");
    r->bullets = (double)most / MINUTE;
    guard_close(&r->guard);
    free(live);
}

/* Snapshots into the same memory one after the other; the first, which brings it into the caches, does not count. */
static void save_again(struct past_run *r)
{
    const struct board *b = r->guard.board;
    size_t size = board_snapshot_size(b);

    if (size > r->copy_room) {
        free(r->copy);
        r->copy = aligned_bytes(r->copy_room = 2 * size);
    }
    for (int i = 0; i < SAVES; i++) {
        double from = bench_now();
        board_save(b, r->copy);
        if (i > 0)
            samples_add(&r->again, bench_since(from));
    }
    samples_add(&r->bytes, (double)size);
}

/* What a window does before a tick; a key frame's time is kept. */
static void remember(struct past_run *r, const uint16_t pads[MAX_PLAYERS])
{
    struct rewind *past = r->guard.past;
    uint32_t now = board_frame(r->guard.board);
    double from = bench_now();
    bool kept = rewind_push(past, r->guard.board, pads);
    double took = bench_since(from);

    if (!kept)
        report_fail("out of memory");
    if (past->key[past->n - 1].frame == now)
        samples_add(&r->key, took);
}

/* Plays to the end of the minute, with drawing, so that the caches hold what they do in a game. */
static void play(struct past_run *r, const struct rom *rom)
{
    struct fb fb;
    uint32_t rgb[256];
    int w, h;

    power(r, rom);
    if (!guard_store_past(&r->guard))
        report_fail("out of memory");
    board_screen_size(r->guard.board, &w, &h);
    uint8_t *mem = aligned_bytes(fb_size(w, h)), *scratch = aligned_bytes(board_scratch_size(r->guard.board));
    fb_init(&fb, mem, w, h);
    r->hash = calloc(r->end + 1, sizeof *r->hash);
    if (!r->hash)
        report_fail("out of memory");
    for (uint32_t f = 0; f < r->end; f++) {
        uint16_t pads[MAX_PLAYERS];
        if (f + MINUTE >= r->end)
            r->hash[f] = board_hash(r->guard.board);
        demo_pads(r->demo, f, pads);
        remember(r, pads);
        tick(r->guard.board, pads);
        board_draw(r->guard.board, NULL, &fb, rgb, scratch);
        if (f % SECOND == 0)
            save_again(r);
    }
    free(mem);
    free(scratch);
}

/* The C library's copy of as many bytes, in one piece each, through as much memory as the past may take. The first
 * round only makes the memory be there. */
static void copy_plainly(struct past_run *r)
{
    size_t size = (size_t)samples_median(&r->bytes) / ALIGN * ALIGN, n = ((size_t)GUARD_PAST_MIB << 20) / size;
    uint8_t *to = aligned_bytes(n * size), *from = aligned_bytes(size);

    for (size_t i = 0; i < ROUNDS * n; i++) {
        double start = bench_now();
        memcpy(to + i % n * size, from, size);
        if (i >= n)
            samples_add(&r->plain, bench_since(start));
    }
    free(to);
    free(from);
}

/* One step back to frame f, whose hash is known. */
static void step_back(struct past_run *r, uint32_t f, uint64_t hash, struct samples *steps)
{
    double from = bench_now();
    bool back = guard_rewind(&r->guard, f);

    samples_add(steps, bench_since(from));
    bench_claim(back && board_hash(r->guard.board) == hash ? NULL : "a frame is not the frame it was", "stepping back");
}

static void through_the_minute(struct past_run *r)
{
    for (uint32_t f = r->end; f-- > r->end - MINUTE;) {
        uint64_t ticks = r->guard.past->replayed;
        step_back(r, f, r->hash[f], &r->step);
        ticks = r->guard.past->replayed - ticks;
        r->most_ticks = ticks > r->most_ticks ? ticks : r->most_ticks;
    }
}

/* On to frame LATE, with nothing pressed once the demo is over. */
static void from_late(struct past_run *r)
{
    static uint64_t hash[LATE_STEPS];
    const struct board *b = r->guard.board;

    guard_rewind(&r->guard, rewind_end(r->guard.past));
    while (board_frame(b) < LATE) {
        uint16_t pads[MAX_PLAYERS];
        if (board_frame(b) >= LATE - LATE_STEPS)
            hash[board_frame(b) - (LATE - LATE_STEPS)] = board_hash(b);
        demo_pads(r->demo, board_frame(b), pads);
        remember(r, pads);
        tick(r->guard.board, pads);
    }
    for (uint32_t i = LATE_STEPS; i-- > 0;)
        step_back(r, LATE - LATE_STEPS + i, hash[i], &r->late);
}

static void report_snapshots(struct past_run *r)
{
    double us = samples_median(&r->again) / 1e3, key_us = samples_median(&r->key) / 1e3;

    report_text(
        "**A snapshot** of the built-in game (`board_save`) has %s bytes (the median), and %s at most. Saving a "
        "snapshot to recently used memory takes **%s µs**; the 99th percentile is %s µs. The rewind history has %d "
        "MiB, so each of its key frames is written to memory that is not in a cache. Writing a key frame takes **%s "
        "µs**; the 99th percentile is %s µs. For comparison, `memcpy` takes %s µs to copy the same number of bytes to "
        "such memory. A key frame is saved every few frames, which costs %s µs per frame on average.",
        report_figure(samples_median(&r->bytes)), report_figure(samples_quantile(&r->bytes, 1)),
        samples_figure(&r->again, 1e3), report_figure(samples_quantile(&r->again, 0.99) / 1e3), GUARD_PAST_MIB,
        samples_figure(&r->key, 1e3), report_figure(samples_quantile(&r->key, 0.99) / 1e3),
        samples_figure(&r->plain, 1e3), report_figure(key_us * r->key.n / r->end));
    bench_target("a snapshot of the built-in game", "20 µs", report_string("%s µs", report_figure(us)),
                 us < SNAPSHOT_US);
    bench_target("a snapshot of the built-in game, saved as a key frame of the rewind history", "20 µs",
                 report_string("%s µs", report_figure(key_us)), key_us < SNAPSHOT_US);
}

static void report_late(struct past_run *r)
{
    double worst = samples_quantile(&r->late, 1) / 1e6;
    const char *median = report_figure(samples_median(&r->late) / 1e6);

    report_text(
        "At frame %s, a step back takes %s ms (the median of %d consecutive steps). The slowest step takes %s ms.",
        report_count(LATE), median, LATE_STEPS, report_figure(worst));
    bench_target("a step back at frame 36,000", "16 ms",
                 report_string("median %s ms, worst %s ms", median, report_figure(worst)), worst < STEP_MS);
}

static void report_steps(struct past_run *r, double kept, int keys, uint64_t again)
{
    double worst = samples_quantile(&r->step, 1) / 1e6;
    const char *median = report_figure(samples_median(&r->step) / 1e6);
    const char *slow = report_figure(samples_quantile(&r->step, 0.99) / 1e6);

    report_text(
        "**Rewind.** The densest minute of the run ends at second %s and has %s bullets on average. At that point the "
        "history covers %s seconds with %d key frames. Stepping back through that minute, one frame at a time, takes "
        "%s ms per step (the median). The 99th percentile is %s ms, and the slowest step takes %s ms. A step replays "
        "%s frames on average, and %s at most. Each restored frame has its original hash.",
        report_count(r->end / SECOND), report_count((int64_t)(r->bullets + 0.5)), report_figure(kept), keys, median,
        slow, report_figure(worst), report_figure((double)again / MINUTE), report_count((int64_t)r->most_ticks));
    bench_target("rewind history that fits in 64 MiB, at the end of the built-in game's densest minute", "60 s",
                 report_string("%s s", report_figure(kept)), kept >= 60);
    bench_target("a step back in that minute", "16 ms",
                 report_string("median %s ms, 99th percentile %s ms, worst %s ms", median, slow, report_figure(worst)),
                 worst < STEP_MS);
}

void section_rewind(void)
{
    static struct past_run r;
    static struct demo demo;
    struct rom_image image;

    bench_game(&image, &demo);
    r = (struct past_run){ .demo = &demo };
    find_densest(&r, &image.rom);
    bench_own_clock(true);
    play(&r, &image.rom);
    copy_plainly(&r);
    double kept = (double)(rewind_end(r.guard.past) - rewind_first(r.guard.past)) / SECOND;
    int keys = (int)r.guard.past->n;
    through_the_minute(&r);
    uint64_t again = r.guard.past->replayed;
    from_late(&r);
    bench_own_clock(false);

    report_section("Snapshots and rewind");
    report_snapshots(&r);
    report_steps(&r, kept, keys, again);
    report_late(&r);
    samples_free(&r.bytes);
    samples_free(&r.again);
    samples_free(&r.key);
    samples_free(&r.plain);
    samples_free(&r.step);
    samples_free(&r.late);
    free(r.copy);
    free(r.hash);
    guard_close(&r.guard);
    demo_free(&demo);
    rom_image_free(&image);
}
