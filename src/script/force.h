/*
 * force.h - triggers events that otherwise occur only in play, so that an automated check reaches the scripts that
 * depend on them.
 */
#ifndef SCRIPT_FORCE_H
#define SCRIPT_FORCE_H

#include <stdbool.h>

struct board;

enum force_kind {
    FORCE_HIT,    /* an existing bullet or enemy hits the player, safe or not; if there is none, the player dies */
    FORCE_DEATH,  /* the player loses a life */
    FORCE_GRAZE,  /* the player grazes an existing bullet */
    FORCE_BOMB,   /* the player starts the ship's bomb; the stock is first raised to the cost of one bomb */
    FORCE_EXTEND, /* the extend event is raised; the number of lives stays the same */
    FORCE_TAKE,   /* the player takes an item of each kind */
    FORCE_SAFE,   /* the player is safe for a minute */
    FORCE_DAMAGE  /* each enemy that can be hurt loses 5000 hp, to the player's credit */
};

struct force {
    enum force_kind kind;
    int player; /* 0 or 1; no effect if that player is not in the game */
};

/* Returns whether that player is in the game, visible or not. */
bool force_player_in_game(const struct board *b, int player);

/* Applies `force` between two frames and calls the handlers of the events that it raises. Returns false on a script
 * fault, which is in board_last_output(b)->fault. The board must not have a fault yet. Afterwards the run can no longer
 * be replayed from pads alone. */
bool force_run(struct board *b, const struct force *force);

#endif
