/*
 * simulation.h - a board that can be saved and restored, and that reports after each tick whether the ship was hit. It
 * can record everything that could hit the ship, frame by frame: a forecast.
 */
#ifndef WORKBENCH_SIMULATION_H
#define WORKBENCH_SIMULATION_H

#include "../../board/board.h"
#include "../../machine/collision/danger.h"

/* The shapes that could hit the ship in a frame. */
struct forecast_frame {
    size_t first;      /* index in `list` */
    uint32_t n;        /* shapes */
    bool moves;        /* the buttons move the ship in this frame */
    bool safe;         /* nothing hits the ship in this frame */
    uint32_t fired;    /* bullets and lasers that spawned in this frame */
    uint64_t checksum; /* of the shapes and of the ship's properties, without its position */
    struct danger_ship ship;
    int32_t enemy_x; /* of the nearest enemy above the ship, or the field's middle; Q15.16 px */
};

/* Consecutive frames: frame[0] is the tick after board frame `from`. */
struct forecast {
    uint32_t from, frames;
    struct forecast_frame *frame;
    struct danger *list;
    size_t n;
    bool full; /* out of memory: it ends early */
};

void forecast_clear(struct forecast *f, uint32_t from);
void forecast_close(struct forecast *f);

/* The result of a tick. */
enum simulation_end {
    SIMULATION_RUNNING, /* the section continues */
    SIMULATION_HIT,     /* the ship was hit in this tick */
    SIMULATION_ENDED,   /* the section is over, and the ship was not hit in this tick */
    SIMULATION_FAULT    /* a script faulted; board_last_output has the fault */
};

struct simulation {
    struct board *b;
    void *block; /* malloc; RAM is its aligned part */
    size_t size;
    const struct rom *rom;
    const struct board_start *start;
    int player;                 /* the player whose ship it is: 0 or 1 */
    struct danger_ship ship;    /* after the last tick in which entities moved */
    bool moved;                 /* entities moved in the last tick */
    bool touched;               /* in the last tick, something touched the ship, which was not safe */
    bool ship_was_moved;        /* a script has moved the ship; the caller resets it */
    uint32_t starts;            /* how often the section has started */
    int section;                /* 0: none; '/': a boss's phase; otherwise a stage */
    bool stop_at_marks;         /* a stage's section ends at its next mark, or when a boss enters */
    struct forecast *recording; /* receives the frames; NULL: not recorded */
    uint64_t ticks;             /* since simulation_open */
};

/* Allocates a board and powers it on. Close it in either case. rom and start must outlive it. */
bool simulation_open(struct simulation *t, const struct rom *rom, const struct board_start *start, char *err,
                     size_t err_size);

/* Powers the board on again. */
bool simulation_restart(struct simulation *t, char *err, size_t err_size);
void simulation_close(struct simulation *t);

enum simulation_end simulation_tick(struct simulation *t, const uint16_t pads[MAX_PLAYERS]);

/* A saved state. */
struct simulation_state {
    void *block, *snapshot;
    size_t capacity;
    uint32_t frame;
    struct danger_ship ship;
    uint32_t starts;
};

/* False: out of memory. */
bool simulation_save(const struct simulation *t, struct simulation_state *m);
void simulation_restore(struct simulation *t, const struct simulation_state *m);
void simulation_state_free(struct simulation_state *m);

/* Returns the buttons for a tick in which the ship cannot be steered: fire and start from time to time, for menus. */
uint16_t simulation_menu_pads(const struct simulation *t);

/* Returns whether the ship can be steered in the next tick. */
bool simulation_can_steer(const struct simulation *t);

/* Saves a demo of `frames` frames of pads (player 1) from power-on. prints: enum demo_checksum_rate. */
struct cart;
bool simulation_record(struct simulation *t, const struct cart *cart, const uint16_t *pads, uint32_t frames,
                       const char *path, int prints, char *err, size_t err_size);

#endif
