/*
 * machine.c - see machine.h: resolving handles, and functions that involve several parts.
 */
#include "machine.h"

#include <stdio.h>
#include <string.h>

struct targets board_players(const struct board *b)
{
    return (struct targets){ &b->player.s, b->player.x, b->player.y, b->player.in };
}

/* Stores the present position of an entity, for the motion of bullets or shots, or, with `before`, its position before
 * this frame's move. Enemies and players move before shots, and shots before bullets. For an entity of the pool that is
 * moving now, both are the position before the move: slots below `moved` have moved already. */
static bool where(const struct motion_world *w, int64_t around, uint32_t moved, bool before, fx *x, fx *y)
{
    const struct board *b = w->context;
    const enum handle_kind kind = handle_kind(around), moves = w->shots ? H_SHOT : H_BULLET;
    const struct bullets *s = kind == H_SHOT ? &b->shots : &b->bullets;
    const uint32_t i = handle_slot(around);

    if (!board_alive(b, around) || !board_where(b, around, x, y))
        return false;
    if (kind == moves ? i < moved : kind == H_SHOT && before) {
        *x -= s->vx[i];
        *y -= s->vy[i];
    } else if (before && kind == H_ENEMY) {
        *x = b->enemies.was_x[i];
        *y = b->enemies.was_y[i];
    } else if (before && kind == H_PLAYER) {
        *x = b->player.was_x[i];
        *y = b->player.was_y[i];
    } else if (before && kind == H_OPTION) {
        *x = b->options.was_x[i];
        *y = b->options.was_y[i];
    }
    return true;
}

struct motion_world board_world(const struct board *b, bool shots)
{
    struct motion_world w = { &b->motions,
                              &b->steps,
                              &b->bullet_kinds,
                              board_players(b),
                              b->core.clock,
                              shots,
                              where,
                              b,
                              { 0, 0, (fx)(b->cart.m.field_w * FX_ONE), (fx)(b->cart.m.field_h * FX_ONE) },
                              (b->vm.limit - b->vm.work) / MOTION_WORK,
                              emit_queue };

    if (shots) {
        w.kinds = NULL;
        w.targets = (struct targets){ &b->enemies.s, b->enemies.x, b->enemies.y, NULL };
    }
    return w;
}

/* The capacity (event_room) covers every event that a frame can raise on its own. Only scripts can overfill the list,
 * hence FAULT_SCRIPT. */
void board_event(struct board *b, enum event_kind kind, int64_t a, int64_t b2)
{
    if (!events_push(&b->events, kind, a, b2))
        board_fault(b, FAULT_SCRIPT, "too many events in one frame (at most %d)", (int)b->events.cap);
}

uint64_t board_chance(void *board, uint64_t below)
{
    struct board *b = board;
    struct rng r;

    memcpy(r.s, b->core.random, sizeof r.s);
    uint64_t v = below ? rng_below(&r, below) : rng_next(&r);
    memcpy(b->core.random, r.s, sizeof r.s);
    b->core.drawn++;
    return v;
}

/* Copies a string, cut to fit. Replaces every byte that is not printable ASCII by '?', because demos and the cabinet's
 * font support only printable ASCII. */
static void copy_plain(char *to, size_t size, const char *from)
{
    snprintf(to, size, "%s", from);
    for (; *to; to++)
        if (*to < 32 || *to > 126)
            *to = '?';
}

void board_add_marker(struct board *b, enum board_marker_kind kind, const char *name, const char *of, const char *title,
                      int32_t value)
{
    struct board_out *out = &b->output->out;

    if (out->markers == BOARD_MARKERS)
        return;
    struct board_marker *m = &out->marker[out->markers++];
    m->kind = kind;
    m->value = value;
    copy_plain(m->name, sizeof m->name, name);
    copy_plain(m->of, sizeof m->of, of);
    copy_plain(m->title, sizeof m->title, title);
}

bool board_lists(const struct board *b)
{
    return strcmp(b->start.practice.section, PRACTICE_LIST) == 0;
}

void board_score(struct board *b, uint32_t i, int64_t points)
{
    const struct manifest *m = &b->cart.m;
    int64_t *score = &b->player.score[i];
    const int64_t most = 999999999999;

    if (!b->player.in[i])
        return;

    *score = points > most - *score ? most : *score + points < 0 ? 0 : *score + points;
    while (b->core.extended[i] < (uint32_t)m->n_extends && *score >= m->extends[b->core.extended[i]]) {
        b->core.extended[i]++;
        b->player.lives[i]++;
        board_event(b, EV_EXTEND, board_handle(b, H_PLAYER, (int32_t)i), 0);
    }
}

void board_vanish(struct board *b, uint32_t i)
{
    const struct bullets *s = &b->bullets;
    uint16_t spark = b->bullet_kinds.vanish[bullets_kind(s, &b->bullet_kinds, i)];

    if (spark)
        board_sparks(b, &(struct spark_burst){ .x = s->x[i], .y = s->y[i], .kind = (uint16_t)(spark - 1), .n = 1 });
}

static const struct slots *pool(const struct board *b, enum handle_kind kind)
{
    switch (kind) {
    case H_BULLET:
        return &b->bullets.s;
    case H_SHOT:
        return &b->shots.s;
    case H_ENEMY:
        return &b->enemies.s;
    case H_SPRITE:
        return &b->sprites.s;
    case H_ITEM:
        return &b->items.s;
    case H_LASER:
        return &b->lasers.s;
    case H_TASK:
        return &b->tasks.s;
    case H_LINE:
        return &b->lines.s;
    case H_OPTION:
        return &b->options.s;
    case H_BULLETML:
        return &b->ml_roots.s;
    default:
        return NULL;
    }
}

int64_t board_handle(const struct board *b, enum handle_kind kind, int32_t slot)
{
    const struct slots *s = pool(b, kind);

    if (slot == NO_SLOT)
        return handle_of(kind, 0, 0);
    if (kind == H_PLAYER)
        return handle_of(kind, b->player.gen[slot], (uint32_t)slot);
    return handle_of(kind, s ? s->gen[slot] : 1, (uint32_t)slot);
}

bool board_alive(const struct board *b, int64_t h)
{
    enum handle_kind kind = handle_kind(h);
    uint32_t slot = handle_slot(h), gen = handle_gen(h);
    const struct slots *s = pool(b, kind);

    if (kind == H_PLAYER)
        return slot < PADS && b->player.in[slot] && b->player.gen[slot] == gen;
    if (kind == H_TASK)
        return tasks_alive(b, slot, gen);
    if (kind == H_LAYER || kind == H_PLANE)
        return gen == 1 && slot < b->bg.s.live && (slot == BG_PLANE) == (kind == H_PLANE);
    if (kind == H_BULLETML && slots_has(s, slot, gen))
        return !(b->ml_roots.flags[slot] & ROOT_OVER);
    if (kind == H_ENEMY && slots_has(s, slot, gen))
        return !(b->enemies.flags[slot] & ENEMY_GONE);
    return s ? slots_has(s, slot, gen) : gen != 0;
}

bool board_there(const struct board *b, int64_t h)
{
    enum handle_kind kind = handle_kind(h);

    if (kind == H_ENEMY)
        return slots_has(&b->enemies.s, handle_slot(h), handle_gen(h));
    if ((kind == H_BULLET || kind == H_SHOT || kind == H_ITEM) &&
        slots_has_held(pool(b, kind), handle_slot(h), handle_gen(h)))
        return true;
    return board_alive(b, h);
}

int64_t board_followed(const struct board *b, uint32_t i)
{
    int follow = (b->sprites.flags[i] & SPRITE_FOLLOW) / SPRITE_FOLLOW_ONE;

    if (follow <= FOLLOW_OWNER)
        return follow ? b->sprites.owner[i] : 0;
    return board_handle(b, H_PLAYER, follow - FOLLOW_PLAYER);
}

uint8_t board_player_of(const struct board *b, int64_t h)
{
    const enum handle_kind kind = handle_kind(h);

    if ((kind != H_PLAYER && kind != H_OPTION) || !board_alive(b, h))
        return 0;
    return (uint8_t)(1 + (kind == H_PLAYER ? handle_slot(h) : b->options.player[handle_slot(h)]));
}

/* Stores the position of sprite i. If the entity it follows no longer exists, the position is relative to (0, 0). */
static void sprite_where(const struct board *b, uint32_t i, fx *x, fx *y)
{
    int64_t followed = board_followed(b, i);

    *x = *y = 0;
    if (followed)
        board_where(b, followed, x, y);
    *x = fx_add(*x, b->sprites.x[i]);
    *y = fx_add(*y, b->sprites.y[i]);
}

bool board_where(const struct board *b, int64_t h, fx *x, fx *y)
{
    uint32_t i = handle_slot(h);

    if (!board_there(b, h))
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
        return sprite_where(b, i, x, y), true;
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
