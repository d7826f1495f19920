/*
 * events.h - the events of the current frame, in the order they were detected. Empty between frames. Stored as columns:
 * the list can hold several events per bullet, and an array of structs would waste 7 bytes of padding each.
 */
#ifndef MACHINE_EVENTS_H
#define MACHINE_EVENTS_H

#include <stdint.h>
#include <stdbool.h>

enum event_kind {
    EV_GRAZE, /* a: player, b: bullet or laser handle */
    EV_HIT,   /* a: player, b: handle of the entity that hit the player */
    EV_SHOT,  /* a: shot handle, b: handle of the enemy or bullet that takes the shot's damage */
    EV_DEATH, /* a: player */
    EV_GAME_OVER,
    EV_KILL,     /* a: enemy handle, b: player or 0 */
    EV_LEAVE,    /* a: enemy handle */
    EV_EXTEND,   /* a: player */
    EV_TAKE,     /* a: player, b: item handle */
    EV_BOMB,     /* a: player, b: 1 if the bomb saves the player from a hit */
    EV_CONTINUE, /* a: player */
    EV_SCRIPT,   /* a: index of the event that sys.emit queued */
    EV_BLOCK,    /* a: handle of the bullet, which is removed, b: handle of the enemy that blocks it */
    EV_LASER,    /* a: handle of a player's laser that touches an enemy */
    EV_FIRED,    /* a: bullet handle, b: root of the BulletML document that fired it << 32 | label + 1 */
    EV_MEET      /* last: see events_meeting. a, b: handles of the bullets with the pair's first and second tag */
};

struct event {
    int64_t a, b;
    uint32_t kind; /* enum event_kind */
    uint32_t pair; /* index of the tag pair, for EV_MEET; otherwise 0 */
};

struct events {
    uint32_t cap, n;
    int64_t *a, *b;
    uint8_t *kind;
};

/* Returns the bytes of RAM that cap events take. */
uint64_t events_size(uint32_t cap);

/* Initialises an empty list of capacity cap in the events_size(cap) bytes at `memory`, aligned for int64_t. */
void events_init(struct events *e, uint32_t cap, uint8_t *memory);

static inline struct event events_at(const struct events *e, uint32_t i)
{
    const uint32_t kind = e->kind[i], pair = kind > EV_MEET ? kind - EV_MEET : 0;

    return (struct event){ e->a[i], e->b[i], kind - pair, pair };
}

/* Returns the kind of the meetings of a pair of tags. */
static inline enum event_kind events_meeting(uint32_t pair)
{
    return (enum event_kind)(EV_MEET + pair);
}

/* Appends an event. Returns false if the list is full, which ends the run: the capacity covers every event that a frame
 * can raise on its own, so only scripts can overfill the list. */
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
