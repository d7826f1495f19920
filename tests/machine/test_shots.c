/*
 * test_shots.c - which enemy each shot hits, against the reference of hits.h: crowds of all sizes and densities, that
 * stand in rows, heaps and lines, at all scales up to the ends of the world.
 */
#include "hits.h"

enum { SHOTS = 1024, FOES = 4096, KINDS = 6 };

static struct rig_game g;
static struct rig rig;

/* ---- scenes ---- */

/* How a scene is strewn: around (x, y) as far as wide and high, whole steps of grain apart; grain 1: anywhere. */
struct field {
    fx x, y, wide, high, grain;
};

static struct field draw_field(void)
{
    struct field f = { .wide = (fx)(rng_below(&rng, (uint64_t)edge) >> rng_below(&rng, 24)) };

    f.high = one_in(5) ? 0 : one_in(3) ? f.wide / (fx)(1 + rng_below(&rng, 9)) : f.wide;
    f.wide = one_in(9) ? 0 : f.wide;
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

/* A size that has some of n enemies overlap, or all, or none. */
static fx extent(const struct field *f, uint64_t n)
{
    uint64_t part = one_in(2) ? 1 + n / (1 + rng_below(&rng, 4)) : 1 + rng_below(&rng, 64);
    fx most = f->wide > f->high ? f->wide : f->high;

    return one_in(24) ? fastest : one_in(24) ? 0 : clamped(2 * (int64_t)most / (int64_t)part, fastest);
}

static fx move(const struct field *f)
{
    return one_in(16) ? within(fastest) : within(clamped(f->wide / 16, fastest)) >> rng_below(&rng, 12);
}

static void draw_kinds(struct board *b, const struct field *f, uint64_t n)
{
    struct bullet_kinds *s = &b->shot_kinds;
    struct enemy_kinds *e = &b->enemy_kinds;
    bool all_swept = one_in(2);
    const struct shape_columns of[] = { { s->shape, s->a, s->b, s->x, s->y }, { e->shape, e->a, e->b, e->x, e->y } };

    s->s.live = e->s.live = KINDS;
    for (uint32_t k = 0; k < KINDS; k++) {
        s->shape[k] = (uint8_t)(one_in(12)  ? SHAPE_NONE
                                : one_in(3) ? SHAPE_CIRCLE
                                : one_in(2) ? SHAPE_BOX
                                            : SHAPE_CAPSULE);
        s->a[k] = extent(f, 4 * n);
        s->b[k] = s->shape[k] != SHAPE_CIRCLE ? extent(f, 4 * n) : 0;
        if (s->shape[k] == SHAPE_CAPSULE)
            s->b[k] = clamped(s->b[k], fastest - s->a[k]);
        s->flags[k] = (uint8_t)((all_swept || one_in(2) ? KIND_SWEPT : 0) | (one_in(2) ? KIND_TURNS : 0));
        e->shape[k] = (uint8_t)(one_in(12) ? SHAPE_NONE : one_in(2) ? SHAPE_CIRCLE : SHAPE_BOX);
        e->a[k] = extent(f, n);
        e->b[k] = e->shape[k] == SHAPE_BOX ? extent(f, n) : 0;
        s->x[k] = s->y[k] = e->x[k] = e->y[k] = 0;
    }
    for (uint32_t k = 0; k < KINDS; k += KINDS / 2)
        for (int i = 0; i < 2; i++)
            if (one_in(3))
                draw_pieces(&of[i], k, k + KINDS / 2 - 1, i == 1, extent(f, i == 0 ? 4 * n : n));
}

static void draw_enemies(struct board *b, const struct field *f, uint64_t n, uint32_t kinds)
{
    struct enemies *e = &b->enemies;
    bool still = one_in(3);

    while (n--) {
        fx x = strewn(f->x, f->wide, f->grain), y = strewn(f->y, f->high, f->grain);
        uint32_t i = (uint32_t)enemies_spawn(e, &b->enemy_kinds, (uint16_t)rng_below(&rng, kinds), x, y, 0);
        if (!still && !one_in(8)) {
            e->x[i] = clamped((int64_t)x + move(f), edge);
            e->y[i] = clamped((int64_t)y + move(f), edge);
        }
        if (one_in(12))
            e->flags[i] |= ENEMY_DYING;
        if (one_in(12))
            enemies_drop(e, i);
    }
}

static void draw_shots(struct board *b, const struct field *f, uint64_t n, uint32_t kinds)
{
    struct bullets *s = &b->shots;
    fx grain = f->grain > 1 && one_in(2) ? f->grain / 2 : f->grain;

    while (n--) {
        bool far = one_in(16);
        struct bullet_spec shape = { .kind = (uint16_t)rng_below(&rng, kinds) };
        uint32_t i = (uint32_t)bullets_fire(s, &shape, 0);
        s->dir[i] = (ang)rng_next(&rng) << (one_in(3) ? 30 : 0);
        s->vx[i] = one_in(3) ? 0 : move(f);
        s->vy[i] = one_in(3) ? 0 : move(f);
        s->x[i] = far ? within(edge) : clamped((int64_t)strewn(f->x, f->wide, grain) + s->vx[i], edge);
        s->y[i] = far ? within(edge) : clamped((int64_t)strewn(f->y, f->high, grain) + s->vy[i], edge);
        if (one_in(16))
            bullets_drop(s, i);
    }
}

static void empty(struct board *b)
{
    EACH_LIVE (i, &b->shots.s)
        bullets_drop(&b->shots, i);
    EACH_LIVE (i, &b->enemies.s)
        enemies_drop(&b->enemies, i);
    slots_trim(&b->shots.s);
    slots_trim(&b->enemies.s);
    b->events.n = 0;
}

static void check(struct board *b, int scene, uint64_t m, uint64_t k)
{
    struct field f = draw_field();
    uint32_t kinds = one_in(2) ? 1 : KINDS;

    empty(b);
    draw_kinds(b, &f, k);
    draw_enemies(b, &f, k, kinds);
    if (one_in(4)) { /* a second heap, or one enemy far away */
        struct field other = draw_field();
        draw_enemies(b, &other, one_in(2) ? 1 : k / 2, kinds);
    }
    draw_shots(b, &f, m, kinds);
    reference(b);
    hit_run(b);
    compare(b, scene);
}

/* ---- tests ---- */

TEST(few)
{
    int scenes = rig_long() ? 400000 : 20000;

    rng_seed(&rng, 5);
    memset(&seen, 0, sizeof seen);
    for (int i = 0; i < scenes; i++)
        check(rig.b, i, 1 + rng_below(&rng, 24), 1 + rng_below(&rng, 1 + rng_below(&rng, 96)));
    if (seen.shots < scenes || seen.shot_misses < scenes || seen.ties < scenes / 2)
        fail_msg("too few: shots %ld misses %ld ties %ld", seen.shots, seen.shot_misses, seen.ties);
}

TEST(many)
{
    int scenes = rig_long() ? 4000 : 200;

    rng_seed(&rng, 6);
    memset(&seen, 0, sizeof seen);
    for (int i = 0; i < scenes; i++)
        check(rig.b, i, 1 + rng_below(&rng, SHOTS >> rng_below(&rng, 6)),
              1 + rng_below(&rng, 2048 >> rng_below(&rng, 6)));
    if (seen.shots < 100 * scenes || seen.shot_misses < 1000 * scenes || seen.ties < 50 * scenes)
        fail_msg("too few: shots %ld misses %ld ties %ld", seen.shots, seen.shot_misses, seen.ties);
}

/* All there is room for. */
TEST(full)
{
    rng_seed(&rng, 7);
    for (int i = 0; i < 4; i++)
        check(rig.b, i, SHOTS, FOES * 2 / 3);
    for (int i = 0; i < 4; i++) {
        struct field f = { .wide = 100 << 16, .high = 100 << 16, .grain = i & 1 ? 1 : 10 << 16 };
        empty(rig.b);
        draw_kinds(rig.b, &f, FOES);
        draw_enemies(rig.b, &f, FOES, KINDS);
        draw_enemies(rig.b, &f, FOES - rig.b->enemies.s.live, KINDS);
        draw_shots(rig.b, &f, SHOTS, KINDS);
        reference(rig.b);
        hit_run(rig.b);
        compare(rig.b, i);
    }
}

static int setup(void **state)
{
    (void)state;
    open_pools(&rig, &g, rig_manifest().bullets, SHOTS, FOES, false);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    rig_free(&rig);
    rig_game_free(&g);
    return 0;
}

RUN_TESTS(setup, teardown)
