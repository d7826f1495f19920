-- parallax.lua - Parallax: The sea, the clouds and their shadows scroll at different speeds. The
-- lines of the sea sway without any extra pictures.
bg.def("coast", function()
  local sea, shadow, cloud = bg.layer(1), bg.layer(2), bg.layer(3)
  sea.map, sea.bank, sea.vy = "sea", 9, 0.5
  bg.lines(1, { wave = 5, every = 64, speed = 0.5 })
  shadow.map, shadow.bank, shadow.blend, shadow.x, shadow.vy = "clouds", 3, "ghost", 40, 0.9
  cloud.map, cloud.bank, cloud.vx, cloud.vy = "clouds", 3, -0.25, 1.5
end)

return function(e)
  bg.show("coast", { over = 20 })
  while true do
    wait_for(e:move { x = 60, y = 70, over = 90, ease = "both" })
    wait_for(e:move { x = 180, y = 70, over = 90, ease = "both" })
  end
end
