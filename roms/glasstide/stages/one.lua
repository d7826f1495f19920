-- stages/one.lua - the shallows, where the Chandelier Crab keeps guard.
local habits = require "stages/one/habits"
local sea = require "sea"
require "stages/one/creatures"
require "stages/one/crab"

local swoop = path.def {
  { x = -16, y = 30 }, { x = 60, y = 92, over = 50, ease = "out" },
  { x = 170, y = 120, over = 60 },
  { x = 260, y = 50, over = 60, ease = "in" } }
local vault = path.def {
  { x = -20, y = 170 }, { x = 44, y = 84, over = 46, ease = "out" },
  { x = 120, y = 50, over = 36 },
  { x = 196, y = 84, over = 36 }, { x = 262, y = 170, over = 46, ease = "in" } }
local dive = path.def {
  { x = 24, y = -20 }, { x = 60, y = 120, over = 70, ease = "both" },
  { x = 190, y = 200, over = 60 },
  { x = 230, y = 350, over = 60, ease = "in" } }
local hover = path.def {
  { x = 40, y = -20 }, { x = 40, y = 76, over = 56, ease = "out" }, { wait = 96 },
  { x = 40, y = -30, over = 70, ease = "in" } }
local glide = path.def {
  { x = -34, y = 56 }, { x = 120, y = 104, over = 100, ease = "both" },
  { x = 276, y = 60, over = 100, ease = "both" } }
local loom = path.def {
  { x = 64, y = -30 }, { x = 64, y = 76, over = 90, ease = "out" }, { wait = 270 },
  { x = 64, y = -50, over = 90, ease = "in" } }
local fall = path.def { { x = 34, y = -24 }, { x = 34, y = 348, over = 330 } }
local drift = path.def { { x = 70, y = -24 }, { x = 88, y = 350, over = 620 } }
local berth = path.def {
  { x = 120, y = -30 }, { x = 120, y = 62, over = 80, ease = "out" }, { wait = 400 },
  { x = 276, y = 90, over = 90, ease = "in" } }

local wave = stage.wave

-- The same wave from both sides.
local function both(w)
  wave(w)
  w.mirror = true
  wave(w)
end

local function shallows()
  stage.at(90)   wave { kind = "krill", n = 8, every = 14, path = swoop, run = habits.spit }
  stage.at(250)  wave { kind = "krill", n = 8, every = 14, path = swoop,
                        mirror = true, run = habits.spit }
  stage.at(440)  wave { kind = "fish", n = 5, every = 10, path = hover, dx = 40, run = habits.fan }
  stage.at(690)  both { kind = "krill", n = 7, every = 12, path = vault, run = habits.drip }
  stage.at(900)  wave { kind = "ray", n = 2, every = 70, path = glide, dy = -14, run = habits.wake }
  stage.at(1060) wave { kind = "ray", n = 2, every = 70, path = glide, dy = -14,
                        mirror = true, run = habits.wake }
  stage.at(1290) wave { kind = "jelly", n = 2, every = 40, path = loom, dx = 112,
                        run = habits.pulse }
  stage.at(1420) wave { kind = "krill", n = 8, every = 16, path = dive, run = habits.spit }
  stage.at(1560) wave { kind = "krill", n = 8, every = 16, path = dive,
                        mirror = true, run = habits.spit }
  stage.at(1800)
  stage.clear(240)
end

local function deep()
  stage.at(2090) wave { kind = "krill", n = 6, every = 12, path = vault, run = habits.drip }
  stage.at(2170) wave { kind = "float", n = 2, every = 20, path = drift, dx = 90 }
  stage.at(2180) wave { kind = "urchin", n = 4, every = 44, path = fall, dx = 57,
                        run = habits.bristle }
  stage.at(2420) both { kind = "fish", n = 4, every = 12, path = hover, dx = 26, run = habits.gild }
  stage.at(2640) wave { kind = "nautilus", n = 1, every = 1, path = berth, run = habits.whorl }
  stage.at(2760) wave { kind = "krill", n = 10, every = 12, path = swoop, run = habits.spit }
  stage.at(2980) wave { kind = "krill", n = 10, every = 12, path = swoop,
                        mirror = true, run = habits.spit }
  stage.at(3240) wave { kind = "jelly", n = 2, every = 30, path = loom, dx = 112,
                        run = habits.pulse }
                 wave { kind = "ray", n = 3, every = 80, path = glide, run = habits.wake }
  stage.at(3550) wave { kind = "float", n = 1, every = 1, path = drift, dx = 40 }
  stage.at(3560) wave { kind = "urchin", n = 4, every = 30, path = fall, dx = 57,
                        mirror = true, run = habits.bristle }
  stage.at(3760) both { kind = "krill", n = 12, every = 10, path = vault, run = habits.drip }
  stage.at(4000)
  stage.clear(300)
end

stage.def("one", function()
  bg.show("shallows", { over = 0 })
  sea.speed(1.6)
  shallows()
  stage.at(2070)
  stage.mark("deep")
  deep()
  stage.mark("guard")
  sea.speed(0.8)
  boss.fight("guard")
  sea.speed(2.4)
  wait(60)
end, { music = "tide" })
