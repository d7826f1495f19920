-- sweep.lua - bullet.sweep: clears bullets in a circle that grows each frame, in a task of the caller's owner.
local sys = ...

local EDGE = 16383 -- px: the largest coordinate

local function within(v) return math.max(-EDGE, math.min(EDGE, v)) end

-- Returns the position, as arguments of bullet.clear and query.near; nil if the entity it starts at has despawned.
local function placed(a)
  local xy, ways = a.x ~= nil and a.y ~= nil, 0
  for _, way in ipairs { a.x or a.y or false, a.from or false, a.follow or false } do
    if way then ways = ways + 1 end
  end
  if ways ~= 1 or not (xy or a.from or a.follow) then
    sys.fail("bullet.sweep", "place: expected `x` and `y`, or `from` (a thing), or `follow` (a thing)")
  end
  if a.follow then return a.follow.alive and { from = a.follow, dx = a.dx, dy = a.dy } end
  if xy then return { x = within(a.x + a.dx), y = within(a.y + a.dy) } end
  return a.from.alive and { x = within(a.from.x + a.dx), y = within(a.from.y + a.dy) }
end

-- Damages enemies in the circle, each once.
local function hurt(a, circle, met)
  circle.what = "enemy"
  for _, e in ipairs(query.near(circle)) do
    if not met[e] then
      met[e] = true
      e:hurt(a.hurt, a.by)
    end
  end
end

local function sweep(a, circle)
  local met = {}
  for k = 1, a.over do
    if a.follow and not a.follow.alive then return end
    circle.radius = a.radius + (a.radius_to - a.radius) * k / a.over
    circle.what, circle.tag, circle.spark, circle.items, circle.all = nil, a.tag, a.spark, a.items, a.all
    if not a.lasers then circle.lasers = false end -- the default is left out, because arguments are part of a run
    bullet.clear(circle)
    circle.tag, circle.spark, circle.items, circle.all, circle.lasers = nil, nil, nil, nil, nil
    if a.hurt > 0 then hurt(a, circle, met) end
    wait(1)
  end
end

function bullet.sweep(args)
  local a = sys.check("bullet.sweep", args)
  local circle = placed(a)
  if not circle then return task.own(a.from or a.follow, sweep) end -- a task that ends at once
  return task.go(sweep, a, circle)
end
