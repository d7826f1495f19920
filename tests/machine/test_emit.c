/*
 * test_emit.c - what motion programs fire, wait for and follow: the steps emit, wait_for and path. An emit fires what
 * the pattern in Lua with the same arguments fires, a path leads where it leads an enemy, both to the bit.
 */
#include "rig.h"

static struct rig_game g;
static struct rig rig;

#define KINDS                                                                                                          \
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })\n"                                                    \
    "bullet.def('seed', { sprite = 'dot', hit = { circle = 3 }, bank = 6, cloud = 'wink' })\n"                         \
    "shot.def('bolt', { sprite = 'dot', hit = { circle = 3 }, bank = 3 })\n"                                           \
    "enemy.def('foe', { sprite = 'wink', hit = { box = { 9, 9 } }, hp = 50 })\n"                                       \
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"                                                   \
    "value.def('power') value.def('heat') value.def('power', { of = 'shot' })\n"                                       \
    "local function dot(t) t.kind, t.speed = t.kind or 'dot', t.speed or 1\n"                                          \
    "  t.motion = t.motion and motion.def(t.motion) return bullet.fire(t) end\n"                                       \
    "local function is(a, b) if a ~= b and not (type(a) == 'number' and math.abs(a - b) < 1e-6) then\n"                \
    "  error(('%s, expected %s'):format(a, b), 2) end end\n"

static struct manifest manifest(void)
{
    struct manifest m = rig_manifest();

    m.motions = 2000;
    m.lua_kib = 4096;
    m.has_orbit = m.has_freeze = 1;
    m.bullet_values = 2;
    m.shot_values = 1;
    return m;
}

/* Its asserts are the test. */
static void power(const char *text)
{
    struct manifest m = manifest();

    rig_with_sys(&g, &m, text);
    rig_power(&rig, &g, NULL);
}

static void end(void)
{
    rig_free(&rig);
    rig_game_free(&g);
}

static void holds(const char *text, int frames)
{
    power(text);
    rig_run(&rig, frames);
    end();
}

/* Twins in the same frame: one runs an emit, a task fires the pattern from the other. A frame later each has moved
 * once. */
TEST(patterns)
{
    holds(KINDS
          "local own = { one = {}, ring = {}, fan = 'spread', arc = 'sweep', stack = 'speed_to', line = 'width' }\n"
          "local names = { 'one', 'ring', 'fan', 'arc', 'stack', 'line' }\n"
          "motion.def { name = 'plain', { turn = 3, over = 5 } } motion.def { name = 'fine', fine = true }\n"
          "local function number(most) return rng.chance(0.3) and rng.int(-most, most) or rng.number(-most, most) end\n"
          "local function all(tag) local list = {}\n"
          "  bullet.each(tag, function(b) list[#list + 1] = { b.x, b.y, b.dir, b.speed, b.vx, b.vy, b.kind, b.bank,\n"
          "    b.motion or 0, b.delay, b.power, b.heat, b.around or 0 } end) return list end\n"
          "local seen = {}\n"
          "task.go(function() string.sys.join(1, 'ship')\n"
          "  for run = 1, 700 do\n"
          "    player.get(1).x, player.get(1).y = rng.int(9, 200), rng.int(9, 200)\n"
          "    local name = rng.pick(names) local word = own[name]\n"
          "    local a = { pattern = name, kind = rng.pick { 'dot', 'seed' }, speed = number(5) }\n"
          "    if name ~= 'one' then a.n = rng.int(0, 9) end\n"
          "    if type(word) == 'string' then a[word] = number(word == 'speed_to' and 6 or 300) end\n"
          "    if rng.chance(0.5) then a.dir = number(700) end\n"
          "    if rng.chance(0.4) then a.aim = true end\n"
          "    if rng.chance(0.3) then a.skip = { rng.int(-2, 4), rng.int(5, 7) } end\n"
          "    if rng.chance(0.3) then a.bank = rng.int(0, 15) end\n"
          "    if rng.chance(0.2) then a.delay = rng.int(0, 5) end\n"
          "    if rng.chance(0.4) then a.motion = rng.pick { 'plain', 'fine' } end\n"
          "    if rng.chance(0.4) then a.power = number(900) end\n"
          "    if rng.chance(0.2) then a.around = player.get(1) end\n"
          "    local at = { x = rng.number(0, 200), y = rng.number(-20, 200), speed = number(3), dir = number(360) }\n"
          "    if rng.chance(0.1) then at.x = rng.pick { 270, -60 } end\n"
          "    local e = {} for k, v in pairs(a) do e[k] = v end e.tag = 'e'\n"
          "    local em = dot { x = at.x, y = at.y, speed = at.speed, dir = at.dir,\n"
          "      motion = { fine = rng.chance(0.2), { wait = 1 }, { emit = e }, { die = true } } }\n"
          "    wait(1)\n"
          "    a.from, a.tag, a.pattern, a.dir = em, 'l', nil, a.dir or not a.aim and em.dir or nil\n"
          "    a.each = name ~= 'one' and function(t) bullet.fire(t) end or nil\n"
          "    if name ~= 'one' then pattern[name](a)\n"
          "    elseif not a.skip or a.skip[1] > 1 then a.skip = nil bullet.fire(a) end\n"
          "    wait(1) local lua = all('l') wait(1) local mine = all('e') is(#mine, #lua)\n"
          "    seen[name] = (seen[name] or 0) + #lua\n"
          "    for i, b in ipairs(lua) do for k, v in ipairs(b) do if mine[i][k] ~= v then\n"
          "      error(('%d %s: bullet %d: %d: %s, expected %s'):format(run, name, i, k, mine[i][k], v)) end end end\n"
          "    bullet.group():remove()\n"
          "  end\n"
          "  for _, name in ipairs(names) do assert(seen[name] > 50) end\n"
          "  board.note(1) print('done')\n"
          "end)\n",
          2200);
}

/* A pattern as one call fires what its loop does, which `each` asks for: of bullets and shots, of fine ones, from
 * places at the edge of the world, into a full pool, aimed, skipped, from what is gone. */
TEST(volleys)
{
    holds(KINDS
          "local own = { ring = {}, fan = 'spread', arc = 'sweep', stack = 'speed_to', line = 'width' }\n"
          "local names = { 'ring', 'fan', 'arc', 'stack', 'line' }\n"
          "motion.def { name = 'plain', { turn = 3, over = 5 } } motion.def { name = 'fine', fine = true }\n"
          "local function number(most)\n"
          "  if rng.chance(0.1) then return rng.pick { 0, -0.0, most, -most, 1e-9, 0.1 } end\n"
          "  return rng.chance(0.3) and rng.int(-most, most) or rng.number(-most, most) end\n"
          "local function all(from, tag) local list = {}\n"
          "  from.each(tag, function(b) list[#list + 1] = { b.x, b.y, b.dir, b.speed, b.vx, b.vy, b.kind, b.bank,\n"
          "    b.motion or 0, from == bullet and b.delay or 0, b.power, from == bullet and b.heat or 0,\n"
          "    b.around or 0, b.age } end) return list end\n"
          "local seen, full = {}, 0\n"
          "task.go(function() string.sys.join(1, 'ship')\n"
          "  local foe = enemy.spawn { kind = 'foe', x = 100, y = 30 }\n"
          "  local dead = dot { x = 9, y = 9 } dead:remove()\n"
          "  for run = 1, 1500 do\n"
          "    player.get(1).x, player.get(1).y = rng.int(9, 200), rng.int(9, 200)\n"
          "    foe.x, foe.y = rng.int(-60, 300), rng.int(-40, 200)\n"
          "    local name, shots = rng.pick(names), rng.chance(0.3) local word = own[name]\n"
          "    local from = shots and shot or bullet\n"
          "    local a = { fire = shots and 'shot' or rng.chance(0.5) and 'bullet' or nil, n = rng.int(0, 9),\n"
          "      kind = shots and 'bolt' or rng.pick { 'dot', 'seed' }, speed = number(rng.pick { 5, 8191 }) }\n"
          "    if rng.chance(0.05) then a.n = 4500 end\n"
          "    if type(word) == 'string' then a[word] = number(word == 'speed_to' and 6 or 300) end\n"
          "    if rng.chance(0.5) then a.dir = number(rng.pick { 700, 1e9 }) end\n"
          "    if rng.chance(0.4) then a.aim = true end\n"
          "    if rng.chance(0.3) then a.skip = { rng.int(-2, 4), rng.int(5, 7) } end\n"
          "    if rng.chance(0.3) then a.bank = rng.int(0, 15) end\n"
          "    if rng.chance(0.2) and not shots then a.delay = rng.int(0, 5) end\n"
          "    if rng.chance(0.2) and shots then a.by = player.get(1) end\n"
          "    if rng.chance(0.4) then a.motion = rng.pick { 'plain', 'fine' } end\n"
          "    if rng.chance(0.4) then a.power = number(900) end\n"
          "    if rng.chance(0.2) then a.around = player.get(1) end\n"
          "    if rng.chance(0.5) then a.from = rng.chance(0.1) and dead or rng.chance(0.5) and foe or player.get(1)\n"
          "    else a.x, a.y = rng.number(0, 200), rng.number(-20, 200) end\n"
          "    if rng.chance(0.3) then a.dx = number(rng.chance(0.1) and 16000 or 50) end\n"
          "    if rng.chance(0.3) then a.dy = number(rng.chance(0.1) and 16000 or 50) end\n"
          "    local pool = shots and 'shots' or 'bullets'\n"
          "    local before = board.refused(pool)\n"
          "    a.tag = 'l' pattern[name](a)\n"
          "    local mine, lost = all(from, 'l'), board.refused(pool) - before\n"
          "    from.group():remove()\n"
          "    a.each = function(t) from.fire(t) end pattern[name](a)\n"
          "    local lua = all(from, 'l') is(#mine, #lua) is(board.refused(pool) - before, 2 * lost)\n"
          "    if lost > 0 then full = full + 1 end\n"
          "    seen[name] = (seen[name] or 0) + #lua\n"
          "    for i, b in ipairs(lua) do for k, v in ipairs(b) do if mine[i][k] ~= v then\n"
          "      error(('%d %s: bullet %d: %d: %s, expected %s'):format(run, name, i, k, mine[i][k], v)) end end end\n"
          "    from.group():remove()\n"
          "    if run % 4 == 0 then wait(1) end\n"
          "  end\n"
          "  for _, name in ipairs(names) do assert(seen[name] > 500, name) end\n"
          "  assert(full > 10, full)\n"
          "  board.note(1) print('done')\n"
          "end)\n",
          400);
}

/* Both say the same of what is wrong; but a place is missing where the bullets are fired: with `each`, by that. */
TEST(volley_errors)
{
    static const char *const wrong[][2] = {
        { "pattern.line { kind = 'dot', speed = 1, n = 3, width = 90, x = 16380, y = 1",
          "main.lua:12: bullet.fire: x: expected a number from -16383 to 16383 px, got 16425.0" },
        { "pattern.ring { kind = 'dot', speed = 1, n = 3, x = 1",
          "main.lua:12: pattern.ring: place: expected either `x` and `y`, or `from`" },
        { "pattern.fan { kind = 'dot', sped = 1, n = 3, spread = 9, x = 1, y = 2",
          "main.lua:12: pattern.fan: unknown argument \"sped\" (did you mean \"speed\"?)" },
        { "pattern.arc { kind = 'dot', speed = 1, n = -1, sweep = 9, x = 1, y = 2",
          "main.lua:12: pattern.arc: n: expected a whole number from 0 to 65535 bullets, got -1" },
    };

    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        for (int each = 0; each < 2; each++) {
            struct manifest m = manifest();
            char text[3000];
            snprintf(text, sizeof text, "%s\n%s%s }", KINDS, wrong[i][0],
                     each ? ", each = function(t) bullet.fire(t) end" : "");
            rig_with_sys(&g, &m, text);
            rig_power_any(&rig, &g, NULL);
            assert_non_null(rig_fault(&rig));
            const bool own = each && strstr(wrong[i][1], "place:");
            assert_string_equal(rig_fault(&rig)->message,
                                own ? "main.lua:12: bullet.fire: place: expected either `x` and `y`, or `from`"
                                    : wrong[i][1]);
            end();
        }
}

/* ---- the queue ---- */

TEST(order)
{
    /* in slot order, though the slots were given from above and the emitters go; across blocks */
    holds(KINDS
          "task.go(function()\n"
          "  local list = {} for i = 1, 140 do list[i] = dot { x = i, y = 50, speed = 0 } end\n"
          "  for _, i in ipairs { 130, 3, 70, 1 } do list[i].motion = motion.def { { emit = { pattern = 'arc', n = 2,\n"
          "    sweep = 20, dir = 0, kind = 'dot', speed = 0, tag = 'e' } }, { die = true } } end\n"
          "  wait(1) local x = {} bullet.each('e', function(b) x[#x + 1] = ('%.0f %.0f'):format(b.x, b.dir) end)\n"
          "  is(table.concat(x, ','), '1 0,1 20,3 0,3 20,70 0,70 20,130 0,130 20') is(#x, 8)\n"
          "end)\n",
          3);
    /* several with no time between: each from the direction of its moment; it flies on with the last */
    holds(
        KINDS
        "task.go(function()\n"
        "  local b = dot { x = 50, y = 50, dir = 0, motion = { { loop = 3, { emit = { kind = 'dot', speed = 2, tag =\n"
        "    'e' } }, { turn = 90 } }, { emit = { kind = 'dot', speed = 3, tag = 'e' } } } }\n"
        "  wait(1) local n = 0\n"
        "  bullet.each('e', function(c) is(c.dir, 90 * n) is(c.x, 50) is(c.y, 50) is(c.age, 0) n = n + 1 end)\n"
        "  is(n, 4) is(b.dir, 270) is(b.y, 49)\n"
        "  wait(1) is(bullet.group('e').count, 4) bullet.each('e', function(c) is(c.age, 1) end)\n"
        "end)\n",
        3);
    /* what is fired has programs that fire; one in a frame, so it ends */
    holds(KINDS
          "motion.def { name = 'c', { emit = { kind = 'dot', speed = 1, tag = 'c' } } }\n"
          "motion.def { name = 'b', { emit = { kind = 'dot', speed = 1, tag = 'b', motion = 'c' } }, { die = true } }\n"
          "task.go(function()\n"
          "  dot { x = 50, y = 50, tag = 'a', motion = { { emit = { pattern = 'ring', n = 3, kind = 'dot', speed = 0,\n"
          "    tag = 'a', motion = 'b' } }, { die = true } } }\n"
          "  local function n(a, b, c) wait(1) is(bullet.group('a').count, a) is(bullet.group('b').count, b)\n"
          "    is(bullet.group('c').count, c) end\n"
          "  n(3, 0, 0) n(0, 3, 0) n(0, 3, 3) n(0, 3, 3)\n"
          "end)\n",
          8);
    /* shots fire shots for their player, and bullets; a delay begins a frame later than the bullet */
    holds(
        KINDS
        "task.go(function()\n"
        "  string.sys.join(1, 'ship') local p = player.get(1)\n"
        "  shot.fire { kind = 'bolt', from = p, speed = 1, power = 7, tag = 's', motion = motion.def {\n"
        "    { emit = { fire = 'shot', pattern = 'fan', n = 3, spread = 20, kind = 'bolt', speed = 2, power = "
        "'power',\n"
        "      tag = 'new' } }, { emit = { kind = 'seed', speed = 1, delay = 2, power = 'power', heat = 5, tag = 'e' } "
        "},\n"
        "    { die = true } } }\n"
        "  wait(1) is(shot.group().count, 3) is(shot.group('s').count, 0)\n"
        "  shot.each('new', function(s) is(s.by, p) is(s.power, 7) is(s.bank, 3) end)\n"
        "  bullet.each('e', function(b) is(b.power, 7) is(b.heat, 5) is(b.delay, 2) is(b.dir, 270) is(b.bank, 6) end)\n"
        "  is(bullet.group('e').count, 1) local y\n"
        "  bullet.each('e', function(b) y = b.y end) wait(2)\n"
        "  bullet.each('e', function(b) is(b.delay, 0) is(b.y, y) end) wait(1)\n"
        "  bullet.each('e', function(b) is(b.y, y - 1) is(b.age, 1) end)\n"
        "end)\n",
        8);
}

/* Names of values: read when it fires; cut, bounded. */
TEST(names)
{
    holds(
        KINDS
        "task.go(function()\n"
        "  local m = { { emit = { pattern = 'ring', n = 'power', dir = 'heat', speed = 'heat', bank = 'power', delay "
        "=\n"
        "    'power', kind = 'dot', power = 'heat', tag = 'e' } } }\n"
        "  local function fire(power, heat) dot { x = 50, y = 50, dir = 9, power = power, heat = heat, motion = m }\n"
        "    wait(1) local list = {} bullet.each('e', function(b) list[#list + 1] = b end) return list end\n"
        "  local e = fire(3.9, 1.25) is(#e, 3) is(e[1].dir, 1.25) is(e[2].bank, 3) is(e[3].delay, 3)\n"
        "  is(e[1].speed, 1.25) is(e[1].power, 1.25) is(e[1].heat, 0) bullet.group():remove()\n"
        "  is(#fire(-4, 2), 0) bullet.group():remove()\n"
        "  e = fire(1, -32768) is(e[1].dir, 352) bullet.group():remove() e = fire(1, -30000) is(e[1].speed, -8191) "
        "is(e[1].power, -30000) bullet.group():remove()\n"
        "  for word, of in pairs { spread = 'fan', sweep = 'arc', speed_to = 'stack', width = 'line' } do\n"
        "    dot { x = 50, y = 50, power = 40, motion = { { emit = { pattern = of, n = 3, [word] = 'power', kind = "
        "'dot',\n"
        "      speed = 2, dir = 0, tag = 'e' } } } }\n"
        "    local at = { x = 50, y = 50, kind = 'dot', n = 3, [word] = 40, speed = 2, dir = 0, tag = 'l' }\n"
        "    wait(1) pattern[of](at) wait(1) local want = {}\n"
        "    bullet.each('l', function(b) want[#want + 1] = b end) is(#want, 3) local i = 0\n"
        "    bullet.each('e', function(b) i = i + 1 is(b.x, want[i].x) is(b.y, want[i].y) is(b.speed, want[i].speed)\n"
        "      end) is(i, 3) bullet.group():remove()\n"
        "  end\n"
        "end)\n",
        20);
    /* of nothing declared for shots: 0 */
    holds(KINDS "task.go(function()\n"
                "  shot.fire { kind = 'bolt', x = 50, y = 50, speed = 0, power = 2, motion = motion.def { { emit = { "
                "pattern = 'fan',\n"
                "    n = 'power', spread = 90, speed = 'heat', kind = 'dot', tag = 'e' } } } }\n"
                "  wait(1) is(bullet.group('e').count, 2) bullet.each('e', function(b) is(b.speed, 0) end)\n"
                "end)\n",
          3);
}

/* A full pool: all that finds no room is counted, one by one, and the log says it once. */
TEST(full)
{
    const uint16_t none[MAX_PLAYERS] = { 0 };
    int lines = 0;

    power(KINDS
          "task.go(function()\n"
          "  dot { x = 50, y = 50, speed = 0, motion = { { loop = 300, { emit = { pattern = 'ring', n = 1000, skip = { "
          "1,\n"
          "    998 }, kind = 'dot', speed = 1 } } }, { emit = { pattern = 'ring', n = 0, kind = 'dot', speed = 1 } },\n"
          "    { emit = { fire = 'shot', kind = 'bolt', speed = 1 } } } }\n"
          "  wait(1) is(board.live 'bullets', 256) is(board.refused 'bullets', 600 - 255) is(board.live 'shots', 1)\n"
          "  bullet.group():remove() is(board.refused 'shots', 0)\n"
          "  for i = 1, 200 do dot { x = 50, y = 50, motion = { { emit = { pattern = 'stack', n = 3, speed_to = 2, "
          "kind =\n"
          "    'dot', speed = 1 } }, { die = true } } } end\n"
          "  wait(1) is(board.live 'bullets', 256) is(board.refused 'bullets', 345 + 600 - 256)\n"
          "  bullet.group():remove() for i = 1, 256 do dot { x = 50, y = 50, motion = { { emit = { kind = 'dot', speed "
          "=\n"
          "    1 } }, { die = true } } } end\n"
          "  wait(1) is(board.live 'bullets', 256) is(board.refused 'bullets', 345 + 600 - 256)\n"
          "end)\n");
    for (int f = 0; f < 6; f++) {
        const struct board_out *out = board_tick(rig.b, none);
        rig_sound(&rig);
        lines += out->full_pool_count;
        rig_spoil(&rig); /* a restored board finds its queue */
    }
    assert_int_equal(lines, 1);
    end();
}

/* A board that fires much of what it has room for, without and with a restore in each frame: the same hashes. */
TEST(restore)
{
    static const char text[] = KINDS "motion.def { name = 'split', { wait = 4 }, { emit = { pattern = 'ring', n = 3, "
                                     "kind = 'dot', speed = 1, aim = true } } }\n"
                                     "local m = motion.def { { loop = forever, { wait = 3 }, { emit = { pattern = "
                                     "'fan', n = 2, spread = 40, kind = 'dot',\n"
                                     "  speed = 2, motion = 'split' } } } }\n"
                                     "task.go(function() for i = 1, 90 do bullet.fire { kind = 'dot', x = 2 * i, y = "
                                     "i, speed = 0.5, dir = i, motion = m }\n"
                                     "  end end)\n";
    static uint64_t hashes[60];

    for (int pass = 0; pass < 2; pass++) {
        power(text);
        for (int f = 0; f < 60; f++) {
            rig_run(&rig, 1);
            if (pass)
                rig_spoil(&rig);
            const uint64_t now = board_hash(rig.b);
            if (pass && now != hashes[f])
                fail_msg("frame %d: another hash after a restore", f);
            hashes[f] = now;
        }
        end();
    }
}

/* ---- wait_for ---- */

TEST(waits)
{
    /* x and y, either way; on the line itself; at once where it begins there; a jump over it */
    holds(KINDS "local function at(t, w) t.motion = { { wait_for = w }, { bank = 7 } } return dot(t) end\n"
                "task.go(function()\n"
                "  local a = at({ x = 10, y = 50, dir = 0, speed = 3 }, { x = 16 })\n"
                "  local b = at({ x = 22, y = 50, dir = 180, speed = 4 }, { x = 16 })\n"
                "  local c = at({ x = 50, y = 16, dir = 90 }, { y = 16 })\n"
                "  local d = at({ x = 50, y = 20, dir = 270 }, { y = 16.5 })\n"
                "  local e = at({ x = 50, y = 20, dir = 0 }, { y = 16 })\n"
                "  local f = at({ x = 10, y = 20, dir = 0 }, { x = 200 })\n"
                "  wait(1) is(c.bank, 7) is(a.bank, 0) is(a.x, 13) wait(1) is(a.x, 16) is(a.bank, 0) is(b.x, 14) "
                "is(b.bank, 0)\n"
                "  wait(1) is(a.bank, 7) is(b.bank, 7) is(d.bank, 0) f.x = 300 wait(1) is(f.bank, 7) is(d.y, 16) "
                "is(d.bank, 0)\n"
                "  wait(1) is(d.bank, 7) is(e.bank, 0)\n"
                "end)\n",
          8);
    /* near: nearer than so many px from where it is, exactly; of a shot, an enemy */
    holds(KINDS "task.go(function()\n"
                "  string.sys.join(1, 'ship') player.get(1).x, player.get(1).y = 100, 100\n"
                "  local a = dot { x = 97, y = 92, dir = 90, motion = { { wait_for = { near = 5 } }, { bank = 7 } } }\n"
                "  wait(5) is(a.y, 97) is(a.bank, 0)\n"
                "  local e = enemy.spawn { kind = 'foe', x = 60, y = 60 }\n"
                "  local s = shot.fire { kind = 'bolt', x = 60, y = 80, dir = 270, speed = 2, motion = motion.def { { "
                "wait_for = {\n"
                "    near = 12 } }, { bank = 7 } } }\n"
                "  wait(1) is(a.bank, 7) wait(3) is(s.y, 72) is(s.bank, 3) wait(1) is(s.y, 70) is(s.bank, 3) wait(1) "
                "is(s.bank, 7)\n"
                "end)\n",
          12);
    holds(
        KINDS
        "task.go(function() local a = dot { x = 97, y = 92, motion = { { wait_for = { near = 5 } }, { bank = 7 } } }\n"
        "  wait(9) is(a.bank, 0) end)\n",
        12);
    /* a limit, with and without what comes; names; a group's write of the place */
    holds(
        KINDS
        "task.go(function()\n"
        "  local a = dot { x = 10, y = 50, dir = 0, motion = { { wait_for = { x = 99, limit = 4 } }, { bank = 7 } } }\n"
        "  local b = dot { x = 10, y = 50, dir = 0, motion = { { wait_for = { tag = 'go', limit = 4 } }, { bank = 7 } "
        "} }\n"
        "  local c = dot { x = 10, y = 50, dir = 0, power = 13, heat = 9, motion = { { wait_for = { x = 'power' } }, { "
        "bank = 7\n"
        "    }, { wait_for = { near = 'power', limit = 'heat' } }, { bank = 8 } } }\n"
        "  wait(1) c.power = 12 wait(3) is(a.bank, 0) is(b.bank, 0) is(c.x, 14) c.power = 99\n"
        "  wait(1) is(a.bank, 7) is(b.bank, 7) wait(7) is(c.bank, 7) wait(1) is(c.bank, 8)\n"
        "end)\n",
        20);
    /* in loops; fine */
    holds(
        KINDS
        "task.go(function()\n"
        "  local a = dot { x = 10, y = 50, dir = 0, speed = 0.25, motion = { fine = true, { wait_for = { x = 11 } },\n"
        "    { speed = 2 } } }\n"
        "  wait(4) is(a.speed, 0.25) wait(1) is(a.x, 13) is(a.speed, 2)\n"
        "end)\n",
        8);
}

TEST(signals)
{
    /* one before the step began is nothing; then the tag's alone; any; each round anew */
    holds(KINDS "local m = { { wait = 2 }, { loop = 2, { wait_for = { tag = 'go' } }, { turn = 10 } } }\n"
                "task.go(function()\n"
                "  local a, s = dot { x = 10, y = 50, dir = 0, motion = m }, nil\n"
                "  s = shot.fire { kind = 'bolt', x = 10, y = 50, dir = 0, speed = 1, motion = a.motion }\n"
                "  local go = bullet.group('go')\n"
                "  go:signal() wait(1) go:signal() wait(1) go:signal() wait(1) is(a.dir, 0)\n"
                "  bullet.group('other'):signal() shot.group('go'):signal() wait(1) is(a.dir, 0) is(s.dir, 10)\n"
                "  go:signal() is(a.dir, 0) wait(1) is(a.dir, 10) wait(40) is(a.dir, 10) is(a.x < 60, true)\n"
                "  bullet.group():signal() wait(1) is(a.dir, 20) is(a.motion, nil) is(s.dir, 10)\n"
                "end)\n",
          60);
    /* one that stands hears it, and goes on when it may; a delayed one has not begun; the limit is off after it */
    holds(KINDS
          "local m = { { wait_for = { tag = 'go', limit = 9 } }, { bank = 7 }, { wait = 20 }, { bank = 8 } }\n"
          "task.go(function()\n"
          "  local a, b = dot { x = 10, y = 50, motion = m }, dot { x = 10, y = 50, delay = 5, motion = m }\n"
          "  wait(1) a.frozen = 3 wait(1) bullet.group('go'):signal() wait(1) is(a.bank, 0)\n"
          "  wait(1) is(a.bank, 0) wait(1) is(a.bank, 7) wait(3) is(b.bank, 0) wait(7) is(a.bank, 7) is(b.bank, 7)\n"
          "  wait(9) is(a.bank, 7) wait(1) is(a.bank, 8)\n"
          "end)\n",
          40);
    /* another program in the same frame does not hear it */
    holds(KINDS "task.go(function()\n"
                "  local a = dot { x = 10, y = 50, motion = { { wait_for = { tag = 'go' } }, { bank = 7 } } }\n"
                "  bullet.group('go'):signal() wait(2) is(a.bank, 0)\n"
                "  bullet.group('go'):signal() a.motion = a.motion wait(2) is(a.bank, 0)\n"
                "  bullet.group('go'):signal() wait(1) is(a.bank, 7) bullet.group('go'):signal() wait(1)\n"
                "end)\n",
          9);
}

/* ---- path ---- */

/* Random routes: where it begins at the route's start, it is where the enemy is, in every frame. */
TEST(paths)
{
    static char text[8192];

    for (int seed = 1; seed <= 12; seed++) {
        snprintf(text, sizeof text,
                 "%slocal rnd = %d local function r(n) rnd = (rnd * 1103515245 + 12345) %% 2147483648 return rnd "
                 "// 65536 %% n end\n"
                 "local routes = {}\n"
                 "for k = 1, 12 do local p = { { x = r(9000) / 37, y = r(9000) / 41 } }\n"
                 "  for i = 2, 2 + r(5) do p[i] = r(4) == 0 and { wait = r(6) } or { x = r(9000) / 37, y = "
                 "r(9000) / 43, over = 1 + r(20),\n"
                 "    ease = ({ 'linear', 'in', 'out', 'both' })[1 + r(4)] } end\n"
                 "  p[#p + 1] = { x = 100, y = 20 + r(90), over = 30 } routes[k] = path.def(p) end\n"
                 "for k, route in ipairs(routes) do task.go(function()\n"
                 "  local mirror = k %% 3 == 0\n"
                 "  local e = enemy.spawn { kind = 'foe', x = 5, y = 5 }\n"
                 "  local t = task.go(path.run, e, route, mirror) local ended\n"
                 "  local sx, sy = path.place(route[1], mirror, 0, 0) local b = dot { x = sx, y = sy, motion = { { "
                 "path = route, mirror = mirror, bank = 4 }, { "
                 "bank = 5 } } }\n"
                 "  local x, y = b.x + 7.25, b.y - 3\n"
                 "  local c = dot { x = x, y = y, motion = { { path = route, mirror = mirror } } }\n"
                 "  for f = 1, 200 do wait(1)\n"
                 "    if not task.alive(t) then break end\n"
                 "    is(b.x, e.x) is(b.y, e.y) is(b.bank, 4)\n"
                 "    assert(math.abs(c.x - b.x - 7.25) < 3e-5 and math.abs(c.y - b.y + 3) < 3e-5)\n"
                 "  end\n"
                 "  is(task.alive(t), false) local vx, vy = b.vx, b.vy wait(1) is(b.bank, 5) is(b.vx, vx) "
                 "is(b.vy, vy) ended = true\n"
                 "  if e.alive then board.note(1) end\n"
                 "end) end\n",
                 KINDS, seed * 77);
        holds(text, 230);
    }
    /* a script's write moves the rest of the route; at the world's edge; waits stand */
    holds(KINDS "local route = path.def { { x = 0, y = 0 }, { x = 10, y = 0, over = 5 }, { wait = 3 }, { x = 10, y = "
                "20, over = 10 } }\n"
                "task.go(function()\n"
                "  local a = dot { x = 50, y = 60, dir = 45, motion = { { path = route } } }\n"
                "  wait(2) is(a.x, 54) is(a.dir, 0) wait(3) is(a.x, 60) wait(2) is(a.x, 60) is(a.speed, 0) a.x = 90\n"
                "  wait(2) is(a.x, 90) is(a.y, 62) wait(9) is(a.y, 80) is(a.motion ~= nil, true) wait(1) is(a.y, 82)\n"
                "  local b = dot { x = 100, y = 60, motion = { { path = route, mirror = true } } }\n"
                "  wait(5) is(b.x, 90)\n"
                "end)\n",
          30);
}

/* ---- what is refused ---- */

static void refused(const char *steps, const char *message)
{
    static char text[2048];
    struct manifest m = rig_manifest();

    snprintf(text, sizeof text,
             "bullet.def('dot', { sprite = 'dot', hit = 'none' }) shot.def('bolt', { sprite = 'dot', hit = 'none' })\n"
             "value.def('heat') local route, point = path.def { { x = 1, y = 1 }, { x = 2, y = 2, over = 3 } }, "
             "path.def { { x = 1,\n"
             "y = 1 } } motion.def { %s }",
             steps);
    m.bullet_values = 1;
    m.has_orbit = 1;
    rig_script(&g, &m, text);
    rig_power_any(&rig, &g, NULL);
    if (!rig_fault(&rig))
        fail_msg("%s: no fault", steps);
    char said[sizeof rig_fault(&rig)->message + 1]; /* with an end to look for */
    snprintf(said, sizeof said, "%s\n", rig_fault(&rig)->message);
    if (!strstr(said, message))
        fail_msg("%s: expected \"%s\", got \"%s\"", steps, message, rig_fault(&rig)->message);
    end();
}

TEST(errors)
{
    refused("{ emit = 3 }", "step 1: emit: expected a table");
    refused("{ emit = {} }", "step 1: emit: kind: expected a name, got nil");
    refused("{ emit = { 'dot' } }", "step 1: emit: expected named arguments");
    refused("{ emit = { kind = 'dot' } }",
            "step 1: emit: speed: expected a number from -8191 to 8191 px/frame, got nil");
    refused("{ emit = { kind = 'dit', speed = 1 } }", "unknown bullet kind \"dit\" (did you mean \"dot\"?)");
    refused("{ wait = 1 }, { emit = { kind = 'bolt', speed = 1 } }", "step 2: emit: unknown bullet kind \"bolt\"");
    refused("{ emit = { kind = 'dot', fire = 'shot', speed = 1 } }", "unknown shot kind \"dot\"");
    refused("{ emit = { kind = 'dot', fire = 'gun', speed = 1 } }", "fire: expected bullet or shot, got \"gun\"");
    refused("{ emit = { kind = 'dot', speed = 1, pattern = 'rings', n = 3 } }",
            "pattern: expected one, ring, fan, arc, stack or line, got \"rings\"");
    refused("{ emit = { kind = 'dot', speed = 1, n = 3 } }",
            "`n` does not apply to pattern \"one\" (did you forget `pattern`?)");
    refused("{ emit = { kind = 'dot', speed = 1, pattern = 'ring' } }", "step 1: emit: pattern \"ring\" requires `n`");
    refused("{ emit = { kind = 'dot', speed = 1, pattern = 'fan', n = 3 } }",
            "step 1: emit: pattern \"fan\" requires `spread`");
    refused("{ emit = { kind = 'dot', speed = 1, pattern = 'arc', n = 3, spread = 4 } }",
            "`spread` does not apply to pattern \"arc\"");
    refused("{ emit = { kind = 'dot', speed = 1, pattern = 'ring', n = -1 } }",
            "step 1: emit: n: expected a whole number from 0 to 65535 bullets, got -1");
    refused("{ emit = { kind = 'dot', speed = 'heap' } }", "unknown value \"heap\" (did you mean \"heat\"?)");
    refused("{ emit = { kind = 'dot', speed = 1, x = 3 } }", "step 1: emit: `x` is not allowed");
    refused("{ emit = { kind = 'dot', speed = 1, each = print } }", "`each` is not allowed");
    refused("{ emit = { kind = 'dot', speed = 1, colour = 3 } }", "step 1: emit: unknown argument \"colour\"");
    refused("{ emit = { kind = 'dot', speed = 1, het = 3 } }", "unknown argument \"het\" (did you mean \"heat\"?)");
    refused("{ emit = { kind = 'dot', speed = 1, motion = 'none' } }", "unknown motion \"none\"");
    refused("{ emit = { kind = 'bolt', fire = 'shot', speed = 1, delay = 3 } }", "`delay` does not apply to shots");
    refused("{ emit = { kind = 'dot', speed = 1 }, turn = 3 }", "`turn` cannot be combined with `emit`");
    refused("{ loop = forever, { emit = { kind = 'dot', speed = 1 } } }",
            "with `loop = forever`, at least one step must take time");
    refused("{ wait_for = 3 }", "step 1: wait_for: expected a table");
    refused("{ wait_for = {} }", "wait_for: expected one of `x`, `y`, `near` and `tag`, got 0");
    refused("{ wait_for = { x = 1, tag = 'a' } }", "wait_for: expected one of `x`, `y`, `near` and `tag`, got 2");
    refused("{ wait_for = { near = -1 } }", "step 1: wait_for: near: expected a number from 0 to 16383 px, got -1");
    refused("{ wait_for = { z = 1 } }", "wait_for: unknown argument \"z\"");
    refused("{ wait_for = { x = 1, limits = 3 } }", "unknown argument \"limits\" (did you mean \"limit\"?)");
    refused("{ wait_for = { x = 1, limit = 0 } }",
            "limit: expected forever or a whole number from 1 to 1000000000 frames");
    refused("{ wait_for = { x = 1 }, bank = 3 }", "`bank` cannot be combined with `wait_for`");
    refused("{ loop = forever, { wait_for = { x = 1 } } }",
            "step 1: infinite loop: with `loop = forever`, at least one step must take time (`wait_for` takes no time "
            "if its condition "
            "already holds: add { wait = 1 })");
    refused("{ loop = forever, { loop = 3, { orbit = 50, over = 15 }, { turn = 3 } } }",
            "step 1: infinite loop: with `loop = forever`, at least one step must take time (`orbit` takes no time "
            "once its thing has "
            "despawned: add { wait = 1 })");
    refused("{ loop = 60000, { loop = 60000, { orbit = 50, over = 15 } } }",
            "this loop runs too many steps in one frame; at least one of them must take time (`orbit` takes no time "
            "once its "
            "thing has despawned: add { wait = 1 })");
    refused("{ orbit = 50, over = 15 }, { loop = forever, { turn = 3 } }",
            "step 2: infinite loop: with `loop = forever`, at least one step must take time\n");
    refused("{ path = 3 }", "path: expected a route (from path.def), got 3");
    refused("{ path = {} }", "step 1: path: expected a route (from path.def)");
    refused("{ path = point }", "step 1: path: the route has no length");
    refused("{ path = route, over = 4 }", "`over` cannot be combined with `path`");
    refused("{ turn = 3, mirror = true }", "`mirror` requires `path`");
    refused("fine = true, { path = route }", "`path` cannot be used in a fine motion (this step is always exact)");
}

RUN_TESTS(NULL, NULL)
