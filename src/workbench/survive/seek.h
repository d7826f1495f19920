/*
 * seek.h - looks for a run without a hit, and for a proof that there is none.
 */
#ifndef WORKBENCH_SEEK_H
#define WORKBENCH_SEEK_H

#include "trial.h"

enum seek_verdict {
    SEEK_SURVIVED,  /* to the section's end */
    SEEK_LASTED,    /* to the last frame that was asked for */
    SEEK_CANNOT,    /* no buttons bring a ship through */
    SEEK_NOT_FOUND, /* within the effort */
    SEEK_NO_SHIP,   /* there was none to be steered */
    SEEK_FAULT,     /* of a script; board_last_output has it */
    SEEK_NO_MEMORY,
    SEEK_BOTS /* no way was looked for: bots alone flew */
};

struct seek {
    struct trial *t;
    uint32_t effort; /* in hundreds of plans */
    uint32_t limit;  /* frames from power-on */
    void (*tell)(void *user, uint32_t done, uint32_t of);
    void *user; /* tell(user, ...) is called now and then; tell may be NULL */

    enum seek_verdict verdict;
    uint16_t *pads;  /* of the run that came furthest, from power-on; free it with seek_close */
    uint32_t frames; /* of it, in which it is not hit */
    uint32_t begin;  /* the first in which the ship could be steered */
    uint32_t last;   /* cannot: the frame in which no ship is left; else as frames */
    uint32_t plans;  /* that were made */
    uint32_t probes; /* runs by other buttons that bullets were compared in */
    bool reacts;     /* they were not the same in all of these */
    uint32_t reacts_at;
    uint32_t room; /* of pads */
};

/* Looks. t has just been powered. t, effort, limit, tell are set before. */
void seek_run(struct seek *s);
void seek_close(struct seek *s);

/* Presses nothing but fire, and what gets through menus, until the ship can be steered; writes that into s->pads.
 * False: it never could, and s->verdict says why. */
bool seek_begin(struct seek *s);

#endif
