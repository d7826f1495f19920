/*
 * events.h - what happened this frame, in the order it was found. Empty between frames. Kept as columns, for there is
 * room for several a bullet, and a struct would be 7 bytes of padding larger.
 */
#ifndef MACHINE_EVENTS_H
#define MACHINE_EVENTS_H

#include <stdint.h>
#include <stdbool.h>

enum event_kind {
    EV_GRAZE, /* a: player, b: bullet or laser handle */
    EV_HIT,   /* a: player, b: handle of what hit it */
    EV_SHOT,  /* a: shot handle, b: handle of the enemy or bullet that takes the shot's damage */
    EV_DEATH, /* a: player */
    EV_GAME_OVER,
    EV_KILL,     /* a: enemy handle, b: player or 0 */
    EV_LEAVE,    /* a: enemy handle */
    EV_EXTEND,   /* a: player */
    EV_TAKE,     /* a: player, b: item handle */
    EV_BOMB,     /* a: player, b: 1 if the bomb saves it from a hit */
    EV_CONTINUE, /* a: player */
    EV_SCRIPT,   /* a: index of what sys.emit queued */
    EV_BLOCK,    /* a: bullet handle, b: enemy handle: the bullet goes */
    EV_LASER,    /* a: handle of a player's laser that touches enemies */
    EV_FIRED,    /* a: bullet handle, b: root of the document that fired it << 32 | label + 1 */
    EV_MEET      /* the last: EV_MEET + n of pair n. a, b: bullet handles, of the pair's first and second tag */
};

struct event {
    int64_t a, b;
    uint32_t kind; /* enum event_kind */
    uint32_t pair; /* of EV_MEET; else 0 */
};

struct events {
    uint32_t cap, n;
    int64_t *a, *b;
    uint8_t *kind;
};

/* Bytes of RAM that so many take. */
uint64_t events_size(uint32_t cap);

/* Points the columns into memory of events_size(cap) bytes, aligned as an int64_t, and empties them. */
void events_layout(struct events *e, uint32_t cap, uint8_t *at);

static inline struct event events_at(const struct events *e, uint32_t i)
{
    const uint32_t kind = e->kind[i], pair = kind > EV_MEET ? kind - EV_MEET : 0;

    return (struct event){ e->a[i], e->b[i], kind - pair, pair };
}

/* False: no room, which ends the run (the capacity holds all that one frame can raise by itself). */
static inline bool events_push(struct events *e, enum event_kind kind, int64_t a, int64_t b)
{
    if (e->n == e->cap)
        return false;
    e->a[e->n] = a;
    e->b[e->n] = b;
    e->kind[e->n++] = (uint8_t)kind;
    return true;
}

#endif
