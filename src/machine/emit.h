/*
 * emit.h - what motion programs fire (the step `emit`).
 *
 * A program that comes to an emit queues it, with the place and direction of its bullet at that moment. When all have
 * moved and hits were found, the queue is fired in its order: shots' emits, then bullets', each in slot order, so the
 * order in which slots are taken is nowhere seen. What is fired moves in the next frame, as if a task had fired it at
 * the start of that. Between frames the queue is empty.
 *
 * There is an end to it: an emit fires one bullet or more, so of those that a frame brings, no more than the pool has
 * slots can matter, and of the others only their bullets are counted, as refused. The queue stands in Lua's heap, where
 * it grows to that size as it is needed; a game whose programs fire nothing has none.
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
    uint32_t step; /* the emit in the list of steps */
    uint32_t by;
    uint16_t player, shot; /* shot: 1: a shot fires it */
    fx value[MAX_VALUES];  /* of what fires it */
};
_Static_assert(sizeof(struct emission) == 48, "snapshots of Lua's heap copy this struct, so it must not have padding");

struct emissions {
    struct emission *list; /* NULL: nothing was queued in this frame */
    uint32_t n, room;
    uint32_t of[2];   /* those of them that fire bullets, and shots */
    uint64_t over[2]; /* bullets, and shots, of emits that found no room */
};

/* Empties the queue. */
void emit_none(struct board *b);

/* struct motion_world's emit; its context is the board. Raises Lua's error when there is no memory. */
void emit_queue(const struct motion_world *w, const struct bullets *s, uint32_t i, uint32_t st);

/* Fires what was queued, which counts as work. For vm_call. */
void emit_run(struct board *b);

/* A pattern of n, as numbers: the bullets of ring, fan, arc, stack and line differ in these alone. */
struct emit_figure {
    uint8_t pattern; /* enum emit_pattern */
    int32_t n;
    double dir, speed; /* degrees, px/frame */
    double size;       /* as of struct motion_emit */
    fx cos30, sin30;   /* of a line: of its direction */
};

/* Degrees and px/frame of bullet i, 0 <= i < n, and how far a line's is from the middle: the doubles that
 * scripts/pattern.lua computes, bit for bit. */
struct emit_way {
    double dir, speed, dx, dy;
};
void emit_way(const struct emit_figure *f, int32_t i, struct emit_way *out);

/* Sets a line's cos30 and sin30, from its dir. */
void emit_turn(struct emit_figure *f);

/* Counts and logs n bullets (or shots) more that a full pool refused. */
void emit_refuse(struct board *b, bool shot, uint64_t n);

/* Fires a bullet or shot: sets the shape's hp and cloud, and counts and logs it when there is no room (NO_SLOT). pace:
 * its speed in Q32, of which only fine ones have more than shape->speed. clock: of the frame in which it first moves.
 */
int32_t emit_fire(struct board *b, bool shot, struct bullet_shape *shape, int64_t pace, uint32_t clock);

#endif
