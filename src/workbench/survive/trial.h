/*
 * trial.h - a board to try things on: it ticks, is saved and restored, and says what became of the ship; and what the
 * bullets did on the way can be written down, frame by frame.
 */
#ifndef WORKBENCH_TRIAL_H
#define WORKBENCH_TRIAL_H

#include "../../board/board.h"
#include "../../machine/collision/danger.h"

/* What could hit the ship in a frame. */
struct forecast_frame {
    size_t first;            /* of `list` */
    uint32_t n;              /* so many */
    bool moves;              /* the ship's buttons move it in this frame */
    bool safe;               /* nothing hits it in this frame */
    uint32_t fired;          /* bullets and lasers that began in it */
    uint64_t print;          /* of the list and of what the ship is, but not of where it is */
    struct danger_ship ship; /* of its way */
    int32_t foe_x;           /* of the nearest enemy above it, or the field's middle; Q15.16 px */
};

/* Of frames from one board frame on: frame[0] is the tick that makes frame `from` + 1. */
struct forecast {
    uint32_t from, frames;
    struct forecast_frame *frame;
    struct danger *list;
    size_t n;
    bool full; /* no memory: it ends early */
};

void forecast_clear(struct forecast *f, uint32_t from);
void forecast_close(struct forecast *f);

/* How a tick left the ship, or the section. */
enum trial_end {
    TRIAL_ON,    /* it flies, or is not in the game yet */
    TRIAL_HIT,   /* it was hit in this tick */
    TRIAL_ENDED, /* the section is over, and it was not hit */
    TRIAL_FAULT  /* of a script: board_last_output has it */
};

struct trial {
    struct board *b;
    void *block; /* malloc'ed; RAM is the aligned part of it */
    size_t size;
    const struct rom *rom;
    const struct board_start *start;
    int who;                 /* the player it is about: 0 or 1 */
    struct danger_ship ship; /* after the last tick in which things moved */
    bool moved;              /* they did in the last tick */
    bool touched;            /* in the last tick something that hits touched the ship, which was not safe */
    bool astray;             /* in one since trial_astray was set to false, a script moved the ship */
    uint32_t starts;         /* how often the section has begun */
    int section;             /* 0: none, '/': a boss's phase, else a stage */
    bool parts;              /* a stage's section is over with its next mark, or when a boss flies in */
    struct forecast *into;   /* what happens is written here; NULL: nowhere */
    uint64_t ticks;          /* in all */
};

/* Takes memory, and powers a board. False and one sentence; close it either way. rom and start outlive it. */
bool trial_open(struct trial *t, const struct rom *rom, const struct board_start *start, char *err, size_t err_size);

/* Powers it anew. */
bool trial_again(struct trial *t, char *err, size_t err_size);
void trial_close(struct trial *t);

enum trial_end trial_tick(struct trial *t, const uint16_t pads[MAX_PLAYERS]);

/* A place to go back to. */
struct trial_mark {
    void *block, *at;
    size_t room;
    uint32_t frame;
    struct danger_ship ship;
    uint32_t starts;
};

/* False: no memory. */
bool trial_save(const struct trial *t, struct trial_mark *m);
void trial_restore(struct trial *t, const struct trial_mark *m);
void trial_mark_free(struct trial_mark *m);

/* What to press while the ship is not steered: fire and start now and then, so that menus are gone through. */
uint16_t trial_press(const struct trial *t);

/* Can the ship be steered now? Between frames. */
bool trial_steers(const struct trial *t);

/* Saves a demo of `frames` frames of pads (player 1) from power-on to that path, with the checksums `prints` (enum
 * demo_checksum_rate). Returns false and one sentence on failure. */
struct cart;
bool trial_record(struct trial *t, const struct cart *cart, const uint16_t *pads, uint32_t frames, const char *path,
                  int prints, char *err, size_t err_size);

#endif
