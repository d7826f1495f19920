-- main.lua - the document from many places at once, in rows of twenty; tools/lab/bulletml/speed.c has the same for
-- libbulletml.
local run = require "run"

bullet.def("dot", { sprite = "dot", hit = { circle = 2 } })
player.def("mark", { sprite = "dot", hit = { circle = 1 }, graze = 0 })

task.go(function()
  for i = 0, run.roots - 1 do
    bullet.ml { name = "document", x = 65 + i % 20 * 10, y = 20 + i // 20 % 10 * 10, kind = "dot", rank = run.rank,
      seed = run.seed + i }
  end
  wait(forever)
end)
