/*
 * test_lead.c - steps that lead a bullet, against their formulas in quadruple precision: in every frame it is at the
 * nearest fx, and it flies on as it flew. And what scripts say and do to them. The oracle is libquadmath.
 */
#include <quadmath.h>
#include "rig.h"

static struct rig_game g;
static struct rig rig;
static struct rng rng;

static const __float128 TURN = 4294967296.0;

static void end(void)
{
    rig_free(&rig);
    rig_game_free(&g);
}

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
};

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

static void lead(const struct motion_step *p, const struct start *a, uint32_t n, double *worst)
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
    else if (vx || vy)
        assert_true(b->dir[0] == trig_atan2(vy, vx) && b->speed[0] == fx_min(fx_hypot(vx, vy), MAX_SPEED << 16));
    move(&w);
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
        uint32_t n = 1 + (uint32_t)rng_below(&rng, run % 50 ? 90 : 3000);
        struct start a = { number(far * px), number(far * px), number(3 * px), (ang)rng_next(&rng) };
        struct motion_step p = { .duration = n };
        switch (run % 6) {
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
    end();
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
    end();
}

#define KINDS                                                                                                          \
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })\n"                                                    \
    "shot.def('bolt', { sprite = 'dot', hit = { circle = 3 } })\n"                                                     \
    "enemy.def('foe', { sprite = 'wink', hit = { box = { 9, 9 } }, hp = 50 })\n"                                       \
    "local function dot(t) t.kind, t.speed, t.motion = 'dot', t.speed or 1, motion.def(t.motion) return "              \
    "bullet.fire(t) end\n"                                                                                             \
    "local function near(a, b) assert(math.abs(a - b) < 1e-4, ('%.6f, expected %.6f'):format(a, b)) end\n"

/* Its asserts are the test. */
static void holds(const char *text, int frames)
{
    struct manifest m = rig_manifest();

    m.has_orbit = 1;
    m.bullet_values = 3;
    rig_script(&g, &m, text);
    rig_power(&rig, &g, NULL);
    rig_run(&rig, frames);
    end();
}

TEST(scripts)
{
    /* go_to: at a speed, to values, which may change meanwhile; then on with the next step */
    holds(KINDS "value.def('tx') value.def('ty') \n"
                "task.go(function()\n"
                "  local a = dot { x = 10, y = 10, motion = { { go_to = { 40, 50 }, speed = 5 }, { speed = 0 } } }\n"
                "  local b = dot { x = 10, y = 10, motion = { { go_to = { 'tx', 'ty' }, over = 20, ease = 'out' }, { "
                "dir = 0, speed "
                "= 2 } }, tx = 90, ty = 70 }\n"
                "  wait(9) assert(a.x < 40) b.tx = 5 wait(1) assert(a.x == 40 and a.y == 50) wait(1) assert(a.x == 40 "
                "and a.speed == "
                "0)\n"
                "  wait(9) assert(b.x == 90 and b.y == 70) wait(1) assert(b.x == 92 and b.y == 70)\n"
                "end)\n",
          30);
    /* around an enemy that moves; when it dies, on as it flew */
    holds(KINDS "task.go(function()\n"
                "  local e = enemy.spawn { kind = 'foe', x = 100, y = 60 }\n"
                "  e:move { x = 140, y = 90, over = 40 }\n"
                "  local b = dot { from = e, dir = 30, around = e, motion = { { orbit = 0, radius_to = 40, spin = 6, "
                "over = 20 },\n"
                "    { orbit = 40, spin = 6, over = forever }, { speed = 9 } } }\n"
                "  assert(b.around == e)\n"
                "  for k = 1, 30 do wait(1)\n"
                "    local r, a = k <= 20 and 2 * k or 40, math.rad(30 + 6 * k)\n"
                "    near(b.x, e.x + r * math.cos(a)) near(b.y, e.y + r * math.sin(a))\n"
                "  end\n"
                "  e:remove() local dir = b.dir wait(1) assert(b.speed == 9 and b.dir == dir)\n"
                "end)\n",
          60);
    /* around bullets, lower and higher slots, in the same block and in another: a frame behind, always */
    holds(KINDS
          "task.go(function()\n"
          "  local lead, last = {}, {}\n"
          "  for i = 1, 200 do lead[i] = dot { x = 60, y = 60 + i / 4, dir = 0, motion = { { wait = forever } } } end\n"
          "  for i = 1, 50 do last[i] = lead[i * 4]; dot { x = 60, y = 60, dir = 0, tag = 'f' .. i, around = last[i],\n"
          "    motion = { { orbit = 10, spin = 0, over = forever } } } end\n"
          "  bullet.clear { tag = 'none' }\n"
          "  wait(5)\n"
          "  for i = 1, 50 do bullet.each('f' .. i, function(b) near(math.sqrt((b.x - last[i].x + 1) * (b.x - "
          "last[i].x + 1) +\n"
          "    (b.y - last[i].y) * (b.y - last[i].y)), 10) end) end\n"
          "end)\n",
          9);
    /* nothing to go round: the step is over at once; a group takes another thing */
    holds(
        KINDS
        "task.go(function()\n"
        "  local e = enemy.spawn { kind = 'foe', x = 100, y = 60 }\n"
        "  local b = dot { x = 50, y = 50, dir = 0, tag = 't', motion = { { orbit = 9, over = 5 }, { speed = 2 } } }\n"
        "  wait(1) assert(b.x == 52 and b.motion == nil)\n"
        "  bullet.group('t').around = e assert(b.around == e) b.motion = motion.def { { orbit = 9, over = 5 } }\n"
        "  wait(1) near(math.sqrt((b.x - 100) * (b.x - 100) + (b.y - 60) * (b.y - 60)), 9) b.around = nil\n"
        "  local x, vx = b.x, b.vx wait(1) assert(b.x == x + vx and b.around == nil)\n"
        "end)\n",
        9);
    /* a script's write takes it away for the rest of the step */
    holds(KINDS "task.go(function()\n"
                "  local m = { { go_to = { 90, 10 }, over = 8 }, { dir = 90 } }\n"
                "  local a, b, c = dot { x = 10, y = 10, motion = m }, dot { x = 10, y = 10, motion = m }, nil\n"
                "  c = dot { x = 10, y = 10, dir = 90, motion = { { wave = 20, every = 8, over = 8 } } }\n"
                "  wait(2) a.dir = 180 b.x = 100 c.x = 50\n"
                "  assert(c.dir == 90 and c.speed == 1)\n"
                "  wait(1) assert(a.x == 20 and b.x == 110 and c.x == 50 and c.y == 13)\n"
                "  wait(6) assert(a.dir == 90 and b.dir == 90 and c.x == 50 and c.y == 19)\n"
                "end)\n",
          12);
    /* a wave for ever, then another program; fine after it */
    holds(KINDS "task.go(function()\n"
                "  local a = dot { x = 50, y = 10, dir = 90, motion = { { wave = 20, every = 8, phase = 90, over = "
                "forever } } }\n"
                "  wait(4) near(a.x, 90) near(a.y, 14) wait(4) near(a.x, 50) assert(a.dir == 90)\n"
                "  a.motion = motion.def { fine = true } wait(2) assert(a.speed == 1 and a.dir == 90)\n"
                "end)\n",
          14);
}

TEST(bounce_steps)
{
    /* two walls, then on; what stands inside runs in the frame after the bounce, and takes its time */
    holds("bullet.def('red', { sprite = 'dot', hit = 'none', bank = 9 })\n" KINDS "task.go(function()\n"
          "  local a = dot { x = 5, y = 50, dir = 180, speed = 2, motion = { { bounce = 1, walls = 'left right',\n"
          "    { bank = 7 }, { wait = 2 }, { kind = 'red' } }, { dir = 90 } } }\n"
          "  wait(2) assert(a.x == 1 and a.bank == 0) wait(1) assert(a.x == 1 and a.dir == 0 and a.bank == 0)\n"
          "  wait(1) assert(a.x == 3 and a.bank == 7 and a.vx == 2) wait(1) assert(a.x == 5 and a.kind == 'dot')\n"
          "  wait(1) assert(a.x == 5 and a.y == 52 and a.kind == 'red' and a.motion == nil)\n"
          "end)\n",
          9);
    /* a wall that is none; over ends it; a corner is one bounce; twice in turn */
    holds(
        KINDS
        "task.go(function()\n"
        "  local a = dot { x = 5, y = 50, dir = 180, speed = 2, motion = { { bounce = 9, walls = 'top', over = 6 }, { "
        "speed = 1 } } }\n"
        "  local b = dot { x = 3, y = 3, dir = 225, speed = 2, motion = { { bounce = 1 }, { speed = 1 } } }\n"
        "  local c = dot { x = 1, y = 50, dir = 180, speed = 2, motion = { { loop = 2, { bounce = 1, walls = 'left' "
        "},\n"
        "    { dir = 180 } }, { speed = 0 } } }\n"
        "  wait(3) assert(a.x == -1 and b.x > 0 and b.y == b.x and b.dir == 45)\n"
        "  wait(3) assert(a.x == -7 and a.speed == 2 and c.speed == 0) wait(1) assert(a.x == -8 and b.speed == 1)\n"
        "end)\n",
        9);
    /* a script turns it in the frame of its bounce */
    holds(KINDS
          "task.go(function()\n"
          "  local a = dot { x = 1, y = 50, dir = 180, speed = 2, motion = { { bounce = 3 } } }\n"
          "  wait(1) assert(a.x == 1) a.dir = 90 wait(1) assert(a.x == 1 and a.y == 52) wait(1) assert(a.y == 54)\n"
          "  a.motion = nil wait(1) assert(a.y == 56)\n"
          "end)\n",
          9);
}

static void refused(const char *steps, const char *message)
{
    static char text[1024];

    snprintf(text, sizeof text, "value.def('v') motion.def { %s }", steps);
    struct manifest m = rig_manifest();

    m.bullet_values = 1;
    rig_script(&g, &m, text);
    rig_power_any(&rig, &g, NULL);
    if (!rig_fault(&rig))
        fail_msg("%s: no fault", steps);
    if (!strstr(rig_fault(&rig)->message, message))
        fail_msg("%s: expected \"%s\", got \"%s\"", steps, message, rig_fault(&rig)->message);
    end();
}

TEST(errors)
{
    refused("{ go_to = { 1, 2 } }", "step 1: `go_to` requires either `over` (frames) or `speed`");
    refused("{ go_to = { 1, 2 }, over = 3, speed = 2 }", "`go_to` requires either `over` (frames) or `speed`");
    refused("{ go_to = { 1, 2 }, speed = 2, ease = 'in' }", "`ease` requires `over`");
    refused("{ go_to = { 1, 2 }, speed = 0 }", "speed: expected a number above 0");
    refused("{ go_to = { 1, 2 }, over = forever }", "never arrives");
    refused("{ go_to = { 1 }, over = 3 }", "go_to: expected { x, y }");
    refused("{ go_to = { x = 1, y = 2 }, over = 3 }", "go_to: expected { x, y }");
    refused("{ go_to = { 1, 99999 }, over = 3 }", "step 1: go_to: expected a number from -16383 to 16383 px");
    refused("{ go_to = { 'v', 'quick' }, over = 3 }", "go_to: expected a number or the name of a value");
    refused("{ go_to = { 1, 2 }, over = 3, turn = 5 }", "`turn` cannot be combined with `go_to`");
    refused("{ go_to = { 1, 2 }, over = 3, wave = 5 }", "`go_to` and `wave` cannot be combined");
    refused("{ polar = 1 }", "`polar` requires `over`");
    refused("{ wave = 1, over = 4 }", "`wave` requires `every`");
    refused("{ orbit = 1, over = 4 }", "add `around = true` to `board` in rom.lua");
    refused("{ orbit = 1, at = { 1, 2 }, radius_to = 4, over = forever }", "`radius_to` with `over = forever`");
    refused("{ orbit = -1, at = { 1, 2 }, over = 4 }", "orbit: expected a number from 0 to 8191 px");
    refused("{ turn = 1, spin = 3 }", "`spin` requires `go_to`, `polar`, `wave` or `orbit`");
    refused("{ speed = 1, over = forever }", "`speed` with `over = forever` never arrives");
    refused("{ loop = 2, { wait = 1 }, spin = 3 }", "`spin` cannot be combined with `loop`");
    refused("{ bounce = 0 }", "bounce: expected forever or a whole number from 1 to 65534 times, got 0");
    refused("{ bounce = 2, walls = 'up' }", "walls: expected one or more of \"left right top bottom\", got \"up\"");
    refused("{ bounce = 2, walls = ' ' }", "walls: expected one or more of");
    refused("{ bounce = 2, turn = 1 }", "`turn` cannot be combined with `bounce`");
    refused("{ turn = 2, walls = 'left' }", "`walls` requires `bounce`");
    refused("{ bounce = 2, { loop = 2, { bounce = 1 } } }", "`bounce` cannot be nested in `bounce`");
    refused("fine = true, { bounce = 2 }", "cannot be used in a fine motion");
    refused("fine = true, { go_to = { 1, 2 }, over = 3 }", "cannot be used in a fine motion");
}

RUN_TESTS(NULL, NULL)
