/*
 * test_hits.c - every collision of a frame against the reference of hits.h.
 * Scenes are drawn so that most pairs are about to touch, at all scales up to the ends of the world.
 * tests/scripts/hits.lua has the kinds that scripts declare, and what comes of a hit.
 */
#include "hits.h"

enum { BULLETS = 192, SHOTS = 48, FOES = 24, KINDS = 14, PIECES = 8 /* kinds from there on */ };

/* ---- scenes ---- */

/* A length up to most, of any order of magnitude. */
static fx length(fx most)
{
    return one_in(9) ? most : one_in(9) ? 0 : (fx)(rng_below(&rng, (uint64_t)most + 1) >> rng_below(&rng, 24));
}

static fx either_way(fx v)
{
    return one_in(2) ? v : -v;
}

/* Lets each enemy's scale apply to half of the shapes, all of which become so small that none is too large then. */
static void draw_scaled_kinds(struct enemy_kinds *k)
{
    for (uint32_t i = 0; i < KINDS; i++) {
        k->a[i] /= 4;
        k->b[i] /= k->shape[i] == SHAPE_CIRCLES ? 1 : 4;
        k->x[i] /= 4;
        k->y[i] /= 4;
        k->shape[i] |= k->shape[i] != SHAPE_NONE && one_in(2) ? SHAPE_SCALED : 0;
    }
}

static void draw_kinds(struct board *b, fx scale)
{
    b->bullet_kinds.s.live = b->shot_kinds.s.live = b->enemy_kinds.s.live = KINDS;
    for (uint32_t k = 0; k < KINDS; k++) {
        struct bullet_kinds *of[] = { &b->bullet_kinds, &b->shot_kinds };
        for (int i = 0; i < 2; i++) {
            of[i]->shape[k] = (uint8_t)(one_in(8) ? SHAPE_NONE : one_in(3) ? SHAPE_CAPSULE : 1 + rng_below(&rng, 2));
            of[i]->a[k] = length(scale);
            of[i]->b[k] = of[i]->shape[k] == SHAPE_CIRCLE ? 0 : length(scale);
            if (of[i]->shape[k] == SHAPE_CAPSULE)
                of[i]->b[k] = clamped(of[i]->b[k], fastest - of[i]->a[k]);
            of[i]->flags[k] =
                (uint8_t)((one_in(5) ? 0 : KIND_GRAZE) | (one_in(4) ? 0 : KIND_SWEPT) | (one_in(2) ? KIND_TURNS : 0));
            of[i]->x[k] = of[i]->y[k] = 0;
            if (of[i]->shape[k] == SHAPE_NONE)
                of[i]->a[k] = of[i]->b[k] = 0;
        }
        b->enemy_kinds.shape[k] = (uint8_t)(one_in(9) ? SHAPE_NONE : one_in(3) ? SHAPE_CIRCLE : SHAPE_BOX);
        b->enemy_kinds.a[k] = length(scale);
        b->enemy_kinds.b[k] = length(scale);
        b->enemy_kinds.flags[k] = (uint8_t)((one_in(4) ? 0 : ENEMY_TOUCH) | (one_in(4) ? ENEMY_BLOCKS_BULLETS : 0) |
                                            (one_in(4) ? 0 : ENEMY_SWEPT));
    }
    struct shape_columns all[] = {
        { b->bullet_kinds.shape, b->bullet_kinds.a, b->bullet_kinds.b, b->bullet_kinds.x, b->bullet_kinds.y },
        { b->shot_kinds.shape, b->shot_kinds.a, b->shot_kinds.b, b->shot_kinds.x, b->shot_kinds.y },
        { b->enemy_kinds.shape, b->enemy_kinds.a, b->enemy_kinds.b, b->enemy_kinds.x, b->enemy_kinds.y },
    };
    for (int i = 0; i < 3; i++)
        for (uint32_t k = PIECES; k < KINDS; k += 3)
            draw_pieces(&all[i], k, k + 2, i == 2, length(scale));
    memset(b->enemy_kinds.scale, SCALE_ONE, KINDS);
    if (one_in(3))
        draw_scaled_kinds(&b->enemy_kinds);
    b->player_kinds.s.live = 2;
    for (int k = 0; k < 2; k++) {
        b->player_kinds.radius[k] = length(scale);
        b->player_kinds.graze_radius[k] = length(scale);
    }
}

static void draw_players(struct board *b, fx scale, fx place)
{
    for (int p = 0; p < MAX_PLAYERS; p++) {
        struct player *pl = &b->player;
        pl->in_game[p] = !one_in(6);
        pl->kind[p] = (uint16_t)rng_below(&rng, 2);
        pl->x[p] = within(place);
        pl->y[p] = within(place);
        pl->prev_x[p] = clamped((int64_t)pl->x[p] + either_way(length(scale)), edge);
        pl->prev_y[p] = clamped((int64_t)pl->y[p] + either_way(length(scale)), edge);
        if (!pl->in_game[p])
            pl->x[p] = pl->y[p] = pl->prev_x[p] = pl->prev_y[p] = PARK_COORDINATE;
    }
}

/* Puts bullet i so that its way just touches, or just misses, player p's circle or ring. */
static void graze_past(struct board *b, uint32_t i, uint32_t p)
{
    struct bullets *s = &b->bullets;
    uint16_t kind = b->player.kind[p], k = s->kind[i];
    bool bar = b->bullet_kinds.shape[k] == SHAPE_CAPSULE;
    int64_t r = (int64_t)b->bullet_kinds.a[k] +
                (one_in(2) ? b->player_kinds.radius[kind] : b->player_kinds.graze_radius[kind]) + within(3);
    fx ux, uy;
    int64_t wx = (int64_t)s->vx[i] - (b->player.x[p] - b->player.prev_x[p]),
            wy = (int64_t)s->vy[i] - (b->player.y[p] - b->player.prev_y[p]);

    if (bar && one_in(2)) /* square to its bar */
        trig_polar(FX_ONE, s->dir[i] + 0x40000000, &ux, &uy);
    else if (one_in(3) || (!wx && !wy)) /* anywhere around */
        trig_normalise(within(FX_ONE), within(FX_ONE), &ux, &uy);
    else /* square to its way */
        trig_normalise((fx)(-wy / 4), (fx)(wx / 4), &ux, &uy);
    if (one_in(2))
        ux = -ux, uy = -uy;
    int64_t back = (int64_t)rng_below(&rng, FX_ONE + 1);
    fx bar_x = 0, bar_y = 0;
    if (bar) /* some place of it */
        trig_polar(within(b->bullet_kinds.b[k]), s->dir[i], &bar_x, &bar_y);
    s->x[i] = clamped(b->player.x[p] + (ux * r >> 16) + (wx * back >> 16) + bar_x, edge + (edge >> 4));
    s->y[i] = clamped(b->player.y[p] + (uy * r >> 16) + (wy * back >> 16) + bar_y, edge + (edge >> 4));
}

static void draw_bullets(struct board *b, fx scale, fx place)
{
    struct bullet_spec shape = { 0 };
    uint32_t n = (uint32_t)rng_below(&rng, BULLETS + 1);

    for (uint32_t k = 0; k < n; k++) {
        shape.kind = (uint16_t)rng_below(&rng, KINDS);
        shape.speed = either_way(length(clamped(scale, fastest)));
        shape.dir = (ang)(rng_next(&rng) >> (one_in(3) ? 34 : 0)) << (one_in(3) ? 30 : 0);
        shape.x = within(place);
        shape.y = within(place);
        int32_t i = bullets_fire(&b->bullets, &shape, 0);
        if (!one_in(6))
            graze_past(b, (uint32_t)i, (uint32_t)rng_below(&rng, MAX_PLAYERS));
        b->bullets.flags[i] = (uint8_t)(one_in(4) ? rng_below(&rng, 4) : 0);
        if (one_in(9))
            bullets_drop(&b->bullets, (uint32_t)i);
    }
}

static void draw_others(struct board *b, fx scale, fx place)
{
    struct bullet_spec shape = { 0 };

    for (uint64_t n = rng_below(&rng, FOES + 1); n--;) {
        uint16_t k = (uint16_t)rng_below(&rng, KINDS);
        uint32_t p = (uint32_t)rng_below(&rng, MAX_PLAYERS);
        int64_t r = b->player_kinds.radius[b->player.kind[p]];
        fx x = within(place), y = within(place);
        if (!one_in(3)) {
            x = clamped((int64_t)b->player.x[p] + either_way(clamped(r + b->enemy_kinds.a[k], edge)) + within(2), edge);
            y = clamped((int64_t)b->player.y[p] + within(clamped(b->enemy_kinds.b[k] + 2, edge)), edge);
        }
        int32_t i = enemies_spawn(&b->enemies, &b->enemy_kinds, k, x, y, 0);
        b->enemies.scale[i] = (uint8_t)(one_in(4) ? SCALE_MAX : SCALE_MIN + rng_below(&rng, SCALE_MAX - SCALE_MIN + 1));
        if (one_in(2)) { /* it moved, and ends a little aside or was a little aside */
            fx mx = either_way(length(clamped(scale, fastest))), my = either_way(length(clamped(scale, fastest)));
            b->enemies.prev_x[i] = clamped((int64_t)x + mx, edge);
            b->enemies.prev_y[i] = clamped((int64_t)y + my, edge);
        }
    }
    for (uint64_t n = rng_below(&rng, SHOTS + 1); n--;) {
        shape.kind = (uint16_t)rng_below(&rng, KINDS);
        shape.x = within(place);
        shape.y = within(place);
        shape.speed = length(clamped(scale, fastest));
        shape.dir = one_in(3) ? 0 : (ang)rng_next(&rng);
        if (b->enemies.s.live && !one_in(4)) {
            uint32_t e = (uint32_t)rng_below(&rng, b->enemies.s.live);
            uint16_t k = b->enemies.kind[e];
            int64_t dx = (int64_t)b->enemy_kinds.a[k] + b->shot_kinds.a[shape.kind] + within(2);
            shape.x = clamped(b->enemies.x[e] + (one_in(2) ? dx : -dx), edge);
            shape.y = clamped((int64_t)b->enemies.y[e] + within(b->enemy_kinds.b[k]), edge);
        }
        bullets_fire(&b->shots, &shape, 0);
    }
}

static void empty(struct board *b)
{
    EACH_LIVE (i, &b->bullets.s)
        bullets_drop(&b->bullets, i);
    EACH_LIVE (i, &b->shots.s)
        bullets_drop(&b->shots, i);
    EACH_LIVE (i, &b->enemies.s)
        enemies_drop(&b->enemies, i);
    slots_trim(&b->bullets.s);
    slots_trim(&b->shots.s);
    slots_trim(&b->enemies.s);
    b->events.n = 0;
}

TEST(random)
{
    int scenes = rig_long() ? 200000 : 10000;
    struct rig_game g;
    struct rig rig;
    struct board *b;

    open_pools(&rig, &g, BULLETS, SHOTS, FOES, false);
    b = rig.b;
    rng_seed(&rng, 77);
    for (int i = 0; i < scenes; i++) {
        fx scale = length(fastest), place = one_in(4) ? edge : length(edge);
        empty(b);
        draw_kinds(b, scale);
        draw_players(b, one_in(2) ? scale : length(fastest), place);
        draw_bullets(b, one_in(2) ? scale : length(fastest), place);
        draw_others(b, scale, place);
        reference(b);
        hit_now(b);
        compare(b, i);
    }
    const long least = 10000;
    assert_true(seen.hits > least && seen.bullet_misses > least && seen.grazes > least && seen.box_hits > least);
    assert_true(seen.standing > least / 4 && seen.touches > least / 2 && seen.touch_misses > least / 2);
    assert_true(seen.shots > least && seen.shot_misses > least && seen.blocks > least && seen.capsule_hits > least);
    assert_true(seen.capsule_shots > least / 4 && seen.circles_hits > least / 2 && seen.circles_shots > least / 8);
    assert_true(seen.long_foes > least / 4 && seen.long_touches > least / 4);
    assert_true(seen.scaled_foes > least / 8 && seen.scaled_touches > least / 8);
    rig_close(&rig);
}

RUN_TESTS(NULL, NULL)
