-- stages/two.lua - the drowned glassworks, where the furnace still burns.
local habits = require "stages/two/habits"
local sea = require "sea"
local waves = require "waves"
require "stages/two/creatures"
require "stages/two/bellows"
require "stages/two/eels"
require "stages/two/scene"
local trains = require "stages/two/trains"

local sweep = path.def {
  { x = -16, y = 60 }, { x = 80, y = 40, over = 50, ease = "out" }, { x = 180, y = 96, over = 60 },
  { x = 260, y = 150, over = 60, ease = "in" } }
local hook = path.def {
  { x = 40, y = -20 }, { x = 60, y = 110, over = 70, ease = "out" },
  { x = 150, y = 130, over = 50 },
  { x = 200, y = -30, over = 80, ease = "in" } }
local sink = path.def {
  { x = 30, y = -24 }, { x = 30, y = 90, over = 90, ease = "out" },
  { x = 30, y = 350, over = 230, ease = "in" } }
local rush = path.def {
  { x = 120, y = -40 }, { x = 120, y = 96, over = 70, ease = "out" }, { wait = 30 },
  { x = 120, y = 380, over = 120, ease = "in" } }
local scuttle = path.def {
  { x = 40, y = -24 }, { x = 40, y = 78, over = 54, ease = "out" }, { wait = 40 },
  { x = 100, y = 88, over = 50, ease = "both" }, { wait = 50 },
  { x = 60, y = -34, over = 70, ease = "in" } }
local hang = path.def {
  { x = 66, y = -34 }, { x = 66, y = 72, over = 80, ease = "out" }, { wait = 230 },
  { x = 66, y = -44, over = 80, ease = "in" } }
local wind = path.def {
  { x = 44, y = -34 }, { x = 84, y = 70, over = 80, ease = "out" },
  { x = 40, y = 110, over = 90, ease = "both" }, { x = 84, y = 70, over = 90, ease = "both" },
  { x = 20, y = -40, over = 80, ease = "in" } }
local glide = path.def {
  { x = -40, y = 60 }, { x = 110, y = 96, over = 110, ease = "both" }, { wait = 40 },
  { x = 284, y = 60, over = 110, ease = "both" } }
local berth = path.def {
  { x = 120, y = -40 }, { x = 120, y = 70, over = 90, ease = "out" }, { wait = 440 },
  { x = 120, y = -60, over = 90, ease = "in" } }

local wave, both = stage.wave, waves.both

-- The wall of arches introduces the creatures of the works.
local function arches()
  stage.at(10)   both { kind = "drone", n = 5, every = 13, path = sweep, run = habits.blink }
  stage.at(170)  wave { kind = "drone", n = 7, every = 13, path = sweep, mirror = true,
                        run = habits.blink }
  stage.at(370)  wave { kind = "bottle", n = 5, every = 12, path = sink, dx = 24,
                        run = habits.cork }
  stage.at(470)  wave { kind = "bottle", n = 5, every = 12, path = sink, dx = 24, mirror = true,
                        run = habits.cork }
  stage.at(640)  wave { kind = "puffer", n = 2, every = 20, path = hang, dx = 108,
                        run = habits.puff }
  stage.at(880)  both { kind = "tongs", n = 2, every = 30, path = scuttle, dx = 24,
                        run = habits.nip }
  stage.at(1060) wave { kind = "drone", n = 8, every = 11, path = hook, run = habits.beads }
  stage.at(1160) wave { kind = "drone", n = 8, every = 11, path = hook, mirror = true,
                        run = habits.beads }
  stage.at(1290) wave { kind = "crucible", n = 1, every = 1, path = hang, dx = 0,
                        run = habits.spill }
  stage.at(1330) wave { kind = "crucible", n = 1, every = 1, path = hang, mirror = true,
                        run = habits.spill }
end

-- Two kinds at a time, which fire across each other.
local function galleries()
  stage.at(1580) both { kind = "drone", n = 6, every = 10, path = sweep, run = habits.beads }
  stage.at(1640) wave { kind = "gear_ray", n = 1, every = 1, path = glide, run = habits.mesh }
  stage.at(1780) wave { kind = "bottle", n = 7, every = 0, path = rush, formation = "v", gap = 24,
                        run = habits.cork }
  stage.at(1830) both { kind = "tongs", n = 2, every = 26, path = scuttle, dx = 20,
                        run = habits.nip }
  stage.at(1980) both { kind = "worm", n = 1, every = 1, path = wind, run = habits.vent }
  stage.at(2060) both { kind = "drone", n = 8, every = 10, path = hook, run = habits.blink }
  stage.at(2130)
  stage.clear(200)
end

-- In the street, creatures come faster and in formations.
local function street()
  stage.at(2380) wave { kind = "bottle", n = 7, every = 0, path = rush, formation = "v", gap = 22,
                        run = habits.shaken }
  stage.at(2520) both { kind = "drone", n = 6, every = 9, path = sweep, run = habits.blink }
  stage.at(2640) wave { kind = "bottle", n = 6, every = 0, path = rush, formation = "line",
                        gap = 34,
                        run = habits.shaken }
  stage.at(2760) wave { kind = "gear_ray", n = 1, every = 1, path = glide, run = habits.mesh }
  stage.at(2900) wave { kind = "bottle", n = 9, every = 0, path = rush, formation = "v", gap = 20,
                        run = habits.shaken }
  stage.at(3000) both { kind = "drone", n = 6, every = 9, path = hook, run = habits.beads }
  stage.at(3100) wave { kind = "gear_ray", n = 1, every = 1, path = glide, mirror = true,
                        run = habits.mesh }
  stage.at(3180) wave { kind = "bottle", n = 7, every = 0, path = rush, formation = "line",
                        gap = 30, run = habits.cork }
  stage.at(3290) both { kind = "drone", n = 8, every = 8, path = sweep, run = habits.beads }
  stage.at(3400)
  stage.clear(200)
end

-- After the Bellows, all creatures appear together.
local function halls()
  stage.at(3760) both { kind = "drone", n = 7, every = 10, path = sweep, run = habits.beads }
  stage.at(3900) both { kind = "worm", n = 1, every = 1, path = wind, run = habits.vent }
  stage.at(4080) wave { kind = "bottle", n = 6, every = 12, path = sink, dx = 36,
                        run = habits.cork }
  stage.at(4270) wave { kind = "gear_ray", n = 1, every = 1, path = glide, run = habits.mesh }
  stage.at(4340) wave { kind = "gear_ray", n = 1, every = 1, path = glide, dy = -10, mirror = true,
                        run = habits.mesh }
  stage.at(4540) both { kind = "tongs", n = 3, every = 24, path = scuttle, dx = 20,
                        run = habits.nip }
  stage.at(4720) wave { kind = "kiln", n = 1, every = 1, path = berth, run = habits.bake }
  stage.at(4900) both { kind = "drone", n = 8, every = 10, path = hook, run = habits.blink }
  stage.at(5120) both { kind = "puffer", n = 1, every = 1, path = hang, run = habits.puff }
  stage.at(5240) wave { kind = "bottle", n = 9, every = 0, path = rush, formation = "v", gap = 20,
                        run = habits.cork }
  stage.at(5380)
  stage.clear(200)
end

-- Trains run through the yard on two tracks, down and up; creatures fly between them.
local function yard()
  trains.send(1, 1.2, { "engine", "ladle", "gun", "gun" })
  wait(140)
  both { kind = "drone", n = 6, every = 10, path = sweep, run = habits.blink }
  wait(90)
  trains.send(2, -1.3, { "engine", "gun", "ladle", "gun" })
  wait(170)
  wave { kind = "bottle", n = 7, every = 0, path = rush, formation = "v", gap = 20, run = habits.shaken }
  wait(110)
  trains.send(2, 1.2, { "engine", "gun", "ladle", "gun", "ladle" })
  wait(120)
  wave { kind = "gear_ray", n = 1, every = 1, path = glide, run = habits.mesh }
  wait(100)
  trains.send(1, -1.3, { "engine", "gun", "gun", "ladle" })
  both { kind = "drone", n = 8, every = 9, path = hook, run = habits.beads }
  wait(230)
  trains.send(1, 1.4, { "engine", "gun", "ladle", "gun", "ladle", "gun" })
  wait(50)
  trains.send(2, 1.4, { "engine", "ladle", "gun", "ladle", "gun", "ladle" })
  wait(180)
  both { kind = "puffer", n = 1, every = 1, path = hang, run = habits.puff }
  wait(130)
  both { kind = "drone", n = 8, every = 9, path = sweep, run = habits.beads }
  wait(130)
  stage.clear(200)
end

stage.def("two", function()
  sea.scene("works", 1.6, 0)
  text.put { col = 15, row = 16, text = "The Drowned Glassworks", align = "center", bank = 0 }
  task.go(function()
    wait(90)
    text.clear { col = 0, row = 16, w = 30, h = 1 }
  end)
  arches()
  galleries()
  stage.at(2330)
  stage.mark("street")
  sea.scene("street", 2.6)
  street()
  stage.mark("bellows")
  sea.scene("hearth", 1)
  wait(40)
  boss.fight("bellows")
  sea.scene("works", 1.9)
  stage.at(3720)
  stage.mark("halls")
  halls()
  stage.mark("yard")
  sea.scene("yard", 3.4)
  yard()
  stage.mark("eels")
  sea.scene("hearth", 0.6)
  wait(60)
  boss.fight("eels")
  sea.speed(2.2)
  wait(90)
end, { music = "works" })
