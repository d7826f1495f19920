/*
 * force.c - see force.h. Each kind raises the event that collisions or the player would have raised; events_run.c
 * handles the rest.
 */
#include "force.h"
#include "api/api.h"
#include "events_run.h"

enum {
    SAFE = 60 * 60, /* frames */
    FORCE_HP = 5000 /* few enough that an enemy meant to be indestructible survives */
};

/* Returns the handle of a bullet that can be grazed or, if not `grazes`, that can hit a player. Returns 0 if there is
 * none. */
static int64_t bullet_that(const struct board *b, bool grazes)
{
    const struct bullets *s = &b->bullets;

    EACH_LIVE (i, &s->s) {
        const bool able =
            grazes ? b->bullet_kinds.flags[s->kind[i]] & KIND_GRAZE : b->bullet_kinds.shape[s->kind[i]] != SHAPE_NONE;
        if (able && !(s->flags[i] & BULLET_DELAYED))
            return board_handle(b, H_BULLET, (int32_t)i);
    }
    return 0;
}

/* Returns the handle of a bullet or enemy that can hit players, or 0. */
static int64_t danger(const struct board *b)
{
    const int64_t bullet = bullet_that(b, false);

    if (bullet)
        return bullet;
    EACH_LIVE (i, &b->enemies.s)
        if (b->enemy_kinds.flags[b->enemies.kind[i]] & ENEMY_TOUCH && !(b->enemies.flags[i] & ENEMY_DYING))
            return board_handle(b, H_ENEMY, (int32_t)i);
    return 0;
}

static void hit(struct board *b, uint32_t p, int64_t player)
{
    const int64_t by = danger(b);

    b->player.safe[p] = 0;
    if (by)
        board_event(b, EV_HIT, player, by);
    else
        events_player_die(b, p);
}

static void take(struct board *b, uint32_t p, int64_t player)
{
    for (uint32_t k = 0; k < b->item_kinds.s.live; k++) {
        const int32_t i = items_put(&b->items, (uint16_t)k, b->player.x[p], b->player.y[p], b->core.clock);
        if (i != NO_SLOT)
            board_event(b, EV_TAKE, player, board_handle(b, H_ITEM, i));
    }
}

static void damage(lua_State *L, struct board *b, uint32_t p)
{
    EACH_LIVE (i, &b->enemies.s)
        events_enemy_hurt(b, L, i, FORCE_HP, p + 1);
}

static int run(lua_State *L)
{
    struct board *b = vm_board(L);
    const uint32_t p = (uint32_t)b->output->force->player;
    const int64_t player = board_handle(b, H_PLAYER, (int32_t)p);
    const int64_t bullet = bullet_that(b, true);

    switch (b->output->force->kind) {
    case FORCE_HIT:
        hit(b, p, player);
        break;
    case FORCE_DEATH:
        events_player_die(b, p);
        break;
    case FORCE_GRAZE:
        if (bullet)
            board_event(b, EV_GRAZE, player, bullet);
        break;
    case FORCE_BOMB:
        api_bomb_afford(L, b, p);
        api_bomb_start(L, b, p);
        break;
    case FORCE_EXTEND:
        board_event(b, EV_EXTEND, player, 0);
        break;
    case FORCE_TAKE:
        take(b, p, player);
        break;
    case FORCE_SAFE:
        b->player.safe[p] = SAFE;
        break;
    case FORCE_DAMAGE:
        damage(L, b, p);
        break;
    }
    return 0;
}

bool force_in_game(const struct board *b, int player)
{
    return b->player.in[player] != 0;
}

bool force_run(struct board *b, const struct force *force)
{
    struct output *o = b->output;

    if (!force_in_game(b, force->player))
        return true;
    o->force = force;
    const bool fine = api_between(b, run, WORK_LIMIT);
    o->force = NULL;
    if (!fine)
        o->out.fault = &o->fault;
    return fine;
}
