/*
 * machine.c - see machine.h: resolving handles, and functions that involve several parts.
 */
#include "machine.h"

#include <stdio.h>
#include <string.h>

/* Stores the present position of an entity, for the motion of bullets or shots, or, with `before_move`, its position
 * before this frame's move. Enemies and players move before shots, and shots before bullets. For an entity of the pool
 * that is moving now, both are the position before the move: slots below `moved` have moved already. */
static bool get_entity_position(const struct motion_world *w, int64_t entity, uint32_t moved, bool before_move, fx *x,
                                fx *y)
{
    const struct board *b = w->context;
    const enum handle_kind kind = handle_kind(entity), moving_kind = w->is_shots ? H_SHOT : H_BULLET;
    const struct bullets *s = kind == H_SHOT ? &b->shots : &b->bullets;
    const uint32_t i = handle_slot(entity);

    if (!board_is_alive(b, entity) || !board_get_position(b, entity, x, y))
        return false;
    if (kind == moving_kind ? i < moved : kind == H_SHOT && before_move) {
        *x -= s->vx[i];
        *y -= s->vy[i];
    } else if (before_move && kind == H_ENEMY) {
        *x = b->enemies.prev_x[i];
        *y = b->enemies.prev_y[i];
    } else if (before_move && kind == H_PLAYER) {
        *x = b->player.prev_x[i];
        *y = b->player.prev_y[i];
    } else if (before_move && kind == H_OPTION) {
        *x = b->options.prev_x[i];
        *y = b->options.prev_y[i];
    }
    return true;
}

struct motion_world board_motion_world(const struct board *b, bool for_shots)
{
    struct motion_world w = { &b->motions,
                              &b->steps,
                              &b->bullet_kinds,
                              board_targets(b, for_shots),
                              b->core.clock,
                              for_shots,
                              get_entity_position,
                              b,
                              { 0, 0, (fx)(b->cart.manifest.field_w * FX_ONE),
                                (fx)(b->cart.manifest.field_h * FX_ONE) },
                              (b->vm.limit - b->vm.work) / MOTION_WORK,
                              emit_queue };

    if (for_shots)
        w.kinds = NULL;
    return w;
}

/* The capacity (event_capacity) covers every event that a frame can raise on its own. Only scripts can overfill the
 * list, hence FAULT_SCRIPT. */
void board_raise_event(struct board *b, enum event_kind kind, int64_t a, int64_t b2)
{
    if (!events_push(&b->events, kind, a, b2))
        board_raise_fault(b, FAULT_SCRIPT, "too many events in one frame (at most %d)", (int)b->events.cap);
}

uint64_t board_random(void *board, uint64_t limit)
{
    struct board *b = board;
    struct rng r;

    memcpy(r.s, b->core.random, sizeof r.s);
    uint64_t v = limit ? rng_below(&r, limit) : rng_next(&r);
    memcpy(b->core.random, r.s, sizeof r.s);
    b->core.drawn++;
    return v;
}

/* Copies a title, cut to fit without cutting a character. Replaces control characters by '?'. */
static void copy_title(char *to, size_t size, const char *from)
{
    size_t n = strlen(from);

    for (n = n < size ? n : size - 1; n > 0 && ((uint8_t)from[n] & 0xc0) == 0x80;)
        n--;
    for (size_t i = 0; i < n; i++)
        to[i] = (uint8_t)from[i] < 32 || from[i] == 127 ? '?' : from[i];
    to[n] = 0;
}

/* Copies a string, cut to fit. Replaces every byte that is not printable ASCII by '?', because demos support only
 * printable ASCII. */
static void copy_printable(char *to, size_t size, const char *from)
{
    snprintf(to, size, "%s", from);
    for (; *to; to++)
        if (*to < 32 || *to > 126)
            *to = '?';
}

void board_add_marker(struct board *b, enum board_marker_kind kind, const char *name, const char *parent,
                      const char *title, int32_t value)
{
    struct board_out *out = &b->output->out;

    if (out->marker_count == MAX_TICK_MARKERS)
        return;
    struct board_marker *m = &out->marker[out->marker_count++];
    m->kind = kind;
    m->value = value;
    copy_printable(m->name, sizeof m->name, name);
    copy_printable(m->parent, sizeof m->parent, parent);
    copy_title(m->title, sizeof m->title, title);
}

void board_add_key_hint(struct board *b, int player, uint32_t button, const char *meaning)
{
    struct board_out *out = &b->output->out;

    if (out->key_hint_count == MAX_KEY_HINTS)
        return;
    struct board_key_hint *hint = &out->key_hint[out->key_hint_count++];
    hint->player = player;
    hint->button = button;
    copy_title(hint->meaning, sizeof hint->meaning, meaning);
}

bool board_is_listing(const struct board *b)
{
    return strcmp(b->start.practice.section, PRACTICE_LIST) == 0;
}

bool board_runs_through_stages(const struct board *b)
{
    return board_is_listing(b) || strchr(b->start.practice.section, '/');
}

void board_add_score(struct board *b, uint32_t i, int64_t points)
{
    const struct manifest *m = &b->cart.manifest;
    int64_t *score = &b->player.score[i];
    const int64_t max_score = 999999999999;

    if (!b->player.in_game[i])
        return;

    *score = points > max_score - *score ? max_score : *score + points < 0 ? 0 : *score + points;
    while (b->core.extends_received[i] < (uint32_t)m->n_extends && *score >= m->extends[b->core.extends_received[i]]) {
        b->core.extends_received[i]++;
        b->player.lives[i]++;
        board_raise_event(b, EV_EXTEND, board_handle(b, H_PLAYER, (int32_t)i), 0);
    }
}

void board_spawn_vanish_spark(struct board *b, uint32_t i)
{
    const struct bullets *s = &b->bullets;
    uint16_t spark = b->bullet_kinds.vanish_spark[bullets_kind(s, &b->bullet_kinds, i)];

    if (spark)
        board_burst_sparks(b,
                           &(struct spark_burst){ .x = s->x[i], .y = s->y[i], .kind = (uint16_t)(spark - 1), .n = 1 });
}

/* Returns the pool of the entities of this kind, or NULL if they have none. */
static const struct slots *pool_of(const struct board *b, enum handle_kind kind)
{
    static const size_t offsets[HANDLE_KINDS] = {
        [H_BULLET] = offsetof(struct board, bullets.s), [H_SHOT] = offsetof(struct board, shots.s),
        [H_ENEMY] = offsetof(struct board, enemies.s),  [H_SPRITE] = offsetof(struct board, sprites.s),
        [H_ITEM] = offsetof(struct board, items.s),     [H_LASER] = offsetof(struct board, lasers.s),
        [H_TASK] = offsetof(struct board, tasks.s),     [H_LINE] = offsetof(struct board, lines.s),
        [H_OPTION] = offsetof(struct board, options.s), [H_BULLETML] = offsetof(struct board, ml_roots.s),
    };

    if (kind >= HANDLE_KINDS || !offsets[kind])
        return NULL;
    return (const struct slots *)(const void *)((const uint8_t *)b + offsets[kind]);
}

int64_t board_handle(const struct board *b, enum handle_kind kind, int32_t slot)
{
    const struct slots *s = pool_of(b, kind);

    if (slot == NO_SLOT)
        return handle_make(kind, 0, 0);
    if (kind == H_PLAYER)
        return handle_make(kind, b->player.gen[slot], (uint32_t)slot);
    return handle_make(kind, s ? s->gen[slot] : 1, (uint32_t)slot);
}

bool board_is_alive(const struct board *b, int64_t h)
{
    enum handle_kind kind = handle_kind(h);
    uint32_t slot = handle_slot(h), gen = handle_gen(h);
    const struct slots *s = pool_of(b, kind);

    if (kind == H_PLAYER)
        return slot < MAX_PLAYERS && b->player.in_game[slot] && b->player.gen[slot] == gen;
    if (kind == H_TASK)
        return tasks_is_alive(b, slot, gen);
    if (kind == H_LAYER || kind == H_PLANE)
        return gen == 1 && slot < b->bg.s.live && (slot == BG_PLANE) == (kind == H_PLANE);
    if (kind == H_MOVE)
        return slot < b->enemies.s.top && slots_has(&b->enemies.s, slot, b->enemies.s.gen[slot]) &&
               !(b->enemies.flags[slot] & ENEMY_NOT_ALIVE) && enemies_is_moving(&b->enemies, slot, gen);
    if (kind == H_CAMERA)
        return gen == 1 && slot < b->camera.s.live;
    if (kind == H_BULLETML && slots_has(s, slot, gen))
        return !(b->ml_roots.flags[slot] & ROOT_DESPAWNED);
    if (kind == H_ENEMY && slots_has(s, slot, gen))
        return !(b->enemies.flags[slot] & ENEMY_NOT_ALIVE);
    return s ? slots_has(s, slot, gen) : gen != 0;
}

bool board_is_readable(const struct board *b, int64_t h)
{
    enum handle_kind kind = handle_kind(h);

    if (kind == H_ENEMY)
        return slots_has(&b->enemies.s, handle_slot(h), handle_gen(h));
    if ((kind == H_BULLET || kind == H_SHOT || kind == H_ITEM) &&
        slots_has_held(pool_of(b, kind), handle_slot(h), handle_gen(h)))
        return true;
    return board_is_alive(b, h);
}

int64_t board_sprite_follow_target(const struct board *b, uint32_t i)
{
    int follow = (b->sprites.flags[i] & SPRITE_FOLLOW) / SPRITE_FOLLOW_ONE;

    if (follow <= FOLLOW_OWNER)
        return follow ? b->sprites.owner[i] : 0;
    return board_handle(b, H_PLAYER, follow - FOLLOW_PLAYER);
}

uint8_t board_player_of(const struct board *b, int64_t h)
{
    const enum handle_kind kind = handle_kind(h);

    if ((kind != H_PLAYER && kind != H_OPTION) || !board_is_alive(b, h))
        return 0;
    return (uint8_t)(1 + (kind == H_PLAYER ? handle_slot(h) : b->options.player[handle_slot(h)]));
}

/* Stores the position of sprite i. If the entity it follows no longer exists, the position is relative to (0, 0). */
static void get_sprite_position(const struct board *b, uint32_t i, fx *x, fx *y)
{
    int64_t followed = board_sprite_follow_target(b, i);

    *x = *y = 0;
    if (followed)
        board_get_position(b, followed, x, y);
    *x = fx_add(*x, b->sprites.x[i]);
    *y = fx_add(*y, b->sprites.y[i]);
}

bool board_get_position(const struct board *b, int64_t h, fx *x, fx *y)
{
    uint32_t i = handle_slot(h);

    if (!board_is_readable(b, h))
        return false;
    switch (handle_kind(h)) {
    case H_BULLET:
        return *x = b->bullets.x[i], *y = b->bullets.y[i], true;
    case H_SHOT:
        return *x = b->shots.x[i], *y = b->shots.y[i], true;
    case H_ENEMY:
        return *x = b->enemies.x[i], *y = b->enemies.y[i], true;
    case H_PLAYER:
        return *x = b->player.x[i], *y = b->player.y[i], true;
    case H_SPRITE:
        return get_sprite_position(b, i, x, y), true;
    case H_ITEM:
        return *x = b->items.x[i], *y = b->items.y[i], true;
    case H_LASER:
        return *x = b->laser_heads.x[i], *y = b->laser_heads.y[i], true;
    case H_OPTION:
        return *x = b->options.x[i], *y = b->options.y[i], true;
    default:
        return false;
    }
}
