-- tests/game.lua - checks that must still pass after changes. `curtain test .` runs them (docs/guide/27-testing.md).
local ready = test.run { frames = 120 }
test.expect(ready.music == "river", "the title has music")

local stage = test.run { stage = "river", pads = "fire", invincible = true, frames = 1400 }
test.expect(stage.score > 0, "shots hit enemies")
test.expect(stage:moment("mark", "temple"), "the stage reaches the temple")
test.expect(stage:live("enemies") > 0, "enemies appear there")

for _, phase in ipairs { "wings", "feast" } do
  local fight = test.run { stage = "keeper/" .. phase, pads = "fire", invincible = true }
  test.expect(fight:wait("board.live('bullets') > 40", 600), phase .. ": more than 40 bullets fly")
  test.expect(fight:wait(function() return fight:moment("won") end, 45 * 60), phase .. ": it can be beaten")
  test.expect(fight:refused("bullets") == 0, phase .. ": no bullet is dropped")
end

local hit = test.run { stage = "keeper/feast", lives = 1 }
test.expect(hit:wait(function() return hit:moment("death") end, 20 * 60), "a ship that stands still is hit")
-- test.shot("feast", hit) would compare this picture with a saved one; `curtain test . --update` saves it.
