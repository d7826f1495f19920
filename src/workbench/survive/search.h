/*
 * search.h - searches for a run without a hit, and for a proof that there is none.
 */
#ifndef WORKBENCH_SEARCH_H
#define WORKBENCH_SEARCH_H

#include "simulation.h"

enum search_verdict {
    SEARCH_SURVIVED,  /* to the section's end */
    SEARCH_LASTED,    /* to the limit */
    SEARCH_CANNOT,    /* proved unavoidable: the ship is hit whatever buttons are pressed */
    SEARCH_NOT_FOUND, /* within the effort */
    SEARCH_NO_SHIP,   /* no ship could be steered */
    SEARCH_FAULT,     /* a script faulted; board_last_output has the fault */
    SEARCH_NO_MEMORY,
    SEARCH_BOTS /* bots played; there was no search */
};

struct search {
    struct simulation *t;
    uint32_t effort;                                             /* in hundreds of plans */
    uint32_t limit;                                              /* frames from power-on */
    void (*on_progress)(void *user, uint32_t done, uint32_t of); /* or NULL */
    void *user;

    enum search_verdict verdict;
    uint16_t *pads;  /* of the longest run, from power-on; malloc */
    uint32_t frames; /* of that run, up to the hit */
    uint32_t begin;  /* the first frame in which the ship could be steered */
    uint32_t last;   /* SEARCH_CANNOT: the frame by which every ship is hit; otherwise the same as frames */
    uint32_t plans;  /* number of plans so far */
    uint32_t probes; /* runs with other buttons whose bullets were compared */
    bool reacts;     /* the bullets differed between these runs */
    uint32_t reacts_at;
    uint32_t capacity; /* capacity of pads, frames */
};

/* Searches. The caller sets t, which must be at power-on, effort, limit and on_progress. */
void search_run(struct search *s);
void search_close(struct search *s);

/* Goes through menus until the ship can be steered, and stores the buttons in s->pads. False: it never could be
 * steered, and s->verdict has the reason. */
bool search_begin(struct search *s);

#endif
