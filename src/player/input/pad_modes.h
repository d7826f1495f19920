/*
 * pad_modes.h - autofire, toggled focus and one-handed play: computes the pads of a tick from the held buttons.
 *
 * The result is what is recorded, so demos don't depend on these modes. All times are in ticks. A mode affects a button
 * only while the button controls the ship; otherwise menus and dialogue would be confirmed automatically.
 *
 * * autofire: while fire is held, it is pressed for AUTOFIRE_ON ticks and released for AUTOFIRE_OFF, fifteen times a
 *   second.
 * * toggle_focus: each press of focus turns it on or off. A power-on turns it off. After a jump in time, it is on if
 *   the previous tick's pads have focus.
 * * one_hand: fire is held automatically from the first move on, because the hand also has to steer, focus and bomb. A
 *   press of fire stops this and works as usual; the next move starts it again. Bombs have a button that the hand
 *   reaches (keys.h), instead of a double tap of focus, which is tapped all the time in such games.
 */
#ifndef PLAYER_PAD_MODES_H
#define PLAYER_PAD_MODES_H

#include <stdbool.h>
#include <stdint.h>
#include "../../base/pads.h"

enum { AUTOFIRE_ON = 2, AUTOFIRE_OFF = 2 /* ticks */ };

struct pad_modes {
    bool autofire, toggle_focus, one_hand;
};

/* The state for one player. */
struct pad_mode_state {
    uint16_t held;       /* buttons held in the last tick */
    bool focus_on;       /* with toggle_focus */
    bool auto_fire;      /* with one_hand: fire is held automatically */
    uint32_t fire_ticks; /* for which fire has been held */
};

/* Derives the state after a power-on (pads 0) or after a jump to the tick after one with these pads. Buttons that are
 * held across the jump don't count as new presses. */
void pad_modes_resume(struct pad_mode_state *p, uint16_t pads);

/* Whether these buttons control the ship, instead of a menu or a dialogue. */
struct pad_modes_control {
    bool can_steer, can_fire;
};

/* Returns the pads of the next tick for the held buttons. */
uint16_t pad_modes_tick(struct pad_mode_state *p, const struct pad_modes *modes, struct pad_modes_control control,
                        uint16_t held);

#endif
