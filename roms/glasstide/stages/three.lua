-- stages/three.lua - the abyss: down between columns of basalt, over the trench, past the
-- Anglerlamp in lightless water, and to the Queen of the Glass Tide.
require "stages/three/creatures"
require "stages/three/angler"
local habits = require "stages/three/habits"
local queen = require "stages/three/queen"
local moon = require "stages/moon"
local kinds = require "kinds"
local sea = require "sea"
local waves = require "waves"

local swoop = path.def {
  { x = -18, y = 44 }, { x = 70, y = 104, over = 54, ease = "out" },
  { x = 166, y = 122, over = 56 },
  { x = 262, y = 40, over = 58, ease = "in" } }
local helix = path.def {
  { x = 60, y = -20 }, { x = 180, y = 70, over = 60, ease = "both" },
  { x = 60, y = 140, over = 60, ease = "both" }, { x = 180, y = 70, over = 60, ease = "both" },
  { x = 60, y = -30, over = 60, ease = "both" } }
local pounce = path.def {
  { x = 40, y = -36 }, { x = 40, y = 92, over = 44, ease = "out" }, { wait = 84 },
  { x = 40, y = -46, over = 80, ease = "in" } }
local sink = path.def {
  { x = 64, y = -36 }, { x = 64, y = 84, over = 66, ease = "out" }, { wait = 250 },
  { x = 10, y = -60, over = 90, ease = "in" } }
local hang = path.def {
  { x = 120, y = -40 }, { x = 120, y = 76, over = 70, ease = "out" }, { wait = 330 },
  { x = 120, y = -60, over = 90, ease = "in" } }
local patrol = path.def {
  { x = -36, y = 60 }, { x = 80, y = 92, over = 70, ease = "out" },
  { x = 170, y = 70, over = 90, ease = "both" },
  { x = 76, y = 110, over = 90, ease = "both" }, { x = 290, y = 40, over = 110, ease = "in" } }
local moor = path.def {
  { x = 62, y = -50 }, { x = 62, y = 92, over = 110, ease = "out" }, { wait = 320 },
  { x = 62, y = -100, over = 120, ease = "in" } }
local dart = path.def {
  { x = 120, y = -80 }, { x = 120, y = 110, over = 60, ease = "out" }, { wait = 90 },
  { x = 120, y = -140, over = 90, ease = "in" } }

local ROSE <const> = 1 -- the second glass colour
local wave, both = stage.wave, waves.both

local function lone(w)
  w.n, w.every = 1, 1
  wave(w)
end

local function pair(w)
  w.n, w.every = 1, 1
  both(w)
end

-- You descend between the columns.
local function descent()
  stage.at(70)   wave { kind = "mite", n = 8, every = 13, path = swoop, run = habits.spit }
  stage.at(200)  wave { kind = "mite", n = 8, every = 13, path = swoop, mirror = true,
                        run = habits.spit }
  stage.at(340)  wave { kind = "viper", n = 4, every = 16, path = pounce, dx = 52,
                        run = habits.bite }
  stage.at(510)  pair { kind = "squid", path = sink, run = habits.ink }
  stage.at(630)  wave { kind = "mite", n = 10, every = 11, path = helix, run = habits.litter }
  stage.at(840)  lone { kind = "comb", path = hang, run = habits.lights }
  stage.at(960)  both { kind = "viper", n = 2, every = 18, path = pounce, dx = 34,
                        run = habits.bite }
  stage.at(1130) wave { kind = "spider", n = 2, every = 50, path = sink, dx = 112,
                        run = habits.web }
  stage.at(1280) both { kind = "mite", n = 6, every = 14, path = swoop, run = habits.spit }
  stage.at(1440)
  stage.clear(150)
end

-- The floor of the sea rushes by.
local function trench()
  stage.at(1640) both { kind = "mite", n = 6, every = 10, path = swoop, run = habits.litter }
  stage.at(1740) wave { kind = "shark", n = 2, every = 110, path = patrol, dy = 10,
                        run = habits.hunt }
  stage.at(1920) wave { kind = "viper", n = 5, every = 0, formation = "v", gap = 30, path = dart,
                        run = habits.bite }
  stage.at(2080) lone { kind = "chain_head", path = hang, run = habits.chain }
  stage.at(2420)
  stage.clear(150)
end

-- After the Anglerlamp, all creatures appear in groups.
local function deep()
  stage.at(2790) both { kind = "mite", n = 9, every = 11, path = helix, run = habits.litter }
  stage.at(2940) lone { kind = "gulper", path = hang, run = habits.gulp }
  stage.at(3080) both { kind = "viper", bank = ROSE, n = 3, every = 14, path = pounce, dx = 30,
                        run = habits.bite }
  stage.at(3240) pair { kind = "comb", bank = ROSE, path = sink, run = habits.lights }
  stage.at(3350) wave { kind = "mite", n = 8, every = 0, formation = "circle", gap = 22,
                        path = helix, run = habits.spit }
  stage.at(3510) lone { kind = "shark", bank = ROSE, path = patrol, run = habits.hunt }
                 lone { kind = "spider", bank = ROSE, path = hang, run = habits.web }
  stage.at(3650) lone { kind = "shark", bank = ROSE, path = patrol, mirror = true,
                        run = habits.hunt }
  stage.at(3800) pair { kind = "chain_head", path = moor, run = habits.chain }
                 pair { kind = "squid", bank = ROSE, path = sink, run = habits.ink }
  stage.at(4010) both { kind = "mite", n = 10, every = 10, path = swoop, run = habits.spit }
  stage.at(4230)
  stage.clear(200)
end

-- The queen, seen from afar before she appears: a shape that rises through the dark water.
local function omen()
  local shape = sprite.put { sprite = "queen_afar", x = 120, y = 250, layer = "back", bank = 1 }
  for _ = 1, 220 do
    shape.y = shape.y - 1.6
    wait(1)
  end
  shape:remove()
end

stage.def("three", function()
  palette.load("three")
  sea.scene("abyss", 1.6, 0)
  descent()
  stage.at(1595)
  stage.mark("trench")
  sea.scene("trench", 3.6)
  trench()
  stage.mark("angler")
  sea.scene("lightless", 0.7, 60)
  wait(70)
  boss.fight("angler")
  wait(100) -- its light goes out
  sea.scene("abyss", 2.2, 50)
  stage.at(2745)
  stage.mark("deep")
  deep()
  sea.scene("court", 0.5, 60)
  stage.mark("queen")
  task.go(omen)
  wait(180)
  queen.fight()
  music.stop { fade = 140 }
  wait(kinds.COLLAPSE)
  if moon.open() then moon.dive() end
end, { music = "abyss" })
