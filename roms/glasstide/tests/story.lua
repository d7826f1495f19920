-- story.lua - the opening is told once the power is on, with its music; START leaves it, and the title is there. Left
-- alone it ends by itself.
local run = test.run { seed = 1 }
run:step(60)
test.equal(run.music, "opening", "its music")
test.equal(run:live("sprites"), 1, "a picture")
test.shot("opening")
run:press("start@70:72")
run:step(60)
test.equal(run.music, "title", "it is left by START")

local alone = test.run { seed = 1 }
test.expect(alone:wait(function(r) return r.music == "title" end, 30 * 60), "it ends by itself")
test.expect(alone.frame > 18 * 60, "after some time")
