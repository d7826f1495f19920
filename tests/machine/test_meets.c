/*
 * test_meets.c - bullets that meet bullets: who meets whom, against all pairs and the reference of hits.h.
 * tests/scripts/meets.lua has what comes of it.
 */
#include "hits.h"

enum { BULLETS = 320, KINDS = 14, PIECES = 6 /* kinds from there on */, TAGS = 5 };

static fx length(fx most)
{
    return one_in(9) ? most : one_in(9) ? 0 : (fx)(rng_below(&rng, (uint64_t)most + 1) >> rng_below(&rng, 24));
}

static fx slower(fx v)
{
    return v < fastest ? v : fastest;
}

static void draw_kinds(struct bullet_kinds *k, fx size)
{
    const struct shape_columns columns = { k->shape, k->a, k->b, k->x, k->y };

    k->s.live = KINDS;
    for (uint32_t i = 0; i < KINDS; i++) {
        k->shape[i] = (uint8_t)(one_in(9) ? SHAPE_NONE : one_in(2) ? SHAPE_CIRCLE : SHAPE_BOX);
        k->a[i] = k->shape[i] ? length(one_in(20) ? fastest : size) : 0;
        k->b[i] = k->shape[i] == SHAPE_BOX ? length(size) : 0;
        k->x[i] = k->y[i] = 0;
        k->flags[i] =
            (uint16_t)((one_in(3) ? 0 : KIND_SWEPT) | (one_in(3) ? KIND_FIXED : 0) | (one_in(2) ? KIND_TURNS : 0));
    }
    for (uint32_t i = PIECES; i < KINDS; i += 4)
        draw_pieces(&columns, i, i + 3, false, size);
}

static void draw_pairs(struct bullets *s)
{
    s->n_meet_pairs = 1 + (uint32_t)rng_below(&rng, 4);
    for (uint32_t p = 0; p < s->n_meet_pairs; p++) {
        s->meet_first[p] = (uint16_t)(1 + rng_below(&rng, TAGS));
        s->meet_second[p] = (uint16_t)(1 + rng_below(&rng, TAGS));
        s->meet_flags[p] = (uint8_t)rng_below(&rng, 8);
    }
}

/* grain: places are multiples of it, so that many are equally far apart. */
static void draw_bullets(struct bullets *s, uint64_t n, fx span, fx speed, fx grain)
{
    while (n--) {
        struct bullet_spec shape = { .kind = (uint16_t)rng_below(&rng, KINDS),
                                     .delay = one_in(9),
                                     .dir = (ang)rng_next(&rng) };
        shape.tag = (uint16_t)rng_below(&rng, TAGS + 1);
        uint32_t i = (uint32_t)bullets_fire(s, &shape, 0);
        bool still = one_in(3) || shape.delay;
        fx most = one_in(30) ? fastest : speed;
        s->vx[i] = still ? 0 : within(most) / grain * grain;
        s->vy[i] = still ? 0 : within(most) / grain * grain;
        s->x[i] = clamped((int64_t)within(span) / grain * grain + s->vx[i], edge);
        s->y[i] = clamped((int64_t)within(span) / grain * grain + s->vy[i], edge);
        if (one_in(9))
            bullets_drop(s, i);
        else if (one_in(9))
            slots_hold(&s->s, s->leaving, i);
    }
}

static void empty(struct board *b)
{
    bullets_release_all(&b->bullets);
    EACH_LIVE (i, &b->bullets.s)
        bullets_drop(&b->bullets, i);
    slots_trim(&b->bullets.s);
    b->events.n = 0;
}

/* The same where the kind stands. */
static struct whole body(const struct board *b, uint32_t i)
{
    struct whole w = flier(&b->bullets, &b->bullet_kinds, i);

    for (int k = 0; k < w.n && !(b->bullet_kinds.flags[b->bullets.kind[i]] & KIND_SWEPT); k++) {
        w.piece[k].was_x = w.piece[k].x;
        w.piece[k].was_y = w.piece[k].y;
    }
    return w;
}

static struct {
    long met, ties, alone, held, passed, stood, pieces;
    bool first[BULLETS], gone[BULLETS];
} plain;

static bool there(const struct board *b, uint32_t i, uint16_t tag)
{
    const struct bullets *s = &b->bullets;
    bool live = s->s.live_bits[i / 64] >> (i & 63) & 1, held = i < s->s.held_top && s->s.held[i / 64] >> (i & 63) & 1;

    return (live || held) && s->tag[i] == tag && !(s->flags[i] & BULLET_DELAYED) && !plain.gone[i];
}

static wide apart(const struct bullets *s, uint32_t i, uint32_t k)
{
    return square((wide)s->x[i] - s->vx[i] - ((wide)s->x[k] - s->vx[k])) +
           square((wide)s->y[i] - s->vy[i] - ((wide)s->y[k] - s->vy[k]));
}

/* Whom bullet i meets as the first of pair p; NO_SLOT: nobody. */
static int32_t plain_partner(const struct board *b, uint32_t p, uint32_t i)
{
    const struct bullets *s = &b->bullets;
    bool alone = s->meet_first[p] == s->meet_second[p];
    struct whole me = body(b, i);
    int32_t found = NO_SLOT;
    wide best = 0;

    for (uint32_t k = 0; k < s->s.top; k++) {
        if (k == i || !there(b, k, s->meet_second[p]) || (alone && plain.first[k]))
            continue;
        wide d = apart(s, i, k);
        if (found != NO_SLOT && d > best)
            continue;
        if (!meets(me, body(b, k), true)) {
            plain.passed++;
            continue;
        }
        plain.ties += found != NO_SLOT && d == best;
        if (found != NO_SLOT && d == best)
            continue;
        best = d;
        found = (int32_t)k;
    }
    return found;
}

static void mark(const struct board *b, uint32_t p, uint32_t i, uint32_t k)
{
    const struct bullets *s = &b->bullets;
    const uint16_t *flags = b->bullet_kinds.flags;
    bool all = s->meet_flags[p] & MEET_ALL, alone = s->meet_first[p] == s->meet_second[p];

    plain.first[i] = true;
    plain.first[k] |= alone;
    if (s->meet_flags[p] & MEET_FIRST && (all || !(flags[s->kind[i]] & KIND_FIXED)))
        plain.gone[i] = true;
    if (s->meet_flags[p] & MEET_SECOND && (all || !(flags[s->kind[k]] & KIND_FIXED)))
        plain.gone[k] = true;
    plain.met++;
    plain.alone += alone;
    plain.held += i < s->s.held_top && s->s.held[i / 64] >> (i & 63) & 1;
    plain.stood += !(flags[s->kind[i]] & KIND_SWEPT) != !(flags[s->kind[k]] & KIND_SWEPT);
    plain.pieces += (b->bullet_kinds.shape[s->kind[i]] | b->bullet_kinds.shape[s->kind[k]]) > SHAPE_MAX_SIMPLE;
}

static void reference_meets(const struct board *b)
{
    const struct bullets *s = &b->bullets;

    expected_n = 0;
    memset(plain.first, 0, sizeof plain.first);
    memset(plain.gone, 0, sizeof plain.gone);
    for (uint32_t p = 0; p < s->n_meet_pairs; p++)
        for (uint32_t i = 0; i < s->s.top; i++) {
            int32_t k = there(b, i, s->meet_first[p]) && !plain.first[i] ? plain_partner(b, p, i) : NO_SLOT;
            if (k == NO_SLOT)
                continue;
            expect(b, EV_MEET, H_BULLET, i, H_BULLET, (uint32_t)k);
            expected[expected_n - 1].pair = p;
            mark(b, p, i, (uint32_t)k);
        }
}

static void compare_pairs(const struct board *b, int scene)
{
    compare(b, scene);
    for (int i = 0; i < expected_n; i++)
        if (events_at(&b->events, (uint32_t)i).pair != expected[i].pair)
            fail_msg("scene %d, event %d: pair %u, expected %u", scene, i, events_at(&b->events, (uint32_t)i).pair,
                     expected[i].pair);
}

/* At all scales up to the ends of the world: crowds of small ones, single large or fast ones, places in a raster. */
TEST(random)
{
    int n = rig_long() ? 60000 : 6000;
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    m.bullets = BULLETS;
    m.bullets_can_meet = 1;
    rig_script(&g, &m, "");
    rig_power(&r, &g, NULL);
    rig_reserve_kinds(r.b);
    rng_seed(&rng, 5);
    for (int i = 0; i < n; i++) {
        fx span = (fx)(1 + (rng_below(&rng, (uint64_t)edge) >> rng_below(&rng, 22)));
        fx size = slower(1 + span / (fx)(1 + rng_below(&rng, 60))),
           speed = slower(span / (fx)(1 + rng_below(&rng, 40)));
        fx grain = one_in(2) ? 1 : 1 + span / (fx)(1 + rng_below(&rng, 9));
        empty(r.b);
        draw_kinds(&r.b->bullet_kinds, size);
        draw_pairs(&r.b->bullets);
        draw_bullets(&r.b->bullets, 1 + rng_below(&rng, one_in(4) ? BULLETS : 40), span, speed, grain);
        reference_meets(r.b);
        r.b->bullets.holds_all = true; /* as the move does, in a game where bullets meet */
        hit_run(r.b);
        compare_pairs(r.b, i);
    }
    assert_true(plain.met > 2 * n && plain.passed > 9 * n && plain.ties > n / 9 && plain.alone > n / 9);
    assert_true(plain.held > n / 9 && plain.stood > n / 9 && plain.pieces > n);
    rig_close(&r);
}

/* In a crowd each looks at few: 4,000 and 4,000 in a field, and one that is fast and large. */
TEST(crowd)
{
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    m.bullets = 8000;
    m.bullets_can_meet = 1;
    rig_script(&g, &m,
               "bullet.def('dot', { sprite = 'dot', hit = { circle = 2 } })\n"
               "bullet.def('moon', { sprite = 'dot', hit = { circle = 60 } })\n"
               "bullet.meet('fire', 'ice', { on_meet = function() end })\n"
               "bullet.fire { kind = 'moon', x = 99, y = 99, speed = 200, tag = 'ice' }\n"
               "for i = 1, 7999 do\n"
               "  bullet.fire { kind = 'dot', x = rng.number(0, 240), y = rng.number(0, 320), dir = i, speed = 2,\n"
               "    tag = i % 2 == 0 and 'fire' or 'ice' }\n"
               "end\n");
    rig_power(&r, &g, NULL);
    rig_run(&r, 1);
    assert_int_equal(r.b->bullets.s.live, 8000);
    assert_in_range(r.b->counts.tested, 4000, 4000 * 9);
    rig_close(&r);
}

RUN_TESTS(NULL, NULL)
