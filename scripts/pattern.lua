-- pattern.lua - shapes made of bullets. Every pattern is a loop over bullet.fire, or over the function given as `each`.
-- That gets a new table of arguments for every bullet, so it may change the table and call the next pattern with it.
local sys = ... -- functions that only the standard library gets; src/board/api/api_sys.c explains each
local pattern = {}

local OWN = { "n", "spread", "sweep", "speed_to", "width", "step", "every", "arms", "lock", "each" }

-- Checks the arguments; returns those of the pattern, and those to hand on, with dir filled in. aim: the pattern always
-- aims.
local function open(name, args, aim)
  local a, own = sys.check(name, args), {}
  for _, key in ipairs(OWN) do own[key], a[key] = a[key], nil end
  a.aim = aim or a.aim
  a.dir = args.dir or (a.aim and 0 or 90)
  return own, a
end

-- Fires bullet i with the arguments a, or hands them to `each`.
local function hand(own, a, i)
  if not own.each then return bullet.fire(a) end
  local copy = {}
  for key, value in pairs(a) do copy[key] = value end
  own.each(copy, i)
end

-- The i-th of n as a share of the way, both ends included: 0 for i = 0, 1 for i = n - 1.
local function part(i, n) return n > 1 and i / (n - 1) or 0 end

-- Turns an aimed direction into a plain one, seen from the middle of the places where the bullets start.
local function settle(a)
  if not a.aim or a.from and not a.from.alive then return end
  local here = { x = a.x, y = a.y }
  if a.from then here = { x = a.from.x + (a.dx or 0), y = a.from.y + (a.dy or 0) } end
  local target = player.nearest(here.x, here.y)
  local to = target and target.alive and angle.to(here, target) or 90
  a.dir, a.aim = to + a.dir, false
end

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

-- Bullets side by side stay side by side, so the aim is settled once, from their middle.
function pattern.line(args)
  local own, a = open("pattern.line", args)
  settle(a)
  local across_x, across_y = -angle.sin(a.dir), angle.cos(a.dir)
  local kx, ky = "x", "y"
  if a.from then kx, ky = "dx", "dy" end
  local x, y = a[kx] or 0, a[ky] or 0
  for i = 0, own.n - 1 do
    local side = own.n > 1 and own.width * (part(i, own.n) - 0.5) or 0
    a[kx], a[ky] = x + across_x * side, y + across_y * side
    hand(own, a, i + 1)
  end
end

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
  if own.lock then settle(a) end
  for i = 1, own.n do
    hand(own, a, i)
    wait(own.every)
  end
end

return pattern
