/*
 * simulate.h - a screen and a host that are not there: what pace.h makes of them, counted.
 */
#ifndef PACING_SIMULATE_H
#define PACING_SIMULATE_H

#include <stdbool.h>
#include <stdint.h>

struct simulate {
    double hz;   /* of the screen */
    double told; /* what the host says it has; 0: nothing, so there is no waiting for it */
    bool waits;  /* showing a picture returns at a refresh; else at once */
    int seconds;
    int work[2];   /* usec that a frame takes, least and most */
    int late;      /* usec that the host is late at most, after each wait */
    int stalls;    /* one frame of so many takes 25 ms; 0: none */
    uint64_t seed; /* of all that is random here */
};

struct simulated {
    int64_t refreshes, ticks;
    int64_t with[4]; /* refreshes that show so many new ticks; 3: or more */
    int64_t least;   /* refreshes with none or with more than one that the two rates ask for */
    double off;      /* ticks, from the clock: the most */
    double mean;     /* usec from a frame's tick to the refresh that shows it */
    double most;     /* and the longest */
};

struct simulated simulate(const struct simulate *s);

/* Refreshes with none or more than one beyond those that the rates ask for. */
int64_t simulated_uneven(const struct simulated *s);

#endif
