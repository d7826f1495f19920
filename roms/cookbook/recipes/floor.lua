-- floor.lua - Raster floor: A map is drawn in perspective, line by line, under a sky of swaying
-- lines. The camera swings from side to side, and fog hides the far edge of the floor.
bg.def("court", function()
  local sky, floor = bg.layer(1), bg.plane()
  sky.map, sky.bank, sky.vx = "sea", 9, 0.2
  bg.lines(1, { wave = 6, every = 40, speed = 0.5 })
  floor.map, floor.horizon, floor.height, floor.vy = "slabs", 110, 22, -2
  floor.fog = { to = 0x3c4c88, far = 700 }
  for i = 0, forever do
    floor.dir = 270 + 16 * angle.sin(i)
    wait(1)
  end
end)

return function(e)
  bg.show("court", { over = 20 })
  for k = 0, forever do
    wait(50)
    pattern.ring { from = e, kind = "orb", bank = 1, n = 16, dir = 11 * k, speed = 1.4 }
  end
end
