-- tests/game.lua - what must stay true of the game, whatever is changed. `curtain test .` runs it (docs/guide/27-testing.md).
local ready = test.run { frames = 120 }
test.expect(ready.music == "river", "the title has its music")

local stage = test.run { stage = "river", pads = "fire", invincible = true, frames = 1400 }
test.expect(stage.score > 0, "who fires, hits")
test.expect(stage:moment("mark", "temple"), "the stage comes to its temple")
test.expect(stage:live("enemies") > 0, "where there are lanterns")

for _, phase in ipairs { "wings", "feast" } do
  local fight = test.run { stage = "keeper/" .. phase, pads = "fire", invincible = true }
  test.expect(fight:wait("board.live('bullets') > 40", 600), phase .. ": the air is full of it")
  test.expect(fight:wait(function() return fight:moment("won") end, 45 * 60), phase .. ": it can be beaten")
  test.expect(fight:refused("bullets") == 0, phase .. ": there was room for all of it")
end

local hit = test.run { stage = "keeper/feast", lives = 1 }
test.expect(hit:wait(function() return hit:moment("death") end, 20 * 60), "who stands still is hit")
-- test.shot("feast", hit) would keep that picture and compare it from then on: curtain test . --update takes it.
