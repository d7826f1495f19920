-- pattern.lua - shapes made of bullets; figure.lua has more. Every pattern is a loop over bullet.fire (or shot.fire),
-- or over the function given as `each`. That function gets a new table of arguments for every bullet, so it may change
-- the table and call another pattern with it. Without `each`, the five patterns that take no time are fired in C
-- (src/script/api/api_volley.c), with bit-identical results.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local pattern = {}

local OWN = { "n", "spread", "sweep", "speed_to", "width", "step", "every", "arms", "lock", "sides", "points", "inner",
  "petals", "tilt", "bend", "list", "scale", "dots", "gap", "turns", "skip", "fire", "each" }

-- Checks the arguments. Returns the pattern's own, and those to pass on, with dir set. aim: the pattern always aims.
local function open(name, args, aim)
  local a, own = sys.check(name, args), { name = name }
  for _, key in ipairs(OWN) do own[key], a[key] = a[key], nil end
  own.fire = own.fire or "bullet"
  own.shots = own.fire == "shot"
  if own.fire == "beam" and not a.speed and (own.speed_to or own.sides or own.inner) then
    sys.fail(name, "fire: this figure sets speeds, but beams have no speed")
  end
  if not a.speed and (own.speed_to or own.sides or own.inner) then -- with `each`, the bullet needs no speed
    sys.fail(name, "speed: expected a number of px/frame, got nil")
  end
  if own.skip then own.first, own.last = own.skip[1], own.skip[2] end
  a.aim = aim or a.aim
  if aim and args.dir == nil and a.dir then sys.fail(name, "`vx` cannot be combined with `aim`") end
  a.dir = a.dir or (a.aim and 0 or own.shots and 270 or 90)
  return own, a
end

-- Fails unless bullets have a position; the error of the inner call would name another function.
local function check_place(own, a)
  local named = a.x or a.y
  if a.follow then
    if named or a.from then sys.fail(own.name, "follow: cannot be combined with `x`, `y` or `from`") end
  elseif a.from and named or not (a.from or a.x and a.y) then
    local want = (a.from or named) and "either `x` and `y`, or `from`" or "`x` and `y`, or `from` (a thing), got neither"
    sys.fail(own.name, "place: expected " .. want)
  end
end

local function fire(own, a)
  check_place(own, a)
  if own.fire == "bullet" then return bullet.fire(a) end
  if own.shots then return shot.fire(a) end
  return laser[own.fire](a)
end

-- Fires bullet i with the arguments a, or passes them to `each`.
local function hand(own, a, i)
  if own.first and i >= own.first and i <= own.last then return end
  if not own.each then return fire(own, a) end
  local copy = {}
  for key, value in pairs(a) do copy[key] = value end
  own.each(copy, i)
end

-- Returns i as a fraction of n - 1: 0 for i = 0, 1 for i = n - 1.
local function part(i, n) return n > 1 and i / (n - 1) or 0 end

-- Replaces an aimed direction by a plain one, as seen from the middle of the bullets' start positions.
local function settle(own, a)
  if not a.aim or a.from and not a.from.alive then return end
  local x, y = a.x, a.y
  if a.from then x, y = a.from.x + (a.dx or 0), a.from.y + (a.dy or 0) end
  if not (x and y) then return end -- no position: `each` must set one
  a.dir, a.aim = sys.aim(x, y, own.shots) + a.dir, false
end

local ring, fan, arc = sys.volley("pattern.ring"), sys.volley("pattern.fan"), sys.volley("pattern.arc")
local stack, line = sys.volley("pattern.stack"), sys.volley("pattern.line")

-- ---- from one position ----

function pattern.ring(args)
  if ring(args) then return end
  local own, a = open("pattern.ring", args)
  local dir = a.dir
  for i = 0, own.n - 1 do
    a.dir = dir + 360 * i / own.n
    hand(own, a, i + 1)
  end
end

function pattern.fan(args)
  if fan(args) then return end
  local own, a = open("pattern.fan", args)
  local dir = own.n > 1 and a.dir - own.spread / 2 or a.dir
  for i = 0, own.n - 1 do
    a.dir = dir + own.spread * part(i, own.n)
    hand(own, a, i + 1)
  end
end

function pattern.arc(args)
  if arc(args) then return end
  local own, a = open("pattern.arc", args)
  local dir = a.dir
  for i = 0, own.n - 1 do
    a.dir = dir + own.sweep * part(i, own.n)
    hand(own, a, i + 1)
  end
end

function pattern.stack(args)
  if stack(args) then return end
  local own, a = open("pattern.stack", args)
  local speed = a.speed
  for i = 0, own.n - 1 do
    a.speed = speed + (own.speed_to - speed) * part(i, own.n)
    hand(own, a, i + 1)
  end
end

-- ---- parallel bullets from adjacent positions ----

-- Returns put(i, x, y), which fires bullet i from x, y px beside the pattern's position. Turned, +x is the direction of
-- flight. The aim is determined once, from the middle.
local function around(own, a, turned)
  if not (own.each or a.from or a.x and a.y) then return fire(own, a) end -- its error names the missing argument
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
  if line(args) then return end
  local own, a = open("pattern.line", args)
  local put = around(own, a, true)
  for i = 0, own.n - 1 do put(i + 1, 0, own.n > 1 and own.width * (part(i, own.n) - 0.5) or 0) end
end

-- ---- over time ----

function pattern.spiral(args)
  local own, a = open("pattern.spiral", args)
  if own.every == 0 and own.n == forever then sys.fail("pattern.spiral", "every: 0 with `n = forever` never ends") end
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
  if own.every == 0 and own.n == forever then sys.fail("pattern.aimed", "every: 0 with `n = forever` never ends") end
  if own.lock then settle(own, a) end
  for i = 1, own.n do
    hand(own, a, i)
    wait(own.every)
  end
end

sys.pattern = { open = open, hand = hand, part = part, around = around } -- for figure.lua

return pattern
