/*
 * seats.h - which controller plays for which player.
 *
 * Player 1 has no controller until one is used: any press on one gives it the place. Another takes a free place by
 * START; in a game for one, START hands the place over. One that is unplugged leaves its place, which waits: the same
 * model plugged in again returns there, and until then any other may take it. A switch that is held when its controller
 * comes or takes a place by START counts only once it has been let go.
 *
 * No clock, no port: what happens follows from the calls.
 */
#ifndef PLAYER_SEATS_H
#define PLAYER_SEATS_H

#include <stdbool.h>
#include <stdint.h>
#include "../../../platform/platform.h"
#include "../../base/pads.h"

enum { SEAT_EMPTY = -1, SEATS_EVENTS = 3 * PLAT_MAX_CONTROLLERS /* one may go, another come, and be pressed */ };

enum seats_what {
    SEATS_TAKEN, /* a player has this controller now */
    SEATS_LOST,  /* a player's controller was unplugged */
    SEATS_BACK,  /* and plugged in again */
    SEATS_FULL   /* START was pressed, and no place is free; player: 0 */
};

struct seats_event {
    enum seats_what what;
    int player;                        /* from 0 */
    bool first;                        /* taken by player 1, who had none before */
    bool start;                        /* taken by START */
    struct plat_controller controller; /* as it was, of one that is gone */
};

struct seats {
    struct plat_controller is[PLAT_MAX_CONTROLLERS];
    bool there[PLAT_MAX_CONTROLLERS];
    uint32_t held[PLAT_MAX_CONTROLLERS];     /* at the last poll */
    uint32_t ignored[PLAT_MAX_CONTROLLERS];  /* until they are released */
    uint32_t switches[PLAT_MAX_CONTROLLERS]; /* what this poll hands on: held and not ignored */
    int seat[MAX_PLAYERS];                   /* controller of each player, or SEAT_EMPTY */
    bool waits[MAX_PLAYERS];                 /* an empty one: for the return of was */
    struct plat_controller was[MAX_PLAYERS];
    struct seats_event event[SEATS_EVENTS]; /* of the last poll */
    int events;
};

void seats_open(struct seats *s);

/* A poll: the held buttons, and the description of each controller from plat_get_controller (NULL: not connected).
 * players: number of players of the game. Afterwards s->switches, s->seat and s->event are this poll's. */
void seats_poll(struct seats *s, int players, const uint32_t held[PLAT_MAX_CONTROLLERS],
                const struct plat_controller *const plugged[PLAT_MAX_CONTROLLERS]);

/* The player that a controller plays for; -1: none. */
int seats_player(const struct seats *s, int controller);

/* Gives a controller that is there to a player, who gives up what they had, as does whoever had this; SEAT_EMPTY: only
 * the giving up. What is held on it does not count until it is let go. */
void seats_give(struct seats *s, int player, int controller);

/* The switches of a player's controller; 0: none. */
uint32_t seats_switches(const struct seats *s, int player);

#endif
