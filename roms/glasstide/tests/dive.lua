-- dive.lua - the recorded run: its stages, its score and four pictures.
local run = test.run { demo = "demos/run.demo", frames = 600 }
test.shot("dive-600")
run:step(1200)
test.shot("dive-1800")
run:step(3000)
test.shot("dive-4800")
test.equal(run.score, 68488, "points")
test.equal(run.difficulty, "normal")
test.equal(run.music, "lantern", "the midboss's music")

local first = run:moment("stage")
test.equal(first and first.name, "one", "the first stage")
test.expect(run:moment("boss", "nautilus"), "the Lantern Nautilus appears")
for i = 2, #run.moments do
  test.expect(run.moments[i - 1].frame <= run.moments[i].frame, "moments are in order")
end
