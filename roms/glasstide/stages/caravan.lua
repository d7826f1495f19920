-- stages/caravan.lua - a two-minute score attack. Clearing a formation brings the next one, so
-- faster shooting brings more. Formations destroyed completely, in a row, are worth more each time.
-- At 2:00 everything stops, and remaining lives and bombs are paid.
local clock = require "clock"
local herds = require "stages/caravan/herds"
require "stages/caravan/scene"

local LONG <const> = 120 * 60 -- frames
local LATE <const> = 10 * 60  -- the last frames, in which the clock ticks
local PATIENCE <const> = 200  -- frames until the next formation comes anyway
local FEW <const> = 2         -- survivors at which the next formation comes
local KEPT <const> = 8        -- herd tags, reused in rotation

local caravan = { LONG = LONG }

local left_of = {} -- tag -> how many of that herd are left
local streak = 0   -- herds destroyed completely, in a row

on.start(function() left_of, streak = {}, 0 end)
on.death(function() streak = 0 end)
on.leave(function(e)
  if left_of[e.tag] then left_of[e.tag], streak = nil, 0 end
end)

-- A herd was destroyed completely.
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

-- Sends each herd when the one before is nearly gone.
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

-- Pays for the remaining lives and bombs.
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
  local began = game.frames -- game.frames stops with the game
  local function left() return math.max(0, LONG - (game.frames - began)) end
  local road = task.scope() -- stopping it also stops pending waves
  task.own(road, drive)
  task.own(road, function() tick(left) end)
  do
    local shown <close> = clock.show(left, LATE)
    stage.at(LONG)
  end
  task.stop(road)
  if stage.skipping() then return end
  hud.note(clock.text(0), hud.banks.alarm)
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
  hud.note()
end, { music = "caravan" })

return caravan
