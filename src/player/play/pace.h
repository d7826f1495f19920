/*
 * pace.h - decides when a frame is due and how many ticks it has: 60 ticks a second on every screen.
 *
 * The caller passes the time, in microseconds, so a test can simulate it.
 *
 * Free: a frame is due every sixtieth of a second, counted from a base, so that rounding errors don't add up.
 *
 * Locked: showing a picture returns at a refresh of the screen. A frame is due at the first refresh at which a tick is
 * due: at 59.94 Hz one refresh in a thousand has two ticks, at 75 Hz one in five has none and shows no new picture.
 * Refreshes are counted on a separate clock, which runs at the screen's rate and ignores the jitter of the calls. If
 * the error is larger than the jitter, the clock and its rate are corrected. The number of ticks of a refresh therefore
 * depends only on the two rates. If the screen doesn't wait, this code does; missed refreshes are counted. On average,
 * the game is never more than a tick away from the clock.
 *
 * A picture that is ready long before its refresh would only show older input. So a frame starts as late as the work of
 * recent frames and a margin allow; for some seconds after a missed refresh, it starts at once.
 */
#ifndef PLAYER_PACE_H
#define PLAYER_PACE_H

#include <stdbool.h>
#include <stdint.h>

enum {
    PACE_SECOND = 1000000,    /* usec */
    PACE_MAX_TICKS = 4,       /* per frame; the rest is lost, and the game slows down */
    PACE_MIN_REFRESH = 20000, /* thousandths of a Hz: the pace is not locked to slower or faster screens */
    PACE_MAX_REFRESH = 1000000
};

struct pace {
    uint64_t base;    /* usec: when tick 0 was due */
    uint64_t ticks;   /* taken since then */
    int refresh;      /* rate of the screen, in thousandths of a Hz; 0: free */
    int64_t step;     /* time between refreshes, in millionths of a tick; at and off have the same unit */
    int64_t at;       /* time of the last counted refresh, since base */
    int64_t off;      /* mean delay between a refresh and the call that reports it */
    int counted;      /* refreshes since the clock was last corrected */
    bool asleep;      /* this code waits for the next refresh, not the screen */
    uint64_t begin;   /* usec: when the frame of a due tick starts; 0: no tick is due */
    int64_t delay;    /* usec by which the start of the last frame was delayed */
    int64_t work;     /* usec from a frame's start to its picture: the recent maximum */
    int careful_left; /* refreshes in which frames start at once */
};

struct pace_frame {
    int ticks;     /* 1 to PACE_MAX_TICKS */
    uint64_t due;  /* usec, not after now */
    uint64_t lost; /* usec that are skipped, because the game is too slow */
};

/* Starts or restarts in free mode, with the first frame due at once. */
void pace_open(struct pace *p, uint64_t now);

/* Sets the screen's refresh rate in thousandths of a Hz, if showing a picture waits for a refresh; otherwise 0. Rates
 * out of range count as 0. Does nothing if the rate hasn't changed. Call it before each wait: it restarts the pace if
 * the host's clock was set back, which would delay the next frame. */
void pace_refresh(struct pace *p, int refresh, uint64_t now);

/* Returns the time to wait for before calling pace_frame_due. */
uint64_t pace_due(const struct pace *p);

/* Returns whether a frame is due. Call it once after each wait; if it returns true, call pace_take. */
bool pace_frame_due(struct pace *p, uint64_t now);
struct pace_frame pace_take(struct pace *p, uint64_t now);

/* Reports the time from pace_take to the picture, in usec. */
void pace_worked(struct pace *p, uint64_t usec);

/* Counts a frame as on time now, when another clock sets the pace. */
void pace_follow(struct pace *p, uint64_t now);

#endif
