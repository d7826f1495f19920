-- bomb.lua - Shock wave: A bomb is a task with a duration, a cost and invincibility. This bomb
-- shakes the picture and sends out a ring of light that turns every bullet it reaches into a star.
item.def("bomb_star", { sprite = "shard", bank = 3, radius = 10, gives = { score = 10 } })
spark.def("wave", { sprite = "ember", life = 40, bank = 3, blend = "glow" })

bomb.def("shock", { over = 100, run = function(p)
  screen.shake { size = 5, over = 50 }
  screen.flash { to = 0xfff6bc, over = 16, share = 0.6 }
  spark.burst { kind = "wave", from = p, n = 60, radius = 10, speed = 5 }
  bullet.sweep { from = p, radius_to = 320, over = 60, items = "bomb_star", hurt = 20, by = p }
  wait(70)
  item.group():pull(p)
end })

player.def("bomber", { sprite = "ship", hit = { circle = 2 }, bomb = "shock",
                       registers = { bombs = { start = 3, show = "icons" } } })

local function run(e)
  for k = 0, forever do
    pattern.ring { from = e, kind = "orb", bank = 1, n = 26, dir = 5 * k, speed = 1.4 }
    wait(22)
  end
end

return { run = run, ship = "bomber", hud = true }
