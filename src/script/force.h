/*
 * force.h - triggers events that otherwise only play causes, so that a check reaches the scripts that wait for them.
 */
#ifndef SCRIPT_FORCE_H
#define SCRIPT_FORCE_H

#include <stdbool.h>

struct board;

enum force_kind {
    FORCE_HIT,    /* an existing bullet or enemy hits the player, safe or not; if there is none, the player dies */
    FORCE_DEATH,  /* the player loses a life */
    FORCE_GRAZE,  /* the player grazes an existing bullet */
    FORCE_BOMB,   /* the ship's bomb; its stock is filled first */
    FORCE_EXTEND, /* an extra life */
    FORCE_TAKE,   /* the player takes an item of each kind */
    FORCE_SAFE,   /* the player is safe for a minute */
    FORCE_DAMAGE  /* each enemy that can be hurt loses 5000 hp, to the player's credit */
};

struct force {
    enum force_kind kind;
    int player; /* 0 or 1; no effect if that player is not in the game */
};

/* Returns whether that player is in the game, visible or not. */
bool force_in_game(const struct board *b, int player);

/* Applies `force` between two frames, handlers included. Returns false on a script fault, which is in
 * board_last(b)->fault. The board must not have a fault yet. Afterwards the run can no longer be replayed from pads
 * alone. */
bool force_run(struct board *b, const struct force *force);

#endif
