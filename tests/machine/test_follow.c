/*
 * test_follow.c - sprites that go with a thing, trails, and what sparks start from and change their colour by.
 */
#include <math.h>
#include "rig.h"

static struct rig_game g;
static struct rig r;

static const char kinds[] = "bullet.def('b', { sprite = 'dot', hit = { circle = 3 } })\n"
                            "enemy.def('e', { sprite = 'dot', hit = { circle = 4 }, hp = 9 })\n"
                            "player.def('p', { sprite = 'dot', hit = { circle = 2 } })\n"
                            "spark.def('k', { sprite = 'dot', life = 12, bank = 3 })\n"
                            "spark.def('ramp', { sprite = 'dot', life = 10, banks = { 1, 5, 2 } })\n"
                            "spark.def('z', { sprite = 'dot', life = 500, bank = 4 })\n";

static void open_with(const char *text)
{
    static char full[8192];

    snprintf(full, sizeof full, "%s%s", kinds, text);
    rig_with_sys(&g, NULL, full);
    rig_power(&r, &g, NULL);
}

static void close_it(void)
{
    rig_free(&r);
    rig_game_free(&g);
}

static void at(double x, double y)
{
    fx sx, sy;

    assert_int_equal(r.b->sprites.s.live, 1);
    int32_t i = (int32_t)slots_next(&r.b->sprites.s, 0);
    assert_true(board_get_position(r.b, board_handle(r.b, H_SPRITE, i), &sx, &sy));
    assert_true(fx_to_double(sx) == x && fx_to_double(sy) == y);
}

TEST(follow)
{
    open_with("local e = enemy.spawn { kind = 'e', x = 50, y = 60 }\n"
              "local s = sprite.put { sprite = 'arrow', follow = e, dx = 10, dy = -5 }\n"
              "assert(s.x == 60 and s.y == 55 and s.dx == 10 and s.dy == -5)\n"
              "task.go(function() wait(1) e:move { x = 90, y = 60, over = 4 } wait(2) s.dx, s.dy = 1, 2 wait(2)\n"
              "  assert(s.x == 91 and s.dx == 1) bullet.fire { kind = 'b', from = s, speed = 0 } wait(1) e:kill() "
              "assert(s.alive) wait(1) assert(not s.alive and s.dx == nil) end)");
    rig_run(&r, 1), at(60, 55);
    rig_run(&r, 1), at(70, 55); /* it moved in this frame, and the sprite with it */
    rig_spoil(&r);
    rig_run(&r, 1), at(80, 55);
    rig_run(&r, 1), at(81, 62);
    rig_run(&r, 2), at(91, 62);
    assert_int_equal(r.b->bullets.s.live, 1);
    rig_run(&r, 1);
    assert_int_equal(r.b->sprites.s.live, 0); /* gone in the frame in which the enemy died */
    assert_int_equal(r.b->sprites.n_following, 0);
    rig_run(&r, 1);
    close_it();
    open_with("string.sys.join(1, 'p') local p = player.get(1)\n"
              "local s = sprite.put { sprite = 'dot', follow = p, dy = 9 } p.x, p.y = 30, 40\n"
              "task.go(function() wait(2) assert(s.x == 30 and s.y == 49) string.sys.leave(1) wait(1) assert(not "
              "s.alive) end)");
    rig_run(&r, 2), at(30, 49);
    rig_run(&r, 2);
    assert_int_equal(r.b->sprites.s.live, 0);
    close_it();
    open_with("local b = bullet.fire { kind = 'b', x = 9, y = 9, speed = 2, dir = 0 }\n"
              "sprite.put { sprite = 'dot', follow = b } sprite.put { sprite = 'dot', x = 1, y = 1 }\n"
              "b:remove() assert(not sprite.put { sprite = 'dot', follow = b }.alive)");
    rig_run(&r, 1), at(1, 1);
    close_it();
}

/* A sprite that a phase puts on a player goes with the phase. */
TEST(scene)
{
    open_with("string.sys.join(1, 'p')\n"
              "local scene = string.sys.scene(string.sys.scope())\n"
              "task.own(scene, function() sprite.put { sprite = 'dot', follow = player.get(1) } wait(forever) end)\n"
              "task.go(function() wait(3) task.stop(scene) end)");
    rig_run(&r, 3);
    assert_int_equal(r.b->sprites.s.live, 1);
    rig_run(&r, 1);
    assert_int_equal(r.b->sprites.s.live, 0);
    close_it();
}

/* The picture of one that follows is where one would be that was put there. */
TEST(picture)
{
    uint64_t h[2];

    for (int i = 0; i < 2; i++) {
        open_with(i ? "local e = enemy.spawn { kind = 'e', x = 50, y = 60 } e.hidden = true sprite.put { sprite = "
                      "'arrow', follow = e, dx = 3, dy = 4, bank = 2 }"
                    : "local e = enemy.spawn { kind = 'e', x = 50, y = 60 } e.hidden = true sprite.put { sprite = "
                      "'arrow', x = 53, y = 64, bank = 2 }");
        rig_run(&r, 2);
        h[i] = rig_picture(&r);
        close_it();
    }
    assert_true(h[0] == h[1]);
}

/* A spark each three frames, where the thing is when the task has its turn; each lives 12 frames. */
TEST(trail)
{
    open_with("local e = enemy.spawn { kind = 'e', x = 50, y = 60 }\n"
              "spark.trail { kind = 'k', follow = e, every = 3, dx = 2 }\n"
              "task.go(function() e:move { x = 90, y = 60, over = 40 } wait(30) e:remove() end)");
    for (int f = 1; f <= 50; f++) {
        rig_run(&r, 1);
        int last = f < 30 ? f : 30, n = 0;
        for (int born = 1; born <= last; born += 3)
            n += f - born < 11;
        if (f <= 29)
            assert_int_equal(r.b->sparks.s.live, n);
    }
    assert_int_equal(r.b->sparks.s.live, 0);
    close_it();
    open_with("spark.trail { kind = 'z', follow = enemy.spawn { kind = 'e', x = 50, y = 60 }, over = 9 }");
    rig_run(&r, 40);
    assert_int_equal(r.b->sparks.s.live, 3); /* one each 4 frames, of 9 */
    assert_true(r.b->sparks.x[0] == 50 * 65536 && r.b->sparks.vx[0] == 0);
    close_it();
}

static void spark_at(int i, double x, double y, double vx, double vy)
{
    const struct sparks *s = &r.b->sparks;
    double off = fabs(fx_to_double(s->x[i]) - x) + fabs(fx_to_double(s->y[i]) - y) + fabs(fx_to_double(s->vx[i]) - vx) +
                 fabs(fx_to_double(s->vy[i]) - vy);

    if (off > 0.001)
        fail_msg("spark %d is at %f, %f with %f, %f", i, fx_to_double(s->x[i]), fx_to_double(s->y[i]),
                 fx_to_double(s->vx[i]), fx_to_double(s->vy[i]));
}

TEST(shapes)
{
    open_with("spark.burst { kind = 'z', x = 100, y = 100, n = 4, radius = 20, speed = 0 }");
    spark_at(0, 120, 100, 0, 0);
    spark_at(1, 100, 120, 0, 0);
    spark_at(2, 80, 100, 0, 0);
    spark_at(3, 100, 80, 0, 0);
    close_it();
    open_with("spark.burst { kind = 'z', x = 100, y = 100, n = 4, radius = 20, dir = 90, speed = 2 }");
    for (int i = 0; i < 4; i++) { /* turned by dir: along the ring, at 1 to 2 px a frame */
        const struct sparks *s = &r.b->sparks;
        double speed = hypot(fx_to_double(s->vx[i]), fx_to_double(s->vy[i]));
        assert_true(speed >= 0.999 && speed <= 2.001);
        double way[4][2] = { { 0, 1 }, { -1, 0 }, { 0, -1 }, { 1, 0 } };
        assert_true(fabs(fx_to_double(s->vx[i]) - speed * way[i][0]) < 0.001);
        assert_true(fabs(fx_to_double(s->vy[i]) - speed * way[i][1]) < 0.001);
    }
    close_it();
    open_with("spark.burst { kind = 'z', x = 10, y = 20, to_x = 40, to_y = 26, n = 4, speed = 0 }\n"
              "spark.burst { kind = 'z', x = 10, y = 20, to_x = 40, to_y = 26, speed = 0 }");
    spark_at(0, 10, 20, 0, 0);
    spark_at(1, 20, 22, 0, 0);
    spark_at(2, 30, 24, 0, 0);
    spark_at(3, 40, 26, 0, 0);
    spark_at(4, 10, 20, 0, 0);
    close_it();
}

/* Three banks in ten frames: from 0, 4 and 7 on. A kind after it is not touched. */
TEST(ramp)
{
    const uint8_t want[10] = { 1, 1, 1, 1, 5, 5, 5, 2, 2, 2 };

    open_with("assert(table.concat(string.sys.kinds('spark'), ' ') == 'k ramp z')");
    for (uint16_t age = 0; age < 10; age++) {
        assert_int_equal(sparks_bank(&r.b->spark_kinds, 0, age), 3);
        assert_int_equal(sparks_bank(&r.b->spark_kinds, 1, age), want[age]);
        assert_int_equal(sparks_bank(&r.b->spark_kinds, 4, age), 4);
    }
    close_it();
    /* as drawn, in its second bank it shows what a plain kind of that bank does */
    uint64_t h[2];
    for (int i = 0; i < 2; i++) {
        open_with(i ? "spark.burst { kind = 'ramp', x = 50, y = 50, speed = 0 }"
                    : "spark.def('five', { sprite = 'dot', life = 99, bank = 5 }) spark.burst { kind = 'five', x = 50, "
                      "y = 50, speed = 0 }");
        rig_run(&r, 5);
        h[i] = rig_picture(&r);
        close_it();
    }
    assert_true(h[0] == h[1]);
}

static void says(const char *text, const char *line)
{
    static char full[8192];
    struct rig_game game;

    snprintf(full, sizeof full, "%s%s", kinds, text);
    rig_script(&game, NULL, full);
    assert_string_equal(rig_said(&game, 1, false), line);
    rig_game_free(&game);
}

TEST(errors)
{
    says("sprite.put { sprite = 'dot', x = 1 }",
         "sprite.put: place: expected `x` and `y`, or `follow` (a thing), got only one of `x` and `y`");
    says("sprite.put { sprite = 'dot', x = 1, y = 2, follow = player.get(1) }",
         "sprite.put: place: expected `x` and `y`, or `follow` (a thing), got both");
    says("sprite.put { sprite = 'dot', x = 1, y = 2, dx = 3 }", "sprite.put: dx, dy: require `follow`");
    says("sprite.put { sprite = 'dot', follow = player.get(1), screen = true }",
         "sprite.put: `screen` cannot be combined with `follow`");
    says("sprite.put { sprite = 'dot', x = 1, y = 2 }.dx = 3",
         "sprite: dx: the sprite follows nothing; set `x` and `y` instead");
    says("sprite.put { sprite = 'dot', follow = enemy.spawn { kind = 'e', x = 1, y = 1 } }.y = 3",
         "sprite: y: the sprite follows a thing; set `dx` and `dy` instead");
    says("spark.burst { kind = 'k', x = 1, y = 2, to_x = 3 }",
         "spark.burst: shape: expected `radius`, or `to_x` and `to_y`, or neither");
    says("spark.burst { kind = 'k', x = 1, y = 2, to_x = 3, to_y = 4, radius = 4 }",
         "spark.burst: shape: expected `radius`, or `to_x` and `to_y`, or neither");
    says("spark.def('q', { sprite = 'dot', life = 5, banks = {} })",
         "spark.def: banks: expected a list of 1 to 8 banks");
    says("spark.def('q', { sprite = 'dot', life = 5, banks = { 1, 16 } })",
         "spark.def: banks: expected a whole number from 0 to 15, got 16");
    says("spark.def('q', { sprite = 'dot', life = 5, bank = 1, banks = { 1, 2 } })",
         "spark.def: expected either `bank` or `banks`, got both");
    says("spark.trail { kind = 'k', every = 2 }", "spark.trail: follow: expected a thing with a position, got nil");
}

RUN_TESTS(NULL, NULL)
