-- main.lua - one document on an empty field, from where libbulletml's world has its root. Each bullet gets the number
-- of its creation, in two values, for a value ends at 32767.
local run = require "run"

bullet.def("dot", { sprite = "dot", hit = { circle = 2 }, harmless = true })
player.def("mark", { sprite = "dot", hit = { circle = 1 }, graze = 0 })
value.def("ones")
value.def("thousands")

local n = 0
task.go(function()
  bullet.ml { name = "document", x = 160, y = 20, kind = "dot", rank = run.rank, seed = run.seed, loop = run.loop,
    on_fire = function(b)
      n = n + 1
      b.ones, b.thousands, b.bank = n % 1000, n // 1000, n % 8
    end }
  wait(forever)
end)
