-- stages/three/scene.lua - the look of the abyss: the way down between columns of basalt, the
-- trench that rushes by, lightless water, the drowned quay, and the Queen's court.
local sea = require "sea"

-- Dark water, far below everything.
local function depths()
  local water = bg.layer(1)
  water.map, water.x = "depths", -8
  bg.lines(1, { wave = 7, every = 96, speed = 0.3 })
  return { water, 0.35 }
end

local function strip(n, map, part)
  local l = bg.layer(n)
  l.map, l.x = map, -8
  return { l, part }
end

local function ground(horizon, height, far)
  local floor = bg.plane()
  floor.map, floor.x = "trench", 70
  floor.horizon, floor.height, floor.dir = horizon, height, 270
  floor.fog = { to = 0x0a1028, far = far }
  return { floor, -2 }
end

bg.def("abyss", function()
  palette.load("three")
  sea.flow { depths(), strip(2, "walls", 1), strip(3, "snow", 0.7), strip(4, "chains", 1.6) }
  bg.lines(4, { wave = 4, every = 200, speed = 0.5 })
end)

bg.def("trench", function()
  palette.load("three")
  sea.flow { depths(), ground(64, 52, 620), strip(3, "snow", 1.4), strip(4, "chains", 2.4) }
end)

-- Only water, so that all light comes from the lamp.
bg.def("lightless", function()
  palette.load("dark")
  sea.flow { depths() }
end)

bg.def("quay", function()
  palette.load("three")
  sea.flow { depths(), strip(2, "quay", 1), strip(3, "snow", 1.4), strip(4, "chains", 2.2) }
  bg.lines(4, { wave = 4, every = 200, speed = 0.5 })
end)

bg.def("court", function()
  palette.load("three")
  local floor = ground(34, 74, 900)
  sea.flow { depths(), floor, strip(2, "walls", 0.9), strip(3, "snow", 0.6) }
end)

local scene = {}

-- Only the lamp gives light: colours that an earlier phase lit go dark.
function scene.lightless()
  palette.fade { to = "dark", over = 40, first = 10 * 16 + 1, last = 13 * 16 + 15 }
end

return scene
