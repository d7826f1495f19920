/*
 * screen_controllers.c - the controllers: which player uses each, how to assign it to another, and its pressed buttons,
 * which identify it.
 */
#include <stdio.h>
#include <string.h>
#include "../input/input_code.h"
#include "play_state.h"

static int player_count(struct play *play)
{
    return play_cart(play)->manifest.players > 1 ? MAX_PLAYERS : 1;
}

/* The controller of a row; -1: none is plugged in. */
static int controller_at(struct play *play, int at)
{
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        if (play->pads.controllers.connected[i] && at-- == 0)
            return i;
    return -1;
}

static int rows(void *context)
{
    int n = 0;

    while (controller_at(context, n) >= 0)
        n++;
    return n > 0 ? n : 1;
}

static const char *text(void *context)
{
    return player_count(context) > 1
               ? "Player 1 gets the first controller used. Press START on another to add player 2."
               : "The first controller you use controls the game. Press START on another to switch.";
}

/* The labels of the buttons held on controller i: "2: cross, L1  ". Returns the length. */
static size_t describe_buttons(struct play *play, int i, char *out, size_t size)
{
    char label[INPUT_CODE_NAME_SIZE];
    size_t n = 0;

    for (unsigned bit = 0; bit < PLAT_BUTTONS && n < size; bit++) {
        if (!(play->controllers_held[i] >> bit & 1))
            continue;
        input_code_label(INPUT_CODE_CONTROLLER | bit, play->pads.controllers.info[i].kind, label, sizeof label);
        n += n ? (size_t)snprintf(out + n, size - n, ", %s", label)
               : (size_t)snprintf(out, size, "%d: %s", i + 1, label);
    }
    return n && n < size ? n + (size_t)snprintf(out + n, size - n, "  ") : n;
}

static void describe(void *context, int at, struct screen_row *row)
{
    struct play *play = context;
    const struct controllers *controllers = &play->pads.controllers;
    const int i = controller_at(play, at), player = i < 0 ? -1 : controllers_find_player(controllers, i);
    char *suffix;
    size_t n = 0;

    if (i < 0) {
        snprintf(row->label, sizeof row->label, "No controllers");
        row->disabled = true;
        return;
    }
    snprintf(row->label, sizeof row->label, "%d %s", i + 1, play_controller_name(&controllers->info[i]));
    if ((suffix = strstr(row->label, " Controller")) != NULL)
        *suffix = '\0'; /* the heading says it */
    if (player < 0)
        snprintf(row->value, sizeof row->value, "None");
    else
        snprintf(row->value, sizeof row->value, "Player %d", player + 1);
    snprintf(row->help, sizeof row->help, "Press a button to identify a controller.");
    for (int c = 0; c < PLAT_MAX_CONTROLLERS && n < sizeof row->help; c++)
        n += describe_buttons(play, c, row->help + n, sizeof row->help - n);
    row->changes = true;
}

/* Unassigned, player 1, player 2, and unassigned again. */
static void change(void *context, int at, int by)
{
    struct play *play = context;
    struct controllers *controllers = &play->pads.controllers;
    const int i = controller_at(play, at), n = player_count(play) + 1,
              now = controllers_find_player(controllers, i) + 1, to = (now + (by < 0 ? -1 : 1) + n) % n;

    if (to > 0)
        controllers_assign(controllers, to - 1, i);
    else
        controllers_assign(controllers, now - 1, CONTROLLERS_NONE);
}

/* Here START assigns the controller, and changes no row. */
static bool listen(void *context, const struct plat_input *in)
{
    struct play *play = context;
    uint32_t all = 0;

    memcpy(play->controllers_held, in->controllers, sizeof play->controllers_held);
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        all |= in->controllers[i];
    return all >> PLAT_START & 1;
}

static const struct screen_def controllers_screen = {
    .title = "Controllers", .rows = rows, .row = describe, .text = text, .change = change, .listen = listen
};

void play_open_controllers(struct play *play)
{
    screens_open(&play->screens, &controllers_screen, play);
}
