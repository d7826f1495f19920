/*
 * emit.h - bullets and shots fired by motion programs (the step `emit`).
 *
 * When a motion program reaches an emit step, the step is queued with the present position and direction of the bullet.
 * After motion and hit detection, the queue is fired in order: emits queued by shots, in slot order, then emits queued
 * by bullets, in slot order. Firing after all moves means that the allocation order of slots has no effect. New bullets
 * first move in the next frame, as if a task had fired them at the start of that frame. Between frames the queue is
 * empty.
 *
 * The queue is bounded: every emit fires at least one bullet, so a frame cannot use more emits than the pool has slots.
 * Further emits fire nothing; their bullets are counted as refused. The queue is allocated in Lua's heap and grows up
 * to that size on demand; a game whose programs fire nothing has no queue.
 */
#ifndef MACHINE_EMIT_H
#define MACHINE_EMIT_H

#include <stdbool.h>
#include <stdint.h>
#include "../entities/bullets.h"

struct board;

struct emission {
    int64_t x, y; /* Q32 */
    ang dir;
    uint32_t step;       /* index of the emit step in the list of steps */
    uint32_t owner_task; /* owner_task of the bullet or shot that emits */
    uint16_t player,
        is_shot;          /* player: of the bullet or shot that emits; is_shot: 1 if a shot emits, 0 if a bullet does */
    fx value[MAX_VALUES]; /* values of the bullet or shot that emits */
};
_Static_assert(sizeof(struct emission) == 48, "snapshots of Lua's heap copy this struct, so it must not have padding");

struct emissions {
    struct emission *list;     /* NULL: nothing has been queued in this frame */
    uint32_t n, cap;           /* number of emissions in the list; capacity of the list */
    uint32_t queued_count[2];  /* number of queued emits that fire bullets ([0]) and shots ([1]) */
    uint64_t dropped_count[2]; /* number of bullets ([0]) and shots ([1]) in emits that did not fit in the queue */
};

/* Empties the queue. */
void emit_clear(struct board *b);

/* Queues emit step `step`, which bullet or shot i has reached. This is the `emit` callback of struct motion_world,
 * whose context is the board. Raises a Lua error when out of memory. */
void emit_queue(const struct motion_world *w, const struct bullets *s, uint32_t i, uint32_t step);

/* Fires the queued emits, counts the work, and empties the queue. Call only inside vm_call. */
void emit_run(struct board *b);

/* The bullets that one emit or one call of a pattern fires: what they share, and how they differ. */
struct volley {
    uint8_t pattern; /* enum emit_pattern */
    bool fires_shots;
    bool is_aimed;                 /* dir is relative to the direction from (aim_x, aim_y) to the nearest target */
    int32_t n;                     /* bullets, counting the skipped ones */
    int64_t skip_first, skip_last; /* first and last skipped bullet, counted from 1; none if first > last */
    double dir, speed;             /* degrees, px/frame */
    double size;                   /* see struct motion_emit */
    fx x, y;                       /* where the bullets start */
    double dx, dy;                 /* line: added to each bullet's offset before it is rounded, px */
    fx aim_x, aim_y;
    ang aim_dir;        /* set by emit_aim_volley: added to each bullet's dir */
    fx cos30, sin30;    /* line, set by emit_aim_volley: cosine and sine of dir (2^30: 1) */
    uint8_t has_values; /* bit k: the bullets get value[k] */
    fx value[MAX_VALUES];
    struct bullet_spec spec; /* the rest, the same for all bullets */
};

/* Direction (degrees) and speed (px/frame) of one bullet of a volley and, in a line, its offset from the middle (px).
 * The doubles are bit for bit the same as those computed by scripts/pattern.lua. */
struct volley_bullet {
    double dir, speed, dx, dy;
};

/* Finds the direction of an aimed volley. Call it before any of the following functions. A line is aimed as a whole, so
 * that its bullets fly in parallel. */
void emit_aim_volley(const struct board *b, struct volley *v);

/* Computes bullet i of the volley, 0 <= i < n. */
void emit_compute_bullet(const struct volley *v, int32_t i, struct volley_bullet *out);

/* Returns how many bullets the volley fires from bullet i on, 0 <= i < n, not counting the skipped ones. */
uint32_t emit_count_left(const struct volley *v, int32_t i);

/* Fires the volley's bullets in order. Those that a full pool refuses are counted and logged. Returns the number of
 * bullets fired. clock: as in emit_fire. */
uint32_t emit_fire_volley(struct board *b, struct volley *v, uint32_t clock);

/* Returns the work of finding the target of a bullet or shot. */
uint32_t emit_aim_work(const struct board *b, bool is_shot);

/* Counts and logs n more bullets (or shots) refused by a full pool. */
void emit_count_refused(struct board *b, bool is_shot, uint64_t n);

/* Fires a bullet or shot, after setting hp, pierce_hits and is_clouded of *spec from its kind. Returns the new slot, or
 * NO_SLOT if the pool is full, which is counted and logged. speed_q32: the speed in Q32, used only if spec->is_fine is
 * set; otherwise the speed is spec->speed. clock: the clock of the frame in which the bullet or shot first moves. */
int32_t emit_fire(struct board *b, bool is_shot, struct bullet_spec *spec, int64_t speed_q32, uint32_t clock);

#endif
