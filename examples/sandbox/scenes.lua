-- scenes.lua - a demo stage for backgrounds: the sea with clouds and their shadows, and towers on a floor of slabs.
bg.def("sea", function()
  local sea, low, high = bg.layer(1), bg.layer(2), bg.layer(3)
  sea.map, sea.bank, sea.vy = "sea", 9, 0.5 -- bank 13 + 9 wraps to 6, indigo
  low.map, low.bank, low.blend, low.x, low.vy = "clouds", 3, "ghost", 40, 0.8
  high.map, high.bank, high.vx, high.vy = "clouds", 3, -0.25, 1.5
  bg.lines(1, { wave = 5, every = 64, speed = 0.5 })
end)

bg.def("slabs", function()
  local sky, floor, towers = bg.layer(1), bg.plane(), bg.layer(2)
  sky.map, sky.bank, sky.vx = "sea", 9, 0.125
  floor.map, floor.horizon, floor.height, floor.vy = "slabs", 120, 24, -1.5
  floor.fog = { to = 0x3c4c88, far = 900 }
  towers.map, towers.y, towers.wrap, towers.vx = "towers", -6, false, -0.1
  for i = 0, forever do
    floor.dir = 270 + 10 * angle.sin(i)
    wait(1)
  end
end)

stage.def("scenes", function()
  bg.show("sea", { over = 0 })
  for i = 0, 5 do
    pattern.ring { x = 120, y = 100, kind = "orb", n = 16, dir = 7 * i, speed = 1, bank = 1 }
    wait(40)
  end
  bg.show("slabs", { over = 60 })
  wait(forever)
end)
