-- stages/moon/scene.lua - black water, and the path of moonlight on it. The light is broken: each
-- of its lines sways separately, and its strokes drift down faster than the swell below
-- them.
bg.def("moon", function()
  palette.load("moon")
  local water, town, light = bg.layer(1), bg.layer(2), bg.layer(3)
  water.map, water.vy = "water", 0.25
  town.map = "town"
  light.map, light.vy = "moonlight", 0.7
  bg.lines(1, { wave = 3, every = 96, speed = 0.3 })
  bg.lines(2, { wave = 2, every = 70, speed = 0.2 })
  for i = 0, forever do
    bg.lines(3, { wave = 6 + 3 * angle.sin(i / 3), every = 26, speed = 0.8 })
    wait(4)
  end
end)
