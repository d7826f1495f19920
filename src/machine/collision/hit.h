/*
 * hit.h - every collision of a frame, in one fixed order. Reads everything; writes events and counts,
 * and takes the shots and items away that left and hit nothing.
 *
 * Order: for each player, bullets by slot (a hit, else a graze), then lasers by slot (the same), then enemies by slot;
 * then the shots by slot, each with the enemy it touches, or the bullet that shots can hit: of several, the one that
 * was nearest to it before they moved, and of those an enemy, then the lowest slot; one that pierces with several, in
 * that order; then the players' lasers that
 * touch enemies; then the live bullets by slot, each with the enemy that blocks it, if any does; then by pair of tags
 * the bullets of the first tag by slot, each with the one of the second tag that it meets; then the enemies that left
 * the field, by slot; then the items by slot, each with the player that takes it. Bullets, shots, enemies and items
 * that end this frame's move outside of the field and its margin are tested as all others.
 */
#ifndef MACHINE_HIT_H
#define MACHINE_HIT_H

#include "../machine.h"

/* A thing this frame: its shape, where it is now, and its move of the frame. */
struct body {
    uint8_t shape;
    fx a, b;
    fx x, y, mx, my;
    fx c; /* a capsule that is a piece: (b, c) leads from its middle to one end of its bar */
};

/* Takes a body apart into circles, boxes and capsules, as the thing is turned now; returns how many. The bar of a
 * bullet's capsule goes to the points that trig_polar gives; each circle's place is turned by two of its vectors. */
uint32_t hit_bullet_pieces(const struct bullets *s, const struct bullet_kinds *k, uint32_t i,
                           struct body piece[SHAPE_PARTS]);
uint32_t hit_enemy_pieces(const struct board *b, uint32_t i, struct body piece[SHAPE_PARTS]);

/* The broad phase that bullets_move does: the bullets near each player. The players have moved already. */
void hit_queries(struct board *b, struct bullets_query query[PADS]);

/* Can a shot of this frame hit a bullet? Then what leaves the field must be held by the moves. */
bool hit_solid_possible(const struct board *b);

/* How far from its line laser i hits at that age; below 0: it hits nothing. */
fx hit_laser_reach(const struct board *b, uint32_t i, uint32_t age);

/* Counts the work that asking hit_laser_enemy is. */
void hit_laser_work(struct board *b, uint32_t i, uint32_t foe);

/* Does laser i, as it is now, touch that enemy in this frame? */
bool hit_laser_enemy(const struct board *b, uint32_t i, uint32_t foe);

/* Raises the events of this frame's hits. */
void hit_run(struct board *b);

#endif
