-- stages/three/fuse.lua - rows of lamps on the quay, tied to each other by a fuse. A flame runs along it and lights one
-- lamp after another; a lamp that breaks before cuts the fuse.
local habits = require "stages/three/habits"
local fuse = {}

local STEP <const> = 26 -- frames in which the flame runs from one lamp to the next
local BEADS <const> = 4 -- in a fuse between two lamps
local SAG <const> = 12  -- px

local function ride(e, vy)
  while true do
    e.y = e.y + vy
    wait(1)
  end
end

-- The place on the fuse from lamp a to lamp b, from a: t from 0 to 1.
local function along(a, b, t) return t * (b[1] - a[1]), t * (a[2] - b[2]) + SAG * 4 * t * (1 - t) end

local function tie(lamp, a, b)
  for i = 1, BEADS do
    local dx, dy = along(a, b, i / (BEADS + 1))
    sprite.put { sprite = "stalk", follow = lamp, dx = dx, dy = dy, layer = "back" }
  end
end

local function light(lamp)
  lamp.picture = "lit"
  sound.play("lamp", { from = lamp })
  spark.burst { kind = "glint", from = lamp, n = 12, speed = 2.4 }
  sprite.put { sprite = "lamplight", follow = lamp, layer = "back", blend = "light" }
  task.own(lamp, habits.burn)
end

-- The flame; lamps are those that have scrolled in so far.
local function run(list, lamps)
  for i, at in ipairs(list) do
    wait_until(function() return lamps[i] end)
    if not lamps[i].alive then return end
    light(lamps[i])
    local to = list[i + 1]
    for k = 1, to and STEP or 0 do
      local from, next_lamp = lamps[i], lamps[i + 1]
      if not from.alive or next_lamp and not next_lamp.alive then return end
      local dx, dy = along(at, to, k / STEP)
      spark.burst { kind = "glint", from = from, dx = dx, dy = dy, n = 2, speed = 1 }
      wait(1)
    end
  end
end

-- Sends a row of lamps, a list of { x, height above the first }, in the order of the fuse, down the field.
function fuse.send(vy, list)
  if stage.skipping() then return end
  local lamps = {}
  for i, at in ipairs(list) do
    task.go(function()
      wait(at[2] / vy // 1)
      local lamp = enemy.spawn { kind = "quay_lamp", x = at[1], y = -22 }
      lamps[i] = lamp
      if list[i + 1] then tie(lamp, at, list[i + 1]) end
      task.own(lamp, ride, vy)
    end)
  end
  task.go(function()
    wait(70)
    run(list, lamps)
  end)
end

return fuse
