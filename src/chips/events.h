/*
 * events.h - what happened this frame, in the order it was found. Empty between frames.
 * floor: chips
 */
#ifndef CHIPS_EVENTS_H
#define CHIPS_EVENTS_H

#include <stdint.h>
#include <stdbool.h>

enum event_kind {
    EV_GRAZE, /* a: player, b: bullet handle */
    EV_HIT,   /* a: player, b: handle of what hit it */
    EV_SHOT,  /* a: shot handle, b: handle of the enemy or bullet that takes the shot's damage */
    EV_DEATH, /* a: player */
    EV_GAME_OVER,
    EV_KILL,   /* a: enemy handle, b: player or 0 */
    EV_LEAVE,  /* a: enemy handle */
    EV_EXTEND, /* a: player */
    EV_SCRIPT, /* a: index of what sys.emit queued */
    EV_BLOCK,  /* a: bullet handle, b: enemy handle: the bullet goes */
    EV_LASER   /* a: handle of a player's laser that touches enemies */
};

struct event {
    int64_t a, b;
    uint32_t kind; /* enum event_kind */
};

struct events {
    uint32_t cap, n;
    struct event *list;
};

/* False: no room, which ends the run (the capacity holds all that one frame can raise by itself). */
bool events_push(struct events *e, enum event_kind kind, int64_t a, int64_t b);

#endif
