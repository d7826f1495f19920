/*
 * events_run.c - see events_run.h.
 *
 * The Lua registry holds the handlers: a list of functions for each event that has any, and one table of properties:
 * functions, drop lists, parts and pictures. The keys of the properties of kinds are e.g. "on_hit 3" (enemy kind 3),
 * "bullet's on_death 3" (bullet kind 3), "on_meet 3" (tag pair 3), "document's on_fire 3" (running BulletML document 3)
 * and "ship's run 3" (kind of ship 3). The keys of a single enemy's properties are slot + 1 (on_death) and -slot - 1
 * (drops). Spawning an enemy sets both entries of its slot, so no entry of the slot's previous enemy is left. The entry
 * of a document that ended is left until a document with on_fire starts in its slot; nothing reads it, because only a
 * document with on_fire (ROOT_HAS_HANDLER) raises EV_FIRED. A handler may raise further events; they are applied in the
 * same frame, after all events raised earlier.
 */
#include "events_run.h"
#include <string.h>
#include "../base/int.h"
#include "../entities/sparks.h"
#include "api/api.h"
#include "../machine/collision/hit.h"
#include "../machine/lasers_run.h"
#include "../machine/sound.h"
#include "../machine/window.h"

/* The names in on.NAME: the first eleven in the order of enum event_kind, with NULL for EV_SHOT, which has no
 * handlers; then the events that only scripts raise. */
static const char *const event_names[] = { "graze",  "hit",  NULL,   "death",    "game_over", "kill",  "leave",
                                           "extend", "take", "bomb", "continue", "phase",     "stage", "start" };

static const char handlers_key = 0, properties_key = 0, emitted_arguments_key = 0;

/* Returns the number of the event of that name, or -1. */
static int find_event(const char *name)
{
    for (size_t k = 0; k < sizeof event_names / sizeof *event_names; k++)
        if (event_names[k] && !strcmp(event_names[k], name))
            return (int)k;
    return -1;
}

void events_add_handler(lua_State *L, const char *name)
{
    const int kind = find_event(name);

    vm_push_registry_table(L, &handlers_key);
    if (lua_rawgeti(L, -1, kind) == LUA_TNIL) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_rawseti(L, -3, kind);
    }
    lua_pushvalue(L, -3);
    lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
    lua_pop(L, 3);
}

bool events_emit(struct board *b, lua_State *L, const char *name, int n)
{
    int kind = find_event(name);

    if (kind < 0)
        return false;
    lua_createtable(L, n, 0);
    lua_insert(L, -n - 1);
    for (int i = n; i >= 1; i--)
        lua_rawseti(L, -i - 1, i);
    vm_push_registry_table(L, &emitted_arguments_key);
    lua_insert(L, -2);
    lua_Integer at = (lua_Integer)lua_rawlen(L, -2) + 1;
    lua_rawseti(L, -2, at);
    lua_pop(L, 1);
    board_raise_event(b, EV_SCRIPT, at, (int64_t)kind << 8 | n);
    return true;
}

enum { EVENT_WORK = 30, HANDLER_WORK = 10 /* work per event and per handler call, excluding the handler's own work */ };

static void charge(struct board *b, uint64_t work)
{
    if (!board_charge_work(b, work))
        board_raise_overload(
            b, "events: too many handler calls in one frame (%u events); raise fewer events or declare fewer handlers",
            b->events.n);
}

/* Calls every handler of an event with the n arguments on top of the stack (popped). */
static void call_handlers(struct board *b, lua_State *L, int kind, int n)
{
    int first = lua_gettop(L) - n + 1;

    luaL_checkstack(L, n + 4, NULL);
    vm_push_registry_table(L, &handlers_key);
    lua_Integer handler_count = lua_rawgeti(L, -1, kind) == LUA_TTABLE ? (lua_Integer)lua_rawlen(L, -1) : 0;
    for (lua_Integer h = 1; h <= handler_count; h++) {
        charge(b, HANDLER_WORK);
        lua_rawgeti(L, -1, h);
        for (int i = 0; i < n; i++)
            lua_pushvalue(L, first + i);
        lua_call(L, n, 0);
    }
    lua_settop(L, first - 1);
}

static void call_event_handlers(struct board *b, lua_State *L, const struct event *e)
{
    api_push_handle(L, e->a);
    api_push_handle(L, e->b);
    call_handlers(b, L, (int)e->kind, 2);
}

void events_set_property(lua_State *L, uint16_t kind, const char *property)
{
    vm_push_registry_table(L, &properties_key);
    lua_pushfstring(L, "%s %d", property, (int)kind);
    lua_pushvalue(L, -3);
    lua_rawset(L, -3);
    lua_pop(L, 2);
}

void events_set_enemy_property(lua_State *L, uint32_t slot, enum enemy_property property)
{
    vm_push_registry_table(L, &properties_key);
    lua_insert(L, -2);
    lua_rawseti(L, -2, property * ((lua_Integer)slot + 1));
    lua_pop(L, 1);
}

static void push_enemy_property(lua_State *L, uint32_t slot, enum enemy_property property)
{
    vm_push_registry_table(L, &properties_key);
    lua_rawgeti(L, -1, property * ((lua_Integer)slot + 1));
    lua_remove(L, -2);
}

void events_push_property(lua_State *L, uint16_t kind, const char *property)
{
    vm_push_registry_table(L, &properties_key);
    lua_pushfstring(L, "%s %d", property, (int)kind);
    lua_rawget(L, -2);
    lua_remove(L, -2);
}

bool events_push_function(lua_State *L, uint16_t kind, const char *property)
{
    events_push_property(L, kind, property);
    if (lua_isfunction(L, -1))
        return true;
    lua_pop(L, 1);
    return false;
}

static int64_t player_handle(const struct board *b, uint32_t player)
{
    return player ? board_handle(b, H_PLAYER, (int32_t)player - 1) : 0;
}

/* Calls a kind's function, if it has one, with two handles (0: nil). */
static void call_kind_function(lua_State *L, uint16_t kind, const char *property, int64_t first, int64_t second)
{
    if (!events_push_function(L, kind, property))
        return;
    api_push_handle(L, first);
    api_push_handle(L, second);
    lua_call(L, 2, 0);
}

/* Drops items at (x, y) as listed by the value on top of the stack (popped); does nothing if that is not a drop
 * list. */
static void drop_items(lua_State *L, struct board *b, fx x, fx y)
{
    if (lua_type(L, -1) == LUA_TSTRING)
        api_drop_items(L, b, x, y);
    else
        lua_pop(L, 1);
}

/* Drops the items of the enemy's own drop list or, if it has none, of its kind's. */
static void drop_enemy_items(lua_State *L, struct board *b, uint32_t i)
{
    push_enemy_property(L, i, ENEMY_DROPS);
    if (lua_type(L, -1) != LUA_TSTRING) {
        lua_pop(L, 1);
        events_push_property(L, b->enemies.kind[i], "drops");
    }
    drop_items(L, b, b->enemies.x[i], b->enemies.y[i]);
}

/* Pushes the enemy's own on_death or, if it has none, its kind's. Returns false, with nothing pushed, if neither
 * exists. */
static bool push_on_death(lua_State *L, uint32_t slot, uint16_t kind)
{
    push_enemy_property(L, slot, ENEMY_ON_DEATH);
    if (lua_isfunction(L, -1))
        return true;
    lua_pop(L, 1);
    return events_push_function(L, kind, "on_death");
}

/* Emits the sparks of a death. spark: spark kind + 1; 0: none. */
static void emit_death_sparks(struct board *b, uint16_t spark, fx x, fx y)
{
    if (spark)
        board_burst_sparks(
            b, &(struct spark_burst){
                   .x = x, .y = y, .speed = 2 << 16, .spread = UINT32_MAX, .kind = (uint16_t)(spark - 1), .n = 12 });
}

/* Calls the function below the n arguments on top of the stack (all popped) as a handler of enemy i, in the enemy's
 * scene. */
static void call_enemy_handler(struct board *b, lua_State *L, uint32_t i, int n)
{
    struct tasks_context saved = tasks_enter_scene(b, b->enemies.owner[i]);

    lua_call(L, n, 0);
    tasks_set_context(b, saved);
}

/* Removes the parts of an enemy that died and emits their sparks, in slot order. A part that has parts is removed after
 * them. */
static void remove_parts(struct board *b, uint32_t body)
{
    struct enemies *e = &b->enemies;

    if (!e->n_parts || !e->n_parts[body])
        return;
    EACH_LIVE (i, &e->s) {
        if (e->body[i] != body + 1 || e->flags[i] & ENEMY_DYING)
            continue;
        remove_parts(b, i);
        emit_death_sparks(b, b->enemy_kinds.spark[e->kind[i]], e->x[i], e->y[i]);
        enemies_drop(e, i);
    }
}

void events_kill_enemy(struct board *b, lua_State *L, uint32_t i, uint32_t player)
{
    uint16_t kind = b->enemies.kind[i];
    int64_t h = board_handle(b, H_ENEMY, (int32_t)i), p = player_handle(b, player);

    if (b->enemies.flags[i] & ENEMY_DYING)
        return;
    b->enemies.flags[i] |= ENEMY_DYING;
    if (player)
        board_add_score(b, player - 1, b->enemy_kinds.score[kind]);
    emit_death_sparks(b, b->enemy_kinds.spark[kind], b->enemies.x[i], b->enemies.y[i]);
    board_raise_event(b, EV_KILL, h, p);
    sound_play_cue(b, CUE_KILL, b->enemies.x[i]);
    b->enemies.hp[i] = 0;
    if (b->items.s.cap)
        drop_enemy_items(L, b, i);
    if (push_on_death(L, i, kind)) { /* on_death can still read the enemy's position */
        api_push_handle(L, h);
        api_push_handle(L, p);
        call_enemy_handler(b, L, i, 2);
    }
    if (board_is_readable(b, h))
        remove_parts(b, i);
}

/* Returns whether an event about entity h still takes effect, i.e. whether h has not been removed or killed since the
 * event was raised. */
static bool still_exists(const struct board *b, int64_t h)
{
    if (!board_is_readable(b, h))
        return false;
    return handle_kind(h) != H_ENEMY || !(b->enemies.flags[handle_slot(h)] & ENEMY_DYING);
}

/* Takes `amount`, in 2^-32 hp, from one enemy. Sets *body to the handle of the enemy's body, or 0 if it has none, and
 * returns the share of the amount that is passed on to the body. */
static uint64_t hurt_one_enemy(struct board *b, lua_State *L, uint32_t i, uint64_t amount, uint32_t player,
                               int64_t *body)
{
    struct enemies *e = &b->enemies;

    *body = e->body[i] ? board_handle(b, H_ENEMY, e->body[i] - 1) : 0;
    if (e->safe_left[i] || !enemies_scale_damage(amount, e->rate[i]))
        return 0;
    const uint64_t passed_on = enemies_scale_damage(enemies_damage(e, i, amount), e->damage_share[i]);
    enemies_blink(e, &b->enemy_kinds, i);
    if (!e->hp[i] && !(e->flags[i] & ENEMY_UNDYING))
        events_kill_enemy(b, L, i, player);
    return passed_on;
}

bool events_hurt_enemy(struct board *b, lua_State *L, uint32_t i, int32_t n, uint32_t player)
{
    struct enemies *e = &b->enemies;

    if (e->safe_left[i] || n <= 0 || e->flags[i] & ENEMY_DYING)
        return false;
    if (e->rate) { /* an enemy may be a part and pass damage on to its body, which a handler may remove first */
        const int64_t first = board_handle(b, H_ENEMY, (int32_t)i);
        uint64_t amount = (uint64_t)n << 32;
        for (int64_t h = first, body; amount && still_exists(b, h); h = body)
            amount = hurt_one_enemy(b, L, handle_slot(h), amount, player, &body);
        return !still_exists(b, first);
    }
    e->hp[i] = n >= e->hp[i] ? 0 : e->hp[i] - n;
    enemies_blink(e, &b->enemy_kinds, i);
    if (e->hp[i] || e->flags[i] & ENEMY_UNDYING)
        return false;
    events_kill_enemy(b, L, i, player);
    return true;
}

/* Applies the damage of a shot or laser to enemy i. If the enemy survives, calls its kind's on_hit. */
static void hit_enemy(struct board *b, lua_State *L, uint32_t i, int32_t damage, uint32_t player)
{
    if (events_hurt_enemy(b, L, i, damage, player) || !events_push_function(L, b->enemies.kind[i], "on_hit"))
        return;
    api_push_handle(L, board_handle(b, H_ENEMY, (int32_t)i));
    api_push_handle(L, player_handle(b, player));
    lua_pushinteger(L, damage);
    call_enemy_handler(b, L, i, 3);
}

/* Removes a bullet or shot that is live or held. */
static void remove_bullet(struct board *b, struct bullets *s, int64_t h)
{
    if (board_is_alive(b, h))
        bullets_drop(s, handle_slot(h));
    else
        bullets_release(s, handle_slot(h));
}

/* Uses up shot h, which hit `entity`, unless the shot pierces it. */
static void use_up_shot(struct board *b, int64_t h, int64_t entity)
{
    if (!bullets_pierce(&b->shots, &b->shot_kinds, handle_slot(h), entity, b->core.clock))
        remove_bullet(b, &b->shots, h);
}

/* Destroys bullet h, whose hp reached 0. on_death can still read the bullet, which is no longer alive. */
static void destroy_bullet(struct board *b, lua_State *L, int64_t h, uint32_t player)
{
    const struct bullet_kinds *k = &b->bullet_kinds;
    uint32_t i = handle_slot(h);
    uint16_t kind = b->bullets.kind[i];

    if (board_is_alive(b, h))
        bullets_hold(&b->bullets, i);
    if (player)
        board_add_score(b, player - 1, k->score[kind]);
    emit_death_sparks(b, k->spark[kind], b->bullets.x[i], b->bullets.y[i]);
    if (b->items.s.cap) {
        events_push_property(L, kind, "bullet's drops");
        drop_items(L, b, b->bullets.x[i], b->bullets.y[i]);
    }
    call_kind_function(L, kind, "bullet's on_death", h, player_handle(b, player));
    if (board_is_readable(b, h))
        bullets_release(&b->bullets, i);
}

/* Applies a shot's hit on a bullet: damages a bullet that has hp; cancels one that has none. Earlier events of the
 * frame may have changed the bullet. */
static void hit_bullet(struct board *b, lua_State *L, const struct event *e)
{
    const struct bullets *s = &b->bullets;
    uint32_t shot = handle_slot(e->a), i = handle_slot(e->b), player = b->shots.player[shot];
    int32_t damage = b->shot_kinds.damage[b->shots.kind[shot]];
    bool cancels = b->shot_kinds.flags[b->shots.kind[shot]] & KIND_CANCELS;

    if (s->hp && s->hp[i]) {
        if (s->hp[i] == HP_FOREVER) {
            remove_bullet(b, &b->shots, e->a);
            return;
        }
        use_up_shot(b, e->a, e->b);
        s->hp[i] = damage >= s->hp[i] ? 0 : s->hp[i] - damage;
        if (s->hp[i] == 0)
            destroy_bullet(b, L, e->b, player);
    } else if (cancels && !(b->bullet_kinds.flags[s->kind[i]] & KIND_FIXED)) {
        use_up_shot(b, e->a, e->b);
        board_spawn_vanish_spark(b, i);
        remove_bullet(b, &b->bullets, e->b);
    }
}

/* Applies a shot's hit. An enemy that still exists uses up the shot even if the enemy is safe. */
static void apply_shot(struct board *b, lua_State *L, const struct event *e)
{
    if (!still_exists(b, e->a) || !still_exists(b, e->b))
        return;
    if (handle_kind(e->b) == H_BULLET) {
        hit_bullet(b, L, e);
        return;
    }
    uint32_t shot = handle_slot(e->a);
    int32_t damage = b->shot_kinds.damage[b->shots.kind[shot]];
    uint32_t player = b->shots.player[shot];
    use_up_shot(b, e->a, e->b);
    hit_enemy(b, L, handle_slot(e->b), damage, player);
}

/* Hurts all enemies that a player's laser touches, in slot order. A handler may move or remove the laser or any of the
 * enemies. */
static void apply_laser(struct board *b, lua_State *L, const struct event *e)
{
    const uint32_t i = handle_slot(e->a);

    if (!board_is_alive(b, e->a))
        return;
    const uint16_t kind = b->laser_heads.kind[i];
    const int32_t damage = b->laser_kinds.damage[kind];
    b->lasers.rehit_clock[i * MAX_PLAYERS] = b->core.clock + b->laser_kinds.hit_interval[kind];
    EACH_LIVE (k, &b->enemies.s) {
        if (!board_is_alive(b, e->a))
            return;
        if (b->enemies.flags[k] & ENEMY_DYING)
            continue;
        hit_charge_laser(b, i, k);
        if (!hit_laser_touches_enemy(b, i, k))
            continue;
        b->counts.hit++;
        hit_enemy(b, L, k, damage, b->laser_heads.player[i]);
    }
}

/* Removes a blocked bullet, unless a shot of this frame killed its blocker. */
static void apply_block(struct board *b, lua_State *L, const struct event *e)
{
    (void)L;
    if (still_exists(b, e->a) && still_exists(b, e->b))
        bullets_drop(&b->bullets, handle_slot(e->a));
}

/* Removes bullet h of a pair that met, and emits the pair's spark or, if it has none, the bullet kind's. Does nothing
 * if the bullet no longer exists, or if its kind is immune to clearing and the pair does not clear all. */
static void remove_met_bullet(struct board *b, uint32_t pair, int64_t h)
{
    const struct bullets *s = &b->bullets;
    uint32_t i = handle_slot(h);

    if (!still_exists(b, h))
        return;
    if (b->bullet_kinds.flags[s->kind[i]] & KIND_FIXED && !(s->meet_flags[pair] & MEET_ALL))
        return;
    if (s->meet_spark[pair])
        board_burst_sparks(b, &(struct spark_burst){
                                  .x = s->x[i], .y = s->y[i], .kind = (uint16_t)(s->meet_spark[pair] - 1), .n = 1 });
    else
        board_spawn_vanish_spark(b, i);
    remove_bullet(b, &b->bullets, h);
}

/* Applies the meeting of two bullets, if both still exist: calls the pair's handler, then removes the bullets that the
 * pair is declared to remove. */
static void apply_meet(struct board *b, lua_State *L, const struct event *e)
{
    uint8_t flags = b->bullets.meet_flags[e->pair];

    if (!(still_exists(b, e->a) && still_exists(b, e->b)))
        return;
    call_kind_function(L, (uint16_t)e->pair, "on_meet", e->a, e->b);
    if (flags & MEET_FIRST)
        remove_met_bullet(b, e->pair, e->a);
    if (flags & MEET_SECOND)
        remove_met_bullet(b, e->pair, e->b);
}

static void apply_graze(struct board *b, lua_State *L, const struct event *e)
{
    uint32_t p = handle_slot(e->a), i = handle_slot(e->b);

    if (!still_exists(b, e->b) || !board_is_alive(b, e->a))
        return;
    if (handle_kind(e->b) == H_LASER)
        b->lasers.rehit_clock[i * MAX_PLAYERS + p] =
            b->core.clock + b->laser_kinds.graze_interval[b->laser_heads.kind[i]];
    else
        b->bullets.flags[i] |= (uint8_t)(BULLET_GRAZED << p);
    b->player.grazes[p]++;
    sound_play_cue(b, CUE_GRAZE, b->player.x[p]);
    call_event_handlers(b, L, e);
}

/* Returns whether the register named by the item kind's `full` is at its maximum; the item then gives only points. The
 * name is looked up among the ship's registers, then among the run's. */
static bool is_register_full(lua_State *L, const struct board *b, uint32_t p, uint16_t kind)
{
    const char *name = board_name(b, N_ITEM_REGISTER, (int)b->item_kinds.full_register[kind] - 1);
    int reg = name ? api_find_player_register(L, b, p, name) : -1;

    if (reg >= 0)
        return registers_is_full(&b->registers, board_register_row(b, p, (uint32_t)reg), p);
    reg = name ? api_find_run_register(L, name) : -1;
    return reg >= 0 && board_run_register_is_full(b, (uint32_t)reg);
}

/* Adds the item kind's amounts to the registers that it names: the ship's or, if the ship has no such register, the
 * run's. */
static void give_registers(lua_State *L, struct board *b, uint32_t p, uint16_t kind)
{
    for (int k = 0; k < ITEM_MAX_REGISTERS; k++) {
        const int32_t n = b->item_kinds.register_amounts[kind * ITEM_MAX_REGISTERS + k];
        const char *name = n ? board_name(b, N_ITEM_REGISTER, k) : NULL;
        int reg = n ? api_find_player_register(L, b, p, name) : -1;
        if (reg >= 0)
            board_set_register(b, p, (uint32_t)reg, (int64_t)board_get_register(b, p, (uint32_t)reg) + n);
        else if (n && (reg = api_find_run_register(L, name)) >= 0)
            board_set_run_register(b, (uint32_t)reg, (int64_t)board_get_run_register(b, (uint32_t)reg) + n);
    }
}

int64_t events_item_points(const struct board *b, uint32_t p, uint16_t kind)
{
    const fx line = b->player_kinds.collect_line[b->player.kind[p]];

    return items_points(&b->item_kinds, kind, b->player.y[p], line == FX_MIN ? 0 : line,
                        (fx)(b->cart.manifest.field_h << 16));
}

static void give_item(lua_State *L, struct board *b, uint32_t p, uint16_t kind)
{
    const bool full = is_register_full(L, b, p, kind);

    board_add_score(b, p, events_item_points(b, p, kind));
    if (full)
        return;
    give_registers(L, b, p, kind);
    if (!b->item_kinds.lives[kind])
        return;
    b->player.lives[p] = (int32_t)int64_min((int64_t)b->player.lives[p] + b->item_kinds.lives[kind], MAX_LIVES);
    board_raise_event(b, EV_EXTEND, board_handle(b, H_PLAYER, (int32_t)p), 0);
}

/* Applies the taking of an item. Handlers can still read the item, which is no longer alive. A player who was hit in
 * this frame still takes the item, because EV_DEATH is applied after EV_TAKE. */
static void apply_take(struct board *b, lua_State *L, const struct event *e)
{
    const uint32_t p = handle_slot(e->a), i = handle_slot(e->b);

    if (!board_is_alive(b, e->a) || !board_is_alive(b, e->b))
        return;
    slots_hold(&b->items.s, b->items.collected, i);
    give_item(L, b, p, b->items.kind[i]);
    sound_play_cue(b, CUE_ITEM, b->player.x[p]);
    call_kind_function(L, b->items.kind[i], "item's on_take", e->a, e->b);
    call_event_handlers(b, L, e);
    if (board_is_readable(b, e->b))
        slots_release(&b->items.s, i);
}

void events_check_game_over(struct board *b)
{
    for (int p = 0; p < MAX_PLAYERS; p++)
        if (b->player.in_game[p] || b->core.continues_left[p])
            return;
    if (b->core.game_over)
        return;
    b->core.game_over = 1;
    board_raise_event(b, EV_GAME_OVER, 0, 0);
}

void events_get_start_position(const struct board *b, uint32_t p, fx *x, fx *y)
{
    const struct window view = window_of(b);
    const int w = manifest_view_w(&b->cart.manifest), h = manifest_view_h(&b->cart.manifest);
    bool is_two_player = b->player.in_game[0] && b->player.in_game[1];

    *x = fx_int(view.left) + (w << 15) + (is_two_player ? (p ? 1 : -1) * (w << 13) : 0);
    *y = fx_int(view.top + h) - (h << 16) / 8;
}

void events_kill_player(struct board *b, uint32_t p)
{
    board_raise_event(b, EV_DEATH, board_handle(b, H_PLAYER, (int32_t)p), 0);
    board_add_marker(b, MARKER_DEATH, p ? "2" : "1", "", "", 0);
    b->player.safe_left[p] = b->player_kinds.safe_frames[b->player.kind[p]];
    if (b->player.safe_left[p] == 0)
        b->player.safe_left[p] = 1;
    b->player.lives[p]--;
}

/* Fades the beams that player p is firing. */
static void fade_beams(struct board *b, uint32_t p)
{
    const struct bullets *h = &b->laser_heads;

    EACH_LIVE (i, &b->lasers.s)
        if (h->player[i] == p + 1 && b->lasers.form[i] == LASER_BEAM &&
            b->laser_kinds.flags[h->kind[i]] & LASER_HITS_ENEMIES)
            lasers_fade(&b->lasers, i, lasers_age(b, i));
}

static void apply_hit(struct board *b, lua_State *L, const struct event *e)
{
    uint32_t p = handle_slot(e->a);

    if (b->start.practice.invincible) /* checked here, not through `safe`, which scripts read and write */
        return;
    /* An earlier handler may have removed the entity that hit the player. */
    if (!board_is_alive(b, e->a) || b->player.safe_left[p] || b->player.deathbomb_left[p] || !still_exists(b, e->b))
        return;
    call_event_handlers(b, L, e);
    if (!board_is_alive(b, e->a) || b->player.safe_left[p]) /* a handler may have saved the player */
        return;
    sound_play_cue(b, CUE_HIT, b->player.x[p]);
    fade_beams(b, p);
    b->player.deathbomb_left[p] = b->player_kinds.deathbomb_frames[b->player.kind[p]];
    if (!b->player.deathbomb_left[p])
        events_kill_player(b, p);
}

/* The handlers of on.death see the player where it died; then the player respawns or leaves the game. */
static void apply_death(struct board *b, lua_State *L, const struct event *e)
{
    uint32_t p = handle_slot(e->a);
    fx x, y;

    call_event_handlers(b, L, e);
    items_release(&b->items, p);
    if (!board_is_alive(b, e->a))
        return;
    if (b->player.lives[p] >= 0) {
        events_get_start_position(b, p, &x, &y);
        player_set_position(&b->player, p, x, y);
        return;
    }
    b->player.lives[p] = 0;
    player_leave(&b->player, p);
    options_drop_from(&b->options, p, 0);
    events_check_game_over(b);
}

/* The handlers of on.kill and on.leave can still read the enemy, which is removed after they return. An enemy killed
 * while leaving raises no on.leave. */
static void apply_enemy_end(struct board *b, lua_State *L, const struct event *e)
{
    if (e->kind == EV_LEAVE && !still_exists(b, e->a))
        return;
    call_event_handlers(b, L, e);
    if (board_is_readable(b, e->a))
        enemies_drop(&b->enemies, handle_slot(e->a));
}

static void apply_script_event(struct board *b, lua_State *L, const struct event *e)
{
    int n = (int)(e->b & 255), kind = (int)(e->b >> 8);

    vm_push_registry_table(L, &emitted_arguments_key);
    lua_rawgeti(L, -1, e->a);
    int args = lua_gettop(L);
    for (int i = 1; i <= n; i++)
        lua_rawgeti(L, args, i);
    call_handlers(b, L, kind, n);
    lua_pushnil(L);
    lua_rawseti(L, args - 1, e->a);
    lua_settop(L, args - 2);
}

static void apply_bomb(struct board *b, lua_State *L, const struct event *e)
{
    api_push_handle(L, e->a);
    lua_pushboolean(L, e->b != 0);
    call_handlers(b, L, EV_BOMB, 2);
}

/* Calls on_fire of the document that fired the bullet, with the name of the bullet's label or nil. */
static void apply_fired(struct board *b, lua_State *L, const struct event *e)
{
    const uint32_t root = (uint32_t)(e->b >> 32), label = (uint32_t)e->b;
    struct ml ml;

    if (!board_is_alive(b, e->a))
        return;
    cart_bulletml(&b->cart, b->ml_roots.program[root], &ml);
    events_push_property(L, (uint16_t)root, "document's on_fire");
    lua_pushinteger(L, e->a);
    lua_pushstring(L, label ? ml_label(&ml, label - 1) : NULL);
    lua_call(L, 2, 0);
}

static void apply_extend(struct board *b, lua_State *L, const struct event *e)
{
    sound_play_cue(b, CUE_EXTEND, b->player.x[handle_slot(e->a)]);
    call_event_handlers(b, L, e);
}

static void (*const apply[])(struct board *b, lua_State *L, const struct event *e) = {
    [EV_GRAZE] = apply_graze,
    [EV_HIT] = apply_hit,
    [EV_SHOT] = apply_shot,
    [EV_DEATH] = apply_death,
    [EV_GAME_OVER] = call_event_handlers,
    [EV_KILL] = apply_enemy_end,
    [EV_LEAVE] = apply_enemy_end,
    [EV_EXTEND] = apply_extend,
    [EV_TAKE] = apply_take,
    [EV_BOMB] = apply_bomb,
    [EV_CONTINUE] = call_event_handlers,
    [EV_SCRIPT] = apply_script_event,
    [EV_BLOCK] = apply_block,
    [EV_LASER] = apply_laser,
    [EV_FIRED] = apply_fired,
    [EV_MEET] = apply_meet,
};

void events_call_start_handlers(lua_State *L, int64_t game)
{
    struct board *b = vm_board(L);
    const struct tasks_context saved = { b->tasks.current_owner, b->tasks.current_scene };
    const int32_t current = b->tasks.current;

    b->tasks.current = NO_SLOT; /* a handler cannot wait */
    tasks_set_context(b, (struct tasks_context){ game, 0 });
    call_handlers(b, L, EV_START, 0);
    tasks_set_context(b, saved);
    b->tasks.current = current;
}

int events_run(lua_State *L)
{
    struct board *b = vm_board(L);

    luaL_checkstack(L, 32, NULL);
    for (uint32_t i = 0; i < b->events.n; i++) {
        struct event e = events_at(&b->events, i);
        charge(b, EVENT_WORK);
        apply[e.kind](b, L, &e);
    }
    b->events.n = 0;
    bullets_release_all(&b->bullets); /* invariant: nothing is held between frames */
    bullets_release_all(&b->shots);
    if (b->lasers.s.live)
        lasers_end_frame(b);
    return 0;
}
