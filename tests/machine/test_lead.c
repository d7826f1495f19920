/*
 * test_lead.c - steps that lead a bullet, against their formulas in quadruple precision: in every frame it is at the
 * nearest fx, and it flies on as it flew. The oracle is libquadmath. tests/scripts/lead.lua has what scripts do to
 * them.
 */
#include <quadmath.h>
#include "rig.h"

static struct rig_game g;
static struct rig rig;
static struct rng rng;

static const __float128 TURN = 4294967296.0;

static int32_t number(int64_t most)
{
    return (int32_t)((int64_t)rng_below(&rng, (uint64_t)(2 * most + 1)) - most);
}

static __float128 sine(__float128 turns)
{
    return sinq(2 * M_PIq * turns);
}

static __float128 cosine(__float128 turns)
{
    return cosq(2 * M_PIq * turns);
}

/* Share of a move after k of n frames. */
static __float128 share(int ease, __float128 t)
{
    switch (ease) {
    case EASE_IN:
        return t * t;
    case EASE_OUT:
        return 1 - (1 - t) * (1 - t);
    case EASE_BOTH:
        return t < 0.5Q ? 2 * t * t : 1 - 2 * (1 - t) * (1 - t);
    default:
        return t;
    }
}

struct start {
    fx x, y, speed;
    ang dir;
    fx vx, vy; /* of dir and speed, as the bullet has them */
};

/* Frame by frame: the velocity on an axis after k frames of n, and how far they led, in units of Q32. */
static void accelerated(const struct motion_step *p, int axis, fx from, uint32_t k, uint32_t n, __float128 *v,
                        __float128 *way)
{
    const __float128 start = (__float128)from * 65536, number = axis ? p->accel : p->speed;
    const __float128 most = p->mode & MODE_HAS_LIMIT ? (__float128)(axis ? p->size_to : p->size) * 65536 : 1e30Q;
    const bool to = p->mode & (axis ? MODE_TO_VY : MODE_TO_VX);

    *v = start;
    *way = 0;
    for (uint32_t j = 1; j <= k; j++) {
        if (to)
            *v = start + (number - start) * j / n;
        else if (number > 0 && *v < most)
            *v = *v + number < most ? *v + number : most;
        else if (number < 0 && *v > -most)
            *v = *v + number > -most ? *v + number : -most;
        *way += *v;
    }
}

/* Where the formula has the bullet in frame k of n, in units of fx. */
static void formula(const struct motion_step *p, const struct start *a, uint32_t k, uint32_t n, __float128 *x,
                    __float128 *y)
{
    __float128 t = (__float128)k / n, cx = a->x, cy = a->y, r = 0, angle = a->dir / TURN;

    if (p->actions & DOES_GO_TO) {
        *x = a->x + (p->x - (__float128)a->x) * share(p->mode & MODE_EASE, t);
        *y = a->y + (p->y - (__float128)a->y) * share(p->mode & MODE_EASE, t);
        return;
    }
    if (p->actions & DOES_WAVE) {
        __float128 way = (__float128)a->speed * k, from = p->dir / TURN;
        __float128 to = from + roundq((k % p->count) * TURN / p->count) / TURN;
        __float128 side = p->size * (sine(to) - sine(from));
        *x = a->x + way * cosine(angle) - side * sine(angle);
        *y = a->y + way * sine(angle) + side * cosine(angle);
        return;
    }
    if (p->actions & DOES_ACCEL_XY) {
        __float128 v, way[2];
        accelerated(p, 0, a->vx, k, n, &v, &way[0]);
        accelerated(p, 1, a->vy, k, n, &v, &way[1]);
        *x = a->x + way[0] / 65536;
        *y = a->y + way[1] / 65536;
        return;
    }
    if (p->mode & MODE_HAS_CENTRE) {
        cx = p->x;
        cy = p->y;
        r = fx_hypot(a->x - p->x, a->y - p->y);
        if (a->x != p->x || a->y != p->y)
            angle = trig_atan2(a->y - p->y, a->x - p->x) / TURN;
    }
    if (p->actions & DOES_POLAR)
        r += (__float128)p->speed / 65536 * k;
    else
        r = p->size + (p->mode & MODE_HAS_SIZE_TO ? ((__float128)p->size_to - p->size) * t : 0);
    angle += (__float128)p->turn / TURN * k;
    *x = cx + r * cosine(angle);
    *y = cy + r * sine(angle);
}

static void move(struct motion_world *w)
{
    const struct box world = { -(WORLD_EDGE << 16), -(WORLD_EDGE << 16), WORLD_EDGE << 16, WORLD_EDGE << 16 };

    bullets_move(&rig.b->bullets, w, &world, NULL, false);
    w->clock++;
}

/* How far the bullet is from where it should be, in units of fx. */
static double off(const struct motion_step *p, const struct start *a, uint32_t k, uint32_t n)
{
    __float128 x, y;

    formula(p, a, k, n, &x, &y);
    x = fabsq(x - rig.b->bullets.x[0]);
    y = fabsq(y - rig.b->bullets.y[0]);
    return (double)(x > y ? x : y);
}

/* After its last frame, an accelerated bullet has the velocity of the formula, not that of its rounded places. */
static void check_final_velocity(const struct motion_step *p, const struct start *a, uint32_t n, fx *vx, fx *vy)
{
    const struct bullets *b = &rig.b->bullets;
    __float128 v[2], way;

    accelerated(p, 0, a->vx, n, n, &v[0], &way);
    accelerated(p, 1, a->vy, n, n, &v[1], &way);
    *vx = b->vx[0];
    *vy = b->vy[0];
    assert_true(fabsq(v[0] / 65536 - *vx) < 0.5001Q && fabsq(v[1] / 65536 - *vy) < 0.5001Q);
    assert_true(b->speed[0] == fx_hypot(*vx, *vy) && (!(*vx || *vy) || b->dir[0] == trig_atan2(*vy, *vx)));
}

static void lead(const struct motion_step *p, struct start *a, uint32_t n, double *worst)
{
    struct bullets *b = &rig.b->bullets;
    struct bullet_spec s = { .x = a->x, .y = a->y, .dir = a->dir, .speed = a->speed };
    struct motion_world w = board_motion_world(rig.b, false);

    if (b->s.live)
        bullets_drop(b, 0);
    rig.b->motions.s.live = rig.b->steps.s.live = 0;
    s.motion = (uint16_t)(rig_motion(rig.b, p, 1, false) + 1);
    w.clock = 77;
    assert_int_equal(bullets_fire(b, &s, w.clock), 0);
    a->vx = b->vx[0];
    a->vy = b->vy[0];
    for (uint32_t k = 1; k <= n; k++) {
        fx x = b->x[0], y = b->y[0];
        move(&w);
        double now = off(p, a, k, n);
        *worst = now > *worst ? now : *worst;
        if (now > 0.5 + 1e-4)
            fail_msg("step %x: frame %u of %u: %.4f units off", (unsigned)p->actions, k, n, now);
        if (abs(b->x[0] - x) <= MAX_SPEED << 16 && abs(b->y[0] - y) <= MAX_SPEED << 16)
            assert_true(b->vx[0] == b->x[0] - x && b->vy[0] == b->y[0] - y && b->speed_bound >= fx_abs(b->vx[0]));
    }
    if (p->actions & DOES_GO_TO)
        assert_true(b->x[0] == p->x && b->y[0] == p->y);
    fx x = b->x[0], y = b->y[0], vx = b->vx[0], vy = b->vy[0];
    if (p->actions & DOES_WAVE)
        trig_polar(a->speed, a->dir, &vx, &vy);
    else if ((vx || vy) && !(p->actions & DOES_ACCEL_XY))
        assert_true(b->dir[0] == trig_atan2(vy, vx) && b->speed[0] == fx_min(fx_hypot(vx, vy), MAX_SPEED << 16));
    move(&w);
    if (p->actions & DOES_ACCEL_XY)
        check_final_velocity(p, a, n, &vx, &vy);
    assert_true(b->x[0] == x + vx && b->y[0] == y + vy && !b->motion[0] && !b->travel_q32[0]);
}

TEST(formulas)
{
    double worst = 0;

    rig_script(&g, NULL, "");
    rig_power(&rig, &g, NULL);
    rng_seed(&rng, 5);
    for (int run = 0; run < 4000; run++) {
        const int64_t px = FX_ONE, far = run % 7 ? 400 : 3000;
        uint32_t n = 1 + (uint32_t)rng_below(&rng, run % 50 ? 90 : run % 8 == 5 || run % 8 == 6 ? 300 : 3000);
        struct start a = { number(far * px), number(far * px), number(3 * px), (ang)rng_next(&rng), 0, 0 };
        struct motion_step p = { .duration = n };
        switch (run % 8) {
        case 0:
        case 1:
            p.actions = DOES_GO_TO;
            p.x = number(far * px), p.y = number(far * px);
            p.mode = (uint8_t)rng_below(&rng, 4);
            break;
        case 2:
            p.actions = DOES_POLAR;
            p.speed = (int64_t)number(2 * px) * 65536 + number(65535);
            p.turn = number((1 << 27));
            break;
        case 3:
            p.actions = DOES_POLAR;
            p.mode = MODE_HAS_CENTRE;
            p.x = number(far * px), p.y = number(far * px);
            p.speed = (int64_t)number(px) * 65536;
            p.turn = number((1 << 27));
            break;
        case 4:
            p.actions = DOES_WAVE;
            p.size = number(200 * px);
            p.count = (uint16_t)(1 + rng_below(&rng, 300));
            p.dir = (ang)rng_next(&rng);
            break;
        case 5:
            p.actions = DOES_ACCEL_XY;
            p.mode = run % 3 ? MODE_HAS_LIMIT : 0;
            p.size = abs(number(4 * px)), p.size_to = abs(number(4 * px));
            p.speed = (int64_t)number(px / 8) * number(px) / (run % 11 ? 1 : 5000);
            p.accel = run % 5 ? (int64_t)number(px / 8) * number(px) : 0;
            break;
        case 6:
            p.actions = DOES_ACCEL_XY;
            p.mode = (uint8_t)(MODE_TO_VX | (run % 3 ? MODE_TO_VY : 0));
            p.speed = (int64_t)number(3 * px) * 65536 + number(65535);
            p.accel = run % 3 ? (int64_t)number(3 * px) * 65536 + number(65535) : 0;
            break;
        default:
            p.actions = DOES_ORBIT;
            p.mode = MODE_HAS_CENTRE | (run % 4 ? MODE_HAS_SIZE_TO : 0);
            p.x = number(far * px), p.y = number(far * px);
            p.size = abs(number(far * px)), p.size_to = abs(number(far * px));
            p.turn = number(INT32_MAX);
        }
        lead(&p, &a, n, &worst);
    }
    print_message("# worst distance from the formula: %.6f units of 1/65536 px\n", worst);
    assert_true(worst > 0.49);
    rig_close(&rig);
}

/* After up to 2^32 - 1 frames, at all speeds: the closed form, or clamped far outside the world. */
TEST(long_acceleration)
{
    const __float128 far = (__float128)(1ll << 47);
    struct motion_step p = { .actions = DOES_ACCEL_XY };
    struct steps s = { .mode = &p.mode, .size = &p.size, .size_to = &p.size_to, .speed = &p.speed, .accel = &p.accel };
    uint32_t inside = 0;

    rng_seed(&rng, 6);
    for (int run = 0; run < 200000; run++) {
        const int small = (int)rng_below(&rng, 46), frames = (int)rng_below(&rng, 31);
        const bool to = run % 2;
        const uint32_t n = (uint32_t)(rng_next(&rng) >> 33 >> frames) % 1000000000u + 1;
        const uint32_t k = to ? 1 + (uint32_t)rng_below(&rng, n) : (uint32_t)(rng_next(&rng) >> 32 >> frames);
        const struct motion_lead l = { .vx = number(MAX_SPEED << 16) >> rng_below(&rng, 29) };
        int64_t v[2], way[2];
        p.speed = ((int64_t)number(MAX_SPEED << 16) * 65536 + number(65535)) >> small;
        p.mode = to ? MODE_TO_VX : 0;
        motion_accelerate(&s, 0, &l, k, n, v, way);
        const __float128 start = (__float128)l.vx * 65536, half = (__float128)k * ((__float128)k + 1) / 2;
        const __float128 want = start * k + (to ? (p.speed - start) / n : (__float128)p.speed) * half;
        if (fabsq(want) >= far)
            assert_true((want < 0) == (way[0] < 0) && llabs(way[0]) >= 1ll << 47);
        else if (fabsq(want - way[0]) >= 1)
            fail_msg("%d: %u of %u frames: %.3f units of 2^-32 px off", run, k, n, (double)(want - way[0]));
        inside += fabsq(want) < far;
    }
    assert_true(inside > 50000);
}

/* Where something that flies from v by `speed` a frame is in frame k, between walls at 0 and w. */
static int64_t folded(int64_t v, int64_t speed, uint32_t k, int64_t w)
{
    int64_t at = (v + speed * k) % (2 * w);

    at = at < 0 ? at + 2 * w : at;
    return at > w ? 2 * w - at : at;
}

/* Bounces between all walls, exactly at the reflected place in every frame; the bound on speeds holds. */
TEST(bounces)
{
    struct bullets *b;

    rig_script(&g, NULL, "");
    rig_power(&rig, &g, NULL);
    rng_seed(&rng, 8);
    b = &rig.b->bullets;
    const struct motion_step steps[] = {
        { .actions = DOES_LOOP | DOES_BOUNCE, .count = MOTION_FOREVER, .jump = 3 },
        { .actions = DOES_BOUNCE, .mode = MODE_WALLS, .duration = UINT32_MAX, .jump = 3 },
        { .actions = DOES_LOOP_END, .jump = 1 }
    };
    for (int run = 0; run < 400; run++) {
        struct motion_world w = board_motion_world(rig.b, false);
        fx x = (fx)rng_below(&rng, (uint64_t)w.field.x1 + 1), y = (fx)rng_below(&rng, (uint64_t)w.field.y1 + 1);
        struct bullet_spec s = { .x = x,
                                 .y = y,
                                 .speed = number(run % 9 ? 8 * FX_ONE : MAX_SPEED << 16),
                                 .dir = run % 5 ? (ang)rng_next(&rng) : (ang)rng_below(&rng, 8) << 29 };
        if (run % 4 == 0) /* from a wall */
            s.x = x = run % 8 ? 0 : w.field.x1;
        if (b->s.live)
            bullets_drop(b, 0);
        rig.b->motions.s.live = rig.b->steps.s.live = 0;
        s.motion = (uint16_t)(rig_motion(rig.b, steps, 3, false) + 1);
        assert_int_equal(bullets_fire(b, &s, 0), 0);
        fx vx = b->vx[0], vy = b->vy[0];
        for (uint32_t k = 1; k < 300; k++) {
            move(&w);
            if (b->x[0] != folded(x, vx, k, w.field.x1) || b->y[0] != folded(y, vy, k, w.field.y1))
                fail_msg("run %d: frame %u: not at the reflected place", run, k);
            assert_true(b->speed_bound >= fx_abs(b->vx[0]) && b->speed_bound >= fx_abs(b->vy[0]));
        }
    }
    rig_close(&rig);
}

RUN_TESTS(NULL, NULL)
