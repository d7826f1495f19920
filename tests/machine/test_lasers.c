/*
 * test_lasers.c - beams, bolts and curves: what they are frame by frame, whom they hit and when, how they end; and a
 * game that has none.
 */
#include <math.h>
#include "../../src/script/api/api.h"
#include "../../src/board/inspect.h"
#include "../../src/machine/lasers_run.h"
#include "rig.h"

static struct rig_game g;
static struct rig r;

static const char kinds[] =
    "laser.def('ray', { strip = 'dot', width = 10, hit = { share = 0.5 } })\n"
    "laser.def('wall', { strip = 'dot', width = 8, hit = { share = 1 }, clearable = false, graze = 0 })\n"
    "laser.def('mist', { strip = 'dot', width = 8, hit = 'none' })\n"
    "laser.def('lance', { strip = 'dot', width = 6, hit = { share = 1 }, damage = 3, every = 4 })\n"
    "spark.def('glint', { sprite = 'dot', life = 50 })\n"
    "item.def('gem', { sprite = 'dot', radius = 3, gravity = 0 })\n"
    "bullet.def('orb', { sprite = 'dot', hit = 'none' })\n"
    "enemy.def('fly', { sprite = 'dot', hp = 100, hit = { circle = 5 }, touch = false })\n"
    "enemy.def('box', { sprite = 'dot', hp = 100, hit = { box = { 10, 10 } }, touch = false })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 16, safe = 0, lives = 90 })\n"
    "on.hit(function(p, l) print('hit', l.kind, l.state) p.safe = 1 end)\n"
    "on.graze(function(p, l) print('graze', l.kind, l.state) end)\n";

static struct manifest manifest(void)
{
    struct manifest m = rig_manifest();

    m.lasers = 8;
    m.curve_points = 256;
    m.items = 64;
    m.has_freeze = m.has_orbit = 1;
    return m;
}

/* The script runs as a task of the first frame, with the player at (120, 200). */
static void begin(const char *script)
{
    static char text[8192];
    struct manifest m = manifest();

    snprintf(text, sizeof text,
             "%stask.go(function()\n"
             "string.sys.join(1, 'ship')\n"
             "local p = player.get(1)\n"
             "p.x, p.y = 120, 200\n"
             "%s\n"
             "end)\n",
             kinds, script);
    rig_with_sys(&g, &m, text);
    rig_power(&r, &g, NULL);
}

static void end(void)
{
    rig_free(&r);
    rig_game_free(&g);
}

/* How often the log of this frame has the line. */
static int said(const char *line)
{
    const struct board_out *out = board_last_output(r.b);
    int n = 0;

    for (const char *at = out->log; (at = strstr(at, line)) != NULL && at < out->log + out->log_size; at++)
        n++;
    return n;
}

static void one_frame(void)
{
    rig_run(&r, 1);
    if (rig_fault(&r))
        fail_msg("%s", rig_fault(&r)->message);
}

static struct lasers *l(void)
{
    return &r.b->lasers;
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
        one_frame();
        assert_int_equal(l()->s.live, 1);
        assert_int_equal(lasers_shown_age(r.b, 0), age);
        assert_int_equal(lasers_state_of(r.b, 0, age), states[age]);
        assert_int_equal(lasers_width(l(), 0, age) / 66, (int)(widths[age] * 65536) / 66);
        bool dangerous = age >= 5 && age < 12;
        assert_int_equal(said("hit\tray"), dangerous && widths[age] / 4 + 2 >= 4);
        assert_int_equal(said("graze\tray"), age == 5);
    }
    one_frame();
    assert_int_equal(l()->s.live, 0);
    end();
}

/* It passes what lies between two frames, but not in the first one in which it is dangerous, and not when a script
 * turns it. 10 degrees a frame at 180 px are 31 px. */
TEST(spin)
{
    int frames = 0;

    begin("p.x, p.y = 120, 190\n"
          "laser.beam { kind = 'wall', x = 120, y = 10, dir = 90 + 24, length = 200, hold = forever, warn = 0, grow = "
          "0,\n"
          "  spin = -16, width = 2 }");
    for (int i = 0; i < 6; i++) {
        one_frame();
        frames += said("hit\twall");
    }
    assert_int_equal(frames, 1); /* it was at 114, 98, 82: the third frame passes 90 */
    end();
    begin("p.x, p.y = 120, 190\n"
          "local b = laser.beam { kind = 'wall', x = 120, y = 10, dir = 114, length = 200, hold = forever, warn = 0,\n"
          "  grow = 0, width = 2 }\n"
          "wait(3) b.dir = 66");
    for (frames = 0; frames < 8; frames++) {
        one_frame();
        assert_int_equal(said("hit\twall"), 0);
    }
    assert_int_equal(trig_to_degrees(r.b->laser_heads.dir[0]), 66);
    end();
}

/* It stays with what it follows, turns as that turns, and goes with it. */
TEST(follow)
{
    begin("local e = enemy.spawn { kind = 'fly', x = 50, y = 50 }\n"
          "local o = bullet.fire { kind = 'orb', x = 60, y = 100, dir = 10, speed = 2 }\n"
          "laser.beam { kind = 'ray', follow = e, dx = 3, dy = 4, dir = 90, length = 50, hold = forever }\n"
          "laser.beam { kind = 'ray', follow = o, dir = 40, length = 50, hold = forever, turns = true }\n"
          "wait(2) e.x = 80 o.dir = 100\n"
          "wait(1) o.dir = 130\n"
          "wait(2) e:remove()\n"
          "wait(2) o:remove()");
    one_frame();
    assert_true(r.b->laser_heads.x[0] == 53 << 16 && r.b->laser_heads.y[0] == 54 << 16);
    assert_true(l()->x0[0] == 53 << 16 && l()->y0[0] == 104 << 16);
    rig_run(&r, 2);
    assert_true(r.b->laser_heads.x[0] == 83 << 16 && l()->x0[0] == 83 << 16);
    assert_true(r.b->laser_heads.x[1] == r.b->bullets.x[0] && r.b->laser_heads.y[1] == r.b->bullets.y[0]);
    assert_int_equal((int)(trig_to_degrees(r.b->laser_heads.dir[1]) + 0.5), 130);
    one_frame();
    assert_int_equal((int)(trig_to_degrees(r.b->laser_heads.dir[1]) + 0.5), 160);
    assert_int_equal(l()->s.live, 2);
    rig_run(&r, 2);
    assert_int_equal(l()->s.live, 1);
    rig_run(&r, 2);
    assert_int_equal(l()->s.live, 0);
    assert_null(rig_fault(&r));
    end();
}

/* A beam is where the laser that it follows is, also where that one has a higher slot. */
TEST(follow_laser)
{
    begin("local first = laser.beam { kind = 'ray', x = 1, y = 1, length = 5, hold = forever }\n"
          "local c = laser.curve { kind = 'ray', x = 20, y = 50, dir = 10, speed = 3, points = 9 }\n"
          "first:remove()\n"
          "laser.beam { kind = 'ray', follow = c, dy = 2, length = 50, hold = forever }");
    for (int frame = 0; frame < 30; frame++) {
        one_frame();
        assert_true(l()->form[0] == LASER_BEAM && l()->form[1] == LASER_CURVE);
        assert_int_equal(r.b->laser_heads.x[0], r.b->laser_heads.x[1]);
        assert_int_equal(r.b->laser_heads.y[0], r.b->laser_heads.y[1] + (2 << 16));
    }
    end();
}

/* What goes round a laser flies alike whichever of the two has the lower slot. */
TEST(around_laser)
{
    static fx path[2][60][2];

    for (int lower = 0; lower < 2; lower++) {
        char script[1024];
        snprintf(script, sizeof script,
                 "local m = motion.def { { orbit = 30, spin = 3, over = forever } }\n"
                 "%s"
                 "local c = laser.bolt { kind = 'ray', x = 60, y = 50, dir = 40, speed = 2, length = 9 }\n"
                 "%s"
                 "laser.curve { kind = 'ray', x = 90, y = 50, speed = 1, motion = m, around = c, points = 9 }\n",
                 lower ? "local first = laser.beam { kind = 'ray', x = 1, y = 1, length = 5, hold = forever }\n" : "",
                 lower ? "first:remove()\n" : "");
        begin(script);
        for (int frame = 0; frame < 60; frame++) {
            one_frame();
            EACH_LIVE (i, &l()->s)
                if (l()->form[i] == LASER_CURVE) {
                    assert_int_equal(i, !lower);
                    path[lower][frame][0] = r.b->laser_heads.x[i];
                    path[lower][frame][1] = r.b->laser_heads.y[i];
                }
        }
        end();
    }
    assert_memory_equal(path[0], path[1], sizeof path[0]);
}

/* ---- bolts ---- */

/* It comes out of where it was fired, is as long as it says, and goes when all of it has left. */
TEST(bolt)
{
    begin("laser.bolt { kind = 'ray', x = 20, y = 30, dir = 0, speed = 4, length = 30 }");
    for (int frame = 1; frame < 80; frame++) {
        one_frame();
        const int head = 20 + 4 * frame, tail = head - (4 * frame < 30 ? 4 * frame : 30);
        if (tail > 240 + 64) {
            assert_int_equal(l()->s.live, 0);
            end();
            return;
        }
        assert_int_equal(l()->s.live, 1);
        assert_int_equal(r.b->laser_heads.x[0], head << 16);
        assert_int_equal(l()->x0[0], tail << 16);
        assert_int_equal(l()->y0[0], 30 << 16);
    }
    fail();
}

/* It hits what it passes, however fast it is; a delayed one warns and does not. */
TEST(bolt_hits)
{
    begin("laser.bolt { kind = 'wall', x = 120, y = 20, dir = 90, speed = 400, length = 4 }\n"
          "laser.bolt { kind = 'wall', x = 120, y = 200, dir = 90, speed = 0, length = 4, delay = 3 }");
    one_frame();
    assert_int_equal(said("hit\twall\ton"), 1);
    one_frame();
    assert_int_equal(said("hit"), 0);
    one_frame();
    assert_int_equal(said("hit"), 0);
    one_frame();
    assert_int_equal(said("hit"), 1);
    end();
}

/* ---- curves ---- */

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
        one_frame();
        if (!l()->s.live) {
            assert_true(frame > 60 + 40);
            x = xs[frame - 39], y = ys[frame - 39]; /* it left with its last point, and not before */
            assert_true(x < -(64 << 16) || x > 304 << 16 || y < -(64 << 16) || y > 384 << 16);
            x = xs[frame - 40], y = ys[frame - 40];
            assert_true(x >= -(64 << 16) && x <= 304 << 16 && y >= -(64 << 16) && y <= 384 << 16);
            assert_int_equal(r.b->laser_points.s.live, 0);
            assert_int_equal(r.b->laser_heads.s.live, 0);
            end();
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

/* A write of the place moves all of it, and passes nothing. */
TEST(curve_moves)
{
    fx x, y;

    begin("local c = laser.curve { kind = 'wall', x = 60, y = 100, dir = 0, speed = 2, points = 10 }\n"
          "wait(20) c.y = 300\n"
          "wait(5) c:shift(7, -30)");
    for (int i = 0; i < 30; i++) {
        one_frame();
        assert_int_equal(said("hit"), 0);
    }
    for (uint32_t k = 0; k < 10; k++) {
        lasers_get_corner(r.b, 0, k, &x, &y);
        assert_int_equal(x, (60 + 2 * 30 + 7 - 2 * (int)k) << 16);
        assert_int_equal(y, 270 << 16);
    }
    end();
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
    bool dangerous;
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
        one_frame();
        note_was(&was);
        for (int frame = 0; frame < 500; frame++, was = now) {
            if (rng_below(&rng, 12) == 0)
                pads[0] = (uint16_t)(rng_next(&rng) & 15);
            rig_tick(&r, pads);
            assert_null(rig_fault(&r));
            if (!l()->s.live)
                continue;
            note_was(&now);
            if (lasers_shown_age(r.b, 0) == 0 || l()->flags[0] & LASER_UNSWEPT)
                was = now; /* the player's way is left out: those frames are only asked where it is */
            const bool hit = said("hit") > 0, right = touches_sometime(&was, &now, 6 << 16);
            if (l()->flags[0] & LASER_UNSWEPT)
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
        end();
    }
    assert_true(hits > 40 && frames - hits > 400 && near_misses < hits / 4);
}

/* ---- grazes, shots, clears ---- */

TEST(graze)
{
    int grazes = 0;

    begin("laser.beam { kind = 'ray', x = 132, y = 10, dir = 90, length = 250, hold = forever, warn = 0, grow = 0 }\n"
          "laser.beam { kind = 'wall', x = 108, y = 10, dir = 90, length = 250, hold = forever, warn = 0, grow = 0 }");
    for (int frame = 0; frame < 25; frame++) {
        one_frame();
        assert_int_equal(said("graze\tray"), frame % 8 == 0);
        assert_int_equal(said("graze\twall"), 0);
        grazes += said("graze");
    }
    assert_int_equal(grazes, 4);
    assert_int_equal(r.b->player.grazes[0], 4);
    end();
}

/* A player's laser hurts each enemy it touches, every fourth frame, and no player. */
TEST(shoots)
{
    begin("local a = enemy.spawn { kind = 'fly', x = 120, y = 60 }\n"
          "local b = enemy.spawn { kind = 'box', x = 127, y = 100 }\n"
          "local c = enemy.spawn { kind = 'box', x = 129, y = 130 }\n"
          "wait(2)\n"
          "local s = laser.beam { kind = 'lance', follow = p, dir = 270, length = 180, hold = 9, warn = 0, grow = 0 }\n"
          "task.go(function() for i = 1, 12 do print('hp', a.hp, b.hp, c.hp, s.by == p) wait(1) end end)");
    for (int frame = 0; frame < 15; frame++) {
        one_frame();
        assert_int_equal(said("hit\t"), 0);
        const int hurt = frame < 3 ? 0 : frame < 7 ? 3 : frame < 11 ? 6 : 9;
        char line[64];
        snprintf(line, sizeof line, "hp\t%d\t%d\t100\ttrue", 100 - hurt, 100 - hurt);
        if (frame >= 2 && frame < 13 && !said(line))
            fail_msg("frame %d: expected %s, got %s", frame, line, board_last_output(r.b)->log);
    }
    end();
}

/* A clear takes what it touches, whole, and leaves sparks along it, `every` px. */
TEST(clear)
{
    begin("local function some()\n"
          "  laser.beam { kind = 'ray', x = 10, y = 50, dir = 0, length = 120, hold = forever, warn = 0 }\n"
          "  laser.beam { kind = 'wall', x = 10, y = 60, dir = 0, length = 120, hold = forever, warn = 0 }\n"
          "  laser.beam { kind = 'lance', x = 10, y = 70, dir = 0, length = 120, hold = forever, warn = 0 }\n"
          "  laser.beam { kind = 'mist', x = 10, y = 90, dir = 0, length = 120, hold = forever, warn = 0, tag = 'm' }\n"
          "  wait(12)\n"
          "end\n"
          "some()\n"
          "local function left(n) print('left', n, laser.group().count) end\n"
          "left(bullet.clear { x = 133, y = 55.5, radius = 2, spark = 'glint' })\n" /* near the first one's round end */
          "wait(1)\n"
          "left(bullet.clear { lasers = false })\n"
          "left(laser.clear { x = 200, y = 90, w = 130, h = 2 })\n"
          "left(laser.clear { x = 200, y = 90, w = 133, h = 2, every = 30, spark = 'glint' })\n"
          "wait(1)\n"
          "left(laser.clear { x = 60, y = 10, to_x = 60, to_y = 300, width = 0, all = true })\n"
          "laser.group():clear { spark = 'glint', every = 60 }\n"
          "left(0)\n"
          "some()\n"
          "left(laser.group('m'):clear {})\n"
          "laser.each(nil, function(x) x:clear { spark = 'glint' } end)\n"
          "left(0)");
    rig_run(&r, 12);
    one_frame();
    assert_int_equal(said("left\t1\t3\n"), 1);
    assert_int_equal(r.b->sparks.s.live, 10);
    one_frame();
    assert_int_equal(said("left\t0\t3\n"), 2);
    assert_int_equal(said("left\t1\t2\n"), 1);
    assert_int_equal(r.b->sparks.s.live, 14);
    one_frame();
    assert_int_equal(said("left\t1\t1\n"), 1);
    assert_int_equal(said("left\t0\t0\n"), 1);
    assert_int_equal(r.b->sparks.s.live, 16);
    rig_run(&r, 11);
    one_frame();
    assert_int_equal(said("left\t1\t3\n"), 1);
    assert_int_equal(said("left\t0\t0\n"), 1);
    assert_null(rig_fault(&r));
    end();
}

/* Items lie at rest on the line from (x, y) on, each (dx, dy) from the one before, from slot `from` on. */
static void row_of_items(uint32_t from, uint32_t n, double x, double y, double dx, double dy)
{
    const struct items *s = &r.b->items;

    assert_int_equal(s->s.live, from + n);
    for (uint32_t k = 0; k < n; k++) {
        assert_true(abs((int)(s->x[from + k] - (fx)((x + k * dx) * 65536))) < 4);
        assert_true(abs((int)(s->y[from + k] - (fx)((y + k * dy) * 65536))) < 4);
        assert_true(s->vx[from + k] == 0 && s->vy[from + k] == 0);
    }
}

/* A laser that a clear turns into items leaves them each so many px along its line, the first half of that from its
 * head; no chance is drawn. */
TEST(items)
{
    uint64_t chance[4];

    begin("laser.beam { kind = 'ray', x = 10, y = 50, dir = 0, length = 120, hold = forever, warn = 0 }\n"
          "wait(2) print('took', bullet.clear { items = 'gem' })\n"
          "wait(2) laser.beam { kind = 'ray', x = 10, y = 90, dir = 90, length = 100, hold = forever, tag = 't' }\n"
          "wait(2) print('took', laser.group('t'):clear { items = 'gem', every = 25 })\n"
          "wait(2) laser.beam { kind = 'ray', x = 10, y = 20, length = 3, hold = forever }:clear { items = 'gem' }\n"
          "wait(2) laser.beam { kind = 'wall', x = 30, y = 200, dir = 0, length = 50, hold = forever, warn = 0 }\n"
          "wait(1) bullet.sweep { x = 30, y = 200, radius = 4, radius_to = 9, over = 1, items = 'gem' }\n"
          "bullet.sweep { x = 30, y = 200, radius = 9, radius_to = 9, over = 1, all = true, lasers = false }\n"
          "wait(1) bullet.sweep { x = 30, y = 200, radius = 4, radius_to = 9, over = 1, items = 'gem', all = true }");
    rig_run(&r, 2);
    memcpy(chance, r.b->core.random, sizeof chance);
    one_frame();
    assert_int_equal(said("took\t1\n"), 1);
    assert_int_equal(l()->s.live, 0);
    row_of_items(0, 10, 16, 50, 12, 0);
    rig_run(&r, 3);
    one_frame();
    assert_int_equal(said("took\t1\n"), 1);
    row_of_items(10, 4, 10, 102.5, 0, 25);
    rig_run(&r, 2);
    row_of_items(14, 1, 10, 20, 0, 0);
    rig_run(&r, 3);
    row_of_items(14, 1, 10, 20, 0, 0); /* a wall is not clearable */
    assert_int_equal(l()->s.live, 1);
    rig_run(&r, 2);
    row_of_items(15, 4, 36, 200, 12, 0);
    assert_int_equal(l()->s.live, 0);
    assert_memory_equal(chance, r.b->core.random, sizeof chance);
    end();
}

/* A curve leaves them along its body, round its bends; where there is no room, they are counted. */
TEST(items_of_curves)
{
    begin("local m = motion.def { { wait = 9 }, { dir = 90 } }\n"
          "laser.curve { kind = 'ray', x = 20, y = 40, dir = 0, speed = 4, points = 31, motion = m }\n"
          "wait(31) laser.clear { items = 'gem', every = 20 }\n"
          "wait(2) laser.beam { kind = 'ray', x = 10, y = 50, dir = 0, length = 120, hold = forever }\n"
          "wait(1) laser.clear { items = 'gem', every = 1 }");
    rig_run(&r, 31);
    assert_int_equal(lasers_corner_count(r.b, 0), 31);
    const fx x = r.b->laser_heads.x[0], y = r.b->laser_heads.y[0];
    assert_true(x == 56 << 16 || x == 60 << 16);
    one_frame();
    /* 120 px: down to the bend, and back to where it came from */
    const struct items *s = &r.b->items;
    const fx down = y - (40 << 16);
    assert_int_equal(s->s.live, 6);
    for (int k = 0; k < 6; k++) {
        const fx at = (10 + 20 * k) << 16;
        assert_int_equal(s->x[k], at < down ? x : x - (at - down));
        assert_int_equal(s->y[k], at < down ? y - at : 40 << 16);
    }
    rig_run(&r, 3);
    assert_int_equal(s->s.live, 64);
    assert_int_equal(board_refused_count(r.b, "items"), 120 + 6 - 64);
    assert_null(rig_fault(&r));
    end();
}

/* A phase that is beaten turns the lasers it leaves into items as well. */
TEST(phase)
{
    static const char boss[] =
        "boss.def('b', { title = 'B', kind = 'fly', x = 100, y = 60, phases = { { id = 'p', hp = 5, time = 30, rest = "
        "0,\n"
        "  clear = { items = 'gem', spark = 'glint' }, run = function(e)\n"
        "    laser.beam { kind = 'wall', x = 20, y = 90, dir = 0, length = 60, hold = forever }\n"
        "    laser.bolt { kind = 'ray', x = 20, y = 120, dir = 0, speed = 30, length = 24 }\n"
        "    wait(5) e:hurt(9) wait(forever) end } } })\n";
    static char text[8192];
    struct manifest m = manifest();

    snprintf(text, sizeof text, "%s%stask.go(function() boss.fight('b') end)\n", kinds, boss);
    rig_with_sys(&g, &m, text);
    rig_power(&r, &g, NULL);
    for (int i = 0; i < 200 && !r.b->items.s.live; i++)
        one_frame();
    assert_int_equal(r.b->items.s.live, 60 / 12 + 24 / 12);
    assert_int_equal(r.b->sparks.s.live, 7);
    assert_int_equal(l()->s.live, 0);
    end();
}

/* ---- questions ---- */

/* A query finds a laser by what is drawn of it, and sorts by the place of its line that is nearest. In the first b is
 * 15 - 4 px away and a 25 - 5; in the third c is at 10, a at 22, b at 58; the fifth box begins at 147.5, b
 * ends at 154. */
TEST(queries)
{
    begin(
        "local function names(list) local t = {} for i, x in ipairs(list) do t[i] = x.tag end\n"
        "  return table.concat(t, ' ') end\n"
        "laser.beam { kind = 'ray', x = 10, y = 50, dir = 0, length = 120, hold = forever, warn = 0, grow = 0, tag = "
        "'a' }\n"
        "laser.beam { kind = 'mist', x = 100, y = 90, dir = 90, length = 60, hold = forever, warn = 0, grow = 0, tag = "
        "'b' }\n"
        "laser.bolt { kind = 'ray', x = 200, y = 60, dir = 180, speed = 20, length = 20, tag = 'c' }\n"
        "wait(2)\n"
        "print('1', names(query.near { what = 'laser', x = 100, y = 75, radius = 16 }))\n" /* b at 11, a at 20 */
        "print('2', names(query.near { what = 'laser', x = 100, y = 75, radius = 20 }))\n"
        "print('3', names(query.near { what = 'laser', x = 150, y = 60, radius = 90 }))\n" /* c 10, a 22, b 58 */
        "print('4', names(query.near { what = 'laser', x = 150, y = 60, radius = 90, tag = 'b' }))\n"
        "print('5', names(query.box { what = 'laser', x = 100, y = 200, w = 6, h = 105 }))\n"
        "print('6', names(query.box { what = 'laser', x = 100, y = 207, w = 6, h = 105 }))\n"
        "print('7', names(query.line { what = 'laser', x = 0, y = 0, to_x = 240, to_y = 0, width = 89 }))\n"
        "print('8', names(query.line { what = 'laser', x = 0, y = 150, to_x = 240, to_y = 150, width = 2 }))\n"
        "laser.group():remove() print('9', #query.near { what = 'laser', x = 0, y = 0, radius = 32767 })");
    rig_run(&r, 2);
    one_frame();
    static const char *const lines[] = { "1\tb\n", "2\tb a\n", "3\tc a b\n", "4\tb\n", "5\tb\n",
                                         "6\t\n",  "7\t\n",    "8\tb\n",     "9\t0\n" };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        if (said(lines[i]) != 1)
            fail_msg("expected %s among %s", lines[i], board_last_output(r.b)->log);
    end();
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
    end();
}

/* ---- properties, verbs, pools ---- */

TEST(properties)
{
    begin("local b = laser.beam { kind = 'ray', x = 50, y = 40, length = 60, hold = forever, tag = 'one', bank = 3 }\n"
          "local c = laser.curve { kind = 'ray', x = 50, y = 40, dir = 0, speed = 5, points = 8 }\n"
          "assert(b.x == 50 and b.y == 40 and b.dir == 90 and b.length == 60 and b.width == 10 and b.spin == 0)\n"
          "assert(b.kind == 'ray' and b.tag == 'one' and b.bank == 3 and b.state == 'warn' and b.form == 'beam')\n"
          "assert(b.age == 0 and b.alive and b.frozen == 0 and b.follow == nil and b.by == nil and b.speed == 0)\n"
          "assert(c.form == 'curve' and c.state == 'on' and c.speed == 5 and c.vx == 5 and c.length == 0)\n"
          "b.x, b.dir, b.length, b.width, b.spin, b.tag, b.bank = 55, 30, 20, 4, 2, 'two', 1\n"
          "b:turn(60) b.speed = 9\n"
          "assert(b.x == 55 and math.abs(b.dir - 90) < 0.01 and b.length == 20 and b.width == 4 and b.tag == 'two')\n"
          "assert(laser.group('one').count == 0 and laser.group('two').count == 1 and laser.group().count == 2)\n"
          "b:aim(10) assert(math.abs(b.dir - angle.of(65, 160) - 10) < 0.01 and math.abs(b.spin - 2) < 0.01)\n"
          "wait(1)\n"
          "assert(c.x == 55 and c.length == 5 and b.x == 55)\n"
          "c.frozen = 2 wait(2) assert(c.x == 55 and c.age == 1) wait(1) assert(c.x == 60 and c.age == 2)\n"
          "c.vx = 3 wait(1) assert(c.x == 63)\n"
          "laser.group():shift(1, 2) assert(b.x == 56 and b.y == 42 and c.x == 64 and c.y == 42)\n"
          "laser.group().width = 7 assert(b.width == 7 and c.width == 7)\n"
          "c:fade() assert(c.state == 'fade') wait(12) assert(c.alive) wait(1) assert(not c.alive)\n"
          "b:fade() wait(1) assert(not b.alive and b.x == nil)\n" /* it warned: nothing is left to fade */
          "b.x = 3 b:turn(2) b:fade()\n"
          "for i = 1, 8 do assert(laser.curve { kind = 'ray', x = 1, y = 1, dir = 0, speed = 0, points = 32 }.alive) "
          "end\n"
          "assert(not laser.beam { kind = 'ray', x = 1, y = 1, length = 9, hold = 1 }.alive)\n"
          "laser.group():remove()\n"
          "laser.curve { kind = 'ray', x = 1, y = 1, dir = 0, speed = 0, points = 224 }\n"
          "assert(not laser.curve { kind = 'ray', x = 1, y = 1, dir = 0, speed = 0, points = 33 }.alive)\n"
          "assert(laser.curve { kind = 'ray', x = 1, y = 1, dir = 0, speed = 0, points = 32 }.alive)\n"
          "print('done')");
    int done = 0;
    for (int i = 0; i < 30; i++) {
        one_frame();
        done += said("done");
    }
    assert_int_equal(done, 1);
    assert_int_equal(board_refused_count(r.b, "lasers"), 1);
    assert_int_equal(board_refused_count(r.b, "laser_points"), 1);
    end();
}

/* A field that is emptied has none of them, a player's neither. */
TEST(wipe)
{
    begin("laser.beam { kind = 'lance', x = 1, y = 1, length = 9, hold = forever }\n"
          "laser.beam { kind = 'wall', x = 1, y = 1, length = 9, hold = forever }\n"
          "laser.curve { kind = 'ray', x = 50, y = 50, speed = 1, points = 40 }\n"
          "wait(2) string.sys.wipe()");
    rig_run(&r, 2);
    assert_true(l()->s.live == 3 && r.b->laser_heads.s.live == 3 && r.b->laser_points.s.live == 2);
    one_frame();
    assert_true(l()->s.live == 0 && r.b->laser_heads.s.live == 0 && r.b->laser_points.s.live == 0);
    end();
}

/* A laser owns tasks: they end with it, and have no turn while it stands. */
TEST(tasks)
{
    struct inspect_task tasks[4];
    uint32_t owned = 0;

    begin("local c = laser.curve { kind = 'ray', x = 50, y = 50, speed = 1 }\n"
          "task.own(c, function() for i = 1, forever do print('turn', i) wait(1) end end)\n"
          "wait(3) c.frozen = 4 wait(8) c:remove()");
    for (int frame = 1; frame <= 12; frame++) {
        char line[32];
        one_frame();
        const bool stood = frame >= 5 && frame <= 8;
        snprintf(line, sizeof line, "turn\t%d\n", frame <= 4 ? frame : frame - 4);
        if (said("turn") != (!stood && frame < 12) || (!stood && frame < 12 && !said(line)))
            fail_msg("frame %d: %s", frame, board_last_output(r.b)->log);
        if (frame != 6)
            continue;
        const uint32_t n = inspect_tasks(r.b, 0, tasks, 4);
        for (uint32_t k = 0; k < n && k < 4; k++)
            owned += tasks[k].owner == OWNER_LASER && tasks[k].owner_number == 0;
    }
    assert_int_equal(owned, 1);
    end();
}

/* Heads run every step: they wait for a signal, and fire as they fly, as the bullet beside them does. */
TEST(steps)
{
    begin("local m = motion.def { { wait_for = { tag = 'go', limit = 50 } }, { emit = { pattern = 'ring', n = 3,\n"
          "  kind = 'orb', speed = 2 } }, { wait_for = { x = 150, limit = 90 } }, { turn = 90 } }\n"
          "local c = laser.curve { kind = 'ray', x = 60, y = 50, dir = 0, speed = 5, motion = m, points = 64 }\n"
          "local b = bullet.fire { kind = 'orb', x = 60, y = 50, dir = 0, speed = 5, motion = m, tag = 'beside' }\n"
          "wait(4) laser.group('come'):signal() wait(1) print('no', bullet.group().count)\n"
          "laser.group('go'):signal() bullet.group('go'):signal() wait(1) print('now', bullet.group().count)\n"
          "wait(25) print('same', c.x == b.x and c.y == b.y and c.dir == b.dir and c.y > 60)\n"
          "c.frozen = 5 c:shift(0, -30) laser.group():signal() wait(20) print('same', c.y < b.y)");
    for (int i = 0, seen = 0; i < 60; i++) {
        one_frame();
        seen += said("no\t1\n") + said("now\t7\n") + said("same\ttrue\n");
        if (i == 59)
            assert_int_equal(seen, 4);
    }
    end();
}

/* There is room for the events of a frame in which every laser grazes both players. */
TEST(room)
{
    enum { MANY = 2000 };
    static char text[8192];
    struct manifest m = manifest();

    m.lasers = MANY;
    m.players = 2;
    snprintf(
        text, sizeof text,
        "%stask.go(function()\n"
        "string.sys.join(1, 'ship') string.sys.join(2, 'ship')\n"
        "for i = 1, 2 do player.get(i).x, player.get(i).y = 100 + 20 * i, 200 end\n"
        "for i = 1, %d do laser.beam { kind = 'ray', x = 130, y = 10, length = 290, hold = forever, warn = 0 } end\n"
        "end)\n",
        kinds, MANY);
    rig_with_sys(&g, &m, text);
    rig_power(&r, &g, NULL);
    one_frame();
    assert_int_equal(r.b->player.grazes[0], MANY);
    assert_int_equal(r.b->player.grazes[1], MANY);
    end();
}

/* Patterns fire them. */
TEST(patterns)
{
    begin("pattern.ring { kind = 'ray', fire = 'curve', x = 120, y = 100, n = 3, speed = 2, points = 9 }\n"
          "pattern.fan { kind = 'ray', fire = 'bolt', x = 120, y = 100, n = 2, spread = 40, speed = 2, length = 9 }\n"
          "pattern.line { kind = 'mist', fire = 'beam', x = 120, y = 60, n = 2, width = 40, hold = 9, length = 50 }\n"
          "print('done', laser.group().count)");
    one_frame();
    assert_int_equal(said("done\t7"), 1);
    assert_int_equal(l()->form[0], LASER_CURVE);
    assert_int_equal(l()->form[4], LASER_BOLT);
    assert_true(l()->form[6] == LASER_BEAM && r.b->laser_heads.x[6] == 100 << 16 && r.b->laser_heads.x[5] == 140 << 16);
    end();
}

/* ---- what is wrong ---- */

static void fault(const char *script, const char *message)
{
    const uint16_t pads[MAX_PLAYERS] = { 0 };

    begin(script);
    for (int i = 0; i < 3 && !rig_fault(&r); i++)
        board_tick(r.b, pads);
    assert_non_null(rig_fault(&r));
    const char *at = strstr(rig_fault(&r)->message, ": ");
    assert_string_equal(at ? at + 2 : "", message);
    end();
}

TEST(faults)
{
    fault("laser.beam { kind = 'rya', x = 1, y = 1, length = 9, hold = 1 }",
          "laser.beam: unknown laser kind \"rya\" (did you mean \"ray\"?)");
    fault("pattern.ring { kind = 'ray', x = 1, y = 1, n = 3, speed = 3 }",
          "pattern.ring: unknown bullet kind \"ray\" (found laser kind \"ray\")");
    fault("laser.beam { kind = 'ray', x = 1, y = 1, length = 9 }",
          "laser.beam: hold: expected forever or a whole number from 0 to 1000000000 frames, got nil");
    fault("laser.beam { kind = 'ray', x = 1, follow = p, length = 9, hold = 2 }",
          "laser.beam: `follow` cannot be combined with `x`, `y` or `from`");
    fault("laser.beam { kind = 'ray', x = 1, y = 1, turns = true, length = 9, hold = 2 }",
          "laser.beam: turns: requires `follow`");
    fault("laser.curve { kind = 'ray', x = 1, y = 1, speed = 1, points = 257 }",
          "laser.curve: points: expected a whole number from 2 to 256 frames, got 257");
    fault("laser.curve { kind = 'ray', x = 1, y = 1, speed = 1 }.length = 3",
          "laser: length: cannot be set on a curve (`points` sets its length)");
    for (int i = 0; i < api_table.things[H_LASER]->n; i++) {
        const struct api_param *p = &api_table.things[H_LASER]->props[i];
        char text[200], want[100];
        if (p->access & PROP_WRITE)
            continue;
        snprintf(text, sizeof text,
                 "local l = laser.bolt { kind = 'ray', x = 1, y = 1, speed = 1, length = 9 } l.%s = 1", p->name);
        snprintf(want, sizeof want, "laser: %s is read-only", p->name);
        fault(text, want);
    }
    fault("pattern.stack { kind = 'ray', fire = 'beam', x = 1, y = 1, n = 3, speed_to = 3, length = 9, hold = 1 }",
          "pattern.stack: fire: this figure sets speeds, but beams have no speed");
    fault("print(laser.group().x)", "lasers: x cannot be read from a group (only `count` can)");
}

/* Without room there is no table, no memory, and a word that says what to do. */
TEST(without)
{
    struct manifest m = rig_manifest();
    uint64_t hashes[MAX_PARTS];

    rig_script(&g, &m,
               "bullet.def('orb', { sprite = 'dot', hit = 'none' })\n"
               "task.go(function() wait(5) laser.group() end)\n");
    rig_power(&r, &g, NULL);
    rig_run(&r, 3);
    board_hashes(r.b, hashes);
    for (int i = FIRST_OPTIONAL_PART; i < PART_COUNT; i++) {
        assert_int_equal(slots_size(machine_parts[i].chip, 0, 0), 0);
        assert_int_equal(hashes[i], 0);
    }
    assert_int_equal(board_hash(r.b), board_combine_hashes(hashes));
    for (int i = 0; i < 4 && !rig_fault(&r); i++)
        board_tick(r.b, (const uint16_t[MAX_PLAYERS]){ 0 });
    assert_non_null(
        strstr(rig_fault(&r)->message, "laser: lasers are disabled; add `lasers = 64` to `board` in rom.lua"));
    end();
    rig_script(&g, &m,
               "bullet.def('orb', { sprite = 'dot', hit = 'none' })\n"
               "task.go(function() wait(5) pattern.ring { fire = 'curve', n = 3 } end)\n");
    rig_power(&r, &g, NULL);
    for (int i = 0; i < 8 && !rig_fault(&r); i++)
        board_tick(r.b, (const uint16_t[MAX_PLAYERS]){ 0 });
    assert_non_null(strstr(rig_fault(&r)->message,
                           "pattern.ring: fire: lasers are disabled; add `lasers = 64` to `board` in rom.lua"));
    end();
}

/* Beams and bolts without curves. */
TEST(without_curves)
{
    static const char *const texts[] = {
        "laser.curve { kind = 'ray', x = 9, y = 9, speed = 1 }",
        "pattern.ring { fire = 'curve', kind = 'ray', x = 9, y = 9, speed = 1, n = 3 }"
    };

    for (int i = 0; i < 2; i++) {
        struct manifest m = rig_manifest();
        char text[300];
        m.lasers = 8;
        snprintf(
            text, sizeof text,
            "laser.def('ray', { strip = 'dot', width = 4, hit = 'none' })\n"
            "task.go(function() pattern.ring { fire = 'bolt', kind = 'ray', x = 9, y = 9, speed = 1, n = 3, length = "
            "9 } %s end)\n",
            texts[i]);
        rig_script(&g, &m, text);
        rig_power(&r, &g, NULL);
        board_tick(r.b, (const uint16_t[MAX_PLAYERS]){ 0 });
        assert_int_equal(r.b->lasers.s.live, 3);
        assert_non_null(strstr(rig_fault(&r)->message, i ? "pattern.ring: fire: " : "laser.curve: "));
        assert_non_null(strstr(rig_fault(&r)->message, "add `curve_points = 2048` to `board` in rom.lua"));
        end();
    }
}

RUN_TESTS(NULL, NULL)
