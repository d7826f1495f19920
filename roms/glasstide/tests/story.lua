-- story.lua - the opening plays after power-on, with its music. START skips it and shows the title. Otherwise it ends
-- by itself.
local run = test.run { seed = 1 }
run:step(60)
test.equal(run.music, "opening", "its music")
test.equal(run:live("sprites"), 1, "a picture")
test.shot("opening")
run:press("start@70:72")
run:step(60)
test.equal(run.music, "title", "start skips the opening")

local alone = test.run { seed = 1 }
test.expect(alone:wait(function(r) return r.music == "title" end, 30 * 60), "it ends by itself")
test.expect(alone.frame > 18 * 60, "after some time")
