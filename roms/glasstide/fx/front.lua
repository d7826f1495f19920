-- fx/front.lua - movement behind the title and its pages while nobody plays: bubbles, and now and
-- then a large creature far below.
local story = require "story"
local front = {}

local WIDE <const>, HIGH <const> = rom.screen.w, rom.screen.h

local function nobody()
  return not (player.get(1).alive or player.get(2).alive or story.telling())
end

-- The shadow of a creature that crosses slowly. Its number, k, determines its kind and where it
-- enters.
local SWIMMERS <const> = { "jelly", "ray", "nautilus", "fish" }

local function swim(k)
  local name = SWIMMERS[k % #SWIMMERS + 1]
  if not rom.has(name) then return end
  local way = k % 2 == 0 and 1 or -1
  local y, x = 190 + 61 * k % 100, way > 0 and -40 or WIDE + 40
  local s = sprite.put { sprite = name, x = x, y = y, layer = "back", blend = "ghost",
                         flip_x = way < 0 }
  while s.alive and nobody() and s.x > -50 and s.x < WIDE + 50 do
    s.x, s.y = s.x + 0.45 * way, y + 8 * angle.sin(s.x * 2)
    wait(1)
  end
  s:remove()
end

function front.run()
  for age = 0, forever do
    if nobody() then
      if age % 11 == 0 then
        spark.burst { kind = "bubbles", x = 97 * age % WIDE, y = HIGH + 8, dir = 270, spread = 30,
                      speed = 1.6 }
      end
      if age % 260 == 100 then task.go(swim, age // 260) end
    end
    wait(1)
  end
end

return front
