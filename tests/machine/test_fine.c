/*
 * test_fine.c - fine motion against the formulas: one bullet with it and one without drift as the accuracy lab says; a
 * change of speed over n frames ends exactly where the closed form puts it. The oracle is libquadmath.
 */
#include <quadmath.h>
#include "rig.h"

static struct rig_game g;
static struct rig rig;
static struct rng rng;

static const __float128 Q32 = 4294967296.0;

static void begin(const char *text)
{
    struct manifest m = rig_manifest();

    m.margin = 1024;
    rig_script(&g, &m, text);
    rig_power(&rig, &g, NULL);
}

static void end(void)
{
    rig_free(&rig);
    rig_game_free(&g);
}

/* How far bullet i is from where it would be after flying `way` along its direction from (100, 100), in units of fx. */
static double off(uint32_t i, __float128 way)
{
    const struct bullets *b = &rig.b->bullets;
    __float128 turn = 2 * M_PIq * b->dir[i] / Q32;
    int64_t x, y;

    bullets_get_position(b, i, &x, &y);
    return (double)(hypotq(x / Q32 - 100 - way * cosq(turn), y / Q32 - 100 - way * sinq(turn)) * FX_ONE);
}

/* 0.002 px a frame for ten minutes: 16 headings, each a fine bullet (even slots) and an ordinary one. */
TEST(drift)
{
    enum { HEADINGS = 16 };
    double fine = 0, plain = 0, fine_600 = 0, plain_600 = 0;

    begin("bullet.def('dot', { sprite = 'dot', hit = 'none' })\n"
          "local fine = motion.def { fine = true }\n"
          "task.go(function()\n"
          "  for i = 1, 16 do\n"
          "    for k = 1, 2 do\n"
          "      bullet.fire { kind = 'dot', x = 100, y = 100, speed = 0.002, dir = 22 * i + 1,\n"
          "                    motion = k == 1 and fine or nil }\n"
          "    end\n"
          "  end\n"
          "end)\n");
    rig_run(&rig, 600);
    for (uint32_t i = 0; i < 2 * HEADINGS; i += 2) {
        fine_600 = fmax(fine_600, off(i, 600 * (__float128)0.002));
        plain_600 = fmax(plain_600, off(i + 1, 600 * (__float128)0.002));
    }
    rig_run(&rig, 36000 - 600);
    for (uint32_t i = 0; i < 2 * HEADINGS; i += 2) {
        fine = fmax(fine, off(i, 36000 * (__float128)0.002));
        plain = fmax(plain, off(i + 1, 36000 * (__float128)0.002));
    }
    /* 0.002 in Q15.16 is 131 units for 131.07, and each part of the velocity is up to half a unit off besides */
    print_message("# worst drift in px after 600 frames: %.1e fine, %.1e not; after 36,000: %.1e fine, %.1e not\n",
                  fine_600 / FX_ONE, plain_600 / FX_ONE, fine / FX_ONE, plain / FX_ONE);
    assert_true(fine_600 < 0.004 && fine > 0.2 && fine < 0.24); /* 0.0000034 px */
    assert_true(plain_600 > 340 && plain_600 < 380);
    assert_true(plain > 36000 * 0.58 && plain < 36000 * 0.62); /* 0.33 px */
    end();
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
    begin("");
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
    end();
}

/* The greatest speed to and fro for hours: the count of the way goes round and round, and the place stays. */
TEST(ends)
{
    const int64_t most = (int64_t)MAX_SPEED << 32;
    const struct motion_step still = { .actions = DOES_WAIT, .duration = UINT32_MAX },
                             faster = { .actions = DOES_ACCEL, .duration = 2, .accel = most };
    struct bullets *s;
    int64_t x, y;

    begin("");
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
    end();
}

/* Velocities by their parts: off by what a direction is, half an ang, and by the bits beyond 31 that it is taken
 * from. */
TEST(parts)
{
    begin("");
    rng_seed(&rng, 8);
    set_off(&(struct motion_step){ .actions = DOES_WAIT, .duration = UINT32_MAX }, 1, 0);
    for (int run = 0; run < 3000; run++) {
        struct bullets *s = &rig.b->bullets;
        int64_t vx = number((int64_t)1 << (4 + run % 40)), vy = number((int64_t)1 << (4 + run * 7 % 40)), x, y;
        bullets_set_velocity(s, 0, vx, vy);
        bullets_get_velocity(s, 0, &x, &y);
        double size = sqrt((double)vx * (double)vx + (double)vy * (double)vy), slack = 1 + size / (1 << 29);
        if (fabs((double)(x - vx)) > slack || fabs((double)(y - vy)) > slack)
            fail_msg("set (%lld, %lld), is (%lld, %lld)", (long long)vx, (long long)vy, (long long)x, (long long)y);
    }
    end();
}

/* What scripts see and do. */
TEST(scripts)
{
    begin("bullet.def('dot', { sprite = 'dot', hit = 'none' })\n"
          "local fine, plain = motion.def { fine = true }, motion.def { { wait = 9 } }\n"
          "assert(fine ~= motion.def { fine = false, { wait = 8 } } and fine == motion.def { fine = true })\n"
          "assert(motion.def { fine = true, { wait = 9 } } ~= plain)\n"
          "local step = 1 / 4294967296\n"
          "task.go(function()\n"
          "  local b = bullet.fire { kind = 'dot', x = 50, y = 60, dir = 0, speed = 3 * step, motion = fine }\n"
          "  assert(b.speed == 3 * step and b.vx == 3 * step and b.vy == 0 and b.x == 50)\n"
          "  wait(100)\n"
          "  assert(b.x == 50 + 300 * step and b.y == 60 and b.motion == fine)\n"
          "  b.speed = 5 * step wait(2) assert(b.x == 50 + 310 * step)\n"
          "  b.dir = 90 wait(1) assert(b.x == 50 + 310 * step and b.y == 60 + 5 * step)\n"
          "  b.x = 70 assert(b.x == 70) wait(1) assert(b.x == 70)\n"
          "  b.y = 80 + 7 * step assert(b.y == 80 + 7 * step) wait(1) assert(b.y == 80 + 12 * step and b.x == 70)\n"
          "  b.vx, b.vy = 0.1, 0 for _ = 1, 300 do b.vy = b.vy + 0.001 wait(1) end\n"
          "  assert(math.abs(b.vx - 0.1) < 1e-7 and math.abs(b.x - 100) < 1e-5) b.dir, b.x, b.y = 0, 70, 80\n"
          "  b.vx = 2 assert(b.speed == 2 and b.dir == 0 and b.vy == 0) wait(1) assert(b.x == 72)\n"
          "  b.speed = 5 * step wait(1) b.motion = fine assert(b.speed == 5 * step)\n"
          "  b.motion = nil assert(b.speed == 0 and b.vx == 0 and b.x == 72) wait(1) assert(b.x == 72)\n"
          "  b.speed = 1.5 b.motion = fine assert(b.speed == 1.5) wait(1) assert(b.x == 73.5)\n"
          "  b.motion = plain assert(b.vx == 1.5) wait(1) assert(b.x == 75)\n"
          /* an acceleration below a unit of Q15.16 */
          "  local m = motion.def { fine = true, { accel = 3 * step, over = 10 } }\n"
          "  local c = bullet.fire { kind = 'dot', x = 0, y = 0, dir = 0, speed = 0, motion = m }\n"
          "  wait(20) assert(c.speed == 30 * step and c.x == (3 * 55 + 30 * 10) * step)\n"
          "  board.note 'done'\n"
          "end)\n");
    rig_run(&rig, 500);
    assert_null(rig_fault(&rig) ? rig_fault(&rig)->message : NULL);
    assert_int_equal(rig.b->bullets.s.live, 2);
    end();
}

RUN_TESTS(NULL, NULL)
