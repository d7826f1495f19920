-- missions.lua - from the title: the list, a mission that is cleared, its saved result, and one
-- that fails.
local function tap(run, button, after)
  run:press(button .. "@" .. run.frame .. ":" .. run.frame + 1)
  run:step(after or 20)
  run:press()
end

local run = test.run { seed = 5, frames = 60 }
tap(run, "start", 60) -- from the opening to the list
for _ = 1, 3 do tap(run, "down") end
tap(run, "fire", 40) -- the missions
tap(run, "down") -- from the lesson
tap(run, "fire", 40) -- to First Light
tap(run, "fire", 60) -- on normal, with the heron and darts
test.equal(run:eval "player.get(1).kind", "heron")
test.equal(run:eval "player.get(1).lives", 0, "one life")
test.equal(run:eval "game.stage", "one")

run:exec "player.get(1).chain = 20"
run:step(90)
local value, stars, ship = run:eval "mission.best('first_light')"
test.expect(value and value < 300, "the time is saved")
test.equal({ stars, ship }, { 3, "heron" }, "with all its stars")
test.equal(run:eval "mission.stars()", 3, "in total")
test.equal(run:heard("mission"), 1, "its sound plays")

tap(run, "fire", 40) -- back to the list
tap(run, "down")
tap(run, "fire", 40)
tap(run, "fire", 60)
run:exec "player.get(1).bombs = 1"
tap(run, "bomb", 60) -- Clear Water allows none
test.equal(run:heard("failed"), 1, "it fails")
test.equal(run:eval "mission.best('clear_water')", nil, "and nothing is saved")

-- Every mission starts and runs for some seconds without a fault, with fire held.
local function begin(i)
  local one = test.run { seed = i, frames = 60 }
  one:exec "save.set('unlock/rush', true) save.set('unlock/tern', true)"
  tap(one, "start", 60)
  for _ = 1, 3 do tap(one, "down") end
  tap(one, "fire", 30)
  for _ = 2, i do tap(one, "down", 3) end
  for _ = 1, 8 do
    if one:moment "game" then break end -- on the page before, the ship only shows its shots
    tap(one, "fire", 16)
  end
  test.expect(one:eval "player.get(1).alive", ("mission %d starts"):format(i))
  one:exec "player.get(1).safe = 10000"
  one:press("fire")
  one:step(240)
  test.equal(one.fault, nil, ("mission %d"):format(i))
  test.expect(one:wait("boss.now() or game.stage", 300), ("mission %d: nothing appears"):format(i))
end

local _, most = run:eval "mission.stars()"
test.expect(most >= 90, "thirty missions or more")
for i = 1, most // 3 do begin(i) end
