/*
 * press.c - how buttons become pads (press.h).
 */
#include "press.h"

enum { MOVES = PAD_UP | PAD_DOWN | PAD_LEFT | PAD_RIGHT };

void press_resume(struct press *p, uint16_t pads)
{
    *p = (struct press){ .held = PAD_ALL, .focus = pads & PAD_FOCUS, .fires = pads & PAD_FIRE };
}

static unsigned toggled(struct press *p, unsigned held, unsigned fresh)
{
    if (fresh & PAD_FOCUS)
        p->focus = !p->focus;
    return (held & ~(unsigned)PAD_FOCUS) | (p->focus ? PAD_FOCUS : 0);
}

/* Before a press of fire, releases fire for a tick, so that the game notices the press. */
static unsigned with_one_hand(struct press *p, unsigned held, unsigned fresh)
{
    if (fresh & PAD_FIRE) {
        held &= p->fires ? ~(unsigned)PAD_FIRE : ~0u;
        p->fires = false;
    } else if (held & MOVES && !(held & PAD_FIRE)) {
        p->fires = true;
    }
    return held | (p->fires ? PAD_FIRE : 0);
}

static unsigned in_bursts(struct press *p, unsigned held)
{
    if (!(held & PAD_FIRE)) {
        p->fire_ticks = 0;
        return held;
    }
    bool on = p->fire_ticks++ % (PRESS_ON + PRESS_OFF) < PRESS_ON;
    return on ? held : held & ~(unsigned)PAD_FIRE;
}

uint16_t press_tick(struct press *p, const struct press_modes *modes, struct press_ship ship, uint16_t held)
{
    unsigned out = held, fresh = held & ~(unsigned)p->held;

    p->held = held;
    if (modes->toggle_focus && ship.steers)
        out = toggled(p, out, fresh);
    if (!ship.fires) {
        p->fires = false;
        p->fire_ticks = 0;
        return (uint16_t)out;
    }
    if (modes->one_hand)
        out = with_one_hand(p, out, fresh);
    if (modes->autofire)
        out = in_bursts(p, out);
    return (uint16_t)out;
}
