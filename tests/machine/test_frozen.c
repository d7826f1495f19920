/*
 * test_frozen.c - what is frozen goes on as it was: random programs, fine ones too, moves of enemies and tasks that
 * things own, on a board where nothing stands and on one where things are frozen at random; after as many moves they
 * are the same, bit for bit. tests/scripts/frozen.lua has what scripts see.
 */
#include "rig.h"

static struct rig_game g, other_game;
static struct rig rig, other;

enum { FRAMES = 400, THINGS = 256 };

/* All that one thing's further way depends on, and what scripts can read of it. */
struct state {
    bool alive;
    int64_t x, y, vx, vy, speed, pace, way, from;
    ang dir;
    uint32_t age, left, made, over;
    uint16_t kind, bank, motion, pc, mute, rounds[MOTION_MAX_DEPTH];
};

static struct state plain[3][FRAMES + 1][THINGS]; /* bullets, shots, enemies: after so many moves */
static int moves[3][THINGS];

/* Is it on its way to a wall? Such a step has no end of its own. */
static bool bounces(const struct board *b, const struct bullets *s, uint32_t i)
{
    return s->motion[i] && b->steps.actions[b->motions.first[s->motion[i] - 1] + s->pc[i]] & DOES_BOUNCE;
}

static struct state of_bullet(const struct board *b, const struct bullets *s, uint32_t i)
{
    struct state v;

    memset(&v, 0, sizeof v);
    if (i >= s->s.top || !(s->s.live_bits[i / 64] >> i % 64 & 1))
        return v;
    v.alive = true;
    bullets_get_position(s, i, &v.x, &v.y);
    bullets_get_velocity(s, i, &v.vx, &v.vy);
    v.speed = bullets_speed(s, i);
    v.pace =
        s->flags[i] & BULLET_FINE || !s->speed_q32[i] ? s->speed_q32[i] : b->core.clock - s->speed_q32[i]; /* a clock */
    v.way = s->travel_q32[i];
    v.from = s->step_start[i];
    v.dir = s->dir[i];
    v.age = b->core.clock - s->born[i];
    v.left = s->step_flags[i] & STEP_BEGUN && !bounces(b, s, i) ? s->step_end[i] - b->core.clock : 0;
    v.kind = s->kind[i];
    v.bank = s->bank[i];
    v.motion = s->motion[i];
    v.pc = s->pc[i];
    v.mute = s->step_flags[i];
    memcpy(v.rounds, &s->rounds_left[i * MOTION_MAX_DEPTH], sizeof v.rounds);
    return v;
}

static struct state of_enemy(const struct board *b, uint32_t i)
{
    const struct enemies *e = &b->enemies;
    struct state v;

    memset(&v, 0, sizeof v);
    if (i >= e->s.top || !(e->s.live_bits[i / 64] >> i % 64 & 1))
        return v;
    v.alive = true;
    v.x = e->x[i];
    v.y = e->y[i];
    v.bank = e->bank[i];
    v.age = b->core.clock - e->born[i];
    v.over = e->move_duration[i];
    v.made = v.over ? e->move_elapsed[i] : 0;
    return v;
}

static struct state of(const struct board *b, int pool, uint32_t i)
{
    return pool == 2 ? of_enemy(b, i) : of_bullet(b, pool ? &b->shots : &b->bullets, i);
}

static bool stood(const struct board *b, int pool, uint32_t i)
{
    const uint8_t *stands = pool == 2 ? b->enemies.freeze_flags
                            : pool    ? b->shots.freeze_flags
                                      : b->bullets.freeze_flags;

    return stands && stands[i] & FREEZE_LAST_MOVE;
}

static const char world[] =
    "bullet.def('dot', { sprite = 'dot', hit = 'none' })\n"
    "bullet.def('box', { sprite = 'wink', hit = 'none', bank = 4 })\n"
    "shot.def('dot', { sprite = 'dot', hit = 'none' })\n"
    "enemy.def('foe', { sprite = 'dot', hit = 'none' })\n"
    "local function step(blind)\n"
    "  local s, k = {}, rng.int(1, 8)\n"
    "  if blind and (k == 5 or k == 6) then k = 3 end\n"
    "  if k == 1 then return { wait = rng.int(1, 20) } end\n"
    "  if k == 2 then s.turn = rng.number(-5, 5) end\n"
    "  if k == 3 then s.speed = rng.number(-1, 2) end\n"
    "  if k == 4 then s.accel = rng.number(-0.1, 0.1) end\n"
    "  if k == 5 then s.home = rng.number(0, 4) s.over = 20 end\n"
    "  if k == 6 then s.aim = true end\n"
    "  if k == 7 then s.kind = rng.pick { 'dot', 'box' } s.turn = 2 end\n"
    "  if k == 8 then s.bank = rng.int(0, 15) s.speed = 1.25 end\n"
    "  if k == 1 or rng.chance(0.7) and not s.home then s.over = rng.int(1, 30) end\n"
    "  return s\n"
    "end\n"
    "local function program(blind)\n"
    "  local p = { fine = rng.chance(0.4) }\n"
    "  for i = 1, rng.int(1, 5) do p[i] = step(blind) end\n"
    "  if rng.chance(0.5) then p = { fine = p.fine, { wait = 3 }, { loop = rng.int(1, 5), step(blind), { wait = 2 }, "
    "step(blind) "
    "}, p[1] } end\n"
    "  if not p.fine and rng.chance(0.5) then\n"
    "    p[#p + 1] = rng.pick { { polar = 0.5, spin = 2, over = 25 }, { wave = 8, every = 20, over = 40 },\n"
    "      { go_to = { 100, 90 }, over = 30, ease = 'both' }, { orbit = 30, at = { 120, 120 }, spin = 3, over = 45 },\n"
    "      { bounce = 3, walls = 'left right top', over = 90, { turn = 5, over = 4 } } }\n"
    "  end\n"
    "  if rng.chance(0.2) then p[#p + 1] = { wait = 60 } p[#p + 1] = { die = true } end\n"
    "  return motion.def(p)\n"
    "end\n"
    "local function own(t, turns)\n"
    "  for k = 1, turns do\n"
    "    wait(1 + k % 4)\n"
    "    if k % 5 == 0 then t.vx = 0.5 + k / 64 elseif k % 3 == 0 then t:turn(k) else t.bank = t.age % 16 end\n"
    "  end\n"
    "end\n"
    "local function walk(e, n)\n"
    "  while true do\n"
    "    e:move { x = (e.age * 7 + n) % 200, y = (e.age * 5 + n) % 200, over = 9 + n % 7, ease = 'both' }\n"
    "    task.go(function() wait(4) e.bank = e.age % 16 end)\n"
    "    wait(10 + n % 11)\n"
    "  end\n"
    "end\n"
    "local function fire()\n"
    "  for i = 1, 80 do\n"
    "    local a = { kind = 'dot', x = rng.number(0, 240), y = rng.number(0, 240), dir = rng.dir(),\n"
    "      speed = rng.number(-1, 1.5), tag = 't' .. i % 5, motion = rng.chance(0.8) and program() or nil, delay = i % "
    "7 == 0 and rng.int(1, 40) or nil }\n"
    "    local b = bullet.fire(a)\n"
    "    if i % 4 == 0 then b.vx = 0.3 end\n"
    "    if i % 3 == 0 then task.own(b, own, 90) end\n"
    "    if i <= 40 then\n"
    "      a.motion, a.delay = rng.chance(0.8) and program(true) or nil, nil\n" /* enemies may stand */
    "      local s = shot.fire(a)\n"
    "      if i % 3 == 1 then task.own(s, own, 90) end\n"
    "    end\n"
    "    if i <= 20 then enemy.spawn { kind = 'foe', x = 2 * i, y = i, tag = 't' .. i % 5, run = function(e) walk(e, "
    "i) end } end\n"
    "  end\n"
    "end\n"
    "local function freezer(seed)\n"
    "  local function draw(n) seed = (seed * 1103515245 + 12345) & 0x7fffffff return (seed >> 8) % n end\n"
    "  while true do\n"
    "    for _ = 1, draw(3) do\n"
    "      local pool, n = ({ bullet, shot, enemy })[1 + draw(3)], draw(4) == 0 and 0 or draw(5) == 0 and forever or "
    "draw(25)\n"
    "      local tag, one = 't' .. draw(5), draw(7)\n"
    "      if one < 3 then pool.group(tag).frozen = n\n"
    "      elseif one < 6 then pool.each(tag, function(t) if draw(3) == 0 then t.frozen = n end end)\n"
    "      else pool.group().frozen = 0 end\n"
    "    end\n"
    "    wait(1 + draw(9))\n"
    "  end\n"
    "end\n"
    "if FREEZE then task.go(freezer, SEED) end\n"
    "task.go(fire)\n"
    "if FREEZE then task.go(function() wait(1) freezer(SEED + 9) end) end\n";

static void power(struct rig_game *game, struct rig *r, bool freeze, int seed)
{
    struct manifest m = rig_manifest();
    struct board_start start = { .seed = (uint64_t)seed, .difficulty = -1 };
    char script[1 << 13];

    m.has_freeze = freeze;
    m.margin = 1024;
    m.motions = 128;
    m.tasks = 256;
    snprintf(script, sizeof script, "local FREEZE, SEED = %s, %d\n%s", freeze ? "true" : "false", seed, world);
    rig_script(game, &m, script);
    rig_power(r, game, &start);
}

/* After a move a thing is as the other board's was after as many; while it stands, it is where it was. */
static void compare(const struct board *b, int frame, int pool, uint32_t i, long *standing)
{
    bool still = stood(b, pool, i);
    struct state v = of(b, pool, i);
    const struct state *was = &plain[pool][moves[pool][i]][i];

    *standing += still && v.alive;
    if (!still)
        was = &plain[pool][++moves[pool][i]][i];
    if (v.alive != was->alive || v.x != was->x || v.y != was->y || (!still && memcmp(&v, was, sizeof v)))
        fail_msg("frame %d: pool %d, thing %u differs after %d moves", frame, pool, (unsigned)i, moves[pool][i]);
}

TEST(goes_on)
{
    const int seeds = rig_long() ? 300 : 12;
    long standing = 0, all = 0;

    for (int seed = 1; seed <= seeds; seed++) {
        power(&g, &rig, false, seed);
        power(&other_game, &other, true, seed);
        memset(moves, 0, sizeof moves);
        for (int f = 1; f <= FRAMES; f++) {
            rig_run(&rig, 1);
            for (int pool = 0; pool < 3; pool++)
                for (uint32_t i = 0; i < THINGS / (pool == 2 ? 8 : pool ? 4 : 1); i++)
                    plain[pool][f][i] = of(rig.b, pool, i);
        }
        for (int f = 1; f <= FRAMES; f++) {
            rig_run(&other, 1);
            for (int pool = 0; pool < 3; pool++)
                for (uint32_t i = 0; i < THINGS / (pool == 2 ? 8 : pool ? 4 : 1); i++)
                    compare(other.b, f, pool, i, &standing);
            all += other.b->bullets.s.live + other.b->shots.s.live + other.b->enemies.s.live;
        }
        rig_close(&rig);
        rig_close(&other);
    }
    assert_true(standing > all / 10 && standing < all * 9 / 10);
}

RUN_TESTS(NULL, NULL)
