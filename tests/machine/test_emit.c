/*
 * test_emit.c - volleys with random arguments: an emit fires what the pattern in Lua with the same arguments fires, and
 * a pattern fires the same with and without `each`. tests/scripts/emit.lua tests the steps one by one.
 */
#include "rig.h"

static const char shared[] =
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })\n"
    "bullet.def('seed', { sprite = 'dot', hit = { circle = 3 }, bank = 6, cloud = 'wink' })\n"
    "shot.def('bolt', { sprite = 'dot', hit = { circle = 3 }, bank = 3 })\n"
    "enemy.def('foe', { sprite = 'wink', hit = { box = { 9, 9 } }, hp = 50 })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
    "value.def('power') value.def('heat') value.def('power', { of = 'shot' })\n"
    "motion.def { name = 'plain', { turn = 3, over = 5 } } motion.def { name = 'fine', fine = true }\n"
    "local number_of = { fan = 'spread', arc = 'sweep', stack = 'speed_to', line = 'width' }\n"
    "local function number(most)\n"
    "  if rng.chance(0.1) then return rng.pick { 0, -0.0, most, -most, 1e-9, 0.1 } end\n"
    "  return rng.chance(0.3) and rng.int(-most, most) or rng.number(-most, most)\n"
    "end\n"
    "local function random(name, kind, most_speed)\n"
    "  local a, word, p = { kind = kind, speed = number(most_speed) }, number_of[name], player.get(1)\n"
    "  p.x, p.y = rng.int(9, 200), rng.int(9, 200)\n"
    "  if name ~= 'one' then a.n = rng.int(0, 9) end\n"
    "  if word then a[word] = number(word == 'speed_to' and 6 or 300) end\n"
    "  if rng.chance(0.5) then a.dir = number(700) end\n"
    "  if rng.chance(0.4) then a.aim = true end\n"
    "  if rng.chance(0.3) then a.skip = { rng.int(-2, 4), rng.int(5, 7) } end\n"
    "  if rng.chance(0.3) then a.bank = rng.int(0, 15) end\n"
    "  if rng.chance(0.2) and kind ~= 'bolt' then a.delay = rng.int(0, 5) end\n"
    "  if rng.chance(0.4) then a.motion = rng.pick { 'plain', 'fine' } end\n"
    "  if rng.chance(0.4) then a.power = number(900) end\n"
    "  if rng.chance(0.2) then a.around = p end\n"
    "  return a\n"
    "end\n"
    "local function all(of, tag)\n"
    "  local list, of_bullets = {}, of == bullet\n"
    "  of.each(tag, function(b)\n"
    "    list[#list + 1] = { b.x, b.y, b.dir, b.speed, b.vx, b.vy, b.kind, b.bank, b.motion or 0, b.age, b.power,\n"
    "      b.around or 0, of_bullets and b.delay or 0, of_bullets and b.heat or 0 }\n"
    "  end)\n"
    "  return list\n"
    "end\n"
    "local seen = {}\n"
    "local function same(run, name, got, want)\n"
    "  seen[name] = (seen[name] or 0) + #want\n"
    "  if #got ~= #want then error(('%d %s: %d bullets, expected %d'):format(run, name, #got, #want)) end\n"
    "  for i, b in ipairs(want) do for k, v in ipairs(b) do if got[i][k] ~= v then\n"
    "    error(('%d %s: bullet %d: %d: %s, expected %s'):format(run, name, i, k, got[i][k], v)) end end end\n"
    "end\n";

/* Its asserts are the test; it must come to its end. */
static void run(const char *text, int frames)
{
    static char script[1 << 14];
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    m.lua_kib = 4096;
    m.motions = 2000;
    m.has_orbit = 1;
    m.bullet_values = 2;
    m.shot_values = 1;
    snprintf(script, sizeof script, "%stask.go(function() string.sys.join(1, 'ship')\n%sboard.note(1) end)", shared,
             text);
    rig_with_sys(&g, &m, script);
    rig_power(&r, &g, NULL);
    rig_run(&r, frames);
    assert_true(r.b->core.note_digest != 0);
    rig_close(&r);
}

/* Twins in the same frame: one runs an emit, a task fires the pattern from the other. A frame later each has moved
 * once. */
TEST(patterns)
{
    run("for i = 1, 700 do\n"
        "  local name = rng.pick { 'one', 'ring', 'fan', 'arc', 'stack', 'line' }\n"
        "  local a = random(name, rng.pick { 'dot', 'seed' }, 5)\n"
        "  local e = { pattern = name, tag = 'e' } for k, v in pairs(a) do e[k] = v end\n"
        "  local emitter = bullet.fire { kind = 'dot', speed = number(3), dir = number(360),\n"
        "    x = rng.chance(0.1) and rng.pick { 270, -60 } or rng.number(0, 200), y = rng.number(-20, 200),\n"
        "    motion = motion.def { fine = rng.chance(0.2), { wait = 1 }, { emit = e }, { die = true } } }\n"
        "  wait(1)\n"
        "  a.from, a.tag, a.dir = emitter, 'l', a.dir or not a.aim and emitter.dir or nil\n"
        "  if name ~= 'one' then\n"
        "    a.each = function(t) bullet.fire(t) end\n"
        "    pattern[name](a)\n"
        "  elseif not a.skip or a.skip[1] > 1 then\n"
        "    a.skip = nil\n"
        "    bullet.fire(a)\n"
        "  end\n"
        "  wait(1)\n"
        "  local want = all(bullet, 'l')\n"
        "  wait(1)\n"
        "  same(i, name, all(bullet, 'e'), want)\n"
        "  bullet.group():remove()\n"
        "end\n"
        "for _, n in pairs(seen) do assert(n > 50) end\n",
        2200);
}

/* Of bullets and shots, from places at the edge of the world, into a full pool, from what has despawned. */
TEST(volleys)
{
    run("local foe, full = enemy.spawn { kind = 'foe', x = 100, y = 30 }, 0\n"
        "local dead = bullet.fire { kind = 'dot', x = 9, y = 9, speed = 1 } dead:remove()\n"
        "for i = 1, 1500 do\n"
        "  local name, shots = rng.pick { 'ring', 'fan', 'arc', 'stack', 'line' }, rng.chance(0.3)\n"
        "  local of, pool = shots and shot or bullet, shots and 'shots' or 'bullets'\n"
        "  local a = random(name, shots and 'bolt' or rng.pick { 'dot', 'seed' }, rng.pick { 5, 8191 })\n"
        "  a.fire = shots and 'shot' or rng.chance(0.5) and 'bullet' or nil\n"
        "  foe.x, foe.y = rng.int(-60, 300), rng.int(-40, 200)\n"
        "  if rng.chance(0.05) then a.n = 4500 end\n"
        "  if rng.chance(0.2) and shots then a.by = player.get(1) end\n"
        "  if rng.chance(0.5) then a.from = rng.chance(0.1) and dead or rng.chance(0.5) and foe or player.get(1)\n"
        "  else a.x, a.y = rng.number(0, 200), rng.number(-20, 200) end\n"
        "  if rng.chance(0.3) then a.dx = number(rng.chance(0.1) and 16000 or 50) end\n"
        "  if rng.chance(0.3) then a.dy = number(rng.chance(0.1) and 16000 or 50) end\n"
        "  local before = board.refused(pool)\n"
        "  a.tag = 'l'\n"
        "  pattern[name](a)\n"
        "  local got, lost = all(of, 'l'), board.refused(pool) - before\n"
        "  of.group():remove()\n"
        "  a.each = function(t) of.fire(t) end\n"
        "  pattern[name](a)\n"
        "  same(i, name, got, all(of, 'l'))\n"
        "  assert(board.refused(pool) - before == 2 * lost)\n"
        "  if lost > 0 then full = full + 1 end\n"
        "  of.group():remove()\n"
        "  if i % 4 == 0 then wait(1) end\n"
        "end\n"
        "for _, n in pairs(seen) do assert(n > 500) end\n"
        "assert(full > 10, full)\n",
        400);
}

static void expect_fault(const char *program, const char *message)
{
    struct manifest m = rig_manifest();
    char script[256];
    struct rig_game g;

    m.has_orbit = 1;
    snprintf(script, sizeof script, "motion.def { %s }", program);
    rig_script(&g, &m, script);
    assert_string_equal(rig_said(&g, 1, false), message);
    rig_game_free(&g);
}

/* Loops whose steps may take no time. */
TEST(endless_loops)
{
    expect_fault("{ loop = forever, { wait_for = { x = 1 } } }",
                 "motion.def: step 1: infinite loop: with `loop = forever`, at least one step must take time "
                 "(`wait_for` takes no time if its condition already holds: add { wait = 1 })");
    expect_fault("{ loop = forever, { loop = 3, { orbit = 50, over = 15 }, { turn = 3 } } }",
                 "motion.def: step 1: infinite loop: with `loop = forever`, at least one step must take time "
                 "(`orbit` takes no time once its thing has despawned: add { wait = 1 })");
    expect_fault("{ loop = 60000, { loop = 60000, { orbit = 50, over = 15 } } }",
                 "motion.def: step 1: this loop runs too many steps in one frame; at least one of them must take time "
                 "(`orbit` takes no time once its thing has despawned: add { wait = 1 })");
}

RUN_TESTS(NULL, NULL)
