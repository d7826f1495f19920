-- What motion programs fire, wait for and follow: the steps emit, wait_for and path.
--board: bullet_values=2 shot_values=1 motions=200 orbit freeze
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })
bullet.def('seed', { sprite = 'dot', hit = { circle = 3 }, bank = 6, cloud = 'wink' })
shot.def('bolt', { sprite = 'dot', hit = { circle = 3 }, bank = 3 })
enemy.def('foe', { sprite = 'wink', hit = { box = { 9, 9 } }, hp = 50 })
player.def('ship', { sprite = 'dot', hit = { circle = 2 } })
value.def('power')
value.def('heat')
value.def('power', { of = 'shot' })
local sys = string.sys
local down = path.def { { x = 0, y = 0 }, { x = 10, y = 0, over = 5 }, { wait = 3 }, { x = 10, y = 20, over = 10 } }
local point = path.def { { x = 1, y = 1 } }
local routes, ended = {}, 0
for k = 1, 30 do
  local points = { { x = rng.number(0, 240), y = rng.number(0, 240) } }
  for i = 2, 2 + rng.int(0, 4) do
    local ease = rng.pick { 'linear', 'in', 'out', 'both' }
    local place = { x = rng.number(0, 240), y = rng.number(0, 200), over = rng.int(1, 20), ease = ease }
    points[i] = rng.chance(0.25) and { wait = rng.int(0, 5) } or place
  end
  points[#points + 1] = { x = 100, y = rng.int(20, 110), over = 30 }
  routes[k] = path.def(points)
end
local function dot(x, y, program, t)
  t = t or {}
  t.kind, t.x, t.y, t.speed, t.motion = 'dot', x, y, t.speed or 1, motion.def(program)
  return bullet.fire(t)
end
local function ship(x, y)
  sys.join(1, 'ship')
  local p = player.get(1)
  p.x, p.y = x, y
  return p
end
-- Prints some properties of each bullet of a tag; nil: of all.
local function list(tag, ...)
  local names, lines = { ... }, {}
  bullet.each(tag, function(b)
    local line = {}
    for i, name in ipairs(names) do line[i] = ('%.7g'):format(b[name]) end
    lines[#lines + 1] = table.concat(line, ' ')
  end)
  print(#lines > 0 and table.concat(lines, ', ') or 'none')
end

--case: emits fire in slot order, whatever the order in which their bullets got programs
local dots = {}
for i = 1, 140 do dots[i] = bullet.fire { kind = 'dot', x = i, y = 50, speed = 0 } end
local two = { pattern = 'arc', n = 2, sweep = 20, dir = 0, kind = 'dot', speed = 0, tag = 'e' }
for _, i in ipairs { 130, 3, 70, 1 } do dots[i].motion = motion.def { { emit = two }, { die = true } } end
wait(1)
list('e', 'x', 'dir')
--> 1 0, 1 20, 3 0, 3 20, 70 0, 70 20, 130 0, 130 20

--case: of several emits in a frame each fires in the direction of its moment
local b = dot(50, 50, {
  { loop = 3, { emit = { kind = 'dot', speed = 2, tag = 'e' } }, { turn = 90 } },
  { emit = { kind = 'dot', speed = 3, tag = 'e' } },
}, { dir = 0 })
wait(1)
list('e', 'x', 'y', 'dir', 'speed', 'age')
print(b.dir, b.y)
wait(1)
list('e', 'age')
--> 50 50 0 2 0, 50 50 90 2 0, 50 50 180 2 0, 50 50 270 3 0
--> 270.0 49.0
--> 1, 1, 1, 1

--case: what is fired may fire, a frame later
motion.def { name = 'c', { emit = { kind = 'dot', speed = 1, tag = 'c' } } }
motion.def { name = 'b', { emit = { kind = 'dot', speed = 1, tag = 'b', motion = 'c' } }, { die = true } }
local ring = { pattern = 'ring', n = 3, kind = 'dot', speed = 0, tag = 'a', motion = 'b' }
dot(50, 50, { { emit = ring }, { die = true } }, { tag = 'a' })
for _ = 1, 4 do
  wait(1)
  print(bullet.group('a').count, bullet.group('b').count, bullet.group('c').count)
end
--> 3 0 0
--> 0 3 0
--> 0 3 3
--> 0 3 3

--case: shots fire shots, for their player, and bullets; a delay starts a frame after the bullet
local p = ship(100, 100)
local fan = { fire = 'shot', pattern = 'fan', n = 3, spread = 20, kind = 'bolt', speed = 2, power = 'power' }
local seed = { kind = 'seed', speed = 1, delay = 2, power = 'power', heat = 5 }
shot.fire {
  kind = 'bolt', from = p, speed = 1, power = 7, tag = 's',
  motion = motion.def { { emit = fan }, { emit = seed }, { die = true } },
}
wait(1)
shot.each(nil, function(s) print(s.by == p, s.power, s.bank) end)
list(nil, 'power', 'heat', 'delay', 'dir', 'bank', 'y')
wait(2)
list(nil, 'delay', 'y')
wait(1)
list(nil, 'age', 'y')
--> true 7.0 3
--> true 7.0 3
--> true 7.0 3
--> 7 5 2 270 6 100
--> 0 100
--> 1 99

--case: an emit reads values when it fires, as whole numbers and within their limits
local ring = {
  pattern = 'ring', kind = 'dot', tag = 'e', n = 'power', dir = 'heat', speed = 'heat', bank = 'power',
  delay = 'power', power = 'heat',
}
for _, t in ipairs { { 3.9, 1.25 }, { -4, 2 }, { 1, -32768 } } do
  dot(50, 50, { { emit = ring } }, { dir = 9, power = t[1], heat = t[2] })
  wait(1)
  list('e', 'dir', 'speed', 'bank', 'delay', 'power', 'heat')
  bullet.group():remove()
end
--> 1.25 1.25 3 3 1.25 0, 121.25 1.25 3 3 1.25 0, 241.25 1.25 3 3 1.25 0
--> none
--> 352 -8191 1 1 -32768 0

--case: the number of each pattern may be a value; what shots have no value for is 0
for word, of in pairs { spread = 'fan', sweep = 'arc', speed_to = 'stack', width = 'line' } do
  local emit = { pattern = of, n = 3, [word] = 'power', kind = 'dot', speed = 2, dir = 0, tag = 'e' }
  dot(50, 50, { { emit = emit }, { die = true } }, { power = 40 })
  wait(1)
  pattern[of] { x = 50, y = 50, kind = 'dot', n = 3, [word] = 40, speed = 2, dir = 0, tag = 'l' }
  wait(1)
  local want = {}
  bullet.each('l', function(b) want[#want + 1] = b.x .. b.y .. b.dir .. b.speed end)
  bullet.each('e', function(b) assert(table.remove(want, 1) == b.x .. b.y .. b.dir .. b.speed) end)
  print(bullet.group('e').count, #want)
  bullet.group():remove()
end
local fan = { pattern = 'fan', n = 'power', spread = 90, speed = 'heat', kind = 'dot' }
shot.fire { kind = 'bolt', x = 50, y = 50, speed = 0, power = 2, motion = motion.def { { emit = fan } } }
wait(1)
list(nil, 'speed')
--> 3 0
--> 3 0
--> 3 0
--> 3 0
--> 0, 0

--case: what finds no place in a full pool is counted
local ring = { pattern = 'ring', n = 1000, skip = { 1, 998 }, kind = 'dot', speed = 1 }
local none = { pattern = 'ring', n = 0, kind = 'dot', speed = 1 }
local bolt = { fire = 'shot', kind = 'bolt', speed = 1 }
dot(50, 50, { { loop = 300, { emit = ring } }, { emit = none }, { emit = bolt } }, { speed = 0 })
wait(1)
print(board.live 'bullets', board.refused 'bullets', board.live 'shots', board.refused 'shots')
bullet.group():remove()
local stack = { pattern = 'stack', n = 3, speed_to = 2, kind = 'dot', speed = 1 }
for i = 1, 200 do dot(50, 50, { { emit = stack }, { die = true } }) end
wait(1)
print(board.live 'bullets', board.refused 'bullets' - 345)
bullet.group():remove()
for i = 1, 256 do dot(50, 50, { { emit = { kind = 'dot', speed = 1 } }, { die = true } }) end
wait(1)
print(board.live 'bullets', board.refused 'bullets' - 345)
--> bullet pool full (256): new bullets are dropped; raise `board.bullets` in rom.lua
--> 256 345 1 0
--> 256 344
--> 256 344

--case: waiting for a line: crossed from either side, reached, started on, jumped over
local function at(x, y, dir, speed, condition)
  return dot(x, y, { { wait_for = condition }, { bank = 7 } }, { dir = dir, speed = speed })
end
local dots = {
  at(10, 50, 0, 3, { x = 16 }),
  at(22, 50, 180, 4, { x = 16 }),
  at(50, 16, 90, 1, { y = 16 }),
  at(50, 20, 270, 1, { y = 16.5 }),
  at(50, 20, 0, 1, { y = 16 }),
  at(10, 20, 0, 1, { x = 200 }),
}
for _ = 1, 5 do
  wait(1)
  list(nil, 'bank')
  dots[6].x = 300
end
--> 0, 0, 7, 0, 0, 0
--> 0, 0, 7, 0, 0, 7
--> 7, 7, 7, 0, 0, 7
--> 7, 7, 7, 0, 0, 7
--> 7, 7, 7, 7, 0, 7

--case: waiting until a target is nearer
ship(100, 100)
local program = { { wait_for = { near = 5 } }, { bank = 7 } }
local a = dot(97, 92, program, { dir = 90 })
local far = dot(80, 92, program, { dir = 90 })
wait(5)
print(a.y, a.bank) -- 5 px: not nearer
enemy.spawn { kind = 'foe', x = 60, y = 60 }
local s = shot.fire {
  kind = 'bolt', x = 60, y = 80, dir = 270, speed = 2,
  motion = motion.def { { wait_for = { near = 12 } }, { bank = 7 } },
}
wait(1)
print(a.bank)
for y = 72, 70, -2 do
  wait(y == 72 and 3 or 1)
  print(s.y, s.bank)
end
wait(1)
print(s.bank, far.bank)
--> 97.0 0
--> 7
--> 72.0 3
--> 70.0 3
--> 7 0

--case: a limit ends the waiting; places and limits may be values
local a = dot(10, 50, { { wait_for = { x = 99, limit = 4 } }, { bank = 7 } }, { dir = 0 })
local b = dot(10, 50, { { wait_for = { near = 5, limit = 4 } }, { bank = 7 } }, { dir = 0 }) -- of nobody
local c = dot(10, 50, {
  { wait_for = { x = 'power' } },
  { bank = 7 },
  { wait_for = { near = 'power', limit = 'heat' } },
  { bank = 8 },
}, { dir = 0, power = 13, heat = 9 })
wait(1)
c.power = 12
wait(3)
print(a.bank, b.bank, c.x)
wait(1)
print(a.bank, b.bank)
wait(7)
print(c.bank)
wait(1)
print(c.bank)
--> 0 0 14.0
--> 7 7
--> 7
--> 8

--case: a signal counts once, for those with its tag that wait when it is given
local program = { { wait = 2 }, { loop = 2, { wait_for = { tag = 'go' } }, { turn = 45 } } }
local a = dot(10, 50, program, { dir = 0 })
local s = shot.fire { kind = 'bolt', x = 10, y = 50, dir = 0, speed = 1, motion = a.motion }
local go = bullet.group('go')
for _ = 1, 3 do
  go:signal() -- too early
  wait(1)
end
bullet.group('other'):signal()
shot.group('go'):signal()
wait(1)
print(a.dir, s.dir)
go:signal()
print(a.dir)
wait(1)
print(a.dir)
wait(40)
print(a.dir)
bullet.group():signal() -- any
wait(1)
print(a.dir, a.motion, s.dir)
--> 0.0 45.0
--> 0.0
--> 45.0
--> 45.0
--> 90.0 nil 45.0

--case: a frozen bullet hears a signal, a delayed one or another program does not
local program = motion.def {
  { wait_for = { tag = 'go', limit = 9 } }, { bank = 7 }, { wait = 20 }, { bank = 8 },
}
local frozen = bullet.fire { kind = 'dot', x = 10, y = 50, speed = 1, motion = program }
local delayed = bullet.fire { kind = 'dot', x = 10, y = 50, speed = 1, delay = 5, motion = program }
local other = bullet.fire { kind = 'dot', x = 10, y = 50, speed = 1, motion = program }
wait(1)
frozen.frozen = 3
wait(1)
bullet.group('go'):signal()
other.motion = program
for _, frames in ipairs { 2, 1, 3, 7, 9, 1 } do
  wait(frames)
  print(frozen.bank, delayed.bank, other.bank)
end
--> 0 0 0
--> 7 0 0
--> 7 0 0
--> 7 7 7
--> 7 7 7
--> 8 7 7

--case: a path leads a bullet as it leads an enemy, wherever it starts
for k, route in ipairs(routes) do
  local mirror = k % 3 == 0
  local x, y = path.place(route[1], mirror, 0, 0)
  task.go(function()
    local e = enemy.spawn { kind = 'foe', x = 5, y = 5 }
    local t = task.go(path.run, e, route, mirror)
    local b = dot(x, y, { { path = route, mirror = mirror, bank = 4 }, { bank = 5 } })
    local c = dot(b.x + 7.25, b.y - 3, { { path = route, mirror = mirror } })
    while true do
      wait(1)
      if not task.alive(t) then break end
      assert(b.x == e.x and b.y == e.y and b.bank == 4)
      assert(math.abs(c.x - b.x - 7.25) < 3e-5 and math.abs(c.y - b.y + 3) < 3e-5)
    end
    local vx, vy = b.vx, b.vy
    wait(1)
    assert(b.bank == 5 and b.vx == vx and b.vy == vy)
    ended = ended + 1
  end)
end
wait(230)
print(ended)
--> 30

--case: a path starts where the bullet is, and continues from where it is moved
local a = dot(50, 60, { { path = down } }, { dir = 45 })
local b = dot(100, 60, { { path = down, mirror = true } })
for _, frames in ipairs { 2, 3, 2, 2, 9, 1 } do
  wait(frames)
  print(a.x, a.y, a.dir, a.speed, b.x)
  if a.speed == 0 then a.x = 90 end
end
--> 54.0 60.0 0.0 2.0 96.0
--> 60.0 60.0 0.0 2.0 90.0
--> 60.0 60.0 0.0 0.0 90.0
--> 90.0 62.0 90.0 2.0 90.0
--> 90.0 80.0 90.0 2.0 90.0
--> 90.0 82.0 90.0 2.0 90.0

--load: arguments of emit
motion.def { { emit = 3 } }
--! motion.def: step 1: emit: expected a table, got 3
motion.def { { emit = { 'dot' } } }
--! motion.def: step 1: emit: expected named arguments ({ name = value }), got key 1
motion.def { { wait = 1 }, { emit = { kind = 'bolt', speed = 1 } } }
--! motion.def: step 2: emit: unknown bullet kind "bolt" (found shot kind "bolt")
motion.def { { emit = { kind = 'dot', speed = 1, n = 3 } } }
--! motion.def: step 1: emit: `n` does not apply to pattern "one" (did you forget `pattern`?)
motion.def { { emit = { kind = 'dot', speed = 1, pattern = 'ring' } } }
--! motion.def: step 1: emit: pattern "ring" requires `n`
motion.def { { emit = { kind = 'dot', speed = 1, pattern = 'fan', n = 3 } } }
--! motion.def: step 1: emit: pattern "fan" requires `spread`
motion.def { { emit = { kind = 'dot', speed = 1, pattern = 'arc', n = 3, spread = 4 } } }
--! motion.def: step 1: emit: `spread` does not apply to pattern "arc"
motion.def { { emit = { kind = 'dot', speed = 'heap' } } }
--! motion.def: step 1: speed: unknown value "heap" (did you mean "heat"?)
motion.def { { emit = { kind = 'dot', speed = 1, x = 3 } } }
--! motion.def: step 1: emit: `x` is not allowed (`emit` fires from the bullet's position)
motion.def { { emit = { kind = 'dot', speed = 1, het = 3 } } }
--! motion.def: step 1: emit: unknown argument "het" (did you mean "heat"?)
motion.def { { emit = { kind = 'bolt', fire = 'shot', speed = 1, delay = 3 } } }
--! motion.def: step 1: emit: `delay` does not apply to shots
motion.def { { emit = { kind = 'dot', speed = 1 }, turn = 3 } }
--! motion.def: step 1: `turn` cannot be combined with `emit`
motion.def { { loop = forever, { emit = { kind = 'dot', speed = 1 } } } }
--! motion.def: step 1: infinite loop: with `loop = forever`, at least one step must take time

--load: arguments of wait_for
motion.def { { wait_for = 3 } }
--! motion.def: step 1: wait_for: expected a table, got 3
motion.def { { wait_for = { x = 1, tag = 'a' } } }
--! motion.def: step 1: wait_for: expected one of `x`, `y`, `near` and `tag`, got 2
motion.def { { wait_for = { x = 1, limits = 3 } } }
--! motion.def: step 1: wait_for: unknown argument "limits" (did you mean "limit"?)
motion.def { { wait_for = { x = 1, limit = 0 } } }
--! motion.def: step 1: wait_for: limit: expected forever or a whole number from 1 to 1000000000 frames, got 0
motion.def { { wait_for = { x = 1 }, bank = 3 } }
--! motion.def: step 1: `bank` cannot be combined with `wait_for`

--load: arguments of path
motion.def { { path = {} } }
--! motion.def: step 1: path: expected a route (from path.def)
motion.def { { path = point } }
--! motion.def: step 1: path: the route has no length; add a second point
motion.def { { path = down, over = 4 } }
--! motion.def: step 1: `over` cannot be combined with `path`
motion.def { { turn = 3, mirror = true } }
--! motion.def: step 1: `mirror` requires `path`
motion.def { fine = true, { path = down } }
--! motion.def: step 1: `path` cannot be used in a fine motion (this step is always exact)

--load: a step before an endless loop does not make it take time
motion.def { { orbit = 50, over = 15 }, { loop = forever, { turn = 3 } } }
--! motion.def: step 2: infinite loop: with `loop = forever`, at least one step must take time

--each: a volley fails alike with and without `each`, but for a place that is missing
pattern.line { kind = 'dot', speed = 1, n = 3, width = 90, x = 16380, y = 1 }
--! bullet.fire: x: expected a number from -16383 to 16383 px, got 16425.0
pattern.line { kind = 'dot', speed = 1, n = 3, width = 90, x = 16380, y = 1, each = function(t) bullet.fire(t) end }
--! bullet.fire: x: expected a number from -16383 to 16383 px, got 16425.0
pattern.ring { kind = 'dot', speed = 1, n = 3, x = 1 }
--! pattern.ring: place: expected either `x` and `y`, or `from`
pattern.ring { kind = 'dot', speed = 1, n = 3, x = 1, each = function(t) bullet.fire(t) end }
--! bullet.fire: place: expected either `x` and `y`, or `from`
