-- stages/river.lua - the stage, in the order of play.
local left = path.def { { x = 20, y = -24 }, { x = 60, y = 90, over = 80, ease = "out" }, { wait = 60 },
                        { x = -40, y = 40, over = 90, ease = "in" } }
local sway = path.def { { x = 50, y = -24 }, { x = 90, y = 70, over = 70, ease = "out" },
                        { x = 40, y = 150, over = 90, ease = "both" }, { x = 100, y = 350, over = 110, ease = "in" } }
local sink = path.def { { x = 60, y = -40 }, { x = 60, y = 84, over = 110, ease = "out" }, { wait = 420 },
                        { x = 60, y = -60, over = 90, ease = "in" } }

local function glow(e) -- a lantern: a ring that opens
  wait(70)
  pattern.ring { from = e, kind = "orb", bank = 2, aim = true, speed = 1.4,
                 n = by_difficulty { easy = 6, normal = 10, hard = 16 } }
end

local function dust(e) -- a moth: aimed fans as it sways
  for _ = 1, 3 do
    wait(45)
    pattern.fan { from = e, kind = "petal", bank = 7, spread = 36, aim = true, speed = 2.2,
                  n = by_difficulty { easy = 1, normal = 3, hard = 5 } }
  end
end

local function wheel(e) -- a temple lantern: a wheel of rice
  wait(100)
  for i = 1, forever do
    pattern.ring { from = e, kind = "rice", bank = 1, dir = 9 * i, speed = 1.7,
                   n = by_difficulty { easy = 6, normal = 9, hard = 12 } }
    wait(16)
  end
end

stage.def("river", function()
  bg.show("river", { over = 0 })
  stage.at(90)
  stage.wave { kind = "lantern", n = 5, every = 26, path = left, dx = 14, run = glow }
  stage.at(300)
  stage.wave { kind = "lantern", n = 5, every = 26, path = left, dx = 14, mirror = true, run = glow }
  stage.at(520)
  stage.wave { kind = "moth", n = 4, every = 40, path = sway, run = dust }
  stage.wave { kind = "moth", n = 4, every = 40, path = sway, mirror = true, run = dust }
  stage.at(860)
  stage.wave { kind = "lantern", n = 7, every = 0, path = left, dx = 60, formation = "v", gap = 20, run = glow }
  stage.mark("temple")
  stage.at(1080)
  stage.wave { kind = "drum", n = 1, every = 0, path = sink, run = wheel }
  stage.wave { kind = "drum", n = 1, every = 0, path = sink, mirror = true, run = wheel }
  stage.at(1400)
  stage.wave { kind = "moth", n = 6, every = 36, path = sway, run = dust }
  stage.at(1560)
  stage.wave { kind = "moth", n = 6, every = 36, path = sway, mirror = true, run = dust }
  stage.clear(900)
  wait(60)
  boss.fight("keeper")
  wait(90)
end, { music = "river" })
