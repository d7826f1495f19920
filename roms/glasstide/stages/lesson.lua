-- stages/lesson.lua - the first mission: each step asks for one thing and goes on until the craft
-- has done it.
local scoring = require "scoring"
local sea = require "sea"

local ROW <const> = 7        -- of the words, below the HUD
local LONG <const> = 60 * 60 -- frames
local MIDDLE <const> = 120   -- px

-- Says what to do, repeats act(p) until done(p), and clears the field.
local function teach(title, words, act, done)
  local p, part = player.get(1), task.scope()
  hud.banner({ title, words }, LONG, ROW)
  task.own(part, function()
    while true do act(p) end
  end)
  wait_until(function() return p.state == "fly" and done(p) end)
  task.stop(part)
  enemy.each(nil, function(e) e:hurt(e.hp) end)
  bullet.clear { all = true, spark = "pop" }
  sound.play("phase")
  hud.banner({ "WELL DONE" }, 60, ROW)
  wait(75)
end

local function sink(e)
  while true do
    e.y = e.y + 1.2
    wait(1)
  end
end

-- How far a count of the craft has risen by n since now.
local function more(p, what, n)
  local from = p[what]
  return function() return p[what] >= from + n end
end

local function krill()
  enemy.spawn { kind = "krill", x = rng.int(50, 190), y = -10, run = sink }
  wait(34)
end

-- Two columns with a lane between them, where the craft is when they start.
local function lane(p)
  local x = math.max(40, math.min(200, p.x))
  for _ = 1, 24 do
    for _, side in ipairs { -15, 15 } do
      bullet.fire { kind = "pellet", bank = 7, x = x + side, y = -8, dir = 90, speed = 1.6 }
    end
    wait(12)
  end
  wait(40)
end

-- Orbs that pass the craft on both sides.
local function brush(p)
  local side = rng.int(0, 1) * 2 - 1
  bullet.fire { kind = "orb", bank = 3, x = p.x + 13 * side, y = -8, dir = 90, speed = 1.8 }
  wait(14)
end

local function shower(p)
  p.gauge = math.max(p.gauge, scoring.NEED)
  for k = -3, 3 do
    bullet.fire { kind = "star", bank = 1, x = MIDDLE + 26 * k, y = -8, dir = 90, speed = 1.2 }
  end
  wait(40)
end

local function wall(p)
  p.bombs = math.max(p.bombs, 1)
  for k = -7, 7 do
    bullet.fire { kind = "rice", bank = 1, x = MIDDLE + 16 * k, y = -8, dir = 90, speed = 1 }
  end
  wait(22)
end

local broken = 0 -- krill
on.kill(function() broken = broken + 1 end)

stage.def("lesson", function()
  local p = player.get(1)
  sea.scene("shallows", 1.6, 0)
  wait(150) -- the mission's own words
  broken = 0
  teach("FIRE", "Hold Fire and break six krill.", krill, function() return broken >= 6 end)
  local held = 0 -- frames
  teach("FOCUS", "Hold Focus to fly slowly and to see the dot that can be hit. Stay in the lane.", lane,
        function()
          held = pad.down("focus", 1) and held + 1 or held
          return held >= 180
        end)
  teach("GRAZE", "Let bullets pass close by. They fill GLASS.", brush, more(p, "brushes", 12))
  teach("SPECIAL", "With a quarter of GLASS, Special turns bullets into prisms. Take ten.", shower,
        more(p, "prisms", 10))
  teach("BOMB", "No way through: use a bomb.", wall, more(p, "used", 1))
end, { music = "tide" })
