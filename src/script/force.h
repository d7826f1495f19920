/*
 * force.h - makes happen what only play brings about, so that a check reaches the scripts that wait for it.
 */
#ifndef SCRIPT_FORCE_H
#define SCRIPT_FORCE_H

#include <stdbool.h>

struct board;

enum force_kind {
    FORCE_HIT,    /* a bullet or an enemy that is there hits the player, safe or not; without one it dies */
    FORCE_DEATH,  /* the player loses a life */
    FORCE_GRAZE,  /* a bullet that is there is grazed */
    FORCE_BOMB,   /* the ship's bomb, paid from a stock that is filled up first */
    FORCE_EXTEND, /* an extra life */
    FORCE_TAKE,   /* an item of each kind is taken */
    FORCE_SAFE,   /* the player is safe for a minute */
    FORCE_DAMAGE  /* each enemy that can be hurt loses 5000 hp, to the player's credit */
};

struct force {
    enum force_kind kind;
    int player; /* 0 or 1; one that is not in the game changes nothing */
};

/* Is that player in the game, seen or not? */
bool force_in_game(const struct board *b, int player);

/* Does that between two frames, handlers included. False: a script fault, which is in board_last(b)->fault. The board
 * must not have a fault; its past cannot be replayed from pads alone any more. */
bool force_run(struct board *b, const struct force *force);

#endif
