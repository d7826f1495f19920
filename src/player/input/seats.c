/*
 * seats.c - assigns controllers (seats.h). A poll handles unplugged controllers, then new ones, then presses.
 */
#include "seats.h"

#include <string.h>

void seats_open(struct seats *s)
{
    memset(s, 0, sizeof *s);
    for (int p = 0; p < MAX_PLAYERS; p++)
        s->seat[p] = SEAT_EMPTY;
}

int seats_player(const struct seats *s, int controller)
{
    for (int p = 0; p < MAX_PLAYERS; p++)
        if (s->seat[p] == controller)
            return p;
    return -1;
}

uint32_t seats_switches(const struct seats *s, int player)
{
    return s->seat[player] == SEAT_EMPTY ? 0 : s->switches[s->seat[player]];
}

static void add_event(struct seats *s, enum seats_what what, int player, const struct plat_controller *c)
{
    s->event[s->events++] = (struct seats_event){ .what = what, .player = player, .controller = *c };
}

void seats_give(struct seats *s, int player, int controller)
{
    int had = controller == SEAT_EMPTY ? -1 : seats_player(s, controller);

    if (had >= 0)
        s->seat[had] = SEAT_EMPTY;
    s->seat[player] = controller;
    s->waits[player] = false;
    if (controller == SEAT_EMPTY)
        return;
    s->ignored[controller] |= s->held[controller];
    s->switches[controller] &= ~s->ignored[controller];
}

static void unplug(struct seats *s, int i)
{
    int player = seats_player(s, i);

    s->there[i] = false;
    s->held[i] = s->ignored[i] = 0;
    if (player < 0)
        return;
    s->seat[player] = SEAT_EMPTY;
    s->waits[player] = true;
    s->was[player] = s->is[i];
    add_event(s, SEATS_LOST, player, &s->is[i]);
}

static bool same_model(const struct plat_controller *a, const struct plat_controller *b)
{
    return a->kind == b->kind && strcmp(a->name, b->name) == 0;
}

static void plug_in(struct seats *s, int i, const struct plat_controller *c, uint32_t held)
{
    s->there[i] = true;
    s->is[i] = *c;
    s->held[i] = s->ignored[i] = held;
    for (int p = 0; p < MAX_PLAYERS; p++) {
        if (s->waits[p] && same_model(&s->was[p], c)) {
            s->seat[p] = i;
            s->waits[p] = false;
            add_event(s, SEATS_BACK, p, c);
            return;
        }
    }
}

/* Handles a press on a controller without a player. */
static void pressed(struct seats *s, int i, int players, uint32_t fresh)
{
    const bool first = s->seat[0] == SEAT_EMPTY;
    int player = 0;

    if (!first) {
        if (!(fresh >> PLAT_START & 1))
            return;
        while (player < players && s->seat[player] != SEAT_EMPTY)
            player++;
        if (player == players && players > 1) {
            add_event(s, SEATS_FULL, 0, &s->is[i]);
            return;
        }
        player = player < players ? player : 0;
        s->ignored[i] |= 1u << PLAT_START;
    }
    s->seat[player] = i;
    add_event(s, SEATS_TAKEN, player, &s->is[i]);
    s->event[s->events - 1].first = first && !s->waits[player];
    s->event[s->events - 1].start = fresh >> PLAT_START & 1;
    s->waits[player] = false;
}

void seats_poll(struct seats *s, int players, const uint32_t held[PLAT_MAX_CONTROLLERS],
                const struct plat_controller *const plugged[PLAT_MAX_CONTROLLERS])
{
    s->events = 0;
    players = players < 1 ? 1 : players > MAX_PLAYERS ? MAX_PLAYERS : players;
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        if (s->there[i] && (!plugged[i] || plugged[i]->id != s->is[i].id))
            unplug(s, i);
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        if (!s->there[i] && plugged[i])
            plug_in(s, i, plugged[i], held[i]);
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++) {
        uint32_t now = s->there[i] ? held[i] : 0, fresh = now & ~s->held[i];

        s->held[i] = now;
        s->ignored[i] &= now;
        if (fresh && seats_player(s, i) < 0)
            pressed(s, i, players, fresh);
        s->switches[i] = now & ~s->ignored[i];
    }
}
