/*
 * press.h - autofire, toggled focus and one-handed play: computes the pads of a tick from the held buttons.
 *
 * The result is what is recorded, so demos don't depend on these modes. All times are in ticks. A mode affects a button
 * only while the button controls the ship; otherwise menus and dialogue would be confirmed automatically.
 *
 * * autofire: while fire is held, it is pressed for PRESS_ON ticks and released for PRESS_OFF, fifteen times a second.
 * * toggle_focus: each press of focus turns it on or off. A power-on turns it off. After a jump in time, the pads of
 * the
 *   previous tick decide.
 * * one_hand: fire is held automatically from the first move on, because the hand also has to steer, focus and bomb. A
 *   press of fire stops this and works as usual; the next move starts it again. Bombs have a button that the hand
 *   reaches (keys.h), instead of a double tap of focus, which is tapped all the time in such games.
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

/* The state for one player. */
struct press {
    uint16_t held;       /* buttons held in the last tick */
    bool focus, fires;   /* focus is toggled on; fire is held automatically */
    uint32_t fire_ticks; /* ticks since fire is held */
};

/* Derives the state after a power-on (pads 0) or after a jump to the tick after one with these pads. Buttons that are
 * held across the jump don't count as new presses. */
void press_resume(struct press *p, uint16_t pads);

/* Whether the buttons control the ship, instead of a menu or a dialogue. */
struct press_ship {
    bool steers, fires;
};

/* Returns the pads of the next tick for the held buttons. */
uint16_t press_tick(struct press *p, const struct press_modes *modes, struct press_ship ship, uint16_t held);

#endif
