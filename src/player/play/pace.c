/*
 * pace.c - the free and the locked mode (pace.h).
 *
 * In locked mode, the clock of the refreshes is a sum of equal steps, so it has no jitter; each whole number that it
 * passes is a tick. The delay of the calls relative to this clock is smoothed. If the delay leaves the dead band, the
 * clock is corrected by it at once; as the error took `counted` refreshes to build up, the step is corrected by that
 * fraction of it. In the dead band nothing is corrected, so at a rate of 60 each refresh has one tick for a very long
 * time, and jitter can't cause refreshes with two ticks and none.
 */
#include "pace.h"

#include "../../base/int.h"

enum {
    TICK = 1000000,
    SMOOTH = 16,             /* refreshes */
    BAND = TICK / 4,         /* dead band of the clock's error; on a fast screen a quarter of a refresh */
    MARGIN = 4,              /* a picture is shown at least a quarter of a refresh after the refresh before its own */
    SAFETY_MARGIN = 4000,    /* usec by which a picture is early */
    MIN_DELAY = 1000,        /* usec: shorter delays are skipped */
    WORK_DECAY = 256,        /* frames until a long one is almost forgotten */
    CAREFUL_REFRESHES = 300, /* after a missed one */
    SETTLE_TICKS = 2,        /* at the start, which place the clock */
    MIN_RATE_WINDOW = 30,    /* refreshes over which an error of the rate is spread, at least */
    MAX_AHEAD = PACE_SECOND / 8, /* usec until the next frame; more only if the clock was set back */
    RATE_LIMIT = 32,             /* the rate is corrected by 1/32 at most */
    EARLIEST_PHASE = TICK / 4    /* in a tick, when it is due: the least delay without the dead band */
};

void pace_open(struct pace *p, uint64_t now)
{
    *p = (struct pace){ .base = now };
}

static int64_t step_of(int refresh)
{
    return (int64_t)60 * TICK * 1000 / refresh;
}

static void start_locked(struct pace *p, uint64_t now)
{
    p->base = now;
    p->ticks = 0;
    p->step = step_of(p->refresh);
    p->at = TICK / 2;
    p->off = 0;
    p->counted = 0;
    p->asleep = false;
    p->begin = 0;
    p->delay = 0;
    p->careful_left = CAREFUL_REFRESHES;
}

/* Returns the time `at` millionths of a tick after the base. */
static uint64_t time_of(const struct pace *p, int64_t at)
{
    return p->base + (uint64_t)int64_max(at, 0) / 60;
}

static uint64_t free_due(const struct pace *p, uint64_t tick)
{
    return p->base + tick * PACE_SECOND / 60;
}

/* The clock of the refreshes is TICK / 2 ahead of the base, at which the first tick is due. */
static uint64_t refresh_due(const struct pace *p, int64_t at)
{
    return time_of(p, at - TICK / 2);
}

uint64_t pace_due(const struct pace *p)
{
    if (!p->refresh)
        return free_due(p, p->ticks);
    if (p->begin)
        return p->begin;
    return p->asleep ? refresh_due(p, p->at + p->step + p->step / MARGIN) : 0;
}

static void restart(struct pace *p, uint64_t now)
{
    if (p->refresh)
        start_locked(p, now);
    else
        pace_open(p, now);
}

void pace_refresh(struct pace *p, int refresh, uint64_t now)
{
    const uint64_t due = pace_due(p);

    refresh = refresh < PACE_MIN_REFRESH || refresh > PACE_MAX_REFRESH ? 0 : refresh;
    if (refresh == p->refresh && (due <= now || due - now <= MAX_AHEAD))
        return;
    p->refresh = refresh;
    restart(p, now);
}

/* Corrects the clock and its rate. */
static void correct(struct pace *p)
{
    const int64_t right = step_of(p->refresh), most = right / RATE_LIMIT;

    p->step = int64_clamp(p->step + p->off / int_max(p->counted, MIN_RATE_WINDOW), right - most, right + most);
    p->at += p->off;
    p->off = 0;
    p->counted = 0;
}

/* Places the first refreshes in the middle of a tick, so the margins on both sides are equal. */
static bool settle(struct pace *p, uint64_t now)
{
    p->base = now - (p->ticks + 1) * PACE_SECOND / 60;
    p->at = (int64_t)p->ticks * TICK + TICK + TICK / 2;
    return true;
}

/* Counts the present refresh. Returns false if the screen did not wait for it. */
static bool count_refresh(struct pace *p, uint64_t now)
{
    if (p->ticks < SETTLE_TICKS)
        return settle(p, now);
    const int64_t measured = (int64_t)(now - p->base) * 60 + TICK / 2, late = measured - p->at - p->step;

    if (late < -p->step / 2)
        return false;
    p->at += p->step;
    p->counted++;
    p->careful_left -= p->careful_left > 0;
    if (late > p->step / 2) { /* some were missed: this one's delay is unknown */
        p->at += (late + p->step / 2) / p->step * p->step;
        p->careful_left = CAREFUL_REFRESHES;
        return true;
    }
    p->off += (late - p->off) / SMOOTH;
    if (int64_abs(p->off) > int64_min(BAND, p->step / 4))
        correct(p);
    return true;
}

/* Starts the frame of a due tick, or delays it as long as its picture is in time for the next refresh. Returns whether
 * it starts. */
static bool begin_frame(struct pace *p, uint64_t now)
{
    const uint64_t end = refresh_due(p, p->at + p->off + p->step), needs = (uint64_t)p->work + SAFETY_MARGIN;

    p->delay = 0;
    if (p->careful_left || end < now + needs + MIN_DELAY)
        return true;
    p->begin = end - needs;
    p->delay = (int64_t)(p->begin - now);
    return false;
}

void pace_worked(struct pace *p, uint64_t usec)
{
    const int64_t took = usec < MAX_AHEAD ? (int64_t)usec : MAX_AHEAD; /* more isn't work: the machine slept */

    p->work = int64_max(took, p->work - p->work / WORK_DECAY);
}

bool pace_frame_due(struct pace *p, uint64_t now)
{
    if (!p->refresh)
        return now >= free_due(p, p->ticks);
    if (p->begin) {
        const bool due = now >= p->begin;
        p->begin = due ? 0 : p->begin;
        return due;
    }
    if (p->asleep && now < pace_due(p)) /* plat_wait returned early */
        return false;
    if (p->asleep) {
        p->at += p->step;
        p->counted++;
        p->asleep = false;
    } else if (!count_refresh(p, now)) {
        p->asleep = true;
        return false;
    }
    p->asleep = p->at / TICK < (int64_t)p->ticks + 1;
    return !p->asleep && begin_frame(p, now);
}

static struct pace_frame take_free(struct pace *p, uint64_t now)
{
    struct pace_frame f = { .ticks = 1, .due = free_due(p, p->ticks) };

    while (f.ticks < PACE_MAX_TICKS && free_due(p, p->ticks + (uint64_t)f.ticks) <= now)
        f.ticks++;
    p->ticks += (uint64_t)f.ticks;
    const uint64_t next = free_due(p, p->ticks);
    if (next <= now) {
        f.lost = now + PACE_SECOND / 60 - next;
        p->base = now;
        p->ticks = 1;
    }
    return f;
}

static struct pace_frame take_locked(struct pace *p, uint64_t now)
{
    const int64_t ready = p->at / TICK - (int64_t)p->ticks;
    struct pace_frame f = { .ticks = (int)int64_clamp(ready, 1, PACE_MAX_TICKS) };
    const uint64_t due = time_of(p, (int64_t)p->ticks * TICK + EARLIEST_PHASE) + (uint64_t)p->delay;

    f.due = due < now ? due : now;
    p->ticks += (uint64_t)f.ticks;
    if (ready > PACE_MAX_TICKS) {
        f.lost = (uint64_t)(ready - PACE_MAX_TICKS) * PACE_SECOND / 60;
        p->ticks += (uint64_t)(ready - PACE_MAX_TICKS);
    }
    return f;
}

struct pace_frame pace_take(struct pace *p, uint64_t now)
{
    return p->refresh ? take_locked(p, now) : take_free(p, now);
}

void pace_follow(struct pace *p, uint64_t now)
{
    p->refresh = 0;
    p->base = now;
    p->ticks = 0;
}
