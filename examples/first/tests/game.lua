-- tests/game.lua - what must stay true of the game, whatever is changed. `curtain test .` runs it (manual, chapter 28).
local run = test.run { stage = "one", pads = "fire", invincible = true, frames = 600 }
test.expect(run:live("enemies") > 0, "jellies come")
test.expect(run:live("bullets") > 20, "and fire")
test.expect(run:wait("player.get(1).score > 0", 3600), "shots hit them")
test.expect(run:wait(function() return run:moment("clear") end, 3600), "the stage has an end")
