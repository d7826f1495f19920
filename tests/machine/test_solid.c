/*
 * test_solid.c - shots that hit bullets: those that have hp, and those that a shot cancels. Which one each shot hits,
 * against the reference of hits.h; and by hand what comes of it.
 */
#include "hits.h"

enum { BULLETS = 192, SHOTS = 64, FOES = 32, KINDS = 5 };

/* ---- whom a shot hits ---- */

static void draw_kinds(struct bullet_kinds *k, fx span, uint16_t flags)
{
    k->s.live = KINDS;
    for (uint32_t i = 0; i < KINDS; i++) {
        k->shape[i] = (uint8_t)(one_in(9) ? SHAPE_NONE : one_in(2) ? SHAPE_CIRCLE : SHAPE_BOX);
        k->a[i] = one_in(20) ? fastest : within(span / 8 < fastest ? span / 8 : fastest);
        k->a[i] = k->a[i] < 0 ? -k->a[i] : k->a[i];
        k->b[i] = k->shape[i] == SHAPE_BOX ? k->a[i] / (fx)(1 + rng_below(&rng, 4)) : 0;
        k->flags[i] = (uint16_t)((one_in(3) ? 0 : KIND_SWEPT) | (one_in(3) ? flags : 0));
    }
}

static void draw_pool(struct bullets *s, uint64_t n, fx span, fx grain)
{
    while (n--) {
        struct bullet_spec shape = { .kind = (uint16_t)rng_below(&rng, KINDS), .delay = one_in(8) };
        uint32_t i = (uint32_t)bullets_fire(s, &shape, 0);
        fx most = one_in(9) ? fastest : span / 9 < fastest ? span / 9 : fastest;
        s->vx[i] = one_in(3) || shape.delay ? 0 : within(most);
        s->vy[i] = one_in(3) || shape.delay ? 0 : within(most);
        s->x[i] = clamped((int64_t)within(span) / grain * grain + s->vx[i], edge);
        s->y[i] = clamped((int64_t)within(span) / grain * grain + s->vy[i], edge);
        s->speed_bound = fx_max(s->speed_bound, fx_max(fx_abs(s->vx[i]), fx_abs(s->vy[i])));
        if (s->hp)
            s->hp[i] = one_in(2) ? 0 : one_in(3) ? HP_FOREVER : 1 + (int32_t)rng_below(&rng, 9);
        if (one_in(9))
            bullets_drop(s, i);
    }
}

static void draw_enemies(struct board *b, uint64_t n, fx span, fx grain)
{
    struct enemy_kinds *k = &b->enemy_kinds;

    k->s.live = 1;
    k->shape[0] = SHAPE_CIRCLE;
    k->a[0] = span / 16 < fastest ? span / 16 : fastest;
    while (n--)
        enemies_spawn(&b->enemies, k, 0, within(span) / grain * grain, within(span) / grain * grain, 0);
}

static void empty(struct board *b)
{
    EACH_LIVE (i, &b->shots.s)
        bullets_drop(&b->shots, i);
    EACH_LIVE (i, &b->bullets.s)
        bullets_drop(&b->bullets, i);
    EACH_LIVE (i, &b->enemies.s)
        enemies_drop(&b->enemies, i);
    slots_trim(&b->shots.s);
    slots_trim(&b->bullets.s);
    slots_trim(&b->enemies.s);
    b->bullets.speed_bound = b->shots.speed_bound = 0;
    b->events.n = 0;
}

static void scenes(bool hp, int n)
{
    struct rig_game g;
    struct rig r;

    open_pools(&r, &g, BULLETS, SHOTS, FOES, hp);
    for (int i = 0; i < n; i++) {
        fx span = (fx)(1 + (rng_below(&rng, (uint64_t)edge) >> rng_below(&rng, 22)));
        fx grain = one_in(2) ? 1 : 1 + span / (fx)(1 + rng_below(&rng, 9));
        empty(r.b);
        draw_kinds(&r.b->bullet_kinds, span, KIND_FIXED);
        draw_kinds(&r.b->shot_kinds, span, one_in(3) ? KIND_CANCELS : 0);
        draw_pool(&r.b->bullets, 1 + rng_below(&rng, BULLETS), span, grain);
        draw_pool(&r.b->shots, 1 + rng_below(&rng, SHOTS), span, grain);
        if (one_in(2))
            draw_enemies(r.b, 1 + rng_below(&rng, FOES), span, grain);
        reference(r.b);
        hit_run(r.b);
        compare(r.b, i);
    }
    rig_free(&r);
    rig_game_free(&g);
}

TEST(random)
{
    int n = rig_long() ? 60000 : 3000;

    rng_seed(&rng, 11);
    memset(&seen, 0, sizeof seen);
    scenes(true, n);
    if (seen.solids < n || seen.shots < n || seen.solid_ties < n / 9)
        fail_msg("too few: bullets %ld enemies %ld ties %ld", seen.solids, seen.shots, seen.solid_ties);
    memset(&seen, 0, sizeof seen);
    scenes(false, n);
    if (seen.solids < n / 2 || seen.shots < n)
        fail_msg("too few: cancelled %ld enemies %ld", seen.solids, seen.shots);
}

/* ---- what comes of it ---- */

static const char kinds[] =
    "spark.def('ping', { sprite = 'dot', life = 300, drag = 1 })\n"
    "spark.def('pong', { sprite = 'wink', life = 300 })\n"
    "shot.def('bolt', { sprite = 'dot', hit = { circle = 3 }, damage = 2 })\n"
    "shot.def('eraser', { sprite = 'dot', hit = { circle = 3 }, damage = 2, cancels = true })\n"
    "bullet.def('plain', { sprite = 'dot', hit = { circle = 4 }, vanish = 'pong' })\n"
    "bullet.def('fixed', { sprite = 'dot', hit = { circle = 4 }, clearable = false })\n"
    "enemy.def('foe', { sprite = 'dot', hit = { circle = 4 }, hp = 5 })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, lives = 3 }) string.sys.join(1, 'ship')\n"
    "local p = player.get(1)\n"
    "string.good = 0\n"
    "local function count() return bullet.group().count end\n"
    "local function fire(kind, y) return bullet.fire { kind = kind, x = 50, y = y or 100, speed = 0 } end\n"
    "local function shoot(kind, by) return shot.fire { kind = kind, x = 50, y = 150, speed = 10, by = by } end\n";

static const char with_hp[] =
    "local told = ''\n"
    "bullet.def('crate', { sprite = 'dot', hit = { circle = 4 }, hp = 5, score = 70, spark = 'ping', cloud = 'dot',\n"
    "  vanish = 'pong', on_death = function(b, p)\n"
    "    assert(not b.alive and b.kind == 'crate' and b.hp == 0 and b.x == 50)\n"
    "    told = told .. (p and p.index or 'x') .. ' ' end })\n"
    "bullet.def('wall', { sprite = 'dot', hit = { circle = 4 }, hp = forever })\n";

static void holds(bool hp, const char *task, int pings, int pongs)
{
    static char text[8192];
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;
    int sparks[2] = { 0 };

    m.has_hp = hp;
    snprintf(text, sizeof text, "%s%s\ntask.go(function() wait(1) %s string.good = 1 end)\n", kinds, hp ? with_hp : "",
             task);
    rig_with_sys(&g, &m, text);
    rig_power(&r, &g, NULL);
    for (int i = 0; i < 10; i++) {
        rig_run(&r, 10);
        rig_spoil(&r);
    }
    lua_getglobal(r.b->vm.L, "string");
    lua_getfield(r.b->vm.L, -1, "good");
    if (lua_tointeger(r.b->vm.L, -1) != 1)
        fail_msg("%s: it did not come to its end", task);
    EACH_LIVE (i, &r.b->sparks.s)
        sparks[r.b->sparks.kind[i]]++;
    if (sparks[0] != pings || sparks[1] != pongs)
        fail_msg("%s: %d and %d sparks, expected %d and %d", task, sparks[0], sparks[1], pings, pongs);
    rig_free(&r);
    rig_game_free(&g);
}

TEST(hp)
{
    holds(true,
          "local b, s = fire('crate'), shoot('bolt', p) assert(b.hp == 5) wait(10)\n"
          "assert(b.hp == 3 and not s.alive and told == '')",
          0, 0);
    holds(true,
          "local b = fire('crate') for i = 1, 3 do shoot('bolt', p) wait(1) end wait(10)\n"
          "assert(not b.alive and told == '1 ' and p.score == 70)",
          12, 0);
    holds(true,
          "local b = fire('crate') for i = 1, 3 do shoot('bolt') end local s = shoot('bolt') wait(10)\n"
          "assert(not b.alive and told == 'x ' and p.score == 0 and s.alive)",
          12, 0);
    holds(true,
          "local b = fire('wall') for i = 1, 9 do shoot('bolt') end wait(10)\n"
          "assert(b.alive and b.hp == forever and #query.near { what = 'shot', x = 50, y = 90, radius = 999 } == 0)",
          0, 0);
    holds(true, "local b, s = fire('plain'), shoot('bolt') wait(10) assert(b.alive and b.hp == 0 and s.alive)", 0, 0);
    holds(true, "local b, s = fire('plain'), shoot('bolt') b.hp = 2 wait(10) assert(not b.alive and not s.alive)", 0,
          0);
    holds(true, "local b, s = fire('crate'), shoot('bolt') b.hp = 0 wait(10) assert(b.alive and s.alive)", 0, 0);
    holds(true,
          "local b, s = fire('crate'), shoot('bolt') b.hp = forever b.kind = 'plain' wait(10)\n"
          "assert(b.alive and s.alive and b.hp == 0)",
          0, 0);
    holds(true, "local b = fire('plain') b.kind = 'crate' assert(b.hp == 5) bullet.group().hp = 1 assert(b.hp == 1)", 0,
          0);
    holds(true, "fire('crate') fire('wall', 30) assert(bullet.clear() == 2 and told == '')", 0, 1);
}

/* The nearest first; an enemy or a bullet; a delayed bullet lets shots pass; one that leaves the field can be hit. */
TEST(whom)
{
    holds(true,
          "local a, b = fire('crate', 60), fire('crate', 90) shoot('bolt') wait(12)\n"
          "assert(a.hp == 5 and b.hp == 3)",
          0, 0);
    holds(true,
          "local a, e = fire('crate', 100), enemy.spawn { kind = 'foe', x = 50, y = 80 } shoot('bolt') wait(12)\n"
          "assert(a.hp == 3 and e.hp == 5)",
          0, 0);
    holds(true,
          "local a, e = fire('crate', 80), enemy.spawn { kind = 'foe', x = 50, y = 100 } shoot('bolt') wait(12)\n"
          "assert(a.hp == 5 and e.hp == 3)",
          0, 0);
    holds(true,
          "local b = bullet.fire { kind = 'crate', x = 50, y = 100, speed = 0, delay = 60 } assert(b.hp == 5)\n"
          "local s = shoot('bolt') wait(20) assert(b.hp == 5) shoot('bolt') wait(45) assert(b.hp == 5)\n"
          "shoot('bolt') wait(10) assert(b.hp == 3)",
          0, 0);
    holds(true,
          "local b = bullet.fire { kind = 'crate', x = 50, y = 360, speed = 60, dir = 90 } b.hp = 2\n"
          "local s = shot.fire { kind = 'bolt', x = 50, y = 375, speed = 0 } wait(1)\n"
          "assert(not b.alive and told == 'x ' and not s.alive)",
          0, 0); /* its sparks are outside too */
    holds(true,
          "local b = fire('crate', -55) b.hp = 2\n"
          "local s = shot.fire { kind = 'bolt', x = 50, y = -40, speed = 60 } wait(1)\n"
          "assert(not b.alive and told == 'x ' and not s.alive)",
          12, 0);
}

TEST(cancels)
{
    for (int hp = 0; hp < 2; hp++) {
        holds(hp, "local b, s = fire('plain'), shoot('eraser') wait(10) assert(not b.alive and not s.alive)", 0, 1);
        holds(hp, "local b, s = fire('fixed'), shoot('eraser') wait(10) assert(b.alive and s.alive)", 0, 0);
        holds(hp, "local b, s = fire('plain'), shoot('bolt') wait(10) assert(b.alive and s.alive)", 0, 0);
        holds(hp, "fire('plain') fire('plain') fire('plain') shoot('eraser') wait(10) assert(count() == 2)", 0, 1);
        holds(hp, "fire('plain') fire('plain') shoot('eraser') shoot('eraser') wait(10) assert(count() == 0)", 0, 2);
        holds(hp,
              "local b = bullet.fire { kind = 'plain', x = 50, y = 100, speed = 0, delay = 40 }\n"
              "local s = shoot('eraser') wait(10) assert(b.alive and s.alive)",
              0, 0);
    }
    holds(true, "local b, s = fire('crate'), shoot('eraser') wait(10) assert(b.hp == 3 and not s.alive)", 0, 0);
}

static void fault(const char *text, const char *words)
{
    struct rig_game g;
    struct rig r;

    rig_script(&g, NULL, text);
    rig_power_any(&r, &g, NULL);
    assert_non_null(rig_fault(&r));
    assert_string_equal(rig_fault(&r)->message, words);
    rig_free(&r);
    rig_game_free(&g);
}

TEST(errors)
{
    fault("bullet.def('a', { sprite = 'dot', hit = 'none', hp = 3 })",
          "main.lua:1: bullet.def: hp: bullet hp is disabled; add `hp = true` to `board` in rom.lua");
    fault("bullet.def('a', { sprite = 'dot', hit = 'none', score = 3 })",
          "main.lua:1: bullet.def: score: requires `hp`");
    fault("bullet.def('a', { sprite = 'dot', hit = 'none' })\n"
          "bullet.fire { kind = 'a', x = 9, y = 9, speed = 1 }.hp = 3",
          "main.lua:2: bullet: hp: bullet hp is disabled; add `hp = true` to `board` in rom.lua");
    fault("bullet.def('a', { sprite = 'dot', hit = 'none' })\n"
          "print(bullet.fire { kind = 'a', x = 9, y = 9, speed = 1 }.hp)",
          "main.lua:2: bullet: hp: bullet hp is disabled; add `hp = true` to `board` in rom.lua");
}

RUN_TESTS(NULL, NULL)
