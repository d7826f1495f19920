-- stages/two.lua - the drowned glassworks, where the furnace still burns.
local sea = require "sea"

stage.def("two", function()
  palette.load("two")
  sea.speed(1.6)
  wait(60)
end, { music = "tide" })
