-- lesson.lua - the first mission, from the title to its result, by doing what it asks for.
local run = test.run { seed = 5, frames = 60 }

local function tap(button, after)
  run:press(button .. "@" .. run.frame .. ":" .. run.frame + 1)
  run:step(after or 20)
  run:press()
end

-- Holds a button until is_done().
local function hold(button, is_done)
  run:press(button)
  for _ = 1, 300 do
    if is_done() then return run:press() end
    run:step(5)
  end
  test.expect(false, button .. ": the step does not end")
end

local function count(what) return run:eval("player.get(1)." .. what) end
local function is_clear() return run:live("bullets") == 0 end

tap("start", 60)
for _ = 1, 3 do tap("down") end
for _ = 1, 2 do tap("fire", 40) end
tap("fire", 60)
test.equal(run:eval "game.stage", "lesson")
hold("fire", function() return run:live("bullets") > 0 end)
hold("focus", is_clear)
run:step(150)
hold("up", function() return count "brushes" >= 12 and is_clear() end)
run:step(150)
for _ = 1, 6 do tap("special", 60) end
test.expect(count "prisms" >= 10, "bullets become prisms")
run:step(200)
tap("bomb", 200)
test.expect(run:eval "mission.best('lesson')", "it is done")
