-- stages/three.lua - the abyss: down between columns of basalt, over the trench, past the Anglerlamp
-- in water without light, and to the Queen of the Glass Tide.
require "stages/three/creatures"
require "stages/three/angler"
local habits = require "stages/three/habits"
local queen = require "stages/three/queen"
local meeting = require "stages/three/meeting"
local sea = require "sea"

local swoop = path.def {
  { x = -18, y = 44 }, { x = 70, y = 104, over = 54, ease = "out" }, { x = 166, y = 122, over = 56 },
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
  { x = -36, y = 60 }, { x = 80, y = 92, over = 70, ease = "out" }, { x = 170, y = 70, over = 90, ease = "both" },
  { x = 76, y = 110, over = 90, ease = "both" }, { x = 290, y = 40, over = 110, ease = "in" } }
local moor = path.def {
  { x = 62, y = -50 }, { x = 62, y = 92, over = 110, ease = "out" }, { wait = 320 },
  { x = 62, y = -100, over = 120, ease = "in" } }
local dart = path.def {
  { x = 120, y = -80 }, { x = 120, y = 110, over = 60, ease = "out" }, { wait = 90 },
  { x = 120, y = -140, over = 90, ease = "in" } }

local wave = stage.wave

-- The same wave from both sides.
local function both(w)
  wave(w)
  w.mirror = true
  wave(w)
end

-- Down between the columns.
local function descent()
  stage.at(80)   wave { kind = "mite", n = 8, every = 13, path = swoop, run = habits.spit }
  stage.at(230)  wave { kind = "mite", n = 8, every = 13, path = swoop, mirror = true,
                        run = habits.spit }
  stage.at(390)  wave { kind = "viper", n = 4, every = 16, path = pounce, dx = 52,
                        run = habits.bite }
  stage.at(590)  both { kind = "squid", n = 1, every = 1, path = sink, run = habits.ink }
  stage.at(720)  wave { kind = "mite", n = 10, every = 11, path = helix, run = habits.litter }
  stage.at(960)  wave { kind = "comb", n = 1, every = 1, path = hang, run = habits.lights }
  stage.at(1090) both { kind = "viper", n = 2, every = 18, path = pounce, dx = 34,
                        run = habits.bite }
  stage.at(1290) wave { kind = "spider", n = 2, every = 50, path = sink, dx = 112,
                        run = habits.web }
  stage.at(1440) both { kind = "mite", n = 6, every = 14, path = swoop, run = habits.spit }
  stage.at(1620)
  stage.clear(150)
end

-- The floor of the sea rushes by.
local function trench()
  stage.at(1830) both { kind = "mite", n = 6, every = 10, path = swoop, run = habits.litter }
  stage.at(1950) wave { kind = "shark", n = 2, every = 110, path = patrol, dy = 10,
                        run = habits.hunt }
  stage.at(2160) wave { kind = "viper", n = 5, every = 0, formation = "v", gap = 30, path = dart,
                        run = habits.bite }
  stage.at(2340) wave { kind = "chain_head", n = 1, every = 1, path = hang, run = habits.chain }
  stage.at(2760)
  stage.clear(120)
end

-- Behind the lamp: all of them, in company.
local function deep()
  stage.at(3030) both { kind = "mite", n = 9, every = 11, path = helix, run = habits.litter }
  stage.at(3200) wave { kind = "gulper", n = 1, every = 1, path = hang, run = habits.gulp }
  stage.at(3360) both { kind = "viper", n = 3, every = 14, path = pounce, dx = 30,
                        run = habits.bite }
  stage.at(3540) both { kind = "comb", n = 1, every = 1, path = sink, run = habits.lights }
  stage.at(3660) wave { kind = "mite", n = 8, every = 0, formation = "circle", gap = 22,
                        path = helix, run = habits.spit }
  stage.at(3840) wave { kind = "shark", n = 1, every = 1, path = patrol, run = habits.hunt }
                 wave { kind = "spider", n = 1, every = 1, path = hang, run = habits.web }
  stage.at(4000) wave { kind = "shark", n = 1, every = 1, path = patrol, mirror = true,
                        run = habits.hunt }
  stage.at(4180) both { kind = "chain_head", n = 1, every = 1, path = moor, run = habits.chain }
                 both { kind = "squid", n = 1, every = 1, path = sink, run = habits.ink }
  stage.at(4420) both { kind = "mite", n = 10, every = 10, path = swoop, run = habits.spit }
  stage.at(4660)
  stage.clear(180)
end

-- She is seen from afar before she comes: a shape in the dark water, which rises and goes.
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
  bg.show("abyss", { over = 0 })
  sea.speed(1.6)
  descent()
  stage.at(1775)
  stage.mark("trench")
  bg.show("trench")
  sea.speed(3.6)
  trench()
  stage.mark("angler")
  sea.speed(0.7)
  bg.show("lightless", { over = 60 })
  wait(70)
  boss.fight("angler")
  bg.show("abyss", { over = 50 })
  sea.speed(2.2)
  stage.at(2985)
  stage.mark("deep")
  deep()
  bg.show("court", { over = 60 })
  sea.speed(0.5)
  music.stop { fade = 60 }
  stage.mark("queen")
  task.go(omen)
  wait(180)
  meeting()
  music.play("queen") -- until she is broken, however often she comes back
  queen.fight()
  music.stop { fade = 140 }
  wait(150)
  -- the moon: `local moon = require "stages/moon"` above, and here
  -- `if moon.open() then moon.dive() end`
end, { music = "tide" })
