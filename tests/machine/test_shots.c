/*
 * test_shots.c - which enemy or bullet each shot hits, against the reference of hits.h: crowds of all sizes and
 * densities, in heaps, rows and grids, at all scales up to the ends of the world. test_hits.c draws few enemies of all
 * shapes; tests/scripts/solid.lua shows what becomes of bullets that are hit.
 */
#include "hits.h"

enum { SHOTS = 1024, FOES = 4096, BULLETS = 192, KINDS = 6 };

/* The crowd of a scene: as far as wide and high around (x, y), whole steps of grain apart. */
struct field {
    fx x, y, wide, high, grain;
};

static struct field draw_field(void)
{
    struct field f = { .wide = (fx)(rng_below(&rng, (uint64_t)edge) >> rng_below(&rng, 24)) };

    f.high = one_in(4) ? 0 : f.wide;
    f.grain = one_in(2) ? 1 : 1 + f.wide / (fx)(1 + rng_below(&rng, 12));
    if (one_in(2)) {
        f.x = within(edge - f.wide);
        f.y = within(edge - f.high);
    }
    return f;
}

static fx strewn(fx middle, fx most, fx grain)
{
    return clamped((int64_t)middle + within(most) / grain * grain, edge);
}

/* A size with which some of n things overlap, or all, or none. */
static fx extent(const struct field *f, uint64_t n)
{
    return one_in(24) ? fastest : clamped(2 * (int64_t)f->wide / (int64_t)(1 + rng_below(&rng, 2 * n)), fastest);
}

static fx move(const struct field *f)
{
    return one_in(3) ? 0 : one_in(16) ? within(fastest) : within(clamped(f->wide / 16, fastest));
}

static void draw_bullet_kinds(struct bullet_kinds *k, const struct field *f, uint64_t n, uint16_t flag)
{
    k->s.live = KINDS;
    for (uint32_t i = 0; i < KINDS; i++) {
        k->shape[i] = one_in(9) ? SHAPE_NONE : one_in(2) ? SHAPE_CIRCLE : SHAPE_BOX;
        k->a[i] = extent(f, 4 * n);
        k->b[i] = k->shape[i] == SHAPE_BOX ? extent(f, 4 * n) : 0;
        k->flags[i] = (uint16_t)((one_in(2) ? KIND_SWEPT : 0) | (one_in(3) ? flag : 0));
    }
}

static void draw_enemy_kinds(struct enemy_kinds *k, const struct field *f, uint64_t n)
{
    k->s.live = KINDS;
    for (uint32_t i = 0; i < KINDS; i++) {
        k->shape[i] = one_in(2) ? SHAPE_CIRCLE : SHAPE_BOX;
        k->a[i] = extent(f, n);
        k->b[i] = k->shape[i] == SHAPE_BOX ? extent(f, n) : 0;
    }
}

static void draw_enemies(struct board *b, const struct field *f, uint64_t n)
{
    struct enemies *e = &b->enemies;

    while (n--) {
        const fx x = strewn(f->x, f->wide, f->grain), y = strewn(f->y, f->high, f->grain);
        const uint32_t i = (uint32_t)enemies_spawn(e, &b->enemy_kinds, (uint16_t)rng_below(&rng, KINDS), x, y, 0);
        e->x[i] = clamped((int64_t)x + move(f), edge);
        e->y[i] = clamped((int64_t)y + move(f), edge);
        if (one_in(12))
            enemies_drop(e, i);
    }
}

/* Bullets or shots, of which a sixteenth is far away. */
static void draw_bullets(struct bullets *s, const struct field *f, uint64_t n)
{
    while (n--) {
        const struct bullet_spec shape = { .kind = (uint16_t)rng_below(&rng, KINDS), .delay = one_in(8) };
        const uint32_t i = (uint32_t)bullets_fire(s, &shape, 0);
        s->vx[i] = shape.delay ? 0 : move(f);
        s->vy[i] = shape.delay ? 0 : move(f);
        s->x[i] = one_in(16) ? within(edge) : clamped((int64_t)strewn(f->x, f->wide, f->grain) + s->vx[i], edge);
        s->y[i] = clamped((int64_t)strewn(f->y, f->high, f->grain) + s->vy[i], edge);
        s->speed_bound = fx_max(s->speed_bound, fx_max(fx_abs(s->vx[i]), fx_abs(s->vy[i])));
        if (s->hp)
            s->hp[i] = one_in(2) ? 0 : one_in(3) ? HP_FOREVER : 1 + (int32_t)rng_below(&rng, 9);
    }
}

static void empty(struct board *b)
{
    EACH_LIVE (i, &b->shots.s)
        bullets_drop(&b->shots, i);
    EACH_LIVE (i, &b->bullets.s)
        bullets_drop(&b->bullets, i);
    EACH_LIVE (i, &b->enemies.s)
        enemies_drop(&b->enemies, i);
    slots_trim(&b->shots.s);
    slots_trim(&b->bullets.s);
    slots_trim(&b->enemies.s);
    b->bullets.speed_bound = b->shots.speed_bound = 0;
    b->events.n = 0;
}

static void check(struct board *b, int scene, uint64_t shots, uint64_t foes, uint64_t bullets)
{
    const struct field f = draw_field();

    empty(b);
    draw_bullet_kinds(&b->shot_kinds, &f, foes + bullets, bullets && one_in(3) ? KIND_CANCELS : 0);
    draw_bullet_kinds(&b->bullet_kinds, &f, bullets + 1, KIND_FIXED);
    draw_enemy_kinds(&b->enemy_kinds, &f, foes + 1);
    draw_enemies(b, &f, foes);
    draw_bullets(&b->shots, &f, shots);
    draw_bullets(&b->bullets, &f, bullets);
    reference(b);
    hit_run(b);
    compare(b, scene);
}

static uint64_t some(int most)
{
    return 1 + rng_below(&rng, (uint64_t)most >> rng_below(&rng, 6));
}

TEST(crowds_of_enemies)
{
    const int scenes = rig_long() ? 4000 : 300;
    struct rig_game g;
    struct rig r;

    open_pools(&r, &g, BULLETS, SHOTS, FOES, false);
    rng_seed(&rng, 6);
    for (int i = 0; i < scenes; i++)
        check(r.b, i, some(SHOTS), some(FOES / 2), 0);
    for (int i = 0; i < 4; i++)
        check(r.b, scenes + i, SHOTS, FOES, 0);
    if (seen.shots < 50 * scenes || seen.shot_misses < 1000 * scenes || seen.ties < 5 * scenes)
        fail_msg("too few: shots %ld misses %ld ties %ld", seen.shots, seen.shot_misses, seen.ties);
    rig_close(&r);
}

/* Those that have hp, and those that a shot cancels. */
TEST(bullets)
{
    const int scenes = rig_long() ? 60000 : 3000;
    struct rig_game g;
    struct rig r;

    rng_seed(&rng, 11);
    for (int hp = 0; hp < 2; hp++) {
        open_pools(&r, &g, BULLETS, SHOTS, FOES, hp);
        memset(&seen, 0, sizeof seen);
        for (int i = 0; i < scenes; i++)
            check(r.b, i, some(64), one_in(2) ? some(32) : 0, some(BULLETS));
        if (seen.solids < (hp ? scenes : scenes / 5) || seen.shots < scenes || (hp && seen.solid_ties < scenes / 9))
            fail_msg("too few: bullets %ld enemies %ld ties %ld", seen.solids, seen.shots, seen.solid_ties);
        rig_close(&r);
    }
}

RUN_TESTS(NULL, NULL)
