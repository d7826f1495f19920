/*
 * hit.h - detects every collision of a frame, in one fixed order. Reads all pools; writes events and counts, and
 * removes the bullets, shots and items that left the field and hit nothing.
 *
 * Order:
 *   1. for each player: bullets by slot (hit or graze), then lasers by slot (hit or graze), then enemies by slot;
 *   2. shots by slot, each with the enemy or hittable bullet that it touches: of several, the one that was nearest
 *      before both moved; ties go to an enemy, then to the lowest slot. A piercing shot hits several, nearest first;
 *   3. players' lasers that touch enemies;
 *   4. live bullets by slot, each with an enemy that blocks it;
 *   5. for each pair of tags: bullets of the first tag by slot, each with the bullet of the second tag that it meets;
 *   6. enemies that left the field, by slot;
 *   7. items by slot, each with the player that takes it.
 *
 * Bullets, shots, enemies and items that this frame's move takes outside the field and its margin are tested like all
 * others.
 */
#ifndef MACHINE_HIT_H
#define MACHINE_HIT_H

#include "../machine.h"

/* An entity in this frame: its shape, its position after the move, and its move. */
struct body {
    uint8_t shape;
    fx a, b;
    fx x, y, mx, my;
    fx c; /* in a piece that is a capsule: (b, c) is the vector from its middle to one end of its segment */
};

/* Splits the body of bullet or enemy i, in its present rotation, into circles, boxes and capsules; returns the number
 * of pieces. The ends of a bullet's capsule are computed by one trig_polar, the position of a rotated circle by the sum
 * of two. */
uint32_t hit_split_bullet(const struct bullets *s, const struct bullet_kinds *k, uint32_t i,
                          struct body piece[SHAPE_MAX_CIRCLES]);
uint32_t hit_split_enemy(const struct board *b, uint32_t i, struct body piece[SHAPE_MAX_CIRCLES]);

/* Stores the queries by which bullets_move, the broad phase, finds the bullets near each player. Call when the players
 * have moved. */
void hit_get_queries(struct board *b, struct bullets_query query[MAX_PLAYERS]);

/* Returns whether any shot of this frame can hit a bullet. If so, the moves must hold bullets that leave the field. */
bool hit_solid_is_possible(const struct board *b);

/* Returns the distance from the laser's line within which laser i hits at this age, or -1 if it hits nothing. */
fx hit_laser_reach(const struct board *b, uint32_t i, uint32_t age);

/* Counts the work of one call of hit_laser_touches_enemy with the same arguments. */
void hit_charge_laser(struct board *b, uint32_t i, uint32_t enemy);

/* Returns whether laser i, in its present state, touches enemy `enemy` in this frame. */
bool hit_laser_touches_enemy(const struct board *b, uint32_t i, uint32_t enemy);

/* Returns the size in bytes of the board's hit_grid, for a pool of `enemies` slots. */
size_t hit_grid_size(size_t enemies);

/* Raises the events of this frame's hits. */
void hit_run(struct board *b);

#endif
