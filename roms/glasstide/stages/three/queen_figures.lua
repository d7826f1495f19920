-- stages/three/queen_figures.lua - two self-contained phases of the Queen: the rose window, and the
-- tide she returns with.
local by = require "stages/three/by"
local figures = {}

-- 4. A window of coloured glass grows out of her, ring by ring. Arches line up above arches, and
-- your way leads through them. The window turns; except on easy, light falls through it.
local GLASS <const> = { 5, 3, 1, 0 } -- colours of adjacent panes

-- One ring of n panes in `arches` pieces, each with an opening of `open` bullets.
local function ring_of_panes(e, n, arches, open, dir, speed, way)
  local each = n // arches
  local turning = motion.def { { polar = speed, spin = 0.1 * way, over = forever } }
  pattern.ring { from = e, dy = -4, kind = "orb", n = n, dir = dir, speed = speed, motion = turning,
                 each = function(a, i)
                   local place = (i - 1) % each
                   if place >= each - open then return end
                   local sill = place == 0 or place == each - open - 1
                   a.kind = sill and "star" or "orb"
                   a.bank = sill and 3 or GLASS[(i - 1) // each % 4 + 1]
                   bullet.fire(a)
                 end }
end

local function light_through(e)
  while true do
    wait(by(forever, 260, 220, 240))
    local p = player.nearest(e.x, e.y)
    local dir = p and p.alive and angle.to(e, p) or 90
    sound.play("charge", { from = e })
    for side = -1, 1, 2 do
      laser.beam { kind = "ray", bank = 2, from = e, dy = -4, dir = dir + 20 * side, length = 380,
                   warn = 70, hold = 60, fade = 20, spin = -0.05 * side }
    end
    wait(70)
    sound.play("beam", { from = e })
  end
end

-- Panes come loose in the middle: daggers of shards aimed at you.
local function loose(e)
  while true do
    wait(by(203, 118, 70, 49))
    pattern.fan { from = e, dy = 8, kind = "shard", bank = 2, aim = true, delay = 22,
                  n = by(1, 3, 3, 4), spread = by(0, 44, 40, 66), speed = by(1.4, 1.6, 1.7, 1.1),
                  each = function(a) a.n, a.speed_to = 3, a.speed + 0.4 pattern.stack(a) end }
  end
end

function figures.window(e)
  task.go(light_through, e)
  task.go(loose, e)
  e:move { x = 120, y = 84, over = 50, ease = "both" }
  wait(50)
  local arches = by(6, 6, 8, 8)
  local n = arches * by(6, 8, 8, 10)
  local turn, step = 90, 0
  for k = 0, forever do
    if k % 6 == 0 then step = by(5, 6, 6, 5) * (k // 6 % 2 == 0 and 1 or -1) end
    turn = turn + step
    if k % 12 == 0 then sound.play("chord", { from = e }) end
    local way = k // 12 % 2 == 0 and 1 or -1
    ring_of_panes(e, n, arches, by(3, 3, 2, 3), turn, by(1.2, 1.25, 1.3, 0.85), way)
    wait(by(47, 30, 22, 13))
  end
end

-- The tide returns: arms of kelp hang from her across the field and sway. The channels between
-- them sway along, and now and then an arm has a hole.
local function kelp(e)
  local arms = by(12, 18, 22, 28)
  local speed = by(1.3, 1.4, 1.5, 0.95)
  local period, lean = by(420, 360, 320, 400), by(8, 12, 15, 14)
  for k = 0, forever do
    if k % 14 < 10 then
      local t = 360 * (by(9, 7, 6, 7) * k % period) / period
      pattern.ring { from = e, dy = -4, kind = "rice", bank = k % 14 < 5 and 5 or 0, n = arms,
                     dir = 90 + 180 / arms + lean * angle.sin(t), speed = speed }
    end
    wait(by(12, 6, 6, 7))
  end
end

local bloom = motion.def { { speed = 0.4, over = 40 }, { bank = 2 }, { wait = 14 },
                           { speed = 1.6, over = 60 } }

function figures.again(e)
  e:move { x = 120, y = 84, over = 40, ease = "both" }
  wait(40)
  task.go(kelp, e)
  task.go(function()
    while true do -- pearls down the channels
      wait(by(209, 67, 50, 44))
      pattern.fan { from = e, dy = 10, kind = "pearl", bank = 3, aim = true, n = by(1, 2, 3, 5),
                    spread = by(0, 40, 36, 60), speed = by(1.4, 1.7, 1.9, 1.4), delay = 20 }
    end
  end)
  for k = 1, forever do
    wait(by(188, 79, 74, 84))
    pattern.rose { from = e, dy = -4, kind = "petal", bank = 1, petals = 5, dir = 37 * k,
                   aim = k % 2 == 0, n = by(15, 20, 30, 40),
                   speed = 2.4, speed_to = 1.3, motion = bloom }
  end
end

return figures
