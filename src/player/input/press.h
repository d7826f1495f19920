/*
 * press.h - how a player presses: from the buttons that are held to those that a tick gets.
 *
 * What comes out is what is recorded, so a demo needs none of this. All is counted in ticks. A mode acts only on what
 * is the ship's at that tick: everywhere else a button is a button, so that no menu and no talk is answered by itself.
 *
 * * autofire: fire that is held is pressed for PRESS_ON ticks and released for PRESS_OFF, fifteen times a second.
 * * toggle_focus: each press of focus switches it, and it stays. A power-on switches it off; so the pads say where time
 *   was turned back to.
 * * one_hand: fire is held by itself from the first move on, for the fingers that are left have to steer, focus and
 *   bomb. A press of fire lets it go, and as long as it is held it is what it always is; the next move holds it again.
 *   Bombs are not thrown by a second tap of focus: focus is tapped all the time in such games. They get a switch that
 *   the hand reaches (keys.h, one hand).
 */
#ifndef PLAYER_PRESS_H
#define PLAYER_PRESS_H

#include <stdbool.h>
#include <stdint.h>
#include "../../base/pads.h"

enum { PRESS_ON = 2, PRESS_OFF = 2 /* ticks */ };

struct press_modes {
    bool autofire, toggle_focus, one_hand;
};

/* Of one player. */
struct press {
    uint16_t held;       /* what the last tick was given */
    bool focus, fires;   /* switched on; held by itself */
    uint32_t fire_ticks; /* that fire is held */
};

/* The present is another one: a power-on (pads 0), or time was turned to a tick after one that got these pads. What is
 * held over it is no new press. */
void press_resume(struct press *p, uint16_t pads);

/* What is the ship's, and not a menu's or a talk's. */
struct press_ship {
    bool steers, fires;
};

/* The pads of the next tick, from the buttons that are held. */
uint16_t press_tick(struct press *p, const struct press_modes *modes, struct press_ship ship, uint16_t held);

#endif
