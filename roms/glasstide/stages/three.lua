-- stages/three.lua - the abyss: down between columns of basalt, over the trench, past the
-- Anglerlamp in lightless water and a drowned quay, and to the Queen of the Glass Tide.
require "stages/three/creatures"
require "stages/three/angler"
local fuse = require "stages/three/fuse"
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
  stage.at(10)   both { kind = "mite", n = 6, every = 13, path = swoop, run = habits.spit }
  stage.at(170)  wave { kind = "mite", n = 8, every = 13, path = swoop, mirror = true,
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
end

-- Two kinds at a time: the slow ones fill the middle, the fast ones come around them.
local function columns()
  stage.at(1420) lone { kind = "comb", path = hang, run = habits.lights }
  stage.at(1480) both { kind = "viper", n = 2, every = 16, path = pounce, dx = 30,
                        run = habits.bite }
  stage.at(1620) wave { kind = "mite", n = 8, every = 0, formation = "circle", gap = 22,
                        path = helix, run = habits.spit }
  stage.at(1700) pair { kind = "squid", path = sink, run = habits.ink }
  stage.at(1790) wave { kind = "viper", n = 5, every = 0, formation = "v", gap = 32, path = dart,
                        run = habits.bite }
  stage.at(1900) both { kind = "mite", n = 8, every = 11, path = swoop, run = habits.litter }
  stage.at(2060)
  stage.clear(130)
end

-- The floor of the sea rushes by.
local function trench()
  stage.at(2240) both { kind = "mite", n = 6, every = 10, path = swoop, run = habits.litter }
  stage.at(2340) wave { kind = "shark", n = 2, every = 110, path = patrol, dy = 10,
                        run = habits.hunt }
  stage.at(2520) wave { kind = "viper", n = 5, every = 0, formation = "v", gap = 30, path = dart,
                        run = habits.bite }
  stage.at(2680) lone { kind = "chain_head", path = hang, run = habits.chain }
  stage.at(3020) both { kind = "mite", n = 8, every = 9, path = helix, run = habits.spit }
  stage.at(3090) lone { kind = "shark", path = patrol, mirror = true, run = habits.hunt }
  stage.at(3170) wave { kind = "viper", n = 5, every = 0, formation = "line", gap = 42, path = dart,
                        run = habits.bite }
  stage.at(3320)
  stage.clear(100)
end

-- After the Anglerlamp, all creatures appear in groups.
local function deep()
  stage.at(3570) both { kind = "mite", n = 9, every = 11, path = helix, run = habits.litter }
  stage.at(3720) lone { kind = "gulper", path = hang, run = habits.gulp }
  stage.at(3860) both { kind = "viper", bank = ROSE, n = 3, every = 14, path = pounce, dx = 30,
                        run = habits.bite }
  stage.at(4020) pair { kind = "comb", bank = ROSE, path = sink, run = habits.lights }
  stage.at(4130) wave { kind = "mite", n = 8, every = 0, formation = "circle", gap = 22,
                        path = helix, run = habits.spit }
  stage.at(4290) lone { kind = "shark", bank = ROSE, path = patrol, run = habits.hunt }
                 lone { kind = "spider", bank = ROSE, path = hang, run = habits.web }
  stage.at(4430) lone { kind = "shark", bank = ROSE, path = patrol, mirror = true,
                        run = habits.hunt }
  stage.at(4580) pair { kind = "chain_head", path = moor, run = habits.chain }
                 pair { kind = "squid", bank = ROSE, path = sink, run = habits.ink }
  stage.at(4790) both { kind = "mite", n = 10, every = 10, path = swoop, run = habits.spit }
  stage.at(5010)
  stage.clear(150)
end

-- The lamps of a drowned quay light one another.
local function quay()
  fuse.send(1, { { 60, 0 }, { 104, 30 }, { 148, 60 }, { 188, 90 } })
  wait(150)
  fuse.send(1, { { 190, 0 }, { 150, 36 }, { 104, 50 }, { 60, 90 }, { 100, 130 }, { 150, 150 } })
  both { kind = "mite", n = 6, every = 12, path = swoop, run = habits.spit }
  wait(240)
  fuse.send(1, { { 120, 0 }, { 76, 34 }, { 48, 80 }, { 80, 126 }, { 124, 150 } })
  fuse.send(1, { { 164, 20 }, { 194, 64 }, { 170, 110 } })
  wait(110)
  both { kind = "viper", bank = ROSE, n = 2, every = 16, path = pounce, dx = 32, run = habits.bite }
  wait(170)
  fuse.send(1, { { 44, 0 }, { 82, 0 }, { 120, 0 }, { 158, 0 }, { 196, 0 } })
  wait(90)
  fuse.send(1, { { 196, 0 }, { 158, 0 }, { 120, 0 }, { 82, 0 }, { 44, 0 } })
  lone { kind = "shark", bank = ROSE, path = patrol, run = habits.hunt }
  wait(200)
  fuse.send(1.2, { { 120, 0 }, { 70, 20 }, { 50, 66 }, { 80, 108 }, { 120, 120 }, { 160, 108 }, { 190, 66 },
                   { 170, 20 } })
  both { kind = "mite", n = 10, every = 10, path = helix, run = habits.litter }
  wait(240)
  pair { kind = "comb", bank = ROSE, path = sink, run = habits.lights }
  wait(130)
  fuse.send(1.2, { { 44, 0 }, { 82, 12 }, { 120, 24 }, { 158, 12 }, { 196, 0 } })
  both { kind = "mite", n = 10, every = 9, path = swoop, run = habits.spit }
  wait(210)
  stage.clear(180)
end

-- The queen, seen from afar while the warning shows: a shape that rises through the dark water.
local function omen()
  local shape = sprite.put { sprite = "queen_afar", x = 120, y = 250, layer = "back", bank = 1 }
  for _ = 1, 130 do
    shape.y = shape.y - 2.7
    wait(1)
  end
  shape:remove()
end

stage.def("three", function()
  palette.load("three")
  sea.scene("abyss", 1.6, 0)
  descent()
  columns()
  stage.at(2195)
  stage.mark("trench")
  sea.scene("trench", 3.6)
  trench()
  stage.mark("angler")
  sea.scene("lightless", 0.7, 60)
  wait(70)
  boss.fight("angler")
  wait(60) -- its light goes out
  sea.scene("abyss", 2.2, 50)
  stage.mark("deep")
  deep()
  stage.mark("quay")
  sea.scene("quay", 1, 50)
  quay()
  sea.scene("court", 0.5, 60)
  stage.mark("queen")
  task.go(omen)
  queen.fight()
  music.stop { fade = 140 }
  wait(kinds.COLLAPSE)
  if moon.open() then moon.dive() end
end, { music = "abyss" })
