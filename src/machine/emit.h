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

/* A ring, fan, arc, stack or line of n bullets: the parameters from which emit_compute_bullet computes each bullet. */
struct emit_pattern_params {
    uint8_t pattern; /* enum emit_pattern */
    int32_t n;
    double dir, speed; /* degrees, px/frame */
    double size;       /* see struct motion_emit */
    fx cos30, sin30;   /* cosine and sine of a line's direction (2^30: 1); unused by other patterns */
};

/* Direction (degrees) and speed (px/frame) of one bullet of a pattern and, in a line, its offset from the middle (px).
 * The doubles are bit for bit the same as those computed by scripts/pattern.lua. */
struct emit_bullet {
    double dir, speed, dx, dy;
};

/* Computes bullet i of the pattern, 0 <= i < n. */
void emit_compute_bullet(const struct emit_pattern_params *f, int32_t i, struct emit_bullet *out);

/* Sets the line's cos30 and sin30 from its dir. */
void emit_set_direction(struct emit_pattern_params *f);

/* Counts and logs n more bullets (or shots) refused by a full pool. */
void emit_count_refused(struct board *b, bool is_shot, uint64_t n);

/* Fires a bullet or shot, after setting the shape's hp, pierce and clouded from its kind. Returns the new slot, or
 * NO_SLOT if the pool is full, which is counted and logged. speed_q32: the speed in Q32, used only if spec->is_fine is
 * set; otherwise the speed is spec->speed. clock: the clock of the frame in which the bullet or shot first moves. */
int32_t emit_fire(struct board *b, bool is_shot, struct bullet_spec *shape, int64_t speed_q32, uint32_t clock);

#endif
