/*
 * controllers.h - assigns controllers to players.
 *
 * Player 1 gets the first controller on which a button is pressed. START on another controller assigns it to a player
 * who has none; in a one-player game, START switches to that controller. If a controller is unplugged, the player's
 * assignment is reserved for the same model, which is assigned again when it is plugged in; until then, any other
 * controller can be assigned. A button that is held when its controller is connected, or that assigned it, counts only
 * after it is released.
 *
 * Nothing here depends on a clock or a port.
 */
#ifndef PLAYER_CONTROLLERS_H
#define PLAYER_CONTROLLERS_H

#include <stdbool.h>
#include <stdint.h>
#include "../../../platform/platform.h"
#include "../../base/pads.h"

enum {
    CONTROLLERS_NONE = -1,                            /* instead of a controller's number */
    CONTROLLERS_MAX_EVENTS = 3 * PLAT_MAX_CONTROLLERS /* one may be unplugged, another connected and pressed */
};

enum controllers_event_kind {
    CONTROLLERS_ASSIGNED,    /* a player got this controller */
    CONTROLLERS_UNPLUGGED,   /* a player's controller was unplugged */
    CONTROLLERS_RECONNECTED, /* it was plugged in again */
    CONTROLLERS_REFUSED      /* START was pressed, but every player has a controller; player: 0 */
};

struct controllers_event {
    enum controllers_event_kind kind;
    int player;                        /* from 0 */
    bool first;                        /* player 1 got it and had none before */
    bool start;                        /* assigned with START */
    struct plat_controller controller; /* for CONTROLLERS_UNPLUGGED, its former description */
};

struct controllers {
    struct plat_controller info[PLAT_MAX_CONTROLLERS];
    bool connected[PLAT_MAX_CONTROLLERS];
    uint32_t held[PLAT_MAX_CONTROLLERS];                    /* at the last poll */
    uint32_t ignored[PLAT_MAX_CONTROLLERS];                 /* held buttons that don't count until they are released */
    uint32_t buttons[PLAT_MAX_CONTROLLERS];                 /* result of this poll: held and not ignored */
    int controller_of[MAX_PLAYERS];                         /* controller of each player, or CONTROLLERS_NONE */
    bool reserved[MAX_PLAYERS];                             /* the player's controller was unplugged */
    struct plat_controller reserved_for[MAX_PLAYERS];       /* that controller */
    struct controllers_event event[CONTROLLERS_MAX_EVENTS]; /* of the last poll */
    int event_count;
};

void controllers_open(struct controllers *s);

/* Handles a poll. held: the buttons of each controller. plugged: the description of each from plat_get_controller;
 * NULL: not connected. players: the number of players of the game. Updates s->buttons, s->controller_of and s->event.
 * */
void controllers_poll(struct controllers *s, int players, const uint32_t held[PLAT_MAX_CONTROLLERS],
                      const struct plat_controller *const plugged[PLAT_MAX_CONTROLLERS]);

/* Returns the player of a controller, or -1. */
int controllers_find_player(const struct controllers *s, int controller);

/* Assigns a connected controller to a player instead of its previous player; CONTROLLERS_NONE only removes the player's
 * controller. Buttons held on it don't count until they are released. */
void controllers_assign(struct controllers *s, int player, int controller);

/* Returns the buttons of a player's controller; 0 if the player has none. */
uint32_t controllers_buttons(const struct controllers *s, int player);

#endif
