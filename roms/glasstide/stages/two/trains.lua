-- stages/two/trains.lua - trains in the yard: an engine and its trucks. When the engine breaks, the trucks break one
-- after another.
local habits = require "stages/two/habits"
local kinds = require "kinds"
local trains = {}

local TRACKS <const> = { 64, 176 } -- x; art_two_train.c draws the rails there
local LONG <const> = 58            -- px from one truck to the next
local DOES <const> = { engine = habits.stoke, gun = habits.battery, ladle = habits.slosh }

local function roll(e, vy)
  while true do
    e.y = e.y + vy
    wait(1)
  end
end

-- engine: a table whose `broken` is set when the engine breaks, and `by`, the player who broke it.
local function derail(e, i, engine)
  wait_until(function() return engine.broken end)
  wait(8 * (i - 1))
  bullet.sweep { x = e.x, y = e.y, radius = 8, radius_to = 56, over = 14, spark = "pop", items = "foam" }
  e:hurt(1000, engine.by)
end

local function run(track, vy, list)
  local engine = { broken = false }
  local function on_death(e, p)
    kinds.large(e, p)
    engine.broken, engine.by = true, p
  end
  for i, kind in ipairs(list) do
    if engine.broken then return end
    local e = enemy.spawn { kind = kind, x = TRACKS[track], y = vy > 0 and -34 or 354, run = DOES[kind],
                            on_death = i == 1 and on_death or nil }
    task.own(e, roll, vy)
    if i > 1 then
      task.own(e, derail, i, engine)
    elseif vy < 0 then
      e.picture = "up"
    end
    wait(LONG / math.abs(vy) // 1)
  end
end

-- Sends a train, a list of kinds with the engine first, on track 1 or 2: down the field, or up if vy < 0.
function trains.send(track, vy, list)
  if not stage.skipping() then task.go(run, track, vy, list) end
end

return trains
