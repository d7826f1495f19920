/*
 * test_pierce.c - shots that go through what they hit: which things each hits in a frame, against a plain list of all
 * that it touches. tests/scripts/pierce.lua has how often, in which frames, and when it is used up.
 */
#include "hits.h"

enum { BULLETS = 96, SHOTS = 48, FOES = 40, KINDS = 4, CLOCK = 1000, MOST = BULLETS + FOES };

/* ---- whom a shot hits ---- */

/* What a shot touches. */
struct touched {
    wide apart;
    int64_t thing;
};

static int by_distance(const void *a, const void *b)
{
    const struct touched *p = a, *q = b;

    if (p->apart != q->apart)
        return p->apart < q->apart ? -1 : 1;
    if (handle_kind(p->thing) != handle_kind(q->thing))
        return handle_kind(p->thing) == H_ENEMY ? -1 : 1;
    return handle_slot(p->thing) < handle_slot(q->thing) ? -1 : 1;
}

static long through, kept_out, stopped, full;

/* Does the shot have it in mind? Counts those that it has. */
static bool in_mind(const struct board *b, uint32_t i, int64_t thing, int *n)
{
    bool is = false;

    *n = 0;
    for (uint32_t k = 0; k < MAX_PIERCED_TARGETS; k++) {
        int64_t h = b->shots.pierced_targets[i * MAX_PIERCED_TARGETS + k];
        if (!h || b->shots.rehit_clock[i * MAX_PIERCED_TARGETS + k] <= CLOCK || !board_is_readable(b, h))
            continue;
        is |= h == thing;
        ++*n;
    }
    return is;
}

static int list_touched(const struct board *b, uint32_t i, struct touched t[MOST])
{
    const struct bullets *s = &b->shots, *o = &b->bullets;
    const uint16_t flags = b->shot_kinds.flags[s->kind[i]];
    const struct whole shot = flier(s, &b->shot_kinds, i);
    int n = 0;

    EACH_LIVE (e, &b->enemies.s)
        if (meets(shot, foe(b, e), flags & KIND_SWEPT))
            t[n++] = (struct touched){ square((wide)s->x[i] - s->vx[i] - b->enemies.prev_x[e]) +
                                           square((wide)s->y[i] - s->vy[i] - b->enemies.prev_y[e]),
                                       board_handle(b, H_ENEMY, (int32_t)e) };
    EACH_LIVE (k, &o->s)
        if (is_solid(b, k, flags & KIND_CANCELS) && meets(shot, flier(o, &b->bullet_kinds, k), flags & KIND_SWEPT))
            t[n++] = (struct touched){ square((wide)s->x[i] - s->vx[i] - ((wide)o->x[k] - o->vx[k])) +
                                           square((wide)s->y[i] - s->vy[i] - ((wide)o->y[k] - o->vy[k])),
                                       board_handle(b, H_BULLET, (int32_t)k) };
    qsort(t, (size_t)n, sizeof *t, by_distance);
    return n;
}

static void expect_of(const struct board *b, uint32_t i)
{
    struct touched t[MOST];
    const int n = list_touched(b, i, t), left = b->shots.pierce_left[i];
    int known, hits = 0;

    in_mind(b, i, 0, &known);
    for (int k = 0; k < n; k++) {
        int unused;
        if (b->shot_kinds.pierce_hits[b->shots.kind[i]] && in_mind(b, i, t[k].thing, &unused)) {
            kept_out++;
            continue;
        }
        if (left != PIERCE_FOREVER && hits > left)
            break;
        if (b->shot_kinds.pierce_hits[b->shots.kind[i]] && known + hits == MAX_PIERCED_TARGETS) {
            full++;
            break;
        }
        expect(b, EV_SHOT, H_SHOT, i, handle_kind(t[k].thing), handle_slot(t[k].thing));
        through += hits++ > 0;
        if (handle_kind(t[k].thing) == H_BULLET && b->bullets.hp[handle_slot(t[k].thing)] == HP_FOREVER) {
            stopped++;
            break;
        }
    }
}

static void draw_kinds(struct bullet_kinds *k, fx span, bool shots)
{
    k->s.live = KINDS;
    for (uint32_t i = 0; i < KINDS; i++) {
        k->shape[i] = one_in(2) ? SHAPE_CIRCLE : SHAPE_BOX;
        k->a[i] = (fx)rng_below(&rng, (uint64_t)span / 4 + 1);
        k->b[i] = k->shape[i] == SHAPE_BOX ? k->a[i] : 0;
        k->flags[i] = (uint16_t)((one_in(4) ? 0 : KIND_SWEPT) | (shots && one_in(3) ? KIND_CANCELS : 0));
        if (shots) {
            k->pierce_hits[i] = one_in(4) ? 0 : one_in(3) ? PIERCE_FOREVER : 1 + (int32_t)rng_below(&rng, 4);
            k->rehit_interval[i] = 6;
        }
    }
}

static void draw_pool(struct bullets *s, uint64_t n, fx span, fx grain)
{
    while (n--) {
        struct bullet_spec shape = { .kind = (uint16_t)rng_below(&rng, KINDS) };
        uint32_t i = (uint32_t)bullets_fire(s, &shape, 0);
        s->vx[i] = within(span / 2);
        s->vy[i] = within(span / 2);
        s->x[i] = within(span) / grain * grain + s->vx[i];
        s->y[i] = within(span) / grain * grain + s->vy[i];
        s->speed_bound = fx_max(s->speed_bound, fx_max(fx_abs(s->vx[i]), fx_abs(s->vy[i])));
        if (s->hp)
            s->hp[i] = one_in(2) ? 0 : one_in(6) ? HP_FOREVER : 1 + (int32_t)rng_below(&rng, 9);
    }
}

static int64_t any_thing(const struct board *b)
{
    const bool foe_one = one_in(2);
    const uint32_t i = (uint32_t)rng_below(&rng, foe_one ? FOES : BULLETS);
    const struct slots *s = foe_one ? &b->enemies.s : &b->bullets.s;

    return handle_make(foe_one ? H_ENEMY : H_BULLET, i < s->top && !one_in(5) ? s->gen[i] : 77, i);
}

static void draw_memory(struct board *b)
{
    EACH_LIVE (i, &b->shots.s) {
        const int32_t of = b->shot_kinds.pierce_hits[b->shots.kind[i]];
        b->shots.pierce_left[i] = of <= 0 ? of : (int32_t)rng_below(&rng, (uint64_t)of + 1);
        for (uint32_t k = 0; of && k < MAX_PIERCED_TARGETS; k++) {
            bool twice = false;
            int64_t h = one_in(3) ? any_thing(b) : 0;
            for (uint32_t j = 0; j < k; j++)
                twice |= b->shots.pierced_targets[i * MAX_PIERCED_TARGETS + j] == h;
            b->shots.pierced_targets[i * MAX_PIERCED_TARGETS + k] = twice ? 0 : h;
            b->shots.rehit_clock[i * MAX_PIERCED_TARGETS + k] = CLOCK - 2 + (uint32_t)rng_below(&rng, 6);
        }
    }
}

static void scene(struct board *b, int number)
{
    const fx span = (fx)(64 + (rng_below(&rng, (uint64_t)edge / 4) >> rng_below(&rng, 14)));
    const fx grain = one_in(2) ? 1 : 1 + span / (fx)(1 + rng_below(&rng, 9));

    EACH_LIVE (i, &b->shots.s)
        bullets_drop(&b->shots, i);
    EACH_LIVE (i, &b->bullets.s)
        bullets_drop(&b->bullets, i);
    EACH_LIVE (i, &b->enemies.s)
        enemies_drop(&b->enemies, i);
    b->bullets.speed_bound = b->shots.speed_bound = 0;
    draw_kinds(&b->bullet_kinds, span, false);
    draw_kinds(&b->shot_kinds, span, true);
    draw_pool(&b->bullets, rng_below(&rng, BULLETS), span, grain);
    draw_pool(&b->shots, 1 + rng_below(&rng, SHOTS), span, grain);
    b->enemy_kinds.s.live = 1;
    b->enemy_kinds.shape[0] = SHAPE_CIRCLE;
    b->enemy_kinds.a[0] = span / 8;
    for (uint64_t n = rng_below(&rng, FOES); n--;)
        enemies_spawn(&b->enemies, &b->enemy_kinds, 0, within(span) / grain * grain, within(span) / grain * grain, 0);
    draw_memory(b);
    b->core.clock = CLOCK;
    b->events.n = 0;
    expected_n = 0;
    EACH_LIVE (i, &b->shots.s)
        expect_of(b, i);
    hit_run(b);
    compare(b, number);
}

TEST(random)
{
    const int n = rig_long() ? 40000 : 2500;
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    rng_seed(&rng, 21);
    m.bullets = BULLETS;
    m.shots = SHOTS;
    m.enemies = FOES;
    m.has_hp = m.has_pierce = 1;
    rig_script(&g, &m, "");
    rig_power(&r, &g, NULL);
    rig_reserve_kinds(r.b);
    for (int i = 0; i < n; i++)
        scene(r.b, i);
    if (through < n || kept_out < n / 4 || stopped < n / 4 || full < n / 20)
        fail_msg("too few: through %ld, kept out %ld, stopped %ld, full %ld", through, kept_out, stopped, full);
    rig_close(&r);
}

RUN_TESTS(NULL, NULL)
