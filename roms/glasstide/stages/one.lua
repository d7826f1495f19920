-- stages/one.lua - the shallows: the reef, the wreck of a lamp ship, the bones of a whale, and the guardians.
require "stages/one/creatures"
require "stages/one/nautilus"
require "stages/one/crab"
local habits = require "stages/one/habits"
local bones = require "stages/one/bones"
local hatches = require "stages/one/hatches"
local scene = require "stages/one/scene"
local kinds = require "kinds"
local sea = require "sea"
local waves = require "waves"

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
local stoop = path.def { -- for arrows: down in one stroke, a rest, and back up
  { x = 44, y = -24 }, { x = 44, y = 64, over = 40, ease = "out" }, { wait = 150 },
  { x = 44, y = -40, over = 60, ease = "in" } }
local bob = path.def { -- for seahorses: up and down like waves
  { x = -20, y = 60 }, { x = 30, y = 50, over = 50, ease = "out" },
  { x = 44, y = 84, over = 60, ease = "both" }, { x = 36, y = 52, over = 60, ease = "both" },
  { x = 48, y = 84, over = 60, ease = "both" }, { x = 40, y = 56, over = 60, ease = "both" },
  { x = 40, y = -40, over = 60, ease = "in" } }
local fall = path.def { { x = 34, y = -24 }, { x = 34, y = 348, over = 330 } }
local drift = path.def { { x = 70, y = -24 }, { x = 88, y = 350, over = 620 } }
local berth = path.def {
  { x = 120, y = -30 }, { x = 120, y = 62, over = 80, ease = "out" }, { wait = 400 },
  { x = 276, y = 90, over = 90, ease = "in" } }
local post = path.def { -- for formations: to the middle, a rest, and back up
  { x = 120, y = -34 }, { x = 120, y = 70, over = 60, ease = "out" }, { wait = 170 },
  { x = 120, y = -60, over = 70, ease = "in" } }
local plunge = path.def { { x = 120, y = -40 }, { x = 120, y = 110, over = 80, ease = "out" },
  { x = 120, y = 380, over = 130, ease = "in" } }

local wave, both = stage.wave, waves.both

local function reef()
  stage.at(90)   wave { kind = "krill", n = 8, every = 14, path = swoop, run = habits.spit }
  stage.at(250)  wave { kind = "krill", n = 8, every = 14, path = swoop,
                        mirror = true, run = habits.spit }
  stage.at(420)  wave { kind = "fish", n = 5, every = 10, path = hover, dx = 40, run = habits.fan }
  stage.at(630)  wave { kind = "arrow", n = 3, every = 36, path = stoop, dx = 76,
                        run = habits.salvo }
  stage.at(820)  both { kind = "krill", n = 6, every = 14, path = vault, run = habits.drip }
  stage.at(960)  both { kind = "seahorse", n = 1, every = 1, path = bob, run = habits.bubbles }
  stage.at(1160) wave { kind = "ray", n = 2, every = 70, path = glide, dy = -14, run = habits.wake }
  stage.at(1270) wave { kind = "krill", n = 8, every = 16, path = dive,
                        mirror = true, run = habits.spit }
end

-- Two kinds at a time: one stays and aims, the other crosses in front of it.
local function shoals()
  stage.at(1400) wave { kind = "arrow", n = 3, every = 0, formation = "line", gap = 62, path = post,
                        run = habits.salvo }
  stage.at(1460) both { kind = "krill", n = 7, every = 13, path = dive, run = habits.spit }
  stage.at(1640) wave { kind = "jelly", n = 1, every = 1, path = post, run = habits.pulse }
  stage.at(1670) both { kind = "fish", n = 3, every = 14, path = hover, dx = 18, run = habits.fan }
  stage.at(1830) wave { kind = "krill", n = 9, every = 0, formation = "v", gap = 19, path = plunge,
                        run = habits.drip }
  stage.at(1920) both { kind = "ray", n = 1, every = 1, path = glide, dy = -10, run = habits.wake }
  stage.at(2060) wave { kind = "krill", n = 9, every = 0, formation = "v", gap = 19, path = plunge,
                        run = habits.spit }
  stage.at(2100)
  stage.clear(120)
end

-- The wreck of the lamp ship scrolls by, and creatures come out of its hatches.
local function wreck()
  if stage.skipping() then return end
  sea.speed(0.9)
  scene.wreck(hatches.open)
  sea.speed(1.6)
end

-- So do the bones of a whale; shoals pass between its ribs.
local function whale()
  if stage.skipping() then return end
  sea.speed(0.9)
  scene.whale(function(spine, middle)
    bones.grow(spine, middle)
    task.go(function()
      wait(250)
      both { kind = "fish", n = 2, every = 16, path = hover, dx = 22, run = habits.gild }
      wait(270)
      both { kind = "krill", n = 6, every = 13, path = vault, run = habits.spit }
    end)
  end)
  sea.speed(1.8)
end

local function deep()
  both { kind = "fish", n = 4, every = 12, path = hover, dx = 26, run = habits.gild }
  wait(170)
  wave { kind = "float", n = 2, every = 20, path = drift, dx = 90 }
  wave { kind = "urchin", n = 4, every = 44, path = fall, dx = 57, run = habits.bristle }
  wait(250)
  wave { kind = "nautilus", n = 1, every = 1, path = berth, run = habits.whorl }
  wait(120)
  both { kind = "krill", n = 8, every = 14, path = swoop, dy = 4, run = habits.spit }
  wait(260)
  wave { kind = "jelly", n = 2, every = 30, path = loom, dx = 112, run = habits.pulse }
  wait(60)
  wave { kind = "ray", n = 3, every = 80, path = glide, run = habits.wake }
  wait(250)
  both { kind = "arrow", n = 2, every = 40, path = stoop, dx = 44, run = habits.salvo }
  wait(80)
  both { kind = "seahorse", n = 1, every = 1, path = bob, run = habits.bubbles }
  wait(140)
  both { kind = "krill", n = 10, every = 11, path = vault, run = habits.drip }
  wait(240)
  stage.clear(180)
end

-- Above the crab, all creatures appear together.
local function swarm()
  wave { kind = "urchin", n = 3, every = 0, formation = { { 0, 0 }, { 86, -50 }, { 172, 0 } }, path = fall,
         run = habits.bristle }
  both { kind = "krill", n = 8, every = 12, path = swoop, run = habits.spit }
  wait(210)
  wave { kind = "seahorse", n = 1, every = 1, path = bob, run = habits.bubbles }
  wave { kind = "arrow", n = 3, every = 0, formation = "line", gap = 60, path = post, run = habits.salvo }
  wait(190)
  both { kind = "ray", n = 1, every = 1, path = glide, dy = -16, run = habits.wake }
  both { kind = "fish", n = 3, every = 12, path = hover, dx = 24, run = habits.gild }
  wait(210)
  wave { kind = "krill", n = 11, every = 0, formation = "v", gap = 18, path = plunge, run = habits.drip }
  wait(110)
  wave { kind = "jelly", n = 2, every = 0, formation = "line", gap = 116, path = post, run = habits.pulse }
  both { kind = "krill", n = 9, every = 12, path = dive, run = habits.spit }
  wait(170)
  both { kind = "arrow", n = 2, every = 40, path = stoop, dx = 44, run = habits.salvo }
  wait(140)
  stage.clear(200)
  wait(60)
end

stage.def("one", function()
  sea.scene("shallows", 1.6, 0)
  reef()
  shoals()
  stage.mark("wreck")
  wreck()
  stage.clear(180)
  stage.mark("nautilus")
  sea.speed(0.8)
  boss.fight("nautilus")
  music.play("tide")
  sea.speed(1.8)
  palette.fade { to = "deep", over = 400, first = 13 * 16, last = 13 * 16 + 15 } -- less light
  wait(90)
  stage.mark("deep")
  deep()
  stage.mark("whale")
  whale()
  swarm()
  stage.mark("crab")
  sea.speed(0.8)
  boss.fight("crab")
  sea.speed(2.4)
  wait(kinds.COLLAPSE)
end, { music = "tide" })
