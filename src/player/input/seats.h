/*
 * seats.h - assigns controllers to players.
 *
 * Player 1 gets the first controller on which a button is pressed. Another controller gets a free place with START; in
 * a one-player game, START hands the place over. If a controller is unplugged, its place waits: the same model returns
 * there when it is plugged in again, and until then any other controller can take the place. A button that is held when
 * its controller is connected, or takes a place with START, counts only after it is released.
 *
 * Nothing here depends on a clock or a port.
 */
#ifndef PLAYER_SEATS_H
#define PLAYER_SEATS_H

#include <stdbool.h>
#include <stdint.h>
#include "../../../platform/platform.h"
#include "../../base/pads.h"

enum {
    SEAT_EMPTY = -1,
    SEATS_EVENTS = 3 * PLAT_MAX_CONTROLLERS /* one may be unplugged, another connected and pressed */
};

enum seats_what {
    SEATS_TAKEN, /* a player got this controller */
    SEATS_LOST,  /* a player's controller was unplugged */
    SEATS_BACK,  /* it was plugged in again */
    SEATS_FULL   /* START was pressed, but no place is free; player: 0 */
};

struct seats_event {
    enum seats_what what;
    int player;                        /* from 0 */
    bool first;                        /* player 1 got it and had none before */
    bool start;                        /* taken with START */
    struct plat_controller controller; /* for SEATS_LOST, its former description */
};

struct seats {
    struct plat_controller is[PLAT_MAX_CONTROLLERS];
    bool there[PLAT_MAX_CONTROLLERS];
    uint32_t held[PLAT_MAX_CONTROLLERS];     /* at the last poll */
    uint32_t ignored[PLAT_MAX_CONTROLLERS];  /* held buttons that don't count until they are released */
    uint32_t switches[PLAT_MAX_CONTROLLERS]; /* result of this poll: held and not ignored */
    int seat[MAX_PLAYERS];                   /* controller of each player, or SEAT_EMPTY */
    bool waits[MAX_PLAYERS];                 /* the place waits for `was` to return */
    struct plat_controller was[MAX_PLAYERS];
    struct seats_event event[SEATS_EVENTS]; /* of the last poll */
    int events;
};

void seats_open(struct seats *s);

/* A poll: the held buttons, and the description of each controller from plat_get_controller (NULL: not connected).
 * players: number of players of the game. Afterwards s->switches, s->seat and s->event are this poll's. */
void seats_poll(struct seats *s, int players, const uint32_t held[PLAT_MAX_CONTROLLERS],
                const struct plat_controller *const plugged[PLAT_MAX_CONTROLLERS]);

/* Returns the player of a controller, or -1. */
int seats_player(const struct seats *s, int controller);

/* Gives a connected controller to a player and takes it from its previous player; SEAT_EMPTY only takes the player's
 * controller away. Buttons held on it don't count until they are released. */
void seats_give(struct seats *s, int player, int controller);

/* Returns the buttons of a player's controller; 0 if the player has none. */
uint32_t seats_switches(const struct seats *s, int player);

#endif
