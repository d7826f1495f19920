-- stages/caravan.lua - two minutes, and all that swims by in them. A formation that is gone calls
-- the next, so who shoots faster sees more; one of which none got away is worth more each time.
-- At 2:00 all stops, and what is left is paid for.
local clock = require "clock"
local herds = require "stages/caravan/herds"
require "stages/caravan/scene"

local LONG <const> = 120 * 60 -- frames
local LATE <const> = 10 * 60  -- of them the last, when the clock is heard
local PATIENCE <const> = 200  -- frames until the next comes although the one before is still there
local FEW <const> = 2         -- that many left of one call the next as well
local KEPT <const> = 8        -- tags of herds, taken in turns

local caravan = { LONG = LONG }

local left_of = {} -- tag -> how many of that herd swim yet
local streak = 0   -- herds in a row of which none got away

on.start(function() left_of, streak = {}, 0 end)
on.death(function() streak = 0 end)
on.leave(function(e)
  if left_of[e.tag] then left_of[e.tag], streak = nil, 0 end
end)

-- A herd is gone, and none of it got away.
local function whole()
  streak = streak + 1
  local points = 1000 * math.min(streak, 50)
  player.each(function(p) if p.alive then score.add(points, p) end end)
  sound.play("bonus")
  hud.centre(6, ("  x%d  +%d  "):format(streak, points), hud.banks.bright)
end

on.kill(function(e)
  local left = left_of[e.tag]
  if not left then return end
  left_of[e.tag] = left > 1 and left - 1 or nil
  if left == 1 then whole() end
end)

-- The next herd as soon as there is room for it.
local function drive()
  for k = 1, forever do
    local tag = "herd " .. k % KEPT
    left_of[tag] = herds.send(k, streak, tag)
    wait_until(function() return (left_of[tag] or 0) <= FEW end, PATIENCE)
    wait(8)
    if k % 4 == 0 then text.clear { col = 0, row = 6, w = hud.cols, h = 1 } end
  end
end

local function tick(left)
  while true do
    if left() <= LATE and left() > 0 and left() % 60 == 0 then sound.play("tick") end
    wait(1)
  end
end

-- What is left, and what it is worth.
local function pay()
  local lines = { "TIME!" }
  player.each(function(p)
    if not p.alive then return end
    local lives, bombs = 20000 * p.lives, 5000 * p.bombs
    score.add(lives + bombs, p)
    lines[#lines + 1] = text.lang("LIVES %d"):format(lives)
    lines[#lines + 1] = text.lang("BOMBS %d"):format(bombs)
  end)
  hud.banner(lines, 170)
end

stage.def("caravan", function()
  bg.show("caravan", { over = 0 })
  local began = game.frames -- what stands still while the game does
  local function left() return math.max(0, LONG - (game.frames - began)) end
  local road = task.scope() -- with it go the waves that are on their way
  task.own(road, drive)
  task.own(road, function() tick(left) end)
  do
    local shown <close> = clock.show(left, LATE)
    stage.at(LONG)
  end
  task.stop(road)
  if stage.skipping() then return end
  hud.centre(hud.rows - 2, clock.text(0), hud.banks.alarm)
  player.each(function(p) p.safe = 200 end)
  bullet.clear { all = true, spark = "pop" }
  enemy.each(nil, function(e)
    spark.burst { kind = "fizz", from = e, n = 4 }
    e:remove()
  end)
  sound.play("phase")
  pay()
  wait(180)
  text.clear { col = 0, row = 6, w = hud.cols, h = 1 }
  text.clear { col = 8, row = hud.rows - 2, w = hud.cols - 16, h = 1 }
end, { music = "caravan" })

return caravan
