-- tests/game.lua - checks that must still pass after changes. `curtain test .` runs them (docs/guide/27-testing.md).
local flight = test.run { stage = "canyon", pads = "left,fire", invincible = true, frames = 200 }
test.expect(flight:eval("camera.x") < 20, "the camera goes to the left edge of the field with the ship")
test.expect(flight:eval("camera.x >= 0"), "it stays in the field")
test.expect(flight:live("enemies") > 0, "enemies appear")

local still = test.run { stage = "canyon", pads = "fire", invincible = true, frames = 960 }
test.expect(still:eval("camera.x") == 120, "it stays in the middle with a ship that stays there")
test.expect(still:moment("mark", "pair"), "the stage reaches the pair of airships")
test.expect(still:refused("bullets") == 0, "no bullet is dropped")
