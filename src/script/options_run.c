/*
 * options_run.c - options on the board: spawns as many as each ship's register calls for, and moves them with the ship.
 */
#include "api/api.h"
#include "events_run.h"
#include "options_run.h"

/* Fills in the current state of player p's ship for its options. Returns false if it has no options. */
static bool fill_ship(const struct board *b, uint32_t p, struct option_ship *ship)
{
    const struct player *s = &b->player;
    const struct option_plan *plan = s->in_game[p] ? b->option_plans[s->kind[p]] : NULL;

    if (!plan)
        return false;
    const int64_t value =
        plan->level_register < 0 ? INT32_MAX : board_get_register(b, p, (uint32_t)plan->level_register);
    *ship = (struct option_ship){ .plan = plan,
                                  .level = options_level(plan, value),
                                  .x = s->x[p],
                                  .y = s->y[p],
                                  .prev_x = s->prev_x[p],
                                  .prev_y = s->prev_y[p],
                                  .is_focused = s->flags[p] & PLAYER_FOCUS };
    return ship->level != NULL;
}

static void add_option(struct board *b, lua_State *L, uint32_t p, uint16_t kind, uint32_t index)
{
    const int32_t i =
        options_add(&b->options, &b->option_kinds, kind, p, index, b->player.x[p], b->player.y[p], b->core.clock);

    if (i == NO_SLOT) {
        board_report_full(b, &b->options.s);
        return;
    }
    if (!events_push_function(L, kind, "option's run"))
        return;
    lua_pushinteger(L, board_handle(b, H_OPTION, i));
    tasks_start(b, L, board_handle(b, H_OPTION, i), 1);
}

void options_adjust_count(struct board *b, lua_State *L)
{
    struct option_ship ship;

    for (uint32_t p = 0; p < MAX_PLAYERS; p++) {
        const uint32_t n = fill_ship(b, p, &ship) ? ship.level->n : 0;
        uint32_t existing = 0; /* one bit per existing option */
        EACH_LIVE (i, &b->options.s)
            if (b->options.player[i] == p)
                existing |= 1u << b->options.index[i];
        if (existing >> n)
            options_drop_from(&b->options, p, n);
        for (uint32_t k = 0; k < n; k++)
            if (!(existing >> k & 1))
                add_option(b, L, p, ship.plan->kind, k);
    }
}

void options_follow(struct board *b)
{
    struct option_ship ship;

    for (uint32_t p = 0; p < MAX_PLAYERS; p++)
        if (fill_ship(b, p, &ship))
            options_move(&b->options, &b->option_paths, p, &ship);
}
