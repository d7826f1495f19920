/*
 * test_delay.c - bullets with a delay: still and harmless while it lasts, and from its end on as one that was fired
 * then.
 */
#include "rig.h"

static const char kinds[] = "bullet.def('orb', { sprite = 'dot', hit = { circle = 4 }, cloud = 'wink' })\n"
                            "bullet.def('bar', { sprite = 'arrow', hit = { box = { 9, 5 } }, bank = 3 })\n"
                            "bullet.def('star', { sprite = 'dot', hit = { circle = 2 }, bank = 5, cloud = 'arrow' })\n"
                            "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 16, lives = 9 })\n"
                            "motion.def { name = 'turn', { turn = 3, over = 40 }, { speed = 0.5, over = 30 } }\n"
                            "motion.def { name = 'late', { wait = 7 }, { kind = 'bar', aim = true }, { die = true } }\n"
                            "motion.def { name = 'fine', fine = true, { accel = 0.01, over = 50 } }\n"
                            "motion.def { name = 'creep', fine = true }\n"
                            "string.sys.join(1, 'ship')\n";

static void power(struct rig_game *g, struct rig *r, const char *format, ...)
{
    static char text[4096];
    va_list args;
    size_t n = sizeof kinds - 1;

    memcpy(text, kinds, n);
    va_start(args, format);
    vsnprintf(text + n, sizeof text - n, format, args);
    va_end(args);
    rig_with_sys(g, NULL, text);
    rig_power(r, g, NULL);
}

static uint64_t bullets_hash(const struct rig *r)
{
    uint64_t part[MAX_PARTS];

    board_hashes(r->b, part);
    for (int i = 0; i < board_part_count(r->b); i++)
        if (!strcmp(board_part_name(r->b, i), "bullets"))
            return part[i];
    return 0;
}

/* One is fired with a delay of n, another n frames later: from then on their boards' bullets are equal, in every
 * column, also after a snapshot in the middle. */
static void same(const char *args, const char *writes, int n)
{
    const char *fire = "task.go(function() wait(%d) local b = bullet.fire { %s, delay = %d }\n"
                       "  wait(%d) %s end)\n";
    struct rig_game g, h;
    struct rig a, b;

    power(&g, &a, fire, 3, args, n, n / 2, writes);
    power(&h, &b, fire, 3 + n, args, 0, 0, writes);
    rig_run(&b, 3 + n + 1);
    for (int f = 0; f < 3 + n + 1; f++) {
        if (f == 3 + n / 2)
            rig_spoil(&a);
        rig_run(&a, 1);
        if (f < 3 + n && a.b->bullets.s.live)
            assert_true(a.b->bullets.vx[0] == 0 && a.b->bullets.vy[0] == 0);
    }
    for (int f = 0; f < 120; f++) {
        if (bullets_hash(&a) != bullets_hash(&b))
            fail_msg("{ %s } %s, delay %d: frame %d after it differs", args, writes, n, f);
        rig_run(&a, 1);
        rig_run(&b, 1);
    }
    rig_free(&a);
    rig_free(&b);
    rig_game_free(&g);
    rig_game_free(&h);
}

TEST(same)
{
    static const char *const args[] = {
        "kind = 'orb', x = 60, y = 40, speed = 1.5, dir = 33",
        "kind = 'bar', x = 60, y = 40, speed = 0.5, dir = 200, motion = 'turn', bank = 2",
        "kind = 'orb', x = 60, y = 40, speed = 2, motion = 'late', tag = 't'",
        "kind = 'star', x = 60, y = 40, speed = 0.001, motion = 'fine'",
        "kind = 'star', x = 60, y = 40, speed = 0.3, dir = 11, motion = 'creep'",
    };
    static const char *const writes[] = {
        "",
        "b.speed = 0.75",
        "b.dir = 77",
        "b.kind = 'star'",
        "b.kind = 'bar' b.bank = 9",
        "b.motion = 'late'",
        "b.motion = 'creep'",
        "b.motion = nil",
        "b.x, b.y = 99.5, 12.25",
        "b:turn(20)",
        "b:aim(3)",
        "local g = bullet.group() g.speed = 1.25 g:turn(7)",
    };
    static const int delays[] = { 1, 2, 40, 255, 256, 257, 600 };

    for (size_t i = 0; i < sizeof args / sizeof *args; i++) {
        for (size_t k = 0; k < sizeof delays / sizeof *delays; k++)
            same(args[i], "", delays[k]);
        for (size_t k = 0; k < sizeof writes / sizeof *writes; k++)
            same(args[i], writes[k], 20);
    }
}

static double global(struct rig *r, const char *name)
{
    lua_State *L = r->b->vm.L;

    lua_getglobal(L, "string");
    lua_getfield(L, -1, name);
    double v = lua_tonumber(L, -1);
    lua_pop(L, 2);
    return v;
}

/* A player stands in it all the while; the frame in which it starts is the first that touches. */
TEST(harmless)
{
    struct rig_game g;
    struct rig r;

    power(&g, &r,
          "string.hits, string.grazes = 0, 0\n"
          "on.hit(function() string.hits = string.hits + 1 end)\n"
          "on.graze(function() string.grazes = string.grazes + 1 end)\n"
          "task.go(function() local p = player.get(1) wait_until(function() return p.safe == 0 end)\n"
          "  bullet.fire { kind = 'orb', from = p, speed = 0, delay = 50 }\n"
          "  bullet.fire { kind = 'bar', from = p, speed = 3, dx = 9, delay = 50 } end)\n");
    for (int f = 0; !r.b->bullets.s.live; f++) {
        assert_true(f < 1000);
        rig_run(&r, 1);
    }
    rig_run(&r, 49);
    assert_true(global(&r, "hits") == 0 && global(&r, "grazes") == 0);
    assert_int_equal(r.b->counts.tested, 0);
    rig_run(&r, 1);
    assert_true(global(&r, "hits") == 1);
    rig_free(&r);
    rig_game_free(&g);
}

TEST(read)
{
    struct rig_game g;
    struct rig r;

    power(&g, &r,
          "string.good = 0\n"
          "task.go(function()\n"
          "  local b = bullet.fire { kind = 'orb', x = 50, y = 60, speed = 2, dir = 30, delay = 10 }\n"
          "  for i = 0, 10 do\n"
          "    assert(b.kind == 'orb' and b.delay == 10 - i and b.age == 0 and b.x == 50 and b.y == 60)\n"
          "    assert(b.speed == 2 and math.abs(b.vx - 2 * angle.cos(30)) < 0.0001, b.vx)\n"
          "    wait(1)\n"
          "  end\n"
          "  assert(b.age == 1 and b.delay == 0 and b.x > 51 and b.kind == 'orb')\n"
          "  b.kind = 'star' assert(b.kind == 'star')\n"
          "  local c = bullet.fire { kind = 'bar', x = 50, y = 60, speed = 2, delay = 10 }\n"
          "  c.kind = 'star' assert(c.kind == 'star' and c.bank == 5) c.vx, c.vy = 3, 4\n"
          "  assert(math.abs(c.speed - 5) < 0.0001 and c.x == 50)\n"
          "  local d = bullet.fire { kind = 'orb', x = 90, y = 60, speed = 2, delay = 10 }\n"
          "  assert(bullet.clear { x = 90, y = 60, radius = 1 } == 1 and not d.alive and c.alive)\n"
          "  local e = bullet.fire { kind = 'orb', x = 90, y = 60, speed = 2 }\n"
          "  wait(15) assert(e.age == 15 and c.age == 5 and c.kind == 'star' and e.kind == 'orb')\n"
          "  string.good = 1 end)\n");
    rig_run(&r, 40);
    assert_true(global(&r, "good") == 1);
    rig_free(&r);
    rig_game_free(&g);
}

/* The cloud's four frames share the delay; a slot that is used again flies at once. */
TEST(cloud)
{
    const int delay = 10;
    struct rig_game g;
    struct rig r;

    power(&g, &r,
          "task.go(function() local b = bullet.fire { kind = 'orb', x = 100, y = 80, speed = 0, delay = %d }\n"
          "  wait(%d) b:remove() bullet.fire { kind = 'orb', x = 100, y = 80, speed = 1 } end)\n",
          delay, delay + 5);
    for (int f = 0; f < delay + 5; f++) {
        bool cloud = f < delay;
        const struct sprite *s = &r.b->sprite_images[cart_find(&r.b->cart, CART_SPRITES, cloud ? "wink" : "dot")];
        int opaque = 0;
        rig_run(&r, 1);
        rig_picture(&r);
        for (int v = 0; v < s->h; v++)
            for (int u = 0; u < s->w; u++) {
                uint8_t want = s->pix[((cloud ? f * 4 / delay : 0) * s->h + v) * s->pitch + u];
                if (r.fb.pix[(80 - s->oy + v) * r.fb.pitch + 100 - s->ox + u] != want)
                    fail_msg("frame %d: pixel %d,%d differs", f, u, v);
                opaque += want != 0;
            }
        assert_true(opaque > 30);
    }
    rig_run(&r, 2);
    assert_true(r.b->bullets.vy[0] == 65536 && !(r.b->bullet_kinds.flags[r.b->bullets.kind[0]] & KIND_IS_CLOUD_ROW));
    rig_free(&r);
    rig_game_free(&g);
}

RUN_TESTS(NULL, NULL)
