/*
 * pace.h - when a frame of the cabinet is due, and how many ticks it has: 60 a second, whatever the screen does.
 *
 * It has no clock: the caller says what time it is, in microseconds, so all of it can be simulated.
 *
 * Free: a frame is due every sixtieth of a second, counted from a base, so that nothing is lost to rounding.
 *
 * Locked: showing a picture returns when the screen has taken it, at a refresh. A frame is then due at the first
 * refresh at which a tick is: at 59.94 Hz one refresh of a thousand has two ticks, at 75 Hz one of five has none and
 * shows no new picture. Refreshes are counted on a clock of their own that goes by the screen's rate and passes over
 * the jitter with which they are heard of; it is set right when it is off by more than that, and its rate with it. So
 * which refresh has how many ticks follows from the two rates alone. A screen that does not wait is waited for here;
 * refreshes that were missed are counted as passed. It is never more than a tick away from the clock on average.
 *
 * A picture that is ready long before the refresh it is for would only show switches that are older. So a frame begins
 * so late that what frames take, and some thousandths of a second, are left; after a refresh that was missed, for some
 * seconds at once.
 */
#ifndef PLAYER_PACE_H
#define PLAYER_PACE_H

#include <stdbool.h>
#include <stdint.h>

enum {
    PACE_SECOND = 1000000, /* usec; a tick in parts of a sixtieth of one */
    PACE_LATE = 4,         /* ticks a frame has at most: what is later than that is lost, and the game slows down */
    PACE_LEAST = 20000,    /* thousandths of a Hz: slower screens, and faster ones, are not locked to */
    PACE_MOST = 1000000
};

struct pace {
    uint64_t base;  /* usec: when tick 0 was due */
    uint64_t ticks; /* handed out since */
    int refresh;    /* of the screen, in thousandths of a Hz; 0: free */
    int64_t step;   /* a refresh, in millionths of a tick, which the rest of these are */
    int64_t at;     /* the refresh last counted, since base */
    int64_t off;    /* by how much they are heard of later than that, smoothed */
    int counted;    /* refreshes since the clock was last set right */
    bool asleep;    /* the next refresh is waited for here, not by the screen */
    uint64_t begin; /* usec: a tick is due, and its frame begins then; 0: none is waited for */
    int64_t spare;  /* usec that the last frame was begun later */
    int64_t work;   /* usec that a frame takes until its picture is handed in: the most, lately */
    int careful;    /* refreshes in which frames are begun at once */
};

/* What a frame stands for. */
struct pace_frame {
    int ticks;     /* 1 to PACE_LATE */
    uint64_t due;  /* usec: never after now */
    uint64_t lost; /* usec that are left out: the game cannot follow */
};

/* Begins, or begins again, now: free, and the first frame is due at once. */
void pace_open(struct pace *p, uint64_t now);

/* The screen's refreshes a thousand seconds, if showing a picture waits for one; 0, and what is out of range: it does
 * not. Does nothing when that is as it was. To be called before each wait: a clock that was set back, so that the next
 * frame would be due long after now, begins again. */
void pace_refresh(struct pace *p, int refresh, uint64_t now);

/* Until when to wait before pace_comes is asked. */
uint64_t pace_due(const struct pace *p);

/* Is a frame due? To be asked once after each wait; true is followed by pace_take. */
bool pace_comes(struct pace *p, uint64_t now);
struct pace_frame pace_take(struct pace *p, uint64_t now);

/* The frame took so long, in usec, from pace_take until its picture was handed in. */
void pace_worked(struct pace *p, uint64_t usec);

/* The frame that has come is on time, whatever its time is: another clock leads. */
void pace_follow(struct pace *p, uint64_t now);

#endif
