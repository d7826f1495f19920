/*
 * test_groups.c - what is done to a group in C is what a loop over its things does: random writes and verbs of groups
 * of bullets, shots and enemies on one board, the same one by one on another, and equal columns in every frame. Clears
 * and queries of circles, boxes and lines take what whole numbers say in Lua. tests/scripts/groups.lua has the rest.
 */
#include "rig.h"

static struct rig_game g;
static struct rig rig;

static const char kinds[] =
    "spark.def('glow', { sprite = 'dot', life = 9 })\n"
    "for _, k in ipairs { 'dot', 'bolt' } do bullet.def(k, { sprite = 'dot', hit = 'none', graze = false }) end\n"
    "bullet.def('ball', { sprite = 'wink', hit = 'none', bank = 3, graze = false })\n"
    "shot.def('bolt', { sprite = 'dot', hit = 'none' })\n"
    "shot.def('ball', { sprite = 'wink', hit = 'none', bank = 5 })\n"
    "enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 9, score = 7, spark = 'glow',\n"
    "  on_death = function(e, p) if e.tag == 'a' then\n"
    "    enemy.spawn { kind = 'foe', x = e.x, y = e.y, tag = 'a', hp = 1 } end end })\n"
    "motion.def { name = 'spin', { turn = 3, over = 50 }, { speed = 1, over = 9 } }\n"
    "motion.def { name = 'fine', fine = true, { accel = 0.01, over = 90 } }\n";

/* What a test does with GROUPS true or false: one call of `all` is a verb or write on all that have the tag. */
static const char random_script[] =
    "local function all(pool, tag, f) if GROUPS then f(pool.group(tag)) else pool.each(tag, f) end end\n"
    "local function any(...) return rng.pick { ... } end\n"
    "local function px() return rng.number(-60, 300) end\n"
    "local flying = {\n"
    "  function() local v = px() return function(t) t.x = v end end,\n"
    "  function() local v = px() return function(t) t.y = v end end,\n"
    "  function() local v = rng.dir() return function(t) t.dir = v end end,\n"
    "  function() local v = rng.number(-2, 4) return function(t) t.speed = v end end,\n"
    "  function() local v = rng.number(-2, 2) return function(t) t.vx = v end end,\n"
    "  function() local v = rng.number(-2, 2) return function(t) t.vy = v end end,\n"
    "  function() local v = any('bolt', 'ball') return function(t) t.kind = v end end,\n"
    "  function() local v = rng.int(0, 15) return function(t) t.bank = v end end,\n"
    "  function() local v = any('a', 'b', 'c') return function(t) t.tag = v end end,\n"
    "  function() local v = any('spin', 'fine') return function(t) t.motion = v end end,\n"
    "  function() return function(t) t.motion = nil end end,\n"
    "  function() local v = rng.dir() return function(t) t:aim(v) end end,\n"
    "  function() local v = rng.dir() return function(t) t:turn(v) end end,\n"
    "  function() local x, y = rng.number(-40, 40), rng.number(-40, 40) return function(t) t:shift(x, y) end end,\n"
    "  function() return function(t) if rng_low then t:remove() end end end,\n"
    "  function() return function(t) if rng_low then t:clear { spark = 'glow' } end end end,\n"
    "}\n"
    "local walking = {\n"
    "  function() local v = px() return function(t) t.x = v end end,\n"
    "  function() local v = px() return function(t) t.y = v end end,\n"
    "  function() local v = rng.int(1, 30) return function(t) t.hp = v end end,\n"
    "  function() local v = rng.int(0, 15) return function(t) t.bank = v end end,\n"
    "  function() local v = any('a', 'b', 'c') return function(t) t.tag = v end end,\n"
    "  function() local v = any(0, 3, forever) return function(t) t.safe = v end end,\n"
    "  function() local a = { x = px(), y = px(), over = rng.int(1, 40), ease = any('in', 'out', 'both') }\n"
    "    return function(t) t:move(a) end end,\n"
    "  function() local x, y = rng.number(-40, 40), rng.number(-40, 40) return function(t) t:shift(x, y) end end,\n"
    "  function() local n = rng.int(0, 9) return function(t) t:hurt(n) end end,\n"
    "  function() return function(t) if rng_low then t:kill(1) end end end,\n"
    "  function() return function(t) if rng_low then t:remove() end end end,\n"
    "}\n"
    "task.go(function()\n"
    "  for n = 1, forever do\n"
    "    for i = 1, 6 do\n"
    "      local a = { kind = any('bolt', 'ball'), x = px(), y = px(), dir = rng.dir(), speed = rng.number(0, 3),\n"
    "        tag = any('a', 'b', 'c', nil), motion = any('spin', 'fine', 'spin') }\n"
    "      if i % 2 == 0 then a.motion = nil end\n"
    "      bullet.fire(a)\n"
    "      shot.fire(a)\n"
    "    end\n"
    "    if enemy.count() < 25 then\n"
    "      enemy.spawn { kind = 'foe', x = px(), y = px(), tag = any('a', 'b', 'c'), hp = rng.int(1, 20) }\n"
    "    end\n"
    "    rng_low = n % 9 == 0\n"
    "    local tag = any('a', 'b', 'c', nil)\n"
    "    if n % 23 == 0 then tag = nil end\n"
    "    local b, s, e = any(table.unpack(flying))(), any(table.unpack(flying))(), any(table.unpack(walking))()\n"
    "    all(bullet, tag, b) all(enemy, tag, e)\n"
    "    all(shot, tag, s)\n"
    "    wait(1)\n"
    "  end\n"
    "end)\n";

static void power(struct rig_game *game, struct rig *r, const char *first, const char *text)
{
    struct manifest m = rig_manifest();
    char script[1 << 14];

    m.bullets = 512;
    m.shots = 512;
    snprintf(script, sizeof script, "%s%s%s", first, kinds, text);
    rig_script(game, &m, script);
    rig_power(r, game, NULL);
}

TEST(random)
{
    const int frames = rig_long() ? 20000 : 1500;
    struct rig_game other_game;
    struct rig other;
    uint64_t ha[MAX_PARTS], hb[MAX_PARTS], seen = 0;

    power(&g, &rig, "local GROUPS, rng_low = true, false\n", random_script);
    power(&other_game, &other, "local GROUPS, rng_low = false, false\n", random_script);
    for (int f = 0; f < frames; f++) {
        rig_run(&rig, 1);
        rig_run(&other, 1);
        board_hashes(rig.b, ha);
        board_hashes(other.b, hb);
        for (int i = 0; i < board_part_count(rig.b); i++)
            if (ha[i] != hb[i] && strcmp(board_part_name(rig.b, i), "script"))
                fail_msg("frame %d: %s differ", f, board_part_name(rig.b, i));
        seen += rig.b->bullets.s.live + rig.b->shots.s.live + rig.b->enemies.s.live;
    }
    print_message("# %d frames of random groups equal loops, over %.0f things on average\n", frames,
                  (double)seen / frames);
    assert_true(seen / (uint64_t)frames > 200);
    assert_true(other.b->counts.moved > 0);
    rig_close(&other);
    rig_close(&rig);
}

/* Bullets at quarters of a pixel; shapes likewise. All in whole numbers of eighths. */
static const char shapes_script[] =
    "local function q(lo, hi) return rng.int(lo * 4, hi * 4) * 2 end\n"
    "local function square(v) return v * v end\n"
    "local function inside(s, x, y)\n"
    "  local dx, dy = x - s.x, y - s.y\n"
    "  if s.radius then return square(dx) + square(dy) <= square(s.radius) end\n"
    "  if s.w then return 2 * math.abs(dx) <= s.w and 2 * math.abs(dy) <= s.h end\n"
    "  local wx, wy = s.to_x - s.x, s.to_y - s.y\n"
    "  local along, ww = dx * wx + dy * wy, wx * wx + wy * wy\n"
    "  if along <= 0 then return 4 * (square(dx) + square(dy)) <= square(s.width) end\n"
    "  if along >= ww then return 4 * (square(x - s.to_x) + square(y - s.to_y)) <= square(s.width) end\n"
    "  return 4 * square(dx * wy - dy * wx) <= square(s.width) * ww\n"
    "end\n"
    "local function shape()\n"
    "  local s = { x = q(-20, 260), y = q(-20, 260) }\n"
    "  local how = rng.int(1, 3)\n"
    "  if how == 1 then s.radius = q(0, 90)\n"
    "  elseif how == 2 then s.w, s.h = q(0, 160), q(0, 160)\n"
    "  else s.to_x, s.to_y, s.width = q(-20, 260), q(-20, 260), q(0, 60) end\n"
    "  if rng.chance(0.2) and how == 3 then s.to_x = s.x if rng.chance(0.5) then s.to_y = s.y end end\n"
    "  return s\n"
    "end\n"
    "local function told(s, more)\n"
    "  local a = more or {}\n"
    "  for k, v in pairs(s) do a[k] = v / 8 end\n"
    "  return a\n"
    "end\n"
    "local function fill()\n"
    "  bullet.clear() shot.group():clear()\n"
    "  for i = 1, 200 do\n"
    "    local x, y, tag = q(0, 240) / 8, q(0, 240) / 8, i % 3 == 0 and 't' or nil\n"
    "    bullet.fire { kind = 'dot', x = x, y = y, speed = 0, tag = tag }\n"
    "    shot.fire { kind = 'bolt', x = x, y = y, speed = 0, tag = tag }\n"
    "  end\n"
    "end\n";

static const char clears_script[] =
    "task.go(function() while true do\n"
    "  fill()\n"
    "  for i = 1, 12 do\n"
    "    local s, tag, want, n = shape(), rng.chance(0.5) and 't' or nil, {}, 0\n"
    "    bullet.each(tag, function(b) if inside(s, 8 * b.x // 1 | 0, 8 * b.y // 1 | 0) then want[b] = true n = n + 1 "
    "end end)\n"
    "    local before, shots, got = bullet.group().count, 0\n"
    "    shot.each(tag, function(b) if inside(s, 8 * b.x // 1 | 0, 8 * b.y // 1 | 0) then shots = shots + 1 end end)\n"
    "    if i % 2 == 0 then got = bullet.clear(told(s, { tag = tag })) else got = bullet.group(tag):clear(told(s)) "
    "end\n"
    "    for b in pairs(want) do if b.alive then error('left') end end\n"
    "    if got ~= n or bullet.group().count ~= before - n then error(got .. ' for ' .. n) end\n"
    "    if shot.group(tag):clear(told(s)) ~= shots then error('shots') end\n"
    "    taken = taken + n\n"
    "  end\n"
    "  print(taken)\n"
    "  wait(1)\n"
    "end end)\n";

/* Each query's list against the loop's, sorted by distance and then by slot. */
static const char queries_script[] =
    "local pools = { bullet = bullet, shot = shot, enemy = enemy }\n"
    "local function asked(s, a)\n"
    "  if s.radius then return query.near(told(s, a)) end\n"
    "  return s.w and query.box(told(s, a)) or query.line(told(s, a))\n"
    "end\n"
    "task.go(function() while true do\n"
    "  fill()\n"
    "  enemy.group():remove()\n"
    "  for i = 1, 30 do enemy.spawn { kind = 'foe', x = q(0, 240) / 8, y = q(0, 240) / 8, tag = i % 3 == 0 and 't' or "
    "nil } end\n"
    "  for i = 1, 12 do\n"
    "    local s, tag, want = shape(), rng.chance(0.5) and 't' or nil, {}\n"
    "    local what = rng.pick { 'bullet', 'shot', 'enemy' }\n"
    "    if s.radius and s.radius > 400 then s.radius = 400 end\n"
    "    pools[what].each(tag, function(b)\n"
    "      local x, y = 8 * b.x // 1 | 0, 8 * b.y // 1 | 0\n"
    "      if inside(s, x, y) then want[#want + 1] = { b, square(x - s.x) + square(y - s.y) } end\n"
    "    end)\n"
    "    table.sort(want, function(a, b)\n"
    "      if a[2] ~= b[2] then return a[2] < b[2] end\n"
    "      return a[1] & 0xffffff < b[1] & 0xffffff\n"
    "    end)\n"
    "    local got = asked(s, { what = what, tag = tag })\n"
    "    if #got ~= #want then error(#got .. ' for ' .. #want) end\n"
    "    for k = 1, #want do if got[k] ~= want[k][1] then error('the order') end end\n"
    "    taken = taken + #want\n"
    "  end\n"
    "  print(taken)\n"
    "  wait(1)\n"
    "end end)\n";

static void run_shapes(const char *script, int frames)
{
    static char text[1 << 14];

    snprintf(text, sizeof text, "%s%s", shapes_script, script);
    power(&g, &rig, "local taken = 0\n", text);
    rig_run(&rig, frames);
    const struct board_out *out = board_last_output(rig.b);
    print_message("# %.*s things taken by shapes, as whole numbers say\n", (int)out->log_size - 1, out->log);
    assert_true(atoi(out->log) > frames);
    rig_close(&rig);
}

TEST(clears)
{
    run_shapes(clears_script, rig_long() ? 2000 : 150);
}

TEST(queries)
{
    run_shapes(queries_script, rig_long() ? 2000 : 150);
}

/* Circles that grow, each against what is left by a loop with the closed form of its radius. */
static const char sweeps_script[] =
    "task.go(function() while true do\n"
    "  fill()\n"
    "  enemy.group():remove()\n"
    "  for i = 1, 20 do enemy.spawn { kind = 'foe', x = q(0, 240) / 8, y = q(0, 240) / 8, hp = 1000 } end\n"
    "  local lo, hi, over, n = rng.int(0, 40), rng.int(0, 120), 1 << rng.int(0, 5), rng.int(1, 9)\n"
    "  local x, y, vx, vy, tag = q(0, 240) / 8, q(0, 240) / 8, rng.int(-2, 2), rng.int(-2, 2), rng.pick { 't', false "
    "}\n"
    "  local still = rng.chance(0.5)\n"
    "  if still then vx, vy = 0, 0 end\n"
    "  local lead = sprite.put { sprite = 'dot', x = x, y = y }\n"
    "  bullet.sweep { x = still and x - 5 or nil, y = still and y - 7 or nil, dx = still and 5 or 0, dy = still and 7 "
    "or nil,\n"
    "    follow = not still and lead or nil, radius = lo, radius_to = hi, over = over, tag = tag or nil, hurt = n }\n"
    "  local left, hit = {}, {}\n"
    "  bullet.each(nil, function(b) if not tag or b.tag == tag then left[b] = { b.x, b.y } end end)\n"
    "  for k = 1, over do\n"
    "    local r = lo + (hi - lo) * k / over\n"
    "    print(taken)\n"
    "    wait(1)\n"
    "    for b, at in pairs(left) do\n"
    "      local inside = square(at[1] - x) + square(at[2] - y) <= square(r)\n"
    "      if inside == b.alive then error('sweep') end\n"
    "      if inside then left[b] = nil taken = taken + 1 end\n"
    "    end\n"
    "    enemy.each(nil, function(e)\n"
    "      if square(e.x - x) + square(e.y - y) <= square(r) then hit[e] = true end\n"
    "      if e.hp ~= (hit[e] and 1000 - n or 1000) then error('hurt ' .. e.hp) end\n"
    "    end)\n"
    "    x, y = x + vx, y + vy\n"
    "    lead.x, lead.y = x, y\n"
    "  end\n"
    "  lead:remove()\n"
    "end end)\n";

TEST(sweeps)
{
    run_shapes(sweeps_script, rig_long() ? 20000 : 1000);
}

RUN_TESTS(NULL, NULL)
