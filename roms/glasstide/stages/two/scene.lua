-- stages/two/scene.lua - the look of the drowned glassworks: a wall of
-- arches with fires behind it, the street of the works, which rushes
-- by, and the yard with its two tracks.
local sea = require "sea"

-- Rising embers. Their place depends on the frame, so that they use no random numbers.
local function embers(every, top, bottom)
  for k = 1, forever do
    spark.burst { kind = "ember", x = 97 * k % 240, y = top + 61 * k % (bottom - top), dir = 250,
                  spread = 70, speed = 0.7 }
    wait(every)
  end
end

bg.def("works", function()
  palette.load("two")
  bg.layer(1).map = "works"
  bg.layer(2).map = "pipes"
  bg.layer(3).map, bg.layer(3).x = "stacks", -16
  sea.flow { { bg.layer(1), 0.7 }, { bg.layer(2), 1.15 }, { bg.layer(3), 1.9 } }
  embers(11, 60, 340)
end)

bg.def("street", function()
  palette.load("two")
  local street, skyline, stacks = bg.plane(), bg.layer(1), bg.layer(3)
  street.map, street.horizon, street.height, street.dir = "street", 74, 46, 270
  street.x = 77 -- between the rails
  skyline.map, skyline.wrap, skyline.y = "skyline", false, -5
  street.fog = { to = 0x1a0f14, far = 620 } -- its far end would glitter without fog
  stacks.map, stacks.x = "stacks", -16
  sea.flow { { street, -2.2 }, { stacks, 2.6 } }
  embers(4, 100, 330)
end)

bg.def("yard", function()
  palette.load("two")
  local yard, stacks = bg.layer(1), bg.layer(3)
  yard.map, stacks.map, stacks.x = "yard", "stacks", -16
  sea.flow { { yard, 1 }, { stacks, 1.5 } }
  embers(7, 40, 330)
end)

-- The scene of the bosses: the wall shimmers in the heat, and more embers rise.
bg.def("hearth", function()
  palette.load("two")
  bg.layer(1).map = "works"
  bg.layer(3).map, bg.layer(3).x = "stacks", -16
  bg.lines(1, { wave = 2, every = 44, speed = 0.8 })
  sea.flow { { bg.layer(1), 0.6 }, { bg.layer(3), 1.4 } }
  embers(5, 60, 340)
end)
