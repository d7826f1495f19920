-- night.lua - the background of the stage and the title: the sky with the moon, and the river in perspective.
local LAMP, GLINT = 16 * 13 + 13, 16 * 13 + 14 -- two colours of bank 13: windows, and light on the water

-- Sets up sky and water, and animates them while they are shown.
local function night(speed, fog)
  local sky, water, moon = bg.layer(1), bg.plane(), nil
  sky.map, sky.vx = "sky", -0.04
  water.map, water.horizon, water.height = "river", 92, 96
  water.fog = { to = fog, far = 900 }
  water.dir, water.vy = 270, -speed
  for i = 0, forever do
    if not (moon and moon.alive) then
      moon = sprite.put { sprite = "moon", x = 178, y = 62, layer = "back", stay = true }
    end
    water.x = 384 + 40 * angle.sin(i / 4) -- around the middle of the map, where the water is
    if i % 20 == 0 then palette.set(LAMP, i % 60 == 0 and 0xf09038 or 0xffb854) end
    if i % 80 == 0 then palette.fade { to = 0x7c86b8, over = 40, first = GLINT, last = GLINT } end
    if i % 80 == 40 then palette.fade { to = 0x464c78, over = 40, first = GLINT, last = GLINT } end
    wait(1)
  end
end

bg.def("river", function() night(1.6, 0x0c1028) end)
bg.def("feast", function() night(3.2, 0x1c2148) end) -- the boss's spell card: faster and misty

-- Shows the river for the title and for practising a phase, which have no stage to show a background. It never
-- replaces the background of a stage, even during a fade.
task.go(function()
  while true do
    local none = not game.stage and not boss.now() and not bg.plane().map
    for i = 1, 4 do none = none and not bg.layer(i).map end
    if none then bg.show("river", { over = 0 }) end -- boot.run has wiped the field
    wait(1)
  end
end)
