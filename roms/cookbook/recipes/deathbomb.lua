-- deathbomb.lua - Deathbomb: For twelve frames after a hit, the bomb button still saves the ship. A
-- red flash marks this time. After that the ship dies, and nearby bullets are cleared.
bomb.def("rescue", { over = 60, safe = 120, run = function(p)
  screen.flash { over = 20 }
  bullet.sweep { from = p, radius_to = 300, over = 40, spark = "glint" }
end })

player.def("mortal", { sprite = "ship", hit = { circle = 2 }, lives = 9, deathbomb = 12,
                       bomb = "rescue", registers = { bombs = { start = 5, show = "icons" } } })

on.hit(function(p)
  if p.kind == "mortal" then screen.flash { to = 0xff2020, over = 12, share = 0.5 } end
end)
on.death(function(p)
  spark.burst { kind = "glint", from = p, n = 60, speed = 3 }
  bullet.clear { from = p, radius = 90, spark = "glint" }
end)

local function run(e)
  while true do
    pattern.fan { from = e, kind = "knife", bank = 1, n = 9, spread = 80, aim = true, speed = 2.6 }
    wait(40)
  end
end

return { run = run, ship = "mortal", hud = true }
