/*
 * engine.h - the engine's own code, as the lab's rows of the engine run it: a board whose chips are laid out as on any
 * board, without ROM and scripts.
 */
#ifndef LAB_ENGINE_H
#define LAB_ENGINE_H

#include "../../../src/machine/collision/hit.h"
#include "../../../src/machine/machine.h"

/* A pixel in fx. */
#define PX(n) ((fx)((n)*65536))

/* Nothing that is an fx lies outside. */
extern const struct box ENGINE_EVERYWHERE;

/* Room for so many bullets, shots and enemies; everything empty. Ends the program when memory is short. */
struct board *engine_power(uint32_t bullets, uint32_t shots, uint32_t enemies);
void engine_free(struct board *b);

/* A kind of bullet that is a circle; kinds of shots and enemies that are boxes. Returns the kind. */
uint16_t engine_circle(struct bullet_kinds *k, fx radius, bool swept);
uint16_t engine_box(struct bullet_kinds *k, fx half_w, fx half_h, bool swept);
uint16_t engine_enemy(struct board *b, fx half_w, fx half_h);

/* What an entry of the Lua API takes an argument for when it is not given, as Lua spells it; "" if there is no such. */
const char *engine_default(const char *entry, const char *argument);

/* A motion program of these steps: its number for bullet_spec. */
uint16_t engine_motion(struct board *b, const struct motion_step *steps, uint32_t n, bool fine);

/* A bullet with the given velocity in a new slot; returns the slot. */
uint32_t engine_bullet(struct bullets *s, uint16_t kind, fx x, fx y, fx vx, fx vy);

/* Player 1 is in, with that hit circle and no graze, at (x, y), having moved there by (mx, my) this frame. */
void engine_player(struct board *b, fx radius, fx x, fx y, fx mx, fx my);

/* One frame of all bullets; those outside keep are dropped. */
void engine_move(struct board *b, const struct box *keep);

/* One frame of a board: everything moves, hits are found, then what left keep is gone. Returns how many events there
 * are: b->events has them. */
uint32_t engine_board_frame(struct board *b, const struct box *keep);

/* The frame's collisions; returns how many hits (bullets, and shots on enemies) there are: b->events has them. */
uint32_t engine_hits(struct board *b);

#endif
