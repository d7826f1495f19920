/*
 * players_run.c - updates players between the tasks' turns and the moves: bombs, and the deathbomb window after a hit,
 * in which a bomb saves the player.
 */
#include "events_run.h"
#include "api/api.h"

enum { BUTTON_BOMB = 5 }; /* index in PAD_BUTTON_NAMES */
_Static_assert(1 << BUTTON_BOMB == PAD_BOMB, "BUTTON_BOMB is the bit of PAD_BOMB");

/* Counts down player p's bomb. When the bomb ends, stops its scope. */
static void step_bomb(struct board *b, uint32_t p)
{
    const int64_t scope = b->player.bomb_scope[p];

    if (!b->player.bomb_left[p] || --b->player.bomb_left[p])
        return;
    if (board_is_alive(b, scope))
        tasks_stop(b, handle_slot(scope));
    b->player.bomb_scope[p] = 0;
}

void events_step_players(struct board *b, lua_State *L)
{
    for (uint32_t p = 0; p < MAX_PLAYERS; p++) {
        if (!b->player.in_game[p])
            continue;
        step_bomb(b, p);
        if (b->player_kinds.bomb[b->player.kind[p]] && input_take(&b->input, p, BUTTON_BOMB, 0, PRESS_GAME))
            api_bomb_start(L, b, p);
        if (b->player.deathbomb_left[p] && --b->player.deathbomb_left[p] == 0)
            events_kill_player(b, p);
    }
}
