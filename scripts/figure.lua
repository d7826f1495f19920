-- figure.lua - less common patterns: growing figures, random gaps, points and pictures. It adds functions to the table
-- of pattern.lua, unless the game has its own pattern.lua. Only games that use one of them have this file in their ROM.
local sys = ...
if not sys.pattern then return end
local open, hand, part, around = sys.pattern.open, sys.pattern.hand, sys.pattern.part, sys.pattern.around

function pattern.whip(args)
  local own, a = open("pattern.whip", args)
  local dir, speed = a.dir, a.speed
  for i = 0, own.n - 1 do
    a.dir = dir + own.bend * part(i, own.n)
    a.speed = speed + (own.speed_to - speed) * part(i, own.n)
    hand(own, a, i + 1)
  end
end

-- Random numbers are drawn for skipped bullets too, so a gap doesn't change the other bullets.
function pattern.scatter(args)
  local own, a = open("pattern.scatter", args)
  local dir, speed = a.dir - own.spread / 2, a.speed
  for i = 1, own.n do
    a.dir = dir + own.spread * rng.number(0, 1)
    a.speed = speed + (own.speed_to - speed) * rng.number(0, 1)
    hand(own, a, i)
  end
end

-- A circle has `petals` periods of a cosine: 1 at each tip, -1 between two tips.
function pattern.rose(args)
  local own, a = open("pattern.rose", args)
  local dir, low, half = a.dir, own.speed_to, (a.speed - own.speed_to) / 2
  for i = 0, own.n - 1 do
    a.dir = dir + 360 * i / own.n
    a.speed = low + half * (1 + angle.cos(360 * (own.petals * i % own.n) / own.n))
    hand(own, a, i + 1)
  end
end

-- ---- figures that keep their shape while they grow: each bullet's velocity is a point of the figure ----

local FAR = 8192 -- px: angle.of rounds its arguments to 1/65536 px, so points are pushed out before they are measured

-- The direction of the point (x, y), seen from (0, 0), and its distance.
local function polar(x, y)
  local far = math.max(math.abs(x), math.abs(y))
  if far == 0 then return 0, 0 end
  return angle.of(x / far * FAR, y / far * FAR), math.sqrt(x * x + y * y)
end

-- Fires m bullets along a side, from its first corner to just before the second. The corners are at distances (shares
-- of the speed) from the middle: the first in direction dir, the second `turn` degrees further. i: bullets fired
-- before.
local function side(own, a, i, m, dir, speed, from, to, turn)
  local dx, dy = to * angle.cos(turn) - from, to * angle.sin(turn)
  for k = 0, m - 1 do
    local by, share = 0, from
    if k > 0 then by, share = polar(from + dx * k / m, dy * k / m) end
    a.dir, a.speed = dir + by, speed * share
    hand(own, a, i + k + 1)
  end
end

-- Returns the number of bullets on each side.
local function bullets_a_side(name, n, sides)
  if n % sides ~= 0 then
    local near = math.max(sides, (n + sides // 2) // sides * sides)
    local text = "n: expected a multiple of %d (the sides), got %d (did you mean %d?)"
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

-- A stretched circle: bullet i is at angle t of the circle, in equal steps. The first bullet flies in direction dir, so
-- its t is the angle that stretching maps to -tilt.
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

-- ---- parallel bullets from adjacent places ----

function pattern.points(args)
  local own, a = open("pattern.points", args)
  for i, p in ipairs(own.list) do
    if type(p) ~= "table" or math.type(p[1]) == nil or math.type(p[2]) == nil then
      sys.fail("pattern.points", ("point %d: expected { x, y } in px"):format(i))
    end
  end
  local put = around(own, a, own.turns)
  for i, p in ipairs(own.list) do put(i, p[1] * own.scale, p[2] * own.scale) end
end

-- Returns the places { col, row } of a picture's bullets, and its first and last column and row. Blanks at the edges
-- aren't part of the picture; dots are.
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
  if odd then sys.fail("pattern.picture", ("dots: expected rows of ASCII characters, got byte %d"):format(odd:byte())) end
  local list, left, right, top, bottom = read_dots(own.dots)
  if #list == 0 then sys.fail("pattern.picture", 'dots: expected at least one character other than "." and space') end
  local put, col, row = around(own, a, own.turns), (left + right) / 2, (top + bottom) / 2
  for i, p in ipairs(list) do put(i, (p[1] - col) * own.gap, (p[2] - row) * own.gap) end
end
