-- pattern.lua - shapes made of bullets. Every pattern is a loop over bullet.fire (or shot.fire), or over the function
-- given as `each`. That gets a new table of arguments for every bullet, so it may change the table and call the next
-- pattern with it.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local pattern = {}

local OWN = { "n", "spread", "sweep", "speed_to", "width", "step", "every", "arms", "lock", "sides", "points", "inner",
  "petals", "tilt", "bend", "list", "scale", "dots", "gap", "turns", "skip", "fire", "each" }

-- Checks the arguments; returns those of the pattern, and those to hand on, with dir filled in. aim: the pattern always
-- aims.
local function open(name, args, aim)
  local a, own = sys.check(name, args), {}
  for _, key in ipairs(OWN) do own[key], a[key] = a[key], nil end
  own.shots = own.fire == "shot"
  if own.skip then own.first, own.last = own.skip[1], own.skip[2] end
  a.aim = aim or a.aim
  a.dir = args.dir or (a.aim and 0 or own.shots and 270 or 90)
  return own, a
end

local function fire(own, a)
  if own.shots then return shot.fire(a) end
  return bullet.fire(a)
end

-- Fires bullet i with the arguments a, or hands them to `each`.
local function hand(own, a, i)
  if own.first and i >= own.first and i <= own.last then return end
  if not own.each then return fire(own, a) end
  local copy = {}
  for key, value in pairs(a) do copy[key] = value end
  own.each(copy, i)
end

-- The i-th of n as a share of the way, both ends included: 0 for i = 0, 1 for i = n - 1.
local function part(i, n) return n > 1 and i / (n - 1) or 0 end

-- Turns an aimed direction into a plain one, seen from the middle of the places where the bullets start.
local function settle(own, a)
  if not a.aim or a.from and not a.from.alive then return end
  local x, y = a.x, a.y
  if a.from then x, y = a.from.x + (a.dx or 0), a.from.y + (a.dy or 0) end
  if not (x and y) then return end -- no place: only an `each` can bring one
  a.dir, a.aim = sys.aim(x, y, own.shots) + a.dir, false
end

-- ---- all from one place ----

function pattern.ring(args)
  local own, a = open("pattern.ring", args)
  local dir = a.dir
  for i = 0, own.n - 1 do
    a.dir = dir + 360 * i / own.n
    hand(own, a, i + 1)
  end
end

function pattern.fan(args)
  local own, a = open("pattern.fan", args)
  local dir = own.n > 1 and a.dir - own.spread / 2 or a.dir
  for i = 0, own.n - 1 do
    a.dir = dir + own.spread * part(i, own.n)
    hand(own, a, i + 1)
  end
end

function pattern.arc(args)
  local own, a = open("pattern.arc", args)
  local dir = a.dir
  for i = 0, own.n - 1 do
    a.dir = dir + own.sweep * part(i, own.n)
    hand(own, a, i + 1)
  end
end

function pattern.stack(args)
  local own, a = open("pattern.stack", args)
  local speed = a.speed
  for i = 0, own.n - 1 do
    a.speed = speed + (own.speed_to - speed) * part(i, own.n)
    hand(own, a, i + 1)
  end
end

function pattern.whip(args)
  local own, a = open("pattern.whip", args)
  local dir, speed = a.dir, a.speed
  for i = 0, own.n - 1 do
    a.dir = dir + own.bend * part(i, own.n)
    a.speed = speed + (own.speed_to - speed) * part(i, own.n)
    hand(own, a, i + 1)
  end
end

-- Chance is drawn for skipped bullets too: a gap does not change the others.
function pattern.scatter(args)
  local own, a = open("pattern.scatter", args)
  local dir, speed = a.dir - own.spread / 2, a.speed
  for i = 1, own.n do
    a.dir = dir + own.spread * rng.number(0, 1)
    a.speed = speed + (own.speed_to - speed) * rng.number(0, 1)
    hand(own, a, i)
  end
end

-- Once round there are `petals` waves of a cosine: 1 at each tip, -1 between two.
function pattern.rose(args)
  local own, a = open("pattern.rose", args)
  local dir, low, half = a.dir, own.speed_to, (a.speed - own.speed_to) / 2
  for i = 0, own.n - 1 do
    a.dir = dir + 360 * i / own.n
    a.speed = low + half * (1 + angle.cos(360 * (own.petals * i % own.n) / own.n))
    hand(own, a, i + 1)
  end
end

-- ---- figures that keep their shape while they grow: a bullet's velocity is a point of the figure ----

local FAR = 8192 -- px: angle.of rounds its arguments to 1/65536 px, so points are pushed out before they are measured

-- The direction of the point (x, y), seen from (0, 0), and its distance.
local function polar(x, y)
  local far = math.max(math.abs(x), math.abs(y))
  if far == 0 then return 0, 0 end
  return angle.of(x / far * FAR, y / far * FAR), math.sqrt(x * x + y * y)
end

-- m bullets along a side, from its first corner up to but without the second. Corners are given as distances, in shares
-- of speed, from the middle: the first in direction dir, the second `turn` degrees on. i: bullets fired before.
local function side(own, a, i, m, dir, speed, from, to, turn)
  local dx, dy = to * angle.cos(turn) - from, to * angle.sin(turn)
  for k = 0, m - 1 do
    local by, share = 0, from
    if k > 0 then by, share = polar(from + dx * k / m, dy * k / m) end
    a.dir, a.speed = dir + by, speed * share
    hand(own, a, i + k + 1)
  end
end

-- How many bullets a side has, of so many sides.
local function bullets_a_side(name, n, sides)
  if n % sides ~= 0 then
    local near = math.max(sides, (n + sides // 2) // sides * sides)
    local text = "n: expected a multiple of %d, for as many bullets on each side, got %d (did you mean %d?)"
    sys.fail(name, text:format(sides, n, near))
  end
  return n // sides
end

function pattern.polygon(args)
  local own, a = open("pattern.polygon", args)
  local m = bullets_a_side("pattern.polygon", own.n, own.sides)
  local dir, speed = a.dir, a.speed
  for k = 0, own.sides - 1 do
    side(own, a, k * m, m, dir + 360 * k / own.sides, speed, 1, 1, 360 / own.sides)
  end
end

function pattern.star(args)
  local own, a = open("pattern.star", args)
  local m = bullets_a_side("pattern.star", own.n, 2 * own.points)
  local dir, speed, turn = a.dir, a.speed, 180 / own.points
  for k = 0, own.points - 1 do
    local at = dir + 360 * k / own.points
    side(own, a, 2 * k * m, m, at, speed, 1, own.inner, turn)
    side(own, a, (2 * k + 1) * m, m, at + turn, speed, own.inner, 1, turn)
  end
end

-- A circle, stretched: bullet i stands at angle t of the circle, at equal steps. The first flies along dir, so its t is
-- the one that the stretching takes to -tilt.
function pattern.ellipse(args)
  local own, a = open("pattern.ellipse", args)
  local dir, long, wide = a.dir + own.tilt, a.speed, own.speed_to
  local first = -own.tilt
  if own.tilt ~= 0 and long * wide ~= 0 then
    first = polar(angle.cos(first) / long, angle.sin(first) / wide)
  end
  for i = 0, own.n - 1 do
    local t = first + 360 * i / own.n
    local by, speed = polar(long * angle.cos(t), wide * angle.sin(t))
    a.dir, a.speed = dir + by, speed
    hand(own, a, i + 1)
  end
end

-- ---- from places side by side, flying in parallel ----

-- Returns put(i, x, y), which fires bullet i from a place x, y px from the pattern's. Turned, +x is the direction of
-- flight. The aim is settled once, from the middle.
local function around(own, a, turned)
  if not (own.each or a.from or a.x and a.y) then return fire(own, a) end -- its error says what is missing
  settle(own, a)
  local kx, ky, cos, sin = "x", "y", 1, 0
  if a.from then kx, ky = "dx", "dy" end
  if turned then cos, sin = angle.cos(a.dir), angle.sin(a.dir) end
  local from_x, from_y = a[kx] or 0, a[ky] or 0
  return function(i, x, y)
    a[kx], a[ky] = from_x + (x * cos - y * sin), from_y + (x * sin + y * cos)
    hand(own, a, i)
  end
end

function pattern.line(args)
  local own, a = open("pattern.line", args)
  local put = around(own, a, true)
  for i = 0, own.n - 1 do put(i + 1, 0, own.n > 1 and own.width * (part(i, own.n) - 0.5) or 0) end
end

function pattern.points(args)
  local own, a = open("pattern.points", args)
  for i, p in ipairs(own.list) do
    if type(p) ~= "table" or math.type(p[1]) == nil or math.type(p[2]) == nil then
      sys.fail("pattern.points", ("point %d: expected { x, y }, two numbers of px"):format(i))
    end
  end
  local put = around(own, a, own.turns)
  for i, p in ipairs(own.list) do put(i, p[1] * own.scale, p[2] * own.scale) end
end

-- The places { col, row } of a picture's bullets, and its first and last column and row. Blanks at the edges are no
-- part of it, dots are.
local function read_dots(dots)
  local list, row, left, right, top, bottom = {}, 0, math.huge, 0, nil, 0
  for line in (dots .. "\n"):gmatch("([^\n]*)\n") do
    row = row + 1
    for col = 1, #line do
      local sign = line:sub(col, col)
      if sign ~= " " then
        left, right, top, bottom = math.min(left, col), math.max(right, col), top or row, row
        if sign ~= "." then list[#list + 1] = { col, row } end
      end
    end
  end
  return list, left, right, top, bottom
end

function pattern.picture(args)
  local own, a = open("pattern.picture", args)
  local odd = own.dots:match("[^ -~\n]")
  if odd then sys.fail("pattern.picture", ("dots: expected rows of plain signs, got byte %d"):format(odd:byte())) end
  local list, left, right, top, bottom = read_dots(own.dots)
  if #list == 0 then sys.fail("pattern.picture", "dots: expected a sign for each bullet, got dots and blanks alone") end
  local put, col, row = around(own, a, own.turns), (left + right) / 2, (top + bottom) / 2
  for i, p in ipairs(list) do put(i, (p[1] - col) * own.gap, (p[2] - row) * own.gap) end
end

-- ---- over time ----

function pattern.spiral(args)
  local own, a = open("pattern.spiral", args)
  if own.every == 0 and own.n == forever then sys.fail("pattern.spiral", "every: 0 with n = forever never ends") end
  local dir = a.dir
  for i = 0, own.n - 1 do
    for arm = 0, own.arms - 1 do
      a.dir = dir + 360 * arm / own.arms
      hand(own, a, i * own.arms + arm + 1)
    end
    dir = (dir + own.step) % 360 -- kept small: a long spiral loses no precision
    wait(own.every)
  end
end

function pattern.aimed(args)
  local own, a = open("pattern.aimed", args, true)
  if own.every == 0 and own.n == forever then sys.fail("pattern.aimed", "every: 0 with n = forever never ends") end
  if own.lock then settle(own, a) end
  for i = 1, own.n do
    hand(own, a, i)
    wait(own.every)
  end
end

return pattern
