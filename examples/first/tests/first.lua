-- first.lua - the stage starts, the ship flies and fires, and jellies appear and can be shot.
local run = test.run { stage = "one", seed = 1, frames = 30 }
local x = run:eval "player.get(1).x"
run:press("left")
run:step(20)
test.expect(run:eval "player.get(1).x" < x, "left moves the ship to the left")

local fight = test.run { stage = "one", seed = 1, invincible = true, pads = "fire", frames = 240 }
test.expect(fight:live("enemies") > 0, "jellies appear")
test.expect(fight:live("bullets") > 0, "they fire")
test.shot("first-240")
test.expect(fight:wait("player.get(1).score > 0", 3000), "a shot hits one")
