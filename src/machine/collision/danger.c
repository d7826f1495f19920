/*
 * danger.c - see danger.h. Skips the same entities as hit.c and hit_lasers.c.
 */
#include "danger.h"
#include "../lasers_run.h"
#include "hit_parts.h"

struct visitor {
    void (*visit)(void *context, const struct danger *d);
    void *context;
};

static uint16_t age_of(const struct board *b, uint32_t born)
{
    const uint32_t age = b->core.clock - born;

    return (uint16_t)(age < UINT16_MAX ? age : UINT16_MAX);
}

/* Calls v->visit for each piece of an entity. d: the members that all pieces share. */
static void visit_bodies(const struct visitor *v, struct danger d, const struct body *piece, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        if (piece[i].shape == SHAPE_NONE)
            continue;
        d.shape = piece[i].shape == SHAPE_BOX       ? DANGER_BOX
                  : piece[i].shape == SHAPE_CAPSULE ? DANGER_CAPSULE
                                                    : DANGER_CIRCLE;
        d.x = piece[i].x;
        d.y = piece[i].y;
        d.mx = piece[i].mx;
        d.my = piece[i].my;
        d.a = piece[i].a;
        d.b = piece[i].b;
        d.c = piece[i].c;
        v->visit(v->context, &d);
    }
}

static void visit_bullets(const struct board *b, const struct visitor *v)
{
    const struct bullets *s = &b->bullets;
    const struct bullet_kinds *k = &b->bullet_kinds;
    struct body piece[SHAPE_MAX_CIRCLES];

    EACH_LIVE (i, &s->s) {
        const unsigned flags = k->flags[s->kind[i]];
        if (s->flags[i] & BULLET_DELAYED || flags & KIND_HARMLESS)
            continue;
        const uint32_t n = hit_split_bullet(s, k, i, piece);
        visit_bodies(
            v,
            (struct danger){
                .source = DANGER_BULLET, .swept = flags & KIND_SWEPT, .age = age_of(b, s->born[i]), .slot = i },
            piece, n);
    }
}

static void visit_enemies(const struct board *b, const struct visitor *v)
{
    struct body piece[SHAPE_MAX_CIRCLES];

    EACH_LIVE (i, &b->enemies.s) {
        const unsigned flags = b->enemy_kinds.flags[b->enemies.kind[i]];
        if (!(flags & ENEMY_TOUCH) || b->enemies.flags[i] & ENEMY_DYING)
            continue;
        const uint32_t n = hit_split_enemy(b, i, piece);
        visit_bodies(v, (struct danger){ .source = DANGER_ENEMY, .swept = flags & ENEMY_SWEPT, .slot = i }, piece, n);
    }
}

static void visit_laser(const struct board *b, const struct visitor *v, uint32_t i)
{
    const uint32_t age = lasers_age(b, i);
    const fx reach = hit_laser_reach(b, i, age);

    if (reach < 0 || b->laser_kinds.flags[b->laser_heads.kind[i]] & LASER_HITS_ENEMIES)
        return;
    for (uint32_t k = 0; k < lasers_segment_count(b, i); k++) {
        const struct lasers_segment now = lasers_get_segment(b, i, k), old = lasers_get_old_segment(b, i, k);
        const struct danger d = { .shape = DANGER_LASER_SEGMENT,
                                  .source = DANGER_LASER,
                                  .swept = true,
                                  .age = (uint16_t)(age < UINT16_MAX ? age : UINT16_MAX),
                                  .slot = i,
                                  .x = now.x,
                                  .y = now.y,
                                  .mx = now.x - old.x,
                                  .my = now.y - old.y,
                                  .a = reach,
                                  .b = now.to_x,
                                  .c = now.to_y,
                                  .d = now.to_x - old.to_x,
                                  .e = now.to_y - old.to_y };

        v->visit(v->context, &d);
    }
}

void danger_visit_shapes(const struct board *b, void (*visit)(void *context, const struct danger *d), void *context)
{
    const struct visitor v = { visit, context };

    visit_bullets(b, &v);
    EACH_LIVE (i, &b->lasers.s)
        visit_laser(b, &v, i);
    visit_enemies(b, &v);
}

static bool segment_would_hit(const struct danger *d, const struct danger_path *path)
{
    const int64_t mx = (int64_t)path->x - path->prev_x, my = (int64_t)path->y - path->prev_y;
    const struct geom_bar bar = {
        (int64_t)d->x - d->mx - path->prev_x, (int64_t)d->y - d->my - path->prev_y, d->mx - mx, d->my - my,
        (int64_t)d->b - d->d - path->prev_x,  (int64_t)d->c - d->e - path->prev_y,  d->d - mx,  d->e - my
    };

    return geom_swept_bar(&bar, (int64_t)d->a + path->radius);
}

bool danger_would_hit(const struct danger *d, const struct danger_path *path)
{
    static const uint8_t shapes[] = { SHAPE_CIRCLE, SHAPE_BOX, SHAPE_CAPSULE };

    if (d->shape == DANGER_LASER_SEGMENT)
        return segment_would_hit(d, path);
    const struct body p = { shapes[d->shape], d->a, d->b, d->x, d->y, d->mx, d->my, d->c };
    const struct body q = { .shape = SHAPE_CIRCLE,
                            .a = path->radius,
                            .x = path->x,
                            .y = path->y,
                            .mx = path->x - path->prev_x,
                            .my = path->y - path->prev_y };
    return hit_any_bodies_touch(&p, 1, &q, 1, d->swept);
}

void danger_get_ship(const struct board *b, int i, struct danger_ship *out)
{
    const struct player *p = &b->player;
    const struct player_kinds *k = &b->player_kinds;
    const uint16_t kind = p->kind[i];

    *out = (struct danger_ship){ .in_game = p->in_game[i], .area = b->player_area };
    if (!out->in_game)
        return;
    out->can_steer = !b->core.frozen && !p->deathbomb_left[i] && !(board_ignored_buttons(b, (uint32_t)i) & PAD_UP);
    out->is_hit = p->deathbomb_left[i] > 0;
    out->is_safe = p->safe_left[i] > 0;
    out->lives = p->lives[i];
    out->path = (struct danger_path){ p->prev_x[i], p->prev_y[i], p->x[i], p->y[i], k->radius[kind] };
    out->speed = k->speed[kind];
    out->focused_speed = k->focus_speed[kind];
}

void danger_set_invincible(struct board *b, bool invincible)
{
    b->start.practice.invincible = invincible;
}
