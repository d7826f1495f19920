/*
 * pad_modes.c - computes pads from held buttons (pad_modes.h).
 */
#include "pad_modes.h"

enum { DIRECTIONS = PAD_UP | PAD_DOWN | PAD_LEFT | PAD_RIGHT };

void pad_modes_resume(struct pad_mode_state *p, uint16_t pads)
{
    *p = (struct pad_mode_state){ .held = PAD_ALL, .focus_on = pads & PAD_FOCUS, .auto_fire = pads & PAD_FIRE };
}

static unsigned toggle_focus_button(struct pad_mode_state *p, unsigned held, unsigned newly_pressed)
{
    if (newly_pressed & PAD_FOCUS)
        p->focus_on = !p->focus_on;
    return (held & ~(unsigned)PAD_FOCUS) | (p->focus_on ? PAD_FOCUS : 0);
}

/* Before a press of fire, releases fire for a tick, so that the game notices the press. */
static unsigned hold_fire(struct pad_mode_state *p, unsigned held, unsigned newly_pressed)
{
    if (newly_pressed & PAD_FIRE) {
        held &= p->auto_fire ? ~(unsigned)PAD_FIRE : ~0u;
        p->auto_fire = false;
    } else if (held & DIRECTIONS && !(held & PAD_FIRE)) {
        p->auto_fire = true;
    }
    return held | (p->auto_fire ? PAD_FIRE : 0);
}

static unsigned pulse_fire(struct pad_mode_state *p, unsigned held)
{
    if (!(held & PAD_FIRE)) {
        p->fire_ticks = 0;
        return held;
    }
    bool on = p->fire_ticks++ % (AUTOFIRE_ON + AUTOFIRE_OFF) < AUTOFIRE_ON;
    return on ? held : held & ~(unsigned)PAD_FIRE;
}

uint16_t pad_modes_tick(struct pad_mode_state *p, const struct pad_modes *modes, struct pad_modes_control control,
                        uint16_t held)
{
    unsigned out = held, newly_pressed = held & ~(unsigned)p->held;

    p->held = held;
    if (modes->toggle_focus && control.can_steer)
        out = toggle_focus_button(p, out, newly_pressed);
    if (!control.can_fire) {
        p->auto_fire = false;
        p->fire_ticks = 0;
        return (uint16_t)out;
    }
    if (modes->one_hand)
        out = hold_fire(p, out, newly_pressed);
    if (modes->autofire)
        out = pulse_fire(p, out);
    return (uint16_t)out;
}
