-- stages/one/scene.lua - the look of the shallows: a floor of sand, rippling light, the reef on both
-- sides, kelp so near that it is almost black, and shafts of light from above. The wreck of a lamp
-- ship and the bones of a whale lie there too.
local sea = require "sea"

local scene = {}

local REEF_PART, REEF_TALL = 1.75, 320
local FIND_PART, FIND_TALL, MIDDLE = 1.2, 640, 120

local side = {} -- the third layer and its share of the speed: the reef, or for a while a find

local function remove_all(set)
  for _, s in pairs(set) do s:remove() end
end

-- Each shaft sways separately. Wiping the field removes the shafts, so this puts them again.
local function shine()
  local set <close> = setmetatable({}, { __close = remove_all })
  local kinds = { "shaft", "shaft_thin", "shaft" }
  for k = 0, forever do
    for i, kind in ipairs(kinds) do
      if not (set[i] and set[i].alive) then
        set[i] = sprite.put { sprite = kind, x = 0, y = 160, layer = "back", blend = "ghost",
                              stay = true }
      end
      set[i].x = 90 * i - 46 + 14 * angle.sin(k * (0.31 + 0.06 * i) + 140 * i)
    end
    wait(2)
  end
end

bg.def("shallows", function()
  palette.load("one")
  local floor, light, reef, kelp = bg.layer(1), bg.layer(2), bg.layer(3), bg.layer(4)
  floor.map, light.map, kelp.map = "floor", "caustics", "kelp"
  reef.map, reef.x = "reef", -14
  bg.lines(2, { wave = 6, every = 160, speed = 0.4 })
  bg.lines(4, { wave = 3, every = 150, speed = 0.5 })
  side = { reef, REEF_PART }
  sea.flow { { floor, 1 }, { light, 1.2 }, side, { kelp, 2.6 } }
  shine()
end)

-- The reef scrolls away on both sides, and a find comes: a map of this width. Calls found(hull, middle) when its lower
-- end is about to appear. Returns when its upper end has passed and the reef is coming back.
local function find(map, wide, found)
  local hull = bg.layer(3)
  wait(2) -- practice from here sets the scene first
  hull.y, hull.wrap = hull.y % REEF_TALL, false
  wait_until(function() return hull.y >= REEF_TALL end, 300)
  hull.map, hull.x, hull.y = map, MIDDLE - wide // 2, -FIND_TALL
  side[2] = FIND_PART
  found(hull, MIDDLE)
  wait_until(function() return hull.y >= 320 end, 1200)
  hull.map, hull.x, hull.y = "reef", -14, -REEF_TALL
  side[2] = REEF_PART
  task.go(function()
    wait_until(function() return hull.y >= 0 end, 600)
    hull.wrap = true
  end)
end

function scene.wreck(found) find("wreck", 160, found) end

function scene.whale(found) find("whale", 224, found) end

local function ride(e, hull, dy)
  while true do
    e.y = hull.y + dy
    wait(1)
  end
end

-- Spawns enemies of a kind at their places on a scrolling find, as each scrolls in. Each entry starts with its x from
-- the middle and its y from the upper end; run(enemy, entry) is its task.
function scene.settle(hull, middle, list, kind, run)
  for _, at in ipairs(list) do
    task.go(function()
      wait_until(function() return hull.y + at[2] > -26 end, 1200)
      local e = enemy.spawn { kind = kind, x = middle + at[1], y = hull.y + at[2] }
      task.own(e, ride, hull, at[2])
      task.own(e, run, at)
    end)
  end
end

return scene
