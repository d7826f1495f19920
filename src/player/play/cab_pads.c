/*
 * cab_pads.c - whose controller is whose, and from the buttons that are held to the pads of a tick.
 */
#include <stdarg.h>
#include <stdio.h>
#include "../../board/inspect.h"
#include "../input/switch.h"
#include "cab_parts.h"

void cab_pads_open(struct cab *cab)
{
    seats_open(&cab->seats);
    cab_pads_apply(cab);
    cab_pads_power(cab);
}

void cab_pads_apply(struct cab *cab)
{
    const struct config *c = &cab->config;

    for (int p = 0; p < MAX_PLAYERS; p++) {
        keys_hand(&cab->config.keys, p, (enum keys_hand)c->one_hand[p]);
        cab->modes[p] = (struct press_modes){ .autofire = c->autofire[p],
                                              .toggle_focus = c->focus[p],
                                              .one_hand = c->one_hand[p] != HAND_BOTH };
    }
}

/* ---- pads ---- */

void cab_pads_power(struct cab *cab)
{
    cab->pressed_to = 0;
    for (int p = 0; p < MAX_PLAYERS; p++)
        press_resume(&cab->press[p], 0);
}

/* Time was turned: what the players had switched is what they had then. */
static void resume(struct cab *cab, uint32_t frame)
{
    uint16_t were[MAX_PLAYERS] = { 0 };

    if (frame)
        demo_pads(&cab->session.now->writer.demo, frame - 1, were);
    for (int p = 0; p < MAX_PLAYERS; p++)
        press_resume(&cab->press[p], were[p]);
}

void cab_pads_tick(struct cab *cab, uint16_t pads[MAX_PLAYERS])
{
    const struct board *b = cab_live(cab);
    const uint32_t frame = board_frame(b);

    if (frame != cab->pressed_to)
        resume(cab, frame);
    cab->pressed_to = frame + 1;
    for (int p = 0; p < MAX_PLAYERS; p++) {
        const struct inspect_controls ship = inspect_player_controls(b, p);
        pads[p] = press_tick(&cab->press[p], &cab->modes[p], (struct press_ship){ ship.can_steer, ship.can_fire },
                             cab->pads[p]);
    }
}

/* ---- controllers ---- */

void cab_seats_poll(struct cab *cab, const struct plat_input *in)
{
    struct plat_controller is[PLAT_MAX_CONTROLLERS];
    const struct plat_controller *plugged[PLAT_MAX_CONTROLLERS];

    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        plugged[i] = plat_get_controller(i, &is[i]) ? &is[i] : NULL;
    seats_poll(&cab->seats, cab->session.now ? cab_cart(cab)->manifest.players : 1, in->controllers, plugged);
}

const char *cab_controller_name(const struct plat_controller *c)
{
    return c->name[0] ? c->name : switch_kind_name(c->kind);
}

/* Over the picture, and at the foot of a screen. */
CAB_PRINTF(3, 4) static void tell(struct cab *cab, int frames, const char *format, ...)
{
    char text[sizeof cab->notice];
    va_list args;

    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    cab_notice(cab, frames, "%s", text);
    if (screens_are_open(&cab->screens))
        screens_say(&cab->screens, "%s", text);
}

/* A player lost what they played with: the game waits for them. */
static bool waits_for(struct cab *cab, int player)
{
    return cab->config.keys.player[player].controller && !cab->session.demo && !cab->attracting && !cab_fault(cab);
}

static void lost(struct cab *cab, int player, const char *name)
{
    if (!waits_for(cab, player)) {
        tell(cab, CAB_NOTICE_FRAMES, "Player %d: %s unplugged", player + 1, name);
        return;
    }
    cab->paused = cab->unplugged = true;
    tell(cab, CAB_NOTICE_STAYS, "Player %d: %s unplugged. Plug it in or press START on another controller", player + 1,
         name);
}

static void seat_event(struct cab *cab, const struct seats_event *e)
{
    const char *name = cab_controller_name(&e->controller);

    if (e->what == SEATS_LOST)
        lost(cab, e->player, name);
    else if (e->what == SEATS_FULL)
        tell(cab, CAB_NOTICE_FRAMES, "Every player already has a controller");
    else if (cab->unplugged)
        tell(cab, CAB_NOTICE_STAYS, "Player %d: %s. Press START to resume", e->player + 1, name);
    else if (!e->first)
        tell(cab, CAB_NOTICE_FRAMES, "Player %d: %s", e->player + 1, name);
}

/* START ends the pause that a lost controller began, and the game does not get it. */
static void go_on(struct cab *cab, const struct keys_read *k)
{
    if (!cab->unplugged || screens_are_open(&cab->screens))
        return;
    for (int i = 0; i < cab->seats.events; i++)
        cab->paused = cab->paused && !cab->seats.event[i].start;
    for (int p = 0; p < MAX_PLAYERS; p++) {
        cab->paused = cab->paused && !(k->pads_fresh[p] & PAD_START);
        cab->stale[p] |= k->pads_fresh[p] & PAD_START;
    }
    if (cab->paused)
        return;
    cab->unplugged = false;
    cab->notice_left = 0;
}

void cab_seats_told(struct cab *cab, const struct keys_read *k)
{
    for (int i = 0; i < cab->seats.events; i++)
        seat_event(cab, &cab->seats.event[i]);
    go_on(cab, k);
}
