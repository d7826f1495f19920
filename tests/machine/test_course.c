/*
 * test_course.c - steps in their middle, of many bullets at once, against the same bullets moved one by one: every
 * column is the same after every frame, whatever the steps' numbers, the targets, and what scripts take away.
 */
#include "rig.h"

enum { PROGRAMS = 12, STEPS = 4, FRAMES = 60 };

static struct rig_game g;
static struct rig at_once, singly;
static struct rng rng;

static int64_t below(int64_t n)
{
    return (int64_t)rng_below(&rng, (uint64_t)n);
}

/* Usual, or the greatest there may be. */
static int64_t any_speed(void)
{
    const int64_t most = (int64_t)MAX_SPEED << 32;

    switch (below(6)) {
    case 0:
        return below(2) ? most : -most;
    case 1:
        return below(2 * most + 1) - most;
    default:
        return below((int64_t)9 << 32) - ((int64_t)4 << 32);
    }
}

static struct motion_step any_step(void)
{
    static const uint32_t ops[] = { DOES_TURN, DOES_SPEED, DOES_ACCEL, DOES_HOME, DOES_AIM, DOES_DIR, DOES_BANK };
    struct motion_step s = { .actions = DOES_WAIT,
                             .duration = (uint32_t)(below(5) ? below(20) : below(2)),
                             .bank = (uint8_t)below(16),
                             .dir = (ang)rng_next(&rng),
                             .turn = (int32_t)rng_next(&rng) >> below(20),
                             .home = (ang)(rng_next(&rng) >> 33 >> below(20)),
                             .speed = any_speed(),
                             .accel = any_speed() >> below(12) };

    for (int n = (int)below(4); n > 0; n--)
        s.actions |= ops[below(7)];
    return s;
}

/* Programs alike in both games: some begin anew for ever, some end and let fly, some take the bullet away. */
static void define(bool fine[PROGRAMS + 1])
{
    for (int p = 0; p < PROGRAMS; p++) {
        struct motion_step steps[STEPS + 3];
        uint32_t n = 0, loop = (uint32_t)below(2);
        if (loop)
            steps[n++] = (struct motion_step){ .actions = DOES_LOOP, .count = MOTION_FOREVER, .jump = STEPS + 2 };
        for (int k = 0; k < STEPS; k++)
            steps[n++] = any_step();
        if (loop) {
            steps[n - 1].duration += 1; /* a round takes time */
            steps[n++] = (struct motion_step){ .actions = DOES_LOOP_END, .jump = 1 };
        } else if (below(3) == 0)
            steps[n++] = (struct motion_step){ .actions = DOES_DIE };
        fine[p + 1] = below(4) == 0;
        rig_motion(at_once.b, steps, n, fine[p + 1]);
        assert_int_equal(rig_motion(singly.b, steps, n, fine[p + 1]), p);
    }
}

/* Rings of a program, so that neighbours run one step, and single bullets. */
static void fire(const bool fine[PROGRAMS + 1], uint32_t clock)
{
    struct bullet_spec s = { .x = (fx)(below(400) << 16), .y = (fx)(below(400) << 16) };
    const int n = below(3) ? 1 + (int)below(40) : 1;

    s.motion = (uint16_t)below(PROGRAMS + 1);
    s.is_fine = s.motion && fine[s.motion];
    s.speed = (fx)(any_speed() >> 16);
    s.delay = below(5) ? 0 : (uint32_t)(1 + below(5));
    for (int k = 0; k < n; k++, s.dir += 0x6789abc) {
        if (below(9) == 0)
            s.dir = (ang)below(8) << 29;
        assert_int_equal(bullets_fire(&at_once.b->bullets, &s, clock), bullets_fire(&singly.b->bullets, &s, clock));
    }
}

/* What scripts do between two moves. */
static void disturb(struct bullets *a, struct bullets *b)
{
    EACH_LIVE (i, &a->s) {
        const uint8_t mute = below(12) ? 0 : (uint8_t)below(4);
        if (a->step_flags[i] & STEP_BEGUN)
            a->step_flags[i] |= mute, b->step_flags[i] |= mute;
        if (below(30) == 0)
            a->dir[i] = b->dir[i] = (ang)rng_next(&rng);
    }
}

/* Beside the players: none, some, or more than a course looks at at once; some in the place of a bullet. */
enum { CROWD = 2 * SLOTS_BLOCK };
static fx crowd_x[CROWD], crowd_y[CROWD];
static uint64_t crowd_used[CROWD / SLOTS_BLOCK];
static struct slots crowd;

static void gather_crowd(const struct bullets *b)
{
    crowd = (struct slots){ .live_bits = crowd_used, .top = CROWD, .cap = CROWD };
    memset(crowd_used, 0, sizeof crowd_used);
    for (int64_t n = below(8); n > 0; n--) {
        const uint32_t i = (uint32_t)below(CROWD), at = (uint32_t)below(b->s.top + 1);
        const bool there = at < b->s.top && below(2);
        crowd.live += !(crowd_used[i / SLOTS_BLOCK] >> i % SLOTS_BLOCK & 1);
        crowd_used[i / SLOTS_BLOCK] |= 1ull << i % SLOTS_BLOCK;
        crowd_x[i] = there ? b->x[at] : (fx)(below(400) << 16);
        crowd_y[i] = there ? b->y[at] : (fx)(below(400) << 16);
    }
}

static void targets(void)
{
    gather_crowd(&at_once.b->bullets);
    for (int p = 0; p < MAX_PLAYERS; p++) {
        const fx x = (fx)(below(400) << 16), y = (fx)(below(400) << 16);
        at_once.b->player.in_game[p] = singly.b->player.in_game[p] = (uint8_t)(below(4) != 0);
        at_once.b->player.x[p] = singly.b->player.x[p] = x;
        at_once.b->player.y[p] = singly.b->player.y[p] = y;
    }
}

static void move(uint32_t clock)
{
    const fx most = WORLD_EDGE << 16;
    const struct box world = { -most, -most, most, most };
    struct motion_world a = board_motion_world(at_once.b, false), b = board_motion_world(singly.b, false);
    struct bullets *s = &singly.b->bullets;

    a.clock = b.clock = clock;
    if (clock % 3 == 0)
        a.targets = b.targets = (struct targets){ &crowd, crowd_x, crowd_y, NULL };
    bullets_move(&at_once.b->bullets, &a, &world, NULL, false);
    bullets_begin_move(s);
    EACH_LIVE (i, &s->s)
        if (bullets_move_one(s, &b, i) && (s->x[i] < -most || s->x[i] > most || s->y[i] < -most || s->y[i] > most))
            bullets_drop(s, i);
}

static void compare(const struct bullets *a, const struct bullets *b, uint32_t clock)
{
    assert_int_equal(a->s.live, b->s.live);
    assert_int_equal(a->work_done, b->work_done);
    EACH_LIVE (i, &a->s) {
        const bool same = a->x[i] == b->x[i] && a->y[i] == b->y[i] && a->vx[i] == b->vx[i] && a->vy[i] == b->vy[i] &&
                          a->dir[i] == b->dir[i] && a->speed[i] == b->speed[i] && a->bank[i] == b->bank[i] &&
                          a->motion[i] == b->motion[i] && a->pc[i] == b->pc[i] && a->step_end[i] == b->step_end[i] &&
                          a->step_start[i] == b->step_start[i] && a->step_flags[i] == b->step_flags[i] &&
                          a->speed_q32[i] == b->speed_q32[i] && a->travel_q32[i] == b->travel_q32[i] &&
                          a->x_low[i] == b->x_low[i] && a->flags[i] == b->flags[i] && a->y_low[i] == b->y_low[i];
        if (!same)
            fail_msg("clock %u: bullet %u differs", clock, i);
        assert_true(a->speed_bound >= fx_abs(a->vx[i]) && a->speed_bound >= fx_abs(a->vy[i]));
    }
    for (uint32_t block = 0; block < a->s.top / SLOTS_BLOCK; block++)
        assert_true(a->busy[block] == b->busy[block] && a->idle[block] == b->idle[block]);
}

TEST(courses)
{
    long moved = 0;

    rng_seed(&rng, 31);
    for (int run = 0; run < 120; run++) {
        bool fine[PROGRAMS + 1] = { false };
        rig_script(&g, NULL, "");
        rig_power(&at_once, &g, NULL);
        rig_power(&singly, &g, NULL);
        define(fine);
        for (uint32_t clock = 100; clock < 100 + FRAMES; clock++) {
            if (below(3) == 0)
                fire(fine, clock);
            targets();
            disturb(&at_once.b->bullets, &singly.b->bullets);
            move(clock);
            compare(&at_once.b->bullets, &singly.b->bullets, clock);
            moved += at_once.b->bullets.s.live;
        }
        rig_free(&at_once);
        rig_close(&singly);
    }
    print_message("# %ld moves\n", moved);
    assert_true(moved > 100000);
}

RUN_TESTS(NULL, NULL)
