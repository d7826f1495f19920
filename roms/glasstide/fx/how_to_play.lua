-- fx/how_to_play.lua - How to Play: the library's pages on the buttons, then how to score, each with
-- a heron that plays.
local FALL <const> = 1.5 -- speed of bullets

-- Bullets on both sides of the craft, near enough to graze.
local function graze(area, n)
  for i = 1, n do
    bullet.fire { kind = "orb", x = area.w // 2 + (i % 2 == 0 and 12 or -12), y = area.y,
                  dir = 90, speed = FALL }
    area.play(20)
  end
end

local function fill(area)
  area.ship()
  graze(area, 12)
  area.play(60)
end

-- The glass is full: bullets around the craft become prisms, which it takes.
local function release(area)
  local p = area.ship()
  p.gauge = 1000
  for _ = 1, 4 do
    for k = -3, 3 do
      bullet.fire { kind = "star", x = area.w // 2, y = area.y, dir = 90 + 9 * k, speed = FALL }
    end
    area.play(12)
  end
  area.play(1, "special")
  area.play(80)
end

local function sink(e)
  while true do
    e.y = e.y + 0.8
    wait(1)
  end
end

local function chain(area)
  area.ship()
  for i = 1, 8 do
    enemy.spawn { kind = "krill", x = area.w // 2 + (i % 2 == 0 and 14 or -14), y = area.y, run = sink }
    area.play(16, "fire")
  end
  area.play(70, "fire")
end

-- Pearls fall; the craft takes them high up.
local function pearls(area)
  area.ship()
  item.drop { kind = "pearl", x = area.w // 2, y = area.y + 20, n = 6 }
  area.play(24)
  area.play(8, "up")
  area.play(60)
end

return { "move", "fire", "focus", "bomb",
  { title = "Graze", text = "Bullets that pass close to your ship fill the GLASS bar.",
    gauges = { "gauge" }, show = fill },
  { title = "Special", button = "special",
    text = "Special needs a quarter of GLASS and uses it up. Bullets become prisms and raise RATE. Full GLASS blinks.",
    gauges = { "shards", "gauge" }, show = release },
  { title = "Chain", text = "Break enemies without a pause: each one is worth more.",
    gauges = { "chain" }, show = chain },
  { title = "Pearls", text = "Collect pearls. Near the top of the screen they are worth up to ten times as much.", show = pearls } }
