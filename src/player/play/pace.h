/*
 * pace.h - when a frame is due, and how many ticks it has: 60 a second on every screen.
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
    PACE_SECOND = 1000000, /* usec; a tick in parts of a sixtieth of one */
    PACE_LATE = 4,         /* ticks a frame has at most; the rest is lost, and the game slows down */
    PACE_LEAST = 20000,    /* thousandths of a Hz: the pace is not locked to slower or faster screens */
    PACE_MOST = 1000000
};

struct pace {
    uint64_t base;  /* usec: when tick 0 was due */
    uint64_t ticks; /* taken since then */
    int refresh;    /* of the screen, in thousandths of a Hz; 0: free */
    int64_t step;   /* a refresh, in millionths of a tick, as are at and off */
    int64_t at;     /* the last counted refresh, since base */
    int64_t off;    /* the mean delay between a refresh and the call that reports it */
    int counted;    /* refreshes since the clock was last corrected */
    bool asleep;    /* this code waits for the next refresh, not the screen */
    uint64_t begin; /* usec: the time at which the frame of a due tick starts; 0: no tick is due */
    int64_t spare;  /* usec by which the start of the last frame was delayed */
    int64_t work;   /* usec from a frame's start to its picture: the recent maximum */
    int careful;    /* refreshes in which frames start at once */
};

struct pace_frame {
    int ticks;     /* 1 to PACE_LATE */
    uint64_t due;  /* usec: never after now */
    uint64_t lost; /* usec that are skipped, because the game is too slow */
};

/* Starts, or restarts, now: free, and the first frame is due at once. */
void pace_open(struct pace *p, uint64_t now);

/* The screen's refreshes in a thousand seconds, if showing a picture waits for one; 0, or out of range: it doesn't.
 * Does nothing if the rate hasn't changed. Call it before each wait: it restarts the pace if the host's clock was set
 * back, which would delay the next frame. */
void pace_refresh(struct pace *p, int refresh, uint64_t now);

/* Wait until this time before calling pace_frame_due. */
uint64_t pace_due(const struct pace *p);

/* Is a frame due? Call it once after each wait, and then pace_take if it returns true. */
bool pace_frame_due(struct pace *p, uint64_t now);
struct pace_frame pace_take(struct pace *p, uint64_t now);

/* The time from pace_take to the picture, in usec. */
void pace_worked(struct pace *p, uint64_t usec);

/* The present frame is on time: another clock sets the pace. */
void pace_follow(struct pace *p, uint64_t now);

#endif
