/*
 * test_extremes.c - scripts that pass the largest, the smallest and the oddest numbers they may, for many frames.
 * Nothing lives outside of the world, and no speed grows past its limit. `make ubsan` runs it under UBSan, where an
 * overflow ends it.
 */
#include "rig.h"

static struct rig_game g;
static struct rig rig;

/* Calls with arguments drawn from the ends of what is allowed; one in eight is anywhere in between. */
static const char script[] =
    "local TINY <const> = 1 / 4294967296\n"
    "local function of(list, lo, hi)\n"
    "  if rng.chance(0.12) then return rng.number(lo, hi) end\n"
    "  return rng.pick(list)\n"
    "end\n"
    "local function speed() return of({ 0, 8191, -8191, 8191 - TINY, 1 / 65536, -1 / 65536, TINY, 1, 400, -60 }, "
    "-8191, 8191) end\n"
    "local function place() return of({ 0, -1024, 2047.9999, 512, 511.5, 16383, -16383, 200, 201, 1 / 65536 }, -16383, "
    "16383) end\n"
    "local function near() return 512 + of({ 0, 4, -4, 3.99999, 16, -16.5, 1 / 65536, -8, 40 }, -200, 200) end\n"
    "local function dir() return of({ 0, 90, 180, 270, 45, 359.99999999, -1e15, 2147483648, 5e-324, 1e-9, -0.0, 1e300, "
    "-1e300 }, "
    "-1e15, 1e15) end\n"
    "local function frames() return rng.pick { 1, 1, 2, 3, 60, 1000000000 } end\n"
    "local function step(deep)\n"
    "  local s, k = {}, rng.int(1, 10)\n"
    "  if k == 1 and deep < 4 then\n"
    "    s.loop = rng.pick { 0, 1, 65534, forever }\n"
    "    for i = 1, rng.int(1, 3) do s[i] = step(deep + 1) end\n"
    "    s[#s + 1] = { wait = 1 }\n"
    "    return s\n"
    "  end\n"
    "  if k == 2 then return { wait = rng.pick { 0, 1, 2, forever } } end\n"
    "  if rng.chance(0.5) then s.over = frames() end\n"
    "  if rng.chance(0.5) then s.speed = speed() end\n"
    "  if rng.chance(0.4) then s.accel = speed() end\n"
    "  if rng.chance(0.4) then s.turn = dir() end\n"
    "  if rng.chance(0.2) then s.aim = true end\n"
    "  if s.over and rng.chance(0.3) then s.home = of({ 0, 180, 1e-9, 90 }, 0, 180) end\n"
    "  if not s.over and rng.chance(0.3) then s.dir = dir() end\n"
    "  if rng.chance(0.2) then s.kind = rng.pick(KINDS) end\n"
    "  s.bank = rng.int(0, 15)\n"
    "  return s\n"
    "end\n"
    "local motions = {}\n"
    "local function motion_of()\n"
    "  if #motions < 24 then\n"
    "    local m = { fine = rng.chance(0.5) }\n"
    "    for i = 1, rng.int(1, 5) do m[i] = step(1) end\n"
    "    motions[#motions + 1] = motion.def(m)\n"
    "  end\n"
    "  return rng.chance(0.6) and rng.pick(motions) or nil\n"
    "end\n"
    "local function fire(what, kinds)\n"
    "  local b = what.fire { kind = rng.pick(kinds), x = rng.chance(0.7) and near() or place(), y = rng.chance(0.7) "
    "and near() or place(),\n"
    "    dir = dir(), speed = speed(), motion = motion_of(), aim = rng.chance(0.2), tag = rng.pick { 'a', 'b' } }\n"
    "  return b\n"
    "end\n"
    "local function write(b)\n"
    "  local k = rng.int(1, 9)\n"
    "  if k == 1 then b.speed = speed() elseif k == 2 then b.dir = dir() elseif k == 3 then b.vx = speed()\n"
    "  elseif k == 4 then b.vy = speed() elseif k == 5 then b.x = near() elseif k == 6 then b.y = place()\n"
    "  elseif k == 7 then b.motion = motion_of() elseif k == 8 then b:turn(dir()) else b:aim(dir()) end\n"
    "  if b.alive then board.note(b.x + b.y + b.vx + b.vy + b.speed + b.dir) end\n"
    "end\n"
    "local function others()\n"
    "  local p = player.get(rng.int(1, 2))\n"
    "  if p.alive then p.safe = 0 if rng.chance(0.3) then p.x, p.y = near(), near() end end\n"
    "  local e = enemy.spawn { kind = rng.pick { 'wall', 'globe', 'shade' }, x = near(), y = near() }\n"
    "  e:move { x = place(), y = place(), over = rng.pick { 1, 2, 7, 1000000000 }, ease = rng.pick { 'linear', 'in', "
    "'out', 'both' } }\n"
    "  spark.burst { kind = 'ping', x = place(), y = place(), n = 3, dir = dir(), speed = of({ 8191, 0, TINY }, 0, "
    "8191), spread = 360 }\n"
    "  query.near { what = 'bullet', x = place(), y = place(), radius = of({ 0, 32767, 1 / 65536 }, 0, 32767) }\n"
    "  board.note(angle.to({ x = place(), y = place() }, { x = place(), y = place() }) + angle.sin(dir()) + "
    "angle.difference(dir(), dir()))\n"
    "  if rng.chance(0.2) then bullet.clear { x = place(), y = place(), radius = of({ 0, 8191 }, 0, 8191), spark = "
    "'ping' } end\n"
    "  enemy.each(nil, function(one) if one.age > 20 then one:remove() end end)\n"
    "end\n"
    "task.go(function()\n"
    "  while true do\n"
    "    for _ = 1, 12 do fire(bullet, KINDS) end\n"
    "    for _ = 1, 4 do fire(shot, { 'bolt', 'ball' }) end\n"
    "    bullet.each(rng.pick { 'a', 'b' }, function(b) if rng.chance(0.1) then write(b) end end)\n"
    "    if rng.chance(0.1) then bullet.group('a').speed = speed() bullet.group('b').x = near() "
    "bullet.group('a'):turn(dir()) end\n"
    "    others()\n"
    "    wait(1)\n"
    "  end\n"
    "end)\n";

/* The kinds: their extents are drawn too, so that each seed has its own. */
static const char kinds[] =
    "spark.def('ping', { sprite = 'dot', life = 30, gravity = 8191, drag = 1 })\n"
    "local function size() return rng.pick { 0, 1 / 65536, 2, 4, 3.5, 8, 160, 8191 } end\n"
    "bullet.def('dot', { sprite = 'dot', hit = { circle = size() } })\n"
    "bullet.def('late', { sprite = 'dot', hit = { circle = size() }, swept = false })\n"
    "bullet.def('crate', { sprite = 'dot', hit = { box = { size(), size() } }, turns = true })\n"
    "bullet.def('air', { sprite = 'dot', hit = 'none' })\n"
    "shot.def('bolt', { sprite = 'dot', hit = { box = { size(), size() } } })\n"
    "shot.def('ball', { sprite = 'dot', hit = { circle = size() }, swept = rng.chance(0.5) })\n"
    "enemy.def('wall', { sprite = 'dot', hit = { box = { size(), size() } }, hp = 1000000 })\n"
    "enemy.def('globe', { sprite = 'dot', hit = { circle = size() }, swept = false, hp = 1000000 })\n"
    "enemy.def('shade', { sprite = 'dot', hit = 'none' })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = size() }, graze = size(), speed = rng.pick { 4, 8191 }, "
    "lives = 99, safe = 1 })\n"
    "string.sys.join(1, 'ship') string.sys.join(2, 'ship')\n"
    "local KINDS <const> = { 'dot', 'late', 'crate', 'air' }\n";

static void begin(uint64_t seed)
{
    static char text[sizeof script + sizeof kinds];
    struct manifest m = rig_manifest();
    struct board_start start = { .seed = seed, .difficulty = -1 };

    m.screen_w = m.screen_h = m.field_w = m.field_h = 1024;
    m.margin = 1024;
    snprintf(text, sizeof text, "%s%s", kinds, script);
    rig_with_sys(&g, &m, text);
    rig_power(&rig, &g, &start);
}

static void inside(fx x, fx y, const char *what, uint32_t i)
{
    const struct box *k = &rig.b->keep_box;

    if (x < k->x0 || x > k->x1 || y < k->y0 || y > k->y1)
        fail_msg("%s %u lives at (%d, %d), outside the world", what, i, x, y);
}

/* What every frame must leave. */
static void check_pool(const struct bullets *s, const struct bullet_kinds *k, const char *what)
{
    const fx most = (fx)MAX_SPEED << 16;

    EACH_LIVE (i, &s->s) {
        inside(s->x[i], s->y[i], what, i);
        assert_true(s->kind[i] < k->s.live);
        assert_true(s->speed[i] <= most && s->speed[i] >= -most);
        assert_true(s->vx[i] <= most + 1 && s->vx[i] >= -most - 1 && s->vy[i] <= most + 1 && s->vy[i] >= -most - 1);
    }
    for (uint32_t i = 0; i < s->s.top; i++)
        if (!(s->s.live_bits[i / 64] >> (i & 63) & 1))
            assert_true(!s->x[i] && !s->y[i] && !s->vx[i] && !s->vy[i]);
}

TEST(scripts)
{
    int seeds = rig_long() ? 2000 : 120;
    int64_t grazes = 0;

    for (int seed = 0; seed < seeds; seed++) {
        uint16_t pads[MAX_PLAYERS];
        struct rng r;

        rng_seed(&r, (uint64_t)seed);
        begin((uint64_t)seed);
        for (int f = 0; f < 120; f++) {
            rig_pads(&r, pads);
            if (board_tick(rig.b, pads)->fault)
                fail_msg("seed %d, frame %d: %s", seed, f, rig_fault(&rig)->message);
            check_pool(&rig.b->bullets, &rig.b->bullet_kinds, "bullet");
            check_pool(&rig.b->shots, &rig.b->shot_kinds, "shot");
        }
        rig_picture(&rig);
        grazes += rig.b->player.grazes[0];
        rig_close(&rig);
    }
    assert_true(grazes > 100);
}

RUN_TESTS(NULL, NULL)
