/*
 * test_lasers.c - beams, bolts and curves against formulas: their shapes in each frame, whom they hit, which of their
 * points is nearest. tests/scripts/lasers.lua has the rest.
 */
#include <math.h>
#include "../../src/machine/lasers_run.h"
#include "rig.h"

static struct rig_game g;
static struct rig r;

static const char kinds[] =
    "laser.def('ray', { strip = 'dot', width = 10, hit = { share = 0.5 } })\n"
    "laser.def('wall', { strip = 'dot', width = 8, hit = { share = 1 }, graze = 0 })\n"
    "bullet.def('orb', { sprite = 'dot', hit = 'none' })\n"
    "enemy.def('fly', { sprite = 'dot', hit = { circle = 5 }, touch = false })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 16, safe = 0, lives = 90 })\n"
    "on.hit(function(p) print 'hit' p.safe = 1 end)\n"
    "on.graze(function() print 'graze' end)\n"
    "string.sys.join(1, 'ship')\n"
    "local p = player.get(1)\n"
    "p.x, p.y = 120, 200\n";

/* The script runs as a task of the first frame, with the player at (120, 200). */
static void begin(const char *script)
{
    static char text[4096];
    struct manifest m = rig_manifest();

    m.lasers = 8;
    m.curve_points = 256;
    snprintf(text, sizeof text, "%stask.go(function()\n%s\nend)\n", kinds, script);
    rig_with_sys(&g, &m, text);
    rig_power(&r, &g, NULL);
}

/* Has this frame printed the word? */
static bool printed(const char *word)
{
    const struct board_out *out = board_last_output(r.b);
    const char *at = strstr(out->log, word);

    return at && at < out->log + out->log_size;
}

/* ---- beams ---- */

/* A beam through the player's place: warns 5 frames, grows 3, holds 4, fades 2; 10 px wide. It grazes from its growth
 * on and hits as soon as half of its half width, and the player's 2 px, reach 4 px: when it is 8 px wide. */
TEST(states)
{
    static const enum laser_state states[] = { LASER_WARN, LASER_WARN, LASER_WARN, LASER_WARN, LASER_WARN,
                                               LASER_GROW, LASER_GROW, LASER_GROW, LASER_ON,   LASER_ON,
                                               LASER_ON,   LASER_ON,   LASER_FADE, LASER_FADE };
    static const double widths[] = { 10, 10, 10, 10, 10, 2.5, 5, 7.5, 10, 10, 10, 10, 6.666, 3.333 };

    begin(
        "laser.beam { kind = 'ray', x = 124, y = 20, dir = 90, length = 250, hold = 4, warn = 5, grow = 3, fade = 2 }");
    for (uint32_t age = 0; age < 14; age++) {
        rig_run(&r, 1);
        assert_int_equal(r.b->lasers.s.live, 1);
        assert_int_equal(lasers_shown_age(r.b, 0), age);
        assert_int_equal(lasers_state_of(r.b, 0, age), states[age]);
        assert_int_equal(lasers_width(&r.b->lasers, 0, age) / 66, (int)(widths[age] * 65536) / 66);
        bool dangerous = age >= 5 && age < 12;
        assert_int_equal(printed("hit"), dangerous && widths[age] / 4 + 2 >= 4);
        assert_int_equal(printed("graze"), age == 5);
    }
    rig_run(&r, 1);
    assert_int_equal(r.b->lasers.s.live, 0);
    rig_close(&r);
}

/* The body is where the head was; it has as many points as frames, at most those it asks for; it goes when the last one
 * has left. A bullet of the same motion flies beside the head, a pixel away. */
TEST(curve)
{
    static fx xs[400], ys[400];
    fx x, y;

    begin("local m = motion.def { { turn = 2, over = 60 }, { bounce = 1, walls = 'right' } }\n"
          "laser.curve { kind = 'wall', x = 20, y = 150, dir = 300, speed = 3, points = 40, motion = m }\n"
          "bullet.fire { kind = 'orb', x = 20, y = 151, dir = 300, speed = 3, motion = m }");
    xs[0] = 20 << 16;
    ys[0] = 150 << 16;
    for (int frame = 1; frame < 400; frame++) {
        rig_run(&r, 1);
        if (!r.b->lasers.s.live) {
            assert_true(frame > 60 + 40);
            x = xs[frame - 39], y = ys[frame - 39]; /* it left with its last point, and not before */
            assert_true(x < -(64 << 16) || x > 304 << 16 || y < -(64 << 16) || y > 384 << 16);
            x = xs[frame - 40], y = ys[frame - 40];
            assert_true(x >= -(64 << 16) && x <= 304 << 16 && y >= -(64 << 16) && y <= 384 << 16);
            assert_int_equal(r.b->laser_points.s.live, 0);
            assert_int_equal(r.b->laser_heads.s.live, 0);
            rig_close(&r);
            return;
        }
        xs[frame] = r.b->laser_heads.x[0];
        ys[frame] = r.b->laser_heads.y[0];
        if (r.b->bullets.s.live) {
            assert_int_equal(xs[frame], r.b->bullets.x[0]);
            assert_int_equal(ys[frame], r.b->bullets.y[0] - 65536);
        }
        assert_int_equal(lasers_corner_count(r.b, 0), frame < 39 ? frame + 1 : 40);
        for (uint32_t k = 0; k < lasers_corner_count(r.b, 0); k++) {
            lasers_get_corner(r.b, 0, k, &x, &y);
            assert_true(x == xs[frame - (int)k] && y == ys[frame - (int)k]);
            lasers_get_old_corner(r.b, 0, k, &x, &y);
            const int was = frame - (int)k - (frame > 1 && frame > (int)k);
            assert_true((x == xs[was] && y == ys[was]) || frame == 1);
        }
    }
    fail();
}

/* ---- hits against plain arithmetic ---- */

/* Is a point within far of a bar? With 128 bits, by its own formula. */
static bool is_near(int64_t px, int64_t py, int64_t ax, int64_t ay, int64_t bx, int64_t by, int64_t far)
{
    __extension__ typedef __int128 wide;
    const wide dx = bx - ax, dy = by - ay, ex = px - ax, ey = py - ay, fx_ = px - bx, fy = py - by;
    const wide along = ex * dx + ey * dy, all = dx * dx + dy * dy, f2 = (wide)far * far;

    if (along <= 0)
        return ex * ex + ey * ey <= f2;
    if (along >= all)
        return fx_ * fx_ + fy * fy <= f2;
    const wide cross = ex * dy - ey * dx;
    /* cross^2 <= f2 * all, both below 2^126 for what this test has */
    return cross * cross <= f2 * all;
}

struct was {
    fx x[LASER_MAX_POINTS], y[LASER_MAX_POINTS];
    uint32_t n;
    fx px, py;
};

static void note_was(struct was *w)
{
    w->n = lasers_corner_count(r.b, 0);
    for (uint32_t k = 0; k < w->n; k++)
        lasers_get_corner(r.b, 0, k, &w->x[k], &w->y[k]);
    w->px = r.b->player.x[0];
    w->py = r.b->player.y[0];
}

/* Does it touch in the frame, at one of 64 moments? Ends and player go straight. */
static bool touches_sometime(const struct was *was, const struct was *now, int64_t far)
{
    for (int t = 0; t <= 64; t++)
        for (uint32_t k = 0; k + 1 < now->n; k++) {
#define AT(a, b) ((int64_t)(a) * (64 - t) + (int64_t)(b)*t) /* in units of fx / 64 */
            uint32_t i = k < was->n ? k : was->n - 1, j = k + 1 < was->n ? k + 1 : was->n - 1;
            if (is_near(AT(was->px, now->px), AT(was->py, now->py), AT(was->x[i], now->x[k]), AT(was->y[i], now->y[k]),
                        AT(was->x[j], now->x[k + 1]), AT(was->y[j], now->y[k + 1]), 64 * far))
                return true;
        }
    return false;
}

/* Many lasers at random, and a player who is moved about by its pad: hits are those that the formula has at one of many
 * moments of the frame; what it has not, is no further off than two of these moments. */
TEST(hits)
{
    static const char *const scripts[] = {
        "laser.beam { kind = 'wall', x = 120, y = 100, dir = 0, length = 140, hold = forever, warn = 0, grow = 0,\n"
        "  spin = 3.7 }",
        "local e = enemy.spawn { kind = 'fly', x = 60, y = 100 } e.safe = forever\n"
        "task.go(function() while true do e:move { x = 200, y = 220, over = 30 } wait(30)\n"
        "  e:move { x = 40, y = 90, over = 25 } wait(25) end end)\n"
        "laser.beam { kind = 'wall', follow = e, dir = 80, length = 130, hold = forever, warn = 0, grow = 0, spin = "
        "-2.3 }",
        "local m = motion.def { { turn = 4, over = forever } }\n"
        "while true do laser.curve { kind = 'wall', x = 120, y = 130, dir = 50, speed = 9, points = 20, motion = m }\n"
        "  wait(97) laser.group():remove() end",
        "while true do laser.bolt { kind = 'wall', x = 30, y = 60, aim = true, speed = 21, length = 50 } wait(40)\n"
        "  laser.group():remove() end",
    };
    static struct was was, now;
    struct rng rng;
    int hits = 0, near_misses = 0, frames = 0;

    rng_seed(&rng, 5);
    for (size_t s = 0; s < sizeof scripts / sizeof *scripts; s++) {
        begin(scripts[s]);
        uint16_t pads[MAX_PLAYERS] = { 0 };
        rig_run(&r, 1);
        note_was(&was);
        for (int frame = 0; frame < 500; frame++, was = now) {
            if (rng_below(&rng, 12) == 0)
                pads[0] = (uint16_t)(rng_next(&rng) & 15);
            rig_tick(&r, pads);
            if (!r.b->lasers.s.live)
                continue;
            note_was(&now);
            if (lasers_shown_age(r.b, 0) == 0 || r.b->lasers.flags[0] & LASER_UNSWEPT)
                was = now; /* the player's way is left out: those frames are only asked where it is */
            const bool hit = printed("hit"), right = touches_sometime(&was, &now, 6 << 16);
            if (r.b->lasers.flags[0] & LASER_UNSWEPT)
                continue;
            frames++;
            hits += hit;
            if (right)
                assert_true(hit);
            else if (hit) {
                near_misses++;
                assert_true(touches_sometime(&was, &now, (6 << 16) + 20000));
            }
        }
        rig_close(&r);
    }
    assert_true(hits > 40 && frames - hits > 400 && near_misses < hits / 4);
}

/* The place found is nearer than all others of the line, but for a 256th of a px. */
TEST(nearest)
{
    struct rng rng;

    begin("local m = motion.def { { turn = 7, over = forever } }\n"
          "laser.curve { kind = 'ray', x = 90, y = 40, dir = 20, speed = 9, points = 60, motion = m }\n"
          "laser.beam { kind = 'ray', x = 20, y = 300, dir = 320, length = 250, hold = forever }\n"
          "laser.beam { kind = 'ray', x = 20, y = 300, dir = 320, length = 0, hold = forever }");
    rig_run(&r, 70);
    rng_seed(&rng, 8);
    for (uint32_t i = 0; i < 3; i++)
        for (int n = 0; n < 2000; n++) {
            const fx x = (fx)rng_below(&rng, 400 << 16) - (80 << 16), y = (fx)rng_below(&rng, 400 << 16) - (40 << 16);
            fx at_x, at_y, ax, ay, bx, by;
            lasers_get_nearest_point(r.b, i, x, y, &at_x, &at_y);
            const double d = hypot((double)at_x - x, (double)at_y - y);
            double best = 1e18;
            for (uint32_t k = 0; k + 1 < lasers_corner_count(r.b, i); k++) {
                lasers_get_corner(r.b, i, k, &ax, &ay);
                lasers_get_corner(r.b, i, k + 1, &bx, &by);
                const double wx = (double)bx - ax, wy = (double)by - ay, all = wx * wx + wy * wy;
                double t = all > 0 ? (((double)x - ax) * wx + ((double)y - ay) * wy) / all : 0;
                t = t < 0 ? 0 : t > 1 ? 1 : t;
                best = fmin(best, hypot(ax + t * wx - x, ay + t * wy - y));
            }
            assert_true(d > best - 2 && d < best + 512);
        }
    rig_close(&r);
}

RUN_TESTS(NULL, NULL)
