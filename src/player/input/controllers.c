/*
 * controllers.c - assigns controllers (controllers.h). A poll handles unplugged controllers, then new ones, then
 * presses.
 */
#include "controllers.h"

#include <string.h>

void controllers_open(struct controllers *s)
{
    memset(s, 0, sizeof *s);
    for (int p = 0; p < MAX_PLAYERS; p++)
        s->controller_of[p] = CONTROLLERS_NONE;
}

int controllers_find_player(const struct controllers *s, int controller)
{
    for (int p = 0; p < MAX_PLAYERS; p++)
        if (s->controller_of[p] == controller)
            return p;
    return -1;
}

uint32_t controllers_buttons(const struct controllers *s, int player)
{
    return s->controller_of[player] == CONTROLLERS_NONE ? 0 : s->buttons[s->controller_of[player]];
}

static void add_event(struct controllers *s, enum controllers_event_kind kind, int player,
                      const struct plat_controller *c)
{
    s->event[s->event_count++] = (struct controllers_event){ .kind = kind, .player = player, .controller = *c };
}

void controllers_assign(struct controllers *s, int player, int controller)
{
    int previous_player = controller == CONTROLLERS_NONE ? -1 : controllers_find_player(s, controller);

    if (previous_player >= 0)
        s->controller_of[previous_player] = CONTROLLERS_NONE;
    s->controller_of[player] = controller;
    s->reserved[player] = false;
    if (controller == CONTROLLERS_NONE)
        return;
    s->ignored[controller] |= s->held[controller];
    s->buttons[controller] &= ~s->ignored[controller];
}

static void unplug(struct controllers *s, int i)
{
    int player = controllers_find_player(s, i);

    s->connected[i] = false;
    s->held[i] = s->ignored[i] = 0;
    if (player < 0)
        return;
    s->controller_of[player] = CONTROLLERS_NONE;
    s->reserved[player] = true;
    s->reserved_for[player] = s->info[i];
    add_event(s, CONTROLLERS_UNPLUGGED, player, &s->info[i]);
}

static bool same_model(const struct plat_controller *a, const struct plat_controller *b)
{
    return a->kind == b->kind && strcmp(a->name, b->name) == 0;
}

static void plug_in(struct controllers *s, int i, const struct plat_controller *c, uint32_t held)
{
    s->connected[i] = true;
    s->info[i] = *c;
    s->held[i] = s->ignored[i] = held;
    for (int p = 0; p < MAX_PLAYERS; p++) {
        if (s->reserved[p] && same_model(&s->reserved_for[p], c)) {
            s->controller_of[p] = i;
            s->reserved[p] = false;
            add_event(s, CONTROLLERS_RECONNECTED, p, c);
            return;
        }
    }
}

/* Handles a press on a controller without a player. */
static void handle_press(struct controllers *s, int i, int players, uint32_t newly_pressed)
{
    const bool first = s->controller_of[0] == CONTROLLERS_NONE;
    int player = 0;

    if (!first) {
        if (!(newly_pressed >> PLAT_START & 1))
            return;
        while (player < players && s->controller_of[player] != CONTROLLERS_NONE)
            player++;
        if (player == players && players > 1) {
            add_event(s, CONTROLLERS_REFUSED, 0, &s->info[i]);
            return;
        }
        player = player < players ? player : 0;
        s->ignored[i] |= 1u << PLAT_START;
    }
    s->controller_of[player] = i;
    add_event(s, CONTROLLERS_ASSIGNED, player, &s->info[i]);
    s->event[s->event_count - 1].first = first && !s->reserved[player];
    s->event[s->event_count - 1].start = newly_pressed >> PLAT_START & 1;
    s->reserved[player] = false;
}

void controllers_poll(struct controllers *s, int players, const uint32_t held[PLAT_MAX_CONTROLLERS],
                      const struct plat_controller *const plugged[PLAT_MAX_CONTROLLERS])
{
    s->event_count = 0;
    players = players < 1 ? 1 : players > MAX_PLAYERS ? MAX_PLAYERS : players;
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        if (s->connected[i] && (!plugged[i] || plugged[i]->id != s->info[i].id))
            unplug(s, i);
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        if (!s->connected[i] && plugged[i])
            plug_in(s, i, plugged[i], held[i]);
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++) {
        uint32_t now = s->connected[i] ? held[i] : 0, newly_pressed = now & ~s->held[i];

        s->held[i] = now;
        s->ignored[i] &= now;
        if (newly_pressed && controllers_find_player(s, i) < 0)
            handle_press(s, i, players, newly_pressed);
        s->buttons[i] = now & ~s->ignored[i];
    }
}
