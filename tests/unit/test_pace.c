/*
 * test_pace.c - 60 ticks a second on any screen: no drift, no more refreshes with two ticks or none than the rates ask
 * for, and a late host that loses what it says.
 */
#include "../test.h"
#include <math.h>
#include "../../src/player/play/pace.h"
#include "../../tools/lab/pacing/simulate.h"

enum { MINUTES = 10, SECONDS = MINUTES * 60 };

static struct simulate screen(double hz, double told, int late)
{
    return (struct simulate){ .hz = hz,
                              .told = told,
                              .waits = true,
                              .seconds = SECONDS,
                              .work = { 2000, 5000 },
                              .late = late,
                              .seed = (uint64_t)(hz * 100) + (uint64_t)late };
}

static void holds(struct simulate s, int uneven)
{
    const struct simulated r = simulate(&s);

    assert_true(llabs(r.ticks - 60 * SECONDS) <= 3);
    assert_true(llabs(simulated_uneven(&r)) <= uneven);
    assert_true(r.off < 2.5);
    if (s.hz > 60.5)
        assert_true(r.with[2] + r.with[3] <= uneven);
}

/* Some thousandths of a second of jitter make no refresh another than the rates do. */
TEST(screens)
{
    static const double rates[] = { 50, 59.94, 60, 60.05, 75, 119.88, 143.98, 240 };

    for (size_t i = 0; i < sizeof rates / sizeof *rates; i++)
        for (int late = 0; late <= 1500; late += 500)
            holds(screen(rates[i], rates[i], late), 4);
}

/* A wrong rate from the host is found out: 59 for 59.94, 144 for 143.86. */
TEST(told_wrong)
{
    holds(screen(59.94, 59, 500), 4);
    holds(screen(143.86, 144, 500), 4);
    holds(screen(60, 61, 500), 4);
}

/* A screen that does not wait, or is faster than it says, is waited for here: there are 60 ticks, not more. */
TEST(does_not_wait)
{
    struct pace p;
    uint64_t now = 1000000;
    int ticks = 0;

    pace_open(&p, now);
    pace_refresh(&p, 60000, now);
    for (int calls = 0; now < 1000000 + 10 * PACE_SECOND; calls++) {
        assert_true(calls < 3000); /* it is no busy loop */
        now = pace_due(&p) > now ? pace_due(&p) : now + 100;
        if (pace_frame_due(&p, now))
            ticks += pace_take(&p, now).ticks;
    }
    assert_in_range(ticks, 598, 602);
}

/* Without a screen's rate a frame is due every sixtieth, to the microsecond, for ever. */
TEST(no_screen)
{
    struct pace p;
    const uint64_t base = 12345;

    pace_open(&p, base);
    for (uint64_t i = 0; i < 100000; i++) {
        const uint64_t due = base + i * PACE_SECOND / 60;
        assert_true(pace_due(&p) == due);
        assert_true(i == 0 || !pace_frame_due(&p, due - 1));
        assert_true(pace_frame_due(&p, due));
        const struct pace_frame f = pace_take(&p, due);
        assert_int_equal(f.ticks, 1);
        assert_true(f.due == due && f.lost == 0);
    }
}

/* Four ticks at most; the rest is lost, and said. */
TEST(late)
{
    struct pace p;
    struct pace_frame f;

    pace_open(&p, 0);
    assert_int_equal(pace_take(&p, 0).ticks, 1);
    f = pace_take(&p, 40000); /* those of 16666 and 33333 */
    assert_int_equal(f.ticks, 2);
    assert_true(f.due == 16666 && f.lost == 0);
    f = pace_take(&p, 500000);
    assert_int_equal(f.ticks, PACE_MAX_TICKS);
    assert_true(f.due == 50000 && f.lost == 500000 + 16666 - 116666);
    assert_true(pace_due(&p) == 500000 + 16666);
    pace_follow(&p, 700000);
    assert_int_equal(pace_take(&p, 700000).ticks, 1);
    assert_true(pace_due(&p) == 716666);
}

/* Runs frames on this clock until that many ticks are handed out. Each wait ends exactly on time. */
static uint64_t runs(struct pace *p, int refresh, uint64_t now, int ticks)
{
    for (int frames = 0; ticks > 0; frames++) {
        assert_true(frames < 4000);
        pace_refresh(p, refresh, now);
        const uint64_t due = pace_due(p);
        now = due > now ? due : now + (refresh ? 1000000000 / (uint64_t)refresh : 0);
        if (!pace_frame_due(p, now))
            continue;
        const struct pace_frame f = pace_take(p, now);
        assert_in_range(f.ticks, 1, PACE_MAX_TICKS);
        assert_true(f.due <= now);
        ticks -= f.ticks;
        pace_worked(p, 5000);
    }
    return now;
}

/* A clock that jumps, both ways and by any time: the game goes on at once, at its rate. */
TEST(jumps)
{
    static const int64_t jumps[] = { -7200000000, -1000000, 200000, 5000000, 86400000000, -86400000000 };
    static const int rates[] = { 0, 60000, 143980, 50000 };
    struct pace p;

    for (size_t r = 0; r < sizeof rates / sizeof *rates; r++) {
        uint64_t now = 100000000000;
        pace_open(&p, now);
        now = runs(&p, rates[r], now, 600);
        for (size_t i = 0; i < sizeof jumps / sizeof *jumps; i++) {
            now += (uint64_t)jumps[i];
            pace_worked(&p, (uint64_t)jumps[i]); /* it jumped in the middle of a frame */
            const uint64_t from = now;
            now = runs(&p, rates[r], now, 600);
            assert_in_range(now - from, 9700000, 10100000);
            assert_true(p.work < PACE_SECOND);
        }
    }
}

RUN_TESTS(NULL, NULL)
