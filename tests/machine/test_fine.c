/*
 * test_fine.c - fine motion against the formulas: a change of speed over n frames ends exactly where the closed form
 * puts it. The oracle is libquadmath. tests/scripts/fine.lua has what scripts see.
 */
#include <quadmath.h>
#include "rig.h"

static struct rig_game g;
static struct rig rig;
static struct rng rng;

static const __float128 Q32 = 4294967296.0;

static void begin(void)
{
    struct manifest m = rig_manifest();

    m.margin = 1024;
    rig_script(&g, &m, "");
    rig_power(&rig, &g, NULL);
}

/* A number that has 32 fraction bits, up to +-most. */
static int64_t number(int64_t most)
{
    return (int64_t)rng_below(&rng, (uint64_t)(2 * most + 1)) - most;
}

static __float128 magnitude(__float128 v)
{
    return v < 0 ? -v : v;
}

/* Bullet 0 anew, fine, at the middle of the world, running a program of one step. */
static void set_off(const struct motion_step *step, int64_t pace, ang dir)
{
    struct board *b = rig.b;
    struct bullet_spec s = { .dir = dir, .is_fine = true };

    if (b->bullets.s.live)
        bullets_drop(&b->bullets, 0);
    b->motions.s.live = 0;
    b->steps.s.live = 0;
    s.motion = (uint16_t)(rig_motion(b, step, 1, true) + 1);
    assert_int_equal(bullets_fire(&b->bullets, &s, 0), 0);
    bullets_set_speed(&b->bullets, 0, pace);
}

/* After n moves, bullet 0 is where `way` along dir leads: to one unit of 2^-32, and to half of one along an axis. */
static void fly(uint32_t n, __float128 way, ang dir)
{
    struct board *b = rig.b;
    const struct box world = { -(WORLD_EDGE << 16), -(WORLD_EDGE << 16), WORLD_EDGE << 16, WORLD_EDGE << 16 };
    struct motion_world w = board_motion_world(b, false);
    __float128 turn = 2 * M_PIq * dir / Q32;
    bool axis = dir << 2 == 0;
    int64_t x, y;

    for (uint32_t k = 0; k < n; k++, w.clock++)
        bullets_move(&b->bullets, &w, &world, NULL, false);
    assert_int_equal(b->bullets.s.live, 1);
    bullets_get_position(&b->bullets, 0, &x, &y);
    if (magnitude(x - way * cosq(turn)) > (axis ? 0.5001 : 1) || magnitude(y - way * sinq(turn)) > (axis ? 0.5001 : 1))
        fail_msg("%u frames: at (%lld, %lld), expected (%.3f, %.3f)", n, (long long)x, (long long)y,
                 (double)(way * cosq(turn)), (double)(way * sinq(turn)));
}

TEST(closed_form)
{
    begin();
    rng_seed(&rng, 7);
    for (int run = 0; run < 3000; run++) {
        uint32_t n = 1 + (uint32_t)rng_below(&rng, run % 10 ? 60 : 4000), more = (uint32_t)rng_below(&rng, 50);
        int64_t most = ((int64_t)12000 << 32) / (n + more);
        int64_t from = number(most), to = number(most), add = (to - from) / n;
        ang dir = (ang)(run % 3 ? rng_next(&rng) : (uint64_t)(run & 3) << 30);
        struct motion_step over = { .actions = DOES_SPEED, .duration = n, .speed = to },
                           accel = { .actions = DOES_ACCEL, .duration = n, .accel = add };
        __float128 steps = (__float128)n * (n + 1) / 2;

        most = (int64_t)MAX_SPEED << 32;
        from = from > most ? most : from < -most ? -most : from;
        to = to > most ? most : to < -most ? -most : to;
        over.speed = to;
        set_off(&over, from, dir);
        fly(n + more, (__float128)from * n + (__float128)(to - from) * (n + 1) / 2 + (__float128)to * more, dir);
        assert_true(rig.b->bullets.speed_q32[0] == to);

        accel.accel = add = (to - from) / n;
        set_off(&accel, from, dir);
        fly(n + more, from * (__float128)n + add * steps + (from + (__float128)add * n) * more, dir);
        assert_true(rig.b->bullets.speed_q32[0] == from + add * n);
    }
    rig_close(&rig);
}

/* The greatest speed to and fro for hours: the count of the way goes round and round, and the place stays. */
TEST(ends)
{
    const int64_t most = (int64_t)MAX_SPEED << 32;
    const struct motion_step still = { .actions = DOES_WAIT, .duration = UINT32_MAX },
                             faster = { .actions = DOES_ACCEL, .duration = 2, .accel = most };
    struct bullets *s;
    int64_t x, y;

    begin();
    s = &rig.b->bullets;
    set_off(&still, most, 0x12345678);
    for (int i = 0; i < 1 << 18; i++) {
        struct motion_world w = board_motion_world(rig.b, false);
        bullets_move(s, &w,
                     &(struct box){ -(WORLD_EDGE << 16), -(WORLD_EDGE << 16), WORLD_EDGE << 16, WORLD_EDGE << 16 },
                     NULL, false);
        s->dir[0] += 0x80000000;
    }
    bullets_get_position(s, 0, &x, &y);
    assert_in_range(x + 4096, 0, 8192);
    assert_in_range(y + 4096, 0, 8192);

    /* what a program adds up stops at the greatest speed; a script's speed is the nearest fx, ties to even */
    set_off(&faster, 0, 0);
    fly(1, most, 0);
    assert_true(s->speed_q32[0] == most && s->speed[0] == (fx)MAX_SPEED << 16);
    bullets_set_position(s, 0, 0, 0);
    fly(1, most, 0);
    assert_true(s->speed_q32[0] == most && s->speed[0] == (fx)MAX_SPEED << 16);
    for (int64_t n = 4; n < 8; n++) {
        bullets_set_speed(s, 0, (n << Q32_EXTRA_BITS) + 0x8000);
        assert_int_equal(s->speed[0], n + (n & 1));
        bullets_set_speed(s, 0, -(n << Q32_EXTRA_BITS) - 0x8000);
        assert_int_equal(s->speed[0], -(n + (n & 1)));
    }

    /* what was fine leaves nothing behind */
    bullets_start_program(s, 0, 0, false);
    assert_true(!s->speed_q32[0] && !s->travel_q32[0] && !s->x_low[0] && !s->y_low[0] && !(s->flags[0] & BULLET_FINE));
    rig_close(&rig);
}

RUN_TESTS(NULL, NULL)
