/*
 * force.c - see force.h. Each kind raises the event that collisions or the player would have raised; events_run.c
 * handles the rest.
 */
#include "force.h"
#include "api/api.h"
#include "events_run.h"

enum {
    SAFE_FRAMES = 60 * 60, /* a minute */
    DAMAGE_HP = 5000       /* few enough that an enemy meant to be indestructible survives */
};

/* Returns the handle of a bullet that can be grazed or, if not `grazeable`, that can hit a player. Returns 0 if there
 * is none. */
static int64_t find_bullet(const struct board *b, bool grazeable)
{
    const struct bullets *s = &b->bullets;

    EACH_LIVE (i, &s->s) {
        const bool matches = grazeable ? b->bullet_kinds.flags[s->kind[i]] & KIND_GRAZE
                                       : b->bullet_kinds.shape[s->kind[i]] != SHAPE_NONE;
        if (matches && !(s->flags[i] & BULLET_DELAYED))
            return board_handle(b, H_BULLET, (int32_t)i);
    }
    return 0;
}

/* Returns the handle of a bullet or enemy that can hit players, or 0. */
static int64_t find_danger(const struct board *b)
{
    const int64_t bullet = find_bullet(b, false);

    if (bullet)
        return bullet;
    EACH_LIVE (i, &b->enemies.s)
        if (b->enemy_kinds.flags[b->enemies.kind[i]] & ENEMY_TOUCH && !(b->enemies.flags[i] & ENEMY_DYING))
            return board_handle(b, H_ENEMY, (int32_t)i);
    return 0;
}

static void hit_player(struct board *b, uint32_t p, int64_t player_handle)
{
    const int64_t source = find_danger(b);

    b->player.safe_left[p] = 0;
    if (source)
        board_raise_event(b, EV_HIT, player_handle, source);
    else
        events_kill_player(b, p);
}

static void take_items(struct board *b, uint32_t p, int64_t player_handle)
{
    for (uint32_t k = 0; k < b->item_kinds.s.live; k++) {
        const int32_t i = items_spawn(&b->items, (uint16_t)k, b->player.x[p], b->player.y[p], b->core.clock);
        if (i != NO_SLOT)
            board_raise_event(b, EV_TAKE, player_handle, board_handle(b, H_ITEM, i));
    }
}

static int apply_force(lua_State *L)
{
    struct board *b = vm_board(L);
    const uint32_t p = (uint32_t)b->output->force->player;
    const int64_t player_handle = board_handle(b, H_PLAYER, (int32_t)p);
    const int64_t bullet = find_bullet(b, true);

    switch (b->output->force->kind) {
    case FORCE_HIT:
        hit_player(b, p, player_handle);
        break;
    case FORCE_DEATH:
        events_kill_player(b, p);
        break;
    case FORCE_GRAZE:
        if (bullet)
            board_raise_event(b, EV_GRAZE, player_handle, bullet);
        break;
    case FORCE_BOMB:
        api_bomb_ensure_stock(L, b, p);
        api_bomb_start(L, b, p);
        break;
    case FORCE_EXTEND:
        board_raise_event(b, EV_EXTEND, player_handle, 0);
        break;
    case FORCE_TAKE:
        take_items(b, p, player_handle);
        break;
    case FORCE_SAFE:
        b->player.safe_left[p] = SAFE_FRAMES;
        break;
    case FORCE_DAMAGE:
        EACH_LIVE (i, &b->enemies.s)
            events_hurt_enemy(b, L, i, DAMAGE_HP, p + 1);
        break;
    }
    return 0;
}

bool force_player_in_game(const struct board *b, int player)
{
    return b->player.in_game[player] != 0;
}

bool force_run(struct board *b, const struct force *force)
{
    struct output *o = b->output;

    if (!force_player_in_game(b, force->player))
        return true;
    o->force = force;
    const bool ok = api_run_between_frames(b, apply_force, WORK_LIMIT);
    o->force = NULL;
    if (!ok)
        o->out.fault = &o->fault;
    return ok;
}
