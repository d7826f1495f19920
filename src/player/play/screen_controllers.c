/*
 * screen_controllers.c - the controllers that are plugged in: whose each is, another player for it, and what is pressed
 * on them, by which one is told from another.
 */
#include <stdio.h>
#include <string.h>
#include "../input/switch.h"
#include "cab_parts.h"

static int players(struct cab *cab)
{
    return cab_cart(cab)->manifest.players > 1 ? MAX_PLAYERS : 1;
}

/* The controller of a row; -1: none is plugged in. */
static int controller_at(struct cab *cab, int at)
{
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        if (cab->seats.there[i] && at-- == 0)
            return i;
    return -1;
}

static int rows(void *of)
{
    struct cab *cab = of;
    int n = 0;

    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        n += cab->seats.there[i];
    return n > 0 ? n : 1;
}

static const char *text(void *of)
{
    struct cab *cab = of;

    return players(cab) > 1 ? "Player 1 gets the first controller used. Press START on another to add player 2."
                            : "The first controller you use controls the game. Press START on another to switch.";
}

/* What is held on controller i, as it is printed there: "2: cross, L1  ". Returns its length. */
static size_t describe_one(struct cab *cab, int i, char *out, size_t size)
{
    char label[SWITCH_NAME];
    size_t n = 0;

    for (unsigned bit = 0; bit < PLAT_BUTTONS && n < size; bit++) {
        if (!(cab->pressed[i] >> bit & 1))
            continue;
        switch_label(SWITCH_CONTROLLER | bit, cab->seats.is[i].kind, label, sizeof label);
        n += n ? (size_t)snprintf(out + n, size - n, ", %s", label)
               : (size_t)snprintf(out, size, "%d: %s", i + 1, label);
    }
    return n && n < size ? n + (size_t)snprintf(out + n, size - n, "  ") : n;
}

static void describe_pressed(struct cab *cab, char *out, size_t size)
{
    size_t n = 0;

    snprintf(out, size, "Press a button to identify a controller.");
    for (int i = 0; i < PLAT_MAX_CONTROLLERS && n < size; i++)
        n += describe_one(cab, i, out + n, size - n);
}

static void describe(void *of, int at, struct screen_row *row)
{
    struct cab *cab = of;
    const int i = controller_at(cab, at), player = i < 0 ? -1 : seats_player(&cab->seats, i);

    if (i < 0) {
        snprintf(row->label, sizeof row->label, "No controllers");
        row->faint = true;
        return;
    }
    snprintf(row->label, sizeof row->label, "%d %s", i + 1, cab_controller_name(&cab->seats.is[i]));
    if (player < 0)
        snprintf(row->value, sizeof row->value, "Unassigned");
    else
        snprintf(row->value, sizeof row->value, "Player %d", player + 1);
    describe_pressed(cab, row->help, sizeof row->help);
    row->changes = true;
}

/* Nobody, player 1, player 2, and round. */
static void change(void *of, int at, int by)
{
    struct cab *cab = of;
    const int i = controller_at(cab, at), n = players(cab) + 1, now = seats_player(&cab->seats, i) + 1,
              to = (now + (by < 0 ? -1 : 1) + n) % n;

    if (to > 0)
        seats_give(&cab->seats, to - 1, i);
    else
        seats_give(&cab->seats, now - 1, SEAT_EMPTY);
}

/* START takes a place here, and changes no row. */
static bool listen(void *of, const struct plat_input *in)
{
    struct cab *cab = of;
    uint32_t all = 0;

    memcpy(cab->pressed, in->controllers, sizeof cab->pressed);
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        all |= in->controllers[i];
    return all >> PLAT_START & 1;
}

static const struct screen_def controllers = {
    .title = "Controllers", .rows = rows, .row = describe, .text = text, .change = change, .listen = listen
};

void cab_open_controllers(struct cab *cab)
{
    screens_open(&cab->screens, &controllers, cab);
}
